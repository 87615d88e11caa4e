// The scope as a person sees and drives it: pixels of the grabbed widget, keys, mouse, drops.
#include "capture/capture.h"
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

QTEST_MAIN(TestScopeView)
#include "tst_scope_view.moc"
