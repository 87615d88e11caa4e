// The stream of McpDrive: samples belong to the signals they are shown under, at the ticks they were taken.
#include "support/link_pair.h"

#include <QTest>

#include <map>
#include <numbers>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

/// Judges every block by what the signals of a motor at 1500 rpm look like: each has a look of its own.
class Judge {
public:
    explicit Judge(Session &session)
        : m_session(session)
    {
        session.onEvent = [this](const Event &event) { accept(event); };
    }

    std::size_t streams = 0, blocks = 0;
    std::string wrong;
    capture::Tick lost = 0;

private:
    void accept(const Event &event)
    {
        if (const auto *started = std::get_if<StreamStarted>(&event)) {
            m_layout = started->layout;
            ++streams;
        } else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            judge(*block);
        }
    }

    void judge(const capture::SampleBlock &block)
    {
        ++blocks;
        lost += block.lostTicks;
        if (block.stream != m_layout.id)
            wrong = "a block of another stream";
        if (block.fast.size() != m_layout.fast.size() * block.count)
            wrong = "another number of samples";
        if (m_last && block.firstTick < *m_last)
            wrong = "time goes back";
        m_last = block.firstTick + static_cast<capture::Tick>(block.count) * m_layout.fastStep;
        for (std::size_t s = 0; s < m_layout.fast.size() && wrong.empty(); ++s)
            for (std::size_t i = 0; i < block.count && wrong.empty(); ++i)
                if (!fits(m_layout.fast[s].name, block.fast[s * block.count + i]))
                    wrong = m_layout.fast[s].name + " shows "
                        + std::to_string(block.fast[s * block.count + i]);
        for (const capture::SlowGroup &group : block.slow) {
            if (group.values.size() != m_layout.slow.size())
                wrong = "another number of slow values";
            for (std::size_t s = 0; s < m_layout.slow.size() && wrong.empty(); ++s)
                if (!fits(m_layout.slow[s].name, group.values[s]))
                    wrong = m_layout.slow[s].name + " shows " + std::to_string(group.values[s])
                        + " slowly";
        }
    }

    /// Ranges that do not overlap: speed 250 tenths of a hertz, Iq small but not that, Vq large.
    static bool fits(const std::string &name, std::int32_t value)
    {
        if (name == "STOPLL_ROT_SPEED")
            return value > 220 && value < 280;
        if (name == "V_Q")
            return value > 1000;
        if (name == "I_D_REF")
            return value == 0; // without flux weakening
        return false;
    }

    Session &m_session;
    capture::StreamLayout m_layout;
    std::optional<capture::Tick> m_last;
};

} // namespace

class TestMcpDriveStream : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void reconfiguredThreeHundredTimesInFlightEverySampleHasItsSignal();
    void slowSignalsComeAtTheirOwnRate();
    void slowSignalsMayComeOnceAPacket();
    void whatCannotBeStreamedIsRefusedAndTheOldStreamStays();
    void aSignalOfASensorThatIsNotThereIsRefused();
    void anEmptyWishStops();
    void aBoardOfSmallPacketsIsStoppedToo();
    void theDatalogIsStoppedBeforeTheFirstConfiguration();
    void aRecoveryBehindTheFirstStopAsksForAnother();
    void aConfigurationThatWasDamagedOnItsWayIsSentAgain();
    void eachConfigurationHasAnotherMark();
    void nothingIsInventedWhereBytesAreLost();
    void ticksMapToTheSessionsTime();
    void aResetBehindAStopIsNoticed_data();
    void aResetBehindAStopIsNoticed();
    void aRecoveryShowsAsAGapOnly();
    void aLostByteCostsLittle_data();
    void aLostByteCostsLittle();
    void aLineThatIsTooSlowShowsGaps();
    void linkTwoUsesItsOwnRegister();
};

