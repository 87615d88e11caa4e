// The table of lies, and those that a board tells of its own accord.
#include "simulation/mcp/liars.h"

#include "aspep/packet.h"

#include <algorithm>
#include <array>
#include <utility>

namespace simulation {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kHeldMost = 64, kStalledMost = 65536;
constexpr std::uint8_t kIdle = 0, kStart = 4, kRun = 6; ///< STATUS

constexpr auto kLies = [] {
    using enum Lie;
    using enum LieActs;
    return std::to_array<LieInfo>({
        {WrongVersion, "wrong-version", OnLink, 1, "answers every BEACON with protocol version 3"},
        {CounterProposals, "counter-proposals", OnLink, 1,
            "answers every BEACON with other sizes than before"},
        {ShrinkingOffers, "shrinking-offers", OnLink, 1,
            "offers less with every BEACON, at last no datalog"},
        {NeverConfigured, "never-configured", OnLink, 1,
            "answers every PING as if no BEACON had matched"},
        {FalseParity, "false-parity", OnLink, 2, "miscounts its requests in PINGs"},
        {OtherNumber, "other-number", OnLink, 2, "echoes another PING number"},
        {ErrorStorm, "error-storm", OnLink, 1, "sends an ERROR before every packet"},
        {LateErrors, "late-errors", OnLink, 3, "sends an ERROR 30 ms behind an answer"},
        {UnknownErrors, "unknown-errors", OnLink, 5,
            "sends an ERROR of no known code instead of an answer"},
        {Noise, "noise", OnLink, 6, "sends some random bytes behind a packet"},
        {Flood, "flood", OnLink, 0, "sends random bytes at full rate for 0.5 s of every 2 s"},
        {Stall, "stall", OnLink, 40, "halts in the middle of a packet, for 1 ms to 10 s"},
        {TornPackets, "torn-packets", OnLink, 12, "leaves the end of a packet away"},
        {Resets, "resets", OnLink, 0, "restarts every 0.5 to 3 s"},
        {ResetsInAnswer, "resets-in-answer", OnLink, 60, "restarts in the middle of an answer"},
        {AtProbe, "at-probe", OnLink, 0, "hears and echoes a modem manager's AT from 3 to 8 s on"},

        {WrongLength, "wrong-length", OnAnswers, 6,
            "announces 0, 8191 or some bytes more or less than follow"},
        {BeyondAgreed, "beyond-agreed", OnAnswers, 6, "answers with more bytes than were agreed"},
        {OddLength, "odd-length", OnAnswers, 6, "puts one byte more in front of the status"},
        {EmptyAnswer, "empty-answer", OnAnswers, 6, "answers with no bytes at all"},
        {ShortRaw, "short-raw", OnAnswers, 2, "sends less of a structure than its size says"},
        {LongRaw, "long-raw", OnAnswers, 2, "sends more of a structure than its size says"},
        {NoNul, "no-nul", OnAnswers, 2, "sends texts without their end"},
        {ShortList, "short-list", OnAnswers, 6, "leaves the end of a list away and says OK"},
        {LateAnswer, "late-answer", OnAnswers, 6, "answers after 0.5 to 2 times the time-out"},
        {WrongAnswer, "wrong-answer", OnAnswers, 6, "repeats the answer to the request before"},
        {Twice, "twice", OnAnswers, 4, "sends an answer twice"},
        {Unsolicited, "unsolicited", OnAnswers, 0,
            "sends answers that were not asked for, 10 to 100 ms apart"},
        {UnknownStatus, "unknown-status", OnAnswers, 8,
            "ends an answer with a status of no known meaning"},
        {RefusedReads, "refused-reads", OnAnswers, 4,
            "says that a register is unknown which it has"},
        {RefusedWrites, "refused-writes", OnAnswers, 1,
            "says that a register is read-only, having written it"},

        {NotANumber, "nan", OnValues, 1, "NaN in every floating-point value"},
        {Infinite, "inf", OnValues, 1, "infinity in every floating-point value"},
        {Huge, "huge", OnValues, 1, "the largest number in every value"},
        {Denormal, "denormal", OnValues, 1, "denormal numbers and -0 in floating-point values"},
        {Zeros, "zeros", OnValues, 1, "zeros in every floating-point value"},
        {ManyMotors, "many-motors", OnValues, 1, "says it has 0, 8 or 255 motors"},
        {StrangeState, "strange-state", OnValues, 1,
            "says the motor is in a state of no known meaning"},

        {TimeForward, "time-forward", OnDatalog, 20,
            "lets the datalog's time jump ahead, up to hours"},
        {TimeBack, "time-back", OnDatalog, 20, "lets the datalog's time jump back"},
        {TimeFrozen, "time-frozen", OnDatalog, 1, "gives all datalog packets the same time"},
        {TimeOdd, "time-odd", OnDatalog, 4,
            "gives a datalog packet a time that is off by a few periods"},
        {WrongMark, "wrong-mark", OnDatalog, 5,
            "gives a datalog packet a mark that was not chosen"},
        {MarkZero, "mark-0", OnDatalog, 5, "gives a datalog packet the mark 0"},
        {OldMark, "old-mark", OnDatalog, 1, "keeps the former mark for two packets"},
        {AsyncId, "async-id", OnDatalog, 4, "sends packets of its own accord that are no datalog"},
        {OddPacket, "odd-packet", OnDatalog, 5, "sends datalog packets that end within a sample"},

        {FaultInStart, "fault-in-start", OnDrive, 0,
            "has an over-current of 50 ms during every start-up"},
        {FaultInRun, "fault-in-run", OnDrive, 0, "has an over-current of 50 ms once it runs"},
        {FaultStays, "fault-stays", OnDrive, 0,
            "has an over-current once it runs, which never ends"},
        {FaultFlickers, "fault-flickers", OnDrive, 0,
            "has an over-current every 60 ms once it ran"},
        {NeverStops, "never-stops", OnDrive, 1, "says OK to STOP and goes on"},
        {OkButIdle, "ok-but-idle", OnDrive, 1, "says OK to START and stays idle"},
        {NokButRuns, "nok-but-runs", OnDrive, 1, "says NOK to START and starts"},
    });
}();

constexpr bool tableIsInOrder()
{
    for (std::size_t i = 0; i < kLies.size(); ++i) {
        if (static_cast<std::size_t>(kLies[i].lie) != i)
            return false;
    }
    return true;
}
static_assert(tableIsInOrder());

} // namespace

