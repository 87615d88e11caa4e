// The one timer of a session: a single shot, exact to some ten microseconds where the system can. Qt's own timers count
// whole milliseconds, which is a whole exchange with a drive that is asked a thousand times a second. Beside it a clock
// that goes on while the computer sleeps, which the one that timers run by does not.
#pragma once

#include "base/time.h"

#include <QObject>
#include <QTimer>

class QSocketNotifier;

namespace session {

/// Since some fixed time; from any thread. Only differences count.
TimePoint elapsedTime();

class WakeTimer : public QObject {
    Q_OBJECT
public:
    explicit WakeTimer(QObject *parent = nullptr);
    ~WakeTimer() override;

    /// One due() after this time, which replaces the one before. In the thread that the timer lives in.
    void start(Duration wait);
    void stop();

Q_SIGNALS:
    void due();

private:
    void makeCoarse();
    void startCoarse(Duration wait);

    QTimer m_coarse; ///< where there is nothing better
    int m_descriptor = -1;
    QSocketNotifier *m_notifier = nullptr;
};

} // namespace session
