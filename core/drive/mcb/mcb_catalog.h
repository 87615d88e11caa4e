// The registers of an MCB drive for people: what GET INFO says of each, with the names, units and words of the dictionary.
// Pure functions.
#pragma once

#include "catalog/catalog.h"
#include "drive/mcb/mcb_board.h"

namespace drive {

constexpr unsigned kMcbMotorBits =
    3; ///< of an identifier below the address, as catalogues have them

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
