// The scope on a screen whose scale is no whole number: each pixel of the screen is painted once, and none is made of
// its neighbours. What a screen is like is decided when a program begins, so the test runs itself once more for each
// scale.
#include "support/scope_bench.h"

#include <QProcess>

using namespace facts;

class TestScopeScale : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyPixelIsPaintedOnce();
    void theSameOnScreensOfOtherScales_data();
    void theSameOnScreensOfOtherScales();

private:
    void columnsAreThoseOfTheScreen(const QImage &image, const QRect &plot, const QColor &trace);
    void itsEdgesArePainted(const QImage &image, const QRect &plot, const QColor &trace);
    void theCanvasIsFilled(QWidget &canvas);
};

namespace {

constexpr const char *kScale = "QT_SCALE_FACTOR";
constexpr int kLabels = 80; ///< pixels at the right edge
constexpr QRgb kGap = 0xFFEDEDED; ///< the shade of a gap on white

/// As Qt rounds edges that are painted.
QRect onScreen(const QRect &rect, double ratio)
{
    const QPoint first(qRound(rect.left() * ratio), qRound(rect.top() * ratio));
    const QPoint end(qRound((rect.right() + 1) * ratio), qRound((rect.bottom() + 1) * ratio));
    return {first, end - QPoint(1, 1)};
}

std::vector<int> inkOf(const QImage &image, const QRect &plot, int x, const QColor &color)
{
    std::vector<int> rows;
    for (int y = plot.top(); y <= plot.bottom(); ++y)
        if (image.pixel(x, y) == color.rgb())
            rows.push_back(y);
    return rows;
}

} // namespace

/// Steep ramps with a gap between: next to one another no two columns are alike, and the shade of the gap reaches from
/// the upper edge to the lower one.
void TestScopeScale::everyPixelIsPaintedOnce()
{
    constexpr int kSamples = 10'000, kRamp = 700, kSizes = 8;
    Bench bench({signal(1, "A")});
    const auto ramps = [](int, int tick) { return tick % kRamp; };
    bench.record(kSamples, ramps);
    bench.tick += std::int64_t{2} * kRamp;
    bench.record(kSamples, ramps);
    bench.view.addChannel(bench.id(1));
    for (int more = 0; more < kSizes && !QTest::currentTestFailed(); ++more) {
        bench.view.resize(790 + more, 390 + more);
        bench.view.fitAll();
        const QImage image = bench.picture();
        QCOMPARE(image.devicePixelRatio(), std::max(1.0, qEnvironmentVariable(kScale).toDouble()));
        const QRect plot = onScreen(bench.view.plotRect(0), image.devicePixelRatio());
        const QColor trace = bench.view.colorOf(bench.id(1));
        columnsAreThoseOfTheScreen(image, plot, trace);
        if (!QTest::currentTestFailed())
            itsEdgesArePainted(image, plot, trace);
        if (!QTest::currentTestFailed())
            theCanvasIsFilled(plotOf(bench.view));
    }
}

/// An image that was drawn larger has columns twice, one that was drawn smaller has holes between them.
void TestScopeScale::columnsAreThoseOfTheScreen(
    const QImage &image, const QRect &plot, const QColor &trace)
{
    int compared = 0;
    std::vector<int> last;
    const int labels = int(kLabels * image.devicePixelRatio()); // numbers over the traces
    for (int x = plot.left(); x <= plot.right() - labels; ++x) {
        std::vector<int> now = inkOf(image, plot, x, trace);
        if (!now.empty() && !last.empty()) {
            ++compared;
            QVERIFY2(now != last, qPrintable(QString::number(x)));
            QVERIFY2(now.front() <= last.back() + 1 && last.front() <= now.back() + 1,
                qPrintable(QString::number(x)));
        }
        last = std::move(now);
    }
    QVERIFY(compared > plot.width() / 2);
}

void TestScopeScale::itsEdgesArePainted(const QImage &image, const QRect &plot, const QColor &trace)
{
    QVERIFY(!inkOf(image, plot, plot.left(), trace).empty());
    QVERIFY(!inkOf(image, plot, plot.right(), trace).empty());
    int gap = plot.left();
    while (gap <= plot.right() && image.pixel(gap, plot.top()) != kGap)
        ++gap;
    QVERIFY(gap <= plot.right()); // it reaches the upper edge
    const int last = int(std::ceil(image.devicePixelRatio())); // one of them is the axis
    for (int y = plot.bottom(); y > plot.bottom() - last; --y)
        QVERIFY2(image.pixelColor(gap + 1, y) != Qt::white, qPrintable(QString::number(y)));
}

void TestScopeScale::theCanvasIsFilled(QWidget &canvas)
{
    const QImage image = canvas.grab().toImage();
    QCOMPARE(image.size(), (QSizeF(canvas.size()) * image.devicePixelRatio()).toSize());
    const QColor ground = canvas.palette().color(QPalette::Base);
    QCOMPARE(image.pixelColor(image.width() - 1, image.height() - 1), ground);
    QCOMPARE(image.pixelColor(image.width() - 1, 0), ground);
    QCOMPARE(image.pixelColor(0, image.height() - 1), ground);
}

void TestScopeScale::theSameOnScreensOfOtherScales_data()
{
    QTest::addColumn<QString>("scale");
    for (const char *scale : {"1.25", "1.5", "1.75", "2"})
        QTest::newRow(scale) << QString::fromLatin1(scale);
}

void TestScopeScale::theSameOnScreensOfOtherScales()
{
    QFETCH(const QString, scale);
    QProcess self;
    QProcessEnvironment around = QProcessEnvironment::systemEnvironment();
    around.insert(QLatin1String(kScale), scale);
    around.insert(QStringLiteral("QT_SCALE_FACTOR_ROUNDING_POLICY"), QStringLiteral("PassThrough"));
    self.setProcessEnvironment(around);
    self.setProcessChannelMode(QProcess::MergedChannels);
    self.start(QCoreApplication::applicationFilePath(),
        {QStringLiteral("tst_scope_scale"), QStringLiteral("everyPixelIsPaintedOnce")});
    QVERIFY(self.waitForFinished());
    QVERIFY2(self.exitStatus() == QProcess::NormalExit && self.exitCode() == 0,
        self.readAll().constData());
}

QTEST_MAIN(TestScopeScale)
#include "tst_scope_scale.moc"