void TestMcpDriveStream::reconfiguredThreeHundredTimesInFlightEverySampleHasItsSignal()
{
    Session session;
    QVERIFY(session.runAt(1500));
    session.runFor(1s);
    Judge judge(session);
    const RegisterId speed = session.id("STOPLL_ROT_SPEED"), vq = session.id("V_Q"),
                     still = session.id("I_D_REF");
    const std::vector<std::vector<RegisterId>> choices{{speed}, {vq}, {speed, vq}, {vq, speed},
        {still, speed, vq}, {vq, still, still}, {still, still, vq, speed}};
    support::Random random(7);
    for (int i = 0; i < 300; ++i) {
        Stream stream;
        stream.fast = choices[random.below(choices.size())];
        stream.fastEvery = 1 + static_cast<unsigned>(random.below(3));
        if (random.chance(0.5)) {
            stream.slow = choices[random.below(3)];
            stream.slowEvery = 1 + static_cast<unsigned>(random.below(20));
        }
        session.submit(stream);
        session.runFor(Duration(random.below(120'000'000)));
        QVERIFY2(judge.wrong.empty(), judge.wrong.c_str());
    }
    QVERIFY2(judge.streams > 100, std::to_string(judge.streams).c_str());
    QVERIFY(judge.blocks > 300); // more packets than configurations
    QCOMPARE(session.counters.streamSkipped, 0U);
}

void TestMcpDriveStream::slowSignalsComeAtTheirOwnRate()
{
    Session session;
    std::vector<capture::Tick> slow, fast;
    session.onEvent = [&](const Event &event) {
        if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            for (const auto &group : block->slow)
                slow.push_back(group.tick - block->firstTick);
            fast.push_back(block->count);
        }
    };
    session.submit(Stream{{session.id("I_A")}, 2, {session.id("V_Q"), session.id("V_D")}, 10});
    session.runFor(500ms);
    QVERIFY(slow.size() > 100);
    QCOMPARE(slow[0], 18); // behind the tenth block, which is 18 ticks after the first
    QCOMPARE(slow[1], 38);
}

void TestMcpDriveStream::slowSignalsMayComeOnceAPacket()
{
    Session session;
    QVERIFY(session.runAt(1500));
    session.runFor(1s);
    Judge judge(session);
    const auto judged = session.onEvent;
    bool always = true;
    session.onEvent = [&](const Event &event) {
        judged(event);
        if (const auto *block = std::get_if<capture::SampleBlock>(&event))
            always = always && block->slow.size() == 1
                && block->slow[0].tick == block->firstTick + 2 * capture::Tick{block->count - 1};
    };
    session.submit(Stream{
        {session.id("STOPLL_ROT_SPEED")}, 2, {session.id("V_Q")}, Stream::kSlowOncePerPacket});
    session.runFor(500ms);
    QVERIFY(judge.blocks > 4);
    QVERIFY2(judge.wrong.empty(), judge.wrong.c_str());
    QVERIFY(always);
    QCOMPARE(judge.lost, 0);
}

void TestMcpDriveStream::whatCannotBeStreamedIsRefusedAndTheOldStreamStays()
{
    Session session;
    std::uint64_t blocks = 0;
    session.onEvent = [&](const Event &event) {
        blocks += std::holds_alternative<capture::SampleBlock>(event);
    };
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(300ms);
    const std::vector<Stream> bad{{{session.id("SPEED_MEAS")}, 1, {}, 1},
        {{session.id("I_A")}, 1, {session.id("BUS_VOLTAGE")}, 1}, {{0xFFF1}, 1, {}, 1},
        {{session.id("I_A") & ~7U}, 1, {}, 1}, {{(session.id("I_A") & ~7U) + 2}, 1, {}, 1},
        {{session.id("I_A")}, 0, {}, 1}, {{session.id("I_A")}, 257, {}, 1},
        {{session.id("I_A")}, 1, {session.id("I_B")}, 256},
        {{}, 1, {session.id("I_B")}, Stream::kSlowOncePerPacket},
        {std::vector<RegisterId>(11, session.id("I_A")), 1, {}, 1}};
    const std::size_t sets = support::count(session.requests, mcp::CommandId::SetRegister);
    for (const Stream &stream : bad) {
        const WishId wish = session.submit(stream);
        QVERIFY(session.runUntilEnded(wish));
        QVERIFY(session.outcome(wish) == Outcome::Refused);
        QVERIFY(!session.ended[wish].front().reason.empty());
    }
    QCOMPARE(support::count(session.requests, mcp::CommandId::SetRegister), sets);
    const std::uint64_t before = blocks;
    session.runFor(300ms);
    QVERIFY(blocks > before);
}

