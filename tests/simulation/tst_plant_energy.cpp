// Where a simulated drive's energy goes: each side of the ledger is summed by itself, so they can disagree.
#include "simulation/plant/plant.h"
#include "simulation/plant/presets.h"

#include <QTest>

#include <cmath>
#include <numbers>

using simulation::Bridge;
using simulation::Energies;
using simulation::Plant;
using simulation::PlantParameters;
using simulation::Preset;

namespace {

constexpr double kPeriod_s = 1.0 / 16000.0;
constexpr double kTurn = 2.0 * std::numbers::pi;

/// Sine duties in the rotor's own angle, as a perfect sensor would give.
Bridge turning(const Plant &plant, double vd_v, double vq_v)
{
    const double angle = plant.angle_rad()
        + 1.5 * kPeriod_s * plant.speed_radps() * plant.parameters().motor.polePairs;
    const double bus_v = plant.trueBus_v();
    const auto leg = [&](double phase) {
        return 0.5 + (vq_v * std::cos(angle - phase) + vd_v * std::sin(angle - phase)) / bus_v;
    };
    return {.on = true, .a = leg(0.0), .b = leg(kTurn / 3.0), .c = leg(2.0 * kTurn / 3.0)};
}

struct Books {
    double bus, bridge, shaft; ///< what is missing on each side, in joules
};

Books missing(const Energies &from, const Energies &to)
{
    return {to.supply_j - from.supply_j - (to.source_j - from.source_j)
            - (to.board_j - from.board_j) - (to.bridge_j - from.bridge_j)
            - (to.capacitor_j - from.capacitor_j),
        to.bridge_j - from.bridge_j - (to.inverter_j - from.inverter_j)
            - (to.copper_j - from.copper_j) - (to.mechanical_j - from.mechanical_j)
            - (to.field_j - from.field_j),
        to.mechanical_j - from.mechanical_j + (to.driven_j - from.driven_j)
            - (to.friction_j - from.friction_j) - (to.load_j - from.load_j)
            - (to.kinetic_j - from.kinetic_j) - (to.cogging_j - from.cogging_j)};
}

} // namespace

class TestPlantEnergy : public QObject {
    Q_OBJECT

private slots:
    void everyPresetsBooksBalance_data();
    void everyPresetsBooksBalance();
};

void TestPlantEnergy::everyPresetsBooksBalance_data()
{
    QTest::addColumn<QString>("name");
    for (const Preset &preset : simulation::presets()) {
        const auto name = QString::fromUtf8(preset.name.data(), qsizetype(preset.name.size()));
        QTest::newRow(qPrintable(name)) << name;
    }
}

void TestPlantEnergy::everyPresetsBooksBalance()
{
    QFETCH(QString, name);
    const PlantParameters &p = *simulation::findPreset(name.toStdString());
    Plant plant(p, 3);
    const Energies start = plant.energies();
    for (int i = 0; i < 16000; ++i) {
        const double ramp = std::min(1.0, i / 8000.0);
        plant.setBridge(turning(plant, 0.0, 0.35 * p.inverter.supply_v * ramp));
        plant.advance(kPeriod_s);
    }
    const Energies end = plant.energies();
    QVERIFY(plant.speed_radps() > 0.3 * p.motor.maxSpeed_rpm * kTurn / 60.0);
    const Books gone = missing(start, end);
    QVERIFY(std::abs(gone.bus) < 1e-3 * end.supply_j);
    QVERIFY(std::abs(gone.bridge) < 2e-3 * end.bridge_j);
    QVERIFY(std::abs(gone.shaft) < 1e-3 * end.mechanical_j);
}

QTEST_APPLESS_MAIN(TestPlantEnergy)
#include "tst_plant_energy.moc"
