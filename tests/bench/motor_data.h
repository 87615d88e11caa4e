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

} // namespace bench
