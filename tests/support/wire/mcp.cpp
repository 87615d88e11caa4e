#include "support/wire/mcp.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace judge {

namespace {

std::uint32_t little(ByteView bytes, std::size_t at, std::size_t width)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
        value |= std::uint32_t{bytes[at + i]} << 8 * i;
    return value;
}

std::int16_t signed16(ByteView bytes, std::size_t at)
{
    return static_cast<std::int16_t>(little(bytes, at, 2));
}
std::int32_t signed32(ByteView bytes, std::size_t at)
{
    return static_cast<std::int32_t>(little(bytes, at, 4));
}

Sent never(const std::string &why)
{
    Sent sent;
    sent.kind = Kind::Never;
    sent.why = why;
    return sent;
}

// Registers without their motor: element << 6 | type << 3.
// How many motors there are is asked for during a Stop, too: to stop them all.
constexpr unsigned kGlobalConfig = 5U << 3, kStatus = 1U << 6 | 1U << 3, kMode = 2U << 6 | 1U << 3,
                   kFaults = 3U << 3, kSpeedMeas = 1U << 6 | 3U << 3,
                   kHsoSpeedMeas = 38U << 6 | 3U << 3, kSpeedRef = 2U << 6 | 3U << 3,
                   kSpeedRamp = 6U << 6 | 5U << 3, kTorqueRamp = 7U << 6 | 5U << 3,
                   kCurrentRef = 13U << 6 | 5U << 3, kPositionRamp = 14U << 6 | 5U << 3,
                   kIqRef = 37U << 6 | 2U << 3, kIdRef = 38U << 6 | 2U << 3;

bool isDatalog(unsigned id)
{
    const unsigned element = id >> 6;
    return (id >> 3 & 7U) == 5 && element >= 20 && element <= 22;
}

} // namespace

unsigned WireMcp::checkOf(std::uint32_t header)
{
    unsigned crc = 0;
    for (unsigned nibble = 0; nibble < 7; ++nibble) {
        crc ^= header >> 4 * nibble & 15U;
        for (int bit = 0; bit < 4; ++bit)
            crc = (crc << 1 ^ ((crc & 8U) != 0 ? 7U : 0U)) & 15U;
    }
    return crc;
}

void WireMcp::reset()
{
    m_header.clear();
    m_payload.clear();
    m_tail.clear();
    m_wanted = 0;
    m_gap.reset();
}

std::vector<Sent> WireMcp::sent(ByteView bytes, TimePoint at)
{
    std::vector<Sent> all;
    // A blind stop drops what has not left yet, also a payload whose header has; it begins with a Beacon or a Ping, and
    // no request begins like them: its motor would be 5 or 6.
    if (const std::uint32_t word = little(bytes, 0, 4); m_wanted > 0 && m_payload.empty()
        && bytes.size() == 4 && (word % 16 == 5 || word % 16 == 6) && checkOf(word) == word >> 28)
        m_wanted = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        const TimePoint begins = at + wireTime(i, m_baud);
        if (m_wanted == 0) {
            m_header.push_back(bytes[i]);
            if (m_header.size() == 4)
                header(all, begins + wireTime(1, m_baud));
            continue;
        }
        if (m_payload.empty())
            m_gap = begins - m_headerEnd;
        m_payload.push_back(bytes[i]);
        if (m_payload.size() < m_wanted)
            continue;
        for (Sent &one : request())
            all.push_back(std::move(one));
        m_payload.clear();
        m_wanted = 0;
    }
    return all;
}

void WireMcp::header(std::vector<Sent> &all, TimePoint at)
{
    const std::uint32_t word = little(m_header, 0, 4);
    m_header.clear();
    m_headerEnd = at;
    if (checkOf(word) != word >> 28)
        return all.push_back(never("a header with a wrong check"));
    Sent link;
    link.kind = Kind::LinkControl;
    switch (word & 15U) {
    case 5:
    case 6:
        return all.push_back(link);
    case 9:
        m_wanted = word >> 4 & 0x1FFFU;
        if (m_wanted == 0)
            all.push_back(never("an empty request, which repeats the one before"));
        return;
    default:
        all.push_back(never("a packet that is no business of a client"));
    }
}

