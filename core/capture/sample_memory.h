// Where the samples of fast columns lie, in slices of fixed size. Slices are handed out from arenas of two mebibytes,
// which the system is asked to back with one page each: handing out 512 small pages instead costs as much time as
// decoding the samples that go into them. An arena is given back when the last of its slices is.
//
// Used in one thread (whoever appends); slices may be let go in any. Others may put the arenas elsewhere, e.g. into a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace capture {

constexpr std::size_t kSliceSamples = 65536;
constexpr std::size_t kSliceBytes = kSliceSamples * sizeof(std::int16_t);
constexpr std::size_t kArenaBytes = std::size_t{2} << 20;

/// kSliceSamples codes that nobody has written yet.
using Slice = std::shared_ptr<std::int16_t[]>;

class SampleMemory {
public:
    SampleMemory() = default;
    SampleMemory(const SampleMemory &) = delete;
    SampleMemory &operator=(const SampleMemory &) = delete;
    virtual ~SampleMemory() = default;

    Slice take();

protected:
    /// kArenaBytes bytes, aligned to a page, never nullptr; let go in any thread.
    virtual std::shared_ptr<std::byte> makeArena();

private:
    std::shared_ptr<std::byte> m_arena;
    std::size_t m_used = kArenaBytes; ///< bytes of m_arena that are handed out
};

/// Asks the system for large pages; where it has none, nothing happens.
void preferLargePages(void *memory, std::size_t bytes);

} // namespace capture
