// How long the event loop of this thread was away at the longest: a timer that should come every 5 ms, and the gap between two
// of its beats. For figures, never for an assertion: a busy machine makes gaps of its own.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <algorithm>

namespace support {

class BeatWatch {
public:
    static constexpr int kBeat_ms = 5;

    BeatWatch()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(kBeat_ms);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { beat(); });
        restart();
    }

    /// Begins anew, with a beat now.
    void restart()
    {
        m_longest_ms = 0.0;
        m_beats = 0;
        m_since.start();
        m_timer.start();
    }
    /// Until now: a loop that is away while this is asked counts, too.
    double longest_ms() const { return std::max(m_longest_ms, sinceLast_ms()); }
    int beats() const { return m_beats; }

private:
    double sinceLast_ms() const { return static_cast<double>(m_since.nsecsElapsed()) / 1e6; }
    void beat()
    {
        m_longest_ms = longest_ms();
        m_since.start();
        ++m_beats;
    }

    QTimer m_timer;
    QElapsedTimer m_since;
    double m_longest_ms = 0.0;
    int m_beats = 0;
};

} // namespace support
