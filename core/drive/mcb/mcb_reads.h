// Reading by one request a register. The link repeats what was lost, so what gets no answer here is given up.
#pragma once

#include "drive/mcb/mcb_messages.h"
#include "drive/reader.h"

#include <span>

namespace drive {

class McbReads : public PlainReads {
public:
    explicit McbReads(const McbFacts &board)
        : m_board(board)
    {
    }

    McbRequest request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const McbAnswer &answer, TimePoint now) const;

private:
    const McbFacts &m_board;
};

/// A value as the catalogue has it, from the words of an answer; nothing if they are no such value.
std::optional<Value> mcbValueOf(const McbFacts &board, std::uint16_t address, mcb::WordView words);
/// Which words a value of a register is, or why it cannot be one.
Result<mcb::Words, std::string> mcbWordsOf(
    const McbFacts &board, std::uint16_t address, const Value &value);

} // namespace drive
