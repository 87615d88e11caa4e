// How right the lab is: experiments on virtual time with motors whose truth is known, as a table. The presets, and the
// motors of tests/data/invented, which nothing was tuned with; with several seeds, without a load and with two brakes.
// Behind the intervals that held stand half of their mean width in percent, and that width beside the spread of the
// seeds. What did not come to a result is told with its reason. `rotorscope-lab-accuracy 20 pm24` takes twenty seeds of
// one motor.
#include "campaign/lab_gains.h"
#include "lab/evaluation/electrical_evaluation.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "lab/evaluation/power_evaluation.h"
#include "lab/evaluation/response_evaluation.h"
#include "session/files/motor_file.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"
#include "support/places.h"

#include <QDir>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numbers>
#include <span>
#include <string_view>

namespace {

using namespace lab;

constexpr double kPercent = 100.0;
constexpr double kColdest_c = 20.0, kCopper = 0.00393; ///< per degree

struct Motor {
    std::string name;
    simulation::PlantParameters plant;
};

/// One number over all runs of a row.
struct Column {
    const char *name = "";
    double bar = 0.0; ///< percent
    int found = 0, held = 0;
    double worst = 0.0; ///< percent, signed
    double sum = 0.0, squares = 0.0, widths = 0.0; ///< of the numbers and of their intervals

    void accept(const std::optional<Estimate> &estimate, double truth)
    {
        if (!estimate || !(truth > 0.0))
            return;
        ++found;
        held += *estimate->low <= truth && truth <= *estimate->high ? 1 : 0;
        const double off = (estimate->value / truth - 1.0) * kPercent;
        worst = std::abs(off) > std::abs(worst) ? off : worst;
        sum += off;
        squares += off * off;
        widths += (*estimate->high - *estimate->low) / truth * kPercent;
    }
    /// The mean interval beside that which holds 95 % of the numbers, if these are normal; of one number nothing.
    double tooWide() const
    {
        if (found < 2)
            return 0.0;
        constexpr double kOf95 = 2.0 * 1.96;
        const double mean = sum / found;
        const double deviation = std::sqrt((squares - sum * mean) / (found - 1));
        return widths / found / (kOf95 * deviation);
    }
    void print() const
    {
        if (found == 0)
            std::printf(" - |");
        else
            std::printf(" %s%+.2f%s (%d/%d; %.1f, %.1f) |", std::abs(worst) > bar ? "**" : "",
                worst, std::abs(worst) > bar ? "**" : "", held, found, widths / found / 2.0,
                tooWide());
    }
};

std::vector<Motor> motors()
{
    std::vector<Motor> all;
    for (const simulation::Preset &preset : simulation::presets())
        all.push_back({std::string(preset.name), preset.parameters});
    const QDir folder(support::dataFile(QStringLiteral("invented")));
    for (const QString &name : folder.entryList({QStringLiteral("*.json")}, QDir::Files)) {
        const auto file = session::readMotorFile(folder.filePath(name));
        if (!file)
            qFatal("%s cannot be read", qPrintable(name));
        all.push_back({name.chopped(5).toStdString(), file->machine});
    }
    return all;
}

/// Of the nominal torque.
simulation::PlantParameters braked(simulation::PlantParameters plant, double share)
{
    constexpr double kAmpTorque = 1.5;
    plant.load.constant_nm +=
        share * kAmpTorque * plant.motor.polePairs * plant.motor.flux_wb * plant.motor.nominal_a;
    return plant;
}

/// The plans one after another. @return  why it is no result, empty if it is one
std::string carryOut(support::LabBench &bench, const std::vector<Plan> &plans)
{
    bench.pair.verdictTaken = true; // what may leave is for the tests
    if (bench.experiment.subject.catalog == nullptr)
        return "the board was not identified";
    for (const Plan &plan : plans) {
        bench.experiment.plan = plan;
        const Outcome outcome = bench.run();
        if (outcome.end != End::Complete)
            return outcome.reason;
    }
    return {};
}

simulation::BoardOptions boardOf(const simulation::PlantParameters &plant, std::uint64_t seed)
{
    simulation::BoardOptions options;
    options.plant = plant;
    options.seed = seed;
    return options;
}

void end(std::span<const Column> columns, const std::vector<std::string> &reasons)
{
    for (const Column &column : columns)
        column.print();
    std::printf(" %s |\n", reasons.empty() ? "" : reasons.front().c_str());
    std::fflush(stdout);
}

void mechanics(const Motor &motor, double brake, std::uint64_t seeds)
{
    std::array columns{
        Column{"J", 1.5}, Column{"viscous", 6.0}, Column{"dry", 5.0}, Column{"fan", 5.0}};
    const simulation::PlantParameters plant = braked(motor.plant, brake);
    std::vector<std::string> reasons;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        support::LabBench bench(boardOf(plant, seed), seed);
        SpinPlan plan = spinPlanFor(bench.experiment.subject, {});
        plan.seed = static_cast<std::uint32_t>(seed);
        std::string why = carryOut(bench, {plan});
        const auto found = why.empty() ? evaluateMechanics(bench.capture, bench.happenings)
                                       : Result<Mechanics, std::string>(fail(why));
        if (!found) {
            reasons.push_back(found.error());
            continue;
        }
        columns[0].accept(found->inertia_kgm2, plant.motor.inertia_kgm2);
        columns[1].accept(found->viscous_nms, plant.motor.viscous_nms);
        columns[2].accept(found->dry_nm, plant.motor.coulomb_nm + plant.load.constant_nm);
        columns[3].accept(found->fan_nms2, plant.load.fan_nms2);
    }
    std::printf("| %s | %.0f %% | %zu of %llu |", motor.name.c_str(), brake * kPercent,
        static_cast<std::size_t>(seeds) - reasons.size(), static_cast<unsigned long long>(seeds));
    end(columns, reasons);
}

