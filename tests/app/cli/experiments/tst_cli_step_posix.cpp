// Experiments as programs: the run and its file say the same, what is left of it, and how it ends. How good the numbers
// are is for the tests of their evaluations, on virtual time: here the machine may stand still.
#include "session/recording/lent_note.h"
#include "support/programs/experiment_program_posix.h"
#include "support/programs/size_limit_posix.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QtTest>

#include <algorithm>
#include <array>
#include <memory>

using support::CliRun;
using support::ExperimentProgram;
using support::Simulator;

/// It ended so; or otherwise, and as it should where the machine did not let it run: then there is nothing more to be
/// seen.
#define COMPARE_OUTCOME(program, expected, text, ...)                                              \
    do {                                                                                           \
        const auto asExpected = [](const CliRun &it) {                                             \
            return it.status == (expected) && it.err.contains(QLatin1String(text));                \
        };                                                                                         \
        const CliRun came = (program).outcome(asExpected __VA_OPT__(, ) __VA_ARGS__);              \
        if (!asExpected(came) && (program).starved()) {                                            \
            QVERIFY2(came.endedEarly(), qPrintable(came.err + came.out));                          \
            qWarning("%s", qPrintable(came.err));                                                  \
            return;                                                                                \
        }                                                                                          \
        COMPARE_STATUS(came, expected);                                                            \
        QVERIFY2(came.err.contains(QLatin1String(text)), qPrintable(came.err));                    \
    } while (false)
#define COMPARE_END(program, expected) COMPARE_OUTCOME(program, expected, "")

namespace {

const QStringList kServo{QStringLiteral("--motor"), QStringLiteral("servo24")};
const QStringList kWithoutSensor{QStringLiteral("--motor"), QStringLiteral("pm24")};
constexpr int kPatience_ms = 60'000; ///< a program takes long to start on a machine that is busy
/// Bytes of a recording with seven times as many: the motor turns.
constexpr qint64 kSomeSamples = 300'000;

QJsonObject jsonOf(const CliRun &run) { return QJsonDocument::fromJson(run.out.toUtf8()).object(); }

} // namespace

