#include "session/files/export_formats.h"

#include "capture/csv_export.h"
#include "capture/npy_export.h"
#include "session/files/mat_file.h"

#include <algorithm>

namespace session {

namespace {

using Proceed = std::function<bool(double)>;

template <class Writer>
FileResult written(const QString &path, Writer &writer, const Proceed &proceed)
{
    return writePieces(
        path, [&writer](std::string_view &piece) { return writer.next(piece); },
        [&] { return !proceed || proceed(writer.progress()); });
}

template <capture::CsvDialect Dialect>
ExportOutcome writeCsv(const QString &path, const ExportWanted &wanted, const Proceed &proceed)
{
    capture::CsvWriter writer(wanted.channels, {wanted.range, Dialect});
    const FileResult file = written(path, writer, proceed);
    return {file, ExportProblem::None, writer.rows()};
}

ExportOutcome writeWav(const QString &path, const ExportWanted &wanted, const Proceed &proceed)
{
    capture::WavWriter writer(wanted.channels, wanted.range);
    if (writer.problem() != ExportProblem::None)
        return {{}, writer.problem(), 0};
    const FileResult file = written(path, writer, proceed);
    return {file, ExportProblem::None, writer.frames()};
}

ExportOutcome writeMat(const QString &path, const ExportWanted &wanted, const Proceed &proceed)
{
    const MatResult result = writeMatFile(path, wanted.channels, wanted.range, proceed);
    return {
        result.file, result.tooLong ? ExportProblem::TooLong : ExportProblem::None, result.rows};
}

ExportOutcome writeNpy(const QString &path, const ExportWanted &wanted, const Proceed &proceed)
{
    capture::NpyWriter writer(wanted.channels, wanted.range);
    if (writer.tooLong())
        return {{}, ExportProblem::TooLong, 0};
    const FileResult file = written(path, writer, proceed);
    return {file, ExportProblem::None, writer.rows()};
}

using Holds = ExportFormat::Holds;
using capture::CsvDialect;

constexpr ExportFormat kFormats[] = {
    {"csv", "csv", QT_TRANSLATE_NOOP("ExportFormat", "CSV, decimal point and commas"), "",
        Holds::RowsOfTheFastest, writeCsv<CsvDialect::Plain>},
    {"csv-continental", "csv",
        QT_TRANSLATE_NOOP("ExportFormat", "CSV, decimal comma and semicolons"), "",
        Holds::RowsOfTheFastest, writeCsv<CsvDialect::Continental>},
    {"mat", "mat", QT_TRANSLATE_NOOP("ExportFormat", "MATLAB file"),
        QT_TRANSLATE_NOOP("FileProblem", "2 GiB of numbers"), Holds::EverySample, writeMat},
    {"npy", "npy", QT_TRANSLATE_NOOP("ExportFormat", "NumPy array"),
        QT_TRANSLATE_NOOP("FileProblem", "2 GiB of numbers"), Holds::EverySample, writeNpy},
    {"wav", "wav", QT_TRANSLATE_NOOP("ExportFormat", "WAV, the fast signals as sound"),
        QT_TRANSLATE_NOOP("FileProblem", "64 signals and 4 GiB"), Holds::FastSignals, writeWav},
};

} // namespace

std::span<const ExportFormat> exportFormats() { return kFormats; }

const ExportFormat *exportFormatOf(const QString &path, bool decimalComma)
{
    const ExportFormat *found = nullptr;
    for (const ExportFormat &each : kFormats)
        if ((found == nullptr || decimalComma)
            && path.endsWith(QLatin1Char('.') + QLatin1String(each.suffix), Qt::CaseInsensitive))
            found = &each;
    return found;
}

const ExportFormat *exportFormatNamed(std::string_view name)
{
    const auto format = std::ranges::find_if(
        kFormats, [name](const ExportFormat &each) { return name == each.name; });
    return format == std::end(kFormats) ? nullptr : format;
}

} // namespace session
