// FcpDrive on simulated boards of both dialects with a motor behind them: who is there, reading and writing, starting
// and ramping within what the user allows, stopping, and watching as fast as the line gives.
#include "support/fcp_bench.h"

#include "drive/protocol_table.h"
#include "fcp/framer.h"
#include "fcp/reply.h"
#include "fcp/request.h"
#include "support/start_notice.h"

#include <QTest>

using namespace drive;
using support::boardOf;
using support::isRead;
using namespace std::chrono_literals;

namespace {

void fcpProfileRows()
{
    QTest::addColumn<QByteArray>("profile");
    for (const std::string_view name : simulation::fcpProfiles())
        QTest::newRow(name.data()) << QByteArray(name.data());
}

} // namespace

class TestFcpDrive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void identificationOnlyReads_data() { fcpProfileRows(); }
    void identificationOnlyReads();
    void theDialectIsFoundOut_data();
    void theDialectIsFoundOut();
    void theWrongDialectIsReadOnly_data();
    void theWrongDialectIsReadOnly();
    void namesAreThoseOfTheForms_data() { fcpProfileRows(); }
    void namesAreThoseOfTheForms();
    void aWriteIsReadBack_data() { fcpProfileRows(); }
    void aWriteIsReadBack();
    void aWriteNeedsArming();
    void aRefusedWriteIsRefused();
    void stagesOfTheRevUpAreOneRegister();
    void speedsThatTheBoardRoundsAreWrittenAllTheSame();
    void withoutARevUpItsStagesAreNeverSent();
    void withoutKnownLimitsNothingMoves_data() { fcpProfileRows(); }
    void withoutKnownLimitsNothingMoves();
    void theMotorStartsRampsAndStops_data() { fcpProfileRows(); }
    void theMotorStartsRampsAndStops();
    void beyondAPersonsLimitNothingIsSent();
    void aSpeedOf16BitsOfStepsIsSent();
    void ofTwoMotorsOnlyTheNamedOneMoves();
    void afterAStopNothingButStopsAndReads();
    void aStopWithoutALinkIsSentBlind();
    void aMotorThatBecomesKnownWhileStoppingIsStopped_data() { fcpProfileRows(); }
    void aMotorThatBecomesKnownWhileStoppingIsStopped();
    void aLostLinkIsToldWhileAPersonKeepsPressing();
    void anOutagePutsNoLookAtTheMotorsOff();
    void aStatusIsOfOneTime();
    void aRestartedBoardIsMetAnewAndReadOnly();
    void aLostBoardIsFoundAgain();
    void watchingFillsTheLine();
    void watchedRegistersGetFairShares();
    void autoFindsEachKind_data();
    void autoFindsEachKind();
    void autoSendsNothingThatActs();
    void aStopWhileAutoStillLooksStopsWhatItFinds();
};

void TestFcpDrive::identificationOnlyReads()
{
    QFETCH(QByteArray, profile);
    support::LinkPair pair(boardOf(profile.constData()));
    pair.connect();
    QVERIFY(pair.runUntilIdentified());
    QVERIFY(pair.requests.size() > 50);
    for (const Bytes &frame : pair.requests)
        QVERIFY(isRead(frame));
    QVERIFY(pair.identified->identity.knownFirmware);
    QVERIFY(!pair.drive->armed());
    for (std::size_t i = 1; i < pair.requests.size(); ++i) // the first asks who is there at all
        QVERIFY(pair.requests[i][0] >> 5 != 0);
}

void TestFcpDrive::theDialectIsFoundOut_data()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<QByteArray>("protocol");
    QTest::addColumn<QByteArray>("version");
    QTest::newRow("firmware 5.4.3")
        << QByteArray("legacy") << QByteArray("MCP legacy") << QByteArray("5.4.3");
    QTest::newRow("integers") << QByteArray("legacy-text") << QByteArray("MCP legacy")
                              << QByteArray("5.4.3");
    QTest::newRow("powerpc") << QByteArray("powerpc") << QByteArray("MCP PowerPC")
                             << QByteArray("1.0.0");
}

