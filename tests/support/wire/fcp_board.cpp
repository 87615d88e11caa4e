#include "support/wire/fcp_board.h"

#include <array>

namespace judge {

namespace {

constexpr std::array kRegisters = std::to_array<FcpRegister>({{"SPEED_REF", 0x04},
    {"SPEED_KP", 0x05}, {"SPEED_KI", 0x06}, {"SPEED_KD", 0x07}, {"TORQUE_REF", 0x08, true, false},
    {"TORQUE_KP", 0x09}, {"TORQUE_KI", 0x0A}, {"TORQUE_KD", 0x0B}, {"FLUX_REF", 0x0C, true, false},
    {"FLUX_KP", 0x0D}, {"FLUX_KI", 0x0E}, {"FLUX_KD", 0x0F}, {"OBSERVER_C1", 0x10},
    {"OBSERVER_C2", 0x11}, {"PLL_KI", 0x14}, {"PLL_KP", 0x15}, {"FLUXWK_KP", 0x16},
    {"FLUXWK_KI", 0x17}, {"BUS_VOLTAGE", 0x19, false}, {"HEATS_TEMP", 0x1A}, {"MOTOR_POWER", 0x1B},
    {"SPEED_MEAS", 0x1E}, {"TORQUE_MEAS", 0x1F, true, false}, {"FLUX_MEAS", 0x20, true, false}});

constexpr unsigned kRead = 0x02, kAck = 0xF0;

double numberOf(ByteView value, bool isSigned)
{
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < value.size(); ++i)
        bits |= std::uint64_t{value[i]} << 8 * i;
    const std::uint64_t over = std::uint64_t{1} << 8 * value.size();
    const bool below = isSigned && bits >= over / 2;
    return static_cast<double>(bits) - (below ? static_cast<double>(over) : 0.0);
}

} // namespace

const FcpRegister *findFcpRegister(std::string_view name)
{
    for (const FcpRegister &known : kRegisters)
        if (known.name == name)
            return &known;
    return nullptr;
}

bool FcpBoard::Frame::accept(std::uint8_t byte, bool arrived)
{
    bytes.push_back(byte);
    arrives = arrives && arrived;
    return bytes.size() >= 2 && bytes.size() == bytes[1] + std::size_t{3};
}

void FcpBoard::reset()
{
    m_asked.clear();
    m_said.clear();
    m_due.reset();
}

void FcpBoard::asks(ByteView bytes, bool arrives)
{
    if (m_asked.bytes.empty() && bytes.size() == 1)
        return; // a lone byte of ones, which fills up a frame that hangs half received in the board
    for (const std::uint8_t byte : bytes) {
        if (!m_asked.accept(byte, arrives))
            continue;
        const Bytes &frame = m_asked.bytes;
        m_due.reset();
        if (m_asked.arrives && (frame[0] & 0x1FU) == kRead && frame[1] == 1)
            m_due = static_cast<std::uint16_t>(frame[2] << 3 | frame[0] >> 5);
        m_asked.clear();
    }
}

void FcpBoard::says(ByteView bytes, TimePoint at, bool arrives)
{
    for (const std::uint8_t byte : bytes) {
        if (!m_said.accept(byte, arrives))
            continue;
        const Bytes &frame = m_said.bytes;
        if (m_said.arrives && m_due && frame[0] == kAck && frame[1] > 0 && frame[1] <= 4)
            for (const FcpRegister &known : kRegisters)
                if (known.number == *m_due >> 3)
                    m_given.add(
                        *m_due, numberOf(ByteView(frame).subspan(2, frame[1]), known.isSigned), at);
        m_due.reset();
        m_said.clear();
    }
    m_given.forgetOld(at);
}

} // namespace judge
