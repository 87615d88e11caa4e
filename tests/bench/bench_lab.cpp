// What an evaluation of the lab costs: spectra for a frequency response, against a plain transform of the same samples,
// and the inertia and friction of a recording, against a plain pass over it.
#include "bench/paired.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "lab/maths/cross_spectra.h"
#include "support/lab_bench.h"

#include <numeric>
#include <random>

namespace {

using namespace bench;

constexpr std::size_t kSamples = 10'000'000; // of each of two signals
constexpr std::size_t kTransform = 2048; // as the response of the speed

std::vector<std::vector<double>> twoSignals()
{
    std::mt19937 random(1);
    std::normal_distribution<double> gauss;
    std::vector<std::vector<double>> samples(2, std::vector<double>(kSamples));
    for (std::size_t i = 0; i < kSamples; ++i) {
        samples[0][i] = gauss(random);
        samples[1][i] = (i > 0 ? 0.9 * samples[1][i - 1] : 0.0) + samples[0][i];
    }
    return samples;
}

/// Each sample once, no window, nothing added up.
double plainTransforms(const std::vector<std::vector<double>> &samples)
{
    kissfft<double> transform(kTransform, false);
    std::vector<lab::Complex> in(kTransform), out(kTransform);
    double sum = 0.0;
    for (const std::vector<double> &signal : samples)
        for (std::size_t at = 0; at + kTransform <= kSamples; at += kTransform) {
            std::copy_n(signal.begin() + static_cast<std::ptrdiff_t>(at), kTransform, in.begin());
            transform.transform(in.data(), out.data());
            sum += out[1].real();
        }
    return sum;
}

void welchAgainstTransform(benchmark::State &state)
{
    const auto samples = twoSignals();
    double sum = 0.0;
    lab::CrossSpectra found;
    const Pair pair = pairedRatio(
        state, [&] { sum += plainTransforms(samples); },
        [&] {
            lab::CrossSpectrum spectrum(kTransform, 1000.0, 1);
            spectrum.add(samples);
            found = spectrum.result();
        });
    benchmark::DoNotOptimize(sum);
    // Of one pole the gain at rest is 1 / (1 - 0.9).
    const double gain = std::abs(found.cross[0][1]) / found.instrument[1];
    require(gain > 9.5 && gain < 10.5, "the response is not that of the signals");
    report(
        {"I5 Welch", "response from 2 x 1e7 samples, transforms of 2048", pair.bSeconds, "a core"});
    report({"I5", "the same", Measured::cost(pair), "a plain FFT of the same samples"});
}
BENCHMARK(welchAgainstTransform)->Iterations(5)->Unit(benchmark::kMillisecond);

double plainPass(const capture::Capture &capture)
{
    double sum = 0.0;
    for (const capture::ChannelInfo &info : capture.channels()) {
        const capture::FastColumn *const column = capture.channel(info.id)->fast();
        if (column == nullptr)
            continue;
        for (capture::Index next = column->begin(); next < column->end();) {
            const auto codes = column->codes(next, kSamples);
            sum = std::accumulate(codes.begin(), codes.end(), sum);
            next += codes.size();
        }
    }
    return sum;
}

void identificationAgainstPass(benchmark::State &state)
{
    support::LabBench bench;
    bench.experiment.plan = lab::spinPlanFor(bench.experiment.subject, {});
    require(bench.run().end == lab::End::Complete, "the experiment did not come to its end");
    const auto span = bench.capture.timeSpan();
    require(span.has_value(), "nothing was recorded");
    const double length = span->to - span->from;
    double sum = 0.0;
    bool known = true;
    const Pair pair = pairedRatio(
        state, [&] { sum += plainPass(bench.capture); },
        [&] { known = known && lab::evaluateMechanics(bench.capture, bench.happenings); });
    benchmark::DoNotOptimize(sum);
    require(known, "the recording tells no inertia");
    report({"I5 identification", "inertia and friction of 10 s",
        pair.bSeconds * 1e3 * 10.0 / length, "a core"});
    report({"I5", "the same", Measured::cost(pair), "a plain pass over the codes"});
}
BENCHMARK(identificationAgainstPass)->Iterations(20)->Unit(benchmark::kMillisecond);

} // namespace
