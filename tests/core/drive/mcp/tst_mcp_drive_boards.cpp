// McpDrive meets every board that the simulation knows: all versions, two motors, six-step and HSO builds.
#include "simulation/plant/presets.h"
#include "support/link_pair.h"

#include <QTest>

#include <numbers>

using namespace drive;
using support::Session;
using namespace std::chrono_literals;

namespace {

/// Blocks of the last stream, signal after signal.
struct Recorder {
    explicit Recorder(Session &session)
    {
        session.onEvent = [this](const Event &event) {
            if (const auto *started = std::get_if<StreamStarted>(&event))
                layout = started->layout;
            else if (const auto *block = std::get_if<capture::SampleBlock>(&event))
                accept(*block);
        };
    }

    void accept(const capture::SampleBlock &block)
    {
        lost += block.lostTicks;
        samples.resize(layout.fast.size());
        for (std::size_t s = 0; s < samples.size(); ++s)
            for (std::size_t i = 0; i < block.count; ++i)
                samples[s].push_back((block.fast[s * block.count + i] + layout.fast[s].offset)
                    * layout.fast[s].factor);
    }

    capture::StreamLayout layout;
    std::vector<std::vector<double>> samples; ///< as shown
    capture::Tick lost = 0;
};

double greatest(const std::vector<double> &values)
{
    return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

double mean(const std::vector<double> &values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

simulation::BoardOptions boardLike(const char *profile, int motors = 1)
{
    simulation::BoardOptions options;
    options.profile = profile;
    options.motors = motors;
    return options;
}

bool offers(const Session &session, Feature feature)
{
    const auto &all = session.identified->capabilities;
    return std::any_of(all.begin(), all.end(),
        [&](const Capability &c) { return c.feature == feature && c.available; });
}

} // namespace

class TestMcpDriveBoards : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyBoardIsIdentifiedStartedAndStopped_data();
    void everyBoardIsIdentifiedStartedAndStopped();
    void everyMotorIsDescribedAndTurns_data();
    void everyMotorIsDescribedAndTurns();
    void aBoardWithAnEncoderAloneTurnsAndStreams();
    void aMotorThatCannotBeIsNoBoard();
    void sensorSpeedsReadRightOnEveryVersion_data();
    void sensorSpeedsReadRightOnEveryVersion();
    void theMainSensorsSpeedIsToldWhereItIsStreamed();
    void twoMotorsAreTwo();
    void bothMotorsOfAStreamShareItsTicks();
    void sixStepHasNoScopeAndNoTorque();
    void hsoValuesCarryTheirUnits();
    void hsoStreamsTheUpperHalf();
};

void TestMcpDriveBoards::everyBoardIsIdentifiedStartedAndStopped_data()
{
    QTest::addColumn<QString>("profile");
    QTest::addColumn<int>("motors");
    for (const std::string &name : simulation::profileNames()) {
        for (const int motors : {1, 2})
            QTest::addRow("%s, %d", name.c_str(), motors) << QString::fromStdString(name) << motors;
    }
}

void TestMcpDriveBoards::everyBoardIsIdentifiedStartedAndStopped()
{
    QFETCH(QString, profile);
    QFETCH(int, motors);
    Session session(true, boardLike(profile.toUtf8().constData(), motors));
    QVERIFY(session.ready);
    QVERIFY(session.identified->identity.knownFirmware);
    QCOMPARE(session.identified->identity.motors, motors);
    QCOMPARE(session.identified->limits.size(), std::size_t(motors));
    for (int motor = 1; motor <= motors; ++motor) {
        const auto &limits = session.identified->limits[std::size_t(motor - 1)];
        QCOMPARE(limits.polePairs, 4.0);
        QCOMPARE(limits.maxSpeedRpm, 4000.0);
        QVERIFY(std::abs(limits.nominalCurrentAmps - 5.0) < 0.01);
        const WishId start = session.submit(Command{MotorAction::Start, motor});
        QVERIFY(session.runUntilEnded(start));
        QVERIFY(session.outcome(start) == Outcome::Ok);
        QVERIFY(session.runUntil(
            [&] { return session.status.at(motor).state == MotorState::Running; }, 5s));
        session.runFor(1s);
        QVERIFY(session.status.at(motor).speedRpm.value_or(0.0) > 1300.0);
    }
    session.drive->stop(session.now);
    session.exchange();
    for (int motor = 1; motor <= motors; ++motor)
        QVERIFY(session.runUntil(
            [&] {
                return session.status.at(motor).state == MotorState::Idle
                    && std::abs(session.status.at(motor).speedRpm.value_or(1.0)) < 20.0;
            },
            5s));
    QCOMPARE(session.counters.recoveries, std::uint64_t(0));
}

void TestMcpDriveBoards::everyMotorIsDescribedAndTurns_data()
{
    QTest::addColumn<QString>("preset");
    QTest::addColumn<QString>("profile");
    for (const simulation::Preset &preset : simulation::presets()) {
        for (const char *profile : {"mcsdk-6.4", "six-step", "hso"}) {
            const std::string name(preset.name);
            QTest::addRow("%s, %s", name.c_str(), profile)
                << QString::fromStdString(name) << profile;
        }
    }
}

void TestMcpDriveBoards::everyMotorIsDescribedAndTurns()
{
    QFETCH(QString, preset);
    QFETCH(QString, profile);
    const auto &motor = simulation::findPreset(preset.toStdString())->motor;
    simulation::BoardOptions options = boardLike(profile.toUtf8().constData());
    options.motor = preset.toStdString();
    Session session(true, options);
    QVERIFY(session.ready);
    QCOMPARE(session.identified->identity.motorNames.at(0), motor.name);
    const MotorLimits &limits = session.identified->limits.at(0);
    QCOMPARE(limits.polePairs, double(motor.polePairs));
    QCOMPARE(limits.maxSpeedRpm, motor.maxSpeed_rpm);
    QVERIFY(std::abs(limits.nominalCurrentAmps - motor.nominal_a) < 0.01);
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.runUntilEnded(start));
    QVERIFY(session.runUntilState(MotorState::Running, 5s));
    session.runFor(1s);
    QVERIFY(session.status.at(1).state == MotorState::Running);
    QVERIFY(session.status.at(1).speedRpm.value_or(0.0) > 0.2 * motor.maxSpeed_rpm);
}

