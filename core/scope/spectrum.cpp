#include "scope/spectrum.h"

#include <kissfft/kissfft.hh>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

namespace scope {

namespace {

constexpr std::size_t kLeast = 16;

/// The largest even number up to `n` whose half has no factor above 5: such transforms are fast.
std::size_t fastSize(std::size_t n)
{
    for (std::size_t half = n / 2; half > 1; --half) {
        std::size_t rest = half;
        for (const std::size_t factor : {2U, 3U, 5U}) {
            while (rest % factor == 0)
                rest /= factor;
        }
        if (rest == 1)
            return 2 * half;
    }
    return 0;
}

/// Samples at equal distances.
struct Uniform {
    std::vector<double> values;
    double step = 0.0; ///< seconds
    double from = 0.0; ///< seconds since the range begins
};

/// The longest unbroken piece; more than kMostTransformed at once are only wanted for averaging.
Uniform longestPiece(const SampleRange &range)
{
    std::size_t begin = 0;
    std::size_t longest = 0;
    std::size_t longestBegin = 0;
    std::size_t count = 0;
    range.visit([&](double /*time*/, double /*value*/, bool joined) {
        if (!joined)
            begin = count;
        ++count;
        if (count - begin > longest) {
            longest = count - begin;
            longestBegin = begin;
        }
    });
    Uniform result;
    result.values.reserve(longest);
    double last = 0.0;
    count = 0;
    range.visit([&](double time, double value, bool /*joined*/) {
        if (count == longestBegin)
            result.from = time;
        if (count >= longestBegin && count < longestBegin + longest) {
            result.values.push_back(value);
            last = time;
        }
        ++count;
    });
    if (longest > 1)
        result.step = (last - result.from) / static_cast<double>(longest - 1);
    return result;
}

/// Every sample is where equal distances put it, to a hundredth of the distance.
bool isUniform(const SampleRange &range, const Uniform &piece)
{
    if (range.channel().fast())
        return true;
    const double to = piece.from + piece.step * (static_cast<double>(piece.values.size()) - 0.5);
    double place = 0.0;
    bool uniform = true;
    range.visit([&](double time, double /*value*/, bool /*joined*/) {
        if (time < piece.from || time > to)
            return;
        uniform =
            uniform && std::abs(time - piece.from - place * piece.step) < 0.01 * piece.step + 2e-9;
        place += 1.0;
    });
    return uniform;
}

/// Adds the mean squares of one transform. The mean that is subtracted is that of the windowed samples: it leaves
/// nothing at 0 Hz, also when the samples are no whole periods.
void transform(const double *values, bool subtractMean, const std::vector<double> &window,
    const kissfft<double> &fft, std::vector<double> &sums)
{
    const std::size_t half = window.size() / 2;
    double weights = 0.0;
    double squares = 0.0;
    double mean = 0.0;
    for (std::size_t i = 0; i < window.size(); ++i) {
        weights += window[i];
        squares += window[i] * window[i];
        mean += window[i] * values[i];
    }
    mean = subtractMean ? mean / weights : 0.0;
    std::vector<double> windowed(window.size());
    for (std::size_t i = 0; i < window.size(); ++i)
        windowed[i] = window[i] * (values[i] - mean);
    std::vector<std::complex<double>> bins(half);
    fft.transform_real(windowed.data(), bins.data());
    const double scale = 1.0 / (static_cast<double>(window.size()) * squares);
    sums[0] += bins[0].real() * bins[0].real() * scale;
    // That is where kissfft puts the last bin.
    sums[half] += bins[0].imag() * bins[0].imag() * scale;
    for (std::size_t k = 1; k < half; ++k)
        sums[k] += 2.0 * std::norm(bins[k]) * scale;
}

} // namespace

double Spectrum::amplitude(std::size_t bin) const
{
    const double square = meanSquares[bin] * noiseBandwidth(window);
    const bool single = bin == 0 || bin + 1 == meanSquares.size();
    return std::sqrt(single ? square : 2.0 * square);
}

Result<Spectrum, NoSpectrum> spectrumOf(const SampleRange &range, const SpectrumSettings &settings)
{
    const Uniform piece = longestPiece(range);
    const std::size_t count = piece.values.size();
    const std::size_t wanted = settings.size == 0 ? count : std::min(settings.size, count);
    const std::size_t size = fastSize(std::min(wanted, kMostTransformed));
    if (size < kLeast)
        return fail(NoSpectrum::TooFewSamples);
    if (!isUniform(range, piece))
        return fail(NoSpectrum::NotUniform);

    Spectrum result;
    result.window = settings.window;
    result.size = size;
    result.binHz = 1.0 / (piece.step * static_cast<double>(size));
    result.mean =
        std::accumulate(piece.values.begin(), piece.values.end(), 0.0) / static_cast<double>(count);
    result.from = range.toNanos(piece.from);
    result.meanSquares.assign(size / 2 + 1, 0.0);
    const std::vector<double> window = windowValues(settings.window, size);
    const kissfft<double> fft(size / 2, false);
    const std::size_t stride = settings.window == Window::Rectangular ? size : size / 2;
    std::size_t start = 0;
    for (; start + size <= count; start += stride) {
        transform(&piece.values[start], settings.subtractMean, window, fft, result.meanSquares);
        ++result.averaged;
    }
    for (double &square : result.meanSquares)
        square /= result.averaged;
    const auto used = static_cast<double>(start - stride + size);
    result.to = range.toNanos(piece.from + used * piece.step);
    return result;
}

SpectrumAverage::SpectrumAverage(std::uint32_t most)
    : m_most(std::max(most, 1U))
{
}

void SpectrumAverage::add(const Spectrum &spectrum)
{
    const bool same = m_count > 0 && m_mean.size == spectrum.size
        && m_mean.window == spectrum.window
        && std::abs(m_mean.binHz - spectrum.binHz) < 1e-6 * spectrum.binHz;
    if (!same) {
        m_mean = spectrum;
        m_count = 1;
        return;
    }
    m_count = m_count < m_most ? m_count + 1 : m_most;
    const double share = 1.0 / m_count;
    for (std::size_t k = 0; k < m_mean.meanSquares.size(); ++k)
        m_mean.meanSquares[k] += share * (spectrum.meanSquares[k] - m_mean.meanSquares[k]);
    m_mean.mean += share * (spectrum.mean - m_mean.mean);
    m_mean.averaged += spectrum.averaged;
    m_mean.from = std::min(m_mean.from, spectrum.from);
    m_mean.to = std::max(m_mean.to, spectrum.to);
}

} // namespace scope
