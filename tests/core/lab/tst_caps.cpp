// The caps that the user agrees to before an experiment begins, and which other experiments are agreed to by them.
#include "lab/caps.h"

#include <QTest>

using lab::capsOf;
using lab::covers;
using namespace std::chrono_literals;

namespace {

lab::Experiment steps(int from, int to, drive::UserLimits user = {})
{
    lab::Experiment experiment;
    experiment.subject.limits.maxSpeedRpm = 4000.0;
    experiment.subject.limits.maxCurrentAmps = 10.0;
    experiment.subject.registers.current = 1;
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
        lab::Experiment untold = experiment; // nothing is held that nothing tells
        untold.subject.registers.current = 0;
        QVERIFY(lab::currentBoundOf(untold) == CurrentBound::None);
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
    void aLongerOneIsAnotherPlan()
    {
        const auto agreedTo = [](int repeat, std::chrono::milliseconds hold) {
            lab::Experiment experiment = steps(1000, 1500);
            auto &plan = std::get<lab::StepPlan>(experiment.plan);
            plan.repeat = repeat;
            plan.hold = hold;
            return lab::agreementTo(experiment, 0.0);
        };
        const lab::Agreement agreed = agreedTo(1, 200ms);
        QCOMPARE(agreed.length, 16'400ms); // twice 8 s for the ways there and back
        QVERIFY(covers(agreed, agreed)); // again, with another gain
        QVERIFY(covers(agreed, agreedTo(4, 50ms)));
        QVERIFY(!covers(agreed, agreedTo(2, 200ms)));
        QVERIFY(!covers(agreed, agreedTo(1, 201ms)));
    }
    /// The speeds of a move the other way are the same, and those of a longer one in more time.
    void aShaftGoesOnlyTheWayThatWasAgreedTo()
    {
        const auto agreedTo = [](double by, std::chrono::milliseconds in) {
            lab::Experiment experiment = steps(1000, 1500);
            experiment.plan = lab::PositionPlan{.byDegrees = by, .ramp = in};
            return lab::agreementTo(experiment, 0.0);
        };
        lab::Agreement agreed = agreedTo(90.0, 300ms);
        agreed.length += 1h;
        QVERIFY(covers(agreed, agreed));
        QVERIFY(covers(agreed, agreedTo(45.0, 200ms)));
        QVERIFY(!covers(agreed, agreedTo(-90.0, 300ms)));
        QVERIFY(!covers(agreed, agreedTo(-5.0, 300ms)));
        QVERIFY(!covers(agreed, agreedTo(750.0, 2500ms)));
    }
    void otherGainsMeanwhileAreAnotherPlan()
    {
        const auto agreedTo = [](int kp, int ki) {
            lab::Experiment experiment = steps(1000, 1500);
            experiment.subject.registers.gain = 17;
            experiment.subject.registers.integral = 18;
            experiment.plan = lab::ResponsePlan{.rpm = 1000, .kp = kp, .ki = ki};
            return lab::agreementTo(experiment, 0.0);
        };
        const lab::Agreement own = agreedTo(0, 0), calm = agreedTo(500, 30);
        QCOMPARE(own.lent.size(), 0U);
        QCOMPARE(calm.lent.size(), 2U);
        QVERIFY(!covers(own, calm));
        QVERIFY(covers(calm, calm) && covers(calm, own));
        QVERIFY(!covers(calm, agreedTo(501, 30)) && !covers(calm, agreedTo(500, 31)));
    }
};

QTEST_APPLESS_MAIN(TestCaps)
#include "tst_caps.moc"
