#include "lab/spin_plan.h"

#include "base/random.h"
#include "drive/motion_limits.h"
#include "lab/to_and_fro.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr double kLowShare = 0.25, kHighShare = 0.7; ///< of the allowed speed
constexpr double kFluxLowShare = 0.45, kFluxHighShare = 0.65; ///< inductances take fast turns
/// Of the way from what an observer needs to the higher speed.
constexpr double kAboveObserved = 0.25;
constexpr double kFluxShare = 0.4; ///< of the nominal current
/// Of the way between both speeds: for a host that stalls.
constexpr double kSpinMargin = 0.6, kFluxMargin = 1.3;
constexpr double kFirstPush = 0.05, kMostPush = 0.7; ///< of the nominal current
constexpr double kFirstDrop = 0.6, kMostDrop = 0.95; ///< of the current that holds the speed
constexpr double kLeastDraw = 0.7; ///< of what a way would take: no two are the same
/// From one speed to the other. Slow ways, and more of them, tell frictions apart; but Hall sensors lag in them all the
/// time, by more than is seen, and where currents flow along the magnets what matters is how they change.
constexpr double kWay_s = 0.25, kSlowWay_s = 0.4;
constexpr milliseconds kLength = 8s, kSlowLength = 16s;
constexpr double kMostGrowth = 2.0; ///< of the push from one way to the next
constexpr Duration kShake = 50ms; ///< with currents along the magnets, until all of them jump
constexpr double kLifts = 0.1; ///< the bus: of the way to its bound
constexpr Duration kFalls = 100ms; ///< once nothing comes back to it any more
/// To either side, of what accelerates, or of what is left while it coasts. Far jumps tell Lq best. An observer's angle
/// moves with them, which costs Ld less than they gain; Hall sensors lag behind them.
constexpr double kJump = 0.9, kHallJump = 0.5;
/// What held the first speed may have been measured badly: if too much of it is left, the motor goes on to accelerate.
constexpr Duration kLook = 20ms;
constexpr int kLooks = SpinPlan::kListen / kLook;
constexpr double kAway = 0.2; ///< of the way, beyond the speed that it comes from
constexpr Duration kNoticed = 100ms;
constexpr Duration kPatience = 1s; ///< with a push that does not reach the other speed

/// A, of the motor, or what the user allows where that is less.
double nominalOf(const Subject &subject, const drive::UserLimits &caps)
{
    const double nominal = subject.limits.nominalCurrentAmps;
    return caps.maxCurrentAmps > 0.0 ? std::min(nominal, caps.maxCurrentAmps) : nominal;
}

class SpinCourse : public Course {
public:
    SpinCourse(const SpinPlan &plan, const Subject &subject)
        : m_plan(plan)
        , m_motor(subject.motor)
        , m_sign(plan.highRpm < 0 ? -1.0 : 1.0)
        , m_nominal(nominalOf(subject, plan.caps))
        , m_draw(plan.seed)
        , m_jump(byHall(subject.nameOf(subject.registers.angle)) ? kHallJump : kJump)
        , m_way_s(plan.fluxAmps > 0.0 || byHall(subject.nameOf(subject.registers.angle))
                  ? kWay_s
                  : kSlowWay_s)
        , m_leastAlong(-plan.fluxAmps)
        , m_mostAlong(plan.fluxAmps)
    {
        m_push = kFirstPush * m_nominal;
    }

    std::optional<Ask> next(const Moment &moment) override
    {
        if (!m_began)
            return listen(moment);
        m_due = moment.now + kLook;
        if (moment.now - *m_began >= m_plan.length)
            m_over = moment.answered;
        if (m_over || !moment.answered || !moment.rpm)
            return std::nullopt;
        const double rpm = *moment.rpm * m_sign;
        const bool there =
            m_pushing ? rpm >= std::abs(m_plan.highRpm) : rpm <= std::abs(m_plan.lowRpm);
        const double took_s = toSeconds(moment.now - m_turned);
        const double way = std::abs(m_plan.highRpm - m_plan.lowRpm);
        const double beyond =
            m_pushing ? std::abs(m_plan.lowRpm) - rpm : rpm - std::abs(m_plan.highRpm);
        const bool strays = beyond > kAway * way;
        if (m_plan.fluxAmps > 0.0 && strays && moment.now - m_turned < kPatience)
            return calm(moment.now);
        m_calm = false;
        const bool runsAway = !m_pushing && moment.now - m_turned >= kNoticed && strays;
        if (!there && !runsAway && moment.now - m_turned < kPatience)
            return m_plan.fluxAmps > 0.0 && (brakes(moment) || moment.now - m_shaken >= kShake)
                ? std::optional(shake(moment.now))
                : std::nullopt;
        const double change = there ? std::min(kMostGrowth, took_s / m_way_s) : kMostGrowth;
        if (m_pushing)
            m_push = std::min(m_used * change, kMostPush * m_nominal);
        else
            m_drop = std::min(m_used * change, kMostDrop);
        return turn(there ? !m_pushing : m_pushing, moment.now);
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_over; }

private:
    std::optional<Ask> listen(const Moment &moment)
    {
        if (moment.now < m_due)
            return std::nullopt;
        m_due = moment.now + kLook;
        m_hold += moment.amps.value_or(0.0) * m_sign / kLooks;
        if (++m_looks < kLooks)
            return std::nullopt;
        // Of the mean, not of each look: where little holds the speed that would be half of its loop's noise.
        m_hold = std::max(0.0, m_hold);
        m_began = moment.now;
        return turn(true, moment.now);
    }

