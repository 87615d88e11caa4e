// StopAlarm: the red text that cannot be overlooked when a stop was not confirmed. Closing it restarts nothing. What is in
// it is made when it is first raised, which takes a few milliseconds that a start of the program has no use for.
#pragma once

#include "drive/event.h"

#include <QDialog>

#include <map>

class QLabel;
class QPushButton;

namespace widgets {

class StopAlarm : public QDialog {
    Q_OBJECT
public:
    explicit StopAlarm(QWidget *parent = nullptr);

    void raiseAlarm(int motor); ///< modal, without a loop of its own
    void raiseNotSent(); ///< the same, for a stop that nothing could carry
    /// Ports that are gone with a stop which nothing confirmed; the same while there is one more than before.
    void showWanted(const QStringList &ports);
    /// Evidence that came after all, for each motor of its own; the text says so and stays until it is closed.
    void take(const drive::StopProgress &progress);

Q_SIGNALS:
    void
    takenBack(); ///< the user says that the stop of the ports that are gone is no longer wanted

private:
    void make();
    void raiseWith(const QString &text);
    QString detail() const;
    QString ofMotors() const;
    QString ofPorts() const;

    std::map<int, drive::StopWord>
        m_motors; ///< what is known of those that the alarm was raised for
    QStringList m_ports; ///< that are gone
    QLabel *m_text = nullptr;
    QLabel *m_detail = nullptr;
    QPushButton *m_takeBack = nullptr;
};

} // namespace widgets
