// The command line and the simulated board as programs, for tests that run them. POSIX only.
#pragma once

#include "support/places.h"

#include <QEventLoop>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>

#include <csignal>

namespace support {

constexpr int kProgramTime_ms = 60'000;

struct CliRun {
    int status = -1;
    QString out, err;

    QStringList lines() const { return out.split(QLatin1Char('\n'), Qt::SkipEmptyParts); }
    QJsonArray list() const { return QJsonDocument::fromJson(out.toUtf8()).array(); }
    QJsonObject object() const { return QJsonDocument::fromJson(out.toUtf8()).object(); }
    bool oneLineOfError() const { return err.count(QLatin1Char('\n')) == 1; }
    /// What moves a motor ended before its end, as documented: nothing is measured, and the reason is said.
    bool endedEarly() const
    {
        return (status == 1 || status == 3 || status == 6) && out.isEmpty() && !err.isEmpty();
    }
    /// The line or one of the programs stood still, and nothing of the command got through.
    bool stalled() const
    {
        return status == 1
            && (err.contains(QLatin1String("was not sent: no answer"))
                || err.contains(QLatin1String("was not sent: too late"))
                || err.contains(QLatin1String("stood still")));
    }
};

/// The program never repeats what moves a motor; what it says the board did not get, because this machine stalled, is typed
/// again here.
template <class Run>
CliRun typedAgain(Run runOnce)
{
    constexpr int kTries = 5;
    CliRun run = runOnce();
    for (int tries = 1; tries < kTries && run.stalled(); ++tries)
        run = runOnce();
    return run;
}

inline CliRun resultOf(QProcess &process)
{
    return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
        QString::fromUtf8(process.readAllStandardOutput()),
        QString::fromUtf8(process.readAllStandardError())};
}

/// With patience: a machine that stalls for a moment must not look like a board that lost a command.
inline void startCli(QProcess &process, const QStringList &words)
{
    process.start(support::programFile(QStringLiteral("rotorscope-cli")),
        QStringList{QStringLiteral("--patience"), QStringLiteral("1000")} + words);
}

inline CliRun runCli(const QStringList &words)
{
    QProcess process;
    startCli(process, words);
    if (!process.waitForFinished(kProgramTime_ms))
        process.kill();
    return resultOf(process);
}

/// The same while this thread's event loop runs, so that a board can live there.
inline CliRun runCliBeside(const QStringList &words)
{
    QProcess process;
    QEventLoop loop;
    QObject::connect(&process, &QProcess::finished, &loop, &QEventLoop::quit);
    QTimer::singleShot(kProgramTime_ms, &loop, &QEventLoop::quit);
    startCli(process, words);
    loop.exec();
    if (process.state() != QProcess::NotRunning)
        process.kill();
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