void TestMcpDriveBoards::aBoardWithAnEncoderAloneTurnsAndStreams()
{
    simulation::BoardOptions options = boardLike("mcsdk-6.4");
    options.motor = "servo24";
    for (const simulation::BuildOption &option : simulation::buildOptions())
        if (option.name == "sensor-alone")
            options.with.push_back(&option);
    QVERIFY(!options.with.empty());
    Session session(true, options);
    QVERIFY(session.ready);
    QVERIFY(session.identified->identity.knownFirmware);
    QCOMPARE(session.identified->identity.speedSignals, std::vector<std::string>{"ENCODER_SPEED"});
    QVERIFY(session.runAt(1500));
    Recorder recorder(session);
    const WishId stream = session.submit(Stream{{session.id("ENCODER_SPEED")}, 1, {}, 1});
    QVERIFY(session.runUntilEnded(stream));
    QVERIFY(session.outcome(stream) == Outcome::Ok);
    session.runFor(1s);
    QVERIFY(std::abs(mean(recorder.samples.at(0)) - 1500.0) < 60.0);
    // What it does not have is said to be so, and breaks nothing.
    const RegisterId observer = session.id("STOPLL_ROT_SPEED"), stages = session.id("REVUP_DATA");
    const WishId read = session.submit(Read{{observer, stages, session.id("SPEED_MEAS")}});
    QVERIFY(session.runUntilEnded(read));
    QVERIFY(session.values.at(observer).status == ReadStatus::NotSupported);
    QVERIFY(session.values.at(stages).status == ReadStatus::NotSupported);
    QVERIFY(session.values.at(session.id("SPEED_MEAS")).status == ReadStatus::Ok);
    QCOMPARE(session.counters.recoveries, std::uint64_t(0));
}

void TestMcpDriveBoards::aMotorThatCannotBeIsNoBoard()
{
    simulation::BoardOptions options;
    options.motor = "steam";
    QVERIFY(simulation::makeBoard(options) == nullptr);
    options.motor.clear();
    options.plant.emplace();
    options.plant->motor.polePairs = 0;
    QVERIFY(simulation::makeBoard(options) == nullptr);
    options.plant->motor.polePairs = 3;
    QVERIFY(simulation::makeBoard(options)->describe().ends_with("24 V PMSM with 3 pole pairs"));
}

void TestMcpDriveBoards::sensorSpeedsReadRightOnEveryVersion_data()
{
    QTest::addColumn<QString>("profile");
    for (const char *name : {"mcsdk-6.0", "mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.3", "mcsdk-6.4"})
        QTest::addRow("%s", name) << name;
}

