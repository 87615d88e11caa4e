// Measurements against signals whose answers are known on paper.
#include "scope/measurement.h"
#include "scope/measurer.h"
#include "scope/phase.h"
#include "support/channels/analytic_channel.h"
#include "support/channels/noisy_channel.h"
#include "support/near.h"

#include <QtTest>

using support::near;
using namespace scope;
using support::fastChannel;
using support::kCode;
using support::kRate;
using support::kSecond;
using support::kTurn;
using support::slowChannel;

class TestScopeMeasure : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void extremesAndMomentsEqualAScan();
    void extremesOfManyValuesAreExact();
    void sines_data();
    void sines();
    void squaresHaveTheirDutyAndLevels_data();
    void squaresHaveTheirDutyAndLevels();
    void aPulseThatDipsIsCountedOnce();
    void aRampsRiseIsTenToNinety();
    void valuesThatHoldWeighAsLongAsTheyHold();
    void thereIsAReasonWhereThereIsNoNumber();
    void aGapMakesTimesUnmeasurable();
    void phases_data();
    void phases();
    void phaseNeedsOneFrequency();
    void statisticsKeepTheirDigits();
    void measuresDrawWhatTheyMeasured();
};

namespace {

double value(const Measurement &measurement)
{
    if (!measurement.value)
        qWarning("no value: %d", int(measurement.value.error()));
    return measurement.value.value_or(NAN);
}
double value(const capture::Channel &channel, Quantity quantity)
{
    return value(Measurer(channel, 0, 100 * kSecond).measure(quantity));
}
std::optional<WhyNot> reason(const Measurement &measurement)
{
    return measurement.value ? std::nullopt : std::optional(measurement.value.error());
}
} // namespace

void TestScopeMeasure::extremesOfManyValuesAreExact()
{
    // Doubles that are the same as floats, and one that is not: blocks have to be exact.
    constexpr std::size_t kCount = 2'000'000;
    const capture::Channel channel = slowChannel(kCount, [](double seconds) {
        return seconds == 100.0 ? 1.0 + 1e-12 : seconds == 101.0 ? 1.0 - 1e-12 : 1.0;
    });
    const SampleRange range(channel, 0, 1000 * kSecond);
    const SampleRange::Extremes found = range.extremes();
    QCOMPARE(found.maxAt, Index(100 * kRate));
    QCOMPARE(found.minAt, Index(101 * kRate));
    QVERIFY(found.max > 1.0 && found.min < 1.0);
}

void TestScopeMeasure::extremesAndMomentsEqualAScan()
{
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        const bool polled = seed % 4 == 0;
        support::NoisyChannel noisy(seed,
            polled ? support::NoisyChannel::Kind::Polled : support::NoisyChannel::Kind::Fast,
            support::NoisyChannel::Shape::Wave, 5000);
        while (!noisy.done())
            noisy.record(700);
        const auto plain = noisy.plain();
        std::mt19937 random(seed);
        for (int i = 0; i < 20; ++i) {
            const std::size_t low = random() % plain.size();
            const std::size_t high = low + random() % (plain.size() - low) + 1;
            const Nanos to = high < plain.size() ? plain[high].time : plain.back().time + 1;
            const SampleRange range(*noisy.channel(), plain[low].time, to);
            QCOMPARE(range.end() - range.begin(), high - low);
            std::size_t minAt = low;
            std::size_t maxAt = low;
            bool gap = false;
            double sum = 0.0;
            double squares = 0.0;
            for (std::size_t k = low; k < high; ++k) {
                minAt = plain[k].value < plain[minAt].value ? k : minAt;
                maxAt = plain[k].value > plain[maxAt].value ? k : maxAt;
                gap = gap || (k > low && plain[k].first);
                sum += plain[k].value;
                squares += plain[k].value * plain[k].value;
            }
            const SampleRange::Extremes extremes = range.extremes();
            QCOMPARE(extremes.min, plain[minAt].value);
            QCOMPARE(extremes.max, plain[maxAt].value);
            QCOMPARE(noisy.channel()->timeOf(extremes.minAt), plain[minAt].time);
            QCOMPARE(noisy.channel()->timeOf(extremes.maxAt), plain[maxAt].time);
            QCOMPARE(range.gapInside(), gap);
            if (!polled) {
                const auto count = double(high - low);
                QVERIFY(near(range.moments()->mean, sum / count, 1e-9));
                QVERIFY(near(range.moments()->rms, std::sqrt(squares / count), 1e-9));
            }
        }
    }
}

