// StopAlarm: the red text that nobody can overlook when a stop was not confirmed. Closing it restarts nothing. What is in
// it is made when it is first raised, which takes a few milliseconds that a start of the program has no use for.
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
    void make();
    void raiseWith(const QString &detail);

    QLabel *m_text = nullptr;
    QLabel *m_detail = nullptr;
};

} // namespace widgets
