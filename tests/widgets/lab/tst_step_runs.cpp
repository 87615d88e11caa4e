// The table of series: numbers with units, the difference to the chosen one, and which of them stay; and the picture
// beside it, where samples are missing.
#include "widgets/lab/run_mark.h"
#include "widgets/lab/step_overlay.h"
#include "widgets/lab/step_runs.h"

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QSet>
#include <QTest>

#include <qcustomplot.h>

#include <cmath>
#include <tuple>

using widgets::StepResult;
using widgets::StepRuns;

namespace {

StepResult result(double rise_s, std::optional<double> half_s = {})
{
    StepResult one;
    one.kp = QStringLiteral("0.02 A/(rad/s)");
    one.series.plan = {.fromRpm = 1000, .toRpm = -1500, .repeat = 3};
    one.series.rise_s = lab::Estimate{rise_s, {}, {}};
    if (half_s)
        one.series.rise_s = lab::Estimate{rise_s, rise_s - *half_s, rise_s + *half_s};
    lab::StepRun run;
    run.rise_s = rise_s;
    for (int repeat = 0; repeat < one.series.plan.repeat; ++repeat)
        for (const bool up : {true, false}) {
            run.up = up;
            one.series.runs.push_back(run);
        }
    return one;
}

/// A step to 1500 rpm at 1.0 s and one back to 1000 at 1.5 s, each asked for 10 ms before and held for 0.5 s.
struct RecordedSteps {
    static constexpr double kTick_hz = 16000.0, kAmpsPerRpm = 2e-3;
    widgets::Experiments::Run run;

