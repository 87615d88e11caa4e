#include "support/wire/mcp_board.h"

#include "support/wire/mcp.h"

#include <bit>
#include <utility>

namespace judge {

namespace {

constexpr unsigned kBeacon = 5, kPing = 6, kData = 9, kResponse = 10;

std::uint32_t little(ByteView bytes, std::size_t at, std::size_t width)
{
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
        value |= std::uint32_t{bytes[at + i]} << 8 * i;
    return value;
}

unsigned typeOf(std::uint16_t id) { return id >> 3 & 7U; }

std::size_t widthOf(std::uint16_t id)
{
    const unsigned type = typeOf(id);
    return type == 1 ? 1 : type == 2 ? 2 : type == 3 ? 4 : 0;
}

/// Registers of 32 bits whose value is a real number: element << 6 | type << 3.
bool isReal(std::uint16_t id)
{
    const unsigned bare = id & ~7U;
    return bare == 0x0A58 || bare == 0x1618 || bare == 0x1658 || bare == 0x1698 || bare == 0x1B58;
}

double numberOf(std::uint16_t id, std::uint32_t bits)
{
    if (isReal(id))
        return static_cast<double>(std::bit_cast<float>(bits));
    switch (widthOf(id)) {
    case 2:
        return static_cast<std::int16_t>(bits);
    case 4:
        return static_cast<std::int32_t>(bits);
    default:
        return bits;
    }
}

} // namespace

void McpBoard::reset()
{
    m_asked.clear();
    m_said.clear();
    m_askedWanted = m_saidWanted = 0;
    m_due.clear();
    m_configs.clear();
    m_tracks.clear();
    m_lastTick = -1;
}

void McpBoard::asks(ByteView bytes, bool arrives)
{
    // A blind stop drops a payload whose header has left, and a board that begins anew behind a header takes the
    // payload for headers: what comes then begins a packet, and no request begins like it.
    if (const std::uint32_t word = little(bytes, 0, 4); bytes.size() == 4
        && (word % 16 == kBeacon || word % 16 == kPing) && WireMcp::checkOf(word) == word >> 28) {
        m_asked.clear();
        m_askedWanted = 0;
        m_askedArrives = true;
    }
    for (const std::uint8_t byte : bytes) {
        m_asked.push_back(byte);
        m_askedArrives = m_askedArrives && arrives;
        if (m_askedWanted == 0 && m_asked.size() == 4) {
            const std::uint32_t word = little(m_asked, 0, 4);
            m_asked.clear();
            m_askedWanted = word % 16 == kData ? word >> 4 & 0x1FFFU : 0;
            m_askedArrives = m_askedArrives || m_askedWanted == 0;
        } else if (m_askedWanted > 0 && m_asked.size() == m_askedWanted) {
            if (m_askedArrives)
                request(m_asked);
            m_asked.clear();
            m_askedWanted = 0;
            m_askedArrives = true;
        }
    }
}

void McpBoard::request(ByteView payload)
{
    m_due.clear();
    const unsigned command = little(payload, 0, 2) >> 3;
    if (command == 2)
        for (std::size_t at = 2; at + 2 <= payload.size(); at += 2)
            m_due.push_back(static_cast<std::uint16_t>(little(payload, at, 2)));
    if (command != 1 || payload.size() < 6)
        return;
    const auto id = static_cast<std::uint16_t>(little(payload, 2, 2));
    if (typeOf(id) == 5 && id >> 6 >= 20 && id >> 6 <= 22)
        setUp(payload.subspan(6));
}

void McpBoard::setUp(ByteView raw)
{
    if (raw.size() < 7)
        return;
    Config config;
    config.fastStep = raw[2] + 1U;
    config.slowEvery = raw[4];
    std::size_t at = 6;
    for (int i = 0; i < raw[3] && at + 2 < raw.size(); ++i, at += 2)
        config.fast.push_back(static_cast<std::uint16_t>(little(raw, at, 2)));
    for (int i = 0; i < raw[5] && at + 2 < raw.size(); ++i, at += 2)
        config.slow.push_back(static_cast<std::uint16_t>(little(raw, at, 2)));
    m_configs[raw[at]] = std::move(config);
}

void McpBoard::says(ByteView bytes, TimePoint at, bool arrives)
{
    for (const std::uint8_t byte : bytes) {
        m_saidArrives = m_saidArrives && arrives;
        m_said.push_back(byte);
        if (m_saidWanted == 0 && m_said.size() == 4) {
            const std::uint32_t word = little(m_said, 0, 4);
            m_saidType = word % 16;
            const bool carries = m_saidType == kData || m_saidType == kResponse;
            m_saidWanted = carries ? word >> 4 & 0x1FFFU : 0;
            m_said.clear();
            if (m_saidWanted == 0)
                m_saidArrives = true;
        } else if (m_saidWanted > 0 && m_said.size() == m_saidWanted) {
            if (m_saidArrives && m_saidType == kResponse)
                answer(m_said, at);
            else if (m_saidArrives)
                packet(m_said, at);
            else if (m_saidType == kData && m_said.size() > 4)
                m_lost.emplace_back(at, little(m_said, 0, 4));
            m_said.clear();
            m_saidWanted = 0;
            m_saidArrives = true;
        }
    }
    forgetOld(at);
}

void McpBoard::answer(ByteView payload, TimePoint at)
{
    const auto due = std::exchange(m_due, {});
    if (due.empty() || payload.empty())
        return;
    // A failure ends the list: the values before it stand, and its code behind them.
    const bool failed = payload.back() != 0;
    std::size_t from = 0;
    std::vector<std::pair<std::uint16_t, double>> all;
    for (const std::uint16_t id : due) {
        if (failed && from + 1 == payload.size())
            break;
        std::size_t width = widthOf(id);
        if (width > 0)
            all.emplace_back(id, numberOf(id, little(payload, from, width)));
        else if (typeOf(id) == 5)
            width = 2 + little(payload, from, 2);
        else
            while (from + width < payload.size() && payload[from + width++] != 0) { }
        from += width;
    }
    if (from + 1 != payload.size())
        return; // not the answer to this
    for (const auto &[id, number] : all)
        m_given.add(id, number, at);
}

void McpBoard::packet(ByteView payload, TimePoint at)
{
    if (payload.size() < 6 || payload.back() != 0)
        return;
    const auto config = m_configs.find(payload[payload.size() - 2]);
    if (config == m_configs.end())
        return;
    const auto &[step, slowEvery, fast, slow] = config->second;
    const std::int64_t begins = little(payload, 0, 4);
    if (begins < m_lastTick)
        m_tracks.clear(); // the board counts anew
    std::size_t slowWidth = 0;
    for (const std::uint16_t id : slow)
        slowWidth += widthOf(id);
    const std::size_t end = payload.size() - 2 - (slowEvery == 254 ? slowWidth : 0);
    std::int64_t tick = begins;
    for (std::size_t from = 4, block = 0; from + 2 * fast.size() <= end && !fast.empty(); ++block) {
        tick = begins + static_cast<std::int64_t>(block * step);
        for (const std::uint16_t id : fast) {
            keep(id, tick, static_cast<std::int16_t>(little(payload, from, 2)), at);
            from += 2;
        }
        if (slowEvery < 254 && (block + 1) % (slowEvery + 1) == 0)
            from += slowWidth;
    }
    m_lastTick = tick;
}

void McpBoard::keep(std::uint16_t id, std::int64_t tick, std::int16_t digits, TimePoint at)
{
    Track &track = m_tracks[id];
    track.samples.push_back({tick, digits});
    if (track.packets.empty() || track.packets.back().first != at)
        track.packets.emplace_back(at, 0);
    ++track.packets.back().second;
    ++m_samples;
}

void McpBoard::forgetOld(TimePoint now)
{
    for (auto &[id, track] : m_tracks)
        while (!track.packets.empty() && track.packets.front().first + kKept < now) {
            const auto count = static_cast<std::ptrdiff_t>(track.packets.front().second);
            track.samples.erase(track.samples.begin(), track.samples.begin() + count);
            track.packets.pop_front();
        }
    while (!m_lost.empty() && m_lost.front().first + kKept < now)
        m_lost.pop_front();
    m_given.forgetOld(now);
}

const std::deque<McpBoard::Sample> &McpBoard::samplesOf(std::uint16_t id) const
{
    static const std::deque<Sample> kNone;
    const auto found = m_tracks.find(id);
    return found == m_tracks.end() ? kNone : found->second.samples;
}

std::optional<TimePoint> McpBoard::sampledAt(std::uint16_t id) const
{
    const auto found = m_tracks.find(id);
    if (found == m_tracks.end() || found->second.packets.empty())
        return {};
    return found->second.packets.back().first;
}

std::optional<std::int64_t> McpBoard::newestTick(std::uint16_t id) const
{
    const auto found = m_tracks.find(id);
    if (found == m_tracks.end() || found->second.samples.empty())
        return {};
    return found->second.samples.back().tick;
}

std::optional<std::int64_t> McpBoard::oldestTick(std::uint16_t id) const
{
    const auto found = m_tracks.find(id);
    if (found == m_tracks.end() || found->second.samples.empty())
        return {};
    return found->second.samples.front().tick;
}

Extremes McpBoard::extremes(std::uint16_t id, std::int64_t from, std::int64_t to) const
{
    Extremes all;
    const auto found = m_tracks.find(id);
    if (found == m_tracks.end())
        return all;
    const auto &samples = found->second.samples;
    auto at = std::lower_bound(samples.begin(), samples.end(), from,
        [](const Sample &sample, std::int64_t tick) { return sample.tick < tick; });
    for (; at != samples.end() && at->tick < to; ++at)
        all.include(at->digits);
    return all;
}

Extremes McpBoard::between(std::uint16_t id, TimePoint from, TimePoint to) const
{
    Extremes all;
    const auto found = m_tracks.find(id);
    if (found == m_tracks.end())
        return all;
    const Track &track = found->second;
    std::size_t left = track.samples.size();
    for (auto packet = track.packets.rbegin(); packet != track.packets.rend(); ++packet) {
        if (packet->first < from)
            break;
        left -= packet->second;
        for (std::size_t i = left; packet->first < to && i < left + packet->second; ++i)
            all.include(track.samples[i].digits);
    }
    return all;
}

} // namespace judge
