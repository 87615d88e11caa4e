// The judge of the wire: whether what a drive puts on its line, and what it says of its motors, is what the user asked
// for and what is true. It sees bytes with their times, the acts of the user, and the truth of the simulated board; it
// is told what the product said, and never looks into it: its decoders (wire/) are its own, small ones.
//
// Protocol-neutral. Time moves where the bench moves it. Each rule is a function of ms_rules_*.cpp with its name and
// its sentence in kRules; a violation tells the rule, the time, the packet and the act that it is about. Source of the
// rules: the motor safety requirements (docs/safety.md names them).
#pragma once

#include "base/bytes.h"
#include "base/time.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace judge {

/// What a packet to the board is for.
enum class Kind : std::uint8_t {
    LinkControl, ///< keeps or makes the link; touches no motor
    StatusRead, ///< states, faults, speeds
    Read, ///< any other register
    StreamSetup, ///< what the board records
    Heartbeat, ///< feeds the drive's watchdog
    Stop, ///< of one motor
    StopRamp,
    Start,
    SetPoint, ///< a ramp or a reference: where the motor is to go
    Mode, ///< what is controlled
    Write, ///< any other register
    Acknowledge, ///< of faults
    Never, ///< what may not be sent
};
const char *nameOf(Kind kind);

/// One thing that a packet asks for; a packet may ask for several.
struct Sent {
    Kind kind = Kind::Read;
    int motor = 0; ///< 0: none, or the board
    std::uint32_t target = 0; ///< the register's number on this wire; 0: none
    std::optional<double> value; ///< as a number, where it is one
    std::optional<double> rpm, amps; ///< where it goes, in physical units
    std::string why; ///< for Never: what is wrong with it
    bool firstOfPacket = true;
    bool rests = false; ///< a set-point that goes to zero, where zero is rest
    bool goesOn = false; ///< one that is what it was: no act, but none for the time of a Stop
};

/// The user's act as the test made it.
struct Act {
    enum class Kind : std::uint8_t {
        Open, ///< connect
        Close, ///< disconnect
        Unplugged, ///< no act: the line is gone
        Arm,
        Disarm,
        Stop, ///< of all motors
        StopMotor, ///< the end of a jog
        StopRamp,
        Start,
        SetPoint,
        Write,
        Acknowledge,
        Limits, ///< the user's own
        Scale, ///< of currents, as the user knows it
        Input, ///< any input event of a window: allows one thing that acts of each kind, and writes
        Confirm, ///< yes to a question
        AgreeToHold, ///< yes to what moves while it is held; moves nothing by itself, and lasts until a Stop
        AgreeToSeries, ///< yes to what moves by itself, and to more of the like until disarmed or stopped
        Series, ///< begins one: allows set-points while it may last, where it was agreed to
        Hold, ///< an input that moves a motor while it is held
        Restore, ///< yes to writing what a file holds: allows writes, and what came before it allows no more
        Leave, ///< a motor that turns is to go on without us
    };
    Kind kind = Kind::Open;
    std::uint64_t id = 0; ///< of the wish; 0: none
    int motor = 0;
    std::uint32_t target = 0; ///< register
    std::optional<double> value, rpm, amps;
    TimePoint at{};
};

/// What a motor does in truth.
struct Motor {
    bool driven = false; ///< the stage is on
    bool idle = true; ///< at rest as the firmware means it, or in a fault
    double rpm = 0.0; ///< of the rotor
};

/// What the product said that the user reads.
enum class Word : std::uint8_t { Requested, Accepted, DriveIdle, Standstill, NotConfirmed };
enum class LinkState : std::uint8_t { Closed, Connecting, Connected, Suspect, Recovering, Lost };

