// Starts from any angle, on every motor; what the observer makes of the rotor then; and rev-ups that must fail.
// Source: features 6.5 and 6.8.
#include "simulation/firmware/build.h"
#include "support/axis_bench.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace simulation;

namespace {

constexpr int kAngles = 50;
constexpr double kHalfTurn = 32768.0;

Build buildOf(std::string_view preset) { return buildFor("mcsdk-6.4", preset); }

const PlantParameters &plantOf(std::string_view preset) { return *findPreset(preset); }

std::int16_t angleOf(const Build &build, const Signals &s)
{
    switch (build.mainSensor) {
    case SpeedSensor::Encoder:
        return s.encoderAngle;
    case SpeedSensor::Hall:
        return s.hallAngle;
    case SpeedSensor::ObserverCordic:
        return s.cordicAngle;
    default:
        return s.pllAngle;
    }
}

/// Largest error of the angle that the loops used, in electrical degrees, over `ms`.
double worstAngle_deg(support::AxisBench &bench, const Build &build, int ms)
{
    double worst = 0.0;
    std::int16_t used = angleOf(build, bench.firmware.variables());
    const bool ahead = build.mainSensor == SpeedSensor::ObserverPll
        || build.mainSensor == SpeedSensor::ObserverCordic; // computed for the next period
    for (int i = 0; i < ms; ++i) {
        bench.firmware.mfTask();
        for (int k = 0; k < support::AxisBench::kHfPerMs; ++k) {
            bench.axis.hfTask();
            const std::int16_t now = angleOf(build, bench.firmware.variables());
            const double angle = (ahead ? used : now) * 180.0 / kHalfTurn;
            const double truth = bench.axis.plant.angle_rad() * 180.0 / std::numbers::pi;
            worst = std::max(worst, std::abs(std::remainder(angle - truth, 360.0)));
            used = now;
        }
    }
    return worst;
}

/// Started, it ends in a fault, in Run or not at all.
std::uint32_t faultsOfStart(support::AxisBench &bench)
{
    bench.ms(20);
    bench.firmware.start();
    for (int i = 0; i < 4000 && bench.firmware.faultFlags() == 0; ++i)
        bench.ms(1);
    bench.ms(5);
    return bench.firmware.faultFlags();
}

constexpr std::uint32_t kStartUp = 0x0010, kFeedbackFault = 0x0020;

bool isFailedStart(std::uint32_t faults) { return faults == kStartUp || faults == kFeedbackFault; }

std::vector<std::string> names()
{
    std::vector<std::string> all;
    for (const Preset &preset : presets())
        all.emplace_back(preset.name);
    return all;
}

} // namespace

class TestFirmwareStartup : public QObject {
    Q_OBJECT

private slots:
    void everyMotorStartsFromFiftyAngles_data();
    void everyMotorStartsFromFiftyAngles();
    void backwardsToo_data() { everyMotorStartsFromFiftyAngles_data(); }
    void backwardsToo();
    void theAngleIsWithinFiveDegreesAtHalfSpeed_data() { everyMotorStartsFromFiftyAngles_data(); }
    void theAngleIsWithinFiveDegreesAtHalfSpeed();
    void theSwitchOverTakesItsTime();
    void anEncoderIsAlignedOnce();
    void tooLittleCurrentFailsToStart();
    void tooFastARevUpFailsToStart();
    void withoutAMotorThatTurnsItFailsToStart();
    void aRevUpBelowTheMinimumSpeedFails();
    void openLoopTurnsTheFieldAsTold();
};

void TestFirmwareStartup::everyMotorStartsFromFiftyAngles_data()
{
    QTest::addColumn<std::string>("preset");
    for (const std::string &name : names())
        QTest::newRow(name.c_str()) << name;
}

void TestFirmwareStartup::everyMotorStartsFromFiftyAngles()
{
    QFETCH(std::string, preset);
    const Build build = buildOf(preset);
    std::set<int> sectors;
    for (std::uint64_t seed = 1; seed <= kAngles; ++seed) {
        support::AxisBench bench(plantOf(preset), build, seed);
        const double from_rad = bench.axis.plant.angle_rad();
        sectors.insert(static_cast<int>(from_rad / std::numbers::pi * 4.0));
        const std::string what = preset + ", seed " + std::to_string(seed) + " from "
            + std::to_string(from_rad * 180.0 / std::numbers::pi);
        QVERIFY2(bench.runs(), what.c_str());
        bench.ms(700);
        QVERIFY2(bench.firmware.state() == MotorState::Run, what.c_str());
        const double wanted_rpm = bench.firmware.speedReference_rpm();
        QVERIFY2(std::abs(bench.speed_rpm() - wanted_rpm) < 0.03 * wanted_rpm,
            (what + ": " + std::to_string(bench.speed_rpm())).c_str());
    }
    QVERIFY(sectors.size() >= 6); // the angles were random, as far as cogs let them
}

void TestFirmwareStartup::backwardsToo()
{
    QFETCH(std::string, preset);
    for (std::uint64_t seed = 100; seed < 110; ++seed) {
        support::AxisBench bench(plantOf(preset), buildOf(preset), seed);
        bench.firmware.rampSpeed(
            {static_cast<std::int16_t>(-bench.firmware.design().defaultSpeed_rpm), 200});
        QVERIFY2(bench.runs(), std::to_string(seed).c_str());
        bench.ms(1200);
        const double wanted_rpm = bench.firmware.speedReference_rpm();
        QVERIFY(wanted_rpm < 0.0);
        QVERIFY2(std::abs(bench.speed_rpm() - wanted_rpm) < -0.02 * wanted_rpm,
            std::to_string(bench.speed_rpm()).c_str());
    }
}

