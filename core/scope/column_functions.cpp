#include "scope/column_functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace scope {

namespace {

using Arguments = std::span<const double>;

constexpr std::array<ColumnFunctionInfo, 12> kFunctions{{
    {"derivative", ColumnKind::Derivative, 1, false},
    {"integral", ColumnKind::Integral, 1, false},
    {"lowpass", ColumnKind::LowPass, 2, true},
    {"highpass", ColumnKind::HighPass, 2, true},
    {"median", ColumnKind::Median, 2, true},
    {"average", ColumnKind::Average, 2, true},
    {"unwrap", ColumnKind::Unwrap, 1, false},
    {"clarke_alpha", ColumnKind::ClarkeAlpha, 2, false},
    {"clarke_beta", ColumnKind::ClarkeBeta, 2, false},
    {"park_d", ColumnKind::ParkD, 3, false},
    {"park_q", ColumnKind::ParkQ, 3, false},
    {"power", ColumnKind::Power, 4, false},
}};

class Derivative final : public ColumnFunction {
public:
    double step(Arguments x, double seconds, bool joined) override
    {
        const double slope = joined && seconds > 0.0 ? (x[0] - m_before) / seconds
                                                     : std::numeric_limits<double>::quiet_NaN();
        m_before = x[0];
        return slope;
    }

private:
    double m_before = 0.0;
};

class Integral final : public ColumnFunction {
public:
    double step(Arguments x, double seconds, bool joined) override
    {
        m_sum = joined ? m_sum + (m_before + x[0]) / 2 * seconds : 0.0;
        m_before = x[0];
        return m_sum;
    }

private:
    double m_before = 0.0;
    double m_sum = 0.0;
};

/// First order, exact for an input that holds between the samples, whatever their distance.
class Filter final : public ColumnFunction {
public:
    Filter(double hertz, bool high)
        : m_rate(2.0 * std::numbers::pi * hertz)
        , m_high(high)
    {
    }
    double step(Arguments x, double seconds, bool joined) override
    {
        if (joined)
            m_low -= std::expm1(-m_rate * seconds) * (x[0] - m_low);
        else
            m_low = x[0];
        return m_high ? x[0] - m_low : m_low;
    }

private:
    double m_rate;
    bool m_high;
    double m_low = 0.0;
};

/// The last n values: a ring in the order of time.
class LastValues {
public:
    explicit LastValues(double count)
        : m_most(static_cast<std::size_t>(count))
    {
        m_ring.reserve(m_most);
    }
    void clear()
    {
        m_ring.clear();
        m_next = 0;
    }
    /// @return the value that leaves, if the ring is full
    const double *add(double value)
    {
        if (m_ring.size() < m_most) {
            m_ring.push_back(value);
            return nullptr;
        }
        m_left = std::exchange(m_ring[m_next], value);
        m_next = (m_next + 1) % m_most;
        return &m_left;
    }
    const std::vector<double> &all() const { return m_ring; }

private:
    std::size_t m_most;
    std::size_t m_next = 0;
    double m_left = 0.0;
    std::vector<double> m_ring;
};

class Median final : public ColumnFunction {
public:
    explicit Median(double count)
        : m_last(count)
    {
    }
    double step(Arguments x, double /*seconds*/, bool joined) override
    {
        if (!joined) {
            m_last.clear();
            m_sorted.clear();
        }
        if (const double *left = m_last.add(x[0]))
            m_sorted.erase(std::ranges::lower_bound(m_sorted, *left));
        m_sorted.insert(std::ranges::upper_bound(m_sorted, x[0]), x[0]);
        const std::size_t half = m_sorted.size() / 2;
        return m_sorted.size() % 2 != 0 ? m_sorted[half]
                                        : (m_sorted[half - 1] + m_sorted[half]) / 2;
    }

private:
    LastValues m_last;
    std::vector<double> m_sorted;
};

/// Sums anew each time: a running sum would keep the rounding of a large value for ever.
class Average final : public ColumnFunction {
public:
    explicit Average(double count)
        : m_last(count)
    {
    }
    double step(Arguments x, double /*seconds*/, bool joined) override
    {
        if (!joined)
            m_last.clear();
        m_last.add(x[0]);
        double sum = 0.0;
        for (const double value : m_last.all())
            sum += value;
        return sum / static_cast<double>(m_last.all().size());
    }

private:
    LastValues m_last;
};

class Unwrap final : public ColumnFunction {
public:
    explicit Unwrap(double turn)
        : m_turn(turn)
    {
    }
    double step(Arguments x, double /*seconds*/, bool joined) override
    {
        if (!joined)
            m_turns = 0.0;
        else
            m_turns -= std::round((x[0] - m_before) / m_turn);
        m_before = x[0];
        return x[0] + m_turns * m_turn;
    }

private:
    double m_turn;
    double m_before = 0.0;
    double m_turns = 0.0;
};

/// Clarke, Park and power: no memory.
class Frame final : public ColumnFunction {
public:
    Frame(ColumnKind kind, const ColumnSettings &settings)
        : m_kind(kind)
        , m_toRadians(2.0 * std::numbers::pi / settings.turn)
    {
    }
    double step(Arguments x, double /*seconds*/, bool /*joined*/) override
    {
        switch (m_kind) {
        case ColumnKind::ClarkeAlpha:
            return x[0];
        case ColumnKind::ClarkeBeta:
            return -(x[0] + 2.0 * x[1]) / std::numbers::sqrt3;
        case ColumnKind::Power:
            return 1.5 * (x[0] * x[1] + x[2] * x[3]);
        default:
            return park(x[0], x[1], x[2] * m_toRadians);
        }
    }

private:
    double park(double alpha, double beta, double angle) const
    {
        const double along = std::cos(angle);
        const double across = std::sin(angle);
        if (m_kind == ColumnKind::ParkD)
            return alpha * across + beta * along;
        return alpha * along - beta * across;
    }

    ColumnKind m_kind;
    double m_toRadians;
};

} // namespace

const ColumnFunctionInfo *columnFunction(std::string_view name)
{
    const auto *const found = std::ranges::find(kFunctions, name, &ColumnFunctionInfo::name);
    return found != kFunctions.end() ? found : nullptr;
}

std::span<const ColumnFunctionInfo> columnFunctions() { return kFunctions; }

bool fits(ColumnKind kind, double constant)
{
    if (!std::isfinite(constant))
        return false;
    if (kind == ColumnKind::LowPass || kind == ColumnKind::HighPass)
        return constant > 0.0;
    return constant >= 1.0 && constant <= kMostTaps && constant == std::floor(constant);
}

std::unique_ptr<ColumnFunction> makeColumnFunction(ColumnKind kind, const ColumnSettings &settings)
{
    switch (kind) {
    case ColumnKind::Derivative:
        return std::make_unique<Derivative>();
    case ColumnKind::Integral:
        return std::make_unique<Integral>();
    case ColumnKind::LowPass:
    case ColumnKind::HighPass:
        return std::make_unique<Filter>(settings.constant, kind == ColumnKind::HighPass);
    case ColumnKind::Median:
        return std::make_unique<Median>(settings.constant);
    case ColumnKind::Average:
        return std::make_unique<Average>(settings.constant);
    case ColumnKind::Unwrap:
        return std::make_unique<Unwrap>(settings.turn);
    default:
        return std::make_unique<Frame>(kind, settings);
    }
}

} // namespace scope
