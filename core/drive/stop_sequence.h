// The stop of every motor: what is to be sent when, and what may be claimed on what evidence. It does no sending.
//
// begin() -> Requested. STOP goes out for each motor and is repeated until the drive is seen idle,
// because the board answers OK to every STOP and may lose one. An OK is only Accepted. DriveIdle
// needs a STATUS, twice in a row, that was asked for after a STOP had left; Standstill needs three
// slow speed readings after that. No such STATUS within half a second is the alarm NotConfirmed;
// the repeating goes on. Without a link the STOPs are sent blind for two seconds; once a link is
// there again, the repeating goes on.
#pragma once

#include "drive/event.h"

#include <optional>
#include <vector>

namespace drive {

/// Nothing drives the motor in this state: idle, fault, or waiting for the bus.
bool isDriveIdle(const MotorStatus &status);

class StopSequence {
public:
    static constexpr Duration kRepeat = std::chrono::milliseconds(100);
    static constexpr Duration kConfirmWithin = std::chrono::milliseconds(500);
    static constexpr Duration kBlindTime = std::chrono::seconds(2);
    static constexpr double kStandstillRpm = 10.0;
    static constexpr int kStandstillReadings = 3;
    static constexpr int kIdleReadings =
        2; ///< one could be damaged: answers are not protected on the wire

    void begin(int motors, TimePoint now);
    void end() { m_motors.clear(); }

    bool active() const { return !m_motors.empty(); }
    /// Nothing but STOP, link control and the reading of states may leave.
    bool exclusive() const;
    /// The alarm was raised for a motor that is not idle until now.
    bool alarmed() const;
    /// Until then STOPs are sent without a link.
    TimePoint blindUntil() const { return m_begun + kBlindTime; }
    bool blind(TimePoint now) const { return active() && now < blindUntil(); }

    /// The motor that a STOP is due for; `connected` says whether there is a link.
    std::optional<int> stopDue(TimePoint now, bool connected) const;
    void stopSent(int number, TimePoint now);
    void stopAnswered(int number, TimePoint now);
    /// A status whose request left at `askedAt`.
    void takeStatus(const MotorStatus &status, TimePoint askedAt);
    void handleTimeout(TimePoint now);
    /// When the next STOP or the alarm is due.
    std::optional<TimePoint> nextStop(bool connected, TimePoint now) const;
    std::optional<TimePoint> nextAlarm() const;

    std::vector<StopProgress> takeProgress() { return std::exchange(m_progress, {}); }

private:
    struct Motor {
        int number = 1;
        std::optional<TimePoint> firstSent;
        TimePoint nextStop;
        bool accepted = false, idle = false, standstill = false, alarmed = false;
        int idleReadings = 0, slowReadings = 0;
    };
    Motor *find(int number);
    void tell(const Motor &motor, StopWord word, TimePoint at);

    std::vector<Motor> m_motors;
    std::vector<StopProgress> m_progress;
    TimePoint m_begun;
};

} // namespace drive
