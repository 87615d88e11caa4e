// StopAlarm: the red text that cannot be overlooked when a stop was not confirmed. Closing it restarts nothing. It lies
// over the picture and off the panel that controls the motors, and has room from the start for the evidence that may
// still come: neither its buttons nor itself move then. Once standstill was measured of all motors that it is about, it
// says so in calm colours, and waits to be read. What is in it is made when it is first raised, which takes a few
// milliseconds that a start of the program has no use for.
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
    /// Both are in its window; it is laid over the one and does not cover the other where there is room.
    void setPlace(const QWidget *over, const QWidget *keepFree);

    void raiseAlarm(int motor); ///< modal, without a loop of its own
    void raiseNotSent(); ///< the same, for a stop that nothing could carry
    /// Ports that are gone with a stop which nothing confirmed; the same while there is one more than before.
    void showWanted(const QStringList &ports);
    /// How many the board has, as it tells; 0: it has not told.
    void setMotors(int motors);
    /// Evidence that came after all, for each motor of its own; the text says so and stays until it is closed.
    void accept(const drive::StopProgress &progress);

Q_SIGNALS:
    /// The user says that the stop of the ports that are gone is no longer wanted.
    void takenBack();

private:
    void make();
    void begin();
    void raiseWith(const QString &text);
    using Words = std::map<int, drive::StopWord>;
    void fitHeadline();
    void showText(const QString &text);
    void place();
    bool stand(const Words &motors) const;
    QString detail() const { return detail(m_motors); }
    QString detail(const Words &motors) const;
    QString ofMotors(const Words &motors) const;
    QString ofPorts() const;
    static QString lateText();

    Words m_motors; ///< what is known of those that the alarm was raised for
    QStringList m_ports; ///< that are gone
    int m_count = 0; ///< motors of the board
    /// It is about a stop of which nothing was heard: every motor of the board has to stand.
    bool m_ofAll = false;
    bool m_calm = false; ///< as it is painted
    const QWidget *m_over = nullptr;
    const QWidget *m_keepFree = nullptr;
    QLabel *m_text = nullptr;
    QLabel *m_detail = nullptr;
    QPushButton *m_takeBack = nullptr;
};

} // namespace widgets
