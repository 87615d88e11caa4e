// The drive of MCB against the simulated drive with its motor: identification, registers, commands, set-points,
// streams, the stop, and what happens when wire and slave are not as they should be. Virtual time.
#include "support/mcb/pair.h"

#include "capture/capture.h"
#include "drive/start_target.h"
#include "drive/values.h"

#include <QtTest>

#include <bit>
#include <cmath>

using namespace drive;
using namespace std::chrono_literals;
using support::McbPair;

class TestMcbDrive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itIsIdentifiedByReadingAlone();
    void theCatalogueIsAsTheDriveTells();
    void textsAreReadInEitherOrder();
    void nothingIsWrittenUnarmed();
    void aWriteIsReadBack();
    void aWriteBeyondTheLimitIsRefused();
    void theMappingIsNotWrittenByHand();
    void aRegisterThatChangedItsTypeIsNotWritten();
    void theMotorStartsRampsAndStops();
    void aStartWithASetPointBeyondTheLimitIsRefused();
    void aStartGoesToTheSetPointThatWasWritten();
    void aRampGoesAtTheSpeedThatWasAsked();
    void currentsAndPositionsAreFollowed();
    void aRampOfCurrentsIsNotThere();
    void aFaultIsToldAndAcknowledged();
    void aStopGoesBeforeEverything();
    void aStopIsConfirmedByWhatIsRead();
    void aStopTakesThePowerOffAQuickStop();
    void aStopThatIsNotObeyedIsAlarmed();
    void aDriveThatIsNotReadyIsStoppedBlind();
    void aDriveThatAnswersNobodyIsStoppedBlind();
    void aStopDoesNotWaitForALengthThatNobodyConfirms();
    void aStopDoesNotWaitForASlowStream_data();
    void aStopDoesNotWaitForASlowStream();
    void aStopGoesBeforeTheIdentification();
    void aStopLeavesWhatWasStreamed_data();
    void aStopLeavesWhatWasStreamed();
    void samplesCarryTheirNameAndTime();
    void sixtySecondsWithoutALostFrame();
    void aDamagedFrameIsAGap();
    void aProgramThatStandsStillLeavesAGap_data();
    void aProgramThatStandsStillLeavesAGap();
    void aStreamTakesAsManyBytesAsItsLimitsSay();
    void registersAreReadWhileItStreams();
    void theWatchedRegistersMayChangeWhileOneIsAsked();
    void aResetWhileItStreamsIsToldAndTakenUp();
    void aDriveThatCyclesIsMet();
    void aDeadLineIsTold();
    void aStuckReadyLineIsTold();
    void disconnectingLeavesTheConfigState();
};

namespace {

std::vector<double> samplesOf(const McbPair &pair, std::size_t signal)
{
    std::vector<double> samples;
    for (const auto &block : pair.blocks)
        for (const auto &group : block.slow) {
            const std::int32_t stored = group.values[signal];
            const auto &what = pair.layout->slow[signal];
            samples.push_back(
                ((what.real ? double{std::bit_cast<float>(stored)} : double(stored)) + what.offset)
                * what.factor);
        }
    return samples;
}

Stream streamOf(std::vector<RegisterId> ids, unsigned every = 1)
{
    Stream stream;
    stream.fast = std::move(ids);
    stream.fastEvery = every;
    return stream;
}

void arm(McbPair &pair)
{
    pair.drive->arm();
    pair.exchange();
}

bool start(McbPair &pair)
{
    arm(pair);
    return pair.ask(Command{}).outcome == Outcome::Ok && pair.runUntilState(MotorState::Running);
}

} // namespace

void TestMcbDrive::itIsIdentifiedByReadingAlone()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(pair.link == LinkState::Connected);
    QVERIFY(pair.writes.empty());
    QCOMPARE(pair.identified->identity.version, std::string("1.12.0"));
    QVERIFY(pair.identified->identity.knownFirmware);
    QCOMPARE(pair.identified->limits.front().maxSpeedRpm > 1000.0, true);
    QVERIFY(pair.identified->limits.front().nominalCurrentAmps > 1.0);
    QCOMPARE(pair.identified->limits.front().polePairs, 5.0);
    QVERIFY(pair.status->state == MotorState::Idle);
    QCOMPARE(pair.status->stateName, std::string("SWITCH_ON_DISABLED"));
    QVERIFY(!pair.drive->armed());
}

