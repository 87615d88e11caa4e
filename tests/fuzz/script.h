// Reads a fuzzer's bytes as a script for a machine without I/O: pieces of a stream, and time that passes between them.
#pragma once

#include "base/bytes.h"
#include "base/time.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>

namespace fuzz {

/// Ends the run as a finding; unlike assert also in a release build.
inline void require(bool holds, int line = __builtin_LINE())
{
    if (holds)
        return;
    std::cerr << "not as line " << line << " requires\n";
    std::abort();
}

/// Plays `script` on a machine with receive(), handleTimeout() and nextTimeout(). A byte up to 191 is the length of a
/// piece of the stream that follows it, one from 192 on lets as many units of time less 191 pass. `drain` is called
/// after each step, to take the output and to look at the machine.
/// Time never stands still: a machine that asks to be called over and over at one instant is a finding.
template <class Machine, class Drain>
void play(
    ByteView script, Machine &machine, Drain drain, Duration unit = std::chrono::milliseconds(125))
{
    constexpr int kStepsAtOneInstant = 1000;
    TimePoint now{};
    std::size_t at = 0;
    const auto passUntil = [&](TimePoint end) {
        int steps = 0;
        for (auto wake = machine.nextTimeout(); wake && *wake <= end;
             wake = machine.nextTimeout()) {
            steps = *wake <= now ? steps + 1 : 0;
            require(steps < kStepsAtOneInstant);
            now = std::max(now, *wake);
            machine.handleTimeout(now);
            drain(now);
        }
        now = end;
    };
    while (at < script.size()) {
        const std::uint8_t step = script[at++];
        if (step >= 192) {
            passUntil(now + unit * (step - 191));
            continue;
        }
        const std::size_t length = std::min<std::size_t>(step, script.size() - at);
        machine.receive(script.subspan(at, length), now);
        drain(now);
        at += length;
    }
    passUntil(now + unit * 40);
}

} // namespace fuzz
