// The Controller half of an ASPEP link, without I/O: it owns no port, no thread and no clock.
//
//   port bytes  --receive(bytes, now)-->  Controller  --takeOutput()--> bytes for the port
//   one timer   --handleTimeout(now)-->               --takeEvents()--> events for the owner
//
// After any call: send takeOutput() (respecting gapBefore), call handleSent() once it has left, act on takeEvents(),
// and arm one timer at nextTimeout().
//
// States:  Idle -connect-> Negotiating -own Beacon echoed-> Pinging -Ping, configured-> Connected
//          Connected -nack, time-out, bad header-> Recovering (Ping; after damage: drain, Ping, the
//                    agreed Beacon until echoed, Ping) -> Connected
//          Connected -Ping reply says not configured-> the board was reset: Negotiating from the maxima again
//          any -attempts spent or no valid packet for `lostAfter`-> Idle, event Lost
//
// Rules of the wire that it keeps (firmware 6.0 to 6.4.2): never a second packet before the reply to the first; a
// pause between the header and the payload of a request; the maxima are offered first because boards only ever shrink;
// connected only after a Ping; resynchronisation by dialogue (exact Beacon echo). Where two packets of the stream in a
// row prove that the line is in step, the dialogue need not wait for silence, and the stream goes on meanwhile; it is
// not left out.
#pragma once

#include "aspep/framer.h"
#include "aspep/negotiation.h"
#include "aspep/packet.h"
#include "aspep/sender.h"
#include "base/output.h"
#include "base/time.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace aspep {

class Controller {
public:
    static constexpr int kSilentOffers = 66;
    struct Config {
        Beacon offer{}; ///< all fields maximal; payload CRC not asked for (no firmware has one)
        std::uint32_t baud = 1843200; ///< time-outs are computed from it
        /// Header to payload, > 0.5 ms is required.
        Duration payloadPause = std::chrono::microseconds(1500);
        /// What a USB adapter and the scheduler may add.
        Duration hostLatency = std::chrono::milliseconds(20);
        Duration patience{}; ///< how much later still a reply may come; more on busy computers
        /// How often a step of a dialogue is sent until the link is lost; oftener into silence.
        int attempts = 5;
        /// Beacons into perfect silence. A program may have fallen silent within a request: the board waits for the
        /// rest without a time-out and swallows them, four bytes each. So many fill the largest request of the usual
        /// firmware, 256 bytes. Fewer only where this is not the last attempt; once connected so many are sent anyway.
        int firstSilentOffers = kSilentOffers;
        /// Silence after which a Ping is sent.
        Duration keepAliveAfter = std::chrono::milliseconds(250);
        Duration suspectAfter = std::chrono::milliseconds(500); ///< no valid packet: event Suspect
        Duration lostAfter = std::chrono::milliseconds(1000); ///< no valid packet: event Lost
    };
    enum class State : std::uint8_t { Idle, Negotiating, Pinging, Connected, Recovering };
    enum class LostReason : std::uint8_t {
        NoAnswer, ///< nothing at all came back
        OnlyGarbage, ///< bytes came, but no valid packet: wrong speed, another protocol or noise
        OldProtocol, ///< the first bytes were a refusal in the frame of the protocol before this one
        NoAgreement, ///< the board answered, but never agreed on version or sizes
        Silence, ///< was connected, then nothing valid for `lostAfter`
        RecoveryFailed,
    };

    // Events, in the order in which they happened.
    /// Nothing that the board held before can be relied on.
    struct Connected {
        Beacon agreed;
        bool afterReset = false; ///< it has said that it was reset; else it may have been
    };
    struct Suspect { };
    struct Recovered { }; ///< connected again after Recovering; what it held still holds
    struct Lost {
        LostReason reason;
    };
    struct Response {
        Bytes payload;
    };
    /// The open request has no response. `executed`: the parity of a later Ping says that it was or was not carried
    /// out; empty if that cannot be known (reset, link lost).
    struct NoResponse {
        std::optional<bool> executed;
    };
    /// Told when what follows has shown that it was whole, or nothing has followed for a moment.
    struct Async {
        Bytes payload;
        TimePoint at; ///< when its end came
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