void TestFcpDrive::theDialectIsFoundOut()
{
    QFETCH(QByteArray, profile);
    QFETCH(QByteArray, protocol);
    QFETCH(QByteArray, version);
    support::FcpBench bench(profile.constData());
    QVERIFY(bench.ready);
    QCOMPARE(QByteArray::fromStdString(bench.identified->identity.protocol), protocol);
    QCOMPARE(QByteArray::fromStdString(bench.identified->identity.version), version);
    QCOMPARE(bench.identified->identity.motors, 1);
    QVERIFY(!bench.identified->identity.evidence.empty());
    QVERIFY(!bench.capability(Feature::Stream)->available);
    QVERIFY(!bench.capability(Feature::Stream)->reason.empty());
}

void TestFcpDrive::theWrongDialectIsReadOnly_data()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<bool>("choosePowerPc");
    QTest::newRow("an STM32 board") << QByteArray("legacy") << true;
    QTest::newRow("a PowerPC board") << QByteArray("powerpc") << false;
}

void TestFcpDrive::theWrongDialectIsReadOnly()
{
    QFETCH(QByteArray, profile);
    QFETCH(bool, choosePowerPc);
    support::LinkPair pair(boardOf(profile.constData()));
    pair.drive =
        makeFcpDrive({.baud = 115200}, choosePowerPc ? fcp::Dialect::PowerPc : fcp::Dialect::Stm32);
    pair.connect();
    QVERIFY(pair.runUntilIdentified());
    QVERIFY(!pair.identified->identity.knownFirmware);
    pair.drive->arm();
    QVERIFY(!pair.drive->armed());
    for (const Capability &one : pair.identified->capabilities)
        QVERIFY(one.available ? one.feature == Feature::Stop : !one.reason.empty());
    for (const Bytes &frame : pair.requests)
        QVERIFY(isRead(frame));
}

void TestFcpDrive::namesAreThoseOfTheForms()
{
    QFETCH(QByteArray, profile);
    support::FcpBench bench(profile.constData());
    QVERIFY(bench.ready);
    for (const char *name : {"SPEED_KP", "SPEED_KI", "I_Q_KP", "I_Q_KI", "I_D_KP", "I_D_KI",
             "STATUS", "FAULTS_FLAGS", "CONTROL_MODE", "SPEED_REF", "SPEED_MEAS", "I_Q_REF",
             "I_Q_MEAS", "BUS_VOLTAGE", "TORQUE_KP", "FLUX_MEAS", "REVUP_DATA"})
        QVERIFY2(bench.identified->catalog->find(name) != nullptr, name);
    // What only a DAC can show is none that could be read.
    QVERIFY(bench.identified->catalog->find("I_ALPHA") == nullptr);
    QVERIFY(bench.identified->catalog->find("TARGET_MOTOR") == nullptr);
    const WishId wish = bench.submit(Read{{bench.id("CONTROL_MODE"), bench.id("SPEED_KP")}});
    QVERIFY(bench.runUntilEnded(wish));
    const Value speed(std::int64_t{3});
    QCOMPARE(bench.values.at(bench.id("CONTROL_MODE")).value, speed);
    // Who wants the digits of the wire gets those of this protocol.
    const auto *mode = bench.identified->catalog->find("CONTROL_MODE");
    QCOMPARE(catalog::onWire(*mode, speed), Value(std::int64_t{1}));
    QCOMPARE(catalog::fromWire(*mode, std::int64_t{0}), std::optional(Value(std::int64_t{4})));
    QVERIFY(!catalog::fromWire(*mode, speed));
    QVERIFY(std::get<std::int64_t>(bench.values.at(bench.id("SPEED_KP")).value) > 0);
    const auto *divisor = bench.identified->catalog->find("SPEED_KP_DIV");
    QCOMPARE(divisor != nullptr, profile != "powerpc");
    if (divisor != nullptr) { // the divisor itself on the wire, its exponent under this name
        const auto exponent =
            std::get<std::int64_t>(bench.values.at(bench.id("SPEED_KP_DIV")).value);
        QVERIFY(exponent > 0 && exponent <= 15);
    }
}

