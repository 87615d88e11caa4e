// export: the signals of a recording, or of a CSV file, in another format.
#include "commands.h"
#include "recording_work.h"
#include "sentences.h"
#include "session/files/problems.h"

#include <QFileInfo>
#include <QJsonObject>

#include <algorithm>
#include <utility>

namespace cli {

namespace {

constexpr char kRegistersEnding[] = ".json"; ///< beside those of the signals

struct Source {
    std::unique_ptr<OpenedRecording> recording; ///< else it is a CSV file
    ImportedCsv csv;
    const capture::Capture &capture() const { return recording ? recording->capture : csv.capture; }
};

bool endsWith(const QString &path, const char *ending)
{
    return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
}

Outcome<Source> openSource(const QString &path)
{
    Source source;
    if (endsWith(path, ".csv")) {
        auto csv = importCsv(path);
        if (!csv)
            return tl::make_unexpected(csv.error());
        source.csv = std::move(**csv);
        return source;
    }
    auto recording = openRecording(path);
    if (!recording)
        return tl::make_unexpected(recording.error());
    source.recording = std::move(*recording);
    return source;
}

/// The wanted channels, in the order wanted; all that hold samples if no name was given.
Outcome<capture::Snapshot> chosen(const capture::Capture &capture, const QStringList &names)
{
    const std::vector<capture::ChannelInfo> channels = capture.channels();
    std::vector<capture::ChannelId> ids;
    for (const QString &name : names) {
        bool found = false;
        for (const capture::ChannelInfo &info : channels) {
            if (QString::fromStdString(info.name).compare(name, Qt::CaseInsensitive) != 0)
                continue;
            ids.push_back(info.id);
            found = true;
        }
        if (!found)
            return failure(kUsage,
                QStringLiteral("There is no signal \"%1\" in it; rotorscope-cli show lists them.")
                    .arg(name));
    }
    if (names.isEmpty())
        for (const capture::ChannelInfo &info : channels)
            if (capture.size(info.id) > 0)
                ids.push_back(info.id);
    return capture.snapshot(ids);
}

/// The newest snapshot of the registers, as the file that the command snapshot writes.
Outcome<session::ExportOutcome> writeJson(
    const QString &path, const Source &source, std::optional<double> to)
{
    const recorded::RegisterSnapshot *newest = nullptr;
    if (source.recording)
        for (const auto &[at, snapshot] : source.recording->report.snapshots)
            if (!to || capture::toSeconds(at) <= *to)
                newest = &snapshot;
    if (newest == nullptr)
        return failure(kUsage, QStringLiteral("It holds no register snapshot of that time."));
    bool written = false;
    return session::ExportOutcome{session::writePieces(path, [&](std::string_view &piece) {
        piece = newest->json;
        return !std::exchange(written, true);
    })};
}

Outcome<session::ExportOutcome> writeSignals(const RecordingArguments &wanted,
    const session::ExportFormat &format, const capture::Capture &capture)
{
    const auto channels = chosen(capture, wanted.only);
    if (!channels)
        return tl::make_unexpected(channels.error());
    std::optional<capture::TimeSpan> range;
    const auto all = capture.timeSpan();
    if (all && (wanted.from || wanted.to)) {
        // Not far beyond what there is, because not every double fits into nanoseconds. But a second: a polled value at
        // the end is still in it, and seconds since 1970 are no double to the nanosecond.
        const double least = all->from - 1.0, most = all->to + 1.0;
        range = capture::TimeSpan{std::clamp(wanted.from.value_or(least), least, most),
            std::clamp(wanted.to.value_or(most), least, most)};
    }
    const auto outcome = format.write(wanted.file, {*channels, range}, {});
    if (outcome.problem != session::ExportProblem::None)
        return failure(kUsage,
            session::exportProblemText(outcome.problem, format)
                + QStringLiteral(" The options --signals, --from and --to do that."));
    return outcome;
}

QString exportEndings(const QString &between)
{
    QStringList endings;
    for (const session::ExportFormat &each : session::exportFormats())
        endings.append(QLatin1Char('.') + QLatin1String(each.suffix));
    endings.append(QLatin1String(kRegistersEnding));
    endings.removeDuplicates();
    return endings.join(between);
}

/// What the file's name ends in, and the options, ask for; nullptr: registers.
Outcome<const session::ExportFormat *> formatOf(const RecordingArguments &wanted)
{
    if (endsWith(wanted.file, kRegistersEnding))
        return nullptr;
    const session::ExportFormat *format = session::exportFormatOf(wanted.file, wanted.continental);
    if (format == nullptr)
        return usage(QStringLiteral("Let the name of the file end in one of %1, not as in \"%2\".")
                         .arg(exportEndings(QStringLiteral(", ")), wanted.file));
    return format;
}

Outcome<int> runExport(const Arguments &arguments, Output &out)
{
    const RecordingArguments &wanted = arguments.recording;
    const QString &path = arguments.words.first();
    const auto format = formatOf(wanted);
    if (!format)
        return tl::make_unexpected(format.error());
    if (QFileInfo::exists(wanted.file)
        && QFileInfo(path).canonicalFilePath() == QFileInfo(wanted.file).canonicalFilePath())
        return failure(kUsage, QStringLiteral("Name another file to write than the one to read."));
    const auto source = openSource(path);
    if (!source)
        return tl::make_unexpected(source.error());
    const auto written = *format == nullptr ? writeJson(wanted.file, *source, wanted.to)
                                            : writeSignals(wanted, **format, source->capture());
    if (!written)
        return tl::make_unexpected(written.error());
    if (written->file.error != session::FileError::None)
        return failure(kFileError, sentenceOf(written->file, wanted.file));
    const QString lack = source->recording ? lackText(*source->recording) : lackText(source->csv);
    if (out.json())
        out.line(QJsonObject{{QStringLiteral("file"), wanted.file},
            {QStringLiteral("rows"), static_cast<qint64>(written->rows)},
            {QStringLiteral("bytes"), written->file.bytes},
            {QStringLiteral("complete"), lack.isEmpty()}});
    else if (*format == nullptr)
        out.line(wanted.file);
    else
        out.line(QStringLiteral("%1: %2 rows").arg(wanted.file, QString::number(written->rows)));
    if (!lack.isEmpty())
        return failure(kDataLost, QStringLiteral("%1 is not whole: %2.").arg(path, lack));
    return kDone;
}

constexpr OptionText kExportOptions[] = {
    {"o,output", "FILE", "The file to write; its ending says the format."},
    {"signals", "A,B", "Only these signals, in this order; separated by commas."},
    {"from", "S", "From this second of the session on."},
    {"to", "S", "Up to this second of the session."},
    {"continental", "", "CSV with ; and a decimal comma, for spreadsheets that expect them."},
};

Outcome<bool> readExport(const Given &given, Arguments &all)
{
    RecordingArguments &arguments = all.recording;
    arguments.file = given.value("output");
    if (arguments.file.isEmpty())
        return usage(QStringLiteral("Name the file to write with -o FILE, such as -o run.csv."));
    arguments.continental = given.has("continental");
    arguments.only = given.list("signals");
    for (const auto &[option, place] :
        {std::pair{"from", &arguments.from}, std::pair{"to", &arguments.to}}) {
        if (!given.has(option))
            continue;
        const QString text = given.value(option);
        *place = plainNumber(text);
        if (!*place)
            return usage(
                QStringLiteral("--%1 must be a number of seconds, with a point, not \"%2\".")
                    .arg(QLatin1String(option), text));
    }
    if (arguments.from && arguments.to && *arguments.from >= *arguments.to)
        return usage(QStringLiteral("--from must lie before --to."));
    return true;
}

const QByteArray kExportWords =
    "FILE.pcapng -o FILE" + exportEndings(QStringLiteral("|")).toLatin1();

} // namespace

const Command kExport{.name = "export",
    .words = kExportWords.constData(),
    .help =
        "Writes the signals of a recording, or of a CSV file, in another format; or its registers.",
    .least = 1,
    .most = 1,
    .options = kExportOptions,
    .read = readExport,
    .needsPort = false,
    .runAlone = runExport};

} // namespace cli
