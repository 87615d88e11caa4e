// One spectrum as a job: a copy of a channel and what is wanted go in, the spectrum and its peaks come out. Touches
// nothing else, so that it may run in any thread.
#pragma once

#include "capture/capture.h"
#include "scope/spectrum.h"

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
};

/// Samples at most; a longer range is cut to its newest ones.
inline constexpr std::uint64_t kMostSpectrumSamples = 1U << 20U;

/// @param copy  of wanted.channel alone
SpectrumAnswer computeSpectrum(const capture::Snapshot &copy, const SpectrumWanted &wanted);

} // namespace widgets
