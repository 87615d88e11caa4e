// DeadMan: whether the user interface of a session is alive, and what follows when it is not. It knows no clock, no
// thread and no drive: its owner asks judge() at each turn and does what the verdict says.
//
//   interface --attend(), hold(): atomics, never a queued call--> Stamps --> DeadMan::judge(now) --> Verdict
//
// A queued call would tell nothing of a frozen interface, and a frozen session would find a heap of them and believe
// that all was well; of an atomic both sides see how old it is. Times are of a clock that goes on while the computer
// sleeps.
//
// Not attended for 500 ms: disarmed, and with that nothing that acts is sent and no drive watchdog is fed. For 2 s,
// while a motor turns that the user has armed here: all motors are stopped. A motor that was left running on purpose
// (disarmed by the user) is not judged here. What is held (a jog) ends 300 ms after its own last stamp. Nothing is ever
// armed again, and no hold revived, by a stamp that comes late.
#pragma once

#include "drive/event.h"

#include <atomic>
#include <map>
#include <optional>
#include <utility>

namespace session {

/// How it is known that the user can see and stop what a session does.
enum class Attendance : std::uint8_t {
    Stamped, ///< the interface calls Session::attend() again and again, from its own thread
    OwnThread, ///< the interface runs in the session's thread: while the session turns, it does too
};

/// What went on unattended, told afterwards.
struct Interruption {
    enum class Cause : std::uint8_t {
        Interface, ///< the interface stood still
        Gap, ///< this program, or the whole computer, stood still
        Hold, ///< what held a jog was not heard of
        LateArming, ///< arming was asked for too long ago: it was not done
    };
    Cause cause = Cause::Interface;
    Duration length{}; ///< how long, as far as it is known
    bool disarmed = false;
    /// A STOP of every motor was begun; for Hold: of the one motor, or of all.
    bool stopped = false;
    bool operator==(const Interruption &) const = default;
};

/// Signs of life. Written by the interface's thread, read by the session's.
class Stamps {
public:
    void attend(TimePoint now);
    /// What moves this motor is held now. Motors from 1.
    void hold(int motor, TimePoint now);
    void release() { m_hold.store(0); }

    struct Seen {
        std::optional<TimePoint> attended; ///< last; empty: never
        Duration longestSilence{}; ///< between two stamps since the last call
        int motor = 0; ///< that is held; 0: none
        std::uint64_t hold = 0; ///< each has a number of its own
        TimePoint held;
    };
    [[nodiscard]] Seen take();

private:
    using Ticks = TimePoint::rep;
    static constexpr Ticks kNever = TimePoint::min().time_since_epoch().count();
    static constexpr std::uint64_t kMotors = 256;

    std::atomic<Ticks> m_attended = kNever;
    std::atomic<Ticks> m_longest = 0;
    std::atomic<Ticks> m_held = kNever;
    std::atomic<std::uint64_t> m_hold = 0; ///< its number * kMotors + motor; 0: nothing is held
    std::uint64_t m_holds = 0; ///< of the interface's thread
};

class DeadMan {
public:
    static constexpr Duration kAbsentAfter = std::chrono::milliseconds(500);
    static constexpr Duration kGoneAfter = std::chrono::seconds(2);
    static constexpr Duration kHoldsFor = std::chrono::milliseconds(300);
    static constexpr Duration kIdleWithin = std::chrono::milliseconds(800); ///< after a hold's end
    static constexpr Duration kLook = std::chrono::milliseconds(100); ///< how often, in doubt

    struct Verdict {
        bool disarm = false;
        bool stopAll = false;
        int stopMotor = 0; ///< this one alone; 0: none
    };

    explicit DeadMan(Attendance attendance)
        : m_attendance(attendance)
    {
    }

    void begin(TimePoint now); ///< the user has opened a connection
    void armed() { m_ours = true; } ///< the user has armed
    void disarmed() { m_ours = false; } ///< the user has: what turns is left to turn
    /// Every motor was told to stop for another reason: nothing that is still to be told goes on as it was.
    void stopped();
    void acceptStatus(const drive::MotorStatus &status) { m_states[status.motor] = status.state; }

    /// Whether what turns now, or could, is this interface's to answer for.
    bool responsible() const { return m_ours; }
    /// Unattended for kAbsentAfter.
    bool absent() const { return m_absence.has_value(); }

    /// @param armed  whether the drive is, now
    /// @param gap    how long nothing ran here until just now; zero: it did
    Verdict judge(const Stamps::Seen &seen, bool armed, Duration gap, TimePoint now);
    /// How long judge() can wait; empty: until something is armed, held or told.
    std::optional<Duration> nextLook(bool armed, TimePoint now) const;
    /// What is to be told, in order.
    std::vector<Interruption> takeNews() { return std::exchange(m_news, {}); }
    void tell(const Interruption &news) { m_news.push_back(news); }

private:
    bool driven() const;
    bool driven(int motor) const;
    Duration silence(const Stamps::Seen &seen, Duration gap, TimePoint now) const;
    void judgeHold(const Stamps::Seen &seen, Verdict &verdict, TimePoint now);

    Attendance m_attendance;
    TimePoint m_begun{};
    TimePoint m_attended{}; ///< last, or begun
    std::map<int, drive::MotorState> m_states;
    bool m_ours = false;
    std::optional<Interruption> m_absence; ///< under way
    std::uint64_t m_hold = 0; ///< under way
    TimePoint m_held{};
    std::uint64_t m_endedHold = 0; ///< the last one that was not heard of
    int m_endedMotor = 0;
    std::optional<TimePoint> m_idleBy; ///< that motor
    std::vector<Interruption> m_news;
};

} // namespace session
