// What the tasks of a drive of the older serial protocol ask and are answered, and how registers are read with it.
#pragma once

#include "drive/board_facts.h"
#include "drive/fcp/registers.h"
#include "drive/reader.h"
#include "drive/task.h"
#include "fcp/protocol.h"
#include "fcp/reply.h"

#include <optional>
#include <span>
#include <vector>

namespace fcp {
class Client;
}

namespace drive {

/// What is known of a board of the older serial protocol, shared by the parts of FcpDrive. Plain data; filled by the
/// identification, read by the other parts.
struct FcpFacts : BoardFacts {
    fcp::Dialect dialect = fcp::Dialect::Stm32;
    double bytesPerSecond = 11520.0; ///< of the line, in each direction
};

class FcpIdentification;
class FcpReads;
class FcpVitals;
class FcpWriteTask;

template <class P>
class DrawnWatch;

struct FcpProtocol {
    using Request = fcp::Request;
    using Answer = fcp::Reply;
    using Facts = FcpFacts;
    using Link = fcp::Client;
    using Identification = FcpIdentification;
    using Vitals = FcpVitals;
    using Watch = DrawnWatch<FcpProtocol>;
    using Reads = FcpReads;
    using Writes = FcpWriteTask;
    static constexpr int kAttempts = 3;
    static std::vector<StateStep> stateSteps();
    static AnswerEnd endIn(const fcp::Reply &reply);
};

inline fcp::Request fcpRequest(int motor, fcp::Command command)
{
    return {static_cast<std::uint8_t>(motor), std::move(command)};
}
std::optional<std::uint8_t> nackCode(const fcp::Reply &reply);

/// Reading by one GET after the other; the raw register of the rev-up takes one for each of its stages.
class FcpReads : public PlainReads<FcpFacts> {
public:
    using PlainReads::PlainReads;

    void begin(std::vector<RegisterId> & /*ids*/) { drop(); }
    void drop() { m_stages.clear(); }
    static std::optional<ReadStatus> refuse(const FcpFacts &board, RegisterId id);
    fcp::Request request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const fcp::Reply &answer, TimePoint now);

private:
    Bytes m_stages; ///< of the rev-up, read until now
};

} // namespace drive
