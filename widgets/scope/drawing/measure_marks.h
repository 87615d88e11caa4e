// What a measurement measured, to be drawn over its trace: levels and points, in the words of core/scope.
#pragma once

#include "capture/channel.h"
#include "scope/measurement.h"

#include <QString>

namespace widgets {

struct MeasureMarks {
    capture::ChannelId channel = 0;
    std::vector<scope::LevelMark> levels;
    std::vector<scope::PointMark> points;
    QString text; ///< what is written beside them
    bool empty() const { return levels.empty() && points.empty(); }
};

} // namespace widgets
