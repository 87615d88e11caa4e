#include "support/wire/mcb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace judge {

namespace {

constexpr unsigned kControl = 0x010, kStatus = 0x011, kMode = 0x014, kModeNow = 0x015,
                   kLastError = 0x00F, kCurrentQ = 0x01A, kCurrentD = 0x01B, kPosition = 0x020,
                   kVelocity = 0x021, kTorque = 0x022, kProfileFirst = 0x025, kProfileLast = 0x027,
                   kPositionNow = 0x030, kVelocityNow = 0x031, kState = 0x640,
                   kMappingFirst = 0x650, kMappingLast = 0x66F, kRx = 0x650, kTx = 0x660;
constexpr std::size_t kConfigWords = 6; ///< of a frame without words that travel, with its check

std::vector<unsigned> wordsOf(ByteView bytes)
{
    std::vector<unsigned> words;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        words.push_back(unsigned{bytes[i]} << 8 | bytes[i + 1]);
    return words;
}

unsigned addressOf(const std::vector<unsigned> &frame) { return frame[0] >> 4 & 0x7FFU; }
unsigned commandOf(const std::vector<unsigned> &frame) { return frame[0] >> 1 & 7U; }
std::array<unsigned, 4> valueOf(const std::vector<unsigned> &frame)
{
    return {frame[1], frame[2], frame[3], frame[4]};
}

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

void WireMcb::reset() { *this = {}; }

std::vector<Sent> WireMcb::sent(ByteView bytes, TimePoint)
{
    m_heard.clear();
    m_length = bytes.size();
    Sent one;
    if (std::all_of(bytes.begin(), bytes.end(), [](auto byte) { return byte == 0xFF; })) {
        // No frame at all: the clock only, to find the length of the slave's.
        one.kind = Kind::LinkControl;
        m_sought = true;
        return {one};
    }
    if (bytes.size() < 2 * kConfigWords || bytes.size() % 2 != 0 || checkOf(bytes) != 0)
        return {never(one, "a frame of a wrong length or check")};
    const auto frame = wordsOf(bytes);
    m_brought = false;
    auto all = configPart(frame);
    travels({frame.begin() + 5, frame.end() - 1}, all);
    return all;
}

std::vector<Sent> WireMcb::configPart(const std::vector<unsigned> &frame)
{
    Sent one;
    const unsigned address = addressOf(frame), command = commandOf(frame);
    const bool continues = m_continues;
    m_continues = command == 2 && (frame[0] & 1U) != 0;
    switch (command) {
    case 0: // who has this register, and how wide it is
        m_read[address] = false;
        return {one};
    case 1: {
        m_read[address] = true;
        const bool state = address == kStatus || address == kLastError || address == kModeNow
            || address == kMode || address == kPositionNow || address == kVelocityNow;
        one.kind = state ? Kind::StatusRead : Kind::Read;
        return {one};
    }
    case 2:
        if (continues)
            return {};
        m_read[address] = false;
        noteWrite(address, valueOf(frame));
        return {write(address, valueOf(frame))};
    case 7:
        one.kind = Kind::LinkControl;
        return {one};
    default:
        return {never(one, "a frame that only a drive sends")};
    }
}

void WireMcb::noteWrite(unsigned address, const Words &words)
{
    m_holds[address] = words;
    m_brought = address == kState && words[0] == 1 && m_sought;
    if (address == kState && words[0] == 2)
        m_sought = false;
    if (address >= kMappingFirst && address <= kMappingLast)
        m_list[address] = words[0] | words[1] << 16;
    if (address != kState || words[0] != 2)
        return;
    const auto sum = [](const std::vector<Entry> &entries) {
        std::size_t number = 0;
        for (const Entry &entry : entries)
            number += entry.words;
        return number;
    };
    m_rx = entriesOf(kRx);
    m_words = std::max(sum(m_rx), sum(entriesOf(kTx)));
}

/// An entry is size in bytes and address; each takes whole words.
std::vector<WireMcb::Entry> WireMcb::entriesOf(unsigned count) const
{
    const auto written = [&](unsigned address) {
        const auto at = m_list.find(address);
        return at == m_list.end() ? 0U : at->second;
    };
    std::vector<Entry> entries;
    for (unsigned i = 1; i <= written(count) && i <= 15; ++i)
        entries.push_back({written(count + i) & 0xFFFFU, ((written(count + i) >> 16) + 1) / 2});
    return entries;
}

/// Behind the config part of a frame.
void WireMcb::travels(const std::vector<unsigned> &words, std::vector<Sent> &all)
{
    if (words.size() != m_words) {
        Sent one;
        one.firstOfPacket = false;
        if (std::any_of(words.begin(), words.end(), [](unsigned word) { return word != 0; }))
            all.push_back(never(one, "words that travel by a mapping that nobody switched on"));
        return;
    }
    auto next = words.begin();
    for (const Entry &entry : m_rx) {
        Words value{};
        std::copy_n(next, std::min<std::size_t>(entry.words, value.size()), value.begin());
        next += entry.words;
        Sent one = write(entry.address, value);
        one.firstOfPacket = false;
        const bool isZero = value == Words{};
        one.rests = one.kind == Kind::SetPoint && (one.rpm || one.amps) && isZero;
        one.goesOn = !changes(entry, value) && one.kind != Kind::Stop;
        // What a drive that was found cycling holds is unknown: zeros go with what ends that.
        if (isZero && m_brought)
            continue;
        if (!one.goesOn || (one.kind == Kind::SetPoint && !isZero))
            all.push_back(one);
    }
}

bool WireMcb::changes(const Entry &entry, const Words &words)
{
    const auto at = m_holds.find(entry.address);
    const auto count = static_cast<std::ptrdiff_t>(std::min<std::size_t>(entry.words, 4));
    const bool same =
        at != m_holds.end() && std::equal(words.begin(), words.begin() + count, at->second.begin());
    m_holds[entry.address] = words;
    return !same;
}

/// The bytes of an exchange may come in pieces, and more of them than were sent.
bool WireMcb::heard(ByteView bytes)
{
    m_heard.insert(m_heard.end(), bytes.begin(), bytes.end());
    if (m_length >= 2 * kConfigWords && m_heard.size() >= m_length)
        accept(ByteView(m_heard).first(m_length));
    return !bytes.empty();
}

/// The answer to a question for a value, in one piece, is what the drive holds.
void WireMcb::accept(ByteView bytes)
{
    m_length = 0;
    if (bytes.size() % 2 != 0 || checkOf(bytes) != 0)
        return;
    const auto frame = wordsOf(bytes);
    const auto asked = m_read.find(addressOf(frame));
    // One that comes again may be the answer to something else.
    if (commandOf(frame) == 3 && (frame[0] & 1U) == 0 && asked != m_read.end()
        && std::exchange(asked->second, false))
        m_holds[addressOf(frame)] = valueOf(frame);
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
