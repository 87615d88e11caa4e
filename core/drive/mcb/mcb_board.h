// What is known of the MCB drive at the other end, shared by the parts of McbDrive. Plain data; filled by the
// identification, read by everybody else.
#pragma once

#include "drive/board_facts.h"
#include "mcb/value.h"

#include <map>

namespace drive {

struct McbBoard : BoardFacts {
    std::map<std::uint16_t, mcb::Info> infos; ///< what GET INFO said, by address
    mcb::TextOrder order = mcb::TextOrder::HighByteFirst;
    double countsPerTurn = 0.0; ///< of the position; 0: not known

    /// nullptr if the drive has no such register.
    const mcb::Info *infoOf(std::uint16_t address) const
    {
        const auto at = infos.find(address);
        return at == infos.end() ? nullptr : &at->second;
    }
    bool readable(std::uint16_t address) const
    {
        const mcb::Info *info = infoOf(address);
        return info != nullptr
            && (info->access == catalog::Access::Read
                || info->access == catalog::Access::ReadWrite);
    }
    bool writable(std::uint16_t address) const
    {
        const mcb::Info *info = infoOf(address);
        return info != nullptr
            && (info->access == catalog::Access::Write
                || info->access == catalog::Access::ReadWrite);
    }
};

} // namespace drive