std::span<const LieInfo> lies() { return kLies; }

Liar::Liar(std::span<const LieChoice> choices, Duration replyTime, std::uint64_t seed)
    : m_choices(choices.begin(), choices.end())
    , m_replyTime(replyTime)
    , m_random(seed ^ 0x5DEECE66DULL)
{
    for (LieChoice &choice : m_choices) {
        if (choice.oneIn == 0)
            choice.oneIn = kLies[static_cast<std::size_t>(choice.lie)].oneIn;
    }
}

bool Liar::chosen(Lie lie) const
{
    return std::ranges::find(m_choices, lie, &LieChoice::lie) != m_choices.end();
}

bool Liar::happens(Lie lie)
{
    const auto choice = std::ranges::find(m_choices, lie, &LieChoice::lie);
    return choice != m_choices.end() && (choice->oneIn <= 1 || below(choice->oneIn) == 0);
}

Bytes Liar::noise(std::size_t count)
{
    Bytes bytes(count);
    std::ranges::generate(bytes, [this] { return static_cast<std::uint8_t>(random()); });
    return bytes;
}

void Liar::hold(TimePoint until, Bytes bytes)
{
    if (m_held.size() >= kHeldMost)
        return;
    const auto behind =
        std::ranges::find_if(m_held, [&](const Held &held) { return held.at > until; });
    m_held.insert(behind, {until, std::move(bytes)});
}

Bytes Liar::packet(Packet kind, Bytes packet, TimePoint now)
{
    if (honest() || packet.size() < aspep::kHeaderSize)
        return packet;
    if (kind == Packet::Control)
        packet = control(std::move(packet));
    else if (kind == Packet::Response)
        packet = response(std::move(packet), now);
    else
        packet = async(std::move(packet));
    packet = withCompany(std::move(packet));
    if (m_stalled) {
        if (m_stalled->bytes.size() < kStalledMost)
            m_stalled->bytes.insert(m_stalled->bytes.end(), packet.begin(), packet.end());
        return {};
    }
    if (packet.size() > 1 && happens(Lie::Stall)) {
        const auto cut = packet.begin() + static_cast<std::ptrdiff_t>(1 + below(packet.size() - 1));
        // Every length of a halt is as likely as its tenfold.
        constexpr std::array<Duration, 5> kHalts{1ms, 10ms, 100ms, 1s, 10s};
        m_stalled = Held{now + kHalts[below(kHalts.size())], Bytes(cut, packet.end())};
        packet.erase(cut, packet.end());
    }
    return packet;
}

