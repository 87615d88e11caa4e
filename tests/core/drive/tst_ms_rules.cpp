// The judge of the wire itself: each rule speaks when it is broken, and is silent when it is kept. Bytes are written
// here by hand, from the protocols' texts.
#include "support/ms_rules.h"
#include "support/wire/fcp.h"
#include "support/wire/mcb.h"
#include "support/wire/mcp.h"

#include <QTest>

#include <functional>

using judge::Act;
using judge::MsRules;
using namespace std::chrono_literals;

namespace {

constexpr std::uint16_t kStartWord = 3U << 3, kStopWord = 4U << 3, kToggle = 6U << 3,
                        kAck = 7U << 3, kSet = 1U << 3, kGet = 2U << 3, kBeat = 33U << 3;

Bytes withCheck(std::uint32_t header)
{
    const std::uint32_t word = header | judge::WireMcp::checkOf(header) << 28;
    return {std::uint8_t(word), std::uint8_t(word >> 8), std::uint8_t(word >> 16),
        std::uint8_t(word >> 24)};
}

/// A connected, identified board of MCP with one motor that does what the test says.
struct JudgeBench {
    MsRules judge;
    TimePoint now{1s};
    std::vector<judge::Motor> truth{judge::Motor{}};

    explicit JudgeBench(int motors = 1)
    {
        judge::Line line;
        line.motors = motors;
        line.maxRpm = 4000.0;
        line.gap = 500us;
        line.answerWithin = 10s;
        truth.resize(static_cast<std::size_t>(motors));
        judge.watch(std::make_unique<judge::WireMcp>(line.baud, 0.001), line);
        act(Act::Kind::Open);
        judge.said(judge::LinkState::Connected, now);
        judge.saidIdentified(motors, now);
        request({kGet, 0x49});
    }
    void act(Act::Kind kind, int motor = 1, std::uint64_t id = 0)
    {
        Act what;
        what.kind = kind;
        what.motor = motor;
        what.id = id;
        what.at = now;
        judge.asked(id, now);
        judge.act(what);
    }
    void setPoint(double rpm)
    {
        Act what;
        what.kind = Act::Kind::SetPoint;
        what.motor = 1;
        what.rpm = rpm;
        what.at = now;
        judge.act(what);
    }
    /// Header, pause, payload of 16-bit words, and the answer.
    void request(std::vector<std::uint16_t> words, Duration pause = 1500us, bool answered = true)
    {
        Bytes payload;
        for (const unsigned word : words) {
            payload.push_back(static_cast<std::uint8_t>(word));
            payload.push_back(static_cast<std::uint8_t>(word >> 8));
        }
        judge.sent(withCheck(static_cast<std::uint32_t>(payload.size()) << 4 | 9U), now);
        now += wireTime(4, 1843200) + pause;
        judge.sent(payload, now);
        now += 2ms;
        if (answered)
            judge.heard(withCheck(1U << 4 | 10U), now);
    }
    void ramp(std::int32_t rpm)
    {
        const auto bits = static_cast<std::uint32_t>(rpm);
        request({kSet, 0x1A9, 6, std::uint16_t(bits), std::uint16_t(bits >> 16), 500});
    }
    void run(Duration time)
    {
        for (const TimePoint end = now + time; now < end; now += 1ms) {
            judge.heard(Bytes{0}, now);
            judge.look(now, truth);
        }
    }
    void drive(int motor = 1) { truth[static_cast<std::size_t>(motor) - 1U] = {true, false, 1500}; }
    void arm()
    {
        act(Act::Kind::Arm);
        act(Act::Kind::Start);
        request({kStartWord | 1});
        drive();
        run(10ms);
    }
};

using Story = std::function<void(JudgeBench &)>;

Bytes frameOf(std::vector<unsigned> words)
{
    Bytes bytes;
    for (const unsigned word : words) {
        bytes.push_back(static_cast<std::uint8_t>(word >> 8));
        bytes.push_back(static_cast<std::uint8_t>(word));
    }
    const unsigned crc = judge::WireMcb::checkOf(bytes);
    bytes.push_back(static_cast<std::uint8_t>(crc >> 8));
    bytes.push_back(static_cast<std::uint8_t>(crc));
    return bytes;
}

/// A servo whose velocity is mapped and holds 5 turns a second; it is not armed.
struct ServoJudgeBench {
    MsRules judge;
    TimePoint now{1s};
    bool driven = false;

