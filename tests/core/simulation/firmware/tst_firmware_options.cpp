// What a build may have besides: flux weakening, feed-forward, the other observer, torque mode; and other control
// rates.
#include "support/axis_bench.h"

#include <QTest>

#include <cmath>

using namespace simulation;

namespace {

using support::AxisBench;

const PlantParameters &ipm48() { return *findPreset("ipm48"); }

/// Mean of a variable over 200 ms.
template <typename Value>
double mean(AxisBench &bench, Value value)
{
    double sum = 0.0;
    for (int i = 0; i < 200; ++i) {
        bench.ms(1);
        sum += value(bench.firmware.variables()) / 200.0;
    }
    return sum;
}

} // namespace

class TestFirmwareOptions : public QObject {
    Q_OBJECT

private slots:
    void fluxWeakeningReachesSpeedsThatTheBusDoesNot();
    void feedForwardLeavesLittleToTheLoops();
    void theCordicObserverRunsTheMotorToo();
    void twoObserversAgree();
    void aPositionIsReachedInItsTime();
    void torqueModeFromTheStart();
    void otherControlRatesWork_data();
    void otherControlRatesWork();
    void writtenThresholdsAndGainsActAtOnce();
    void theSameSeedGivesTheSameMotor();
};

void TestFirmwareOptions::fluxWeakeningReachesSpeedsThatTheBusDoesNot()
{
    const auto speedReached = [](bool weakening, double &id_a) {
        Build build;
        build.fluxWeakening = weakening;
        AxisBench bench(ipm48(), build);
        if (!bench.runs())
            return -1.0;
        bench.firmware.rampSpeed({5000, 1500});
        bench.ms(3000);
        id_a = bench.axis.plant.id_a();
        return bench.speed_rpm();
    };
    double with_a = 0.0, without_a = 0.0;
    const double with = speedReached(true, with_a);
    QVERIFY2(std::abs(with - 5000.0) < 15.0, std::to_string(with).c_str());
    QVERIFY2(with_a < -4.0, std::to_string(with_a).c_str());
    const double without = speedReached(false, without_a);
    QVERIFY2(without < 4900.0, std::to_string(without).c_str());
    QVERIFY2(std::abs(without_a) < 3.0, std::to_string(without_a).c_str());
}

void TestFirmwareOptions::feedForwardLeavesLittleToTheLoops()
{
    Build build;
    build.feedForward = true;
    AxisBench bench(ipm48(), build);
    QVERIFY(bench.runs());
    bench.firmware.rampSpeed({3000, 1000});
    bench.ms(1500);
    bench.axis.plant.setLoadTorque(0.6);
    bench.ms(1000);
    const double q = mean(bench, [](const Signals &s) { return s.ffVq; });
    const double d = mean(bench, [](const Signals &s) { return s.ffVd; });
    const double restQ = mean(bench, [](const Signals &s) { return s.ffVqPi; });
    const double restD = mean(bench, [](const Signals &s) { return s.ffVdPi; });
    const double sum = mean(bench, [](const Signals &s) { return s.vQ; });
    QVERIFY(q > 18000.0 && d < -5000.0);
    QVERIFY2(std::abs(restQ) < 0.15 * q && std::abs(restD) < 0.15 * -d,
        (std::to_string(restQ) + " " + std::to_string(restD)).c_str());
    QVERIFY(std::abs(q + restQ - sum) < 0.02 * sum);
    bench.firmware.tuning().ff2 = bench.firmware.tuning().ff1D = 0; // from now on the loops do it
    bench.ms(500);
    QCOMPARE(bench.firmware.state(), MotorState::Run);
    QVERIFY(mean(bench, [](const Signals &s) { return s.ffVqPi; }) > 18000.0);
}

void TestFirmwareOptions::theCordicObserverRunsTheMotorToo()
{
    Build build;
    build.mainSensor = SpeedSensor::ObserverCordic;
    build.observerPll = false;
    build.observerCordic = true;
    int running = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        AxisBench bench(presets().front().parameters, build, seed);
        if (!bench.runs())
            continue;
        bench.ms(1000);
        running += std::abs(bench.speed_rpm() - 1500.0) < 30.0 ? 1 : 0;
        QCOMPARE(bench.firmware.variables().pllSpeed, std::int16_t{0}); // there is none
    }
    QCOMPARE(running, 10);
}

void TestFirmwareOptions::twoObserversAgree()
{
    Build build;
    build.observerCordic = true;
    AxisBench bench(presets().front().parameters, build);
    QVERIFY(bench.runs());
    bench.ms(1500);
    for (int i = 0; i < 200; ++i) {
        bench.ms(1);
        const Signals &s = bench.firmware.variables();
        const auto apart =
            static_cast<std::int16_t>(static_cast<std::uint16_t>(s.pllAngle - s.cordicAngle));
        QVERIFY2(std::abs(int{apart}) < 1500, std::to_string(apart).c_str()); // 8 degrees
    }
    const double apart = mean(bench, [](const Signals &s) { return s.pllSpeed - s.cordicSpeed; });
    QVERIFY2(std::abs(apart) < 2.0, std::to_string(apart).c_str());
}

