// The program rotorscope itself, without a screen: asked to end by a signal while a motor turns, it stops the motor,
// waits for the evidence and goes; what it cannot open it says at once.
#include "support/places.h"
#include "support/programs/programs_posix.h"

#include <QtTest>

#include <csignal>

class TestWindowSignals : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aSignalStopsTheMotorBeforeTheProgramEnds_data();
    void aSignalStopsTheMotorBeforeTheProgramEnds();
    void theCommandLineTakesOneFile();
};

namespace {

constexpr int kWindowTime_ms = 30'000;

bool says(QProcess &process, const QByteArray &words)
{
    QByteArray heard;
    while (!heard.contains(words)) {
        if (!process.waitForReadyRead(kWindowTime_ms))
            return false;
        heard += process.readAll();
    }
    return true;
}

} // namespace

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
    const support::Simulator board;
    QVERIFY(board.ready());
    const QString idle = board.cli("get STATUS --raw").out;
    QVERIFY(!idle.isEmpty());
    const support::CliRun start = board.cli("start");
    QVERIFY2(start.status == 0, qPrintable(start.err));
    QVERIFY(board.cli("get STATUS --raw").out != idle);

    QProcess window;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("QT_LOGGING_RULES"), QStringLiteral("link.info=true"));
    window.setProcessEnvironment(environment);
    window.setProcessChannelMode(QProcess::MergedChannels);
    window.start(support::programFile(QStringLiteral("rotorscope")),
        {QStringLiteral("--port"), board.port(), QStringLiteral("--connect")});
    QVERIFY(says(window, "stream of ")); // asked for by the window once it knows the board
    QCOMPARE(::kill(static_cast<pid_t>(window.processId()), signal), 0);
    QVERIFY(window.waitForFinished(kWindowTime_ms));
    QCOMPARE(window.exitStatus(), QProcess::NormalExit);
    QCOMPARE(window.exitCode(), 0);
    QCOMPARE(board.cli("get STATUS --raw").out, idle);
}

void TestWindowSignals::theCommandLineTakesOneFile()
{
    QProcess window;
    window.start(support::programFile(QStringLiteral("rotorscope")),
        {QStringLiteral("a.pcapng"), QStringLiteral("b.csv")});
    QVERIFY(window.waitForFinished(kWindowTime_ms));
    QCOMPARE(window.exitCode(), 2);
    const QByteArray told = window.readAllStandardError();
    QVERIFY2(told.contains("\"b.csv\""), told.constData());
}

QTEST_GUILESS_MAIN(TestWindowSignals)
#include "tst_window_signals_posix.moc"
