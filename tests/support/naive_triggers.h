// Trigger times the slow way, for comparison: each sample is asked whether it fires by walking back from it through
// the list, with no state carried along. Written from the words of core/scope/trigger_condition.h, not from its code.
#pragma once

#include "scope/trigger_condition.h"
#include "support/channels/noisy_channel.h"

#include <algorithm>
#include <functional>

namespace support {

/// A candidate: time, and the sample that made it.
struct Candidate {
    capture::Nanos time = 0;
    std::size_t sample = 0;
};

class NaiveTriggers {
public:
    NaiveTriggers(std::vector<PlainSample> samples, scope::TriggerCondition condition)
        : m_s(std::move(samples))
        , m_condition(condition)
    {
        for (std::size_t i = 0; i < m_s.size(); ++i) {
            const bool wrapped = i > 0 && m_condition.turn > 0
                && std::abs(m_s[i].value - m_s[i - 1].value) > m_condition.turn / 2;
            m_joined.push_back(!m_s[i].first && !wrapped);
        }
    }

    /// Hits that keep `holdOff` between them.
    std::vector<capture::Nanos> hits(capture::Nanos holdOff) const
    {
        std::vector<capture::Nanos> result;
        for (const Candidate &one :
            std::visit([this](const auto &what) { return find(what); }, m_condition.what)) {
            if (result.empty() || one.time >= result.back() + holdOff)
                result.push_back(one.time);
        }
        return result;
    }

private:
    using Test = std::function<bool(double)>;

    capture::Nanos crossed(std::size_t i, double level) const
    {
        if (m_condition.between == scope::Between::Hold)
            return m_s[i].time;
        const double share = (level - m_s[i - 1].value) / (m_s[i].value - m_s[i - 1].value);
        return m_s[i - 1].time
            + std::llround(std::clamp(share, 0.0, 1.0) * double(m_s[i].time - m_s[i - 1].time));
    }

    /// Sample i is `there`, and walking back from it an `armed` one comes before another that is `there`.
    bool comes(std::size_t i, const Test &there, const Test &armed) const
    {
        if (!there(m_s[i].value))
            return false;
        while (m_joined[i]) {
            --i;
            if (armed(m_s[i].value))
                return true;
            if (there(m_s[i].value))
                return false;
        }
        return false;
    }
    bool rises(std::size_t i, double level, double hysteresis) const
    {
        return comes(
            i, [=](double v) { return v >= level; },
            [=](double v) { return v < level - hysteresis; });
    }
    bool falls(std::size_t i, double level, double hysteresis) const
    {
        return comes(
            i, [=](double v) { return v <= level; },
            [=](double v) { return v > level + hysteresis; });
    }
    std::size_t startOf(std::size_t i) const
    {
        while (!m_s[i].first)
            --i;
        return i;
    }

    std::vector<Candidate> find(const scope::EdgeTrigger &t) const
    {
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < m_s.size(); ++i) {
            if ((t.slope != scope::Slope::Falling && rises(i, t.level, t.hysteresis))
                || (t.slope != scope::Slope::Rising && falls(i, t.level, t.hysteresis)))
                result.push_back({crossed(i, t.level), i});
        }
        return result;
    }

