// A scope of 800 x 400 pixels on a capture whose signals a test makes up, and what can be found in its picture.
#pragma once

#include "capture/capture.h"
#include "widgets/base/register_texts.h"
#include "widgets/scope/view.h"

#include <qcustomplot.h>

#include <QtTest>
#include <QtWidgets>

#include <cmath>

namespace facts {

using capture::Capture;
using capture::ChannelId;
using widgets::ScopeView;

inline capture::StreamSignal signal(catalog::RegisterId id, const char *unit)
{
    return {id, "S" + std::to_string(id), unit, 1.0, 0.0};
}

inline capture::StreamLayout layoutOf(
    std::vector<capture::StreamSignal> fast, capture::StreamId id = 1)
{
    return {id, 1000.0, 0.0, 1, std::move(fast), {}};
}

/// A scope of 800 x 400 on a capture whose signals are at 1 kHz.
struct Bench {
    Capture capture;
    widgets::EventLog events;
    ScopeView view{capture, events};
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

    /// Value axes of a plot, as drawn; -1 if there is no such plot.
    int axisCount(int plot) const
    {
        const auto *canvas = view.findChild<QCustomPlot *>(QStringLiteral("scopePlot"));
        const QPoint middle = canvas->mapFrom(&view, view.plotRect(plot).center());
        const QCPAxisRect *rect = canvas->axisRectAt(middle);
        return rect ? rect->axisCount(QCPAxis::atLeft) + rect->axisCount(QCPAxis::atRight) : -1;
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
inline QList<int> rowsOf(const QImage &image, int x, const QColor &color)
{
    QList<int> rows;
    for (int y = 30; y < image.height() - 30; ++y) { // below the legend, above the time labels
        if (image.pixel(x, y) == color.rgb())
            rows.append(y);
    }
    return rows;
}

inline void sendDrop(QWidget &target, const QPoint &at, const QByteArray &json, bool *entered)
{
    QMimeData data;
    data.setData(QString::fromLatin1(widgets::kRegisterMimeType), json);
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.setAccepted(false);
    QApplication::sendEvent(&target, &enter);
    *entered = enter.isAccepted();
    if (!*entered)
        return;
    QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&target, &drop);
}

inline QWidget &plotOf(ScopeView &view)
{
    return *view.findChild<QWidget *>(QStringLiteral("scopePlot"));
}

/// Where a plot's traces are, in pixels of the plot widget, which gets the mouse.
inline QRect areaOf(ScopeView &view, int plot)
{
    const QRect area = view.plotRect(plot);
    return {plotOf(view).mapFrom(&view, area.topLeft()), area.size()};
}

/// Where the first entry of a plot's legend is, above its traces.
inline QPoint legendOf(ScopeView &view, int plot)
{
    return areaOf(view, plot).topLeft() + QPoint(20, -8);
}

} // namespace facts
