// McpDrive against the simulated board: what a user's session is made of, on virtual time.
#include "aspep/packet.h"
#include "drive/mcp/scales.h"
#include "support/link_pair.h"

#include <QTest>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

class TestMcpDrive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void connectsAndSaysWhatBoardItIs();
    void nothingMovesUnasked();
    void readsWatchesAndNotices();
    void startsRampsStreamsAndStops();
    void doesNothingThatActsUntilArmed();
    void bytesMayBeGatheredWhereNothingMoves();
    void numbersAreReadLessOftenWhereNothingMoves();
    void aStartThatIsRefusedSaysWhy();
    void acknowledgesAFaultThatIsOver();
    void torqueAndCurrentGoOutInDigits();
    void unknownFirmwareIsShownReadOnly();
    void aBoardThatIsResetIsSeenAndDisarms();
    void aResetIsSeenThoughPingsAreLost();
    void aLostLinkComesBackByItselfAndReadOnly();
    void nobodyAnswersAndItSaysSo();
    void aBoardThatWaitsForTheRestOfARequestIsReached();
    void disconnectingEndsTheStreamAndEveryWish();
    void manyMotorsAreRefusedBeforeTheWire();
    void olderFirmwareHasItsOwnScales();
};

void TestMcpDrive::connectsAndSaysWhatBoardItIs()
{
    Session session(false);
    QVERIFY(session.ready);
    QVERIFY(session.link == LinkState::Connected);
    const Identified &board = *session.identified;
    QCOMPARE(board.identity.motors, 1);
    QVERIFY(board.identity.knownFirmware);
    QVERIFY(board.identity.version.starts_with("6.4"));
    QVERIFY(!board.identity.firmware.empty());
    QVERIFY(!board.identity.controlBoard.empty());
    QCOMPARE(board.streaming.tickHz, 16000.0);
    QCOMPARE(board.streaming.maxSignals, 10U);
    QCOMPARE(board.streaming.linkBytesPerSecond, 184320.0);
    QVERIFY(board.limits.at(0).maxSpeedRpm > 0);
    QVERIFY(board.limits.at(0).nominalCurrentAmps > 0);
    QVERIFY(board.limits.at(0).polePairs > 0);
    for (const Capability &capability : board.capabilities) {
        const bool has = capability.feature != Feature::PositionRamp // its motor has no encoder
            && capability.feature != Feature::CyclicSetPoints // no such protocol
            && capability.feature != Feature::CurrentScale; // the board tells it
        QVERIFY2(capability.available == has, capability.reason.c_str());
    }
    QCOMPARE(board.catalog->readScale(session.id("I_Q")).unit, "A");
    // Version first, then the state, then the datalog stopped, then the rest.
    QCOMPARE(session.requests.at(0), (Bytes{0x10, 0x00, 0x28, 0x00}));
    QCOMPARE(session.requests.at(2), (Bytes{0x10, 0x00, 0x19, 0x00, 0x49, 0x00}));
    QCOMPARE(session.requests.at(3).at(2), 0x29);
    QCOMPARE(session.requests.at(3).at(3), 0x05);
    QVERIFY(session.runUntil(
        [&] { return session.status.contains(1) && session.status[1].speedRpm; }, 1s));
    QVERIFY(session.status[1].state == MotorState::Idle);
    QCOMPARE(session.status[1].stateName, "IDLE");
}

void TestMcpDrive::nothingMovesUnasked()
{
    Session session;
    session.submit(Watch{{session.id("I_Q_MEAS"), session.id("BUS_VOLTAGE")}, 50ms});
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(2s);
    session.board->reset();
    session.runFor(3s);
    QVERIFY(session.link == LinkState::Connected);
    for (const Bytes &request : session.requests)
        QVERIFY(!support::changesSomething(request));
}

