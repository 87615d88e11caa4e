// RunBookPanel: the experiments that were kept in a folder, one a row, with what came of them, a star and a note. What
// is chosen opens: its registers beside the board's or those of another run, its recording on the scope, or as a
// reference behind what is live.
#pragma once

#include "widgets/base/form.h"
#include "widgets/runs/keeper.h"

class QLabel;
class QPushButton;
class QTreeView;

namespace widgets {

class FilePrompt;
class RunBookModel;
class SteadyLabel;

class RunBookPanel : public Form {
    Q_OBJECT
public:
    /// Both outlive it.
    RunBookPanel(RunKeeper &keeper, FilePrompt &files, QWidget *parent = nullptr);

    void focusFirst() override;

Q_SIGNALS:
    /// Two snapshots beside each other; the second is empty: the board.
    void registersWanted(const QString &a, const QString &b);
    void referenceWanted(const QString &recording);
    void recordingWanted(const QString &recording);

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void askFolder();
    void askRecording();
    void split(const QString &recording);
    void read();
    void fitColumns();
    void annotate(int number, const QString &note, bool starred);
    void compare();
    void updateButtons();
    void tell(const QString &sentence);
    std::vector<session::Run> chosen() const; ///< by their number

    RunKeeper &m_keeper;
    FilePrompt &m_files;
    RunBookModel *m_model;
    QTreeView *m_table;
    QLabel *m_folder;
    SteadyLabel *m_told;
    QPushButton *m_split, *m_registers, *m_reference, *m_open;
    bool m_read = false; ///< what is in the folder
};

} // namespace widgets
