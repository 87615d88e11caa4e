// What an automatic measurement says: a number or the reason why there is none, its kind of unit, and the levels and
// points to draw, so that the user sees what was measured. Definitions: measurer.h, step_response.h, phase.h. And what
// many of them say together.
#pragma once

#include "base/result.h"
#include "capture/tick_time.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace scope {

using capture::Nanos;

enum class Quantity : std::uint8_t {
    Min,
    Max,
    PeakToPeak,
    Mean,
    Rms,
    CycleMean, ///< over whole periods
    CycleRms,
    Frequency,
    Period,
    Duty, ///< share of a period above the middle level
    Rise, ///< 10 to 90 %
    Fall,
    Overshoot, ///< past the final value, of the step
    Undershoot, ///< to the wrong side of the initial value, of the step
    PeakTime, ///< from the step to the largest deviation from the initial value in its direction
    Settling,
    DeadTime, ///< to 5 % of the step
    SteadyStateError, ///< set-point minus final value
    Ripple, ///< peak to peak once settled
    RippleRms,
    AbsoluteError, ///< integral of |set-point - value|
    TimedError, ///< integral of time * |set-point - value|
    Phase
};

/// Of the number; the channel's own unit is in its ChannelInfo.
enum class UnitKind : std::uint8_t {
    Channel,
    Seconds,
    Hertz,
    Percent,
    Degrees,
    ChannelSeconds, ///< channel's unit times s
    ChannelSecondsSquared
};

enum class WhyNot : std::uint8_t {
    NoSamples,
    GapInside, ///< times cannot be measured across what is missing
    NoFullPeriod, ///< or the signal is flat
    NoEdge, ///< no complete one in that direction
    NoStep, ///< start and end are the same as far as the noise lets see
    NotSettled, ///< does not stay in the band for long enough
    NoSetPoint, ///< it was not said what the value should be
    OtherFrequency ///< the two channels do not share one
};

/// A level over a stretch of time; two with the roles BandLow and BandHigh are a band.
struct LevelMark {
    enum class Role : std::uint8_t { Measured, Reference, BandLow, BandHigh } role = Role::Measured;
    double level = 0.0; ///< in the channel's unit
    Nanos from = 0;
    Nanos to = 0;
};

/// An instant at a value; two of them are the ends of what was measured.
struct PointMark {
    Nanos time = 0;
    double level = 0.0;
};

struct Measurement {
    Quantity quantity = Quantity::Mean;
    UnitKind unit = UnitKind::Channel;
    Result<double, WhyNot> value = fail(WhyNot::NoSamples);
    bool partial = false; ///< something is missing inside; the number is about what is there
    std::vector<LevelMark> levels;
    std::vector<PointMark> points;

    void refuse(WhyNot why) { value = fail(why); } ///< there is no value
};

UnitKind unitOf(Quantity quantity);

/// Mean, spread and extremes of a measurement over many captures, one number at a time, without keeping them.
/// Numerically stable however large the mean is beside the spread. Source: B. P. Welford, Technometrics 4 (1962), 419.
class Statistics {
public:
    /// A capture that gave no number (nullopt, or not a finite one) is counted apart.
    void add(std::optional<double> value)
    {
        if (!value || !std::isfinite(*value)) {
            ++m_missing;
            return;
        }
        ++m_count;
        const double before = *value - m_mean;
        m_mean += before / static_cast<double>(m_count);
        m_squares += before * (*value - m_mean);
        m_min = std::min(m_min, *value);
        m_max = std::max(m_max, *value);
        m_last = value;
    }
    void clear() { *this = {}; }

    std::uint64_t count() const { return m_count; }
    std::uint64_t missing() const { return m_missing; }
    std::optional<double> last() const { return m_last; }
    std::optional<double> mean() const { return whenAtLeast(1, m_mean); }
    std::optional<double> min() const { return whenAtLeast(1, m_min); }
    std::optional<double> max() const { return whenAtLeast(1, m_max); }
    /// Of the sample (divided by n - 1); nullopt with fewer than two.
    std::optional<double> sigma() const
    {
        return whenAtLeast(2, std::sqrt(m_squares / (static_cast<double>(m_count) - 1.0)));
    }

private:
    std::optional<double> whenAtLeast(std::uint64_t least, double value) const
    {
        return m_count >= least ? std::optional(value) : std::nullopt;
    }

    std::uint64_t m_count = 0;
    std::uint64_t m_missing = 0;
    double m_mean = 0.0;
    double m_squares = 0.0; ///< of the distances from the mean
    double m_min = std::numeric_limits<double>::infinity();
    double m_max = -std::numeric_limits<double>::infinity();
    std::optional<double> m_last;
};

} // namespace scope
