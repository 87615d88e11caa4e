// What the plant's converters, encoder and Hall sensors say, against the true state behind them.
#include "support/plant_drive.h"

#include <QTest>

#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace plant_drive;
using simulation::HallReading;
using simulation::Plant;
using simulation::PlantParameters;

namespace {

PlantParameters quiet()
{
    PlantParameters p = plain();
    p.inverter.noise_digits = p.inverter.busNoise_v = p.inverter.heatsinkNoise_c = 0.0;
    return p;
}

/// Current in one direction until it stands: `amps` in phase A, minus half in B and C.
Plant standing(PlantParameters p, double amps)
{
    Plant plant(locked(p), 1);
    for (int i = 0; i < 3200; ++i) {
        plant.setBridge(vector(0.0, amps * p.motor.rs_ohm, 0.0, plant.trueBus_v()));
        plant.advance(kPeriod_s);
    }
    return plant;
}

} // namespace

class TestPlantSensing : public QObject {
    Q_OBJECT

private slots:
    void aPositiveCurrentLowersItsReadingByItsDigits();
    void amplifierOffsetMovesBothReadings();
    void fewerBitsMeanCoarserSteps();
    void readingsEndAtTheConvertersRange();
    void noiseIsEvenAndBounded();
    void busAndHeatsinkComeInSteps();
    void theHeatsinkWarmsByTheInvertersLosses();
    void phasesFollowInTurn();
    void theEncoderCountsTheRotorsAngle();
    void theEncoderCountsDownBackwardsThroughZero();
    void hallCodesNameTheSector();
    void hallEdgesAreTimedWithinASubStep();
    void hallEdgesCountBothWays();
    void whatIsNotThereReadsZero();
    void theSameSeedGivesTheSameNumbers();
    void anotherSeedRestsElsewhere();
};

void TestPlantSensing::aPositiveCurrentLowersItsReadingByItsDigits()
{
    const Plant plant = standing(quiet(), 6.0);
    const double perAmp = 65536.0 * 0.003 * 9.14 / 3.3;
    QVERIFY(std::abs(plant.phases_a().a - 6.0) < 0.01);
    QCOMPARE(plant.currentA(), std::uint16_t(std::lround(32768.0 - plant.phases_a().a * perAmp)));
    QCOMPARE(plant.currentB(), std::uint16_t(std::lround(32768.0 - plant.phases_a().b * perAmp)));
    QVERIFY(plant.currentA() < 32768 - 3200 && plant.currentB() > 32768 + 1600);
}

void TestPlantSensing::amplifierOffsetMovesBothReadings()
{
    PlantParameters p = quiet();
    p.inverter.offset_digits = -120.0;
    const Plant plant(p, 1);
    QCOMPARE(plant.currentA(), std::uint16_t(32768 - 120));
    QCOMPARE(plant.currentB(), std::uint16_t(32768 - 120));
}

void TestPlantSensing::fewerBitsMeanCoarserSteps()
{
    PlantParameters p = quiet();
    p.inverter.converterBits = 12;
    p.inverter.noise_digits = 40.0;
    Plant plant(p, 1);
    std::set<int> seen;
    for (int i = 0; i < 1000; ++i) {
        plant.advance(kPeriod_s);
        QCOMPARE(plant.currentA() % 16, 0);
        seen.insert(plant.currentA());
    }
    QVERIFY(seen.size() >= 5);
}

void TestPlantSensing::readingsEndAtTheConvertersRange()
{
    PlantParameters p = quiet();
    p.inverter.amplifierGain = 91.4; // 6 A full scale
    QCOMPARE(standing(p, 20.0).currentA(), std::uint16_t(0));
    QCOMPARE(standing(p, -20.0).currentA(), std::uint16_t(65535));
    p.inverter.converterBits = 12;
    QCOMPARE(standing(p, -20.0).currentA(), std::uint16_t(65520));
}

