// Step metrics against first and second order systems, whose answers are formulas.
#include "scope/measurer.h"
#include "support/channels/analytic_channel.h"

#include <QtTest>

#include <numbers>

using namespace scope;
using support::fastChannel;
using support::kRate;
using support::kSecond;

class TestScopeStep : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void firstOrder_data();
    void firstOrder();
    void secondOrder_data();
    void secondOrder();
    void aRightHalfZeroUndershoots();
    void deadTimeIsToFivePerCent();
    void noNumberBeforeItHasSettled();
    void withoutAStepThereAreNoMetrics();
    void errorsNeedASetPoint();
    void valuesThatHoldErrAsLongAsTheyHold();
    void rippleIsWhatRemains();
};

namespace {

constexpr double kStepAt = 0.05;

StepSettings stepAt(std::optional<double> final = std::nullopt)
{
    StepSettings settings;
    settings.at = capture::toNanos(kStepAt);
    settings.final = final;
    return settings;
}
Result<double, WhyNot> measure(
    const capture::Channel &channel, Quantity quantity, const StepSettings &settings)
{
    return Measurer(channel, 0, 10 * kSecond, settings).measure(quantity).value;
}
bool near(const Result<double, WhyNot> &actual, double expected, double error)
{
    if (actual && std::abs(*actual - expected) <= error)
        return true;
    if (!actual)
        qWarning("no value: %d", int(actual.error()));
    else
        qWarning("%.9g is not %.9g within %.3g", *actual, expected, error);
    return false;
}

/// From `from` to `to` with one time constant.
auto firstOrderStep(double from, double to, double tau)
{
    return [=](double t) {
        return t < kStepAt ? from : to + (from - to) * std::exp(-(t - kStepAt) / tau);
    };
}

/// From 0 to `to` with damping `d` < 1 and natural frequency `w`, rad/s.
double secondOrder(double t, double to, double d, double w)
{
    if (t < kStepAt)
        return 0.0;
    const double s = t - kStepAt;
    const double root = std::sqrt(1 - d * d);
    return to * (1.0 - std::exp(-d * w * s) / root * std::sin(root * w * s + std::acos(d)));
}

} // namespace

void TestScopeStep::firstOrder_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("tau");
    QTest::addColumn<double>("noise");
    QTest::newRow("up") << 0.0 << 10.0 << 0.01 << 0.0;
    QTest::newRow("down, with an offset") << 20.0 << -5.0 << 0.02 << 0.0;
    QTest::newRow("a current loop of 1500 rad/s") << 1.0 << 3.0 << 1 / 1500.0 << 0.0;
    QTest::newRow("four samples long") << 0.0 << 10.0 << 1 / 9000.0 << 0.0;
    QTest::newRow("noise of 0.3 %") << 0.0 << 10.0 << 0.01 << 0.03;
}

void TestScopeStep::firstOrder()
{
    QFETCH(const double, from);
    QFETCH(const double, to);
    QFETCH(const double, tau);
    QFETCH(const double, noise);
    const auto channel = fastChannel(8000, firstOrderStep(from, to, tau), noise);
    // The error of a line through samples of an exponential, and what noise moves.
    const double curve = std::max(std::pow(1 / (kRate * tau), 2) / 8, 1e-4) * tau * 3;
    const double moved = noise > 0 ? 0.15 * tau : 0.0;
    const StepSettings settings = stepAt();
    const Quantity edge = to > from ? Quantity::Rise : Quantity::Fall;
    QVERIFY(near(measure(channel, edge, settings), tau * std::log(9.0), curve + moved));
    QVERIFY(
        near(measure(channel, Quantity::DeadTime, settings), -tau * std::log(0.95), curve + moved));
    // 2 % of the step is left after tau ln 50; the rounding of a code is seen there.
    const double rounding = 0.0005 / std::abs(to - from) / 0.02 * tau;
    QVERIFY(near(measure(channel, Quantity::Settling, settings), tau * std::log(50.0),
        curve + rounding + 3 * moved));
    QVERIFY(near(measure(channel, Quantity::Overshoot, settings), 0.0, noise > 0 ? 1.5 : 0.05));
    const auto opposite =
        measure(channel, edge == Quantity::Rise ? Quantity::Fall : Quantity::Rise, settings);
    QVERIFY(!opposite && opposite.error() == WhyNot::NoEdge);
}

