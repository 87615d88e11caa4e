// Carries out an experiment: a machine without I/O between a drive's events and its wishes, in the session's thread.
// While it runs, every packet of samples and every reading is held against the envelope; what breaks it asks for a Stop
// of every motor at once, and that is the last thing the runner asks for. Ending it does the same while it drives the
// motor by a torque, or by the currents of a start-up: nothing but the envelope bounds those.
//
// Every way out brings the motor back to what it was, as far as that is possible, and says in a sentence what is not as
// it was: at the end and where a wish is refused, by the old set-point or by stopping the motor that it started; after
// a Stop the motor rests, and the set-point is the one that stood when it was stopped. What it borrowed goes back after
// a fault, too, and after another's stop, because the drive is armed still; not after a Stop, which disarms.
//
// Call order: begin(); then take() for every event of the drive and advance() when nextTimeout() is due, each followed
// by takeStop() and takeWishes(); until over().
#pragma once

#include "drive/start_target.h"
#include "lab/envelope.h"
#include "lab/experiment.h"
#include "lab/waits.h"

#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lab {

class Runner {
public:
    /// Wishes of a runner have ids from here on: no others are as large.
    static constexpr drive::WishId kFirstWish = drive::WishId{1} << 62;

    explicit Runner(Experiment experiment);

    /// @param ranAt  when a motor of the board was last seen not to be idle: its rotor may turn on for a while
    void begin(TimePoint now, std::optional<TimePoint> ranAt = {});
    void accept(const drive::Event &event, TimePoint now);
    void advance(TimePoint now); ///< early or repeated calls do nothing
    /// Another act decided about the motor: nothing more is asked of it, but a Stop where nothing would bound it any
    /// more, which goes ahead of what was decided. @param why  in words
    void interrupt(const std::string &why);
    /// The same when every motor was stopped: there is nothing left to be asked for.
    void stopped();
    /// The same when the user disarms, which by itself stops no motor.
    void disarm();
    /// Nothing reaches the board any more: what it set going is to be stopped as soon as that is possible.
    void lose(const std::string &why);

    const Experiment &experiment() const { return m_experiment; }

    std::vector<drive::Wish> takeWishes();
    /// Once true: every motor is to be stopped, before anything else leaves.
    bool takeStop() { return std::exchange(m_stop, false); }
    std::optional<TimePoint> nextTimeout() const;
    bool over() const { return m_outcome.has_value(); }
    const Outcome &outcome() const { return *m_outcome; } ///< once over()

private:
    enum class Phase : std::uint8_t {
        Reading, ///< what the motor does now
        Streaming, ///< until the board records
        Watching, ///< until the rest is polled
        Coasting, ///< until the rotor of a motor that was stopped a moment ago stands
        Travelling, ///< until set-points go with every exchange, while the motor rests
        Lending, ///< of the registers that the plan writes, while the motor rests
        Aiming, ///< of a motor at rest: until its start goes to the first speed, or to no current
        Starting, ///< until it runs
        Approaching, ///< until the speed is the first one
        Working, ///< until its course is over
        Returning, ///< to the speed of before, or to rest
        Restoring, ///< of the borrowed registers and of the set-point, while it rests
        Comparing, ///< what the board has now
        Over,
    };

