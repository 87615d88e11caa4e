// Write wishes. A list of writes goes out in its order, in as few SETs as fit, surrounded by reading: the
// value before, for undo, and the value after it, because an OK is not a proof.
//
// What shares a SET: scalars whose values stay aligned as in a SET of their own (small controllers fault otherwise),
// an 8-bit one last. Structures and whatever can move something go alone, so that a lost answer is about them only.
#pragma once

#include "drive/mcp/mcp_reader.h"
#include "drive/task.h"

#include <map>
#include <vector>

namespace drive {

class McpWriteTask : public WishTask<McpProtocol> {
public:
    McpWriteTask(WishId id, const Write &write, const McpBoard &board);

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void takeResponse(const ByteView &response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;
    void cut(const std::string &reason) override;

    void supersede(const Write &newer) override;
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }

private:
    enum class Phase : std::uint8_t { Before, Setting, After };
    enum class State : std::uint8_t { Waiting, Open, Doubtful, Done };
    struct Item {
        RegisterWrite write;
        mcp::Value encoded;
        State state = State::Waiting;
        bool repeated = false;
        WriteResult result;
    };

    void check(Item &item) const;
    void judgeWays();
    McpSet nextSet();
    bool joins(const Item &item, std::size_t size, std::size_t count) const;
    bool alone(const Item &item) const;
    std::vector<Item *> open();
    void settle(Item &item, std::uint8_t status);
    void takeStatuses(const std::vector<Item *> &items, ByteView response);
    std::vector<RegisterId> idsToRead(bool after) const;
    void enter(Phase phase);
    void takeReadingsInto(
        std::optional<Value> WriteResult::*where, ByteView response, TimePoint now);
    void finishItem(Item &item, Outcome outcome, const std::string &reason);
    void finish();

    const McpBoard &m_board;
    Reach m_reach;
    std::vector<Item> m_items;
    RegisterReader m_reader{m_board};
    std::vector<Reading> m_readings;
    std::map<RegisterId, double> m_numbers; ///< numbers read, for the judgement of moves
    Phase m_phase = Phase::Before;
    bool m_started = false;
};

} // namespace drive
