// Reads a list of registers with as few GET requests as the negotiated sizes allow.
//
// Ids go out ordered 32-, 16-, 8-bit (an unaligned value is a fault on small controllers); texts and raw values each
// in a request of their own. The room for answers is computed here, because the board does not check it for every
// register. A failing id ends an answer early: the values before it tell which one it was, the rest is asked again.
// A refusal is believed when it comes twice: the id may have been damaged on its way, and payloads are not protected.
// An answer whose length fits nothing counts as lost. Lost answers are asked for again up to kRepeats times.
#pragma once

#include "drive/mcp/mcp_protocol.h"

#include <deque>
#include <optional>
#include <vector>

namespace drive {

class RegisterReader {
public:
    static constexpr int kRepeats = 3;

    explicit RegisterReader(const McpBoard &board)
        : m_board(board)
    {
    }

    /// Forgets what it was doing and begins with these ids.
    void start(const std::vector<RegisterId> &ids);
    void clear();

    bool finished() const { return m_waiting.empty(); }
    bool gaveUp() const { return m_gaveUp; } ///< some were never answered: no Reading for those

    /// The request for the next batch; nothing when finished.
    std::optional<McpRequest> nextRequest();
    std::vector<Reading> takeResponse(const ByteView &response, TimePoint now);
    void takeNoResponse();

private:
    const McpBoard &m_board;
    std::deque<RegisterId> m_waiting; ///< in sending order; the open batch is its first m_batch
    std::size_t m_batch = 0;
    std::optional<RegisterId> m_doubted; ///< refused once
    int m_losses = 0; ///< of the batch in a row
    bool m_gaveUp = false;
};

} // namespace drive
