// Channels recorded from a formula, for tests that know what a measurement must say.
#pragma once

#include "capture/channel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace support {

constexpr double kRate = 16000.0; ///< samples a second
constexpr double kCode = 0.001; ///< of the channel's unit: what a code is worth
constexpr capture::Nanos kSecond = 1'000'000'000;
constexpr double kTurn = 2.0 * std::numbers::pi; ///< rad

/// A fast channel of `count` samples of f(seconds), rounded to codes; `noise` is the deviation of Gaussian noise.
template <class Formula>
capture::Channel fastChannel(std::size_t count, Formula f, double noise = 0.0,
    std::uint32_t seed = 1, double rate = kRate, capture::Tick firstTick = 0)
{
    capture::Channel channel({seed, 7, "F", "A", kCode, 0.0, capture::ChannelInfo::Kind::Fast});
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss(0.0, 1.0);
    std::vector<std::int16_t> codes;
    for (std::size_t i = 0; i < count; ++i) {
        const double seconds = static_cast<double>(firstTick + capture::Tick(i)) / rate;
        const double value = f(seconds) + noise * gauss(random);
        codes.push_back(
            static_cast<std::int16_t>(std::clamp(std::round(value / kCode), -32768.0, 32767.0)));
    }
    channel.fast()->append(capture::TickBase::of(rate, 0.0), firstTick, 1, codes);
    return channel;
}

/// The same as values that hold.
template <class Formula>
capture::Channel slowChannel(std::size_t count, Formula f, double rate = kRate)
{
    capture::Channel channel({1, 7, "S", "A", 1.0, 0.0, capture::ChannelInfo::Kind::Slow});
    const capture::TickBase base = capture::TickBase::of(rate, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
        const auto tick = static_cast<capture::Tick>(i);
        channel.values()->append(
            base.timeOf(tick), f(static_cast<double>(i) / rate), base.timeOf(tick + 1));
    }
    return channel;
}

} // namespace support
