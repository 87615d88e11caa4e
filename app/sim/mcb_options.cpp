#include "mcb_options.h"

#include <algorithm>
#include <charconv>

namespace sim {

std::optional<std::string> readServoProfile(std::string_view name, simulation::ServoOptions &servo)
{
    servo.newer = name == "newer";
    if (servo.newer || name == "summit-1.12")
        return std::nullopt;
    return "there is no profile \"" + std::string(name) + "\"; there are summit-1.12, newer";
}

std::optional<std::string> readMcbFaults(
    std::string_view list, std::vector<simulation::McbFaultChoice> &faults)
{
    constexpr std::uint32_t kMost = 1'000'000;
    while (!list.empty()) {
        const std::string_view item = list.substr(0, list.find(','));
        list.remove_prefix(std::min(list.size(), item.size() + 1));
        const std::size_t colon = item.find(':');
        const std::string_view name = item.substr(0, colon);
        const auto all = simulation::mcbFaultList();
        const auto row =
            std::find_if(all.begin(), all.end(), [=](const auto &one) { return one.name == name; });
        if (row == all.end())
            return "there is no lie \"" + std::string(name) + "\"; see --list-liars";
        simulation::McbFaultChoice choice{row->fault};
        if (colon != std::string_view::npos) {
            const std::string_view digits = item.substr(colon + 1);
            const char *const last = digits.data() + digits.size();
            const auto [end, error] = std::from_chars(digits.data(), last, choice.every);
            if (error != std::errc{} || end != last || choice.every < 1 || choice.every > kMost)
                return std::string(name) + ": the chance is one in 1 to 1000000, not \""
                    + std::string(digits) + '"';
        }
        faults.push_back(choice);
    }
    return std::nullopt;
}

} // namespace sim
