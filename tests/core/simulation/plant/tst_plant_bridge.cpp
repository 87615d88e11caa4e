// The power stage of the plant: dead time, diodes, supply and capacitor.
#include "support/plant_drive.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace plant_drive;
using simulation::Bridge;
using simulation::Energies;
using simulation::LoadParameters;
using simulation::Plant;
using simulation::PlantParameters;

namespace {

/// Everything that the motor and the capacitor hold.
double stored_j(const Energies &e) { return e.capacitor_j + e.field_j + e.kinetic_j + e.cogging_j; }

double largest(const simulation::Phases &p)
{
    return std::max({std::abs(p.a), std::abs(p.b), std::abs(p.c)});
}

} // namespace

class TestPlantBridge : public QObject {
    Q_OBJECT

private slots:
    void commonModeMovesNothing();
    void dutiesEndAtZeroAndOne();
    void nonsenseDutiesLeaveNumbers();
    void deadTimeTakesItsShareOfTheBus();
    void deadTimeFadesWithinTheRipple();
    void deadTimeDistortsAtTheSixthOrder();
    void openedUnderCurrentTheBusTakesItsEnergy();
    void openedBridgeEmptiesInAFewTimeConstants();
    void backEmfBelowTheBusBrakesNothing();
    void backEmfAboveTheBusChargesIt();
    void brakingRaisesABusThatCannotGiveBack();
    void brakingIntoAnAbsorbingSupplyReturnsEnergy();
    void aRaisedBusSinksThroughTheBoard();
    void theSuppliesDiodeNeverTakesBack();
    void theBusSagsByTheSourcesResistance();
    void shortedPhasesBrake();
};

void TestPlantBridge::commonModeMovesNothing()
{
    Plant plant(plain(), 1);
    for (int i = 0; i < 1600; ++i) {
        const double duty = 0.2 + 0.6 * (i % 100) / 100.0;
        plant.setBridge({true, duty, duty, duty});
        plant.advance(kPeriod_s);
        QVERIFY(largest(plant.phases_a()) < 1e-9);
    }
    Plant shifted(plain(), 1), centred(plain(), 1);
    for (int i = 0; i < 1600; ++i) {
        centred.setBridge({true, 0.6, 0.5, 0.4});
        shifted.setBridge({true, 0.7, 0.6, 0.5});
        centred.advance(kPeriod_s);
        shifted.advance(kPeriod_s);
    }
    QVERIFY(std::abs(centred.phases_a().a - shifted.phases_a().a) < 1e-6);
}

void TestPlantBridge::dutiesEndAtZeroAndOne()
{
    Plant wild(locked(plain()), 1), tame(locked(plain()), 1);
    wild.setBridge({true, 7.0, -3.0, -1e300});
    tame.setBridge({true, 1.0, 0.0, 0.0});
    for (int i = 0; i < 800; ++i) {
        wild.advance(kPeriod_s);
        tame.advance(kPeriod_s);
    }
    QCOMPARE(wild.phases_a().a, tame.phases_a().a);
    // two thirds of the bus over one phase
    QVERIFY(std::abs(tame.phases_a().a - 16.0 / 0.35) < 0.5);
}

void TestPlantBridge::nonsenseDutiesLeaveNumbers()
{
    Plant plant(PlantParameters{}, 1);
    const double nan = std::nan(""), inf = HUGE_VAL;
    const std::vector<Bridge> all{{true, nan, 0.1, 0.2}, {true, inf, -inf, nan},
        {false, nan, nan, nan}, {true, 1.0, 0.0, 1.0}, {true, 0.0, 1.0, 0.0}};
    for (int i = 0; i < 5000; ++i) {
        plant.setBridge(all[static_cast<std::size_t>(i / 7) % all.size()]);
        plant.advance(kPeriod_s);
        QVERIFY(std::isfinite(plant.speed_radps()) && std::isfinite(plant.iq_a()));
        QVERIFY(plant.trueBus_v() >= 0.0 && plant.trueBus_v() < 1000.0);
    }
    const double angle = plant.angle_rad();
    plant.advance(nan);
    plant.advance(-1.0);
    plant.advance(0.0);
    QCOMPARE(plant.angle_rad(), angle);
}

void TestPlantBridge::deadTimeTakesItsShareOfTheBus()
{
    PlantParameters p = locked(plain());
    p.inverter.deadTime_s = 1e-6;
    p.inverter.diodeDrop_v = 0.0;
    Plant plant(p, 1);
    for (int i = 0; i < 3200; ++i) {
        plant.setBridge(vector(0.0, 3.0, 0.0, plant.trueBus_v()));
        plant.advance(kPeriod_s);
    }
    // All three legs lose td/T of the bus: a against b and c makes 4/3 of it along a.
    const double lost_v = 4.0 / 3.0 * 24.0 * 1e-6 / kPeriod_s;
    QVERIFY(std::abs(plant.phases_a().a * 0.35 - (3.0 - lost_v)) < 0.01);
}

