// SnapshotDialog: reads what a board holds and saves it: as a snapshot, or the tuned values of a motor as a C header.
// It shows how far it is and can be cancelled; the file appears whole or not at all.
#pragma once

#include "widgets/snapshots/reader.h"

#include <QDialog>

class QLabel;
class QProgressBar;
class QPushButton;

namespace widgets {

class FilePrompt;

class SnapshotDialog : public QDialog {
    Q_OBJECT
public:
    enum class Form : std::uint8_t {
        Snapshot, ///< every register that can be read, JSON
        Header, ///< what is tuned, for a firmware project; of the motor that the panels act on
    };

    /// All outlive the dialog.
    SnapshotDialog(
        Form form, Device &device, FilePrompt &files, const QString &folder, QWidget *parent);

Q_SIGNALS:
    void saved(const QString &path, int registers);

protected:
    void reject() override; ///< cancels reading first

private:
    void begin();
    void read(const BoardReading &reading);
    void ask();
    void save(const QString &path);
    void tell(const QString &sentence, bool bad);

    Form m_form;
    Device &m_device;
    FilePrompt &m_files;
    QString m_folder;
    int m_motor;
    SnapshotReader m_reader;
    snapshots::Snapshot m_snapshot;
    QByteArray m_content;
    QLabel *m_summary;
    QProgressBar *m_progress;
    QPushButton *m_save;
};

} // namespace widgets
