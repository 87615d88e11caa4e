// The scope as the user sees it: pixels of the grabbed widget.
#include "support/scope_bench.h"
#include "support/screen/text_catcher.h"
#include "widgets/base/axis_ticks.h"
#include "widgets/scope/drawing/axis_ticker.h"
#include "widgets/scope/ghosts.h"

#include <QRegularExpression>

#include <limits>
#include <random>

using namespace facts;
using namespace widgets;

class TestScopeView : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aPeakStandsWhereTheAxesSay();
    void tracesNeverShowAnotherTimeThanTheAxis();
    void anEmptyScopeSaysWhatToDo();
    void aTraceIsDrawnWhereItsValuesAre();
    void aGapShowsNoTraceAndIsShaded();
    void singleSamplesAreDrawnAsSteps();
    void aPeakOfOneSampleIsNeverLost();
    void theLegendCoversNoTrace();
    void theLegendShowsNoValueThatCountsNoMore();
    void labelsSayWhatADivisionIsWorth();
    void smallTicksAreRoundNumbersAndFew();
    void anAxisOfValuesHasThreeNumbersWhereTheyHaveRoom();
    void smallTicksStandBetweenTheLinesOfTheGrid_data();
    void smallTicksStandBetweenTheLinesOfTheGrid();
    void signalsOfOneUnitShareAnAxisAndOthersGetTheirOwn();
    void theZerosOfTheAxesStandAtOneHeight();
    void theFirstAxisTakesTheUnitThatIsLeft();
    void aFifthUnitSharesTheLastAxis();
    void plotsAreStackedAndVanishWhenEmpty();
    void aPaintBeforeTheNextFrameHasItsNumbers();
    void followingKeepsTheNewestSampleAtTheRightEdge();
    void aYoungSessionBeginsAtZeroSeconds();
    void noiseOfADigitStaysSmall();
    void tracesThatOverlapAllStayVisible();
    void aLineIsNeverHiddenByABand();
    void ofEarlierTracesTheNewerOneIsOnTop();
    void recordsThatCameOneByOneLookLikeAllAtOnce();
    void aStoppedPictureStandsStillWhileRecordingGoesOn();
    void manyChangesMakeOneRedraw();
    void coloursStayWithTheRegisterAndFollowTheTheme();
    void moreTracesThanColoursShareThemEvenly();
    void aClearedCaptureKeepsItsTracesByRegister();
    void nonsenseRangesChangeNothing();
    void screenReadersHearWhatIsShown();
    void thePictureHasThePixelsOfItsScreen();
};

/// Made on one screen and shown on another: the library knows of the first alone.
void TestScopeView::thePictureHasThePixelsOfItsScreen()
{
    Bench bench({signal(1, "A")});
    bench.record(1000, [](int, int tick) { return tick; });
    bench.view.addChannel(bench.id(1));
    bench.view.fitAll();
    const QImage sharp = bench.picture();
    auto *plot = bench.view.findChild<QCustomPlot *>();
    plot->setBufferDevicePixelRatio(2.0 * bench.view.devicePixelRatioF());
    plot->replot();
    QCOMPARE(bench.picture(), sharp);
    QCOMPARE(plot->bufferDevicePixelRatio(), bench.view.devicePixelRatioF());
}

