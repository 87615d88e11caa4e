// Boards that lie: whatever a device does wrong, our drive neither stumbles nor hangs, shows no value that the board
// did not have, ends each command once, sends nothing that was not asked for, and knows within seconds where it stands.
// ROTORSCOPE_LONG=1 tells each lie a hundred times; support/seeds.h says which others.
#include "support/link_pair.h"
#include "support/seeds.h"

#include "simulation/mcp/liars.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace drive;
using simulation::Lie;
using simulation::LieActs;
using simulation::LieInfo;
using support::LinkPair;
using namespace std::chrono_literals;

namespace {

/// What cannot change while a board runs, and so shows an answer that was taken for another.
constexpr std::array<std::string_view, 12> kConstants{"GLOBAL_CONFIG", "FW_NAME", "CTRL_STAGE_NAME",
    "PWR_STAGE_NAME", "MOTOR_NAME", "MOTOR_CONFIG", "APPLICATION_CONFIG", "FOCFW_CONFIG",
    "SCALE_CONFIG", "I_Q_KP", "STOPLL_KI", "REVUP_STAGE_NBR"};

/// What an honest board says of itself.
const std::map<RegisterId, Value> &truth()
{
    static const std::map<RegisterId, Value> values = [] {
        support::Session honest(false);
        std::vector<RegisterId> ids;
        for (const std::string_view name : kConstants)
            if (const auto id = honest.identified->catalog->resolve(name))
                ids.push_back(*id);
        honest.runUntilEnded(honest.submit(Read{ids}));
        std::map<RegisterId, Value> found;
        for (const RegisterId id : ids)
            if (honest.values.contains(id) && honest.values.at(id).status == ReadStatus::Ok)
                found[id] = honest.values.at(id).value;
        return found;
    }();
    return values;
}

bool isTransitional(LinkState state)
{
    return state == LinkState::Connecting || state == LinkState::Suspect
        || state == LinkState::Recovering;
}

/// One session with a lying board, and an oracle that looks at everything that leaves and comes.
class Ordeal {
public:
    Ordeal(const LieInfo &lie, std::uint64_t seed)
        : m_lie(lie)
        , m_random(seed)
        , m_pair(options(lie, seed), seed)
    {
        m_pair.onEvent = [this](const Event &event) { judge(event); };
    }

    /// What went wrong; empty if nothing did.
    std::string run()
    {
        m_pair.verdictTaken = true;
        m_pair.connect();
        wait([this] { return m_pair.identified.has_value(); }, 6s);
        m_pair.drive->arm();
        ask(Read{everything()});
        ask(Stream{{id("I_A"), id("I_B"), id("I_A")}, 1, {}, 1});
        ask(Watch{{id("BUS_VOLTAGE"), id("MOTOR_POWER"), id("HEATS_TEMP")}, 20ms});
        wait([] { return false; }, Duration(m_random.below(300'000'000)));
        ask(Command{MotorAction::Start, 1});
        wait([this] { return m_pair.status[1].state == MotorState::Running; }, 2s);
        ask(Write{{{id("SPEED_KP"), std::int64_t{4000}}}});
        ask(SpeedRamp{1, 1200, 200ms});
        wait([] { return false; }, 1s);
        ask(TorqueRamp{1, 1.0, 100ms});
        ask(Stream{{id("I_B"), id("I_A"), id("I_A"), id("I_B")}, 2, {}, 1});
        ask(Read{everything()});
        wait([] { return false; }, 1s);
        m_pair.drive->stop(m_pair.now);
        m_pair.exchange();
        wait([] { return false; }, 5s);
        m_pair.drive->disconnect(m_pair.now);
        m_pair.exchange();
        wait([this] { return m_pair.link == LinkState::Closed; }, 5s);
        if (m_pair.link != LinkState::Closed)
            complain("not closed");
        judgeRequests();
        for (const WishId wish : m_wishes)
            if (m_pair.ended[wish].size() != 1)
                complain("wish " + std::to_string(wish) + " ended "
                    + std::to_string(m_pair.ended[wish].size()) + " times");
        return m_wrong.empty() ? m_pair.judge.verdict() : m_wrong;
    }

private:
    static simulation::BoardOptions options(const LieInfo &lie, std::uint64_t seed)
    {
        simulation::BoardOptions options;
        options.lies = {{lie.lie, 0}};
        options.seed = seed;
        if (seed % 3 == 0)
            options.baud = 460800;
        return options;
    }

    void complain(const std::string &what)
    {
        if (m_wrong.empty())
            m_wrong =
                what + " (at " + std::to_string(toSeconds(m_pair.now.time_since_epoch())) + " s)";
    }

    void wait(const std::function<bool()> &condition, Duration limit)
    {
        m_pair.runUntil(
            [&] {
                judgeTime();
                return condition() || !m_wrong.empty();
            },
            limit);
    }

    RegisterId id(std::string_view name) const
    {
        static const support::Session honest(false);
        return honest.id(name);
    }
    static std::vector<RegisterId> everything()
    {
        std::vector<RegisterId> ids;
        for (const auto &[id, value] : truth())
            ids.push_back(id);
        return ids;
    }

