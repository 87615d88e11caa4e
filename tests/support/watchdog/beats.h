// A watchdog for the window's thread: it tells of each beat of the event loop that computed for longer than 50 ms, what
// it was for and what ran then. A beat is one event with all that it brings about at once; that of a loop inside it (a
// menu, a dialog) is a beat of its own. The clock counts what the thread computes, not how long a busy machine let it
// wait.
//
// Every test with a window has it, see test_program.h. A beat of more than a quarter of a second fails its test;
// sanitizers slow everything and fail none.
#pragma once

#include <QCoreApplication>
#include <QEvent>
#include <QThread>

namespace support {

/// Of the thread that calls; 0 where the system does not tell.
double threadSeconds();

class Beat {
public:
    Beat(const QObject &receiver, const QEvent &event);
    ~Beat();
    Beat(const Beat &) = delete;
    Beat &operator=(const Beat &) = delete;

    static constexpr double kLong_s = 0.05;
    static constexpr double kFrozen_s = 0.25;

    struct Told {
        int beats = 0; ///< longer than kLong_s
        double longest_s = 0.0; ///< of all
        QString what; ///< the longest of those: event, receiver, and some of what ran
    };
    static const Told &told(); ///< since the program began, or forget()
    static void forget();

private:
    bool m_counts = false;
    QEvent::Type m_type = QEvent::None;
};

/// An application that watches its own beats.
template <class App>
class Watched : public App {
public:
    using App::App;
    bool notify(QObject *receiver, QEvent *event) override
    {
        if (!receiver || QThread::currentThread() != this->thread())
            return App::notify(receiver, event);
        const Beat beat(*receiver, *event);
        return App::notify(receiver, event);
    }
};
/// Without a window no user waits.
template <>
class Watched<QCoreApplication> : public QCoreApplication {
public:
    using QCoreApplication::QCoreApplication;
};

} // namespace support