void TestMcbDrive::theCatalogueIsAsTheDriveTells()
{
    simulation::McbBoardOptions options;
    options.servo.newer = true;
    McbPair older, newer(options);
    QVERIFY(older.meet() && newer.meet());
    const auto *before = older.identified->catalog->find("FBK_VOL_A_VALUE");
    const auto *after = newer.identified->catalog->find("FBK_VOL_A_VALUE");
    QVERIFY(before && after);
    QVERIFY(before->type == catalog::ValueType::U32);
    QVERIFY(after->type == catalog::ValueType::F32);
    QVERIFY(before->streaming == catalog::Streaming::Polled);
    QVERIFY(after->streaming == catalog::Streaming::Fast);
    const auto *speed = older.identified->catalog->find("SPEED_MEAS");
    QVERIFY(speed);
    QCOMPARE(speed->name, std::string("CL_VEL_FBK_VALUE"));
    QCOMPARE(older.identified->catalog->readScale(older.id("SPEED_MEAS")).unit, std::string("rpm"));
    QVERIFY(older.identified->catalog->find("NO_SUCH") == nullptr);
}

void TestMcbDrive::textsAreReadInEitherOrder()
{
    simulation::McbBoardOptions options;
    options.servo.order = mcb::TextOrder::LowByteFirst;
    McbPair pair(options);
    QVERIFY(pair.meet());
    QCOMPARE(pair.identified->identity.version, std::string("1.12.0"));
}

void TestMcbDrive::nothingIsWrittenUnarmed()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(pair.ask(Command{}).outcome == Outcome::NotSent);
    QVERIFY(pair.ask(SpeedRamp{1, 100, 100ms}).outcome == Outcome::NotSent);
    QVERIFY(pair.ask(Write{{{pair.id("CL_VEL_PID_KP"), 0.1}}}).outcome == Outcome::NotSent);
    QVERIFY(pair.writes.empty());
}

void TestMcbDrive::aWriteIsReadBack()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    const RegisterId gain = pair.id("CL_VEL_PID_KP");
    const Ended done = pair.ask(Write{{{gain, 0.25}}});
    QVERIFY(done.outcome == Outcome::Ok);
    QCOMPARE(done.writes.size(), std::size_t{1});
    QVERIFY(done.writes.front().verified == true);
    QVERIFY(done.writes.front().before.has_value());
    QVERIFY(std::get<double>(*done.writes.front().readBack) == 0.25);
    QCOMPARE(std::get<double>(pair.values.at(gain).value), 0.25);
    QCOMPARE(pair.writes.size(), std::size_t{1});
}

void TestMcbDrive::aWriteBeyondTheLimitIsRefused()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    const Ended done = pair.ask(Write{{{pair.id("CL_VEL_SET_POINT_VALUE"), 1e4}}});
    QVERIFY(done.outcome == Outcome::Refused);
    QVERIFY2(done.reason.find("beyond") != std::string::npos, done.reason.c_str());
    const Ended text = pair.ask(Write{{{pair.id("CL_VEL_PID_KP"), std::string("x")}}});
    QVERIFY(text.outcome == Outcome::Refused);
    const Ended status = pair.ask(Write{{{pair.id("DRV_STATE_STATUS"), std::int64_t{1}}}});
    QVERIFY(status.outcome == Outcome::Refused);
    QVERIFY(pair.writes.empty());
}

void TestMcbDrive::theMappingIsNotWrittenByHand()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    QVERIFY(pair.ask(Write{{{pair.id("COMMUNICATION_STATE_CONTROL"), std::int64_t{2}}}}).outcome
        == Outcome::Refused);
    QVERIFY(pair.writes.empty());
}

void TestMcbDrive::aRegisterThatChangedItsTypeIsNotWritten()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    const mcb::Info other{
        2, mcb::Type::UInt16, mcb::Cyclic::ConfigOnly, catalog::Access::ReadWrite};
    pair.toDrive = [&](Bytes &bytes) {
        auto frame = mcb::decodeAnswer(bytes);
        if (frame && frame->command == mcb::Command::Ack && frame->address == 0x50A) {
            frame->config = mcb::configOf(other);
            bytes = mcb::encodeFrame(*frame);
        }
    };
    const Ended done = pair.ask(Write{{{pair.id("CL_VEL_PID_KP"), 0.25}}});
    QVERIFY(done.outcome == Outcome::Refused);
    QVERIFY2(done.reason.find("another type") != std::string::npos, done.reason.c_str());
    QVERIFY(pair.writes.empty());
    QVERIFY(pair.runUntil([&] { return pair.identifications == 2; }, 5s));
    QVERIFY(pair.identified->catalog->find("CL_VEL_PID_KP")->type == catalog::ValueType::U16);
}

