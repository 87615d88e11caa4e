// Auto under a Stop: whatever language is being tried, the STOP goes out in each of them, and what is found is stopped.
// How Auto finds each kind of board is tried in tst_legacy_drive.
#include "support/fcp_bench.h"

#include "drive/protocol_table.h"
#include "drive/stop_sequence.h"

#include <QTest>

using namespace drive;
using support::boardOf;
using namespace std::chrono_literals;

namespace {

const Bytes kFcpStop{0x23, 0x01, 0x02, 0x26};

Bytes mcpStop() { return ByteWriter().u16((unsigned(mcp::CommandId::StopMotor) << 3) | 1U).take(); }

/// A board whose motor runs, without a link now.
struct Running : support::LinkPair {
    explicit Running(const char *profile, std::optional<Protocol> spoken = {})
        : LinkPair(boardOf(profile))
    {
        connect();
        ready = runUntilIdentified();
        drive->arm();
        submit(UserLimits{3000.0, 0.0});
        submit(ExpertMode{1});
        submit(Command{MotorAction::Start, 1});
        ready = ready && runUntilState(MotorState::Running);
        drive = makeDrive({Protocol::Auto, 115200, {}, spoken});
        status.clear();
        stops.clear();
        events.clear();
    }
    void press()
    {
        drive->stop(now);
        exchange();
    }
    int told(StopWord word) const
    {
        return static_cast<int>(std::count_if(stops.begin(), stops.end(),
            [&](const StopProgress &stop) { return stop.word == word; }));
    }
    bool ready = false;
};

} // namespace

class TestAutoDrive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aStopGoesOutInEveryLanguageInTurn();
    void whateverIsBeingTriedTheBoardIsStoppedSoon_data();
    void whateverIsBeingTriedTheBoardIsStoppedSoon();
    void betweenTwoRoundsAStopGoesOutAtOnce();
    void aTurnDropsNoStopOfTheLanguageBefore();
    void whatWasSpokenBeforeIsTriedFirst();
    void whatIsSpokenIsTold();
    void aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall_data();
    void aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall();
    void whatRefusesAsTheNewerProtocolIsAskedInNothingElse();
};

void TestAutoDrive::aStopGoesOutInEveryLanguageInTurn()
{
    Running line("mcsdk-6.4");
    QVERIFY(line.ready);
    line.toBoard.cut = line.toDrive.cut = true;
    std::vector<std::pair<TimePoint, char>> sent;
    line.loses = [&](const Bytes &bytes) {
        if (bytes == mcpStop())
            sent.emplace_back(line.now, 'n');
        if (bytes == kFcpStop)
            sent.emplace_back(line.now, 'o');
        return false;
    };
    line.connect();
    line.runFor(50ms);
    const TimePoint asked = line.now;
    line.press();
    line.runFor(490ms);
    QCOMPARE(line.told(StopWord::NotConfirmed), 0);
    line.runFor(20ms);
    QCOMPARE(line.told(StopWord::NotConfirmed), 1);
    line.press(); // hides nothing, and prolongs the blind time
    line.runFor(1490ms);
    QVERIFY2(sent.size() >= 16, std::to_string(sent.size()).c_str());
    for (std::size_t i = 1; i < sent.size(); ++i) {
        QVERIFY(sent[i].second != sent[i - 1].second || sent[i].first - asked < 700ms);
        QVERIFY(sent[i].first - sent[i - 1].first <= 200ms);
    }
    line.runFor(10s);
    QCOMPARE(line.told(StopWord::Requested), 1);
    QCOMPARE(line.told(StopWord::NotConfirmed), 1);
    QVERIFY(line.drive->stopOpen());
    line.toBoard.cut = line.toDrive.cut = false;
    QVERIFY(line.runUntil([&] { return !line.drive->stopOpen(); }, 20s)); // it is not forgotten
    QCOMPARE(line.told(StopWord::DriveIdle), 1);
}

void TestAutoDrive::whateverIsBeingTriedTheBoardIsStoppedSoon_data()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<int>("after_ms");
    for (const char *profile : {"mcsdk-6.4", "legacy", "powerpc"})
        for (const int after : {1, 50, 400, 1100, 1300, 1500, 1900, 2500})
            QTest::addRow("%s, %d ms after connecting", profile, after)
                << QByteArray(profile) << after;
}

void TestAutoDrive::whateverIsBeingTriedTheBoardIsStoppedSoon()
{
    QFETCH(QByteArray, profile);
    QFETCH(int, after_ms);
    Running line(profile.constData());
    QVERIFY(line.ready);
    line.toBoard.cut = line.toDrive.cut = true;
    line.connect();
    line.runFor(std::chrono::milliseconds(after_ms));
    line.press();
    line.runFor(400ms);
    line.toBoard.cut = line.toDrive.cut = false;
    const TimePoint back = line.now;
    QVERIFY(line.runUntil([&] { return line.told(StopWord::DriveIdle) > 0; }, 20s));
    const Duration took = line.now - back;
    // 400 ms of it firmware stays in its state STOP.
    QVERIFY2(took <= 700ms, std::to_string(toSeconds(took)).c_str());
    QVERIFY(line.runUntil([&] { return !line.drive->stopOpen(); }, 1s));
}

