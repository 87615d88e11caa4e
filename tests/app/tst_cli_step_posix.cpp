// step and evaluate: the numbers of a series, the same from the run and from its file, and what is left of it.
#include "support/programs_posix.h"

#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

using support::CliRun;
using support::Simulator;

#define COMPARE_STATUS(result, expected)                                                           \
    do {                                                                                           \
        const CliRun it = result;                                                                  \
        QVERIFY2(it.status == (expected),                                                          \
            qPrintable(QStringLiteral("status %1, stderr: %2").arg(it.status).arg(it.err)));       \
    } while (false)

namespace {

const QStringList kServo{QStringLiteral("--motor"), QStringLiteral("servo24")};
constexpr qint64 kSomeSamples =
    300'000; ///< bytes of a recording with seven times as many: the motor turns

} // namespace

class TestCliStep : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theRunAndItsFileSayTheSame()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const QString file = board.file("run.pcapng");
        const CliRun run =
            board.cli("step speed --from 1000 --to 1500 --repeat 2 --hold 300 --json -o", {file});
        COMPARE_STATUS(run, 0);
        const QJsonObject said = QJsonDocument::fromJson(run.out.toUtf8()).object();
        QCOMPARE(said.value(QStringLiteral("kind")).toString(), QStringLiteral("step"));
        const QJsonArray runs = said.value(QStringLiteral("runs")).toArray();
        QCOMPARE(runs.size(), 4);
        for (qsizetype i = 0; i < runs.size(); ++i) {
            const QJsonObject one = runs[i].toObject();
            QCOMPARE(one.value(QStringLiteral("direction")).toString(),
                i % 2 == 0 ? QStringLiteral("up") : QStringLiteral("down"));
            QCOMPARE(one.keys(),
                (QStringList{QStringLiteral("direction"), QStringLiteral("instant_error_s"),
                    QStringLiteral("overshoot_pct"), QStringLiteral("peak_iq_a"),
                    QStringLiteral("rise_s"), QStringLiteral("settling_s")}));
            const double rise = one.value(QStringLiteral("rise_s")).toDouble();
            QVERIFY2(rise > 0.02 && rise < 0.04, qPrintable(QString::number(rise)));
        }
        const QJsonObject mean = said.value(QStringLiteral("mean"))
                                     .toObject()
                                     .value(QStringLiteral("rise_s"))
                                     .toObject();
        QVERIFY(mean.value(QStringLiteral("low")).toDouble()
            < mean.value(QStringLiteral("high")).toDouble());
        const CliRun again =
            support::runCli({QStringLiteral("evaluate"), QStringLiteral("--json"), file});
        COMPARE_STATUS(again, 0);
        QCOMPARE(again.out, run.out);
    }

    void gainsAreProposedWrittenAndProved()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const CliRun run = board.cli("autotune --goal stiff --apply --json");
        COMPARE_STATUS(run, 0);
        const QJsonObject said = QJsonDocument::fromJson(run.out.toUtf8()).object();
        QCOMPARE(said.value(QStringLiteral("applied")).toBool(), true);
        const QJsonObject stiff =
            said.value(QStringLiteral("candidates")).toArray().first().toObject();
        QCOMPARE(stiff.value(QStringLiteral("goal")).toString(), QStringLiteral("stiff"));
        const double ms =
            said.value(QStringLiteral("proof")).toObject().value(QStringLiteral("ms")).toDouble();
        QVERIFY2(ms > 1.0 && ms < 1.55, qPrintable(run.out));
        const CliRun now = board.cli("get SPEED_KP --raw");
        QVERIFY2(now.out.contains(QString::number(stiff.value(QStringLiteral("speed_kp")).toInt())),
            qPrintable(now.out));
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void aFilePlansAnExperiment()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const auto plan = [&](const QByteArray &text) {
            QFile file(board.file("plan.json"));
            return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        };
        QVERIFY(plan(R"({"experiment":"step","from_rpm":1000,"to_rpm":1300,"hold_ms":200})"));
        const CliRun run = board.cli("experiment --json", {board.file("plan.json")});
        COMPARE_STATUS(run, 0);
        QVERIFY(run.out.startsWith(QStringLiteral("{\"kind\":\"step\"")));
        for (const char *bad : {R"({"experiment":"step","register":1})", R"({"experiment":"go"})",
                 R"({"experiment":"step","from_rpm":"fast"})", "[]", "{"}) {
            QVERIFY(plan(bad));
            const CliRun refused = board.cli("experiment", {board.file("plan.json")});
            COMPARE_STATUS(refused, 5);
            QVERIFY2(refused.oneLineOfError(), qPrintable(refused.err));
        }
    }

    /// Short ones: how good they are is for the tests of their evaluations.
    void theOtherExperimentsSayTheSameFromTheirFiles()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        struct Expected {
            const char *line, *file, *number;
            double value, tolerance;
        };
        for (const Expected &one :
            {Expected{"response speed --seconds 6 --json -o", "a.pcapng", "crossover_hz", 6.7, 1.5},
                Expected{"identify mechanical --json -o", "b.pcapng", "inertia_kgm2", 2.5e-5, 5e-6},
                Expected{"identify electrical --json -o", "c.pcapng", "ld_h", 3.5e-4, 1e-5}}) {
            const QString file = board.file(one.file);
            const CliRun run = board.cli(one.line, {file});
            COMPARE_STATUS(run, 0);
            const double value = QJsonDocument::fromJson(run.out.toUtf8())
                                     .object()
                                     .value(QLatin1String(one.number))
                                     .toObject()
                                     .value(QStringLiteral("value"))
                                     .toDouble();
            QVERIFY2(std::abs(value - one.value) < one.tolerance, qPrintable(run.out + run.err));
            const CliRun again =
                support::runCli({QStringLiteral("evaluate"), QStringLiteral("--json"), file});
            COMPARE_STATUS(again, 0);
            QCOMPARE(again.out, run.out);
            QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
        }
    }

    void aStandingMotorStandsAndARunningOneRunsAfterwards()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const CliRun before = board.cli("get SPEED_RAMP");
        COMPARE_STATUS(board.cli("step speed --from 900 --to 1300 --repeat 1 --hold 300"), 0);
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
        QCOMPARE(board.cli("get SPEED_RAMP").out, before.out);
        COMPARE_STATUS(board.cli("ramp 1800 0"), 0);
        COMPARE_STATUS(board.cli("start"), 0);
        QTRY_VERIFY(board.cli("get --raw SPEED_MEAS").out.contains(QStringLiteral("1800"))
            || board.cli("get --raw SPEED_MEAS").out.contains(QStringLiteral("179")));
        COMPARE_STATUS(board.cli("step speed --from 900 --to 1300 --repeat 1 --hold 300"), 0);
        QVERIFY(board.cli("info").out.contains(QStringLiteral("RUN")));
        QVERIFY(board.cli("get SPEED_REF").out.contains(QStringLiteral("1800 rpm")));
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    void oneThatBreaksItsCapEndsWithSixAndAMotorAtRest()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const CliRun run = board.cli("step speed --from 1000 --to 1500 --repeat 1 --max-rpm 1500");
        COMPARE_STATUS(run, 6);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(
            run.err.contains(QStringLiteral("1500 rpm that are allowed")), qPrintable(run.err));
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void oneWhoseBoardIsGoneEndsWithThree_data()
    {
        QTest::addColumn<bool>("port");
        QTest::addColumn<QString>("reason");
        QTest::newRow("with its port") << true << QStringLiteral("the port was lost");
        QTest::newRow("silent") << false << QStringLiteral("no samples came for 0.5 s");
    }

    /// The motor may do anything: that is not a bound that was too tight.
    void oneWhoseBoardIsGoneEndsWithThree()
    {
        QFETCH(const bool, port);
        QFETCH(const QString, reason);
        Simulator board(kServo);
        QVERIFY(board.ready());
        const QString file = board.file("run.pcapng");
        QProcess process;
        support::startCli(process,
            {QStringLiteral("--port"), board.port(), QStringLiteral("step"),
                QStringLiteral("speed"), QStringLiteral("--from"), QStringLiteral("1000"),
                QStringLiteral("--to"), QStringLiteral("1500"), QStringLiteral("-o"), file});
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(file).size() > kSomeSamples, 20'000);
        if (port)
            board.vanish();
        else
            board.freeze();
        QVERIFY(process.waitForFinished(support::kProgramTime_ms));
        board.vanish();
        const CliRun run = support::resultOf(process);
        COMPARE_STATUS(run, 3);
        QVERIFY2(run.err.contains(reason) && run.err.contains(QStringLiteral("Stop NOT confirmed")),
            qPrintable(run.err));
    }

    /// Nobody restores its set-point: whoever starts the motor again is told where it goes.
    void whatAKilledRunLeavesIsNamedAtTheNextStart()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const QString file = board.file("run.pcapng");
        QProcess process;
        support::startCli(process,
            {QStringLiteral("--port"), board.port(), QStringLiteral("step"),
                QStringLiteral("speed"), QStringLiteral("--from"), QStringLiteral("1200"),
                QStringLiteral("--to"), QStringLiteral("1206"), QStringLiteral("-o"), file});
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(file).size() > kSomeSamples, 20'000);
        process.kill();
        QVERIFY(process.waitForFinished(support::kProgramTime_ms));
        QTRY_VERIFY_WITH_TIMEOUT(
            board.cli("info").out.contains(QStringLiteral("IDLE")), 10'000); // by the guardian
        const CliRun start = board.cli("start");
        COMPARE_STATUS(start, 0);
        QVERIFY2(start.out.contains(QStringLiteral("Start -> 120")), qPrintable(start.out));
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    void whatCannotBeDoneMovesNothing_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<int>("status");
        QTest::newRow("too fast") << QStringLiteral("step speed --from 1000 --to 9000") << 1;
        QTest::newRow("beyond one's own")
            << QStringLiteral("step speed --from 1000 --to 1500 --max-rpm 1400") << 1;
        QTest::newRow("too long") << QStringLiteral(
            "step speed --from 1000 --to 1500 --repeat 30 --hold 2000")
                                  << 1;
        QTest::newRow("no step") << QStringLiteral("step speed --from 1000 --to 1000") << 1;
        QTest::newRow("no end") << QStringLiteral("step speed --from 1000") << 2;
        QTest::newRow("no number") << QStringLiteral("step speed --from x --to 1000") << 2;
        QTest::newRow("another kind") << QStringLiteral("step voltage --from 1 --to 2") << 2;
    }

    void whatCannotBeDoneMovesNothing()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        QFETCH(const QString, line);
        QFETCH(const int, status);
        const CliRun run = board.cli(line.toUtf8().constData());
        COMPARE_STATUS(run, status);
        QVERIFY(run.oneLineOfError());
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void aFileThatIsThereStays()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        QFile file(board.file("run.pcapng"));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
        file.close();
        COMPARE_STATUS(board.cli("step speed --from 1000 --to 1500 -o", {file.fileName()}), 5);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("mine"));
    }

    void boardsThatRecordNothingAndFilesWithoutASeriesSayWhy()
    {
        const CliRun older =
            support::runCli({QStringLiteral("--port"), QStringLiteral("sim:legacy"),
                QStringLiteral("step"), QStringLiteral("speed"), QStringLiteral("--from"),
                QStringLiteral("500"), QStringLiteral("--to"), QStringLiteral("900")});
        COMPARE_STATUS(older, 1);
        QVERIFY2(
            older.err.contains(QStringLiteral("Nothing can be measured")), qPrintable(older.err));
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const QString file = board.file("other.pcapng");
        COMPARE_STATUS(board.cli("capture --hf I_A --seconds 0.2 --record", {file}), 0);
        const CliRun none = support::runCli({QStringLiteral("evaluate"), file});
        COMPARE_STATUS(none, 1);
        QVERIFY2(none.err.contains(QStringLiteral("no recording of an experiment")),
            qPrintable(none.err));
    }
};

QTEST_GUILESS_MAIN(TestCliStep)
#include "tst_cli_step_posix.moc"