void TestMcbDrive::theMotorStartsRampsAndStops()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    QVERIFY(pair.ask(SpeedRamp{1, 1200, 500ms}).outcome == Outcome::Ok);
    pair.runFor(1500ms);
    QVERIFY2(std::abs(*pair.status->speedRpm - 1200.0) < 60.0,
        qPrintable(QString::number(*pair.status->speedRpm)));
    QVERIFY(pair.ask(Command{MotorAction::StopMotor, 1}).outcome == Outcome::Ok);
    QVERIFY(pair.runUntilState(MotorState::Idle));
    QVERIFY(pair.drive->armed());
    QVERIFY(!pair.motions.empty());
}

void TestMcbDrive::aStartWithASetPointBeyondTheLimitIsRefused()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    QVERIFY(pair.ask(Write{{{pair.id("CL_VEL_SET_POINT_VALUE"), 20.0}}}).outcome == Outcome::Ok);
    QVERIFY(pair.ask(UserLimits{600.0, 0.0}).outcome == Outcome::Ok);
    const std::size_t before = pair.writes.size();
    const Ended done = pair.ask(Command{});
    QVERIFY(done.outcome == Outcome::Refused);
    QVERIFY2(done.reason.find("your own limit") != std::string::npos, done.reason.c_str());
    QCOMPARE(pair.writes.size(), before);
}

/// And where nothing was written it goes nowhere: the reference that is shown says the same as the start.
void TestMcbDrive::aStartGoesToTheSetPointThatWasWritten()
{
    McbPair pair;
    QVERIFY(pair.meet());
    const auto target = [&] {
        std::vector<RegisterId> ids = startRegisters(*pair.identified->catalog, 1);
        ids.push_back(pair.id("SPEED_REF"));
        pair.ask(Read{ids});
        return startTarget(
            *pair.identified->catalog, pair.identified->limits[0], 1, [&](RegisterId id) {
                const auto at = pair.values.find(id);
                return at == pair.values.end() ? std::nullopt : std::optional(at->second.value);
            });
    };
    const auto reference = [&] {
        return 60.0 * asNumber(pair.values.at(pair.id("SPEED_REF")).value).value_or(-1.0); // rev/s
    };
    QCOMPARE(target().rpm, std::optional(0.0));
    QCOMPARE(reference(), 0.0);
    arm(pair);
    QVERIFY(pair.ask(Write{{{pair.id("CL_VEL_SET_POINT_VALUE"), 20.0}}}).outcome == Outcome::Ok);
    QCOMPARE(target().rpm, std::optional(1200.0));
    QVERIFY(start(pair));
    pair.runFor(2s);
    QCOMPARE(target().rpm, std::optional(1200.0));
    QVERIFY(std::abs(reference() - 1200.0) < 1.0);
}

void TestMcbDrive::aRampGoesAtTheSpeedThatWasAsked()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    QVERIFY(pair.ask(SpeedRamp{1, 2000, 2000ms}).outcome == Outcome::Ok);
    pair.runFor(1s);
    const double half = *pair.status->speedRpm;
    QVERIFY2(half > 700.0 && half < 1300.0, qPrintable(QString::number(half)));
    QVERIFY(pair.ask(Command{MotorAction::StopRamp, 1}).outcome == Outcome::Ok);
    pair.runFor(500ms);
    QVERIFY(*pair.status->speedRpm < 1500.0);
    QVERIFY(pair.ask(SpeedRamp{1, 100000, 100ms}).outcome == Outcome::Refused);
}

void TestMcbDrive::currentsAndPositionsAreFollowed()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    QVERIFY(pair.ask(PositionRamp{1, 6.0, 1000ms}).outcome == Outcome::Ok);
    pair.runFor(2s);
    QVERIFY(pair.ask(Read{{pair.id("CL_POS_FBK_VALUE")}}).outcome == Outcome::Ok);
    const auto counts = std::get<std::int64_t>(pair.values.at(pair.id("CL_POS_FBK_VALUE")).value);
    QVERIFY2(std::abs(double(counts) - 6.0 / 6.2831853 * 4000.0) < 80.0,
        qPrintable(QString::number(counts)));
    QVERIFY(pair.ask(CurrentReference{1, 1.0, 0.0}).outcome == Outcome::Ok);
    pair.runFor(30ms);
    QVERIFY(pair.ask(Read{{pair.id("I_Q_MEAS")}}).outcome == Outcome::Ok);
    QVERIFY(std::abs(std::get<double>(pair.values.at(pair.id("I_Q_MEAS")).value) - 1.0) < 0.3);
    QVERIFY(pair.ask(CurrentReference{1, 1000.0, 0.0}).outcome == Outcome::Refused);
    QVERIFY(pair.ask(PositionRamp{1, 6000.0, 10ms}).outcome == Outcome::Refused);
}