/// The board would take it, and zeros look like a motor at rest.
void TestMcpDriveStream::aSignalOfASensorThatIsNotThereIsRefused()
{
    const auto outcomeOf = [](Session &session, const Stream &stream) {
        const WishId wish = session.submit(stream);
        return session.runUntilEnded(wish) ? session.outcome(wish) : Outcome::Unknown;
    };
    Session observer;
    const RegisterId current = observer.id("I_A");
    for (const char *name : {"ENCODER_SPEED", "ENCODER_EL_ANGLE", "HALL_SPEED", "HALL_EL_ANGLE",
             "STOCORDIC_ROT_SPEED", "STOCORDIC_BEMF_ALPHA"}) {
        QVERIFY(outcomeOf(observer, Stream{{current, observer.id(name)}, 1, {}, 1})
            == Outcome::Refused);
        QVERIFY(
            outcomeOf(observer, Stream{{current}, 1, {observer.id(name)}, 1}) == Outcome::Refused);
    }
    QVERIFY(
        outcomeOf(observer, Stream{{observer.id("STOPLL_ROT_SPEED")}, 1, {}, 1}) == Outcome::Ok);
    simulation::BoardOptions options;
    options.motor = "servo24"; // an encoder, and an observer that runs beside it
    Session servo(true, options);
    QVERIFY(outcomeOf(
                servo, Stream{{servo.id("ENCODER_SPEED"), servo.id("STOPLL_ROT_SPEED")}, 1, {}, 1})
        == Outcome::Ok);
    QVERIFY(outcomeOf(servo, Stream{{servo.id("HALL_SPEED")}, 1, {}, 1}) == Outcome::Refused);
}

void TestMcpDriveStream::anEmptyWishStops()
{
    Session session;
    std::optional<capture::StreamLayout> layout;
    std::uint64_t afterStop = 0;
    session.onEvent = [&](const Event &event) {
        if (const auto *started = std::get_if<StreamStarted>(&event))
            layout = started->layout;
        if (std::holds_alternative<capture::SampleBlock>(event) && (!layout || layout->empty()))
            ++afterStop;
    };
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(300ms);
    QVERIFY(layout && !layout->empty());
    const WishId stop = session.submit(Stream{});
    QVERIFY(session.runUntilEnded(stop));
    QVERIFY(session.outcome(stop) == Outcome::Ok);
    QVERIFY(session.runUntil([&] { return layout->empty(); }, 200ms));
    session.runFor(300ms);
    QCOMPARE(afterStop, 0U);
}

/// A stop whose buffer is larger than what was agreed is refused.
void TestMcpDriveStream::aBoardOfSmallPacketsIsStoppedToo()
{
    simulation::BoardOptions options;
    options.txAsyncMax = 512;
    Session session(false, options);
    QVERIFY(session.ready);
    const Bytes stop{0x08, 0x00, 0x29, 0x05, 0x07, 0x00, 0x00, 0x02, 0x00, 0x00, 0xFF, 0x00, 0x00};
    QVERIFY(session.requests.at(3) == stop); // while it was identified
    const auto heard = [&] {
        return session.counters.streamPackets + session.counters.streamSkipped;
    };
    QVERIFY(session.runUntilEnded(session.submit(Stream{{session.id("I_A")}, 1, {}, 1})));
    session.runFor(1500ms);
    QVERIFY(heard() > 10);
    const WishId end = session.submit(Stream{});
    QVERIFY(session.runUntilEnded(end));
    QVERIFY(session.outcome(end) == Outcome::Ok);
    session.runFor(1500ms);
    const std::uint64_t before = heard();
    session.runFor(1500ms);
    QCOMPARE(heard(), before);
}