    Ask turn(bool push, TimePoint now)
    {
        m_pushing = push;
        m_turned = now;
        m_used = (push ? m_push : m_drop) * m_draw.between(kLeastDraw, 1.0);
        const double amps =
            push ? std::min(m_hold + m_used, kMostPush * m_nominal) : m_hold * (1.0 - m_used);
        if (m_plan.fluxAmps == 0.0)
            return drive::TorqueRamp{m_motor, m_sign * amps, 0ms};
        m_mean = amps;
        return shake(now);
    }

    /// A current along the magnets brakes to one side where an encoder stands aside, and what comes back lifts the bus:
    /// from then on it flows to the other side. What is only as high as before is not being lifted.
    bool brakes(const Moment &moment)
    {
        if (!moment.busRise)
            return false;
        const bool settled = moment.now - m_flipped >= kFalls;
        const double before = m_busRise;
        m_busRise = settled ? *moment.busRise : std::max(before, *moment.busRise);
        if (!settled || m_along == 0.0 || *moment.busRise <= std::max(kLifts, before))
            return false;
        m_flipped = moment.now;
        m_leastAlong = m_along < 0.0 ? 0.0 : -m_plan.fluxAmps;
        m_mostAlong = m_along < 0.0 ? m_plan.fluxAmps : 0.0;
        return true;
    }

    /// Nothing along the magnets, which is a torque where an encoder stands aside, and no jump.
    std::optional<Ask> calm(TimePoint now)
    {
        if (std::exchange(m_calm, true))
            return std::nullopt;
        m_shaken = now;
        m_along = 0.0;
        const double amps = m_pushing ? std::min(m_hold + m_push, kMostPush * m_nominal)
                                      : m_hold * (1.0 - kMostDrop);
        return drive::CurrentReference{m_motor, m_sign * amps, 0.0};
    }

    /// The same torque on the whole, in jumps, and another current along the magnets with each.
    Ask shake(TimePoint now)
    {
        m_shaken = now;
        m_above = !m_above;
        const double jump = m_jump * std::abs(m_mean - m_hold * (m_pushing ? 1.0 : 0.0));
        m_along = m_draw.between(m_leastAlong, m_mostAlong);
        const double most = std::sqrt(std::max(0.0, m_nominal * m_nominal - m_along * m_along));
        return drive::CurrentReference{
            m_motor, m_sign * std::min(most, m_mean + (m_above ? jump : -jump)), m_along};
    }

    SpinPlan m_plan;
    int m_motor;
    double m_sign;
    double m_nominal; ///< A
    Draw m_draw;
    double m_jump;
    double m_way_s;
    double m_hold = 0.0; ///< A that hold the first speed: a mean, for its loop makes noise
    int m_looks = 0;
    double m_push = 0.0; ///< A above it
    double m_used = 0.0; ///< of one of the two, last
    double m_drop = kFirstDrop; ///< share of it that is taken away
    std::optional<TimePoint> m_began;
    double m_mean = 0.0; ///< A, of this way
    double m_leastAlong, m_mostAlong; ///< A along the magnets, to either side or to one
    double m_along = 0.0;
    double m_busRise = 0.0; ///< when it was seen last
    TimePoint m_turned{}, m_shaken{}, m_flipped{}, m_due{};
    bool m_above = false;
    bool m_calm = false; ///< until it is nearer to the speeds that it goes between
    bool m_pushing = true;
    bool m_over = false;
};

/// Speeds and currents that are read, in a unit that makes torques of them.
std::string objectionToPolled(const SpinPlan &plan, const Subject &subject)
{
    if (plan.fluxAmps != 0.0)
        return "this board records nothing by itself: inductances are not told from values that "
               "are read one after the other";
    if (subject.registers.current == 0)
        return "nothing tells its current in A, and so no torque: say what the full scale of its "
               "currents is";
    if (!(subject.limits.torquePerAmp > 0.0))
        return "nothing tells which torque an ampere makes: it follows from pole pairs and flux of "
               "a motor file";
    return {};
}

std::string objectionToRecorded(const SpinPlan &plan, const Subject &subject)
{
    if (subject.registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return "this board does not record the angle of its rotor";
    if (!(subject.limits.torquePerAmp > 0.0))
        return "the board does not tell the strength of the magnets, without which no torque is "
               "known";
    if (!(subject.limits.nominalCurrentAmps > 0.0))
        return "the board does not tell the nominal current of its motor";
    const double mostAlong = kMostPush * nominalOf(subject, plan.caps);
    if (!(plan.fluxAmps >= 0.0) || plan.fluxAmps > mostAlong)
        return "at most " + decimalText(mostAlong, 3) + " A flow along the magnets";
    if (plan.fluxAmps > 0.0 && (subject.registers.voltage == 0 || subject.registers.currentD == 0))
        return "this board does not record its voltage and both of its currents";
    return {};
}

} // namespace

