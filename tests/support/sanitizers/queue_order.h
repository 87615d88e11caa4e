// ThreadSanitizer does not see the lock of Qt's event queue, because Debian's Qt is not instrumented: whatever a queued call
// carries looks like a race. This tells it the one order that there is: what comes before a call is queued comes before what
// happens when it is delivered. Nothing in builds without it.
#pragma once

namespace support {

/// To be called once, before there is a second thread.
void tellQueueOrder();

} // namespace support