void TestMcpDrive::readsWatchesAndNotices()
{
    Session session(false);
    const WishId read = session.submit(Read{{session.id("BUS_VOLTAGE"), session.id("MOTOR_NAME"),
        session.id("SPEED_KP"), session.id("MOTOR_CONFIG"), session.id("ENCODER_SPEED")}});
    QVERIFY(session.runUntilEnded(read));
    QVERIFY(session.outcome(read) == Outcome::Ok);
    QVERIFY(session.values[session.id("BUS_VOLTAGE")].status == ReadStatus::Ok);
    QVERIFY(std::get<std::int64_t>(session.values[session.id("BUS_VOLTAGE")].value) > 0);
    QCOMPARE(std::get<Bytes>(session.values[session.id("MOTOR_CONFIG")].value).size(), 60U);
    QVERIFY(session.values[session.id("ENCODER_SPEED")].status == ReadStatus::NotSupported);

    std::vector<RegisterId> everything;
    for (const auto &info : session.identified->catalog->registers())
        if (info.readable() && !info.stub)
            everything.push_back(session.identified->catalog->withMotor(info, 1));
    int rounds = 0, unsupported = 0;
    session.onEvent = [&](const Event &event) {
        if (const auto *batch = std::get_if<RegistersRead>(&event)) {
            for (const Reading &reading : batch->readings) {
                rounds += reading.id == session.id("BUS_VOLTAGE");
                unsupported += reading.id == session.id("ENCODER_SPEED");
            }
        }
    };
    session.submit(Watch{everything, 100ms});
    session.runFor(3s);
    QVERIFY2(rounds >= 10, std::to_string(rounds).c_str());
    QCOMPARE(unsupported, 1);
    QCOMPARE(session.counters.timeouts, 0U);
}

void TestMcpDrive::startsRampsStreamsAndStops()
{
    Session session;
    QVERIFY(session.ready);
    QVERIFY(session.startMotor());
    const WishId ramp = session.submit(SpeedRamp{1, 1500, 500ms});
    QVERIFY(session.runUntilEnded(ramp));
    QVERIFY(session.outcome(ramp) == Outcome::Ok);

    capture::StreamLayout layout;
    std::uint64_t samples = 0;
    capture::Tick lost = 0, next = -1;
    double firstSeconds = 0.0;
    session.onEvent = [&](const Event &event) {
        if (const auto *started = std::get_if<StreamStarted>(&event)) {
            layout = started->layout;
        } else if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
            QCOMPARE(block->stream, layout.id);
            QCOMPARE(block->fast.size(), std::size_t{block->count} * layout.fast.size());
            if (next < 0)
                firstSeconds =
                    layout.originSeconds + static_cast<double>(block->firstTick) / layout.tickHz;
            else
                QCOMPARE(block->firstTick, next + block->lostTicks);
            next = block->firstTick + static_cast<capture::Tick>(block->count) * layout.fastStep;
            lost += block->lostTicks;
            samples += block->count;
        }
    };
    const WishId stream = session.submit(Stream{
        {session.id("I_A"), session.id("I_B"), session.id("I_Q"), session.id("STOPLL_ROT_SPEED")},
        1, {}, 1});
    const double asked = toSeconds(session.now.time_since_epoch());
    QVERIFY(session.runUntilEnded(stream));
    QVERIFY(session.outcome(stream) == Outcome::Ok);
    session.runFor(2s);
    QCOMPARE(layout.fast.size(), 4U);
    QCOMPARE(layout.fast[2].name, "I_Q_MEAS");
    QCOMPARE(layout.fast[2].unit, "A");
    QCOMPARE(layout.fast[3].factor, 6.0);
    QCOMPARE(lost, 0);
    QVERIFY2(samples > 31000 && samples <= 32100, std::to_string(samples).c_str());
    QVERIFY(std::abs(firstSeconds - asked) < 0.03);
    QVERIFY(std::abs(*session.status[1].speedRpm - 1500) < 100);

    session.drive->stop(session.now);
    QVERIFY(!session.drive->armed());
    QVERIFY(session.runUntil([&] { return session.hasStopWord(StopWord::MayCoast); }, 10s));
    for (const StopWord word : {StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle})
        QVERIFY(session.hasStopWord(word));
    QVERIFY(!session.hasStopWord(StopWord::NotConfirmed));
    QCOMPARE(session.counters.streamLostTicks, 0U);
}

void TestMcpDrive::doesNothingThatActsUntilArmed()
{
    Session session(false);
    const std::size_t before = session.requests.size();
    std::vector<WishId> wishes;
    wishes.push_back(session.submit(Command{MotorAction::Start, 1}));
    wishes.push_back(session.submit(Command{MotorAction::AcknowledgeFaults, 1}));
    wishes.push_back(session.submit(SpeedRamp{1, 100, 100ms}));
    wishes.push_back(session.submit(TorqueRamp{1, 0.1, 100ms}));
    wishes.push_back(session.submit(CurrentReference{1, 0.1, 0.0}));
    wishes.push_back(session.submit(Write{{{session.id("SPEED_KP"), std::int64_t{1}}}}));
    session.runFor(500ms);
    for (const WishId wish : wishes) {
        QVERIFY(session.outcome(wish) == Outcome::NotSent);
        QCOMPARE(session.ended[wish].front().reason, "not armed");
    }
    for (std::size_t i = before; i < session.requests.size(); ++i)
        QVERIFY(!support::changesSomething(session.requests[i]));
    QVERIFY(!session.drive->armed());
}

