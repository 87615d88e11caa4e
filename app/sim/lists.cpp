// Tables of names: profiles, motors, lies.
#include "lists.h"

#include "simulation/firmware/build.h"
#include "simulation/mcb/faults.h"
#include "simulation/mcp/liars.h"
#include "simulation/mcp/profile.h"
#include "simulation/plant/presets.h"
#include "simulation/simulated_board.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace sim {

namespace {

std::string row(std::string name, std::string_view text)
{
    constexpr std::size_t kColumn = 26;
    name.resize(std::max(name.size() + 1, kColumn), ' ');
    return name + std::string(text) + '\n';
}

std::string profileLine(const simulation::Traits &traits)
{
    if (traits.asPrinted)
        return "the printed specification, to the letter where that can work";
    std::string line = "firmware of MCSDK " + std::to_string(traits.sdkVersion >> 24) + '.'
        + std::to_string(traits.sdkVersion >> 16 & 0xFFU) + '.'
        + std::to_string(traits.sdkVersion >> 8 & 0xFFU);
    switch (simulation::buildFor(traits.profile, std::string_view()).family) {
    case simulation::Family::Foc:
        return line + ", field-oriented control";
    case simulation::Family::SixStep:
        return line + ", six-step: no datalog";
    case simulation::Family::Hso:
        return line + ", HSO/ZeST: other registers, per unit";
    }
    return line;
}

} // namespace

std::string profileList()
{
    std::string text;
    for (const std::string &name : simulation::profileNames())
        text += row(name, profileLine(*simulation::findTraits(name)));
    return text;
}

std::string optionList()
{
    std::string text;
    for (const simulation::BuildOption &option : simulation::buildOptions())
        text += row(std::string(option.name), option.help);
    return text;
}

std::string motorList()
{
    std::string text;
    for (const simulation::Preset &preset : simulation::presets())
        text += row(std::string(preset.name), preset.summary);
    return text;
}

std::string liarList()
{
    constexpr std::array<std::string_view, 5> kActs{
        "The link", "Answers", "Values", "The datalog", "The drive"};
    std::string text =
        "In brackets the chance at which it happens if none is given: one in so many.\n";
    std::optional<simulation::LieActs> acts;
    for (const simulation::LieInfo &info : simulation::lies()) {
        if (acts != info.acts)
            text += '\n' + std::string(kActs[static_cast<std::size_t>(info.acts)]) + '\n';
        acts = info.acts;
        std::string name = "  " + std::string(info.name);
        if (info.oneIn > 0)
            name += " (" + std::to_string(info.oneIn) + ')';
        text += row(std::move(name), info.help);
    }
    text += "\nOf rotorscope-sim mcb, one frame in a hundred if no chance is given\n";
    for (const simulation::McbFaultRow &fault : simulation::mcbFaultList())
        text += row("  " + std::string(fault.name), fault.help);
    return text;
}

} // namespace sim
