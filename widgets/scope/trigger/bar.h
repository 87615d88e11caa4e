// The trigger's bar above the scope: mode, type, source, way and level at hand, everything else in a menu of its own,
// the state in words and the age of what is shown. Fields appear only where they matter. It decides nothing.
#pragma once

#include "widgets/scope/trigger/setup.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QToolButton;

namespace widgets {

class Device;
class ScopeView;
class SteadyLabel;
class TriggerControl;
class ValueEdit;

class TriggerBar : public QWidget {
    Q_OBJECT
public:
    /// All three outlive it.
    TriggerBar(
        TriggerControl &control, ScopeView &scope, const Device &device, QWidget *parent = nullptr);

public Q_SLOTS:
    void refreshAge(); ///< some times a second

private:
    void makeBar();
    QWidget *makeDetails();
    void follow();
    void fitLevel(double level, double step, const QString &unit);
    void followDetails(const QString &unit, double step);
    void fillSources();
    void fillWays();
    void fillWritten();
    void showState();
    static QStringList stateTexts(bool roll);
    void change(const std::function<void(TriggerSetup &)> &edit);
    void openDetails();

    TriggerControl &m_control;
    ScopeView &m_scope;
    const Device &m_device;
    QComboBox *m_mode;
    QComboBox *m_type;
    QComboBox *m_source;
    QComboBox *m_written;
    QComboBox *m_way;
    ValueEdit *m_level;
    QToolButton *m_single;
    QToolButton *m_force;
    QToolButton *m_more;
    SteadyLabel *m_state;
    /// Made with the first mode that has some, and with it what is below.
    QWidget *m_details = nullptr;
    QFormLayout *m_form = nullptr;
    ValueEdit *m_upper = nullptr;
    ValueEdit *m_hysteresis = nullptr;
    ValueEdit *m_least = nullptr;
    ValueEdit *m_most = nullptr;
    QComboBox *m_inside = nullptr;
    ValueEdit *m_time = nullptr;
    QSpinBox *m_count = nullptr;
    ValueEdit *m_preTrigger = nullptr;
    ValueEdit *m_holdOff = nullptr;
    ValueEdit *m_length = nullptr;
    QPushButton *m_middle = nullptr;
    QLabel *m_problem = nullptr;
    QString m_levelUnit; ///< that the field of the level is wide enough for
    QString m_sourcesShown; ///< what fillSources() last made, to leave an open list alone
};

} // namespace widgets