void TestMcpDriveStream::theDatalogIsStoppedBeforeTheFirstConfiguration()
{
    Session session;
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(200ms);
    bool stopped = false;
    for (const Bytes &request : session.requests) {
        if (request.size() < 5 || request[0] != 0x08 || request[2] != 0x29)
            continue;
        if (request.back() == 0)
            stopped = true;
        else
            QVERIFY(stopped);
    }
    // A recovery is a connection too: the next configuration is preceded by a stop again.
    session.toDrive.cut = true;
    session.runFor(60ms);
    session.toDrive.cut = false;
    session.runFor(500ms);
    QVERIFY(session.link == LinkState::Connected);
    const std::size_t from = session.requests.size();
    const WishId wish = session.submit(Stream{{session.id("I_B")}, 1, {}, 1});
    QVERIFY(session.runUntilEnded(wish));
    std::vector<std::uint8_t> marks;
    for (std::size_t i = from; i < session.requests.size(); ++i)
        if (session.requests[i].size() > 5 && session.requests[i][0] == 0x08)
            marks.push_back(session.requests[i].back());
    QCOMPARE(marks.size(), 2U);
    QCOMPARE(marks[0], 0);
    QVERIFY(marks[1] != 0);
}

void TestMcpDriveStream::aRecoveryBehindTheFirstStopAsksForAnother()
{
    support::LinkPair pair;
    const auto isDatalog = [](const Bytes &request) {
        return request.size() >= 5 && request[0] == 0x08 && request[2] == 0x29;
    };
    bool stopped = false, lost = false;
    pair.loses = [&](const Bytes &bytes) {
        const bool loseIt = stopped && !lost && bytes[0] == 0x10; // the first read behind the stop
        lost = lost || loseIt;
        stopped = stopped || isDatalog(bytes);
        return loseIt;
    };
    pair.connect();
    QVERIFY(pair.runUntilIdentified());
    QVERIFY(lost);
    const std::size_t from = pair.requests.size();
    QVERIFY(pair.runUntilEnded(pair.submit(Stream{{pair.id("I_A")}, 1, {}, 1})));
    const auto first = std::find_if(
        pair.requests.begin() + static_cast<std::ptrdiff_t>(from), pair.requests.end(), isDatalog);
    QVERIFY(first != pair.requests.end());
    QCOMPARE(first->back(), std::uint8_t{0}); // a stop
}

void TestMcpDriveStream::aConfigurationThatWasDamagedOnItsWayIsSentAgain()
{
    Session session;
    constexpr std::uint64_t kSizeAt = 4; // of the raw value, behind command and id
    bool damaged = false;
    session.loses = [&](const Bytes &bytes) {
        if (!damaged && bytes.size() > 5 && bytes[0] == 0x08 && bytes[2] == 0x29
            && bytes.back() != 0) {
            damaged = true;
            session.toBoard.onceAt = session.toBoard.passed + kSizeAt;
            session.toBoard.once = support::LineFaults::Once::Flip;
        }
        return false;
    };
    const WishId wish = session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    QVERIFY(session.runUntilEnded(wish));
    QVERIFY(damaged);
    QVERIFY(session.outcome(wish) == Outcome::Ok);
}

void TestMcpDriveStream::eachConfigurationHasAnotherMark()
{
    Session session;
    for (int i = 0; i < 260; ++i)
        QVERIFY(session.runUntilEnded(session.submit(Stream{{session.id("I_A")}, 1, {}, 1})));
    int last = -1, different = 0;
    for (const Bytes &request : session.requests) {
        if (request.size() < 14 || request[0] != 0x08 || request[2] != 0x29 || request.back() == 0)
            continue;
        QVERIFY(request.back() != last);
        last = request.back();
        ++different;
    }
    QCOMPARE(different, 260);
}

