// What code a thread runs once it has computed for a given time, as the names of its functions.
#pragma once

#include <string>
#include <vector>

namespace support {

/// From now on, in this thread alone; 0: not any more. One at a time in a process.
void noteCodeAfter(double seconds);

/// The innermost first; empty if that time was not reached, or the system does not tell.
std::vector<std::string> codeThatRan();

} // namespace support
