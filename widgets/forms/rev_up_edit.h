// RevUpEdit: a text field for one number of a rev-up, read as strictly as every value that reaches a board; a step is
// what the register can hold.
#pragma once

#include "widgets/base/stepped_edit.h"
#include "widgets/registers/register_entry.h"

#include <QStyledItemDelegate>
#include <QTableView>

#include <functional>

namespace widgets {

class RevUpModel;

class RevUpEdit : public SteppedEdit {
    Q_OBJECT
public:
    using Rules = std::function<EntryRules()>; ///< asked anew each time: limits change

    RevUpEdit(Rules rules, int step, QWidget *parent = nullptr);

    std::optional<catalog::Value> value() const; ///< empty if the text is not good
    QString problem() const override;
    void setEmptyAllowed(bool allowed) { m_emptyAllowed = allowed; }

protected:
    void stepBy(int steps) override;

private:
    Rules m_rules;
    int m_step;
    bool m_emptyAllowed = false;
};

class RevUpDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit RevUpDelegate(RevUpModel &model, QObject *parent = nullptr);

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
        const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(
        QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
        const QModelIndex &index) const override;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;

Q_SIGNALS:
    void entryRefused(const QString &sentence) const;

private:
    RevUpModel &m_model;
};

/// The table: keys that begin an edit stay with it instead of being the window's. Enter begins one, too; Tab leaves it.
class RevUpTable : public QTableView {
    Q_OBJECT
public:
    explicit RevUpTable(QWidget *parent = nullptr);

    QSize sizeHint() const override;
    void setModel(QAbstractItemModel *model) override;

Q_SIGNALS:
    void addWanted(); ///< Insert
    void removeWanted(); ///< Delete
    void moveWanted(int by); ///< Alt with an arrow key

protected:
    bool event(QEvent *event) override;
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void fitToFont();
};

/// Whether a key would begin or step a number in a focused view; the window has shortcuts on some of them.
bool editsNumber(const QKeyEvent &key);

} // namespace widgets