    ServoJudgeBench()
    {
        judge::Line line;
        line.maxRpm = 3000.0;
        line.suspect = line.lost = {};
        judge.watch(std::make_unique<judge::WireMcb>(), line);
        act(Act::Kind::Open);
        judge.said(judge::LinkState::Connected, now);
        judge.saidIdentified(1, now);
        exchange({0x0212, 0, 0, 0, 0}); // the velocity that it holds
        exchange({0x000E, 0, 0, 0, 0}, {0x0216, 0, 0x40A0, 0, 0});
        for (const std::vector<unsigned> &step :
            std::vector<std::vector<unsigned>>{{0x6404, 1, 0, 0, 0}, {0x6514, 0x0021, 0x0004, 0, 0},
                {0x6504, 1, 0, 0, 0}, {0x6404, 2, 0, 0, 0}})
            exchange(step);
    }
    void act(Act::Kind kind, std::optional<double> rpm = {})
    {
        Act what;
        what.kind = kind;
        what.motor = 1;
        what.rpm = rpm;
        what.at = now;
        judge.act(what);
    }
    void exchange(const std::vector<unsigned> &words, const std::vector<unsigned> &answer = {})
    {
        judge.sent(frameOf(words), now);
        judge.heard(
            frameOf(answer.empty() ? std::vector<unsigned>{0x000E, 0, 0, 0, 0} : answer), now);
        now += 1ms;
        judge.look(now, {{driven, !driven, 0.0}});
    }
    /// A frame without a request, and what travels in it.
    void travel(unsigned low, unsigned high) { exchange({0x000E, 0, 0, 0, 0, low, high}); }
    /// Of what was found; empty if nothing was.
    QString rule() const
    {
        return QString::fromStdString(judge.verdict()).section(QLatin1Char(':'), 0, 0);
    }
};

using ServoStory = std::function<void(ServoJudgeBench &)>;
constexpr unsigned kFive = 0x40A0, kTen = 0x4120; ///< the upper halves of 5.0 and 10.0
constexpr unsigned kHundred = 0x42C8;

} // namespace

Q_DECLARE_METATYPE(Story)
Q_DECLARE_METATYPE(ServoStory)

class TestMsRules : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aBrokenRuleSpeaks_data();
    void aBrokenRuleSpeaks();
    void whatIsKeptIsSilent();
    void aYesBeforeTheStopIsForWhatWasUnderWay();
    void whoArmsWhileTheMotorComesToRestMayBeHeard();
    void theOrderOfStopsIsTheDrives();
    void aListOfParametersTakesNothingFromOthers();
    void aSeriesMayStepAsLongAsItLasts();
    void aMotorNobodyKnowsOfIsStoppedWhenItIsKnown();
    void theTwoSecondsOfAStopGoOnInAGap();
    void aGapBeforeAStopPutsNothingOff();
    void anAlarmThatStandsIsNotRepeated();
    void framesOfTheOlderProtocolAreTakenApart();
    void framesOfTheBusAreTakenApart();
    void whatTravelsIsJudgedWhereItChanges_data();
    void whatTravelsIsJudgedWhereItChanges();
};

