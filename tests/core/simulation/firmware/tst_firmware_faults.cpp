// Faults that come from physics, and what follows: hard braking, overload, gains and thresholds that are wrong, heat;
// bits that are present and bits that have occurred. Source: mcp-aspep section 7, features 6.8.
#include "support/axis_bench.h"

#include <QTest>

#include <cmath>

using namespace simulation;

namespace {

using support::AxisBench;

constexpr std::uint32_t kOverVoltage = 0x0002, kUnderVoltage = 0x0004, kOverTemperature = 0x0008,
                        kSpeedFeedback = 0x0020, kOverCurrent = 0x0040;

const PlantParameters &pm24() { return presets().front().parameters; }

bool trips(AxisBench &bench, int mostMs)
{
    for (int i = 0; i < mostMs && bench.firmware.faultFlags() == 0; ++i)
        bench.ms(1);
    return bench.firmware.faultFlags() != 0;
}

/// The way back: nothing turns, nothing is present, an acknowledgement and a start.
bool recovers(AxisBench &bench)
{
    bench.ms(1500);
    if (bench.firmware.state() != MotorState::FaultOver || bench.speed_rpm() != 0.0)
        return false;
    bench.firmware.acknowledgeFaults();
    return bench.firmware.state() == MotorState::Idle && bench.firmware.faultFlags() == 0
        && bench.runs();
}

} // namespace

class TestFirmwareFaults : public QObject {
    Q_OBJECT

private slots:
    void hardBrakingRaisesTheBusUntilItTrips();
    void aSupplyThatTakesItBackDoesNotTrip();
    void softBrakingDoesNotTrip();
    void overloadStallsIntoAFault();
    void aShortenedCurrentLoopTripsOrShakes();
    void overCurrentSwitchesOffWithinAPeriod();
    void undervoltageStopsIt();
    void heatStopsIt();
    void presentAndOccurredAreTwoThings();
    void stopComesToRest();
    void reversingWithoutSensorLosesTheRotor();
    void aRestartWhileItTurnsSwitchesOff();
};

void TestFirmwareFaults::hardBrakingRaisesTheBusUntilItTrips()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.firmware.rampSpeed({3600, 1000});
    bench.ms(2000);
    bench.firmware.rampSpeed({600, 0});
    QVERIFY(trips(bench, 500));
    QCOMPARE(bench.firmware.faultFlags() & 0xFFFFU, kOverVoltage);
    QVERIFY(bench.axis.plant.trueBus_v() > 29.0);
    QVERIFY(bench.firmware.variables().busVoltage_v >= 29);
    QVERIFY(recovers(bench));
}

void TestFirmwareFaults::aSupplyThatTakesItBackDoesNotTrip()
{
    PlantParameters plant = pm24();
    plant.inverter.supplyAbsorbs = true;
    AxisBench bench(plant);
    QVERIFY(bench.runs());
    bench.firmware.rampSpeed({3600, 1000});
    bench.ms(2000);
    bench.firmware.rampSpeed({900, 0});
    QVERIFY(!trips(bench, 1000));
    QVERIFY(std::abs(bench.speed_rpm() - 900.0) < 20.0);
}

void TestFirmwareFaults::softBrakingDoesNotTrip()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.firmware.rampSpeed({3600, 1000});
    bench.ms(2000);
    bench.firmware.rampSpeed({900, 1000});
    QVERIFY(!trips(bench, 2000));
    QVERIFY(std::abs(bench.speed_rpm() - 900.0) < 20.0);
}

void TestFirmwareFaults::overloadStallsIntoAFault()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(1000);
    bench.axis.plant.setLoadTorque(0.3); // 5 A make 0.195 N m
    QVERIFY(trips(bench, 1000));
    QVERIFY((bench.firmware.faultFlags() & (kSpeedFeedback | kOverCurrent)) != 0);
    bench.axis.plant.setLoadTorque(0.0);
    QVERIFY(recovers(bench));
}

void TestFirmwareFaults::aShortenedCurrentLoopTripsOrShakes()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(1000);
    bench.firmware.tuning().qKpDiv = bench.firmware.tuning().dKpDiv = 5; // 32 times the gain
    double most_a = 0.0;
    for (int i = 0; i < 300; ++i) {
        bench.ms(1);
        most_a = std::max(most_a, std::abs(bench.axis.plant.iq_a()));
    }
    QVERIFY2(bench.firmware.faultFlags() != 0 || most_a > 2.5, std::to_string(most_a).c_str());
}

