// rotorscope-cli and rotorscope-sim as two programs with a pseudo-terminal between them, and ports behind which there
// is no board, or not any more.
#include "support/places.h"
#include "support/pseudo_terminal.h"

#include <QProcess>
#include <QSocketNotifier>
#include <QTemporaryDir>
#include <QtTest>

class TestTwoPrograms : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCaptureOverTheTerminalHasEveryRow();
    void aBoardThatVanishesIsExitStatus3AndSaysThatTheMotorMayTurn();
    void whatWasRecordedBeforeTheBoardVanishedIsKept();
    void anOlderRecordingIsWorthMoreThanABrokenOne();
    void aPortInUseIsExitStatus3AndNamesTheOther();
    void silenceIsExitStatus3();
    void garbageIsExitStatus3();
};

namespace {

constexpr int kTwoProgramsTime_ms = 30'000;

/// rotorscope-sim with its port at a path of our own.
struct SharedBoard {
    QTemporaryDir folder;
    QProcess process;
    QString port;

    SharedBoard()
        : port(folder.filePath(QStringLiteral("port")))
    {
        process.start(support::programFile(QStringLiteral("rotorscope-sim")),
            {QStringLiteral("mcp"), QStringLiteral("--link"), port});
    }
    bool ready()
    {
        while (!process.canReadLine()) {
            if (!process.waitForReadyRead(kTwoProgramsTime_ms))
                return false;
        }
        return process.readLine().startsWith("ready ");
    }
    ~SharedBoard()
    {
        process.terminate();
        process.waitForFinished(kTwoProgramsTime_ms);
    }
};

/// rotorscope-cli, run by this thread's event loop, so that a board can live there, too.
struct Cli {
    QProcess process;
    QString heard; ///< on standard error

    Cli(const QString &port, const QString &line)
    {
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_LOGGING_RULES"),
            QStringLiteral("link.info=true;cli.progress.info=true"));
        process.setProcessEnvironment(environment);
        process.start(support::programFile(QStringLiteral("rotorscope-cli")),
            QStringList{
                QStringLiteral("--patience"), QStringLiteral("500"), QStringLiteral("--port"), port}
                + line.split(QLatin1Char(' ')));
    }
    bool over() const { return process.state() == QProcess::NotRunning; }
    QString err()
    {
        heard += QString::fromUtf8(process.readAllStandardError());
        return heard;
    }
    bool connected() { return err().contains(QLatin1String("link state 2")); }
    bool recording() { return err().contains(QLatin1String("recording")); }
    /// What is on standard error besides the log.
    QStringList sentences()
    {
        return err().split(QLatin1Char('\n')).filter(QStringLiteral("rotorscope-cli: "));
    }
};

} // namespace

void TestTwoPrograms::aCaptureOverTheTerminalHasEveryRow()
{
    SharedBoard simulator;
    QVERIFY(simulator.ready());
    const QString file = simulator.folder.filePath(QStringLiteral("x.csv"));
    Cli cli(simulator.port,
        QStringLiteral("capture --start --hf I_A --hf-rate 7 --seconds 0.5 -o %1").arg(file));
    QTRY_VERIFY_WITH_TIMEOUT(cli.over(), kTwoProgramsTime_ms);
    // On a busy machine the two may miss each other's bytes; then the status says so, and rows are missing.
    const int status = cli.process.exitCode();
    QVERIFY2(status == 0 || status == 4, qPrintable(cli.err()));
    QFile csv(file);
    QVERIFY(csv.open(QIODevice::ReadOnly));
    const auto rows = csv.readAll().count('\n') - 1;
    QCOMPARE(rows == 1000, status == 0);
    QVERIFY(rows > 100);
}

