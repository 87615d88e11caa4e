// The scope as a person sees and drives it: pixels of the grabbed widget, keys, mouse, drops.
#include "capture/capture.h"
#include "widgets/scope/axis_ticks.h"
#include "widgets/scope/scope_overview.h"
#include "widgets/scope/scope_view.h"

#include <QtTest>
#include <QtWidgets>

#include <cmath>

using namespace widgets;
using capture::Capture;
using capture::ChannelId;

class TestScopeView : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEmptyScopeSaysWhatToDo();
    void aTraceIsDrawnWhereItsValuesAre();
    void aGapShowsNoTraceAndIsShaded();
    void singleSamplesAreDrawnAsSteps();
    void aPeakOfOneSampleIsNeverLost();
    void signalsOfOneUnitShareAnAxisAndOthersGetTheirOwn();
    void aFifthUnitSharesTheLastAxis();
    void plotsAreStackedAndVanishWhenEmpty();
    void followingKeepsTheNewestSampleAtTheRightEdge();
    void aYoungSessionBeginsAtZeroSeconds();
    void noiseOfADigitStaysSmall();
    void tracesThatOverlapAllStayVisible();
    void aLineIsNeverHiddenByABand();
    void aStoppedPictureStandsStillWhileRecordingGoesOn();
    void manyChangesMakeOneRedraw();
    void keysDriveTheView();
    void fittingShowsEverything();
    void draggingPansAndEndsFollowing();
    void theWheelZoomsAtTheMouse();
    void aRightDragZoomsIntoTheBox();
    void draggingAnAxisMovesOnlyThatAxis();
    void theWheelOnAnAxisStepsItsGain();
    void gainsAreOneTwoFive();
    void aLegendEntryIsDraggedToAnotherPlot();
    void theOverviewShowsAndMovesTheView();
    void clickingTheLegendSelectsAndDeleteRemoves();
    void registersDroppedOnAPlotAreReported();
    void whatIsNoListOfRegistersIsNotAccepted();
    void coloursStayWithTheRegisterAndFollowTheTheme();
    void aClearedCaptureKeepsItsTracesByRegister();
    void nonsenseRangesChangeNothing();
    void screenReadersHearWhatIsShown();
};

namespace {

capture::StreamSignal signal(catalog::RegisterId id, const char *unit)
{
    return {id, "S" + std::to_string(id), unit, 1.0, 0.0};
}

capture::StreamLayout layoutOf(std::vector<capture::StreamSignal> fast, capture::StreamId id = 1)
{
    return {id, 1000.0, 0.0, 1, std::move(fast), {}};
}

/// A scope of 800 x 400 on a capture whose signals are at 1 kHz.
struct Bench {
    Capture capture;
    ScopeView view{capture};
    capture::Tick tick = 0;
    capture::StreamId stream = 1;
    std::size_t signalCount = 0;

    explicit Bench(std::vector<capture::StreamSignal> fast)
    {
        signalCount = fast.size();
        capture.begin(layoutOf(std::move(fast)));
        view.resize(800, 400);
        view.setAttribute(Qt::WA_DontShowOnScreen);
        QPalette light;
        light.setColor(QPalette::Base, Qt::white);
        light.setColor(QPalette::Text, Qt::black);
        view.setPalette(light);
        view.show();
    }

    ChannelId id(catalog::RegisterId reg) const { return *capture.find(reg); }

    /// Appends `count` samples of every signal; `value` is called with (signal, tick).
    template <class Value>
    void record(int count, Value value)
    {
        capture::SampleBlock block{stream, tick, static_cast<std::uint32_t>(count), {}, {}, 0};
        for (std::size_t s = 0; s < signalCount; ++s) {
            for (int i = 0; i < count; ++i)
                block.fast.push_back(static_cast<std::int16_t>(value(int(s), int(tick) + i)));
        }
        capture.append(block);
        tick += count;
        view.captureChanged();
    }
    void record(int count, int value)
    {
        record(count, [value](int, int) { return value; });
    }

    /// The picture after everything that is due has been drawn.
    QImage picture()
    {
        const quint64 before = view.redraws();
        view.redraw();
        while (view.redraws() == before) // its timer is due within a frame; ctest ends a hang
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        return view.grab().toImage().convertToFormat(QImage::Format_RGB32);
    }
};

/// Rows of one pixel column that have exactly the trace's colour.
QList<int> rowsOf(const QImage &image, int x, const QColor &color)
{
    QList<int> rows;
    for (int y = 30; y < image.height() - 30; ++y) { // below the legend, above the time labels
        if (image.pixel(x, y) == color.rgb())
            rows.append(y);
    }
    return rows;
}

void sendDrop(QWidget &target, const QPoint &at, const QByteArray &json, bool *entered)
{
    QMimeData data;
    data.setData(QString::fromLatin1(kRegisterMimeType), json);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.setAccepted(false);
    QApplication::sendEvent(&target, &enter);
    *entered = enter.isAccepted();
    if (!*entered)
        return;
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&target, &drop);
}

