// Requests and answers between the tasks of McbDrive and its link, as values: frames of them are made for the motion
// log alone (mcbChanges). And how registers are read and values become words.
#pragma once

#include "drive/mcb/catalog.h"
#include "drive/reader.h"
#include "drive/task.h"
#include "mcb/master.h"

#include <optional>
#include <span>
#include <string>
#include <variant>

namespace drive {

// The registers that this drive is driven by. Source: "MCB protocol description", section 7.
namespace mcbreg {
constexpr std::uint16_t kLastError = 0x00F, kControl = 0x010, kStatus = 0x011, kMode = 0x014,
                        kIq = 0x01A, kId = 0x01B, kPosition = 0x020, kVelocity = 0x021,
                        kProfileVelocity = 0x025, kProfileAcceleration = 0x026,
                        kProfileDeceleration = 0x027, kPositionNow = 0x030, kVelocityNow = 0x031,
                        kRatedCurrent = 0x100, kPolePairs = 0x106, kMaxCurrent = 0x1E0,
                        kMaxVelocity = 0x1E8, kEncoderCounts = 0x388, kVendor = 0x6E0,
                        kProduct = 0x6E1, kRevision = 0x6E2, kVersion = 0x6E4, kWeb = 0x6E5,
                        kSerial = 0x6E6, kPeakCurrent = 0x71F;
} // namespace mcbreg
/// Into kControl: ready, without power. The power stage goes off in every state but a fault, where it is off, and a
/// quick stop, which may hold the motor for ever.
constexpr std::uint16_t kShutdown = 0x06;
/// Into kControl, to stop: a quick stop ends with the disabling of the voltage alone (DS402).
inline std::uint16_t mcbStopWord(const McbFacts &board)
{
    return board.quickStop ? std::uint16_t{0x00} : kShutdown;
}
constexpr double kSecondsPerMinute = 60.0; ///< speeds are turns a second on the wire

/// The way into the cyclic state, and out of it.
struct McbMap {
    mcb::Mapping mapping;
};
struct McbUnmap { };
using McbRequest = std::variant<mcb::Master::Request, McbMap, McbUnmap>;

inline McbRequest mcbRead(std::uint16_t address)
{
    return mcb::Master::Request{mcb::Command::Read, address};
}
inline McbRequest mcbInfo(std::uint16_t address)
{
    return mcb::Master::Request{mcb::Command::GetInfo, address};
}
inline McbRequest mcbWrite(std::uint16_t address, mcb::Words words)
{
    return mcb::Master::Request{mcb::Command::Write, address, std::move(words)};
}
/// For the motion log: what it changes, in frames of the config state; empty if it changes nothing.
Bytes mcbChanges(const McbRequest &request);

struct McbAnswer {
    bool ok = false; ///< false: refused
    mcb::Words words; ///< of the answer
    std::uint32_t code = 0; ///< of the refusal
};

class McbIdentification;
class McbReads;
class McbVitals;
class McbWriteTask;
template <class P>
class RegisterWatch;

struct McbProtocol {
    using Request = McbRequest;
    using Answer = McbAnswer;
    using Facts = McbFacts;
    using Link = mcb::Master;
    using Identification = McbIdentification;
    using Vitals = McbVitals;
    using Watch = RegisterWatch<McbProtocol>;
    using Reads = McbReads;
    using Writes = McbWriteTask;
    static constexpr int kAttempts = 1;
    static std::vector<StateStep> stateSteps();
    static AnswerEnd endIn(const McbAnswer &answer);
};

/// In the place of a code, but ours: the drive took the value, and another one is read back.
constexpr std::uint32_t kOtherValueRead = 0xFFFFFFFF;

/// What a code means, and the code: "no such register (0x06020000)".
std::string mcbWordOf(std::uint32_t code);

/// Reading by one request a register. The link repeats what was lost, so what gets no answer here is given up.
class McbReads : public PlainReads<McbFacts> {
public:
    using PlainReads::PlainReads;

    McbRequest request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const McbAnswer &answer, TimePoint now) const;
};

/// A value as the catalogue has it, from the words of an answer; nothing if they are no such value.
std::optional<Value> mcbValueOf(const McbFacts &board, std::uint16_t address, mcb::WordView words);
/// Which words a value of a register is, or why it cannot be one.
Result<mcb::Words, std::string> mcbWordsOf(
    const McbFacts &board, std::uint16_t address, const Value &value);

} // namespace drive
