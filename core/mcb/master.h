// The master half of MCB, without I/O: exchanges of equal length go out as bytes, what came in at the same time is
// handed to receive(). One request at a time; every request ends once, as a Done event.
//
//   Closed -connect-> Meeting -a good frame-> Config <-on/off-> Cyclic
//   any of these -several bad frames in a row-> Seeking -length found-> Config or Cyclic;  else Lost
//
// Call order: after any call send takeOutput(), act on takeEvents(), arm a timer at nextTimeout(). Code that knows the
// ready line tells every edge of it by setReady(); without such a call the line counts as high, as behind a byte
// stream, where the end of the answer says so.
//
// Seeking: a probe of the greatest length that no slave accepts (its CRC is wrong, so nothing is written and no cyclic
// word taken), in whose answer the shortest whole frame tells the slave's length. So a slave that was reset in the
// cyclic state, one that is still cycling, and an ACK that was lost are all found out by one question.
//
// Source: "MCB protocol description"; mcblib 0.4.9 where it says so.
#pragma once

#include "base/output.h"
#include "mcb/error_code.h"
#include "mcb/fragments.h"
#include "mcb/mapping.h"

#include <optional>
#include <variant>

namespace mcb {

class Master {
public:
    struct Config {
        /// Request to answer. mcblib: 1000 ms by default, 500 ms in its examples.
        Duration answerWithin = std::chrono::milliseconds(500);
        /// Ready line high again after a frame; mcblib's time-out of a transfer.
        Duration readyWithin = std::chrono::milliseconds(1000);
        /// All bytes of an exchange are back. SPI needs none; ours, for byte streams.
        Duration exchangeWithin = std::chrono::milliseconds(200);
        /// The same while a Stop is wanted: it cannot wait for bytes that a line has lost.
        Duration hurriedExchangeWithin = std::chrono::milliseconds(50);
        /// Nothing is sent after a torn exchange: longer than our slaves keep an unfinished frame (50 ms).
        Duration quiet = std::chrono::milliseconds(60);
        Duration patience{}; ///< added to all of these, for computers that stall
    };

    enum class State : std::uint8_t { Closed, Meeting, Config, Cyclic, Seeking, Lost };

    struct Request {
        Command command = Command::Read; ///< GetInfo, Read or Write
        std::uint16_t address = 0;
        Words words{}; ///< of a write
        bool repeatable = false; ///< a write that may be sent again if its answer is lost
        /// From then on it is not sent any more, nor sent again.
        std::optional<TimePoint> leaveBy{};
    };

    enum class End : std::uint8_t {
        Ok,
        Refused, ///< `code` says why
        NotSent, ///< certainly not carried out
        Unknown, ///< sent, the answer was lost
    };
    enum class Cause : std::uint8_t {
        None,
        NoAnswer, ///< nothing at all, or IDLE until the time was over
        NotReady, ///< the ready line stays low
        DeadLow,
        DeadHigh,
        Garbage, ///< only frames with wrong CRCs
        Damaged, ///< the frame with the answer was
        TooLong, ///< a value of more than kMostValueWords
        Cancelled,
        Reset,
    };

    /// A request, or the way into or out of the cyclic state, has ended.
    struct Done {
        Request request; ///< of those ways: the step that ended it
        End end = End::Ok;
        Words words{}; ///< of the answer, whole config words
        std::uint32_t code = 0; ///< of a refusal
        Cause cause = Cause::None;
    };
    struct Met { }; ///< after connect(): the config state
    struct Cycle {
        std::int64_t tick = 0; ///< periods since the cyclic state began
        TimePoint at{}; ///< when the frame left
        Words input{}; ///< of the drive, as many as the mapping has
    };
    struct Searching { }; ///< out of step; nothing else goes on
    struct Back {
        /// The slave is in the config state, and was not asked to leave the cyclic one.
        bool afterReset = false;
    };
    struct Lost {
        Cause cause = Cause::None;
    };
    using Event = std::variant<Done, Met, Cycle, Searching, Back, Lost>;

    /// They only grow.
    struct Stats {
        std::uint64_t bytesIn = 0, bytesOut = 0;
        std::uint64_t exchanges = 0, goodFrames = 0;
        std::uint64_t damaged = 0; ///< wrong CRC, reserved bit, a master's command
        std::uint64_t dead = 0; ///< all zeros, all ones
        std::uint64_t torn = 0; ///< fewer bytes than were sent
        std::uint64_t unexpected = 0; ///< bytes that were not waited for
        std::uint64_t strays = 0; ///< answers to other requests
        std::uint64_t timeouts = 0, searches = 0;
        std::uint64_t cyclesLost = 0;
    };

    Master() = default;
    explicit Master(Config config);

    void connect(TimePoint now);
    void close(); ///< forgets everything; sends nothing

    State state() const { return m_state; }
    /// A request can be given now.
    bool canSend() const;
    bool ready() const { return !m_hasLine || m_ready; }
    void send(Request request, TimePoint now);
    /// Ends the request in hand at once, so that another may go: NotSent if it was not clocked out. A switch of the
    /// state that has left is not cut off.
    void cancel(TimePoint now);
    /// What was not clocked out ends NotSent; what was is not sent again. @return  whether it ended
    bool recall(TimePoint now);

