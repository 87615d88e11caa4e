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

} // namespace

class TestSetPointTrace : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itStepsAtTheInstantAndRampsInItsTime()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.take(speed(1.0, 500.0));
        trace.advance(2.0);
        trace.take(speed(2.1, 1500.0)); // known of only later
        trace.take(speed(2.5, 500.0, 1000));
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

    void aRampThatIsOvertakenGoesOnFromWhereItWas()
    {
        Bench bench({facts::signal(1, "rpm")});
        SetPointTrace trace(bench.capture, bench.view);
        trace.take(speed(1.0, 0.0));
        trace.take(speed(2.0, 1000.0, 1000));
        trace.take(speed(2.5, 0.0, 500)); // half way
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
        trace.take(speed(101.0, 500.0, 0, 100.0)); // the board's axis is 100 s ahead
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
        trace.take(speed(1.0, 500.0));
        trace.advance(2.0);
        const auto channel = *bench.capture.find(*id(bench));
        QCOMPARE(bench.view.plotOf(channel), -1); // nobody wanted to see it
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
        trace.take(speed(1.0, 500.0));
        trace.advance(2.0);
        trace.end();
        trace.advance(9.0);
        const auto channel = *bench.capture.find(*id(bench));
        QVERIFY(bench.capture.timeSpan(channel)->to < 2.0);
        trace.take(speed(10.0, 700.0)); // the next one has nothing of it
        trace.advance(11.0);
        QVERIFY(!bench.capture.valueAt(*bench.capture.find(*id(bench)), 9.0));
    }

private:
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
