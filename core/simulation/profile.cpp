// The rows of the profile table.
#include "simulation/profile.h"

#include "simulation/simulated_board.h"

#include <array>

namespace simulation {

namespace {

constexpr std::array<Traits, 3> kProfiles{{
    {.profile = "mcsdk-6.4",
        .firmwareName = "ST MC SDK\tVer.6.4.0",
        .sdkVersion = 0x06040000,
        .decodesInInterrupt = false,
        .truncatesPingNumber = false,
        .invertsStartStop = false,
        .hasSoftReset = true,
        .hasHall = false,
        .hasOpenLoopAngle = true,
        .flushesOnFault = false,
        .scalesReadSpeeds = false,
        .asPrinted = false},
    {.profile = "mcsdk-6.2",
        .firmwareName = "ST MC SDK\tVer.6.2.0",
        .sdkVersion = 0x06020000,
        .decodesInInterrupt = true,
        .truncatesPingNumber = true,
        .invertsStartStop = true,
        .hasSoftReset = false,
        .hasHall = true,
        .hasOpenLoopAngle = false,
        .flushesOnFault = true,
        .scalesReadSpeeds = true,
        .asPrinted = false},
    {.profile = "spec",
        .firmwareName = "ST MC SDK\tVer.6.4.0",
        .sdkVersion = 0x060400C0,
        .decodesInInterrupt = false,
        .truncatesPingNumber = false,
        .invertsStartStop = false,
        .hasSoftReset = false,
        .hasHall = false,
        .hasOpenLoopAngle = false,
        .flushesOnFault = false,
        .scalesReadSpeeds = false,
        .asPrinted = true},
}};

} // namespace

const Traits *findTraits(std::string_view profile)
{
    for (const Traits &row : kProfiles) {
        if (row.profile == profile)
            return &row;
    }
    return nullptr;
}

std::vector<std::string> profileNames()
{
    std::vector<std::string> names;
    names.reserve(kProfiles.size());
    for (const Traits &row : kProfiles)
        names.emplace_back(row.profile);
    return names;
}

} // namespace simulation
