// The master's end of the older serial protocol: one request at a time, each with exactly one end. It owns no port and
// no clock; what may be asked, and when, is decided above.
//
// Replies carry neither a number nor the motor, so an answer that comes late could be taken for another's. Therefore
// nothing is asked while an answer may still be on its way: what has a wrong check, a wrong length or a wrong kind is
// followed by silence (kSettle), a lost answer by the recovery below. Only what is urgent goes out regardless: then
// as much as an answer has to come back before that silence counts, and no answer is believed until it is over.
//
// Recovery, because firmware 5.4.3 holds a broken frame for ever: silence; then single bytes 0xFF, which fill a hanging
// frame up until the board refuses it, or are passed over where none hangs; then GET_BOARD_INFO. Twice, then the link
// is lost. In about one case of 256 a filled-up frame is executed by chance: while a motor may turn, GET_BOARD_INFO is
// tried alone first.
// Source: firmware 5.4.3 run on a PC; the text asks for 1 s.
#pragma once

#include "base/output.h"
#include "base/time.h"
#include "fcp/framer.h"
#include "fcp/reply.h"
#include "fcp/request.h"

#include <optional>
#include <variant>
#include <vector>

namespace fcp {

class Client {
public:
    static constexpr Duration kAnswerTime = std::chrono::seconds(1);
    static constexpr Duration kSettle = std::chrono::milliseconds(50);
    static constexpr Duration kFillPause = std::chrono::milliseconds(5); ///< after each 0xFF
    static constexpr std::size_t kShortestAnswer = 3; ///< bytes
    static constexpr int kFillBytes = 131; ///< one more than the longest frame has
    /// A line that does not come to rest within this is given up: what babbles there answers no request.
    static constexpr Duration kNoisyAtMost = kAnswerTime;
    /// An urgent request waits so long for the end of the exchange before it.
    static constexpr Duration kGrace = kSettle;
    /// A silence so long is told, if a question has been open for kLeastOpen of it.
    static constexpr Duration kSuspectAfter = std::chrono::milliseconds(500);
    static constexpr Duration kLeastOpen = std::chrono::milliseconds(100);

    struct Config {
        std::uint32_t baud = 115200;
        Duration patience{}; ///< added to the answer time
    };

    enum class State : std::uint8_t { Closed, Connecting, Ready, Waiting, Settling, Recovering };

    // What it tells.
    struct Connected {
        BoardInfo board;
        bool again = false; ///< after a recovery
    };
    struct Answer {
        Reply reply; ///< Ack or Nack
        TimePoint asked; ///< when its request had left
    };
    /// There will be no answer, or none that fits. `executed` false: the board said that it did not understand.
    struct NoAnswer {
        std::optional<bool> executed;
    };
    struct Restarted { }; ///< the board said that it has just started
    struct Suspect { }; ///< asked, and nothing heard for a while
    struct Lost {
        bool heardBytes = false; ///< something came, though never an answer
        bool otherProtocol = false; ///< a board of the newer protocol refused
        bool connecting = false; ///< it was never there
    };
    using Event = std::variant<Connected, Answer, NoAnswer, Restarted, Suspect, Lost>;

    struct Stats {
        std::uint64_t bytesIn = 0, bytesOut = 0, framesIn = 0, framesOut = 0;
        std::uint64_t bad = 0; ///< wrong check, length, kind, or unasked
        std::uint64_t nacks = 0, timeouts = 0, recoveries = 0;
    };

    explicit Client(Config config)
        : m_config(config)
    {
    }

    /// Asks who is there: silence, then GET_BOARD_INFO. Ends with Connected or Lost, at once where a board of the newer
    /// protocol refuses.
    void connect(TimePoint now);
    void close();

    State state() const { return m_state; }
    bool connected() const { return m_connected; }
    bool canSend() const { return m_state == State::Ready; }

    /// Only if canSend(). Ends with Answer or NoAnswer.
    void send(const Request &request, TimePoint now);
    /// Ahead of everything: at once on an idle line or none at all, else after the answer under way or kGrace. The
    /// request before ends with NoAnswer then. Its answer, if sure, comes as Answer; no NoAnswer follows.
    void sendUrgent(const Request &request, TimePoint now);

    /// A motor may turn: see above.
    void setMotorDriven(bool driven) { m_motorDriven = driven; }
    void setDialect(Dialect dialect) { m_dialect = dialect; }

    void receive(ByteView bytes, TimePoint now);
    void handleTimeout(TimePoint now);
    void handleSent(TimePoint now);
    std::vector<Output> takeOutput() { return std::exchange(m_output, {}); }
    std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const;
    const Stats &stats() const { return m_stats; }

private:
    enum class Step : std::uint8_t { Silence, Fill, Ask };

    void put(Bytes frame, TimePoint now);
    bool hearsRefusal(ByteView bytes);
    void accept(Framer::Step step, TimePoint now);
    void onReply(const Reply &reply, TimePoint now);
    void onReplyWhileRecovering(const Reply &reply, TimePoint now);
    void settle(TimePoint now);
    void endRequest();
    void recover(TimePoint now);
    void silence(TimePoint now);
    void rest(Duration howLong, TimePoint now);
    void restless(TimePoint now);
    void fill(TimePoint now);
    void ask(TimePoint now);
    void askFailed(TimePoint now);
    void giveUp(TimePoint now);
    void leaveUrgent(TimePoint now);
    void answerTimeOver(TimePoint now);
    bool asking() const; ///< an answer is due
    std::optional<TimePoint> suspectAt() const;

    Config m_config;
    Dialect m_dialect = Dialect::Stm32;
    State m_state = State::Closed;
    Step m_step = Step::Silence;
    Framer m_framer{Framer::Side::Client};
    Frame m_frame;
    std::optional<Request> m_request; ///< waiting for its answer
    bool m_urgentOpen = false; ///< that request is the urgent one
    /// Settling: something urgent left, and fewer bytes than an answer has have come back since. How many are missing.
    std::size_t m_owed = 0;
    std::optional<Request> m_urgent; ///< waiting to leave
    TimePoint m_urgentBy;
    TimePoint m_asked; ///< when the request was handed out, or had left
    std::optional<TimePoint> m_unanswered; ///< since then nothing that was sent had an answer
    TimePoint m_deadline; ///< of the state
    TimePoint m_noisyUntil; ///< silence has to have begun by then
    TimePoint m_lastByte;
    std::size_t m_infoSize = kInfoSize; ///< of the GET_BOARD_INFO that this board was met by
    int m_filled = 0, m_round = 0;
    bool m_gentle = false; ///< this recovery begins without filling
    bool m_connected = false, m_motorDriven = false, m_suspected = false;
    bool m_strayFrames = false; ///< the board sends more than one answer at times: pause after each
    bool m_heard = false;
    std::size_t m_refused = 0; ///< bytes of the newer protocol's refusal, while connecting
    Stats m_stats;
    std::vector<Output> m_output;
    std::vector<Event> m_events;
};

/// Whether an acknowledgement with these data can be the answer.
bool fits(const Command &command, ByteView data, Dialect dialect);

} // namespace fcp