void TestMsRules::aBrokenRuleSpeaks_data()
{
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Story>("story");
    const auto story = [](const char *name, const char *rule, Story what) {
        QTest::newRow(name) << QString(rule) << what;
    };
    story("a toggle", "never", [](JudgeBench &b) {
        b.arm();
        b.request({kToggle | 1});
    });
    story("an empty request", "never", [](JudgeBench &b) { b.judge.sent(withCheck(9U), b.now); });
    story("a false check", "never", [](JudgeBench &b) { b.judge.sent(Bytes{9, 0, 0, 0}, b.now); });
    story("motor 0", "motors that are there", [](JudgeBench &b) { b.request({kStopWord}); });
    story(
        "motor 2 of 1", "motors that are there", [](JudgeBench &b) { b.request({kStopWord | 2}); });
    story("never armed", "armed", [](JudgeBench &b) {
        b.act(Act::Kind::Start);
        b.request({kStartWord | 1});
    });
    story("armed before a Stop", "armed", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Stop);
        b.request({kAck | 1});
    });
    story("armed before the link was lost", "armed", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.judge.said(judge::LinkState::Lost, b.now);
        b.judge.said(judge::LinkState::Connected, b.now);
        b.request({kSet, 0x91, 5});
    });
    story("a start that nobody asked for", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.request({kStartWord | 1});
    });
    story("a start twice", "asked for", [](JudgeBench &b) {
        b.arm();
        b.request({kStartWord | 1});
    });
    story("another speed than the one asked for", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.setPoint(1000.0);
        b.ramp(2000);
    });
    story("a write after its wish has ended", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Acknowledge, 1, 7);
        b.judge.saidEnded(7, b.now);
        b.request({kAck | 1});
    });
    story("a read during a Stop", "stop first", [](JudgeBench &b) {
        b.arm();
        b.act(Act::Kind::Stop);
        b.request({kStopWord | 1});
        b.request({kGet, 0x691});
    });
    story("a heartbeat unarmed", "heartbeats", [](JudgeBench &b) { b.request({kBeat | 1, 500}); });
    story("a restore that moves", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Input);
        b.act(Act::Kind::Restore);
        b.request({kSet, 0x91, 5}); // a gain may be restored
        b.ramp(1000);
    });
    story("a set-point among parameters", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Restore, 0, 7);
        b.request({kSet, 0x91, 5});
        b.request({kSet, 0x99, 1000, 0}); // the speed's reference
    });
    story("a first start without a question", "first starts are asked", [](JudgeBench &b) {
        b.judge.line().asksFirst = true;
        b.act(Act::Kind::Confirm);
        b.act(Act::Kind::Stop);
        b.run(5ms);
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Input);
        b.request({kStartWord | 1});
    });
    story(
        "agreed to a jog, then started by the button", "first starts are asked", [](JudgeBench &b) {
            b.judge.line().asksFirst = true;
            b.act(Act::Kind::Arm);
            b.act(Act::Kind::AgreeToHold);
            b.run(2s);
            b.act(Act::Kind::Input);
            b.request({kStartWord | 1});
        });
    story("too fast for the board", "bounded", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.setPoint(5000.0);
        b.ramp(5000);
    });
    story("too fast for the person", "bounded", [](JudgeBench &b) {
        Act limits;
        limits.kind = Act::Kind::Limits;
        limits.rpm = 800.0;
        b.judge.act(limits);
        b.act(Act::Kind::Arm);
        b.setPoint(-1000.0);
        b.ramp(-1000);
    });
    story("two requests at once", "one in flight", [](JudgeBench &b) {
        b.request({kGet, 0x49}, 1500us, false);
        b.request({kGet, 0x49});
    });
    story("a write is the first request", "looks first", [](JudgeBench &b) {
        b.act(Act::Kind::Close);
        b.act(Act::Kind::Open);
        b.act(Act::Kind::Arm);
        b.request({kSet, 0x91, 5});
    });
    story("a start that comes late", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Start);
        b.now += 600ms;
        b.request({kStartWord | 1});
    });
    story("a start that was meant for another time", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        Act start;
        start.kind = Act::Kind::Start;
        start.motor = 1;
        start.at = b.now - 600ms;
        b.judge.act(start);
        b.request({kStartWord | 1});
    });
    story("a series that nobody agreed to", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Series);
        b.ramp(1500);
    });
    story("a series after a Stop", "armed", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::AgreeToSeries);
        b.act(Act::Kind::Stop);
        b.act(Act::Kind::Series);
        b.ramp(1500);
    });
    story("a series that was agreed to before it was disarmed", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::AgreeToSeries);
        b.act(Act::Kind::Disarm);
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Series);
        b.ramp(1500);
    });
    story("a series that starts twice", "asked for", [](JudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::AgreeToSeries);
        b.request({kStartWord | 1});
        b.request({kStartWord | 1});
    });
    story("gone from a motor that turns", "stops before it goes", [](JudgeBench &b) {
        b.arm();
        b.judge.closes(b.now);
    });
    story("no pause before the payload", "payload pause", [](JudgeBench &b) {
        b.request({kGet, 0x49}, 100us);
    });
    story("a Stop that does not leave", "stop in time", [](JudgeBench &b) {
        b.arm();
        b.act(Act::Kind::Stop);
        b.run(150ms);
    });
    story("a Stop that is not repeated", "stop in time", [](JudgeBench &b) {
        b.arm();
        b.act(Act::Kind::Stop);
        b.request({kStopWord | 1});
        b.run(250ms);
    });
    story("no alarm", "alarm", [](JudgeBench &b) {
        b.arm();
        b.act(Act::Kind::Stop);
        for (int i = 0; i < 8; ++i) {
            b.request({kStopWord | 1});
            b.run(98ms);
        }
    });
    story("pressing again puts off the alarm", "alarm", [](JudgeBench &b) {
        b.arm();
        for (int i = 0; i < 8; ++i) {
            b.act(Act::Kind::Stop);
            b.request({kStopWord | 1});
            b.run(98ms);
        }
    });
    story("\"drive idle\" of a driven motor", "true words", [](JudgeBench &b) {
        b.arm();
        b.run(600ms);
        b.judge.said(judge::Word::DriveIdle, 1, b.now);
    });
    story("\"standstill\" of a turning motor", "true words", [](JudgeBench &b) {
        b.arm();
        b.run(600ms);
        b.judge.said(judge::Word::Standstill, 1, b.now);
    });
    story("an old state told as new", "fresh",
        [](JudgeBench &b) { b.judge.saidStatus(b.now - 700ms, b.now); });
    story("silence called connected", "silence is told", [](JudgeBench &b) {
        for (int i = 0; i < 700; ++i, b.now += 1ms)
            b.judge.look(b.now, b.truth);
    });
    story("a wish that ends twice", "ends once", [](JudgeBench &b) {
        b.judge.asked(3, b.now);
        b.judge.saidEnded(3, b.now);
        b.judge.saidEnded(3, b.now);
    });
    story("a wish that never ends", "ends once", [](JudgeBench &b) {
        b.judge.asked(3, b.now);
        b.judge.settle(b.now);
    });
}

