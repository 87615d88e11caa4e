#include "lab/position_plan.h"

#include "drive/set_point_check.h"
#include "lab/to_and_fro.h"
#include "lab/waits.h"
#include "motor/ramp.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr milliseconds kRests = 300ms; ///< without current, before it is asked where the shaft is
constexpr milliseconds kLooksAgain = 20ms; ///< again, whether it does
constexpr milliseconds kComesToRest = 3s; ///< or never
constexpr double kMostDegrees = 3600.0;

double radiansOf(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// Of the way, without its sign.
double peakRpm(const PositionPlan &plan)
{
    return std::abs(motor::positionPeakSpeed_rpm(radiansOf(plan.byDegrees), toSeconds(plan.ramp)));
}

/// Where the shaft is counts from where the board was switched on, and is asked for when it rests: a start may have
/// aligned it, or somebody turned it.
class PositionCourse : public Course {
public:
    PositionCourse(const PositionPlan &plan, const Subject &subject)
        : m_plan(plan)
        , m_motor(subject.motor)
        , m_position(subject.registers.position)
        , m_limits(subject.limits)
    {
    }

    std::optional<Ask> next(const Moment &moment) override
    {
        if (m_moves)
            return m_moves->next(moment);
        if (!moment.answered || over())
            return std::nullopt;
        if (m_asked)
            return move(moment);
        m_begun = m_begun.value_or(moment.now);
        if (isNear(moment.rpm, 0.0, m_limits)) {
            m_rests = m_rests.value_or(moment.now + kRests);
            m_due = *m_rests;
        } else {
            m_rests.reset();
            m_due = moment.now + kLooksAgain;
            if (moment.now - *m_begun >= kComesToRest)
                m_problem = "the shaft does not come to rest without a current";
        }
        if (moment.now < m_due || over())
            return std::nullopt;
        m_asked = true;
        return drive::Read{{m_position}};
    }
    TimePoint due() const override { return m_moves ? m_moves->due() : m_due; }
    bool over() const override { return m_moves ? m_moves->over() : !m_problem.empty(); }
    std::string problem() const override { return m_problem; }

private:
    Ask to(double radians) const { return drive::PositionRamp{m_motor, radians, m_plan.ramp}; }
    std::optional<Ask> move(const Moment &moment)
    {
        if (!moment.position_rad) {
            m_problem = "the board does not tell where its shaft is";
            return std::nullopt;
        }
        const double here = *moment.position_rad, there = here + radiansOf(m_plan.byDegrees);
        if (std::max(std::abs(here), std::abs(there)) > drive::kFarthest_rad) {
            m_problem = "the shaft is too far from where the board was switched on, and positions "
                        "count from there: switch the board off and on";
            return std::nullopt;
        }
        m_moves.emplace(ToAndFro::Way{to(there), m_plan.ramp}, ToAndFro::Way{to(here), m_plan.ramp},
            m_plan.hold, m_plan.repeat);
        return m_moves->next(moment);
    }

    PositionPlan m_plan;
    int m_motor;
    drive::RegisterId m_position;
    drive::MotorLimits m_limits;
    std::optional<TimePoint> m_begun, m_rests; ///< since when; when it has for long enough
    TimePoint m_due{};
    bool m_asked = false; ///< where it is
    std::string m_problem; ///< nothing is moved
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
        .length = 2 * plan.repeat * (plan.ramp + plan.hold) + kRests + kComesToRest};
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
