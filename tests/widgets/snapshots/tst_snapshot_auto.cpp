// What a board held is kept before lists of registers are written, on a simulated board in virtual time.
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"
#include "support/edit_bench.h"
#include "widgets/snapshots/auto.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using catalog::Value;
using facts::EditBench;
using State = widgets::RegisterModel::EditState;
using namespace std::chrono_literals;

namespace {

struct Bench : EditBench {
    QTemporaryDir home;
    widgets::AutoSnapshots snapshots{device, home.filePath(QStringLiteral("snapshots"))};

    Bench()
    {
        edits.keepBeforeWriting(snapshots);
        arm();
    }
    void typeTwo(int kp, int ki)
    {
        type("SPEED_KP", QString::number(kp));
        type("SPEED_KI", QString::number(ki));
    }
    const snapshots::Snapshot &newest() const { return *snapshots.kept().front().snapshot; }
};

Value valueIn(const snapshots::Snapshot &snapshot, const char *name)
{
    const snapshots::Entry *entry = snapshot.find(name, 1);
    return entry != nullptr ? entry->value : Value(std::string("missing"));
}

} // namespace

class TestSnapshotAuto : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void whatTheBoardHeldIsKeptBeforeAListIsWritten()
    {
        Bench bench;
        const Value kp = bench.held("SPEED_KP"), ki = bench.held("SPEED_KI");
        const auto all = bench.readAll();
        bench.typeTwo(77, 78);
        bench.edits.apply();
        QVERIFY(bench.edits.underWay());
        QVERIFY(bench.writes.empty()); // reads first
        QVERIFY(bench.settle());
        QVERIFY(bench.held("SPEED_KP") == Value(std::int64_t{77}));
        QCOMPARE(bench.snapshots.kept().size(), 1U);
        QVERIFY(valueIn(bench.newest(), "SPEED_KP") == kp);
        QVERIFY(valueIn(bench.newest(), "SPEED_KI") == ki);
        const auto tunable = std::count_if(all.begin(), all.end(),
            [&](const auto &one) { return bench.device.catalog()->find(one.first)->restorable(); });
        QCOMPARE(bench.newest().entries.size(), std::size_t(tunable));
        QTRY_VERIFY(!bench.snapshots.kept().front().file.isEmpty());
        const auto text = session::readWholeFile(bench.snapshots.kept().front().file);
        QVERIFY(text);
        const auto read = session::readSnapshotJson(*text);
        QVERIFY(read);
        QVERIFY(valueIn(*read, "SPEED_KP") == kp);
    }

    void aSingleRegisterIsWrittenAtOnce()
    {
        Bench bench;
        bench.type("SPEED_KP", QStringLiteral("77"));
        bench.edits.apply();
        QCOMPARE(bench.writes.size(), 1U);
        QVERIFY(bench.settle());
        QVERIFY(bench.snapshots.kept().empty());
    }

    void anUndoOfAListIsOneToo()
    {
        Bench bench;
        bench.typeTwo(77, 78);
        QVERIFY(bench.apply());
        bench.edits.undo();
        QVERIFY(bench.settle());
        QCOMPARE(bench.snapshots.kept().size(), 2U);
        QVERIFY(valueIn(bench.newest(), "SPEED_KP") == Value(std::int64_t{77}));
    }

    void aStopMeanwhileLeavesTheEditsAndWritesNothing()
    {
        Bench bench;
        bench.typeTwo(77, 78);
        bench.edits.apply();
        // In the middle of reading.
        QVERIFY(bench.link.runUntil([&] { return bench.link.requests.size() > 3; }, 1s));
        QVERIFY(bench.edits.underWay());
        const std::size_t before = bench.link.sent.size();
        bench.link.drive->stop(bench.link.now);
        bench.device.armedChanged(false);
        QVERIFY(bench.settle());
        QVERIFY(bench.writes.empty());
        QVERIFY(bench.model.editState(bench.id("SPEED_KP")) == State::Pending);
        QVERIFY(bench.told.last().startsWith(QStringLiteral("Nothing was written"))
            || bench.told.last().contains(QStringLiteral("Arm")));
        QVERIFY(bench.link.runUntil(
            [&] {
                return !bench.link.stops.empty()
                    && bench.link.stops.back().word == drive::StopWord::MayCoast;
            },
            5s));
        // The stop did not wait for what was still to be read: it is among the first bytes after it.
        const Bytes stop{0x19, 0x00};
        const auto from = bench.link.sent.begin() + static_cast<std::ptrdiff_t>(before);
        const auto at = std::search(from, bench.link.sent.end(), stop.begin(), stop.end());
        QVERIFY(at != bench.link.sent.end() && at - from < 64);
    }

    void aLostLinkMeanwhileLeavesTheEdits()
    {
        Bench bench;
        bench.typeTwo(77, 78);
        bench.edits.apply();
        bench.link.toBoard.cut = bench.link.toDrive.cut = true;
        QVERIFY(bench.link.runUntil([&] { return !bench.edits.underWay(); }, 30s));
        QVERIFY(bench.writes.empty());
        QVERIFY(bench.model.editState(bench.id("SPEED_KP")) == State::Pending);
        QVERIFY(bench.told.join(QLatin1Char('\n')).contains(QStringLiteral("Nothing was written")));
    }

    void aDiskThatDoesNotTakeItIsToldAndTheWriteGoesOn_data()
    {
        QTest::addColumn<bool>("beforeTheEnd");
        QTest::newRow("before the write has ended") << true;
        QTest::newRow("whenever it is") << false;
    }
    void aDiskThatDoesNotTakeItIsToldAndTheWriteGoesOn()
    {
        QFETCH(const bool, beforeTheEnd);
        Bench bench;
        const QSignalSpy warned(&bench.snapshots, &widgets::AutoSnapshots::told);
        QFile inTheWay(bench.home.filePath(QStringLiteral("snapshots"))); // a file, not a folder
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        inTheWay.close();
        bench.typeTwo(77, 78);
        bench.edits.apply();
        if (beforeTheEnd) {
            // Read, not yet written.
            QVERIFY(bench.link.runUntil([&] { return !bench.snapshots.kept().empty(); }, 1s));
            QTRY_COMPARE(warned.size(), 1);
            QVERIFY(bench.edits.underWay());
        }
        QVERIFY(bench.settle());
        QVERIFY(bench.held("SPEED_KP") == Value(std::int64_t{77}));
        QTRY_VERIFY(bench.told.last().contains(QStringLiteral("in memory only")));
        QVERIFY(bench.told.filter(QStringLiteral("2 register")).size() == 1); // nor is the end lost
        QCOMPARE(bench.snapshots.kept().size(), 1U);
        QVERIFY(bench.snapshots.kept().front().file.isEmpty());
        QCOMPARE(bench.edits.steps().count(), 1); // it can be taken back, too
    }

    void aMotorThatStartsMeanwhileIsAskedAbout()
    {
        Bench bench;
        bench.typeTwo(1, 1); // by much more than the double
        bench.edits.apply();
        QCOMPARE(bench.questions, 0);
        facts::feed(bench.device, {facts::status(drive::MotorState::Running)});
        QVERIFY(bench.link.runUntil(
            [&] {
                facts::feed(bench.device, {facts::status(drive::MotorState::Running)});
                QCoreApplication::processEvents();
                return bench.questions > 0 || !bench.edits.underWay();
            },
            5s));
        QCOMPARE(bench.questions, 1);
        QVERIFY(bench.writes.empty());
    }

    void whatABuildDoesNotHaveIsAskedForOnce()
    {
        Bench bench;
        bench.typeTwo(77, 78);
        const TimePoint first = bench.link.now;
        QVERIFY(bench.apply());
        const TimePoint second = bench.link.now;
        bench.typeTwo(87, 88);
        QVERIFY(bench.apply());
        QVERIFY(bench.link.now - second < (second - first) / 2);
    }

    void theFolderKeepsANumberAndOnlyItsOwn()
    {
        const QTemporaryDir home;
        session::SnapshotFolder folder(home.path());
        QSignalSpy saved(&folder, &session::SnapshotFolder::saved);
        QFile own(home.filePath(QStringLiteral("2020-01-01_00-00-00_motor_snapshot.json")));
        QVERIFY(own.open(QIODevice::WriteOnly)); // the user's
        const QDateTime at(QDate(2026, 5, 4), QTime(13, 2, 59));
        snapshots::Snapshot snapshot;
        snapshots::Entry entry;
        entry.name = "SPEED_KP";
        entry.motor = 1;
        const int count = int(session::SnapshotFolder::kMostFiles) + 5;
        for (int i = 0; i < count; ++i) {
            entry.value = std::int64_t{i};
            snapshot.entries = {entry};
            folder.save(at.addSecs(i / 2), snapshot); // two of each second
        }
        folder.save(at.addSecs(1000), snapshot); // nothing new
        QTRY_COMPARE(saved.size(), count + 1);
        QVERIFY(own.exists());
        const QStringList files = folder.files();
        QCOMPARE(files.size(), session::SnapshotFolder::kMostFiles);
        QCOMPARE(saved.last().at(0).toString(), saved.at(count - 1).at(0).toString());
        QCOMPARE(files.first(), saved.last().at(0).toString()); // the newest comes first
        QVERIFY(files.contains(saved.at(count - 2).at(0).toString()));
        QVERIFY(!files.contains(saved.first().at(0).toString())); // the oldest went
    }

    void whatWasAskedForIsWrittenBeforeTheFolderEnds()
    {
        const QTemporaryDir home;
        const QDateTime at(QDate(2026, 5, 4), QTime(13, 2, 59));
        {
            session::SnapshotFolder folder(home.path());
            folder.save(at, {});
        }
        QVERIFY(QFile::exists(
            home.filePath(QStringLiteral("2026-05-04_13-02-59_motor_before-write.json"))));
    }
};

QTEST_MAIN(TestSnapshotAuto)
#include "tst_snapshot_auto.moc"
