// Boards that lie: what a broken, slow or hostile device does on the wire, each as a named switch. The board asks its
// Liar at a few places (a request comes in, an answer is ready, a packet goes to the line, 0.5 ms have passed) and is
// honest everywhere else. Deterministic from the seed; it never lies about what the motor does, only about what it
// says.
#pragma once

#include "base/bytes.h"
#include "base/random.h"
#include "base/time.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace simulation {

enum class Lie : std::uint8_t {
    // The link
    WrongVersion,
    CounterProposals,
    ShrinkingOffers,
    NeverConfigured,
    FalseParity,
    OtherNumber,
    ErrorStorm,
    LateErrors,
    UnknownErrors,
    Noise,
    Flood,
    Stall,
    TornPackets,
    Resets,
    ResetsInAnswer,
    AtProbe,
    // Answers
    WrongLength,
    BeyondAgreed,
    OddLength,
    EmptyAnswer,
    ShortRaw,
    LongRaw,
    NoNul,
    ShortList,
    LateAnswer,
    WrongAnswer,
    Twice,
    Unsolicited,
    UnknownStatus,
    RefusedReads,
    RefusedWrites,
    // Values
    NotANumber,
    Infinite,
    Huge,
    Denormal,
    Zeros,
    ManyMotors,
    StrangeState,
    // The datalog
    TimeForward,
    TimeBack,
    TimeFrozen,
    TimeOdd,
    WrongMark,
    MarkZero,
    OldMark,
    AsyncId,
    OddPacket,
    // The drive
    FaultInStart,
    FaultInRun,
    FaultStays,
    FaultFlickers,
    NeverStops,
    OkButIdle,
    NokButRuns,
};

enum class LieActs : std::uint8_t { OnLink, OnAnswers, OnValues, OnDatalog, OnDrive };

struct LieInfo {
    Lie lie;
    std::string_view name; ///< of --liar
    LieActs acts;
    unsigned oneIn; ///< it lies at one chance in so many; 0: it has times of its own
    std::string_view help; ///< what the board does, without a full stop
};

/// All of them, in the order of the enumeration.
std::span<const LieInfo> lies();

struct LieChoice {
    Lie lie = Lie::WrongVersion;
    unsigned oneIn = 0; ///< 0: as in the table
};

class Liar {
public:
    enum class Packet : std::uint8_t { Response, Control, Async };
    /// What it does of its own accord.
    struct Urge {
        Bytes bytes; ///< for the line, as they are
        Bytes heard; ///< on the way to the board, as from another program on the port
        bool restart = false;
        std::optional<std::uint16_t> faults; ///< present from now on
    };

    /// @param replyTime  about what a Controller waits for an answer; late answers are late around it
    Liar(std::span<const LieChoice> choices, Duration replyTime, std::uint64_t seed);

    bool honest() const { return m_choices.empty(); }

    /// The payload of a response that pretends; nothing: the request is carried out.
    std::optional<Bytes> insteadOf(ByteView request) const;
    /// The payload of the response to `request` as it leaves; `payload` ends in the status byte.
    Bytes answer(ByteView request, Bytes payload);
    /// A whole packet as it goes to the line: as it is, spoilt, with company, or nothing at all.
    Bytes packet(Packet kind, Bytes packet, TimePoint now);
    /// Every 0.5 ms. `lineFree`: a response would be taken; otherwise what waits goes on waiting.
    Urge act(TimePoint now, std::uint8_t motorState, bool lineFree);

private:
    struct Held {
        TimePoint at;
        Bytes bytes;
    };
    bool chosen(Lie lie) const;
    bool happens(Lie lie);
    std::uint64_t random() { return splitmix64(m_random); }
    std::uint64_t below(std::uint64_t bound) { return random() % bound; }
    Bytes noise(std::size_t count);
    void hold(TimePoint until, Bytes bytes);

    Bytes beacon(const Bytes &packet);
    Bytes ping(const Bytes &packet);
    Bytes control(Bytes packet);
    Bytes response(Bytes packet, TimePoint now);
    Bytes lengthened(Bytes packet);
    Bytes async(Bytes packet);
    void lieAboutTime(Bytes &packet);
    void lieAboutMark(Bytes &packet, std::size_t end);
    Bytes withCompany(Bytes packet);

    void lieAboutValues(ByteView request, Bytes &payload);
    void lieAboutRaw(ByteView request, Bytes &payload);
    void lieAboutStatus(ByteView request, Bytes &payload);

    void actOnFaults(TimePoint now, std::uint8_t motorState, Urge &urge);
    void actOnLine(TimePoint now, Urge &urge);
    void probe(TimePoint now, bool lineFree, Urge &urge);

    std::vector<LieChoice> m_choices;
    Duration m_replyTime;
    std::uint64_t m_random;

    std::deque<Held> m_held; ///< bounded; leaves in order of time
    std::optional<Held> m_stalled; ///< the rest of a packet, and all that comes behind it
    Bytes m_last, m_lastResponse; ///< payload; packet
    std::uint8_t m_offers = 0;
    std::uint8_t m_mark = 0, m_formerMark = 0;
    int m_oldPackets = 0; ///< datalog packets since the mark changed
    std::optional<std::uint32_t> m_frozenTime;
    std::uint32_t m_timeShift = 0;
    TimePoint m_restartAt{}, m_nextUnsolicited{}, m_flicker{}, m_faultEnds{};
    TimePoint m_nextProbe{}, m_probesEnd{};
    bool m_started = false, m_restart = false;
    std::optional<std::uint16_t> m_faults;
    bool m_ranOnce = false;
};

} // namespace simulation
