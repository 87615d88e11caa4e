#include "session/files/problems.h"

#include <array>

namespace session {

namespace {

// All in the order of their enumeration.

/// %1 is what stands there.
constexpr std::array kCsvProblems{
    QT_TRANSLATE_NOOP("FileProblem", "there is no heading with the names of signals"),
    QT_TRANSLATE_NOOP("FileProblem", "there is one column only"),
    QT_TRANSLATE_NOOP("FileProblem", "there are too many columns"),
    QT_TRANSLATE_NOOP("FileProblem", "the line is too long for a line of numbers"),
    QT_TRANSLATE_NOOP("FileProblem", "the line has another number of fields than the heading"),
    QT_TRANSLATE_NOOP("FileProblem", "\"%1\" is no number"),
    QT_TRANSLATE_NOOP("FileProblem", "\"%1\" is no time"),
    QT_TRANSLATE_NOOP("FileProblem", "the time %1 is before the one above it"),
    QT_TRANSLATE_NOOP("FileProblem", "there is a heading and nothing else")};

constexpr auto kFull = QT_TRANSLATE_NOOP(
    "FileProblem", "No %1 file: it holds at most %2. Choose fewer signals or a shorter range.");

/// %1 is the format, %2 how much fits.
constexpr std::array kExportProblems{"",
    QT_TRANSLATE_NOOP("FileProblem",
        "No %1 file: there is no time at which all fast signals were recorded. Choose "
        "fewer of them."),
    QT_TRANSLATE_NOOP(
        "FileProblem", "No %1 file: the signals have different rates. Choose some of one rate."),
    kFull, kFull};

/// From the sixth on "it" is a register.
constexpr std::array kSnapshotProblems{QT_TRANSLATE_NOOP("Snapshot", "it is no JSON"),
    QT_TRANSLATE_NOOP("Snapshot", "it is no snapshot"),
    QT_TRANSLATE_NOOP("Snapshot", "it is of a newer version than this program knows"),
    QT_TRANSLATE_NOOP("Snapshot", "it has no list of registers"),
    QT_TRANSLATE_NOOP("Snapshot", "it has more registers than any board"),
    QT_TRANSLATE_NOOP("Snapshot", "it has no name"),
    QT_TRANSLATE_NOOP("Snapshot", "it has no motor from 0 to 7"),
    QT_TRANSLATE_NOOP("Snapshot", "it has no id"),
    QT_TRANSLATE_NOOP("Snapshot", "it has no known type"),
    QT_TRANSLATE_NOOP("Snapshot", "its raw number does not fit its type"),
    QT_TRANSLATE_NOOP("Snapshot", "it has neither bits nor a raw number"),
    QT_TRANSLATE_NOOP("Snapshot", "it has no raw text"),
    QT_TRANSLATE_NOOP("Snapshot", "its bytes are no pairs of hexadecimal digits"),
    QT_TRANSLATE_NOOP("Snapshot", "it is there twice")};
static_assert(kSnapshotProblems.size() == std::size_t(SnapshotProblem::Twice) + 1);

/// %1 is the stage.
constexpr std::array kRevUpProblems{QT_TRANSLATE_NOOP("FileProblem", "it is not JSON"),
    QT_TRANSLATE_NOOP("FileProblem", "it has no stages, or more than five"),
    QT_TRANSLATE_NOOP("FileProblem", "the numbers of its stage %1 do not fit")};

} // namespace

QString csvProblemText(const capture::CsvError &error, ProblemWords wordsOf)
{
    const QString line = QString::number(error.line);
    QString what = wordsOf(kCsvProblems.at(static_cast<std::size_t>(error.what)));
    what.replace(QLatin1String("%1"), QString::fromStdString(error.field));
    return error.column == 0
        ? wordsOf(QT_TRANSLATE_NOOP("FileProblem", "line %1: %2")).arg(line, what)
        : wordsOf(QT_TRANSLATE_NOOP("FileProblem", "line %1, column %2: %3"))
              .arg(line, QString::number(error.column), what);
}

QString exportProblemText(ExportProblem problem, const ExportFormat &format, ProblemWords wordsOf)
{
    if (problem == ExportProblem::None)
        return {};
    return wordsOf(kExportProblems.at(static_cast<std::size_t>(problem)))
        .replace(QLatin1String("%1"), QString::fromLatin1(format.suffix).toUpper())
        .replace(QLatin1String("%2"), wordsOf(format.mostText));
}

QString snapshotProblemText(
    const QString &file, const SnapshotFileError &error, ProblemWords wordsOf)
{
    const QString what = wordsOf(kSnapshotProblems.at(static_cast<std::size_t>(error.problem)));
    const QString line = QString::number(error.line);
    if (error.problem == SnapshotProblem::NotJson)
        return wordsOf(QT_TRANSLATE_NOOP("Snapshot", "%1 cannot be used: in line %2 %3 (%4)."))
            .arg(file, line, what, error.parserText);
    if (error.number == 0)
        return wordsOf(QT_TRANSLATE_NOOP("Snapshot", "%1 cannot be used: %2.")).arg(file, what);
    return wordsOf(QT_TRANSLATE_NOOP("Snapshot", "%1 cannot be used: line %2, register %3: %4."))
        .arg(file, line, error.name.isEmpty() ? QString::number(error.number) : error.name, what);
}

QString revUpProblemText(const QString &file, const RevUpFileError &error, ProblemWords wordsOf)
{
    const QString what = wordsOf(kRevUpProblems.at(static_cast<std::size_t>(error.kind)))
                             .replace(QLatin1String("%1"), QString::number(error.stage));
    return wordsOf(QT_TRANSLATE_NOOP("FileProblem", "%1 is no rev-up: %2.")).arg(file, what);
}

QString lostText(const recorded::Lost &lost, ProblemWords wordsOf)
{
    QStringList parts;
    const auto add = [&](std::uint64_t count, const char *one, const char *many) {
        if (count > 0)
            parts.append(wordsOf(count == 1 ? one : many).arg(count));
    };
    add(lost.samples, QT_TRANSLATE_NOOP("FileProblem", "%1 sample"),
        QT_TRANSLATE_NOOP("FileProblem", "%1 samples"));
    add(lost.linkBytes, QT_TRANSLATE_NOOP("FileProblem", "%1 byte of the line"),
        QT_TRANSLATE_NOOP("FileProblem", "%1 bytes of the line"));
    add(lost.others, QT_TRANSLATE_NOOP("FileProblem", "%1 other entry"),
        QT_TRANSLATE_NOOP("FileProblem", "%1 other entries"));
    return parts.join(QStringLiteral(", "));
}

} // namespace session
