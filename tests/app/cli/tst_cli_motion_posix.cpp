// What bounds the motion that the command line asks for, and what it leaves in the motion log.
#include "session/files/limits_file.h"
#include "support/programs/programs_posix.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QtTest>

using support::CliRun;
using support::Simulator;

namespace {

/// In the home of this test.
struct LimitsFile {
    const QString path = session::limitsPath();
    bool write(const char *content) const
    {
        QFile file(path);
        return QDir().mkpath(QFileInfo(path).path()) && file.open(QIODevice::WriteOnly)
            && file.write(content) > 0;
    }
    ~LimitsFile() { QFile::remove(path); }
};

} // namespace

class TestCliMotion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onesOwnLimitsBoundRampsAndStarts()
    {
        const Simulator board;
        QVERIFY(board.ready());
        for (const char *line : {"ramp --max-rpm 1000 1001 100", "ramp --max-rpm 1000 -- -1001 100",
                 "torque --max-amps 0.5 0.6 100", "set --max-rpm 1000 SPEED_REF=1001",
                 "start --max-rpm 100", "start --max-amps 0.1"}) {
            const CliRun run = board.cli(line);
            COMPARE_STATUS(run, 1);
            QVERIFY2(run.err.contains(QStringLiteral("your own limit")), qPrintable(run.err));
        }
        COMPARE_STATUS(board.cli("ramp --max-rpm 1000 1000 100"), 0);
        COMPARE_STATUS(board.cli("ramp --max-rpm 100000 4001 100"), 1); // the board's is lower
    }

    /// Also to a speed that was asked for while the motor rested.
    void aStartSaysWhereItGoes()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const CliRun ramp = board.cli("ramp 2100 0");
        COMPARE_STATUS(ramp, 0);
        QVERIFY2(ramp.out.contains(QStringLiteral("stands: the speed is for its next start")),
            qPrintable(ramp.out));
        const CliRun json = board.cli("--json ramp 2100 0"); // the state alone
        COMPARE_STATUS(json, 0);
        QVERIFY2(!json.out.contains(QStringLiteral("next start")), qPrintable(json.out));
        const CliRun start = board.cli("start");
        COMPARE_STATUS(start, 0);
        QVERIFY2(start.out.contains(QStringLiteral("Start -> 2100 rpm")), qPrintable(start.out));
        const CliRun moving = board.cli("ramp 2000 100");
        COMPARE_STATUS(moving, 0);
        QVERIFY2(!moving.out.contains(QStringLiteral("next start")), qPrintable(moving.out));
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    /// Of a motor with four of them, whose board counts electrical turns.
    void aTachometerTellsThePolePairs()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const CliRun resting = board.cli("pole-pairs 1500");
        COMPARE_STATUS(resting, 1);
        QVERIFY2(resting.err.contains(QStringLiteral("does not turn")), qPrintable(resting.err));
        COMPARE_STATUS(board.cli("ramp 1500 0"), 0);
        COMPARE_STATUS(board.cli("start"), 0);
        // On its way, or on a busy computer, its speed is not constant.
        const auto counted = [&board](const char *line) {
            CliRun run;
            const QDeadlineTimer patience(20'000);
            do
                run = board.cli(line);
            while (!patience.hasExpired()
                && (run.stalled() || run.err.contains(QLatin1String("has to be constant"))));
            return run;
        };
        const CliRun four = counted("--json pole-pairs 1495");
        COMPARE_STATUS(four, 0);
        QCOMPARE(four.object()[QLatin1String("pole_pairs")].toInt(), 4);
        const CliRun five = counted("pole-pairs 1200");
        COMPARE_STATUS(five, 0);
        QVERIFY2(five.out.startsWith(QLatin1String("Pole pairs: 5 (")), qPrintable(five.out));
        const CliRun between = counted("pole-pairs 1330");
        COMPARE_STATUS(between, 1);
        QVERIFY2(between.err.contains(QLatin1String("no whole number")), qPrintable(between.err));
        COMPARE_STATUS(board.cli("pole-pairs 0"), 2);
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    void thoseOfTheWindowHoldUnlessOthersAreGiven()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const LimitsFile file;
        QCOMPARE(session::saveLimits({1000.0, 2.0}, file.path), QString());
        const CliRun refused = board.cli("ramp 1001 100");
        COMPARE_STATUS(refused, 1);
        QVERIFY2(refused.err.contains(QStringLiteral("Your own limits hold: 1000 rpm, 2 A (from ")),
            qPrintable(refused.err));
        QVERIFY(refused.err.contains(QStringLiteral("your own limit")));
        COMPARE_STATUS(board.cli("torque 2.1 100"), 1);
        const CliRun given = board.cli("ramp --max-rpm 1100 1001 100");
        COMPARE_STATUS(given, 0);
        QVERIFY2(given.err.contains(QStringLiteral("hold: 2 A (from ")), qPrintable(given.err));
        COMPARE_STATUS(board.cli("ramp --max-rpm 1100 --max-amps 3 1001 100"), 0);
    }

    void unreadableOnesOfTheWindowEndWhatMovesAndNothingElse()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const LimitsFile file;
        QVERIFY(file.write("{\"maxSpeedRpm\": 10"));
        for (const char *line : {"ramp 100 100", "start", "ramp --max-rpm 200 100 100"}) {
            const CliRun run = board.cli(line);
            COMPARE_STATUS(run, 5);
            QVERIFY(run.oneLineOfError());
            QVERIFY2(run.err.contains(QStringLiteral("it is damaged")), qPrintable(run.err));
        }
        COMPARE_STATUS(board.cli("ramp --max-rpm 200 --max-amps 3 100 100"), 0);
        COMPARE_STATUS(board.cli("stop"), 0);
        COMPARE_STATUS(board.cli("get STATUS"), 0);
    }

    void whatTheBoardDoesNotTellTakesExpertMode()
    {
        const Simulator board({QStringLiteral("--liar"), QStringLiteral("nan")});
        QVERIFY(board.ready());
        const CliRun refused = board.cli("start");
        COMPARE_STATUS(refused, 1);
        QVERIFY2(refused.err.contains(QStringLiteral("expert mode")), qPrintable(refused.err));
        COMPARE_STATUS(board.cli("start --expert"), 0);
        COMPARE_STATUS(board.cli("stop"), 0);
        COMPARE_STATUS(board.cli("start"), 1); // for one run only
    }

    void expertModeIsNoErrorWhereAllIsKnown()
    {
        const Simulator board;
        COMPARE_STATUS(board.cli("ramp --expert 600 100"), 0);
    }

    void aCaptureHasItsMotionLogBeside()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const QString file = board.file("run.csv");
        const CliRun run =
            board.cli("capture --hf I_A --seconds 0.2 --start --ramp 1000,200 -o", {file});
        COMPARE_STATUS(run, 0);
        QFile log(board.file("run.motion.csv"));
        QVERIFY(log.open(QIODevice::ReadOnly));
        const QByteArrayList lines = log.readAll().trimmed().split('\n');
        QVERIFY(lines.at(0).startsWith("number,time,who,source,motor,command"));
        const auto line = [&](const char *word) {
            for (const QByteArray &one : lines)
                if (one.contains(word))
                    return one;
            return QByteArray();
        };
        QVERIFY(line(",START,").contains(",command line,1,START,,ok,"));
        QVERIFY(line(",START,").endsWith(",19 00"));
        QVERIFY(line(",SPEED_RAMP,").contains("1000 rpm in 200 ms"));
        QVERIFY(line("speed not measurable").contains(",1,STOP,"));

        const QString quiet = board.file("quiet.csv");
        COMPARE_STATUS(board.cli("capture --hf I_A --seconds 0.1 -o", {quiet}), 0);
        QVERIFY(!QFile::exists(board.file("quiet.motion.csv")));
    }

    void oddLimitsAreExitStatus2()
    {
        for (const char *word : {"0", "-5", "x", "1,5", "nan", "inf", "1e400"}) {
            const CliRun run = support::runCli({QStringLiteral("--port"), QStringLiteral("sim"),
                QStringLiteral("start"), QStringLiteral("--max-rpm=%1").arg(QLatin1String(word))});
            COMPARE_STATUS(run, 2);
            QVERIFY(run.oneLineOfError());
        }
    }
};

QTEST_GUILESS_MAIN(TestCliMotion)
#include "tst_cli_motion_posix.moc"
