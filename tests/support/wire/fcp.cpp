#include "support/wire/fcp.h"

#include <cmath>
#include <numeric>

namespace judge {

namespace {

std::int32_t littleSigned(ByteView bytes, std::size_t at, std::size_t width)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
        value |= std::uint32_t{bytes[at + i]} << 8 * i;
    if (width == 2)
        return static_cast<std::int16_t>(value);
    return static_cast<std::int32_t>(value);
}

Sent never(Sent one, const std::string &why)
{
    one.kind = Kind::Never;
    one.why = why;
    return one;
}

constexpr unsigned kFlags = 0x01, kStatus = 0x02, kMode = 0x03, kSpeedMeas = 0x1E,
                   kTorqueRef = 0x08, kFluxRef = 0x0C, kRevUp = 0x100;

} // namespace

std::vector<Sent> WireFcp::sent(ByteView bytes, TimePoint)
{
    std::vector<Sent> all;
    // A lone byte of ones fills up a frame that hangs half received in the board.
    if (m_frame.empty() && bytes.size() == 1 && bytes.front() == 0xFF) {
        all.emplace_back();
        all.back().kind = Kind::LinkControl;
        return all;
    }
    for (const std::uint8_t byte : bytes) {
        m_frame.push_back(byte);
        if (m_frame.size() < 2 || m_frame.size() < m_frame[1] + std::size_t{3})
            continue;
        for (Sent &one : frame())
            all.push_back(std::move(one));
        m_frame.clear();
    }
    return all;
}

std::vector<Sent> WireFcp::frame() const
{
    Sent one;
    one.motor = m_frame[0] >> 5;
    const unsigned sum = std::accumulate(m_frame.begin(), m_frame.end() - 1, 0U);
    if ((((sum >> 8) + sum) & 0xFFU) != m_frame.back())
        return {never(one, "a frame with a wrong check")};
    const ByteView payload = ByteView(m_frame).subspan(2, m_frame[1]);
    const auto needs = [&](std::size_t size) { return payload.size() == size; };
    const auto amps = [&](double digits) {
        return m_ampsPerDigit > 0.0 ? std::optional<double>(digits * m_ampsPerDigit) : std::nullopt;
    };
    switch (m_frame[0] & 0x1FU) {
    case 0x01:
        if (payload.size() < 2)
            return {never(one, "a SET without its value")};
        return {write(one)};
    case 0x02: {
        const unsigned id = payload.empty() ? 0 : payload[0];
        const bool state = id == kFlags || id == kStatus || id == kMode || id == kSpeedMeas;
        one.kind = state ? Kind::StatusRead : Kind::Read;
        return {one};
    }
    case 0x03:
        return {needs(1) ? command(one, payload[0]) : never(one, "a command without its number")};
    case 0x06:
        one.kind = Kind::LinkControl;
        return {one};
    case 0x08:
    case 0x0B:
    case 0x0C:
        return {one};
    case 0x07:
        one.kind = Kind::SetPoint;
        one.rpm = littleSigned(payload, 0, 4);
        return {needs(6) ? one : never(one, "a ramp of a wrong length")};
    case 0x09:
        one.kind = Kind::Write;
        one.target = kRevUp << 3 | static_cast<unsigned>(one.motor);
        return {one};
    case 0x0A:
        one.kind = Kind::SetPoint;
        one.amps = amps(std::hypot(littleSigned(payload, 0, 2), littleSigned(payload, 2, 2)));
        return {needs(4) ? one : never(one, "currents of a wrong length")};
    case 0x0D:
        one.kind = Kind::SetPoint;
        one.amps = amps(littleSigned(payload, 0, 4));
        return {needs(6) ? one : never(one, "a ramp of a wrong length")};
    default:
        return {never(one, "a frame of a kind that nobody offers")};
    }
}

Sent WireFcp::command(Sent one, unsigned number) const
{
    switch (number) {
    case 1:
        one.kind = Kind::Start;
        return one;
    case 2:
        one.kind = Kind::Stop;
        return one;
    case 3:
        one.kind = Kind::StopRamp;
        return one;
    case 5:
        one.kind = Kind::LinkControl;
        return one;
    case 7:
        one.kind = Kind::Acknowledge;
        return one;
    default:
        return never(one, "command " + std::to_string(number));
    }
}

Sent WireFcp::write(Sent one) const
{
    const unsigned id = m_frame[2];
    const ByteView value = ByteView(m_frame).subspan(3, m_frame[1] - 1U);
    one.kind = Kind::Write;
    one.target = id << 3 | static_cast<unsigned>(one.motor);
    one.value = littleSigned(value, 0, value.size());
    if (one.motor == 0)
        return never(one, "a SET without a motor goes to the one that was meant last");
    if (id == kMode)
        one.kind = Kind::Mode;
    if (id == kTorqueRef || id == kFluxRef) {
        one.kind = Kind::SetPoint;
        if (m_ampsPerDigit > 0.0)
            one.amps = littleSigned(value, 0, 2) * m_ampsPerDigit;
    }
    return one;
}

} // namespace judge
