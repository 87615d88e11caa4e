// The last records of the trigger as a tool: look at one again, pin it so that it stays, give it a label.
#pragma once

#include "widgets/base/form.h"

class QPushButton;
class QSpinBox;
class QTreeView;

namespace widgets {

class RecordTable;
class ScopeView;
class TriggerControl;

class RecordPanel : public Form {
    Q_OBJECT
public:
    /// Both outlive it.
    RecordPanel(TriggerControl &control, ScopeView &scope, QWidget *parent = nullptr);

    void refresh(Milliseconds now) override;
    double heightShare() const override { return 0.3; } // the traces are what is looked at
    void focusFirst() override;

protected:
    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void showChosen();
    void followShown();
    void enableShow();
    QWidget *makeReferences(ScopeView &scope);

    TriggerControl &m_control;
    RecordTable *m_table;
    QTreeView *m_list;
    QPushButton *m_show;
    QSpinBox *m_persistence;
};

} // namespace widgets
