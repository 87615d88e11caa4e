// The tools of the main window that read the scope: placed here, connected to it, theirs to decide.
#include "widgets/event_panel.h"
#include "widgets/main_window.h"
#include "widgets/scope/scope_view.h"

namespace widgets {

void MainWindow::makeScopeTools()
{
    auto *events = new EventPanel(*m_scope, this);
    QAction *open = addTool(events, tr("Events"), "eventDock", Qt::CTRL | Qt::Key_7);
    connect(m_scope, &ScopeView::noteWanted, events, [events, open](quint32 marker) {
        open->trigger();
        events->editNote(marker);
    });
}

} // namespace widgets