class TestCliStep : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// They wait for their motors most of the time, so all of them begin here.
    void initTestCase()
    {
        const auto begin = [](const char *line) {
            auto program = std::make_unique<ExperimentProgram>(kServo, line);
            program->begin();
            return program;
        };
        m_step = begin("step speed --from 1000 --to 1500 --repeat 2 --hold 200 --json -o");
        m_torque = begin("step torque --from 0.4 --to 0.8 --repeat 2 --json -o");
        m_flux = begin("step flux --from 0 --to -1.5 --repeat 2 --json -o");
        m_response = begin("response speed --seconds 4 --json -o");
        m_current = begin("response current --seconds 4 --json -o");
        m_mechanics = begin("identify mechanical --json -o");
        m_bothWays = begin("identify mechanical --both-directions --json -o");
        m_electrics = begin("identify electrical --json -o");
        m_tuning = begin("autotune --goal stiff --apply --seconds 6 --json -o");
        const std::array all{m_step.get(), m_torque.get(), m_flux.get(), m_response.get(),
            m_current.get(), m_mechanics.get(), m_bothWays.get(), m_electrics.get(),
            m_tuning.get()};
        const auto ended = [](ExperimentProgram *program) { return program->ended(); };
        while (std::count_if(all.begin(), all.end(), ended) < qsizetype(all.size())) { }
    }
    void cleanupTestCase()
    {
        for (auto *program : {&m_step, &m_torque, &m_flux, &m_response, &m_current, &m_mechanics,
                 &m_bothWays, &m_electrics, &m_tuning})
            program->reset();
    }

    void aSeriesOfStepsAndItsFileSayTheSame_data()
    {
        QTest::addColumn<ExperimentProgram *>("program");
        QTest::addColumn<QString>("first");
        QTest::newRow("speed") << m_step.get() << QStringLiteral("up");
        QTest::newRow("torque") << m_torque.get() << QStringLiteral("up");
        QTest::newRow("flux") << m_flux.get() << QStringLiteral("down");
    }

    void aSeriesOfStepsAndItsFileSayTheSame()
    {
        QFETCH(ExperimentProgram *const, program);
        QFETCH(const QString, first);
        COMPARE_END(*program, 0);
        const QJsonObject said = jsonOf(program->run());
        QCOMPARE(said.value(QStringLiteral("kind")).toString(), QStringLiteral("step"));
        const QJsonArray runs = said.value(QStringLiteral("runs")).toArray();
        QCOMPARE(runs.size(), 4);
        for (qsizetype i = 0; i < runs.size(); ++i) {
            const QJsonObject one = runs[i].toObject();
            QCOMPARE(one.value(QStringLiteral("direction")).toString(),
                (i % 2 == 0) == (first == QStringLiteral("up")) ? QStringLiteral("up")
                                                                : QStringLiteral("down"));
            QCOMPARE(one.keys(),
                (QStringList{QStringLiteral("direction"), QStringLiteral("instant_error_s"),
                    QStringLiteral("overshoot_pct"), QStringLiteral("peak_iq_a"),
                    QStringLiteral("rise_s"), QStringLiteral("settling_s")}));
        }
        theFileSaysTheSame(*program);
    }

    void theOtherExperimentsSayTheSameFromTheirFiles_data()
    {
        QTest::addColumn<ExperimentProgram *>("program");
        QTest::addColumn<QString>("number");
        QTest::newRow("response") << m_response.get() << QStringLiteral("crossover_hz");
        QTest::newRow("current") << m_current.get() << QStringLiteral("crossover_hz");
        QTest::newRow("mechanics") << m_mechanics.get() << QStringLiteral("inertia_kgm2");
        QTest::newRow("both directions")
            << m_bothWays.get() << QStringLiteral("inertia_backwards_kgm2");
        QTest::newRow("electrics") << m_electrics.get() << QStringLiteral("ld_h");
    }

    void theOtherExperimentsSayTheSameFromTheirFiles()
    {
        QFETCH(ExperimentProgram *const, program);
        QFETCH(const QString, number);
        COMPARE_END(*program, 0);
        const QJsonObject value = jsonOf(program->run()).value(number).toObject();
        QVERIFY2(value.value(QStringLiteral("value")).toDouble() > 0.0,
            qPrintable(program->run().out + program->run().err));
        theFileSaysTheSame(*program);
    }

    void gainsAreProposedWrittenAndProved()
    {
        const Simulator &board = m_tuning->board();
        COMPARE_END(*m_tuning, 0);
        const QJsonObject said = jsonOf(m_tuning->run());
        QCOMPARE(said.value(QStringLiteral("applied")).toBool(), true);
        const QJsonObject stiff =
            said.value(QStringLiteral("candidates")).toArray().first().toObject();
        QCOMPARE(stiff.value(QStringLiteral("goal")).toString(), QStringLiteral("stiff"));
        const double ms =
            said.value(QStringLiteral("proof")).toObject().value(QStringLiteral("ms")).toDouble();
        QVERIFY2(ms > 1.0, qPrintable(m_tuning->run().out));
        const CliRun now = board.cli("get SPEED_KP --raw");
        QVERIFY2(now.out.contains(QString::number(stiff.value(QStringLiteral("speed_kp")).toInt())),
            qPrintable(now.out));
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void whatAutotuneMeasuredIsKept()
    {
        COMPARE_END(*m_tuning, 0);
        const QDir folder = QFileInfo(m_tuning->file()).dir();
        const auto valueIn = [&](const QString &name, const QString &number) {
            const CliRun told = support::runCli(
                {QStringLiteral("evaluate"), QStringLiteral("--json"), folder.filePath(name)});
            const QJsonObject all = jsonOf(told);
            const QJsonObject of = all.value(QStringLiteral("kind")) == QStringLiteral("step")
                ? all.value(QStringLiteral("mean")).toObject()
                : all;
            return of.value(number).toObject().value(QStringLiteral("value")).toDouble();
        };
        const auto named = [&](const char *pattern) {
            return folder.entryList({QString::fromLatin1(pattern)}, QDir::Files, QDir::Name);
        };
        const QStringList responses = named("run-*-response.pcapng"),
                          steps = named("run-*-steps.pcapng");
        QCOMPARE(responses.value(0), QStringLiteral("run-1-response.pcapng"));
        QVERIFY(responses.size() >= 2 && !steps.isEmpty());
        const QJsonObject proof = jsonOf(m_tuning->run()).value(QStringLiteral("proof")).toObject();
        for (const auto &[file, number] : {std::pair(responses.last(), QStringLiteral("ms")),
                 std::pair(steps.last(), QStringLiteral("overshoot_pct"))})
            QCOMPARE(valueIn(file, number), proof.value(number).toDouble());

        // A second one does not mix with them.
        const CliRun again = support::runCli({QStringLiteral("--port"), m_tuning->board().port(),
            QStringLiteral("autotune"), QStringLiteral("-o"), m_tuning->file()});
        COMPARE_STATUS(again, 5);
        QVERIFY2(again.err.contains(QStringLiteral("is there already")), qPrintable(again.err));
    }

    void aFilePlansAnExperiment()
    {
        ExperimentProgram program(kServo, "experiment --json");
        const Simulator &board = program.board();
        QVERIFY(board.ready());
        const auto plan = [&](const QByteArray &text) {
            QFile file(board.file("plan.json"));
            return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        };
        for (const char *bad : {R"({"experiment":"step","register":1})", R"({"experiment":"go"})",
                 R"({"experiment":"step","from_rpm":"fast"})",
                 R"({"experiment":"step","from_rpm":1500,"to_rpm":1800,"max_a":0})",
                 R"({"experiment":"step","from_rpm":1500})", "[]", "{"}) {
            QVERIFY(plan(bad));
            const CliRun refused = board.cli("experiment", {board.file("plan.json")});
            COMPARE_STATUS(refused, 5);
            QVERIFY2(refused.oneLineOfError(), qPrintable(refused.err));
        }
        QVERIFY(plan(
            R"({"experiment":"step","from_rpm":1000,"to_rpm":1300,"hold_ms":200,"repeat":1})"));
        program.begin({board.file("plan.json")});
        COMPARE_END(program, 0);
        QVERIFY(program.run().out.startsWith(QStringLiteral("{\"kind\":\"step\"")));
    }

    void aPowerAndItsFileSayTheSame()
    {
        ExperimentProgram program(kServo, "experiment --json");
        QVERIFY(program.board().ready());
        QFile plan(program.board().file("plan.json"));
        QVERIFY(plan.open(QIODevice::WriteOnly));
        plan.write(R"({"experiment":"power","rpm":1500,"length_ms":2000,"rs_ohm":0.19})");
        plan.close();
        program.begin({plan.fileName(), QStringLiteral("-o"), program.file()});
        COMPARE_END(program, 0);
        const QJsonObject said = jsonOf(program.run());
        QCOMPARE(said.value(QStringLiteral("kind")).toString(), QStringLiteral("power"));
        for (const char *key : {"speed_rpm", "electrical_w", "copper_w", "shaft_w", "efficiency"})
            QCOMPARE(said.value(QLatin1String(key)).toObject().keys(),
                (QStringList{
                    QStringLiteral("high"), QStringLiteral("low"), QStringLiteral("value")}));
        theFileSaysTheSame(program);
    }

    /// Without anybody who changes it nothing follows, and all is as it was.
    void aLoadThatDoesNotChangeIsNotConclusive()
    {
        ExperimentProgram program(kServo, "step load --speed 1200 --hold 2000");
        QVERIFY(program.board().ready());
        program.begin({QStringLiteral("-o"), program.file()});
        COMPARE_END(program, 1);
        const QString said = program.run().err;
        QVERIFY2(said.contains(QLatin1String("put the load on and take it off")), qPrintable(said));
        QVERIFY2(said.contains(QLatin1String("no load came or went"), Qt::CaseInsensitive),
            qPrintable(said));
        COMPARE_STATUS(program.board().cli("step load --from 100 --to 200"), 2);
    }

    void aStandingMotorStandsAndARunningOneRunsAfterwards()
    {
        ExperimentProgram program(kServo, "step speed --from 900 --to 1300 --repeat 1 --hold 100");
        const Simulator &board = program.board();
        QVERIFY(board.ready());
        const CliRun before = board.cli("get SPEED_RAMP");
        program.begin();
        COMPARE_END(program, 0);
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
        QCOMPARE(board.cli("get SPEED_RAMP").out, before.out);
        const auto onARunningOne = [&] {
            startAt1800(board);
            program.begin();
        };
        onARunningOne();
        COMPARE_OUTCOME(program, 0, "", onARunningOne);
        QVERIFY(board.cli("info").out.contains(QStringLiteral("RUN")));
        QVERIFY(board.cli("get SPEED_REF").out.contains(QStringLiteral("1800 rpm")));
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    void aRunningMotorIsStoppedForWhatIsMeasuredAtRestAndRunsAfterwards()
    {
        ExperimentProgram program(kServo, "identify electrical --json");
        const Simulator &board = program.board();
        QVERIFY(board.ready());
        const auto onARunningOne = [&] {
            startAt1800(board);
            program.begin();
        };
        onARunningOne();
        COMPARE_OUTCOME(program, 0, "", onARunningOne);
        QVERIFY2(jsonOf(program.run()).value(QStringLiteral("rs_ohm")).isObject(),
            qPrintable(program.run().out + program.run().err));
        QVERIFY(turnsAt1800(board));
        QVERIFY(board.cli("info").out.contains(QStringLiteral("RUN")));
        QVERIFY(board.cli("get SPEED_REF").out.contains(QStringLiteral("1800 rpm")));
        // Nothing is stopped that would not be brought back.
        const CliRun refused = board.cli("identify electrical --max-rpm 1500");
        COMPARE_STATUS(refused, 1);
        QVERIFY2(refused.err.contains(QStringLiteral(": Not begun: ")), qPrintable(refused.err));
        QVERIFY(board.cli("info").out.contains(QStringLiteral("RUN")));
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    void aRunningMotorStaysStoppedBehindCtrlC()
    {
        ExperimentProgram program(kServo, "identify electrical -o");
        const Simulator &board = program.board();
        QVERIFY(board.ready());
        const auto untilItIsInterrupted = [&] {
            startAt1800(board);
            program.begin();
            if (program.recorded(kSomeSamples))
                program.interrupt();
        };
        untilItIsInterrupted();
        COMPARE_OUTCOME(program, 128 + SIGINT, "it is not started again", untilItIsInterrupted);
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void oneThatBreaksItsCapEndsWithSixAndAMotorAtRest()
    {
        ExperimentProgram program(
            kServo, "step speed --from 1000 --to 1500 --repeat 1 --hold 100 --max-rpm 1500");
        program.begin();
        COMPARE_OUTCOME(program, 6, "1500 rpm that are allowed");
        QVERIFY(program.run().out.isEmpty());
        QVERIFY(program.board().cli("info").out.contains(QStringLiteral("IDLE")));
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
        ExperimentProgram program(kServo, "step speed --from 1000 --to 1500 -o");
        const auto untilItsBoardIsGone = [&] {
            program.begin();
            if (!program.recorded(kSomeSamples))
                return;
            if (port)
                program.board().vanish();
            else
                program.board().freeze();
        };
        untilItsBoardIsGone();
        COMPARE_OUTCOME(program, 3, "Stop NOT confirmed", untilItsBoardIsGone);
        QVERIFY2(program.run().err.contains(reason), qPrintable(program.run().err));
    }

    /// Its set-point is not restored: at the next start the user is told where it goes.
    void whatAKilledRunLeavesIsNamedAtTheNextStart()
    {
        ExperimentProgram program(kServo, "step speed --from 1200 --to 1206 -o");
        const Simulator &board = program.board();
        program.begin();
        if (!program.recorded(kSomeSamples)) {
            COMPARE_END(program, 0);
            return;
        }
        program.kill();
        QTRY_VERIFY_WITH_TIMEOUT(board.cli("info").out.contains(QStringLiteral("IDLE")),
            kPatience_ms); // by the guardian
        const CliRun start = board.cli("start");
        COMPARE_STATUS(start, 0);
        QVERIFY2(start.out.contains(QStringLiteral("Start -> 120")), qPrintable(start.out));
        COMPARE_STATUS(board.cli("stop"), 0);
    }

    /// With the words that bring it back.
    void whatAKilledRunHasBorrowedIsNamedUntilItIsBack()
    {
        QDir notes(session::lentFolder());
        notes.removeRecursively();
        ExperimentProgram program(kWithoutSensor, "identify electrical -o");
        const Simulator &board = program.board();
        const QString before = board.cli("get REVUP_DATA").out;
        program.begin();
        const auto borrowed = [&notes] { return !notes.entryList(QDir::Files).isEmpty(); };
        while (!borrowed() && !program.ended()) { }
        if (!borrowed()) {
            COMPARE_END(program, 0);
            return;
        }
        program.kill();
        QTRY_VERIFY_WITH_TIMEOUT(board.cli("info").out.contains(QStringLiteral("IDLE")),
            kPatience_ms); // by the guardian
        static const QRegularExpression way(QStringLiteral(
            "An experiment was cut off before it gave back what it had borrowed: REVUP_DATA may "
            "hold what the experiment wrote; what it held before comes back with: rotorscope-cli "
            "set REVUP_DATA=\"([0-9A-F ]+)\"\\."));
        const CliRun met = board.cli("info");
        const auto told = way.match(met.err);
        QVERIFY2(told.hasMatch(), qPrintable(met.err));
        COMPARE_STATUS(board.cli("set", {QStringLiteral("REVUP_DATA=") + told.captured(1)}), 0);
        QCOMPARE(board.cli("get REVUP_DATA").out, before);
        QCOMPARE(board.cli("info").err, QString());
    }

    /// Its Stop comes first, and nothing is written behind it.
    void whatCtrlCLeavesIsSaid()
    {
        constexpr qint64 kDrivenByTorque = 800'000; ///< bytes of a recording with twice as many
        ExperimentProgram program(kServo, "identify mechanical -o");
        const auto untilItIsInterrupted = [&] {
            program.begin();
            if (program.recorded(kDrivenByTorque))
                program.interrupt();
        };
        untilItIsInterrupted();
        COMPARE_OUTCOME(program, 128 + SIGINT, "Interrupted.", untilItIsInterrupted);
        const QString said =
            QStringLiteral("the motor is in torque control now, it was in speed control");
        QVERIFY2(program.run().err.contains(said), qPrintable(program.run().err));
        QVERIFY(program.board().cli("info").out.contains(QStringLiteral("IDLE")));
        const CliRun kept = support::runCli({QStringLiteral("evaluate"), program.file()});
        QVERIFY2(kept.err.contains(said), qPrintable(kept.err));
    }

    void whatCannotBeDoneMovesNothing_data()
    {
        QTest::addColumn<QString>("line");
        QTest::addColumn<int>("status");
        QTest::newRow("too fast") << QStringLiteral("step speed --from 1000 --to 9000") << 1;
        QTest::newRow("beyond one's own")
            << QStringLiteral("step speed --from 1000 --to 1500 --max-rpm 1400") << 1;
        // 3 % of it, and not of the speed that is usual.
        QTest::newRow("a swing beyond one's own")
            << QStringLiteral("response speed --speed 3500 --max-rpm 3600") << 1;
        QTest::newRow("too long") << QStringLiteral(
            "step speed --from 1000 --to 1500 --repeat 30 --hold 2000")
                                  << 1;
        QTest::newRow("no step") << QStringLiteral("step speed --from 1000 --to 1000") << 1;
        QTest::newRow("no end") << QStringLiteral("step speed --from 1000") << 2;
        QTest::newRow("no number") << QStringLiteral("step speed --from x --to 1000") << 2;
        QTest::newRow("another kind") << QStringLiteral("step voltage --from 1 --to 2") << 2;
        QTest::newRow("a torque that brakes")
            << QStringLiteral("step torque --from -1 --to 1") << 1;
        QTest::newRow("a flux beyond one's own")
            << QStringLiteral("step flux --from 0 --to 2 --max-amps 1") << 1;
        QTest::newRow("no current") << QStringLiteral("step torque --from 0 --to x") << 2;
        QTest::newRow("a speed at a speed")
            << QStringLiteral("step speed --from 900 --to 1000 --speed 500") << 2;
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

    /// Before anything moves, and not in the middle by its envelope.
    void aStepThatEndsTooNearWhatAnObserverNeedsIsRefused()
    {
        const Simulator board(kWithoutSensor);
        QVERIFY(board.ready());
        const CliRun run = board.cli("step speed --from 1200 --to 1500");
        COMPARE_STATUS(run, 1);
        QVERIFY(run.oneLineOfError());
        QVERIFY2(
            run.err.contains(QStringLiteral("eep both speeds at 1284 rpm")), qPrintable(run.err));
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void aRecordingOfARefusedRunSaysWhyItWasRefused()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const QString file = board.file("refused.pcapng");
        COMPARE_STATUS(board.cli("torque 0.1 0"), 0); // the board is not in speed control then
        const CliRun refused = board.cli("step speed --from 1000 --to 1500 -o", {file});
        COMPARE_STATUS(refused, 1);
        const QString why = QStringLiteral("the motor is not in speed control");
        QVERIFY2(refused.err.contains(why), qPrintable(refused.err));
        const CliRun kept = support::runCli({QStringLiteral("evaluate"), file});
        COMPARE_STATUS(kept, 1);
        QVERIFY2(kept.err.contains(QStringLiteral("The experiment ended early: ") + why),
            qPrintable(kept.err));
    }

    /// It is gone when that is read.
    void aFileThatIsNotKeptIsNotNamed()
    {
        ExperimentProgram program(kServo, "experiment");
        QVERIFY(program.board().ready());
        QFile plan(program.board().file("plan.json"));
        QVERIFY(plan.open(QIODevice::WriteOnly));
        plan.write(R"({"experiment":"spin","length_ms":1000})"); // too short for a number
        plan.close();
        program.begin({plan.fileName()});
        COMPARE_OUTCOME(program, 1, "The recording: ");
        QVERIFY2(
            !program.run().err.contains(QStringLiteral(".pcapng")), qPrintable(program.run().err));
    }

    void aFullDiskIsSaidOfAFileThatIsNotKept()
    {
        ExperimentProgram program(kServo, "step speed --from 1000 --to 1300 --repeat 1 --hold 200");
        QVERIFY(program.board().ready());
        constexpr rlim_t kLittleRoom = 100'000;
        const auto withLittleRoom = [&program] {
            const support::SizeLimit limit(kLittleRoom);
            program.begin();
        };
        withLittleRoom();
        COMPARE_OUTCOME(program, 5, "The recording ends early: ", withLittleRoom);
        const QString &said = program.run().err;
        QVERIFY2(!said.contains(QStringLiteral(".pcapng"))
                && !said.contains(QStringLiteral("recorded until then")),
            qPrintable(said));
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

    void aFolderThatIsNotThereIsNamedAsTheReason()
    {
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const CliRun run =
            board.cli("step speed --from 1000 --to 1500 -o", {board.file("none/run.pcapng")});
        COMPARE_STATUS(run, 5);
        QVERIFY2(run.err.contains(QStringLiteral("its folder is not there")), qPrintable(run.err));
        QVERIFY(run.oneLineOfError());
        QVERIFY(board.cli("info").out.contains(QStringLiteral("IDLE")));
    }

    void boardsThatRecordNothingAndFilesWithoutASeriesSayWhy()
    {
        for (const auto &[kind, why] :
            {std::pair("speed", "nothing says how fast this motor may turn"),
                std::pair("torque", "Nothing can be measured"),
                std::pair("flux", "Nothing can be measured")}) {
            const CliRun older =
                support::runCli({QStringLiteral("--port"), QStringLiteral("sim:legacy"),
                    QStringLiteral("step"), QLatin1String(kind), QStringLiteral("--from"),
                    QStringLiteral("500"), QStringLiteral("--to"), QStringLiteral("900")});
            COMPARE_STATUS(older, 1);
            QVERIFY2(older.err.contains(QLatin1String(why)) && older.oneLineOfError(),
                qPrintable(older.err));
        }
        const Simulator board(kServo);
        QVERIFY(board.ready());
        const QString file = board.file("other.pcapng");
        COMPARE_STATUS(board.cli("capture --hf I_A --seconds 0.2 --record", {file}), 0);
        const CliRun none = support::runCli({QStringLiteral("evaluate"), file});
        COMPARE_STATUS(none, 1);
        QVERIFY2(none.err.contains(QStringLiteral("no recording of an experiment")),
            qPrintable(none.err));
    }

private:
    static bool turnsAt1800(const Simulator &board)
    {
        const QString last =
            board.cli("get --raw SPEED_MEAS").out.trimmed().section(QLatin1Char(' '), -1);
        return std::abs(last.toInt() - 1800) < 60;
    }
    static void startAt1800(const Simulator &board)
    {
        COMPARE_STATUS(board.cli("ramp 1800 0"), 0);
        COMPARE_STATUS(board.cli("start"), 0);
        QTRY_VERIFY_WITH_TIMEOUT(turnsAt1800(board), kPatience_ms);
    }
    static void theFileSaysTheSame(ExperimentProgram &program)
    {
        const CliRun again =
            support::runCli({QStringLiteral("evaluate"), QStringLiteral("--json"), program.file()});
        COMPARE_STATUS(again, 0);
        QCOMPARE(again.out, program.run().out);
        QVERIFY(program.board().cli("info").out.contains(QStringLiteral("IDLE")));
    }

    std::unique_ptr<ExperimentProgram> m_step, m_torque, m_flux, m_response, m_current, m_mechanics,
        m_bothWays, m_electrics, m_tuning;
};

QTEST_GUILESS_MAIN(TestCliStep)
#include "tst_cli_step_posix.moc"
