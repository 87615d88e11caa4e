// Guardian: a small child process that stops the motors when this program dies or freezes while it drives one. It is
// not in the way of the data: it holds a duplicate of the port's descriptor, knows one page of shared memory with the
// bytes that stop the motors, and waits for the end of this program or for a stamp that does not come. Then it sends
// those bytes every 100 ms for two seconds, lets go of the port and says so on standard error and in the system's log.
// It reads nothing that comes back, parses nothing and starts nothing.
//
// Beside it the same bytes leave from this program itself when it crashes, and when a library calls exit(), as Qt
// does when the screen is gone.
//
// It is no safety function: it ends with the computer, and bytes on a broken cable stop nothing. Not on Windows.
#pragma once

#include "base/output.h"

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

namespace session {

class Guardian {
public:
    /// While a motor is driven the session stamps at least this often; without a stamp for kFrozenAfter it counts as
    /// frozen.
    static constexpr Duration kStampEvery = std::chrono::milliseconds(500);
    static constexpr Duration kFrozenAfter = std::chrono::milliseconds(3000);
    static constexpr Duration kRepeat = std::chrono::milliseconds(100);
    static constexpr int kRepetitions = 20;
    static constexpr const char *kName = "motor-guardian"; ///< of the process

    /// What it did with the port that it watches.
    enum class Act : std::uint8_t {
        None,
        Stopping, ///< it sends now: no other may
        Stopped, ///< and has let go of the port
    };

    Guardian() = default;
    Guardian(const Guardian &) = delete;
    Guardian &operator=(const Guardian &) = delete;
    virtual ~Guardian() = default;

    /// A port from now on, instead of the one before. @param descriptor  -1: one that cannot be sent to
    virtual void watch(int descriptor) = 0;
    /// Before the port is closed.
    virtual void letGo() = 0;
    /// What stops every motor (drive::Drive::stopScript()). @param baud  of the line: how long bytes take
    virtual void setScript(const std::vector<Output> &script, std::uint32_t baud) = 0;
    /// Whether this program drives a motor; only then does it act. Stamps, too.
    virtual void setDriven(bool driven) = 0;
    virtual void stamp() = 0;
    virtual Act act() const = 0;
};

/// Forks the child and installs the hooks for crashes and exit(). First thing in main(): before any thread, and so
/// before the window. nullptr where there is none; `why` says it then.
std::shared_ptr<Guardian> startGuardian(const char *&why);

} // namespace session
