// The observers in front of a winding with an ideal back-EMF: angle, speed, what they call reliable, when they let a
// start-up pass. The motor here is exact and has no converter, so that an error is the observer's own.
#include "simulation/maths/gains.h"
#include "simulation/maths/sensorless.h"
#include "simulation/maths/transforms.h"
#include "simulation/plant/parameters.h"

#include <QTest>

#include <cmath>
#include <complex>
#include <numbers>

using namespace simulation;

namespace {

constexpr double kHf = 16000.0;
constexpr double kBus_v = 24.0, kFullBus_v = 63.2;
constexpr int kPolePairs = 4;
constexpr double kMaxSpeed_radps = 4000.0 * kTurn / 60.0 * kPolePairs; // electrical

std::int16_t digitsOf(double value) { return saturate16(std::lround(value)); }

/// Resistance, inductance and a sinusoidal back-EMF, in stationary coordinates: a vector is alpha - j beta.
struct Winding {
    double rs_ohm = 0.35, ls_h = 0.6e-3, flux_wb = 6.5e-3;
    double angle_rad = 1.0, speed_radps = 0.0;
    std::complex<double> current_a;

    std::complex<double> bemf_v() const
    {
        return std::polar(1.0, angle_rad) * flux_wb * speed_radps;
    }
    void advance(std::complex<double> voltage_v, double dt_s)
    {
        constexpr int kSteps = 20;
        const double dt = dt_s / kSteps;
        for (int i = 0; i < kSteps; ++i) {
            angle_rad += speed_radps * dt / 2.0;
            current_a += (voltage_v - rs_ohm * current_a - bemf_v()) * (dt / ls_h);
            angle_rad += speed_radps * dt / 2.0;
        }
    }
    /// What keeps `iq_a` in the windings at this speed, its angle that of the middle of the period.
    std::complex<double> voltageFor(double iq_a) const
    {
        const std::complex<double> qd(
            speed_radps * flux_wb + rs_ohm * iq_a, speed_radps * ls_h * iq_a);
        return qd * std::polar(1.0, angle_rad + speed_radps / kHf / 2.0);
    }
};

const CurrentSensing kSensing{.bus_v = kBus_v};

ObserverConstants constants()
{
    const Winding motor;
    return observerGains({.rs_ohm = motor.rs_ohm,
        .ls_h = motor.ls_h,
        .hfHz = kHf,
        .maxCurrent_a = kSensing.maxCurrent_a(),
        .maxBemf_v = 1.2 * kMaxSpeed_radps * motor.flux_wb,
        .maxVoltage_v = kFullBus_v / std::numbers::sqrt3});
}

SpeedEstimateParameters speedParameters()
{
    return {.hfHz = static_cast<std::uint16_t>(kHf),
        .polePairs = kPolePairs,
        .maxReliable_dHz = 767,
        .startUpMinimum_dHz = 60};
}

/// An observer and the winding it looks at, a control period at a time.
template <class Observer>
struct Bench {
    Winding motor;
    Observer observer;
    double iq_a = 3.0;
    int tick = 0;

    explicit Bench(const typename Observer::Parameters &parameters)
        : observer(parameters)
    {
    }

    void step()
    {
        const auto volts = motor.voltageFor(iq_a);
        const double perVolt = 32768.0 * std::numbers::sqrt3 / kBus_v;
        const AlphaBeta voltage{
            digitsOf(volts.real() * perVolt), digitsOf(-volts.imag() * perVolt)};
        const double perAmp = kSensing.digitsPerAmp();
        const AlphaBeta current{
            digitsOf(motor.current_a.real() * perAmp), digitsOf(-motor.current_a.imag() * perAmp)};
        observer.step(
            {voltage, current, static_cast<std::uint16_t>(65536.0 * kBus_v / kFullBus_v)});
        motor.advance(std::complex<double>(voltage.alpha, -voltage.beta) / perVolt, 1.0 / kHf);
        if (++tick % 16 == 0)
            observer.mediumTask();
    }
    void run(double seconds)
    {
        const int ticks = static_cast<int>(std::lround(seconds * kHf));
        for (int i = 0; i < ticks; ++i)
            step();
    }
    double angleError_degrees() const
    {
        const double turns = observer.angle() / 65536.0 - motor.angle_rad / kTurn;
        return 360.0 * std::remainder(turns, 1.0);
    }
    double worstAngleError_degrees(double seconds)
    {
        double worst = 0.0;
        for (int i = 0; i < static_cast<int>(std::lround(seconds * kHf)); ++i) {
            step();
            worst = std::max(worst, std::abs(angleError_degrees()));
        }
        return worst;
    }
    double speed_dHz() const { return motor.speed_radps / kTurn / kPolePairs * 10.0; }
};

ObserverPll::Parameters pllParameters()
{
    return {.observer = constants(),
        .speed = speedParameters(),
        .pll = pllGains(960.0, 0.85, 27300.0, kHf)};
}

ObserverPll::Parameters startUpParameters(std::uint16_t minimum_dHz, int tests)
{
    ObserverPll::Parameters parameters = pllParameters();
    parameters.speed.startUpMinimum_dHz = minimum_dHz;
    parameters.speed.startUpTests = tests;
    return parameters;
}

ObserverCordic::Parameters cordicParameters()
{
    SpeedEstimateParameters speed = speedParameters();
    speed.varianceThreshold = 512;
    return {.observer = constants(), .speed = speed};
}

} // namespace

