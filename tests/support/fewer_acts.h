// The steps that a failure needs: leaves out some of a list as long as the failure stays, larger parts first, until no
// step can be missed or there is no time left.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

namespace support {

/// @param fails  whether these steps, in their order, still fail in the same way
/// @param mayGoOn  false ends the search; what has been found by then is returned
inline std::vector<int> fewerActs(std::vector<int> acts,
    const std::function<bool(const std::vector<int> &)> &fails,
    const std::function<bool()> &mayGoOn)
{
    std::size_t part = (acts.size() + 1) / 2;
    while (part >= 1 && !acts.empty()) {
        bool left = false;
        // The last steps are the likeliest to matter: the first go first.
        for (std::size_t from = 0;
             from < acts.size() && (part < acts.size() || acts.size() == 1);) {
            if (!mayGoOn())
                return acts;
            std::vector<int> fewer = acts;
            const auto begin = fewer.begin() + static_cast<std::ptrdiff_t>(from);
            fewer.erase(
                begin, begin + static_cast<std::ptrdiff_t>(std::min(part, acts.size() - from)));
            if (fails(fewer)) {
                acts = std::move(fewer);
                left = true;
            } else {
                from += part;
            }
        }
        if (part == 1 && !left)
            break;
        if (!left || part >= acts.size())
            part = std::max<std::size_t>(1, std::min(part, acts.size()) / 2);
    }
    return acts;
}

} // namespace support