void TestFirmwareStartup::theAngleIsWithinFiveDegreesAtHalfSpeed()
{
    QFETCH(std::string, preset);
    const Build build = buildOf(preset);
    support::AxisBench bench(plantOf(preset), build);
    QVERIFY(bench.runs());
    const auto half = static_cast<std::int16_t>(bench.firmware.stage().maxSpeed_rpm / 2);
    bench.firmware.rampSpeed({half, 1000});
    bench.ms(2500);
    QVERIFY(std::abs(bench.speed_rpm() - half) < 0.02 * half);
    const double worst = worstAngle_deg(bench, build, 500);
    QVERIFY2(worst < 5.0, std::to_string(worst).c_str());
}

void TestFirmwareStartup::theSwitchOverTakesItsTime()
{
    support::AxisBench bench;
    QVERIFY(bench.firmware.start());
    QVERIFY(bench.reaches(MotorState::SwitchOver, 1000));
    int ticks = 0;
    std::int16_t before = bench.firmware.variables().openLoopAngle;
    while (bench.firmware.state() == MotorState::SwitchOver && ticks < 100) {
        bench.ms(1);
        ++ticks;
        const auto turned = static_cast<std::int16_t>(
            static_cast<std::uint16_t>(bench.firmware.variables().openLoopAngle - before));
        QVERIFY2(turned > 0 && turned < 16384, "the angle blends, it does not jump");
        before = bench.firmware.variables().openLoopAngle;
    }
    QVERIFY2(ticks >= 25 && ticks <= 27, std::to_string(ticks).c_str());
    QCOMPARE(bench.firmware.state(), MotorState::Run);
}

void TestFirmwareStartup::anEncoderIsAlignedOnce()
{
    support::AxisBench bench(plantOf("servo24"), buildOf("servo24"));
    QVERIFY(bench.firmware.start());
    QVERIFY(bench.reaches(MotorState::Alignment, 100));
    QVERIFY(bench.reaches(MotorState::Run, 1000));
    bench.ms(300);
    bench.firmware.stop();
    QVERIFY(bench.reaches(MotorState::Idle, 600));
    QVERIFY(bench.firmware.start());
    bool aligned = false;
    for (int i = 0; i < 200 && bench.firmware.state() != MotorState::Run; ++i) {
        bench.ms(1);
        aligned |= bench.firmware.state() == MotorState::Alignment;
    }
    QVERIFY(!aligned);
    QCOMPARE(bench.firmware.state(), MotorState::Run);
}

void TestFirmwareStartup::tooLittleCurrentFailsToStart()
{
    support::AxisBench bench;
    auto stages = bench.firmware.revUp();
    for (std::size_t i = 0; i < stages.size(); ++i) {
        stages[i].torque = 300; // 0.55 A are less torque than the friction takes
        bench.firmware.setRevUpStage(i, stages[i]);
    }
    QVERIFY(isFailedStart(faultsOfStart(bench)));
    QCOMPARE(bench.firmware.state(), MotorState::FaultOver);
}

void TestFirmwareStartup::tooFastARevUpFailsToStart()
{
    support::AxisBench bench;
    auto stages = bench.firmware.revUp();
    stages[2].ms = 30; // 1200 rpm within 30 ms are twice what 2.5 A can do
    stages[3].ms = 300;
    for (std::size_t i = 0; i < stages.size(); ++i)
        bench.firmware.setRevUpStage(i, stages[i]);
    QVERIFY(isFailedStart(faultsOfStart(bench)));
    QCOMPARE(bench.firmware.state(), MotorState::FaultOver);
}

void TestFirmwareStartup::withoutAMotorThatTurnsItFailsToStart()
{
    support::AxisBench bench;
    bench.axis.plant.setLoadTorque(1.0); // held
    QVERIFY(isFailedStart(faultsOfStart(bench)));
    // and when it is let go, the same firmware starts it
    bench.axis.plant.setLoadTorque(0.0);
    bench.ms(500);
    bench.firmware.acknowledgeFaults();
    QCOMPARE(bench.firmware.state(), MotorState::Idle);
    QVERIFY(bench.runs());
}

void TestFirmwareStartup::aRevUpBelowTheMinimumSpeedFails()
{
    support::AxisBench bench; // the observer is believed from 600 rpm on
    auto stages = bench.firmware.revUp();
    stages[1].rpm = stages[2].rpm = stages[3].rpm = stages[4].rpm = 480;
    for (std::size_t i = 0; i < stages.size(); ++i)
        bench.firmware.setRevUpStage(i, stages[i]);
    QCOMPARE(faultsOfStart(bench), kStartUp);
}

void TestFirmwareStartup::openLoopTurnsTheFieldAsTold()
{
    for (const std::uint8_t mode : {std::uint8_t{1}, std::uint8_t{2}}) {
        Build build;
        build.openLoopDebug = true;
        support::AxisBench bench(plantOf("pm24"), build);
        bench.firmware.tuning().openLoopVq = 12; // percent: 1.6 V, enough for 300 rpm
        bench.firmware.setControlMode(mode);
        bench.firmware.rampSpeed({300, 0});
        bench.firmware.setControlMode(mode); // a speed ramp asks for speed mode
        QVERIFY(bench.runs());
        bench.ms(2500);
        QCOMPARE(bench.firmware.state(), MotorState::Run);
        QCOMPARE(bench.firmware.controlMode(), mode);
        double sum = 0.0;
        for (int i = 0; i < 500; ++i) {
            bench.ms(1);
            sum += bench.speed_rpm() / 500.0;
        }
        QVERIFY2(std::abs(sum - 300.0) < 15.0, std::to_string(sum).c_str());
    }
}

QTEST_APPLESS_MAIN(TestFirmwareStartup)
#include "tst_firmware_startup.moc"