void TestScopeView::aPeakStandsWhereTheAxesSay()
{
    Bench bench({signal(1, "A")});
    constexpr int kPlace = 12'345;
    bench.record(20'000, [](int, int tick) { return tick == kPlace ? 100 : 0; });
    bench.view.addChannel(bench.id(1));
    bench.view.fitAll();
    const QImage image = bench.picture();
    const QRect area = bench.view.plotRect(0);
    const auto time = bench.view.visibleRange();
    const auto values = bench.view.valueRangeOf(bench.id(1));
    const int x = area.left() + int((kPlace / 1000.0 - time.from) / time.span() * area.width());
    const int y = area.top() + int((values.to - 100.0) / (values.to - values.from) * area.height());
    const QColor color = bench.view.colorOf(bench.id(1));
    const QList<int> rows = rowsOf(image, x, color);
    QVERIFY(rows.size() > 100);
    QCOMPARE(rows.first(), y);
    QCOMPARE(rowsOf(image, x - 1, color).size(), 1);
    QCOMPARE(rowsOf(image, x + 1, color).size(), 1);
}

/// The window may be painted between a wish for another picture and that picture.
void TestScopeView::tracesNeverShowAnotherTimeThanTheAxis()
{
    Bench bench({signal(1, "A")});
    bench.record(20'000, [](int, int tick) { return tick % 700; });
    bench.view.addChannel(bench.id(1));
    bench.view.fitAll();
    const QColor color = bench.view.colorOf(bench.id(1));
    const auto traces = [&](const QImage &image) { // the grid follows with the next picture
        QList<QList<int>> rows;
        const QRect plot = bench.view.plotRect(0);
        for (int x = plot.left(); x <= plot.right(); ++x)
            rows.append(rowsOf(image, x, color));
        return rows;
    };
    const auto all = traces(bench.picture());
    bench.view.setVisibleRange(3.0, 4.0);
    const auto between = traces(bench.view.grab().toImage().convertToFormat(QImage::Format_RGB32));
    QVERIFY(between != all);
    QVERIFY(between == traces(bench.picture()));
}

void TestScopeView::anEmptyScopeSaysWhatToDo()
{
    Bench bench({});
    QLabel *hint = bench.view.findChild<QLabel *>(QStringLiteral("scopeHint"));
    QVERIFY(hint->isVisibleTo(&bench.view) && hint->text().contains(QStringLiteral("Drag")));
    bench.picture();
    QVERIFY(bench.view.plotRect(0).contains(hint->geometry())); // no word is cut
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

void TestScopeView::theLegendShowsNoValueThatCountsNoMore()
{
    Bench bench({signal(1, "A")});
    bench.capture.appendPolled(2, "S2", "V", 0.5, 24.0);
    for (const int id : {1, 2})
        bench.view.addChannel(bench.id(catalog::RegisterId(id)));
    const auto legend = [&bench](const char *name) {
        bench.picture();
        support::TextCatcher texts(bench.view.shapesSize());
        bench.view.drawShapes(texts);
        return texts.caught().filter(QLatin1String(name) + QStringLiteral("  ")).value(0);
    };
    const auto beats = [&bench](int count, bool waits) {
        for (int i = 0; i < count; ++i) {
            bench.record(100, 5); // of the other one
            bench.view.beat(waits);
        }
    };
    beats(12, true);
    QVERIFY2(legend("S2").contains(QStringLiteral("24")), qPrintable(legend("S2")));
    beats(1, true);
    QVERIFY2(legend("S2").contains(QChar(0x2013)) && !legend("S2").contains(QStringLiteral("24")),
        qPrintable(legend("S2")));
    QVERIFY2(legend("S1").contains(QLatin1Char('5')), qPrintable(legend("S1")));
    bench.capture.appendPolled(2, "S2", "V", 1.6, 25.0); // at once, not with the next beat
    QVERIFY2(legend("S2").contains(QStringLiteral("25")), qPrintable(legend("S2")));
    beats(13, true);
    beats(20, false); // a file has no newer ones to come
    QVERIFY2(legend("S2").contains(QStringLiteral("25")), qPrintable(legend("S2")));
    beats(1, true); // a port was opened again
    QVERIFY2(legend("S2").contains(QChar(0x2013)), qPrintable(legend("S2")));
}

void TestScopeView::theLegendCoversNoTrace()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "A")});
    for (const int id : {1, 2, 3})
        bench.view.addChannel(bench.id(catalog::RegisterId(id)));
    bench.record(1000, [](int, int tick) { return tick % 2 ? 100 : -100; });
    bench.view.setVisibleRange(0.0, 1.0);
    bench.view.fitValues();
    bench.picture();
    const QImage all = bench.picture(); // the second has the room that the first asked for
    const QRect area = bench.view.plotRect(0);
    const auto inked = [&](int x, int y) {
        const QColor pixel = all.pixelColor(x, y);
        return pixel.value() < 200 || pixel.saturation() > 60;
    };
    const QPoint legend = plotOf(bench.view).mapTo(&bench.view, legendOf(bench.view, 0));
    QVERIFY(legend.y() < area.top());
    int written = 0; // the names stand above
    for (int x = area.left(); x < area.right(); ++x)
        written += inked(x, legend.y()) ? 1 : 0;
    QVERIFY(written > 10);
    // Its first tenth, where the legend was, has a trace in every column.
    const int top = area.top() + area.height() / 10;
    for (int x = area.left() + 5; x < area.left() + 200; ++x)
        QVERIFY2(inked(x, top), qPrintable(QString::number(x)));
}

