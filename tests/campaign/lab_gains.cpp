#include "campaign/lab_gains.h"

#include "core/lab/gain_acts.h"

#include <array>
#include <cstdio>

namespace campaign {

namespace {

using namespace lab;
using simulation::PlantParameters;

constexpr double kMoreMs = 1.1; ///< of the goal's, that a proof may show
constexpr double kOvershoot = 5.0; ///< points beside what was predicted

/// What became of a loop.
struct Case {
    std::string why; ///< it came to no result
    double ms = 0.0, predicted_pct = 0.0, measured_pct = 0.0;
    bool kept() const
    {
        return why.empty() && ms <= kMoreMs * distanceOf(Goal::Medium).ms
            && std::abs(measured_pct - predicted_pct) <= kOvershoot;
    }
};

simulation::BoardOptions boardOf(const PlantParameters &plant, std::uint64_t seed)
{
    simulation::BoardOptions options;
    options.plant = plant;
    options.seed = seed;
    return options;
}

struct Proof {
    Case result;
    std::optional<SpeedResponse> response; ///< with those gains
};

/// What the medium gains of a measured response come to: the response and the steps that `autotune` proves them by.
Proof prove(const PlantParameters &plant, const SpeedResponse &measured, GainDigits digits,
    std::uint64_t seed)
{
    support::LabBench after(boardOf(plant, seed), seed), steps(boardOf(plant, seed + 1), seed + 1);
    const auto proposed =
        proposeGains(measured, digits, after.experiment.subject.limits.nominalCurrentAmps);
    if (!proposed)
        return {{proposed.error()}, {}};
    const auto medium = std::find_if(proposed->begin(), proposed->end(),
        [](const GainCandidate &one) { return one.goal == Goal::Medium; });
    if (medium == proposed->end())
        return {{"no medium gains"}, {}};
    for (support::LabBench *bench : {&after, &steps}) {
        bench->pair.verdictTaken = true;
        if (!support::write(*bench, {medium->proportional, medium->integral}))
            return {{"the gains were not written"}, {}};
    }
    const auto proof = support::respond(after);
    if (!proof || !proof->ms)
        return {{proof ? "no Ms" : proof.error()}, {}};
    steps.steps = proofStepsFor(steps.experiment.subject, {});
    steps.experiment.plan = steps.steps;
    const Outcome outcome = steps.run();
    const auto series = steps.series();
    if (outcome.end != End::Complete || !series || !series->overshoot_pct)
        return {{outcome.end != End::Complete ? outcome.reason
                        : series              ? "no step"
                                              : series.error()},
            *proof};
    return {{{}, proof->ms->value, medium->overshoot_pct, series->overshoot_pct->value}, *proof};
}

/// Measures the response and takes the medium gains; where they do not keep their promise, those of the response with
/// them.
Case tune(const PlantParameters &plant, double factor, std::uint64_t seed)
{
    support::LabBench before(boardOf(plant, seed), seed);
    before.pair.verdictTaken = true; // what may leave is for the tests
    const support::Gains told = support::gainsOf(before);
    const auto scaled = [&](int gain) { return std::max(1, int(std::lround(gain * factor))); };
    if (!support::write(before, {scaled(told.proportional), scaled(told.integral)}))
        return {"the gains were not written"};
    const GainDigits digits = support::digitsOf(before);
    const auto measured = support::respondCalmly(before);
    if (!measured)
        return {measured.error()};
    Proof proof = prove(plant, *measured, digits, seed + 1);
    if (!proof.result.kept() && proof.response)
        proof = prove(plant, *proof.response, digits, seed + 3);
    return proof.result;
}

} // namespace

int gainsOf(const std::string &motor, const PlantParameters &plant, std::uint64_t seeds)
{
    PlantParameters heavy = plant, fan = plant, dry = plant;
    heavy.motor.inertia_kgm2 *= 4.0;
    // A diode and 1 mF take nothing back: there any change of this rotor's speed ends with too much voltage.
    heavy.inverter.supplyAbsorbs = true;
    dry.motor.coulomb_nm *= 3.0;
    {
        // A quarter of the nominal torque where it is measured.
        const support::LabBench bench(boardOf(plant, 1), 1);
        constexpr double kAmpTorque = 1.5, kShare = 0.25, kRadPerRpm = 0.10472;
        const double speed = responsePlanFor(bench.experiment.subject, {}).rpm * kRadPerRpm;
        fan.load.fan_nms2 += kShare * kAmpTorque * plant.motor.polePairs * plant.motor.flux_wb
            * plant.motor.nominal_a / (speed * speed);
    }
    struct Load {
        const char *name;
        const PlantParameters &plant;
    };
    int kept = 0;
    for (const Load &load : std::array{Load{"none", plant},
             Load{"four times the inertia, a supply that takes back", heavy}, Load{"a fan", fan},
             Load{"three times the dry friction", dry}}) {
        std::printf("| %s | %s |", motor.c_str(), load.name);
        std::string why;
        for (const double factor : {1.0, 4.0, 0.25}) {
            int held = 0;
            Case worst;
            for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
                const Case one = tune(load.plant, factor, 10 * seed);
                held += one.kept() ? 1 : 0;
                if (seed == 1 || !one.kept())
                    worst = one;
            }
            kept += held;
            const bool all = held == int(seeds);
            if (!worst.why.empty()) {
                why = worst.why;
                std::printf(" **-** (%d/%d) |", held, int(seeds));
            } else {
                std::printf(" %s%.2f, %.0f to %.0f%s (%d/%d) |", all ? "" : "**", worst.ms,
                    worst.predicted_pct, worst.measured_pct, all ? "" : "**", held, int(seeds));
            }
        }
        std::printf(" %s |\n", why.c_str());
        std::fflush(stdout);
    }
    return kept;
}

} // namespace campaign
