// The spectrum of a channel: windows with their right scales, averaging, peaks between the bins, orders.
//
// Scales. A bin holds a mean square in the channel's unit squared, so that the sum over all bins is the mean square of
// the windowed samples exactly (Parseval). A sine of amplitude A at a bin reads amplitude() = A there, whatever the
// window. The root of a band's sum counts noise and tones right: a window spreads a tone over several bins.
// Transform: kissfft (double), which keeps no global state, so that any thread may use it.
#pragma once

#include "base/result.h"
#include "scope/sample_range.h"

#include <vector>

namespace scope {

enum class Window : std::uint8_t {
    Rectangular, ///< for whole periods only; 1 bin wide
    Hann, ///< for looking around; amplitudes up to 15 % low between bins
    BlackmanHarris, ///< 92 dB between the tone and its side lobes
    FlatTop ///< for reading amplitudes: 0.1 % between bins
};

/// One period of the window, n values; symmetric about n / 2 (the periodic form).
std::vector<double> windowValues(Window window, std::size_t n);

/// What a tone that lies `offset` bins away reads, as a share of its amplitude. Exact for many samples.
double windowResponse(Window window, double offset);

/// How many bins of noise one bin counts as: 1, 1.5, 2.0, 3.77.
double noiseBandwidth(Window window);

struct SpectrumSettings {
    Window window = Window::Hann;
    /// Samples a transform; 0 is all of them, as one. Rounded down to an even number without large factors.
    std::size_t size = 0;
    bool subtractMean = true; ///< so that the window does not spread it over the lowest bins
};

/// Samples a transform at most.
constexpr std::size_t kMostTransformed = std::size_t(1) << 22;

struct Spectrum {
    Window window = Window::Hann;
    std::size_t size = 0; ///< samples a transform
    double binHz = 0.0;
    double mean = 0.0; ///< of the samples, also if it was subtracted
    std::uint32_t averaged = 0; ///< transforms in it
    Nanos from = 0; ///< the samples that were used
    Nanos to = 0;
    std::vector<double> meanSquares; ///< of bins 0 to size / 2

    double frequency(double bin) const { return bin * binHz; }
    /// Of a sine there: its peak value, not its rms.
    double amplitude(std::size_t bin) const;
};

enum class NoSpectrum : std::uint8_t {
    TooFewSamples, ///< fewer than 16 in one piece
    NotUniform ///< the samples are not at equal distances, as polled ones
};

/// The spectrum of the longest unbroken piece of the range; its halves overlap unless the window is rectangular.
Result<Spectrum, NoSpectrum> spectrumOf(const SampleRange &range, const SpectrumSettings &settings);

/// The mean of spectra of the same shape; another shape starts it anew.
class SpectrumAverage {
public:
    /// @param most  once so many were added, each new one counts as 1 / most and older ones fade
    explicit SpectrumAverage(std::uint32_t most = 16);
    void add(const Spectrum &spectrum);
    void clear() { m_count = 0; }
    std::uint32_t count() const { return m_count; }
    const Spectrum &mean() const { return m_mean; } ///< meaningful if count() > 0

private:
    std::uint32_t m_most;
    std::uint32_t m_count = 0;
    Spectrum m_mean;
};

/// A tone. Frequency and amplitude are found between the bins from the shape of the window.
struct SpectrumPeak {
    double hertz = 0.0;
    double amplitude = 0.0; ///< peak value of the sine, channel's unit
    std::size_t bin = 0; ///< where the spectrum is highest
};

/// The largest peaks, largest first; what may be a side lobe or the skirt of a larger one is not listed.
/// Error for one tone at least 10 bins from 0 and the end, without noise: frequency 0.02 bins with Rectangular, 0.01
/// with Hann, 0.001 with the others; amplitude 2 %, 0.3 %, 0.1 %, 0.1 %.
/// @param floor    only peaks of at least this amplitude
/// @param refined  takes how many maxima were looked at between the bins, which is what costs: a small share of all
/// Cost: O(bins) for the maxima, then that.
std::vector<SpectrumPeak> findPeaks(
    const Spectrum &spectrum, std::size_t most, double floor = 0.0, std::size_t *refined = nullptr);

/// Frequencies as multiples of the electrical one.
struct OrderAxis {
    double electricalHz = 0.0;
    static OrderAxis ofSpeed(double rpm, int polePairs)
    {
        return {std::abs(rpm) * polePairs / 60.0};
    }
    bool valid() const { return electricalHz > 0.0; }
    double order(double hertz) const { return hertz / electricalHz; }
    double hertz(double order) const { return order * electricalHz; }
};

} // namespace scope