void TestFcpDrive::aWriteIsReadBack()
{
    QFETCH(QByteArray, profile);
    support::FcpBench bench(profile.constData());
    QVERIFY(bench.drive->armed());
    bench.requests.clear();
    const WishId wish = bench.submit(Write{{{bench.id("SPEED_KP"), std::int64_t{1500}}}});
    QVERIFY(bench.runUntilEnded(wish));
    const Ended &ended = bench.ended.at(wish).front();
    QCOMPARE(ended.outcome, Outcome::Ok);
    QCOMPARE(ended.writes.size(), std::size_t{1});
    QVERIFY(ended.writes[0].before.has_value());
    QCOMPARE(ended.writes[0].verified, std::optional<bool>(true));
    QVERIFY(std::count(bench.requests.begin(), bench.requests.end(),
                (Bytes{0x21, 0x03, 0x05, 0xDC, 0x05, 0x0B}))
        == 1); // motor 1, full width
}

void TestFcpDrive::aWriteNeedsArming()
{
    support::LinkPair pair(boardOf("legacy"));
    pair.connect();
    QVERIFY(pair.runUntilIdentified());
    const WishId wish = pair.submit(Write{{{pair.id("SPEED_KP"), std::int64_t{1500}}}});
    QVERIFY(pair.runUntilEnded(wish));
    QCOMPARE(pair.outcome(wish), Outcome::NotSent);
    for (const Bytes &frame : pair.requests)
        QVERIFY(isRead(frame));
}

void TestFcpDrive::aRefusedWriteIsRefused()
{
    support::FcpBench bench("legacy");
    for (const auto &[name, value] : {std::pair{"SPEED_MEAS", 5}, std::pair{"SPEED_KP", 40000},
             std::pair{"CONTROL_MODE", 1}, std::pair{"I_Q_REF", 100}}) {
        const WishId wish = bench.submit(Write{{{bench.id(name), std::int64_t{value}}}});
        QVERIFY(bench.runUntilEnded(wish));
        QVERIFY2(bench.outcome(wish) == Outcome::Refused, name);
        QVERIFY2(!bench.ended.at(wish).front().reason.empty(), name);
    }
    for (const Bytes &frame : bench.requests)
        QVERIFY(isRead(frame));
}

void TestFcpDrive::stagesOfTheRevUpAreOneRegister()
{
    support::FcpBench bench("legacy");
    bench.expert();
    const RegisterId id = bench.id("REVUP_DATA");
    WishId wish = bench.submit(Read{{id}});
    QVERIFY(bench.runUntilEnded(wish));
    Bytes raw = std::get<Bytes>(bench.values.at(id).value);
    QCOMPARE(raw.size(), std::size_t{40});
    raw[6] = static_cast<std::uint8_t>(raw[6] ^ 0x04); // its time
    wish = bench.submit(Write{{{id, raw}}});
    QVERIFY(bench.runUntilEnded(wish));
    QCOMPARE(bench.outcome(wish), Outcome::Ok);
    QCOMPARE(bench.ended.at(wish).front().writes[0].verified, std::optional<bool>(true));
    for (const Bytes &frame : bench.requests)
        if ((frame[0] & 0x1F) == 0x09)
            QVERIFY(frame[2] < 5);
    raw[0] = 0xFF;
    raw[1] = 0xFF; // 65535 rpm and more: beyond the user's limit
    wish = bench.submit(Write{{{id, raw}}});
    QVERIFY(bench.runUntilEnded(wish));
    QCOMPARE(bench.outcome(wish), Outcome::Refused);
}

/// It keeps whole steps of 0.1 Hz, 6 rpm, cut towards zero.
void TestFcpDrive::speedsThatTheBoardRoundsAreWrittenAllTheSame()
{
    support::FcpBench bench("legacy");
    bench.expert();
    const RegisterId speed = bench.id("RAMP_FINAL_SPEED"), revUp = bench.id("REVUP_DATA");
    Bytes stages;
    for (const std::int32_t rpm : {200, 400, 600, 800, 1000}) {
        const Bytes stage = ByteWriter().s32(rpm).s16(300).u16(200).take();
        stages.insert(stages.end(), stage.begin(), stage.end());
    }
    const WishId wish = bench.submit(Write{{{speed, std::int64_t{1000}}, {revUp, stages}}});
    QVERIFY(bench.runUntilEnded(wish));
    const Ended &ended = bench.ended.at(wish).front();
    QVERIFY2(ended.outcome == Outcome::Ok, ended.reason.c_str());
    QVERIFY(ended.writes[0].readBack == Value(std::int64_t{996}));
    QCOMPARE(ended.writes[0].verified, std::optional<bool>(true));
    QVERIFY(ended.writes[1].readBack != Value(stages));
    QCOMPARE(ended.writes[1].verified, std::optional<bool>(true));

    // The same where the answer is lost: what is read back decides.
    const auto sent = [&] {
        return std::count_if(bench.requests.begin(), bench.requests.end(), [](const Bytes &frame) {
            return frame.size() > 2 && frame[0] == 0x21 && frame[2] == 0x5B;
        });
    };
    QCOMPARE(sent(), 1);
    const WishId lost = bench.submit(Write{{{speed, std::int64_t{-1999}}}});
    QVERIFY(bench.runUntil([&] { return sent() == 2; }, 1s));
    bench.toDrive.cut = true;
    bench.runFor(300ms);
    bench.toDrive.cut = false;
    QVERIFY(bench.runUntilEnded(lost));
    QVERIFY(bench.ended.at(lost).front().writes[0].readBack == Value(std::int64_t{-1998}));
    QCOMPARE(bench.outcome(lost), Outcome::Ok);
    QCOMPARE(sent(), 2);
}