void TestMsRules::aBrokenRuleSpeaks()
{
    QFETCH(QString, rule);
    QFETCH(Story, story);
    JudgeBench bench;
    QCOMPARE(bench.judge.verdict(), std::string());
    story(bench);
    QVERIFY2(QString::fromStdString(bench.judge.verdict()).startsWith(rule + ": "),
        ("it said: " + bench.judge.verdict()).c_str());
}

void TestMsRules::whatIsKeptIsSilent()
{
    JudgeBench b;
    b.arm();
    b.setPoint(1500.0);
    b.ramp(1500);
    b.run(300ms);
    // A packet whose header has left before the Stop is finished: half of it would swallow the STOP.
    b.judge.sent(withCheck(2U << 4 | 9U), b.now);
    b.act(Act::Kind::Stop);
    b.now += 2ms;
    b.judge.sent(Bytes{kStopWord | 1, 0}, b.now);
    b.request({kStopWord | 1});
    b.request({kGet, 0x49, 0x59});
    b.run(20ms);
    b.truth[0] = {};
    b.run(2ms);
    b.judge.said(judge::Word::DriveIdle, 1, b.now);
    b.judge.said(judge::Word::Standstill, 1, b.now);
    b.request({kGet, 0x691});
    b.arm();
    b.act(Act::Kind::Stop);
    b.request({kStopWord | 1});
    b.run(50ms);
    b.truth[0] = {};
    b.run(1s);
    QCOMPARE(b.judge.verdict(), std::string());
    QCOMPARE(b.judge.counts().starts, 2);
}

/// A START whose header has left before the Stop was agreed to before it; the next one is asked about all the same.
void TestMsRules::aYesBeforeTheStopIsForWhatWasUnderWay()
{
    for (const bool asked : {false, true}) {
        JudgeBench b;
        b.judge.line().asksFirst = true;
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Start);
        if (asked)
            b.act(Act::Kind::Confirm);
        b.judge.sent(withCheck(2U << 4 | 9U), b.now);
        b.act(Act::Kind::Stop);
        b.now += 2ms;
        b.judge.sent(Bytes{kStartWord | 1, 0}, b.now);
        QCOMPARE(b.judge.verdict().empty(), asked);
        b.request({kStopWord | 1});
        b.run(20ms);
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Start);
        b.request({kStartWord | 1});
        QVERIFY(b.judge.verdict().starts_with("first starts are asked: "));
    }
}

