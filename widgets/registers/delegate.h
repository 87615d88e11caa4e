// RegisterDelegate: the editors of the register tree: names to choose from where a register has them, a strict text
// field otherwise. An editor only changes what is wanted, never the board; what cannot be understood stays in it.
#pragma once

#include "widgets/registers/model.h"
#include "widgets/registers/name_elision.h"

#include <QListWidget>
#include <QStyledItemDelegate>

#include <string_view>

namespace widgets {

/// The bits of a register as a list of names with check boxes. Space switches one, the arrows go from one to the next;
/// a bit without a name keeps its value.
class FlagsEdit : public QListWidget {
    Q_OBJECT
public:
    explicit FlagsEdit(std::string_view registerName, QWidget *parent = nullptr);

    void setBits(std::int64_t bits);
    std::int64_t bits() const;
    bool touched() const { return bits() != m_before; } ///< by the user, since setBits()

    QSize sizeHint() const override; ///< all of them, up to a dozen
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    std::int64_t m_before = 0;
};

/// An EntryEdit, or a QComboBox of names where the register has them; nullptr if it cannot be written.
QWidget *makeRegisterEditor(
    const RegisterModel &model, catalog::RegisterId id, int column, QWidget *parent);

/// Of all registers that are shown, without those of the groups.
QStringList namesIn(const RegisterModel &model);

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
    /// An editor closed on a text that is not good.
    void entryRefused(const QString &sentence) const;

private:
    QString roundedFor(const QStyleOptionViewItem &option, const QModelIndex &index) const;

    const RegisterModel &m_model;
    mutable NameElision m_names; ///< keeps what it has cut
};

} // namespace widgets