SpinPlan spinPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    const double allowed = drive::realBoundsOf(subject.limits, caps).rpm;
    const double high = kHighShare * allowed, observed = subject.leastObservedRpm(caps.maxSpeedRpm);
    const double low = std::max(kLowShare * allowed, observed + kAboveObserved * (high - observed));
    return {.lowRpm = static_cast<int>(std::lround(low)),
        .highRpm = static_cast<int>(std::lround(high)),
        .length = !subject.records()                          ? 5 * SpinPlan::kRound
            : byHall(subject.nameOf(subject.registers.angle)) ? kLength
                                                              : kSlowLength,
        .caps = caps};
}

SpinPlan otherWay(SpinPlan plan)
{
    plan.lowRpm = -plan.lowRpm;
    plan.highRpm = -plan.highRpm;
    return plan;
}

SpinPlan fluxPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    SpinPlan plan = spinPlanFor(subject, caps);
    plan.lowRpm = static_cast<int>(
        std::lround(kFluxLowShare * drive::realBoundsOf(subject.limits, caps).rpm));
    plan.highRpm = static_cast<int>(
        std::lround(kFluxHighShare * drive::realBoundsOf(subject.limits, caps).rpm));
    plan.fluxAmps = kFluxShare * nominalOf(subject, caps);
    plan.length = 12s;
    return plan;
}

std::string objectionTo(const SpinPlan &plan, const Subject &subject)
{
    if (std::string why = !subject.records() ? objectionToPolled(plan, subject)
                                             : objectionToRecorded(plan, subject);
        !why.empty())
        return why;
    if (!subject.records() && plan.length < SpinPlan::kRound)
        return "its ramps take " + decimalText(toSeconds(SpinPlan::kRound), 3) + " s";
    if (plan.length < 1s || plan.length > 30s)
        return "it takes 1 to 30 s";
    const bool sameSign = (plan.lowRpm > 0) == (plan.highRpm > 0);
    if (plan.lowRpm == 0 || !sameSign || std::abs(plan.highRpm) <= std::abs(plan.lowRpm))
        return "it needs two speeds in one direction, the lower one first";
    return {};
}

Conditions conditionsOf(const SpinPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    Conditions conditions{.firstRpm = plan.lowRpm,
        .approach = plan.approach,
        .leastRpm = double(std::min(plan.lowRpm, plan.highRpm)),
        .mostRpm = double(std::max(plan.lowRpm, plan.highRpm)),
        .margin_rpm = (plan.fluxAmps > 0.0 ? kFluxMargin : kSpinMargin)
            * std::abs(plan.highRpm - plan.lowRpm),
        .user = plan.caps,
        .recorded = {registers.current, registers.speed, registers.angle},
        .length = plan.length,
        .steady = plan.fluxAmps > 0.0 || !subject.records()};
    if (!subject.records()) {
        conditions.recorded = {registers.speed, registers.current};
        return conditions;
    }
    if (plan.fluxAmps > 0.0) {
        // At the full rate of the control loop, which leaves room for no more.
        conditions.recorded = {
            registers.current, registers.currentD, registers.voltage, registers.angle};
        conditions.zeroBefore = {registers.referenceD};
        return conditions;
    }
    // Only an encoder can have been aligned aside, which that voltage tells; others are better served by a higher rate.
    const bool aligned = byEncoder(subject.nameOf(registers.angle));
    for (const drive::RegisterId id :
        {registers.voltage, aligned ? registers.voltageD : 0, registers.currentD})
        if (id != 0)
            conditions.recorded.push_back(id);
    return conditions;
}

std::unique_ptr<Course> courseOf(const SpinPlan &plan, const Subject &subject)
{
    const auto to = [&](int rpm, milliseconds ramp) {
        return ToAndFro::Way{drive::SpeedRamp{subject.motor, rpm, ramp}, ramp};
    };
    if (!subject.records())
        return std::make_unique<ToAndFro>(to(plan.highRpm, SpinPlan::kUp),
            to(plan.lowRpm, SpinPlan::kDown), SpinPlan::kHold, plan.length / SpinPlan::kRound);
    return std::make_unique<SpinCourse>(plan, subject);
}

double leastTurning_degPerS(const Recorded<SpinPlan> &spin)
{
    constexpr double kShare = 0.2, kRpm_degPerS = 6.0;
    return kShare * std::abs(spin.plan.lowRpm) * spin.polePairs * kRpm_degPerS;
}

bool usable(const Recorded<SpinPlan> &found)
{
    return (found.angle.empty() || found.polePairs > 0.0) && found.torquePerAmp > 0.0;
}

} // namespace lab