void TestMcbDrive::aRampOfCurrentsIsNotThere()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    const Ended done = pair.ask(TorqueRamp{1, 1.0, 100ms});
    QVERIFY(done.outcome == Outcome::Refused);
    for (const Capability &one : pair.identified->capabilities) {
        if (one.feature == Feature::TorqueRamp)
            QCOMPARE(one.reason, done.reason);
        else if (one.feature != Feature::CurrentScale) // the drive tells it
            QVERIFY2(one.available, one.reason.c_str());
    }
}

void TestMcbDrive::aFaultIsToldAndAcknowledged()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    pair.board->setFaults(0x02);
    QVERIFY(pair.runUntilState(MotorState::FaultOver));
    QCOMPARE(pair.status->faultsPast, std::vector<std::string>{"ERROR_0x00003210"});
    QVERIFY(pair.ask(Command{}).outcome == Outcome::Refused);
    pair.board->setFaults(0);
    pair.runFor(50ms);
    QVERIFY(pair.ask(Command{MotorAction::AcknowledgeFaults, 1}).outcome == Outcome::Ok);
    QVERIFY(pair.runUntilState(MotorState::Idle));
    QVERIFY(start(pair));
}

void TestMcbDrive::aStopGoesBeforeEverything()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    simulation::McbBoardOptions slow;
    const auto write = pair.submit(Write{{{pair.id("CL_VEL_PID_KP"), 0.5}}});
    const auto read = pair.submit(Read{{pair.id("I_Q_MEAS")}});
    pair.writes.clear();
    pair.drive->stop(pair.now);
    QVERIFY(!pair.drive->armed());
    pair.exchange();
    QVERIFY(!pair.writes.empty());
    QCOMPARE(pair.writes.front().address, std::uint16_t{0x010});
    QCOMPARE(pair.writes.front().config[0], std::uint16_t{0x06});
    pair.runFor(100ms);
    QCOMPARE(pair.ended.at(write).size(), std::size_t{1});
    QCOMPARE(pair.ended.at(read).size(), std::size_t{1});
}

void TestMcbDrive::aStopIsConfirmedByWhatIsRead()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    QVERIFY(pair.ask(SpeedRamp{1, 1500, 100ms}).outcome == Outcome::Ok);
    pair.runFor(500ms);
    const TimePoint asked = pair.now;
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntil([&] { return pair.stops.size() == 4; }, 10s));
    const StopWord words[] = {
        StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, StopWord::Standstill};
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(pair.stops[i].word == words[i]);
    QVERIFY(pair.stops[2].at - asked < 200ms);
    QVERIFY(std::abs(pair.board->servo().axis().plant.speed_radps()) < 2.0);
}

/// A drive may hold its motor in a quick stop for ever: shutdown, which stops it in all other states, is nothing there.
void TestMcbDrive::aStopTakesThePowerOffAQuickStop()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    pair.toBoard = [](Bytes &bytes) {
        auto frame = mcb::decodeFrame(bytes);
        if (frame && frame->command == mcb::Command::Write && frame->address == 0x010) {
            frame->config[0] = 0x02; // quick stop
            bytes = mcb::encodeFrame(*frame);
        }
    };
    pair.submit(Command{MotorAction::StopMotor, 1});
    QVERIFY(pair.runUntil([&] { return pair.status->stateName == "QUICK_STOP_ACTIVE"; }, 200ms));
    pair.toBoard = {};
    pair.writes.clear();
    pair.drive->stop(pair.now);
    pair.exchange();
    QVERIFY(!pair.writes.empty());
    QCOMPARE(pair.writes.front().address, std::uint16_t{0x010});
    QCOMPARE(pair.writes.front().config[0], std::uint16_t{0x00});
    const auto off = [&] {
        return pair.board->servo().state() == simulation::Servo::State::SwitchOnDisabled;
    };
    QVERIFY(pair.runUntil(off, 50ms)); // by itself it takes 400 ms
    QVERIFY(pair.runUntil([&] { return !pair.drive->stopOpen(); }, 5s));
}

