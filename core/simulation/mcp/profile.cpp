// The profiles, and the versions between which the SDK did what.
#include "simulation/mcp/profile.h"

#include "simulation/simulated_board.h"

#include <algorithm>
#include <array>

namespace simulation {

namespace {

constexpr std::uint32_t kAlways = 0xFFFFFF; ///< to the newest version read

struct Behaviour {
    bool Traits::*trait;
    std::uint32_t first, last; ///< 0xMMmmpp, both included
};

// One row a fact; the number behind it is the section of mcp-aspep that states it.
constexpr std::array kBehaviours{
    Behaviour{&Traits::decodesInInterrupt, 0x060000, 0x0602FF}, // 3.1
    Behaviour{&Traits::truncatesPingNumber, 0x060000, 0x060201}, // 3.2
    Behaviour{&Traits::ignoresMotorBits, 0x060000, 0x0601FF}, // 5
    Behaviour{&Traits::invertsStartStop, 0x060200, 0x060201}, // 4.2
    Behaviour{&Traits::hasCpuLoadClear, 0x060200, kAlways}, // 4.2
    Behaviour{&Traits::hasProfilerCommand, 0x060100, kAlways}, // 4.2
    Behaviour{&Traits::hasSoftReset, 0x060302, kAlways}, // 4.2
    Behaviour{&Traits::hasSensorSwitch, 0x060400, kAlways}, // 4.2
    Behaviour{&Traits::hasScaleConfig, 0x060200, kAlways}, // 8
    Behaviour{&Traits::nominalCurrentInDigits, 0x060000, 0x0601FF}, // 8
    Behaviour{&Traits::swapsPositionRamp, 0x060000, 0x060201}, // 8: seen in 6.1 and 6.2.1
    Behaviour{&Traits::flushesOnFault, 0x060100, 0x0602FF}, // 6.3
    Behaviour{&Traits::scalesReadSpeeds, 0x060000, 0x0603FF}, // 9
};

struct Profile {
    std::string_view name;
    std::uint32_t version; ///< 0xMMmmpp
    std::string_view firmwareName;
};

// The first is what a board is unless told otherwise.
constexpr std::array kProfiles{
    Profile{"mcsdk-6.4", 0x060400, "ST MC SDK\tVer.6.4.0"},
    Profile{"mcsdk-6.3", 0x060302, "ST MC SDK\tVer.6.3.2"},
    Profile{"mcsdk-6.2", 0x060200, "ST MC SDK\tVer.6.2.0"},
    Profile{"mcsdk-6.1", 0x060100, "ST MC SDK\tVer.6.1.0"},
    Profile{"mcsdk-6.0", 0x060000, "ST MC SDK\tVer.6.0.0"},
    Profile{"six-step", 0x060402, "ST MC SDK\tVer.6.4.2"},
    Profile{"hso", 0x060402, "ST MC SDK\tVer.6.4.2"},
};

constexpr Traits traitsOf(const Profile &profile)
{
    Traits traits{.profile = profile.name,
        .firmwareName = profile.firmwareName,
        .sdkVersion = profile.version << 8, // the low byte is 0 in releases
        .registerVersion = profile.version};
    for (const Behaviour &row : kBehaviours)
        traits.*row.trait = profile.version >= row.first && profile.version <= row.last;
    return traits;
}

/// No SDK: what the text of 2022 prints, under the number of a firmware that decodes like it.
constexpr Traits asPrinted()
{
    return {.profile = "spec",
        .firmwareName = "ST MC SDK\tVer.6.4.0",
        .sdkVersion = 0x060400C0, // "public release" in the low byte, as only the text has it
        .registerVersion = 0x060100,
        .nominalCurrentInDigits = true,
        .asPrinted = true};
}

constexpr auto kTraits = [] {
    std::array<Traits, kProfiles.size() + 1> rows{};
    for (std::size_t i = 0; i < kProfiles.size(); ++i)
        rows[i] = traitsOf(kProfiles[i]);
    rows.back() = asPrinted();
    return rows;
}();

} // namespace

const Traits *findTraits(std::string_view profile)
{
    const auto found = std::ranges::find(kTraits, profile, &Traits::profile);
    return found != kTraits.end() ? &*found : nullptr;
}

std::vector<std::string> profileNames()
{
    std::vector<std::string> names;
    names.reserve(kTraits.size());
    for (const Traits &row : kTraits)
        names.emplace_back(row.profile);
    return names;
}

} // namespace simulation
