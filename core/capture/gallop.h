// A search among rising things from where one is, for walks that go on by about as much each time.
#pragma once

#include <algorithm>
#include <cstddef>

namespace capture {

/// The last of `count` things that begins, of which `low` is one, as far as is known; those behind the last do not.
/// @param stride  how far it is likely to be, at least 1
/// @param begins  called with a number below `count`
template <class Begins>
std::size_t lastThatBegins(std::size_t low, std::size_t stride, std::size_t count, Begins begins)
{
    std::size_t high = std::min(low + stride, count); // does not
    std::size_t reach = 1;
    if (high < count && begins(high)) {
        low = high;
        while (low + reach < count && begins(low + reach)) {
            low += reach;
            reach *= 2;
        }
        high = std::min(low + reach, count);
    } else {
        while (high - low > reach && !begins(high - reach)) {
            high -= reach;
            reach *= 2;
        }
        if (high - low > reach)
            low = high - reach;
    }
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (begins(middle) ? low : high) = middle;
    }
    return low;
}

} // namespace capture
