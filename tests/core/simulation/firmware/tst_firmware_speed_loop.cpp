// The speed loop against the symmetrical optimum: how far a hard step of the reference overshoots for a given damping
// factor. The loop's lag is what counts, and with the encoder it is known: half of its window of 8 ms, half a period of
// the 1 kHz task, the current loop and one and a half control periods. Source: features 6.3, its table.
#include "support/axis_bench.h"

#include <QTest>

#include <cmath>

using namespace simulation;

namespace {

/// What the table assumes: nothing brakes but dry friction, currents have room.
PlantParameters ideal()
{
    PlantParameters p = presets().front().parameters;
    p.motor.viscous_nms = 0.0;
    p.sensors.encoderPulses = 8192; // fine enough to show what the loop does
    return p;
}

Build withEncoder()
{
    Build build;
    build.mainSensor = SpeedSensor::Encoder;
    build.encoder = true;
    return build;
}

double mean_rpm(support::AxisBench &bench)
{
    constexpr int kMs = 200;
    double sum = 0.0;
    for (int i = 0; i < kMs; ++i) {
        bench.ms(1);
        sum += bench.speed_rpm();
    }
    return sum / kMs;
}

/// In percent of the step; a negative number if the motor does not run.
double overshoot(double damping)
{
    const PlantParameters plant = ideal();
    DriveDesign design = support::usualDesign(plant, support::AxisBench::kHf_hz);
    const Pi::Gains gains =
        speedGains({.inertia_kgm2 = plant.motor.inertia_kgm2,
                       .torqueConstant_nmPerA = 1.5 * plant.motor.polePairs * plant.motor.flux_wb,
                       .filter_s = 0.5 * design.encoder.depth / 1000.0,
                       .damping = damping},
            sensingOf(plant));
    design.tuning.speedKp = gains.kp;
    design.tuning.speedKi = gains.ki;
    design.tuning.speedKpDiv = static_cast<std::int16_t>(gains.kpShift);
    design.tuning.speedKiDiv = static_cast<std::int16_t>(gains.kiShift);
    design.currentLimit = 10000;
    design.protection.trip_digits = 30000;
    support::AxisBench bench(plant, withEncoder(), design);
    if (!bench.runs())
        return -1.0;
    bench.ms(2500);
    const double before = mean_rpm(bench);
    bench.firmware.rampSpeed({2100, 0});
    double top = 0.0;
    for (int i = 0; i < 1500; ++i) {
        bench.ms(1);
        top = std::max(top, bench.speed_rpm());
    }
    bench.ms(1000);
    const double after = mean_rpm(bench);
    return bench.firmware.state() == MotorState::Run ? 100.0 * (top - after) / (after - before)
                                                     : -2.0;
}

} // namespace

class TestFirmwareSpeedLoop : public QObject {
    Q_OBJECT

private slots:
    void aStepOvershootsAsTheSymmetricalOptimumSays_data();
    void aStepOvershootsAsTheSymmetricalOptimumSays();
    void aRampDoesNotOvershoot();
    void aLoadStepIsMadeGood();
    void tooMuchGainShakes();
};

void TestFirmwareSpeedLoop::aStepOvershootsAsTheSymmetricalOptimumSays_data()
{
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("expected");
    QTest::newRow("2.41") << 2.41 << 34.0;
    QTest::newRow("3") << 3.0 << 25.0;
    QTest::newRow("4") << 4.0 << 17.0;
    QTest::newRow("6") << 6.0 << 11.0;
}

void TestFirmwareSpeedLoop::aStepOvershootsAsTheSymmetricalOptimumSays()
{
    QFETCH(double, damping);
    QFETCH(double, expected);
    const double seen = overshoot(damping);
    QVERIFY2(std::abs(seen - expected) < 3.0, qPrintable(QString::number(seen)));
}

void TestFirmwareSpeedLoop::aRampDoesNotOvershoot()
{
    support::AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(1500);
    bench.firmware.rampSpeed({3000, 1000});
    double top = 0.0;
    for (int i = 0; i < 2000; ++i) {
        bench.ms(1);
        top = std::max(top, bench.speed_rpm());
    }
    QVERIFY2(top < 3060.0, qPrintable(QString::number(top)));
    QVERIFY(std::abs(bench.speed_rpm() - 3000.0) < 12.0);
}

void TestFirmwareSpeedLoop::aLoadStepIsMadeGood()
{
    support::AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(1500);
    bench.axis.plant.setLoadTorque(0.08);
    double least = 1e9;
    for (int i = 0; i < 1000; ++i) {
        bench.ms(1);
        least = std::min(least, bench.speed_rpm());
    }
    QVERIFY2(least > 1200.0 && least < 1450.0, qPrintable(QString::number(least)));
    QVERIFY(std::abs(bench.speed_rpm() - 1500.0) < 12.0);
    const double kt = 1.5 * 4 * 6.5e-3; // the current carries load and friction
    const double wanted_a = (0.08 + 0.025 + 1.2e-4 * bench.axis.plant.speed_radps()) / kt;
    QVERIFY(std::abs(bench.axis.plant.iq_a() - wanted_a) < 0.1 * wanted_a);
}

void TestFirmwareSpeedLoop::tooMuchGainShakes()
{
    support::AxisBench bench;
    QVERIFY(bench.runs());
    bench.ms(1500);
    bench.firmware.tuning().speedKpDiv = 6; // eight times the gain
    double least = 1e9, most = 0.0;
    for (int i = 0; i < 500 && bench.firmware.state() == MotorState::Run; ++i) {
        bench.ms(1);
        least = std::min(least, bench.speed_rpm());
        most = std::max(most, bench.speed_rpm());
    }
    QVERIFY2(most - least > 100.0 || bench.firmware.faultFlags() != 0,
        qPrintable(QString::number(most - least)));
}

QTEST_APPLESS_MAIN(TestFirmwareSpeedLoop)
#include "tst_firmware_speed_loop.moc"