void TestPlantBridge::deadTimeFadesWithinTheRipple()
{
    PlantParameters p = locked(plain());
    p.inverter.deadTime_s = 1e-6;
    p.inverter.diodeDrop_v = 0.0;
    const auto current = [&](double volts) {
        Plant plant(p, 1);
        for (int i = 0; i < 3200; ++i) {
            plant.setBridge(vector(0.0, volts, 0.0, plant.trueBus_v()));
            plant.advance(kPeriod_s);
        }
        return plant.phases_a().a;
    };
    const double small = current(0.05), twice = current(0.1);
    QVERIFY(small > 0.0);
    QVERIFY(std::abs(twice / small - 2.0) < 0.01); // no threshold, a resistance
    const double zero_a = 24.0 * kPeriod_s / (16.0 * 0.6e-3);
    QVERIFY(small < zero_a / 2.0);
    QVERIFY(std::abs(0.05 / small - (0.35 + 24.0 * 1e-6 / kPeriod_s / zero_a)) < 0.01);
}

void TestPlantBridge::deadTimeDistortsAtTheSixthOrder()
{
    PlantParameters p = plain();
    p.inverter.deadTime_s = 2e-6;
    p.motor.inertia_kgm2 = 1e-2; // keeps the speed
    p.load = {.constant_nm = 0.1};
    Plant plant(p, 1);
    plant.place(0.0, 100.0);
    steps(plant, 0.0, 4.5, 0.05);
    double cosine = 0.0, sine = 0.0, most = 0.0, least = 1e9;
    for (int i = 0; i < 1600; ++i) {
        step(plant, 0.0, 4.5);
        cosine += plant.iq_a() * std::cos(6.0 * plant.angle_rad()) / 800.0;
        sine += plant.iq_a() * std::sin(6.0 * plant.angle_rad()) / 800.0;
        most = std::max(most, plant.iq_a());
        least = std::min(least, plant.iq_a());
    }
    QVERIFY(std::hypot(cosine, sine) > 0.25 * (most - least));
}

void TestPlantBridge::openedUnderCurrentTheBusTakesItsEnergy()
{
    PlantParameters p = locked(plain());
    p.inverter.supplyAbsorbs = false;
    p.inverter.diodeDrop_v = 0.0;
    p.inverter.bleeder_ohm = 1e9;
    p.motor.ld_h = p.motor.lq_h = 5e-3;
    Plant plant(p, 1);
    for (int i = 0; i < 3200; ++i) {
        plant.setBridge(vector(0.0, 5.0, 0.7, plant.trueBus_v()));
        plant.advance(kPeriod_s);
    }
    const Energies before = plant.energies();
    QVERIFY(before.field_j > 0.5);
    coast(plant, 0.05);
    const Energies after = plant.energies();
    QCOMPARE(after.field_j, 0.0);
    QCOMPARE(largest(plant.phases_a()), 0.0);
    const double copper_j = after.copper_j - before.copper_j;
    const double gained_j = after.capacitor_j - before.capacitor_j;
    QVERIFY(gained_j > 0.5 * before.field_j);
    QVERIFY(gained_j + copper_j <= before.field_j);
    QVERIFY(gained_j + copper_j > 0.98 * before.field_j);
}

void TestPlantBridge::openedBridgeEmptiesInAFewTimeConstants()
{
    Plant plant(locked(PlantParameters{}), 1);
    steps(plant, 0.0, 2.0, 0.1);
    QVERIFY(plant.iq_a() > 4.0);
    // The whole bus against the current: i L / (2/3 bus), at most.
    int periods = 0;
    plant.setBridge({});
    for (; largest(plant.phases_a()) > 0.0 && periods < 1000; ++periods)
        plant.advance(kPeriod_s);
    QVERIFY(periods >= 1 && periods * kPeriod_s < 6.0 * 0.6e-3 / 12.0 + 2 * kPeriod_s);
}

void TestPlantBridge::backEmfBelowTheBusBrakesNothing()
{
    PlantParameters p;
    p.motor.coulomb_nm = p.motor.viscous_nms = 0.0;
    Plant plant(p, 1);
    plant.place(0.0, 500.0); // sqrt 3 * 4 * 500 * 6.5e-3 = 22.5 V between phases
    coast(plant, 0.5);
    QCOMPARE(plant.speed_radps(), 500.0);
    QCOMPARE(plant.energies().copper_j, 0.0);
}

void TestPlantBridge::backEmfAboveTheBusChargesIt()
{
    PlantParameters p;
    Plant plant(p, 1);
    plant.setLoad(LoadParameters{.drive_nm = 2.0});
    plant.setBridge({});
    while (plant.speed_radps() < 900.0) // 40 V between phases
        plant.advance(kPeriod_s);
    QVERIFY(plant.trueBus_v() > 30.0);
    QVERIFY(plant.torque_nm() < 0.0);
    QVERIFY(plant.energies().bridge_j < 0.0);
    const double emf_v = std::sqrt(3.0) * 4 * plant.speed_radps() * p.motor.flux_wb;
    QVERIFY(plant.trueBus_v() < emf_v);
    QVERIFY(plant.bus_v() > 30.0);
}

