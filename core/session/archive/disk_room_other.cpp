#include "session/archive/disk_room.h"

namespace session {

void reserveRoom(int /*handle*/, std::int64_t /*from*/, std::int64_t /*size*/) { }

} // namespace session
