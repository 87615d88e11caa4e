#include "scope/phase.h"

#include "scope/measurer.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace scope {

namespace {

constexpr double kSameFrequency = 0.02;
constexpr double kLeastShare = 0.05; ///< of the rms that must be at the frequency

/// The part of a channel at `hertz`, as seen from `origin`; the amplitude is that of a sine.
std::complex<double> fundamental(const SampleRange &range, double hertz, Nanos origin)
{
    const double length = capture::toSeconds(range.to() - range.from());
    const double shift = capture::toSeconds(range.from() - origin);
    const auto window = [&](double time) {
        return 1.0 - std::cos(2.0 * std::numbers::pi * time / length);
    };
    double weights = 0.0;
    double mean = 0.0;
    range.visit([&](double time, double value, bool /*joined*/) {
        weights += window(time);
        mean += window(time) * value;
    });
    if (weights <= 0.0)
        return 0.0;
    mean /= weights;
    std::complex<double> sum = 0.0;
    range.visit([&](double time, double value, bool /*joined*/) {
        const double angle = -2.0 * std::numbers::pi * hertz * (time + shift);
        sum += window(time) * (value - mean) * std::polar(1.0, angle);
    });
    return 2.0 * sum / weights;
}

} // namespace

Measurement measurePhase(
    const capture::Channel &first, const capture::Channel &second, Nanos from, Nanos to)
{
    Measurement result;
    result.quantity = Quantity::Phase;
    result.unit = UnitKind::Degrees;
    const Measurement one = Measurer(first, from, to).measure(Quantity::Frequency);
    const Measurement other = Measurer(second, from, to).measure(Quantity::Frequency);
    const auto refused = [&result](WhyNot why) {
        result.refuse(why);
        return result;
    };
    for (const Measurement &side : {one, other})
        if (!side.value)
            return refused(side.value.error());
    if (std::abs(*other.value / *one.value - 1.0) > kSameFrequency)
        return refused(WhyNot::OtherFrequency);
    const Nanos begin = one.points.front().time;
    const Nanos end = one.points.back().time;
    if (std::lround(capture::toSeconds(end - begin) * *one.value) < 2)
        return refused(WhyNot::NoFullPeriod);
    const SampleRange a(first, begin, end);
    const SampleRange b(second, begin, end);
    const std::complex<double> partA = fundamental(a, *one.value, begin);
    const std::complex<double> partB = fundamental(b, *one.value, begin);
    const auto moments = b.moments();
    if (!moments || std::abs(partB) < kLeastShare * moments->deviation || std::abs(partA) <= 0.0)
        return refused(WhyNot::OtherFrequency);
    result.value = std::arg(partB * std::conj(partA)) * 180.0 / std::numbers::pi;
    result.points = {one.points.front(), other.points.front()};
    return result;
}

} // namespace scope
