// Reads a list of registers of the older serial protocol, one GET after the other; the raw register of the rev-up takes
// one for each of its stages. A refusal ends a register, a lost answer is asked for again up to kRepeats times.
#pragma once

#include "drive/legacy/legacy_protocol.h"
#include "drive/legacy/legacy_registers.h"

#include <deque>
#include <optional>

namespace drive {

class LegacyReader {
public:
    static constexpr int kRepeats = 3;

    explicit LegacyReader(const LegacyFacts &board)
        : m_board(board)
    {
    }

    void start(const std::vector<RegisterId> &ids);
    void clear() { start({}); }
    bool finished() const { return m_waiting.empty(); }
    bool gaveUp() const { return m_gaveUp; } ///< some were never answered: no Reading for those

    /// What is asked next; nothing when finished.
    std::optional<legacy::Request> nextRequest() const;
    /// The reading that the answer completes, if it does: at most one.
    std::vector<Reading> takeResponse(const legacy::Reply &response, TimePoint now);
    void takeNoResponse();

private:
    const LegacyFacts &m_board;
    std::vector<Reading> done(ReadStatus status, Value value, TimePoint now);

    std::deque<RegisterId> m_waiting;
    Bytes m_stages; ///< of the rev-up, read until now
    int m_losses = 0; ///< of the first one, in a row
    bool m_gaveUp = false;
};

} // namespace drive