void TestFirmwareFaults::overCurrentSwitchesOffWithinAPeriod()
{
    DriveDesign design = support::usualDesign(pm24(), AxisBench::kHf_hz);
    design.currentLimit = 20000; // the project's own limit is no help
    AxisBench bench(pm24(), Build{}, design);
    QVERIFY(bench.runs());
    bench.ms(1000);
    bench.firmware.rampTorque({15000, 0}); // 27 A, tripped at 15
    bool off = false;
    double most_a = 0.0;
    for (int k = 0; k < 160 && !off; ++k) {
        if (k % 16 == 0)
            bench.firmware.mfTask();
        bench.axis.hfTask();
        const auto phases = bench.axis.plant.phases_a();
        most_a = std::max({most_a, std::abs(phases.a), std::abs(phases.b), std::abs(phases.c)});
        off = (bench.firmware.faultFlags() >> 16 & kOverCurrent) != 0;
    }
    QVERIFY(off);
    QVERIFY2(most_a > 14.5 && most_a < 20.0, std::to_string(most_a).c_str());
    bench.ms(3);
    QCOMPARE(bench.firmware.state(), MotorState::FaultOver);
    QCOMPARE(bench.firmware.faultFlags(), kOverCurrent); // it is gone, and has occurred
}

void TestFirmwareFaults::undervoltageStopsIt()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(500);
    bench.firmware.tuning().underVoltage_v = 26;
    QVERIFY(trips(bench, 5));
    QCOMPARE(bench.firmware.faultFlags(), kUnderVoltage << 16 | kUnderVoltage);
    QCOMPARE(bench.firmware.state(), MotorState::FaultNow);
    bench.firmware.tuning().underVoltage_v = 12;
    QVERIFY(recovers(bench));
}

void TestFirmwareFaults::heatStopsIt()
{
    PlantParameters plant = pm24();
    plant.inverter.ambient_c = 105.0;
    plant.inverter.heatsinkResistance_kpw = 200.0;
    plant.inverter.heatsinkCapacity_jpk = 0.02;
    AxisBench bench(plant);
    QVERIFY(bench.runs());
    bench.axis.plant.setLoadTorque(0.1);
    QVERIFY(trips(bench, 60000));
    QCOMPARE(bench.firmware.faultFlags() & 0xFFFFU, kOverTemperature);
    QVERIFY(bench.firmware.variables().temperature_c >= 109);
}

void TestFirmwareFaults::presentAndOccurredAreTwoThings()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.firmware.setPresentFaults(0x0400);
    bench.ms(1);
    QCOMPARE(bench.firmware.faultFlags(), 0x04000400U);
    QCOMPARE(bench.firmware.state(), MotorState::FaultNow);
    bench.ms(50);
    bench.firmware.acknowledgeFaults();
    QCOMPARE(bench.firmware.state(), MotorState::FaultNow);
    bench.firmware.setPresentFaults(0);
    bench.ms(2);
    QCOMPARE(bench.firmware.faultFlags(), 0x00000400U);
    QCOMPARE(bench.firmware.state(), MotorState::FaultOver);
    QVERIFY(!bench.firmware.start());
    QVERIFY(recovers(bench));
}

void TestFirmwareFaults::stopComesToRest()
{
    for (const Preset &preset : presets()) {
        AxisBench bench(preset.parameters, buildFor("mcsdk-6.4", preset.name));
        QVERIFY2(bench.runs(), preset.name.data());
        bench.ms(500);
        bench.firmware.stop();
        QCOMPARE(bench.firmware.state(), MotorState::Stop);
        bench.ms(402);
        QCOMPARE(bench.firmware.state(), MotorState::Idle);
        bench.ms(5000);
        QVERIFY2(bench.axis.plant.atRest(), preset.name.data());
        QCOMPARE(bench.firmware.speed_rpm(), 0);
        QVERIFY2(bench.runs(),
            (std::string(preset.name) + " " + std::to_string(bench.firmware.faultFlags())).c_str());
    }
}

void TestFirmwareFaults::reversingWithoutSensorLosesTheRotor()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(500);
    bench.firmware.rampSpeed({-1500, 1000});
    QVERIFY(trips(bench, 2000));
    QCOMPARE(bench.firmware.faultFlags() & 0xFFFFU, kSpeedFeedback);
    AxisBench sensed(*findPreset("servo24"), buildFor("mcsdk-6.4", "servo24"));
    QVERIFY(sensed.runs());
    sensed.ms(500);
    sensed.firmware.rampSpeed({-1200, 1000});
    QVERIFY(!trips(sensed, 2500));
    QVERIFY(std::abs(sensed.speed_rpm() + 1200.0) < 20.0);
}

void TestFirmwareFaults::aRestartWhileItTurnsSwitchesOff()
{
    AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(500);
    bench.firmware.restart();
    QCOMPARE(bench.firmware.state(), MotorState::Idle);
    QCOMPARE(bench.firmware.faultFlags(), 0U);
    QVERIFY(bench.speed_rpm() > 1000.0);
    bench.ms(1500);
    QVERIFY(bench.axis.plant.atRest());
    QVERIFY(bench.runs());
}

QTEST_APPLESS_MAIN(TestFirmwareFaults)
#include "tst_firmware_faults.moc"