    template <class What>
    void ask(What what)
    {
        m_wishes.push_back(m_pair.submit(std::move(what)));
    }

    void judge(const Event &event)
    {
        if (const auto *change = std::get_if<LinkChanged>(&event)) {
            if (!isTransitional(change->state))
                m_since.reset();
            else if (!m_since)
                m_since = m_pair.now;
            if (change->state == LinkState::Lost && change->reason == LinkReason::None)
                complain("lost without a reason");
        } else if (const auto *read = std::get_if<RegistersRead>(&event)) {
            for (const Reading &reading : read->readings)
                judge(reading);
        } else if (const auto *started = std::get_if<StreamStarted>(&event)) {
            m_layout = started->layout;
            m_stream.reset(); // its count of periods may begin anew
            for (const auto &signal : m_layout.fast)
                if (!std::isfinite(signal.factor) || !std::isfinite(signal.offset))
                    complain("a signal without a scale");
        } else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            judge(*block);
        } else if (const auto *found = std::get_if<Identified>(&event)) {
            for (const MotorLimits &limits : found->limits)
                for (const double limit : {limits.maxSpeedRpm, limits.maxCurrentAmps,
                         limits.nominalCurrentAmps, limits.polePairs})
                    if (!(std::isfinite(limit) && limit >= 0.0 && limit < 1e9))
                        complain("a limit of " + std::to_string(limit));
        }
    }

    /// Answers carry no number and payloads no check word. Known is when an answer began, how long it is, which size
    /// the board's structures have, and what stands right behind it; what passes all that is believed.
    bool cannotBeSeen(const Reading &reading) const
    {
        const bool anotherText = std::holds_alternative<std::string>(reading.value);
        return m_lie.lie == Lie::WrongAnswer || m_lie.lie == Lie::Unsolicited
            || m_lie.lie == Lie::TornPackets // the next packet makes up for what is missing
            || (m_lie.lie == Lie::LateAnswer && anotherText) || m_lie.acts == LieActs::OnValues;
    }
    /// Nor can a datalog packet whose end is that of another one, or whose mark is a lie.
    bool samplesCannotBeTrusted() const
    {
        return m_lie.lie == Lie::TornPackets || m_lie.lie == Lie::OldMark;
    }

    void judge(const Reading &reading)
    {
        const auto honest = truth().find(reading.id);
        if (honest == truth().end() || reading.status != ReadStatus::Ok)
            return;
        const auto *raw = std::get_if<Bytes>(&reading.value);
        const auto *honestRaw = std::get_if<Bytes>(&honest->second);
        // Where the answers of before made the firmware an unknown one, everything is shown as the board says it, raw.
        const bool sizesKnown = m_pair.identified && m_pair.identified->identity.knownFirmware;
        if (sizesKnown && raw != nullptr && honestRaw != nullptr
            && raw->size() != honestRaw->size())
            return complain("register " + std::to_string(reading.id) + " has an invented size");
        if (!cannotBeSeen(reading) && reading.value != honest->second)
            complain("register " + std::to_string(reading.id) + " has an invented value");
    }

    /// Channels of one name agree, and time goes on.
    void judge(const capture::SampleBlock &block)
    {
        const std::size_t columns = m_layout.fast.size();
        if (block.stream != m_layout.id || columns == 0
            || block.fast.size() != columns * block.count)
            return complain("a block of no known stream");
        if (m_stream == block.stream && (block.firstTick < m_nextTick || block.lostTicks < 0))
            complain("time goes back");
        m_stream = block.stream;
        m_nextTick = block.firstTick + static_cast<capture::Tick>(block.count) * m_layout.fastStep;
        if (samplesCannotBeTrusted())
            return;
        for (std::size_t s = 1; s < columns; ++s)
            for (std::size_t other = 0; other < s; ++other)
                if (m_layout.fast[s].id == m_layout.fast[other].id && differ(block, s, other))
                    return complain("a sample under the wrong name");
    }

    static bool differ(const capture::SampleBlock &block, std::size_t one, std::size_t other)
    {
        const auto column = [&](std::size_t s) {
            return block.fast.begin() + static_cast<std::ptrdiff_t>(s * block.count);
        };
        return !std::equal(column(one), column(one + 1), column(other));
    }

    /// Whether there is a link is known after five seconds at most.
    void judgeTime()
    {
        if (m_since && m_pair.now - *m_since > 5s)
            complain("neither connected nor lost for 5 s");
    }

    void judgeRequests()
    {
        const auto atMost = [&](mcp::CommandId command, std::size_t most, const char *what) {
            if (support::count(m_pair.requests, command) > most)
                complain(std::string("more than asked for: ") + what);
        };
        atMost(mcp::CommandId::StartMotor, 1, "START");
        for (const auto command : {mcp::CommandId::StartStop, mcp::CommandId::FaultAck,
                 mcp::CommandId::SwReset, mcp::CommandId::StopRamp, mcp::CommandId::IqdRefClear})
            atMost(command, 0, "a command");
        for (const Bytes &request : m_pair.requests)
            judgeRequest(request);
    }

