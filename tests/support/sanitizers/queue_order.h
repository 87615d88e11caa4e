// ThreadSanitizer does not see the locks of Qt, because Debian's Qt is not instrumented: whatever a queued call or a job of a
// pool carries looks like a race, and so does what is ended after its thread. This tells it the order that there is: what comes
// before a call or a job is queued comes before what that does; what a thread or a job has done comes before the return of
// those who waited for it. Nothing in builds without it.
#pragma once

namespace support {

/// To be called once, before there is a second thread.
void tellQueueOrder();

} // namespace support
