// Plans of every kind, drawn by a seed, for campaigns that look at what else happens.
#pragma once

#include "lab/experiment.h"
#include "support/link_pair.h"

namespace support {

/// Short ones. Now and then of a user who allows less current than the motor would take.
inline lab::Plan drawnPlan(Random &random, const lab::Subject &subject)
{
    lab::Plan drawn;
    switch (random.below(5)) {
    case 0: {
        // Without a sensor: with room above what its observer needs.
        const auto least = static_cast<int>(std::max(1000.0, subject.leastObservedRpm() + 300.0));
        const int from = least + static_cast<int>(random.below(500));
        const lab::StepPlan steps{.fromRpm = from,
            .toRpm = from + static_cast<int>(200 + random.below(600)),
            .repeat = static_cast<int>(1 + random.below(3))};
        drawn = steps;
        if (steps.repeat == 3) {
            lab::PowerPlan power = lab::powerPlanFor(subject, {});
            power.fromRpm = power.toRpm = from;
            power.hold = 800ms;
            drawn = power;
        } else if (steps.repeat == 2 && steps.toRpm % 2 == 0) {
            lab::LoadPlan load = lab::loadPlanFor(subject, {});
            load.fromRpm = load.toRpm = from;
            load.hold = 1s;
            drawn = load;
        }
        break;
    }
    case 1: {
        lab::SpinPlan plan = lab::spinPlanFor(subject, {});
        plan.length = 3s;
        drawn = plan;
        break;
    }
    case 2: {
        const bool flux = random.chance(0.5);
        const double share = 0.05 + 0.002 * double(random.below(100));
        lab::CurrentStepPlan plan = lab::currentStepPlanFor(
            subject, flux, 0.0, share * subject.limits.nominalCurrentAmps, {});
        plan.repeat = static_cast<int>(1 + random.below(3));
        drawn = plan;
        break;
    }
    case 3:
        drawn = lab::restPlanFor(subject, {});
        if (subject.registers.position != 0 && random.chance(0.5)) {
            const double by_deg = random.chance(0.5) ? 30.0 : -30.0;
            drawn = lab::PositionPlan{.byDegrees = by_deg * double(1 + random.below(4)),
                .ramp = std::chrono::milliseconds(150 + random.below(300)),
                .repeat = static_cast<int>(1 + random.below(3))};
        }
        break;
    default: {
        lab::ResponsePlan plan = random.chance(0.5) ? lab::currentResponsePlanFor(subject, {})
                                                    : lab::responsePlanFor(subject, {});
        plan.length = 4s;
        if (random.chance(0.3)) { // with gains that are lent
            plan.kp = static_cast<int>(100 + random.below(4000));
            plan.ki = static_cast<int>(random.below(400));
        }
        drawn = plan;
    }
    }
    if (random.chance(0.3)) {
        const double most_a =
            subject.limits.nominalCurrentAmps * 0.02 * double(5 + random.below(40));
        std::visit([&](auto &plan) { plan.caps.maxCurrentAmps = most_a; }, drawn);
    }
    return drawn;
}

} // namespace support
