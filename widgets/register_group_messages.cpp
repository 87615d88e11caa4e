#include "widgets/register_group_messages.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace widgets {
namespace {

constexpr const char *kGroups[] = {
    QT_TRANSLATE_NOOP("RegisterGroups", "Profiler"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Measurements"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Six-step"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Ramps and references"),
    QT_TRANSLATE_NOOP("RegisterGroups", "PFC"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Motor parameters"),
    QT_TRANSLATE_NOOP("RegisterGroups", "HSO and ZeST observer"),
    QT_TRANSLATE_NOOP("RegisterGroups", "DAC and debug"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Current loop"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Sensing and offsets"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Observer + PLL"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Position"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Observer + CORDIC"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Identity"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Configuration"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Speed loop"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Datalog"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Start-up"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Motor state"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Modulation"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Feed forward"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Flux weakening"),
    QT_TRANSLATE_NOOP("RegisterGroups", "Encoder and Hall"),
};

} // namespace

QString registerGroupText(const std::string &group)
{
    const auto *known = std::find(std::begin(kGroups), std::end(kGroups), group);
    return known != std::end(kGroups) ? QCoreApplication::translate("RegisterGroups", *known)
                                      : QString::fromStdString(group);
}

} // namespace widgets
