// The command line and the simulated board as programs, for tests that run them. POSIX only.
#pragma once

#include "support/programs/cli_run.h"

#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include <csignal>

namespace support {

/// The program never repeats what moves a motor; what it says the board did not get, because this machine stalled, is
/// typed again here.
template <class Run>
CliRun typedAgain(Run runOnce)
{
    constexpr int kTries = 5;
    CliRun run = runOnce();
    for (int tries = 1; tries < kTries && run.stalled(); ++tries)
        run = runOnce();
    return run;
}

/// A machine that stalls for a moment must not look like a board that lost a command.
inline QStringList patient(const QStringList &words)
{
    return QStringList{QStringLiteral("--patience"), QStringLiteral("1000")} + words;
}

inline void startCli(QProcess &process, const QStringList &words)
{
    process.start(programFile(QStringLiteral("rotorscope-cli")), patient(words));
}

inline CliRun runCli(const QStringList &words) { return typed(patient(words)); }

/// The same while this thread's event loop runs, so that a board can live there.
inline CliRun runCliBeside(const QStringList &words)
{
    QProcess process;
    QEventLoop loop;
    QObject::connect(&process, &QProcess::finished, &loop, &QEventLoop::quit);
    QTimer::singleShot(kProgramTime_ms, &loop, &QEventLoop::quit);
    startCli(process, words);
    loop.exec();
    return resultOf(process);
}

/// rotorscope-sim with its port in a folder of its own: a board that several runs of the command line meet in turn.
class Simulator {
public:
    explicit Simulator(const QStringList &options = {})
    {
        m_process.start(support::programFile(QStringLiteral("rotorscope-sim")),
            QStringList{QStringLiteral("mcp"), QStringLiteral("--link"), port()} + options);
        while (!m_process.canReadLine() && m_process.waitForReadyRead(kProgramTime_ms)) { }
        m_ready = m_process.readLine().startsWith("ready ");
    }
    Simulator(const Simulator &) = delete;
    Simulator &operator=(const Simulator &) = delete;
    ~Simulator()
    {
        m_process.terminate();
        m_process.waitForFinished(kProgramTime_ms);
    }

    /// A word of its control; wants "--control" among its options.
    void tell(const char *word)
    {
        m_process.write(QByteArray(word).append('\n'));
        m_process.waitForBytesWritten(kProgramTime_ms);
    }

    /// As if its cable were pulled.
    void vanish()
    {
        m_process.kill();
        m_process.waitForFinished(kProgramTime_ms);
    }

    /// As if its firmware stood still.
    void freeze() const { ::kill(static_cast<pid_t>(m_process.processId()), SIGSTOP); }

    bool ready() const { return m_ready; }
    qint64 processId() const { return m_process.processId(); }
    QString port() const { return m_folder.filePath(QStringLiteral("port")); }
    QString file(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    /// A command in one string, then words that may hold spaces.
    CliRun cli(const char *line, const QStringList &more = {}) const
    {
        const QStringList words = QStringList{QStringLiteral("--port"), port()}
            + QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts) + more;
        return typedAgain([&] { return runCli(words); });
    }

private:
    QTemporaryDir m_folder;
    QProcess m_process;
    bool m_ready = false;
};

} // namespace support
