#include "lab/rest_plan.h"

#include "drive/motion_limits.h"
#include "motor/rev_up.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr double kLowCurrent = 0.25, kHighCurrent = 0.5; ///< of the nominal current
constexpr int kLevels = 4; ///< along the magnets
/// Of the last stage: a host that stalls must not let a start-up fail.
constexpr milliseconds kSpare = 2s;
/// Of the allowed speed: driven by what should turn nothing, as one that was aligned aside is.
constexpr double kTurns = 0.1;
constexpr double kDrawnMargin = 0.2; ///< of the allowed speed: a rotor that is drawn to its place

/// No speed in any of them.
drive::RegisterWrite stagesOf(const RestPlan &plan, const Subject &subject)
{
    const double ampsPerDigit = subject.catalog->streamScale(subject.registers.current).factor;
    const auto digits = [&](double amps) {
        constexpr double kMost = 32767.0;
        return static_cast<std::int16_t>(std::lround(std::min(amps / ampsPerDigit, kMost)));
    };
    const auto time = [](milliseconds value) { return static_cast<std::uint16_t>(value.count()); };
    const std::int16_t low = digits(plan.lowAmps), high = digits(plan.highAmps);
    return {subject.registers.startUp,
        motor::bytesOf({{0, low, time(plan.rise)}, {0, low, time(plan.hold)},
            {0, high, time(plan.rise)}, {0, high, time(plan.hold)}, {0, high, time(kSpare)}})};
}

/// Waits until the start-up has held its strongest current.
class StartUpCourse : public Course {
public:
    explicit StartUpCourse(const RestPlan &plan)
        : m_plan(plan)
    {
    }
    std::optional<Ask> next(const Moment &moment) override
    {
        constexpr double kThere = 0.95;
        constexpr Duration kCalibration = 2s; ///< before the first stage
        m_due = moment.now + 20ms;
        if (!m_began)
            m_began = moment.now;
        if (!m_there && std::abs(moment.amps.value_or(0.0)) >= kThere * m_plan.highAmps)
            m_there = moment.now;
        m_over = (m_there && moment.now - *m_there >= m_plan.hold)
            || moment.now - *m_began > 2 * (m_plan.rise + m_plan.hold) + kCalibration;
        return std::nullopt;
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_over; }

private:
    RestPlan m_plan;
    std::optional<TimePoint> m_began, m_there;
    TimePoint m_due{};
    bool m_over = false;
};

/// One current after the other along the magnets: against them, because a board that can weaken them takes none that
/// would strengthen them; but with them where Hall sensors leave the angle open, so that they draw the rotor to it.
class LevelCourse : public Course {
public:
    LevelCourse(const RestPlan &plan, const Subject &subject)
        : m_plan(plan)
        , m_motor(subject.motor)
        , m_sign(byHall(subject.nameOf(subject.registers.angle)) ? 1.0 : -1.0)
        , m_turns_rpm(kTurns * drive::realBoundsOf(subject.limits, plan.caps).rpm)
    {
    }
    std::optional<Ask> next(const Moment &moment) override
    {
        const bool turns = m_level > 0 && std::abs(moment.rpm.value_or(0.0)) > m_turns_rpm;
        if (turns)
            m_level = std::max(m_level, kLevels);
        if (!moment.answered || (m_level > 0 && moment.now < m_due && !turns))
            return std::nullopt;
        m_over = m_level > kLevels;
        if (m_over)
            return std::nullopt;
        m_due = moment.now + m_plan.rise + m_plan.hold;
        const double share = static_cast<double>(m_level) / (kLevels - 1);
        const double amps = m_plan.lowAmps + share * (m_plan.highAmps - m_plan.lowAmps);
        const bool last = m_level++ == kLevels;
        if (last)
            m_due = moment.now;
        return drive::CurrentReference{m_motor, 0.0, last ? 0.0 : m_sign * amps};
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_over; }

private:
    RestPlan m_plan;
    int m_motor;
    double m_sign;
    double m_turns_rpm; ///< from there on it gets no more current
    int m_level = 0; ///< asked for
    TimePoint m_due{};
    bool m_over = false;
};

} // namespace

RestPlan restPlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    double nominal = subject.limits.nominalCurrentAmps;
    if (caps.maxCurrentAmps > 0.0)
        nominal = std::min(nominal, caps.maxCurrentAmps);
    return {.lowAmps = kLowCurrent * nominal, .highAmps = kHighCurrent * nominal, .caps = caps};
}

std::string objectionTo(const RestPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    const std::array all{
        registers.voltage, registers.voltageD, registers.currentD, registers.angle};
    if (std::find(all.begin(), all.end(), 0U) != all.end())
        return "this board does not record voltages, currents and the angle of its rotor";
    if (subject.seesRotor() ? registers.referenceD == 0 : registers.startUp == 0)
        return "this board holds no current through a motor that rests";
    if (!(subject.limits.nominalCurrentAmps > 0.0))
        return "the board does not tell the nominal current of its motor";
    if (!(plan.lowAmps > 0.0) || !(plan.highAmps >= 1.5 * plan.lowAmps))
        return "it needs two currents, the second at least 1.5 times as strong as the first";
    const double allowed = std::min(
        drive::realBoundsOf(subject.limits, plan.caps).amps, subject.limits.nominalCurrentAmps);
    if (plan.highAmps > allowed)
        return decimalText(plan.highAmps, 3) + " A are more than the " + decimalText(allowed, 3)
            + (allowed == plan.caps.maxCurrentAmps ? " A of your own limit"
                                                   : " A that a motor at rest is given here");
    if (plan.rise < 10ms || plan.rise > 2s || plan.hold < 100ms || plan.hold > 2s)
        return "a current rises within 10 ms to 2 s and is held for 100 ms to 2 s";
    return {};
}

Conditions conditionsOf(const RestPlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    const bool sees = subject.seesRotor();
    Conditions conditions{.beginning = sees ? Beginning::AtRest : Beginning::WhileStarting,
        .margin_rpm = kDrawnMargin * drive::realBoundsOf(subject.limits, plan.caps).rpm,
        .user = plan.caps,
        .recorded = {sees ? registers.referenceD : registers.reference, registers.current,
            registers.currentD, registers.voltage, registers.voltageD, registers.speed,
            registers.angle},
        .length = (sees ? kLevels : 2) * (plan.rise + plan.hold)};
    if (!sees)
        conditions.lent.push_back(stagesOf(plan, subject));
    return conditions;
}

std::unique_ptr<Course> courseOf(const RestPlan &plan, const Subject &subject)
{
    if (subject.seesRotor())
        return std::make_unique<LevelCourse>(plan, subject);
    return std::make_unique<StartUpCourse>(plan);
}

bool usable(const Recorded<RestPlan> &found)
{
    return found.plan.lowAmps > 0.0 && found.nominalAmps > 0.0;
}

} // namespace lab