    /// What was agreed on this line before this machine was made. Only what goes out without an answer makes use of it.
    void remember(const Beacon &agreed) { m_negotiation.remember(agreed); }

    void connect(TimePoint now);
    /// Forgets the link at once, without a word on the wire (the protocol has no disconnect).
    /// An open request ends with NoResponse.
    void reset();

    /// Queues one request. Only while canSend(); payload of 2 to agreed().rxMax() bytes.
    void sendRequest(ByteView payload, TimePoint now);
    bool canSend() const; ///< Connected, and no packet of ours waits for its reply

    /// The hurried way for Stop, allowed to break the one-packet rule. Connected and idle: sends the payload at once. A
    /// request open: waits min(its time-out, 50 ms), then tries BEACON, PING, payload by dialogue and after 20 ms
    /// without waiting for the echoes, at least 2 ms apart. Not connected: the same at once. An open request ends with
    /// NoResponse first. The reply, if any, is an ordinary Response or NoResponse.
    void sendUrgent(ByteView payload, TimePoint now);
    /// It has not left yet: another would begin the wait anew, or take the line from it.
    bool urgentWaits() const;

    /// The payloads as they go out without an answer: BEACON, PING, the payloads, and at last enough BEACONs to end a
    /// payload that a board may still wait for. Changes nothing here.
    std::vector<Output> blindScript(const std::vector<Bytes> &payloads) const
    {
        return m_sender.blindScript(payloads, m_negotiation.known());
    }

    void receive(ByteView bytes, TimePoint now);
    void handleTimeout(TimePoint now); ///< early or repeated calls do nothing
    /// All output taken so far has left: reply time-outs count from here.
    void handleSent(TimePoint now) { m_sender.handleSent(responseTimeout(), now); }

    [[nodiscard]] std::vector<Output> takeOutput() { return m_sender.takeOutput(); }
    [[nodiscard]] std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    [[nodiscard]] std::optional<TimePoint> nextTimeout() const;

    State state() const { return m_state; }
    /// Meaningful from Connected on.
    const Beacon &agreed() const { return m_negotiation.agreed(); }
    const Stats &stats() const { return m_stats; }
    std::uint8_t linkId() const { return m_linkId; } ///< LIID of the last Ping reply
    Duration responseTimeout() const; ///< from baud rate and negotiated sizes

private:
    /// What the machine is doing within its State.
    enum class Step : std::uint8_t {
        None, ///< Idle, or Connected with nothing open
        Waiting, ///< a request's response is due
        KeepingAlive, ///< a Ping's reply is due, while Connected
        Draining, ///< out of step: waits for silence
        Resting, ///< in step: waits a moment before the dialogue goes on
        Probing, ///< first words of a recovery: Pings that show whether the board was reset
        Offering, ///< a Beacon's echo is due
        Settling, ///< echoed, but late echoes of earlier Beacons may still come
        Pinging, ///< the reply of the Ping that connects is due
    };
    /// Silence after an async packet that shows that nothing of it was missing: its own rest would have come at once.
    static constexpr Duration kWhole = std::chrono::milliseconds(2);
    /// Silence after which what follows is not taken for the rest of a packet.
    static constexpr Duration kLongSilence = std::chrono::milliseconds(550);

    struct Urgent {
        enum class Stage : std::uint8_t { Patience, Dialogue, Sent };
        Bytes payload;
        Stage stage = Stage::Patience;
        State before = State::Idle; ///< where to go on if the dialogue leads nowhere
        TimePoint until; ///< when the stage ends by itself
        TimePoint begun{}; ///< the dialogue
    };

    /// What the board's silence will bring, and when.
    struct Health {
        std::optional<TimePoint> suspect, keepAlive, lost;
    };