void TestMsRules::whoArmsWhileTheMotorComesToRestMayBeHeard()
{
    for (const bool threads : {false, true}) {
        JudgeBench b;
        b.judge.line().grace = threads ? 300ms : 0ms;
        b.arm();
        b.act(Act::Kind::Stop);
        b.request({kStopWord | 1});
        b.act(Act::Kind::
                Arm); // at the window; the line's thread hears of it after the motor came to rest
        b.truth[0] = {};
        b.run(20ms);
        b.act(Act::Kind::Start);
        b.request({kStartWord | 1});
        QCOMPARE(b.judge.verdict().empty(), threads);
        // A Stop that comes after it counts.
        b.drive();
        b.run(2ms);
        b.act(Act::Kind::Stop);
        b.request({kStopWord | 1});
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::Stop);
        b.truth[0] = {};
        b.run(20ms);
        b.act(Act::Kind::Start);
        b.request({kStartWord | 1});
        QVERIFY(!b.judge.verdict().empty());
    }
}

void TestMsRules::theOrderOfStopsIsTheDrives()
{
    JudgeBench b(2);
    b.act(Act::Kind::Arm);
    b.drive(1);
    b.drive(2);
    b.act(Act::Kind::Stop);
    b.run(80ms);
    b.request({kStopWord | 2});
    b.run(80ms);
    b.request({kStopWord | 1});
    QCOMPARE(b.judge.verdict(), std::string());
    b.run(220ms);
    QCOMPARE(b.judge.verdict(), std::string());
    b.run(10ms); // the repetition of the first
    b.run(250ms);
    QVERIFY(QString::fromStdString(b.judge.verdict()).startsWith(QLatin1String("stop in time: ")));
}

void TestMsRules::aListOfParametersTakesNothingFromOthers()
{
    JudgeBench b;
    b.act(Act::Kind::Arm);
    b.act(Act::Kind::Start, 1, 6); // waits to leave
    b.act(Act::Kind::Restore, 0, 7);
    b.request({kSet, 0x91, 5});
    b.judge.saidEnded(7, b.now);
    b.request({kStartWord | 1});
    QCOMPARE(b.judge.verdict(), std::string());
    b.request({kSet, 0x91, 5});
    QVERIFY(QString::fromStdString(b.judge.verdict()).startsWith(QLatin1String("asked for: ")));
}

void TestMsRules::aSeriesMayStepAsLongAsItLasts()
{
    JudgeBench b;
    b.act(Act::Kind::Arm);
    b.act(Act::Kind::AgreeToSeries);
    b.ramp(1000);
    b.request({kStartWord | 1});
    b.drive();
    for (int i = 0; i < 10; ++i) {
        b.ramp(i % 2 == 0 ? 1500 : 1000);
        b.run(1s);
    }
    b.act(Act::Kind::Series); // one more is not asked about
    b.ramp(1500);
    QCOMPARE(b.judge.verdict(), std::string());
    b.run(MsRules::kSeries);
    b.ramp(1000);
    QVERIFY(QString::fromStdString(b.judge.verdict()).startsWith(QLatin1String("asked for: ")));
}

void TestMsRules::aMotorNobodyKnowsOfIsStoppedWhenItIsKnown()
{
    JudgeBench b(2);
    b.drive(1);
    b.drive(2);
    b.act(Act::Kind::Open);
    b.act(Act::Kind::Stop);
    b.request({kStopWord | 1}); // no other one is known
    b.truth[0] = {};
    b.judge.said(judge::Word::NotConfirmed, 1, b.now);
    b.run(200ms);
    QCOMPARE(b.judge.verdict(), std::string());
    b.judge.saidIdentified(2, b.now);
    b.run(400ms);
    const auto verdict = QString::fromStdString(b.judge.verdict());
    QVERIFY2(verdict.startsWith("stop in time: motor 2"), qPrintable(verdict));
}