void TestScopeStep::secondOrder_data()
{
    QTest::addColumn<double>("damping");
    QTest::addColumn<double>("noise");
    for (const double damping : {0.2, 0.5, 0.707})
        QTest::addRow("damping %g", damping) << damping << 0.0;
    QTest::newRow("damping 0.4, noisy") << 0.4 << 0.02;
}

void TestScopeStep::secondOrder()
{
    QFETCH(const double, damping);
    QFETCH(const double, noise);
    const double w = 300.0;
    const auto shape = [=](double t) { return ::secondOrder(t, 10.0, damping, w); };
    const auto channel = fastChannel(8000, shape, noise);
    const double root = std::sqrt(1 - damping * damping);
    const double overshoot = 100 * std::exp(-std::numbers::pi * damping / root);
    const StepSettings settings = stepAt();
    QVERIFY(near(measure(channel, Quantity::Overshoot, settings), overshoot, 0.05 + 50 * noise));
    QVERIFY(near(measure(channel, Quantity::PeakTime, settings), std::numbers::pi / (w * root),
        1.1 / kRate + 5e-5 + 0.05 * noise));
    // Rise and settling have no short formula: they are read off the formula of the curve, a thousand times finer.
    double ten = 0.0;
    double ninety = 0.0;
    double settled = 0.0;
    for (double s = 0.0; s < 0.4; s += 1 / kRate / 1000) {
        const double y = shape(kStepAt + s) / 10.0;
        ten = ten == 0.0 && y >= 0.1 ? s : ten;
        ninety = ninety == 0.0 && y >= 0.9 ? s : ninety;
        settled = std::abs(y - 1.0) > 0.02 ? s : settled;
    }
    QVERIFY(near(measure(channel, Quantity::Rise, settings), ninety - ten, 5e-6 + 0.01 * noise));
    if (noise == 0.0)
        QVERIFY(near(measure(channel, Quantity::Settling, settings), settled, 3e-5));
}

void TestScopeStep::aRightHalfZeroUndershoots()
{
    // (1 - s T) / (1 + s tau)^2: dips first. y = 1 - (1 + x + x T / tau) e^-x, x = t / tau.
    const double tau = 0.02;
    const double ratio = 1.5;
    const auto channel = fastChannel(8000, [=](double t) {
        const double x = std::max(0.0, t - kStepAt) / tau;
        return 10.0 * (1.0 - (1.0 + x + x * ratio) * std::exp(-x));
    });
    // The lowest point is where x (1 + ratio) = ratio.
    const double x = ratio / (1 + ratio);
    const double lowest = 1.0 - (1.0 + x * (1 + ratio)) * std::exp(-x);
    QVERIFY(lowest < -0.1);
    QVERIFY(near(measure(channel, Quantity::Undershoot, stepAt()), -100 * lowest, 0.05));
    QVERIFY(near(measure(channel, Quantity::Overshoot, stepAt()), 0.0, 0.05));
}

void TestScopeStep::deadTimeIsToFivePerCent()
{
    const double dead = 0.0123;
    const auto channel = fastChannel(8000, [=](double t) {
        return t < kStepAt + dead ? 0.0 : 10.0 * std::min(1.0, (t - kStepAt - dead) / 0.01);
    });
    QVERIFY(near(measure(channel, Quantity::DeadTime, stepAt()), dead + 0.0005, 1e-5));
    QVERIFY(near(measure(channel, Quantity::Rise, stepAt()), 0.008, 1e-5));
}

void TestScopeStep::noNumberBeforeItHasSettled()
{
    const auto slow = fastChannel(8000, firstOrderStep(0.0, 10.0, 0.3));
    const auto settling = measure(slow, Quantity::Settling, stepAt());
    QVERIFY(!settling && settling.error() == WhyNot::NotSettled);
    const auto ripple = measure(slow, Quantity::Ripple, stepAt());
    QVERIFY(!ripple && ripple.error() == WhyNot::NotSettled);
    // What it should become is known, and it is not there yet.
    const auto known = measure(
        fastChannel(8000, firstOrderStep(0.0, 10.0, 0.1)), Quantity::Settling, stepAt(12.0));
    QVERIFY(!known && known.error() == WhyNot::NotSettled);
    const auto ringing = fastChannel(
        8000, [](double t) { return t < kStepAt ? 0.0 : 10.0 + 0.5 * std::sin(400.0 * t); });
    QVERIFY(measure(ringing, Quantity::Settling, stepAt()).error() == WhyNot::NotSettled);
}

