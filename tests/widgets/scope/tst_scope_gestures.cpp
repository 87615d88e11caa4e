// The scope as the user drives it: keys, mouse, drops.
#include "support/scope_bench.h"
#include "widgets/base/axis_ticks.h"
#include "widgets/scope/overview.h"

using namespace facts;
using namespace widgets;

class TestScopeGestures : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aValueThatRoundsToZeroHasNoSign();
    void keysDriveTheView();
    void fittingShowsEverything();
    void draggingPansAndEndsFollowing();
    void theWheelZoomsAtTheMouse();
    void aRightDragZoomsIntoTheBox();
    void draggingAnAxisMovesOnlyThatAxis();
    void theWheelOnAnAxisStepsItsGain();
    void gainsAreOneTwoFive();
    void aLegendEntryIsDraggedToAnotherPlot();
    void aLegendEntryThatIsBroughtBackLeavesNoMark();
    void theOverviewShowsAndMovesTheView();
    void clickingTheLegendSelectsAndDeleteRemoves();
    void registersDroppedOnAPlotAreReported();
    void whatIsNoListOfRegistersIsNotAccepted();
};

void TestScopeGestures::keysDriveTheView()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(20'000, 1);
    bench.picture();
    ScopeView &view = bench.view;
    QTest::keyClick(&view, Qt::Key_Space);
    QVERIFY(!view.running());
    QTest::keyClick(&view, Qt::Key_Space);
    QVERIFY(view.running());
    const double span = view.visibleRange().to - view.visibleRange().from;
    QTest::keyClick(&view, Qt::Key_Plus);
    QVERIFY(view.visibleRange().to - view.visibleRange().from < span);
    QTest::keyClick(&view, Qt::Key_Minus);
    QVERIFY(std::abs(view.visibleRange().to - view.visibleRange().from - span) < 1e-6);
    const double right = view.visibleRange().to;
    QTest::keyClick(&view, Qt::Key_Left);
    QVERIFY(view.visibleRange().to < right);
    QVERIFY(!view.time().following());
    QTest::keyClick(&view, Qt::Key_Right);
    QVERIFY(std::abs(view.visibleRange().to - right) < 1e-6);
    QTest::keyClick(&view, Qt::Key_Left);
    QTest::keyClick(&view, Qt::Key_End);
    QVERIFY(view.time().following());
    QCOMPARE(view.visibleRange().to, 19.999);
    QVERIFY(view.gridVisible());
    QTest::keyClick(&view, Qt::Key_G);
    QVERIFY(!view.gridVisible());
    QTest::keyClick(&view, Qt::Key_F);
    QCOMPARE(view.visibleRange().from, 0.0);
    QCOMPARE(view.visibleRange().to, 20.0);
    // With Ctrl they are not the scope's.
    QTest::keyClick(&view, Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(view.running());
}

void TestScopeGestures::aValueThatRoundsToZeroHasNoSign()
{
    QCOMPARE(widgets::valueLabel(-0.0004, 1.0, QLocale::c()), QStringLiteral("0"));
    QVERIFY(widgets::valueLabel(-0.6, 1.0, QLocale::c()).startsWith(QLatin1Char('-')));
}

void TestScopeGestures::fittingShowsEverything()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(30'000, [](int, int tick) { return tick < 100 ? 5000 : 10; });
    bench.view.fitAll();
    bench.picture();
    const auto range = bench.view.valueRangeOf(bench.id(1));
    QVERIFY(range.to > 5000 && range.from < 10 && range.to < 6000);
    bench.view.setVisibleRange(1.0, 2.0);
    QTest::keyClick(&bench.view, Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(bench.view.valueRangeOf(bench.id(1)).to < 30);
    QCOMPARE(bench.view.visibleRange().from, 1.0);
}

void TestScopeGestures::draggingPansAndEndsFollowing()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(20'000, 1);
    bench.picture();
    QSignalSpy spy(&bench.view.time(), &widgets::TimeWindow::followingChanged);
    const auto before = bench.view.visibleRange();
    QWidget &plot = plotOf(bench.view);
    const QPoint center = areaOf(bench.view, 0).center();
    const int distance = areaOf(bench.view, 0).width() / 5;
    QTest::mousePress(&plot, Qt::LeftButton, {}, center);
    QTest::mouseMove(&plot, center + QPoint(distance, 0));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, center + QPoint(distance, 0));
    const auto after = bench.view.visibleRange();
    QVERIFY(std::abs(before.from - after.from - (before.to - before.from) / 5) < 0.01);
    QCOMPARE(spy.size(), 1);
    QVERIFY(!bench.view.time().following());
    bench.picture();
    QCOMPARE(bench.view.visibleRange().from, after.from);
}

void TestScopeGestures::theWheelZoomsAtTheMouse()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(20'000, 1);
    bench.view.setVisibleRange(0.0, 10.0);
    bench.picture();
    QWidget &plot = plotOf(bench.view);
    const QRect area = areaOf(bench.view, 0);
    const auto wheel = [&](QPoint at, int delta, Qt::KeyboardModifiers held) {
        QWheelEvent event(
            at, plot.mapToGlobal(at), {}, {0, delta}, Qt::NoButton, held, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plot, &event);
    };
    const QPoint quarter(area.left() + area.width() / 4, area.center().y());
    wheel(quarter, 120, {});
    auto range = bench.view.visibleRange();
    QVERIFY(range.to - range.from < 9.0);
    QVERIFY(std::abs(range.from + (range.to - range.from) / 4 - 2.5) < 0.02);
    wheel(quarter, -120, Qt::ShiftModifier);
    QVERIFY(std::abs(bench.view.visibleRange().to - bench.view.visibleRange().from
                - (range.to - range.from))
        < 1e-9);
    QVERIFY(bench.view.visibleRange().from > range.from);
    // On the value axis it is the gain.
    const auto values = bench.view.valueRangeOf(bench.id(1));
    range = bench.view.visibleRange();
    wheel({area.left() - 15, area.center().y()}, 120, {});
    QVERIFY(bench.view.valueRangeOf(bench.id(1)).to < values.to);
    QCOMPARE(bench.view.visibleRange().from, range.from);
}

void TestScopeGestures::aRightDragZoomsIntoTheBox()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(10'000, [](int, int tick) { return tick % 100; });
    bench.view.fitAll();
    bench.picture();
    QWidget &plot = plotOf(bench.view);
    const QRect area = areaOf(bench.view, 0);
    const auto values = bench.view.valueRangeOf(bench.id(1));
    const QPoint from(area.left() + area.width() / 2, area.top() + area.height() / 2);
    const QPoint to(area.left() + area.width() * 3 / 4, area.top() + area.height() * 3 / 4);
    QTest::mousePress(&plot, Qt::RightButton, {}, from);
    QTest::mouseMove(&plot, to);
    QTest::mouseRelease(&plot, Qt::RightButton, {}, to);
    const auto range = bench.view.visibleRange();
    QVERIFY(std::abs(range.from - 5.0) < 0.05 && std::abs(range.to - 7.5) < 0.05);
    const auto zoomed = bench.view.valueRangeOf(bench.id(1));
    const double height = values.to - values.from;
    QVERIFY(std::abs(zoomed.to - (values.to - height / 2)) < height * 0.02);
    QVERIFY(std::abs(zoomed.from - (values.to - height * 3 / 4)) < height * 0.02);
}

void TestScopeGestures::draggingAnAxisMovesOnlyThatAxis()
{
    Bench bench({signal(1, "A"), signal(2, "V")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.record(10'000, [](int, int tick) { return tick % 100; });
    bench.picture();
    QWidget &plot = plotOf(bench.view);
    const QRect area = areaOf(bench.view, 0);
    const auto first = bench.view.valueRangeOf(bench.id(1));
    const auto second = bench.view.valueRangeOf(bench.id(2));
    const QPoint axis(area.left() - 15, area.center().y());
    QTest::mousePress(&plot, Qt::LeftButton, {}, axis);
    QTest::mouseMove(&plot, axis + QPoint(0, area.height() / 4));
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, axis + QPoint(0, area.height() / 4));
    const auto moved = bench.view.valueRangeOf(bench.id(1));
    QVERIFY(std::abs(moved.from - first.from - (first.to - first.from) / 4) < 1.0);
    QCOMPARE(bench.view.valueRangeOf(bench.id(2)).from, second.from);
    bench.record(10, 20000); // an axis moved by hand stays where it was put
    bench.picture();
    QCOMPARE(bench.view.valueRangeOf(bench.id(1)).to, moved.to);
    QVERIFY(bench.view.valueRangeOf(bench.id(2)).to > 20000);
    QTest::mouseClick(&plot, Qt::MiddleButton, {}, axis);
    bench.picture();
    QVERIFY(bench.view.valueRangeOf(bench.id(1)).to > 20000);
}

void TestScopeGestures::theWheelOnAnAxisStepsItsGain()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(10'000, [](int, int tick) { return tick % 100; });
    bench.view.fitAll();
    bench.picture();
    const QRect area = areaOf(bench.view, 0);
    const QPoint axis(area.left() - 10, area.center().y());
    const auto turn = [&](int delta) {
        QWheelEvent wheel(axis, plotOf(bench.view).mapToGlobal(axis), {}, QPoint(0, delta),
            Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&plotOf(bench.view), &wheel);
        const auto range = bench.view.valueRangeOf(bench.id(1));
        return (range.to - range.from) / 8; // a division
    };
    const auto before = bench.view.valueRangeOf(bench.id(1));
    const double first = turn(120);
    QCOMPARE(first, 10.0); // from 120 A in all, which is between 10 and 20 a division
    QCOMPARE(turn(120), 5.0);
    QCOMPARE(turn(120), 2.0);
    QCOMPARE(turn(-120), 5.0);
    QCOMPARE(turn(60), 5.0); // half a notch of a fine wheel
    QCOMPARE(turn(60), 2.0);
    const auto now = bench.view.valueRangeOf(bench.id(1));
    const double middle = before.from + (before.to - before.from) / 2;
    // What is at the mouse stays.
    QVERIFY(std::abs(now.from + (now.to - now.from) / 2 - middle) < 1.0);
}

void TestScopeGestures::gainsAreOneTwoFive()
{
    QCOMPARE(steppedScale(1.0, 1), 2.0);
    QCOMPARE(steppedScale(2.0, 1), 5.0);
    QCOMPARE(steppedScale(5.0, 1), 10.0);
    QCOMPARE(steppedScale(1.0, -1), 0.5);
    QCOMPARE(steppedScale(0.001, -1), 0.0005);
    QCOMPARE(steppedScale(3.0, 1), 5.0);
    QCOMPARE(steppedScale(3.0, -1), 2.0);
    QCOMPARE(steppedScale(1.5, 1), 2.0);
    QCOMPARE(steppedScale(1.5, -1), 1.0);
    QCOMPARE(steppedScale(7.0, 1), 10.0);
    QCOMPARE(steppedScale(7.0, -1), 5.0);
    QCOMPARE(steppedScale(2e-7, 3), 2e-6);
    double scale = 1.0;
    for (int i = 0; i < 30; ++i)
        scale = steppedScale(scale, 1);
    QCOMPARE(scale, 1e10);
    for (int i = 0; i < 60; ++i)
        scale = steppedScale(scale, -1);
    QVERIFY(std::abs(scale / 1e-10 - 1.0) < 1e-9);
    QCOMPARE(steppedScale(0.0, 1), 1.0);
    QCOMPARE(steppedScale(std::nan(""), 1), 1.0);
}

void TestScopeGestures::aLegendEntryThatIsBroughtBackLeavesNoMark()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(100, 1);
    bench.picture();
    QWidget &plot = plotOf(bench.view);
    const QPoint entry = legendOf(bench.view, 0);
    QTest::mousePress(&plot, Qt::LeftButton, {}, entry);
    const QPoint away = entry + QPoint(40, 40);
    QMouseEvent move(
        QEvent::MouseMove, away, plot.mapToGlobal(away), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&plot, &move);
    const auto count = [&bench] {
        int visible = 0;
        for (const QRubberBand *band : bench.view.findChildren<QRubberBand *>())
            visible += band->isVisible() ? 1 : 0;
        return visible;
    };
    const int marks = count();
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, entry);
    QCOMPARE(marks, 1);
    QCOMPARE(count(), 0);
}

void TestScopeGestures::aLegendEntryIsDraggedToAnotherPlot()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "V")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.view.addChannel(bench.id(3), 1);
    bench.record(100, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::channelMoved);
    QWidget &plot = plotOf(bench.view);
    const auto entryOf = [&](int index) { return legendOf(bench.view, index); };
    const auto drag = [&](const QPoint &from, const QPoint &to) {
        QTest::mousePress(&plot, Qt::LeftButton, {}, from);
        QMouseEvent move(
            QEvent::MouseMove, to, plot.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&plot, &move);
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, to);
        bench.picture();
    };
    const auto plots = [&] {
        return QList<int>{bench.view.plotOf(bench.id(1)), bench.view.plotOf(bench.id(2)),
            bench.view.plotOf(bench.id(3))};
    };
    const QColor color = bench.view.colorOf(bench.id(1));
    drag(entryOf(0), areaOf(bench.view, 1).center());
    QCOMPARE(plots(), (QList<int>{1, 0, 1}));
    QCOMPARE(spy.size(), 1);
    QCOMPARE(bench.view.colorOf(bench.id(1)), color);
    QCOMPARE(bench.view.selectedChannel(), bench.id(1)); // the one that was taken
    drag(entryOf(0), areaOf(bench.view, 0).center()); // where it is already
    drag(entryOf(0), entryOf(0) + QPoint(3, 0)); // a click of a shaky hand
    QCOMPARE(spy.size(), 1);
    const QPoint below(plot.width() / 2, plot.height() - 3);
    drag(entryOf(1), below); // below all: a plot of its own
    QCOMPARE(plots(), (QList<int>{1, 0, 2}));
    drag(entryOf(2), below); // it has one
    QCOMPARE(spy.size(), 2);
    drag(entryOf(0), areaOf(bench.view, 2).center()); // the plot it leaves vanishes
    QCOMPARE(plots(), (QList<int>{0, 1, 1}));
    QCOMPARE(bench.view.plotCount(), 2);
    QTest::mousePress(&plot, Qt::LeftButton, {}, entryOf(0));
    QTest::keyClick(&bench.view, Qt::Key_Delete); // while the mouse still holds it
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, below);
    QCOMPARE(plots(), (QList<int>{-1, 0, 0}));
}

