// ExportDialog: what of the recording goes into a file, in which format, and where. It makes the order; the one that
// opened the dialog carries it out, so that nothing is covered while files are written.
#pragma once

#include "widgets/files/export_order.h"

#include <QDialog>

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;

namespace widgets {

class FilePrompt;
class ScopeView;

class ExportDialog : public QDialog {
    Q_OBJECT
public:
    /// All outlive the dialog. What is recorded when the file name is given is what is exported.
    ExportDialog(capture::Capture &capture, ScopeView &scope, FilePrompt &files,
        const QString &folder, QWidget *parent = nullptr);

    /// @param hasLog  a motion log goes beside what is exported; asked when the file name is given
    void setMotionLog(std::function<bool()> hasLog) { m_hasLog = std::move(hasLog); }

Q_SIGNALS:
    void wanted(const widgets::ExportOrder &order); ///< the dialog closes behind it

private:
    enum Range { Visible, Cursors, Everything };

    void ask();
    void order(const QString &path);
    QStringList taken(const ExportOrder &order) const;
    void updateSummary();
    QString emptyText() const;
    const session::ExportFormat *format() const; ///< null: it is a picture
    const PictureFormat *picture() const;
    QString suffix() const;
    std::optional<capture::TimeSpan> range() const;
    capture::Snapshot snapshot() const;

    capture::Capture &m_capture;
    ScopeView &m_scope;
    FilePrompt &m_files;
    QString m_folder;
    std::function<bool()> m_hasLog;
    QComboBox *m_format;
    QComboBox *m_range;
    QComboBox *m_rates;
    QLabel *m_summary;
    QPushButton *m_save;
};

/// "2026-05-04_13-02-59_motor_capture.csv"
QString suggestedCaptureName(const QDateTime &now, const QString &suffix);

} // namespace widgets
