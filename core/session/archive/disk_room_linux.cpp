#include "session/archive/disk_room.h"

#include <fcntl.h>

namespace session {

void reserveRoom(int handle, std::int64_t from, std::int64_t size)
{
    // FALLOC_FL_KEEP_SIZE: a program that ends on the way leaves no zeros behind.
    [[maybe_unused]] const int result =
        fallocate(handle, FALLOC_FL_KEEP_SIZE, static_cast<off_t>(from), static_cast<off_t>(size));
}

} // namespace session