    /// @param gap  ticks from it on are lost, up to the other
    RecordedSteps(capture::Tick gap, capture::Tick gapEnd)
    {
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kTick_hz;
        layout.fast = {{1, "I_Q_REF", "A", 1e-3}, {2, "ENCODER_SPEED", "rpm", 6.0},
            {3, "ENCODER_EL_ANGLE", "deg", 360.0 / 65536.0}};
        run.capture.begin(layout);
        double turns = 0.0;
        constexpr capture::Tick kEnd = 32000;
        append(0, gap, 0, turns);
        for (capture::Tick tick = gap; tick < gapEnd; ++tick)
            turns += speed(tick) / 60.0 / kTick_hz;
        append(gapEnd, kEnd, gapEnd - gap, turns);

        add(0.5, "step plan",
            {{"motor", "1"}, {"pole pairs", "5"}, {"reference", "I_Q_REF"},
                {"speed", "ENCODER_SPEED"}, {"angle", "ENCODER_EL_ANGLE"}, {"from rpm", "1000"},
                {"to rpm", "1500"}, {"repeat", "1"}, {"hold ms", "500"},
                {"jump A per rpm", "0.002"}});
        add(0.99, "speed ramp", {{"motor", "1"}, {"rpm", "1500"}, {"ms", "0"}});
        add(1.49, "speed ramp", {{"motor", "1"}, {"rpm", "1000"}, {"ms", "0"}});
        add(1.99, lab::kEndEntry, {{"outcome", "complete"}});
    }

private:
    static double wanted(capture::Tick tick)
    {
        return tick >= 16000 && tick < 24000 ? 1500.0 : 1000.0;
    }
    static double speed(capture::Tick tick)
    {
        constexpr double kPerSecond = 40.0;
        const auto left = [tick](double from) {
            return std::exp(-kPerSecond * (double(tick) / kTick_hz - from));
        };
        return tick < 16000 ? 1000.0
            : tick < 24000  ? 1500.0 - 500.0 * left(1.0)
                            : 1000.0 + 500.0 * left(1.5);
    }
    void add(
        double seconds, const char *name, std::vector<std::pair<std::string, std::string>> fields)
    {
        run.happenings.emplace_back(
            capture::toNanos(seconds), recorded::Happening{name, std::move(fields)});
    }
    void append(capture::Tick from, capture::Tick to, capture::Tick lost, double &turns)
    {
        std::vector<std::int16_t> columns[3];
        for (capture::Tick tick = from; tick < to; ++tick) {
            turns += speed(tick) / 60.0 / kTick_hz;
            const double amps = 1.0 + kAmpsPerRpm * (wanted(tick) - speed(tick));
            columns[0].push_back(std::int16_t(std::lround(amps * 1e3)));
            columns[1].push_back(std::int16_t(std::lround(speed(tick) / 6.0)));
            columns[2].push_back(static_cast<std::int16_t>(
                std::int64_t(std::floor(turns * 5.0 * 65536.0)) & 0xFFFF));
        }
        capture::SampleBlock block;
        block.stream = 1;
        block.firstTick = from;
        block.count = static_cast<std::uint32_t>(to - from);
        block.lostTicks = lost;
        for (const auto &column : columns)
            block.fast.insert(block.fast.end(), column.begin(), column.end());
        run.capture.append(block);
    }
};

/// The same steps of a board that records nothing: read every 5 ms, and answered 2 ms after they were asked for.
widgets::Experiments::Run &readSteps(widgets::Experiments::Run &run, double tau_s)
{
    for (int read = 120; read < 420; ++read) {
        const double at_s = read * 5e-3;
        const auto left = [&](double from_s) { return 500.0 * std::exp((from_s - at_s) / tau_s); };
        const double rpm = at_s < 1.0 ? 1000.0
            : at_s < 1.5              ? 1500.0 - left(1.0)
                                      : 1000.0 + left(1.5);
        run.capture.appendPolled(7, "SPEED_MEAS", "rpm", at_s, rpm);
    }
    const auto add = [&run](double at_s, recorded::Happening what) {
        run.happenings.emplace_back(capture::toNanos(at_s), std::move(what));
    };
    add(0.5,
        {"step plan",
            {{"motor", "1"}, {"speed", "SPEED_MEAS"}, {"from rpm", "1000"}, {"to rpm", "1500"},
                {"repeat", "1"}, {"hold ms", "500"}}});
    for (const auto &[asked_s, at, rpm] :
        {std::tuple(0.999, "0.999", "1500"), std::tuple(1.499, "1.499", "1000")}) {
        add(asked_s, {"speed ramp", {{"motor", "1"}, {"rpm", rpm}, {"ms", "0"}}});
        add(asked_s + 2e-3,
            {"motion",
                {{"act", "SPEED_RAMP"}, {"asked s", at}, {"took ms", "2"}, {"outcome", "ok"}}});
    }
    add(1.999, {lab::kEndEntry, {{"outcome", "complete"}}});
    return run;
}

QString wordsIn(const widgets::StepOverlay &picture)
{
    return picture.findChild<QLabel *>(QStringLiteral("stepOverlayWhy"))->text();
}

} // namespace