void TestMcpDriveBoards::sensorSpeedsReadRightOnEveryVersion()
{
    QFETCH(QString, profile);
    Session session(true, boardLike(profile.toUtf8().constData()));
    QVERIFY(session.runAt(1500));
    session.runFor(1s);
    const RegisterId id = session.id("STOPLL_ROT_SPEED");
    const WishId read = session.submit(Read{{id}});
    QVERIFY(session.runUntilEnded(read));
    const auto digits = std::get<std::int64_t>(session.values.at(id).value);
    const auto scale = session.identified->catalog->readScale(id);
    QCOMPARE(scale.unit, std::string("rpm"));
    QVERIFY(std::abs(static_cast<double>(digits) * scale.factor - 1500.0) < 40.0);
    QVERIFY(std::abs(session.identified->catalog->readScale(session.id("I_A")).factor
                - 60.175056458 / 32768.0)
        < 1e-8);
}

void TestMcpDriveBoards::theMainSensorsSpeedIsToldWhereItIsStreamed()
{
    for (const simulation::Preset &preset : simulation::presets()) {
        simulation::BoardOptions options = boardLike("mcsdk-6.4");
        options.motor = preset.name;
        Session session(true, options);
        QVERIFY(session.ready);
        const auto &named = session.identified->identity.speedSignals;
        QCOMPARE(named.size(), std::size_t{1});
        const simulation::SpeedSensor sensor = simulation::buildOf(options).mainSensor;
        QCOMPARE(named[0],
            std::string(sensor == simulation::SpeedSensor::Encoder      ? "ENCODER_SPEED"
                    : sensor == simulation::SpeedSensor::Hall           ? "HALL_SPEED"
                    : sensor == simulation::SpeedSensor::ObserverCordic ? "STOCORDIC_ROT_SPEED"
                                                                        : "STOPLL_ROT_SPEED"));
        // It is there, and the board streams it.
        const WishId stream = session.submit(Stream{{session.id(named[0].c_str())}, 1, {}, 1});
        QVERIFY(session.runUntilEnded(stream));
        QVERIFY(session.outcome(stream) == Outcome::Ok);
    }
    Session sixStep(true, boardLike("six-step"));
    QVERIFY(sixStep.ready);
    QCOMPARE(sixStep.identified->identity.speedSignals, std::vector<std::string>{""});
}

void TestMcpDriveBoards::twoMotorsAreTwo()
{
    Session session(true, boardLike("mcsdk-6.4", 2));
    QVERIFY(session.ready);
    const RegisterId first = session.id("SPEED_KD@1"), second = session.id("SPEED_KD@2");
    QVERIFY(first != second && second != 0);
    const WishId write = session.submit(Write{{{second, std::int64_t(1234)}}});
    QVERIFY(session.runUntilEnded(write));
    QVERIFY(session.outcome(write) == Outcome::Ok);
    const WishId read = session.submit(Read{{first, second}});
    QVERIFY(session.runUntilEnded(read));
    QCOMPARE(std::get<std::int64_t>(session.values.at(second).value), std::int64_t(1234));
    QVERIFY(std::get<std::int64_t>(session.values.at(first).value) != 1234);

    const WishId start = session.submit(Command{MotorAction::Start, 2});
    QVERIFY(session.runUntilEnded(start));
    QVERIFY(
        session.runUntil([&] { return session.status.at(2).state == MotorState::Running; }, 5s));
    QVERIFY(session.status.at(1).state == MotorState::Idle);
    const WishId ramp = session.submit(SpeedRamp{2, 900, 500ms});
    QVERIFY(session.runUntilEnded(ramp));
    session.runFor(3s);
    QVERIFY(std::abs(session.status.at(2).speedRpm.value_or(0.0) - 900.0) < 40.0);
    QCOMPARE(session.status.at(1).speedRpm.value_or(1.0), 0.0);
}

void TestMcpDriveBoards::bothMotorsOfAStreamShareItsTicks()
{
    Session session(true, boardLike("mcsdk-6.4", 2));
    QVERIFY(session.runAt(1500));
    QCOMPARE(session.identified->streaming.tickHz, 32000.0);
    Recorder recorder(session);
    const WishId stream = session.submit(
        Stream{{session.id("STOPLL_ROT_SPEED@1"), session.id("STOPLL_ROT_SPEED@2")}, 2, {}, 1});
    QVERIFY(session.runUntilEnded(stream));
    QVERIFY(session.outcome(stream) == Outcome::Ok);
    const TimePoint from = session.now;
    session.runFor(1s);
    QCOMPARE(recorder.samples.size(), std::size_t(2));
    QVERIFY(std::abs(mean(recorder.samples[0]) - 1500.0) < 60.0);
    QCOMPARE(mean(recorder.samples[1]), 0.0);
    QCOMPARE(recorder.lost, capture::Tick(0));
    const double seconds = std::chrono::duration<double>(session.now - from).count();
    QVERIFY(std::abs(static_cast<double>(recorder.samples[0].size()) / seconds - 16000.0) < 1000.0);
}

