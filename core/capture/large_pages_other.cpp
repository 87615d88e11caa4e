#include "capture/large_pages.h"

namespace capture {

void preferLargePages(void * /*memory*/, std::size_t /*bytes*/) { }

} // namespace capture