void TestFcpDrive::withoutARevUpItsStagesAreNeverSent()
{
    simulation::BoardOptions options = boardOf("legacy");
    options.motor = "servo24"; // with an encoder
    support::LinkPair pair(options);
    pair.connect();
    QVERIFY(pair.runUntilIdentified());
    QVERIFY(pair.identified->catalog->find("REVUP_DATA") == nullptr);
    pair.drive->arm();
    const WishId wish = pair.submit(Write{{{0x801, Bytes(40, 0)}}});
    QVERIFY(pair.runUntilEnded(wish));
    QCOMPARE(pair.outcome(wish), Outcome::Refused);
    for (const Bytes &frame : pair.requests)
        QVERIFY((frame[0] & 0x1F) != 0x08 && (frame[0] & 0x1F) != 0x09);
}

void TestFcpDrive::withoutKnownLimitsNothingMoves()
{
    QFETCH(QByteArray, profile);
    support::FcpBench bench(profile.constData());
    for (const auto &wished : {Wish{0, Command{MotorAction::Start, 1}}}) {
        const WishId wish = bench.submit(std::get<Command>(wished.what));
        QVERIFY(bench.runUntilEnded(wish));
        QCOMPARE(bench.outcome(wish), Outcome::Refused);
    }
    const WishId ramp = bench.submit(SpeedRamp{1, 500, 100ms});
    QVERIFY(bench.runUntilEnded(ramp));
    // The text of the PowerPC dialect has a register for the greatest speed.
    QCOMPARE(bench.outcome(ramp), profile == "powerpc" ? Outcome::Ok : Outcome::Refused);
    QCOMPARE(bench.status.at(1).state, MotorState::Idle);
}

void TestFcpDrive::theMotorStartsRampsAndStops()
{
    QFETCH(QByteArray, profile);
    support::FcpBench bench(profile.constData());
    QVERIFY(bench.start());
    const WishId ramp = bench.submit(SpeedRamp{1, 1998, 500ms});
    QVERIFY(bench.runUntilEnded(ramp));
    QCOMPARE(bench.outcome(ramp), Outcome::Ok);
    QVERIFY(bench.runUntil(
        [&] { return std::abs(bench.status.at(1).speedRpm.value_or(0.0) - 1998.0) < 60.0; }, 5s));
    bench.drive->stop(bench.now);
    QVERIFY(!bench.drive->armed());
    QVERIFY(bench.runUntil(
        [&] { return !bench.stops.empty() && bench.stops.back().word == StopWord::MayCoast; }, 5s));
    QCOMPARE(bench.status.at(1).state, MotorState::Idle);
    std::vector<StopWord> words;
    for (const StopProgress &stop : bench.stops)
        words.push_back(stop.word);
    const std::vector<StopWord> wanted{
        StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, StopWord::MayCoast};
    const bool alarmed = std::count(words.begin(), words.end(), StopWord::NotConfirmed) > 0;
    std::erase(words, StopWord::NotConfirmed);
    QCOMPARE(words, wanted);
    QVERIFY(!alarmed);
}

void TestFcpDrive::beyondAPersonsLimitNothingIsSent()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.start());
    bench.requests.clear();
    for (const int rpm : {3001, -3001, 200000}) {
        const WishId wish = bench.submit(SpeedRamp{1, rpm, 100ms});
        QVERIFY(bench.runUntilEnded(wish));
        QCOMPARE(bench.outcome(wish), Outcome::Refused);
    }
    for (const Bytes &frame : bench.requests)
        QVERIFY(isRead(frame));
}

