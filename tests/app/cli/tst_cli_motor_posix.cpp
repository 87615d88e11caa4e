// The command that shows a motor, lays files beside it and writes one.
#include "support/board_on_terminal.h"
#include "support/programs/programs_posix.h"

#include <QtTest>

#include <cmath>

using support::CliRun;
using support::runCli;
using support::Simulator;

namespace {

QJsonObject valueIn(const QJsonObject &object, const char *list, const char *name)
{
    for (const QJsonValue &value : object[QLatin1String(list)].toArray())
        if (value[QLatin1String("name")].toString() == QLatin1String(name))
            return value.toObject();
    return {};
}

QJsonObject shown(const CliRun &run) { return QJsonDocument::fromJson(run.out.toUtf8()).object(); }

bool near(const QJsonValue &value, double wanted)
{
    return value.isDouble() && std::abs(value.toDouble() - wanted) <= 1e-5 * std::abs(wanted);
}

} // namespace

class TestCliMotor : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itShowsTheBoardsMotorAndWhatFollows()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const CliRun run = board.cli("--json motor");
        QCOMPARE(run.status, 0);
        const QJsonObject motor = shown(run);
        QCOMPARE(motor[QLatin1String("motor")].toString(), QStringLiteral("Sim PMSM 24V"));
        QVERIFY(near(valueIn(motor, "values", "rs")[QLatin1String("board")], 0.35));
        QVERIFY(near(valueIn(motor, "values", "flux")[QLatin1String("board")], 6.5e-3));
        QVERIFY(near(valueIn(motor, "derived", "kt")[QLatin1String("board")], 0.039));
        QVERIFY(motor[QLatin1String("warnings")].toArray().isEmpty());
        const CliRun text = board.cli("motor");
        QVERIFY2(text.out.contains(QStringLiteral("rs")), qPrintable(text.out));
        QVERIFY(text.out.contains(QStringLiteral("rpm/V")));
    }

    void whatItWritesDoesNotDifferAndMakesTheSameMachine()
    {
        const Simulator board({QStringLiteral("--motor"), QStringLiteral("ipm48")});
        QVERIFY(board.ready());
        const QString path = board.file("motor.json");
        QCOMPARE(board.cli("motor -o", {path}).status, 0);
        const QJsonObject compared = shown(board.cli("--json motor", {path}));
        int both = 0;
        for (const QJsonValue &value : compared[QLatin1String("values")].toArray()) {
            QVERIFY(!value[QLatin1String("differs")].toBool());
            both += value[QLatin1String("file")].isDouble() ? 1 : 0;
        }
        QCOMPARE(both, 8);
        const CliRun text = board.cli("motor", {path});
        for (const QString &line : text.out.split(QLatin1Char('\n'))) {
            if (!line.startsWith(QLatin1String("rs ")) && !line.startsWith(QLatin1String("ld ")))
                continue;
            // Name, board, file.
            const QStringList columns = line.split(QStringLiteral("  "), Qt::SkipEmptyParts);
            QVERIFY2(columns.size() == 3, qPrintable(line));
            QVERIFY2(columns[1].trimmed() == columns[2].trimmed() && columns[1].size() < 14,
                qPrintable(line));
        }
        const Simulator again({QStringLiteral("--motor"), path});
        QVERIFY(again.ready());
        const QJsonObject twin = shown(again.cli("--json motor", {path}));
        for (const QJsonValue &value : twin[QLatin1String("values")].toArray())
            QVERIFY2(!value[QLatin1String("differs")].toBool(),
                qPrintable(value[QLatin1String("name")].toString()));
    }

    void lostSamplesAreBlamedOnWhatLostThem()
    {
        const Simulator board({QStringLiteral("--liar"), QStringLiteral("noise")});
        QVERIFY(board.ready());
        // The noise may also end the recording before its time, which is told instead.
        CliRun run;
        constexpr int kTries = 4;
        for (int i = 0; i < kTries && !run.err.contains(QStringLiteral("damaged")); ++i) {
            run = board.cli("capture --hf I_A --seconds 0.5 -o", {board.file("x.csv")});
            QCOMPARE(run.status, 4);
        }
        QVERIFY2(run.err.contains(QStringLiteral("damaged on the line")), qPrintable(run.err));
        QVERIFY(!run.err.contains(QStringLiteral("fewer signals")));
    }

    void aValueThatWasNotReadBackIsNotSaidToBeThere()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const CliRun run = board.cli("set REVUP_DATA=0011");
        QCOMPARE(run.status, 1);
        QVERIFY2(!run.err.contains(QStringLiteral("values above")), qPrintable(run.err));
        QVERIFY2(run.err.contains(QStringLiteral("rotorscope-cli get")), qPrintable(run.err));
    }

    /// The board took the value, and refused to give it a moment later.
    void whatWasWrittenAndNotReadBackIsNoSuccess()
    {
        const Simulator board({QStringLiteral("--liar"), QStringLiteral("refused-reads:2")});
        QVERIFY(board.ready());
        // Two refusals in a row are believed: about one run in seven is like that.
        constexpr int kTries = 40;
        bool seen = false;
        for (int i = 0; i < kTries && !seen; ++i) {
            const CliRun run = board.cli("--json set SPEED_KP=1234");
            const QJsonObject one = run.list().at(0).toObject();
            seen = one[QLatin1String("outcome")].toString() == QStringLiteral("ok")
                && !one.contains(QLatin1String("new"));
            if (!seen)
                continue;
            QVERIFY(one[QLatin1String("verified")].isNull());
            QCOMPARE(run.status, 1);
            QVERIFY2(
                run.err.contains(QStringLiteral("not read back: SPEED_KP")), qPrintable(run.err));
            QVERIFY2(run.err.contains(QStringLiteral("rotorscope-cli get")), qPrintable(run.err));
        }
        QVERIFY(seen);
    }

    void aDamagedFileIsOneSentenceWithItsPlace()
    {
        const Simulator board;
        QVERIFY(board.ready());
        const QString path = board.file("bad.json");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("{\"motor\": {\"rs_ohm\": \"0.3\"}}");
        file.close();
        const CliRun run = board.cli("motor", {path});
        QCOMPARE(run.status, 5);
        QVERIFY2(run.err.contains(QStringLiteral("motor.rs_ohm")), qPrintable(run.err));
        QCOMPARE(run.err.count(QLatin1Char('\n')), 1);
        QCOMPARE(board.cli("motor /no/such.json").status, 5);
        QCOMPARE(board.cli("motor -o /no/such/folder/m.json").status, 5);
        QCOMPARE(board.cli("motor a.json b.json").status, 2);
        QCOMPARE(board.cli("motor --motor 2").status, 2);
    }
};

QTEST_GUILESS_MAIN(TestCliMotor)
#include "tst_cli_motor_posix.moc"
