// Where the samples of fast columns and their finest extremes lie, in slices of fixed size. Slices are handed out from
// arenas of two mebibytes, so that no slice is rounded up to pages. An arena holds slices of one size, and is given
// back when the last of them is.
//
// Used in one thread (the one that appends); slices may be let go in any. Others may put the arenas elsewhere, e.g.
// into a file.
#pragma once

#include "capture/min_max_kernel.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace capture {

constexpr std::size_t kSliceSamples = 65536;
constexpr std::size_t kSliceBytes = kSliceSamples * sizeof(std::int16_t);
constexpr std::size_t kSliceRanges = kSliceSamples / 16; ///< one for sixteen samples
constexpr std::size_t kArenaBytes = std::size_t{2} << 20;

/// kSliceSamples codes that are not written yet.
using Slice = std::shared_ptr<std::int16_t[]>;
/// kSliceRanges extremes, as unwritten.
using RangeSlice = std::shared_ptr<CodeRange[]>;

class SampleMemory {
public:
    SampleMemory() = default;
    SampleMemory(const SampleMemory &) = delete;
    SampleMemory &operator=(const SampleMemory &) = delete;
    virtual ~SampleMemory() = default;

    Slice take();
    RangeSlice takeRanges();

protected:
    /// kArenaBytes bytes, aligned to a page, never nullptr; let go in any thread.
    virtual std::shared_ptr<std::byte> makeArena();

private:
    /// The arena that slices of one size are handed out from.
    struct Open {
        std::shared_ptr<std::byte> arena;
        std::size_t used = kArenaBytes; ///< bytes that are handed out
    };
    template <class Entry>
    std::shared_ptr<Entry[]> takeFrom(Open &open, std::size_t count);

    Open m_samples;
    Open m_ranges;
};

} // namespace capture
