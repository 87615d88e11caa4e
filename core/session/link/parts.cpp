// What a session is made of outside the tests.
#include "session/recording/replay.h"

#include "drive/protocol_table.h"
#include "session/link/wake_timer.h"

#include <chrono>

namespace session {

namespace {

/// The one reading of a clock that a link depends on: monotonic, and 0 when the session is made, so
/// that people see times of their session and not of the machine.
Clock makeClock()
{
    const auto start = std::chrono::steady_clock::now();
    return [start] {
        return TimePoint(
            std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start));
    };
}

std::unique_ptr<drive::Drive> makeDrive(const Endpoint &endpoint)
{
    if (isReplay(endpoint))
        return std::make_unique<recorded::ReplayDrive>();
    return drive::makeDrive({endpoint.protocol, endpoint.baud, endpoint.patience, endpoint.spoken});
}

} // namespace

Parts realParts()
{
    return {.clock = makeClock(),
        .transport = makeTransport,
        .drive = makeDrive,
        .elapsed = elapsedTime};
}

Session::Session(QObject *parent)
    : Session(realParts(), parent)
{
}

} // namespace session
