// Where a trace of a unit belongs: beside those that have it, or in a plot of its own.
#pragma once

#include "capture/capture.h"
#include "widgets/base/device_text.h"
#include "widgets/scope/scope_view.h"

namespace widgets {

/// @return  a plot as ScopeView::addChannel() takes it
inline int plotForUnit(const ScopeView &scope, const capture::Capture &capture, const QString &unit)
{
    const QList<capture::ChannelId> shown = scope.channels();
    for (const capture::ChannelId id : shown)
        if (const auto info = capture.info(id); info && deviceText(info->unit) == unit)
            return scope.plotOf(id);
    return shown.isEmpty() ? 0 : scope.plotCount();
}

} // namespace widgets