class TestMathsObserver : public QObject {
    Q_OBJECT

private slots:
    void thePllFindsTheAngleFromAnywhere_data();
    void thePllFindsTheAngleFromAnywhere();
    void theCordicFindsTheAngleFromAnywhere_data();
    void theCordicFindsTheAngleFromAnywhere();
    void theEstimatedCurrentsAndBackEmfAreThose();
    void thePllTracksARamp();
    void theCordicTracksARamp();
    void withoutATurningRotorNothingConverges();
    void aStartUpConvergesWhenTheForcedSpeedIsMatchedOftenEnough();
    void aForcedSpeedBelowTheMinimumNeverConverges();
    void aForcedSpeedOutsideTheBandNeverConverges();
    void aStalledRotorIsNoticedByItsMissingBackEmf();
    void withTheToleranceThatShipsAQuietStallGoesUnnoticed();
    void aSpeedPastItsRangeIsUnreliableUntilItConvergesAnew();
    void clearingForgetsAllButTheParameters();
    void noGainsMakeItUndefined();
    void averagesAreCutTowardsZero();
};

void TestMathsObserver::thePllFindsTheAngleFromAnywhere_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("start");
    for (const double speed : {0.5, -0.5, 0.2, 1.0})
        for (const double start : {0.3, 2.0, 3.7, 5.5})
            QTest::addRow("%g of maximum from %g rad", speed, start) << speed << start;
}

void TestMathsObserver::thePllFindsTheAngleFromAnywhere()
{
    QFETCH(double, speed);
    QFETCH(double, start);
    Bench<ObserverPll> bench(pllParameters());
    bench.motor.angle_rad = start;
    bench.motor.speed_radps = speed * kMaxSpeed_radps;
    bench.observer.setDirection(speed > 0 ? 1 : -1);
    bench.run(0.2);
    const double worst = bench.worstAngleError_degrees(0.1);
    QVERIFY2(worst < 2.0, QByteArray::number(worst).constData());
    QVERIFY(std::abs(bench.observer.speed_dHz() - bench.speed_dHz()) < 4.0);
}

void TestMathsObserver::theCordicFindsTheAngleFromAnywhere_data()
{
    thePllFindsTheAngleFromAnywhere_data();
}

void TestMathsObserver::theCordicFindsTheAngleFromAnywhere()
{
    QFETCH(double, speed);
    QFETCH(double, start);
    ObserverCordic::Parameters parameters = cordicParameters();
    parameters.maxAcceleration_dpp = 2000; // no rotor starts at its full speed, but here it does
    Bench<ObserverCordic> bench(parameters);
    bench.motor.angle_rad = start;
    bench.motor.speed_radps = speed * kMaxSpeed_radps;
    bench.observer.setDirection(speed > 0 ? 1 : -1);
    bench.run(0.2);
    const double worst = bench.worstAngleError_degrees(0.1);
    // a period late: 6 degrees at full speed
    QVERIFY2(worst < (speed < 1.0 ? 5.0 : 8.0), QByteArray::number(worst).constData());
    QVERIFY(std::abs(bench.observer.speed_dHz() - bench.speed_dHz()) < 4.0);
}

void TestMathsObserver::theEstimatedCurrentsAndBackEmfAreThose()
{
    Bench<ObserverPll> bench(pllParameters());
    bench.motor.speed_radps = 0.5 * kMaxSpeed_radps;
    bench.run(0.3);
    const double amp = kSensing.digitsPerAmp();
    const auto &is = bench.motor.current_a;
    const AlphaBeta current = bench.observer.estimatedCurrent();
    QVERIFY(std::abs(current.alpha - is.real() * amp) < 0.02 * 3.0 * amp);
    QVERIFY(std::abs(current.beta + is.imag() * amp) < 0.02 * 3.0 * amp);
    const AlphaBeta bemf = bench.observer.estimatedBemf();
    const double size = std::hypot(bemf.alpha, bemf.beta), exact = 0.5 / 1.2 * 32768.0;
    QVERIFY2(std::abs(size / exact - 1.0) < 0.03, QByteArray::number(size / exact).constData());
    QVERIFY(std::abs(bench.observer.speed().observedBemf() / size / size - 1.0) < 0.03);
}

