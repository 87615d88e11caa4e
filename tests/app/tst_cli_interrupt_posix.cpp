// rotorscope-cli when somebody presses Ctrl-C or ends it: the motor that it started does not go on.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>

class TestCliInterrupt : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everySignalStopsTheMotorAndLeavesNoFile_data();
    void everySignalStopsTheMotorAndLeavesNoFile();
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
    process.start(QStringLiteral(ROTORSCOPE_BIN "/rotorscope-cli"),
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

QTEST_GUILESS_MAIN(TestCliInterrupt)
#include "tst_cli_interrupt_posix.moc"
