// The tools of the main window that read the scope: placed here, connected to it, theirs to decide.
#include "widgets/files/record_panel.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/measuring/math_panel.h"
#include "widgets/measuring/math_traces.h"
#include "widgets/measuring/measure_panel.h"
#include "widgets/measuring/spectrum_panel.h"
#include "widgets/measuring/xy_panel.h"
#include "widgets/scope/events/event_panel.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope/signals/channel_strip.h"
#include "widgets/scope/trigger/trigger_control.h"
#include "widgets/window/main_window.h"

namespace widgets {

void MainWindow::makeScopeTools()
{
    const auto motor = [this] {
        return m_workbench.signalPlan().showsFile() ? 0 : m_device.motor();
    };
    QAction *open = addTool(tr("Events"), "eventDock", Qt::CTRL | Qt::Key_7,
        [this] { return m_events = new EventPanel(*m_scope, this); });
    connect(m_scope, &ScopeView::noteWanted, this, [this, open](quint32 marker) {
        open->trigger();
        m_events->editNote(marker);
    });
    addTool(tr("Records"), "recordDock", Qt::CTRL | Qt::Key_8,
        [this] { return new RecordPanel(*m_trigger, *m_scope, this); });
    addTool(tr("Measurements"), "measureDock", Qt::CTRL | Qt::Key_9,
        [this] { return new MeasurePanel(*m_scope, m_workbench.capture(), *m_trigger, this); });
    addTool(tr("Spectrum"), "spectrumDock", Qt::CTRL | Qt::Key_0, [this, motor] {
        return new SpectrumPanel(*m_scope, m_workbench.capture(), m_device, motor, this);
    });
    m_scope->setChosenColors(m_settings.traceColors); // before anything is drawn
    new MathTraces(m_math, m_workbench.capture(), *m_scope, this);
    m_math.setFormulas(m_settings.formulas);
    QAction *openMath =
        addTool(tr("Math"), "mathDock", Qt::CTRL | Qt::SHIFT | Qt::Key_M, [this, motor] {
            return new MathPanel(m_math, *m_scope, m_workbench.capture(), motor, this);
        });
    showComputedChips(openMath);
    addTool(tr("XY"), "xyDock", Qt::CTRL | Qt::SHIFT | Qt::Key_X, [this, motor] {
        return new XyPanel(*m_scope, m_workbench.capture(), m_workbench.registers(), motor, this);
    });
}

void MainWindow::showComputedChips(QAction *openMath)
{
    auto *strip = findChild<ChannelStrip *>();
    const auto showComputed = [this, strip] {
        QList<ChannelStrip::Computed> computed;
        for (const MathChannels::Entry &entry : m_math.entries()) {
            const QColor color = MathTraces::colorOf(*m_scope, entry.channel);
            if (color.isValid())
                computed.append({entry.formula.name, entry.formula.text, color,
                    [this, name = entry.formula.name](QMenu &menu) {
                        for (const MathChannels::Entry &now : m_math.entries())
                            if (now.formula.name == name)
                                m_scope->fillColors(menu, now.channel);
                    }});
        }
        strip->setComputed(computed);
    };
    connect(&m_math, &MathChannels::changed, strip, showComputed);
    connect(m_scope, &ScopeView::channelsChanged, strip, showComputed);
    connect(strip, &ChannelStrip::computedRemoved, &m_math,
        [this](const QString &name) { m_math.setShown(name, false); });
    connect(strip, &ChannelStrip::computedChosen, this, [this, openMath](const QString &name) {
        openMath->trigger();
        findChild<MathPanel *>()->choose(name);
    });
    showComputed(); // those that were kept came before
}

} // namespace widgets