QWidget &plotOf(ScopeView &view) { return *view.findChild<QWidget *>(QStringLiteral("scopePlot")); }

/// Where a plot's traces are, in pixels of the plot widget, which gets the mouse.
QRect areaOf(ScopeView &view, int plot)
{
    const QRect area = view.plotRect(plot);
    return {plotOf(view).mapFrom(&view, area.topLeft()), area.size()};
}

} // namespace

void TestScopeView::anEmptyScopeSaysWhatToDo()
{
    Bench bench({});
    QLabel *hint = bench.view.findChild<QLabel *>(QStringLiteral("scopeHint"));
    QVERIFY(
        hint && hint->isVisibleTo(&bench.view) && hint->text().contains(QStringLiteral("Drag")));
    bench.capture.begin(layoutOf({signal(1, "A")}, 2));
    bench.view.addChannel(bench.id(1));
    QVERIFY(!hint->isVisibleTo(&bench.view));
    bench.view.removeChannel(bench.id(1));
    QVERIFY(hint->isVisibleTo(&bench.view));
}

void TestScopeView::aTraceIsDrawnWhereItsValuesAre()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(10000, [](int, int tick) { return tick < 5000 ? -1000 : 1000; });
    bench.view.fitAll();
    const QImage image = bench.picture();
    const QColor color = bench.view.colorOf(bench.id(1));
    const QList<int> left = rowsOf(image, 250, color);
    const QList<int> right = rowsOf(image, 600, color);
    QCOMPARE(left.size(), 1);
    QCOMPARE(right.size(), 1);
    QVERIFY(left.first() > 300 && right.first() < 100);
}

void TestScopeView::aGapShowsNoTraceAndIsShaded()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(4000, 500);
    bench.tick += 2000; // lost
    bench.record(4000, 500);
    bench.view.fitAll();
    const QImage image = bench.picture();
    const QColor color = bench.view.colorOf(bench.id(1));
    const QRect area = bench.view.plotRect(0);
    const auto at = [&](double share) { return area.left() + int(share * area.width()); };
    QCOMPARE(rowsOf(image, at(0.2), color).size(), 1);
    QCOMPARE(rowsOf(image, at(0.5), color).size(), 0);
    QCOMPARE(rowsOf(image, at(0.8), color).size(), 1);
    const int y = area.top() + area.height() / 4 + 3;
    QCOMPARE(QColor(image.pixel(at(0.21), y)), QColor(Qt::white));
    QVERIFY(QColor(image.pixel(at(0.51), y)) != QColor(Qt::white));
}

void TestScopeView::singleSamplesAreDrawnAsSteps()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(10, [](int, int tick) { return tick % 2 * 100; });
    bench.view.setVisibleRange(0.0, 0.010);
    bench.view.fitValues();
    const QImage image = bench.picture();
    const QColor color = bench.view.colorOf(bench.id(1));
    const QRect area = bench.view.plotRect(0);
    // Nine tenths into a sample it is still that sample's value: no slope, no rounding to the nearest.
    for (int i = 0; i < 9; ++i) {
        const int x = area.left() + int((i + 0.9) * area.width() / 10.0);
        const QList<int> rows = rowsOf(image, x, color);
        QCOMPARE(rows.size(), 1);
        QCOMPARE(rows.first() < area.center().y(), i % 2 == 1);
    }
}

void TestScopeView::aPeakOfOneSampleIsNeverLost()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(1'000'000, [](int, int tick) { return tick == 654'321 ? 30000 : 0; });
    bench.view.fitAll();
    const QImage image = bench.picture();
    const QColor color = bench.view.colorOf(bench.id(1));
    const QRect area = bench.view.plotRect(0);
    const int x = area.left() + int(0.654321 * area.width());
    int tall = 0;
    for (int dx = -1; dx <= 1; ++dx)
        tall = std::max(tall, int(rowsOf(image, x + dx, color).size()));
    QVERIFY(tall > area.height() / 2);
}

void TestScopeView::signalsOfOneUnitShareAnAxisAndOthersGetTheirOwn()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "rpm")});
    for (const catalog::RegisterId reg : {1U, 2U, 3U})
        bench.view.addChannel(bench.id(reg));
    QCOMPARE(bench.view.plotCount(), 1);
    QCOMPARE(bench.view.axisCount(0), 2);
    bench.record(1000, [](int s, int) { return s == 2 ? 1500 : s; });
    bench.picture();
    QVERIFY(bench.view.valueRangeOf(bench.id(1)).to < 10);
    QVERIFY(bench.view.valueRangeOf(bench.id(3)).to > 1500);
    bench.view.removeChannel(bench.id(3));
    QCOMPARE(bench.view.axisCount(0), 1);
    bench.picture();
}

