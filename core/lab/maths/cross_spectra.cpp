#include "lab/maths/cross_spectra.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lab {

double CrossSpectra::coherence(std::size_t signal, std::size_t bin) const
{
    const double both = instrument[bin] * own[signal][bin];
    return both > 0.0 ? std::min(1.0, std::norm(cross[signal][bin]) / both) : 0.0;
}

CrossSpectra CrossSpectra::band(std::size_t first, std::size_t bins) const
{
    CrossSpectra sum;
    sum.binHz = binHz * static_cast<double>(bins);
    sum.averages = averages * static_cast<int>(bins);
    const auto add = [&](const auto &values) {
        using Value = std::decay_t<decltype(values[0])>;
        return std::vector<Value>{
            std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(first),
                values.begin() + static_cast<std::ptrdiff_t>(first + bins), Value())};
    };
    sum.instrument = add(instrument);
    for (std::size_t signal = 0; signal < cross.size(); ++signal) {
        sum.cross.push_back(add(cross[signal]));
        sum.own.push_back(add(own[signal]));
    }
    return sum;
}

CrossSpectrum::CrossSpectrum(std::size_t size, double sampleHz, std::size_t others)
    : m_size(size)
    , m_sampleHz(sampleHz)
    , m_window(size)
    , m_transform(size, false)
    , m_in(size)
    , m_both(size)
    , m_out(others + 1, std::vector<Complex>(size / 2 + 1))
{
    const std::size_t bins = size / 2 + 1;
    m_sum.instrument.resize(bins);
    m_sum.cross.assign(others, std::vector<std::complex<double>>(bins));
    m_sum.own.assign(others, std::vector<double>(bins));
    const double step = 2.0 * std::numbers::pi / static_cast<double>(size);
    for (std::size_t i = 0; i < size; ++i)
        m_window[i] = 0.5 - 0.5 * std::cos(step * static_cast<double>(i));
}

/// In four sums side by side, which wait for each other a quarter as long as one.
double CrossSpectrum::meanOf(const double *samples) const
{
    std::array<double, 4> sums{};
    std::size_t i = 0;
    for (; i + sums.size() <= m_size; i += sums.size())
        for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += samples[i + k];
    const double rest = std::accumulate(samples + i, samples + m_size, 0.0);
    return (sums[0] + sums[1] + sums[2] + sums[3] + rest) / static_cast<double>(m_size);
}

/// Two real signals at once: what is even of the one transform is of the first, what is odd of the second.
void CrossSpectrum::transform(std::span<const std::vector<double>> stretch, std::size_t at)
{
    for (std::size_t signal = 0; signal < stretch.size(); signal += 2) {
        const bool two = signal + 1 < stretch.size();
        const double *const first = stretch[signal].data() + at;
        const double *const second = two ? stretch[signal + 1].data() + at : first;
        const double firstMean = meanOf(first), secondMean = two ? meanOf(second) : firstMean;
        for (std::size_t i = 0; i < m_size; ++i)
            m_in[i] = {
                (first[i] - firstMean) * m_window[i], (second[i] - secondMean) * m_window[i]};
        m_transform.transform(m_in.data(), m_both.data());
        Complex *const even = m_out[signal].data();
        Complex *const odd = two ? m_out[signal + 1].data() : nullptr;
        for (std::size_t bin = 0; bin < m_sum.instrument.size(); ++bin) {
            const Complex one = 0.5 * m_both[bin],
                          mirror = 0.5 * m_both[bin > 0 ? m_size - bin : 0];
            even[bin] = {one.real() + mirror.real(), one.imag() - mirror.imag()};
            if (odd)
                odd[bin] = {one.imag() + mirror.imag(), mirror.real() - one.real()};
        }
    }
}

void CrossSpectrum::add(std::span<const std::vector<double>> stretch)
{
    const std::size_t length = stretch.front().size();
    for (std::size_t at = 0; at + m_size <= length; at += m_size / 2) {
        transform(stretch, at);
        const std::size_t bins = m_sum.instrument.size();
        const Complex *const base = m_out[0].data();
        for (std::size_t bin = 0; bin < bins; ++bin)
            m_sum.instrument[bin] += std::norm(base[bin]);
        for (std::size_t other = 0; other < m_sum.cross.size(); ++other) {
            const Complex *const out = m_out[other + 1].data();
            Complex *const cross = m_sum.cross[other].data();
            double *const own = m_sum.own[other].data();
            for (std::size_t bin = 0; bin < bins; ++bin) {
                cross[bin] += std::conj(base[bin]) * out[bin];
                own[bin] += std::norm(out[bin]);
            }
        }
        ++m_count;
    }
}

CrossSpectra CrossSpectrum::result() const
{
    CrossSpectra result = m_sum; // scales fall out of every ratio
    result.binHz = m_sampleHz / static_cast<double>(m_size);
    result.averages = (m_count + 1) / 2;
    return result;
}

} // namespace lab
