// The motion log as a table: what was asked of the motors and how it ended. It can be copied and saved, never changed.
// A tool like the forms, without edits.
#pragma once

#include "widgets/base/form.h"

class QLabel;
class QTableView;

namespace widgets {

class FilePrompt;
class MotionLogModel;

class MotionLogPanel : public Form {
    Q_OBJECT
public:
    /// Both outlive it.
    MotionLogPanel(MotionLogModel &log, FilePrompt &files, QWidget *parent = nullptr);

    double heightShare() const override { return 0.3; } // the traces are what is looked at

public Q_SLOTS:
    void copy(); ///< the selected rows, or all, into the clipboard
    void save(); ///< asks for a file

Q_SIGNALS:
    void saved(const QString &path);

private:
    void follow();

    MotionLogModel &m_log;
    FilePrompt &m_files;
    QTableView *m_table;
    QLabel *m_leftOut;
    QWidget *m_copy;
    QWidget *m_save;
};

} // namespace widgets
