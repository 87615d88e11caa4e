#include "lab/maths/cross_spectra.h"

#include <cmath>
#include <kissfft/kissfft.hh>

#include <algorithm>
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
{
    const std::size_t bins = size / 2 + 1;
    m_sum.instrument.resize(bins);
    m_sum.cross.assign(others, std::vector<std::complex<double>>(bins));
    m_sum.own.assign(others, std::vector<double>(bins));
}

void CrossSpectrum::add(std::span<const std::vector<double>> stretch)
{
    kissfft<double> transform(m_size, false);
    std::vector<Complex> in(m_size);
    std::vector<std::vector<Complex>> out(stretch.size(), std::vector<Complex>(m_size));
    const std::size_t length = stretch.front().size();
    for (std::size_t at = 0; at + m_size <= length; at += m_size / 2) {
        for (std::size_t signal = 0; signal < stretch.size(); ++signal) {
            const double *samples = stretch[signal].data() + at;
            double mean = 0.0;
            for (std::size_t i = 0; i < m_size; ++i)
                mean += samples[i] / static_cast<double>(m_size);
            for (std::size_t i = 0; i < m_size; ++i) {
                const double phase =
                    2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(m_size);
                in[i] = (samples[i] - mean) * (0.5 - 0.5 * std::cos(phase));
            }
            transform.transform(in.data(), out[signal].data());
        }
        for (std::size_t bin = 0; bin < m_sum.instrument.size(); ++bin) {
            m_sum.instrument[bin] += std::norm(out[0][bin]);
            for (std::size_t other = 0; other < m_sum.cross.size(); ++other) {
                m_sum.cross[other][bin] += std::conj(out[0][bin]) * out[other + 1][bin];
                m_sum.own[other][bin] += std::norm(out[other + 1][bin]);
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
