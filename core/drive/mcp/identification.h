// Finds out what board is on the other end, before anything is written: version, motors, names,
// structures, scales, limits. Order: GLOBAL_CONFIG, then (by others) the state of every motor, then
// the datalog is stopped, then the rest, each text and structure in a request of its own.
//
// Structures are read until two readings agree: they bound what may be sent to which motor, and
// nothing else protects them on the wire. What has a size that no known firmware has makes the
// board "unknown firmware": shown read-only and raw, never refused.
#pragma once

#include "drive/mcp/requests.h"
#include "drive/task.h"
#include "mcp/structures.h"

#include <map>
#include <set>

namespace drive {

class McpIdentification : public Task<McpProtocol> {
public:
    explicit McpIdentification(McpFacts &board)
        : m_board(board)
    {
    }

    enum class Phase : std::uint8_t { Count, States, StopDatalog, Describe };

    void restart();
    Phase phase() const { return m_phase; }
    /// The state of every motor has been read (not by this task): go on from Phase::States.
    void statesRead() { m_phase = Phase::StopDatalog; }

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const McpAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    void onReadings(std::vector<Reading> readings);
    void afterRound();
    void afterCount();
    void describe();
    void finish();
    std::string text(mcp::RegisterId id, int motor) const;
    template <class T>
    std::optional<T> structure(
        Result<T, mcp::CodecError> (*decode)(ByteView), mcp::RegisterId id, int motor);

    McpFacts &m_board;
    Phase m_phase = Phase::Count;
    Reader<McpProtocol> m_reader{m_board};
    std::map<RegisterId, Value> m_values;
    std::set<RegisterId> m_doubtful; ///< structures that were not the same twice
    std::set<RegisterId> m_unanswered; ///< asked for, and the answers were lost
    int m_rounds = 0;
    mcp::GlobalConfig m_global;
    bool m_sizesKnown = true;
    int m_stopLosses = 0;
};

} // namespace drive
