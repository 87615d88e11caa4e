#include "capture/sample_memory.h"

namespace capture {

void preferLargePages(void *, std::size_t) { }

} // namespace capture
