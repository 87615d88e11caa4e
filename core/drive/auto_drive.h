// Drive for a serial line whose protocol is not told. It tries the protocols one after the other and stays
// with the first whose board answers; from then on it is that protocol's drive, until disconnect().
//
// Order and why: first ASPEP, because the four bytes of its BEACON mean nothing to a board of the older protocol (a length
// that is too long, or a motor and a code that no board has) and a board of the newer one is left as it was. Then the
// older protocol, which begins with reads alone. In the first round the BEACONs end after a second: a board that is there
// and free answers the first. One that was left within a request needs many, and one that boots when the port opens may
// be silent for seconds: therefore ASPEP is tried once more behind the others before no answer is reported.
// Nothing that could move a motor is sent until the board is known.
//
// A board that refuses in the frames of another protocol has proved which one it speaks: that is tried next, and nothing
// else as long as its answers go on to prove it.
//
// A stop that is asked for before a board has answered goes out in every protocol: while it is sent blind, the
// candidates take turns, each with its own way of a stop without a link; then each stops what it finds.
#pragma once

#include "drive/protocol_table.h"

#include <memory>
#include <vector>

namespace drive {

/// @param candidates  at least one; in the order in which they are tried
std::unique_ptr<Drive> makeAutoDrive(
    std::vector<const ProtocolRow *> candidates, const LineOptions &options);

} // namespace drive