    // controller.cpp: what goes out, what comes in, what time brings
    void send(const Packet &packet, Duration gap, TimePoint now);
    void sendData(ByteView payload, Duration gap, TimePoint now);
    void sendPing(Duration gap, TimePoint now);
    /// The packet under way began before what it would answer had left.
    bool tooSoon() const { return !m_sender.answerable(m_packetBegan); }
    void onPacket(Packet &packet, TimePoint now);
    void onData(const Data &data, Bytes &payload, TimePoint now);
    void withdrawResponse();
    void tellAsync();
    void onNack(TimePoint now);
    void onFault(Framer::Step what, TimePoint now);
    void onTorn(TimePoint now);
    void damage();
    void ignore() { ++m_stats.unexpected; }
    static bool reached(const std::optional<TimePoint> &due, TimePoint now)
    {
        return due && now >= *due;
    }
    void onStepOver(TimePoint now);
    void onReplyTimeout(TimePoint now);
    void countFault(Framer::Step what);
    void endRequest(std::optional<bool> executed);
    std::optional<TimePoint> stepEnd() const;
    std::optional<TimePoint> tornAt() const;
    State judgedState() const;
    bool linked() const;
    Health health() const;
    void checkHealth(TimePoint now);

    // controller_dialogue.cpp: how a link comes about and is mended
    void negotiate(TimePoint now);
    void offer(TimePoint now, Duration gap = {});
    void ping(Step step, TimePoint now);
    const Beacon &offered() const;
    void onBeacon(const Beacon &answer, TimePoint now);
    void onPing(const Ping &reply, TimePoint now);
    void acceptAnswer(TimePoint now);
    void afterEcho(TimePoint now);
    void enterConnected(const Ping &reply, TimePoint now);
    void onNotConfigured(TimePoint now);
    void recover(TimePoint now);
    void drain(TimePoint now, Duration quiet);
    void onDrainOver(TimePoint now);
    void rest(TimePoint now, Duration pause);
    void goOn(TimePoint now);
    void retry(TimePoint now);
    std::optional<TimePoint> spentAt() const;
    Duration dialogueLimit() const;
    void lose(LostReason reason);
    LostReason outageFailure() const;
    LostReason connectFailure() const;

    // controller_urgent.cpp
    void startUrgentDialogue(TimePoint now);
    bool underWay(TimePoint now) const;
    void sendBlind(TimePoint now);
    void onUrgentDue(TimePoint now);
    void endBlind(TimePoint now);
    bool blind() const;
    const Beacon &blindOffer() const;
    bool hurried() const;

    Config m_config;
    Framer m_framer;
    Sender m_sender;
    Negotiation m_negotiation;
    State m_state = State::Idle;
    Step m_step = Step::None;
    bool m_afterReset = false;
    bool m_inDoubt = false; ///< a Beacon has left in this outage before a Ping told of a reset
    bool m_parity = false; ///< what the next Ping should say if no request is lost
    std::uint8_t m_linkId = 0;
    std::uint16_t m_number = 0; ///< of the last Ping

    bool m_requestOpen = false; ///< its end has not been told yet
    std::optional<Urgent> m_urgent;

    TimePoint m_packetBegan; ///< when the first bytes of the packet under way came
    TimePoint m_lastByte;
    TimePoint m_lastValid;
    bool m_suspect = false;
    bool m_tornTold = false; ///< that the packet under way does not go on
    bool m_heardBytes = false; ///< since connect()
    Bytes m_firstHeard; ///< the first four bytes since connect()
    bool m_heardAnswer = false; ///< a Beacon or Ping that can be an answer, since connect()

    TimePoint m_dialogueStart;
    TimePoint m_outageStart; ///< last valid packet before the recovery
    TimePoint m_restUntil;
    TimePoint m_drainStart;
    Duration m_quiet{}; ///< silence that ends the drain
    int m_attempts = 0; ///< packets of the dialogue since it last moved on
    int m_rounds = 0; ///< how often the dialogue had to go back
    int m_echoesLeft = 1; ///< exact echoes still wanted before the Ping
    bool m_probed = false; ///< in this recovery the board has said that it was not reset
    bool m_damaged = false; ///< something bad was heard: only Beacon and Ping mend that

    std::vector<Event> m_events;
    std::optional<Async> m_async; ///< not told yet: payloads are not protected
    Stats m_stats;
};

} // namespace aspep
