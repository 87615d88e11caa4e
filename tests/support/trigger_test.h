// What tests of the trigger share: a window on two currents, a signal to trigger on, and words for its settings.
#pragma once

#include "support/scope_window.h"
#include "widgets/scope/trigger/control.h"

#include <QLabel>
#include <QTest>

#include <cmath>

namespace facts {

class TriggerTest : public QObject {
protected:
    using TriggerControl = widgets::TriggerControl;
    using TriggerSetup = widgets::TriggerSetup;

    void open()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        square(2000);
        m_rig->draw();
        view().setFocus();
    }
    widgets::ScopeView &view() { return m_rig->scope(); }
    TriggerControl &control() { return *m_rig->window.findChild<TriggerControl *>(); }
    /// I_A: 10 A up, 10 A down, a turn of it in 100 ms; I_B: the tick.
    void square(int count)
    {
        m_rig->record(count, [](int signal, int tick) {
            return signal == 1 ? tick % 1000 : tick % 100 < 50 ? 10 : -10;
        });
    }
    void flat(int count)
    {
        m_rig->record(count, [](int, int) { return -10; });
    }
    void setup(const std::function<void(TriggerSetup &)> &edit)
    {
        TriggerSetup setup = control().trigger().setup();
        edit(setup);
        control().setSetup(setup);
    }
    void normal(double length = 0.05)
    {
        setup([length](TriggerSetup &setup) {
            setup.mode = scope::Mode::Normal;
            setup.level = 0.0;
            setup.hysteresis = 1.0;
            setup.length = length;
            setup.preTrigger = 0.2;
        });
    }
    QString stateWord() { return m_rig->find<QLabel>("triggerState")->text(); }
    double left() { return view().visibleRange().from; }
    double span() { return view().visibleRange().to - left(); }
    bool near(double one, double other) { return std::abs(one - other) < 1e-6; }

    std::unique_ptr<ScopeWindow> m_rig;
};

} // namespace facts
