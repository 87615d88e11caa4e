// FaultPicture: what was recorded around a fault, as traces, with the values at the instant at which it was told.
#pragma once

#include "widgets/scope/events/fault_records.h"
#include "widgets/scope/events/log.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QVBoxLayout;

namespace widgets {

class ScopeView;

class FaultPicture : public QWidget {
    Q_OBJECT
public:
    /// @param records  outlives it
    explicit FaultPicture(const FaultRecords &records, QWidget *parent = nullptr);

    void showNewestOf(int motor); ///< if there is one

private:
    void follow();
    void showRecord(quint32 id);

    const FaultRecords &m_records;
    QComboBox *m_choice;
    QLabel *m_says;
    QVBoxLayout *m_layout;
    EventLog m_events; ///< the fault alone
    FaultRecord m_shown; ///< a copy: it stays while it is looked at
    ScopeView *m_scope = nullptr;
};

} // namespace widgets
