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
    auto *events = new EventPanel(*m_scope, this);
    QAction *open = addTool(events, tr("Events"), "eventDock", Qt::CTRL | Qt::Key_7);
    connect(m_scope, &ScopeView::noteWanted, events, [events, open](quint32 marker) {
        open->trigger();
        events->editNote(marker);
    });
    addTool(new RecordPanel(*m_trigger, *m_scope, this), tr("Records"), "recordDock",
        Qt::CTRL | Qt::Key_8);
    addTool(new MeasurePanel(*m_scope, m_workbench.capture(), *m_trigger, this), tr("Measurements"),
        "measureDock", Qt::CTRL | Qt::Key_9);
    addTool(new SpectrumPanel(*m_scope, m_workbench.capture(), m_device, this), tr("Spectrum"),
        "spectrumDock", Qt::CTRL | Qt::Key_0);
    m_math->setPolled([this] { return m_selection->plan().polled; });
    m_math->setFormulas(m_settings.formulas);
    addTool(new MathPanel(*m_math, *m_scope, m_workbench.capture(), this), tr("Math"), "mathDock",
        Qt::CTRL | Qt::SHIFT | Qt::Key_M);
    addTool(new XyPanel(*m_scope, m_workbench.capture(), m_workbench.registers(), this), tr("XY"),
        "xyDock", Qt::CTRL | Qt::SHIFT | Qt::Key_X);
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
