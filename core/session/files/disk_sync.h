// What a loss of power must not take: asks the system to put a file's data on the disk.
#pragma once

namespace session {

/// Returns when the data of the file is on the disk, as far as the disk tells the truth: milliseconds, or seconds on a
/// busy disk. @param handle  QFile::handle()
bool syncToDisk(int handle);

} // namespace session
