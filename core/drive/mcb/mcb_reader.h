// Reads a list of registers, one a request. The link repeats what was lost, so what gets no answer here is given up.
#pragma once

#include "drive/mcb/mcb_messages.h"

#include <deque>
#include <optional>
#include <vector>

namespace drive {

class McbReader {
public:
    explicit McbReader(const McbBoard &board)
        : m_board(board)
    {
    }

    /// Forgets what it was doing and begins with these.
    void start(const std::vector<RegisterId> &ids);
    void clear() { m_waiting.clear(); }

    bool finished() const { return m_waiting.empty(); }
    bool gaveUp() const { return m_gaveUp; } ///< some were never answered: no Reading for those

    std::optional<McbRequest> nextRequest() const; ///< nothing when finished
    std::vector<Reading> takeResponse(const McbAnswer &answer, TimePoint now); ///< one
    void takeNoResponse();

private:
    const McbBoard &m_board;
    std::deque<RegisterId> m_waiting; ///< the first one is asked
    bool m_gaveUp = false;
};

/// A value as the catalogue has it, from the words of an answer; nothing if they are no such value.
std::optional<Value> mcbValueOf(const McbBoard &board, std::uint16_t address, mcb::WordView words);
/// Which words a value of a register is, or why it cannot be one.
Result<mcb::Words, std::string> mcbWordsOf(
    const McbBoard &board, std::uint16_t address, const Value &value);

} // namespace drive
