// StopAlarm: the red text that nobody can overlook when a stop was not confirmed. Closing it restarts nothing.
#pragma once

#include <QDialog>

class QLabel;

namespace widgets {

class StopAlarm : public QDialog {
    Q_OBJECT
public:
    explicit StopAlarm(QWidget *parent = nullptr);

    void raiseAlarm(int motor); ///< modal, without a loop of its own
    void raiseNotSent(); ///< the same, for a stop that nothing could carry
    void
    confirmedLate(); ///< evidence came after all; the text says so and stays until it is closed

private:
    QLabel *m_text;
    QLabel *m_detail;
};

} // namespace widgets
