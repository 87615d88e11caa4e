// Snapshot, diff and restore of the command line, against a simulated board that outlives each run: what was saved
// comes back, and a cable that is pulled in between leaves no doubt about what was written.
#include "support/board_on_terminal.h"
#include "support/programs/programs_posix.h"

#include <QtTest>

#include <cmath>

using support::CliRun;
using support::runCli;
using support::Simulator;

class TestCliTuning : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twentyChangedRegistersAreFoundAndRestored();
    void aSnapshotOfTheSameStateIsTheSameFile();
    void onlyTheGroupThatWasNamedIsRestored();
    void whatMovesAMotorIsNotRestored();
    void anUnplugInTheMiddleTellsExactlyWhatWasWritten();
    void otherHardwareIsRefusedUnlessForced();
    void gainsAreTheGeneratorsAndAreAppliedTogether();
    void theSpeedLoopNeedsAnInertia();
    void revUpStagesComeBackFromTheirFile();
    void revUpBeyondALimitIsNotWritten();
    void aRevUpOfJustTheLimitIsWritten();
    void aRefusedRevUpSaysWhatIsTooMuch_data();
    void aRefusedRevUpSaysWhatIsTooMuch();
    void torqueIsBoundedLikeACommand();
    void theHeaderHasTheNamesOfTheSdk();
    void filesThatAreNoneAreExitStatus5_data();
    void filesThatAreNoneAreExitStatus5();
    void wrongUsageIsExitStatus2_data();
    void wrongUsageIsExitStatus2();
};

namespace {

const QStringList kTwenty = QStringLiteral("SPEED_KP SPEED_KI SPEED_KD I_Q_KP I_Q_KI I_Q_KD I_D_KP "
                                           "I_D_KI I_D_KD STOPLL_C1 STOPLL_C2 STOPLL_KI STOPLL_KP "
                                           "SPEED_KP_DIV SPEED_KI_DIV I_D_KP_DIV I_D_KI_DIV "
                                           "I_Q_KP_DIV I_Q_KI_DIV STOPLL_KP_DIV")
                                .split(QLatin1Char(' '));

// A register that a build lacks costs two round trips, one that it has a few bytes: with nearly everything built in, a
// look at the whole board takes half the time, and twice as many registers are compared and restored.
const QStringList kComplete{QStringLiteral("--with"),
    QStringLiteral("cordic,hall,flux-weakening,feed-forward,open-loop,profiler,cpu-load,dac,pfc,"
                   "ipd,current-monitor,zest,potentiometer")};

/// NAME=its value + 1 for each, as one SET would get them.
QStringList changedBy1(const QJsonArray &values)
{
    QStringList words;
    for (const QJsonValue &value : values)
        words.append(QStringLiteral("%1=%2").arg(value[QLatin1String("name")].toString(),
            QString::number(value[QLatin1String("raw")].toInteger() + 1)));
    return words;
}

QStringList namesOf(const QJsonArray &list, const char *outcome = nullptr)
{
    QStringList names;
    for (const QJsonValue &one : list)
        if (outcome == nullptr
            || one[QLatin1String("outcome")].toString() == QLatin1String(outcome))
            names.append(one[QLatin1String("name")].toString());
    return names;
}

} // namespace

void TestCliTuning::twentyChangedRegistersAreFoundAndRestored()
{
    const Simulator board(kComplete);
    QVERIFY(board.ready());
    const QString file = board.file("s.json");
    COMPARE_STATUS(board.cli("snapshot -o", {file}), 0);
    QCOMPARE(
        board.cli("--json diff", {file, QStringLiteral("device")}).out, QStringLiteral("[]\n"));

    const QJsonArray old = board.cli("--json get", kTwenty).list();
    COMPARE_STATUS(board.cli("set --raw", changedBy1(old)), 0);
    const QJsonArray found = board.cli("--json diff", {file, QStringLiteral("device")}).list();
    QStringList names = namesOf(found), wanted = kTwenty;
    names.sort();
    wanted.sort();
    QCOMPARE(names, wanted);
    for (const QJsonValue &one : found)
        QCOMPARE(
            one[QLatin1String("b_raw")].toInteger(), one[QLatin1String("a_raw")].toInteger() + 1);
    QCOMPARE(board.cli("diff", {file, QStringLiteral("device")}).lines().size(), 20);

    const CliRun restored = board.cli("--json restore", {file});
    COMPARE_STATUS(restored, 0);
    QCOMPARE(restored.list().size(), 20);
    for (const QJsonValue &one : restored.list())
        QVERIFY(one[QLatin1String("verified")].toBool());
    QCOMPARE(
        board.cli("--json diff", {file, QStringLiteral("device")}).out, QStringLiteral("[]\n"));
    QCOMPARE(board.cli("--json restore", {file}).out, QStringLiteral("[]\n"));
    QCOMPARE(board.cli("--json get", kTwenty).list(), old);
}