void TestScopeMeasure::sines_data()
{
    QTest::addColumn<double>("hertz");
    QTest::addColumn<double>("amplitude");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("frequencyError"); // relative
    QTest::newRow("plain") << 50.0 << 10.0 << 0.0 << 0.0 << 1e-5;
    QTest::newRow("an offset many times the amplitude") << 33.3 << 1.0 << 25.0 << 0.0 << 1e-4;
    QTest::newRow("few samples a period") << 1777.0 << 10.0 << -3.0 << 0.0 << 1e-4;
    QTest::newRow("noise of 2 %") << 50.0 << 10.0 << 5.0 << 0.2 << 5e-4;
    QTest::newRow("noise of 5 %") << 217.0 << 10.0 << 0.0 << 0.5 << 5e-4;
    QTest::newRow("hardly two periods") << 2.1 << 10.0 << 0.0 << 0.0 << 1e-4;
}

void TestScopeMeasure::sines()
{
    QFETCH(const double, hertz);
    QFETCH(const double, amplitude);
    QFETCH(const double, offset);
    QFETCH(const double, noise);
    QFETCH(const double, frequencyError);
    const auto channel = fastChannel(
        16000, [=](double t) { return offset + amplitude * std::sin(kTurn * hertz * t + 0.4); },
        noise);
    QVERIFY(near(value(channel, Quantity::Frequency) / hertz, 1.0, frequencyError));
    QVERIFY(near(value(channel, Quantity::Period) * hertz, 1.0, frequencyError));
    const double small = kCode + 0.02 * noise + 0.001 * amplitude;
    QVERIFY(near(value(channel, Quantity::CycleMean), offset, 2 * small));
    QVERIFY(near(value(channel, Quantity::CycleRms),
        std::sqrt(offset * offset + amplitude * amplitude / 2 + noise * noise), 2 * small));
    QVERIFY(near(value(channel, Quantity::Duty), 50.0, noise > 0 ? 0.5 : 0.1));
    if (hertz < 1000)
        QVERIFY(near(
            value(channel, Quantity::PeakToPeak), 2 * amplitude, 0.01 * amplitude + 9 * noise));
    // 10 to 90 % of a sine's height: 2 asin(0.8) of its angle. Noise moves the extremes that are its levels.
    if (noise == 0.0 && hertz < 1000)
        QVERIFY(near(value(channel, Quantity::Rise) * hertz, 2 * std::asin(0.8) / kTurn, 2e-3));
}

void TestScopeMeasure::squaresHaveTheirDutyAndLevels_data()
{
    QTest::addColumn<double>("duty");
    QTest::addColumn<double>("noise");
    QTest::newRow("half") << 0.5 << 0.0;
    QTest::newRow("ten per cent") << 0.1 << 0.0;
    QTest::newRow("ninety per cent, noisy") << 0.9 << 0.3;
    QTest::newRow("thirty per cent, noisy") << 0.3 << 0.6;
}

void TestScopeMeasure::squaresHaveTheirDutyAndLevels()
{
    QFETCH(const double, duty);
    QFETCH(const double, noise);
    const double hertz = 37.0;
    const auto channel = fastChannel(
        16000,
        [=](double t) {
            const double phase = t * hertz + 0.15;
            return phase - std::floor(phase) < duty ? 12.0 : -8.0;
        },
        noise);
    const auto levels = findLevels(SampleRange(channel, 0, kSecond));
    QVERIFY(levels);
    QVERIFY(near(levels->top, 12.0, 0.1 * noise + 1e-3));
    QVERIFY(near(levels->base, -8.0, 0.1 * noise + 1e-3));
    // An edge lies anywhere between two samples.
    QVERIFY(near(value(channel, Quantity::Duty), duty * 100.0, 100.0 * hertz / kRate));
    QVERIFY(near(value(channel, Quantity::Frequency), hertz, hertz * hertz / kRate / 30));
}

void TestScopeMeasure::aPulseThatDipsIsCountedOnce()
{
    // High for 8 of 10 ms; the dips cross the middle and do not end the pulse.
    const auto channel = fastChannel(16000, [](double t) {
        const double ms = std::fmod(t + 0.003, 0.01) * 1000.0;
        const bool dip = (ms > 2.0 && ms < 2.3) || (ms > 4.0 && ms < 4.3);
        return ms >= 8.0 ? 0.0 : dip ? 4.0 : 10.0;
    });
    QVERIFY(near(value(channel, Quantity::Duty), 80.0, 0.7));
    QVERIFY(near(value(channel, Quantity::Frequency), 100.0, 0.1));
}