void TestMcbDrive::aStopThatIsNotObeyedIsAlarmed()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    pair.toBoard = [](Bytes &bytes) {
        const auto frame = mcb::decodeFrame(bytes);
        if (frame && frame->command == mcb::Command::Write)
            bytes =
                mcb::encodeFrame({frame->address, mcb::Command::Idle, false, {}, frame->cyclic});
    };
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntil(
        [&] { return !pair.stops.empty() && pair.stops.back().word == StopWord::NotConfirmed; },
        2s));
    pair.toBoard = {};
    QVERIFY(pair.runUntil(
        [&] { return !pair.stops.empty() && pair.stops.back().word == StopWord::Standstill; }, 5s));
}

namespace {

bool stageIsOn(McbPair &pair)
{
    return pair.board->servo().state() == simulation::Servo::State::Enabled;
}

} // namespace

void TestMcbDrive::aDriveThatIsNotReadyIsStoppedBlind()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    pair.drive->handleReady(false, pair.now);
    QVERIFY(stageIsOn(pair));
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntil([&] { return !stageIsOn(pair); }, 250ms));
    QVERIFY(pair.drive->stopOpen()); // not told by the board
    pair.drive->handleReady(true, pair.now);
    pair.look = 100us;
    QVERIFY(pair.runUntil(
        [&] {
            pair.drive->handleReady(true, pair.now);
            return !pair.drive->stopOpen();
        },
        5s));
}

void TestMcbDrive::aDriveThatAnswersNobodyIsStoppedBlind()
{
    for (const bool cyclic : {false, true}) {
        McbPair pair;
        QVERIFY(pair.meet());
        QVERIFY(start(pair));
        if (cyclic)
            QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")})).outcome == Outcome::Ok);
        pair.toDrive = [](Bytes &bytes) { std::fill(bytes.begin(), bytes.end(), std::uint8_t{0}); };
        QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Lost; }, 5s));
        QVERIFY(stageIsOn(pair));
        pair.writes.clear();
        pair.drive->stop(pair.now);
        QVERIFY(pair.runUntil([&] { return !stageIsOn(pair); }, 200ms));
        QVERIFY(pair.drive->stopOpen());
        pair.runFor(3s);
        QVERIFY(pair.stops.back().word == StopWord::NotConfirmed);
        pair.toDrive = {};
        QVERIFY(pair.runUntil([&] { return !pair.drive->stopOpen(); }, 5s));
    }
}

void TestMcbDrive::aStopDoesNotWaitForALengthThatNobodyConfirms()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    bool switching = false;
    pair.toBoard = [&](Bytes &bytes) {
        const auto frame = mcb::decodeFrame(bytes);
        switching = switching
            || (frame && frame->command == mcb::Command::Write
                && frame->address == mcb::kStateRegister && frame->config[0] == mcb::kCyclicState);
    };
    pair.toDrive = [&](Bytes &bytes) { // IDLE for ever instead of the answer
        if (switching)
            bytes = mcb::encodeFrame(
                {0, mcb::Command::Idle, false, {}, mcb::Words((bytes.size() - 12) / 2)});
    };
    pair.submit(streamOf({pair.id("BUS_VOLTAGE")}));
    QVERIFY(pair.runUntil([&] { return switching; }, 1s));
    QVERIFY(stageIsOn(pair));
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntil([&] { return !stageIsOn(pair); }, 200ms));
    pair.toBoard = pair.toDrive = {};
    QVERIFY(pair.runUntil([&] { return !pair.drive->stopOpen(); }, 5s));
}

void TestMcbDrive::aStopDoesNotWaitForASlowStream_data()
{
    QTest::addColumn<unsigned>("every");
    for (const unsigned every : {1U, 2U, 4U, 5U, 16U, 64U, 220U, 256U})
        QTest::addRow("every %u ms", every) << every;
}

/// From any instant of the cycle, with and without a request in hand.
void TestMcbDrive::aStopDoesNotWaitForASlowStream()
{
    QFETCH(const unsigned, every);
    constexpr int kPhases = 16;
    Duration worst{};
    for (int phase = 0; phase < kPhases; ++phase) {
        McbPair pair;
        QVERIFY(pair.meet());
        QVERIFY(start(pair));
        QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")}, every)).outcome == Outcome::Ok);
        pair.runFor(600ms);
        pair.runFor(every * 1ms * phase / kPhases);
        if (phase % 2 == 1)
            pair.submit(Read{{pair.id("I_Q_MEAS"), pair.id("POSITION_MEAS")}});
        pair.writes.clear();
        const TimePoint asked = pair.now;
        pair.drive->stop(pair.now);
        QVERIFY(pair.runUntil([&] { return !pair.writes.empty(); }, 1s));
        QCOMPARE(pair.writes.front().address, std::uint16_t{0x010});
        QCOMPARE(pair.writes.front().config[0], std::uint16_t{0x06});
        worst = std::max(worst, pair.now - asked);
        QVERIFY(pair.runUntil([&] { return !pair.drive->stopOpen(); }, 5s));
        QVERIFY(std::none_of(pair.stops.begin(), pair.stops.end(),
            [](const StopProgress &stop) { return stop.word == StopWord::NotConfirmed; }));
    }
    QVERIFY2(worst <= 25ms, qPrintable(QString::number(worst / 1us)));
}

