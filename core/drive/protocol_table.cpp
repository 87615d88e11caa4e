#include "drive/protocol_table.h"

#include "fcp/protocol.h"

#include <algorithm>
#include <array>
#include <vector>

namespace drive {

namespace {

template <fcp::Dialect dialect>
std::unique_ptr<Drive> makeOlder(const LineOptions &options, Search search)
{
    return makeFcpDrive(options, search == Search::No ? std::optional(dialect) : std::nullopt);
}

std::unique_ptr<Drive> makeAuto(const LineOptions &options, Search)
{
    std::vector<const ProtocolRow *> candidates;
    for (const ProtocolRow &row : protocolTable())
        if (row.asking != LinkReason::None)
            candidates.push_back(&row);
    std::stable_partition(candidates.begin(), candidates.end(),
        [&](const ProtocolRow *one) { return options.spoken == one->choice.protocol; });
    return makeAutoDrive(std::move(candidates), options);
}

} // namespace

std::span<const ProtocolRow> protocolTable()
{
    using enum Protocol;
    using fcp::Dialect;
    static constexpr std::array kRows{
        ProtocolRow{{Auto, "auto", "", "", true}, 0, {}, makeAuto},
        ProtocolRow{{Mcp, "mcp", "MCP over ASPEP", "STM32 motor control SDK 6", true}, 1843200, {},
            makeMcpDrive, LinkReason::AskingNewer, "it answered a BEACON", true,
            {LinkReason::NoAgreement, LinkReason::OtherProtocol}},
        ProtocolRow{{Fcp, "legacy", "MCP legacy", "STM32 motor control SDK 3 to 5", true}, 115200,
            {"legacy", "legacy-text"}, makeOlder<Dialect::Stm32>, LinkReason::AskingOlder, "",
            false, {LinkReason::OldProtocol}},
        ProtocolRow{{PowerPc, "powerpc", "MCP PowerPC", "PowerPC boards", true}, 115200,
            {"powerpc"}, makeOlder<Dialect::PowerPc>},
        ProtocolRow{{Mcb, "mcb", "MCB over SPI", "servo drives of Ingenia and Celera", false}, 0,
            {"mcb"}, makeMcbDrive},
    };
    return kRows;
}

const ProtocolRow &rowOf(Protocol protocol)
{
    const auto rows = protocolTable();
    return *std::ranges::find_if(
        rows, [&](const ProtocolRow &row) { return row.choice.protocol == protocol; });
}

std::string_view wordOf(Protocol protocol) { return rowOf(protocol).choice.word; }

std::optional<Protocol> protocolOf(std::string_view word)
{
    for (const ProtocolRow &row : protocolTable())
        if (row.choice.word == word)
            return row.choice.protocol;
    return std::nullopt;
}

std::unique_ptr<Drive> makeDrive(const LineOptions &options)
{
    return rowOf(options.protocol).make(options, Search::No);
}

} // namespace drive
