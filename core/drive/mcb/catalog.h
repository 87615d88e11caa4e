// The registers of an MCB drive for people: what GET INFO says of each, with the names, units and words of the
// dictionary. Pure functions.
#pragma once

#include "catalog/catalog.h"
#include "drive/board_facts.h"
#include "mcb/value.h"

#include <map>

namespace drive {

/// What is known of the drive at the other end, shared by the parts of McbDrive. Plain data; filled by the
/// identification.
struct McbFacts : BoardFacts {
    std::map<std::uint16_t, mcb::Info> infos; ///< what GET INFO said, by address
    mcb::TextOrder order = mcb::TextOrder::HighByteFirst;
    double countsPerTurn = 0.0; ///< of the position; 0: not known
    bool quickStop = false; ///< the drive was last seen in a quick stop

    /// nullptr if the drive has no such register.
    const mcb::Info *infoOf(std::uint16_t address) const
    {
        const auto at = infos.find(address);
        return at == infos.end() ? nullptr : &at->second;
    }
    bool readable(std::uint16_t address) const { return allows(address, catalog::Access::Read); }
    bool writable(std::uint16_t address) const { return allows(address, catalog::Access::Write); }

private:
    bool allows(std::uint16_t address, catalog::Access access) const
    {
        const mcb::Info *info = infoOf(address);
        return info != nullptr
            && (info->access == access || info->access == catalog::Access::ReadWrite);
    }
};

/// Of an identifier below the address, as catalogues have them.
constexpr unsigned kMcbMotorBits = 3;

constexpr RegisterId mcbIdOf(std::uint16_t address)
{
    return RegisterId{address} << kMcbMotorBits | 1U;
}
constexpr std::uint16_t mcbAddressOf(RegisterId id)
{
    return static_cast<std::uint16_t>(id >> kMcbMotorBits);
}

/// The communication state and the mapping: written by streaming alone.
bool isMcbMappingRegister(std::uint16_t address);

std::shared_ptr<const catalog::Catalog> mcbCatalogOf(
    const std::map<std::uint16_t, mcb::Info> &infos);

} // namespace drive