void TestCliTuning::aSnapshotOfTheSameStateIsTheSameFile()
{
    const Simulator board(kComplete);
    QVERIFY(board.ready());
    const CliRun saved = board.cli("--json snapshot -o", {board.file("a.json")});
    COMPARE_STATUS(saved, 0);
    QVERIFY(saved.object()[QLatin1String("tunable")].toInt() >= 20);
    QVERIFY(saved.object()[QLatin1String("registers")].toInt()
        > saved.object()[QLatin1String("tunable")].toInt());
    COMPARE_STATUS(board.cli("set SPEED_KP=77"), 0);
    COMPARE_STATUS(board.cli("snapshot -o", {board.file("b.json")}), 0);
    // Two files need no board.
    const CliRun diff = runCli({QStringLiteral("diff"), QStringLiteral("--json"),
        board.file("a.json"), board.file("b.json")});
    COMPARE_STATUS(diff, 0);
    QCOMPARE(namesOf(diff.list()), QStringList{QStringLiteral("SPEED_KP")});
    COMPARE_STATUS(board.cli("restore", {board.file("a.json")}), 0);
    COMPARE_STATUS(board.cli("snapshot -o", {board.file("b.json")}), 0);
    QFile a(board.file("a.json")), b(board.file("b.json"));
    QVERIFY(a.open(QIODevice::ReadOnly) && b.open(QIODevice::ReadOnly));
    // Measured currents are never twice the same; what is tunable is.
    const auto tunable = [](QFile &file) {
        QByteArrayList lines = file.readAll().split('\n');
        lines.removeIf([](const QByteArray &line) { return line.contains("\"tunable\":false"); });
        return lines;
    };
    QCOMPARE(tunable(a), tunable(b));
}

void TestCliTuning::onlyTheGroupThatWasNamedIsRestored()
{
    const Simulator board(kComplete);
    QVERIFY(board.ready());
    const QString file = board.file("s.json");
    COMPARE_STATUS(board.cli("snapshot -o", {file}), 0);
    COMPARE_STATUS(board.cli("set SPEED_KP=5 SPEED_KI=6 I_Q_KP=7 I_D_KP=8"), 0);
    COMPARE_STATUS(board.cli("restore --only", {QStringLiteral("speed loop,I_D_KP"), file}), 0);
    QCOMPARE(namesOf(board.cli("--json diff", {file, QStringLiteral("device")}).list()),
        QStringList{QStringLiteral("I_Q_KP")});
}

void TestCliTuning::whatMovesAMotorIsNotRestored()
{
    const Simulator board;
    QVERIFY(board.ready());
    const QString file = board.file("s.json");
    COMPARE_STATUS(board.cli("snapshot -o", {file}), 0);
    COMPARE_STATUS(board.cli("start"), 0);
    COMPARE_STATUS(board.cli("set SPEED_KD=5"), 0);
    COMPARE_STATUS(board.cli("ramp 1200 10"), 0);
    const CliRun restored = board.cli("--json restore", {file});
    COMPARE_STATUS(restored, 0);
    QCOMPARE(namesOf(restored.list()), QStringList{QStringLiteral("SPEED_KD")});
    COMPARE_STATUS(board.cli("stop"), 0);
    const CliRun told = board.cli("restore", {file}); // at rest neither, and it is named
    COMPARE_STATUS(told, 0);
    const auto at = told.out.indexOf(QLatin1String("Not restored, because it moves a motor:"));
    QVERIFY2(at >= 0 && told.out.indexOf(QLatin1String("SPEED_RAMP")) > at, qPrintable(told.out));
}

