#include "capture/sample_memory.h"

#include <new>

namespace capture {

Slice SampleMemory::take()
{
    if (m_used == kArenaBytes) {
        m_arena = makeArena();
        m_used = 0;
    }
    auto *slice = reinterpret_cast<std::int16_t *>(m_arena.get() + m_used);
    m_used += kSliceBytes;
    // Shares the arena's life and points into it.
    Slice taken(std::shared_ptr<std::byte>(m_arena), slice);
    if (m_used == kArenaBytes)
        m_arena.reset(); // only its slices hold it
    return taken;
}

std::shared_ptr<std::byte> SampleMemory::makeArena()
{
    constexpr std::align_val_t kAlignment{kArenaBytes};
    auto *memory = static_cast<std::byte *>(::operator new(kArenaBytes, kAlignment));
    preferLargePages(memory, kArenaBytes);
    return {memory, [](std::byte *arena) { ::operator delete(arena, kAlignment); }};
}

} // namespace capture
