// What the tasks of an MCP drive ask, as the codec has it, and what they are answered: the payload, which ends in a status.
#pragma once

#include "drive/board_facts.h"
#include "mcp/request.h"

#include <map>
#include <variant>
#include <vector>

namespace aspep {
class Controller;
}

namespace drive {

/// What is known of the MCP board at the other end, shared by the parts of McpDrive. Plain data; filled by the identification,
/// read by everybody else.
struct McpFacts : BoardFacts {
    bool hso = false; ///< register family: HSO/ZeST instead of the standard one
    std::uint32_t version = 0; ///< 0xMMmmpp
    std::optional<std::chrono::milliseconds> watchdog; ///< what its name promises

    std::map<RegisterId, std::size_t> structureSizes; ///< as read twice when it was met

    std::uint32_t baud = 1843200;
    std::uint8_t linkId = 0; ///< decides which datalog register is ours
    std::size_t requestBytes = 32, responseBytes = 32,
                streamBytes = 0; ///< negotiated payload sizes
};

class Identification;
class McpReads;
class McpVitals;
class McpWatch;
class McpWriteTask;

struct McpGet {
    std::vector<mcp::RegisterId> registers;
};
struct McpSet {
    std::vector<mcp::RegisterValue> writes;
};
struct McpAct {
    mcp::CommandId command{};
    int motor = 0;
    Bytes content{};
};
using McpRequest = std::variant<McpGet, McpSet, McpAct>;

/// Fails for what firmware mishandles. @param room  what the board takes
Result<Bytes, mcp::CodecError> encode(const McpRequest &request, std::size_t room);

inline McpSet mcpSet(mcp::RegisterId id, int motor, mcp::Value value)
{
    return {{{id.withMotor(static_cast<unsigned>(motor)), std::move(value)}}};
}

struct McpProtocol {
    using Request = McpRequest;
    using Answer = ByteView;
    using Facts = McpFacts;
    using Link = aspep::Controller;
    using Identification = drive::Identification;
    using Vitals = McpVitals;
    using Watch = McpWatch;
    using Writes = McpWriteTask;
    using Reads = McpReads;
    static constexpr int kAttempts = 4;
    static std::optional<ReadStatus> refuseRead(const McpFacts &board, RegisterId id);
};

} // namespace drive