void TestMsRules::theTwoSecondsOfAStopGoOnInAGap()
{
    JudgeBench b;
    b.drive(1);
    b.act(Act::Kind::Stop);
    b.request({kStopWord | 1});
    b.run(100ms);
    b.now += 2s; // no thread ran
    b.run(10ms);
    b.request({kStopWord | 1});
    b.judge.said(judge::Word::NotConfirmed, 1, b.now);
    b.request({kGet, 0x91});
    QCOMPARE(b.judge.verdict(), std::string());
}

void TestMsRules::aGapBeforeAStopPutsNothingOff()
{
    JudgeBench bench;
    bench.arm();
    bench.now += 500ms; // a gap
    bench.judge.said(judge::LinkState::Lost, bench.now);
    bench.act(Act::Kind::Stop);
    for (int i = 0; i < 25; ++i) { // blind, for two seconds from the press
        if (i < 20)
            bench.request({kStopWord | 1}, 1500us, false);
        if (i == 4)
            bench.judge.said(judge::Word::NotConfirmed, 1, bench.now);
        bench.run(96ms);
    }
    QVERIFY2(bench.judge.violations().empty(), bench.judge.verdict().c_str());
}

/// A START that was on its way when Stop was pressed, so that the motor was at rest for a moment.
void TestMsRules::anAlarmThatStandsIsNotRepeated()
{
    for (const bool told : {true, false}) {
        JudgeBench bench;
        bench.act(Act::Kind::Stop);
        bench.run(5ms);
        bench.drive();
        if (told)
            bench.judge.said(judge::Word::NotConfirmed, 1, bench.now);
        bench.act(Act::Kind::Stop);
        for (int i = 0; i < 7; ++i) {
            bench.request({kStopWord | 1});
            bench.run(97ms);
        }
        QCOMPARE(bench.judge.violations().empty(), told);
    }
}

void TestMsRules::framesOfTheOlderProtocolAreTakenApart()
{
    judge::WireFcp wire;
    const auto only = [&](const Bytes &bytes) { return wire.sent(bytes, {}).at(0); };
    // Header, length, payload, check: the two bytes of the sum added up.
    const judge::Sent start = only({0x23, 0x01, 0x01, 0x25});
    QCOMPARE(start.kind, judge::Kind::Start);
    QCOMPARE(start.motor, 1);
    QCOMPARE(only({0x43, 0x01, 0x02, 0x46}).kind, judge::Kind::Stop);
    QCOMPARE(only({0x22, 0x01, 0x02, 0x25}).kind, judge::Kind::StatusRead);
    const judge::Sent ramp = only({0x27, 0x06, 0x18, 0xFC, 0xFF, 0xFF, 0x64, 0x00, 0xA6});
    QCOMPARE(ramp.kind, judge::Kind::SetPoint);
    QCOMPARE(*ramp.rpm, -1000.0);
    QCOMPARE(only({0x23, 0x01, 0x06, 0x2A}).kind, judge::Kind::Never); // START_STOP
    QCOMPARE(only({0x23, 0x01, 0x01, 0x26}).kind, judge::Kind::Never); // its check
    QCOMPARE(only({0xFF}).kind, judge::Kind::LinkControl);
}

void TestMsRules::framesOfTheBusAreTakenApart()
{
    judge::WireMcb wire;
    const auto frame = [&](const std::vector<unsigned> &words) {
        return wire.sent(frameOf(words), {}).at(0);
    };
    QCOMPARE(frame({0x0104, 0x0006, 0, 0, 0}).kind, judge::Kind::Stop);
    QCOMPARE(frame({0x0104, 0x000F, 0, 0, 0}).kind, judge::Kind::Start);
    QCOMPARE(frame({0x0104, 0x0080, 0, 0, 0}).kind, judge::Kind::Acknowledge);
    const judge::Sent speed = frame({0x0214, 0x0000, 0x40A0, 0, 0}); // 5 turns a second
    QCOMPARE(speed.kind, judge::Kind::SetPoint);
    QCOMPARE(*speed.rpm, 300.0);
    QCOMPARE(frame({0x0112, 0, 0, 0, 0}).kind, judge::Kind::StatusRead);
    QCOMPARE(wire.sent(Bytes(12, 0xFF), {}).at(0).kind, judge::Kind::LinkControl); // a clock alone
    QCOMPARE(wire.sent(Bytes(12, 0x0F), {}).at(0).kind, judge::Kind::Never);
}