void TestScopeStep::withoutAStepThereAreNoMetrics()
{
    const auto noise = fastChannel(
        8000, [](double) { return 1.0; }, 0.2);
    for (const Quantity quantity : {Quantity::Rise, Quantity::Overshoot, Quantity::Settling}) {
        const auto result = measure(noise, quantity, stepAt());
        QVERIFY(!result && result.error() == WhyNot::NoStep);
    }
    auto broken = fastChannel(8000, firstOrderStep(0.0, 10.0, 0.01));
    const std::vector<std::int16_t> more(100, 10000);
    broken.fast()->append(capture::TickBase::of(kRate, 0), 9000, 1, more);
    QVERIFY(measure(broken, Quantity::Settling, stepAt()).error() == WhyNot::GapInside);
    const auto nothing = fastChannel(0, [](double) { return 0.0; });
    QVERIFY(measure(nothing, Quantity::Settling, stepAt()).error() == WhyNot::NoSamples);
}

void TestScopeStep::errorsNeedASetPoint()
{
    const auto channel = fastChannel(8000, firstOrderStep(0.0, 9.5, 0.01));
    StepSettings settings = stepAt();
    QVERIFY(measure(channel, Quantity::SteadyStateError, settings).error() == WhyNot::NoSetPoint);
    settings.setPoint = 10.0;
    QVERIFY(near(measure(channel, Quantity::SteadyStateError, settings), 0.5, 0.001));
    // |10 - y| = 0.5 + 9.5 e^(-t/tau) over 0.45 s, and the same times t.
    const double length = 7999 / kRate - kStepAt;
    QVERIFY(
        near(measure(channel, Quantity::AbsoluteError, settings), 0.5 * length + 9.5 * 0.01, 2e-4));
    QVERIFY(near(measure(channel, Quantity::TimedError, settings),
        0.25 * length * length + 9.5 * 0.01 * 0.01, 2e-4));
}

void TestScopeStep::valuesThatHoldErrAsLongAsTheyHold()
{
    // Ten a second: 0 when the step comes, 1 from 0.1 s on, 1.5 from 0.2 s to 1 s.
    const auto channel = support::slowChannel(
        10, [](double t) { return t < 0.05 ? 0.0
                               : t < 0.15  ? 1.0
                                           : 1.5; }, 10.0);
    StepSettings settings = stepAt();
    settings.setPoint = 2.0;
    QVERIFY(near(
        measure(channel, Quantity::AbsoluteError, settings), 2 * 0.05 + 1 * 0.1 + 0.5 * 0.8, 1e-9));
    const auto timed = [](double error, double from, double to) {
        return error * (to * to - from * from) / 2;
    };
    QVERIFY(near(measure(channel, Quantity::TimedError, settings),
        timed(2, 0, 0.05) + timed(1, 0.05, 0.15) + timed(0.5, 0.15, 0.95), 1e-9));
    // A range that ends while a value holds.
    Measurer some(channel, 0, capture::toNanos(0.55), settings);
    QVERIFY(
        near(some.measure(Quantity::AbsoluteError).value, 2 * 0.05 + 1 * 0.1 + 0.5 * 0.35, 1e-9));
}

void TestScopeStep::rippleIsWhatRemains()
{
    const auto channel = fastChannel(8000,
        [](double t) { return firstOrderStep(0.0, 10.0, 0.005)(t) + 0.1 * std::sin(2000.0 * t); });
    // Entered with up to 2 %.
    QVERIFY(near(measure(channel, Quantity::Ripple, stepAt()), 0.2 + 0.1, 0.12));
    QVERIFY(near(measure(channel, Quantity::RippleRms, stepAt()), 0.1 / std::sqrt(2.0), 0.01));
}

QTEST_APPLESS_MAIN(TestScopeStep)
#include "tst_scope_step.moc"