void TestCliTuning::anUnplugInTheMiddleTellsExactlyWhatWasWritten()
{
    simulation::BoardOptions options;
    options.rxMax = 32; // seven registers a request
    support::BoardOnTerminal board(options);
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("s.json"));
    const auto cli = [&](const QStringList &words) {
        return support::runCliBeside(
            QStringList{QStringLiteral("--json"), QStringLiteral("--port"), board.path()} + words);
    };
    const QStringList save{QStringLiteral("snapshot"), QStringLiteral("-o"), file};
    COMPARE_STATUS(cli(save), 0);
    const QJsonArray old = cli(QStringList{QStringLiteral("get")} + kTwenty).list();
    const QStringList set{QStringLiteral("set"), QStringLiteral("--raw")};
    COMPARE_STATUS(cli(set + changedBy1(old)), 0);

    // The cable goes while the board answers the second SET, which begins with I_D_KI.
    const Bytes second{0x08, 0x00, 0xD1, 0x02};
    Bytes heard;
    board.onHeard = [&](const Bytes &bytes) {
        heard.insert(heard.end(), bytes.begin(), bytes.end());
        if (std::search(heard.begin(), heard.end(), second.begin(), second.end()) != heard.end())
            board.unplugInTheMiddle();
    };
    const CliRun broken = cli({QStringLiteral("restore"), file});
    QVERIFY(board.unplugged());
    COMPARE_STATUS(broken, 3);
    QVERIFY(broken.oneLineOfError());
    QVERIFY2(broken.err.contains(
                 QLatin1String("of 20 registers 7 were written, 7 may have been, 6 were not")),
        qPrintable(broken.err));
    const QStringList written = namesOf(broken.list(), "ok");
    const QStringList open = namesOf(broken.list(), "unknown");
    const QStringList waiting = namesOf(broken.list(), "not sent");
    QCOMPARE(written.size(), 7);
    QCOMPARE(open.size(), 7);
    QCOMPARE(waiting.size(), 6);

    board.onHeard = nullptr;
    board.plugIn();
    const QStringList differ =
        namesOf(cli({QStringLiteral("diff"), file, QStringLiteral("device")}).list());
    for (const QString &name : written)
        QVERIFY2(!differ.contains(name), qPrintable(name));
    for (const QString &name : waiting)
        QVERIFY2(differ.contains(name), qPrintable(name));
    const QStringList restore{QStringLiteral("restore"), file};
    COMPARE_STATUS(cli(restore), 0);
    const CliRun same = cli({QStringLiteral("diff"), file, QStringLiteral("device")});
    QCOMPARE(same.list(), QJsonArray());
}

void TestCliTuning::otherHardwareIsRefusedUnlessForced()
{
    const Simulator board(kComplete);
    QVERIFY(board.ready());
    const QString file = board.file("s.json");
    COMPARE_STATUS(board.cli("snapshot -o", {file}), 0);
    QFile edited(file);
    QVERIFY(edited.open(QIODevice::ReadOnly));
    const QByteArray text = edited.readAll();
    edited.close();
    QVERIFY(text.contains("Sim PMSM 24V"));
    QVERIFY(edited.open(QIODevice::WriteOnly));
    edited.write(QByteArray(text).replace("Sim PMSM 24V", "Another one"));
    edited.close();
    COMPARE_STATUS(board.cli("set SPEED_KP=5"), 0);
    const CliRun refused = board.cli("restore", {file});
    COMPARE_STATUS(refused, 1);
    QVERIFY(refused.oneLineOfError() && refused.err.contains(QLatin1String("Another one")));
    QCOMPARE(board.cli("get SPEED_KP").out, QStringLiteral("SPEED_KP = 5\n"));
    COMPARE_STATUS(board.cli("restore --force", {file}), 0);
}

