// A run book: what is kept is read back, nothing that is there is overwritten, and a file that makes no sense costs no other.
#include "session/files/run_book.h"
#include "session/files/whole_file.h"
#include "session/recording/recording_reader.h"

#include <QDir>
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <random>

namespace {

/// One that ended before anything was measured.
session::EndedRun anEndedRun()
{
    session::EndedRun run;
    run.begin = {1'700'000'000, "test", "sim"};
    run.plan = {1'000, {"step plan", {{"from rpm", "1000"}, {"to rpm", "1500"}}}};
    auto told = std::make_shared<session::Told>();
    told->at = 2'000;
    told->entries.emplace_back(record::Happening{"motor state", {{"state", "IDLE"}}});
    run.told.push_back(std::move(told));
    run.end = {3'000, {"experiment ended", {{"outcome", "ended early"}, {"reason", "a test"}}}};
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
        QCOMPARE(report->happenings.front().what.name, std::string("step plan"));
        QCOMPARE(report->snapshots.size(), 1U);
        QVERIFY(report->ending && report->damage.empty());
        QVERIFY(contentOf(session::registersOf(folder.path(), 1)).contains("SPEED_KP"));
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
