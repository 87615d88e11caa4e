// An experiment of the command line on a simulated board of its own, both as programs in real time. Whether the machine
// let them run is looked at: a program that has no core cannot keep its motor in bounds, and ends as its documents say.
#pragma once

#include "support/programs/programs_posix.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <csignal>
#include <functional>
#include <optional>

namespace support {

/// How long the threads of a program were ready and had no core; 0 where this system does not tell it.
inline double waitedForCore_ms(qint64 process)
{
    double waited_ns = 0.0;
    const QDir threads(QStringLiteral("/proc/%1/task").arg(process));
    for (const QString &thread : threads.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(threads.filePath(thread + QStringLiteral("/schedstat")));
        if (file.open(QIODevice::ReadOnly))
            waited_ns += file.readAll().split(' ').value(1).toDouble();
    }
    return waited_ns * 1e-6;
}

/// How long a board and the program that drives it had no core, from now on.
class CoreWait {
public:
    explicit CoreWait(qint64 board)
        : m_board(board)
        , m_before_ms(waitedForCore_ms(board))
    {
    }

    /// Again and again while that program runs: one that has ended does not tell it.
    void look(qint64 program)
    {
        m_longest_ms = std::max(
            m_longest_ms, waitedForCore_ms(m_board) - m_before_ms + waitedForCore_ms(program));
    }
    /// So long that a motor may have been out of bounds, or silent.
    bool starved() const { return m_longest_ms > kStarved_ms; }

private:
    static constexpr double kStarved_ms = 200.0;

    qint64 m_board;
    double m_before_ms;
    double m_longest_ms = 0.0;
};

class ExperimentProgram {
public:
    /// @param line  its command; where it ends with -o its recording is kept in file()
    ExperimentProgram(const QStringList &boardOptions, const char *line)
        : m_board(boardOptions)
        , m_line(QString::fromUtf8(line))
    {
    }

    ExperimentProgram(const ExperimentProgram &) = delete;
    ExperimentProgram &operator=(const ExperimentProgram &) = delete;
    ~ExperimentProgram()
    {
        kill();
        m_board.vanish(); // a board that stands still does not end
    }

    const Simulator &board() const { return m_board; }
    Simulator &board() { return m_board; }
    QString file() const { return m_board.file("run.pcapng"); }

    void begin(const QStringList &more = {})
    {
        m_run.reset();
        m_wait = CoreWait(m_board.processId());
        QDir folder = QFileInfo(file()).dir();
        for (const QString &kept : folder.entryList({QStringLiteral("run*.pcapng")}, QDir::Files))
            folder.remove(kept); // parts, too
        m_more = more;
        QStringList words{QStringLiteral("--port"), m_board.port()};
        words += m_line.split(QLatin1Char(' ')) + more;
        if (m_line.endsWith(QLatin1String("-o")))
            words += file();
        startCli(m_process, words);
    }
    /// Waits until its recording is so large. @return  false: it had ended before
    bool recorded(qint64 bytes)
    {
        while (!ended())
            if (QFileInfo(file()).size() > bytes)
                return true;
        return false;
    }
    /// As Ctrl-C does.
    void interrupt() { ::kill(static_cast<pid_t>(m_process.processId()), SIGINT); }
    void kill()
    {
        m_process.kill();
        m_process.waitForFinished(kProgramTime_ms);
    }

    /// Looks at it, for a moment.
    bool ended()
    {
        constexpr int kLook_ms = 20;
        const bool over =
            m_process.state() == QProcess::NotRunning || m_process.waitForFinished(kLook_ms);
        m_wait.look(m_process.processId());
        return over;
    }
    /// What came of it; waits for that.
    const CliRun &run()
    {
        while (!m_run && !ended()) { }
        if (!m_run)
            m_run = resultOf(m_process);
        return *m_run;
    }
    /// What came of it. One that ended early, other than expected, is played again, twice, though no program of it was
    /// seen without a core: the machine below a virtual one stands still unseen.
    template <class Expected>
    const CliRun &outcome(Expected expected, const std::function<void()> &play = {})
    {
        const auto spoilt = [&] { return run().endedEarly() && !expected(run()) && !starved(); };
        for (int again = 0; again < 2 && spoilt(); ++again) {
            qWarning("%s", qPrintable(run().err));
            if (play)
                play();
            else
                begin(m_more);
        }
        return run();
    }
    bool starved() const { return m_wait.starved(); }

private:
    Simulator m_board;
    CoreWait m_wait{m_board.processId()};
    QString m_line;
    QStringList m_more;
    QProcess m_process;
    std::optional<CliRun> m_run;
};

} // namespace support