/// A frequency of the response in all runs of a row.
struct Bin {
    int found = 0;
    double gain = 0.0, phase_deg = 0.0; ///< sums of the errors; the gain's in percent
};

/// Of the shaft's speed by Iq where the response tells it: with an encoder from 3 to 40 Hz, observed up to 25 Hz.
void responses(const Motor &motor, std::uint64_t seeds)
{
    constexpr double kFrom_hz = 3.0, kTo_hz = 40.0, kClear = 0.8,
                     kDegrees = 180.0 / std::numbers::pi;
    std::map<double, Bin> bins;
    int points = 0, held = 0;
    double squares = 0.0;
    std::vector<std::string> reasons;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        support::LabBench bench(boardOf(motor.plant, seed), seed);
        ResponsePlan plan = responsePlanFor(bench.experiment.subject, {});
        plan.seed = static_cast<std::uint32_t>(seed);
        std::string why = carryOut(bench, {plan});
        const auto found = why.empty() ? evaluateResponse(bench.capture, bench.happenings)
                                       : Result<SpeedResponse, std::string>(fail(why));
        if (!found) {
            reasons.push_back(found.error());
            continue;
        }
        const auto &one = motor.plant.motor;
        const double rad = plan.rpm * 2.0 * std::numbers::pi / 60.0;
        for (const ResponsePoint &point : found->points) {
            if (!point.plantKnown || point.hz < kFrom_hz || point.hz > kTo_hz
                || point.coherence < kClear)
                continue;
            const std::complex<double> truth = 1.5 * one.polePairs * one.flux_wb
                / std::complex(one.viscous_nms + 2.0 * motor.plant.load.fan_nms2 * rad,
                    one.inertia_kgm2 * 2.0 * std::numbers::pi * point.hz);
            const double off = std::abs(point.plant / truth) - 1.0;
            ++points;
            held += std::abs(off) <= 1.96 * point.relative ? 1 : 0;
            squares += off * off;
            Bin &bin = bins[std::round(point.hz * 100.0) / 100.0];
            ++bin.found;
            bin.gain += off * kPercent;
            bin.phase_deg += std::arg(point.plant / truth) * kDegrees;
        }
    }
    const std::size_t results = static_cast<std::size_t>(seeds) - reasons.size();
    double gain = 0.0, phase_deg = 0.0, to_hz = 0.0;
    for (const auto &[hz, bin] : bins) {
        if (2 * bin.found < static_cast<int>(results))
            continue; // seldom clear
        const double off = bin.gain / bin.found, turned = bin.phase_deg / bin.found;
        gain = std::abs(off) > std::abs(gain) ? off : gain;
        phase_deg = std::abs(turned) > std::abs(phase_deg) ? turned : phase_deg;
        to_hz = hz;
    }
    constexpr double kLeastHeld = 90.0, kMostHeld = 99.0;
    const double share = std::round(kPercent * held / std::max(1, points));
    const char *const bold = share < kLeastHeld || share > kMostHeld ? "**" : "";
    std::printf("| %s | %zu of %llu | %.0f Hz | %+.2f | %+.2f | %.2f | %s%.0f %%%s | %s |\n",
        motor.name.c_str(), results, static_cast<unsigned long long>(seeds), to_hz, gain, phase_deg,
        kPercent * std::sqrt(squares / std::max(1, points)), bold, share, bold,
        reasons.empty() ? "" : reasons.front().c_str());
    std::fflush(stdout);
}

