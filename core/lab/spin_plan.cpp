#include "lab/spin_plan.h"

#include "drive/motion_limits.h"
#include "lab/draw.h"
#include "lab/fields.h"

#include <algorithm>
#include <cmath>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr const char *kEntry = "spin plan";
constexpr double kLowShare = 0.25, kHighShare = 0.7; ///< of the allowed speed
constexpr double kAboveObserved =
    0.25; ///< of the way from what an observer needs to the higher speed
constexpr double kMargin = 0.6; ///< of the way between both speeds
constexpr double kFirstPush = 0.05, kMostPush = 0.7; ///< of the nominal current
constexpr double kFirstDrop = 0.2, kMostDrop = 0.95; ///< of the current that holds the speed
constexpr double kLeastDraw = 0.7; ///< of what a way would take: no two are the same
constexpr double kWay_s = 0.25; ///< from one speed to the other
constexpr double kMostGrowth = 2.0; ///< of the push from one way to the next
constexpr Duration kPatience = 1s; ///< with a push that does not reach the other speed

class SpinCourse : public Course {
public:
    SpinCourse(const SpinPlan &plan, const Subject &subject)
        : m_plan(plan)
        , m_motor(subject.motor)
        , m_sign(plan.highRpm < 0 ? -1.0 : 1.0)
        , m_nominal(subject.limits.nominalCurrentAmps)
        , m_draw(plan.seed)
    {
        if (plan.caps.maxCurrentAmps > 0.0)
            m_nominal = std::min(m_nominal, plan.caps.maxCurrentAmps);
        m_push = kFirstPush * m_nominal;
    }

    std::optional<Ask> next(const Moment &moment) override
    {
        m_due = moment.now + 20ms;
        if (!m_began) {
            m_began = moment.now;
            m_hold = std::max(0.0, moment.amps.value_or(0.0) * m_sign);
            return turn(true, moment.now);
        }
        if (moment.now - *m_began >= m_plan.length)
            m_over = moment.answered;
        if (m_over || !moment.answered || !moment.rpm)
            return std::nullopt;
        const double rpm = *moment.rpm * m_sign;
        const bool there =
            m_pushing ? rpm >= std::abs(m_plan.highRpm) : rpm <= std::abs(m_plan.lowRpm);
        const double took_s = toSeconds(moment.now - m_turned);
        if (!there && moment.now - m_turned < kPatience)
            return std::nullopt;
        const double change = there ? std::min(kMostGrowth, took_s / kWay_s) : kMostGrowth;
        if (m_pushing)
            m_push = std::min(m_used * change, kMostPush * m_nominal);
        else
            m_drop = std::min(m_used * change, kMostDrop);
        return turn(there ? !m_pushing : m_pushing, moment.now);
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_over; }

private:
    Ask turn(bool push, TimePoint now)
    {
        m_pushing = push;
        m_turned = now;
        m_used = (push ? m_push : m_drop) * m_draw.between(kLeastDraw, 1.0);
        const double amps =
            push ? std::min(m_hold + m_used, kMostPush * m_nominal) : m_hold * (1.0 - m_used);
        return drive::TorqueRamp{m_motor, m_sign * amps, 0ms};
    }

    SpinPlan m_plan;
    int m_motor;
    double m_sign;
    double m_nominal; ///< A
    Draw m_draw;
    double m_hold = 0.0; ///< A that hold the first speed
    double m_push = 0.0; ///< A above it
    double m_used = 0.0; ///< of one of the two, last
    double m_drop = kFirstDrop; ///< share of it that is taken away
    std::optional<TimePoint> m_began;
    TimePoint m_turned{}, m_due{};
    bool m_pushing = true;
    bool m_over = false;
};

} // namespace

SpinPlan spinPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    const double allowed = drive::realBoundsOf(subject.limits, caps).rpm;
    const double high = kHighShare * allowed, observed = subject.leastObservedRpm();
    const double low = std::max(kLowShare * allowed, observed + kAboveObserved * (high - observed));
    return {.lowRpm = static_cast<int>(std::lround(low)),
        .highRpm = static_cast<int>(std::lround(high)),
        .caps = caps};
}

std::string objectionTo(const SpinPlan &plan, const Subject &subject)
{
    if (subject.registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return "this board does not record the angle of its rotor";
    if (!(subject.limits.torquePerAmp > 0.0))
        return "the board does not tell the strength of the magnets, without which no torque is "
               "known";
    if (!(subject.limits.nominalCurrentAmps > 0.0))
        return "the board does not tell the nominal current of its motor";
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
        .margin_rpm = kMargin * std::abs(plan.highRpm - plan.lowRpm),
        .user = plan.caps,
        .recorded = {registers.current, registers.speed, registers.angle},
        .length = plan.length};
    for (const drive::RegisterId id : {registers.voltage, registers.currentD})
        if (id != 0)
            conditions.recorded.push_back(id);
    return conditions;
}

std::unique_ptr<Course> courseOf(const SpinPlan &plan, const Subject &subject)
{
    return std::make_unique<SpinCourse>(plan, subject);
}

record::Happening entryOf(const SpinPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    return {kEntry,
        {{"motor", std::to_string(subject.motor)}, {"low rpm", std::to_string(plan.lowRpm)},
            {"high rpm", std::to_string(plan.highRpm)},
            {"length ms", std::to_string(plan.length.count())},
            {"approach ms", std::to_string(plan.approach.count())},
            {"seed", std::to_string(plan.seed)}, {"max rpm", textOf(plan.caps.maxSpeedRpm)},
            {"max A", textOf(plan.caps.maxCurrentAmps)},
            {"current", subject.nameOf(registers.current)},
            {"current d", subject.nameOf(registers.currentD)},
            {"voltage", subject.nameOf(registers.voltage)},
            {"speed", subject.nameOf(registers.speed)}, {"angle", subject.nameOf(registers.angle)},
            {"pole pairs", textOf(subject.limits.polePairs)},
            {"torque Nm per A", textOf(subject.limits.torquePerAmp)}}};
}

std::optional<RecordedSpin> recordedSpin(const record::Happening &happening)
{
    if (happening.name != kEntry)
        return std::nullopt;
    const auto number = [&](const char *key) { return numberOf(happening, key).value_or(0.0); };
    const auto whole = [&](const char *key) { return static_cast<int>(number(key)); };
    RecordedSpin found;
    found.motor = whole("motor");
    found.plan = {.lowRpm = whole("low rpm"),
        .highRpm = whole("high rpm"),
        .length = milliseconds(whole("length ms")),
        .approach = milliseconds(whole("approach ms")),
        .seed = static_cast<std::uint32_t>(std::max(0, whole("seed"))),
        .caps = {number("max rpm"), number("max A")}};
    found.current = fieldOf(happening, "current");
    found.voltage = fieldOf(happening, "voltage");
    found.speed = fieldOf(happening, "speed");
    found.angle = fieldOf(happening, "angle");
    found.polePairs = number("pole pairs");
    found.torquePerAmp = number("torque Nm per A");
    if (found.motor < 1 || !(found.polePairs > 0.0) || !(found.torquePerAmp > 0.0))
        return std::nullopt;
    return found;
}

} // namespace lab
