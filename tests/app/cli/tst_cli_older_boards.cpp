// The command line with boards of the older serial protocol: the same commands, the protocol found out or named.
#include "support/programs/cli_run.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using support::CliRun;
using support::typed;

class TestCliOlderBoards : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QVERIFY(m_folder.isValid()); }
    void infoSaysWhatWasFoundAndWhy_data();
    void infoSaysWhatWasFoundAndWhy();
    void valuesAreReadAndWritten();
    void theWrongDialectIsNotWrittenTo();
    void withoutExpertModeNothingStarts();
    void captureReadsAsFastAsTheLineGives();
    void stepsOfTheSpeedAreEvaluatedFromWhatWasRead();
    void currentsAreInAmpereByAScaleOfOnesOwn();
    void mechanicsNeedTheTorqueOfAnAmpere();
    void anUnknownProtocolIsWrongUsage();
    void anUnknownSimulatedBoardIsNoPort();

private:
    QTemporaryDir m_folder;
};

void TestCliOlderBoards::infoSaysWhatWasFoundAndWhy_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("protocol");
    QTest::newRow("found out") << QStringLiteral("--port sim:legacy info")
                               << QStringLiteral("MCP legacy");
    QTest::newRow("named") << QStringLiteral("--port sim:legacy --protocol legacy info")
                           << QStringLiteral("MCP legacy");
    QTest::newRow("powerpc") << QStringLiteral("--port sim:powerpc --protocol auto info")
                             << QStringLiteral("MCP PowerPC");
    QTest::newRow("the newer one")
        << QStringLiteral("--port sim --protocol mcp info") << QStringLiteral("MCP over ASPEP");
}

void TestCliOlderBoards::infoSaysWhatWasFoundAndWhy()
{
    QFETCH(QString, line);
    QFETCH(QString, protocol);
    const CliRun result = typed(line);
    QCOMPARE(result.status, 0);
    QVERIFY2(result.out.contains(protocol), qPrintable(result.out));
    QCOMPARE(
        result.out.contains(QLatin1String("Found by")), !line.contains(QLatin1String(" mcp ")));
    QVERIFY(result.out.contains(QLatin1String("Motor 1: IDLE")));
}

void TestCliOlderBoards::valuesAreReadAndWritten()
{
    const CliRun set =
        typed(QStringLiteral("--port sim:legacy --protocol legacy set SPEED_KP=1234"));
    QCOMPARE(set.status, 0);
    QVERIFY(set.out.contains(QLatin1String("1234")));
    const CliRun get = typed(
        QStringLiteral("--port sim:powerpc --protocol powerpc --json get CONTROL_MODE I_Q_KP"));
    QCOMPARE(get.status, 0);
    QCOMPARE(get.list().size(), 2);
    const QJsonObject mode = get.list().at(0).toObject(); // raw is what the wire has
    QCOMPARE(mode[QLatin1String("raw")].toInt(-1), 1);
    QCOMPARE(mode[QLatin1String("text")].toString(), QStringLiteral("speed"));
    const QString board = QStringLiteral("--port sim:legacy --protocol legacy ");
    QCOMPARE(typed(board + QStringLiteral("get --raw CONTROL_MODE")).out,
        QStringLiteral("CONTROL_MODE = 1\n"));
    const CliRun divisor = typed(board + QStringLiteral("get --raw SPEED_KP_DIV"));
    const int digits = divisor.out.section(QLatin1String("= "), 1).trimmed().toInt();
    const CliRun exponent = typed(board + QStringLiteral("get SPEED_KP_DIV"));
    QCOMPARE(digits, 1 << exponent.out.section(QLatin1String("= "), 1).trimmed().toInt());
    QCOMPARE(typed(board + QStringLiteral("set --raw CONTROL_MODE=3")).status, 2);
    QCOMPARE(typed(board + QStringLiteral("set --raw CONTROL_MODE=0")).status, 0);
    QVERIFY(typed(QStringLiteral("--port sim:legacy --protocol legacy set SPEED_KP=40000")).status
        != 0);
}

void TestCliOlderBoards::theWrongDialectIsNotWrittenTo()
{
    const CliRun result =
        typed(QStringLiteral("--port sim:powerpc --protocol legacy set SPEED_KP=1234"));
    QVERIFY(result.status != 0);
    QVERIFY(typed(QStringLiteral("--port sim:powerpc --protocol legacy info"))
                .out.contains(QLatin1String("read-only")));
}

void TestCliOlderBoards::withoutExpertModeNothingStarts()
{
    const CliRun refused = typed(QStringLiteral("--port sim:legacy --protocol legacy start"));
    QCOMPARE(refused.status, 1);
    QVERIFY2(refused.err.contains(QLatin1String("expert mode")), qPrintable(refused.err));
    QVERIFY2(refused.err.contains(QLatin1String("--expert")), qPrintable(refused.err));
    QCOMPARE(
        typed(QStringLiteral("--port sim:legacy --protocol legacy start --expert --max-rpm 3000"))
            .status,
        0);
}

