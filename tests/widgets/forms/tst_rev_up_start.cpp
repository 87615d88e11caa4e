// A start with an edited rev-up on the simulated board, in virtual time: what is measured is drawn over the plan.
#include "support/rev_up_bench.h"

#include <cmath>

using facts::RevUpBench;
using motor::RevUp;
using Quantity = RevUpBench::Quantity;
using Ending = widgets::RevUpStart::Result;
using namespace std::chrono_literals;

namespace {

QString lastStart(const RevUpBench &rig)
{
    return rig.form.findChild<QLabel *>(QStringLiteral("revUpLastStart"))->text();
}

/// Starts through the drive and lets time pass until the start is over, one way or another.
bool startAndWait(RevUpBench &rig)
{
    rig.bench.link.submit(drive::Command{drive::MotorAction::Start, 1});
    const auto result = [&] { return rig.form.start().result(); };
    if (!rig.bench.link.runUntil([&] { return result() == Ending::UnderWay; }, 2s))
        return false;
    const bool over = rig.bench.link.runUntil([&] { return result() != Ending::UnderWay; }, 20s);
    QCoreApplication::processEvents();
    return over;
}

void stopAndRest(RevUpBench &rig)
{
    rig.bench.link.drive->stop(rig.bench.link.now);
    rig.bench.link.runUntilState(drive::MotorState::Idle);
    rig.bench.link.runFor(500ms);
    rig.bench.link.drive->arm();
}

/// What the stages ask for at a time: straight lines, beyond them the end of the last.
double planned(const RevUpBench &rig, Quantity quantity, double time_s)
{
    double begin_s = 0.0, from = 0.0;
    for (const motor::RevUpStage &stage : rig.stages()) {
        const double end_s = begin_s + 1e-3 * stage.duration_ms;
        const double to = quantity == Quantity::Speed
            ? stage.speed_rpm
            : stage.current_digits * rig.model.shownPerDigit();
        if (time_s < end_s)
            return from + (to - from) * std::max(0.0, time_s - begin_s) / (end_s - begin_s);
        begin_s = end_s;
        from = to;
    }
    return from;
}

/// Greatest distance of measured points from the plan, each shifted by at most `slack_s`: when exactly a polled value
/// was true, and when the rev-up began, is known no better.
double farthest(const QList<QPointF> &measured, const RevUpBench &rig, Quantity quantity,
    double until_s, double slack_s)
{
    double worst = 0.0;
    for (const QPointF &point : measured) {
        if (point.x() > until_s)
            break;
        double least = HUGE_VAL;
        for (int i = -20; i <= 20; ++i) {
            const double wanted = planned(rig, quantity, point.x() + i * slack_s / 20.0);
            least = std::min(least, std::abs(point.y() - wanted));
        }
        worst = std::max(worst, least);
    }
    return worst;
}

constexpr double kSlack_s = 0.03; // a round of polling and the answer's way
// 2.5 % and 10 % of what is asked for.
constexpr double kSpeedBound_rpm = 30.0, kCurrentBound_a = 0.25;

/// Long stages, so that the drive cannot take over early: the observer sees nothing below some 300 rpm.
const RevUp kEdited{{0, 1361, 600}, {150, 1361, 500}, {1200, 1361, 1500}, {1200, 1361, 400}};

} // namespace