void TestScopeView::labelsSayWhatADivisionIsWorth()
{
    const QLocale c = QLocale::c();
    QCOMPARE(perDivision(0.5, QStringLiteral("A"), c), QStringLiteral("0.5 A/div"));
    QCOMPARE(perDivision(200, QStringLiteral("rpm"), c), QStringLiteral("200 rpm/div"));
    QCOMPARE(perDivision(2, {}, c), QStringLiteral("2/div"));
    QCOMPARE(timePerDivision(0.01, c), QStringLiteral("10\u2009ms/div"));
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(100, 1);
    bench.view.setVisibleRange(0.0, 1.0);
    bench.picture();
    const double step = bench.view.time().step();
    QVERIFY(step >= 0.1 && step <= 0.5);
    bench.view.setVisibleRange(0.0, 0.001);
    bench.picture();
    QVERIFY(std::abs(bench.view.time().step() / step - 0.001) < 1e-9);
}

void TestScopeView::smallTicksAreRoundNumbersAndFew()
{
    const QVector<double> quarters = {0.5, 1.0, 1.5, 2.5, 3.0, 3.5};
    QCOMPARE(smallTicksIn(0.0, 4.0, 2.0), quarters);
    QCOMPARE(smallTicksIn(-0.5, 1.1, 1.0).size(), 6);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> power(-9.0, 9.0);
    std::uniform_real_distribution<double> place(-1e6, 1e6);
    for (int i = 0; i < 2000; ++i) {
        const double step = tickStep(std::pow(10.0, power(random)), 1 + i % 10);
        const double small = step / piecesOf(step);
        const double again = tickStep(small, 1); // leaves numbers of the form 1, 2 or 5 alone
        QVERIFY2(std::abs(again / small - 1.0) < 1e-6, qPrintable(QString::number(step)));
        const double from = step * place(random);
        QVERIFY(smallTicksIn(from, from + 10 * step, step).size() <= 50);
    }
    QVERIFY(smallTicksIn(0.0, 1e300, 1e-300).size() <= 1000);

    AxisTicker ticker(AxisTicker::Labels::Values);
    const auto count = [&ticker](const QCPRange &range) {
        QVector<double> ticks;
        QVector<double> small;
        ticker.generate(range, QLocale::c(), QLatin1Char('g'), 6, ticks, &small, nullptr);
        return small.size();
    };
    ticker.setMost(10, 400);
    QCOMPARE(count({0.0, 10.0}), 40);
    ticker.setMost(10, 199); // they would be closer than 4 pixels
    QCOMPARE(count({0.0, 10.0}), 0);
    ticker.setMost(10, 400);
    QCOMPARE(count({0.0, std::numeric_limits<double>::infinity()}), 0);
}

/// Two say nothing of the scale; which ones they were depended on the height.
void TestScopeView::anAxisOfValuesHasThreeNumbersWhereTheyHaveRoom()
{
    // The newest value stands beside the axis and is no round one.
    static const QRegularExpression number(QStringLiteral("^(0|[-\u2212]?[0-9]+00)$"));
    constexpr int kRoom = 104; // pixels: also of the numbers of the next finer step
    for (const int top : {1730, 1930, 2130, 2630, 3130, 3930, 4130}) {
        Bench bench({signal(1, "rpm")});
        bench.view.addChannel(bench.id(1));
        bench.record(2000, [top](int, int tick) { return tick * top / 2000; });
        for (int height = 120; height <= 400; height += 20) {
            bench.view.resize(800, height);
            bench.picture();
            if (bench.view.plotRect(0).height() < kRoom)
                continue;
            support::TextCatcher texts(bench.view.shapesSize());
            bench.view.drawShapes(texts);
            const auto numbers = texts.caught().filter(number);
            QVERIFY2(numbers.size() >= 3,
                qPrintable(
                    QStringLiteral("%1 px, to %2: ")
                        .arg(QString::number(bench.view.plotRect(0).height()), QString::number(top))
                    + numbers.join(QLatin1Char(' '))));
        }
    }
}

void TestScopeView::smallTicksStandBetweenTheLinesOfTheGrid_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

