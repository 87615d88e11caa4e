// The motor of the plant against what its equations say: steady states, step responses, friction, heat.
#include "support/near.h"
#include "support/plant_drive.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace plant_drive;
using simulation::LoadParameters;
using simulation::Plant;
using simulation::PlantParameters;
using support::nearByShare;

namespace {

/// Seconds until the current has come 63.2 % of its way, between samples by interpolation.
template <class Step, class Current>
double timeConstant_s(double final_a, Step step, Current current)
{
    const double wanted = final_a * (1.0 - std::exp(-1.0));
    double before = 0.0;
    for (int i = 1; i < 100'000; ++i) {
        step();
        const double now = current();
        if (now >= wanted)
            return (i - 1 + (wanted - before) / (now - before)) * kPeriod_s;
        before = now;
    }
    return 0.0;
}

} // namespace

class TestPlantMotor : public QObject {
    Q_OBJECT

private slots:
    void voltageSettlesWhereTorqueMeetsFrictionAndLoad();
    void bothVoltageEquationsHoldInTheSteadyState();
    void aLockedRotorsCurrentRisesWithLOverR();
    void aSalientRotorHasTwoTimeConstants();
    void saturationTakesAFifthOfLqAtItsCurrent();
    void saliencyMakesTorqueOfFieldCurrent();
    void zeroCurrentShowsTheBackEmfConstantDuringASpinDown();
    void aRectifiedBusShowsTheBackEmfConstant();
    void dryFrictionHoldsARestingRotor();
    void aBrakeStopsEitherDirectionAndTurnsNothing();
    void aDrivingLoadTurnsTheShaft();
    void coastingStopsAfterTheTimeThatFrictionNeeds();
    void atRestTheBusDischargesAlone();
    void aFansTorqueGrowsWithTheSquare();
    void coggingPullsToItsDetents();
    void coggingRipplesTheSpeedAtItsOrder();
    void theWindingWarmsAsCopperDoes();
    void warmCopperHasMoreResistance();
};

void TestPlantMotor::voltageSettlesWhereTorqueMeetsFrictionAndLoad()
{
    PlantParameters p = plain();
    p.load = {.constant_nm = 0.05, .fan_nms2 = 1e-7};
    Plant plant(p, 1);
    steps(plant, 0.0, 7.0, 3.0);
    const double w = plant.speed_radps();
    QVERIFY(w > 100.0);
    const double against = 0.025 + 0.05 + p.motor.viscous_nms * w + 1e-7 * w * w;
    QVERIFY(nearByShare(plant.torque_nm(), against, 1e-3));
}

void TestPlantMotor::bothVoltageEquationsHoldInTheSteadyState()
{
    Plant plant(plain(), 1);
    steps(plant, -1.0, 6.0, 3.0);
    const auto &m = plant.parameters().motor;
    const double we = m.polePairs * plant.speed_radps();
    // A vector that stands still for a period is that much shorter on a turning rotor.
    const double half = 0.5 * we * kPeriod_s;
    const double seen = std::sin(half) / half;
    const double vq = m.rs_ohm * plant.iq_a() + we * (m.ld_h * plant.id_a() + m.flux_wb);
    const double vd = m.rs_ohm * plant.id_a() - we * m.lq_h * plant.iq_a();
    QVERIFY(std::abs(vq - 6.0 * seen) < 0.05);
    QVERIFY(std::abs(vd + 1.0 * seen) < 0.05);
}

void TestPlantMotor::aLockedRotorsCurrentRisesWithLOverR()
{
    Plant plant(locked(plain()), 1);
    const auto &m = plant.parameters().motor;
    const double tau = timeConstant_s(
        1.0 / m.rs_ohm, [&] { step(plant, 0.0, 1.0); }, [&] { return plant.iq_a(); });
    QVERIFY(nearByShare(tau, m.lq_h / m.rs_ohm, 0.01));
    steps(plant, 0.0, 1.0, 0.1);
    QVERIFY(nearByShare(plant.iq_a(), 1.0 / m.rs_ohm, 1e-3));
    QCOMPARE(plant.speed_radps(), 0.0);
}

