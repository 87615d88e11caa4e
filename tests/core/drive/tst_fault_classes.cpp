// Faults of line and board that no other test brings about: a board of another protocol than the one that is chosen, a
// foreign program that talks on the port, and a datalog that is set up anew before the last set-up has arrived.
// ROTORSCOPE_LONG=1 runs more of each.
#include "drive/protocol_table.h"
#include "simulation/mcb/board.h"
#include "support/link_pair.h"
#include "support/wire/either.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;
using support::LinkPair;

class TestFaultClasses : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingActsOnABoardOfAnotherProtocol_data();
    void nothingActsOnABoardOfAnotherProtocol();
    void aForeignProgramOnThePortIsOvercome_data();
    void aForeignProgramOnThePortIsOvercome();
    void aThousandNewSetUpsMixNoSignals();
};

namespace {

bool isLong() { return qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0; }

constexpr std::array kBoards{"mcsdk-6.0", "mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.3", "mcsdk-6.4",
    "six-step", "hso", "spec", "legacy", "legacy-text", "powerpc", "mcb"};

simulation::BoardOptions slow(const char *profile)
{
    simulation::BoardOptions options;
    options.profile = profile;
    options.baud = 115200;
    options.hfHz = 1000.0; // the motor is not what is looked at
    return options;
}

std::unique_ptr<judge::Decoder> decoderOf(Protocol client)
{
    if (client == Protocol::Auto)
        return std::make_unique<judge::WireEither>();
    if (client == Protocol::Mcp)
        return std::make_unique<judge::WireMcp>(115200, 0.0);
    return std::make_unique<judge::WireFcp>();
}

bool acts(judge::Kind kind)
{
    using enum judge::Kind;
    return kind == Start || kind == SetPoint || kind == Mode || kind == Write || kind == Acknowledge
        || kind == StopRamp;
}

} // namespace

void TestFaultClasses::nothingActsOnABoardOfAnotherProtocol_data()
{
    QTest::addColumn<QString>("board");
    QTest::addColumn<int>("client");
    for (const char *board : kBoards)
        for (const Protocol client :
            {Protocol::Mcp, Protocol::Fcp, Protocol::PowerPc, Protocol::Auto})
            QTest::addRow("%s met by client %d", board, int(client)) << board << int(client);
}

void TestFaultClasses::nothingActsOnABoardOfAnotherProtocol()
{
    QFETCH(QString, board);
    QFETCH(int, client);
    const bool mcb = board == QLatin1String("mcb");
    LinkPair pair(slow(mcb ? "mcsdk-6.4" : qPrintable(board)), 1);
    if (mcb)
        pair.board = simulation::makeMcbBoard({});
    pair.drive = makeDrive({static_cast<Protocol>(client), 115200, {}});
    const auto decoder = decoderOf(static_cast<Protocol>(client));
    int acted = 0, never = 0;
    pair.loses = [&](const Bytes &output) {
        const bool trusted = pair.identified && pair.identified->identity.knownFirmware;
        for (const judge::Sent &one : decoder->sent(output, pair.now)) {
            acted += acts(one.kind) && !trusted ? 1 : 0;
            never += one.kind == judge::Kind::Never ? 1 : 0;
        }
        return false;
    };
    pair.connect();
    // A user who tries all the same.
    std::vector<WishId> wishes;
    for (int i = 0; i < (isLong() ? 100 : 25) && !pair.identified; ++i) {
        pair.drive->arm();
        wishes.push_back(pair.submit(Command{MotorAction::Start, 1}));
        wishes.push_back(pair.submit(Write{{{0x90, std::int64_t{7}}}}));
        wishes.push_back(pair.submit(SpeedRamp{1, 100, 100ms}));
        pair.runFor(200ms);
    }
    pair.runFor(1s);
    QCOMPARE(acted, 0);
    QCOMPARE(never, 0);
    QVERIFY(!pair.status.contains(1) || pair.status.at(1).state == MotorState::Idle
        || pair.status.at(1).state == MotorState::Unknown);
    pair.drive->disconnect(pair.now);
    pair.runFor(1s);
    for (const WishId wish : wishes)
        QCOMPARE(pair.ended[wish].size(), 1U);
}

void TestFaultClasses::aForeignProgramOnThePortIsOvercome_data()
{
    QTest::addColumn<QString>("board");
    for (const char *board : {"mcsdk-6.4", "mcsdk-6.0", "legacy", "powerpc"})
        QTest::addRow("%s", board) << board;
}

