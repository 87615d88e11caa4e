// rotorscope-cli when somebody presses Ctrl-C or ends it: the motor that it started does not go on.
#include "support/places.h"

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

QTEST_GUILESS_MAIN(TestCliInterrupt)
#include "tst_cli_interrupt_posix.moc"