void TestMcbDrive::aStopGoesBeforeTheIdentification()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    pair.replaceDrive(makeMcbDrive({}));
    pair.connect();
    pair.stopped = true;
    const TimePoint asked = pair.now;
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntil([&] { return !stageIsOn(pair); }, 50ms));
    QVERIFY(pair.runUntil([&] { return !pair.drive->stopOpen(); }, 200ms));
    QVERIFY(pair.now - asked < 200ms);
}

void TestMcbDrive::aStopLeavesWhatWasStreamed_data()
{
    QTest::addColumn<int>("after_ms"); // the wish that it breaks off
    for (int ms = 0; ms <= 40; ++ms)
        QTest::addRow("%d ms after other signals were wished for", ms) << ms;
}

/// Whether the other signals came is told by how the wish ended; what was streamed before goes on otherwise.
void TestMcbDrive::aStopLeavesWhatWasStreamed()
{
    QFETCH(int, after_ms);
    McbPair pair;
    QVERIFY(pair.meet());
    const RegisterId before = pair.id("BUS_VOLTAGE"), other = pair.id("I_A");
    QVERIFY(pair.ask(streamOf({before})).outcome == Outcome::Ok);
    pair.runFor(100ms);
    const auto wish = pair.submit(streamOf({before, other}));
    pair.runFor(std::chrono::milliseconds(after_ms));
    pair.drive->stop(pair.now);
    QVERIFY(pair.runUntilEnded(wish));
    QVERIFY(pair.runUntil([&] { return !pair.drive->stopOpen(); }, 5s));
    pair.runFor(500ms);
    pair.blocks.clear();
    pair.runFor(100ms);
    QVERIFY(!pair.blocks.empty());
    const bool came = pair.ended.at(wish).front().outcome == Outcome::Ok;
    QCOMPARE(pair.layout->slow.size(), came ? std::size_t{2} : std::size_t{1});
}

void TestMcbDrive::samplesCarryTheirNameAndTime()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(start(pair));
    const std::vector<RegisterId> wanted{pair.id("CL_VEL_FBK_VALUE"), pair.id("DRV_STATE_STATUS"),
        pair.id("CL_POS_FBK_VALUE"), pair.id("BUS_VOLTAGE")};
    QVERIFY(pair.ask(streamOf(wanted)).outcome == Outcome::Ok);
    QVERIFY(pair.ask(SpeedRamp{1, 1200, 200ms}).outcome == Outcome::Ok);
    pair.runFor(1s);
    QVERIFY(pair.layout);
    QCOMPARE(pair.layout->slow.size(), std::size_t{4});
    for (std::size_t i = 0; i < 4; ++i)
        QCOMPARE(pair.layout->slow[i].id, wanted[i]);
    QVERIFY(std::abs(samplesOf(pair, 0).back() - 1200.0) < 60.0); // rpm
    QCOMPARE(static_cast<int>(samplesOf(pair, 1).back()) & 0x6F, 0x27);
    QVERIFY(std::abs(samplesOf(pair, 3).back() - 24.0) < 1.5);
    const auto counts = samplesOf(pair, 2);
    QVERIFY(counts.back() > counts[counts.size() / 2]);
    const auto &last = pair.blocks.back().slow.back();
    const double at = pair.layout->originSeconds + double(last.tick) / pair.layout->tickHz;
    QVERIFY(std::abs(at - toSeconds(pair.now.time_since_epoch())) < 0.02);
    capture::Capture store;
    store.begin(*pair.layout);
    for (const auto &block : pair.blocks)
        store.append(block);
    QCOMPARE(store.refused().malformed + store.refused().backwards + store.refused().otherStream,
        std::uint64_t{0});
    const auto channel = store.find(wanted[0]);
    QVERIFY(channel);
    QVERIFY(std::abs(*store.lastValue(*channel) - 1200.0) < 60.0);
}

