#include "lab/position_plan.h"

#include "lab/to_and_fro.h"
#include "motor/ramp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr milliseconds kRests = 300ms; ///< without current, before it is asked where the shaft is
constexpr double kMostDegrees = 3600.0;

double radiansOf(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Of the way, without its sign.
double peakRpm(const PositionPlan &plan)
{
    return std::abs(motor::positionPeakSpeed_rpm(radiansOf(plan.byDegrees), toSeconds(plan.ramp)));
}

/// Where the shaft is counts from where the board was switched on, and is asked for when it rests.
class PositionCourse : public Course {
public:
    PositionCourse(const PositionPlan &plan, const Subject &subject)
        : m_plan(plan)
        , m_motor(subject.motor)
        , m_position(subject.registers.position)
    {
    }

    std::optional<Ask> next(const Moment &moment) override
    {
        if (m_moves)
            return m_moves->next(moment);
        if (!moment.answered || m_over)
            return std::nullopt;
        if (!m_rests)
            m_rests = moment.now + kRests;
        if (moment.now < *m_rests)
            return std::nullopt;
        if (!std::exchange(m_asked, true))
            return drive::Read{{m_position}};
        m_over = !moment.position_rad;
        if (m_over)
            return std::nullopt;
        const double here = *moment.position_rad;
        m_moves.emplace(ToAndFro::Way{to(here + radiansOf(m_plan.byDegrees)), m_plan.ramp},
            ToAndFro::Way{to(here), m_plan.ramp}, m_plan.hold, m_plan.repeat);
        return m_moves->next(moment);
    }
    TimePoint due() const override
    {
        return m_moves ? m_moves->due() : m_rests.value_or(TimePoint{});
    }
    bool over() const override { return m_moves ? m_moves->over() : m_over; }

private:
    Ask to(double radians) const { return drive::PositionRamp{m_motor, radians, m_plan.ramp}; }

    PositionPlan m_plan;
    int m_motor;
    drive::RegisterId m_position;
    std::optional<TimePoint> m_rests;
    bool m_asked = false; ///< where it is
    bool m_over = false; ///< the board does not tell that: nothing is moved
    std::optional<ToAndFro> m_moves;
};

} // namespace

std::string objectionTo(const PositionPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    if (registers.position == 0)
        return "this board does not control the position of its shaft";
    if (registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return "this board does not record the angle of its rotor";
    if (!(std::abs(plan.byDegrees) >= 1.0 && std::abs(plan.byDegrees) <= kMostDegrees))
        return "a shaft is moved by 1 to 3600 degrees";
    if (plan.repeat < 1 || plan.repeat > kMostRepeats)
        return "a series has 1 to " + std::to_string(kMostRepeats) + " repetitions";
    if (plan.ramp < 1ms || plan.ramp > 10s)
        return "a move takes 1 ms to 10 s";
    if (plan.hold < 100ms || plan.hold > 10s)
        return "a position is held for 100 ms to 10 s";
    return {};
}

Conditions conditionsOf(const PositionPlan &plan, const Subject &subject)
{
    constexpr double kOvershoot = 0.5; // of the speed: a loop that is being tuned overshoots
    const double peak = peakRpm(plan);
    const Registers &registers = subject.registers;
    return {.beginning = Beginning::AtRest,
        .leastRpm = -peak,
        .mostRpm = peak,
        .margin_rpm = std::max(kLeastMargin_rpm, kOvershoot * peak),
        .user = plan.caps,
        .recorded = {registers.reference, registers.current, registers.speed, registers.angle},
        .length = 2 * plan.repeat * (plan.ramp + plan.hold) + kRests};
}

std::unique_ptr<Course> courseOf(const PositionPlan &plan, const Subject &subject)
{
    return std::make_unique<PositionCourse>(plan, subject);
}

bool usable(const Recorded<PositionPlan> &found)
{
    const PositionPlan &plan = found.plan;
    return std::abs(plan.byDegrees) > 0.0 && plan.ramp >= 1ms && plan.hold >= 1ms
        && found.polePairs >= 1.0;
}

} // namespace lab
