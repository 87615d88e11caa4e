// SetPointTimes: when set-points left for a board, on the axis of its samples, and from when on a motor does not follow
// them. It listens to a drive and its line, from outside: what is wished, when bytes leave and come, what the drive
// tells.
//
// The instant is that of the last bytes before the answer; the board had it between then and the answer, and nothing
// tells more. The samples' axis is the board's own count, put once on the clock here; a packet comes some time after
// its last sample, never before, so that of the packets of the last seconds the promptest tells how both stand to each
// other.
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
    /// A time of the clock here, on the axis, where the two have drifted apart: by more than samples are under way, and
    /// heard for more than a second.
    double of(double seconds) const;

private:
    std::optional<double> m_least, m_before; ///< of this stretch and of the one before it
    double m_since = 0.0;
    double m_late = 0.0; ///< the newest
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
    bool sure = true; ///< the board answered; else it is unknown whether it has it
    bool runs = true; ///< it goes there now; else the motor stands, and it waits for the next start
};

/// What was sent holds no more: a stop, a fault, a reset, a register written past it.
struct SetPointsEnd {
    WishId wish = 0; ///< 0: none told it
    int motor = 0; ///< 0: of every motor
    /// Its ramp stays where it is; else nothing that was sent tells what it follows.
    bool held = false;
    double seconds = 0.0; ///< on the axis of the samples
    double within_s = 0.0;
};

using SetPointNews = std::variant<SentSetPoint, SetPointsEnd>;

class SetPointTimes {
public:
    void onWish(const Wish &wish);
    void onSent(TimePoint now) { m_sent = now; }
    void onReceived(TimePoint now)
    {
        m_sentBefore = m_sent;
        m_received = now;
    }
    /// Of every motor, as it leaves.
    SetPointsEnd onStop(TimePoint now) const { return endAt(0, now); }
    /// @return  what this event tells of set-points
    std::optional<SetPointNews> onEvent(const Event &event, TimePoint now);

private:
    struct Motor {
        MotorState state = MotorState::Unknown;
        TimePoint drivenAt{}; ///< when it was last known to be
    };
    void heard(const capture::SampleBlock &block, TimePoint now);
    std::optional<SetPointNews> ended(const Ended &ended, TimePoint now);
    std::optional<SetPointNews> status(const MotorStatus &status);
    SetPointsEnd endAt(int motor, TimePoint at) const
    {
        return {.motor = motor, .seconds = onAxis(at)};
    }
    double onAxis(TimePoint at) const
    {
        return toSeconds(at.time_since_epoch()) + m_axis.ahead_s();
    }

    std::map<WishId, SetPointNews> m_wished;
    std::map<int, Motor> m_motors;
    std::shared_ptr<const catalog::Catalog> m_catalog;
    TimePoint m_sent{}, m_sentBefore{}; ///< bytes, and those before what came last
    TimePoint m_received{};
    double m_bytesPerSecond = 0.0;
    capture::StreamLayout m_layout;
    SampleAxis m_axis;
};

} // namespace drive
