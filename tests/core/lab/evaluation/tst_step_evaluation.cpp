// One step, from samples whose truth is known: an analytic plant of second order, seen through a board's digits.
#include "lab/evaluation/step_evaluation.h"
#include "lab/evaluation/step_series.h"
#include "support/link_pair.h"

#include <QTest>

#include <numbers>

using namespace lab;
using capture::Nanos;

namespace {

constexpr double kStepTick_hz = 16000.0;
constexpr double kAmpsPerDigit = 1e-3, kJump = 2e-3 /* A/rpm */;
constexpr int kPolePairs = 5;
constexpr Nanos kSecond = 1'000'000'000;

/// Speed after a unit step of w^2 / (s^2 + 2 d w s + w^2), and its integral.
struct Plant {
    double w = 80.0, d = 0.5;
    double at(double t) const
    {
        if (t <= 0.0)
            return 0.0;
        const double wd = w * std::sqrt(1.0 - d * d);
        return 1.0
            - std::exp(-d * w * t)
            * (std::cos(wd * t) + d / std::sqrt(1.0 - d * d) * std::sin(wd * t));
    }
    double overshoot_pct() const
    {
        return 100.0 * std::exp(-std::numbers::pi * d / std::sqrt(1.0 - d * d));
    }
    double rise_s() const // from 10 to 90 %, by bisection on the first crossing
    {
        const auto when = [this](double level) {
            double low = 0.0, high = std::numbers::pi / (w * std::sqrt(1.0 - d * d));
            for (int i = 0; i < 60; ++i)
                (at((low + high) / 2) < level ? low : high) = (low + high) / 2;
            return low;
        };
        return when(0.9) - when(0.1);
    }
};

/// What a board would have recorded of a step from 1000 to 1500 rpm at 1 s, asked for a while before.
struct StepRecording {
    Plant plant;
    double from = 1000.0, to = 1500.0;
    double at_s = 1.0;
    double length_s = 2.0;
    int turnTicks = 16; ///< the speed loop turns once a millisecond
    double noise_digits = 1.0; ///< of the reference at each turn
    double limit_a = 0.0; ///< of the reference; 0: none
    std::optional<std::pair<double, double>> gap = {}; ///< seconds
    std::uint64_t seed = 1;
    capture::Capture capture = {};

    double speed(double t) const { return from + (to - from) * plant.at(t - at_s); }

    StepChannels make()
    {
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kStepTick_hz;
        layout.fast = {{1, "I_Q_REF", "A", kAmpsPerDigit}, {2, "I_Q_MEAS", "A", kAmpsPerDigit},
            {3, "ENCODER_SPEED", "rpm", 6.0}, {4, "ENCODER_EL_ANGLE", "deg", 360.0 / 65536.0}};
        capture.begin(layout);
        support::Random random(seed);
        std::vector<std::int16_t> columns[4];
        capture::Tick first = 0, lost = 0;
        double turns = 0.0, noise = 0.0;
        const auto flush = [&](capture::Tick next) {
            if (columns[0].empty())
                return;
            capture::SampleBlock block;
            block.stream = 1;
            block.firstTick = first;
            block.count = static_cast<std::uint32_t>(columns[0].size());
            block.lostTicks = lost;
            for (auto &column : columns) {
                block.fast.insert(block.fast.end(), column.begin(), column.end());
                column.clear();
            }
            capture.append(block);
            first = next;
            lost = 0;
        };
        const auto ticks = static_cast<capture::Tick>(length_s * kStepTick_hz);
        double error = 0.0;
        for (capture::Tick tick = 0; tick < ticks; ++tick) {
            const double t = double(tick) / kStepTick_hz;
            turns += speed(t) / 60.0 / kStepTick_hz;
            if (gap && t >= gap->first && t < gap->second) {
                flush(tick);
                first = tick + 1;
                ++lost;
                continue;
            }
            if (tick % turnTicks == 0) {
                error = (t >= at_s ? to : from) - speed(t);
                noise = (static_cast<double>(random.next() >> 11) * 0x1p-52 - 1.0) * noise_digits;
            }
            double reference = 1.0 + kJump * error + noise * kAmpsPerDigit;
            if (limit_a > 0.0)
                reference = std::clamp(reference, -limit_a, limit_a);
            const double el = turns * kPolePairs;
            columns[0].push_back(std::int16_t(std::lround(reference / kAmpsPerDigit)));
            columns[1].push_back(std::int16_t(std::lround(reference / kAmpsPerDigit)));
            columns[2].push_back(std::int16_t(std::lround(speed(t) / 6.0)));
            columns[3].push_back(
                static_cast<std::int16_t>(std::int64_t(std::floor(el * 65536.0)) & 0xFFFF));
        }
        flush(ticks);
        return channels();
    }
    StepChannels channels() const
    {
        return {capture.channel(*capture.find(1)), capture.channel(*capture.find(2)),
            capture.channel(*capture.find(3)), capture.channel(*capture.find(4))};
    }
    StepAsked asked() const
    {
        const Nanos at = capture::toNanos(at_s);
        return {from, to, at - 4'000'000, at + 4'000'000, at + kSecond / 2};
    }
};

constexpr StepFacts kFacts{kPolePairs, kJump};

#define VERIFY_NEAR(value, expected, within)                                                       \
    QVERIFY2(std::abs((value) - (expected)) <= (within),                                           \
        qPrintable(                                                                                \
            QStringLiteral("%1, not %2 +- %3")                                                     \
                .arg(QString::number(value), QString::number(expected), QString::number(within))))

} // namespace

