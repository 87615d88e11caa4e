// Encoder and Hall sensors in front of a rotor that turns as a test says: angles, averaged speeds, what is believed.
#include "simulation/maths/encoder_sensor.h"
#include "simulation/maths/hall_sensor.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace simulation;

namespace {

constexpr double kSampling_hz = 16000.0;
constexpr int kTicksPerMedium = 16;
constexpr int kPairs = 4;

/// Degrees from `is` (65536 a turn) to `turns`, the short way.
double degreesOff(std::int16_t is, double turns)
{
    return 360.0 * std::remainder(is / 65536.0 - turns, 1.0);
}

/// A shaft and a counter of `counts` a turn behind it.
struct EncoderBench {
    EncoderSensor sensor;
    int counts, range;
    double shaft_turns = 0.0, speed_hz = 0.0;
    int tick = 0;

    explicit EncoderBench(const EncoderSensor::Parameters &p)
        : sensor(p)
        , counts(p.countsPerTurn)
        , range(p.counterRange)
    {
    }
    std::uint16_t count() const
    {
        const double turns = shaft_turns * counts / range;
        return static_cast<std::uint16_t>((turns - std::floor(turns)) * range);
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * kSampling_hz)); ++i) {
            shaft_turns += speed_hz / kSampling_hz;
            sensor.step(count());
            if (++tick % kTicksPerMedium == 0)
                sensor.mediumTask();
        }
    }
    double electricalTurns() const { return std::floor(shaft_turns * counts) / counts * kPairs; }
};

/// Three switches and the timer that captures their edges, exact.
struct HallBench {
    HallSensor sensor;
    HallCapture capture;
    double turns = 0.02, speed_hz = 0.0, shift_turns = 0.0; ///< electrical
    double now_s = 0.0, edge_s = 0.0;
    int tick = 0;

    explicit HallBench(const HallSensor::Parameters &p)
        : sensor(p)
        , shift_turns(p.phaseShift / 65536.0)
    {
        capture.code = code();
    }
    unsigned code() const
    {
        constexpr std::array<unsigned, 6> kCodes{5, 1, 3, 2, 6, 4};
        const double at = turns - shift_turns;
        return kCodes[static_cast<std::size_t>((at - std::floor(at)) * 6.0) % 6];
    }
    void step()
    {
        const double before = (turns - shift_turns) * 6.0;
        turns += speed_hz / kSampling_hz;
        now_s += 1.0 / kSampling_hz;
        const double after = (turns - shift_turns) * 6.0;
        if (std::floor(before) != std::floor(after)) {
            const double border = after > before ? std::floor(after) : std::floor(before);
            const double at_s = now_s - (after - border) / (6.0 * speed_hz);
            capture.lastPeriod_s = at_s - edge_s;
            edge_s = at_s;
            ++capture.edges;
        }
        capture.sinceEdge_s = now_s - edge_s;
        capture.code = code();
        sensor.step(capture);
        if (++tick % kTicksPerMedium == 0)
            sensor.mediumTask();
    }
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(std::lround(seconds * kSampling_hz)); ++i)
            step();
    }
    double worst_degrees(double seconds)
    {
        double worst = 0.0;
        for (int i = 0; i < static_cast<int>(std::lround(seconds * kSampling_hz)); ++i) {
            step();
            worst = std::max(worst, std::abs(degreesOff(sensor.angle(), turns)));
        }
        return worst;
    }
};

} // namespace

class TestMathsSensors : public QObject {
    Q_OBJECT

private slots:
    void theEncoderFollowsTheShaft_data();
    void theEncoderFollowsTheShaft();
    void anAlignmentSaysWhereZeroIs();
    void theEncodersSpeedIsTheMeanOfItsDepth();
    void clearingAnEncoderKeepsItsAlignment();
    void anEncoderTooFastIsNotBelieved();
    void theHallAngleRunsOnBetweenTheEdges_data();
    void theHallAngleRunsOnBetweenTheEdges();
    void aStandingHallSensorKnowsItsSector();
    void aHallSensorThatTurnsBackStartsAveragingAnew();
    void withoutEdgesTheHallSpeedIsZero();
    void impossibleHallCodesAreNotBelieved();
    void skippedHallSectorsAreNotBelieved();
};

void TestMathsSensors::theEncoderFollowsTheShaft_data()
{
    QTest::addColumn<int>("counts");
    QTest::addColumn<int>("range");
    QTest::addColumn<double>("speed");
    for (const int counts : {48, 4000, 4096, 16384})
        for (const int range : {counts, 65536})
            for (const double speed : {7.3, -33.4, 100.0})
                QTest::addRow("%d counts, counter of %d, %g Hz", counts, range, speed)
                    << counts << range << speed;
}

