#include "lab/evaluation/segments.h"

#include "base/text.h"
#include "lab/happenings.h"
#include "scope/sample_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lab {

namespace {

/// 1 forwards, -1 backwards, 0 as good as standing.
std::vector<int> directionsOf(const Segment &segment, double least_degPerS, double edge_s)
{
    const std::size_t last = segment.turned_deg.size() - 1;
    const auto edge = static_cast<std::size_t>(std::max(1L, std::lround(edge_s / segment.step_s)));
    std::vector<int> directions;
    for (std::size_t at = 0; at <= last; ++at) {
        const std::size_t from = at < edge ? 0 : at - edge, to = std::min(at + edge, last);
        const double speed = (segment.turned_deg[to] - segment.turned_deg[from])
            / (static_cast<double>(to - from) * segment.step_s);
        directions.push_back(std::abs(speed) < least_degPerS ? 0 : speed < 0.0 ? -1 : 1);
    }
    return directions;
}

Segment pieceOf(const Segment &segment, std::size_t from, std::size_t to)
{
    constexpr double kTurn_deg = 360.0;
    const auto cut = [from, to](const std::vector<double> &values) {
        return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(from),
            values.begin() + static_cast<std::ptrdiff_t>(to));
    };
    Segment piece{.at = segment.at
            + static_cast<capture::Nanos>(static_cast<double>(from) * segment.step_s * 1e9),
        .step_s = segment.step_s,
        .period_s = segment.period_s,
        .first_deg = std::remainder(segment.first_deg + segment.turned_deg[from], kTurn_deg),
        .turned_deg = cut(segment.turned_deg),
        .values = {}};
    for (double &turned : piece.turned_deg)
        turned -= segment.turned_deg[from];
    for (const std::vector<double> &values : segment.values)
        piece.values.push_back(cut(values));
    return piece;
}

/// Shortens a stretch to where the channel has samples: others may have been recorded before it, or behind it.
void shorten(const capture::Channel &channel, capture::Nanos &from, capture::Nanos &to)
{
    const scope::SampleRange range(channel, from, to);
    if (range.empty())
        return;
    from = std::max(from, channel.timeOf(range.begin()));
    to = std::min(to, channel.timeOf(range.end() - 1) + 1);
}

/// Values at odd times, and what lies between them.
class Reads {
public:
    Reads(const capture::Channel &channel, capture::Nanos from, capture::Nanos to)
    {
        scope::SampleRange(channel, from, to).visit([this](double at_s, double value, bool) {
            m_all.emplace_back(at_s, value);
        });
    }
    /// Instants that do not fall. Empty: not between two that are close enough.
    std::optional<double> at(double instant_s, double farthest_s)
    {
        while (m_next < m_all.size() && m_all[m_next].first <= instant_s)
            ++m_next;
        if (m_next == 0 || m_next == m_all.size())
            return std::nullopt;
        const auto &[from_s, one] = m_all[m_next - 1];
        const auto &[to_s, other] = m_all[m_next];
        if (to_s - from_s > farthest_s)
            return std::nullopt;
        return one + (other - one) * (instant_s - from_s) / (to_s - from_s);
    }
    double end_s() const { return m_all.empty() ? 0.0 : m_all.back().first; }

private:
    std::vector<std::pair<double, double>> m_all;
    std::size_t m_next = 0;
};

} // namespace

double Segment::angle_rad(std::size_t sample) const
{
    return (first_deg + turned_deg[sample]) * std::numbers::pi / 180.0;
}

std::vector<Segment> segmentsOf(const capture::Channel &angle,
    std::span<const capture::Channel *const> others, capture::Nanos from, capture::Nanos to)
{
    shorten(angle, from, to);
    for (const capture::Channel *channel : others)
        shorten(*channel, from, to);
    const scope::SampleRange turns(angle, from, to);
    std::vector<std::vector<double>> all;
    for (const capture::Channel *channel : others) {
        const scope::SampleRange range(*channel, from, to);
        if (range.end() - range.begin() != turns.end() - turns.begin())
            return {};
        range.visit([&values = all.emplace_back()](
                        double, double value, bool) { values.push_back(value); });
    }
    std::vector<Segment> segments;
    Segment now;
    const capture::FastColumn *ticks = angle.fast();
    const double period_s = ticks != nullptr && !ticks->empty()
        ? ticks->segments().front().base.tickNanos() / 1e9
        : 0.0;
    double before = 0.0, first_s = 0.0, last_s = 0.0;
    const auto finish = [&] {
        constexpr std::size_t kLeast = 3;
        if (now.turned_deg.size() >= kLeast) {
            now.step_s = (last_s - first_s) / static_cast<double>(now.turned_deg.size() - 1);
            now.period_s = period_s > 0.0 ? period_s : now.step_s;
            segments.push_back(std::move(now));
        }
        now = {};
        now.values.resize(others.size());
    };
    finish();
    std::size_t at = 0;
    turns.visit([&](double seconds, double value, bool joined) {
        if (!joined)
            finish();
        if (now.turned_deg.empty()) {
            first_s = seconds;
            now.first_deg = value;
            now.at = turns.toNanos(seconds);
        }
        constexpr double kTurn_deg = 360.0;
        now.turned_deg.push_back(now.turned_deg.empty()
                ? 0.0
                : now.turned_deg.back() + std::remainder(value - before, kTurn_deg));
        for (std::size_t i = 0; i < all.size(); ++i)
            now.values[i].push_back(all[i][at]);
        before = value;
        last_s = seconds;
        ++at;
    });
    finish();
    return segments;
}

