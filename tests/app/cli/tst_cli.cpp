// rotorscope-cli as scripts see it: what it prints, where, and how it ends. The real program, against its own
// simulated board.
#include "support/programs/cli_run.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QtTest>

using support::CliRun;
using support::typed;
using support::wordsOf;

class TestCli : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void wrongUsageIsExitStatus2AndOneLine_data();
    void wrongUsageIsExitStatus2AndOneLine();
    void helpAndVersionAreNoErrors();
    void portsBeginWithTheSimulatedBoard();
    void infoTellsWhatTheBoardIs();
    void getReadsInUnitsAndRaw();
    void setPrintsOldAndNew();
    void whatTheBoardRefusesIsExitStatus1();
    void whatReadsBackAsAnotherValueIsExitStatus1();
    void aStructureOfAnotherLengthIsNotWritten();
    void startTellsTheStateInJson();
    void noConnectionIsExitStatus3();
    void captureWritesExactlyTheTimeAsked();
    void captureIntoNowhereIsExitStatus5AndMovesNothing();
    void captureOfTooMuchSaysSoWithGaps();
    void captureOfLessThanATickIsOneRow();
    void captureTakesSlowSignalsOnceAPacket();
    void captureFromTheStartHoldsTheStartUp();
    void captureThatTheBoardRefusesStartsNoMotor();
    void decodePrintsOneObjectALine();
    void decodeShowsWhatIsEmpty();
    void registersMarksWhatTheBoardDoesNotGive();
    void decodeOfWhatIsNoPacketIsExitStatus5_data();
    void decodeOfWhatIsNoPacketIsExitStatus5();
};

namespace {

QList<QStringList> readCsv(const QString &path)
{
    QFile file(path);
    QList<QStringList> rows;
    if (!file.open(QIODevice::ReadOnly))
        return rows;
    while (!file.atEnd())
        rows.append(QString::fromUtf8(file.readLine()).trimmed().split(QLatin1Char(',')));
    return rows;
}

} // namespace

