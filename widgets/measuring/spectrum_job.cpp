#include "widgets/measuring/spectrum_job.h"

namespace widgets {

SpectrumAnswer computeSpectrum(const capture::Snapshot &copy, const SpectrumWanted &wanted,
    const scope::SpectrumAverage &before)
{
    SpectrumAnswer answer;
    answer.wanted = wanted;
    if (copy->empty())
        return answer;
    const capture::Channel &channel = copy->front();
    scope::Nanos from = wanted.from;
    const scope::SampleRange all(channel, from, wanted.to);
    if (all.end() - all.begin() > kMostSpectrumSamples && !all.empty()) {
        answer.cut = true;
        from = channel.timeOf(all.end() - kMostSpectrumSamples);
    }
    scope::SpectrumSettings settings;
    settings.window = wanted.window;
    settings.size = wanted.size;
    answer.spectrum = scope::spectrumOf(scope::SampleRange(channel, from, wanted.to), settings);
    if (answer.spectrum) {
        auto mean = std::make_shared<scope::SpectrumAverage>(before);
        mean->add(*answer.spectrum);
        answer.peaks = scope::findPeaks(mean->mean(), kMostSpectrumPeaks);
        answer.mean = std::move(mean);
    }
    return answer;
}

} // namespace widgets
