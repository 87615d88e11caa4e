// Snapshots in the main window: their tool, what the menu offers, files that are dropped.
#include "widgets/snapshots/snapshot_actions.h"
#include "widgets/snapshots/snapshot_panel.h"
#include "widgets/window/main_window.h"

namespace widgets {

void MainWindow::makeSnapshots()
{
    QAction *show = addTool(tr("Snapshots"), "snapshotsDock", Qt::CTRL | Qt::Key_5, [this] {
        m_snapshotPanel =
            new SnapshotPanel(m_device, m_workbench.edits(), m_workbench.snapshots(), m_files);
        m_snapshotPanel->setFolder(m_settings.snapshotFolder);
        m_snapshotPanel->offerRecorded(m_recordedSnapshots);
        return m_snapshotPanel;
    });
    const auto panel = [this]() -> SnapshotPanel & {
        finishTools();
        return *m_snapshotPanel;
    };
    m_snapshots = new SnapshotActions(m_device, m_files, panel, *this);
    connect(m_snapshots, &SnapshotActions::panelWanted, show, &QAction::trigger);
    connect(m_snapshots, &SnapshotActions::saved, this,
        [this](const QString &sentence) { say(Banner::Kind::Note, sentence); });
}

} // namespace widgets