void TestCliTuning::gainsAreTheGeneratorsAndAreAppliedTogether()
{
    const Simulator board;
    QVERIFY(board.ready());
    const CliRun shown = board.cli("--json gains --bandwidth 1500");
    COMPARE_STATUS(shown, 0);
    const QJsonArray gains = shown.object()[QLatin1String("gains")].toArray();
    QCOMPARE(namesOf(gains).join(QLatin1Char(' ')), QStringLiteral("I_Q_KP I_Q_KI I_D_KP I_D_KI"));
    // 0.35 Ohm, 0.6 mH, 24 V, 60.2 A: the worked example of the SDK's documentation.
    QCOMPARE(gains[0][QLatin1String("numerator")].toInt(), 4621);
    QCOMPARE(gains[0][QLatin1String("exponent")].toInt(), 10);
    QCOMPARE(gains[1][QLatin1String("numerator")].toInt(), 2696);
    QCOMPARE(gains[1][QLatin1String("exponent")].toInt(), 14);
    QVERIFY(shown.object()[QLatin1String("rise_s")].toDouble() > 0.5e-3);
    COMPARE_STATUS(board.cli("set I_Q_KP=77 I_Q_KI=77 I_D_KP=77 I_D_KI=77"), 0);
    COMPARE_STATUS(board.cli("gains --bandwidth 1500"), 0);
    QCOMPARE(board.cli("get I_Q_KP").out, QStringLiteral("I_Q_KP = 77\n")); // only shown

    const CliRun applied = board.cli("--json gains --bandwidth 1500 --apply");
    COMPARE_STATUS(applied, 0);
    QCOMPARE(applied.list().size(), 4);
    QCOMPARE(board.cli("get I_Q_KP I_D_KI").out, QStringLiteral("I_Q_KP = 4621\nI_D_KI = 2696\n"));
    QCOMPARE(board.cli("--json gains --bandwidth 1500 --apply").out, QStringLiteral("[]\n"));
    COMPARE_STATUS(board.cli("gains --bandwidth 20000"), 1); // beyond the control rate
    QVERIFY(shown.object()[QLatin1String("warnings")].toArray().isEmpty());
    const CliRun quick = board.cli("gains --bandwidth 9500 --damping 1.2 --inertia 5e-5");
    COMPARE_STATUS(quick, 0);
    for (const char *note : {"Note: 9500 rad/s is beyond 9000 rad/s", "Note: the current loop's",
             "Note: the speed loop's phase margin of 10.39 degrees is below 45.\n"})
        QVERIFY2(quick.out.contains(QLatin1String(note)), qPrintable(quick.out));
    const QJsonObject json =
        board.cli("--json gains --bandwidth 9500 --damping 1.2 --inertia 5e-5").object();
    QCOMPARE(json[QLatin1String("warnings")].toArray().size(), 3);
}

void TestCliTuning::theSpeedLoopNeedsAnInertia()
{
    const Simulator board;
    QVERIFY(board.ready());
    const CliRun without = board.cli("--json gains --bandwidth 1500 --damping 3");
    COMPARE_STATUS(without, 0);
    QCOMPARE(
        without.object()[QLatin1String("speed_missing")].toString(), QStringLiteral("inertia"));
    QCOMPARE(without.object()[QLatin1String("gains")].toArray().size(), 4);
    const CliRun with =
        board.cli("--json gains --bandwidth 1500 --damping 3 --inertia 5e-5 --ke 3.3346 --delay 0");
    COMPARE_STATUS(with, 0);
    const QJsonArray gains = with.object()[QLatin1String("gains")].toArray();
    QCOMPARE(namesOf(gains).mid(4).join(QLatin1Char(' ')), QStringLiteral("SPEED_KP SPEED_KI"));
    // 1 / (d K tau) with K = 0.039 / 5e-5 and tau = 1/1732 + 1.5/16000 + 0.5e-3
    QVERIFY(std::abs(gains[4][QLatin1String("gain")].toDouble() - 0.3649) < 2e-4);
    QVERIFY(
        std::abs(with.object()[QLatin1String("speed_phase_margin_deg")].toDouble() - 53.13) < 0.05);
    // An observer averages 64 control periods: the measured speed is 2 ms late.
    const CliRun late =
        board.cli("--json gains --bandwidth 1500 --damping 3 --inertia 5e-5 --ke 3.3346");
    const auto lag = [](const CliRun &run) {
        return run.object()[QLatin1String("speed_lag_s")].toDouble();
    };
    QVERIFY(std::abs(lag(late) - lag(with) - 2e-3) < 1e-9);
    COMPARE_STATUS(board.cli("gains --bandwidth 1500 --delay -1"), 2);
}