void TestAutoDrive::betweenTwoRoundsAStopGoesOutAtOnce()
{
    Running line("legacy");
    QVERIFY(line.ready);
    line.toBoard.cut = line.toDrive.cut = true;
    line.connect();
    QVERIFY(line.runUntil([&] { return line.link == LinkState::Lost; }, 20s));
    line.requests.clear();
    line.press();
    line.runFor(250ms);
    QVERIFY(std::count(line.requests.begin(), line.requests.end(), kFcpStop) >= 1);
    QCOMPARE(line.told(StopWord::Requested), 1);
}

/// A host that stalled sends the blind STOP late: the next language begins before it has left.
void TestAutoDrive::aTurnDropsNoStopOfTheLanguageBefore()
{
    const auto drive = makeDrive({Protocol::Auto, 115200, {}});
    TimePoint now{1s};
    drive->connect(now);
    drive->handleTimeout(now += 50ms); // bytes of the search may wait
    static_cast<void>(drive->takeOutput());
    drive->stop(now);
    std::vector<Output> newer = drive->takeOutput();
    for (const Duration late : {30ms, 67ms}) {
        drive->handleTimeout(now += late);
        for (Output &output : drive->takeOutput())
            newer.push_back(std::move(output));
    }
    QVERIFY(std::any_of(newer.begin(), newer.end(),
        [](const Output &output) { return output.bytes == mcpStop(); }));
    QVERIFY(newer.front().dropsEarlier); // what is older than the Stop
    drive->handleTimeout(now += 3ms);
    const std::vector<Output> older = drive->takeOutput();
    QVERIFY(std::any_of(
        older.begin(), older.end(), [](const Output &output) { return output.bytes == kFcpStop; }));
    for (const Output &output : older)
        QVERIFY(!output.dropsEarlier);
}

void TestAutoDrive::whatWasSpokenBeforeIsTriedFirst()
{
    Running line("legacy", Protocol::Fcp);
    QVERIFY(line.ready);
    line.requests.clear();
    line.connect();
    line.press();
    QVERIFY(!line.requests.empty() || line.runUntil([&] { return !line.requests.empty(); }, 1ms));
    QCOMPARE(line.requests.front(), kFcpStop); // the first frame at all
    QVERIFY(line.runUntil([&] { return !line.drive->stopOpen(); }, 500ms));
}

void TestAutoDrive::whatIsSpokenIsTold()
{
    Running line("powerpc");
    QVERIFY(line.ready);
    QVERIFY(!line.drive->memory().spoken);
    line.connect();
    QVERIFY(line.runUntil([&] { return line.drive->memory().spoken.has_value(); }, 5s));
    QVERIFY(line.drive->memory().spoken == Protocol::Fcp);
    line.drive->disconnect(line.now);
    QVERIFY(line.drive->memory().spoken == Protocol::Fcp);
}

void TestAutoDrive::aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall_data()
{
    QTest::addColumn<int>("baud");
    QTest::addColumn<bool>("deaf");
    for (const int baud : {115200, 1843200})
        for (const bool deaf : {false, true})
            QTest::addRow("%d baud%s", baud, deaf ? ", deaf meanwhile" : "") << baud << deaf;
}

/// Reset by the port's lines, booting, held by a debugger. One call of connect() tells no failure before.
void TestAutoDrive::aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall()
{
    QFETCH(int, baud);
    QFETCH(bool, deaf);
    support::Random random(deaf ? 7 : 8);
    for (int i = 0; i < 25; ++i) {
        const std::chrono::milliseconds silence(200 + random.below(3101));
        simulation::BoardOptions options;
        options.baud = static_cast<std::uint32_t>(baud);
        options.hfHz = 1000.0;
        support::LinkPair line(options, static_cast<std::uint64_t>(i) + 1);
        line.drive = makeDrive({Protocol::Auto, options.baud, {}});
        bool failed = false;
        line.onEvent = [&](const Event &event) {
            const auto *link = std::get_if<LinkChanged>(&event);
            failed = failed || (link != nullptr && link->state == LinkState::Lost);
        };
        line.board->mute(silence);
        line.toBoard.cut = deaf;
        line.connect();
        line.runFor(silence);
        line.toBoard.cut = false;
        const std::string place = std::to_string(silence.count()) + " ms";
        QVERIFY2(line.runUntilIdentified(4s), place.c_str());
        QVERIFY2(!failed, place.c_str());
    }
}

void TestAutoDrive::whatRefusesAsTheNewerProtocolIsAskedInNothingElse()
{
    simulation::BoardOptions options;
    options.baud = 115200;
    options.hfHz = 1000.0;
    support::LinkPair line(options);
    line.drive = makeDrive({Protocol::Auto, 115200, {}});
    line.board->mute(2300ms);
    line.connect();
    line.runFor(2300ms);
    Bytes heard;
    line.loses = [&](const Bytes &bytes) {
        const auto isBeacon = [](std::uint8_t first) { return (first & 0xFU) == 5; };
        heard.push_back(bytes.front());
        return bytes.size() == 4 && isBeacon(bytes.front()); // it never agrees
    };
    QVERIFY(line.runUntil([&] { return line.link == LinkState::Lost; }, 8s));
    const auto older = [&] { return std::count(heard.begin(), heard.end(), 0xFF); };
    QVERIFY2(older() <= 8, std::to_string(older()).c_str());
    line.loses = nullptr;
    QVERIFY(line.runUntilIdentified(3s));
}

QTEST_APPLESS_MAIN(TestAutoDrive)
#include "tst_auto_drive.moc"
