// RegisterPanel: the tree of registers with its search box and what is done with edits. Tells which registers can be
// seen, so that only those are polled, and which ones the user wants on the scope.
#pragma once

#include "widgets/registers/edits.h"
#include "widgets/registers/model.h"

#include <QTimer>
#include <QTreeView>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;
class QMenu;
class QSortFilterProxyModel;

namespace widgets {

class EditBar;

class RegisterPanel : public QWidget {
    Q_OBJECT
public:
    RegisterPanel(RegisterModel &model, RegisterEdits &edits, QWidget *parent = nullptr);
    ~RegisterPanel() override;

    /// Registers whose rows are expanded and on screen.
    std::vector<catalog::RegisterId> visibleRegisters() const;

    /// For the menu; each carries its key and says in its tool tip why it cannot be used.
    struct Actions {
        QAction *undo = nullptr, *redo = nullptr, *apply = nullptr, *revert = nullptr;
        QAction *edit = nullptr, *copy = nullptr, *pin = nullptr;
    };
    const Actions &actions() const { return m_actions; }
    QMenu *columnsMenu() const { return m_columnsMenu; }

    /// Which columns are shown beside the name: "value", "raw", "hex", "access", "help".
    void setColumns(const QStringList &names);
    QStringList columns() const;

public Q_SLOTS:
    void focusSearch();
    void editCurrent(); ///< the value of the selected register
    void copySelected(); ///< a line each: name, value, raw

Q_SIGNALS:
    void visibleRegistersChanged();
    void registersChosen(const QList<quint32> &ids); ///< for the scope

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeTree();
    void makeColumns();
    void makeActions();
    void updateDetails();
    void showColumns();
    int leastName() const;
    bool chosen(const char *column) const;
    void togglePinned();
    void updateEdits();
    void activate(const QModelIndex &index);
    std::vector<catalog::RegisterId> selected() const;
    void chooseSelected();
    void showMenu(const QPoint &at);
    void search(const QString &text);
    QModelIndex bestHit(const QString &name) const;
    void expandDefaults();

    RegisterModel &m_model;
    RegisterEdits &m_edits;
    Actions m_actions;
    QSortFilterProxyModel *m_proxy;
    QLineEdit *m_search;
    QTreeView *m_tree;
    QLabel *m_details;
    QMenu *m_columnsMenu;
    EditBar *m_editBar = nullptr;
    int m_leastName = 0; ///< pixels of the column of names
    QTimer m_settled; ///< scrolling tells once, not at every pixel
};

} // namespace widgets