/// The ramp has 32 bits of rpm on the wire, and the board keeps 16 bits of 0.1 Hz.
void TestFcpDrive::aSpeedOf16BitsOfStepsIsSent()
{
    support::FcpBench bench("legacy");
    bench.judge.line().maxRpm = 0.0; // which this board does not tell
    QCOMPARE(bench.identified->limits.front().wireRpm, 196602.0);
    bench.submit(ExpertMode{1});
    const WishId wish = bench.submit(SpeedRamp{1, -40000, 100ms});
    QVERIFY(bench.runUntilEnded(wish));
    QVERIFY2(bench.outcome(wish) == Outcome::Ok, bench.ended.at(wish).front().reason.c_str());
    const Bytes frame = fcp::encodeRequest({1, fcp::SetRamp{-40000, 100}}).value();
    QCOMPARE(std::count(bench.requests.begin(), bench.requests.end(), frame), 1);
    const WishId read = bench.submit(Read{{bench.id("RAMP_FINAL_SPEED")}});
    QVERIFY(bench.runUntilEnded(read));
    const Value &kept = bench.values.at(bench.id("RAMP_FINAL_SPEED")).value;
    QVERIFY(std::get<std::int64_t>(kept) < 0); // not the other way
    bench.requests.clear();
    const WishId beyond = bench.submit(SpeedRamp{1, 196608, 100ms});
    QVERIFY(bench.runUntilEnded(beyond));
    QCOMPARE(bench.outcome(beyond), Outcome::Refused);
    for (const Bytes &other : bench.requests)
        QVERIFY(isRead(other));
}

void TestFcpDrive::ofTwoMotorsOnlyTheNamedOneMoves()
{
    support::FcpBench bench("legacy", 2);
    QCOMPARE(bench.identified->identity.motors, 2);
    bench.expert(2);
    const WishId wish = bench.submit(Command{MotorAction::Start, 2});
    QVERIFY(bench.runUntilEnded(wish));
    QCOMPARE(bench.outcome(wish), Outcome::Ok);
    QVERIFY(bench.runUntil([&] { return bench.status.at(2).state == MotorState::Running; }, 10s));
    QCOMPARE(bench.status.at(1).state, MotorState::Idle);
    for (const Bytes &frame : bench.requests)
        if (!isRead(frame))
            QCOMPARE(int(frame[0] >> 5), 2);
}

void TestFcpDrive::afterAStopNothingButStopsAndReads()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.start());
    const WishId waiting = bench.submit(Write{
        {{bench.id("SPEED_KP"), std::int64_t{1500}}, {bench.id("SPEED_KI"), std::int64_t{1500}}}});
    bench.requests.clear();
    bench.drive->stop(bench.now);
    bench.exchange();
    const WishId late = bench.submit(SpeedRamp{1, 500, 100ms});
    bench.runFor(2s);
    QVERIFY(bench.ended.contains(waiting) && bench.ended.at(waiting).size() == 1);
    QCOMPARE(bench.outcome(late), Outcome::NotSent);
    int stops = 0;
    for (const Bytes &frame : bench.requests) {
        stops += frame == Bytes{0x23, 0x01, 0x02, 0x26} ? 1 : 0;
        QVERIFY(isRead(frame) || frame == (Bytes{0x23, 0x01, 0x02, 0x26}));
    }
    QVERIFY(stops >= 1);
}

void TestFcpDrive::aStopWithoutALinkIsSentBlind()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.start());
    bench.toDrive.cut = true; // the board hears, and is not heard
    bench.requests.clear();
    bench.drive->stop(bench.now);
    bench.runFor(1s);
    const Bytes stop{0x23, 0x01, 0x02, 0x26};
    QVERIFY(std::count(bench.requests.begin(), bench.requests.end(), stop) >= 5);
    QCOMPARE(bench.stops.back().word, StopWord::NotConfirmed);
    bench.toDrive.cut = false;
    QVERIFY(bench.runUntil([&] { return bench.stops.back().word == StopWord::MayCoast; }, 20s));
}