class TestStepRuns : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theFirstIsTheReferenceOfTheOthers()
    {
        StepRuns runs;
        const QAbstractItemModelTester tester(
            &runs, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const double rise_s : {0.030, 0.025, 0.030})
            runs.add(result(rise_s));
        QCOMPARE(runs.reference(), 0);
        QCOMPARE(text(runs, 0), QStringLiteral("30.0\u202fms"));
        QCOMPARE(text(runs, 1), QStringLiteral("25.0\u202fms  (\u22125.0)"));
        QCOMPARE(text(runs, 2), QStringLiteral("30.0\u202fms  (\u00b10.0)"));
        runs.setReference(1);
        QCOMPARE(text(runs, 0), QStringLiteral("30.0\u202fms  (+5.0)"));
        QCOMPARE(text(runs, 1), QStringLiteral("25.0\u202fms"));
        QCOMPARE(runs.index(0, StepRuns::StepColumn).data().toString(),
            QStringLiteral("1000 \u2192 \u22121500\u202frpm, 3\u00d7"));
    }
    /// Of which only the same step is another tuning, and which no axis has in common with a speed.
    void aCurrentIsToldInItsUnits()
    {
        StepRuns runs;
        const auto torque = [](double rise_s, int flux) {
            StepResult one = result(rise_s);
            one.current = lab::CurrentStepPlan{.flux = flux, .fromAmps = 0.5, .toAmps = 1.5};
            one.curves.append({true, {0.0, 0.01}, {0.5, 1.5}, {}});
            return one;
        };
        runs.add(result(0.030));
        for (const int flux : {0, 0, 1})
            runs.add(torque(flux != 0 ? 1.0e-3 : 1.02e-3, flux));
        QCOMPARE(text(runs, 1), QStringLiteral("1.02\u202fms"));
        runs.setReference(1);
        QCOMPARE(text(runs, 2), QStringLiteral("1.02\u202fms  (\u00b10.00)"));
        QCOMPARE(text(runs, 3), QStringLiteral("1.00\u202fms"));
        QCOMPARE(text(runs, 0), QStringLiteral("30.0\u202fms"));
        QCOMPARE(runs.index(3, StepRuns::StepColumn).data().toString(),
            QStringLiteral("Flux 0.50 \u2192 1.50\u202fA, 3\u00d7"));

        widgets::StepOverlay picture;
        picture.showSteps(runs.results(), true);
        QCOMPARE(picture.curves(), 0);
        picture.showSteps(runs.results(), true, widgets::StepKind::Torque);
        QCOMPARE(picture.curves(), 2);
        const QCPAxis &axis = *picture.findChild<QCustomPlot *>()->yAxis;
        QCOMPARE(axis.label(), QStringLiteral("Iq [A]"));
        QVERIFY(axis.range().lower > 0.3 && axis.range().upper < 1.7); // by tenths of the step
    }
    void onlyStepsThatWereMadeAreCounted()
    {
        StepRuns runs;
        StepResult one = result(0.030);
        one.series.runs.resize(4);
        one.series.runs.back().cut = true;
        runs.add(one);
        QCOMPARE(runs.index(0, StepRuns::StepColumn).data().toString(),
            QStringLiteral("1000 \u2192 \u22121500\u202frpm, 2\u00d7 up, 1\u00d7 down"));
    }
    void anIntervalStandsBesideAndWhatIsNotKnownIsADash()
    {
        StepRuns runs;
        runs.add(result(0.030, 0.0012));
        QCOMPARE(text(runs, 0), QStringLiteral("30.0 \u00b1 1.2\u202fms"));
        QCOMPARE(
            runs.index(0, StepRuns::SettlingColumn).data().toString(), QStringLiteral("\u2013"));
        QCOMPARE(runs.index(0, StepRuns::BusColumn).data().toString(), QStringLiteral("\u2013"));
        QVERIFY(
            runs.index(0, 0).data(Qt::ToolTipRole).toString().contains(QLatin1String("Rise 30.0")));
    }
    void withoutItsReferenceTheOldestIsIt()
    {
        StepRuns runs;
        const QAbstractItemModelTester tester(
            &runs, QAbstractItemModelTester::FailureReportingMode::QtTest);
        for (const double rise_s : {0.030, 0.025, 0.020})
            runs.add(result(rise_s));
        runs.remove(0);
        QCOMPARE(runs.reference(), 0);
        QCOMPARE(runs.results().front().number, 2); // numbers stay
        QCOMPARE(text(runs, 1), QStringLiteral("20.0\u202fms  (\u22125.0)"));
        runs.remove(1);
        runs.remove(0);
        QCOMPARE(runs.reference(), -1);
        runs.add(result(0.010));
        QCOMPARE(runs.reference(), 0);
        QCOMPARE(runs.results().front().number, 4);
    }
    void theOldestGoesButNotTheReference()
    {
        StepRuns runs;
        for (int i = 0; i < StepRuns::kMost + 2; ++i)
            runs.add(result(0.030));
        QCOMPARE(runs.rowCount(), StepRuns::kMost);
        QCOMPARE(runs.results()[0].number, 1);
        QCOMPARE(runs.results()[1].number, 4);
    }
    /// A curve ends where its numbers do, goes on behind samples that are missing, and bridges none of them.
    void aStepIsDrawnAsFarAsItWasRecorded()
    {
        const RecordedSteps recorded(23888, 23936); // 1.493 to 1.496 s, behind the end of the first
        auto found = widgets::stepResult(recorded.run, {});
        QVERIFY2(found, found ? "" : found.error().c_str());
        found->number = 1;
        QCOMPARE(found->series.runs.size(), 2U);
        QVERIFY(found->series.runs[0].rise_s && !found->series.runs[1].rise_s);

        QCOMPARE(found->curves.size(), 2);
        const widgets::StepCurve &up = found->curves[0], &down = found->curves[1];
        QVERIFY(up.up && up.gaps.isEmpty() && up.seconds.size() > 400);
        QVERIFY2(up.seconds.last() > 0.48, qPrintable(QString::number(up.seconds.last())));
        QVERIFY(!down.up && down.seconds.size() > 400);
        QCOMPARE(down.gaps.size(), 1);
        const qsizetype behind = down.gaps.first();
        QVERIFY(behind > 10 && down.seconds[behind] - down.seconds[behind - 1] > 7e-3);
        QVERIFY(std::is_sorted(down.seconds.begin(), down.seconds.end()));

        widgets::StepOverlay picture;
        auto *plot = picture.findChild<QCustomPlot *>();
        picture.showSteps({*found}, true);
        QCOMPARE(picture.curves(), 1);
        QVERIFY2(wordsIn(picture).isEmpty(), qPrintable(wordsIn(picture)));
        QCOMPARE(plot->graphCount(), 2); // a line and its ticks
        picture.showSteps({*found}, false);
        QCOMPARE(picture.curves(), 1);
        QCOMPARE(plot->graphCount(), 3); // both pieces
    }
    void valuesThatWereReadAreDrawnAndToldWithTheirUncertainty()
    {
        widgets::Experiments::Run slow, quick;
        const auto found = widgets::stepResult(readSteps(slow, 0.04), {});
        QVERIFY2(found, found ? "" : found.error().c_str());
        QVERIFY(found->told());
        QCOMPARE(found->curves.size(), 2);
        for (const widgets::StepCurve &curve : found->curves)
            QVERIFY(curve.gaps.isEmpty() && curve.seconds.size() > 90);
        StepRuns runs;
        runs.add(*found);
        const QString tip = runs.index(0, 0).data(Qt::ToolTipRole).toString();
        for (const char *words : {" \u00b1 5.0\u202fms", " \u00b1 6\u202fms",
                 "The board records nothing: its speed was read once in up to 5 ms"})
            QVERIFY2(tip.contains(QString::fromUtf8(words)), qPrintable(tip));

        const auto tooFast = widgets::stepResult(readSteps(quick, 2e-3), {});
        QVERIFY2(tooFast, tooFast ? "" : tooFast.error().c_str());
        QVERIFY(!tooFast->told());
    }
    void aStepThatCannotBeDrawnIsNoneThatWasNotMade()
    {
        widgets::StepOverlay picture;
        QCOMPARE(wordsIn(picture), QStringLiteral("No step yet."));
        StepResult result;
        result.number = 1;
        result.curves.append(widgets::StepCurve());
        picture.showSteps({result}, true);
        QCOMPARE(wordsIn(picture), QStringLiteral("Not drawn: samples are missing."));
        picture.showSteps({result}, false);
        QCOMPARE(wordsIn(picture), QStringLiteral("No step yet."));
    }

    /// Users who see no colours tell them by their ticks.
    void eachOfSixtyFourLooksDifferent()
    {
        QSet<QString> looks;
        QSet<int> shapes;
        for (int number = 1; number <= 64; ++number) {
            const auto tick = widgets::runTick(number, Qt::black);
            looks.insert(widgets::runColor(number, false).name() + QString::number(tick.shape()));
            if (number <= 8)
                shapes.insert(tick.shape());
        }
        QCOMPARE(looks.size(), 64);
        QCOMPARE(shapes.size(), 8);
    }

private:
    static QString text(const StepRuns &runs, int row)
    {
        return runs.index(row, StepRuns::RiseColumn).data().toString();
    }
};

QTEST_MAIN(TestStepRuns)
#include "tst_step_runs.moc"
