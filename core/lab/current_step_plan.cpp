#include "lab/current_step_plan.h"

#include "drive/motion_limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr double kSpeedUsed = 0.35, kSpeedUsedObserved = 0.45; ///< of the allowed speed
/// Of it, around the speed: where the speed leaves that, the next current comes at once. A torque may push the motor
/// further than it slows down while nothing pushes.
constexpr double kBelow = 0.15, kAbove = 0.25;
constexpr double kLowest = 0.5; ///< of the speed
/// Of the allowed speed, above what an observer needs, and at most of the way there: while the next current is on its
/// way a light motor that nothing pushes goes on slowing down, by some 5 rpm each millisecond.
constexpr double kRoom = 0.1, kMostRoom = 2.0 / 3.0;
constexpr double kStallMargin = 0.2; ///< of the allowed speed, beyond these: for a host that stalls
constexpr double kMostFlux = 0.7; ///< of the nominal current
constexpr double kMostFluxObserved = 0.4; ///< an observer loses its rotor by more
constexpr milliseconds kSettles = 300ms, kTakeOver = 300ms; ///< at the speed, and on the way to it
constexpr milliseconds kCoasts = 1s; ///< at most, until it is back
/// Until what is asked for counts at the motor: a packet, an answer, a host that stalls.
constexpr milliseconds kLate = 60ms;
constexpr milliseconds kPacket = 20ms; ///< of samples: so much older the newest speed may be
constexpr milliseconds kGently = 3s; ///< where it has not coasted so far

/// How far the speed may go, from the nearer to 0 on, without its sign.
std::pair<double, double> windowOf(const CurrentStepPlan &plan, const Subject &subject)
{
    const double allowed = drive::realBoundsOf(subject.limits, plan.caps).rpm;
    const double rpm = std::abs(plan.rpm);
    const double low = std::max(rpm - kBelow * allowed, kLowest * rpm);
    const double observed = subject.leastObservedRpm();
    const double room = std::clamp((rpm - observed) * kMostRoom, 0.0, kRoom * allowed);
    return {std::max(low, observed > 0.0 ? observed + room : 0.0), rpm + kAbove * allowed};
}

class CurrentStepCourse : public Course {
public:
    CurrentStepCourse(const CurrentStepPlan &plan, const Subject &subject)
        : m_plan(plan)
        , m_motor(subject.motor)
        , m_window(windowOf(plan, subject))
        , m_observed(!subject.seesRotor())
    {
    }

    std::optional<Ask> next(const Moment &moment) override
    {
        if (!moment.answered || m_over)
            return std::nullopt;
        const double rpm = moment.rpm.value_or(0.0) * (m_plan.rpm < 0 ? -1.0 : 1.0);
        if (!std::exchange(m_timed, true)) { // from the answer on
            m_due = moment.now + timeOf(m_stage);
            m_from_rpm = rpm;
        }
        bool goesOn = moment.now < m_due;
        if (m_stage == Stage::Turning) {
            m_sum_a += moment.amps.value_or(0.0);
            ++m_count;
        } else if (m_stage == Stage::Coasting) {
            m_falls_rpm = fallsBy(rpm, moment.now);
            goesOn = goesOn && rpm - m_falls_rpm > std::abs(m_plan.rpm);
        } else {
            goesOn = goesOn && rpm > m_window.first && rpm < m_window.second;
        }
        if (goesOn)
            return std::nullopt;
        m_over = m_stage == Stage::Turning && m_done == m_plan.repeat;
        return m_over ? std::nullopt : std::optional(leave(rpm));
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_over; }

private:
    enum class Stage : std::uint8_t { Turning, Before, Stepped, Back, Coasting };

    milliseconds timeOf(Stage stage) const
    {
        return stage == Stage::Turning ? m_takeOver + kSettles
            : stage == Stage::Coasting ? kCoasts
                                       : m_plan.hold;
    }

    /// What a coasting motor without a sensor will have lost when the ramp that it is asked for now counts.
    double fallsBy(double rpm, TimePoint now) const
    {
        if (!m_observed)
            return 0.0;
        const Duration coasted = std::max<Duration>(now - (m_due - kCoasts), kPacket);
        return std::max(0.0, m_from_rpm - rpm) * toSeconds(kLate) / toSeconds(coasted);
    }
    /// More slowly than it coasts: then nothing brakes it.
    milliseconds takeOver(double rpm) const
    {
        const double slowly = m_falls_rpm * toSeconds(kTakeOver) / toSeconds(kLate);
        const double near = (kNear - 1.0) * std::abs(m_plan.rpm);
        return rpm > std::abs(m_plan.rpm) + std::max(near, slowly) ? kGently : kTakeOver;
    }

