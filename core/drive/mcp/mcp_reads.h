// Reading with as few GET requests as the negotiated sizes allow.
//
// Ids go out ordered 32-, 16-, 8-bit (an unaligned value is a fault on small controllers); texts and raw values each
// in a request of their own. The room for answers is computed here, because the board does not check it for every
// register. A failing id ends an answer early: the values before it tell which one it was, the rest is asked again.
// A refusal is believed when it comes twice: the id may have been damaged on its way, and payloads are not protected.
// An answer whose length fits nothing counts as lost.
#pragma once

#include "drive/mcp/mcp_protocol.h"
#include "drive/reader.h"

#include <optional>
#include <span>
#include <vector>

namespace drive {

class McpReads : public PlainReads {
public:
    explicit McpReads(const McpFacts &board)
        : m_board(board)
    {
    }

    void begin(std::vector<RegisterId> &ids);
    McpRequest request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, ByteView answer, TimePoint now);

private:
    const McpFacts &m_board;
    std::optional<RegisterId> m_doubted; ///< refused once
};

} // namespace drive
