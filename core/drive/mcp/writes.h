// Write wishes. A list of writes goes out in its order, in as few SETs as fit, behind the
// reading of all values before that are not known, and before the reading of all values after.
//
// What shares a SET: scalars whose values stay aligned as in a SET of their own (small controllers fault otherwise),
// an 8-bit one last. Structures and whatever can move something go alone, so that a lost answer is about them only.
#pragma once

#include "drive/mcp/requests.h"
#include "drive/write_task.h"

#include <map>
#include <vector>

namespace drive {

class McpWriteTask final : public WriteTask<McpProtocol> {
public:
    using WriteTask::WriteTask;

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const McpAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    enum class Phase : std::uint8_t { Begin, Before, Setting, After };

    bool replaceable(const Item &item) const override
    {
        return item.state == State::Waiting && !item.repeated;
    }
    bool same(const RegisterWrite &write, const Value &read) const override;
    /// Ramps tell the one that was asked for last.
    bool showsInForce(const catalog::RegisterInfo &info) const override
    {
        return wireWidth(info.id) != 0 || info.id == mcp::reg::kCurrentRef.bits;
    }
    std::string check(const Item &item, mcp::Value &encoded) const;
    void judgeWays();
    McpSet nextSet();
    bool joins(const Item &item, std::size_t size, std::size_t count) const;
    /// Whether it has a SET of its own.
    bool alone(const Item &item) const
    {
        const auto *info = m_board.catalog->find(item.write.id);
        return wireWidth(item.write.id) == 0 || info == nullptr || info->dangerous;
    }
    std::vector<Item *> open();
    void settle(Item &item, std::uint8_t status);
    void onStatuses(const McpAnswer &answer);
    std::vector<RegisterId> idsToRead(bool after) const;
    void enter(Phase phase)
    {
        m_phase = phase;
        if (phase != Phase::Setting)
            m_reader.start(idsToRead(phase == Phase::After));
    }
    void onAnswers(
        std::optional<Value> WriteResult::*where, const McpAnswer &answer, TimePoint now);

    std::vector<mcp::Value> m_encoded; ///< of the items
    Reader<McpProtocol> m_reader{m_board};
    std::map<RegisterId, double> m_numbers; ///< numbers read, for the judgement of moves
    Phase m_phase = Phase::Begin;
};

} // namespace drive
