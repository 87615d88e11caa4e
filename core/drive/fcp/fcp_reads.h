// Reading by one GET after the other; the raw register of the rev-up takes one for each of its stages.
#pragma once

#include "drive/fcp/fcp_protocol.h"
#include "drive/fcp/fcp_registers.h"
#include "drive/reader.h"

#include <span>

namespace drive {

class FcpReads : public PlainReads {
public:
    explicit FcpReads(const FcpFacts &board)
        : m_board(board)
    {
    }

    void begin(std::vector<RegisterId> & /*ids*/) { drop(); }
    void drop() { m_stages.clear(); }
    fcp::Request request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const fcp::Reply &answer, TimePoint now);

private:
    const FcpFacts &m_board;
    Bytes m_stages; ///< of the rev-up, read until now
};

} // namespace drive