void TestMathsSensors::theEncoderFollowsTheShaft()
{
    QFETCH(int, counts);
    QFETCH(int, range);
    QFETCH(double, speed);
    EncoderBench bench({.countsPerTurn = counts,
        .counterRange = range,
        .polePairs = kPairs,
        .range = {.max_dHz = 2000}});
    bench.run(1.0 / kSampling_hz);
    bench.speed_hz = speed;
    for (int i = 0; i < 16000; ++i) {
        bench.run(1.0 / kSampling_hz);
        const double off = degreesOff(bench.sensor.angle(), bench.electricalTurns());
        // where the counter begins anew at 65536, a count more or less by the rounding of this bench
        QVERIFY2(
            std::abs(off) < 360.0 * kPairs / counts + 0.01, QByteArray::number(off).constData());
    }
    const double mean = speed * 10.0, count = 10.0 * 1000.0 / (counts * 16.0);
    QVERIFY(std::abs(bench.sensor.speed_dHz() - mean) < count + 1.0);
    const double dpp = speed * kPairs * 65536.0 / kSampling_hz;
    QVERIFY(std::abs(bench.sensor.speed_dpp() - dpp)
        < 65536.0 * kPairs / counts / kTicksPerMedium + 1.0);
    QVERIFY(bench.sensor.reliable());
}

void TestMathsSensors::anAlignmentSaysWhereZeroIs()
{
    EncoderBench bench({.countsPerTurn = 4000, .polePairs = kPairs});
    bench.speed_hz = 11.0;
    bench.run(0.1234);
    bench.sensor.align(-20000);
    QCOMPARE(bench.sensor.angle(), std::int16_t{-20000});
    const double was = bench.shaft_turns;
    bench.run(0.05);
    const double expected = -20000.0 / 65536.0 + (bench.shaft_turns - was) * kPairs;
    QVERIFY(std::abs(degreesOff(bench.sensor.angle(), expected)) < 360.0 * kPairs / 4000.0 + 0.1);
    bench.sensor.align(0);
    QCOMPARE(bench.sensor.mechanicalAngle(), std::int16_t{0});
    bench.speed_hz = 1.0;
    bench.run(0.25);
    QVERIFY(std::abs(degreesOff(bench.sensor.mechanicalAngle(), 0.25)) < 0.2);
}

void TestMathsSensors::theEncodersSpeedIsTheMeanOfItsDepth()
{
    EncoderSensor sensor({.countsPerTurn = 1000, .polePairs = 2, .depth = 4});
    std::uint16_t count = 0;
    sensor.step(count);
    for (const int moved : {10, 20, 30, 45}) {
        count = static_cast<std::uint16_t>(count + moved);
        sensor.step(count);
        sensor.mediumTask();
    }
    QCOMPARE(sensor.speed_dHz(), std::int16_t{262}); // 105 / 4 counts a ms: 26.25 Hz
    QCOMPARE(sensor.speed_dpp(), std::int16_t{368}); // 45 a ms: 90 Hz electrical, of 16000 periods
    count = static_cast<std::uint16_t>(count - 115);
    sensor.step(count);
    sensor.mediumTask();
    QCOMPARE(sensor.speed_dHz(), std::int16_t{-50});
}

void TestMathsSensors::clearingAnEncoderKeepsItsAlignment()
{
    EncoderBench bench({.countsPerTurn = 4000, .polePairs = kPairs});
    bench.speed_hz = 11.0;
    bench.run(0.1);
    bench.sensor.align(1000);
    bench.sensor.clear();
    QCOMPARE(bench.sensor.speed_dHz(), std::int16_t{0});
    bench.sensor.step(bench.count());
    QCOMPARE(bench.sensor.angle(), std::int16_t{1000});
}

void TestMathsSensors::anEncoderTooFastIsNotBelieved()
{
    EncoderBench bench({.countsPerTurn = 4000, .polePairs = kPairs, .range = {.max_dHz = 500}});
    bench.speed_hz = 49.0;
    bench.run(0.1);
    QVERIFY(bench.sensor.reliable());
    bench.speed_hz = 51.0;
    bench.run(0.1);
    QVERIFY(!bench.sensor.reliable());
    bench.speed_hz = 10.0;
    bench.run(0.1);
    QVERIFY(!bench.sensor.reliable());
    bench.sensor.clear();
    bench.run(0.1);
    QVERIFY(bench.sensor.reliable());
}

