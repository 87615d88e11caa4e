// A recorded channel with noise, quiet stretches, spikes and gaps, and the same samples as a plain list, for tests
// that compare the scope's fast answers with naive ones. The same seed gives the same samples.
#pragma once

#include "capture/capture.h"

#include <cmath>
#include <random>

namespace support {

struct PlainSample {
    capture::Nanos time = 0;
    double value = 0.0;
    bool first = false; ///< nothing is known right before it
};

/// What is to be recorded, block by block; record() appends the next block.
class NoisyChannel {
public:
    enum class Kind { Fast, Polled };
    enum class Shape { Wave, Angle };

    NoisyChannel(std::uint32_t seed, Kind kind, Shape shape, std::size_t count)
        : m_random(seed)
        , m_kind(kind)
        , m_shape(shape)
        , m_factor(m_random() % 2 == 0 ? 0.01 : -0.02)
    {
        const double noise = static_cast<double>(m_random() % 400);
        const double period = 20.0 + static_cast<double>(m_random() % 3000);
        while (m_codes.size() < count)
            addStretch(noise, period);
        if (kind == Kind::Fast) {
            capture::StreamLayout layout;
            layout.id = 1;
            layout.tickHz = 16000;
            layout.fast.push_back({7, "F", "A", m_factor, 3.0});
            store.begin(layout);
        }
    }

    bool done() const { return m_next == m_codes.size(); }

    /// The next block of at most `most` samples; a gap is never inside a block.
    void record(std::size_t most)
    {
        std::size_t count = 1;
        while (count < most && m_next + count < m_codes.size() && m_gaps[m_next + count] == 0)
            ++count;
        m_tick += m_gaps[m_next];
        capture::SampleBlock block;
        block.stream = 1;
        block.firstTick = m_tick;
        block.count = static_cast<std::uint32_t>(count);
        block.lostTicks = m_gaps[m_next];
        for (std::size_t i = 0; i < count; ++i) {
            block.fast.push_back(m_codes[m_next + i]);
            if (m_kind == Kind::Polled)
                poll(m_tick + static_cast<capture::Tick>(i), m_gaps[m_next + i] > 0);
        }
        m_next += count;
        m_tick += static_cast<capture::Tick>(count);
        if (m_kind == Kind::Fast)
            store.append(block);
    }

    const capture::Channel *channel() const
    {
        const auto id = store.find(7);
        return id ? store.channel(*id) : nullptr;
    }

    /// Everything that has been recorded.
    std::vector<PlainSample> plain() const
    {
        std::vector<PlainSample> result;
        const capture::Channel &all = *channel();
        std::size_t i = 0;
        for (capture::Index at = all.begin(); at < all.end(); ++at, ++i) {
            const double shown =
                m_kind == Kind::Fast ? (m_codes[i] + 3.0) * m_factor : m_codes[i] * 0.01;
            result.push_back({all.timeOf(at), shown, i == 0 || m_gaps[i] > 0});
        }
        return result;
    }

    capture::Capture store;

private:
    void addStretch(double noise, double period)
    {
        const auto what = m_random() % 5; // 0: quiet, 1: steps, else wave or angle
        const std::size_t length = 1 + m_random() % (what == 1 ? 4000 : 1500);
        double plateau = 0.0;
        const bool spikes = m_random() % 3 == 0;
        if (m_random() % 3 == 0 && !m_codes.empty())
            m_gaps.push_back(1 + static_cast<capture::Tick>(m_random() % 300));
        for (std::size_t i = 0; i < length; ++i) {
            const double phase = static_cast<double>(m_codes.size()) / period;
            double value = (static_cast<double>(m_random() % 2001) / 1000.0 - 1.0) * noise;
            // Where the store's blocks begin, so that a step may lie between two of them.
            if (what == 1) {
                if (i == 0 || m_codes.size() % 128 == 0)
                    plateau = (static_cast<double>(m_random() % 7) - 3.0) * 3000.0;
                value = plateau + value / 100.0;
            } else if (m_shape == Shape::Angle)
                value = (phase - std::floor(phase) - 0.5) * 65000.0 + value / 2;
            else if (what != 0)
                value += std::sin(phase * 6.2831853) * 9000.0;
            else
                value = 400.0 + value / 200.0;
            if (spikes && m_random() % 200 == 0)
                value = -value * 2;
            m_codes.push_back(static_cast<std::int16_t>(std::clamp(value, -32768.0, 32767.0)));
            if (m_gaps.size() < m_codes.size())
                m_gaps.push_back(0);
        }
    }

    void poll(capture::Tick tick, bool gap)
    {
        if (gap)
            store.endPolled(7);
        store.appendPolled(7, "P", "A", static_cast<double>(tick) * 0.013,
            m_codes[m_next + static_cast<std::size_t>(tick - m_tick)] * 0.01);
    }

    std::mt19937 m_random;
    Kind m_kind;
    Shape m_shape;
    double m_factor;
    std::vector<std::int16_t> m_codes;
    std::vector<capture::Tick> m_gaps; ///< ticks that are missing before that sample
    std::size_t m_next = 0;
    capture::Tick m_tick = 0;
};

} // namespace support
