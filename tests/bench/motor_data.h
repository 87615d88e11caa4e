// Samples like a motor's: currents, speed, angle and voltage with noise, the same in every run.
#pragma once

#include "capture/capture.h"

#include <cstdint>
#include <vector>

namespace bench {

constexpr int kSignals = 8;
constexpr double kTickHz = 20000.0;

/// Sample `i` of signal `s`.
std::int16_t motorSample(int s, std::int64_t i);

/// `count` samples of signal `s`.
std::vector<std::int16_t> motorSignal(int s, std::size_t count);

/// Eight fast signals A0..A7, and no samples yet.
capture::StreamLayout motorLayout();

/// Appends `count` samples of each signal in packets of `batch`.
void recordMotor(capture::Capture &capture, std::size_t count, std::size_t batch = 1000);

/// Hours of the same, fast: repeats the first fifty seconds.
class MotorStream {
public:
    static constexpr std::size_t kPeriod = 1'000'000; ///< samples

    /// Begins the stream and appends `count` samples of each signal.
    void record(capture::Capture &capture, std::size_t count);
    /// Appends so many more, as one packet.
    void append(capture::Capture &capture, std::size_t count);
    capture::Tick ticks() const { return m_ticks; } ///< so far

    capture::StreamLayout layout =
        motorLayout(); ///< its first fast signals may be all; set before record()

private:
    std::vector<std::vector<std::int16_t>> m_signals;
    capture::Tick m_ticks = 0;
};

} // namespace bench
