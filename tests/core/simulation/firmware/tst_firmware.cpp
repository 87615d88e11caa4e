// The simulated motor control by itself: states, ramps, torque, nonsense gains.
#include "support/axis_bench.h"

#include <QTest>

#include <cmath>

using simulation::Firmware;
using simulation::MotorState;

namespace {

using Run = support::AxisBench;

/// Measured in steps of 6 rpm, which the loop holds to within one or two.
bool near(std::int32_t rpm, std::int32_t wanted) { return std::abs(rpm - wanted) <= 12; }

} // namespace

class TestFirmware : public QObject {
    Q_OBJECT

private slots:
    void startPassesThroughItsStates();
    void aRampTakesItsTime();
    void stopRampHoldsTheSpeed();
    void aNegativeTargetStartsBackwards();
    void torqueModeHoldsTheCurrent();
    void aRevUpThatEndsTooEarlyIsAFault();
    void nonsenseGainsLeaveNumbers();
    void stoppedItRestsWithinHalfASecond();
};

void TestFirmware::startPassesThroughItsStates()
{
    Run run;
    QVERIFY(run.firmware.start());
    std::vector<MotorState> seen;
    for (int i = 0; i < 1000 && run.firmware.state() != MotorState::Run; ++i) {
        if (seen.empty() || seen.back() != run.firmware.state())
            seen.push_back(run.firmware.state());
        run.ms(1);
    }
    QCOMPARE(seen,
        (std::vector{MotorState::ChargeBootCap, MotorState::OffsetCalib, MotorState::Start,
            MotorState::SwitchOver}));
    QCOMPARE(run.firmware.state(), MotorState::Run);
    QVERIFY(!run.firmware.start());
}

void TestFirmware::aRampTakesItsTime()
{
    Run run;
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::Run, 1000));
    run.ms(1000);
    QVERIFY(near(run.firmware.speed_rpm(), 1500));
    run.firmware.rampSpeed({3000, 500});
    run.ms(250);
    QVERIFY(std::abs(run.firmware.speedReference_rpm() - 2250) <= 12);
    run.ms(250);
    QCOMPARE(run.firmware.speedReference_rpm(), 3000);
    run.ms(400);
    QVERIFY(near(run.firmware.speed_rpm(), 3000));
    QVERIFY(run.firmware.power_w() > 10.0);
}

void TestFirmware::stopRampHoldsTheSpeed()
{
    Run run;
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::Run, 1000));
    run.ms(1000);
    run.firmware.rampSpeed({3000, 1000});
    run.ms(500);
    run.firmware.stopRamp();
    run.ms(1500);
    QVERIFY(std::abs(run.firmware.speed_rpm() - 2250) <= 12);
}

void TestFirmware::aNegativeTargetStartsBackwards()
{
    Run run;
    run.firmware.rampSpeed({-1200, 0});
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::Run, 1000));
    QVERIFY(run.firmware.speed_rpm() < -300);
    run.ms(1000);
    QVERIFY(near(run.firmware.speed_rpm(), -1200));
}

void TestFirmware::torqueModeHoldsTheCurrent()
{
    Run run;
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::Run, 1000));
    run.ms(500);
    run.firmware.rampTorque({700, 100});
    run.ms(150);
    double sum = 0.0;
    for (int i = 0; i < 50; ++i) {
        run.ms(1);
        sum += run.firmware.variables().iQ;
    }
    QVERIFY(std::abs(sum / 50.0 - 700.0) < 10.0);
    QCOMPARE(run.firmware.controlMode(), 4);
}

void TestFirmware::aRevUpThatEndsTooEarlyIsAFault()
{
    Run run;
    for (std::size_t i = 0; i < Firmware::kRevUpStages; ++i)
        run.firmware.setRevUpStage(i, {120, 1000, 20});
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::FaultOver, 1000));
    QCOMPARE(run.firmware.faultFlags(), 0x0010U);
    run.firmware.acknowledgeFaults();
    QCOMPARE(run.firmware.state(), MotorState::Idle);
}

void TestFirmware::nonsenseGainsLeaveNumbers()
{
    Run run;
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::Run, 1000));
    auto &tuning = run.firmware.tuning();
    const auto before = tuning;
    tuning.speedKp = tuning.qKp = 32767;
    tuning.speedKpDiv = tuning.qKpDiv = tuning.speedKiDiv = -32768;
    run.ms(300);
    QVERIFY(std::isfinite(run.axis.plant.iq_a()));
    tuning = before;
    run.ms(1500);
    if (run.firmware.state() == MotorState::FaultOver) { // it may well have tripped
        run.firmware.acknowledgeFaults();
        QVERIFY(run.runs());
        run.ms(1500);
    }
    QVERIFY(near(run.firmware.speed_rpm(), 1500));
}

void TestFirmware::stoppedItRestsWithinHalfASecond()
{
    Run run;
    run.firmware.start();
    QVERIFY(run.reaches(MotorState::Run, 1000));
    run.firmware.rampSpeed({3000, 0});
    run.ms(1500);
    run.firmware.stop();
    QCOMPARE(run.firmware.state(), MotorState::Stop);
    run.ms(450);
    QCOMPARE(run.firmware.state(), MotorState::Idle);
    QCOMPARE(run.firmware.speed_rpm(), 0);
}

QTEST_APPLESS_MAIN(TestFirmware)
#include "tst_firmware.moc"