void TestScopeGestures::theOverviewShowsAndMovesTheView()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(100'000, [](int, int tick) { return tick % 100; });
    auto *overview = bench.view.findChild<ScopeOverview *>();
    QVERIFY(!overview->isVisible());
    bench.view.setFocus();
    QTest::keyClick(&bench.view, Qt::Key_O);
    QVERIFY(overview->isVisible());
    bench.view.setVisibleRange(40.0, 60.0);
    bench.picture();
    QVERIFY(std::abs(overview->box().left() / overview->width() - 0.4) < 0.01);
    QVERIFY(std::abs(overview->box().right() / overview->width() - 0.6) < 0.01);
    const QImage strip = overview->grab().toImage();
    const int middle = strip.width() / 2;
    int drawn = 0;
    for (int y = 0; y < strip.height(); ++y)
        drawn += strip.pixel(middle, y) == bench.view.colorOf(bench.id(1)).rgb() ? 1 : 0;
    QVERIFY(drawn > strip.height() / 2);
    const auto at = [&](double share) { return QPoint(int(share * overview->width()), 10); };
    const auto drag = [&](double from, double to) {
        QTest::mousePress(overview, Qt::LeftButton, {}, at(from));
        QMouseEvent move(QEvent::MouseMove, at(to), overview->mapToGlobal(at(to)), Qt::NoButton,
            Qt::LeftButton, {});
        QApplication::sendEvent(overview, &move);
        QTest::mouseRelease(overview, Qt::LeftButton, {}, at(to));
    };
    drag(0.5, 0.7);
    QVERIFY(std::abs(bench.view.visibleRange().from - 60.0) < 0.5);
    QVERIFY(std::abs(bench.view.visibleRange().to - 80.0) < 0.5);
    drag(0.8, 0.9); // the right edge
    QVERIFY(std::abs(bench.view.visibleRange().from - 60.0) < 0.5);
    QVERIFY(std::abs(bench.view.visibleRange().to - 90.0) < 0.5);
    QTest::mouseClick(overview, Qt::LeftButton, {}, at(0.2)); // beside it
    const auto range = bench.view.visibleRange();
    QVERIFY(std::abs((range.from + range.to) / 2 - 20.0) < 0.5);
    QTest::keyClick(overview, Qt::Key_Right);
    QVERIFY(bench.view.visibleRange().from > range.from);
}

