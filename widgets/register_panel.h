// RegisterPanel: the tree of registers with its search box. Tells which registers can be seen, so that only those are
// polled, and which ones the person wants on the scope.
#pragma once

#include "widgets/register_model.h"

#include <QTimer>
#include <QTreeView>
#include <QWidget>

class QLineEdit;
class QSortFilterProxyModel;

namespace widgets {

class RegisterPanel : public QWidget {
    Q_OBJECT
public:
    explicit RegisterPanel(RegisterModel &model, QWidget *parent = nullptr);

    QTreeView *tree() const { return m_tree; }
    /// Registers whose rows are expanded and on screen.
    std::vector<catalog::RegisterId> visibleRegisters() const;

public Q_SLOTS:
    void focusSearch();

Q_SIGNALS:
    void visibleRegistersChanged();
    void registersChosen(const QList<quint32> &ids); ///< for the scope

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void chooseSelected();
    void showMenu(const QPoint &at);
    void search(const QString &text);
    void expandDefaults();

    RegisterModel &m_model;
    QSortFilterProxyModel *m_proxy;
    QLineEdit *m_search;
    QTreeView *m_tree;
    QTimer m_settled; ///< scrolling tells once, not at every pixel
};

} // namespace widgets
