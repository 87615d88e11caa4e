// Takes apart frames of MCB, by the text of the protocol alone. Each output is one frame. Registers are numbered as
// address << 3 | 1: there is one motor.
//
// What travels with every frame is an act where it changes: which registers that are, and how long a frame is, is what
// was written to the drive; what the drive holds already is what it told last, or what it was last told. Words for
// which no mapping was seen have to be zero.
#pragma once

#include "support/ms_rules.h"

#include <array>

namespace judge {

class WireMcb : public Decoder {
public:
    void reset() override;
    std::vector<Sent> sent(ByteView bytes, TimePoint at) override;
    bool heard(ByteView bytes) override;
    bool midPacket() const override { return false; }

    static unsigned checkOf(ByteView bytes); ///< x^16 + x^12 + x^5 + 1, from 0

private:
    using Words = std::array<unsigned, 4>;
    struct Entry {
        unsigned address = 0, words = 0;
    };

    std::vector<Sent> configPart(const std::vector<unsigned> &frame);
    Sent write(unsigned address, const Words &words);
    void noteWrite(unsigned address, const Words &words);
    std::vector<Entry> entriesOf(unsigned count) const;
    void travels(const std::vector<unsigned> &words, std::vector<Sent> &all);
    bool changes(const Entry &entry, const Words &words);
    void accept(ByteView bytes);

    bool m_continues = false; ///< a value in fragments is under way
    bool m_sought = false; ///< the length of its frames, since it was last made to cycle
    bool m_brought = false; ///< this frame ends the cycling of a drive that was found in it
    /// Counts and entries of the mapping, as they were written.
    std::map<unsigned, unsigned> m_list;
    std::vector<Entry> m_rx; ///< of the mapping that was last switched on
    std::size_t m_words = 0; ///< of a frame with it
    std::map<unsigned, Words> m_holds; ///< by address, of the drive
    /// Whether the last question about it was for its value, and has no answer yet.
    std::map<unsigned, bool> m_read;
    Bytes m_heard; ///< since the last frame left
    std::size_t m_length = 0; ///< of that
};

} // namespace judge
