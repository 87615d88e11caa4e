#include "support/wire/mcb.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace judge {

namespace {

constexpr unsigned kControl = 0x010, kStatus = 0x011, kMode = 0x014, kModeNow = 0x015,
                   kLastError = 0x00F, kCurrentQ = 0x01A, kCurrentD = 0x01B, kPosition = 0x020,
                   kVelocity = 0x021, kTorque = 0x022, kProfileFirst = 0x025, kProfileLast = 0x027,
                   kPositionNow = 0x030, kVelocityNow = 0x031, kState = 0x640,
                   kMappingFirst = 0x650, kMappingLast = 0x66F;

Sent never(Sent one, const std::string &why)
{
    one.kind = Kind::Never;
    one.why = why;
    return one;
}

} // namespace

unsigned WireMcb::checkOf(ByteView bytes)
{
    unsigned crc = 0;
    for (const std::uint8_t byte : bytes) {
        crc ^= unsigned{byte} << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc << 1 ^ ((crc & 0x8000U) != 0 ? 0x1021U : 0U)) & 0xFFFFU;
    }
    return crc;
}

std::vector<Sent> WireMcb::sent(ByteView bytes, TimePoint)
{
    Sent one;
    if (std::all_of(bytes.begin(), bytes.end(), [](auto byte) { return byte == 0xFF; })) {
        one.kind =
            Kind::LinkControl; // no frame at all: the clock only, to find the length of the slave's
        return {one};
    }
    if (bytes.size() < 12 || bytes.size() % 2 != 0 || checkOf(bytes) != 0)
        return {never(one, "a frame of a wrong length or check")};
    const auto word = [&](std::size_t i) { return unsigned{bytes[2 * i]} << 8 | bytes[2 * i + 1]; };
    const unsigned address = word(0) >> 4 & 0x7FFU, command = word(0) >> 1 & 7U;
    const bool continues = m_continues;
    m_continues = command == 2 && (word(0) & 1U) != 0;
    switch (command) {
    case 0: // who has this register, and how wide it is
        return {one};
    case 1: {
        const bool state = address == kStatus || address == kLastError || address == kModeNow
            || address == kMode || address == kPositionNow || address == kVelocityNow;
        one.kind = state ? Kind::StatusRead : Kind::Read;
        return {one};
    }
    case 2:
        if (continues)
            return {};
        return {write(address, {word(1), word(2), word(3), word(4)})};
    case 7:
        one.kind = Kind::LinkControl;
        return {one};
    default:
        return {never(one, "a frame that only a drive sends")};
    }
}

Sent WireMcb::write(unsigned address, const std::array<unsigned, 4> &words)
{
    Sent one;
    one.motor = 1;
    one.target = address << 3 | 1U;
    one.kind = Kind::Write;
    const auto real = [&] { return double{std::bit_cast<float>(words[1] << 16 | words[0])}; };
    if (address == kState || (address >= kMappingFirst && address <= kMappingLast)) {
        // A drive that is found with long frames is brought back to those in which it can be asked.
        const bool back = address == kState && words[0] == 1;
        one.kind = back ? Kind::LinkControl : Kind::StreamSetup;
    } else if (address == kControl) {
        one.value = words[0];
        const unsigned low = words[0] & 0xFFU;
        if ((low & 0x80U) != 0)
            one.kind = Kind::Acknowledge;
        else if (low == 0x06 || low == 0x02 || (low & 0x02U) == 0)
            one.kind = Kind::Stop; // shutdown, quick stop, disable voltage
        else
            one.kind = Kind::Start; // switch on, enable
    } else if (address == kMode || (address >= kProfileFirst && address <= kProfileLast)) {
        one.kind = Kind::Mode; // goes before a set-point
    } else if (address == kVelocity) {
        one.kind = Kind::SetPoint;
        one.rpm = 60.0 * real();
    } else if (address == kCurrentQ || address == kCurrentD) {
        one.kind = Kind::SetPoint;
        one.amps = real();
    } else if (address == kPosition || address == kTorque) {
        one.kind = Kind::SetPoint;
    }
    return one;
}

} // namespace judge