void TestMathsObserver::thePllTracksARamp()
{
    Bench<ObserverPll> bench(pllParameters());
    bench.motor.speed_radps = 0.2 * kMaxSpeed_radps;
    bench.run(0.2);
    double worst = 0.0;
    for (int i = 0; i < 16000; ++i) { // from 20 % to 100 % in a second: 1340 rad/s^2
        bench.motor.speed_radps += 0.8 * kMaxSpeed_radps / 16000.0;
        bench.step();
        worst = std::max(worst, std::abs(bench.angleError_degrees()));
    }
    QVERIFY2(worst < 5.0, QByteArray::number(worst).constData());
    QVERIFY(std::abs(bench.observer.speed_dHz() - bench.speed_dHz()) < 6.0);
    QVERIFY(bench.observer.reliable());
}

void TestMathsObserver::theCordicTracksARamp()
{
    Bench<ObserverCordic> bench(cordicParameters());
    double worst = 0.0;
    for (int i = 0; i < 16000; ++i) { // from standstill
        bench.motor.speed_radps += kMaxSpeed_radps / 16000.0;
        bench.step();
        if (i > 3000)
            worst = std::max(worst, std::abs(bench.angleError_degrees()));
    }
    QVERIFY2(worst < 8.0, QByteArray::number(worst).constData());
}

void TestMathsObserver::withoutATurningRotorNothingConverges()
{
    Bench<ObserverPll> bench(pllParameters());
    bench.observer.setDirection(1);
    for (int i = 0; i < 300; ++i) {
        bench.run(1e-3);
        QVERIFY(!bench.observer.converged(100));
    }
}

void TestMathsObserver::aStartUpConvergesWhenTheForcedSpeedIsMatchedOftenEnough()
{
    Bench<ObserverPll> bench(startUpParameters(60, 3));
    bench.motor.speed_radps = 0.2 * kMaxSpeed_radps;
    bench.run(0.2);
    QVERIFY(!bench.observer.converged(133));
    QVERIFY(!bench.observer.converged(133));
    QVERIFY(!bench.observer.converged(0)); // says nothing
    QVERIFY(!bench.observer.converged(80)); // breaks the series
    QVERIFY(!bench.observer.converged(133));
    QVERIFY(!bench.observer.converged(133));
    QVERIFY(bench.observer.converged(133));
}

void TestMathsObserver::aForcedSpeedBelowTheMinimumNeverConverges()
{
    Bench<ObserverPll> bench(startUpParameters(200, 1));
    bench.motor.speed_radps = 0.2 * kMaxSpeed_radps;
    bench.run(0.2);
    QVERIFY(!bench.observer.converged(133));
}

void TestMathsObserver::aForcedSpeedOutsideTheBandNeverConverges()
{
    Bench<ObserverPll> bench(startUpParameters(60, 1));
    bench.motor.speed_radps = 0.5 * kMaxSpeed_radps;
    bench.run(0.2);
    const std::int16_t is = bench.observer.speed_dHz(); // about 333
    QVERIFY(!bench.observer.converged(static_cast<std::int16_t>(-is)));
    QVERIFY(!bench.observer.converged(static_cast<std::int16_t>(is * 16 / 14)));
    QVERIFY(!bench.observer.converged(static_cast<std::int16_t>(is * 16 / 18)));
    QVERIFY(bench.observer.converged(static_cast<std::int16_t>(is * 33 / 32)));
}

void TestMathsObserver::aStalledRotorIsNoticedByItsMissingBackEmf()
{
    ObserverPll::Parameters parameters = pllParameters();
    parameters.speed.bemfTolerance = 32;
    Bench<ObserverPll> bench(parameters);
    bench.motor.speed_radps = 0.5 * kMaxSpeed_radps;
    bench.run(0.2);
    bench.observer.forceConvergence();
    bench.run(0.2);
    QVERIFY(bench.observer.reliable());
    bench.motor.speed_radps = 0.0;
    bench.run(0.01);
    QVERIFY(!bench.observer.reliable());
    bench.motor.speed_radps = 0.5 * kMaxSpeed_radps;
    bench.run(0.2);
    QVERIFY(!bench.observer.reliable()); // until it converges anew
}