void TestPlantMotor::aSalientRotorHasTwoTimeConstants()
{
    PlantParameters p = locked(plain());
    p.motor.lq_h = 1.5e-3;
    const double rs_ohm = p.motor.rs_ohm;
    Plant d(p, 1), q(p, 1);
    const double tauD = timeConstant_s(
        1.0 / rs_ohm, [&] { step(d, 1.0, 0.0); }, [&] { return d.id_a(); });
    const double tauQ = timeConstant_s(
        1.0 / rs_ohm, [&] { step(q, 0.0, 1.0); }, [&] { return q.iq_a(); });
    QVERIFY(nearByShare(tauD, 0.6e-3 / rs_ohm, 0.01));
    QVERIFY(nearByShare(tauQ, 1.5e-3 / rs_ohm, 0.01));
}

void TestPlantMotor::saturationTakesAFifthOfLqAtItsCurrent()
{
    // The volt seconds that bring the current to Isat are the flux, less what the resistance took.
    PlantParameters p = locked(plain());
    p.motor.rs_ohm = 1e-4;
    p.motor.saturation_a = 20.0;
    Plant plant(p, 1);
    double flux_wb = 0.0, before_a = 0.0;
    while (plant.iq_a() < 20.0) {
        before_a = plant.iq_a();
        step(plant, 0.0, 1.0);
        flux_wb += kPeriod_s;
    }
    const double beyond = (plant.iq_a() - 20.0) / (plant.iq_a() - before_a) * kPeriod_s;
    QVERIFY(nearByShare(flux_wb - beyond, 0.8 * p.motor.lq_h * 20.0, 0.002));
}

void TestPlantMotor::saliencyMakesTorqueOfFieldCurrent()
{
    PlantParameters p = locked(plain());
    p.motor.lq_h = 1.5e-3;
    Plant plant(p, 1);
    steps(plant, -1.5, 1.0, 0.2);
    const double id = -1.5 / p.motor.rs_ohm, iq = 1.0 / p.motor.rs_ohm;
    QVERIFY(nearByShare(plant.torque_nm(), 6.0 * (6.5e-3 * iq - 0.9e-3 * id * iq), 1e-3));
}

void TestPlantMotor::zeroCurrentShowsTheBackEmfConstantDuringASpinDown()
{
    // What a bench does: hold the current at zero and read voltage over speed while the rotor runs out.
    PlantParameters p = plain();
    p.motor.inertia_kgm2 = 1e-3;
    Plant plant(p, 1);
    plant.place(0.3, 350.0);
    double vd = 0.0, vq = 4 * 350.0 * 6.5e-3, ratios = 0.0;
    int count = 0;
    for (int i = 0; i < 16000; ++i) {
        vd -= 0.02 * plant.id_a();
        vq -= 0.02 * plant.iq_a();
        step(plant, vd - 0.3 * plant.id_a(), vq - 0.3 * plant.iq_a());
        const double we = 4 * plant.speed_radps(), half = 0.5 * we * kPeriod_s;
        if (i >= 4000 && i % 100 == 0) {
            QVERIFY(std::abs(plant.iq_a()) < 0.1);
            ratios += vq * std::sin(half) / half / we;
            ++count;
        }
    }
    QVERIFY(plant.speed_radps() < 330.0);
    QVERIFY(nearByShare(ratios / count, p.motor.flux_wb, 0.01));
}

