#include "lab/evaluation/power_evaluation.h"

#include "lab/evaluation/segments.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace lab {

namespace {

constexpr double kPhases = 1.5; ///< three, and half of a product of peaks
/// Shares that are unsure: of voltages, whose bus is told in whole volts; of what dead times take, which depends on the
/// angle where it was measured; of resistances; of a torque, also where an observer stands five degrees aside.
constexpr double kVoltage = 0.015, kDeadTimes = 0.1, kOhms = 0.02, kTorque = 0.01, kObserved = 0.03;

/// Means over blocks: rpm, W.
struct PowerBlocks {
    std::vector<double> speed, electrical, dead, copper, shaft, efficiency;

    void add(const Segment &segment, const Recorded<PowerPlan> &of, std::size_t at, std::size_t end)
    {
        const auto count = static_cast<double>(end - at);
        const double w = (segment.turned_deg[end] - segment.turned_deg[at]) * std::numbers::pi
            / (180.0 * of.polePairs * count * segment.step_s);
        double power = 0.0, amps = 0.0, square = 0.0, torque = 0.0;
        for (std::size_t i = at; i < end; ++i) {
            const double q = segment.values[0][i], d = segment.values[1][i];
            power += kPhases * (segment.values[2][i] * q + segment.values[3][i] * d) / count;
            amps += std::hypot(q, d) / count;
            square += (q * q + d * d) / count;
            torque += (of.torquePerAmp - kPhases * of.polePairs * of.saliency_h * d) * q / count;
        }
        speed.push_back(w * 30.0 / std::numbers::pi);
        dead.push_back(kPhases * of.plan.deadVolts * amps);
        electrical.push_back(power - dead.back());
        copper.push_back(kPhases * of.plan.rsOhm * square);
        shaft.push_back(torque * w);
        efficiency.push_back(shaft.back() / electrical.back());
    }
};

Figures figuresFrom(const PowerBlocks &blocks, const Recorded<PowerPlan> &of)
{
    const double torque = byEncoder(of.angle) || byHall(of.angle) ? kTorque : kObserved;
    const double in = meanOf(blocks.electrical)->value, out = meanOf(blocks.shaft)->value;
    const double volts = std::hypot(kVoltage, kDeadTimes * meanOf(blocks.dead)->value / in);
    std::optional<Estimate> copper, efficiency;
    if (of.plan.rsOhm > 0.0)
        copper = withScale(*meanOf(blocks.copper), kOhms);
    if (in > 0.0 && out > 0.0)
        efficiency = withScale(*meanOf(blocks.efficiency), std::hypot(volts, torque));
    return {{"speed_rpm", "Speed", "rpm", withScale(*meanOf(blocks.speed), 0.0)},
        {"electrical_w", "Electrical power", "W", withScale(*meanOf(blocks.electrical), volts)},
        {"copper_w", "Copper losses", "W", copper},
        {"shaft_w", "Shaft power", "W", withScale(*meanOf(blocks.shaft), torque)},
        {"efficiency", "Efficiency", "W/W", efficiency}};
}

} // namespace

Result<Power, std::string> evaluatePower(const capture::Capture &capture, const Happenings &all)
{
    const auto [of, after] = planIn<PowerPlan>(all);
    if (!of)
        return fail(std::string("it is no recording of a motor's power"));
    const auto span = drivenSpan(
        of->motor, after.begin(), after.end(), std::numeric_limits<Nanos>::max(), setsSpeedAtOnce);
    if (!span)
        return fail(std::string("the set-point was never moved in it"));
    const std::vector<Segment> segments = segmentsOf(capture, of->angle,
        {of->current, of->currentD, of->voltage, of->voltageD}, span->from, span->to);
    PowerBlocks blocks;
    for (const Segment &segment : segments) {
        constexpr double kBlock_s = 0.25;
        const auto length = static_cast<std::size_t>(std::lround(kBlock_s / segment.step_s));
        for (std::size_t end = length; length > 0 && end < segment.turned_deg.size(); end += length)
            blocks.add(segment, *of, end - length, end);
    }
    constexpr std::size_t kLeastBlocks = 4;
    if (blocks.speed.size() < kLeastBlocks)
        return fail(std::string("too little of it is without a gap: a second is needed"));
    Power found{figuresFrom(blocks, *of), {}};
    if (!(of->plan.rsOhm > 0.0 && of->plan.deadVolts > 0.0))
        found.notes.emplace_back("resistance or dead time is not known: what it takes is not told");
    noteGaps(found.notes, missingIn(segments));
    noteEnd(found.notes, span->over, span->reason);
    return found;
}

} // namespace lab