std::vector<Segment> segmentsOf(const capture::Capture &capture, const std::string &angle,
    const std::vector<std::string> &others, capture::Nanos from, capture::Nanos to)
{
    const capture::Channel *turns = fastChannel(capture, angle);
    std::vector<const capture::Channel *> channels;
    channels.reserve(others.size());
    for (const std::string &name : others)
        channels.push_back(fastChannel(capture, name));
    if (turns == nullptr || std::find(channels.begin(), channels.end(), nullptr) != channels.end())
        return {};
    return segmentsOf(*turns, channels, from, to);
}

std::vector<Segment> segmentsOfReads(const capture::Channel &speed,
    std::span<const capture::Channel *const> others, capture::Nanos from, capture::Nanos to,
    double step_s, double farthest_s)
{
    constexpr double kDegPerS = 6.0; // an rpm
    constexpr std::size_t kLeast = 3;
    Reads speeds(speed, from, to);
    std::vector<Reads> all;
    constexpr double kLongest_s = 60.0; // of what moves a motor by itself; a file may say years
    double end_s = std::min(speeds.end_s(), kLongest_s);
    for (const capture::Channel *channel : others)
        end_s = std::min(end_s, all.emplace_back(*channel, from, to).end_s());
    std::vector<Segment> segments;
    Segment now;
    double before = 0.0;
    const auto finish = [&] {
        if (now.turned_deg.size() >= kLeast)
            segments.push_back(std::move(now));
        now = {};
        now.step_s = step_s;
        now.values.resize(all.size());
    };
    finish();
    std::vector<double> values(all.size());
    for (std::size_t step = 0; step <= static_cast<std::size_t>(end_s / step_s); ++step) {
        const double at_s = static_cast<double>(step) * step_s;
        const auto rpm = speeds.at(at_s, farthest_s);
        bool whole = rpm.has_value();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto value = all[i].at(at_s, farthest_s);
            whole = whole && value;
            values[i] = value.value_or(0.0);
        }
        if (!whole) {
            finish();
            continue;
        }
        if (now.turned_deg.empty())
            now.at = from + capture::toNanos(at_s);
        now.turned_deg.push_back(now.turned_deg.empty()
                ? 0.0
                : now.turned_deg.back() + (before + *rpm) / 2.0 * kDegPerS * step_s);
        for (std::size_t i = 0; i < all.size(); ++i)
            now.values[i].push_back(values[i]);
        before = *rpm;
    }
    finish();
    return segments;
}

double missingIn(const std::vector<Segment> &segments)
{
    constexpr double kRounding = 0.5; // of a sample
    double missing_s = 0.0;
    for (std::size_t at = 1; at < segments.size(); ++at) {
        const Segment &before = segments[at - 1];
        const double gap_s = capture::toSeconds(segments[at].at - before.at)
            - before.step_s * static_cast<double>(before.turned_deg.size());
        if (gap_s > kRounding * before.step_s)
            missing_s += gap_s;
    }
    return missing_s;
}

void noteGaps(std::vector<std::string> &notes, double missing_s)
{
    if (missing_s > 0.0)
        notes.push_back("samples of " + decimalText(missing_s, 2)
            + " s are missing in it: only what is without a gap counts");
}

std::vector<Segment> whileTurning(
    std::vector<Segment> segments, double least_degPerS, double edge_s)
{
    std::vector<Segment> turning;
    for (Segment &segment : segments) {
        const std::vector<int> directions = directionsOf(segment, least_degPerS, edge_s);
        const auto goesOn = [&](int direction) { return direction == directions.front(); };
        if (!directions.empty() && directions.front() != 0
            && std::all_of(directions.begin(), directions.end(), goesOn)) {
            turning.push_back(std::move(segment));
            continue;
        }
        for (auto from = directions.begin(); from != directions.end();) {
            const auto to = std::find_if(
                from, directions.end(), [from](int direction) { return direction != *from; });
            constexpr std::ptrdiff_t kLeast = 3;
            if (*from != 0 && to - from >= kLeast)
                turning.push_back(
                    pieceOf(segment, static_cast<std::size_t>(from - directions.begin()),
                        static_cast<std::size_t>(to - directions.begin())));
            from = to;
        }
    }
    return turning;
}

double seldomSeen(double turn_rad)
{
    constexpr double kLittle_rad = 0.3;
    return turn_rad > kLittle_rad ? turn_rad * turn_rad : 0.0;
}

std::string seldomSeenNote(double turn_rad)
{
    return "the rotor turns by up to " + decimalText(turn_rad * 180.0 / std::numbers::pi, 2)
        + " electrical degrees within a control period: what its current does meanwhile is not "
          "seen";
}

} // namespace lab
