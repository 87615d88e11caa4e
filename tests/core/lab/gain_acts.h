// What the user does to the gains of a speed loop, on a bench of virtual time: reads them, writes them, asks how the
// loop responds.
#pragma once

#include "lab/evaluation/speed_loop.h"
#include "support/lab_bench.h"

namespace support {

struct Gains {
    int proportional = 0, integral = 0; ///< digits
};

inline Gains gainsOf(LabBench &bench)
{
    const lab::Registers &registers = bench.experiment.subject.registers;
    return {int(bench.number(registers.gain)), int(bench.number(registers.integral))};
}

inline bool write(LabBench &bench, const Gains &gains)
{
    const lab::Registers &registers = bench.experiment.subject.registers;
    return bench.pair.runUntilEnded(
        bench.pair.submit(drive::Write{{{registers.gain, std::int64_t{gains.proportional}},
                                           {registers.integral, std::int64_t{gains.integral}}},
            drive::Reach::Parameters}));
}

inline lab::GainDigits digitsOf(LabBench &bench)
{
    const lab::Subject &subject = bench.experiment.subject;
    const lab::Registers &registers = subject.registers;
    return {lab::jumpPerRpm(subject, 1.0, bench.number(registers.gainExponent)),
        lab::jumpPerRpm(subject, 1.0, bench.number(registers.integralExponent))};
}

inline Result<lab::SpeedResponse, std::string> respond(LabBench &bench)
{
    bench.experiment.plan = lab::responsePlanFor(bench.experiment.subject, {});
    const lab::Outcome outcome = bench.run();
    if (outcome.end != lab::End::Complete)
        return fail(outcome.reason);
    return lab::evaluateResponse(bench.capture, bench.happenings);
}

/// As autotune: a loop that swings by itself is calmed for it.
inline Result<lab::SpeedResponse, std::string> respondCalmly(LabBench &bench)
{
    const Gains gains = gainsOf(bench);
    lab::SpeedLoop loop;
    loop.proportional = gains.proportional;
    loop.integral = gains.integral;
    auto plan = std::optional(lab::responsePlanFor(bench.experiment.subject, {}));
    std::string why;
    while (plan) {
        bench.happenings.clear(); // a recording of its own
        bench.experiment.plan = *plan;
        const lab::Outcome outcome = bench.run();
        if (outcome.end == lab::End::Complete)
            return lab::evaluateResponse(bench.capture, bench.happenings);
        why = outcome.reason;
        plan = outcome.swings ? lab::calmer(*plan, loop) : std::nullopt;
    }
    return fail(why);
}

} // namespace support
