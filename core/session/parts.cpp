// What a session is made of outside the tests.
#include "session/session.h"

#if __has_include("drive/make_drive.h")
#include "drive/make_drive.h"
#define ROTORSCOPE_HAS_DRIVE
#endif

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
    Parts parts;
    parts.clock = readClock;
#ifdef ROTORSCOPE_HAS_DRIVE
    parts.transport = makeTransport;
    parts.drive = [](const Endpoint &endpoint) { return drive::makeDrive(endpoint.baud); };
#endif
    return parts;
}

Session::Session(QObject *parent)
    : Session(realParts(), parent)
{
}

} // namespace session
