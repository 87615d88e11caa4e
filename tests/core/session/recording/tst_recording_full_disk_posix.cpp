// A real file on a disk that is full after so many bytes: a limit on the file's size gives the same short write as a
// full disk, without one.
#include "session/recording/file.h"
#include "session/recording/recording.h"
#include "support/programs/size_limit_posix.h"
#include "support/recording_facts.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace session;
using support::SizeLimit;

class TestRecordingFullDisk : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whereverItFillsAllThatWasWrittenReadsBack();
    void aDiskWithoutRoomForTheHeadIsLeftWithoutAFile_data();
    void aDiskWithoutRoomForTheHeadIsLeftWithoutAFile();
};

namespace {

RecordingFile::Counts recordBlocks(const QString &path)
{
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", ""});
    if (!file.open())
        return file.counts();
    file.add(0, capture::StreamLayout{1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    for (capture::Tick i = 0; i < 20 && !file.isOver(); ++i) {
        file.add(
            i, capture::SampleBlock{1, i * 1000, 1000, std::vector<std::int16_t>(1000, 7), {}, 0});
        file.flushAll();
    }
    file.end();
    return file.counts();
}

} // namespace

void TestRecordingFullDisk::whereverItFillsAllThatWasWrittenReadsBack()
{
    QTemporaryDir folder;
    const auto whole = recordBlocks(folder.filePath(QStringLiteral("whole.pcapng")));
    QCOMPARE(whole.samples, 20'000U);
    int inPlace = 0;
    const qint64 total = qint64(whole.bytes);
    for (qint64 bytes = 1000; bytes < total; bytes += 1 + total / 97) {
        const QString path = folder.filePath(QStringLiteral("%1.pcapng").arg(bytes));
        RecordingFile::Counts counts;
        {
            const SizeLimit limit(static_cast<rlim_t>(bytes));
            counts = recordBlocks(path);
        }
        QVERIFY(counts.bytes <= quint64(bytes));
        const auto facts = support::readRecording(path);
        QCOMPARE(facts.samples(), counts.samples);
        QVERIFY(facts.ending.has_value());
        QCOMPARE(facts.ending->reason, recorded::End::Reason::DiskFull);
        QCOMPARE(QString::fromStdString(facts.ending->text), qt_error_string(EFBIG));
        inPlace += QFileInfo(path).size() == qint64(counts.bytes);
        for (const recorded::Damage &damage : facts.damage)
            QCOMPARE(damage.kind, recorded::Damage::Kind::Missing); // the block that was refused
    }
    QVERIFY(inPlace > 0); // at some lengths there was no room for the mark either
}

void TestRecordingFullDisk::aDiskWithoutRoomForTheHeadIsLeftWithoutAFile_data()
{
    QTest::addColumn<int>("room");
    QTest::newRow("nothing") << 0;
    QTest::newRow("an end, but no head") << 200;
}

void TestRecordingFullDisk::aDiskWithoutRoomForTheHeadIsLeftWithoutAFile()
{
    QFETCH(int, room);
    const QTemporaryDir folder;
    Recording recording(std::make_shared<RecordingTap>());
    QSignalSpy finished(&recording, &Recording::finished);
    {
        const SizeLimit limit(static_cast<rlim_t>(room));
        recording.start(folder.filePath(QStringLiteral("r.pcapng")), RecordingTap::Content::Samples,
            QStringLiteral("test"), {});
        finished.wait();
    }
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished[0][0].value<RecordingResult>().outcome, RecordingOutcome::DiskFull);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList());
}

QTEST_GUILESS_MAIN(TestRecordingFullDisk)
#include "tst_recording_full_disk_posix.moc"
