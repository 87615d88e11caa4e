// The command line as a program: what it is told, and how it ended.
#pragma once

#include "support/places.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

// Runs `result` once. A macro, so that the test ends where it stands, as with QVERIFY.
#define COMPARE_STATUS(result, expected)                                                           \
    do {                                                                                           \
        const auto &comparedRun = (result);                                                        \
        QVERIFY2(comparedRun.status == (expected),                                                 \
            qPrintable(QStringLiteral("status %1, stderr: %2")                                     \
                           .arg(QString::number(comparedRun.status), comparedRun.err)));           \
    } while (false)

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

/// One that still runs has taken too long, and is ended: -1, as one that did not start.
inline CliRun resultOf(QProcess &process)
{
    if (process.state() != QProcess::NotRunning) {
        process.kill();
        process.waitForFinished();
    }
    const bool ended =
        process.error() != QProcess::FailedToStart && process.exitStatus() == QProcess::NormalExit;
    return {ended ? process.exitCode() : -1, QString::fromUtf8(process.readAllStandardOutput()),
        QString::fromUtf8(process.readAllStandardError())};
}

inline CliRun typed(const QStringList &words)
{
    QProcess process;
    process.start(programFile(QStringLiteral("rotorscope-cli")), words);
    process.waitForFinished(kProgramTime_ms);
    return resultOf(process);
}

/// For a line without a word that holds spaces.
inline QStringList wordsOf(const QString &line)
{
    return line.split(QLatin1Char(' '), Qt::SkipEmptyParts);
}
inline QStringList wordsOf(const char *line) { return wordsOf(QString::fromUtf8(line)); }

inline CliRun typed(const QString &line) { return typed(wordsOf(line)); }
inline CliRun typed(const char *line) { return typed(wordsOf(line)); }

} // namespace support
