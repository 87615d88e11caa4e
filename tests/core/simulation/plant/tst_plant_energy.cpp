// Where a simulated drive's energy goes: each side of the ledger is summed by itself, so they can disagree.
#include "simulation/plant/presets.h"
#include "support/plant_drive.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace plant_drive;
using simulation::Energies;
using simulation::LoadParameters;
using simulation::Plant;
using simulation::PlantParameters;
using simulation::Preset;

namespace {

struct Books {
    double bus, bridge, shaft; ///< what is missing on each side, in joules
};

Books missing(const Energies &from, const Energies &to)
{
    const auto rise = [&](double Energies::*member) { return to.*member - from.*member; };
    return {rise(&Energies::supply_j) - rise(&Energies::source_j) - rise(&Energies::board_j)
            - rise(&Energies::bridge_j) - rise(&Energies::capacitor_j),
        rise(&Energies::bridge_j) - rise(&Energies::inverter_j) - rise(&Energies::copper_j)
            - rise(&Energies::mechanical_j) - rise(&Energies::field_j),
        rise(&Energies::mechanical_j) + rise(&Energies::driven_j) - rise(&Energies::friction_j)
            - rise(&Energies::load_j) - rise(&Energies::kinetic_j) - rise(&Energies::cogging_j)};
}

double held_j(const Energies &e) { return e.capacitor_j + e.field_j + e.kinetic_j + e.cogging_j; }

/// What the supply put into the bus.
double fed_j(const Energies &from, const Energies &to)
{
    return to.supply_j - from.supply_j - (to.source_j - from.source_j);
}

struct Draw {
    simulation::Noise noise{20};
    double between(double low, double high) { return low + (high - low) * noise.share(); }
};

} // namespace

class TestPlantEnergy : public QObject {
    Q_OBJECT

private slots:
    void everyPresetsBooksBalance_data() { presetNames(); }
    void everyPresetsBooksBalance();
    void electricalPowerIsMechanicalAndLosses_data() { presetNames(); }
    void electricalPowerIsMechanicalAndLosses();
    void anOpenBridgeNeverCreatesEnergy_data() { presetNames(); }
    void anOpenBridgeNeverCreatesEnergy();
    void wildDutiesNeverCreateEnergy_data() { presetNames(); }
    void wildDutiesNeverCreateEnergy();

private:
    static void presetNames();
};

void TestPlantEnergy::presetNames()
{
    QTest::addColumn<const Preset *>("preset");
    for (const Preset &preset : simulation::presets())
        QTest::newRow(preset.parameters.motor.name.c_str()) << &preset;
}

void TestPlantEnergy::everyPresetsBooksBalance()
{
    QFETCH(const Preset *, preset);
    const PlantParameters &p = preset->parameters;
    Plant plant(p, 3);
    const Energies start = plant.energies();
    for (int i = 0; i < 16000; ++i) {
        const double ramp = std::min(1.0, i / 8000.0);
        step(plant, 0.0, 0.35 * p.inverter.supply_v * ramp);
    }
    const Energies end = plant.energies();
    QVERIFY(plant.speed_radps() > 0.3 * p.motor.maxSpeed_rpm * kTurn / 60.0);
    const Books gone = missing(start, end);
    QVERIFY(std::abs(gone.bus) < 1e-4 * end.supply_j);
    QVERIFY(std::abs(gone.bridge) < 1e-3 * end.bridge_j);
    QVERIFY(std::abs(gone.shaft) < 1e-4 * end.mechanical_j);
}

void TestPlantEnergy::electricalPowerIsMechanicalAndLosses()
{
    // As a bench would do it, without the ledger: instruments at the supply, at the shaft and on the phases.
    QFETCH(const Preset *, preset);
    PlantParameters p = preset->parameters;
    p.motor.copperMass_kg = 0.0; // nothing drifts
    p.inverter.busCapacitance_f = 0.1; // an instrument that averages over many periods
    const double volts = 0.4 * p.inverter.supply_v;
    const double ke_v = p.motor.polePairs * p.motor.flux_wb;
    p.load = {.constant_nm = 0.5 * 1.5 * ke_v * p.motor.nominal_a};
    Plant plant(p, 3);
    const auto turn = [&](double vq_v) {
        const double we = p.motor.polePairs * plant.speed_radps();
        const double damped = 0.25 * p.motor.ld_h / kPeriod_s * plant.id_a(); // keeps d near zero
        step(plant, -we * p.motor.lq_h * plant.iq_a() - damped, vq_v);
    };
    for (int i = 0; i < 32000; ++i)
        turn(volts * std::min(1.0, i / 16000.0));
    double supply_w = 0.0, shaft_w = 0.0, copper_w = 0.0, inverter_w = 0.0;
    constexpr int kCount = 16000;
    const double share = p.inverter.deadTime_s / kPeriod_s;
    for (int i = 0; i < kCount; ++i) {
        turn(volts);
        const double bus_v = plant.trueBus_v();
        supply_w += bus_v
            * ((p.inverter.supply_v - bus_v) / p.inverter.supplyResistance_ohm
                - bus_v / p.inverter.bleeder_ohm);
        shaft_w += plant.torque_nm() * plant.speed_radps();
        const auto i_a = plant.phases_a();
        const double square = i_a.a * i_a.a + i_a.b * i_a.b + i_a.c * i_a.c;
        copper_w += square * p.motor.rs_ohm * (1.0 + 0.00393 * (p.inverter.ambient_c - 20.0));
        inverter_w += square * p.inverter.switchResistance_ohm
            + 2.0 * share * p.inverter.diodeDrop_v
                * (std::abs(i_a.a) + std::abs(i_a.b) + std::abs(i_a.c));
    }
    QVERIFY(shaft_w / kCount > 5.0);
    const double out_w = shaft_w + copper_w + inverter_w;
    QVERIFY2(
        std::abs(supply_w / out_w - 1.0) < 0.02, qPrintable(QString::number(supply_w / out_w)));
    // and what the shaft got went into friction and load
    const double w = plant.speed_radps();
    const double against_w =
        w * (p.motor.coulomb_nm + p.load.constant_nm + p.motor.viscous_nms * w);
    QVERIFY(std::abs(shaft_w / kCount / against_w - 1.0) < 0.02);
}