void TestCliOlderBoards::captureReadsAsFastAsTheLineGives()
{
    const QString file = m_folder.filePath(QStringLiteral("polled.csv"));
    const CliRun result =
        typed(QStringLiteral(
                  "--port sim:legacy --protocol legacy --json capture --hf SPEED_MEAS,I_Q_MEAS "
                  "--seconds 0.5 -o ")
            + file);
    QVERIFY2(result.status == 0, qPrintable(result.err));
    QVERIFY(result.object()[QLatin1String("values_per_second")].toDouble() > 20.0);
    QFile csv(file);
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QVERIFY(csv.readLine().startsWith("time [s],SPEED_MEAS [rpm],I_Q_MEAS"));
    QVERIFY(!csv.readLine().isEmpty());
    const CliRun recorded = typed(
        QStringLiteral("--port sim:legacy --protocol legacy capture --hf SPEED_MEAS --seconds "
                       "0.5 --record ")
        + m_folder.filePath(QStringLiteral("polled.pcapng")));
    QVERIFY2(recorded.status == 0, qPrintable(recorded.err));
    QVERIFY2(recorded.out.contains(QLatin1String("each signal read")), qPrintable(recorded.out));
}

/// Whether they are conclusive depends on how often this computer has time to read.
void TestCliOlderBoards::stepsOfTheSpeedAreEvaluatedFromWhatWasRead()
{
    const QString file = m_folder.filePath(QStringLiteral("steps.pcapng"));
    const CliRun run =
        typed(QStringLiteral("--port sim:legacy --protocol legacy --json step speed --from 1500 "
                             "--to 1650 --repeat 1 --expert --max-rpm 3000 -o ")
            + file);
    QVERIFY2(run.status == 0 || run.status == 1, qPrintable(run.err));
    QVERIFY2(run.object()[QLatin1String("runs")].toArray().size() == 2, qPrintable(run.out));
    QVERIFY2(run.err.contains(QLatin1String("The board records nothing")), qPrintable(run.err));
    const CliRun later = typed(QStringLiteral("--json evaluate ") + file);
    QCOMPARE(later.status, run.status);
    QCOMPARE(later.out, run.out);
}

void TestCliOlderBoards::currentsAreInAmpereByAScaleOfOnesOwn()
{
    // The simulated board's shunt, amplifier and converter make 60.175 A of 32768 digits.
    const QString board = QStringLiteral("--port sim:legacy --protocol legacy --json ");
    const QString scale = QStringLiteral(" --full-scale-current 60.175");
    const auto first = [](const CliRun &result) { return result.list().at(0).toObject(); };
    const CliRun plain = typed(board + QStringLiteral("get I_Q_REF"));
    QCOMPARE(plain.status, 0);
    QVERIFY(first(plain)[QLatin1String("unit")] != QLatin1String("A"));
    const CliRun amps = typed(board + QStringLiteral("get I_Q_REF") + scale);
    QVERIFY2(amps.status == 0, qPrintable(amps.err));
    QCOMPARE(first(amps)[QLatin1String("unit")].toString(), QStringLiteral("A"));

    const QString torque = QStringLiteral("torque 0.5 100 --expert --max-rpm 3000 --max-amps 2");
    const CliRun refused = typed(board + torque);
    QVERIFY(refused.status != 0);
    QVERIFY2(refused.err.contains(QLatin1String("current scale")), qPrintable(refused.err));
    QCOMPARE(typed(board + torque + scale).status, 0);

    const CliRun told = typed(QStringLiteral("--port sim --protocol mcp get I_Q_REF") + scale);
    QCOMPARE(told.status, 1); // never instead of what the board says
    QVERIFY2(told.err.contains(QLatin1String("tells its current scale")), qPrintable(told.err));
    for (const char *wrong : {"0", "-60", "60,175", "1e9"})
        QVERIFY2(typed(board + QStringLiteral("get I_Q_REF --full-scale-current ")
                     + QLatin1String(wrong))
                     .status
                != 0,
            wrong);
}

/// What it measures is for tests on virtual time.
void TestCliOlderBoards::mechanicsNeedTheTorqueOfAnAmpere()
{
    const QString legacy =
        QStringLiteral("--port sim:legacy --protocol legacy identify %1 --expert --max-rpm 3000");
    const auto ends = [](const QString &line, int status, const char *words) {
        const CliRun run = typed(line);
        return run.status == status && run.err.contains(QLatin1String(words));
    };
    const QString mechanical = legacy.arg(QStringLiteral("mechanical"));
    QVERIFY(ends(mechanical, 1, "its current in A"));
    QVERIFY(ends(mechanical + QStringLiteral(" --full-scale-current 60.175"), 1,
        "give it with --torque-constant"));
    QVERIFY(ends(mechanical + QStringLiteral(" --torque-constant 0"), 2, "above 0"));
    const QString electrical = legacy.arg(QStringLiteral("electrical"));
    QVERIFY(ends(electrical, 1, "Nothing can be measured"));
    QVERIFY(ends(electrical + QStringLiteral(" --torque-constant 0.05"), 2, "identify mechanical"));
    QVERIFY(ends(QStringLiteral("--port sim identify mechanical --torque-constant 0.05"), 1,
        "tells its torque constant itself"));
}

void TestCliOlderBoards::anUnknownProtocolIsWrongUsage()
{
    const CliRun result = typed(QStringLiteral("--port sim --protocol quantum info"));
    QCOMPARE(result.status, 2);
    QVERIFY(result.err.contains(QLatin1String("powerpc")));
}

void TestCliOlderBoards::anUnknownSimulatedBoardIsNoPort()
{
    const CliRun result = typed(QStringLiteral("--port sim:mcsdk-6.4 info"));
    QCOMPARE(result.status, 3);
    QVERIFY2(result.err.contains(QLatin1String("no port sim:mcsdk-6.4"))
            && result.err.contains(QLatin1String("sim:mcb")),
        qPrintable(result.err));
}

QTEST_GUILESS_MAIN(TestCliOlderBoards)
#include "tst_cli_older_boards.moc"