    std::vector<Candidate> find(const scope::LevelTrigger &t) const
    {
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < m_s.size(); ++i) {
            const bool above = t.side == scope::LevelTrigger::Side::AtOrAbove;
            if (above ? m_s[i].value >= t.level : m_s[i].value <= t.level)
                result.push_back({m_s[i].time, i});
        }
        return result;
    }

    std::vector<Candidate> find(const scope::WindowTrigger &t) const
    {
        const Test outside = [&](double v) { return v < t.low || v > t.high; };
        const Test inside = [&](double v) { return !outside(v); };
        const Test deep = [&](double v) {
            return v >= t.low + t.hysteresis && v <= t.high - t.hysteresis;
        };
        const Test far = [&](double v) {
            return v < t.low - t.hysteresis || v > t.high + t.hysteresis;
        };
        const bool leaves = t.when == scope::WindowTrigger::When::Leaves;
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < m_s.size(); ++i) {
            if (leaves ? comes(i, outside, deep) : comes(i, inside, far)) {
                const double out = m_s[leaves ? i : i - 1].value;
                result.push_back({crossed(i, out > t.high ? t.high : t.low), i});
            }
        }
        return result;
    }

    std::vector<Candidate> find(const scope::PulseTrigger &t) const
    {
        const bool positive = t.polarity == scope::PulseTrigger::Polarity::Positive;
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < m_s.size(); ++i) {
            const auto ends = [&](std::size_t k) {
                return positive ? falls(k, t.level, t.hysteresis) : rises(k, t.level, t.hysteresis);
            };
            const auto begins = [&](std::size_t k) {
                return positive ? rises(k, t.level, t.hysteresis) : falls(k, t.level, t.hysteresis);
            };
            if (!ends(i))
                continue;
            for (std::size_t k = i; !m_s[k].first;) {
                --k;
                if (ends(k))
                    break;
                if (begins(k)) {
                    if (t.width.holds(crossed(i, t.level) - crossed(k, t.level)))
                        result.push_back({crossed(i, t.level), i});
                    break;
                }
            }
        }
        return result;
    }

    /// Walks back from an arrival to where the way began; 0 is never a start, for the first sample crosses nothing.
    std::size_t startOfSlew(std::size_t i, const Test &arrived, const Test &back,
        const std::function<bool(std::size_t)> &begins) const
    {
        for (std::size_t k = i;; --k) {
            if (k != i && (arrived(m_s[k].value) || back(m_s[k].value)))
                return 0;
            if (begins(k))
                return k;
            if (!m_joined[k])
                return 0;
        }
    }
    std::vector<Candidate> find(const scope::SlewTrigger &t) const
    {
        const Test high = [&](double v) { return v >= t.high; };
        const Test low = [&](double v) { return v <= t.low; };
        const Test under = [&](double v) { return v < t.low - t.hysteresis; };
        const Test over = [&](double v) { return v > t.high + t.hysteresis; };
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < m_s.size(); ++i) {
            if (t.slope != scope::Slope::Falling && high(m_s[i].value)) {
                const std::size_t k = startOfSlew(
                    i, high, under, [&](std::size_t n) { return rises(n, t.low, t.hysteresis); });
                if (k != 0 && t.time.holds(crossed(i, t.high) - crossed(k, t.low)))
                    result.push_back({crossed(i, t.high), i});
            }
            if (t.slope != scope::Slope::Rising && low(m_s[i].value)) {
                const std::size_t k = startOfSlew(
                    i, low, over, [&](std::size_t n) { return falls(n, t.high, t.hysteresis); });
                if (k != 0 && t.time.holds(crossed(i, t.low) - crossed(k, t.high)))
                    result.push_back({crossed(i, t.low), i});
            }
        }
        return result;
    }

    std::vector<Candidate> find(const scope::DropoutTrigger &t) const
    {
        const std::vector<Candidate> edges = find(t.edge);
        std::vector<Candidate> result;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const capture::Nanos due = edges[e].time + t.time;
            std::size_t i = edges[e].sample + 1;
            while (i < m_s.size() && !m_s[i].first && m_s[i].time < due)
                ++i;
            const bool late = i < m_s.size() && !m_s[i].first;
            const bool saved = e + 1 < edges.size()
                && (edges[e + 1].sample < i
                    || (edges[e + 1].sample == i && edges[e + 1].time < due));
            if (late && !saved)
                result.push_back({due, i});
        }
        return result;
    }

    std::vector<Candidate> find(const scope::NthEdgeTrigger &t) const
    {
        const std::vector<Candidate> edges = find(t.edge);
        std::vector<Candidate> result;
        std::size_t begin = 0;
        while (begin < edges.size()) { // one unbroken run at a time
            std::size_t end = begin;
            while (end < edges.size() && startOf(edges[end].sample) == startOf(edges[begin].sample))
                ++end;
            if (t.idle == 0) {
                for (std::size_t e = begin + t.count - 1; e < end; e += t.count)
                    result.push_back(edges[e]);
            } else {
                capture::Nanos before = m_s[startOf(edges[begin].sample)].time;
                for (std::size_t e = begin; e < end; before = edges[e].time, ++e) {
                    if (edges[e].time - before < t.idle)
                        continue;
                    std::size_t last = e; // the burst that begins here
                    while (last + 1 < end && edges[last + 1].time - edges[last].time < t.idle)
                        ++last;
                    if (e + t.count - 1 <= last)
                        result.push_back(edges[e + t.count - 1]);
                }
            }
            begin = end;
        }
        return result;
    }

    std::vector<Candidate> find(const scope::EventTrigger & /*event*/) const { return {}; }

    std::vector<PlainSample> m_s;
    std::vector<bool> m_joined; ///< the sample follows the one before it
    scope::TriggerCondition m_condition;
};

} // namespace support
