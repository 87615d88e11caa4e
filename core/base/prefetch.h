// Tells the processor what will be needed soon, so that it comes from main memory while something else is computed.
#pragma once

#include <cstddef>
#include <span>

/// A hint: it changes nothing, and the bytes may be anywhere.
template <class T>
void prefetch(std::span<const T> soon)
{
#if defined(__GNUC__) || defined(__clang__)
    constexpr std::size_t kLine = 64; // bytes that come together
    const auto bytes = std::as_bytes(soon);
    for (std::size_t at = 0; at < bytes.size(); at += kLine)
        __builtin_prefetch(bytes.data() + at);
#else
    static_cast<void>(soon);
#endif
}
