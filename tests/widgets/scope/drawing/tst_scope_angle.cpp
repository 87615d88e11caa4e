// Angles in the picture: where one passes its end it goes on at the other end, without a stroke across; what only looks
// like it (a step, a count of turns, a band of many turns) is drawn as it is.
#include "support/scope_bench.h"

using namespace facts;

class TestScopeAngle : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anAngleThatTurnsHasNoSpikes_data()
    {
        QTest::addColumn<double>("seconds"); // of the picture
        QTest::addColumn<int>("degrees"); // a sample, at 1 kHz
        QTest::newRow("steps") << 0.4 << 2;
        QTest::newRow("steps backwards") << 0.4 << -2;
        QTest::newRow("columns") << 8.0 << 1;
        QTest::newRow("columns backwards") << 8.0 << -1;
        QTest::newRow("many samples a column") << 80.0 << 1;
    }
    void anAngleThatTurnsHasNoSpikes();
    void theEndsOfATurnAreStillThere();
    void aStepOfAnotherUnitIsJoined();
    void aCountOfTurnsIsJoined();

private:
    /// The greatest height of a stroke of the trace's colour, in pixels of the plot's height.
    static int tallest(Bench &bench, const QImage &picture)
    {
        const QColor color = bench.view.colorOf(bench.id(1));
        const QRect area = bench.view.plotRect(0);
        int most = 0;
        for (int x = area.left() + 2; x < area.right() - 60;
             ++x) { // right: the last value in words
            int run = 0;
            for (int y = area.top(); y <= area.bottom(); ++y) {
                run = picture.pixel(x, y) == color.rgb() ? run + 1 : 0;
                most = std::max(most, run);
            }
        }
        return most;
    }
    static int turning(int tick, int degrees)
    {
        const int angle = (tick * degrees) % 360;
        return angle > 180 ? angle - 360 : angle < -180 ? angle + 360 : angle;
    }
};

void TestScopeAngle::anAngleThatTurnsHasNoSpikes()
{
    QFETCH(double, seconds);
    QFETCH(int, degrees);
    Bench bench({signal(1, "°")});
    const bool slow = seconds > 50.0;
    bench.record(int(seconds * 1000),
        [&](int, int tick) { return turning(slow ? tick / 50 : tick, degrees); });
    bench.view.addChannel(bench.id(1));
    bench.view.setVisibleRange(0.0, seconds);
    bench.view.fitValues();
    const QImage picture = bench.picture();
    const int height = bench.view.plotRect(0).height();
    QVERIFY2(tallest(bench, picture) < height / 8,
        qPrintable(QStringLiteral("%1 of %2").arg(tallest(bench, picture)).arg(height)));
}

void TestScopeAngle::theEndsOfATurnAreStillThere()
{
    Bench bench({signal(1, "°")});
    bench.record(8000, [](int, int tick) { return turning(tick, 1); });
    bench.view.addChannel(bench.id(1));
    bench.view.setVisibleRange(0.0, 8.0);
    bench.view.fitValues();
    const QImage picture = bench.picture();
    const QColor color = bench.view.colorOf(bench.id(1));
    const QRect area = bench.view.plotRect(0);
    const auto range = bench.view.valueRangeOf(bench.id(1));
    const auto rowOf = [&](double value) {
        return area.top() + int((range.to - value) / (range.to - range.from) * area.height());
    };
    for (const int turn : {2, 5, 12}) { // 180 degrees, and -179 right after it
        const int x = area.left() + int((turn * 0.36 + 0.18) / 8.0 * area.width());
        bool high = false;
        bool low = false;
        for (int dx = -2; dx <= 2; ++dx) {
            for (int dy = -2; dy <= 2; ++dy) {
                high = high || picture.pixel(x + dx, rowOf(180.0) + dy) == color.rgb();
                low = low || picture.pixel(x + dx, rowOf(-179.0) + dy) == color.rgb();
            }
        }
        QVERIFY2(high && low, qPrintable(QString::number(turn)));
    }
}

void TestScopeAngle::aStepOfAnotherUnitIsJoined()
{
    for (const double seconds : {0.4, 8.0}) {
        Bench bench({signal(1, "A")});
        bench.record(int(seconds * 1000), [&](int, int tick) { return tick < 200 ? -180 : 180; });
        bench.view.addChannel(bench.id(1));
        bench.view.setVisibleRange(0.0, seconds);
        bench.view.fitValues();
        QVERIFY(tallest(bench, bench.picture()) > bench.view.plotRect(0).height() / 2);
    }
}

void TestScopeAngle::aCountOfTurnsIsJoined()
{
    Bench bench({signal(1, "°")}); // many turns: a position, which jumps where it jumps
    bench.record(8000, [](int, int tick) { return tick < 4000 ? 0 : 3600; });
    bench.view.addChannel(bench.id(1));
    bench.view.setVisibleRange(0.0, 8.0);
    bench.view.fitValues();
    QVERIFY(tallest(bench, bench.picture()) > bench.view.plotRect(0).height() / 2);
}

QTEST_MAIN(TestScopeAngle)
#include "tst_scope_angle.moc"
