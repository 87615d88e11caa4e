// A protocol of the tests alone, as small as one can be, and a board that speaks it.
//
// Each way a frame of five bytes: kind ('R' read, 'W' write, 'N' no), register, value (16 bits), sum of the four.
// The answer has the kind and the register of its request.
#pragma once

#include "base/bytes.h"
#include "simulation/device.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace support::toy {

using namespace std::chrono_literals;

enum Address : std::uint8_t { State, Speed, MaxSpeed, Target, Gain, Control, Registers };
enum Order : std::int16_t { Stop, Start, Acknowledge };
enum Standing : std::int16_t { Idle, Running, Stopping, Fault };

struct Frame {
    char kind = 'R';
    std::uint8_t address = 0;
    std::int16_t value = 0;
};

constexpr Frame kStop{'W', Control, Stop};

inline Bytes encode(const Frame &frame)
{
    Bytes bytes = ByteWriter()
                      .u8(static_cast<std::uint8_t>(frame.kind))
                      .u8(frame.address)
                      .s16(frame.value)
                      .take();
    bytes.push_back(static_cast<std::uint8_t>(bytes[0] + bytes[1] + bytes[2] + bytes[3]));
    return bytes;
}

/// Takes the next frame out of what came; bytes before it are passed over.
inline std::optional<Frame> nextFrame(Bytes &bytes)
{
    for (; bytes.size() >= 5; bytes.erase(bytes.begin())) {
        ByteReader reader(bytes);
        const auto kind = static_cast<char>(reader.u8());
        const auto address = static_cast<std::uint8_t>(reader.u8());
        const Frame frame{kind, address, static_cast<std::int16_t>(reader.s16())};
        if (encode(frame).back() != bytes[4])
            continue;
        bytes.erase(bytes.begin(), bytes.begin() + 5);
        return frame;
    }
    return std::nullopt;
}

/// The board: a motor that follows its target by 50 rpm a millisecond while it runs.
class Board : public simulation::ByteDevice {
public:
    void receive(ByteView bytes, TimePoint now) override
    {
        advance(now);
        m_in.insert(m_in.end(), bytes.begin(), bytes.end());
        while (const auto frame = nextFrame(m_in)) {
            const bool writes = frame->kind == 'W';
            const bool known = frame->address < Registers && (!writes || frame->address >= Target);
            if (known && writes)
                obey(*frame);
            const Bytes answer = encode({known ? frame->kind : 'N', frame->address,
                known ? m_values.at(frame->address) : std::int16_t{}});
            m_out.insert(m_out.end(), answer.begin(), answer.end());
        }
    }
    void advance(TimePoint now) override
    {
        for (; m_now + 1ms <= now; m_now += 1ms) {
            const int wanted = m_values[State] == Running ? m_values[Target] : 0;
            m_values[Speed] = static_cast<std::int16_t>(
                m_values[Speed] + std::clamp(wanted - m_values[Speed], -50, 50));
            if (m_values[State] == Stopping && m_values[Speed] == 0)
                m_values[State] = Idle;
        }
    }
    Bytes takeOutput() override { return std::exchange(m_out, {}); }
    TimePoint nextWake() const override { return m_now + 1ms; }

private:
    void obey(const Frame &frame)
    {
        m_values.at(frame.address) = frame.value;
        if (frame.address == Control)
            m_values[State] = frame.value == toy::Start ? Running
                : m_values[Speed]                       ? Stopping
                                                        : Idle;
    }

    std::array<std::int16_t, Registers> m_values{Idle, 0, 3000, 500, 100, 0};
    TimePoint m_now{};
    Bytes m_in, m_out;
};

} // namespace support::toy
