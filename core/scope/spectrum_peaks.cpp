#include "scope/spectrum.h"

#include <algorithm>
#include <cmath>

namespace scope {

namespace {

/// Bins from the middle of a tone to its first zero.
std::size_t lobe(Window window)
{
    switch (window) {
    case Window::Rectangular:
        return 1;
    case Window::Hann:
        return 2;
    case Window::BlackmanHarris:
        return 4;
    case Window::FlatTop:
        return 5;
    }
    return 2;
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

} // namespace

std::vector<SpectrumPeak> findPeaks(const Spectrum &spectrum, std::size_t most, double floor)
{
    std::vector<SpectrumPeak> candidates;
    const std::vector<double> &squares = spectrum.meanSquares;
    for (std::size_t k = 1; k + 1 < squares.size(); ++k) {
        if (squares[k] <= squares[k - 1] || squares[k] < squares[k + 1])
            continue;
        const double offset = offsetFrom(spectrum, k);
        const double amplitude = spectrum.amplitude(k) / windowResponse(spectrum.window, offset);
        if (amplitude >= floor && amplitude > 0.0)
            candidates.push_back(
                {spectrum.frequency(static_cast<double>(k) + offset), amplitude, k});
    }
    std::sort(candidates.begin(), candidates.end(),
        [](const SpectrumPeak &a, const SpectrumPeak &b) { return a.amplitude > b.amplitude; });
    std::vector<SpectrumPeak> result;
    for (const SpectrumPeak &peak : candidates) {
        if (result.size() >= most)
            break;
        const bool isHidden = std::any_of(result.begin(), result.end(),
            [&](const SpectrumPeak &larger) { return hidden(spectrum, peak, larger); });
        if (!isHidden)
            result.push_back(peak);
    }
    return result;
}

} // namespace scope
