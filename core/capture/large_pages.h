// Memory that is filled from end to end is cheaper in large pages: the system clears one of two mebibytes at once
// instead of interrupting the append 512 times, and the processor keeps one address for it.
#pragma once

#include <cstddef>

namespace capture {

/// Asks the system for them; a hint, which may change nothing. Many systems give them only where they are asked for.
/// @param memory  aligned to a large page, nothing written yet
void preferLargePages(void *memory, std::size_t bytes);

} // namespace capture