void TestPlantSensing::noiseIsEvenAndBounded()
{
    PlantParameters p = quiet();
    p.inverter.noise_digits = 4.0;
    Plant plant(p, 9);
    std::array<int, 9> counts{};
    double together = 0.0;
    for (int i = 0; i < 40'000; ++i) {
        plant.advance(kPeriod_s);
        const int a = plant.currentA() - 32768, b = plant.currentB() - 32768;
        QVERIFY(std::abs(a) <= 4 && std::abs(b) <= 4);
        const int row = a + 4;
        ++counts[static_cast<std::size_t>(row)];
        together += a * b;
    }
    for (std::size_t i = 1; i < 8; ++i)
        QVERIFY(std::abs(counts[i] - 5000) < 350);
    QVERIFY(std::abs(together / 40'000.0) < 0.1); // A and B are independent
}

void TestPlantSensing::busAndHeatsinkComeInSteps()
{
    const PlantParameters p = quiet();
    const Plant plant(p, 1);
    const double step_v = p.inverter.busRange_v / 4096.0;
    QVERIFY(std::abs(plant.bus_v() - plant.trueBus_v()) <= 0.5 * step_v);
    QVERIFY(std::abs(std::remainder(plant.bus_v(), step_v)) < 1e-9);
    QCOMPARE(plant.heatsink_c(), 20.0);
}

void TestPlantSensing::theHeatsinkWarmsByTheInvertersLosses()
{
    PlantParameters p = locked(quiet());
    p.inverter.switchResistance_ohm = 0.1;
    p.inverter.heatsinkCapacity_jpk = 1.0;
    p.inverter.heatsinkResistance_kpw = 2.0;
    Plant plant(p, 1);
    for (int i = 0; i < 16000 * 20; ++i) {
        plant.setBridge(vector(0.0, 4.5, 0.0, plant.trueBus_v()));
        plant.advance(kPeriod_s);
    }
    const double amps = 4.5 / 0.45;
    QVERIFY(std::abs(plant.heatsink_c() - 20.0 - 2.0 * 1.5 * 0.1 * amps * amps) < 0.3);
}

void TestPlantSensing::phasesFollowInTurn()
{
    // With positive speed B comes 120 degrees after A, and the angle is that of the q axis from phase A.
    Plant plant(plain(), 1);
    steps(plant, 0.0, 6.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        step(plant, 0.0, 6.0);
        const double angle = plant.angle_rad();
        const auto phase = [&](double at) {
            return plant.iq_a() * std::cos(angle - at) + plant.id_a() * std::sin(angle - at);
        };
        QVERIFY(std::abs(plant.phases_a().a - phase(0.0)) < 1e-6);
        QVERIFY(std::abs(plant.phases_a().b - phase(kTurn / 3.0)) < 1e-6);
        QVERIFY(std::abs(plant.phases_a().c - phase(2.0 * kTurn / 3.0)) < 1e-6);
    }
    QVERIFY(plant.speed_radps() > 100.0);
}

void TestPlantSensing::theEncoderCountsTheRotorsAngle()
{
    PlantParameters p = quiet();
    p.sensors.encoderPulses = 1000;
    Plant plant(p, 4);
    QCOMPARE(plant.encoderCount(), std::uint16_t(0));
    const double zero = plant.rotor_rad();
    plant.place(4 * (zero + 1e-6), 200.0);
    int wraps = 0, last = plant.encoderCount();
    for (int i = 0; i < 8000; ++i) {
        plant.advance(kPeriod_s);
        const int count = plant.encoderCount();
        QVERIFY(count < 4000);
        const double turned = plant.rotor_rad() - zero;
        const double expected = (turned - kTurn * std::floor(turned / kTurn)) / kTurn * 4000.0;
        QVERIFY(count <= expected && count + 1.0 >= expected);
        wraps += count < last ? 1 : 0;
        last = count;
    }
    QVERIFY(wraps >= 1);
}

void TestPlantSensing::theEncoderCountsDownBackwardsThroughZero()
{
    PlantParameters p = quiet();
    p.sensors.encoderPulses = 256;
    Plant plant(p, 4);
    plant.place(4 * plant.rotor_rad(), -20.0);
    for (int i = 0; i < 20; ++i)
        plant.advance(kPeriod_s);
    QVERIFY(plant.encoderCount() > 1000 && plant.encoderCount() < 1024);
}

void TestPlantSensing::hallCodesNameTheSector()
{
    PlantParameters p = quiet();
    p.sensors.hall = true;
    p.sensors.hallPlacement_deg = 300.0;
    Plant plant(p, 1);
    const std::array<unsigned, 6> forward{5, 1, 3, 2, 6, 4};
    for (int sector = 0; sector < 6; ++sector) {
        for (const double within_deg : {0.5, 30.0, 59.5}) {
            plant.place((300.0 + 60.0 * sector + within_deg) * kTurn / 360.0);
            QCOMPARE(plant.hall().code, forward[static_cast<std::size_t>(sector)]);
        }
    }
}

void TestPlantSensing::hallEdgesAreTimedWithinASubStep()
{
    PlantParameters p = quiet();
    p.sensors.hall = true;
    p.motor.coulomb_nm = p.motor.viscous_nms = 0.0;
    Plant plant(p, 1);
    const double speed_radps = 123.0;
    plant.place(0.1, speed_radps);
    const double between_s = kTurn / 6.0 / (4 * speed_radps);
    for (int i = 0; i < 2000; ++i) {
        plant.advance(kPeriod_s);
        const HallReading hall = plant.hall();
        QVERIFY(hall.sinceEdge_s < between_s + 1e-9);
        if (hall.edges >= 2)
            QVERIFY(std::abs(hall.lastPeriod_s - between_s) < 1e-8);
        if (hall.edges >= 1) { // and the angle follows from the time since the edge
            const double in_rad = std::remainder(plant.angle_rad(), kTurn / 6.0);
            const double since_rad = hall.sinceEdge_s * 4 * speed_radps;
            QVERIFY(std::abs(std::remainder(in_rad - since_rad, kTurn / 6.0)) < 1e-6);
        }
    }
    QCOMPARE(plant.hall().edges,
        std::uint32_t(std::floor((0.1 + 2000 * kPeriod_s * 4 * speed_radps) / (kTurn / 6.0))));
}

void TestPlantSensing::hallEdgesCountBothWays()
{
    PlantParameters p = quiet();
    p.sensors.hall = true;
    Plant plant(p, 1);
    plant.place(0.05, -40.0);
    std::vector<unsigned> codes{plant.hall().code};
    for (int i = 0; i < 1600; ++i) {
        plant.advance(kPeriod_s);
        if (plant.hall().code != codes.back())
            codes.push_back(plant.hall().code);
    }
    QVERIFY(codes.size() > 6);
    QCOMPARE(plant.hall().edges, std::uint32_t(codes.size() - 1));
    QCOMPARE((std::vector(codes.begin(), codes.begin() + 7)),
        (std::vector<unsigned>{1, 5, 4, 6, 2, 3, 1}));
}

void TestPlantSensing::whatIsNotThereReadsZero()
{
    Plant plant(quiet(), 1);
    plant.place(0.0, 100.0);
    for (int i = 0; i < 1000; ++i)
        plant.advance(kPeriod_s);
    QCOMPARE(plant.encoderCount(), std::uint16_t(0));
    QCOMPARE(plant.hall().code, 0U);
    QCOMPARE(plant.hall().edges, 0U);
}

void TestPlantSensing::theSameSeedGivesTheSameNumbers()
{
    const auto readings = [](std::uint64_t seed) {
        Plant plant(PlantParameters{}, seed);
        std::vector<std::uint16_t> all;
        for (int i = 0; i < 2000; ++i) {
            step(plant, 0.0, 5.0 * i / 2000.0);
            all.push_back(plant.currentA());
            all.push_back(plant.currentB());
        }
        return all;
    };
    QVERIFY(readings(77) == readings(77));
    QVERIFY(readings(77) != readings(78));
}

void TestPlantSensing::anotherSeedRestsElsewhere()
{
    std::array<int, 6> sectors{};
    for (std::uint64_t seed = 0; seed < 600; ++seed)
        ++sectors[static_cast<std::size_t>(
            Plant(PlantParameters{}, seed).angle_rad() / kTurn * 6.0)];
    for (const int count : sectors)
        QVERIFY(count > 60 && count < 140);
}

QTEST_APPLESS_MAIN(TestPlantSensing)
#include "tst_plant_sensing.moc"
