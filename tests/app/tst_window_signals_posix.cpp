// The program rotorscope itself, without a screen: asked to end by a signal while a motor turns, it stops the motor,
// waits for the evidence and goes.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>

class TestWindowSignals : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSignalStopsTheMotorBeforeTheProgramEnds_data();
    void aSignalStopsTheMotorBeforeTheProgramEnds();

private:
    /// Runs rotorscope-cli to its end and returns what it printed.
    QByteArray command(const QStringList &words);

    QString m_port;
};

namespace {

constexpr int kLong_ms = 30'000;

QString program(const char *name)
{
    return QStringLiteral(ROTORSCOPE_BIN "/") + QLatin1String(name);
}

bool says(QProcess &process, const QByteArray &words)
{
    QByteArray heard;
    while (!heard.contains(words)) {
        if (!process.waitForReadyRead(kLong_ms))
            return false;
        heard += process.readAll();
    }
    return true;
}

} // namespace

QByteArray TestWindowSignals::command(const QStringList &words)
{
    QProcess cli;
    cli.start(program("rotorscope-cli"), QStringList{QStringLiteral("--port"), m_port} + words);
    return cli.waitForFinished(kLong_ms) ? cli.readAllStandardOutput() : QByteArray();
}

void TestWindowSignals::aSignalStopsTheMotorBeforeTheProgramEnds_data()
{
    QTest::addColumn<int>("signal");
    QTest::newRow("terminate") << SIGTERM;
    QTest::newRow("interrupt") << SIGINT;
    QTest::newRow("hang up") << SIGHUP;
}

void TestWindowSignals::aSignalStopsTheMotorBeforeTheProgramEnds()
{
    QFETCH(const int, signal);
    QTemporaryDir folder;
    m_port = folder.filePath(QStringLiteral("port"));
    QProcess board;
    board.start(
        program("rotorscope-sim"), {QStringLiteral("mcp"), QStringLiteral("--link"), m_port});
    QVERIFY(says(board, "ready "));
    const QStringList status{
        QStringLiteral("get"), QStringLiteral("STATUS"), QStringLiteral("--raw")};
    const QByteArray idle = command(status);
    QVERIFY(!idle.isEmpty());
    command({QStringLiteral("start")});
    QVERIFY(command(status) != idle);

    QProcess window;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_LOGGING_RULES"), QStringLiteral("link.info=true"));
    window.setProcessEnvironment(environment);
    window.setProcessChannelMode(QProcess::MergedChannels);
    window.start(
        program("rotorscope"), {QStringLiteral("--port"), m_port, QStringLiteral("--connect")});
    QVERIFY(says(window, "stream of ")); // asked for by the window once it knows the board
    QCOMPARE(::kill(static_cast<pid_t>(window.processId()), signal), 0);
    QVERIFY(window.waitForFinished(kLong_ms));
    QCOMPARE(window.exitStatus(), QProcess::NormalExit);
    QCOMPARE(window.exitCode(), 0);
    QCOMPARE(command(status), idle);
    board.terminate();
    QVERIFY(board.waitForFinished(kLong_ms));
}

QTEST_GUILESS_MAIN(TestWindowSignals)
#include "tst_window_signals_posix.moc"
