// rotorscope-cli against boards that are not the usual one: two motors, six-step, HSO, the oldest firmware. Two real
// programs with a pseudo-terminal between them.
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <cmath>

class TestCliBoards : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachOfTwoMotorsIsReached();
    void sixStepTurnsWithoutAScope();
    void hsoReadsAndRecordsInItsUnits();
    void theOldestFirmwareReadsInRpm();
};

namespace {

constexpr int kLong_ms = 30'000;

struct Answer {
    int status = -1;
    QString out, err;
};

/// rotorscope-sim with its port at a path of our own.
class Bench {
public:
    explicit Bench(const QStringList &options)
        : m_port(m_folder.filePath(QStringLiteral("port")))
    {
        m_simulator.start(QStringLiteral(ROTORSCOPE_BIN "/rotorscope-sim"),
            QStringList{QStringLiteral("mcp"), QStringLiteral("--link"), m_port} + options);
    }
    ~Bench()
    {
        m_simulator.terminate();
        m_simulator.waitForFinished(kLong_ms);
    }
    bool ready()
    {
        while (!m_simulator.canReadLine()) {
            if (!m_simulator.waitForReadyRead(kLong_ms))
                return false;
        }
        return m_simulator.readLine().startsWith("ready ");
    }
    Answer cli(const char *line)
    {
        QProcess process;
        QStringList words{QStringLiteral("--port"), m_port};
        words += QString::fromLatin1(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
        words.replaceInStrings(QStringLiteral("FILE"), csv());
        process.start(QStringLiteral(ROTORSCOPE_BIN "/rotorscope-cli"), words);
        if (!process.waitForFinished(kLong_ms))
            process.kill();
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
            QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
    }
    /// The number of `NAME = NUMBER unit`; `name` may stand for one of several motors.
    double value(const char *name)
    {
        const Answer answer = cli(QByteArray("get ").append(name).constData());
        return answer.out.section(QLatin1String(" = "), 1)
            .section(QLatin1Char(' '), 0, 0)
            .toDouble();
    }
    /// Polls until `name` stays near `target`; the deadline is that of a start. A start overshoots its speed, so that one
    /// reading proves nothing.
    bool reaches(const char *name, double target, double tolerance = 60.0)
    {
        QElapsedTimer time;
        time.start();
        int inARow = 0;
        while (inARow < 4 && time.elapsed() < kLong_ms)
            inARow = std::abs(value(name) - target) < tolerance ? inARow + 1 : 0;
        return inARow == 4;
    }
    QString csv() const { return m_folder.filePath(QStringLiteral("x.csv")); }

private:
    QTemporaryDir m_folder;
    QProcess m_simulator;
    QString m_port;
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
    const Answer info = bench.cli("info");
    QCOMPARE(info.status, 0);
    QVERIFY(info.out.contains(QLatin1String("Motor 1: IDLE")));
    QVERIFY(info.out.contains(QLatin1String("Motor 2: IDLE")));
    QCOMPARE(bench.cli("set SPEED_KD@2=77").status, 0);
    QCOMPARE(bench.value("SPEED_KD@2"), 77.0);
    QVERIFY(bench.value("SPEED_KD@1") != 77.0);
    QCOMPARE(bench.cli("get SPEED_KD@3").status, 2);
    QCOMPARE(bench.cli("start --motor 2").status, 0);
    QVERIFY(bench.reaches("SPEED_MEAS@2", 1500.0));
    QCOMPARE(bench.value("SPEED_MEAS@1"), 0.0);
    const Answer capture = bench.cli("capture --hf I_A@1,I_A@2 --seconds 0.2 -o FILE");
    QVERIFY2(capture.status == 0, qPrintable(capture.err));
    QCOMPARE(firstLine(bench.csv()), QByteArray("time [s],I_A@1 [A],I_A@2 [A]"));
    QCOMPARE(bench.cli("stop").status, 0);
    QCOMPARE(bench.value("SPEED_MEAS@2"), 0.0);
}

void TestCliBoards::sixStepTurnsWithoutAScope()
{
    Bench bench({QStringLiteral("--profile"), QStringLiteral("six-step")});
    QVERIFY(bench.ready());
    QCOMPARE(bench.cli("start").status, 0);
    QVERIFY(bench.reaches("SPEED_MEAS", 1500.0));
    QCOMPARE(bench.cli("ramp 1800 200").status, 0);
    QVERIFY(bench.reaches("SPEED_MEAS", 1800.0));
    QCOMPARE(bench.cli("get I_A").status, 1); // not in this build
    QCOMPARE(bench.cli("capture --hf I_A --seconds 0.2 -o FILE").status, 1);
    QVERIFY(!QFile::exists(bench.csv()));
    QCOMPARE(bench.cli("stop").status, 0);
}

void TestCliBoards::hsoReadsAndRecordsInItsUnits()
{
    Bench bench({QStringLiteral("--profile"), QStringLiteral("hso")});
    QVERIFY(bench.ready());
    QCOMPARE(bench.cli("start").status, 0);
    QVERIFY(bench.reaches("MECHANICAL_SPEED_RPM", 1500.0));
    QVERIFY(bench.reaches("FOC_FELEC_HZ", 100.0, 4.0));
    QCOMPARE(bench.cli("set FOC_SPEEDREF_FREQ_PU=120").status, 0);
    QVERIFY(bench.reaches("MECHANICAL_SPEED_RPM", 1800.0));
    const Answer capture = bench.cli("capture --hf ADC_I_U,FE_HSO --seconds 0.2 -o FILE");
    QVERIFY2(capture.status == 0, qPrintable(capture.err));
    QCOMPARE(firstLine(bench.csv()), QByteArray("time [s],ADC_I_U [A],FE_HSO [Hz]"));
    QCOMPARE(bench.cli("stop").status, 0);
}

void TestCliBoards::theOldestFirmwareReadsInRpm()
{
    Bench bench({QStringLiteral("--profile"), QStringLiteral("mcsdk-6.0")});
    QVERIFY(bench.ready());
    QVERIFY(bench.cli("info").out.contains(QLatin1String("6.0.0")));
    QCOMPARE(bench.cli("start").status, 0);
    QVERIFY(bench.reaches("SPEED_MEAS", 1500.0));
    QVERIFY(bench.reaches("STOPLL_ROT_SPEED", 1500.0));
    QCOMPARE(bench.cli("stop").status, 0);
}

QTEST_GUILESS_MAIN(TestCliBoards)
#include "tst_cli_boards_posix.moc"
