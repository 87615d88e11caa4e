#include "lab/step_plan.h"

#include "lab/to_and_fro.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace lab {

namespace {

using namespace std::chrono_literals;

constexpr double kOvershoot = 0.5; ///< of the step: loops that are being tuned overshoot
/// Of the step, and digits of a speed besides: the least undershoot of all simulated motors without a sensor with their
/// boards' gains; others have twice as much. More would refuse steps that end well.
constexpr double kUndershoot = 0.1, kUndershootDigits = 2.0;

} // namespace

std::string objectionTo(const StepPlan &plan, const Subject &subject)
{
    if (!subject.records() && plan.caps.maxCurrentAmps > 0.0 && subject.registers.current == 0)
        return "nothing tells its current in A, so that none could be held against your limit: say "
               "what the full scale of its currents is";
    if (plan.fromRpm == plan.toRpm)
        return "both speeds are the same: there is no step";
    if (plan.repeat < 1 || plan.repeat > kMostRepeats)
        return "a series has 1 to " + std::to_string(kMostRepeats) + " repetitions";
    if (plan.hold < 50ms || plan.hold > 10s)
        return "a speed is held for 50 ms to 10 s";
    return {};
}

Conditions conditionsOf(const StepPlan &plan, const Subject &subject)
{
    const double step = std::abs(double(plan.toRpm) - plan.fromRpm);
    Conditions conditions{.firstRpm = plan.fromRpm,
        .approach = plan.approach,
        .leastRpm = double(std::min(plan.fromRpm, plan.toRpm)),
        .mostRpm = double(std::max(plan.fromRpm, plan.toRpm)),
        .margin_rpm = std::max(kLeastMargin_rpm, kOvershoot * step),
        .undershoot_rpm = kUndershoot * step + kUndershootDigits * subject.limits.speedStepRpm,
        .user = plan.caps,
        .recorded = {subject.registers.reference, subject.registers.current,
            subject.registers.speed},
        .length = 2 * plan.repeat * plan.hold};
    if (subject.registers.angle != 0)
        conditions.recorded.push_back(subject.registers.angle);
    return conditions;
}

std::unique_ptr<Course> courseOf(const StepPlan &plan, const Subject &subject)
{
    const auto to = [&](int rpm) {
        return ToAndFro::Way{drive::SpeedRamp{subject.motor, rpm, 0ms}, 0ms};
    };
    return std::make_unique<ToAndFro>(to(plan.toRpm), to(plan.fromRpm), plan.hold, plan.repeat);
}

double jumpPerRpm(const Subject &subject, double gain, double exponent)
{
    const bool recorded = subject.catalog && subject.registers.reference != 0;
    const double amps =
        recorded ? subject.catalog->streamScale(subject.registers.reference).factor : 0.0;
    const double step = subject.limits.speedStepRpm;
    if (!(step > 0.0) || !(exponent >= 0.0) || exponent > 31.0)
        return 0.0;
    return gain / std::exp2(exponent) / step * amps;
}

bool usable(const Recorded<StepPlan> &found)
{
    const StepPlan &plan = found.plan;
    return plan.fromRpm != plan.toRpm && plan.repeat >= 1 && plan.repeat <= kMostRepeats
        && plan.hold >= 1ms;
}

} // namespace lab