void TestCli::wrongUsageIsExitStatus2AndOneLine_data()
{
    QTest::addColumn<QString>("line");
    for (const char *line : {"", "fly", "--port", "--port sim", "--colour red info", "info",
             "get STATUS", "--port sim get", "--port sim get NO_SUCH_REGISTER",
             "--port sim get STATUS@9", "--port sim set SPEED_KP", "--port sim set SPEED_KP=1,5",
             "--port sim set SPEED_KP=99999999", "--port sim set SPEED_KP=nan",
             "--port sim set SPEED_KP=1 SPEED_KP@1=2", "--port sim ramp 1000",
             "--port sim ramp fast 100", "--port sim ramp 1000 -1", "--baud 3 --port sim info",
             "--port sim start --motor 2", "--port sim capture -o x.csv --seconds 1",
             "--port sim capture --hf I_A --seconds 1",
             "--port sim capture --hf I_A --seconds -1 -o x.csv",
             "--port sim capture --hf SPEED_MEAS --seconds 1 -o x.csv",
             "--port sim capture --hf I_A --hf-rate 256 --seconds 1 -o x.csv",
             "--port sim capture --hf I_A --mf I_B --mf-rate 255 --seconds 1 -o x.csv",
             "--port sim capture --hf I_A --ramp 1500 --seconds 1 -o x.csv",
             "--port sim capture --hf I_A --seconds 1 -o x.pcapng",
             "--port sim capture --hf I_A --seconds 1 -o x.mat",
             "--port sim capture --hf I_A --seconds 1 --output= --record x.pcapng", "--port= info",
             "decode"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

void TestCli::wrongUsageIsExitStatus2AndOneLine()
{
    QFETCH(QString, line);
    const CliRun result = typed(line);
    COMPARE_STATUS(result, 2);
    QCOMPARE(result.out, QString());
    QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
    QVERIFY2(result.err.startsWith(QLatin1String("rotorscope-cli: ")), qPrintable(result.err));
}

void TestCli::helpAndVersionAreNoErrors()
{
    for (const char *line : {"--help", "capture --help", "get -h", "--version"}) {
        const CliRun result = typed(line);
        COMPARE_STATUS(result, 0);
        QVERIFY(!result.out.isEmpty());
        QCOMPARE(result.err, QString());
    }
    QVERIFY(typed("--help").out.contains(QLatin1String("capture --hf")));
    QVERIFY(typed("set --help").out.contains(QLatin1String("--raw")));
}

void TestCli::portsBeginWithTheSimulatedBoard()
{
    QVERIFY(typed("ports").lines().first().startsWith(QLatin1String("sim ")));
    const QJsonObject first = typed("--json ports").list().first().toObject();
    QCOMPARE(first[QLatin1String("path")].toString(), QStringLiteral("sim"));
    QCOMPARE(first[QLatin1String("kind")].toString(), QStringLiteral("simulator"));
}

void TestCli::infoTellsWhatTheBoardIs()
{
    const CliRun result = typed("--port sim --json info");
    COMPARE_STATUS(result, 0);
    const QJsonObject info = result.object();
    QCOMPARE(info[QLatin1String("control_rate_hz")].toDouble(), 16000.0);
    QCOMPARE(info[QLatin1String("stream_bytes")].toInt(), 2048);
    QVERIFY(!info[QLatin1String("version")].toString().isEmpty());
    QVERIFY(info[QLatin1String("watchdog_ms")].isNull());
    QVERIFY(info.contains(QLatin1String("watchdog_ms")));
    QCOMPARE(info[QLatin1String("motors")]
                 .toArray()
                 .first()
                 .toObject()[QLatin1String("state")]
                 .toString(),
        QStringLiteral("IDLE"));
    QVERIFY(typed("--port sim info").out.contains(QLatin1String("Motor 1: IDLE")));
}

void TestCli::getReadsInUnitsAndRaw()
{
    const CliRun shown = typed("--port sim get STATUS BUS_VOLTAGE I_Q");
    COMPARE_STATUS(shown, 0);
    QCOMPARE(shown.lines().size(), 3);
    QCOMPARE(shown.lines()[0], QStringLiteral("STATUS = IDLE (0)"));
    QVERIFY2(shown.lines()[1].endsWith(QLatin1String(" V")), qPrintable(shown.lines()[1]));
    QVERIFY2(shown.lines()[2].startsWith(QLatin1String("I_Q_MEAS = ")),
        qPrintable(shown.lines()[2])); // by its alias
    QCOMPARE(typed("--port sim get STATUS --raw").lines()[0], QStringLiteral("STATUS = 0"));
    const QJsonObject status = typed("--port sim --json get STATUS@1").list().first().toObject();
    QCOMPARE(status[QLatin1String("value")].toInt(-1), 0);
    QCOMPARE(status[QLatin1String("text")].toString(), QStringLiteral("IDLE"));
}

void TestCli::setPrintsOldAndNew()
{
    const QJsonObject old = typed("--port sim --json get SPEED_KP").list().first().toObject();
    const qint64 value = old[QLatin1String("raw")].toInteger();
    const CliRun result = typed({QStringLiteral("--port"), QStringLiteral("sim"),
        QStringLiteral("set"), QStringLiteral("SPEED_KP=%1").arg(value + 7)});
    COMPARE_STATUS(result, 0);
    QCOMPARE(result.lines(),
        QStringList{QStringLiteral("SPEED_KP: %1 -> %2")
                        .arg(QString::number(value), QString::number(value + 7))});
}

void TestCli::whatTheBoardRefusesIsExitStatus1()
{
    const CliRun readOnly = typed("--port sim set STATUS=1");
    COMPARE_STATUS(readOnly, 1);
    QCOMPARE(readOnly.err.count(QLatin1Char('\n')), 1);
}

void TestCli::whatReadsBackAsAnotherValueIsExitStatus1()
{
    // Firmware answers OK to a mode that it does not have, and keeps the one it is in.
    const CliRun kept = typed("--port sim --json set --expert CONTROL_MODE=9");
    COMPARE_STATUS(kept, 1);
    QCOMPARE(kept.err.count(QLatin1Char('\n')), 1);
    QVERIFY(kept.err.contains(QLatin1String("CONTROL_MODE")));
    const QJsonObject result = kept.list().first().toObject();
    QCOMPARE(result[QLatin1String("outcome")].toString(), QStringLiteral("ok"));
    QCOMPARE(result[QLatin1String("verified")], QJsonValue(false));
    QCOMPARE(result[QLatin1String("new")], result[QLatin1String("old")]);
}

void TestCli::aStructureOfAnotherLengthIsNotWritten()
{
    // Firmware would fill the missing bytes with what lies in its buffer, and ramp to any speed.
    const CliRun result = typed("--port sim set SPEED_RAMP=00 SPEED_KP=5");
    COMPARE_STATUS(result, 1);
    QCOMPARE(result.lines().size(), 1); // of what was not even asked for there is nothing to tell
    QVERIFY2(result.lines()[0].endsWith(QLatin1String("-> 5")), qPrintable(result.out));
    QVERIFY2(
        result.err.contains(QLatin1String("SPEED_RAMP (takes 6 bytes)")), qPrintable(result.err));
}

void TestCli::startTellsTheStateInJson()
{
    const CliRun result = typed("--port sim --json start");
    COMPARE_STATUS(result, 0);
    const QJsonObject state = result.object();
    QVERIFY(!state[QLatin1String("state")].toString().isEmpty());
    QVERIFY(state.contains(QLatin1String("speed_rpm")));
    QVERIFY(!state.contains(QLatin1String("max_speed_rpm"))); // info tells it, and nothing is 0
}

void TestCli::noConnectionIsExitStatus3()
{
    const CliRun result = typed("--port /dev/no-such-port info");
    COMPARE_STATUS(result, 3);
    QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
    QVERIFY2(result.err.contains(QLatin1String("/dev/no-such-port")), qPrintable(result.err));
}

void TestCli::captureWritesExactlyTheTimeAsked()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    const CliRun result = typed(wordsOf("--port sim capture --hf I_B,I_A --hf-rate 3 --mf "
                                        "STOPLL_ROT_SPEED --mf-rate 9 --seconds 0.25 -o")
        << file);
    COMPARE_STATUS(result, 0);
    const auto rows = readCsv(file);
    QCOMPARE(rows.first(),
        (QStringList{QStringLiteral("time [s]"), QStringLiteral("I_B [A]"),
            QStringLiteral("I_A [A]"), QStringLiteral("STOPLL_ROT_SPEED [rpm]")}));
    QCOMPARE(rows.size() - 1, 1000); // 0.25 s at 16 kHz / 4
    QCOMPARE(rows[1][0], QStringLiteral("0"));
    QCOMPARE(rows[2][0], QStringLiteral("0.00025"));
    QCOMPARE(rows.last()[0], QStringLiteral("0.24975"));
}

void TestCli::captureIntoNowhereIsExitStatus5AndMovesNothing()
{
    const CliRun result =
        typed("--port sim capture --start --hf I_A --seconds 1 -o /no/such/folder/x.csv");
    COMPARE_STATUS(result, 5);
    QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
}

void TestCli::captureOfTooMuchSaysSoWithGaps()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    const CliRun result = typed(
        wordsOf("--port sim --baud 230400 capture --hf I_A,I_B,I_Q_MEAS,I_D_MEAS --seconds 0.5 -o")
        << file);
    COMPARE_STATUS(result, 4);
    QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
    const auto rows = readCsv(file);
    QVERIFY(rows.size() > 100);
    QVERIFY(rows.size() < 8001);
}

void TestCli::captureOfLessThanATickIsOneRow()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    const CliRun result =
        typed(wordsOf("--port sim capture --hf I_A --seconds 0.00001 -o") << file);
    COMPARE_STATUS(result, 0);
    QCOMPARE(readCsv(file).size(), 2);
}

