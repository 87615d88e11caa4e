// The real window on a board that streams two currents: the board's words are fed by hand, samples come when a test
// records them, at 1 kHz from the session's zero on.
#pragma once

#include "support/window_rig.h"
#include "widgets/scope/view.h"

#include <functional>

namespace facts {

struct ScopeWindow : WindowRig {
    capture::Tick tick = 0;

    explicit ScopeWindow(const widgets::Settings &settings = quietSettings())
        : WindowRig(settings)
    {
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        connectBoard(device());
        stream();
    }
    ~ScopeWindow() { device().portChanged(session::PortState::Closed, {}); }
    ScopeWindow(const ScopeWindow &) = delete;
    ScopeWindow &operator=(const ScopeWindow &) = delete;

    widgets::Device &device() { return workbench.device(); }
    widgets::ScopeView &scope() { return *window.scope(); }
    QWidget &plot() { return *find<QWidget>("scopePlot"); }

    /// One digit is 1 A of I_A and 2 A of I_B.
    void stream() { feed(device(), {drive::StreamStarted{layout()}}); }
    static capture::StreamLayout layout()
    {
        return {1, 1000.0, 0.0, 1,
            {{kCurrentA, "I_A", "A", 1.0, 0.0}, {kCurrentB, "I_B", "A", 2.0, 0.0}}, {}};
    }
    capture::ChannelId id(catalog::RegisterId reg) { return *workbench.capture().find(reg); }

    /// `value(signal, tick)` for each of the two signals.
    void record(int count, const std::function<int(int, int)> &value)
    {
        capture::SampleBlock block{1, tick, static_cast<std::uint32_t>(count), {}, {}, 0};
        for (int signal = 0; signal < 2; ++signal) {
            for (int i = 0; i < count; ++i)
                block.fast.push_back(
                    static_cast<std::int16_t>(value(signal, static_cast<int>(tick) + i)));
        }
        tick += count;
        feed(device(), {block});
    }
    void lose(int ticks) { tick += ticks; }

    /// Lets everything that is due be drawn.
    void draw()
    {
        const quint64 before = scope().redraws();
        scope().redraw();
        while (scope().redraws() == before)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }

    /// A point of the plot widget: at a time, and a share of the first plot's height from its top.
    QPoint at(double seconds, double share = 0.5)
    {
        const QRect area = scope().plotRect(0);
        const QPoint shift = plot().mapTo(&scope(), QPoint(0, 0));
        return QPoint(qRound(scope().time().xOf(seconds)), area.top() + int(share * area.height()))
            - QPoint(0, shift.y());
    }
    /// Moves the mouse with nothing or the left button pressed; events, so that no test waits.
    void moveMouse(const QPoint &to, Qt::MouseButtons held = Qt::NoButton)
    {
        QMouseEvent move(QEvent::MouseMove, to, plot().mapToGlobal(to), Qt::NoButton, held, {});
        QApplication::sendEvent(&plot(), &move);
    }
    void drag(const QPoint &from, const QPoint &to)
    {
        QTest::mousePress(&plot(), Qt::LeftButton, {}, from);
        moveMouse(to, Qt::LeftButton);
        QTest::mouseRelease(&plot(), Qt::LeftButton, {}, to);
    }
    void mouseLeaves()
    {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&plot(), &leave);
    }
};

} // namespace facts