/// ModemManager asks a new port for a modem some seconds after it has appeared. What it asks reaches the board between
/// our packets or within them, and what the board makes of it reaches us.
void TestFaultClasses::aForeignProgramOnThePortIsOvercome()
{
    QFETCH(QString, board);
    for (int seed = 1; seed <= (isLong() ? 200 : 5); ++seed) {
        const QByteArray place = "seed " + QByteArray::number(seed);
        LinkPair pair(slow(qPrintable(board)), static_cast<std::uint64_t>(seed));
        support::Random random(static_cast<std::uint64_t>(seed));
        pair.connect();
        QVERIFY2(pair.runUntilIdentified(10s), place.constData());
        pair.drive->arm();
        const RegisterId gain = pair.id("SPEED_KP");
        std::vector<WishId> wishes;
        pair.runFor(pair.now < TimePoint{} + 4s ? TimePoint{} + 4s - pair.now : Duration{});
        const TimePoint end = pair.now + 5s;
        while (pair.now < end) {
            const Bytes probe = ByteWriter().text("AT\r\n").take();
            for (std::uint64_t i = 0; i <= random.below(4); ++i)
                pair.board->receive(probe, pair.now);
            if (random.below(2) == 0)
                pair.board->inject(probe);
            wishes.push_back(pair.submit(Read{{gain}}));
            pair.runFor(Duration(random.below(600'000'000)));
        }
        QVERIFY2(pair.runUntil([&] { return pair.link == LinkState::Connected; }, 5s),
            place.constData());
        wishes.push_back(pair.submit(Read{{gain}}));
        QVERIFY2(pair.runUntilEnded(wishes.back()), place.constData());
        QCOMPARE(pair.outcome(wishes.back()), Outcome::Ok);
        for (const WishId wish : wishes)
            QVERIFY2(pair.ended[wish].size() == 1, place.constData());
        QVERIFY2(pair.status.at(1).state == MotorState::Idle, place.constData());
    }
}

/// The board is told of new sources as fast as it answers; packets of the set-up before are still on their way then.
/// Signals of one register twice over must be equal, and those of another register must not stand in their place.
void TestFaultClasses::aThousandNewSetUpsMixNoSignals()
{
    support::Session session;
    QVERIFY(session.startMotor());
    support::Random random(7);
    capture::StreamLayout layout;
    int wrong = 0, compared = 0;
    session.onEvent = [&](const Event &event) {
        if (const auto *started = std::get_if<StreamStarted>(&event))
            layout = started->layout;
        const auto *block = std::get_if<capture::SampleBlock>(&event);
        if (block == nullptr)
            return;
        wrong += block->stream != layout.id ? 1 : 0;
        for (std::size_t a = 0; a < layout.fast.size(); ++a)
            for (std::size_t b = a + 1; b < layout.fast.size(); ++b) {
                if (layout.fast[a].id != layout.fast[b].id)
                    continue;
                ++compared;
                wrong += std::equal(block->fast.begin() + std::ptrdiff_t(a * block->count),
                             block->fast.begin() + std::ptrdiff_t((a + 1) * block->count),
                             block->fast.begin() + std::ptrdiff_t(b * block->count))
                    ? 0
                    : 1;
            }
    };
    const std::array<RegisterId, 4> sources{
        session.id("I_A"), session.id("I_B"), session.id("V_Q"), session.id("STOPLL_ROT_SPEED")};
    constexpr int kTimes = 1000; // marks are used again after 255
    for (int i = 0; i < kTimes; ++i) {
        const RegisterId twice = sources[random.below(sources.size())];
        const RegisterId other = sources[random.below(sources.size())];
        Stream stream{{twice, other, twice}, 1 + unsigned(random.below(3)), {}, 1};
        if (random.below(2) == 0)
            stream.fast = {other, twice, other, twice};
        const WishId wish = session.submit(stream);
        session.runFor(Duration(random.below(12'000'000)));
        if (random.below(3) == 0)
            QVERIFY(session.runUntilEnded(wish));
    }
    session.runFor(300ms);
    QCOMPARE(wrong, 0);
    constexpr int kEnough = kTimes / 10; // a packet takes longer than most set-ups last
    QVERIFY2(compared > kEnough, qPrintable(QString::number(compared)));
    QCOMPARE(session.status[1].state, MotorState::Running);
}

QTEST_APPLESS_MAIN(TestFaultClasses)
#include "tst_fault_classes.moc"
