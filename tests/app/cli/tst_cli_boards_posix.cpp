// rotorscope-cli against boards that are not the usual one: two motors, six-step, HSO, the oldest firmware. Two real
// programs with a pseudo-terminal between them.
#include "support/programs/programs_posix.h"

#include <QElapsedTimer>
#include <QFile>
#include <QtTest>

#include <cmath>

class TestCliBoards : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachOfTwoMotorsIsReached();
    void sixStepTurnsWithoutAScope();
    void hsoReadsAndRecordsInItsUnits();
    void theOldestFirmwareReadsInRpm();
    void aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall();
};

namespace {

constexpr int kLong_ms = 30'000;

class Bench : public support::Simulator {
public:
    using Simulator::Simulator;

    /// FILE stands for csv().
    support::CliRun cli(const char *line) const
    {
        return Simulator::cli(QByteArray(line).replace("FILE", csv().toUtf8()).constData());
    }
    /// With what was said where it does not.
    bool does(const char *line) const
    {
        const support::CliRun run = cli(line);
        if (run.status != 0)
            qWarning().noquote() << line << "ended with" << run.status << run.out << run.err;
        return run.status == 0;
    }
    /// The number of `NAME = NUMBER unit`; `name` may stand for one of several motors.
    double value(const char *name) const
    {
        const support::CliRun answer = cli(QByteArray("get ").append(name).constData());
        return answer.out.section(QLatin1String(" = "), 1)
            .section(QLatin1Char(' '), 0, 0)
            .toDouble();
    }
    /// Polls until `name` stays near `target`; the deadline is that of a start. A start overshoots its speed, so that
    /// one reading proves nothing.
    bool reaches(const char *name, double target, double tolerance = 60.0) const
    {
        QElapsedTimer time;
        time.start();
        int inARow = 0;
        while (inARow < 4 && time.elapsed() < kLong_ms)
            inARow = std::abs(value(name) - target) < tolerance ? inARow + 1 : 0;
        return inARow == 4;
    }
    QString csv() const { return file("x.csv"); }
};

QByteArray firstLine(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readLine().trimmed() : QByteArray();
}

} // namespace

void TestCliBoards::eachOfTwoMotorsIsReached()
{
    Bench bench({QStringLiteral("--motors"), QStringLiteral("2")});
    QVERIFY(bench.ready());
    const support::CliRun info = bench.cli("info");
    QCOMPARE(info.status, 0);
    QVERIFY(info.out.contains(QLatin1String("Motor 1: IDLE")));
    QVERIFY(info.out.contains(QLatin1String("Motor 2: IDLE")));
    QVERIFY(bench.does("set SPEED_KD@2=77"));
    QCOMPARE(bench.value("SPEED_KD@2"), 77.0);
    QVERIFY(bench.value("SPEED_KD@1") != 77.0);
    QCOMPARE(bench.cli("get SPEED_KD@3").status, 2);
    QVERIFY(bench.does("start --motor 2"));
    QVERIFY(bench.reaches("SPEED_MEAS@2", 1500.0));
    QCOMPARE(bench.value("SPEED_MEAS@1"), 0.0);
    const support::CliRun capture = bench.cli("capture --hf I_A@1,I_A@2 --seconds 0.2 -o FILE");
    QVERIFY2(capture.status == 0, qPrintable(capture.err));
    QCOMPARE(firstLine(bench.csv()), QByteArray("time [s],I_A@1 [A],I_A@2 [A]"));
    QVERIFY(bench.does("stop"));
    QCOMPARE(bench.value("SPEED_MEAS@2"), 0.0);
}

void TestCliBoards::sixStepTurnsWithoutAScope()
{
    Bench bench({QStringLiteral("--profile"), QStringLiteral("six-step")});
    QVERIFY(bench.ready());
    QVERIFY(bench.does("start"));
    QVERIFY(bench.reaches("SPEED_MEAS", 1500.0));
    QVERIFY(bench.does("ramp 1800 200"));
    QVERIFY(bench.reaches("SPEED_MEAS", 1800.0));
    QCOMPARE(bench.cli("get I_A").status, 1); // not in this build
    QCOMPARE(bench.cli("capture --hf I_A --seconds 0.2 -o FILE").status, 1);
    QVERIFY(!QFile::exists(bench.csv()));
    QVERIFY(bench.does("stop"));
}

void TestCliBoards::hsoReadsAndRecordsInItsUnits()
{
    Bench bench({QStringLiteral("--profile"), QStringLiteral("hso")});
    QVERIFY(bench.ready());
    QVERIFY(bench.does("start"));
    QVERIFY(bench.reaches("MECHANICAL_SPEED_RPM", 1500.0));
    QVERIFY(bench.reaches("FOC_FELEC_HZ", 100.0, 4.0));
    QVERIFY(bench.does("set FOC_SPEEDREF_FREQ_PU=120"));
    QVERIFY(bench.reaches("MECHANICAL_SPEED_RPM", 1800.0));
    const support::CliRun capture = bench.cli("capture --hf ADC_I_U,FE_HSO --seconds 0.2 -o FILE");
    QVERIFY2(capture.status == 0, qPrintable(capture.err));
    QCOMPARE(firstLine(bench.csv()), QByteArray("time [s],ADC_I_U [A],FE_HSO [Hz]"));
    QVERIFY(bench.does("stop"));
}

void TestCliBoards::theOldestFirmwareReadsInRpm()
{
    Bench bench({QStringLiteral("--profile"), QStringLiteral("mcsdk-6.0")});
    QVERIFY(bench.ready());
    QVERIFY(bench.cli("info").out.contains(QLatin1String("6.0.0")));
    QVERIFY(bench.does("start"));
    QVERIFY(bench.reaches("SPEED_MEAS", 1500.0));
    QVERIFY(bench.reaches("STOPLL_ROT_SPEED", 1500.0));
    QVERIFY(bench.does("stop"));
}

/// Reset by the port's lines, booting, held by a debugger.
void TestCliBoards::aBoardThatIsSilentWhenThePortOpensIsFoundInOneCall()
{
    for (const int silent_ms : {300, 1800, 3300}) {
        Bench bench({QStringLiteral("--control")});
        QVERIFY(bench.ready());
        bench.tell(QByteArray("mute ").append(QByteArray::number(silent_ms)).constData());
        QElapsedTimer time;
        time.start();
        QVERIFY2(bench.does("info"), qPrintable(QString::number(silent_ms)));
        // Else it was found before it was silent. Half of that is for the programs' own start.
        QVERIFY2(time.elapsed() > silent_ms / 2, qPrintable(QString::number(time.elapsed())));
    }
}

QTEST_GUILESS_MAIN(TestCliBoards)
#include "tst_cli_boards_posix.moc"
