// The Controller half of an ASPEP link, without I/O: it owns no port, no thread and no clock.
//
//   port bytes  --receive(bytes, now)-->  Controller  --takeOutput()--> bytes for the port
//   one timer   --handleTimeout(now)-->               --takeEvents()--> events for the owner
//
// After any call: send takeOutput() (respecting gapBefore), call handleSent() once it has left, act on
// takeEvents(), and arm one timer at nextTimeout().
//
// States:  Idle -connect-> Negotiating -own Beacon echoed-> Pinging -Ping, configured-> Connected
//          Connected -nack, time-out, bad header-> Recovering (drain, agreed Beacon until echoed, Ping) -> Connected
//          Connected -Ping reply says not configured-> the board was reset: Negotiating from the maxima again
//          any -attempts spent or no valid packet for `lostAfter`-> Idle, event Lost
//
// Rules of the wire that live here (firmware 6.0 to 6.4.2): never a second packet before the reply to the first;
// a pause between the header and the payload of a request; the maxima are offered first because boards only ever
// shrink; connected only after a Ping; resynchronisation by dialogue (exact Beacon echo), never by scanning.
#pragma once

#include "aspep/framer.h"
#include "aspep/packet.h"
#include "base/output.h"
#include "base/time.h"

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace aspep {

class Controller {
public:
    struct Config {
        Beacon offer; ///< all fields maximal; payload CRC not asked for (no firmware has one)
        std::uint32_t baud = 1843200; ///< time-outs are computed from it
        Duration payloadPause = std::chrono::microseconds(1500); ///< header to payload, > 0.5 ms is required
        Duration hostLatency = std::chrono::milliseconds(20); ///< what a USB adapter and the scheduler may add
        int attempts = 5; ///< how often one step of a dialogue is sent before the link counts as lost
        Duration keepAliveAfter = std::chrono::milliseconds(250); ///< silence after which a Ping is sent
        Duration suspectAfter = std::chrono::milliseconds(500); ///< no valid packet: event Suspect
        Duration lostAfter = std::chrono::milliseconds(1000); ///< no valid packet: event Lost
    };
    enum class State : std::uint8_t { Idle, Negotiating, Pinging, Connected, Recovering };
    enum class LostReason : std::uint8_t {
        NoAnswer, ///< nothing at all came back
        OnlyGarbage, ///< bytes came, but no valid packet: wrong speed, another protocol or noise
        NoAgreement, ///< the board answered, but never agreed on version or sizes
        Silence, ///< was connected, then nothing valid for `lostAfter`
        RecoveryFailed,
    };

    // Events, in the order in which they happened.
    struct Connected {
        Beacon agreed;
        bool afterReset = false; ///< the board was reset meanwhile: nothing it held can be relied on
    };
    struct Suspect { };
    struct Recovered { }; ///< connected again after Recovering; what it held still holds
    struct Lost {
        LostReason reason;
    };
    struct Response {
        Bytes payload;
    };
    /// The open request has no response. `executed`: the parity of a later Ping says that it was or was not
    /// carried out; empty if that cannot be known (reset, link lost).
    struct NoResponse {
        std::optional<bool> executed;
    };
    struct Async {
        Bytes payload;
    };
    using Event = std::variant<Connected, Suspect, Recovered, Lost, Response, NoResponse, Async>;

    struct Stats {
        std::uint64_t bytesIn = 0, bytesOut = 0;
        std::uint64_t packetsIn = 0, packetsOut = 0;
        std::uint64_t badHeaderCrc = 0; ///< header CRC wrong
        std::uint64_t unknownType = 0; ///< CRC right, type not known
        std::uint64_t inconsistent = 0; ///< doubled fields differ, zero fields not zero
        std::uint64_t tooLong = 0; ///< longer than what was negotiated
        std::uint64_t badPayloadCrc = 0;
        std::uint64_t torn = 0; ///< a packet whose end never came
        std::uint64_t unexpected = 0; ///< valid, but nothing was waiting for it
        std::uint64_t nacks = 0;
        std::uint64_t timeouts = 0;
        std::uint64_t recoveries = 0;
        std::uint64_t discardedBytes = 0; ///< thrown away while out of step
    };

    explicit Controller(Config config);

    void connect(TimePoint now);
    /// Forgets the link at once, without a word on the wire (the protocol has no disconnect).
    void reset();

    /// Queues one request. Only while canSend(); payload of 2 to agreed().rxMax() bytes.
    void sendRequest(ByteView payload, TimePoint now);
    bool canSend() const; ///< Connected, and no packet of ours waits for its reply

    /// The hurried way for Stop, allowed to break the one-packet rule. Connected and idle: sends the payload at
    /// once. A request open: waits min(its time-out, 50 ms), then tries BEACON, PING, payload by dialogue and after
    /// 20 ms without waiting for the echoes, at least 2 ms apart. Not connected: the same at once.
    /// An open request ends with NoResponse first. The reply, if any, is an ordinary Response or NoResponse.
    void sendUrgent(ByteView payload, TimePoint now);

    void receive(ByteView bytes, TimePoint now);
    void handleTimeout(TimePoint now); ///< early or repeated calls do nothing
    void handleSent(TimePoint now); ///< all output taken so far has left: reply time-outs count from here

    [[nodiscard]] std::vector<Output> takeOutput();
    [[nodiscard]] std::vector<Event> takeEvents();
    [[nodiscard]] std::optional<TimePoint> nextTimeout() const;

    State state() const;
    const Beacon &agreed() const; ///< meaningful from Connected on
    const Stats &stats() const;
    std::uint8_t linkId() const; ///< LIID of the last Ping reply
    Duration responseTimeout() const; ///< from baud rate and negotiated sizes
    // private members follow in the implementation
};

} // namespace aspep