void TestCliTuning::revUpStagesComeBackFromTheirFile()
{
    const Simulator board;
    QVERIFY(board.ready());
    const CliRun before = board.cli("--json revup");
    COMPARE_STATUS(before, 0);
    QCOMPARE(before.object()[QLatin1String("stages")].toArray().size(), 5);
    QFile file(board.file("revup.json"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(before.out.toUtf8());
    file.close();
    COMPARE_STATUS(board.cli("revup --set 0,2.5,800 1200,2.5,1500"), 0);
    const QJsonArray stages = board.cli("--json revup").object()[QLatin1String("stages")].toArray();
    QCOMPARE(stages[1][QLatin1String("speed_rpm")].toInt(), 1200);
    QVERIFY(std::abs(stages[1][QLatin1String("current_a")].toDouble() - 2.5) < 1e-3);
    QCOMPARE(stages[4][QLatin1String("duration_ms")].toInt(-1), 0);
    COMPARE_STATUS(board.cli("revup --set", {file.fileName()}), 0);
    QCOMPARE(board.cli("--json revup").out, before.out);
    COMPARE_STATUS(board.cli("revup --set 0,1,200 -900,1,2000"), 0); // backwards
    const CliRun slow = board.cli("revup --set 300,1,500");
    COMPARE_STATUS(slow, 0);
    QVERIFY(slow.out.contains(QLatin1String("Stage 5: 300 rpm")));
    QVERIFY(slow.out.contains(QLatin1String("Note: stage 1: ends too slow (300 rpm, limit ")));
    QVERIFY(!slow.out.contains(QRegularExpression(QStringLiteral("limit [0-9.e+]+\\)"))));
    QVERIFY(board.cli("revup").out.contains(QLatin1String("Note: stage 1: ends too slow")));
    const CliRun odd = board.cli("revup --set 0,2,500 1000,2.5,2000");
    COMPARE_STATUS(odd, 0); // boards keep 0.1 Hz
    QVERIFY(odd.out.contains(
        QLatin1String("Note: stage 2: 1000 rpm became 996; boards keep steps of 6 rpm")));
    QVERIFY(odd.out.contains(QLatin1String("Stage 2: 996 rpm")));
    const CliRun fast = board.cli("revup --set 99999,1,100");
    COMPARE_STATUS(fast, 2);
    QVERIFY(fast.err.contains(QLatin1String("larger than a stage holds")));
}

void TestCliTuning::revUpBeyondALimitIsNotWritten()
{
    const Simulator board;
    QVERIFY(board.ready());
    const QString before = board.cli("revup").out;
    for (const char *line : {"revup --set 0,2,100 1200,50,1000", "revup --set 9000,2,1000"})
        COMPARE_STATUS(board.cli(line), 1);
    for (const char *line : {"revup --set 1,2", "revup --set a,b,c", "revup --set 1.5,2,100",
             "revup --set 1,nan,100", "revup --set 1,2,70000", "revup --set", "revup 1,2,3"})
        COMPARE_STATUS(board.cli(line), 2);
    COMPARE_STATUS(board.cli("revup --set /etc/passwd"), 5);
    QCOMPARE(board.cli("revup").out, before);
}

void TestCliTuning::aRevUpOfJustTheLimitIsWritten()
{
    const Simulator board;
    QVERIFY(board.ready());
    COMPARE_STATUS(board.cli("revup --set 0,2.5,800 1200,5,1500"), 0);
    const QJsonArray stages = board.cli("--json revup").object()[QLatin1String("stages")].toArray();
    QVERIFY(std::abs(stages[1][QLatin1String("current_a")].toDouble() - 5.0) < 1e-3);
}

void TestCliTuning::aRefusedRevUpSaysWhatIsTooMuch_data()
{
    QTest::addColumn<QString>("stages");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("said");
    const auto row = [](const char *stages, int status, const char *said) {
        QTest::newRow(stages) << QString::fromLatin1(stages) << status << QString::fromLatin1(said);
    };
    row("1000,6,100", 1, "The current of stage 1 is beyond the limit of 5 A; nothing was written.");
    row("0,1,100 9000,1,100", 1,
        "The speed of stage 2 is beyond the limit of 4000 rpm; nothing was written.");
    row("1000,99,100", 2, "The current of \"1000,99,100\" is larger than a stage holds, 60.");
    row("1000,-99,100", 2, "The current of \"1000,-99,100\" is larger than a stage holds, 60.");
    row("1000,1,70000", 2, "The time of \"1000,1,70000\" is larger than a stage holds, 65535 ms.");
    row("1000,1,0.5", 2, "\"1000,1,0.5\" is no stage");
    // One that takes no time: the drive refuses it, before anything was read.
    row("0,1,100 1200,6,0", 1, "Not written: REVUP_DATA (beyond the limit of 5 A)");
}

void TestCliTuning::aRefusedRevUpSaysWhatIsTooMuch()
{
    QFETCH(const QString, stages);
    QFETCH(const int, status);
    QFETCH(const QString, said);
    const Simulator board;
    QVERIFY(board.ready());
    const CliRun refused = board.cli("revup --set", stages.split(QLatin1Char(' ')));
    COMPARE_STATUS(refused, status);
    QVERIFY2(refused.err.contains(said) && refused.oneLineOfError(), qPrintable(refused.err));
    QCOMPARE(refused.out, QString());
}

void TestCliTuning::torqueIsBoundedLikeACommand()
{
    const Simulator board;
    QVERIFY(board.ready());
    COMPARE_STATUS(board.cli("torque -1.5 100"), 0);
    COMPARE_STATUS(board.cli("torque 99 100"), 1);
    for (const char *line : {"torque 1", "torque 1,5 100", "torque nan 100", "torque 1 -1"})
        COMPARE_STATUS(board.cli(line), 2);
}

void TestCliTuning::theHeaderHasTheNamesOfTheSdk()
{
    const Simulator board(kComplete);
    QVERIFY(board.ready());
    const QString path = board.file("drive_parameters.h");
    COMPARE_STATUS(board.cli("set SPEED_KP=4321 SPEED_KP_DIV=9 I_D_KP=1000 I_D_KP_DIV=9"), 0);
    COMPARE_STATUS(board.cli("revup --set 0,2.5,200 900,2.5,1500"), 0);
    COMPARE_STATUS(board.cli("header -o", {path}), 0);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString text =
        QString::fromUtf8(file.readAll())
            .replace(QRegularExpression(QStringLiteral(" +")), QStringLiteral(" "));
    for (const char *line : {"#define PID_SPEED_KP_DEFAULT 4321/(SPEED_UNIT/10)\n",
             "#define SP_KPDIV 512\n", "#define SP_KPDIV_LOG LOG2((512))\n",
             "#define PID_FLUX_KP_DEFAULT 2000\n", // over torque's divisor, 1024
             "#define PHASE2_FINAL_SPEED_UNIT (900*SPEED_UNIT/U_RPM)\n",
             "#define PHASE2_FINAL_CURRENT_A 2.49934\n"})
        QVERIFY2(text.contains(QLatin1String(line)), line);
    COMPARE_STATUS(board.cli("header -o /no/such/folder/x.h"), 5);

    const Simulator other({QStringLiteral("--profile"), QStringLiteral("hso")});
    QVERIFY(other.ready());
    const QString none = other.file("none.h");
    COMPARE_STATUS(other.cli("header -o", {none}), 1);
    QVERIFY(!QFile::exists(none));
}

void TestCliTuning::filesThatAreNoneAreExitStatus5_data()
{
    QTest::addColumn<QString>("line");
    for (const char *line : {"snapshot -o /no/such/folder/s.json", "snapshot -o /dev/null",
             "diff /no/such.json device", "diff /dev/null /dev/null", "restore /no/such.json",
             "restore /etc/passwd", "diff /etc/passwd device"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

void TestCliTuning::filesThatAreNoneAreExitStatus5()
{
    QFETCH(QString, line);
    const CliRun result = runCli(QStringList{QStringLiteral("--port"), QStringLiteral("sim")}
        + line.split(QLatin1Char(' ')));
    COMPARE_STATUS(result, 5);
    QCOMPARE(result.out, QString());
    QVERIFY(result.oneLineOfError());
}

void TestCliTuning::wrongUsageIsExitStatus2_data()
{
    QTest::addColumn<QString>("line");
    for (const char *line : {"snapshot", "--port sim snapshot", "diff a.json", "diff a.json device",
             "--port sim restore", "--port sim restore a.json b.json",
             "--port sim restore --only , a.json", "--port sim gains", "--port sim header",
             "--port sim gains --bandwidth -1", "--port sim gains --bandwidth 1500 --damping 1",
             "--port sim snapshot -o a.json b.json"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

void TestCliTuning::wrongUsageIsExitStatus2()
{
    QFETCH(QString, line);
    const CliRun result = runCli(line.split(QLatin1Char(' ')));
    COMPARE_STATUS(result, 2);
    QCOMPARE(result.out, QString());
    QVERIFY(result.oneLineOfError());
}

QTEST_GUILESS_MAIN(TestCliTuning)
#include "tst_cli_tuning_posix.moc"
