// The table of series: numbers with units, the difference to the chosen one, and which of them stay.
#include "widgets/lab/run_mark.h"
#include "widgets/lab/step_runs.h"

#include <QAbstractItemModelTester>
#include <QSet>
#include <QTest>

#include <qcustomplot.h>

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