void TestMathsSensors::theHallAngleRunsOnBetweenTheEdges_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<int>("shift");
    for (const double speed : {12.0, 133.0, -133.0, 500.0})
        for (const int shift : {0, 10923, -20000})
            QTest::addRow("%g Hz, shifted by %d", speed, shift) << speed << shift;
}

void TestMathsSensors::theHallAngleRunsOnBetweenTheEdges()
{
    QFETCH(double, speed);
    QFETCH(int, shift);
    HallBench bench({.polePairs = kPairs,
        .phaseShift = static_cast<std::int16_t>(shift),
        .range = {.max_dHz = 2000}});
    bench.speed_hz = speed;
    bench.run(1.0);
    const double worst = bench.worst_degrees(0.2);
    // at an edge it is up to a period late, between them a digit of speed a period wrong
    const double bound = 1.0 + 360.0 * std::abs(speed) / kSampling_hz
        + 60.0 / (std::abs(speed) * 65536.0 / kSampling_hz);
    QVERIFY2(worst < bound, QByteArray::number(worst).constData());
    const double dpp_dHz = kSampling_hz * 10.0 / 65536.0 / kPairs;
    QVERIFY(std::abs(bench.sensor.speed_dHz() - speed * 10.0 / kPairs) < dpp_dHz + 1.0);
    QVERIFY(bench.sensor.reliable());
}

void TestMathsSensors::aStandingHallSensorKnowsItsSector()
{
    for (int sector = 0; sector < 6; ++sector) {
        HallBench bench({.polePairs = kPairs});
        bench.turns = (sector + 0.3) / 6.0;
        bench.run(0.01);
        QVERIFY(std::abs(degreesOff(bench.sensor.angle(), (sector + 0.5) / 6.0)) < 0.1);
        QCOMPARE(bench.sensor.speed_dHz(), std::int16_t{0});
    }
}

void TestMathsSensors::aHallSensorThatTurnsBackStartsAveragingAnew()
{
    HallBench bench({.polePairs = kPairs});
    bench.speed_hz = 100.0;
    bench.run(0.1);
    QVERIFY(bench.sensor.speed_dpp() > 400);
    bench.speed_hz = -50.0;
    bench.run(0.0035); // one edge back
    QCOMPARE(bench.sensor.speed_dpp(), std::int16_t{0});
    QVERIFY(std::abs(degreesOff(bench.sensor.angle(), bench.turns)) < 31.0);
    bench.run(0.1);
    QVERIFY(std::abs(bench.sensor.speed_dpp() + 205) <= 1);
    QVERIFY(bench.sensor.reliable());
}

void TestMathsSensors::withoutEdgesTheHallSpeedIsZero()
{
    HallBench bench({.polePairs = kPairs, .timeout_s = 0.15});
    bench.speed_hz = 100.0;
    bench.run(0.1);
    bench.speed_hz = 0.0;
    bench.run(0.14);
    QVERIFY(bench.sensor.speed_dHz() > 0); // still believed
    // No further than its sector.
    QVERIFY(std::abs(degreesOff(bench.sensor.angle(), bench.turns)) < 61.0);
    bench.run(0.02);
    QCOMPARE(bench.sensor.speed_dHz(), std::int16_t{0});
    bench.speed_hz = 100.0;
    bench.run(0.1);
    QVERIFY(bench.worst_degrees(0.1) < 5.0);
}

void TestMathsSensors::impossibleHallCodesAreNotBelieved()
{
    for (const unsigned code : {0U, 7U}) {
        HallBench bench({.polePairs = kPairs});
        bench.speed_hz = 100.0;
        bench.run(0.1);
        QVERIFY(bench.sensor.reliable());
        for (int i = 0; i < 3; ++i)
            bench.sensor.step({.code = code, .edges = bench.capture.edges});
        QVERIFY(!bench.sensor.reliable());
        bench.sensor.clear();
        bench.run(0.1);
        QVERIFY(bench.sensor.reliable());
    }
}

void TestMathsSensors::skippedHallSectorsAreNotBelieved()
{
    HallSensor sensor({.polePairs = kPairs});
    HallCapture capture{.code = 5, .lastPeriod_s = 1e-3};
    sensor.step(capture);
    for (const unsigned code : {3U, 6U, 5U}) { // every second
        QVERIFY(sensor.reliable());
        capture.code = code;
        ++capture.edges;
        sensor.step(capture);
    }
    QVERIFY(!sensor.reliable());
}

QTEST_APPLESS_MAIN(TestMathsSensors)
#include "tst_maths_sensors.moc"
