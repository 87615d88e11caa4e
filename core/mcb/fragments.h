// Values of more than four words: cut for the line, and put together again. Nothing is padded away here: how long a
// value really is says GET INFO, or the zero at its end.
#pragma once

#include "mcb/frame.h"

namespace mcb {

constexpr std::size_t kMostValueWords = 128; ///< as many as mcblib holds

/// Frames for `words`: at least one, the last one filled up with zeros and alone without the pending bit.
std::vector<Frame> fragmentsOf(std::uint16_t address, Command command, WordView words);

/// Gathers the fragments of one value at a time.
class Gatherer {
public:
    enum class Added : std::uint8_t { More, Whole, TooLong };

    /// A fragment of another register than the last one begins a new value; so does the one after Whole and TooLong.
    Added add(const Frame &fragment);
    /// All words since the beginning, those of the padding included; until the next add().
    const Words &words() const { return m_words; }
    void clear();

private:
    std::uint16_t m_address = 0;
    bool m_open = false; ///< more fragments are due
    Words m_words;
};

} // namespace mcb
