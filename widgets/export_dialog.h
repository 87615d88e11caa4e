// ExportDialog: what of the recording goes into a CSV file, and how. The file is written in a thread of its own and
// appears whole or not at all; the dialog shows how far it is and can cancel.
#pragma once

#include "capture/capture.h"
#include "session/csv_file.h"

#include <QDialog>

#include <functional>
#include <memory>

class QComboBox;
class QLabel;
class QProgressBar;
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

    bool running() const;

Q_SIGNALS:
    void exported(const QString &path);
    void failed(const QString &sentence);

protected:
    void reject() override; ///< cancels a running export first

private:
    struct Part {
        QString path;
        capture::Snapshot channels;
    };

    void ask();
    void begin(const QString &path);
    void nextPart();
    void partFinished(const session::CsvResult &result);
    void updateSummary();
    bool visibleOnly() const;
    bool ratesApart() const;
    capture::Snapshot snapshot() const;

    capture::Capture &m_capture;
    ScopeView &m_scope;
    FilePrompt &m_files;
    QString m_folder;
    QComboBox *m_range;
    QComboBox *m_rates;
    QLabel *m_summary;
    QProgressBar *m_progress;
    QPushButton *m_save;
    QPushButton *m_cancel;
    QList<Part> m_parts;
    qsizetype m_done = 0;
    capture::CsvOptions m_options;
    std::unique_ptr<session::CsvExport> m_export;
    quint64 m_rows = 0;
};

/// "2026-05-04_13-02-59_motor_capture.csv"
QString suggestedCaptureName(const QDateTime &now);

} // namespace widgets
