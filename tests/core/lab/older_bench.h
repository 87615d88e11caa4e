// Experiments on boards of the older protocol, which record nothing by themselves.
#pragma once

#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

namespace support {

/// @param motor  a preset, with an own load
inline simulation::BoardOptions olderServo(
    std::uint32_t baud = 115200, const char *motor = "servo24")
{
    simulation::BoardOptions options;
    options.profile = "legacy";
    options.baud = baud;
    options.plant = *simulation::findPreset(motor);
    options.plant->inverter.supplyAbsorbs = true; // a step down lifts nothing
    return options;
}

/// With what its user says of it: how fast the motor may turn and, where wanted, what its currents are worth.
struct OlderBench : LabBench {
    explicit OlderBench(
        const simulation::BoardOptions &options = olderServo(), double fullScale_a = 0.0)
        : LabBench(options)
    {
        if (fullScale_a > 0.0) {
            pair.submit(drive::CurrentScale{1, fullScale_a});
            pair.drive->arm();
            pair.exchange();
            if (const auto scaled = lab::pollableSubjectOf(*pair.identified, 1))
                experiment.subject = *scaled;
        }
        pair.submit(drive::UserLimits{3000.0, 0.0});
        pair.submit(drive::ExpertMode{1});
        steps = {.fromRpm = 1000, .toRpm = 2000, .repeat = 1, .caps = {3000.0, 0.0}};
    }
    /// Makes its speed loop take four times as long.
    bool slower()
    {
        const auto divide = [this](const char *name, std::int64_t by) {
            const drive::RegisterId id = pair.id(name);
            const auto value = static_cast<std::int64_t>(number(id)) / by;
            const drive::WishId write = pair.submit(drive::Write{{{id, value}}});
            return value > 0 && pair.runUntilEnded(write)
                && pair.outcome(write) == drive::Outcome::Ok;
        };
        return divide("SPEED_KP", 4) && divide("SPEED_KI", 16);
    }
};

} // namespace support
