// Spectra of several signals with one of them, averaged over segments (Welch, Hann, half overlapped): the material of a
// frequency response by an instrument. Pure. Source: Bendat and Piersol, Random Data, ch. 5 and 9.
#pragma once

#include <complex>
#include <kissfft/kissfft.hh>
#include <span>
#include <vector>

namespace lab {

using Complex = std::complex<double>;

struct CrossSpectra {
    double binHz = 0.0;
    int averages = 0; ///< that are independent: half of those that overlap
    std::vector<double> instrument; ///< of the first signal with itself, one a bin
    std::vector<std::vector<Complex>> cross; ///< of each other signal with it
    std::vector<std::vector<double>> own; ///< of each other signal with itself

    /// The sum of so many bins from one on, as a single bin of as many averages more.
    CrossSpectra band(std::size_t first, std::size_t bins) const;
    /// How much of a signal follows the instrument at a bin: 0 to 1.
    double coherence(std::size_t signal, std::size_t bin) const;
};

/// Adds up over stretches of signals; each stretch holds the instrument first, then the others, as long.
class CrossSpectrum {
public:
    /// @param size  of a transform, even. @param others  signals beside the instrument
    CrossSpectrum(std::size_t size, double sampleHz, std::size_t others);
    /// Cost: one transform for two signals, twice over, for stretches overlap by half.
    void add(std::span<const std::vector<double>> stretch);
    CrossSpectra result() const;
    int count() const { return m_count; } ///< of transforms

private:
    double meanOf(const double *samples) const;
    void transform(std::span<const std::vector<double>> stretch, std::size_t at);

    std::size_t m_size;
    double m_sampleHz;
    int m_count = 0;
    CrossSpectra m_sum;
    std::vector<double> m_window;
    kissfft<double> m_transform;
    std::vector<Complex> m_in, m_both; ///< of two signals, one the imaginary part of the other
    std::vector<std::vector<Complex>> m_out; ///< of each signal
};

} // namespace lab