void TestMathsObserver::withTheToleranceThatShipsAQuietStallGoesUnnoticed()
{
    // The PLL runs on like a flywheel, at low variance; 64 of 64 of the back-EMF may be missing.
    Bench<ObserverPll> bench(pllParameters());
    bench.motor.speed_radps = 0.5 * kMaxSpeed_radps;
    bench.run(0.2);
    bench.observer.forceConvergence();
    bench.motor.speed_radps = 0.0;
    bench.run(0.1);
    QVERIFY(bench.observer.reliable());
    QVERIFY(bench.observer.speed_dHz() > 100);
    QVERIFY(bench.observer.speed().observedBemf() < bench.observer.speed().expectedBemf() / 64);
}

void TestMathsObserver::aSpeedPastItsRangeIsUnreliableUntilItConvergesAnew()
{
    SpeedEstimate estimate(
        {.polePairs = 1, .maxReliable_dHz = 1000, .minReliable_dHz = 10, .errorsBeforeFault = 3});
    const auto at = [&](std::int16_t dpp, int averages) {
        for (int i = 0; i < 64; ++i)
            estimate.store(dpp);
        for (int i = 0; i < averages; ++i)
            estimate.average({});
        return estimate.reliable();
    };
    QVERIFY(at(400, 10)); // 976
    QVERIFY(at(420, 2)); // 1025: too fast, but not often enough
    QVERIFY(at(400, 1));
    QVERIFY(!at(-420, 3));
    QVERIFY(!at(-400, 10));
    estimate.forceConvergence();
    QVERIFY(!at(2, 3)); // 4: too slow
    estimate.clear();
    QVERIFY(at(400, 1));
}

void TestMathsObserver::clearingForgetsAllButTheParameters()
{
    Bench<ObserverPll> bench(pllParameters());
    bench.motor.speed_radps = 0.5 * kMaxSpeed_radps;
    bench.run(0.2);
    bench.observer.clear();
    QCOMPARE(bench.observer.angle(), std::int16_t{0});
    QCOMPARE(bench.observer.speed_dpp(), std::int16_t{0});
    QCOMPARE(bench.observer.estimatedBemf(), (AlphaBeta{}));
    Bench<ObserverPll> fresh(pllParameters());
    bench.motor = fresh.motor;
    bench.tick = fresh.tick;
    for (int i = 0; i < 1000; ++i) {
        bench.step();
        fresh.step();
        QCOMPARE(bench.observer.angle(), fresh.observer.angle());
    }
}

void TestMathsObserver::noGainsMakeItUndefined()
{
    for (const int wild : {32767, -32768, 0, 1}) {
        const auto w = static_cast<std::int16_t>(wild);
        ObserverPll::Parameters parameters = pllParameters();
        parameters.observer = {
            .c1 = w, .c3 = w, .c5 = w, .gain1 = w, .gain2 = w, .f1Shift = 40, .f2Shift = -3};
        parameters.pll = {w, w, 0, 0};
        parameters.speed.depth = 1000;
        parameters.speed.depthDpp = 37;
        parameters.speed.polePairs = 0;
        Bench<ObserverPll> bench(parameters);
        bench.motor.speed_radps = 10.0 * kMaxSpeed_radps;
        bench.run(0.05);
        QVERIFY(bench.observer.estimatedBemf().alpha >= -32767);
    }
}

void TestMathsObserver::averagesAreCutTowardsZero()
{
    QCOMPARE(mechanicalSpeed_dHz(100, 16000, 4), std::int16_t{61}); // 244.14 / 4 -> 244 / 4
    QCOMPARE(mechanicalSpeed_dHz(-100, 16000, 4), std::int16_t{-61});
    QCOMPARE(mechanicalSpeed_dHz(32767, 50000, 1), std::int16_t{32767});
    SpeedEstimate estimate({.polePairs = 1, .depth = 4, .depthDpp = 2, .errorsBeforeFault = 1});
    estimate.forceConvergence();
    const auto store = [&](std::initializer_list<std::int16_t> speeds) {
        for (const std::int16_t dpp : speeds)
            estimate.store(dpp);
        estimate.average({.alpha = 32767, .beta = 0}); // enough for any speed
    };
    store({10, 20, 30, 45});
    QCOMPARE(estimate.speed_dpp(), std::int16_t{37}); // of the last two
    QCOMPARE(estimate.speed_dHz(), mechanicalSpeed_dHz(26, 16000, 1));
    QVERIFY(estimate.reliable()); // 167 is less than a quarter of 26 * 26
    store({10, 20, 30, 46});
    QVERIFY(!estimate.reliable()); // 177 is not
}

QTEST_APPLESS_MAIN(TestMathsObserver)
#include "tst_maths_observer.moc"