void TestMcpDriveBoards::sixStepHasNoScopeAndNoTorque()
{
    Session session(true, boardLike("six-step"));
    QVERIFY(session.ready);
    QVERIFY(!offers(session, Feature::Stream));
    QVERIFY(!offers(session, Feature::TorqueRamp));
    QVERIFY(offers(session, Feature::SpeedRamp));
    QCOMPARE(session.identified->streaming.maxSignals, 0U);
    QVERIFY(session.runAt(1200));
    const WishId stream = session.submit(Stream{{session.id("I_Q_MEAS")}, 1, {}, 1});
    QVERIFY(session.runUntilEnded(stream));
    QVERIFY(session.outcome(stream) != Outcome::Ok);
    const RegisterId iq = session.id("I_Q_MEAS");
    const WishId read = session.submit(Read{{iq, session.id("BUS_VOLTAGE")}});
    QVERIFY(session.runUntilEnded(read));
    QVERIFY(session.values.at(iq).status == ReadStatus::NotSupported);
    const auto bus = std::get<std::int64_t>(session.values.at(session.id("BUS_VOLTAGE")).value);
    QVERIFY(bus >= 22 && bus <= 25);
}

void TestMcpDriveBoards::hsoValuesCarryTheirUnits()
{
    Session session(true, boardLike("hso"));
    QVERIFY(session.ready);
    QVERIFY(session.identified->identity.knownFirmware);
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.runUntilEnded(start));
    QVERIFY(session.runUntilState(MotorState::Running));
    session.runFor(1s);
    const auto shown = [&](const char *name) {
        const RegisterId id = session.id(name);
        const WishId read = session.submit(Read{{id}});
        session.runUntilEnded(read);
        const Value &value = session.values.at(id).value;
        const double number = std::holds_alternative<double>(value)
            ? std::get<double>(value)
            : static_cast<double>(std::get<std::int64_t>(value));
        return number * session.identified->catalog->readScale(id).factor;
    };
    QVERIFY(std::abs(shown("MECHANICAL_SPEED_RPM") - 1500.0) < 40.0);
    QVERIFY(std::abs(shown("FOC_FELEC_HZ") - 100.0) < 3.0);
    QVERIFY(std::abs(shown("FOC_SPEEDREF_FREQ_PU") - 100.0) < 1.0);
    QVERIFY(std::abs(shown("ADC_U_DC") - 24.0) < 1.5);
    QVERIFY(std::abs(shown("FOC_RS_RATED") - 0.35) < 1e-3);
    QCOMPARE(shown("MOTOR_POLEPAIRS"), 4.0);
    QVERIFY(shown("I_Q") > 0.2 && shown("I_Q") < 5.0);
}

void TestMcpDriveBoards::hsoStreamsTheUpperHalf()
{
    Session session(true, boardLike("hso"));
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.runUntilEnded(start));
    QVERIFY(session.runUntilState(MotorState::Running));
    session.runFor(1s);
    Recorder recorder(session);
    const WishId stream = session.submit(Stream{
        {session.id("ADC_I_U"), session.id("FE_HSO"), session.id("FOC_ANGLE_PU")}, 1, {}, 1});
    QVERIFY(session.runUntilEnded(stream));
    QVERIFY(session.outcome(stream) == Outcome::Ok);
    session.runFor(1s);
    QCOMPARE(recorder.samples.size(), std::size_t(3));
    QCOMPARE(recorder.layout.fast[1].unit, std::string("Hz"));
    QVERIFY(std::abs(mean(recorder.samples[1]) - 100.0) < 3.0);
    QVERIFY(greatest(recorder.samples[0]) > 0.2 && greatest(recorder.samples[0]) < 5.0);
    QVERIFY(greatest(recorder.samples[2]) > 170.0 && greatest(recorder.samples[2]) <= 180.0);
    QCOMPARE(recorder.lost, capture::Tick(0));
}

QTEST_APPLESS_MAIN(TestMcpDriveBoards)
#include "tst_mcp_drive_boards.moc"
