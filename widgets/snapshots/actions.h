// SnapshotActions: what a window offers about snapshots: menu entries with their keys, and files that are dropped on
// it.
#pragma once

#include "widgets/snapshots/dialog.h"

#include <QAction>
#include <QObject>

#include <functional>

namespace widgets {

class SnapshotPanel;

class SnapshotActions : public QObject {
    Q_OBJECT
public:
    /// All outlive this. The panel knows the folder, and gets files that are dropped; it is asked for when it is
    /// needed.
    SnapshotActions(
        Device &device, FilePrompt &files, std::function<SnapshotPanel &()> panel, QWidget &window);

    QList<QAction *> actions() const { return {m_save, m_header}; }
    QAction *save() const { return m_save; }

Q_SIGNALS:
    void saved(const QString &sentence);
    void panelWanted(); ///< a file was dropped: show what is in it

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void open(SnapshotDialog::Form form);
    void update();

    Device &m_device;
    FilePrompt &m_files;
    std::function<SnapshotPanel &()> m_panel;
    QWidget &m_window;
    QAction *m_save;
    QAction *m_header;
};

} // namespace widgets