void TestMcbDrive::sixtySecondsWithoutALostFrame()
{
    simulation::McbBoardOptions options;
    options.board.hfHz = 4000; // what the motor does is not looked at
    McbPair pair(options);
    QVERIFY(pair.meet());
    QVERIFY(pair.ask(streamOf({pair.id("CL_VEL_FBK_VALUE"), pair.id("I_Q_MEAS")})).outcome
        == Outcome::Ok);
    pair.runFor(61s);
    std::int64_t samples = 0, last = -1000;
    for (const auto &block : pair.blocks) {
        QCOMPARE(block.lostTicks, capture::Tick{0});
        for (const auto &group : block.slow) {
            QCOMPARE(group.tick - last, capture::Tick{1000}); // microseconds
            last = group.tick;
            ++samples;
        }
    }
    QVERIFY(samples >= 60'000);
    QCOMPARE(pair.counters.streamLostTicks, std::uint64_t{0});
}

void TestMcbDrive::aDamagedFrameIsAGap()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")})).outcome == Outcome::Ok);
    pair.runFor(100ms);
    int left = 1;
    pair.toDrive = [&](Bytes &bytes) {
        if (left-- > 0)
            bytes[11] ^= 4;
    };
    pair.runFor(200ms);
    int gaps = 0;
    for (const auto &block : pair.blocks)
        if (block.lostTicks != 0) {
            ++gaps;
            QCOMPARE(block.lostTicks, capture::Tick{1000});
        }
    QCOMPARE(gaps, 1);
    QCOMPARE(pair.counters.streamLostTicks, std::uint64_t{1});
}

void TestMcbDrive::aProgramThatStandsStillLeavesAGap_data()
{
    QTest::addColumn<unsigned>("every"); // periods of 1 ms
    QTest::newRow("each period") << 1U;
    QTest::newRow("each fourth") << 4U;
}

/// The drive was asked for nothing meanwhile.
void TestMcbDrive::aProgramThatStandsStillLeavesAGap()
{
    QFETCH(unsigned, every);
    McbPair pair({}, 700ms);
    QVERIFY(pair.meet());
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")}, every)).outcome == Outcome::Ok);
    pair.runFor(100ms);
    pair.stall(50ms); // as computers do
    pair.runFor(100ms);
    pair.stall(700ms);
    pair.runFor(300ms); // counters are told each 250 ms
    std::vector<capture::Tick> gaps; // us
    for (const auto &block : pair.blocks)
        if (block.lostTicks != 0)
            gaps.push_back(block.lostTicks);
    QCOMPARE(gaps.size(), std::size_t{1});
    QVERIFY2(gaps[0] > 690'000 && gaps[0] <= 700'000, qPrintable(QString::number(gaps[0])));
    const double lost = static_cast<double>(pair.counters.streamLostTicks);
    QVERIFY2(std::abs(lost - static_cast<double>(gaps[0]) / (1000.0 * every)) <= 0.5,
        qPrintable(QString::number(lost)));
}

void TestMcbDrive::aStreamTakesAsManyBytesAsItsLimitsSay()
{
    McbPair pair;
    QVERIFY(pair.meet());
    const std::vector<RegisterId> ids{pair.id("CL_VEL_FBK_VALUE"), pair.id("DRV_STATE_STATUS"),
        pair.id("CL_POS_FBK_VALUE"), pair.id("BUS_VOLTAGE")};
    QVERIFY(pair.ask(streamOf(ids)).outcome == Outcome::Ok);
    double frame = static_cast<double>(pair.identified->streaming.frameOverhead);
    for (const RegisterId id : ids)
        frame += static_cast<double>(catalog::widthOf(pair.identified->catalog->find(id)->type));
    std::vector<std::pair<double, std::uint64_t>> told; // seconds, bytes
    pair.onEvent = [&](const Event &event) {
        if (const auto *counters = std::get_if<LinkCounters>(&event))
            told.emplace_back(toSeconds(pair.now.time_since_epoch()), counters->bytesIn);
    };
    pair.runFor(2s);
    pair.onEvent = nullptr;
    QVERIFY(told.size() > 2);
    const double bytes = static_cast<double>(told.back().second - told.front().second);
    const double each = bytes / (told.back().first - told.front().first);
    const double said = frame * pair.identified->streaming.tickHz;
    QVERIFY2(std::abs(each - said) < 0.02 * said, qPrintable(QString::number(each)));
    QVERIFY(frame <= static_cast<double>(pair.identified->streaming.maxPacket));
}