void TestFcpDrive::aMotorThatBecomesKnownWhileStoppingIsStopped()
{
    QFETCH(QByteArray, profile);
    support::FcpBench bench(profile.constData(), 2);
    QVERIFY(bench.ready && bench.identified->identity.motors == 2);
    bench.submit(UserLimits{3000.0, 0.0});
    for (const int motor : {1, 2}) {
        bench.submit(ExpertMode{motor});
        bench.submit(Command{MotorAction::Start, motor});
    }
    const auto runs = [&](int motor) { return bench.status[motor].state == MotorState::Running; };
    QVERIFY(bench.runUntil([&] { return runs(1) && runs(2); }, 10s));
    bench.replaceDrive(makeFcpDrive({.baud = bench.baud}));
    bench.stops.clear();
    bench.requests.clear();
    bench.connect();
    bench.drive->stop(bench.now);
    bench.exchange();
    QVERIFY(bench.runUntil([&] { return !bench.drive->stopOpen(); }, 3s));
    for (const int motor : {1, 2})
        QVERIFY(std::any_of(bench.stops.begin(), bench.stops.end(), [&](const StopProgress &stop) {
            return stop.motor == motor && stop.word == StopWord::DriveIdle;
        }));
    // The second motor did not wait for the registers: there are far more than 50 of them.
    const Bytes second = fcp::encodeRequest({2, fcp::Execute{2}}).value();
    const auto at = std::find(bench.requests.begin(), bench.requests.end(), second);
    QVERIFY(at != bench.requests.end() && at - bench.requests.begin() < 12);
}

void TestFcpDrive::aLostLinkIsToldWhileAPersonKeepsPressing()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.start());
    bench.toDrive.cut = true;
    const TimePoint asked = bench.now;
    std::optional<TimePoint> suspect, lost;
    bench.onEvent = [&](const Event &event) {
        const auto *change = std::get_if<LinkChanged>(&event);
        if (change != nullptr && change->state == LinkState::Suspect && !suspect)
            suspect = bench.now;
        if (change != nullptr && change->state == LinkState::Lost && !lost)
            lost = bench.now;
    };
    bench.requests.clear();
    for (int press = 0; press < 20; ++press) {
        bench.drive->stop(bench.now);
        bench.exchange();
        bench.runFor(400ms);
    }
    QVERIFY(suspect && *suspect - asked <= 600ms);
    QVERIFY(lost && *lost - asked <= 7s);
    const Bytes stop{0x23, 0x01, 0x02, 0x26};
    QVERIFY(std::count(bench.requests.begin(), bench.requests.end(), stop) >= 60); // all the time
    QCOMPARE(std::count_if(bench.stops.begin(), bench.stops.end(),
                 [](const StopProgress &one) { return one.word == StopWord::NotConfirmed; }),
        1);
    bench.toDrive.cut = false;
    QVERIFY(bench.runUntil([&] { return !bench.drive->stopOpen(); }, 20s));
}

/// The round of questions that an outage interrupts takes long; the one behind it comes in time all the same.
void TestFcpDrive::anOutagePutsNoLookAtTheMotorsOff()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.ready);
    for (const Duration phase : {0ms, 30ms, 70ms}) {
        bench.runFor(phase);
        bench.toDrive.cut = true;
        bench.runFor(1200ms);
        bench.toDrive.cut = false;
        QVERIFY(bench.runUntil([&] { return bench.link == LinkState::Connected; }, 10s));
        TimePoint looked = bench.now;
        Duration longest{};
        bench.onEvent = [&](const Event &event) {
            if (!std::holds_alternative<MotorStatus>(event))
                return;
            longest = std::max(longest, bench.now - looked);
            looked = bench.now;
        };
        bench.runFor(3s);
        QVERIFY2(longest <= 300ms, qPrintable(QString::number(longest / 1ms)));
        TimePoint told = bench.now;
        bench.onEvent = [&](const Event &event) {
            const auto *change = std::get_if<LinkChanged>(&event);
            if (change != nullptr && change->state == LinkState::Suspect)
                told = bench.now;
        };
        bench.toDrive.cut = true;
        const TimePoint silent = bench.now;
        bench.runFor(700ms);
        QVERIFY2(told - silent <= 500ms, qPrintable(QString::number((told - silent) / 1ms)));
        bench.toDrive.cut = false;
        bench.onEvent = nullptr;
        QVERIFY(bench.runUntil([&] { return bench.link == LinkState::Connected; }, 10s));
    }
}

