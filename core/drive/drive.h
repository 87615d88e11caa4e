// Drive: one face for every protocol. A sans-IO machine: bytes and `now` in, bytes and events out.
//
// Call order: connect(), then receive()/handleTimeout()/submit() in any order. After any call: send takeOutput()
// (respecting gapBefore), call handleSent() once it has left, act on takeEvents(), arm one timer at nextTimeout().
// A drive is made read-only. Until arm() it has no way to write: wishes that write or move end NotSent.
#pragma once

#include "base/output.h"
#include "drive/event.h"
#include "drive/protocol.h"
#include "drive/wish.h"

#include <array>
#include <optional>
#include <vector>

namespace drive {

/// What is known of the board at a line from when it was heard last. A stop needs it where nothing is heard any more;
/// it outlives the link, the drive and the port.
struct LineMemory {
    std::optional<Protocol> spoken{}; ///< where the drive had to find out
    int motors = 1;
    /// The four bytes of a link that was agreed on, in its protocol's own words; a board takes no wider one.
    std::optional<std::array<std::uint8_t, 4>> agreed{};
};

class Drive {
public:
    Drive() = default;
    Drive(const Drive &) = delete;
    Drive &operator=(const Drive &) = delete;
    virtual ~Drive() = default;

    virtual void connect(TimePoint now) = 0;
    /// Ends streaming where the link still allows it, cancels open wishes, then LinkChanged{Closed}.
    /// Never stops a motor: that is decided by the caller.
    virtual void disconnect(TimePoint now) = 0;

    virtual void receive(ByteView bytes, TimePoint now) = 0;
    virtual void handleTimeout(TimePoint now) = 0; ///< early or repeated calls do nothing
    virtual void handleSent(TimePoint now) = 0; ///< all output taken so far has left
    /// An edge of the line by which the board says that it is ready for the next output; where there is none it is
    /// never called.
    virtual void handleReady(bool /*high*/, TimePoint) { }
    [[nodiscard]] virtual std::vector<Output> takeOutput() = 0;
    [[nodiscard]] virtual std::vector<Event> takeEvents() = 0;
    [[nodiscard]] virtual std::optional<TimePoint> nextTimeout() const = 0;

    /// Exactly one Ended event with the wish's id follows, now or later.
    virtual void submit(Wish wish, TimePoint now) = 0;

    /// Stops every motor, ahead of everything else, and keeps at it until the drive is seen idle and the motor at
    /// rest or the alarm is raised (StopProgress). Cancels queued wishes as NotSent and disarms.
    /// While disconnecting it comes first: the drive stays connected until disconnect() is called again.
    virtual void stop(TimePoint now) = 0;
    /// From stop() until there is evidence that nothing drives any motor, also one that was not known of before.
    virtual bool stopOpen() const = 0;
    /// What stops every motor that is known when this drive cannot send any more: for the guardian. Sent every
    /// 100 ms for a while, whatever comes back. Empty where nothing moves.
    [[nodiscard]] virtual std::vector<Output> stopScript() const { return {}; }
    /// Lets writes and motion pass until stop(), a lost link or disarm(). The user's own act.
    virtual void arm() = 0;
    virtual void disarm() = 0;
    virtual bool armed() const = 0;
    /// How long what comes may be gathered before it is given to receive(): some milliseconds where a board streams by
    /// itself, each of its motors was seen idle, and nothing is armed or being stopped. Zero: not at all.
    virtual Duration gathersFor() const { return {}; }
    /// Time has passed unattended: this program, or the whole computer, stood still. Disarms, tells the link as
    /// Suspect, and reads the states of the motors before anything but a stop; believed again once they are read.
    virtual void doubt(TimePoint) { disarm(); }

    /// From the drive that had this line before; ahead of connect(). It is for a stop that nothing answers.
    virtual void remember(const LineMemory &memory) = 0;
    /// What was remembered, and what the board has told since.
    virtual LineMemory memory() const = 0;
};

} // namespace drive
