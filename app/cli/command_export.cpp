// export: the signals of a recording, or of a CSV file, in another format.
#include "capture/csv_export.h"
#include "capture/wav_export.h"
#include "commands.h"
#include "recording_work.h"
#include "session/mat_file.h"

#include <QFileInfo>
#include <QJsonObject>

#include <algorithm>
#include <utility>

namespace cli {

using session::FileError;

namespace {

struct Source {
    std::unique_ptr<OpenedRecording> recording;
    std::unique_ptr<capture::Capture> csv;
    const capture::Capture &capture() const { return recording ? recording->capture : *csv; }
};

struct Written {
    session::FileResult file;
    std::uint64_t rows = 0; ///< of samples
    std::size_t gaps = 0; ///< of a WAV file
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
        source.csv = std::move(*csv);
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

QString wavText(capture::WavProblem problem)
{
    switch (problem) {
    case capture::WavProblem::None:
        break;
    case capture::WavProblem::NoFastSamples:
        return QStringLiteral("there are no instants at which all fast signals were recorded; name "
                              "fewer with --signals");
    case capture::WavProblem::DifferentRates:
        return QStringLiteral("the signals have different rates; name some of one with --signals");
    case capture::WavProblem::TooManyChannels:
        return QStringLiteral("there are more than 64 signals; name some with --signals");
    case capture::WavProblem::TooLong:
        return QStringLiteral("a WAV file ends at 4 GiB; take less with --from and --to");
    }
    return {};
}

Outcome<Written> writeWav(const QString &path, const capture::Snapshot &channels,
    const std::optional<capture::TimeSpan> &range)
{
    capture::WavWriter writer(channels, range);
    if (writer.problem() != capture::WavProblem::None)
        return failure(kUsage, QStringLiteral("No WAV file: %1.").arg(wavText(writer.problem())));
    const auto file = session::writePieces(
        path, [&writer](std::string_view &bytes) { return writer.next(bytes); });
    return Written{file, writer.frames(), writer.gaps()};
}

Outcome<Written> writeMat(const QString &path, const capture::Snapshot &channels,
    const std::optional<capture::TimeSpan> &range)
{
    const session::MatResult result = session::writeMatFile(path, channels, range);
    if (result.tooLong)
        return failure(kUsage,
            QStringLiteral(
                "A MATLAB file holds 2 GiB of numbers; take less with --from and --to."));
    return Written{result.file, result.rows, 0};
}

Written writeCsv(
    const QString &path, const capture::Snapshot &channels, const capture::CsvOptions &options)
{
    capture::CsvWriter writer(channels, options);
    const auto file =
        session::writePieces(path, [&writer](std::string_view &text) { return writer.next(text); });
    return {file, writer.rows(), 0};
}

/// The newest snapshot of the registers, as the file that the command snapshot writes.
Outcome<Written> writeJson(const QString &path, const Source &source, std::optional<double> to)
{
    const record::RegisterSnapshot *newest = nullptr;
    if (source.recording)
        for (const auto &[at, snapshot] : source.recording->report.snapshots)
            if (!to || capture::toSeconds(at) <= *to)
                newest = &snapshot;
    if (newest == nullptr)
        return failure(kUsage, QStringLiteral("It holds no register snapshot of that time."));
    bool written = false;
    return Written{session::writePieces(path, [&](std::string_view &piece) {
        piece = newest->json;
        return !std::exchange(written, true);
    })};
}

Outcome<Written> write(const RecordingArguments &wanted, const Source &source)
{
    if (endsWith(wanted.file, ".json"))
        return writeJson(wanted.file, source, wanted.to);
    const capture::Capture &capture = source.capture();
    const auto channels = chosen(capture, wanted.only);
    if (!channels)
        return tl::make_unexpected(channels.error());
    std::optional<capture::TimeSpan> range;
    const auto all = capture.timeSpan();
    if (all && (wanted.from || wanted.to)) // a polled value at the end is still in it
        range =
            capture::TimeSpan{wanted.from.value_or(all->from), wanted.to.value_or(all->to + 1.0)};
    if (endsWith(wanted.file, ".wav"))
        return writeWav(wanted.file, *channels, range);
    if (endsWith(wanted.file, ".mat"))
        return writeMat(wanted.file, *channels, range);
    capture::CsvOptions options;
    options.range = range;
    if (wanted.continental)
        options.dialect = capture::CsvDialect::Continental;
    return writeCsv(wanted.file, *channels, options);
}

Outcome<int> runExport(const Arguments &arguments, Output &out)
{
    const RecordingArguments &wanted = arguments.recording;
    const QString &path = arguments.words.first();
    if (!endsWith(wanted.file, ".csv") && !endsWith(wanted.file, ".mat")
        && !endsWith(wanted.file, ".wav") && !endsWith(wanted.file, ".json"))
        return failure(kUsage,
            QStringLiteral(
                "Let the name of the file end in .csv, .mat, .wav or .json, not as in \"%1\".")
                .arg(wanted.file));
    if (QFileInfo::exists(wanted.file)
        && QFileInfo(path).canonicalFilePath() == QFileInfo(wanted.file).canonicalFilePath())
        return failure(kUsage, QStringLiteral("Name another file to write than the one to read."));
    const auto source = openSource(path);
    if (!source)
        return tl::make_unexpected(source.error());
    const auto written = write(wanted, *source);
    if (!written)
        return tl::make_unexpected(written.error());
    if (written->file.error != FileError::None)
        return failure(kFileError,
            QStringLiteral("%1 was not written: %2; make room or choose another place with -o.")
                .arg(wanted.file,
                    written->file.error == FileError::NotAFile ? QStringLiteral("it is no file")
                                                               : written->file.systemText));
    const QString lack = source->recording ? lackText(*source->recording) : lackText(*source->csv);
    if (out.json())
        out.line(QJsonObject{{QStringLiteral("file"), wanted.file},
            {QStringLiteral("rows"), static_cast<qint64>(written->rows)},
            {QStringLiteral("bytes"), written->file.bytes},
            {QStringLiteral("complete"), lack.isEmpty()}});
    else if (endsWith(wanted.file, ".json"))
        out.line(wanted.file);
    else
        out.line(QStringLiteral("%1: %2 rows").arg(wanted.file, QString::number(written->rows)));
    if (!lack.isEmpty())
        return failure(kDataLost, QStringLiteral("%1 is not whole: %2.").arg(path, lack));
    return kDone;
}

constexpr OptionText kOptions[] = {
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

} // namespace

const Command kExport{.name = "export",
    .words = "FILE.pcapng -o FILE.csv|.mat|.wav|.json",
    .help =
        "Writes the signals of a recording, or of a CSV file, in another format; or its registers.",
    .least = 1,
    .most = 1,
    .options = kOptions,
    .read = readExport,
    .needsPort = false,
    .runAlone = runExport};

} // namespace cli