void TestCli::captureTakesSlowSignalsOnceAPacket()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    const CliRun result = typed(
        wordsOf("--port sim capture --hf I_A --mf I_B --mf-rate 254 --seconds 0.5 -o") << file);
    COMPARE_STATUS(result, 0);
    const auto rows = readCsv(file);
    QCOMPARE(rows.size(), 8001);
    QCOMPARE(rows[1][2], QString()); // not yet known
    QVERIFY(!rows.last()[2].isEmpty());
}

void TestCli::captureFromTheStartHoldsTheStartUp()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    const CliRun result = typed(wordsOf("--port sim capture --start --from-start --ramp 1500,200 "
                                        "--hf STOPLL_ROT_SPEED,I_Q_REF --hf-rate 15 --seconds 2 -o")
        << file);
    COMPARE_STATUS(result, 0);
    const auto rows = readCsv(file);
    QCOMPARE(rows.size() - 1, 2000);
    QCOMPARE(rows[1][2].toDouble(), 0.0); // no torque is asked for yet
    QVERIFY2(std::abs(rows.last()[1].toDouble() - 1500) < 100, qPrintable(rows.last()[1]));
}

void TestCli::captureThatTheBoardRefusesStartsNoMotor()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("x.csv"));
    // 20 ms of so slow a line hold no group of 254 samples.
    const CliRun result =
        typed(wordsOf("--port sim --baud 115200 capture --start --hf I_A --mf I_B "
                      "--mf-rate 253 --seconds 1 -o")
            << file);
    COMPARE_STATUS(result, 1);
    QVERIFY2(result.err.contains(QLatin1String("--mf-rate")), qPrintable(result.err));
    QVERIFY2(!result.err.contains(QLatin1String("The motor was stopped")), qPrintable(result.err));
    QVERIFY(!QFile::exists(file));
}

namespace {

CliRun decode(const QByteArray &text)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("trace.jsonl"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        return {};
    file.close();
    return typed({QStringLiteral("decode"), path});
}

} // namespace

