// The presets: what issue and users expect of each, and that impossible figures are found.
#include "simulation/plant/plant.h"
#include "simulation/plant/presets.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using simulation::findPreset;
using simulation::impossibleParameter;
using simulation::PlantParameters;
using simulation::Preset;
using simulation::presets;

class TestPlantPresets : public QObject {
    Q_OBJECT

private slots:
    void theFirstIsTheMotorThatBoardsHad();
    void twoAreSensorlessOneHasAnEncoderOneHallOneIsSalient();
    void namesAreShortAndFound();
    void everyOneIsPossible();
    void nominalCurrentReadsWithHeadroom();
    void maximumSpeedIsWithinTheVoltageOrItsWeakening();
    void impossibleFiguresAreNamed();
};

void TestPlantPresets::theFirstIsTheMotorThatBoardsHad()
{
    const PlantParameters &p = presets().front().parameters;
    QCOMPARE(p.motor.polePairs, 4);
    QCOMPARE(p.motor.rs_ohm, 0.35);
    QCOMPARE(p.motor.ld_h, 0.6e-3);
    QCOMPARE(p.motor.flux_wb, 6.5e-3);
    QCOMPARE(p.motor.nominal_a, 5.0);
    QVERIFY(std::abs(p.inverter.maxReadable_a() - 60.175056) < 1e-5);
    QVERIFY(std::abs(p.inverter.digitsPerAmp() - 544.544) < 1e-2);
}

void TestPlantPresets::twoAreSensorlessOneHasAnEncoderOneHallOneIsSalient()
{
    const auto count = [](auto &&has) {
        return std::count_if(presets().begin(), presets().end(),
            [&](const Preset &preset) { return has(preset.parameters); });
    };
    const auto salient = [](const PlantParameters &p) { return p.motor.lq_h > 1.5 * p.motor.ld_h; };
    QCOMPARE(presets().size(), std::size_t(5));
    QCOMPARE(count([](const auto &p) { return p.sensors.encoderPulses > 0; }), 1);
    QCOMPARE(count([](const auto &p) { return p.sensors.hall; }), 1);
    QCOMPARE(count(salient), 1);
    QCOMPARE(count([&](const auto &p) {
        return p.sensors.encoderPulses == 0 && !p.sensors.hall && !salient(p);
    }),
        2);
}

void TestPlantPresets::namesAreShortAndFound()
{
    for (const Preset &preset : presets()) {
        QCOMPARE(findPreset(preset.name), &preset.parameters);
        QVERIFY(preset.name.size() <= 8 && !preset.summary.empty());
        QVERIFY(std::all_of(preset.name.begin(), preset.name.end(),
            [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }));
        QVERIFY(preset.parameters.motor.name.size() <= 23);
    }
    QVERIFY(findPreset("pm2") == nullptr);
    QVERIFY(findPreset("") == nullptr);
}

void TestPlantPresets::everyOneIsPossible()
{
    for (const Preset &preset : presets())
        QVERIFY(impossibleParameter(preset.parameters).empty());
}

void TestPlantPresets::nominalCurrentReadsWithHeadroom()
{
    for (const Preset &preset : presets()) {
        const PlantParameters &p = preset.parameters;
        QVERIFY(p.inverter.maxReadable_a() > 2.0 * p.motor.nominal_a);
        QVERIFY(p.motor.nominal_a * p.inverter.digitsPerAmp() > 1000.0);
        QVERIFY(p.inverter.busRange_v > 1.5 * p.inverter.supply_v);
    }
}

void TestPlantPresets::maximumSpeedIsWithinTheVoltageOrItsWeakening()
{
    for (const Preset &preset : presets()) {
        const auto &m = preset.parameters.motor;
        const double we = m.maxSpeed_rpm / 60.0 * 2.0 * std::numbers::pi * m.polePairs;
        const double volts = we * m.flux_wb,
                     limit = preset.parameters.inverter.supply_v / std::sqrt(3.0);
        if (m.lq_h > m.ld_h)
            QVERIFY(we * (m.flux_wb - m.ld_h * m.nominal_a) < 0.9 * limit);
        else
            QVERIFY(volts < 0.95 * limit);
        QVERIFY(m.maxSpeed_rpm >= 3000.0);
        // and the load leaves some torque at that speed
        const double w = we / m.polePairs;
        const double against =
            m.coulomb_nm + m.viscous_nms * w + preset.parameters.load.fan_nms2 * w * w;
        QVERIFY(against < 0.85 * 1.5 * m.polePairs * m.flux_wb * m.nominal_a);
    }
}

void TestPlantPresets::impossibleFiguresAreNamed()
{
    const auto with = [](auto &&change) {
        PlantParameters p;
        change(p);
        return impossibleParameter(p);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QCOMPARE(with([](auto &p) { p.motor.polePairs = 0; }), std::string_view("polePairs"));
    QCOMPARE(with([](auto &p) { p.motor.ld_h = 0.0; }), std::string_view("ld_h"));
    QCOMPARE(with([&](auto &p) { p.motor.flux_wb = nan; }), std::string_view("flux_wb"));
    QCOMPARE(with([](auto &p) { p.motor.coulomb_nm = -1.0; }), std::string_view("coulomb_nm"));
    QCOMPARE(with([](auto &p) { p.inverter.shunt_ohm = 0.0; }), std::string_view("shunt_ohm"));
    QCOMPARE(with([](auto &p) { p.inverter.busRange_v = 12.0; }), std::string_view("busRange_v"));
    QCOMPARE(
        with([](auto &p) { p.sensors.encoderPulses = 20000; }), std::string_view("encoderPulses"));
    QCOMPARE(with([&](auto &p) { p.load.fan_nms2 = -nan; }), std::string_view("fan_nms2"));
    QVERIFY(with([](auto &) {}).empty());
}

QTEST_APPLESS_MAIN(TestPlantPresets)
#include "tst_plant_presets.moc"