void TestMsRules::whatTravelsIsJudgedWhereItChanges_data()
{
    QTest::addColumn<QString>("rule");
    QTest::addColumn<ServoStory>("story");
    const auto story = [](const char *name, const char *rule, ServoStory what) {
        QTest::newRow(name) << QString(rule) << what;
    };
    story("what it holds goes on", "", [](ServoJudgeBench &b) {
        for (int i = 0; i < 5; ++i)
            b.travel(0, kFive);
    });
    story("mapping moves it", "armed", [](ServoJudgeBench &b) { b.travel(0, kTen); });
    story("it was asked for", "", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::SetPoint, 600.0);
        b.travel(0, kTen);
        b.travel(0, kTen);
    });
    story("nobody asked for it", "asked for", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.travel(0, kTen);
    });
    story("it was asked for once", "asked for", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::SetPoint, 600.0);
        b.travel(0, kTen);
        b.travel(0, kFive);
        b.travel(0, kTen);
    });
    story("beyond the limit", "bounded", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.act(Act::Kind::SetPoint, 6000.0);
        b.travel(0, kHundred);
    });
    story("rest with a Stop", "", [](ServoJudgeBench &b) {
        b.driven = true;
        b.travel(0, kFive);
        b.act(Act::Kind::Stop);
        b.travel(0, 0);
    });
    story("it goes on in spite of a Stop", "stop first", [](ServoJudgeBench &b) {
        b.driven = true;
        b.travel(0, kFive);
        b.act(Act::Kind::Stop);
        b.travel(0, kFive);
    });
    story("another value with a Stop", "armed", [](ServoJudgeBench &b) {
        b.driven = true;
        b.travel(0, kFive);
        b.act(Act::Kind::Stop);
        b.travel(0, kTen);
    });
    story("back after the Stop", "asked for", [](ServoJudgeBench &b) {
        b.travel(0, kFive);
        b.act(Act::Kind::Stop);
        b.travel(0, 0);
        b.act(Act::Kind::Arm);
        b.travel(0, kFive);
    });
    story("to zero under a motor that turns", "asked for", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.driven = true;
        b.travel(0, kFive);
        b.travel(0, 0);
    });
    story("to zero by a person's wish", "", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Arm);
        b.driven = true;
        b.travel(0, kFive);
        b.act(Act::Kind::SetPoint, 0.0);
        b.travel(0, 0);
    });
    story("the drive's own mind", "", [](ServoJudgeBench &b) {
        b.travel(0, kFive);
        b.exchange({0x0212, 0, 0, 0, 0, 0, kFive}, {0x000E, 0, 0, 0, 0, 0, 0});
        b.exchange({0x000E, 0, 0, 0, 0, 0, kFive}, {0x0216, 0, kTen, 0, 0, 0, 0});
        b.travel(0, kTen);
    });
    story("what a damaged answer says is nobody's", "armed", [](ServoJudgeBench &b) {
        b.travel(0, kFive);
        b.judge.sent(frameOf({0x0212, 0, 0, 0, 0, 0, kFive}), b.now);
        Bytes answer = frameOf({0x0216, 0, kTen, 0, 0, 0, 0});
        answer[1] ^= 1U;
        b.judge.heard(answer, b.now);
        b.travel(0, kTen);
    });
    story("words of no mapping", "never", [](ServoJudgeBench &b) {
        b.exchange({0x000E, 0, 0, 0, 0, 0, kFive, 0});
    });
    story("zeros of no mapping", "", [](ServoJudgeBench &b) {
        b.exchange({0x000E, 0, 0, 0, 0, 0, 0, 0});
    });
    story("after the line has gone no mapping is known", "never", [](ServoJudgeBench &b) {
        b.act(Act::Kind::Unplugged);
        b.act(Act::Kind::Open);
        b.travel(0, kFive);
    });
}

/// The mapping is read from the bytes that brought it about, and so is what the drive holds.
void TestMsRules::whatTravelsIsJudgedWhereItChanges()
{
    QFETCH(QString, rule);
    QFETCH(ServoStory, story);
    ServoJudgeBench bench;
    story(bench);
    QVERIFY2(bench.rule() == rule, bench.judge.verdict().c_str());
}

QTEST_APPLESS_MAIN(TestMsRules)
#include "tst_ms_rules.moc"
