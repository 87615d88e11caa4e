#include "session/files/disk_sync.h"

#include <unistd.h>

namespace session {

bool syncToDisk(int handle)
{
#if defined(_POSIX_SYNCHRONIZED_IO) && _POSIX_SYNCHRONIZED_IO > 0
    return fdatasync(handle) == 0;
#else
    return fsync(handle) == 0;
#endif
}

} // namespace session