void TestPlantMotor::aRectifiedBusShowsTheBackEmfConstant()
{
    // The diodes charge an unloaded bus to the highest voltage between two phases.
    PlantParameters p;
    p.inverter.supply_v = 1.0;
    p.inverter.busCapacitance_f = 2e-6;
    p.inverter.bleeder_ohm = 1e5;
    p.motor.inertia_kgm2 = 0.1;
    for (const double speed_radps : {100.0, 200.0, 400.0}) {
        Plant plant(p, 1);
        plant.place(1.0, speed_radps);
        coast(plant, 0.3);
        const double emf_v = std::sqrt(3.0) * 4 * plant.speed_radps() * p.motor.flux_wb;
        QVERIFY(nearByShare(plant.trueBus_v() + 2.0 * p.inverter.diodeDrop_v, emf_v, 0.01));
    }
}

void TestPlantMotor::dryFrictionHoldsARestingRotor()
{
    Plant plant(plain(), 5);
    const double angle = plant.angle_rad();
    const double volts = 0.95 * 0.025 / (1.5 * 4 * 6.5e-3) * 0.35;
    steps(plant, 0.0, volts, 0.5);
    QCOMPARE(plant.speed_radps(), 0.0);
    QCOMPARE(plant.angle_rad(), angle);
    steps(plant, 0.0, volts / 0.95 * 1.1, 0.5);
    QVERIFY(plant.speed_radps() > 0.5);
}

void TestPlantMotor::aBrakeStopsEitherDirectionAndTurnsNothing()
{
    for (const double brake_nm : {0.05, -0.05}) {
        for (const double speed_radps : {100.0, -100.0}) {
            Plant plant(plain(), 1);
            plant.setLoadTorque(brake_nm);
            plant.place(0.0, speed_radps);
            coast(plant, 0.05);
            QVERIFY(std::abs(plant.speed_radps()) < 50.0);
            QVERIFY(plant.speed_radps() * speed_radps > 0.0);
            coast(plant, 0.5);
            QCOMPARE(plant.speed_radps(), 0.0);
            QVERIFY(plant.atRest());
        }
    }
}

void TestPlantMotor::aDrivingLoadTurnsTheShaft()
{
    Plant plant(plain(), 1);
    plant.setLoad(LoadParameters{.drive_nm = -0.05});
    coast(plant, 3.0);
    const double w = (0.05 - 0.025) / 1.2e-4;
    QVERIFY(nearByShare(plant.speed_radps(), -w, 0.01));
    QVERIFY(plant.energies().driven_j > 1.0);
}

