// One spectrum as a job: a copy of a channel, what is wanted and the mean until then go in, the mean with it and its
// peaks come out. Touches nothing else, so that it may run in any thread. All that takes longer the more samples there
// are is here.
#pragma once

#include "capture/capture.h"
#include "scope/spectrum.h"

#include <memory>

namespace widgets {

struct SpectrumWanted {
    capture::ChannelId channel = 0;
    scope::Nanos from = 0;
    scope::Nanos to = 0; ///< not included
    std::uint64_t samples = 0; ///< that are there; a picture that fills up is looked at again
    scope::Window window = scope::Window::Hann;
    std::size_t size = 0; ///< as in SpectrumSettings
    bool operator==(const SpectrumWanted &) const = default;
};

struct SpectrumAnswer {
    SpectrumWanted wanted;
    Result<scope::Spectrum, scope::NoSpectrum> spectrum = fail(scope::NoSpectrum::TooFewSamples);
    bool cut = false; ///< there were more samples: only the newest ones were used
    std::shared_ptr<const scope::SpectrumAverage> mean; ///< with it; none without a spectrum
    std::vector<scope::SpectrumPeak> peaks; ///< of the mean, the largest first
};

constexpr std::size_t kMostSpectrumPeaks = 10;

/// Samples at most; a longer range is cut to its newest ones.
inline constexpr std::uint64_t kMostSpectrumSamples = 1U << 20U;

/// @param copy    of wanted.channel alone
/// @param before  the mean that it is added to
SpectrumAnswer computeSpectrum(const capture::Snapshot &copy, const SpectrumWanted &wanted,
    const scope::SpectrumAverage &before = scope::SpectrumAverage(1));

} // namespace widgets
