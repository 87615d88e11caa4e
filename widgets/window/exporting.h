// Exporting: what of the scope goes into files. It asks what is wanted, has it written in a thread, tells what became
// of it, and asks before the window closes over a file that is not whole yet.
#pragma once

#include "widgets/base/banner.h"
#include "widgets/base/question.h"
#include "widgets/files/job.h"

#include <QPointer>

namespace widgets {

class FilePrompt;
class Replacing;
class ScopeView;
class Workbench;
struct ExportOrder;
struct ExportResult;

class Exporting : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    struct Parts {
        Workbench &workbench;
        ScopeView &scope;
        FilePrompt &files;
        Replacing &replacing; ///< is told what is in a file
        QuestionPrompt &prompt;
        QWidget *window; ///< dialogs are over it; tests do without
    };
    Exporting(const Parts &parts, const QString &folder, QObject *parent = nullptr);

    QString folder() const { return m_folder; } ///< of the last file
    void carryOut(const ExportOrder &order);
    void write(const QString &title, FileJob::Work work); ///< in a thread
    /// False: a file is being written. Then it has asked, and closeWanted() follows where the answer says so.
    bool mayClose();

public Q_SLOTS:
    void ask(); ///< Ctrl+Shift+E: what is on the screen now is what is meant
    void copyPicture();
    /// What is shown is the outline of a recording that is being read: its extremes are no samples to be exported.
    void setOutline(bool shown) { m_outline = shown; }

Q_SIGNALS:
    void said(widgets::Banner::Kind kind, const QString &sentence);
    void exported(); ///< a capture
    void closeWanted();

private:
    void ended(const ExportOrder &order, const ExportResult &result);
    void tellCapture(const QString &path, const QString &motionLog, const QString &wrong);
    FileJob *underWay() const;

    Parts m_parts;
    QString m_folder;
    QList<QPointer<FileJob>> m_jobs;
    bool m_outline = false;
    bool m_closeAfter = false; ///< the window waits for the file
};

} // namespace widgets
