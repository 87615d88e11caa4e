#include "drive/mcb/catalog.h"

#include "base/text.h"
#include "drive/mcb/commands.h"
#include "mcb/dictionary.h"
#include "mcb/mapping.h"

#include <algorithm>
#include <array>
#include <span>

namespace drive {

using catalog::RegisterInfo;
using catalog::ValueType;

namespace {

struct Alias {
    std::uint16_t address;
    std::string_view name;
};
/// Standard names of the same thing. Gains have none: those of other drives are digits, these are V/A.
constexpr Alias kAliases[] = {{0x031, "SPEED_MEAS"}, {0x079, "SPEED_REF"}, {0x03B, "I_Q_MEAS"},
    {0x03C, "I_D_MEAS"}, {0x072, "I_Q_REF"}, {0x073, "I_D_REF"}, {0x038, "I_A"}, {0x039, "I_B"},
    {0x070, "V_Q"}, {0x071, "V_D"}, {0x060, "BUS_VOLTAGE"}, {0x067, "HEATS_TEMP"}};

struct Group {
    std::uint16_t first;
    std::string_view name;
};
/// Each up to the next one.
constexpr Group kGroups[] = {{0x000, "State"}, {0x018, "Set-points"}, {0x030, "Measurements"},
    {0x070, "Demands"}, {0x080, "Inputs and outputs"}, {0x096, "Demands"}, {0x100, "Motor"},
    {0x120, "Brake"}, {0x14F, "Commutation"}, {0x1E0, "Limits"}, {0x2E0, "Set-points"},
    {0x35F, "Sensors"}, {0x450, "Homing"}, {0x4FF, "Gains"}, {0x517, "State"}, {0x530, "Filters"},
    {0x590, "Gains"}, {0x5FC, "Inputs and outputs"}, {0x610, "Reactions"}, {0x630, "Protection"},
    {0x640, "Communication"}, {0x64D, "State"}, {0x650, "Communication"}, {0x6DB, "Storage"},
    {0x6E0, "Identity"}, {0x700, "Power stage"}};

constexpr catalog::StartRegisters kStart{{"DRV_OP_CMD"}, {}, {"CL_VEL_SET_POINT_VALUE"},
    {"CL_CUR_Q_SET_POINT"}, mcbControlOf, {}, {}, {"PROF_MAX_ACC", "PROF_MAX_DEC", "DRV_OP_CMD"}};

constexpr std::array<std::uint16_t, 10> kGains{
    0x500, 0x501, 0x505, 0x506, 0x50A, 0x50B, 0x50C, 0x511, 0x512, 0x513};
constexpr std::array<std::uint16_t, 5> kSpeeds{0x021, 0x025, 0x07B, 0x453, 0x454};
constexpr std::array<std::uint16_t, 6> kCurrents{0x01A, 0x01B, 0x01C, 0x01D, 0x07C, 0x07D};

bool isIn(std::span<const std::uint16_t> list, std::uint16_t address)
{
    return std::ranges::find(list, address) != list.end();
}

/// Can move or harm something as soon as it is written.
bool isDangerous(std::uint16_t address)
{
    return (address >= 0x010 && address <= 0x024) || (address >= 0x07B && address <= 0x07D)
        || (address >= 0x14F && address <= 0x157) || address == mcbreg::kMaxCurrent
        || address == mcbreg::kMaxVelocity || (address >= 0x630 && address <= 0x633)
        || (address >= 0x610 && address <= 0x61B) || (address >= 0x6DB && address <= 0x6DF)
        || isMcbMappingRegister(address);
}

std::string groupOf(std::uint16_t address)
{
    const auto next = std::ranges::find_if(
        kGroups, [address](const Group &group) { return group.first > address; });
    return std::string(std::prev(next)->name);
}

void name(RegisterInfo &info, std::uint16_t address)
{
    const mcb::Entry *entry = mcb::findEntry(address);
    info.name = entry != nullptr ? entry->name : "REGISTER_0x" + hexDigits(address, 3);
    if (entry != nullptr) {
        info.help = entry->description;
        info.unit = entry->unit;
        if (!entry->olderName.empty())
            info.aliases.push_back(entry->olderName);
    }
    for (const Alias &alias : kAliases)
        if (alias.address == address)
            info.aliases.emplace_back(alias.name);
}

} // namespace

bool isMcbMappingRegister(std::uint16_t address)
{
    return address == mcb::kStateRegister
        || (address >= mcb::kRxCountRegister
            && address <= mcb::kTxCountRegister + mcb::kMostMapped);
}

std::shared_ptr<const catalog::Catalog> mcbCatalogOf(
    const std::map<std::uint16_t, mcb::Info> &infos)
{
    std::vector<RegisterInfo> registers;
    for (const auto &[address, told] : infos) {
        RegisterInfo info;
        info.id = RegisterId{address} << kMcbMotorBits;
        name(info, address);
        info.group = groupOf(address);
        info.type = mcb::valueTypeOf(told);
        info.access = told.access;
        if (isMcbMappingRegister(address) && info.access == catalog::Access::ReadWrite)
            info.access = catalog::Access::Read;
        info.perMotor = address < 0x5FC;
        info.dangerous = isDangerous(address);
        if (const mcb::Entry *entry = mcb::findEntry(address))
            info.effect = entry->effect;
        // What the dictionary does not know may be anything.
        info.dangerous =
            info.dangerous || (info.writable() && info.effect != catalog::Effect::Kept);
        const bool scalar = catalog::widthOf(info.type) > 0;
        if (told.cyclic == mcb::Cyclic::Tx && scalar)
            info.streaming = catalog::Streaming::Fast;
        if (isIn(kGains, address) && scalar)
            info.gain = catalog::Gain::Numerator;
        if (info.unit == "rev/s" && scalar)
            info.quantity = catalog::Quantity::TurnsPerSecond;
        if (info.type == ValueType::F32 && isIn(kSpeeds, address))
            info.setPoint = catalog::SetPoint::Speed;
        else if (info.type == ValueType::F32 && isIn(kCurrents, address))
            info.setPoint = catalog::SetPoint::Current;
        registers.push_back(std::move(info));
    }
    return std::make_shared<const catalog::Catalog>(
        std::move(registers), 1, std::vector<catalog::Scales>{{}}, kStart);
}

} // namespace drive
