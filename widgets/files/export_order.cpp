#include "widgets/files/export_order.h"

#include "capture/csv_export.h"
#include "session/files/problems.h"
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

/// Sound leaves much out, and so may rows that are those of the fastest signals.
bool holdsAll(const ExportOrder &order)
{
    using Holds = session::ExportFormat::Holds;
    if (order.range || order.format->holds == Holds::FastSignals)
        return false;
    return order.format->holds == Holds::EverySample
        || std::all_of(order.parts.begin(), order.parts.end(), [](const ExportOrder::Part &part) {
               return capture::everySampleHasARow(part.channels);
           });
}

QString partErrorText(const ExportOrder &order, const ExportResult &result)
{
    return result.last.problem != session::ExportProblem::None
        ? session::exportProblemText(result.last.problem, *order.format, translatedFileProblem)
        : exportFileErrorText(result.last.file, result.path);
}

} // namespace

ExportResult carryOut(const ExportOrder &order, const std::function<bool(double)> &proceed)
{
    ExportResult result;
    for (qsizetype i = 0; i < order.parts.size() && result.ok(); ++i) {
        const ExportOrder::Part &part = order.parts[i];
        result.path = part.path;
        result.last =
            order.format->write(part.path, {part.channels, order.range}, [&](double fraction) {
                return proceed(
                    (static_cast<double>(i) + fraction) / static_cast<double>(order.parts.size()));
            });
        if (result.ok()) {
            result.written.append(QFileInfo(part.path).fileName());
            result.rows += result.last.rows;
        }
    }
    result.allInIt = result.ok() && holdsAll(order);
    return result;
}

QString exportErrorText(const ExportOrder &order, const ExportResult &result)
{
    if (result.written.isEmpty())
        return partErrorText(order, result);
    const QString names = deviceText(result.written.join(QStringLiteral(", ")));
    if (result.cancelled())
        return Exports::tr("The export was cancelled. Written before: %1.", "files").arg(names);
    return partErrorText(order, result) + QLatin1Char(' ')
        + Exports::tr("Written before: %1.", "files").arg(names);
}

} // namespace widgets