    void ask(Ask what, TimePoint now);
    void again(TimePoint now);
    void ramp(int rpm, milliseconds duration, TimePoint now);
    void enter(Phase phase, Duration within, TimePoint now);
    void coast(TimePoint now);
    void lend(TimePoint now);
    void aim(TimePoint now);
    void start(TimePoint now);
    void onStarted(TimePoint now);
    void onEnded(const drive::Ended &ended, TimePoint now);
    void onStatus(const drive::MotorStatus &status, TimePoint now);
    void onRead(TimePoint now);
    void onCompared();
    std::string wrongWay() const;
    void onLate(TimePoint now);
    void approach(TimePoint now);
    void work(TimePoint now);
    void giveBack(TimePoint now);
    void catchSpeed(TimePoint now);
    void restore(TimePoint now);
    void endButReturn(End end, const std::string &why, TimePoint now);
    void restoreNext(TimePoint now);
    void compare(TimePoint now);
    void giveUp(End end, const std::string &reason, TimePoint now);
    void abort(const std::string &reason, const char *stopping = kStopping);
    void cut(const std::string &why);
    void restSetPoints();
    void finish();
    bool steadyAt(double rpm, TimePoint now);
    bool hadItsTime(TimePoint now) const;
    bool swingsThrough(TimePoint now);
    drive::StartTarget startTarget() const;
    std::optional<ShownReference> shownReference() const;
    bool moves() const { return m_phase >= Phase::Starting && m_phase <= Phase::Returning; }
    bool needsEnvelope() const;
    Caps caps() const;
    Caps startCaps() const;
    Caps courseCaps() const;
    std::optional<double> busRise() const;
    double mostBefore_v() const;
    milliseconds wayTo(double rpm) const;
    std::optional<double> shown(drive::RegisterId id) const;

    static constexpr const char *kStopping = "every motor was told to stop";

    Experiment m_experiment;
    Conditions m_conditions;
    std::unique_ptr<Course> m_course;
    Envelope m_envelope;
    Phase m_phase = Phase::Over;
    TimePoint m_until{}; ///< the phase is over by then, or it has failed
    std::optional<TimePoint> m_deadline; ///< the motor is as before by then; once it runs
    Settling m_settling; ///< of the speed, in this phase
    bool m_swings = false; ///< and was not when the course began
    double m_ampSum = 0.0; ///< of the means of the packets since the speed should have come to rest
    int m_ampCount = 0;

    drive::WishId m_lastWish = kFirstWish;
    drive::WishId m_waiting = 0; ///< what the phase waits for; 0: it has ended
    bool m_answered = false; ///< with ok
    TimePoint m_answeredAt{}; ///< the last, however it ended
    bool m_commanded = false; ///< something left that may move the motor
    std::map<drive::RegisterId, catalog::Value> m_values; ///< the newest
    std::optional<drive::MotorStatus> m_status;
    std::vector<drive::RegisterWrite> m_old; ///< of the borrowed registers
    std::optional<TimePoint> m_ranAt;
    bool m_lent = false; ///< they may hold what the experiment wrote
    std::vector<drive::RegisterWrite> m_way; ///< how a start went to its speed (Subject::way)
    bool m_wayWritten = false; ///< it may be another one
    bool m_travels = false; ///< set-points do, with every exchange, since this asked for it
    bool m_cut = false; ///< it has ended, and only gives those back
    std::deque<Ask> m_restores; ///< still to be asked for
    double m_before_rpm = 0.0; ///< the set-point
    milliseconds m_beforeRamp{}; ///< in which it was to be reached
    std::optional<double> m_beforeShown_rpm; ///< of the speed reference
    std::optional<double> m_before_v; ///< of the bus
    std::optional<double> m_before_c; ///< of the power stage
    /// Most square of speed, rpm^2, that a step took away, and no bound was broken.
    double m_braked = 0.0;
    double m_target_rpm = 0.0; ///< the set-point that the board may have taken last
    Ask m_asked; ///< last
    int m_tries = 0; ///< of it, that were too late
    std::optional<int> m_asked_rpm; ///< on its way
    bool m_stands = false; ///< the start was refused
    /// A torque was asked for, or a position, and no speed was taken since.
    bool m_byTorque = false;
    bool m_byPosition = false; ///< that was the last of them
    drive::CurrentReference m_currents; ///< that were asked for last
    bool m_ran = false; ///< the motor did
    Outcome m_soFar;

    std::vector<drive::Wish> m_wishes;
    bool m_stop = false;
    std::optional<Outcome> m_outcome;
};

} // namespace lab