/// Along the axes, in the picture and in what is exported as shapes: longer ticks with the grid, short ones between.
void TestScopeView::smallTicksStandBetweenTheLinesOfTheGrid()
{
    QFETCH(bool, dark);
    Bench bench({signal(1, "A")});
    if (dark) {
        QPalette colors;
        colors.setColor(QPalette::Base, Qt::black);
        colors.setColor(QPalette::Text, Qt::white);
        bench.view.setPalette(colors);
    }
    bench.view.addChannel(bench.id(1));
    bench.record(2000, 0);
    bench.view.setVisibleRange(0.0, 1.0);
    bench.picture();
    const QImage screen = bench.picture();
    QImage shapes(bench.view.shapesSize(), QImage::Format_RGB32);
    shapes.fill(dark ? Qt::black : Qt::white);
    bench.view.drawShapes(shapes);
    const QRect area = bench.view.plotRect(0);
    const int lines = qRound(1.0 / bench.view.time().step());
    const int pieces = piecesOf(bench.view.time().step());
    for (const bool exported : {false, true}) {
        const QImage &image = exported ? shapes : screen;
        const auto marks = [&](int up) {
            int found = 0;
            for (int x = area.left() + 8; x < area.right() - 8; ++x) {
                const int lightness = image.pixelColor(x, area.bottom() - up).lightness();
                found += dark ? lightness > 90 : lightness < 165; // the grid is fainter
            }
            return found;
        };
        QCOMPARE(marks(4), lines - 1);
        QCOMPARE(marks(2), lines * pieces - 1);
        QCOMPARE(marks(7), 0);
    }
}

void TestScopeView::signalsOfOneUnitShareAnAxisAndOthersGetTheirOwn()
{
    Bench bench({signal(1, "A"), signal(2, "A"), signal(3, "rpm")});
    for (const catalog::RegisterId reg : {1U, 2U, 3U})
        bench.view.addChannel(bench.id(reg));
    QCOMPARE(bench.view.plotCount(), 1);
    QCOMPARE(bench.axisCount(0), 2);
    bench.record(1000, [](int s, int) { return s == 2 ? 1500 : s; });
    bench.picture();
    QVERIFY(bench.view.valueRangeOf(bench.id(1)).to < 10);
    QVERIFY(bench.view.valueRangeOf(bench.id(3)).to > 1500);
    bench.view.removeChannel(bench.id(3));
    QCOMPARE(bench.axisCount(0), 1);
    bench.picture();
}

/// Where that takes little room by themselves, else when the user wants it.
void TestScopeView::theZerosOfTheAxesStandAtOneHeight()
{
    Bench bench({signal(1, "A"), signal(2, "V"), signal(3, "rpm")});
    for (const catalog::RegisterId id : {1, 2})
        bench.view.addChannel(bench.id(id));
    bench.record(2000, [](int signal, int tick) {
        return signal == 0 ? (tick % 2 ? 1000 : -1000) // of the middle
            : signal == 1  ? (tick % 2 ? 1000 : -700)
                           : (tick % 2 ? 2000 : 1900);
    });
    bench.view.fitAll();
    const auto below = [&](catalog::RegisterId id) {
        const auto range = bench.view.valueRangeOf(bench.id(id));
        return -range.from / (range.to - range.from);
    };
    QVERIFY(std::abs(below(1) - below(2)) < 1e-6);
    for (const auto &[id, least, most] :
        {std::tuple(1U, -1000.0, 1000.0), std::tuple(2U, -700.0, 1000.0)}) {
        const auto range = bench.view.valueRangeOf(bench.id(id));
        QVERIFY(range.from < least && range.to > most); // all of it is still seen
        QVERIFY(range.to - range.from < 1.5 * (most - least));
    }
    bench.view.addChannel(bench.id(3));
    bench.view.fitAll();
    QVERIFY(bench.view.valueRangeOf(bench.id(3)).from > 1000); // its zero is far away
    const double alone = below(1);
    const QPoint inside = bench.view.plotRect(0).center();
    auto *plot = bench.view.findChild<QWidget *>(QStringLiteral("scopePlot"));
    const QPoint place = plot->mapFrom(&bench.view, inside);
    const auto choose = [&] {
        QTest::mouseClick(plot, Qt::RightButton, {}, place);
        auto *menu = bench.view.findChild<QMenu *>(QStringLiteral("scopeMenu"));
        for (QAction *action : menu->actions())
            if (action->text().startsWith(QStringLiteral("Zeros")))
                action->trigger();
        menu->close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    };
    choose();
    QVERIFY(std::abs(below(1) - below(3)) < 1e-6);
    QVERIFY(std::abs(below(2) - below(3)) < 1e-6);
    choose(); // and off again
    QVERIFY(bench.view.valueRangeOf(bench.id(3)).from > 1000);
    QVERIFY(std::abs(below(1) - alone) < 1e-6);
}

