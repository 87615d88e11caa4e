// A simulated board behind a pseudo-terminal, for tests that open it as a serial port. POSIX only.
#pragma once

#include "simulation/simulated_board.h"
#include "support/pseudo_terminal.h"

#include <QElapsedTimer>
#include <QSocketNotifier>
#include <QTimer>

#include <functional>
#include <memory>

namespace support {

/// A simulated board behind a pseudo-terminal, run by this thread's event loop.
class BoardOnTerminal {
public:
    explicit BoardOnTerminal(const simulation::BoardOptions &options = {})
        : m_board(simulation::makeBoard(options))
    {
        m_time.start();
        m_pump.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_pump, &QTimer::timeout, &m_pump, [this] { pump(); });
        m_pump.start(1);
        plugIn();
    }

    const QString &path() const { return m_terminal->path(); }
    std::uint64_t sentBytes() const { return m_sent; }

    /// Pulls the cable while half of what is on its way has been sent.
    void unplugInTheMiddle() { m_unplugNext = true; }
    bool unplugged() const { return m_unplugged; }
    /// The cable again, at a path of its own; the board went on meanwhile.
    void plugIn()
    {
        m_terminal = std::make_unique<PseudoTerminal>();
        m_input = std::make_unique<QSocketNotifier>(m_terminal->master(), QSocketNotifier::Read);
        QObject::connect(m_input.get(), &QSocketNotifier::activated, &m_pump, [this] { pump(); });
        m_unplugNext = m_unplugged = false;
    }
    /// Told of the bytes that arrive at the board, before it has them.
    std::function<void(const Bytes &)> onHeard;
    /// Told of the bytes that leave it. @return false: they are lost on the line
    std::function<bool(const Bytes &)> onSaid;
    const simulation::SimulatedBoard &board() const { return *m_board; }

private:
    TimePoint now() const { return TimePoint(Duration(m_time.nsecsElapsed())); }

    void pump()
    {
        if (m_unplugged)
            return;
        const Bytes in = m_terminal->read();
        if (onHeard && !in.empty())
            onHeard(in);
        if (!in.empty())
            m_board->receive(in, now());
        m_board->advance(now());
        Bytes out = m_board->takeOutput();
        if (m_unplugNext && out.size() > 1) {
            out.resize(out.size() / 2);
            m_terminal->write(out);
            m_input.reset();
            m_terminal->unplug();
            m_unplugged = true;
            return;
        }
        if (out.empty() || (onSaid && !onSaid(out)))
            return;
        m_sent += out.size();
        m_terminal->write(out);
    }

    std::unique_ptr<simulation::SimulatedBoard> m_board;
    std::unique_ptr<PseudoTerminal> m_terminal;
    QElapsedTimer m_time;
    QTimer m_pump;
    std::unique_ptr<QSocketNotifier> m_input;
    std::uint64_t m_sent = 0;
    bool m_unplugNext = false;
    bool m_unplugged = false;
};

} // namespace support
