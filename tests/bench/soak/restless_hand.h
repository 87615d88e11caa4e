// What the programs that run the real window for minutes share: a hand that never rests, and what the process holds.
#pragma once

#include "support/window_rig.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"

#include <QApplication>
#include <QFile>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace bench {

constexpr std::array kSoakSignals{"I_A", "I_B", "I_Q_MEAS", "I_D_MEAS", "STOPLL_EL_ANGLE"};

template <class Condition>
bool until(Condition condition)
{
    constexpr int kPatience_ms = 30'000;
    return QTest::qWaitFor(condition, kPatience_ms);
}

/// Zooms out to minutes and in to samples, drags to and fro; every act asks for a redraw.
class Hand : public QObject {
public:
    explicit Hand(facts::WindowRig &rig)
        : m_rig(rig)
        , m_plot(rig.find<QWidget>("scopePlot"))
    {
        connect(&m_timer, &QTimer::timeout, this, &Hand::act);
        m_timer.start(std::chrono::milliseconds(16)); // a frame
    }
    std::uint64_t acts() const { return m_acts; }

private:
    void act()
    {
        const QRect area = m_rig.window.scope()->plotRect(0);
        const QPoint middle = area.center();
        const auto step = static_cast<int>(m_acts++ % 240);
        if (step < 80) // in and out again
            turn(middle, step < 40 ? 120 : -120);
        else if (step == 80)
            mouse(QEvent::MouseButtonPress, middle, Qt::LeftButton);
        else if (step < 239)
            mouse(QEvent::MouseMove,
                middle + QPoint(int(0.4 * area.width() * std::sin(step / 10.0)), 0), Qt::NoButton);
        else
            mouse(QEvent::MouseButtonRelease, middle, Qt::LeftButton);
    }
    void turn(const QPoint &at, int angle)
    {
        QWheelEvent wheel(at, m_plot->mapToGlobal(at), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
            Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_plot, &wheel);
    }
    void mouse(QEvent::Type type, const QPoint &at, Qt::MouseButton button)
    {
        const Qt::MouseButtons held =
            type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, m_plot->mapToGlobal(at), button, held, Qt::NoModifier);
        QApplication::sendEvent(m_plot, &event);
    }

    facts::WindowRig &m_rig;
    QWidget *m_plot;
    QTimer m_timer;
    std::uint64_t m_acts = 0;
};

/// What the process holds, in MiB; nothing where the system does not tell it in this way.
inline std::optional<double> residentMiB()
{
    QFile file(QStringLiteral("/proc/self/status"));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    for (const QByteArray &line : file.readAll().split('\n')) {
        if (line.startsWith("VmRSS:"))
            return line.mid(6).simplified().split(' ').front().toDouble() / 1024.0;
    }
    return {};
}

/// Replaces what the scope shows at first by the five signals; whether all of them stream.
inline bool showSignals(facts::WindowRig &rig)
{
    const auto &catalog = *rig.workbench.device().catalog();
    std::vector<catalog::RegisterId> ids;
    for (const char *name : kSoakSignals)
        ids.push_back(catalog.resolve(name).value_or(0));
    for (const auto id : ids)
        rig.window.selection()->add(id, 0);
    for (const auto &info : rig.workbench.capture().channels()) {
        if (std::find(ids.begin(), ids.end(), info.registerId) == ids.end())
            rig.window.selection()->remove(info.registerId);
    }
    return until([&] { return rig.workbench.capture().streaming().size() == kSoakSignals.size(); });
}

} // namespace bench
