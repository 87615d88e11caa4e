// The list of events and markers, as a tool: jump to one, write a note, delete a marker. The log holds them.
#pragma once

#include "widgets/base/form.h"

#include <QTimer>

class QCheckBox;
class QPushButton;
class QSortFilterProxyModel;
class QTreeView;

namespace widgets {

class ScopeView;

class EventPanel : public Form {
    Q_OBJECT
public:
    /// `scope` outlives it.
    explicit EventPanel(ScopeView &scope, QWidget *parent = nullptr);

    double heightShare() const override { return 0.3; } // the traces are what is looked at
    void focusFirst() override;
    void editNote(quint32 marker); ///< selects it and opens its note

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void showEvent(QShowEvent *event) override;

private:
    void showKinds(bool onlyMarkers);
    void watchSelection();
    void enableRemove();
    void follow();
    void gather();
    void scrollToEnd();
    void jump(const QModelIndex &index);
    void removeChosen();
    void copyChosen();
    void choose(quint32 id);

    ScopeView &m_scope;
    QSortFilterProxyModel *m_markers;
    QTreeView *m_list;
    QCheckBox *m_onlyMarkers;
    QPushButton *m_remove;
    QTimer m_scroll;
    QTimer m_paint; ///< until then the list is not painted
    bool m_behind = false; ///< its end is to be shown when it is seen
};

} // namespace widgets
