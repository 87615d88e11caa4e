// SnapshotPanel: two snapshots beside each other, or one beside the board, as a table of what differs; and the way
// back: what is chosen of A is written to the board, read back and told register by register. It goes through
// RegisterEdits like any other edit, so that it needs arming, asks, and can be taken back.
#pragma once

#include "session/recording/reader.h"
#include "widgets/base/form.h"
#include "widgets/registers/edits.h"
#include "widgets/snapshots/auto.h"
#include "widgets/snapshots/model.h"

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace widgets {

class FilePrompt;

/// What an opened recording holds of registers, as text: most of it is never looked at.
struct RecordedSnapshots {
    QString path; ///< of the recording
    std::vector<session::RecordingReport::At<recorded::RegisterSnapshot>> all;
};

class SnapshotPanel : public Form {
    Q_OBJECT
public:
    /// All outlive the panel.
    SnapshotPanel(Device &device, RegisterEdits &edits, AutoSnapshots &automatic, FilePrompt &files,
        QWidget *parent = nullptr);

    void setFolder(const QString &folder) { m_folder = folder; } ///< where files are looked for
    void offerSave(QAction *save); ///< by a button, once; it outlives this
    QString folder() const { return m_folder; }

    /// Lists them among what can be compared, in place of those of another recording.
    void offerRecorded(RecordedSnapshots recorded);

    SnapshotModel *model() const { return m_model; }
    void focusFirst() override;
    QWidget *footer() const override { return m_footer; }

public Q_SLOTS:
    /// Loads a file as A and compares it with the board, or with what B is.
    void openFile(const QString &path);
    /// The one as A, the other as B; empty: the board as it is now.
    void compareFiles(const QString &a, const QString &b);
    void readBoard();
    void restore();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    enum class Kind : std::uint8_t { Board, File, Kept, Recorded };
    struct Source {
        Kind kind = Kind::Board;
        QString key, title;
        std::shared_ptr<const snapshots::Snapshot> snapshot; ///< empty: not read yet
    };
    struct Side {
        QComboBox *box = nullptr;
        QPushButton *open = nullptr;
        QString key; ///< of its source; empty: none
    };

    void makeWidgets();
    QWidget *makeSides();
    QWidget *makeFilters();
    void makeTable();
    QWidget *makeBottom();
    void makeSide(Side &side, const QString &name, const char *objectName);
    void listSources();
    void chooseSource(Side &side, int index);
    void askFile(Side &side);
    void sourcesChanged();
    bool load(const QString &path, Side &side);
    bool accept(Source &recorded);
    Source *source(const QString &key);
    std::shared_ptr<const snapshots::Snapshot> snapshotOf(const Side &side) const;
    bool isBoard(const Side &side) const;
    void boardRead(const BoardReading &reading);
    void boardChanged();
    void compare();
    void offer();
    void updateTexts();
    QString restoreHint() const; ///< why nothing can be restored; empty if it can
    std::vector<drive::RegisterWrite> chosen() const;
    QList<int> selectedRows() const; ///< of the model
    void copy();
    void toggleSelected();
    void showMenu(const QPoint &at);
    void restored(const WriteReport &report);
    void tell(const QString &sentence);

    Device &m_device;
    RegisterEdits &m_edits;
    AutoSnapshots &m_automatic;
    FilePrompt &m_files;
    SnapshotReader m_reader;
    SnapshotModel *m_model;
    QSortFilterProxyModel *m_proxy;
    QString m_folder;
    RecordedSnapshots m_recorded;
    std::vector<Source> m_sources;
    Side m_a, m_b;
    std::vector<int> m_moving; ///< motors that are not idle
    QLineEdit *m_search = nullptr;
    QCheckBox *m_all = nullptr;
    QCheckBox *m_otherHardware = nullptr;
    QTableView *m_table = nullptr;
    QLabel *m_summary = nullptr;
    QLabel *m_told = nullptr;
    QPlainTextEdit *m_report = nullptr;
    QProgressBar *m_progress = nullptr;
    QPushButton *m_cancel = nullptr;
    QPushButton *m_read = nullptr;
    QPushButton *m_restore = nullptr;
    QWidget *m_footer = nullptr;
    QString m_restoring; ///< what the list of writes is called
};

} // namespace widgets
