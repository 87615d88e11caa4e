#include "bench/motor_data.h"

#include <algorithm>
#include <cmath>

namespace bench {

namespace {
constexpr double kTurn = 6.283185307179586;

/// A cheap hash: noise that depends on nothing but the place.
std::int32_t noise(std::uint64_t place, std::int32_t width)
{
    place *= 0x9E3779B97F4A7C15ULL;
    place ^= place >> 29;
    place *= 0xBF58476D1CE4E5B9ULL;
    return static_cast<std::int32_t>((place >> 33) % static_cast<std::uint64_t>(2 * width + 1))
        - width;
}
} // namespace

std::int16_t motorSample(int s, std::int64_t i)
{
    const double angle = double(i) * kTurn * 100.0 / kTickHz; // 100 Hz electrical
    const auto place = static_cast<std::uint64_t>(i) * kSignals + static_cast<std::uint64_t>(s);
    double value = 0;
    switch (s) {
    case 0:
    case 1:
    case 2:
        value = 9000.0 * std::sin(angle - s * kTurn / 3) + noise(place, 700);
        break;
    case 3:
        value = 8200.0 + noise(place, 500);
        break;
    case 4:
        value = -300.0 + noise(place, 500);
        break;
    case 5:
        value = 12000.0 + 2500.0 * std::sin(double(i) * kTurn / 60000.0) + noise(place, 40);
        break;
    case 6:
        value = std::fmod(double(i) * 65536.0 * 100.0 / kTickHz, 65536.0) - 32768.0;
        break;
    default:
        value = 24000.0 + noise(place, 120);
    }
    return static_cast<std::int16_t>(value);
}

std::vector<std::int16_t> motorSignal(int s, std::size_t count)
{
    std::vector<std::int16_t> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = motorSample(s, static_cast<std::int64_t>(i));
    return samples;
}

capture::StreamLayout motorLayout()
{
    capture::StreamLayout layout;
    layout.id = 1;
    layout.tickHz = kTickHz;
    for (int s = 0; s < kSignals; ++s)
        layout.fast.push_back({static_cast<catalog::RegisterId>(s + 1), "A" + std::to_string(s),
            "A", 3.3 / 65536.0 / 0.33 / 1.53, 0.0});
    return layout;
}

void recordMotor(capture::Capture &capture, std::size_t count, std::size_t batch)
{
    capture.begin(motorLayout());
    for (std::size_t done = 0; done < count; done += batch) {
        const std::size_t now = std::min(batch, count - done);
        capture::SampleBlock block{1, static_cast<capture::Tick>(done),
            static_cast<std::uint32_t>(now), std::vector<std::int16_t>(now * kSignals), {}, 0};
        for (std::size_t s = 0; s < kSignals; ++s) {
            for (std::size_t i = 0; i < now; ++i)
                block.fast[s * now + i] =
                    motorSample(static_cast<int>(s), static_cast<std::int64_t>(done + i));
        }
        capture.append(block);
    }
}

void MotorStream::record(capture::Capture &capture, std::size_t count)
{
    constexpr std::size_t kBatch = 5000;
    for (int s = 0; s < static_cast<int>(layout.fast.size()); ++s)
        m_signals.push_back(motorSignal(s, std::min(count + kBatch, kPeriod)));
    capture.begin(layout);
    for (std::size_t done = 0; done < count; done += kBatch)
        append(capture, std::min(kBatch, count - done));
}

capture::SampleBlock MotorStream::next(std::size_t count)
{
    capture::SampleBlock block{layout.id, m_ticks, static_cast<std::uint32_t>(count), {}, {}, 0};
    block.fast.reserve(count * m_signals.size());
    for (const auto &codes : m_signals) {
        auto at = static_cast<std::size_t>(m_ticks) % codes.size();
        for (std::size_t left = count; left > 0;) {
            const std::size_t part = std::min(left, codes.size() - at);
            const auto from = codes.begin() + static_cast<std::ptrdiff_t>(at);
            block.fast.insert(block.fast.end(), from, from + static_cast<std::ptrdiff_t>(part));
            left -= part;
            at = 0;
        }
    }
    m_ticks += static_cast<capture::Tick>(count);
    return block;
}

namespace {
constexpr std::size_t kSteps = std::size_t{2} * 1920; ///< of an envelope
constexpr std::int32_t kWhole = 256;
} // namespace

Ragged::Ragged(std::size_t count, Wave wave, int signalCount)
    : m_count(count)
{
    for (int s = 0; s < kSignals; ++s) {
        m_waves.push_back(motorSignal(s, wave == Wave::Motor ? MotorStream::kPeriod : 2));
        if (wave == Wave::Peaks)
            m_waves.back() = {20000, -20000};
    }
    for (int s = 0; s < signalCount; ++s) {
        std::vector<std::int32_t> envelope(kSteps);
        std::int32_t now = kWhole / 2;
        for (std::size_t step = 0; step < kSteps; ++step) {
            now += noise(step * 64 + static_cast<std::size_t>(s), kWhole / 8);
            now = std::clamp(now, kWhole / 8, kWhole);
            envelope[step] = now;
        }
        m_envelopes.push_back(std::move(envelope));
    }
}

std::int16_t Ragged::at(int signal, std::size_t index) const
{
    const auto &wave = m_waves[static_cast<std::size_t>(signal % kSignals)];
    const auto &envelope = m_envelopes[static_cast<std::size_t>(signal)];
    return static_cast<std::int16_t>(
        wave[index % wave.size()] * envelope[index * kSteps / m_count] / kWhole);
}

void Ragged::record(capture::Capture &capture, std::size_t gapEvery) const
{
    capture::StreamLayout layout = motorLayout();
    while (static_cast<int>(layout.fast.size()) < signalCount()) {
        layout.fast.push_back(layout.fast[layout.fast.size() % kSignals]);
        layout.fast.back().id = static_cast<catalog::RegisterId>(layout.fast.size());
    }
    layout.fast.resize(static_cast<std::size_t>(signalCount()));
    capture.begin(layout);
    const std::size_t batch = gapEvery != 0 ? gapEvery : 5000;
    capture::Tick tick = 0;
    for (std::size_t done = 0; done < m_count; done += batch) {
        const std::size_t now = std::min(batch, m_count - done);
        capture::SampleBlock block{1, tick, static_cast<std::uint32_t>(now), {}, {}, 0};
        block.fast.reserve(now * layout.fast.size());
        for (int s = 0; s < signalCount(); ++s)
            for (std::size_t i = 0; i < now; ++i)
                block.fast.push_back(at(s, done + i));
        tick += static_cast<capture::Tick>(now) + (gapEvery != 0 ? 1 : 0);
        capture.append(block);
    }
}

void Ragged::import(capture::Capture &capture) const
{
    const capture::StreamLayout layout = motorLayout();
    constexpr auto kStep = static_cast<capture::Nanos>(1e9 / kTickHz);
    for (int s = 0; s < signalCount(); ++s) {
        const auto id = capture.addImported("V" + std::to_string(s), "A");
        for (std::size_t i = 0; i < m_count; ++i) {
            const auto time = static_cast<capture::Nanos>(i) * kStep;
            capture.appendImported(id, time, at(s, i) * layout.fast[0].factor, time + kStep);
        }
    }
}

} // namespace bench
