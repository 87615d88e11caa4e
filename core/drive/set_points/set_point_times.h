// SetPointTimes: when set-points left for a board, on the axis of its samples. It listens to a drive and its line, from outside:
// what is wished, when bytes leave and come, what the drive tells.
//
// The instant is that of the last bytes before the answer; the board had it between then and the answer, and nothing tells
// more. The samples' axis is the board's own count, put once on the clock here; a packet comes some time after its last
// sample, never before, so that of the packets of the last seconds the promptest tells how both stand to each other.
#pragma once

#include "drive/event.h"

#include <map>
#include <optional>

namespace drive {

/// How far the axis of streamed samples is ahead of the clock here.
class SampleAxis {
public:
    void forget() { *this = {}; }
    /// What was sampled at `sampled_s` of the axis has been here at `arrived_s`.
    void heard(double arrived_s, double sampled_s);
    /// To be added to a time of the clock here; 0 before anything was heard.
    double ahead_s() const;

private:
    std::optional<double> m_least, m_before; ///< of this stretch and of the one before it
    double m_since = 0.0;
};

/// A set-point that a board has, as far as is known.
struct SentSetPoint {
    enum class Kind : std::uint8_t { Speed, Current, Position };
    WishId wish = 0;
    Kind kind = Kind::Speed;
    int motor = 1;
    double value = 0.0; ///< rpm, A (Iq) or rad
    std::chrono::milliseconds ramp{}; ///< in which it goes there
    double seconds = 0.0; ///< its bytes left, on the axis of the samples
    double within_s = 0.0; ///< it was there within so long after that
    double ahead_s = 0.0; ///< of the axis, before the clock here
};

class SetPointTimes {
public:
    void onWish(const Wish &wish);
    void onSent(TimePoint now) { m_sent = now; }
    void onReceived(TimePoint) { m_sentBefore = m_sent; }
    /// @return  a set-point that this event tells the end of
    std::optional<SentSetPoint> onEvent(const Event &event, TimePoint now);

private:
    void heard(const capture::SampleBlock &block, TimePoint now);

    std::map<WishId, SentSetPoint> m_wished;
    TimePoint m_sent{}, m_sentBefore{}; ///< bytes, and those before what came last
    double m_bytesPerSecond = 0.0;
    capture::StreamLayout m_layout;
    SampleAxis m_axis;
};

} // namespace drive