void TestPlantMotor::coastingStopsAfterTheTimeThatFrictionNeeds()
{
    Plant plant(plain(), 1);
    const auto &m = plant.parameters().motor;
    plant.place(0.0, 200.0);
    int periods = 0;
    for (plant.setBridge({}); plant.speed_radps() != 0.0 && periods < 100'000; ++periods)
        plant.advance(kPeriod_s);
    const double tau_s = m.inertia_kgm2 / m.viscous_nms;
    const double expected_s = tau_s * std::log(1.0 + m.viscous_nms * 200.0 / m.coulomb_nm);
    QVERIFY(nearByShare(periods * kPeriod_s, expected_s, 1e-3));
}

void TestPlantMotor::atRestTheBusDischargesAlone()
{
    PlantParameters p = plain();
    p.inverter.supplyAbsorbs = false;
    Plant plant(p, 1);
    plant.place(0.0, 2.0 * p.inverter.supply_v / (p.motor.flux_wb * p.motor.polePairs));
    coast(plant, 0.1); // the diodes lift the bus above its supply
    plant.place(0.0);
    const double before_v = plant.trueBus_v();
    QVERIFY(before_v > 1.2 * p.inverter.supply_v);
    constexpr double kAt_s = 0.1;
    coast(plant, kAt_s);
    const double tau_s = p.inverter.bleeder_ohm * p.inverter.busCapacitance_f;
    QVERIFY(nearByShare(plant.trueBus_v(), before_v * std::exp(-kAt_s / tau_s), 1e-9));
    QVERIFY(plant.atRest());
}

void TestPlantMotor::aFansTorqueGrowsWithTheSquare()
{
    PlantParameters p = plain();
    p.motor.coulomb_nm = p.motor.viscous_nms = 0.0;
    p.load = {.fan_nms2 = 2e-6};
    Plant plant(p, 1);
    plant.place(0.0, 300.0);
    coast(plant, 0.2);
    // w' = -k w^2 / J
    QVERIFY(nearByShare(plant.speed_radps(), 1.0 / (1.0 / 300.0 + 2e-6 * 0.2 / 5e-5), 1e-3));
}

void TestPlantMotor::coggingPullsToItsDetents()
{
    PlantParameters p = plain();
    p.motor.cogging_nm = 0.01;
    p.motor.coggingPerTurn = 12;
    p.motor.coulomb_nm = 1e-4;
    Plant plant(p, 1);
    plant.place(4 * 0.3 * kTurn / 12.0); // three tenths of the way to the next one
    coast(plant, 2.0);
    QCOMPARE(plant.speed_radps(), 0.0);
    const double pitches = plant.rotor_rad() / kTurn * 12.0;
    QVERIFY(std::abs(pitches - std::round(pitches)) < 0.01);
    Plant fresh(p, 7);
    coast(fresh, 0.1);
    QCOMPARE(fresh.energies().kinetic_j, 0.0);
    QVERIFY(fresh.energies().cogging_j < 1e-12);
}

void TestPlantMotor::coggingRipplesTheSpeedAtItsOrder()
{
    PlantParameters p = plain();
    p.motor.coulomb_nm = p.motor.viscous_nms = 0.0;
    p.motor.cogging_nm = 0.01;
    p.motor.coggingPerTurn = 12;
    Plant plant(p, 1);
    plant.place(0.0, 100.0);
    plant.setBridge({});
    double least = 1e9, most = 0.0;
    for (int i = 0; i < 16000; ++i) {
        plant.advance(kPeriod_s);
        least = std::min(least, plant.speed_radps());
        most = std::max(most, plant.speed_radps());
    }
    // Energy: J w^2 / 2 + cogging / n (1 - cos) is constant.
    QVERIFY(nearByShare(most, 100.0, 1e-4));
    QVERIFY(nearByShare(least, std::sqrt(1e4 - 2.0 / 5e-5 * 2.0 * 0.01 / 12.0), 1e-4));
}

void TestPlantMotor::theWindingWarmsAsCopperDoes()
{
    PlantParameters p = locked(plain());
    p.motor.copperMass_kg = 0.02;
    p.motor.coolingTime_s = 5.0;
    Plant plant(p, 1);
    steps(plant, 0.0, 1.75, 0.2);
    QVERIFY(plant.winding_c() > 20.1);
    const double before_c = plant.winding_c(), before_j = plant.energies().copper_j;
    steps(plant, 0.0, 1.75, 2.0);
    const double power_w = (plant.energies().copper_j - before_j) / 2.0;
    const double final_k = power_w * 5.0 / (0.02 * 385.0);
    const double expected_c = 20.0 + final_k + (before_c - 20.0 - final_k) * std::exp(-2.0 / 5.0);
    QVERIFY(nearByShare(plant.winding_c() - before_c, expected_c - before_c, 0.005));
    coast(plant, 5.0);
    QVERIFY(nearByShare(plant.winding_c() - 20.0, (expected_c - 20.0) / std::exp(1.0), 0.01));
}

void TestPlantMotor::warmCopperHasMoreResistance()
{
    PlantParameters p = locked(plain());
    p.inverter.ambient_c = 120.0;
    Plant plant(p, 1);
    steps(plant, 0.0, 1.0, 0.1);
    QVERIFY(nearByShare(plant.iq_a(), 1.0 / (0.35 * 1.393), 1e-3));
}

QTEST_APPLESS_MAIN(TestPlantMotor)
#include "tst_plant_motor.moc"