/// A look at the motors that an outage has cut in two is none: the board was reset meanwhile.
void TestFcpDrive::aStatusIsOfOneTime()
{
    for (Duration phase = 0ms; phase < 120ms; phase += 1ms) {
        support::FcpBench bench("legacy", 2);
        QVERIFY(bench.ready);
        bench.board->setFaults(2);
        bench.runFor(200ms);
        bench.board->setFaults(0);
        bench.runFor(300ms);
        for (const int motor : {1, 2})
            QVERIFY(bench.status[motor].state == MotorState::FaultOver
                && !bench.status[motor].faultsPast.empty());
        bench.runFor(phase);
        bench.toDrive.cut = bench.toBoard.cut = true;
        bench.board->reset();
        bench.runFor(900ms);
        bench.toDrive.cut = bench.toBoard.cut = false;
        int told = 0, untrue = 0;
        bench.onEvent = [&](const Event &event) {
            if (const auto *status = std::get_if<MotorStatus>(&event)) {
                ++told;
                untrue += status->state != MotorState::Idle || !status->faultsPast.empty();
            }
        };
        QVERIFY(bench.runUntil([&] { return told >= 4; }, 10s));
        QVERIFY2(untrue == 0, qPrintable(QString::number(phase / 1ms)));
    }
}

void TestFcpDrive::aRestartedBoardIsMetAnewAndReadOnly()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.drive->armed());
    bench.identified.reset();
    bench.board->inject(support::startNotice({0xD1B, "5.4.3", 9, 10, 0}));
    bench.runFor(20ms);
    QVERIFY(!bench.drive->armed());
    QVERIFY(bench.runUntilIdentified());
    QCOMPARE(bench.link, LinkState::Connected);
    QCOMPARE(bench.reason, LinkReason::BoardReset);
}

void TestFcpDrive::aLostBoardIsFoundAgain()
{
    support::FcpBench bench("legacy");
    bench.toBoard.cut = true;
    QVERIFY(bench.runUntil([&] { return bench.link == LinkState::Lost; }, 10s));
    QVERIFY(!bench.drive->armed());
    bench.identified.reset();
    bench.toBoard.cut = false;
    QVERIFY(bench.runUntilIdentified(20s));
    QCOMPARE(bench.link, LinkState::Connected);
    QVERIFY(!bench.drive->armed());
}

void TestFcpDrive::watchingFillsTheLine()
{
    // 4 bytes out and 7 back: 1047 exchanges a second is what 115200 baud allow.
    support::FcpBench bench("legacy");
    const RegisterId speed = bench.id("SPEED_MEAS");
    int values = 0;
    bench.onEvent = [&](const Event &event) {
        if (const auto *read = std::get_if<RegistersRead>(&event))
            for (const Reading &reading : read->readings) {
                ++values;
                QVERIFY(reading.spread > 0s && reading.spread < 5ms);
            }
    };
    Watch watch;
    watch.drawn = watch.registers = {speed};
    bench.submit(watch);
    bench.runFor(100ms);
    const std::size_t before = bench.requests.size();
    values = 0;
    bench.runFor(2s);
    const double possible = 2.0 / toSeconds(wireTime(11, 115200));
    const auto exchanges = static_cast<double>(bench.requests.size() - before);
    QVERIFY2(exchanges >= 0.8 * possible, std::to_string(exchanges / possible).c_str());
    QVERIFY2(values >= 0.75 * possible, std::to_string(values / possible).c_str());
}

void TestFcpDrive::watchedRegistersGetFairShares()
{
    support::FcpBench bench("legacy");
    std::map<RegisterId, int> count;
    bench.onEvent = [&](const Event &event) {
        if (const auto *read = std::get_if<RegistersRead>(&event))
            for (const Reading &reading : read->readings)
                ++count[reading.id];
    };
    Watch watch;
    watch.drawn = {bench.id("SPEED_MEAS"), bench.id("I_Q_MEAS")};
    watch.registers = {bench.id("SPEED_MEAS"), bench.id("BUS_VOLTAGE"), bench.id("HEATS_TEMP")};
    bench.submit(watch);
    bench.runFor(2s);
    const int speed = count[bench.id("SPEED_MEAS")], current = count[bench.id("I_Q_MEAS")];
    QVERIFY(speed > 500 && std::abs(speed - current) <= 2);
    for (const char *name : {"BUS_VOLTAGE", "HEATS_TEMP"}) { // every 100 ms
        QVERIFY(count[bench.id(name)] >= 18);
        QVERIFY(count[bench.id(name)] <= 22);
    }
}

