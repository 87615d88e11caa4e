// The tools of the main window that read the scope: placed here, connected to it, theirs to decide.
#include "widgets/analysis/math_channels.h"
#include "widgets/analysis/math_panel.h"
#include "widgets/analysis/measure_panel.h"
#include "widgets/analysis/spectrum_panel.h"
#include "widgets/analysis/xy_panel.h"
#include "widgets/files/event_recorder.h"
#include "widgets/files/record_panel.h"
#include "widgets/scope/event_panel.h"
#include "widgets/scope/scope_view.h"
#include "widgets/scope/trigger_control.h"
#include "widgets/window/main_window.h"

namespace widgets {

void MainWindow::makeScopeTools()
{
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
    addTool(tr("Spectrum"), "spectrumDock", Qt::CTRL | Qt::Key_0,
        [this] { return new SpectrumPanel(*m_scope, m_workbench.capture(), m_device, this); });
    m_math->setPolled([this] { return m_selection->plan().polled; });
    m_math->setFormulas(m_settings.formulas);
    addTool(tr("Math"), "mathDock", Qt::CTRL | Qt::SHIFT | Qt::Key_M,
        [this] { return new MathPanel(*m_math, *m_scope, m_workbench.capture(), this); });
    addTool(tr("XY"), "xyDock", Qt::CTRL | Qt::SHIFT | Qt::Key_X, [this] {
        return new XyPanel(*m_scope, m_workbench.capture(), m_workbench.registers(), this);
    });
    using Kind = scope::EventTrigger::Kind;
    connect(m_recorder, &EventRecorder::stateChanged, m_trigger,
        [this](double seconds, EventKind kind, quint32 which) {
            m_trigger->event(
                kind == EventKind::Fault ? Kind::Fault : Kind::StateChange, seconds, which);
        });
    connect(m_recorder, &EventRecorder::written, m_trigger,
        [this](double seconds, quint32 id) { m_trigger->event(Kind::RegisterWrite, seconds, id); });
}

} // namespace widgets