void TestScopeMeasure::aRampsRiseIsTenToNinety()
{
    // Up in 20 ms, down in 5 ms, with rests.
    const auto shape = [](double t) {
        if (t < 0.1)
            return -4.0;
        if (t < 0.12)
            return -4.0 + 10.0 * (t - 0.1) / 0.02;
        if (t < 0.2)
            return 6.0;
        return std::max(-4.0, 6.0 - 10.0 * (t - 0.2) / 0.005);
    };
    const auto channel = fastChannel(4800, shape);
    QVERIFY(near(value(channel, Quantity::Rise), 0.016, 2e-5));
    QVERIFY(near(value(channel, Quantity::Fall), 0.004, 2e-5));
    const auto noisy = fastChannel(4800, shape, 0.1);
    QVERIFY(near(value(noisy, Quantity::Rise), 0.016, 1e-3));
    QVERIFY(near(value(noisy, Quantity::Fall), 0.004, 3e-4));
}

void TestScopeMeasure::valuesThatHoldWeighAsLongAsTheyHold()
{
    capture::Capture store;
    store.appendPolled(7, "P", "A", 0.0, 10.0);
    store.appendPolled(7, "P", "A", 0.5, 20.0);
    store.appendPolled(7, "P", "A", 0.6, 0.0);
    store.appendPolled(7, "P", "A", 1.0, 0.0);
    const capture::Channel &channel = *store.channel(*store.find(7));
    const auto mean = [&](double from, double to) {
        return value(Measurer(channel, capture::toNanos(from), capture::toNanos(to))
                         .measure(Quantity::Mean));
    };
    QVERIFY(near(mean(0.0, 1.0), 10.0 * 0.5 + 20.0 * 0.1, 1e-9));
    QVERIFY(near(mean(0.25, 0.55), (10.0 * 0.25 + 20.0 * 0.05) / 0.3, 1e-9));
    QVERIFY(near(mean(0.1, 0.2), 10.0, 1e-9)); // no sample inside, but one that holds
}

void TestScopeMeasure::thereIsAReasonWhereThereIsNoNumber()
{
    const auto nothing = fastChannel(0, [](double) { return 0.0; });
    const auto flat = fastChannel(100, [](double) { return 3.0; });
    const auto half = fastChannel(100, [](double t) { return t < 0.003 ? 0.0 : 5.0; });
    const auto why = [](const capture::Channel &channel, Quantity quantity) {
        return reason(Measurer(channel, 0, kSecond).measure(quantity));
    };
    for (int i = 0; i < int(Quantity::Phase); ++i) {
        if (unitOf(Quantity(i)) == UnitKind::Channel && i <= int(Quantity::CycleRms))
            QCOMPARE(why(nothing, Quantity(i)), WhyNot::NoSamples);
    }
    QCOMPARE(why(flat, Quantity::Frequency), WhyNot::NoFullPeriod);
    QCOMPARE(why(flat, Quantity::Duty), WhyNot::NoFullPeriod);
    QCOMPARE(why(flat, Quantity::Rise), WhyNot::NoEdge);
    QCOMPARE(why(half, Quantity::Frequency), WhyNot::NoFullPeriod);
    QCOMPARE(why(half, Quantity::Rise), std::nullopt);
    QCOMPARE(why(half, Quantity::Fall), WhyNot::NoEdge);
    QCOMPARE(why(half, Quantity::Settling), WhyNot::NoStep);
    QCOMPARE(why(flat, Quantity::Mean), std::nullopt);
}

void TestScopeMeasure::aGapMakesTimesUnmeasurable()
{
    auto channel = fastChannel(16000, [](double t) { return std::sin(kTurn * 50 * t); });
    const std::vector<std::int16_t> more(100, 500);
    channel.fast()->append(capture::TickBase::of(kRate, 0), 20000, 1, more);
    Measurer measurer(channel, 0, 2 * kSecond);
    QCOMPARE(reason(measurer.measure(Quantity::Frequency)), WhyNot::GapInside);
    QCOMPARE(reason(measurer.measure(Quantity::Rise)), WhyNot::GapInside);
    const Measurement max = measurer.measure(Quantity::Max);
    QVERIFY(max.value && max.partial);
    QVERIFY(!Measurer(channel, 0, kSecond).measure(Quantity::Max).partial);
}

