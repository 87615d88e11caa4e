// The tools of the main window that read the scope: placed here, connected to it, theirs to decide.
#include "widgets/analysis/math_channels.h"
#include "widgets/analysis/math_panel.h"
#include "widgets/analysis/measure_panel.h"
#include "widgets/analysis/spectrum_panel.h"
#include "widgets/analysis/xy_panel.h"
#include "widgets/files/event_recorder.h"
#include "widgets/files/record_panel.h"
#include "widgets/files/replaying.h"
#include "widgets/scope/channel_strip.h"
#include "widgets/scope/event_panel.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope/trigger_control.h"
#include "widgets/window/main_window.h"

namespace widgets {

void MainWindow::makeScopeTools()
{
    const auto motor = [this] { return m_selection->showsFile() ? 0 : m_device.motor(); };
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
    m_math->setPolled([this] { return m_selection->plan().polled; });
    m_math->setFormulas(m_settings.formulas);
    QAction *openMath =
        addTool(tr("Math"), "mathDock", Qt::CTRL | Qt::SHIFT | Qt::Key_M, [this, motor] {
            return new MathPanel(*m_math, *m_scope, m_workbench.capture(), motor, this);
        });
    showComputedChips(openMath);
    addTool(tr("XY"), "xyDock", Qt::CTRL | Qt::SHIFT | Qt::Key_X, [this, motor] {
        return new XyPanel(*m_scope, m_workbench.capture(), m_workbench.registers(), motor, this);
    });
    const auto tellTrigger = [this] {
        const bool replay = replaying(m_device) && m_device.portOpen();
        m_trigger->setAwaitsSamples(!m_selection->showsFile() || replay);
    };
    connect(m_selection, &SignalSelection::changed, m_trigger, tellTrigger);
    connect(&m_device, &Device::portStateChanged, m_trigger, tellTrigger);
    using Kind = scope::EventTrigger::Kind;
    connect(m_recorder, &EventRecorder::stateChanged, m_trigger,
        [this](double seconds, EventKind kind, quint32 which) {
            m_trigger->event(
                kind == EventKind::Fault ? Kind::Fault : Kind::StateChange, seconds, which);
        });
    connect(m_recorder, &EventRecorder::written, m_trigger,
        [this](double seconds, quint32 id) { m_trigger->event(Kind::RegisterWrite, seconds, id); });
}

void MainWindow::showComputedChips(QAction *openMath)
{
    auto *strip = findChild<ChannelStrip *>();
    const auto showComputed = [this, strip] {
        QList<ChannelStrip::Computed> computed;
        for (const MathChannels::Entry &entry : m_math->entries()) {
            const QColor color = m_math->colorOf(entry.formula.name);
            if (color.isValid())
                computed.append({entry.formula.name, entry.formula.text, color,
                    [this, name = entry.formula.name](QMenu &menu) {
                        for (const MathChannels::Entry &now : m_math->entries())
                            if (now.formula.name == name)
                                m_scope->fillColors(menu, now.channel);
                    }});
        }
        strip->setComputed(computed);
    };
    connect(m_math, &MathChannels::changed, strip, showComputed);
    connect(m_scope, &ScopeView::channelsChanged, strip, showComputed);
    connect(strip, &ChannelStrip::computedRemoved, m_math,
        [this](const QString &name) { m_math->setShown(name, false); });
    connect(strip, &ChannelStrip::computedChosen, this, [this, openMath](const QString &name) {
        openMath->trigger();
        findChild<MathPanel *>()->choose(name);
    });
    showComputed(); // those that were kept came before
}

} // namespace widgets