/// A reader that comes late loses stretches of bytes. What is told then is what the board took, sample by sample.
void TestMcpDriveStream::nothingIsInventedWhereBytesAreLost()
{
    using Samples = std::map<capture::Tick, std::vector<std::int16_t>>;
    const auto record = [](std::uint64_t seed, double burst) {
        simulation::BoardOptions servo;
        servo.motor = "servo24";
        Session session(true, servo, seed);
        Samples samples;
        if (!session.runAt(1500))
            return samples;
        session.runFor(500ms);
        session.onEvent = [&](const Event &event) {
            const auto *block = std::get_if<capture::SampleBlock>(&event);
            for (std::uint32_t i = 0; block != nullptr && i < block->count; ++i)
                for (std::size_t at = i; at < block->fast.size(); at += block->count)
                    samples[block->firstTick + i].push_back(block->fast[at]);
        };
        Stream stream;
        for (const char *name :
            {"I_Q_MEAS", "ENCODER_SPEED", "ENCODER_EL_ANGLE", "V_Q", "I_D_MEAS"})
            stream.fast.push_back(session.id(name));
        session.submit(stream);
        session.runFor(100ms);
        session.toDrive.burst = burst;
        session.toDrive.burstMost = 300;
        session.runFor(8s);
        session.toDrive.burst = 0.0;
        return samples;
    };
    const Samples truth = record(1, 0.0);
    QVERIFY(truth.size() > 100'000);
    for (const std::uint64_t seed : {1, 2}) {
        std::size_t wrong = 0;
        const Samples told = record(seed, 5e-5);
        QVERIFY(told.size() > 40'000 && told.size() < truth.size());
        for (const auto &[tick, values] : told) {
            const auto at = truth.find(tick);
            wrong += at != truth.end() && at->second != values ? 1 : 0;
        }
        QCOMPARE(wrong, 0U);
    }
}

void TestMcpDriveStream::ticksMapToTheSessionsTime()
{
    Session session;
    session.runFor(3s);
    double worst = 0.0;
    capture::StreamLayout layout;
    session.onEvent = [&](const Event &event) {
        if (const auto *started = std::get_if<StreamStarted>(&event))
            layout = started->layout;
        if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            const double end = layout.originSeconds
                + static_cast<double>(block->firstTick + block->count) / layout.tickHz;
            worst = std::max(worst, std::abs(toSeconds(session.now.time_since_epoch()) - end));
        }
    };
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(1s);
    session.submit(Stream{{session.id("I_A"), session.id("I_B")}, 1, {}, 1});
    session.runFor(1s);
    QVERIFY2(worst > 0.0 && worst < 0.03, std::to_string(worst).c_str());
}

void TestMcpDriveStream::aResetBehindAStopIsNoticed_data()
{
    QTest::addColumn<bool>("twice");
    QTest::newRow("one reset") << false;
    QTest::newRow("another before anything was streamed again") << true;
}

/// A stop goes out with a Beacon at once, behind which a board does not tell any more that it was reset: its samples
/// are asked for again, and stand where they belong.
void TestMcpDriveStream::aResetBehindAStopIsNoticed()
{
    QFETCH(bool, twice);
    for (Duration late{}; late < 130ms; late += 9ms) {
        Session session;
        QVERIFY(session.startMotor());
        session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
        session.runFor(300ms);
        double newest = 0.0;
        capture::StreamLayout layout;
        session.onEvent = [&](const Event &event) {
            if (const auto *started = std::get_if<StreamStarted>(&event))
                layout = started->layout;
            if (const auto *block = std::get_if<capture::SampleBlock>(&event))
                newest = layout.originSeconds
                    + static_cast<double>(block->firstTick + block->count) / layout.tickHz;
        };
        session.board->reset();
        session.runFor(late);
        session.drive->stop(session.now);
        if (twice) {
            session.runFor(60ms);
            session.board->reset();
            session.runFor(9ms);
            session.drive->stop(session.now);
        }
        session.runFor(3s);
        const double old = toSeconds(session.now.time_since_epoch()) - newest;
        QVERIFY2(std::abs(old) < 0.03, std::to_string(old).c_str());
        QVERIFY(!session.drive->armed());
    }
}

void TestMcpDriveStream::aRecoveryShowsAsAGapOnly()
{
    Session session;
    QVERIFY(session.runAt(1500));
    session.runFor(1s);
    Judge judge(session);
    session.submit(Stream{{session.id("STOPLL_ROT_SPEED"), session.id("V_Q")}, 1, {}, 1});
    session.runFor(500ms);
    session.board->corruptAfter(1000);
    session.runFor(100ms);
    session.board->inject(Bytes{0xFF, 0x01, 0x02});
    session.runFor(100ms);
    session.toDrive.once = support::LineFaults::Once::Drop;
    session.toDrive.onceAt = session.toDrive.passed + 100;
    session.runFor(2s);
    QVERIFY(session.link == LinkState::Connected);
    QVERIFY(session.counters.recoveries > 0);
    QCOMPARE(judge.streams, 1U); // the same stream before and after
    QVERIFY(judge.lost > 0);
    QVERIFY2(judge.wrong.empty(), judge.wrong.c_str());
}

void TestMcpDriveStream::aLostByteCostsLittle_data()
{
    QTest::addColumn<QStringList>("names");
    QTest::addColumn<unsigned>("every");
    QTest::newRow("one signal") << QStringList{"V_Q"} << 1U;
    QTest::newRow("one signal, every fourth period") << QStringList{"V_Q"} << 4U;
    QTest::newRow("two signals") << QStringList{"V_Q", "STOPLL_ROT_SPEED"} << 1U;
    QTest::newRow("most of what the line carries")
        << QStringList{"STOPLL_ROT_SPEED", "V_Q", "I_D_REF", "I_D_REF"} << 1U;
    QTest::newRow("four signals, every eighth period")
        << QStringList{"STOPLL_ROT_SPEED", "V_Q", "I_D_REF", "I_D_REF"} << 8U;
}

/// Two packets of the stream in a row prove where they begin: the link is mended while the samples go on.
void TestMcpDriveStream::aLostByteCostsLittle()
{
    QFETCH(QStringList, names);
    QFETCH(unsigned, every);
    constexpr int kPlaces = 51;
    std::vector<double> costs;
    Session session;
    QVERIFY(session.runAt(1500));
    session.runFor(1s);
    Judge judge(session);
    std::vector<RegisterId> ids;
    for (const QString &name : names)
        ids.push_back(session.id(name.toStdString()));
    session.submit(Stream{ids, every, {}, 1});
    session.runFor(500ms);
    for (int i = 0; i < kPlaces; ++i) {
        const capture::Tick before = judge.lost;
        session.toDrive.once = support::LineFaults::Once::Drop;
        session.toDrive.onceAt = session.toDrive.passed + 100 + static_cast<std::uint64_t>(37 * i);
        session.runFor(600ms);
        costs.push_back(
            static_cast<double>(judge.lost - before) / session.identified->streaming.tickHz);
    }
    QVERIFY(session.link == LinkState::Connected);
    QVERIFY2(judge.wrong.empty(), judge.wrong.c_str());
    QCOMPARE(judge.streams, 1U);
    std::sort(costs.begin(), costs.end());
    const std::string told = "median " + std::to_string(costs[kPlaces / 2]) + " s, worst "
        + std::to_string(costs.back()) + " s";
    QVERIFY2(costs[kPlaces / 2] > 0.0 && costs[kPlaces / 2] <= 0.030, told.c_str());
}

void TestMcpDriveStream::aLineThatIsTooSlowShowsGaps()
{
    simulation::BoardOptions options;
    options.baud = 460800;
    Session session(true, options);
    QVERIFY(session.runAt(1500));
    session.runFor(1s);
    Judge judge(session);
    session.submit(
        Stream{{session.id("STOPLL_ROT_SPEED"), session.id("V_Q"), session.id("V_Q")}, 1, {}, 1});
    session.runFor(2s);
    QVERIFY(judge.lost > 1000);
    QVERIFY2(judge.wrong.empty(), judge.wrong.c_str());
    QVERIFY(session.link == LinkState::Connected);
}

void TestMcpDriveStream::linkTwoUsesItsOwnRegister()
{
    simulation::BoardOptions options;
    options.linkId = 1;
    Session session(false, options);
    QVERIFY(session.ready);
    QCOMPARE(session.requests.at(3).at(2), 0x69);
    const WishId wish = session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    QVERIFY(session.runUntilEnded(wish));
    QVERIFY(session.outcome(wish) == Outcome::Ok);
}

QTEST_APPLESS_MAIN(TestMcpDriveStream)
#include "tst_mcp_drive_stream.moc"