std::vector<Sent> WireMcp::request() const
{
    if (m_payload.size() < 2)
        return {never("a request of one byte")};
    const unsigned word = little(m_payload, 0, 2);
    const unsigned command = word >> 3;
    Sent one;
    one.motor = static_cast<int>(word & 7U);
    switch (command) {
    case 0:
        return {one};
    case 1:
        return writes();
    case 2:
        return reads();
    case 3:
        one.kind = Kind::Start;
        return {one};
    case 4:
        one.kind = Kind::Stop;
        return {one};
    case 5:
        one.kind = Kind::StopRamp;
        return {one};
    case 6:
        return {never("START_STOP, a toggle")};
    case 7:
        one.kind = Kind::Acknowledge;
        return {one};
    case 33: // the second user command
        one.kind = Kind::Heartbeat;
        return {one};
    default:
        return {never("command " + std::to_string(command))};
    }
}

std::vector<Sent> WireMcp::reads() const
{
    if (m_payload.size() % 2 != 0)
        return {never("a GET of odd length")};
    Sent one;
    one.kind = Kind::StatusRead;
    for (std::size_t at = 2; at < m_payload.size(); at += 2) {
        const unsigned bare = little(m_payload, at, 2) & ~7U;
        constexpr std::array kStates{
            kStatus, kMode, kFaults, kSpeedMeas, kHsoSpeedMeas, kGlobalConfig};
        if (std::find(kStates.begin(), kStates.end(), bare) == kStates.end())
            one.kind = Kind::Read;
    }
    return {one};
}

std::vector<Sent> WireMcp::writes() const
{
    std::vector<Sent> all;
    const ByteView bytes(m_payload);
    for (std::size_t at = 2; at < bytes.size();) {
        if (at + 2 > bytes.size())
            return {never("a SET that ends within an identifier")};
        const auto id = static_cast<std::uint16_t>(little(bytes, at, 2));
        at += 2;
        const unsigned type = id >> 3 & 7U;
        std::size_t width = type == 1 ? 1 : type == 2 ? 2 : type == 3 ? 4 : 0;
        if (type == 5) {
            width = little(bytes, at, 2);
            at += 2;
        } else if (type == 4) {
            while (at + width < bytes.size() && bytes[at + width] != 0)
                ++width;
            ++width;
        }
        if (width == 0 || at + width > bytes.size())
            return {never("a SET without its value")};
        all.push_back(writeOf(id, bytes.subspan(at, width)));
        all.back().firstOfPacket = all.size() == 1;
        at += width;
    }
    if (all.empty())
        all.push_back(never("a SET of nothing"));
    return all;
}

Sent WireMcp::writeOf(std::uint16_t id, ByteView value) const
{
    Sent one;
    one.kind = Kind::Write;
    one.motor = id & 7;
    one.target = id;
    const unsigned bare = id & ~7U, type = id >> 3 & 7U;
    if (isDatalog(id)) {
        one.kind = Kind::StreamSetup;
        return one;
    }
    if (type <= 3)
        one.value = little(value, 0, value.size());
    const auto amps = [&](double digits) {
        return m_ampsPerDigit > 0.0 ? std::optional<double>(digits * m_ampsPerDigit) : std::nullopt;
    };
    if (bare == kMode) {
        one.kind = Kind::Mode;
    } else if (bare == kSpeedRef || bare == kSpeedRamp) {
        one.kind = Kind::SetPoint;
        one.rpm = signed32(value, 0);
    } else if (bare == kTorqueRamp) {
        one.kind = Kind::SetPoint;
        one.amps = amps(signed32(value, 0));
    } else if (bare == kIqRef || bare == kIdRef) {
        one.kind = Kind::SetPoint;
        one.amps = amps(signed16(value, 0));
    } else if (bare == kCurrentRef) {
        one.kind = Kind::SetPoint;
        one.amps = amps(std::hypot(signed16(value, 0), signed16(value, 2)));
    } else if (bare == kPositionRamp) {
        one.kind = Kind::SetPoint;
        const auto angle = std::bit_cast<float>(little(value, 0, 4));
        const auto time = std::bit_cast<float>(little(value, 4, 4));
        if (!std::isfinite(angle) || !std::isfinite(time))
            return never("a position that is no number");
    }
    return one;
}

bool WireMcp::heard(ByteView bytes)
{
    m_tail.insert(m_tail.end(), bytes.begin(), bytes.end());
    bool answer = false;
    for (std::size_t at = 0; at + 4 <= m_tail.size(); ++at) {
        const std::uint32_t word = little(m_tail, at, 4);
        const unsigned type = word & 15U;
        answer = answer || ((type == 10 || type == 15) && checkOf(word) == word >> 28);
    }
    if (m_tail.size() > 3)
        m_tail.erase(m_tail.begin(), m_tail.end() - 3);
    return answer;
}

} // namespace judge
