#include "session/files/disk_sync.h"

#include <io.h>

namespace session {

bool syncToDisk(int handle) { return _commit(handle) == 0; }

} // namespace session
