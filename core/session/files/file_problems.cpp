#include "session/files/file_problems.h"

#include <array>

namespace session {

namespace {

// Both in the order of their enumeration.

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

} // namespace session
