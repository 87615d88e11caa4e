// What the tasks of a drive of the older serial protocol ask and are answered.
#pragma once

#include "drive/board_facts.h"
#include "legacy/protocol.h"
#include "legacy/reply.h"

#include <optional>
#include <string>

namespace legacy {
class Client;
}

namespace drive {

/// What is known of a board of the older serial protocol, shared by the parts of LegacyDrive. Plain data; filled by the
/// identification, read by everybody else.
struct LegacyFacts : BoardFacts {
    legacy::Dialect dialect = legacy::Dialect::Stm32;
    double bytesPerSecond = 11520.0; ///< of the line, in each direction
};

class LegacyIdentification;
class LegacyReads;
class LegacyVitals;
class LegacyWriteTask;

template <class P>
class DrawnWatch;

struct LegacyProtocol {
    using Request = legacy::Request;
    using Answer = legacy::Reply;
    using Facts = LegacyFacts;
    using Link = legacy::Client;
    using Identification = LegacyIdentification;
    using Vitals = LegacyVitals;
    using Watch = DrawnWatch<LegacyProtocol>;
    using Reads = LegacyReads;
    using Writes = LegacyWriteTask;
    static constexpr int kAttempts = 3;
    static std::optional<ReadStatus> refuseRead(const LegacyFacts &board, RegisterId id);
    static std::optional<std::string> refusalIn(const legacy::Reply &reply);
};

inline legacy::Request legacyRequest(int motor, legacy::Command command)
{
    return {static_cast<std::uint8_t>(motor), std::move(command)};
}
/// Why not, if the answer is a refusal; empty if it is none.
std::string nackWord(const legacy::Reply &reply);
std::optional<std::uint8_t> nackCode(const legacy::Reply &reply);

} // namespace drive
