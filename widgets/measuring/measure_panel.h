// The automatic measurements as a tool: choose a trace and a measure, see its value and its statistics; the chosen row
// is drawn over its trace. Measures a few times a second while it can be seen, and every record of the trigger.
#pragma once

#include "scope/record.h"
#include "widgets/base/form.h"
#include "widgets/measuring/measure_table.h"

class QComboBox;
class QPushButton;
class QTreeView;

namespace widgets {

class ScopeView;
class TriggerControl;

class MeasurePanel : public Form {
    Q_OBJECT
public:
    /// All outlive it.
    MeasurePanel(ScopeView &scope, const capture::Capture &capture, TriggerControl &trigger,
        QWidget *parent = nullptr);

    QList<NamedMeasure> measures() const;
    /// In the place of those that are there; each as soon as its trace is shown.
    void setMeasures(QList<NamedMeasure> measures);
    void measure(capture::ChannelId channel, scope::Quantity quantity); ///< as a new row
    void refresh(Milliseconds now) override;
    double heightShare() const override { return 0.3; } // the traces are what is looked at
    void focusFirst() override;

protected:
    void hideEvent(QHideEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void makeSide(QWidget *side);
    void fillTraces();
    void addChosen();
    void addWaiting();
    void showAdded();
    void removeChosen();
    void recordCompleted(const scope::Record &record);
    void add(const MeasureTable::Wanted &wanted);
    void measureAll();
    bool betweenCursors() const;
    capture::TimeSpan measuredRange() const;
    void drawChosen();
    void enableButtons();

    ScopeView &m_scope;
    const capture::Capture &m_capture;
    TriggerControl &m_trigger;
    MeasureTable *m_table;
    QList<NamedMeasure> m_waiting; ///< for their traces
    QTreeView *m_list;
    QComboBox *m_trace;
    QComboBox *m_quantity;
    QComboBox *m_against;
    QComboBox *m_range;
    QPushButton *m_remove = nullptr, *m_clear = nullptr, *m_copy = nullptr;
};

} // namespace widgets
