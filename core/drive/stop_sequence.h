// The stop of every motor: what is to be sent when, and what may be claimed on what evidence. It does no sending.
//
// Each motor for itself: Requested -STOP sent, OK-> Accepted -two states in a row, asked for after a STOP had left,
// show it idle-> DriveIdle -three slow speeds in a row-> Standstill. Where nothing measures the speed of a rotor that
// is not driven, the last word is MayCoast. STOP is due at once and every 100 ms until DriveIdle, because a board
// answers OK to every STOP and may lose one. Half a second without DriveIdle is the alarm NotConfirmed, once; the
// repeating goes on.
//
// Rules. A motor that becomes known while a stop is active joins it; one that the board says it does not have leaves
// it. A stop is open until every motor is idle and the board has told how many there are. Asked for again, an open stop
// goes on: what was requested keeps its half second, a motor that was idle begins anew. Without a link STOPs are due
// for two seconds after it was asked for last; then only with one.
#pragma once

#include "drive/event.h"

#include <optional>
#include <vector>

namespace drive {

/// A word of a stop as the motion log has it. @param entry  with the STOPs that left since the word before
MotionEntry entryOf(const StopProgress &progress, TimePoint asked, MotionEntry entry = {});

/// Nothing drives the motor in this state: idle, fault, or waiting for the bus.
bool isDriveIdle(const MotorStatus &status);

class StopSequence {
public:
    static constexpr Duration kRepeat = std::chrono::milliseconds(100);
    static constexpr Duration kLeastTurn = std::chrono::milliseconds(40);
    static constexpr Duration kConfirmWithin = std::chrono::milliseconds(500);
    static constexpr Duration kBlindTime = std::chrono::seconds(2);
    static constexpr double kStandstillRpm = 10.0;
    static constexpr int kStandstillReadings = 3;
    /// One could be damaged: answers are not protected on the wire.
    static constexpr int kIdleReadings = 2;

    /// How sure the number of motors is.
    enum class Count : std::uint8_t {
        AtLeast, ///< there may be more
        Exactly, ///< the board has told
    };

    /// Asked for; also while it is active. @param expected  motors that may be there, too: stopped only without a link,
    /// because with one the board tells at once, and may have no such motor
    void begin(int motors, TimePoint now, int expected = 1);
    /// What is known of the motors by now. Nothing unless active().
    void follow(int motors, Count count, TimePoint now);
    void end() { m_motors.clear(); }

    bool active() const { return !m_motors.empty(); }
    /// Not confirmed: a motor is not seen idle, or there may be an unknown one.
    bool open() const { return active() && (m_count != Count::Exactly || !allIdle()); }
    /// A motor is not seen idle: nothing but STOP, link control and the reading of states may leave.
    bool exclusive() const { return !allIdle(); }
    /// The alarm was raised for a motor that is not idle until now.
    bool alarmed() const;
    /// Until then STOPs are sent without a link.
    TimePoint blindUntil() const { return m_blindUntil; }
    bool blind(TimePoint now) const { return active() && now < m_blindUntil; }

    /// The motor that a STOP is due for, and has been for longest; `connected` says whether there is a link.
    std::optional<int> stopDue(TimePoint now, bool connected) const;
    /// How soon another STOP follows one without an answer: each motor has its turn within kRepeat, as long as
    /// that leaves a link the time to send one.
    Duration turn() const;
    void stopSent(int number, TimePoint now);
    /// The last STOP of it may not have left: the next one is due at once.
    void stopFailed(int number, TimePoint now);
    void stopAnswered(int number, TimePoint now);
    /// A status whose request left at `askedAt`.
    void acceptStatus(const MotorStatus &status, TimePoint askedAt);
    void handleTimeout(TimePoint now);
    /// When the next STOP or the alarm is due.
    std::optional<TimePoint> nextStop(bool connected, TimePoint now) const;
    std::optional<TimePoint> nextAlarm() const;

    std::vector<StopProgress> takeProgress() { return std::exchange(m_progress, {}); }

private:
    struct Motor {
        int number = 1;
        TimePoint begun; ///< the alarm counts from here
        TimePoint nextStop;
        std::optional<TimePoint> firstSent{};
        bool accepted = false, idle = false, standstill = false, alarmed = false;
        int idleReadings = 0, slowReadings = 0;
    };
    bool allIdle() const;
    bool wantsStop(const Motor &motor, bool connected) const;
    void add(int motors, TimePoint now);
    void endAtStandstill();
    Motor *find(int number);
    void tell(const Motor &motor, StopWord word, TimePoint at);

    std::vector<Motor> m_motors;
    std::vector<StopProgress> m_progress;
    TimePoint m_blindUntil;
    Count m_count = Count::AtLeast;
    int m_known = 1; ///< motors that the board is known to have
};

} // namespace drive