void TestFirmwareOptions::aPositionIsReachedInItsTime()
{
    Build build = buildFor("mcsdk-6.4", "servo24");
    build.positionControl = true;
    AxisBench bench(*findPreset("servo24"), build);
    const Signals &s = bench.firmware.variables();
    QCOMPARE(s.alignState, std::uint8_t{0});
    bench.firmware.rampPosition({20.0F, 1.0F}); // kept until it runs
    QCOMPARE(bench.firmware.controlMode(), std::uint8_t{7});
    QVERIFY(bench.runs());
    QCOMPARE(s.alignState, std::uint8_t{2});
    bench.ms(500);
    QCOMPARE(s.positionState, std::uint8_t{1});
    QVERIFY2(std::abs(s.position_rad - 10.0F) < 1.0F, std::to_string(s.position_rad).c_str());
    bench.ms(700);
    QVERIFY2(std::abs(s.position_rad - 20.0F) < 0.05F, std::to_string(s.position_rad).c_str());
    QCOMPARE(s.positionState, std::uint8_t{2});
    bench.firmware.rampPosition({-5.0F, 1.0F});
    bench.ms(1300);
    QVERIFY2(std::abs(s.position_rad + 5.0F) < 0.05F, std::to_string(s.position_rad).c_str());
    bench.firmware.rampPosition({-4.0F, 0.0F});
    bench.ms(600);
    QCOMPARE(s.positionState, std::uint8_t{3});
    QVERIFY2(std::abs(s.position_rad + 4.0F) < 0.05F, std::to_string(s.position_rad).c_str());
    bench.firmware.rampSpeed({600, 200}); // and back to speed
    bench.ms(800);
    QVERIFY2(std::abs(bench.speed_rpm() - 600.0) < 12.0, std::to_string(bench.speed_rpm()).c_str());
    bench.firmware.stop();
    bench.ms(500);
    QCOMPARE(s.positionState, std::uint8_t{0});
}

void TestFirmwareOptions::torqueModeFromTheStart()
{
    AxisBench bench;
    bench.firmware.rampTorque({600, 0});
    QVERIFY(bench.runs());
    QCOMPARE(bench.firmware.controlMode(), std::uint8_t{4});
    bench.ms(20);
    const double current = mean(bench, [](const Signals &s) { return s.iQ; });
    QVERIFY2(std::abs(current - 600.0) < 15.0, std::to_string(current).c_str());
}

void TestFirmwareOptions::otherControlRatesWork_data()
{
    QTest::addColumn<int>("hertz");
    QTest::newRow("4 kHz") << 4000;
    QTest::newRow("8 kHz") << 8000;
    QTest::newRow("20 kHz") << 20000;
    QTest::newRow("30 kHz") << 30000;
}

void TestFirmwareOptions::otherControlRatesWork()
{
    QFETCH(int, hertz);
    const PlantParameters &plant = presets().front().parameters;
    Axis axis(plant, Build{}, hertz, 4);
    const auto ms = [&](int count) {
        for (int i = 0; i < count; ++i) {
            axis.firmware.mfTask();
            for (int k = 0; k < hertz / Firmware::kMfHz; ++k)
                axis.hfTask();
        }
    };
    ms(20);
    QVERIFY(axis.firmware.start());
    ms(2500);
    QCOMPARE(axis.firmware.state(), MotorState::Run);
    const double rpm = axis.plant.speed_radps() * support::kRpmPerRadps;
    QVERIFY2(std::abs(rpm - 1500.0) < 45.0, std::to_string(rpm).c_str());
}

void TestFirmwareOptions::writtenThresholdsAndGainsActAtOnce()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(1000);
    bench.firmware.tuning().speedKp = bench.firmware.tuning().speedKi = 0; // not driven
    bench.ms(600);
    QVERIFY(bench.speed_rpm() < 600.0);
    AxisBench other;
    QVERIFY(other.runs());
    other.firmware.tuning().overVoltage_v = 20;
    other.ms(2);
    QCOMPARE(other.firmware.faultFlags(), 0x00020002U);
}

void TestFirmwareOptions::theSameSeedGivesTheSameMotor()
{
    const auto trace = [](std::uint64_t seed) {
        AxisBench bench(presets().front().parameters, Build{}, seed);
        bench.firmware.start();
        std::vector<std::int16_t> seen;
        for (int i = 0; i < 600; ++i) {
            bench.ms(1);
            seen.push_back(bench.firmware.variables().iA);
            seen.push_back(bench.firmware.variables().pllAngle);
        }
        return seen;
    };
    QVERIFY(trace(3) == trace(3));
    QVERIFY(trace(3) != trace(4));
}

QTEST_APPLESS_MAIN(TestFirmwareOptions)
#include "tst_firmware_options.moc"
