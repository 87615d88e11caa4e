// What the picture has besides its traces, as plain data: the range of an axis, ghosts behind the traces, and over them
// the trigger and what a measurement measured.
#pragma once

#include "capture/capture.h"
#include "scope/measurement.h"

#include <QString>

#include <optional>
#include <vector>

namespace widgets {

/// What a value axis shows.
struct ValueRange {
    double from = 0.0, to = 1.0; ///< in the unit of its channels; from < to
    bool operator==(const ValueRange &) const = default;
};

constexpr int kReferenceAlpha = 130; ///< of 255: what is drawn of a reference

/// Traces that the user keeps to compare with.
enum class Reference : std::uint8_t { A, B };

/// Traces of another time, drawn paler behind those of now: a reference that was kept, or records shown before.
struct Ghost {
    capture::Snapshot kept; ///< nullptr: from the recording itself
    double shift = 0.0; ///< seconds to add to the picture's time to get the ghost's
    int alpha = 110; ///< of 255
    char mark = 0; ///< the letter of a reference, which is dashed; 0: an earlier record
    bool operator==(const Ghost &) const = default;
};

/// Where the trigger stands: its levels on the trace that is watched, and its time.
struct TriggerMarks {
    capture::ChannelId source = 0;
    std::vector<double> levels; ///< in the source's unit; empty: no level is waited for
    std::optional<double> position; ///< seconds on the session's axis; empty: the picture rolls
    bool operator==(const TriggerMarks &) const = default;
};

/// Levels and points that a measurement found, in the words of core/scope.
struct MeasureMarks {
    capture::ChannelId channel = 0;
    std::vector<scope::LevelMark> levels;
    std::vector<scope::PointMark> points;
    QString text; ///< what is written beside them
    bool empty() const { return levels.empty() && points.empty(); }
};

} // namespace widgets