void TestMcpDrive::bytesMayBeGatheredWhereNothingMoves()
{
    Session session;
    QVERIFY(session.ready);
    session.drive->disarm();
    session.runFor(200ms);
    QCOMPARE(session.drive->gathersFor(), Duration::zero()); // what comes is an answer
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(500ms);
    QVERIFY(session.drive->gathersFor() >= 5ms);
    session.drive->arm();
    QCOMPARE(session.drive->gathersFor(), Duration::zero());
    QVERIFY(session.startMotor());
    session.drive->disarm();
    session.runFor(500ms);
    QCOMPARE(session.drive->gathersFor(), Duration::zero()); // it turns, by any start
    session.drive->stop(session.now);
    QVERIFY(session.runUntil([&] { return !session.drive->stopOpen(); }, 10s));
    session.runFor(500ms);
    QVERIFY(session.drive->gathersFor() >= 5ms);
}

/// States, and what is drawn, come as often as ever.
void TestMcpDrive::numbersAreReadLessOftenWhereNothingMoves()
{
    Session session(false);
    const RegisterId kp = session.id("SPEED_KP");
    int read = 0, states = 0;
    session.onEvent = [&](const Event &event) {
        if (const auto *batch = std::get_if<RegistersRead>(&event))
            read += static_cast<int>(std::ranges::count(batch->readings, kp, &Reading::id));
        states += std::holds_alternative<MotorStatus>(event) ? 1 : 0;
    };
    const auto readIn = [&](Duration time) {
        read = states = 0;
        session.runFor(time);
        return read;
    };
    session.submit(Watch{{kp}, 50ms});
    QVERIFY(readIn(30ms) > 0);
    readIn(500ms);
    const int atRest = readIn(2s);
    QVERIFY2(atRest >= 9 && atRest <= 11, std::to_string(atRest).c_str());
    QVERIFY2(states >= 19, std::to_string(states).c_str());

    for (int i = 0; i < 4; ++i) { // wherever it is in its round
        readIn(300ms + i * 50ms);
        session.drive->arm();
        session.drive->handleTimeout(session.now); // as a session does after each call
        QVERIFY(readIn(60ms) > 0);
        session.drive->disarm();
    }
    session.drive->arm();
    QVERIFY(readIn(2s) >= 38);
    QVERIFY(session.startMotor());
    session.drive->disarm();
    readIn(500ms);
    QVERIFY(readIn(2s) >= 38); // it turns, by any start
    session.drive->stop(session.now);
    QVERIFY(session.runUntil([&] { return !session.drive->stopOpen(); }, 10s));
    readIn(500ms);
    QVERIFY(readIn(2s) <= 11);
    session.submit(Watch{{kp}, 50ms, {kp}});
    QVERIFY(readIn(2s) >= 38);
}

void TestMcpDrive::aStartThatIsRefusedSaysWhy()
{
    Session session;
    session.board->setFaults(0x0004);
    session.runFor(300ms);
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.runUntilEnded(start));
    QVERIFY(session.outcome(start) == Outcome::Refused);
    QCOMPARE(session.ended[start].front().reason, "CMD_NOK in FAULT_NOW, UNDER_VOLT");
    QVERIFY(!session.ended[start].front().byProgram);
    QVERIFY(session.status[1].state == MotorState::FaultNow);
    QCOMPARE(session.status[1].faultsNow, std::vector<std::string>{"UNDER_VOLT"});
}

void TestMcpDrive::acknowledgesAFaultThatIsOver()
{
    Session session;
    session.board->setFaults(0x0002);
    QVERIFY(session.runUntilState(MotorState::FaultNow));
    session.board->setFaults(0);
    QVERIFY(session.runUntilState(MotorState::FaultOver));
    QVERIFY(session.status[1].faultsNow.empty());
    QCOMPARE(session.status[1].faultsPast, std::vector<std::string>{"OVER_VOLT"});
    const WishId acknowledge = session.submit(Command{MotorAction::AcknowledgeFaults, 1});
    QVERIFY(session.runUntilEnded(acknowledge));
    QVERIFY(session.outcome(acknowledge) == Outcome::Ok);
    QVERIFY(session.runUntilState(MotorState::Idle));
}

