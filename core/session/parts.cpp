// What a session is made of outside the tests.
#include "session/session.h"

#include "drive/make_drive.h"

#include <chrono>

namespace session {

namespace {

/// The one reading of a clock that a link depends on.
TimePoint readClock()
{
    return TimePoint(
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

} // namespace

Parts realParts()
{
    return {.clock = readClock, .transport = makeTransport, .drive = [](const Endpoint &endpoint) {
                return drive::makeDrive(endpoint.baud);
            }};
}

Session::Session(QObject *parent)
    : Session(realParts(), parent)
{
}

} // namespace session