class TestStepEvaluation : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void riseAndOvershootAreThoseOfThePlant_data()
    {
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("d");
        QTest::addColumn<double>("to");
        for (const double w : {40.0, 80.0, 120.0})
            for (const double d : {0.4, 0.6, 0.8})
                for (const double to : {1500.0, 700.0})
                    QTest::addRow("w %.0f d %.1f to %.0f", w, d, to) << w << d << to;
    }
    /// Within 1 % and 0.5 points.
    void riseAndOvershootAreThoseOfThePlant()
    {
        QFETCH(const double, w);
        QFETCH(const double, d);
        QFETCH(const double, to);
        StepRecording recording{.plant = {w, d}, .to = to};
        const StepRun run = evaluateStep(recording.make(), recording.asked(), kFacts);
        QVERIFY(run.found && !run.unusable);
        QCOMPARE(run.up, to > 1000.0);
        const double rise = recording.plant.rise_s();
        VERIFY_NEAR(*run.rise_s, rise, 0.01 * rise);
        VERIFY_NEAR(*run.overshoot_pct, recording.plant.overshoot_pct(), 0.5);
        VERIFY_NEAR(double(run.at), 1e9, 63e3); // a sample
        VERIFY_NEAR(*run.instantError_s, 1.0 / kStepTick_hz, 1e-9);
    }

    void theInstantIsInTheDataHoweverLateTheWriteWas()
    {
        for (std::uint64_t seed = 1; seed <= 200; ++seed) {
            support::Random random(seed);
            StepRecording recording;
            recording.seed = seed;
            recording.noise_digits = 60.0; // of a jump of 1000
            recording.at_s = 0.5 + 0.001 * double(random.below(500)); // at a turn of the loop
            StepAsked asked = recording.asked();
            asked.asked -= Nanos(random.below(300)) * 1'000'000;
            const StepRun run = evaluateStep(recording.make(), asked, kFacts);
            QVERIFY2(run.found, qPrintable(QString::number(seed)));
            VERIFY_NEAR(double(run.at), recording.at_s * 1e9, 1e6);
        }
    }

    void withoutItsJumpTheInstantIsUncertainAndSaysHowMuch()
    {
        StepRecording recording;
        const StepChannels channels = recording.make();
        StepAsked asked = recording.asked();
        StepFacts facts = kFacts;
        facts.jumpPerRpm = kJump / 2.0; // another gain than the recording's
        const StepRun run = evaluateStep(channels, asked, facts);
        QVERIFY(!run.found);
        QVERIFY(!run.settling_s);
        VERIFY_NEAR(*run.instantError_s, 38e-3, 1e-4); // the range that was searched
        QVERIFY(run.at <= Nanos(recording.at_s * 1e9));
        // The shape of the speed needs no instant.
        VERIFY_NEAR(*run.rise_s, recording.plant.rise_s(), 0.02 * recording.plant.rise_s());
        VERIFY_NEAR(*run.overshoot_pct, recording.plant.overshoot_pct(), 0.7);
    }

    void withoutAGainTheJumpThatStandsOutIsTaken()
    {
        StepRecording recording;
        StepFacts facts = kFacts;
        facts.jumpPerRpm = 0.0;
        const StepRun run = evaluateStep(recording.make(), recording.asked(), facts);
        QVERIFY(run.found);
        VERIFY_NEAR(double(run.at), 1e9, 63e3);
        StepRecording noisy;
        noisy.noise_digits = 600.0;
        QVERIFY(!evaluateStep(noisy.make(), noisy.asked(), facts).found);
    }

    void aJumpThatTheLimitCutsIsFoundAndTheLimitTold()
    {
        StepRecording recording;
        recording.limit_a = 1.6; // 0.6 of 1.0 A
        recording.plant.w = 40.0;
        const StepRun run = evaluateStep(recording.make(), recording.asked(), kFacts);
        QVERIFY(run.found);
        VERIFY_NEAR(double(run.at), 1e9, 63e3);
        QVERIFY2(run.atLimit > 0.005, qPrintable(QString::number(run.atLimit)));
        VERIFY_NEAR(*run.peakIq_a, 1.6, 2e-3);
    }

    void nothingIsToldAcrossAGap()
    {
        for (const double at : {0.95, 1.02, 1.3}) {
            StepRecording recording;
            recording.gap = {at, at + 0.001};
            const StepRun run = evaluateStep(recording.make(), recording.asked(), kFacts);
            QVERIFY(run.unusable == scope::WhyNot::GapInside);
            QVERIFY(!run.rise_s && !run.overshoot_pct && !run.settling_s);
        }
        StepRecording before;
        before.gap = {0.5, 0.6};
        QVERIFY(!evaluateStep(before.make(), before.asked(), kFacts).unusable);
    }

    void aSpeedThatStaysIsNoStep()
    {
        StepRecording recording;
        recording.to = 1000.0;
        StepAsked asked = recording.asked();
        const StepChannels channels = recording.make();
        asked.to = 1500;
        QVERIFY(evaluateStep(channels, asked, kFacts).unusable.has_value());
        asked.to = 500; // and one that goes the other way is not this step
        StepRecording other;
        QVERIFY(evaluateStep(other.make(), asked, kFacts).unusable.has_value());
    }

    void withoutAnAngleTheSpeedSignalIsTaken()
    {
        StepRecording recording;
        StepChannels channels = recording.make();
        channels.angle = nullptr;
        const StepRun run = evaluateStep(channels, recording.asked(), kFacts);
        VERIFY_NEAR(*run.overshoot_pct, recording.plant.overshoot_pct(), 1.5); // digits of 6 rpm
    }

    /// A recording has runs, and a series is one of them.
    void whatIsToldOfASeriesCallsItsStepsSteps()
    {
        StepRun whole;
        whole.found = true;
        whole.rise_s = 0.03;
        whole.overshoot_pct = 14.0;
        whole.settling_s = 0.2;
        whole.peakIq_a = 0.6;
        StepRun broken;
        broken.up = false;
        broken.unusable = scope::WhyNot::GapInside;
        broken.peakIq_a = 0.6;
        MeasuredSteps series;
        series.runs = {whole, broken};
        noteRuns(series, "speed");
        addMeans(series, {1e-3, 1e-3, 1e-3});
        const std::vector<std::string> once{
            "samples are missing in step 2 (down): nothing is told of its speed",
            "the mean rise time, overshoot and settling time are those of 1 of 2 steps"};
        QCOMPARE(series.notes, once);

        StepRun swings = whole;
        swings.up = false;
        swings.settling_s.reset();
        StepRun flat;
        flat.unusable = scope::WhyNot::NoStep;
        series = {};
        series.runs = {whole, swings, flat};
        noteRuns(series, "speed");
        addMeans(series, {1e-3, 1e-3, 1e-3});
        const std::vector<std::string> twice{
            "step 2 (down) does not settle while its speed is held",
            "step 3 (up) is not seen in the speed",
            "the mean rise time, overshoot and peak current are those of 2 of 3 steps",
            "the mean settling time is that of 1 of 3 steps"};
        QCOMPARE(series.notes, twice);
    }

    void aStandingRotorGivesASpeedOfNothing()
    {
        StepRecording recording;
        recording.from = recording.to = 0.0;
        recording.make();
        const capture::Capture speed =
            speedOf(*recording.channels().angle, kPolePairs, 5e-3, 0, kSecond);
        QCOMPARE(speed.channels().size(), 1U);
        const auto ends = speed.extremes(speed.channels().front().id, 0.0, 1.0);
        QCOMPARE(ends.min, 0.0f);
        QCOMPARE(ends.max, 0.0f);
        QVERIFY(speedOf(*recording.channels().angle, 0.0, 5e-3, 0, kSecond).channels().empty());
    }
};

QTEST_APPLESS_MAIN(TestStepEvaluation)
#include "tst_step_evaluation.moc"
