#include "capture/large_pages.h"

#include <sys/mman.h>

namespace capture {

void preferLargePages(void *memory, std::size_t bytes)
{
    (void)::madvise(memory, bytes, MADV_HUGEPAGE);
}

} // namespace capture
