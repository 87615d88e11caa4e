// Decoder: the bytes of a recording in, entries and damage out, in the order of the file. It owns no file, holds at
// most one block and what was fed last, and never trusts a length.
//
// A block counts only if both of its checksums fit. Behind damage the next such block is searched byte by byte; what
// was between is told as Damage, with the number of blocks that are missing. What a later version may have added is
// passed over. A layout that was swallowed by damage is taken from the next repetition; samples before that are told
// as damage, too, because their meaning is not known.
//
// Call order: feed() and next() until it is empty, again and again; finish() and next() until it is empty; ending().
#pragma once

#include "base/result.h"
#include "recorded/block.h"
#include "recorded/entry.h"

#include <map>
#include <optional>
#include <variant>

namespace recorded {

struct Item {
    std::uint64_t offset = 0; ///< of the block in the file
    Nanos at = 0;
    Entry entry;
};

/// Something is missing between the items before and after it.
struct Damage {
    enum class Kind : std::uint8_t {
        Unreadable, ///< bytes that are no sound block
        CutShort, ///< such bytes at the end of the file: its writer was stopped there
        Missing, ///< sound bytes, but the numbers of the blocks jump
        /// Samples whose layout is among what is missing, or values whose register is; such values are told once, up
        /// to the next description.
        Undescribed,
    } kind = Kind::Unreadable;
    std::uint64_t offset = 0; ///< where it begins
    std::uint64_t bytes = 0;
    std::uint32_t blocks = 0; ///< missing, as far as their numbers tell
    bool operator==(const Damage &) const = default;
};

class Decoder {
public:
    using Step = std::variant<Item, Damage>;

    void feed(ByteView bytes);
    /// Nothing follows.
    void finish() { m_finished = true; }
    /// The next entry or damage; empty: it wants more bytes, or all was told.
    [[nodiscard]] std::optional<Step> next();

    /// The file begins as a recording, or a sound block of one was found in it.
    bool isRecording() const { return m_soundBlocks > 0; }
    /// How it was ended; empty: it was interrupted, or is still being written.
    const std::optional<End> &ending() const { return m_ending; }
    std::uint64_t blocks() const { return m_soundBlocks; }
    std::uint32_t nextNumber() const { return m_expected.value_or(0); } ///< of a block behind all

private:
    ByteView rest() const { return ByteView(m_buffer).subspan(m_at); }
    void skip(std::size_t bytes);
    void pass(std::size_t bytes);
    bool lookHere();
    bool onPacket(ByteView bytes);
    bool skipOther(const Claim &claim);
    void onEntry(const BlockHead &head, ByteView data);
    bool isNews(const Entry &entry, bool repeated);
    bool isDescribed(const PolledValues &values) const;
    bool isDescribed(const capture::SampleBlock &block) const;
    void tellDamage(std::uint32_t number);
    void tellEnd();

    Bytes m_buffer;
    std::size_t m_at = 0;
    std::uint64_t m_offset = 0; ///< of m_at in the file
    bool m_finished = false;
    std::vector<Step> m_ready; ///< to be told, the first one first
    std::optional<Damage> m_damage; ///< goes on
    std::optional<Damage> m_skipped; ///< blocks of other kinds since the last sound one
    std::optional<std::uint32_t> m_expected; ///< number of the next block
    std::uint64_t m_soundBlocks = 0;
    std::optional<End> m_ending;
    std::optional<capture::StreamLayout> m_layout;
    std::map<RegisterId, PolledRegister> m_polled;
    bool m_toldUndescribed = false; ///< values, since a register was described
};

} // namespace recorded