Liar::Urge Liar::act(TimePoint now, std::uint8_t motorState, bool lineFree)
{
    Urge urge;
    if (honest())
        return urge;
    if (!m_started) {
        m_started = true;
        m_restartAt = now + 2s;
        m_nextUnsolicited = now;
        m_nextProbe = now + 3s;
        m_probesEnd = now + 8s;
    }
    if (chosen(Lie::AtProbe) && now >= m_nextProbe && now < m_probesEnd)
        probe(now, lineFree, urge);
    actOnFaults(now, motorState, urge);
    if (lineFree && urge.bytes.empty())
        actOnLine(now, urge);
    if (chosen(Lie::Resets) && now >= m_restartAt) {
        m_restartAt = now + 500ms + Duration(below(2'500'000'000));
        m_restart = true;
    }
    urge.restart = std::exchange(m_restart, false);
    if (urge.restart) { // what was held went with the processor's memory
        m_held.clear();
        m_stalled.reset();
    }
    return urge;
}

/// What ModemManager sends to a port that it takes for a modem's, and the echo of it that comes back.
void Liar::probe(TimePoint now, bool lineFree, Urge &urge)
{
    constexpr std::array<std::string_view, 4> kCommands{
        "AT\r\n", "AT\r\nAT\r\nAT\r\n", "AT+CGMI\r\n", "ATI\r\n"};
    const std::string_view command = kCommands[below(kCommands.size())];
    urge.heard = ByteWriter().text(command).take();
    if (lineFree)
        urge.bytes = urge.heard;
    m_nextProbe = now + 20ms + Duration(below(480'000'000));
}

void Liar::actOnLine(TimePoint now, Urge &urge)
{
    if (m_stalled) {
        if (m_stalled->at <= now) {
            urge.bytes = std::move(m_stalled->bytes);
            m_stalled.reset();
        }
        return;
    }
    if (!m_held.empty() && m_held.front().at <= now) {
        urge.bytes = std::move(m_held.front().bytes);
        m_held.pop_front();
    } else if (chosen(Lie::Unsolicited) && now >= m_nextUnsolicited) {
        m_nextUnsolicited = now + 10ms + Duration(below(90'000'000));
        urge.bytes = m_lastResponse;
    } else if (chosen(Lie::Flood) && now.time_since_epoch() % 2s < 500ms) {
        urge.bytes = noise(64);
    }
}

void Liar::actOnFaults(TimePoint now, std::uint8_t motorState, Urge &urge)
{
    constexpr std::uint16_t kOverCurrent = 0x40;
    constexpr Duration kShort = 50ms;
    const bool enters = motorState == kRun && !m_ranOnce;
    m_ranOnce = m_ranOnce || motorState == kRun;
    const std::uint16_t before = m_faults.value_or(0);
    std::uint16_t faults = before;
    if (faults != 0 && now >= m_faultEnds)
        faults = 0;
    if ((chosen(Lie::FaultInStart) && motorState == kStart)
        || (chosen(Lie::FaultInRun) && enters)) {
        faults = kOverCurrent;
        m_faultEnds = now + kShort;
    }
    if (chosen(Lie::FaultStays) && m_ranOnce) {
        faults = kOverCurrent;
        m_faultEnds = TimePoint::max();
    }
    if (chosen(Lie::FaultFlickers) && m_ranOnce && now >= m_flicker) {
        m_flicker = now + 60ms;
        faults = kOverCurrent;
        m_faultEnds = now + 5ms;
    }
    if (motorState == kIdle && !chosen(Lie::FaultStays) && !chosen(Lie::FaultFlickers))
        m_ranOnce = false;
    m_faults = faults;
    if (faults != before)
        urge.faults = faults;
}

} // namespace simulation
