// Motor constants: the same magnets said in four ways, and what looks wrong about a motor.
#include "motor/constants.h"
#include "support/near.h"

#include <QTest>

#include <cmath>
#include <limits>

using support::nearByShare;
using namespace motor;
using Warning = MotorWarning;

class TestMotorConstants : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void fluxKeAndKvAreOneMotor();
    void ratedFluxIsReadAsTheFirmwareMeansIt();
    void constantsOfAKnownMotor();
    void baseSpeedIsWhereTheVoltageIsUsedUp();
    void whatIsMissingIsEmptyAndNeverNan();
    void aSoundMotorHasNoWarning();
    void eachFlawHasItsWarning_data();
    void eachFlawHasItsWarning();
};

namespace {

const MotorParameters kMotor{4, 0.35, 0.6e-3, 0.6e-3, 6.5e-3, 5.0};
const DriveLimits kDrive{24.0, 60.0, 4000.0};

} // namespace

void TestMotorConstants::fluxKeAndKvAreOneMotor()
{
    const double ke = keOfFlux_vrmsPerKrpm(6.5e-3, 4);
    QVERIFY(nearByShare(ke, 3.3346, 1e-4));
    QVERIFY(nearByShare(fluxOfKe_wb(ke, 4), 6.5e-3, 1e-12));
    const double kv = kvOfFlux_rpmpv(6.5e-3, 4);
    QVERIFY(nearByShare(fluxOfKv_wb(kv, 4), 6.5e-3, 1e-12));
    // Peak instead of rms, and a volt instead of 1000 rpm: KV Ke sqrt(2) = 1000.
    QVERIFY(nearByShare(kv * ke * std::sqrt(2.0), 1000.0, 1e-12));
    // Kt in N m per peak ampere and Ke in V s per rad of a phase: 3/2.
    QVERIFY(nearByShare(ktOfFlux_nmpa(6.5e-3, 4), 0.039, 1e-12));
}

void TestMotorConstants::ratedFluxIsReadAsTheFirmwareMeansIt()
{
    QVERIFY(nearByShare(fluxOfConfiguration_wb(3.3346, 4, false), 6.5e-3, 1e-4));
    // Also of a small motor, and of a strong one: no figure tells its unit.
    QVERIFY(nearByShare(fluxOfConfiguration_wb(0.05, 4, false), fluxOfKe_wb(0.05, 4), 1e-12));
    QVERIFY(nearByShare(fluxOfConfiguration_wb(6.5e-3 * 2 * M_PI, 4, true), 6.5e-3, 1e-9));
    QVERIFY(nearByShare(fluxOfConfiguration_wb(0.5 * 2 * M_PI, 4, true), 0.5, 1e-9));
    for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        QCOMPARE(fluxOfConfiguration_wb(none, 4, false), 0.0);
    QCOMPARE(fluxOfConfiguration_wb(3.3, 0, true), 0.0);
}

void TestMotorConstants::constantsOfAKnownMotor()
{
    const MotorConstants constants = motorConstants(kMotor, 24.0);
    QVERIFY(nearByShare(constants.kt_nmpa.value(), 0.039, 1e-12));
    QVERIFY(nearByShare(constants.timeConstantQ_s.value(), 0.6e-3 / 0.35, 1e-12));
    QVERIFY(nearByShare(constants.timeConstantD_s.value(), 0.6e-3 / 0.35, 1e-12));
    QVERIFY(nearByShare(torque_nm(kMotor, 2.0), 0.078, 1e-12));
    MotorParameters salient = kMotor;
    salient.ld_h = 0.4e-3;
    QVERIFY(torque_nm(salient, 2.0, -1.0) > torque_nm(salient, 2.0));
}

void TestMotorConstants::baseSpeedIsWhereTheVoltageIsUsedUp()
{
    const double rpm = motorConstants(kMotor, 24.0).baseSpeed_rpm.value();
    const double we = rpm * 2 * M_PI / 60 * 4;
    const double vq = 0.35 * 5.0 + we * 6.5e-3, vd = we * 0.6e-3 * 5.0;
    QVERIFY(nearByShare(std::hypot(vq, vd), 24.0 / std::sqrt(3.0), 1e-9));
    QVERIFY(!motorConstants(kMotor, 2.0).baseSpeed_rpm); // the resistance takes more than that
}

void TestMotorConstants::whatIsMissingIsEmptyAndNeverNan()
{
    const MotorConstants none = motorConstants({}, 24.0);
    QVERIFY(!none.kt_nmpa && !none.ke_vrmsPerKrpm && !none.kv_rpmpv && !none.baseSpeed_rpm);
    QVERIFY(!none.timeConstantQ_s && !none.timeConstantD_s);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const MotorConstants odd = motorConstants({4, nan, 0.6e-3, nan, nan, 5.0}, nan);
    QVERIFY(!odd.kt_nmpa && !odd.timeConstantQ_s && !odd.baseSpeed_rpm);
    QVERIFY(!motorConstants(kMotor, 0.0).baseSpeed_rpm);
}

void TestMotorConstants::aSoundMotorHasNoWarning()
{
    QVERIFY(checkMotor(kMotor, kDrive).empty());
    QVERIFY(checkMotor(kMotor, {}).empty());
}

void TestMotorConstants::eachFlawHasItsWarning_data()
{
    QTest::addColumn<MotorParameters>("motor");
    QTest::addColumn<int>("warning");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto row = [](const char *name, Warning warning, auto change) {
        MotorParameters motor = kMotor;
        change(motor);
        QTest::newRow(name) << motor << static_cast<int>(warning);
    };
    using M = MotorParameters;
    row("no pole pairs", Warning::PolePairsMissing, [](M &m) { m.polePairs = 0; });
    row("half a pole pair", Warning::PolePairsMissing, [](M &m) { m.polePairs = 3.5; });
    row("pole pairs not a number", Warning::PolePairsMissing, [=](M &m) { m.polePairs = nan; });
    row("resistance in mOhm", Warning::ResistanceImplausible, [](M &m) { m.rs_ohm = 3500; });
    row("inductance in mH", Warning::InductanceImplausible, [](M &m) { m.lq_h = m.ld_h = 60; });
    row("no flux", Warning::FluxImplausible, [](M &m) { m.flux_wb = 0; });
    row("current in mA", Warning::NominalCurrentImplausible,
        [](M &m) { m.nominalCurrent_a = 5001; });
    row("swapped", Warning::LdAboveLq, [](M &m) { m.ld_h = 0.7e-3; });
    row("too slow", Warning::TimeConstantImplausible, [](M &m) { m.rs_ohm = 0.5e-3; });
    row("more than the drive has", Warning::NominalCurrentBeyondDrive,
        [](M &m) { m.nominalCurrent_a = 61; });
    row("strong magnets", Warning::SpeedBeyondBaseSpeed, [](M &m) { m.flux_wb = 20e-3; });
}

void TestMotorConstants::eachFlawHasItsWarning()
{
    QFETCH(MotorParameters, motor);
    QFETCH(int, warning);
    const auto warnings = checkMotor(motor, kDrive);
    QVERIFY(std::find(warnings.begin(), warnings.end(), static_cast<Warning>(warning))
        != warnings.end());
}

QTEST_APPLESS_MAIN(TestMotorConstants)
#include "tst_motor_constants.moc"