void TestScopeView::aFifthUnitSharesTheLastAxis()
{
    Bench bench(
        {signal(1, "A"), signal(2, "V"), signal(3, "rpm"), signal(4, "deg"), signal(5, "W")});
    for (catalog::RegisterId reg = 1; reg <= 5; ++reg)
        bench.view.addChannel(bench.id(reg));
    bench.record(1000, 7);
    QVERIFY(!bench.picture().isNull());
    QCOMPARE(bench.view.axisCount(0), 4);
    QCOMPARE(bench.view.channels().size(), 5);
}

void TestScopeView::plotsAreStackedAndVanishWhenEmpty()
{
    Bench bench({signal(1, "A"), signal(2, "V"), signal(3, "rpm")});
    bench.view.addChannel(bench.id(1), 7); // clipped: an empty scope has one plot
    QCOMPARE(bench.view.plotOf(bench.id(1)), 0);
    bench.view.addChannel(bench.id(2), 1);
    bench.view.addChannel(bench.id(3), -5);
    QCOMPARE(bench.view.plotCount(), 2);
    QCOMPARE(bench.view.plotOf(bench.id(2)), 1);
    QCOMPARE(bench.view.plotOf(bench.id(3)), 0);
    bench.record(1000, 1);
    bench.picture();
    const QRect upper = bench.view.plotRect(0);
    const QRect lower = bench.view.plotRect(1);
    QVERIFY(upper.bottom() < lower.top());
    QCOMPARE(upper.left(), lower.left()); // one time axis: the same second is one vertical line
    QCOMPARE(upper.width(), lower.width());
    bench.view.removeChannel(bench.id(1));
    bench.view.removeChannel(bench.id(3));
    QCOMPARE(bench.view.plotCount(), 1);
    QCOMPARE(bench.view.plotOf(bench.id(2)), 0);
    bench.view.removeChannel(bench.id(2));
    QCOMPARE(bench.view.plotCount(), 1);
    bench.picture();
}

void TestScopeView::followingKeepsTheNewestSampleAtTheRightEdge()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    QVERIFY(bench.view.following());
    bench.record(20'000, 1);
    bench.picture();
    QCOMPARE(bench.view.visibleRange().to, 19.999);
    const double span = bench.view.visibleRange().to - bench.view.visibleRange().from;
    bench.record(500, 1);
    QTRY_COMPARE(bench.view.visibleRange().to, 20.499);
    QVERIFY(std::abs(bench.view.visibleRange().to - bench.view.visibleRange().from - span) < 1e-9);
    bench.view.zoom(2.0);
    QCOMPARE(bench.view.visibleRange().to, 20.499);
    QVERIFY(bench.view.following());
}

void TestScopeView::aYoungSessionBeginsAtZeroSeconds()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(1000, 1);
    bench.picture();
    QCOMPARE(bench.view.visibleRange().from, 0.0);
    QVERIFY(bench.view.visibleRange().to > 1.0);
    bench.view.zoom(100.0);
    bench.record(10, 1);
    QTRY_COMPARE(bench.view.visibleRange().to, 1.009);
}

void TestScopeView::noiseOfADigitStaysSmall()
{
    Bench bench({signal(1, "rpm")});
    bench.view.addChannel(bench.id(1));
    bench.record(8000, [](int, int tick) { return tick % 2; });
    bench.picture();
    const auto range = bench.view.valueRangeOf(bench.id(1));
    QVERIFY(range.to - range.from >= 20.0);
    QVERIFY(range.from < 0.0 && range.to > 1.0);
}

