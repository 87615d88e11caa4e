// RegisterDelegate: the editors of the register tree: names to choose from where a register has them, a strict text
// field otherwise. An editor only changes what is wanted, never the board; what cannot be understood stays in it.
#pragma once

#include "widgets/registers/register_model.h"

#include <QStyledItemDelegate>

namespace widgets {

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
