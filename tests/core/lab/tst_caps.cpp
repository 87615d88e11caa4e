// The caps that the user agrees to before an experiment begins, and which other experiments are agreed to by them.
#include "lab/caps.h"

#include <QTest>

using lab::capsOf;
using lab::covers;

namespace {

lab::Experiment steps(int from, int to, drive::UserLimits user = {})
{
    lab::Experiment experiment;
    experiment.subject.limits.maxSpeedRpm = 4000.0;
    experiment.subject.limits.maxCurrentAmps = 10.0;
    experiment.plan = lab::StepPlan{.fromRpm = from, .toRpm = to, .caps = user};
    return experiment;
}

} // namespace

class TestCaps : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Half a step beyond both speeds, and the way from rest or from the speed of before.
    void theyHoldThePlanAndTheWayThereAndBack()
    {
        const lab::Caps resting = capsOf(steps(1000, 1500), 0.0);
        QCOMPARE(resting.leastRpm, -250.0);
        QCOMPARE(resting.mostRpm, 1750.0);
        QCOMPARE(resting.mostAmps, 12.5);
        const lab::Caps running = capsOf(steps(1000, 1500), 1200.0);
        QCOMPARE(running.leastRpm, 750.0);
        QCOMPARE(capsOf(steps(1000, 1500), 2000.0).mostRpm, 2250.0);
    }
    void theBoardsLimitAndThePersonsBoundThem()
    {
        QCOMPARE(capsOf(steps(3000, 4000), 0.0).mostRpm, 4400.0); // its own loop overshoots there
        const lab::Caps mine = capsOf(steps(1000, 1500, {1600.0, 3.0}), 0.0);
        QCOMPARE(mine.mostRpm, 1600.0);
        QCOMPARE(mine.mostAmps, 3.0);
        QCOMPARE(lab::allowedRpm(steps(1000, 1500, {1600.0, 3.0})), 1600.0);
    }
    /// The range of its sensors says nothing of the motor.
    void theMotorsOwnCurrentBoundsThem()
    {
        lab::Experiment experiment = steps(1000, 1500);
        experiment.subject.limits.nominalCurrentAmps = 2.0;
        QCOMPARE(capsOf(experiment, 0.0).mostAmps, 2.5);
        experiment.plan = lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .caps = {0.0, 3.0}};
        QCOMPARE(capsOf(experiment, 0.0).mostAmps, 2.5); // the user cannot raise it
    }
    void whatBoundsTheCurrentIsKnown()
    {
        using lab::CurrentBound;
        lab::Experiment experiment = steps(1000, 1500);
        QVERIFY(lab::currentBoundOf(experiment) == CurrentBound::Board);
        experiment.subject.limits.nominalCurrentAmps = 2.0;
        QVERIFY(lab::currentBoundOf(experiment) == CurrentBound::Nominal);
        experiment.plan = lab::StepPlan{.fromRpm = 1000, .toRpm = 1500, .caps = {0.0, 2.4}};
        QVERIFY(lab::currentBoundOf(experiment) == CurrentBound::User);
        QVERIFY(lab::currentBoundOf(lab::Experiment{}) == CurrentBound::None);
    }
    void whoeverAgreedToMoreAgreedToLess()
    {
        const lab::Caps agreed = capsOf(steps(1000, 1500), 0.0);
        QVERIFY(covers(agreed, agreed));
        QVERIFY(covers(agreed, capsOf(steps(1000, 1400), 0.0)));
        QVERIFY(covers(agreed, capsOf(steps(1000, 1500), 1200.0)));
        QVERIFY(!covers(agreed, capsOf(steps(1000, 1600), 0.0)));
        QVERIFY(!covers(agreed, capsOf(steps(1000, 500), -300.0)));
        const lab::Caps less = capsOf(steps(1000, 1500, {0.0, 3.0}), 0.0);
        QVERIFY(covers(agreed, less));
        QVERIFY(!covers(less, agreed)); // more current
        lab::Caps boundless = agreed;
        boundless.mostAmps = 0.0;
        QVERIFY(covers(boundless, agreed));
        QVERIFY(!covers(agreed, boundless));
    }
};

QTEST_APPLESS_MAIN(TestCaps)
#include "tst_caps.moc"
