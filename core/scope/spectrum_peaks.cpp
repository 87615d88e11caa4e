#include "scope/spectrum.h"

#include <algorithm>
#include <cmath>

namespace scope {

namespace {

/// Bins from the middle of a tone to its first zero.
std::size_t lobe(Window window)
{
    constexpr std::size_t kBins[] = {1, 2, 4, 5}; // in the order of the enumeration
    return kBins[static_cast<std::size_t>(window)];
}

/// How far the tone lies from the bin where it is highest, in bins: from the two bins beside it, whose ratio depends
/// on nothing else.
double offsetFrom(const Spectrum &spectrum, std::size_t bin)
{
    const auto at = [&](std::size_t k) { return spectrum.amplitude(k); };
    const double left = at(bin - 1);
    const double right = at(bin + 1);
    const double ratio = std::max(left, right) / at(bin);
    const double side = right > left ? 1.0 : -1.0;
    if (spectrum.window == Window::Rectangular)
        return side * ratio / (1.0 + ratio);
    if (spectrum.window == Window::Hann)
        return side * std::clamp((2.0 * ratio - 1.0) / (ratio + 1.0), 0.0, 0.5);
    // The wider windows have no short formula; the flat top is steep only two bins away.
    const std::size_t away = spectrum.window == Window::FlatTop ? 2 : 1;
    if (bin < away || bin + away >= spectrum.meanSquares.size())
        return 0.0;
    const auto distance = static_cast<double>(away);
    const double wanted = at(bin + away) / at(bin - away);
    double low = -1.0;
    double high = 1.0;
    for (int i = 0; i < 50; ++i) {
        const double middle = (low + high) / 2;
        const double there = windowResponse(spectrum.window, distance - middle)
            / windowResponse(spectrum.window, distance + middle);
        (there < wanted ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// At most what a tone reads so many bins away.
double skirt(Window window, double bins)
{
    double most = 0.0;
    for (const double part : {-0.5, -0.25, 0.0, 0.25, 0.5})
        most = std::max(most, std::abs(windowResponse(window, bins + part)));
    return most;
}

bool hidden(const Spectrum &spectrum, const SpectrumPeak &peak, const SpectrumPeak &larger)
{
    const std::size_t distance =
        peak.bin > larger.bin ? peak.bin - larger.bin : larger.bin - peak.bin;
    if (distance < lobe(spectrum.window))
        return true;
    // Twice: the tone's mirror image below 0 Hz adds to its side lobes.
    const double leak = larger.amplitude * skirt(spectrum.window, static_cast<double>(distance));
    return peak.amplitude < 2.0 * leak;
}

bool isHidden(
    const Spectrum &spectrum, const SpectrumPeak &peak, const std::vector<SpectrumPeak> &largerOnes)
{
    return std::ranges::any_of(
        largerOnes, [&](const SpectrumPeak &larger) { return hidden(spectrum, peak, larger); });
}

/// At most so many times what its highest bin reads is the amplitude of a tone, where offsetFrom() places it.
double greatestGain(Window window)
{
    double gain = 1.0;
    const double farthest = window == Window::Rectangular || window == Window::Hann ? 0.5 : 1.0;
    for (int part = 0; part <= 8; ++part)
        gain = std::max(gain, 1.0 / windowResponse(window, farthest * part / 8));
    constexpr double kRounding = 1.0 + 1e-9;
    return gain * kRounding;
}

struct Maximum {
    double square;
    std::size_t bin;
    bool operator<(const Maximum &other) const
    {
        return square != other.square ? square < other.square : bin > other.bin;
    }
};

bool isSmaller(const SpectrumPeak &a, const SpectrumPeak &b) { return a.amplitude < b.amplitude; }

} // namespace

std::vector<SpectrumPeak> findPeaks(
    const Spectrum &spectrum, std::size_t most, double floor, std::size_t *refined)
{
    const std::vector<double> &squares = spectrum.meanSquares;
    // Noise has a maximum every third bin. Where a tone lies between the bins is worth finding only for those that can
    // be among the largest: a bin reads at most so much less than the tone does.
    const double mostGain = greatestGain(spectrum.window);
    std::vector<Maximum> maxima;
    for (std::size_t k = 1; k + 1 < squares.size(); ++k)
        if (squares[k] > squares[k - 1] && squares[k] >= squares[k + 1])
            maxima.push_back({squares[k], k});
    std::make_heap(maxima.begin(), maxima.end());
    std::vector<SpectrumPeak> result;
    // Of the maxima that were taken off the heap; a heap by amplitude.
    std::vector<SpectrumPeak> known;
    std::size_t count = 0;
    while (result.size() < most && !(maxima.empty() && known.empty())) {
        const double bound =
            maxima.empty() ? 0.0 : spectrum.amplitude(maxima.front().bin) * mostGain;
        if (!known.empty() && known.front().amplitude >= bound) {
            std::pop_heap(known.begin(), known.end(), isSmaller);
            if (!isHidden(spectrum, known.back(), result))
                result.push_back(known.back());
            known.pop_back();
            continue;
        }
        if (bound < floor || bound == 0.0)
            break; // as are all that follow
        const std::size_t bin = maxima.front().bin;
        std::pop_heap(maxima.begin(), maxima.end());
        maxima.pop_back();
        if (isHidden(spectrum, {0.0, bound, bin}, result))
            continue; // whatever it reads between the bins
        ++count;
        const double offset = offsetFrom(spectrum, bin);
        const double amplitude = spectrum.amplitude(bin) / windowResponse(spectrum.window, offset);
        if (amplitude < floor || !(amplitude > 0.0))
            continue;
        known.push_back({spectrum.frequency(static_cast<double>(bin) + offset), amplitude, bin});
        std::push_heap(known.begin(), known.end(), isSmaller);
    }
    if (refined)
        *refined = count;
    return result;
}

} // namespace scope