void TestScopeView::tracesThatOverlapAllStayVisible()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "A")});
    for (const catalog::RegisterId reg : {1U, 2U, 3U})
        bench.view.addChannel(bench.id(reg));
    bench.record(20'000, [](int, int tick) { return tick % 2 == 0 ? -1000 : 1000; });
    const QImage image = bench.picture();
    const int x = bench.view.plotRect(0).center().x();
    qsizetype all = 0;
    for (const catalog::RegisterId reg : {1U, 2U, 3U}) {
        const auto rows = rowsOf(image, x, bench.view.colorOf(bench.id(reg)));
        QVERIFY2(rows.size() > 50, qPrintable(QString::number(rows.size())));
        all += rows.size();
    }
    const auto top = rowsOf(image, x, bench.view.colorOf(bench.id(1))).first();
    const auto bottom = rowsOf(image, x, bench.view.colorOf(bench.id(1))).last();
    QVERIFY(all >= bottom - top + 1); // no holes between the stripes
}

void TestScopeView::aLineIsNeverHiddenByABand()
{
    Bench bench({signal(1, "A"), signal(2, "A")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.record(20'000, [](int s, int tick) { return s == 0 ? 300 : tick % 2 * 1000; });
    const QImage image = bench.picture();
    const QRect area = bench.view.plotRect(0);
    for (int x = area.left() + 20; x < area.right() - 100; ++x)
        QCOMPARE(rowsOf(image, x, bench.view.colorOf(bench.id(1))).size(), 1);
}

void TestScopeView::aStoppedPictureStandsStillWhileRecordingGoesOn()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(20'000, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::runningChanged);
    bench.view.setRunning(false);
    bench.picture();
    const double right = bench.view.visibleRange().to;
    const quint64 redraws = bench.view.redraws();
    bench.record(5000, 9);
    QCoreApplication::processEvents();
    QCOMPARE(bench.view.visibleRange().to, right);
    QCOMPARE(bench.view.redraws(), redraws);
    QCOMPARE(bench.capture.size(bench.id(1)), 25'000U);
    bench.view.setRunning(true);
    QTRY_COMPARE(bench.view.visibleRange().to, 24.999);
    QCOMPARE(spy.size(), 2);
}

void TestScopeView::manyChangesMakeOneRedraw()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.picture();
    const quint64 before = bench.view.redraws();
    for (int i = 0; i < 1000; ++i)
        bench.record(10, i);
    bench.picture();
    QVERIFY(bench.view.redraws() - before <= 3);
    const quint64 after = bench.view.redraws();
    bench.view.captureChanged(); // nothing new
    QCoreApplication::processEvents();
    QCOMPARE(bench.view.redraws(), after);
}

void TestScopeView::keysDriveTheView()
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
    QVERIFY(!view.following());
    QTest::keyClick(&view, Qt::Key_Right);
    QVERIFY(std::abs(view.visibleRange().to - right) < 1e-6);
    QTest::keyClick(&view, Qt::Key_Left);
    QTest::keyClick(&view, Qt::Key_End);
    QVERIFY(view.following());
    QCOMPARE(view.visibleRange().to, 19.999);
    QVERIFY(view.gridVisible());
    QTest::keyClick(&view, Qt::Key_G);
    QVERIFY(!view.gridVisible());
    QTest::keyClick(&view, Qt::Key_F);
    QCOMPARE(view.visibleRange().from, 0.0);
    QCOMPARE(view.visibleRange().to, 20.0);
    // With Ctrl they belong to somebody else.
    QTest::keyClick(&view, Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(view.running());
}

void TestScopeView::fittingShowsEverything()
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

void TestScopeView::draggingPansAndEndsFollowing()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(20'000, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::followingChanged);
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
    QVERIFY(!bench.view.following());
    bench.picture();
    QCOMPARE(bench.view.visibleRange().from, after.from);
}

void TestScopeView::theWheelZoomsAtTheMouse()
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

void TestScopeView::aRightDragZoomsIntoTheBox()
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

void TestScopeView::draggingAnAxisMovesOnlyThatAxis()
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

void TestScopeView::theWheelOnAnAxisStepsItsGain()
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
    QVERIFY(
        std::abs(now.from + (now.to - now.from) / 2 - middle) < 1.0); // what is at the mouse stays
}

void TestScopeView::gainsAreOneTwoFive()
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

void TestScopeView::aLegendEntryIsDraggedToAnotherPlot()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "V")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.view.addChannel(bench.id(3), 1);
    bench.record(100, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::channelMoved);
    QWidget &plot = plotOf(bench.view);
    const auto entryOf = [&](int index) {
        return areaOf(bench.view, index).topLeft() + QPoint(20, 12);
    };
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
    bench.view.removeSelected(); // a key, while the mouse still holds it
    QTest::mouseRelease(&plot, Qt::LeftButton, {}, below);
    QCOMPARE(plots(), (QList<int>{-1, 0, 0}));
}

