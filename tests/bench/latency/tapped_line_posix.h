// A pseudo-terminal in front of another one, with a clock at the tap: every chunk of bytes that a program writes is
// timed when it arrives, before it goes on to the board. Runs in threads of its own. POSIX only.
#pragma once

#include "support/pseudo_terminal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <sched.h>

namespace bench {

using Clock = std::chrono::steady_clock;

/// False if this user may not do that. @param process  0: the calling thread
inline bool makeRealTime(pid_t process)
{
    sched_param priority{};
    priority.sched_priority = 20;
    return ::sched_setscheduler(process, SCHED_RR, &priority) == 0;
}

class TappedLine {
public:
    /// @param board  path of the board's terminal
    explicit TappedLine(const QString &board)
        : m_board(
            ::open(board.toLocal8Bit().constData(), O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK))
    {
        termios settings{};
        ::tcgetattr(m_board, &settings);
        ::cfmakeraw(&settings);
        ::tcsetattr(m_board, TCSANOW, &settings);
        m_threads[0] = std::thread([this] { toBoard(); });
        m_threads[1] = std::thread([this] { fromBoard(); });
    }
    TappedLine(const TappedLine &) = delete;
    TappedLine &operator=(const TappedLine &) = delete;
    ~TappedLine()
    {
        m_end = true;
        for (std::thread &thread : m_threads)
            thread.join();
        ::close(m_board);
    }

    const QString &path() const { return m_terminal.path(); } ///< for the program

    /// From now on waits for these bytes toward the board.
    void expect(const Bytes &wanted)
    {
        m_seen = 0;
        m_wanted = wanted; // the thread looks at it only while m_armed
        m_armed = true;
    }
    /// When they came, since the clock's epoch; 0: not yet.
    std::int64_t seen() const { return m_seen; }
    std::uint64_t bytesFromBoard() const { return m_fromBoard; }

private:
    // A thread for each direction: a program that is slow to read must not hold up what it has written.
    void toBoard()
    {
        makeRealTime(0);
        pollfd source{m_terminal.master(), POLLIN, 0};
        while (!m_end) {
            ::poll(&source, 1, 20);
            const auto now = Clock::now().time_since_epoch();
            if (const Bytes out = m_terminal.read(); !out.empty()) {
                look(out, std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
                passOn(m_board, out);
            }
        }
    }
    void fromBoard()
    {
        makeRealTime(0);
        pollfd source{m_board, POLLIN, 0};
        Bytes in(65536);
        while (!m_end) {
            ::poll(&source, 1, 20);
            const auto count = ::read(m_board, in.data(), in.size());
            if (count <= 0)
                continue;
            m_fromBoard += static_cast<std::uint64_t>(count);
            passOn(m_terminal.master(), ByteView(in).first(static_cast<std::size_t>(count)));
        }
    }
    void look(const Bytes &bytes, std::int64_t now)
    {
        if (!m_armed)
            return;
        m_tail.insert(m_tail.end(), bytes.begin(), bytes.end());
        const auto at = std::search(m_tail.begin(), m_tail.end(), m_wanted.begin(), m_wanted.end());
        if (at != m_tail.end()) {
            m_armed = false;
            m_tail.clear();
            m_seen = now;
        } else if (m_tail.size() > m_wanted.size()) {
            m_tail.erase(
                m_tail.begin(), m_tail.end() - static_cast<std::ptrdiff_t>(m_wanted.size()));
        }
    }
    void passOn(int fd, ByteView bytes)
    {
        for (std::size_t at = 0; at < bytes.size() && !m_end;) {
            const auto count = ::write(fd, bytes.data() + at, bytes.size() - at);
            if (count > 0) {
                at += static_cast<std::size_t>(count);
            } else {
                pollfd room{fd, POLLOUT, 0};
                ::poll(&room, 1, 20);
            }
        }
    }

    support::PseudoTerminal m_terminal;
    int m_board;
    Bytes m_wanted, m_tail;
    std::atomic<bool> m_armed{false}, m_end{false};
    std::atomic<std::int64_t> m_seen{0};
    std::atomic<std::uint64_t> m_fromBoard{0};
    std::array<std::thread, 2> m_threads;
};

} // namespace bench
