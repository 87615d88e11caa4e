// The motor model against what its equations say in the steady state.
#include "simulation/pmsm.h"

#include <QTest>

#include <cmath>
#include <numbers>

using simulation::Pmsm;
using simulation::PmsmParameters;

class TestPmsm : public QObject {
    Q_OBJECT

private slots:
    void voltageSettlesAtTheSpeedWhereTorqueMeetsFriction();
    void anIdlingMotorRunsWhereBackEmfMeetsTheVoltage();
    void aSmallVoltageCannotBreakFriction();
    void anOpenBridgeLetsTheRotorRunOut();
};

void TestPmsm::voltageSettlesAtTheSpeedWhereTorqueMeetsFriction()
{
    const PmsmParameters p;
    Pmsm motor(p);
    for (int i = 0; i < 16000 * 3; ++i)
        motor.drive(0.0, 6.0, 1.0 / 16000.0);
    const double w = motor.speed_radps();
    QVERIFY(w > 100.0);
    QVERIFY(std::abs(motor.torque_nm() - p.coulomb_nm - p.viscous_nms * w) < 1e-6);
    // both voltage equations, with nothing changing
    const double we = p.polePairs * w;
    QVERIFY(
        std::abs(p.rs_ohm * motor.iq_a() + we * (p.ld_h * motor.id_a() + p.flux_wb) - 6.0) < 1e-6);
    QVERIFY(std::abs(p.rs_ohm * motor.id_a() - we * p.lq_h * motor.iq_a()) < 1e-6);
}

void TestPmsm::anIdlingMotorRunsWhereBackEmfMeetsTheVoltage()
{
    PmsmParameters p;
    p.coulomb_nm = 0.0;
    p.viscous_nms = 0.0;
    Pmsm motor(p);
    for (int i = 0; i < 16000 * 3; ++i)
        motor.drive(0.0, 5.2, 1.0 / 16000.0);
    const double expected_radps = 5.2 / (p.polePairs * p.flux_wb);
    QVERIFY(std::abs(motor.speed_radps() - expected_radps) < 1e-3 * expected_radps);
    QVERIFY(std::abs(motor.iq_a()) < 1e-3);
}

void TestPmsm::aSmallVoltageCannotBreakFriction()
{
    const PmsmParameters p;
    Pmsm motor(p);
    const double volts = 0.5 * p.coulomb_nm / (1.5 * p.polePairs * p.flux_wb) * p.rs_ohm;
    for (int i = 0; i < 16000; ++i)
        motor.drive(0.0, volts, 1.0 / 16000.0);
    QCOMPARE(motor.speed_radps(), 0.0);
    QVERIFY(std::abs(motor.iq_a() - volts / p.rs_ohm) < 1e-6);
}

void TestPmsm::anOpenBridgeLetsTheRotorRunOut()
{
    Pmsm motor{PmsmParameters{}};
    for (int i = 0; i < 16000 * 2; ++i)
        motor.drive(0.0, 6.0, 1.0 / 16000.0);
    const double before = motor.speed_radps();
    double seconds = 0.0;
    while (!motor.atRest() && seconds < 2.0) {
        motor.coast(1.0 / 16000.0);
        seconds += 1.0 / 16000.0;
    }
    QVERIFY(before > 100.0);
    QVERIFY2(seconds > 0.05 && seconds < 0.5, qPrintable(QString::number(seconds)));
}

QTEST_APPLESS_MAIN(TestPmsm)
#include "tst_pmsm.moc"