void TestTwoPrograms::aBoardThatVanishesIsExitStatus3AndSaysThatTheMotorMayTurn()
{
    SharedBoard simulator;
    QVERIFY(simulator.ready());
    const QString file = simulator.folder.filePath(QStringLiteral("x.csv"));
    Cli cli(simulator.port, QStringLiteral("capture --hf I_A --seconds 60 -o %1").arg(file));
    QTRY_VERIFY_WITH_TIMEOUT(cli.connected(), kTwoProgramsTime_ms);
    simulator.process.kill();
    QTRY_VERIFY_WITH_TIMEOUT(cli.over(), kTwoProgramsTime_ms);
    QCOMPARE(cli.process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(cli.process.exitCode(), 3);
    QCOMPARE(cli.sentences().size(), 1);
    QVERIFY2(cli.err().contains(QLatin1String("may still be turning")), qPrintable(cli.err()));
}

void TestTwoPrograms::whatWasRecordedBeforeTheBoardVanishedIsKept()
{
    SharedBoard simulator;
    QVERIFY(simulator.ready());
    const QString file = simulator.folder.filePath(QStringLiteral("x.csv"));
    Cli cli(simulator.port, QStringLiteral("capture --hf I_A --seconds 60 -o %1").arg(file));
    QTRY_VERIFY_WITH_TIMEOUT(cli.recording(), kTwoProgramsTime_ms);
    simulator.process.kill();
    QTRY_VERIFY_WITH_TIMEOUT(cli.over(), kTwoProgramsTime_ms);
    QCOMPARE(cli.process.exitCode(), 3);
    QVERIFY2(cli.err().contains(QLatin1String("until then is in")), qPrintable(cli.err()));
    QFile csv(file);
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readLine(), QByteArray("time [s],I_A [A]\n"));
    QVERIFY(csv.readAll().count('\n') > 0);
}

void TestTwoPrograms::anOlderRecordingIsWorthMoreThanABrokenOne()
{
    SharedBoard simulator;
    QVERIFY(simulator.ready());
    const QString file = simulator.folder.filePath(QStringLiteral("x.csv"));
    QFile older(file);
    QVERIFY(older.open(QIODevice::WriteOnly));
    older.write("of yesterday\n");
    older.close();
    Cli cli(simulator.port, QStringLiteral("capture --hf I_A --seconds 60 -o %1").arg(file));
    QTRY_VERIFY_WITH_TIMEOUT(cli.recording(), kTwoProgramsTime_ms);
    simulator.process.kill();
    QTRY_VERIFY_WITH_TIMEOUT(cli.over(), kTwoProgramsTime_ms);
    QCOMPARE(cli.process.exitCode(), 3);
    QVERIFY(older.open(QIODevice::ReadOnly));
    QCOMPARE(older.readAll(), QByteArray("of yesterday\n"));
}

void TestTwoPrograms::aPortInUseIsExitStatus3AndNamesTheOther()
{
    SharedBoard simulator;
    QVERIFY(simulator.ready());
    const QString file = simulator.folder.filePath(QStringLiteral("x.csv"));
    Cli first(simulator.port,
        QStringLiteral("capture --hf I_A --hf-rate 255 --seconds 60 -o %1").arg(file));
    QTRY_VERIFY_WITH_TIMEOUT(first.connected(), kTwoProgramsTime_ms);
    Cli second(simulator.port, QStringLiteral("info"));
    QTRY_VERIFY_WITH_TIMEOUT(second.over(), kTwoProgramsTime_ms);
    QCOMPARE(second.process.exitCode(), 3);
    QVERIFY2(
        second.err().contains(QLatin1String("rotorscope-cli (pid ")), qPrintable(second.err()));
    QVERIFY(!first.over()); // undisturbed
    first.process.terminate();
    QTRY_VERIFY_WITH_TIMEOUT(first.over(), kTwoProgramsTime_ms);
}

void TestTwoPrograms::silenceIsExitStatus3()
{
    support::PseudoTerminal terminal;
    Cli cli(terminal.path(), QStringLiteral("info"));
    QTRY_VERIFY_WITH_TIMEOUT(cli.over(), kTwoProgramsTime_ms);
    QCOMPARE(cli.process.exitCode(), 3);
    QCOMPARE(cli.sentences().size(), 1);
    QVERIFY2(cli.err().contains(QLatin1String("no board answers")), qPrintable(cli.err()));
}

void TestTwoPrograms::garbageIsExitStatus3()
{
    support::PseudoTerminal terminal;
    QTimer noise;
    noise.callOnTimeout([&terminal] { terminal.write(Bytes(200, 0x55)); });
    noise.start(5);
    Cli cli(terminal.path(), QStringLiteral("info --baud 115200"));
    QTRY_VERIFY_WITH_TIMEOUT(cli.over(), kTwoProgramsTime_ms);
    QCOMPARE(cli.process.exitCode(), 3);
    QCOMPARE(cli.sentences().size(), 1);
    QVERIFY2(cli.err().contains(QLatin1String("make no sense")), qPrintable(cli.err()));
    QVERIFY2(cli.err().contains(QLatin1String("A drive that speaks MCB needs --protocol mcb.")),
        qPrintable(cli.err()));
}

QTEST_GUILESS_MAIN(TestTwoPrograms)
#include "tst_two_programs_posix.moc"