void electrics(const Motor &motor, std::uint64_t seeds)
{
    std::array columns{
        Column{"Rs", 2.0}, Column{"Ld", 2.0}, Column{"Lq", 2.0}, Column{"flux", 1.5}};
    const simulation::PlantParameters &plant = motor.plant;
    std::vector<std::string> reasons;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        support::LabBench bench(boardOf(plant, seed), seed);
        SpinPlan turning = fluxPlanFor(bench.experiment.subject, {});
        turning.seed = static_cast<std::uint32_t>(seed);
        std::string why = carryOut(bench, {restPlanFor(bench.experiment.subject, {}), turning});
        const auto found = why.empty() ? evaluateElectrics(bench.capture, bench.happenings)
                                       : Result<Electrics, std::string>(fail(why));
        if (!found) {
            reasons.push_back(found.error());
            continue;
        }
        const double warm = 1.0 + kCopper * (plant.inverter.ambient_c - kColdest_c);
        columns[0].accept(
            found->rs_ohm, plant.motor.rs_ohm * warm + plant.inverter.switchResistance_ohm);
        columns[1].accept(found->ld_h, plant.motor.ld_h);
        columns[2].accept(found->lq_h, plant.motor.lq_h);
        columns[3].accept(found->flux_wb, plant.motor.flux_wb);
    }
    std::printf("| %s | %zu of %llu |", motor.name.c_str(),
        static_cast<std::size_t>(seeds) - reasons.size(), static_cast<unsigned long long>(seeds));
    end(columns, reasons);
}

/// Of the shaft at a speed that is held: the air gap gives what friction, fan and brake take there, at the speed that
/// the angle tells.
void powers(const Motor &motor, double brake, std::uint64_t seeds)
{
    std::array columns{Column{"shaft", 3.0}};
    const simulation::PlantParameters plant = braked(motor.plant, brake);
    std::vector<std::string> reasons;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        support::LabBench bench(boardOf(plant, seed), seed);
        std::string why = carryOut(bench, {powerPlanFor(bench.experiment.subject, {})});
        const auto found = why.empty() ? evaluatePower(bench.capture, bench.happenings)
                                       : Result<Power, std::string>(fail(why));
        if (!found) {
            reasons.push_back(found.error());
            continue;
        }
        const auto figure = [&found](std::string_view key) {
            const Figures &all = found->figures;
            const auto at = std::ranges::find(all, key, &Figure::key);
            return at == all.end() ? std::nullopt : at->value;
        };
        const auto rpm = figure("speed_rpm");
        const double w = rpm ? rpm->value * std::numbers::pi / 30.0 : 0.0;
        const double torque = plant.motor.coulomb_nm + plant.load.constant_nm
            + (plant.motor.viscous_nms + plant.load.fan_nms2 * w) * w;
        columns[0].accept(figure("shaft_w"), torque * w);
    }
    std::printf("| %s | %.0f %% | %zu of %llu |", motor.name.c_str(), brake * kPercent,
        static_cast<std::size_t>(seeds) - reasons.size(), static_cast<unsigned long long>(seeds));
    end(columns, reasons);
}

} // namespace

int main(int count, char **words)
{
    const std::uint64_t seeds = count > 1 ? std::strtoull(words[1], nullptr, 10) : 2;
    std::vector<Motor> all = motors();
    if (const std::span wanted(words + std::min(count, 2), words + count); !wanted.empty())
        std::erase_if(all, [wanted](const Motor &motor) {
            return std::find(wanted.begin(), wanted.end(), motor.name) == wanted.end();
        });
    std::printf(
        "Worst error in percent, how many of the 95 %% intervals held the truth; bold: beyond "
        "its bar.\n\n");
    std::printf(
        "| motor | brake, of the nominal torque | results | inertia | viscous | dry | fan | "
        "else |\n|---|---|---|---|---|---|---|---|\n");
    for (const Motor &motor : all)
        for (const double brake : {0.0, 0.1, 0.25})
            mechanics(motor, brake, seeds);
    std::printf(
        "\n| motor | results | Rs | Ld | Lq | flux | else |\n|---|---|---|---|---|---|---|\n");
    for (const Motor &motor : all)
        electrics(motor, seeds);
    std::printf(
        "\n| motor | results | clear up to | gain, percent | phase, degrees | rms, percent | "
        "held | else |\n|---|---|---|---|---|---|---|---|\n");
    for (const Motor &motor : all)
        responses(motor, seeds);
    std::printf("\n| motor | brake, of the nominal torque | results | shaft power | else "
                "|\n|---|---|---|---|---|\n");
    for (const Motor &motor : all)
        for (const double brake : {0.0, 0.1})
            powers(motor, brake, seeds);
    std::printf(
        "\nMedium gains: Ms that was measured, overshoot in %% as predicted and as measured.\n\n"
        "| motor | load | gains as they were | four times | a quarter | else "
        "|\n|---|---|---|---|---|---|\n");
    int kept = 0, cases = 0;
    for (const Motor &motor : all)
        if (simulation::findPreset(motor.name) != nullptr) {
            kept += campaign::gainsOf(motor.name, motor.plant, seeds);
            cases += 12 * int(seeds);
        }
    std::printf("\n%d of %d as promised.\n", kept, cases);
    return 0;
}
