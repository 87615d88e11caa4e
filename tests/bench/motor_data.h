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
    /// So many more, as one packet.
    capture::SampleBlock next(std::size_t count);
    void append(capture::Capture &capture, std::size_t count) { capture.append(next(count)); }
    capture::Tick ticks() const { return m_ticks; } ///< so far

    /// Its first fast signals may be all; set before record().
    capture::StreamLayout layout = motorLayout();

private:
    std::vector<std::vector<std::int16_t>> m_signals;
    capture::Tick m_ticks = 0;
};

/// Amplitudes that change from column to column of a picture of everything, as under a changing load: a random walk,
/// two steps a column of 1,920. Not to be changed: figures from before would mean something else.
class Ragged {
public:
    enum class Wave {
        Motor, ///< of motorSample()
        Peaks ///< both ends of the envelope in any two samples: the same picture for any number of them
    };
    Ragged(std::size_t count, Wave wave, int signalCount = kSignals);

    std::int16_t at(int signal, std::size_t index) const;
    std::size_t count() const { return m_count; }
    int signalCount() const { return static_cast<int>(m_envelopes.size()); }
    /// All of it, at kTickHz.
    /// @param gapEvery  samples between two gaps; 0: none
    void record(capture::Capture &capture, std::size_t gapEvery = 0) const;
    /// The same as values with an instant each.
    void import(capture::Capture &capture) const;

private:
    std::size_t m_count;
    std::vector<std::vector<std::int16_t>> m_waves; ///< of 8 signals, which repeat
    std::vector<std::vector<std::int32_t>> m_envelopes; ///< of 256
};

} // namespace bench