void TestScopeView::theOverviewShowsAndMovesTheView()
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

void TestScopeView::clickingTheLegendSelectsAndDeleteRemoves()
{
    Bench bench({signal(1, "A"), signal(2, "A")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.record(100, 1);
    bench.picture();
    QSignalSpy spy(&bench.view, &ScopeView::removeRequested);
    QTest::keyClick(&bench.view, Qt::Key_Delete); // nothing is selected
    QCOMPARE(spy.size(), 0);
    const QPoint entry = areaOf(bench.view, 0).topLeft() + QPoint(20, 12);
    QTest::mouseClick(&plotOf(bench.view), Qt::LeftButton, {}, entry);
    QTest::keyClick(&bench.view, Qt::Key_Delete);
    QCOMPARE(spy.size(), 1);
    QCOMPARE(spy[0][0].value<quint32>(), bench.id(1));
    QCOMPARE(bench.view.channels(), QList<ChannelId>{bench.id(2)});
    bench.picture();
}

void TestScopeView::registersDroppedOnAPlotAreReported()
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

void TestScopeView::whatIsNoListOfRegistersIsNotAccepted()
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

void TestScopeView::coloursStayWithTheRegisterAndFollowTheTheme()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "A")});
    for (const catalog::RegisterId reg : {1U, 2U, 3U})
        bench.view.addChannel(bench.id(reg));
    const QColor second = bench.view.colorOf(bench.id(2));
    QVERIFY(second != bench.view.colorOf(bench.id(1)) && second != bench.view.colorOf(bench.id(3)));
    bench.view.removeChannel(bench.id(2));
    bench.view.removeChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    QCOMPARE(bench.view.colorOf(bench.id(2)), second);
    bench.record(100, 1);
    QCOMPARE(QColor(bench.picture().pixel(3, 3)), QColor(Qt::white));
    QPalette dark;
    dark.setColor(QPalette::Base, QColor(20, 20, 20));
    dark.setColor(QPalette::Text, Qt::white);
    bench.view.setPalette(dark);
    QCOMPARE(QColor(bench.picture().pixel(3, 3)), QColor(20, 20, 20));
    QVERIFY(bench.view.colorOf(bench.id(2)).lightness() > second.lightness());
    QVERIFY(std::abs(bench.view.colorOf(bench.id(2)).hue() - second.hue()) < 25);
}

void TestScopeView::aClearedCaptureKeepsItsTracesByRegister()
{
    Bench bench({signal(1, "A"), signal(2, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(100, 1);
    bench.picture();
    const ChannelId before = bench.id(1);
    bench.capture.clear();
    bench.record(100, 2);
    bench.picture();
    QVERIFY(bench.id(1) != before);
    QCOMPARE(bench.view.channels(), QList<ChannelId>{bench.id(1)});
    bench.capture.begin({});
    bench.capture.clear();
    bench.view.captureChanged();
    bench.picture();
    QVERIFY(bench.view.channels().isEmpty());
}

void TestScopeView::nonsenseRangesChangeNothing()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(1000, 1);
    bench.view.setVisibleRange(0.0, 1.0);
    const double inf = std::numeric_limits<double>::infinity();
    bench.view.setVisibleRange(1.0, 1.0);
    bench.view.setVisibleRange(2.0, 1.0);
    bench.view.setVisibleRange(std::nan(""), 1.0);
    bench.view.setVisibleRange(0.0, inf);
    bench.view.zoom(0.0);
    bench.view.zoom(std::nan(""));
    QCOMPARE(bench.view.visibleRange().from, 0.0);
    QCOMPARE(bench.view.visibleRange().to, 1.0);
    for (int i = 0; i < 200; ++i)
        bench.view.zoom(2.0);
    bench.picture();
    QVERIFY(bench.view.visibleRange().to > bench.view.visibleRange().from);
    for (int i = 0; i < 200; ++i)
        bench.view.zoom(0.5);
    bench.picture();
    QVERIFY(bench.view.visibleRange().to - bench.view.visibleRange().from <= 1e7 + 1);
}

void TestScopeView::screenReadersHearWhatIsShown()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    QAccessibleInterface *face = QAccessible::queryAccessibleInterface(&bench.view);
    QVERIFY(face);
    QCOMPARE(face->text(QAccessible::Name), QStringLiteral("Scope"));
    QVERIFY(face->text(QAccessible::Description).contains(QStringLiteral("S1")));
}

QTEST_MAIN(TestScopeView)
#include "tst_scope_view.moc"