void TestMcpDrive::torqueAndCurrentGoOutInDigits()
{
    Session session;
    const double amps = session.identified->catalog->readScale(session.id("I_Q")).factor;
    const WishId torque = session.submit(TorqueRamp{1, 100 * amps, 200ms});
    QVERIFY(session.runUntilEnded(torque));
    QVERIFY(session.outcome(torque) == Outcome::Ok);
    const Bytes ramp{0x08, 0x00, 0xE9, 0x01, 0x06, 0x00, 100, 0, 0, 0, 200, 0};
    QVERIFY(std::find(session.requests.begin(), session.requests.end(), ramp)
        != session.requests.end());
    // It was in speed mode: torque mode goes first, and is not sent again when it is there already.
    const Bytes mode{0x08, 0x00, 0x89, 0x00, 0x04};
    QCOMPARE(std::count(session.requests.begin(), session.requests.end(), mode), 1);
    const WishId current = session.submit(CurrentReference{1, -50 * amps, 10 * amps});
    QVERIFY(session.runUntilEnded(current));
    const Bytes reference{0x08, 0x00, 0x69, 0x03, 0x04, 0x00, 0xCE, 0xFF, 10, 0};
    QVERIFY(std::find(session.requests.begin(), session.requests.end(), reference)
        != session.requests.end());
    QCOMPARE(std::count(session.requests.begin(), session.requests.end(), mode), 1);
}

void TestMcpDrive::unknownFirmwareIsShownReadOnly()
{
    Session session(false);
    std::vector<catalog::RegisterInfo> registers = session.identified->catalog->registers();
    makeRaw(registers);
    for (const catalog::RegisterInfo &info : registers) {
        QVERIFY(!info.writable());
        QCOMPARE(info.unit, "");
    }
    McpFacts board;
    board.motors = 1;
    addCapabilities(board, {});
    for (const Capability &capability : board.capabilities)
        QCOMPARE(capability.available, capability.feature == Feature::Stop);
}

void TestMcpDrive::aBoardThatIsResetIsSeenAndDisarms()
{
    Session session;
    QVERIFY(session.startMotor());
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(500ms);
    session.events.clear();
    session.identified.reset();
    const std::size_t sentBefore = session.requests.size();
    session.board->reset();
    QVERIFY(session.runUntil([&] { return session.identified.has_value(); }, 5s));
    QVERIFY(session.link == LinkState::Connected);
    QVERIFY(session.reason == LinkReason::BoardReset);
    QVERIFY(!session.drive->armed());
    std::uint64_t samples = 0;
    session.onEvent = [&](const Event &event) {
        if (const auto *block = std::get_if<capture::SampleBlock>(&event))
            samples += block->count;
    };
    session.runFor(1s); // what was streamed is streamed again, the motor stays where it is
    QVERIFY2(samples > 14000, std::to_string(samples).c_str());
    QVERIFY(session.status[1].state == MotorState::Idle);
    for (std::size_t i = sentBefore + 1; i < session.requests.size(); ++i)
        QVERIFY(!support::changesSomething(session.requests[i]));
}

void TestMcpDrive::aResetIsSeenThoughPingsAreLost()
{
    constexpr unsigned kPing = 6;
    for (const bool answersAreLost : {false, true}) {
        for (int lost = 1; lost <= 4; ++lost) {
            Session session;
            QVERIFY(session.startMotor());
            session.identified.reset();
            session.board->reset();
            int pings = 0;
            session.loses = [&](const Bytes &bytes) {
                const bool ping = bytes.size() == 4 && (bytes[0] & 0x0FU) == kPing;
                const bool loses = ping && ++pings <= lost;
                session.toDrive.cut = answersAreLost && loses;
                return loses && !answersAreLost;
            };
            QVERIFY(session.runUntil([&] { return session.identified.has_value(); }, 5s));
            QVERIFY(session.reason == LinkReason::BoardReset);
            QVERIFY(!session.drive->armed());
        }
    }
}