    /// Only what was asked for is written, and with the values that were asked for.
    void judgeRequest(const Bytes &request)
    {
        const auto decoded = mcp::decodeRequest(request);
        if (!decoded)
            return complain("a request that is none");
        if (mcp::isMotorCommand(decoded->command) && decoded->motor != 1
            && m_lie.lie != Lie::ManyMotors)
            complain("a command to a motor that is not there");
        if (!support::changesSomething(request)
            || decoded->command != static_cast<std::uint16_t>(mcp::CommandId::SetRegister))
            return;
        for (const auto &write : mcp::decodeSetList(decoded->content).writes) {
            static const std::set<RegisterId> asked{
                id("SPEED_KP"), id("SPEED_RAMP"), id("TORQUE_RAMP"), id("CONTROL_MODE")};
            if (!asked.contains(write.id.bits))
                complain("a write that nobody asked for: " + std::to_string(write.id.bits));
            if (write.id.bits == id("TORQUE_RAMP"))
                judgeTorque(request);
        }
    }

    void judgeTorque(const Bytes &request)
    {
        ByteReader reader(ByteView(request).subspan(6));
        const std::int32_t digits = reader.s32();
        constexpr int kOneAmpere = 545; // of the board's scale
        if (std::abs(digits - kOneAmpere) > 1)
            complain("one ampere was sent as " + std::to_string(digits));
    }

    const LieInfo &m_lie;
    support::Random m_random;
    LinkPair m_pair;
    std::vector<WishId> m_wishes;
    capture::StreamLayout m_layout;
    std::optional<capture::StreamId> m_stream;
    capture::Tick m_nextTick = 0;
    std::optional<TimePoint> m_since;
    std::string m_wrong;
};

std::string nameOf(Lie lie)
{
    return std::string(simulation::lies()[static_cast<std::size_t>(lie)].name);
}

} // namespace

class TestLiars : public QObject {
    Q_OBJECT

private slots:
    void namesAreUnique();
    void noLieMisleadsTheDrive_data();
    void noLieMisleadsTheDrive();
    void answersThatBelongElsewhereAreFoundOut();
    void theSameSeedTellsTheSameLies();
    void aLieCanBeToldAlwaysOrSeldom();
};

void TestLiars::namesAreUnique()
{
    std::set<std::string_view> names;
    for (const LieInfo &info : simulation::lies()) {
        QVERIFY(names.insert(info.name).second);
        QVERIFY2(info.help.size() >= 10 && info.help.size() <= 60, info.name.data());
        QVERIFY(!info.help.ends_with('.'));
    }
}

void TestLiars::noLieMisleadsTheDrive_data()
{
    QTest::addColumn<int>("lie");
    for (const LieInfo &info : simulation::lies())
        QTest::newRow(info.name.data()) << static_cast<int>(info.lie);
}

void TestLiars::noLieMisleadsTheDrive()
{
    QFETCH(int, lie);
    const LieInfo &info = simulation::lies()[static_cast<std::size_t>(lie)];
    const std::string wrong = support::playSeeds(
        support::seedsOf(1, 100), [&](std::uint64_t seed) { return Ordeal(info, seed).run(); });
    QVERIFY2(wrong.empty(), wrong.c_str());
}

/// By the packet behind them, and by the size that the structure had before; or not at all, and the firmware is
/// unknown.
void TestLiars::answersThatBelongElsewhereAreFoundOut()
{
    for (const auto &[lie, seed] : {std::pair(Lie::ResetsInAnswer, 98),
             std::pair(Lie::LateAnswer, 52), std::pair(Lie::WrongAnswer, 88)}) {
        Ordeal ordeal(
            simulation::lies()[static_cast<std::size_t>(lie)], static_cast<std::uint64_t>(seed));
        const std::string wrong = ordeal.run();
        QVERIFY2(wrong.empty(), (nameOf(lie) + ": " + wrong).c_str());
    }
}

void TestLiars::theSameSeedTellsTheSameLies()
{
    const auto run = [] {
        simulation::BoardOptions options;
        options.lies = {{Lie::WrongLength, 0}, {Lie::Noise, 0}, {Lie::TornPackets, 0}};
        options.seed = 5;
        LinkPair pair(options);
        pair.connect();
        pair.runFor(2s);
        return std::pair(pair.sent, pair.counters.bytesIn);
    };
    QVERIFY(run() == run());
}

void TestLiars::aLieCanBeToldAlwaysOrSeldom()
{
    const auto lost = [](unsigned oneIn) {
        simulation::BoardOptions options;
        options.lies = {{Lie::WrongLength, oneIn}};
        LinkPair pair(options);
        pair.connect();
        pair.runFor(3s);
        return pair.identified.has_value();
    };
    QVERIFY(!lost(1));
    QVERIFY2(lost(1000), nameOf(Lie::WrongLength).c_str());
}

QTEST_APPLESS_MAIN(TestLiars)
#include "tst_liars.moc"
