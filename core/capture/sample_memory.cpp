#include "capture/sample_memory.h"

#include "capture/large_pages.h"

#include <new>

namespace capture {

template <class Entry>
std::shared_ptr<Entry[]> SampleMemory::takeFrom(Open &open, std::size_t count)
{
    if (open.used == kArenaBytes) {
        open.arena = makeArena();
        open.used = 0;
    }
    auto *slice = reinterpret_cast<Entry *>(open.arena.get() + open.used);
    open.used += count * sizeof(Entry);
    // Shares the arena's life and points into it.
    std::shared_ptr<Entry[]> taken(open.arena, slice);
    if (open.used == kArenaBytes)
        open.arena.reset(); // only its slices hold it
    return taken;
}

Slice SampleMemory::take()
{
    static_assert(kArenaBytes % kSliceBytes == 0);
    return takeFrom<std::int16_t>(m_samples, kSliceSamples);
}

RangeSlice SampleMemory::takeRanges()
{
    static_assert(kArenaBytes % (kSliceRanges * sizeof(CodeRange)) == 0);
    return takeFrom<CodeRange>(m_ranges, kSliceRanges);
}

std::shared_ptr<std::byte> SampleMemory::makeArena()
{
    constexpr std::align_val_t kAlignment{kArenaBytes};
    void *const memory = ::operator new(kArenaBytes, kAlignment);
    preferLargePages(memory, kArenaBytes);
    return {static_cast<std::byte *>(memory),
        [](std::byte *arena) { ::operator delete(arena, kAlignment); }};
}

} // namespace capture