void TestScopeMeasure::phases_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("harmonic");
    QTest::addColumn<double>("error");
    for (const double degrees : {0.0, 30.0, -90.0, 120.0, 179.0, -150.0})
        QTest::addRow("%g degrees", degrees) << degrees << 0.0 << 0.0 << 0.1;
    QTest::newRow("noise of 10 %") << 60.0 << 1.0 << 0.0 << 0.5;
    QTest::newRow("a fifth harmonic") << 60.0 << 0.0 << 1.5 << 0.2;
}

void TestScopeMeasure::phases()
{
    QFETCH(const double, degrees);
    QFETCH(const double, noise);
    QFETCH(const double, harmonic);
    QFETCH(const double, error);
    const double hertz = 87.0;
    const auto wave = [=](double shift) {
        return [=](double t) {
            const double angle = kTurn * hertz * t + shift;
            return 2.0 + 10.0 * std::sin(angle) + harmonic * std::sin(5 * angle + 1.0);
        };
    };
    const auto first = fastChannel(8000, wave(0.3), noise, 1);
    const auto second = fastChannel(8000, wave(0.3 + degrees * kTurn / 360), noise, 2);
    const Measurement phase = measurePhase(first, second, 0, kSecond);
    QVERIFY(near(std::remainder(value(phase) - degrees, 360.0), 0.0, error));
    QCOMPARE(phase.unit, UnitKind::Degrees);
    QCOMPARE(phase.points.size(), 2U);
}

void TestScopeMeasure::phaseNeedsOneFrequency()
{
    const auto at = [](double hertz) {
        return fastChannel(8000, [=](double t) { return 10.0 * std::sin(kTurn * hertz * t); });
    };
    QCOMPARE(reason(measurePhase(at(50), at(60), 0, kSecond)), WhyNot::OtherFrequency);
    QCOMPARE(reason(measurePhase(at(50), at(0), 0, kSecond)), WhyNot::NoFullPeriod);
    QCOMPARE(reason(measurePhase(at(3), at(3), 0, kSecond)), WhyNot::NoFullPeriod);
}

void TestScopeMeasure::statisticsKeepTheirDigits()
{
    Statistics statistics;
    QVERIFY(!statistics.mean() && !statistics.sigma() && !statistics.min());
    for (int i = 0; i < 30000; ++i)
        statistics.add(1e9 + (i % 3)); // a naive sum of squares has no digit left here
    statistics.add(std::nullopt);
    statistics.add(NAN);
    QCOMPARE(statistics.count(), 30000U);
    QCOMPARE(statistics.missing(), 2U);
    QVERIFY(near(*statistics.mean(), 1e9 + 1.0, 1e-3));
    QVERIFY(near(*statistics.sigma(), std::sqrt(2.0 / 3.0 * 30000.0 / 29999.0), 1e-6));
    QCOMPARE(*statistics.min(), 1e9);
    QCOMPARE(*statistics.max(), 1e9 + 2.0);
    QCOMPARE(*statistics.last(), 1e9 + 2.0);
    statistics.clear();
    QCOMPARE(statistics.count(), 0U);
    statistics.add(4.0);
    QVERIFY(!statistics.sigma());
}

void TestScopeMeasure::measuresDrawWhatTheyMeasured()
{
    const auto channel =
        fastChannel(16000, [](double t) { return 5.0 * std::sin(kTurn * 50 * t); });
    Measurer measurer(channel, 0, kSecond);
    const Measurement peak = measurer.measure(Quantity::PeakToPeak);
    QCOMPARE(peak.levels.size(), 2U);
    QVERIFY(near(peak.levels[1].level - peak.levels[0].level, *peak.value, 1e-12));
    const Measurement frequency = measurer.measure(Quantity::Frequency);
    QCOMPARE(frequency.points.size(), 2U);
    const double periods =
        capture::toSeconds(frequency.points[1].time - frequency.points[0].time) * *frequency.value;
    QVERIFY(near(periods, 48.0, 1e-6) || near(periods, 49.0, 1e-6));
    const Measurement rise = measurer.measure(Quantity::Rise);
    QVERIFY(near(capture::toSeconds(rise.points[1].time - rise.points[0].time), *rise.value, 2e-9));
    QVERIFY(near(rise.points[1].level, 4.0, 0.01));
}

QTEST_APPLESS_MAIN(TestScopeMeasure)
#include "tst_scope_measure.moc"