void TestFcpDrive::autoFindsEachKind_data()
{
    QTest::addColumn<QByteArray>("profile");
    QTest::addColumn<QByteArray>("protocol");
    QTest::newRow("mcp") << QByteArray("mcsdk-6.4") << QByteArray("MCP over ASPEP");
    QTest::newRow("legacy") << QByteArray("legacy") << QByteArray("MCP legacy");
    QTest::newRow("legacy-text") << QByteArray("legacy-text") << QByteArray("MCP legacy");
    QTest::newRow("powerpc") << QByteArray("powerpc") << QByteArray("MCP PowerPC");
}

void TestFcpDrive::autoFindsEachKind()
{
    QFETCH(QByteArray, profile);
    QFETCH(QByteArray, protocol);
    support::LinkPair pair(boardOf(profile.constData()));
    pair.drive = makeDrive({Protocol::Auto, 115200, {}});
    pair.connect();
    const TimePoint begun = pair.now;
    QVERIFY(pair.runUntilIdentified(15s));
    QVERIFY2(pair.now - begun < 2500ms, std::to_string(toSeconds(pair.now - begun)).c_str());
    std::vector<LinkReason> asked; // what is tried is told
    for (const Event &event : pair.events)
        if (const auto *link = std::get_if<LinkChanged>(&event))
            if (link->state == LinkState::Connecting)
                asked.push_back(link->reason);
    const bool newer = protocol.startsWith("MCP over");
    QCOMPARE(asked.size(), std::size_t(newer ? 1 : 2));
    QCOMPARE(asked.front(), LinkReason::AskingNewer);
    QCOMPARE(asked.back(), newer ? LinkReason::AskingNewer : LinkReason::AskingOlder);
    const std::string &said = pair.identified->identity.protocol;
    QVERIFY2(said.starts_with(protocol.toStdString()), said.c_str());
    QVERIFY(pair.identified->identity.evidence.starts_with("it "));
    QCOMPARE(pair.link, LinkState::Connected);
    QVERIFY(pair.identified->identity.knownFirmware);
}

void TestFcpDrive::autoSendsNothingThatActs()
{
    // All that goes out before the board is known, taken for frames of the older protocol.
    for (const char *profile : {"legacy", "powerpc"}) {
        support::LinkPair pair(boardOf(profile));
        pair.drive = makeDrive({Protocol::Auto, 115200, {}});
        fcp::Framer framer(fcp::Framer::Side::Board);
        int frames = 0;
        pair.loses = [&](const Bytes &bytes) {
            fcp::Frame frame;
            for (ByteView rest(bytes); !rest.empty();)
                if (framer.next(rest, frame) == fcp::Framer::Step::Frame) {
                    ++frames;
                    const unsigned motor = frame.header >> 5;
                    if (motor > 2) // no board has it
                        continue;
                    const Bytes header{frame.header};
                    if (!isRead(header))
                        qFatal("a frame that acts");
                }
            return false;
        };
        pair.connect();
        QVERIFY(pair.runUntilIdentified(15s));
        QVERIFY(frames > 50);
    }
}

void TestFcpDrive::aStopWhileAutoStillLooksStopsWhatItFinds()
{
    support::FcpBench bench("legacy");
    QVERIFY(bench.ready && bench.start());
    bench.drive = makeDrive({Protocol::Auto, 115200, {}});
    bench.stops.clear();
    bench.connect();
    bench.runFor(50ms); // the first language has had no answer yet
    bench.drive->stop(bench.now);
    QVERIFY(bench.runUntil(
        [&] { return !bench.stops.empty() && bench.stops.back().word == StopWord::MayCoast; },
        20s));
    QCOMPARE(std::count_if(bench.stops.begin(), bench.stops.end(),
                 [](const StopProgress &stop) { return stop.word == StopWord::Requested; }),
        1);
}

QTEST_APPLESS_MAIN(TestFcpDrive)
#include "tst_legacy_drive.moc"
