// A run book: what is kept is read back, nothing that is there is overwritten, and a file that makes no sense costs no
// other.
#include "session/files/run_book.h"
#include "session/files/run_stretches.h"
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "session/recording/file.h"
#include "session/recording/reader.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <map>
#include <random>

namespace {

/// One that ended before anything was measured.
session::EndedRun anEndedRun()
{
    session::EndedRun run;
    run.begin = {1'700'000'000, "test", "sim"};
    run.plan = {"step plan", {{"from rpm", "1000"}, {"to rpm", "1500"}}};
    const recorded::Happening end{
        "experiment ended", {{"outcome", "ended early"}, {"reason", "a test"}}};
    recorded::Nanos at = 1'000;
    for (const recorded::Happening &happening :
        {run.plan, recorded::Happening{"motor state", {{"state", "IDLE"}}}, end}) {
        auto told = std::make_shared<session::Told>();
        told->at = at++;
        told->entries.emplace_back(happening);
        run.told.push_back(std::move(told));
    }
    run.outcome = {lab::End::Refused, "a test", {}};
    run.board = QStringLiteral("Firmware \u2603");
    run.motorName = QStringLiteral("Motor");
    run.at = 1'700'000'123;
    snapshots::Snapshot registers;
    registers.board.firmware = "Firmware";
    registers.board.motorNames = {"Motor"};
    for (const auto &[name, motor, digits] : {std::tuple("SPEED_KP", 1, 700),
             std::tuple("SPEED_KI", 1, 30), std::tuple("SPEED_KP", 2, 5)}) {
        snapshots::Entry entry;
        entry.name = name;
        entry.motor = motor;
        entry.type = catalog::ValueType::S16;
        entry.tunable = true;
        entry.value = std::int64_t(digits);
        registers.entries.push_back(entry);
    }
    run.registers = std::move(registers);
    return run;
}

QByteArray contentOf(const QString &path)
{
    const auto content = session::readWholeFile(path);
    return content ? *content : QByteArray();
}

} // namespace

class TestRunBook : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsKeptIsReadBack()
    {
        QTemporaryDir folder;
        const auto first = session::keepRun(folder.path(), anEndedRun());
        QVERIFY2(first, first ? "" : qPrintable(first.error()));
        QCOMPARE(first->number, 1);
        QCOMPARE(first->gains,
            (QMap<QString, double>{
                {QStringLiteral("SPEED_KI"), 30}, {QStringLiteral("SPEED_KP"), 700}}));
        QVERIFY(first->result.isEmpty());
        QVERIFY(!first->notes.isEmpty()); // why nothing came of it
        session::EndedRun blind = anEndedRun();
        blind.registers.reset();
        const auto second = session::keepRun(folder.path(), blind);
        QVERIFY(second && second->number == 2 && !second->registers);

        const auto book = session::readRunBook(folder.path());
        QVERIFY(book);
        QVERIFY(book->problems.isEmpty());
        QCOMPARE(book->runs.size(), 2U);
        QVERIFY(book->runs[0] == *first);
        QVERIFY(book->runs[1] == *second);

        // Each of its files stands for itself.
        capture::Capture capture;
        const auto report = session::readRecording(session::recordingOf(folder.path(), 1), capture);
        QVERIFY(report);
        QCOMPARE(report->happenings.size(), 3U);
        QCOMPARE(report->happenings.front().second.name, std::string("step plan"));
        QCOMPARE(report->snapshots.size(), 1U);
        QVERIFY(report->ending && report->damage.empty());
        QVERIFY(contentOf(session::registersOf(folder.path(), 1)).contains("SPEED_KP"));
    }

