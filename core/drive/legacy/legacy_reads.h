// Reading by one GET after the other; the raw register of the rev-up takes one for each of its stages.
#pragma once

#include "drive/legacy/legacy_protocol.h"
#include "drive/legacy/legacy_registers.h"
#include "drive/reader.h"

#include <span>

namespace drive {

class LegacyReads : public PlainReads {
public:
    explicit LegacyReads(const LegacyFacts &board)
        : m_board(board)
    {
    }

    void begin(std::vector<RegisterId> & /*ids*/) { drop(); }
    void drop() { m_stages.clear(); }
    legacy::Request request(std::span<const RegisterId> ids, std::size_t &count) const;
    std::optional<std::vector<Reading>> readings(
        std::span<const RegisterId> ids, const legacy::Reply &answer, TimePoint now);

private:
    const LegacyFacts &m_board;
    Bytes m_stages; ///< of the rev-up, read until now
};

} // namespace drive
