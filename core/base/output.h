// What a machine wants to put on the wire, and how long the wire has to rest before it.
#pragma once

#include "base/bytes.h"
#include "base/time.h"

/// Bytes that belong together. `gapBefore` is the least time between the end of the bytes before it and its own
/// first byte, on the wire: the owner hands the earlier bytes to the port, waits until they have left and the gap
/// has passed, and only then writes these. Receivers that re-arm slowly lose what comes sooner.
struct Output {
    Bytes bytes;
    Duration gapBefore{};
    /// What was handed over before and has not left is dropped, also by the port: it is older than a stop.
    bool dropsEarlier = false;
};