    /// Maps and enters the cyclic state with a frame every `period`. Needs canSend() and mapping.possible().
    void switchOn(const Mapping &mapping, Duration period, TimePoint now, bool clearCounts = true);
    /// Frames that leave as they are, whether the drive is ready or not and whatever is under way, which takes care of
    /// itself afterwards. What comes back is thrown away.
    void sendBlind(std::vector<Output> frames, TimePoint now);
    /// From now on no request waits for the next frame of a slow cycle: it has frames of its own between those. Nor
    /// does it wait long for bytes that are missing from an exchange.
    void setHurried(bool hurried, TimePoint now);
    /// Back to the config state. Needs canSend().
    void switchOff(TimePoint now);
    /// What the drive gets in every cycle from now on; filled up with zeros.
    void setCyclicOutput(Words words) { m_cyclicOutput = std::move(words); }
    /// What the last cyclic frame took along; what was set behind it has not left.
    const Words &cyclicSent() const { return m_cyclicSent; }
    const Mapping &mapping() const { return m_mapping; }
    Duration period() const { return m_period; }

    void receive(ByteView bytes, TimePoint now);
    void setReady(bool high, TimePoint now);
    void handleTimeout(TimePoint now);
    [[nodiscard]] std::vector<Output> takeOutput() { return std::exchange(m_output, {}); }
    [[nodiscard]] std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const;
    const Stats &stats() const { return m_stats; }

private:
    struct Exchange {
        std::size_t length = 0;
        TimePoint at{}, by{};
        bool piece = false; ///< it carries a piece of the request
        std::optional<std::int64_t> tick{}; ///< of a frame of the cycle
        Bytes received{};
    };
    struct Operation {
        Request request;
        std::vector<Frame> pieces;
        std::size_t sent = 0; ///< pieces
        std::size_t exchanges = 0; ///< since the last piece left
        Gatherer gathered{};
        bool spoilt = false; ///< a frame was damaged since it was asked
        int tries = 1, idles = 0;
        std::optional<TimePoint> deadline{};
    };
    enum class Way : std::uint8_t { None, On, Off, Leave };

    void work(TimePoint now);
    bool mayExchange(TimePoint now) const;
    std::optional<Bytes> nextBytes(TimePoint now, Exchange &exchange);
    Frame operationFrame(Exchange &exchange, TimePoint now);
    Frame idle(std::uint16_t address) const;
    bool betweenCycles() const;
    TimePoint exchangeDue() const; ///< of the one under way
    void endBlind(TimePoint now);
    void hush(TimePoint now);
    void finish(TimePoint now);
    void finishGood(const Exchange &exchange, const Frame &frame, TimePoint now);
    void finishBad(FrameError error, TimePoint now);
    void finishTorn(TimePoint now);
    void checkReady(TimePoint now);
    void checkOperation(TimePoint now);

    // What an answer means (master_operation.cpp).
    void begin(Request request);
    void onAnswer(const Exchange &exchange, const Frame &frame, TimePoint now);
    void onAck(const Frame &frame, TimePoint now);
    void onRefusal(const Frame &frame, TimePoint now);
    void spoil(TimePoint now);
    bool mayRepeat() const;
    void repeat();
    bool isLate(TimePoint now) const;
    void giveUp(Cause cause, TimePoint now);
    void end(End end, TimePoint now, Words words = {}, std::uint32_t code = 0,
        Cause cause = Cause::None);
    void nextStep(Done done, TimePoint now);
    void switched(std::uint16_t state, TimePoint now);

    // Lengths (master_seek.cpp).
    void seek(TimePoint now);
    void onProbe(ByteView received, TimePoint now);
    void found(std::size_t words, TimePoint now);
    void meet();
    void lose(Cause cause, TimePoint now);

    Config m_config{};
    State m_state = State::Closed;
    std::optional<Exchange> m_exchange;
    std::optional<Operation> m_operation;
    std::size_t m_blindBytes = 0; ///< of blind frames, still to come back
    TimePoint m_blindBy{};
    TimePoint m_notBefore{};
    int m_drain = 0; ///< IDLE frames that may still bring left-over answers
    int m_bad = 0, m_torn = 0; ///< in a row
    Cause m_lastBad = Cause::None;

    bool m_hasLine = false, m_ready = true;
    std::optional<TimePoint> m_readyBy; ///< something wants to go and the line is low

    Way m_way = Way::None;
    std::vector<MappingStep> m_steps;
    std::size_t m_step = 0;
    bool m_cancelled = false; ///< no further step on the way into the cyclic state
    Mapping m_mapping;
    std::size_t m_words = 0; ///< of a frame now
    Duration m_period{};
    TimePoint m_cycleStart{};
    std::int64_t m_nextTick = 0;
    std::optional<TimePoint> m_hurried; ///< since then
    Words m_cyclicOutput, m_cyclicSent;

    bool m_wasCyclic = false, m_met = false; ///< before the search
    bool m_leaving = false; ///< asked to leave the cyclic state since it was entered
    int m_probes = 0;
    std::optional<std::size_t> m_probed; ///< bytes of a frame, seen once
    std::optional<Request> m_doubtful; ///< the switch whose ACK was lost

    std::vector<Output> m_output;
    std::vector<Event> m_events;
    Stats m_stats;
};

} // namespace mcb
