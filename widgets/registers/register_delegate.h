// RegisterDelegate: the editors of the register tree: names to choose from where a register has them, a strict text
// field otherwise. An editor only changes what is wanted, never the board; what cannot be understood stays in it.
#pragma once

#include "widgets/base/stepped_edit.h"
#include "widgets/registers/register_model.h"

#include <QStyledItemDelegate>
#include <QValidator>

namespace widgets {

/// Says whether a text can be written to a register; keeps Enter from taking one that cannot.
class EntryValidator : public QValidator {
    Q_OBJECT
public:
    EntryValidator(const RegisterModel &model, catalog::RegisterId id, int column, QObject *parent);

    State validate(QString &text, int &position) const override;
    QString problem(const QString &text) const; ///< one sentence; empty if the text is good

private:
    const RegisterModel &m_model;
    catalog::RegisterId m_id;
    int m_column;
};

/// A text field for one register.
class EntryEdit : public SteppedEdit {
    Q_OBJECT
public:
    EntryEdit(const RegisterModel &model, catalog::RegisterId id, int column, QWidget *parent);

    QString problem() const override { return m_validator->problem(text()); }

protected:
    void stepBy(int steps) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    const RegisterModel &m_model;
    catalog::RegisterId m_id;
    int m_column;
    EntryValidator *m_validator;
};

/// An EntryEdit, or a QComboBox of names where the register has them; nullptr if it cannot be written.
QWidget *makeRegisterEditor(
    const RegisterModel &model, catalog::RegisterId id, int column, QWidget *parent);

class RegisterDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    explicit RegisterDelegate(const RegisterModel &model, QObject *parent = nullptr);

    QWidget *createEditor(QWidget *parent, const QStyleOptionViewItem &option,
        const QModelIndex &index) const override;
    void setEditorData(QWidget *editor, const QModelIndex &index) const override;
    void setModelData(
        QWidget *editor, QAbstractItemModel *model, const QModelIndex &index) const override;
    void updateEditorGeometry(QWidget *editor, const QStyleOptionViewItem &option,
        const QModelIndex &index) const override;
    bool helpEvent(QHelpEvent *event, QAbstractItemView *view, const QStyleOptionViewItem &option,
        const QModelIndex &index) override;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override;

Q_SIGNALS:
    void entryRefused(
        const QString &sentence) const; ///< an editor closed on a text that is not good

private:
    QString roundedFor(const QStyleOptionViewItem &option, const QModelIndex &index) const;

    const RegisterModel &m_model;
};

} // namespace widgets