/// What the judge has to know of a line and its board beforehand.
struct Line {
    int motors = 1;
    int motorsTold = 0; ///< by a board that lies; more than there are
    std::uint32_t baud = 1843200;
    double maxRpm = 0.0, maxAmps = 0.0, ampsPerDigit = 0.0; ///< of the board; 0: not told
    bool stopsBlind = true; ///< without a link, too
    bool speedIsMeasured = true; ///< false: the rotor is seen to turn only while driven
    Duration firstStop = std::chrono::milliseconds(100); ///< from the act to the first byte
    Duration repeat = std::chrono::milliseconds(200); ///< between STOPs of one motor
    Duration alarm = std::chrono::milliseconds(600); ///< half a second and a poll
    Duration suspect = std::chrono::milliseconds(600), lost = std::chrono::milliseconds(2500);
    /// How long an act of the user counts, from the act or from what the board last answered on the way to it: a start
    /// looks first at what it would start to.
    Duration fresh = std::chrono::milliseconds(550);
    /// The first start after a connection or a Stop is asked about.
    bool asksFirst = false;
    /// From an act at a window to the thread that serves the line.
    Duration grace{};
    Duration stall{}; ///< how long the program may have no core
    int startParts = 1, referenceParts = 1; ///< packets that a start or a current reference takes
    Duration gap{}; ///< from header to payload, at least
    Duration answerWithin{}; ///< after which a request counts as unanswered; zero: not judged
};

/// A packet taken apart. One decoder for each protocol.
class Decoder {
public:
    virtual ~Decoder() = default;
    virtual void reset() = 0; ///< the line was opened anew
    /// Bytes that leave at `at`. @return what whole packets ask for
    virtual std::vector<Sent> sent(ByteView bytes, TimePoint at) = 0;
    /// Bytes that arrive. @return whether an answer may be among them
    virtual bool heard(ByteView bytes) = 0;
    virtual bool midPacket() const = 0; ///< of what is sent
    /// From the end of the last header to its payload; empty if no payload has begun since the last call.
    virtual std::optional<Duration> takeGap() { return std::nullopt; }
};

class MsRules {
public:
    static constexpr Duration kOldest = std::chrono::seconds(10); ///< that an act counts at most
    /// One that moves by itself, with its start.
    static constexpr Duration kSeries = std::chrono::seconds(75);
    static constexpr Duration kGap = std::chrono::milliseconds(250); ///< longer: it did not run
    static constexpr Duration kBlind = std::chrono::seconds(2); ///< STOPs without a link
    static constexpr Duration kEvidence = std::chrono::milliseconds(500);

    MsRules() = default;
    MsRules(const MsRules &) = delete;
    MsRules &operator=(const MsRules &) = delete;

    /// From now on this line is judged.
    void watch(std::unique_ptr<Decoder> decoder, const Line &line);
    bool watching() const { return m_decoder != nullptr; }
    Line &line() { return m_line; }
    /// This rule is not judged here; the reason is for readers of the test.
    void excuse(const std::string &rule, const std::string &reason);

    /// What has been asked and told so far: to be taken when a drive hands bytes over, and given when they leave.
    std::uint64_t moment() const { return m_moment; }
    /// Bytes that leave at `at`. A packet that was handed over, or whose header had left, before an act is not
    /// called back by it: half a packet would make the board eat the next one.
    void sent(ByteView bytes, TimePoint at, std::uint64_t handed);
    void sent(ByteView bytes, TimePoint at) { sent(bytes, at, m_moment); }
    void heard(ByteView bytes, TimePoint at);
    void act(const Act &act);
    void look(TimePoint now, const std::vector<Motor> &truth);
    void said(Word word, int motor, TimePoint at);
    void said(LinkState link, TimePoint at);
    void saidIdentified(int motors, TimePoint at);
    void saidEnded(std::uint64_t wish, TimePoint at);
    void asked(std::uint64_t wish, TimePoint at);
    void saidStatus(TimePoint evidence, TimePoint at);

    /// The line is closed on purpose: a motor that turns is stopped before, unless the user chose to leave it.
    void closes(TimePoint now);
    /// Each wish that was asked for has ended; to be called when the faults are over.
    void settle(TimePoint now);

    const std::vector<std::string> &violations() const { return m_violations; }
    /// The first violation; empty if there is none.
    std::string verdict() const { return m_violations.empty() ? "" : m_violations.front(); }

    struct Counts {
        int acts = 0, arms = 0, starts = 0, stops = 0, setPoints = 0, packets = 0;
        std::optional<double> rpm; ///< of the last set-point that is a speed
        std::map<std::uint32_t, double> written; ///< the last number of each register that is none
    };
    const Counts &counts() const { return m_counts; } ///< of what left, and of acts
    void forgetWritten() { m_counts.written.clear(); }

private:
    struct OpenStop {
        TimePoint first, latest;
        std::uint64_t moment = 0; ///< of the first
        TimePoint pressed; ///< the first; the two above are put off by gaps in which no thread ran
        struct Of {
            std::optional<TimePoint> sent; ///< the last STOP
            std::optional<TimePoint> allowed; ///< since when it could be sent
            bool rested = false, alarmed = false, told = false, late = false;
        };
        std::map<int, Of> motors;
    };

