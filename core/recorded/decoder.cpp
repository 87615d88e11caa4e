#include "recorded/decoder.h"

#include "recorded/entry_codec.h"

#include <algorithm>
#include <utility>

namespace recorded {

namespace {

constexpr std::size_t kLongestBlock = blockSize(kMostPayload);
constexpr std::uint32_t kLongestOther = 1 << 20; ///< of a block that is no entry

} // namespace

void Decoder::feed(ByteView bytes)
{
    if (m_at > 0) {
        m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_at));
        m_at = 0;
    }
    m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.end());
}

std::optional<Decoder::Step> Decoder::next()
{
    while (m_ready.empty() && lookHere()) { }
    if (m_ready.empty())
        return std::nullopt;
    Step step = std::move(m_ready.front());
    m_ready.erase(m_ready.begin());
    return step;
}

void Decoder::skip(std::size_t bytes)
{
    m_at += bytes;
    m_offset += bytes;
}

/// These bytes are no good.
void Decoder::pass(std::size_t bytes)
{
    if (!m_damage)
        m_damage = Damage{Damage::Kind::Unreadable, m_offset, 0, 0};
    m_damage->bytes += bytes;
    skip(bytes);
}

/// False: more bytes have to come first.
bool Decoder::lookHere()
{
    const ByteView bytes = rest();
    if (bytes.empty() || (bytes.size() < kClaimBytes && !m_finished)) {
        if (m_finished)
            tellEnd();
        return false;
    }
    const Claim claim = claimOf(bytes);
    const bool packet = claim.type == kPacketBlock && claim.length >= kBlockOverhead
        && claim.length <= kLongestBlock;
    const bool other = !m_damage && claim.type != kPacketBlock && claim.length <= kLongestOther;
    if ((packet || other) && claim.length > bytes.size() && !m_finished)
        return false;
    if ((packet && onPacket(bytes)) || (other && skipOther(claim)))
        return true;
    // No sound block begins here: on to the next byte that could begin one.
    const auto found =
        std::find(bytes.begin() + 1, bytes.end(), static_cast<std::uint8_t>(kPacketBlock));
    pass(static_cast<std::size_t>(found - bytes.begin()));
    return true;
}

/// The block at the beginning of `bytes`, if it is sound.
bool Decoder::onPacket(ByteView bytes)
{
    const auto head = packetHead(bytes, kMostPayload);
    const auto data = head ? packetData(*head, bytes) : std::nullopt;
    if (!data)
        return false;
    tellDamage(head->number);
    ++m_soundBlocks;
    m_expected = head->number + 1;
    if (head->interface == Interface::Entries) {
        onEntry(*head, *data);
    } else {
        const auto direction =
            head->direction == 2 ? LinkBytes::Direction::Sent : LinkBytes::Direction::Received;
        m_ready.emplace_back(
            Item{m_offset, head->at, LinkBytes{direction, Bytes(data->begin(), data->end())}});
    }
    skip(blockSize(data->size()));
    return true;
}

/// Blocks of other kinds have no checksum of ours: passed over where both of their lengths agree.
bool Decoder::skipOther(const Claim &claim)
{
    const ByteView bytes = rest();
    if (claim.length < 12 || claim.length % 4 != 0 || claim.length > bytes.size())
        return false;
    ByteReader trailer(bytes.subspan(claim.length - 4));
    if (trailer.u32() != claim.length)
        return false;
    if (isSectionHead(bytes))
        m_expected.reset(); // blocks are counted anew
    if (!m_skipped)
        m_skipped = Damage{Damage::Kind::Unreadable, m_offset, 0, 0};
    m_skipped->bytes += claim.length;
    skip(claim.length);
    return true;
}

/// Told when the next sound block is known, whose number says how many are missing.
void Decoder::tellDamage(std::uint32_t number)
{
    const std::uint32_t missing = m_expected && number > *m_expected ? number - *m_expected : 0;
    // What was passed over as a block of another kind may have been one of ours before its type was damaged.
    if (!m_damage && missing > 0)
        m_damage = m_skipped.value_or(Damage{Damage::Kind::Missing, m_offset, 0, 0});
    m_skipped.reset();
    if (!m_damage)
        return;
    m_damage->blocks = missing;
    m_ready.emplace_back(*m_damage);
    m_damage.reset();
}

/// What is left when nothing sound follows. Other programs may have put blocks of theirs behind the end.
void Decoder::tellEnd()
{
    if (m_damage)
        m_damage->kind = Damage::Kind::CutShort;
    else if (m_skipped && m_expected && !m_ending)
        m_damage = m_skipped;
    tellDamage(m_expected.value_or(0));
}

void Decoder::onEntry(const BlockHead &head, ByteView data)
{
    const auto damage = [&](Damage::Kind kind) {
        m_ready.emplace_back(Damage{kind, m_offset, blockSize(data.size()), 1});
    };
    auto decoded = decodeEntry(data);
    if (!decoded) {
        if (decoded.error() != PayloadError::UnknownKind)
            damage(Damage::Kind::Unreadable);
        return;
    }
    const auto *block = std::get_if<capture::SampleBlock>(&decoded->entry);
    if (block && !isDescribed(*block))
        return damage(Damage::Kind::Undescribed);
    const auto *values = std::get_if<PolledValues>(&decoded->entry);
    if (values && !isDescribed(*values) && !std::exchange(m_toldUndescribed, true))
        damage(Damage::Kind::Undescribed); // once: they come one by one
    if (const auto *end = std::get_if<End>(&decoded->entry))
        m_ending = *end;
    if (isNews(decoded->entry, decoded->repeat == Repeat::Yes))
        m_ready.emplace_back(Item{m_offset, head.at, std::move(decoded->entry)});
}

/// Keeps descriptions; false for a repetition of what is known, which would only cut the samples in two.
bool Decoder::isNews(const Entry &entry, bool repeated)
{
    if (const auto *layout = std::get_if<capture::StreamLayout>(&entry)) {
        // Ids come again: after a port was opened anew, and with a count that began anew.
        const bool known = m_layout == *layout;
        m_layout = *layout;
        return !repeated || !known;
    }
    if (const auto *polled = std::get_if<PolledRegister>(&entry)) {
        const auto found = m_polled.find(polled->id);
        const bool known = found != m_polled.end() && found->second == *polled;
        if (m_polled.size() < kMostRegisters || found != m_polled.end())
            m_polled[polled->id] = *polled;
        m_toldUndescribed = false;
        return !repeated || !known;
    }
    return true;
}

bool Decoder::isDescribed(const PolledValues &values) const
{
    return m_polled.size() == kMostRegisters
        || std::ranges::all_of(values.values,
            [this](const PolledValue &value) { return m_polled.contains(value.id); });
}

bool Decoder::isDescribed(const capture::SampleBlock &block) const
{
    if (!m_layout || m_layout->id != block.stream || m_layout->empty())
        return false;
    const auto near = [this](double tick) { return isNear(*m_layout, tick); };
    const double end = static_cast<double>(block.firstTick)
        + static_cast<double>(block.count) * m_layout->fastStep;
    return near(static_cast<double>(block.firstTick)) && near(end)
        && std::ranges::all_of(block.slow,
            [&](const capture::SlowGroup &g) { return near(static_cast<double>(g.tick)); })
        && block.fast.size() == std::size_t{block.count} * m_layout->fast.size()
        && (block.slow.empty() || block.slow.front().values.size() == m_layout->slow.size());
}

} // namespace recorded
