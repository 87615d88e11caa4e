// The computed trace of the set-points as they were sent.
#include "support/scope_bench.h"
#include "widgets/scope/signals/set_point_trace.h"

using facts::Bench;
using widgets::SetPointTrace;

namespace {

drive::SentSetPoint speed(double seconds, double rpm, int ms = 0, double ahead = 0.0)
{
    drive::SentSetPoint sent;
    sent.value = rpm;
    sent.seconds = seconds;
    sent.ramp = std::chrono::milliseconds(ms);
    sent.ahead_s = ahead;
    return sent;
}

drive::SetPointsEnd ends(double seconds, bool held, int motor = 0)
{
    drive::SetPointsEnd end;
    end.seconds = seconds;
    end.held = held;
    end.motor = motor;
    return end;
}

} // namespace

class TestSetPointTrace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itStepsAtTheInstantAndRampsInItsTime()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 500.0));
        trace.advance(2.0);
        trace.accept(speed(2.1, 1500.0)); // known of only later
        trace.accept(speed(2.5, 500.0, 1000));
        for (double now = 2.2; now < 5.0; now += 0.0167)
            trace.advance(now);
        const auto channel = bench.capture.find(*id(bench));
        QVERIFY(channel);
        const auto at = [&](double seconds) {
            return bench.capture.valueAt(*channel, seconds).value_or(-1.0);
        };
        QCOMPARE(at(0.9999), -1.0); // what was before is not known
        QCOMPARE(at(1.0001), 500.0);
        QCOMPARE(at(2.0999), 500.0);
        QCOMPARE(at(2.1001), 1500.0);
        QCOMPARE(at(2.4999), 1500.0);
        QVERIFY(std::abs(at(3.0) - 1000.0) < 2.0);
        QCOMPARE(at(3.6), 500.0);
        QCOMPARE(at(4.6), 500.0);
        QCOMPARE(bench.capture.refused().backwards, 0U);
    }

    void aRampFromNobodyKnowsWhereIsAGap()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 1500.0, 1000));
        for (double now = 1.1; now < 5.0; now += 0.0167)
            trace.advance(now);
        QVERIFY(!at(bench, 1.0001) && !at(bench, 1.5) && !at(bench, 1.999));
        QCOMPARE(at(bench, 2.001), std::optional(1500.0));
        QCOMPARE(at(bench, 4.0), std::optional(1500.0));
        trace.accept(speed(6.0, 500.0, 1000)); // that of this one is known
        trace.advance(8.0);
        QVERIFY(std::abs(*at(bench, 6.5) - 1000.0) < 2.0);
        QCOMPARE(bench.capture.refused().backwards, 0U);
    }

    void aRampThatIsStoppedStays()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 0.0));
        trace.accept(speed(2.0, 1000.0, 1000));
        trace.advance(2.7);
        trace.finish(ends(2.5, true)); // known of only later
        trace.advance(5.0);
        QVERIFY(std::abs(*at(bench, 2.6) - 500.0) < 2.0);
        QVERIFY(std::abs(*at(bench, 4.0) - 500.0) < 2.0);
        trace.accept(speed(6.0, 1500.0, 1000)); // and goes on from there
        trace.advance(8.0);
        QVERIFY(std::abs(*at(bench, 6.5) - 1000.0) < 2.0);
        trace.accept(speed(9.0, 0.0, 1000));
        trace.finish(ends(9.5, false)); // whether it heard is unknown
        trace.advance(12.0);
        QVERIFY(at(bench, 9.4) && !at(bench, 9.6) && !at(bench, 11.0));
        SetPointTrace first(bench.capture, bench.view); // from where to where: neither is known
        first.accept(speed(21.0, 1500.0, 1000));
        first.finish(ends(21.5, true));
        first.advance(25.0);
        QVERIFY(!at(bench, 21.4) && !at(bench, 21.6) && !at(bench, 23.0));
    }

    void aStopEndsIt()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 500.0));
        trace.finish(ends(2.0, false));
        trace.accept(speed(1.9, 900.0)); // its answer came behind the stop
        trace.advance(4.0);
        QCOMPARE(at(bench, 1.8), std::optional(500.0));
        QVERIFY(!at(bench, 2.1) && !at(bench, 3.5));
        trace.accept(speed(5.0, 800.0, 1000)); // from where is unknown again
        trace.advance(8.0);
        QVERIFY(!at(bench, 5.5));
        QCOMPARE(at(bench, 6.5), std::optional(800.0));
        trace.finish(ends(9.0, false, 2)); // of another motor
        trace.advance(11.0);
        QCOMPARE(at(bench, 10.0), std::optional(800.0));
    }

    void whatWaitsForTheStartIsAStep()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        auto waits = speed(1.0, 500.0, 1000);
        waits.runs = false;
        trace.accept(waits);
        waits.seconds = 2.0;
        waits.value = 1500.0;
        trace.accept(waits);
        trace.finish(ends(3.0, true)); // nothing ramps
        trace.accept(speed(5.0, 0.0, 1000)); // it was started in between: it comes from somewhere
        trace.advance(8.0);
        QCOMPARE(at(bench, 1.1), std::optional(500.0));
        QCOMPARE(at(bench, 2.1), std::optional(1500.0));
        QCOMPARE(at(bench, 4.9), std::optional(1500.0));
        QVERIFY(!at(bench, 5.5));
        QCOMPARE(at(bench, 6.1), std::optional(0.0));
    }

    void whatMayNotHaveArrivedIsAGap()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 500.0));
        auto lost = speed(2.0, 900.0);
        lost.sure = false;
        trace.accept(lost);
        trace.advance(4.0);
        QCOMPARE(at(bench, 1.9), std::optional(500.0));
        QVERIFY(!at(bench, 2.1) && !at(bench, 3.5));
    }

    /// Who follows a current follows no speed.
    void anotherKindOfSetPointEndsIt()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 500.0));
        auto current = speed(2.0, 1.5);
        current.kind = drive::SentSetPoint::Kind::Current;
        trace.accept(current);
        trace.advance(4.0);
        QCOMPARE(at(bench, 1.9), std::optional(500.0));
        QVERIFY(!at(bench, 2.1) && !at(bench, 3.5));
    }

    void aRampThatIsOvertakenGoesOnFromWhereItWas()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 0.0));
        trace.accept(speed(2.0, 1000.0, 1000));
        trace.accept(speed(2.5, 0.0, 500)); // half way
        trace.advance(5.0);
        const auto channel = *bench.capture.find(*id(bench));
        QVERIFY(std::abs(*bench.capture.valueAt(channel, 2.4999) - 500.0) < 2.0);
        QVERIFY(std::abs(*bench.capture.valueAt(channel, 2.75) - 250.0) < 2.0);
        QCOMPARE(*bench.capture.valueAt(channel, 3.1), 0.0);
    }

    void itStandsWhereTheSamplesStand()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(101.0, 500.0, 0, 100.0)); // the board's axis is 100 s ahead
        trace.advance(2.0);
        const auto span = bench.capture.timeSpan(*bench.capture.find(*id(bench)));
        QVERIFY(std::abs(span->from - 101.0) < 1e-9);
        QVERIFY(std::abs(span->to - (102.0 - SetPointTrace::kBehind_s)) < 1e-9);
    }

    void itIsShownWithItsUnitUntilItIsTakenOff()
    {
        Bench bench({facts::signal(1, "A"), facts::signal(2, "rpm")});
        bench.view.addChannel(bench.id(1), 0);
        bench.view.addChannel(bench.id(2), 1);
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 500.0));
        trace.advance(2.0);
        const auto channel = *bench.capture.find(*id(bench));
        QCOMPARE(bench.view.plotOf(channel), -1); // it was not to be shown
        trace.setShown(true);
        trace.advance(2.1);
        QCOMPARE(bench.view.plotOf(channel), 1);
        trace.setShown(false);
        QCOMPARE(bench.view.plotOf(channel), -1);
        trace.setShown(true);
        trace.advance(2.2);
        bench.view.removeChannel(channel);
        Q_EMIT bench.view.removeRequested(channel); // by its own menu
        QVERIFY(!trace.shown());
        trace.advance(2.3);
        QCOMPARE(bench.view.plotOf(channel), -1);
        trace.setShown(true);
        bench.capture.clear(); // what was recorded is cleared: it goes on
        trace.advance(3.0);
        const auto anew = bench.capture.find(*id(bench));
        QVERIFY(anew && bench.view.plotOf(*anew) >= 0);
        QCOMPARE(bench.capture.valueAt(*anew, 2.5), std::optional(500.0));
    }

    void theEndOfAConnectionEndsIt()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.accept(speed(1.0, 500.0));
        trace.advance(2.0);
        trace.end();
        trace.advance(9.0);
        const auto channel = *bench.capture.find(*id(bench));
        QVERIFY(bench.capture.timeSpan(channel)->to < 2.0);
        trace.accept(speed(10.0, 700.0)); // the next one has nothing of it
        trace.advance(11.0);
        QVERIFY(!bench.capture.valueAt(*bench.capture.find(*id(bench)), 9.0));
    }

private:
    static std::optional<double> at(const Bench &bench, double seconds)
    {
        return bench.capture.valueAt(*bench.capture.find(*id(bench)), seconds);
    }
    static std::optional<catalog::RegisterId> id(const Bench &bench)
    {
        for (const capture::ChannelInfo &info : bench.capture.channels())
            if (info.name == "SPEED_SENT")
                return info.registerId;
        return {};
    }
};

QTEST_MAIN(TestSetPointTrace)
#include "tst_set_point_trace.moc"