void TestCli::decodePrintsOneObjectALine()
{
    const CliRun result = decode("{\"transcript\": \"a header\"}\n"
                                 "{\"t_ms\": 1, \"dir\": \"C>P\", \"hex\": \"05 ff ff 0f\"}\n"
                                 "{\"t_ms\": 2, \"dir\": \"--\", \"hex\": \"\"}\n"
                                 "{\"t_ms\": 3, \"dir\": \"P>C\", \"hex\": \"05c701\"}\n");
    COMPARE_STATUS(result, 0);
    QCOMPARE(result.lines().size(), 3);
    QVERIFY(result.lines()[0].contains(QLatin1String("\"type\":\"BEACON\"")));
    QVERIFY(result.lines()[1].contains(QLatin1String("\"type\":\"event\"")));
    QVERIFY(result.lines()[2].contains(QLatin1String("\"type\":\"invalid\"")));
}

/// An empty request has no CRC, also where payloads have one; a packet that a stop sends off may hold no block; a list
/// of no registers is a list.
void TestCli::decodeShowsWhatIsEmpty()
{
    using Lines = std::vector<std::pair<const char *, const char *>>;
    const auto decoded = [](const Lines &lines) {
        QByteArray text;
        for (const auto &[direction, bytes] : lines)
            text += QByteArray("{\"dir\":\"") + direction + "\",\"hex\":\"" + bytes
                + "\",\"t_ms\":0}\n";
        return decode(text).lines();
    };
    const QStringList withCrc = decoded({
        {"C>P", "85c701a4"},
        {"P>C", "85c701a4"},
        {"C>P", "06100020"},
        {"P>C", "361000d0"},
        {"C>P", "09000090"},
        {"P>C", "1a00002000cafe"},
        {"C>P", "290000e01000cafe"},
    });
    QCOMPARE(withCrc.size(), 7);
    QVERIFY(withCrc[4].contains(QLatin1String("\"type\":\"REQUEST\",\"length\":0")));
    QVERIFY(withCrc[6].contains(QLatin1String("\"registers\":[]")));
    const QStringList stopped = decoded({
        {"C>P", "05c70114"},
        {"P>C", "05c70114"},
        {"C>P", "06100020"},
        {"P>C", "361000d0"},
        {"C>P", "f900003008002905090000010000fe01910509"},
        {"P>C", "1a00002000"},
        {"C>P", "d900004008002905070000000000000000"},
        {"P>C", "69000000640000000900"},
        {"P>C", "1a00002000"},
        {"C>P", "290000e01000"},
        {"P>C", "1a00002000"},
    });
    QCOMPARE(stopped.size(), 11);
    QVERIFY2(stopped[7].contains(QLatin1String("\"decoded\":true")), qPrintable(stopped[7]));
    QVERIFY2(stopped[7].contains(QLatin1String("\"hf_blocks\":0")), qPrintable(stopped[7]));
}

void TestCli::registersMarksWhatTheBoardDoesNotGive()
{
    const CliRun result = typed("--port sim registers");
    COMPARE_STATUS(result, 0);
    int marked = 0;
    for (const QString &line : result.lines()) {
        const bool missing = line.contains(QLatin1String("not on this board"));
        marked += missing ? 1 : 0;
        if (line.startsWith(QLatin1String("ENCODER_SPEED ")))
            QVERIFY(missing); // its motor has none
        if (line.startsWith(QLatin1String("I_A ")) || line.startsWith(QLatin1String("SPEED_KP ")))
            QVERIFY(!missing);
    }
    QVERIFY(marked > 10);
    const CliRun asked = typed("--port sim get ENCODER_SPEED");
    QVERIFY2(asked.err.contains(QLatin1String("does not give ENCODER_SPEED; leave it out")),
        qPrintable(asked.err));
}

void TestCli::decodeOfWhatIsNoPacketIsExitStatus5_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("nothing") << QByteArray();
    QTest::newRow("no JSON") << QByteArray("hello\n");
    QTest::newRow("a list") << QByteArray("[1,2]\n");
    QTest::newRow("another direction") << QByteArray("{\"dir\":\"X\",\"hex\":\"05ffff0f\"}\n");
    QTest::newRow("a number") << QByteArray("{\"dir\":\"C>P\",\"hex\":5}\n");
    QTest::newRow("no hex digits") << QByteArray("{\"dir\":\"C>P\",\"hex\":\"zz11\"}\n");
    QTest::newRow("half a byte") << QByteArray("{\"dir\":\"C>P\",\"hex\":\"123\"}\n");
    QTest::newRow("zeros") << QByteArray(3'000'000, '\0');
}

void TestCli::decodeOfWhatIsNoPacketIsExitStatus5()
{
    QFETCH(QByteArray, text);
    const CliRun result = decode(text);
    COMPARE_STATUS(result, 5);
    QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
}

QTEST_GUILESS_MAIN(TestCli)
#include "tst_cli.moc"
