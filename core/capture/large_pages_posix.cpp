#include "capture/sample_memory.h"

#include <sys/mman.h>

namespace capture {

void preferLargePages(void *memory, std::size_t bytes)
{
#ifdef MADV_HUGEPAGE
    (void)madvise(memory, bytes, MADV_HUGEPAGE); // a wish; small pages are as right
#else
    (void)memory;
    (void)bytes;
#endif
}

} // namespace capture