    // ms_rules.cpp: what happens; ms_rules_list.cpp: the rules
    void judge(const Sent &sent, const std::string &bytes);
    void neverLeaves(const Sent &sent);
    void onlyMotorsThatAreThere(const Sent &sent);
    void nothingActsUnarmed(const Sent &sent);
    void nothingActsUnasked(const Sent &sent);
    void onlyStopAndStatesDuringAStop(const Sent &sent);
    void heartbeatsOnlyWhileArmed(const Sent &sent);
    void firstStartsAreAsked(const Sent &sent);
    void setPointsAreBounded(const Sent &sent);
    void oneInFlight(const Sent &sent);
    void firstRequestOnlyReads(const Sent &sent);
    void payloadPause();
    void stopsLeaveInTime(TimePoint now);
    void stopsAreRepeated(int motor, OpenStop::Of &of, TimePoint now);
    void alarmComes(int motor, OpenStop::Of &of, TimePoint now);
    void silenceIsTold(TimePoint now);

    void onStop(const Act &act);
    bool stopGoesOn() const; ///< some motor has not come to rest since
    void arm();
    void forgetActs();
    bool acts(Kind kind) const;
    bool mayRest(const Sent &sent) const;
    /// When arming or a Stop ended it.
    bool wasUnderWay() const { return m_packetBegan < m_disarmed; }
    bool restedLately(int motor, double rpm, TimePoint at) const;
    void violate(const char *rule, const std::string &what);

    Line m_line;
    std::unique_ptr<Decoder> m_decoder;
    std::set<std::string> m_excused;
    std::vector<std::string> m_violations;
    Counts m_counts;
    std::string m_packet; ///< being judged, for people
    TimePoint m_now{}, m_opened{}, m_disarmedAt{}, m_lookedAt{};

    bool m_open = false, m_identified = false;
    std::uint64_t m_moment = 1; ///< counts acts and ends of wishes
    std::uint64_t m_packetBegan = 1, m_disarmed = 0; ///< moments
    bool m_armed = false; ///< the user armed since the connection, and no Stop came since
    bool m_over = false; ///< by a Stop, with the link or by a reset, and not armed since
    bool m_requested = false; ///< a request has left since the link came about
    LinkState m_link = LinkState::Closed;
    std::optional<TimePoint> m_heardAt;
    TimePoint m_answeredAt{};
    std::optional<TimePoint> m_unanswered; ///< when the request left whose answer is due
    std::optional<OpenStop> m_stop;
    struct Pending {
        Act act;
        int uses = 0;
        std::set<Kind> used = {}; ///< of an input event
        /// Since when it asks for nothing any more.
        std::optional<std::uint64_t> voided = std::nullopt;
        TimePoint voidedAt{};
    };
    std::vector<Pending>::iterator pendingFor(const Sent &sent);
    Act *actFor(const Sent &sent);

    std::vector<Pending> m_acts;
    std::map<int, TimePoint> m_stopSent; ///< by motor
    /// Motors whose Stop was said to be unconfirmed, and nothing else since.
    std::set<int> m_alarming;
    std::optional<TimePoint> m_leave, m_held;
    std::optional<TimePoint> m_armedEarly; ///< when the user armed before the Stop was over
    bool m_seriesAgreed = false; ///< since it was armed
    /// What the user has agreed to and seen, so that a START may leave.
    struct Agreed {
        std::optional<TimePoint> confirmed;
        bool hold = false, startedOnce = false;
    };
    Agreed m_agreed; ///< since the connection or the last Stop
    Agreed m_agreedBefore; ///< the last Stop: for what was under way then
    struct Bounds {
        double rpm = 0.0, amps = 0.0;
    };
    std::map<std::uint64_t, Bounds> m_user{{0, {}}}; ///< of the user, since which moment
    std::set<std::uint64_t> m_wishes, m_ended;
    std::map<int, Motor> m_truth;
    struct Seen {
        TimePoint idleAt{}, restAt{}; ///< when it was last so
        bool everIdle = false, everRested = false;
    };
    std::map<int, Seen> m_seen;
};

} // namespace judge