void TestMcpDrive::aLostLinkComesBackByItselfAndReadOnly()
{
    Session session;
    QVERIFY(session.startMotor());
    session.toBoard.cut = session.toDrive.cut = true;
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Suspect; }, 1s));
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Lost; }, 3s));
    QVERIFY(session.reason == LinkReason::Silence);
    QVERIFY(!session.drive->armed());
    session.runFor(5s);
    QVERIFY(session.link == LinkState::Lost);
    const WishId wish = session.submit(Read{{0x0049}});
    QVERIFY(session.outcome(wish) == Outcome::NotSent);
    const std::size_t before = session.requests.size();
    session.identified.reset();
    session.toBoard.cut = session.toDrive.cut = false;
    QVERIFY(session.runUntilIdentified(5s));
    session.runFor(500ms);
    QVERIFY(session.link == LinkState::Connected);
    QVERIFY(!session.drive->armed());
    QVERIFY(session.status[1].state == MotorState::Running); // the board does not care
    for (std::size_t i = before; i < session.requests.size(); ++i)
        QVERIFY(!support::changesSomething(session.requests[i]));
}

void TestMcpDrive::aBoardThatWaitsForTheRestOfARequestIsReached()
{
    // A program that was killed between header and payload leaves such a board behind.
    for (const int length : {4, 7, 128, 255, 256}) {
        support::Session session(false);
        QVERIFY(session.ready);
        session.drive->disconnect(session.now);
        session.runFor(1s);
        const aspep::HeaderBytes header =
            aspep::encodeHeader(aspep::Data{false, static_cast<std::uint16_t>(length)});
        session.board->receive(Bytes(header.begin(), header.end()), session.now);
        session.runFor(10ms);
        session.board->receive(Bytes{0x12, 0x00, 0x13}, session.now);
        session.runFor(100ms);
        session.connect();
        QVERIFY(session.runUntil([&] { return session.link != LinkState::Connecting; }, 10s));
        QVERIFY2(session.link == LinkState::Connected, std::to_string(length).c_str());
    }
}

void TestMcpDrive::nobodyAnswersAndItSaysSo()
{
    support::LinkPair pair;
    pair.toBoard.cut = true;
    pair.connect();
    QVERIFY(pair.link == LinkState::Connecting);
    const WishId wish = pair.submit(Read{{0x0049}});
    QVERIFY(pair.runUntil([&] { return pair.link == LinkState::Lost; }, 5s));
    QVERIFY(pair.reason == LinkReason::NoAnswer);
    QVERIFY(pair.outcome(wish) == Outcome::NotSent || pair.outcome(wish) == Outcome::Unknown);
    pair.drive->disconnect(pair.now);
    pair.exchange();
    QVERIFY(pair.link == LinkState::Closed);
    QVERIFY(!pair.drive->nextTimeout());
}

void TestMcpDrive::disconnectingEndsTheStreamAndEveryWish()
{
    Session session;
    session.submit(Stream{{session.id("I_A")}, 1, {}, 1});
    session.runFor(200ms);
    std::vector<WishId> wishes;
    for (int i = 0; i < 20; ++i)
        wishes.push_back(session.submit(Read{{session.id("BUS_VOLTAGE")}}));
    session.drive->disconnect(session.now);
    session.exchange();
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Closed; }, 1s));
    for (const WishId wish : wishes)
        QCOMPARE(session.ended[wish].size(), 1U);
    const Bytes &last = session.requests.back();
    QCOMPARE(last.at(2), 0x29); // the datalog
    QCOMPARE(last.back(), 0); // mark 0
    QVERIFY(!session.drive->nextTimeout());
}

void TestMcpDrive::manyMotorsAreRefusedBeforeTheWire()
{
    Session session;
    const std::size_t before = session.requests.size();
    std::vector<WishId> wishes;
    for (const int motor : {-1, 0, 2, 7, 8, 100}) {
        wishes.push_back(session.submit(Command{MotorAction::Start, motor}));
        wishes.push_back(session.submit(SpeedRamp{motor, 100, 100ms}));
    }
    session.runFor(500ms);
    for (const WishId wish : wishes)
        QVERIFY(session.outcome(wish) == Outcome::Refused);
    for (std::size_t i = before; i < session.requests.size(); ++i)
        QVERIFY(!support::changesSomething(session.requests[i]));
}

void TestMcpDrive::olderFirmwareHasItsOwnScales()
{
    simulation::BoardOptions options;
    options.profile = "mcsdk-6.2";
    Session session(false, options);
    QVERIFY(session.ready);
    QVERIFY(session.identified->identity.version.starts_with("6.2"));
    QVERIFY(session.identified->identity.knownFirmware);
    const auto id = session.id("STOPLL_ROT_SPEED");
    QCOMPARE(session.identified->catalog->streamScale(id).factor, 6.0);
    QVERIFY(session.identified->catalog->readScale(id).factor < 1.0);
}

QTEST_APPLESS_MAIN(TestMcpDrive)
#include "tst_mcp_drive.moc"