    Ask leave(double rpm)
    {
        m_timed = false;
        // A slow one need not coast, but the current along the magnets has to end.
        const bool slow = m_plan.flux == 0 && m_stage == Stage::Back && rpm < std::abs(m_plan.rpm);
        m_stage = m_stage == Stage::Coasting || slow
            ? Stage::Turning
            : static_cast<Stage>(static_cast<int>(m_stage) + 1);
        switch (m_stage) {
        case Stage::Turning:
            ++m_done;
            m_sum_a = 0.0;
            m_count = 0;
            m_takeOver = takeOver(rpm);
            m_falls_rpm = 0.0;
            return drive::SpeedRamp{m_motor, m_plan.rpm, m_takeOver};
        case Stage::Coasting:
            return current(0.0, 0.0);
        case Stage::Stepped:
            return current(m_plan.toAmps, held());
        case Stage::Before:
        case Stage::Back:
            return current(m_plan.fromAmps, held());
        }
        return current(0.0, 0.0);
    }

    /// What holds the speed.
    double held() const { return m_sum_a / std::max(m_count, 1); }

    Ask current(double amps, double beside) const
    {
        if (m_plan.flux != 0)
            return drive::CurrentReference{m_motor, beside, amps};
        return drive::TorqueRamp{m_motor, amps, 0ms};
    }

    static constexpr double kNear = 1.02; ///< of a speed: its noise

    CurrentStepPlan m_plan;
    int m_motor;
    std::pair<double, double> m_window; ///< rpm
    bool m_observed; ///< it has no sensor
    double m_falls_rpm = 0.0; ///< fallsBy(), where it coasts
    Stage m_stage = Stage::Turning;
    bool m_timed = false; ///< its time began
    double m_from_rpm = 0.0; ///< the speed then
    milliseconds m_takeOver{0};
    double m_sum_a = 0.0; ///< of Iq, by packets
    int m_count = 0;
    int m_done = 0;
    TimePoint m_due{};
    bool m_over = false;
};

} // namespace

CurrentStepPlan currentStepPlanFor(const Subject &subject, bool flux, double fromAmps,
    double toAmps, const drive::UserLimits &caps)
{
    const double allowed = drive::realBoundsOf(subject.limits, caps).rpm;
    const double rpm = (subject.seesRotor() ? kSpeedUsed : kSpeedUsedObserved) * allowed;
    const bool backwards = !flux && fromAmps + toAmps < 0.0;
    return {.flux = flux ? 1 : 0,
        .fromAmps = fromAmps,
        .toAmps = toAmps,
        .rpm = static_cast<int>(std::lround(backwards ? -rpm : rpm)),
        .caps = caps};
}

std::string objectionTo(const CurrentStepPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    const bool flux = plan.flux != 0;
    if (registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return "this board does not record the angle of its rotor";
    if (flux && (registers.referenceD == 0 || registers.currentD == 0))
        return "this board does not record the current along its magnets";
    if (plan.fromAmps == plan.toAmps)
        return "both currents are the same: there is no step";
    if (plan.repeat < 1 || plan.repeat > kMostRepeats)
        return "a series has 1 to " + std::to_string(kMostRepeats) + " repetitions";
    if (plan.hold < 10ms || plan.hold > 500ms)
        return "a current is held for 10 to 500 ms";
    if (plan.rpm == 0)
        return "the motor has to turn";
    const double most = std::max(std::abs(plan.fromAmps), std::abs(plan.toAmps));
    double allowed = drive::realBoundsOf(subject.limits, plan.caps).amps;
    if (flux)
        allowed = std::min(allowed,
            (subject.seesRotor() ? kMostFlux : kMostFluxObserved)
                * subject.limits.nominalCurrentAmps);
    if (!(most <= allowed))
        return decimalText(most, 3) + " A are more than the " + decimalText(allowed, 3)
            + " A that are allowed";
    const double way = plan.rpm < 0 ? -1.0 : 1.0;
    if (!flux && std::min(plan.fromAmps * way, plan.toAmps * way) < 0.0)
        return "a torque against the way that the motor turns would brake it, and nothing says "
               "that its supply takes what comes back: both currents have to push the same way";
    return {};
}

Conditions conditionsOf(const CurrentStepPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    const auto [low, high] = windowOf(plan, subject);
    const bool backwards = plan.rpm < 0;
    // Four signals: as many as a link of 1.8 Mbit/s carries at the full rate of the control loop.
    Conditions conditions{.firstRpm = plan.rpm,
        .approach = plan.approach,
        .leastRpm = backwards ? -high : low,
        .mostRpm = backwards ? -low : high,
        .margin_rpm = kStallMargin * drive::realBoundsOf(subject.limits, plan.caps).rpm,
        .user = plan.caps,
        .recorded = {registers.reference, registers.current, registers.speed, registers.angle},
        .length = plan.repeat * (3 * plan.hold + kCoasts + kGently + kSettles) + kSettles};
    if (plan.flux != 0) {
        conditions.recorded = {
            registers.referenceD, registers.currentD, registers.current, registers.angle};
        conditions.zeroBefore = {registers.referenceD};
    }
    return conditions;
}

std::unique_ptr<Course> courseOf(const CurrentStepPlan &plan, const Subject &subject)
{
    return std::make_unique<CurrentStepCourse>(plan, subject);
}

bool usable(const Recorded<CurrentStepPlan> &found)
{
    return found.plan.fromAmps != found.plan.toAmps && found.plan.hold >= 1ms;
}

} // namespace lab