void TestScopeGestures::clickingTheLegendSelectsAndDeleteRemoves()
{
    Bench bench({signal(1, "A"), signal(2, "A")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.record(100, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::removeRequested);
    QTest::keyClick(&bench.view, Qt::Key_Delete); // nothing is selected
    QCOMPARE(spy.size(), 0);
    const QPoint entry = legendOf(bench.view, 0);
    QTest::mouseClick(&plotOf(bench.view), Qt::LeftButton, {}, entry);
    QTest::keyClick(&bench.view, Qt::Key_Delete);
    QCOMPARE(spy.size(), 1);
    QCOMPARE(spy[0][0].value<quint32>(), bench.id(1));
    QCOMPARE(bench.view.channels(), QList<ChannelId>{bench.id(2)});
    bench.picture();
}

void TestScopeGestures::registersDroppedOnAPlotAreReported()
{
    Bench bench({signal(1, "A"), signal(2, "V")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2), 1);
    bench.record(100, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::registerDropped);
    bool entered = false;
    sendDrop(bench.view, bench.view.plotRect(1).center(), "[1337, 7]", &entered);
    QVERIFY(entered);
    QCOMPARE(spy.size(), 2);
    QCOMPARE(spy[0][0].value<quint32>(), 1337U);
    QCOMPARE(spy[0][1].toInt(), 1);
    const QPoint onAxis(bench.view.plotRect(0).left() - 15, bench.view.plotRect(0).center().y());
    sendDrop(bench.view, onAxis, "[5]", &entered);
    QCOMPARE(spy.last()[1].toInt(), 0);
    sendDrop(bench.view, {400, bench.view.height() - 5}, "[6]", &entered);
    QCOMPARE(spy.last()[1].toInt(), -1);
}

void TestScopeGestures::whatIsNoListOfRegistersIsNotAccepted()
{
    Bench bench({signal(1, "A")});
    QSignalSpy spy(&bench.view, &ScopeView::registerDropped);
    for (const char *bad : {"", "garbage", "{}", "[]", "[-1]", "[4294967296]", "[\"1\"]", "[1.5"}) {
        bool entered = true;
        sendDrop(bench.view, {400, 200}, bad, &entered);
        QVERIFY2(!entered, bad);
    }
    QCOMPARE(spy.size(), 0);
}

QTEST_MAIN(TestScopeGestures)
#include "tst_scope_gestures.moc"