void TestPlantEnergy::anOpenBridgeNeverCreatesEnergy()
{
    QFETCH(const Preset *, preset);
    Draw draw;
    for (int trial = 0; trial < 100; ++trial) {
        PlantParameters p = preset->parameters;
        p.inverter.supplyAbsorbs = trial % 4 == 0;
        p.inverter.busCapacitance_f *= draw.between(0.1, 2.0);
        Plant plant(p, static_cast<std::uint64_t>(trial));
        const double most = 3.0 * p.motor.maxSpeed_rpm * kTurn / 60.0;
        plant.place(draw.between(0.0, kTurn), draw.between(-most, most));
        const int driven = static_cast<int>(draw.between(0.0, 12.0));
        for (int i = 0; i < driven; ++i) {
            plant.setBridge(
                {true, draw.between(0.0, 1.0), draw.between(0.0, 1.0), draw.between(0.0, 1.0)});
            plant.advance(kPeriod_s);
        }
        plant.setBridge({});
        const Energies opened = plant.energies();
        Energies last = opened;
        for (int i = 0; i < 300; ++i) {
            const double before_radps = std::abs(plant.speed_radps());
            plant.advance(kPeriod_s);
            const Energies now = plant.energies();
            QVERIFY(now.bridge_j <= last.bridge_j); // a diode takes nothing out of the bus
            // Speed and current are half a step apart: for a moment a balance may lack what one step moves.
            const double moment = 1e-9
                + (std::abs(now.mechanical_j - last.mechanical_j)
                      + std::abs(now.bridge_j - last.bridge_j)
                      + std::abs(now.field_j - last.field_j))
                    / Plant::kSubSteps
                + 1.5 * p.motor.cogging_nm * std::max(before_radps, std::abs(plant.speed_radps()))
                    * Plant::kMaxStep_s;
            const Books gone = missing(last, now);
            QVERIFY(gone.bridge >= -moment);
            QVERIFY(std::abs(gone.shaft) <= moment);
            QVERIFY(held_j(now) - held_j(last) <= fed_j(last, now) + moment);
            last = now;
        }
        // Moments do not add up.
        const double most_j = 1e-5 * (opened.kinetic_j + opened.field_j);
        QVERIFY(missing(opened, last).bridge >= -most_j);
        QVERIFY(held_j(last) - held_j(opened) <= fed_j(opened, last) + most_j);
    }
}

void TestPlantEnergy::wildDutiesNeverCreateEnergy()
{
    // Duties at random, bridge on and off, load and drive changing: over any stretch the books close to a few percent
    // of what passed through, and never in favour of the motor by more than that.
    QFETCH(const Preset *, preset);
    Draw draw;
    Plant plant(preset->parameters, 11);
    const auto &m = preset->parameters.motor;
    const double torque = 1.5 * m.polePairs * m.flux_wb * m.nominal_a;
    Energies last = plant.energies();
    for (int stretch = 0; stretch < 200; ++stretch) {
        plant.setLoad(LoadParameters{.constant_nm = draw.between(0.0, torque),
            .fan_nms2 = 0.0,
            .drive_nm = draw.between(-torque, torque)});
        double passed = 0.0;
        for (int i = 0; i < 160; ++i) {
            plant.setBridge({draw.between(0.0, 1.0) > 0.2, draw.between(0.3, 0.7),
                draw.between(0.3, 0.7), draw.between(0.3, 0.7)});
            const double before = plant.energies().bridge_j;
            plant.advance(kPeriod_s);
            passed += std::abs(plant.energies().bridge_j - before)
                + std::abs(plant.torque_nm() * plant.speed_radps()) * kPeriod_s;
        }
        const Energies now = plant.energies();
        const Books gone = missing(last, now);
        QVERIFY(std::abs(gone.bus) <= 0.03 * passed + 1e-6);
        QVERIFY(gone.bridge >= -0.03 * passed);
        QVERIFY(std::abs(gone.shaft) <= 0.01 * passed + 1e-6);
        last = now;
    }
}

QTEST_APPLESS_MAIN(TestPlantEnergy)
#include "tst_plant_energy.moc"