void TestMcbDrive::registersAreReadWhileItStreams()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")})).outcome == Outcome::Ok);
    QVERIFY(pair.ask(Read{{pair.id("DRV_ID_SOFTWARE_VERSION")}}).outcome == Outcome::Ok);
    QVERIFY(
        pair.values.at(pair.id("DRV_ID_SOFTWARE_VERSION")).value == Value(std::string("1.12.0")));
    QVERIFY(pair.ask(Write{{{pair.id("CL_VEL_PID_KP"), 0.25}}}).outcome == Outcome::Ok);
    const auto first = pair.layout->id;
    QVERIFY(pair.ask(streamOf({pair.id("I_Q_MEAS"), pair.id("I_A")}, 4)).outcome == Outcome::Ok);
    pair.runFor(100ms);
    QVERIFY(pair.layout->id != first);
    QCOMPARE(pair.blocks.back().slow.back().values.size(), std::size_t{2});
    QVERIFY(pair.ask(Stream{}).outcome == Outcome::Ok);
    QVERIFY(pair.layout->empty());
    QVERIFY(!pair.board->slave().cyclic());
}

void TestMcbDrive::theWatchedRegistersMayChangeWhileOneIsAsked()
{
    McbPair pair;
    QVERIFY(pair.meet());
    const std::vector<RegisterId> ids{
        pair.id("SPEED_MEAS"), pair.id("I_Q_MEAS"), pair.id("MOT_PAIR_POLES")};
    // In the cyclic state an answer takes frames, so that a question is open between two of them.
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")})).outcome == Outcome::Ok);
    for (int change = 0; change < 60; ++change) {
        pair.values.clear();
        pair.submit(Watch{{ids[static_cast<std::size_t>(change) % 3]}, 1ms});
        pair.runFor(std::chrono::milliseconds(1 + change % 4));
        for (const auto &[id, reading] : pair.values)
            QVERIFY(std::find(ids.begin(), ids.end(), id) != ids.end());
    }
    pair.submit(Watch{ids, 1ms});
    pair.values.clear();
    pair.runFor(100ms);
    QCOMPARE(pair.values.size(), std::size_t{3});
}

void TestMcbDrive::aResetWhileItStreamsIsToldAndTakenUp()
{
    McbPair pair;
    QVERIFY(pair.meet());
    arm(pair);
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")})).outcome == Outcome::Ok);
    pair.runFor(50ms);
    pair.board->reset();
    QVERIFY(pair.runUntil([&] { return pair.reason == LinkReason::BoardReset; }, 3s));
    QVERIFY(!pair.drive->armed());
    QVERIFY(!pair.wroteUnidentified);
    pair.blocks.clear();
    QVERIFY(pair.runUntil([&] { return pair.blocks.size() > 2; }, 5s));
    QCOMPARE(pair.identifications, 2);
    for (double volts : samplesOf(pair, 0))
        QVERIFY(std::abs(volts - 24.0) < 1.5);
}

void TestMcbDrive::aDriveThatCyclesIsMet()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE"), pair.id("I_A")})).outcome == Outcome::Ok);
    pair.runFor(10ms);
    pair.replaceDrive(makeMcbDrive({})); // the program was killed
    pair.identified.reset();
    QVERIFY(pair.meet());
    QVERIFY(!pair.board->slave().cyclic());
}

void TestMcbDrive::aDeadLineIsTold()
{
    McbPair pair;
    pair.toDrive = [](Bytes &bytes) { std::fill(bytes.begin(), bytes.end(), std::uint8_t{0}); };
    pair.connect();
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Lost; }, 5s));
    QVERIFY(pair.reason == LinkReason::DeadLine);
    pair.toDrive = {};
    QVERIFY(pair.runUntil([&] { return pair.identified.has_value(); }, 5s));
    QVERIFY(pair.link == LinkState::Connected);
}

void TestMcbDrive::aStuckReadyLineIsTold()
{
    McbPair pair;
    pair.drive->handleReady(false, pair.now);
    pair.connect();
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Lost; }, 5s));
    QVERIFY(pair.reason == LinkReason::NotReady);
    QVERIFY(pair.ask(Read{{8}}).outcome == Outcome::NotSent);
}

void TestMcbDrive::disconnectingLeavesTheConfigState()
{
    McbPair pair;
    QVERIFY(pair.meet());
    QVERIFY(pair.ask(streamOf({pair.id("BUS_VOLTAGE")})).outcome == Outcome::Ok);
    pair.drive->disconnect(pair.now);
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Closed; }, 1s));
    QVERIFY(!pair.board->slave().cyclic());
    QVERIFY(!pair.drive->nextTimeout());
}

QTEST_GUILESS_MAIN(TestMcbDrive)
#include "tst_mcb_drive.moc"
