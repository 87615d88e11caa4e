// Pieces of files that are read as if they were memory. A disk that fails, or a file that has become shorter, is no
// death of the program: what cannot be read any more is zeros from then on, and a flag says that it happened, so that
// they are not shown any more. Where the system cannot do that the program ends as it did before.
#pragma once

#include <atomic>
#include <cstddef>

namespace session {

/// From now on a failure to read [bytes, bytes + size) sets the flag. @param failed  outlives the mapping
/// @return  false if there are too many: they are as unguarded as before
bool guardPiece(const std::byte *bytes, std::size_t size, std::atomic<bool> &failed);
/// Before it is unmapped.
void unguardPiece(const std::byte *bytes);

} // namespace session
