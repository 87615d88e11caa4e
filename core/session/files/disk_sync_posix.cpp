#include "session/files/disk_sync.h"

#include <fcntl.h>
#include <unistd.h>

namespace session {

bool syncToDisk(int handle)
{
#ifdef __APPLE__
    // There is no fdatasync, and fsync leaves the data in the disk's own memory.
    return fcntl(handle, F_FULLFSYNC) == 0;
#elif defined(_POSIX_SYNCHRONIZED_IO) && _POSIX_SYNCHRONIZED_IO > 0
    return fdatasync(handle) == 0;
#else
    return fsync(handle) == 0;
#endif
}

} // namespace session