void TestScopeView::theFirstAxisTakesTheUnitThatIsLeft()
{
    Bench bench({signal(1, "A"), signal(2, "rpm"), signal(3, "V")});
    bench.view.addChannel(bench.id(1));
    bench.view.addChannel(bench.id(2));
    bench.record(1000, [](int s, int) { return s == 1 ? 1500 : 0; });
    bench.picture();
    const auto before = bench.view.valueRangeOf(bench.id(2));
    bench.view.removeChannel(bench.id(1));
    QCOMPARE(bench.axisCount(0), 1);
    QCOMPARE(bench.view.valueRangeOf(bench.id(2)).from, before.from);
    QCOMPARE(bench.view.valueRangeOf(bench.id(2)).to, before.to);
    bench.view.addChannel(bench.id(3));
    QCOMPARE(bench.axisCount(0), 2);
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
    QCOMPARE(bench.axisCount(0), 4);
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

/// The upper plot is the lowest now and shows the times again, of which it has none before it is laid out.
void TestScopeView::aPaintBeforeTheNextFrameHasItsNumbers()
{
    Bench bench({signal(1, "A"), signal(2, "V")});
    bench.view.addChannel(bench.id(1), 0);
    bench.view.addChannel(bench.id(2), 1);
    bench.record(1000, 1);
    bench.picture();
    bench.view.removeChannel(bench.id(2));
    QVERIFY(!bench.view.grab().isNull());
    const auto *plot = bench.view.findChild<QCustomPlot *>();
    const QCPAxis *time = plot->axisRect(0)->axis(QCPAxis::atBottom);
    QVERIFY(time->tickLabels());
    QVERIFY(!time->tickVector().empty());
    QCOMPARE(time->tickVectorLabels().size(), time->tickVector().size());
}

void TestScopeView::followingKeepsTheNewestSampleAtTheRightEdge()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    QVERIFY(bench.view.time().following());
    bench.record(20'000, 1);
    bench.picture();
    QCOMPARE(bench.view.visibleRange().to, 19.999);
    const double span = bench.view.visibleRange().to - bench.view.visibleRange().from;
    bench.record(500, 1);
    QTRY_COMPARE(bench.view.visibleRange().to, 20.499);
    QVERIFY(std::abs(bench.view.visibleRange().to - bench.view.visibleRange().from - span) < 1e-9);
    bench.view.time().zoom(2.0);
    QCOMPARE(bench.view.visibleRange().to, 20.499);
    QVERIFY(bench.view.time().following());
}

void TestScopeView::aYoungSessionBeginsAtZeroSeconds()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(1000, 1);
    bench.picture();
    QCOMPARE(bench.view.visibleRange().from, 0.0);
    QVERIFY(bench.view.visibleRange().to > 1.0);
    bench.view.time().zoom(100.0);
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
    Bench raw({signal(1, "s16A")}); // a board that tells no scale
    raw.view.addChannel(raw.id(1));
    raw.record(8000, [](int, int tick) { return tick % 8 - 4; });
    raw.picture();
    QVERIFY(raw.view.valueRangeOf(raw.id(1)).to > 50.0);
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

void TestScopeView::ofEarlierTracesTheNewerOneIsOnTop()
{
    Bench bench({signal(1, "A")});
    bench.view.addChannel(bench.id(1));
    bench.record(300, [](int, int tick) { return tick < 200 ? 50 : -50; });
    bench.view.fitAll();
    bench.view.setVisibleRange(0.2, 0.3);
    // Both where nothing else is.
    bench.view.ghosts().setRecords({{nullptr, -0.1, 120}, {nullptr, -0.2, 40}});
    const QImage image = bench.picture();
    QColor newer = bench.view.colorOf(bench.id(1));
    newer.setAlpha(120);
    QImage ground(1, 1, QImage::Format_RGB32);
    ground.fill(Qt::white);
    QPainter(&ground).fillRect(ground.rect(), newer);
    const QRect area = bench.view.plotRect(0);
    int found = 0;
    for (int y = area.top(); y < area.center().y(); ++y) {
        const QColor pixel = image.pixelColor(area.left() + 303, y);
        const QColor wanted = ground.pixelColor(0, 0);
        found +=
            std::abs(pixel.red() - wanted.red()) + std::abs(pixel.green() - wanted.green()) < 6;
    }
    QCOMPARE(found, 1);
}

/// What is kept of the picture of earlier records is what painting all of them anew would give.
void TestScopeView::recordsThatCameOneByOneLookLikeAllAtOnce()
{
    const auto value = [](int s, int tick) {
        const int wave = std::abs(tick % 100 - 50) * (s == 0 ? 10 : -7); // every view has its ends
        return wave + (tick / 1000 % 3) * (tick % 100 == 20 ? 100 : 0);
    };
    const auto made = [&value](Bench &bench) {
        bench.record(20'000, value);
        bench.view.addChannel(bench.id(1));
        bench.view.addChannel(bench.id(2));
        bench.view.setRunning(false);
        bench.view.fitAll();
    };
    Bench kept({signal(1, "A"), signal(2, "V")});
    made(kept);
    std::mt19937 random(3);
    std::vector<Ghost> records;
    // No sample where a column begins: sums of seconds would put it here or there.
    constexpr double kOff = 0.000371;
    double from = 8.0 + kOff;
    double span = 0.5;
    for (int step = 0; step < 60; ++step) {
        switch (random() % 8) {
        case 0: // another time is looked at
            from = 6.0 + kOff + double(random() % 4000) / 1000.0;
            break;
        case 1: // and another scale of it: dense, or single samples
            span = random() % 2 == 0 ? 0.5 : 3.0;
            break;
        case 2:
            records.clear();
            break;
        default: { // the next record: the others are older by it
            const double by = 0.1 + double(random() % 300) / 1000.0 + kOff / 3;
            from = std::min(from + by, 16.0);
            for (Ghost &ghost : records)
                ghost.shift -= by;
            records.insert(records.begin(), Ghost{nullptr, -by, 0});
            records.resize(std::min<std::size_t>(records.size(), 4));
        }
        }
        for (std::size_t i = 0; i < records.size(); ++i)
            records[i].alpha = 120 - 20 * int(i);
        kept.view.setVisibleRange(from, from + span);
        kept.view.ghosts().setRecords(records);
        Bench fresh({signal(1, "A"), signal(2, "V")});
        made(fresh);
        fresh.view.setVisibleRange(from, from + span);
        fresh.view.ghosts().setRecords(records);
        const QImage wanted = fresh.picture();
        const QImage found = kept.picture();
        if (records.empty())
            continue; // a picture without them stands on the columns of the one before
        int others = 0;
        for (int y = 0; y < wanted.height(); ++y)
            for (int x = 0; x < wanted.width(); ++x)
                others += wanted.pixel(x, y) != found.pixel(x, y) ? 1 : 0;
        QVERIFY2(
            others == 0, qPrintable(QStringLiteral("%1 pixels in step %2").arg(others).arg(step)));
    }
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

void TestScopeView::moreTracesThanColoursShareThemEvenly()
{
    std::vector<capture::StreamSignal> many;
    for (catalog::RegisterId reg = 1; reg <= 16; ++reg)
        many.push_back(signal(reg, "V"));
    Bench bench(many);
    bench.record(10, 1);
    QMap<QRgb, int> uses;
    for (catalog::RegisterId reg = 1; reg <= 16; ++reg) {
        bench.view.addChannel(bench.id(reg));
        ++uses[bench.view.colorOf(bench.id(reg)).rgb()];
    }
    QCOMPARE(uses.size(), 8);
    for (const int count : uses)
        QCOMPARE(count, 2);
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
    bench.view.time().zoom(0.0);
    bench.view.time().zoom(std::nan(""));
    QCOMPARE(bench.view.visibleRange().from, 0.0);
    QCOMPARE(bench.view.visibleRange().to, 1.0);
    for (int i = 0; i < 200; ++i)
        bench.view.time().zoom(2.0);
    bench.picture();
    QVERIFY(bench.view.visibleRange().to > bench.view.visibleRange().from);
    for (int i = 0; i < 200; ++i)
        bench.view.time().zoom(0.5);
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