void TestPlantBridge::brakingRaisesABusThatCannotGiveBack()
{
    PlantParameters p = plain();
    p.inverter.supplyAbsorbs = false;
    p.motor.inertia_kgm2 = 5e-4;
    Plant plant(p, 1);
    plant.place(0.0, 350.0);
    double most_v = 0.0;
    while (plant.speed_radps() > 100.0) {
        const double emf = 4 * plant.speed_radps() * p.motor.flux_wb;
        step(plant, 0.0, emf - 2.0); // some 5 A against the rotation
        most_v = std::max(most_v, plant.trueBus_v());
    }
    // A rotor of 27 J through the motor's resistance into 1 mF.
    QVERIFY(most_v > 40.0 && most_v < std::sqrt(24.0 * 24.0 + 2.0 * 31.0 / 1e-3));
    QVERIFY(plant.energies().supply_j < 0.3); // what the board itself took
}

void TestPlantBridge::brakingIntoAnAbsorbingSupplyReturnsEnergy()
{
    PlantParameters p = plain();
    p.motor.inertia_kgm2 = 5e-4;
    Plant plant(p, 1);
    plant.place(0.0, 350.0);
    while (plant.speed_radps() > 100.0)
        step(plant, 0.0, 4 * plant.speed_radps() * p.motor.flux_wb - 2.0);
    QVERIFY(std::abs(plant.trueBus_v() - 24.0) < 0.1);
    QVERIFY(plant.energies().supply_j < -5.0);
}

void TestPlantBridge::aRaisedBusSinksThroughTheBoard()
{
    PlantParameters p = plain();
    p.inverter.supplyAbsorbs = false;
    Plant plant(p, 1);
    plant.setLoad(LoadParameters{.drive_nm = 2.0});
    while (plant.trueBus_v() < 34.0)
        plant.advance(kPeriod_s);
    plant.setLoad({});
    plant.place(0.0);
    const double from_v = plant.trueBus_v();
    coast(plant, 0.2);
    QVERIFY(std::abs(plant.trueBus_v() - from_v * std::exp(-0.2)) < 0.01);
    coast(plant, 1.0);
    QVERIFY(std::abs(plant.trueBus_v() - 24.0) < 0.01);
}

void TestPlantBridge::theSuppliesDiodeNeverTakesBack()
{
    PlantParameters p;
    p.inverter.supplyResistance_ohm = 0.01;
    p.inverter.busCapacitance_f = 1e-4;
    simulation::Bus bus(p.inverter);
    bus.prepare(Plant::kMaxStep_s);
    simulation::Noise noise(3);
    double supplied_j = 0.0;
    for (int i = 0; i < 1000; ++i) {
        bus.step(110.0 * noise.share() - 50.0);
        QVERIFY(bus.work().supply_j >= supplied_j);
        supplied_j = bus.work().supply_j;
    }
    QVERIFY(supplied_j > 0.1);
}

void TestPlantBridge::theBusSagsByTheSourcesResistance()
{
    PlantParameters p = locked(plain());
    p.inverter.supplyResistance_ohm = 1.0;
    Plant plant(p, 1);
    plant.setBridge({true, 0.7, 0.5, 0.3});
    for (int i = 0; i < 3200; ++i)
        plant.advance(kPeriod_s);
    // Two equations, two unknowns: v = 24 - I, I = v^2 (0.2^2 + 0.2^2) / 0.35 / v
    const double perVolt = 0.08 / 0.35 + 1e-3;
    QVERIFY(std::abs(plant.trueBus_v() - 24.0 / (1.0 + perVolt)) < 0.01);
}

void TestPlantBridge::shortedPhasesBrake()
{
    PlantParameters p = plain();
    p.motor.coulomb_nm = p.motor.viscous_nms = 0.0;
    Plant plant(p, 1);
    plant.place(0.0, 200.0);
    plant.setBridge({true, 0.0, 0.0, 0.0});
    for (int i = 0; i < 3200; ++i) {
        plant.advance(kPeriod_s);
        QVERIFY(std::abs(plant.energies().bridge_j) < 1e-9);
    }
    QVERIFY(plant.speed_radps() < 20.0);
    const Energies e = plant.energies();
    const double was_j = 0.5 * p.motor.inertia_kgm2 * 200.0 * 200.0;
    QVERIFY(std::abs(e.copper_j + stored_j(e) - e.capacitor_j - was_j) < 1e-3 * was_j);
}

QTEST_APPLESS_MAIN(TestPlantBridge)
#include "tst_plant_bridge.moc"
