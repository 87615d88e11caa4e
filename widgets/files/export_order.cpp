#include "widgets/files/export_order.h"

#include "session/mat_file.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>

namespace widgets {
namespace {

struct Exports {
    Q_DECLARE_TR_FUNCTIONS(Exports)
};

using Proceed = std::function<bool(double)>;

session::CsvResult resultOf(const session::FileResult &file, const QString &path)
{
    return {file.error, path, file.systemText, 0, file.bytes};
}

void writePart(const ExportOrder &order, const ExportOrder::Part &part, const Proceed &proceed,
    ExportResult &result)
{
    if (order.format == ExportFormat::Wav) {
        capture::WavWriter writer(part.channels, order.range);
        result.wav = writer.problem();
        if (result.wav == capture::WavProblem::None)
            result.file =
                resultOf(session::writePieces(
                             part.path, [&](std::string_view &bytes) { return writer.next(bytes); },
                             [&] { return proceed(writer.progress()); }),
                    part.path);
    } else if (order.format == ExportFormat::Mat) {
        const session::MatResult written =
            session::writeMatFile(part.path, part.channels, order.range, proceed);
        result.matTooLong = written.tooLong;
        result.file = resultOf(written.file, part.path);
    } else {
        capture::CsvOptions options;
        options.range = order.range;
        if (order.format == ExportFormat::CsvContinental)
            options.dialect = capture::CsvDialect::Continental;
        capture::CsvWriter writer(part.channels, options);
        result.file = session::writeCsvFile(part.path, writer, proceed);
    }
}

/// Pictures and sound leave much out, and so may rows that are those of the fastest signals.
bool holdsAll(const ExportOrder &order)
{
    if (order.range || isPicture(order.format) || order.format == ExportFormat::Wav)
        return false;
    return order.format == ExportFormat::Mat
        || std::all_of(order.parts.begin(), order.parts.end(), [](const ExportOrder::Part &part) {
               return capture::everySampleHasARow(part.channels);
           });
}

QString wavText(capture::WavProblem problem)
{
    switch (problem) {
    case capture::WavProblem::None:
        break;
    case capture::WavProblem::NoFastSamples:
        return Exports::tr(
            "No WAV file: there is no time at which all fast signals were recorded.");
    case capture::WavProblem::DifferentRates:
        return Exports::tr("No WAV file: the signals have different rates.");
    case capture::WavProblem::TooManyChannels:
        return Exports::tr("No WAV file: there are more than 64 signals.");
    case capture::WavProblem::TooLong:
        return Exports::tr("No WAV file: it would be longer than 4 GiB. Choose a shorter range.");
    }
    return {};
}

} // namespace

bool isPicture(ExportFormat format)
{
    return format == ExportFormat::Png || format == ExportFormat::Svg
        || format == ExportFormat::Pdf;
}

QString suffixOf(ExportFormat format)
{
    switch (format) {
    case ExportFormat::Csv:
    case ExportFormat::CsvContinental:
        break;
    case ExportFormat::Wav:
        return QStringLiteral("wav");
    case ExportFormat::Mat:
        return QStringLiteral("mat");
    case ExportFormat::Png:
        return QStringLiteral("png");
    case ExportFormat::Svg:
        return QStringLiteral("svg");
    case ExportFormat::Pdf:
        return QStringLiteral("pdf");
    }
    return QStringLiteral("csv");
}

QString filterOf(ExportFormat format)
{
    switch (format) {
    case ExportFormat::Csv:
    case ExportFormat::CsvContinental:
        break;
    case ExportFormat::Wav:
        return Exports::tr("WAV files (*.wav)");
    case ExportFormat::Mat:
        return Exports::tr("MATLAB files (*.mat)");
    case ExportFormat::Png:
        return Exports::tr("PNG pictures (*.png)");
    case ExportFormat::Svg:
        return Exports::tr("SVG pictures (*.svg)");
    case ExportFormat::Pdf:
        return Exports::tr("PDF files (*.pdf)");
    }
    return Exports::tr("CSV files (*.csv)");
}

ExportResult carryOut(const ExportOrder &order, const Proceed &proceed)
{
    ExportResult result;
    for (qsizetype i = 0; i < order.parts.size() && result.ok(); ++i) {
        writePart(
            order, order.parts[i],
            [&](double fraction) {
                return proceed(
                    (static_cast<double>(i) + fraction) / static_cast<double>(order.parts.size()));
            },
            result);
        if (result.ok())
            result.written.append(QFileInfo(order.parts[i].path).fileName());
    }
    result.allInIt = result.ok() && holdsAll(order);
    return result;
}

namespace {
QString partErrorText(const ExportResult &result)
{
    if (result.wav != capture::WavProblem::None)
        return wavText(result.wav);
    if (result.matTooLong)
        return Exports::tr(
            "No MATLAB file: it would hold more than 2 GiB of numbers. Choose a shorter range.");
    return csvErrorText(result.file);
}
} // namespace

QString exportErrorText(const ExportResult &result)
{
    if (result.written.isEmpty())
        return partErrorText(result);
    const QString names = deviceText(result.written.join(QStringLiteral(", ")));
    if (result.cancelled())
        return Exports::tr("The export was cancelled. Written before: %1.", "files").arg(names);
    return partErrorText(result) + QLatin1Char(' ')
        + Exports::tr("Written before: %1.", "files").arg(names);
}

} // namespace widgets
