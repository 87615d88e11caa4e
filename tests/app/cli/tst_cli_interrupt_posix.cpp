// rotorscope-cli when the user presses Ctrl-C or ends it: the motor that it started does not go on.
#include "support/programs/experiment_program_posix.h"

#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>
#include <csignal>

class TestCliInterrupt : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everySignalStopsTheMotorAndLeavesNoFile_data();
    void everySignalStopsTheMotorAndLeavesNoFile();
    void whatWasRecordedUntilThenIsCalledAsLongAsItIs();
    void gainsThatWereNotProvedAreSaidWithTheWayBack();
};

void TestCliInterrupt::everySignalStopsTheMotorAndLeavesNoFile_data()
{
    QTest::addColumn<int>("number");
    QTest::newRow("Ctrl-C") << SIGINT;
    QTest::newRow("kill") << SIGTERM;
    QTest::newRow("closed terminal") << SIGHUP;
}

void TestCliInterrupt::everySignalStopsTheMotorAndLeavesNoFile()
{
    QFETCH(int, number);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    QProcess process;
    process.setProcessEnvironment([] {
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert(
            QStringLiteral("QT_LOGGING_RULES"), QStringLiteral("cli.progress.info=true"));
        return environment;
    }());
    process.start(support::programFile(QStringLiteral("rotorscope-cli")),
        {QStringLiteral("--port"), QStringLiteral("sim"), QStringLiteral("capture"),
            QStringLiteral("--start"), QStringLiteral("--hf"), QStringLiteral("I_A"),
            QStringLiteral("--seconds"), QStringLiteral("60"), QStringLiteral("-o"), file});
    QByteArray err;
    const auto heard = [&](const char *word) {
        err += process.readAllStandardError();
        return err.contains(word);
    };
    QTRY_VERIFY_WITH_TIMEOUT(heard("started"), 20'000);
    ::kill(static_cast<pid_t>(process.processId()), number);
    QTRY_COMPARE_WITH_TIMEOUT(process.state(), QProcess::NotRunning, 10'000);
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 128 + number);
    QVERIFY2(heard("The motor was stopped."), err.constData());
    QVERIFY(!QFile::exists(file));
}

void TestCliInterrupt::whatWasRecordedUntilThenIsCalledAsLongAsItIs()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    const QString recording = folder.filePath(QStringLiteral("x.pcapng"));
    QProcess process;
    process.start(support::programFile(QStringLiteral("rotorscope-cli")),
        {QStringLiteral("--port"), QStringLiteral("sim"), QStringLiteral("--json"),
            QStringLiteral("capture"), QStringLiteral("--hf"), QStringLiteral("I_A"),
            QStringLiteral("--seconds"), QStringLiteral("60"), QStringLiteral("-o"), file,
            QStringLiteral("--record"), recording});
    constexpr qint64 kSomeSamples = 200'000;
    QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(recording).size() > kSomeSamples, 20'000);
    ::kill(static_cast<pid_t>(process.processId()), SIGINT);
    QTRY_COMPARE_WITH_TIMEOUT(process.state(), QProcess::NotRunning, 10'000);
    const QJsonObject told =
        QJsonDocument::fromJson(process.readAllStandardOutput().trimmed()).object();
    QVERIFY(!told[QLatin1String("complete")].toBool(true));
    QCOMPARE(told[QLatin1String("wanted_seconds")].toDouble(), 60.0);
    constexpr double kHfHz = 16000.0;
    const double length_s = told[QLatin1String("rows")].toDouble() / kHfHz;
    QVERIFY(length_s > 0.1);
    QVERIFY2(std::abs(told[QLatin1String("seconds")].toDouble() - length_s) < 0.1,
        QJsonDocument(told).toJson().constData());
}

void TestCliInterrupt::gainsThatWereNotProvedAreSaidWithTheWayBack()
{
    constexpr int kTries = 3; // a machine that stands still ends the response before
    const support::Simulator board({QStringLiteral("--motor"), QStringLiteral("servo24")});
    QVERIFY(board.ready());
    const auto gains = [&] {
        const QStringList lines =
            board.cli("get SPEED_KP SPEED_KI --raw").out.split(QLatin1Char('\n'));
        return QStringLiteral("SPEED_KP=%1 SPEED_KI=%2")
            .arg(lines.value(0).section(QLatin1Char(' '), -1),
                lines.value(1).section(QLatin1Char(' '), -1));
    };
    const QString old = gains();
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(
        QStringLiteral("QT_LOGGING_RULES"), QStringLiteral("cli.progress.info=true"));
    bool written = false;
    QByteArray err;
    support::CoreWait wait(board.processId());
    for (int left = kTries; left > 0 && !written; --left) {
        QProcess process;
        process.setProcessEnvironment(environment);
        support::startCli(process,
            {QStringLiteral("--port"), board.port(), QStringLiteral("autotune"),
                QStringLiteral("--apply"), QStringLiteral("--seconds"), QStringLiteral("6")});
        err.clear();
        const auto writtenOrEnded = [&] {
            wait.look(process.processId());
            written = (err += process.readAllStandardError()).contains("gains written");
            return written || process.state() == QProcess::NotRunning;
        };
        QTRY_VERIFY_WITH_TIMEOUT(writtenOrEnded(), 120'000);
        if (!written)
            continue;
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QTRY_COMPARE_WITH_TIMEOUT(process.state(), QProcess::NotRunning, 10'000);
        QCOMPARE(process.exitCode(), 128 + SIGINT);
        err += process.readAllStandardError();
    }
    if (!written && wait.starved()) { // as it should then
        qWarning("%s", err.constData());
        QVERIFY2(err.contains("The experiment was ended: ") || err.contains("Not conclusive: "),
            err.constData());
        QCOMPARE(gains(), old);
        return;
    }
    QVERIFY2(written, err.constData());
    const QString said =
        QStringLiteral("The gains are now %1; the way back: rotorscope-cli set %2.");
    QVERIFY2(QString::fromUtf8(err).contains(said.arg(gains(), old)), err.constData());
}

QTEST_GUILESS_MAIN(TestCliInterrupt)
#include "tst_cli_interrupt_posix.moc"
