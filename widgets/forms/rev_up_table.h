// The table of a rev-up's stages: its cells are typed as strictly as every value that reaches a board.
#pragma once

#include <QStyledItemDelegate>
#include <QTableView>

namespace widgets {

class RevUpModel;

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