    void aRecordingIsPartedWhereItsGainsChange()
    {
        using recorded::Nanos;
        constexpr Nanos kMilli = 1'000'000;
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("long.pcapng"));
        QString why;
        session::RecordingFile file(
            session::makeDiskSink(path, why), {1'700'000'000, "test", "sim"});
        QVERIFY(file.open());
        const auto run = anEndedRun();
        QVERIFY(file.add(0,
            recorded::RegisterSnapshot{
                "all registers", session::snapshotJson(*run.registers).toStdString()}));
        QVERIFY(file.add(0, recorded::PolledRegister{7, "BUS_VOLTAGE", "V"}));
        const auto written = [](const char *told) {
            return recorded::Happening{
                "ended", {{"wish", "1"}, {"outcome", "ok"}, {"reason", ""}, {"SPEED_KP", told}}};
        };
        for (Nanos ms = 100; ms <= 5000; ms += 100) {
            if (ms == 2000)
                QVERIFY(file.add(ms * kMilli, written("ok, was 700, is 350")));
            if (ms == 2200)
                QVERIFY(file.add(ms * kMilli, written("ok, was 350, is 300")));
            if (ms == 3000) // no change
                QVERIFY(file.add(ms * kMilli, written("refused, was 300, is 300, why")));
            const double volts = double(ms) / 1000.0;
            QVERIFY(file.add(ms * kMilli, recorded::PolledValues{{{7, ms * kMilli, volts}}}));
        }
        QVERIFY(file.end());

        const auto kept = session::keepStretches(folder.path(), path);
        QVERIFY2(kept, kept ? "" : qPrintable(kept.error()));
        QCOMPARE(kept->runs.size(), 2U);
        QCOMPARE(kept->leftOut, 1); // 0.2 s between two turns of a gain
        QCOMPARE(kept->runs[0].gains[QStringLiteral("SPEED_KP")], 700.0);
        QCOMPARE(kept->runs[1].gains[QStringLiteral("SPEED_KP")], 300.0);
        QCOMPARE(kept->runs[1].gains[QStringLiteral("SPEED_KI")], 30.0); // of the snapshot
        QVERIFY(kept->runs[0].notes.isEmpty() && kept->runs[0].result.isEmpty());
        QVERIFY(contentOf(session::registersOf(folder.path(), 2)).contains("300"));
        const auto millisOf = [&](int number) {
            capture::Capture capture;
            const auto report =
                session::readRecording(session::recordingOf(folder.path(), number), capture);
            const auto span = capture.timeSpan();
            const auto millis = [](double seconds) { return std::lround(seconds * 1000.0); };
            return report && report->damage.empty() && span
                ? std::pair(millis(span->from), millis(span->to))
                : std::pair(0L, 0L);
        };
        QCOMPARE(millisOf(1), std::pair(100L, 2000L));
        QCOMPARE(millisOf(2), std::pair(2300L, 5000L));
        const auto book = session::readRunBook(folder.path());
        QVERIFY(book && book->problems.isEmpty() && book->runs.size() == 2);
        QVERIFY(book->runs[1] == kept->runs[1]);

        QVERIFY(!session::keepStretches(folder.path(), folder.filePath(QStringLiteral("none"))));
        QVERIFY(!session::keepStretches(folder.path(), path, [](double) { return false; }));
        QCOMPARE(session::readRunBook(folder.path())->runs.size(), 2U);
    }

    /// Each run has one to tell, though its gains are the same; and has it whole, though it lends some.
    void aRecordingIsPartedWhereAnotherExperimentBegins()
    {
        using recorded::Nanos;
        constexpr Nanos kMilli = 1'000'000;
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("long.pcapng"));
        QString why;
        session::RecordingFile file(
            session::makeDiskSink(path, why), {1'700'000'000, "test", "sim"});
        QVERIFY(file.open());
        QVERIFY(file.add(0, recorded::PolledRegister{7, "BUS_VOLTAGE", "V"}));
        const recorded::Happening plan{
            "step plan", {{"motor", "1"}, {"from rpm", "1000"}, {"to rpm", "1500"}}};
        const recorded::Happening end{
            "experiment ended", {{"outcome", "complete"}, {"reason", ""}}};
        const auto written = [](const char *told) {
            return recorded::Happening{
                "ended", {{"wish", "1"}, {"outcome", "ok"}, {"reason", ""}, {"SPEED_KP", told}}};
        };
        const std::map<Nanos, recorded::Happening> what{{1000, plan}, {2000, end}, {3000, plan},
            {4000, end}, {5000, written("ok, was 700, is 350")}, {5500, plan},
            {5700, written("ok, was 350, is 90")}, {6300, written("ok, was 90, is 350")},
            {6500, end}};
        for (Nanos ms = 100; ms <= 7000; ms += 100) {
            QVERIFY(file.add(ms * kMilli, recorded::PolledValues{{{7, ms * kMilli, 24.0}}}));
            if (const auto at = what.find(ms); at != what.end())
                QVERIFY(file.add(ms * kMilli, at->second));
        }
        QVERIFY(file.end());

        const auto kept = session::keepStretches(folder.path(), path);
        QVERIFY2(kept, kept ? "" : qPrintable(kept.error()));
        QCOMPARE(kept->leftOut, 1); // half a second behind the last one
        QStringList times;
        for (const session::Run &run : kept->runs) {
            times.append(run.plan.front().second + QLatin1Char(' ') + run.plan.back().second);
            capture::Capture capture;
            const auto report =
                session::readRecording(session::recordingOf(folder.path(), run.number), capture);
            QVERIFY(report && report->damage.empty() && !report->happenings.empty());
            const auto plans = std::ranges::count_if(
                report->happenings, [](const auto &one) { return one.second.name == "step plan"; });
            QCOMPARE(int(plans), 1);
        }
        QCOMPARE(times,
            (QStringList{QStringLiteral("0.000 3.000"), QStringLiteral("3.000 5.000"),
                QStringLiteral("5.000 6.500")}));
    }

    void aStretchIsOfTheMotorThatWasMeasuredInIt()
    {
        using recorded::Nanos;
        constexpr Nanos kMilli = 1'000'000;
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("two.pcapng"));
        QString why;
        session::RecordingFile file(
            session::makeDiskSink(path, why), {1'700'000'000, "test", "sim"});
        QVERIFY(file.open());
        auto registers = *anEndedRun().registers;
        registers.board.motorNames = {"Left", "Right"};
        QVERIFY(file.add(0,
            recorded::RegisterSnapshot{
                "all registers", session::snapshotJson(registers).toStdString()}));
        QVERIFY(file.add(0, recorded::PolledRegister{7, "BUS_VOLTAGE", "V"}));
        const auto plan = [](const char *motor) {
            return recorded::Happening{
                "step plan", {{"motor", motor}, {"from rpm", "1000"}, {"to rpm", "1500"}}};
        };
        for (Nanos ms = 100; ms <= 4000; ms += 100) {
            QVERIFY(file.add(ms * kMilli, recorded::PolledValues{{{7, ms * kMilli, 24.0}}}));
            if (ms == 500 || ms == 2000)
                QVERIFY(file.add(ms * kMilli, plan(ms == 500 ? "2" : "1")));
        }
        QVERIFY(file.end());
        const auto kept = session::keepStretches(folder.path(), path);
        QVERIFY2(kept, kept ? "" : qPrintable(kept.error()));
        QCOMPARE(kept->runs.size(), 2U);
        QCOMPARE(kept->runs[0].motor, 2);
        QCOMPARE(kept->runs[0].motorName, QStringLiteral("Right"));
        QCOMPARE(kept->runs[0].gains, (QMap<QString, double>{{QStringLiteral("SPEED_KP"), 5}}));
        QCOMPARE(kept->runs[1].motor, 1);
        QCOMPARE(kept->runs[1].motorName, QStringLiteral("Left"));
        QCOMPARE(kept->runs[1].gains[QStringLiteral("SPEED_KP")], 700.0);
    }

    void aNoteAndAStarStay()
    {
        QTemporaryDir folder;
        QVERIFY(session::keepRun(folder.path(), anEndedRun()));
        QCOMPARE(
            session::annotateRun(folder.path(), 1, QStringLiteral("good \u2713"), true), QString());
        const auto book = session::readRunBook(folder.path());
        QCOMPARE(book->runs.front().note, QStringLiteral("good \u2713"));
        QVERIFY(book->runs.front().starred);
        QCOMPARE(book->runs.front().reason, QStringLiteral("a test"));
        QVERIFY(!session::annotateRun(folder.path(), 2, {}, true).isEmpty()); // there is none
    }

    void nothingThatIsThereIsOverwritten()
    {
        QTemporaryDir folder;
        const QString foreign = folder.filePath(QStringLiteral("run-0007.pcapng"));
        QVERIFY(session::writeWholeFile(foreign, "mine").isEmpty());
        const auto kept = session::keepRun(folder.path(), anEndedRun());
        QVERIFY(kept);
        QCOMPARE(kept->number, 8);
        QCOMPARE(contentOf(foreign), QByteArray("mine"));
    }

    void whatCannotBeKeptLeavesNothing()
    {
        QTemporaryDir folder;
        const QString noFolder = folder.filePath(QStringLiteral("file"));
        QVERIFY(session::writeWholeFile(noFolder, "x").isEmpty());
        const auto kept = session::keepRun(noFolder, anEndedRun());
        QVERIFY(!kept && !kept.error().isEmpty());
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("file")});
        QVERIFY(!session::readRunBook(folder.filePath(QStringLiteral("none"))));
    }

    void aFileThatMakesNoSenseIsNamedAndTheOthersAreRead()
    {
        QTemporaryDir folder;
        for (int i = 0; i < 3; ++i)
            QVERIFY(session::keepRun(folder.path(), anEndedRun()));
        const QString second = folder.filePath(QStringLiteral("run-0002.json"));
        const QByteArray whole = contentOf(second);
        const auto runsWith = [&](const QByteArray &content) {
            session::writeWholeFile(second, content);
            const auto book = session::readRunBook(folder.path());
            return book ? std::pair(book->runs.size(), book->problems)
                        : std::pair(0UL, QStringList());
        };
        for (const QByteArray &wrong : {QByteArray(), QByteArray("[]"), QByteArray("{}"),
                 whole.left(whole.size() / 2), QByteArray(whole).replace("rotorscope-run", "other"),
                 QByteArray(whole).replace("\"version\": 1", "\"version\": 2"),
                 QByteArray(2 << 20, ' ')}) {
            const auto [runs, problems] = runsWith(wrong);
            QCOMPARE(runs, 2UL);
            QCOMPARE(problems.size(), 1);
            QVERIFY(problems.first().startsWith(QLatin1String("run-0002.json: ")));
        }
        // Bytes that are off make another run or none, and nothing worse.
        std::mt19937 random(1);
        for (int round = 0; round < 500; ++round) {
            QByteArray damaged = whole;
            for (int i = 0; i < 3; ++i)
                damaged[qsizetype(random() % std::size_t(damaged.size()))] = char(random());
            const auto [runs, problems] = runsWith(damaged);
            QCOMPARE(runs + std::size_t(problems.size()), 3UL);
        }
    }

    void otherFilesAreNoRuns()
    {
        QTemporaryDir folder;
        QVERIFY(session::keepRun(folder.path(), anEndedRun()));
        for (const char *name : {"run-1.json", "run-0001.json.bak", "run-99999999.json",
                 "notes.json", "run-0001-registers.json", "run-00002.json"})
            if (const QString path = folder.filePath(QLatin1String(name)); !QFile::exists(path))
                session::writeWholeFile(path, "{}");
        const auto book = session::readRunBook(folder.path());
        QCOMPARE(book->runs.size(), 1U);
        QVERIFY(book->problems.isEmpty());
    }

    /// How long it takes is told, not judged: machines are busy.
    void aThousandRunsAreRead()
    {
        QTemporaryDir folder;
        QVERIFY(session::keepRun(folder.path(), anEndedRun()));
        const QByteArray run = contentOf(folder.filePath(QStringLiteral("run-0001.json")));
        for (int i = 2; i <= 1000; ++i) {
            QFile copy(
                folder.filePath(QStringLiteral("run-%1.json").arg(i, 4, 10, QLatin1Char('0'))));
            QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(run) == run.size());
        }
        QElapsedTimer timer;
        timer.start();
        const auto book = session::readRunBook(folder.path());
        qInfo("1,000 runs read in %lld ms", static_cast<long long>(timer.elapsed()));
        QVERIFY(book && book->runs.size() == 1000);
        QCOMPARE(book->runs.back().number, 1000);
    }

    void readingCanBeCancelled()
    {
        QTemporaryDir folder;
        for (int i = 0; i < 4; ++i)
            QVERIFY(session::keepRun(folder.path(), anEndedRun()));
        const auto book = session::readRunBook(folder.path(), [](double) { return false; });
        QVERIFY(book && book->runs.size() == 1);
    }
};

QTEST_GUILESS_MAIN(TestRunBook)
#include "tst_run_book.moc"
