#include "lab/response_plan.h"

#include "base/random.h"
#include "base/text.h"
#include "drive/motion_limits.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr double kMostSpeed = 0.4; ///< of the allowed speed
constexpr double kLeastDigits = 10.0, kSpeedShare = 0.03; ///< of the amplitude
constexpr double kMarginAmplitudes = 3.0; ///< amplitudes beyond both
/// Between two samples. A current is known at its samples alone, and what is faster folds into the highest points: of a
/// speed's response they are 1 % off here. The speed loop holds a current's reference for a millisecond each: its jumps
/// fold into all frequencies, by 7 % of the gain where samples are 0.94 ms apart.
constexpr double kFarthestOfSpeed_s = 1.25e-3, kFarthestOfCurrent_s = 0.5e-3;
constexpr int kMostGain = 32767; ///< of a register of 16 bits

class ResponseCourse : public Course {
public:
    /// @param shorter  of the two times for which the set-point is held
    ResponseCourse(const ResponsePlan &plan, int motor, milliseconds shorter)
        : m_plan(plan)
        , m_motor(motor)
        , m_shorter(shorter)
        , m_draw(plan.seed)
    {
    }
    std::optional<Ask> next(const Moment &moment) override
    {
        if (!m_began)
            m_began = m_due = moment.now;
        if (!moment.answered || moment.now < m_due)
            return std::nullopt;
        if (moment.now - *m_began >= m_plan.length) {
            m_over = true;
            return std::nullopt;
        }
        // From when it was due, so that the link's pace is not in it; but never two at once.
        m_due = std::max(m_due, moment.now - m_shorter / 3)
            + (m_draw.between(0.0, 1.0) < 0.5 ? m_shorter : 2 * m_shorter);
        if (std::exchange(m_up, m_draw.between(0.0, 1.0) < 0.5) == m_up && m_moved)
            return std::nullopt;
        m_moved = true;
        return drive::SpeedRamp{
            m_motor, m_plan.rpm + (m_up ? m_plan.amplitudeRpm : -m_plan.amplitudeRpm), 0ms};
    }
    TimePoint due() const override { return m_due; }
    bool over() const override { return m_over; }

private:
    ResponsePlan m_plan;
    int m_motor;
    milliseconds m_shorter;
    Draw m_draw;
    std::optional<TimePoint> m_began;
    TimePoint m_due{};
    bool m_up = false, m_moved = false, m_over = false;
};

} // namespace

ResponsePlan responsePlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    const double allowed = drive::realBoundsOf(subject.limits, caps).rpm;
    ResponsePlan plan;
    plan.rpm = static_cast<int>(std::lround(kMostSpeed * allowed));
    plan.amplitudeRpm = usualAmplitudeRpm(subject, plan.rpm);
    plan.caps = caps;
    return plan;
}

ResponsePlan currentResponsePlanFor(const Subject &subject, const drive::UserLimits &caps)
{
    ResponsePlan plan = responsePlanFor(subject, caps);
    plan.current = 1;
    plan.length = 6s;
    return plan;
}

int usualAmplitudeRpm(const Subject &subject, int rpm)
{
    return static_cast<int>(std::lround(
        std::max(kLeastDigits * subject.limits.speedStepRpm, kSpeedShare * std::abs(rpm))));
}

std::string tooFarApart(double step_s, bool ofCurrent)
{
    constexpr double kRounding = 1e-9, kMilliseconds = 1e3;
    const double most_s = ofCurrent ? kFarthestOfCurrent_s : kFarthestOfSpeed_s;
    if (step_s <= most_s + kRounding)
        return {};
    return "its samples are " + decimalText(step_s * kMilliseconds, 3)
        + " ms apart, too far for the response of a " + (ofCurrent ? "current" : "speed") + ": "
        + decimalText(most_s * kMilliseconds, 3) + " ms are the most";
}

std::string objectionTo(const ResponsePlan &plan, const Subject &subject)
{
    constexpr std::size_t kSignals = 4;
    const Registers &registers = subject.registers;
    if (subject.exchanged
            ? std::min({registers.reference, registers.current, registers.speedReference}) == 0
            : registers.angle == 0 || !(subject.limits.polePairs > 0.0))
        return subject.exchanged
            ? "this drive does not send its speed, its current and what they are to be"
            : "this board does not record the angle of its rotor";
    if (const auto why =
            tooFarApart(subject.fastEvery(kSignals) / subject.tickHz, plan.current != 0);
        subject.tickHz > 0.0 && !why.empty())
        return why;
    if (plan.length < 4s || plan.length > 40s)
        return "it takes 4 to 40 s";
    if (plan.amplitudeRpm < 1)
        return "the speed has to go to and fro by 1 rpm or more";
    if (2 * plan.amplitudeRpm >= std::abs(plan.rpm))
        return "the speed may go to and fro by less than half of it";
    if (plan.kp < 0 || plan.ki < 0 || plan.kp > kMostGain || plan.ki > kMostGain)
        return "gains are 0 to " + std::to_string(kMostGain) + " digits";
    if (plan.kp > 0 && (subject.registers.gain == 0 || subject.registers.integral == 0))
        return "this board has no gains of a speed loop";
    return {};
}

Conditions conditionsOf(const ResponsePlan &plan, const Subject &subject)
{
    const Registers &registers = subject.registers;
    std::vector<drive::RegisterWrite> lent;
    if (plan.kp > 0)
        lent = {
            {registers.gain, std::int64_t{plan.kp}}, {registers.integral, std::int64_t{plan.ki}}};
    return {.firstRpm = plan.rpm,
        .approach = plan.approach,
        .leastRpm = double(plan.rpm) - plan.amplitudeRpm,
        .mostRpm = double(plan.rpm) + plan.amplitudeRpm,
        .margin_rpm = std::max(kLeastMargin_rpm, kMarginAmplitudes * plan.amplitudeRpm),
        .user = plan.caps,
        .recorded = {registers.reference, registers.current, registers.speed,
            subject.exchanged ? registers.speedReference : registers.angle},
        .length = plan.length,
        .lent = lent,
        .travels = subject.exchanged};
}

std::unique_ptr<Course> courseOf(const ResponsePlan &plan, const Subject &subject)
{
    return std::make_unique<ResponseCourse>(plan, subject.motor, subject.exchanged ? 5ms : 30ms);
}

bool usable(const Recorded<ResponsePlan> &found)
{
    return (found.angle.empty() || found.polePairs > 0.0) && found.plan.amplitudeRpm >= 1;
}

} // namespace lab
