// What the tasks of an MCP drive ask and are answered, as the codec has it. Register values between the wire's bytes
// and the neutral Value, with the range checks that keep nonsense from being encoded, and how registers are read.
// Reasons are short words for the Ended event.
#pragma once

#include "base/result.h"
#include "drive/board_facts.h"
#include "drive/reader.h"
#include "drive/task.h"
#include "drive/values.h"
#include "mcp/request.h"
#include "mcp/response.h"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace aspep {
class Controller;
}

namespace drive {

/// What is known of the MCP board at the other end, shared by the parts of McpDrive. Plain data; filled by the
/// identification, read by the other parts.
struct McpFacts : BoardFacts {
    bool hso = false; ///< register family: HSO/ZeST instead of the standard one
    std::uint32_t version = 0; ///< 0xMMmmpp

    /// One a motor: the sensors that its FOC build has, as FOCFW_CONFIG numbers them; none: not known.
    std::vector<std::set<std::uint8_t>> sensors;
    std::map<RegisterId, std::size_t> structureSizes; ///< as read twice when it was met

    std::uint32_t baud = 1843200;
    std::uint8_t linkId = 0; ///< decides which datalog register is ours
};

class McpIdentification;
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
using McpAnswer = Result<mcp::Response, mcp::CodecError>; ///< an error: it has no status

/// Fails for what firmware mishandles. @param room  what the board takes
Result<Bytes, mcp::CodecError> encode(const McpRequest &request, std::size_t room);

inline McpSet mcpSet(mcp::RegisterId id, int motor, mcp::Value value)
{
    return {{{id.withMotor(static_cast<unsigned>(motor)), std::move(value)}}};
}

struct McpProtocol {
    using Request = McpRequest;
    using Answer = McpAnswer;
    using Facts = McpFacts;
    using Link = aspep::Controller;
    using Identification = McpIdentification;
    using Vitals = McpVitals;
    using Watch = McpWatch;
    using Writes = McpWriteTask;
    using Reads = McpReads;
    static constexpr int kAttempts = 4;
    static std::vector<StateStep> stateSteps();
    static AnswerEnd endIn(const McpAnswer &answer);
};

/// The register of one motor.
inline RegisterId idOf(mcp::RegisterId id, int motor)
{
    return id.withMotor(static_cast<unsigned>(motor)).bits;
}

/// Bytes a scalar takes in an answer; 0 for texts and raw values, whose length only the answer tells.
std::size_t wireWidth(RegisterId id);

/// As a SET has it. Fails (with the reason) on text, on non-finite numbers and out of the type's range.
Result<mcp::Value, std::string> wireValue(const catalog::RegisterInfo &info, const Value &value);

/// The firmware's word for a status byte, or the byte in hex.
std::string statusWord(std::uint8_t status);

/// Reading with as few GET requests as the negotiated sizes allow.
///
/// Ids go out ordered 32-, 16-, 8-bit (an unaligned value is a fault on small controllers); texts and raw values each
/// in a request of their own. The room for answers is computed here, because the board does not check it for every
/// register. A failing id ends an answer early: the values before it tell which one it was, the rest is asked again.
/// A refusal is believed when it comes twice: the id may have been damaged on its way, and payloads are not protected.
/// An answer that the codec refuses counts as lost.
class McpReads : public PlainReads<McpFacts> {
public:
    using PlainReads::PlainReads;

    void begin(std::vector<RegisterId> &ids);
    McpRequest request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const McpAnswer &answer, TimePoint now);

private:
    std::optional<RegisterId> m_doubted; ///< refused once
};

} // namespace drive