class TestRevUpStart : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void theMeasuredStartLiesOnTheEditedPlan_data()
    {
        QTest::addColumn<bool>("streamed");
        QTest::newRow("Iq polled") << false;
        QTest::newRow("Iq streamed") << true;
    }
    void theMeasuredStartLiesOnTheEditedPlan()
    {
        QFETCH(bool, streamed);
        RevUpBench rig;
        QVERIFY(rig.setAll(kEdited));
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        QVERIFY(rig.heldBytes() == motor::bytesOf(motor::completed(kEdited)));
        QVERIFY(rig.chart.drawnMeasured(Quantity::Speed).isEmpty());

        const drive::RegisterId iq = rig.bench.id("I_Q_MEAS");
        if (streamed)
            rig.bench.link.submit(drive::Stream{{iq}, 8, {}, 1});
        else
            rig.bench.link.submit(drive::Watch{{iq}, 20ms});
        rig.bench.link.runFor(200ms);
        QVERIFY(startAndWait(rig));
        QVERIFY(rig.form.start().result() == Ending::Running);
        const double over = rig.form.start().duration_s();
        QVERIFY2(over > 1.3, qPrintable(QString::number(over))); // into the third stage

        const auto speed = rig.chart.drawnMeasured(Quantity::Speed),
                   current = rig.chart.drawnMeasured(Quantity::Current);
        QVERIFY(speed.size() > 40);
        QVERIFY(current.size() > (streamed ? 200 : 20));
        // Until the switch-over, which is no part of the plan any more.
        const double until = over - 0.1;
        const double off = farthest(speed, rig, Quantity::Speed, until, kSlack_s);
        QVERIFY2(off < kSpeedBound_rpm, qPrintable(QString::number(off)));
        const double amps = farthest(current, rig, Quantity::Current, until, kSlack_s);
        QVERIFY2(amps < kCurrentBound_a, qPrintable(QString::number(amps)));
        QVERIFY(lastStart(rig).contains(QStringLiteral("took over")));
        // Both curves end where the start did, not where the plan does.
        QVERIFY(speed.back().x() <= over);
        QVERIFY(current.back().x() <= over);

        // It stays while the plan is edited, and goes with the next start only.
        QVERIFY(rig.model.addAfter(0));
        QCOMPARE(rig.chart.drawnMeasured(Quantity::Speed), speed);
        rig.bench.edits.revert();
        stopAndRest(rig);
        QCOMPARE(rig.chart.drawnMeasured(Quantity::Speed), speed);
        bool cleared = false;
        connect(&rig.form.start(), &widgets::RevUpStart::changed, &rig.form,
            [&] { cleared = cleared || rig.chart.drawnMeasured(Quantity::Speed).isEmpty(); });
        QVERIFY(startAndWait(rig));
        QVERIFY(cleared);
        QVERIFY(rig.chart.drawnMeasured(Quantity::Speed).size() > 40);
    }

    void aPlanThatWasNotAppliedIsNotWhatIsMeasured()
    {
        RevUpBench rig;
        rig.bench.arm();
        rig.bench.link.runFor(200ms);
        QVERIFY(startAndWait(rig)); // the board's own stages: 1200 rpm after 0.55 s
        QVERIFY(rig.setAll(kEdited));
        const double off = farthest(rig.chart.drawnMeasured(Quantity::Speed), rig, Quantity::Speed,
            rig.form.start().duration_s() - 0.1, kSlack_s);
        QVERIFY2(off > 5 * kSpeedBound_rpm, qPrintable(QString::number(off)));
    }

    void aStartThatFailsIsShownUntilItsFault()
    {
        RevUpBench rig;
        QVERIFY(rig.setAll({{0, 1361, 100}, {3996, 1361, 60}})); // too fast to follow
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        QVERIFY(startAndWait(rig));
        QVERIFY(rig.form.start().result() == Ending::Failed);
        QVERIFY2(lastStart(rig).contains(QStringLiteral("START_UP")), qPrintable(lastStart(rig)));
        QVERIFY(rig.form.start().duration_s() < 0.3);
    }

    void whatWasNotRecordedIsSaid()
    {
        RevUpBench rig;
        QVERIFY(!lastStart(rig).isEmpty());
        rig.bench.arm();
        QVERIFY(startAndWait(rig));
        QVERIFY(lastStart(rig).contains(QStringLiteral("No Iq was recorded")));
        QVERIFY(!lastStart(rig).contains(QStringLiteral("No speed")));
        QVERIFY(rig.chart.drawnMeasured(Quantity::Current).isEmpty());
    }

    void aStartBackwardsIsMirroredOntoThePlan()
    {
        RevUpBench rig;
        QVERIFY(rig.setAll(kEdited));
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        rig.bench.link.submit(drive::SpeedRamp{1, -1500, 100ms}); // at rest: the next start's aim
        rig.bench.link.runFor(200ms);
        QVERIFY(startAndWait(rig));
        QVERIFY(rig.form.start().result() == Ending::Running);
        QVERIFY(rig.form.start().measured().speed_rpm.back().y() < -300.0);
        const auto speed = rig.chart.drawnMeasured(Quantity::Speed);
        const double off =
            farthest(speed, rig, Quantity::Speed, rig.form.start().duration_s() - 0.1, kSlack_s);
        QVERIFY2(off < kSpeedBound_rpm, qPrintable(QString::number(off)));
        QVERIFY(lastStart(rig).contains(QStringLiteral("backwards")));
    }

    void aStoppedStartIsNoSuccess()
    {
        RevUpBench rig;
        QVERIFY(rig.setAll(kEdited));
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        rig.bench.link.submit(drive::Command{drive::MotorAction::Start, 1});
        QVERIFY(rig.bench.link.runUntil(
            [&] { return rig.form.start().result() == Ending::UnderWay; }, 2s));
        rig.bench.link.runFor(300ms);
        rig.bench.link.drive->stop(rig.bench.link.now);
        QVERIFY(rig.bench.link.runUntil(
            [&] { return rig.form.start().result() != Ending::UnderWay; }, 5s));
        QVERIFY(rig.form.start().result() == Ending::Stopped);
        QVERIFY(lastStart(rig).contains(QStringLiteral("stopped")));
    }

    void whileItRunsOnlyTheCurrentIsPolled()
    {
        RevUpBench rig;
        const auto atRest = rig.form.watchedRegisters();
        QVERIFY(
            std::find(atRest.begin(), atRest.end(), rig.bench.id("REVUP_DATA")) != atRest.end());
        QVERIFY(rig.setAll(kEdited));
        rig.bench.arm();
        QVERIFY(rig.bench.apply());
        int told = 0;
        connect(&rig.form, &widgets::Form::watchedRegistersChanged, &rig.form, [&told] { ++told; });
        rig.bench.link.submit(drive::Command{drive::MotorAction::Start, 1});
        QVERIFY(rig.bench.link.runUntil(
            [&] { return rig.form.start().result() == Ending::UnderWay; }, 2s));
        QVERIFY(told > 0);
        QCOMPARE(rig.form.watchedRegisters(),
            std::vector<catalog::RegisterId>{rig.bench.id("I_Q_MEAS")});
    }
};

QTEST_MAIN(TestRevUpStart)
#include "tst_rev_up_start.moc"
