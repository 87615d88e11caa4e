// RunKeeper: puts every experiment that ends into the run book, with the registers as they are right behind it. It
// reads them, and it writes files in a thread of a pool; nothing waits for it. What is written while it reads, by the
// next experiment too, is put back in what is kept: it belongs to the next run. Closed before it is done, it keeps the
// run without registers. Without a folder it does nothing.
#pragma once

#include "session/files/run_book.h"
#include "widgets/lab/experiments.h"
#include "widgets/snapshots/reader.h"

#include <QPointer>

#include <map>
#include <memory>
#include <optional>

namespace widgets {

class RunKeeper : public QObject {
    Q_OBJECT
public:
    /// All outlive it. @param window  over which a long job shows itself
    RunKeeper(Device &device, Experiments &experiments, QWidget *window, QObject *parent = nullptr);
    ~RunKeeper() override;

    QString folder() const { return m_folder; }
    void setFolder(const QString &folder);

Q_SIGNALS:
    void folderChanged();
    void kept(const session::Run &run);
    void failed(const QString &sentence);

private:
    void ended(const Experiments::RunPtr &run);
    void noteWrites(const drive::Ended &ended);
    snapshots::Snapshot behindTheRun(const snapshots::Snapshot &read) const;
    void write(std::optional<snapshots::Snapshot> registers);

    Device &m_device;
    QPointer<QWidget> m_window;
    SnapshotReader m_reader;
    QString m_folder;
    std::shared_ptr<session::EndedRun> m_ended; ///< whose registers are being read
    /// What was written since then, as it was before.
    std::map<catalog::RegisterId, catalog::Value> m_before;
};

} // namespace widgets
