// A recording on a disk that fails at any block: what was counted stays, the file says how it ended, and nothing more
// is asked of the disk.
#include "recorded/block.h"
#include "recorded/restore.h"
#include "session/recording/file.h"
#include "session/recording/notes.h"
#include "session/recording/reader.h"
#include "support/recording_facts.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cstring>
#include <limits>

using namespace session;

class TestRecordingFile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsCountedIsInTheFile();
    void anOldFileIsLeftAlone();
    void itsPictureIsThereBeforeItsSamplesAreRead();
    void whatIsNotKnownHidesNoPicture_data();
    void whatIsNotKnownHidesNoPicture();
    void whereverTheDiskFailsTheRecordingEndsWithAMark();
    void aDiskWithoutRoomForAMarkGetsItInItsPlace();
    void hardlyAnyRoomLeftEndsItCleanly();
    void aFailedSyncEndsIt();
    void anEntryThatFitsNoBlockIsLeftOutAndCounted();
    void whatHappenedYearsAwayIsPassedOver();
};

namespace {

/// A file in memory, and a disk that takes so many blocks.
struct FakeDisk {
    Bytes file;
    int appends = 1'000'000; ///< that succeed from now on
    bool takesMark = true; ///< after the first failure
    bool syncs = true;
    int calls = 0;
};

class FakeSink : public BlockSink {
public:
    explicit FakeSink(FakeDisk &disk)
        : m_disk(disk)
    {
    }
    bool append(ByteView bytes) override
    {
        ++m_disk.calls;
        if (m_disk.appends-- <= 0 && !(m_disk.takesMark && m_failed))
            return !(m_failed = true);
        m_disk.file.insert(m_disk.file.end(), bytes.begin(), bytes.end());
        return true;
    }
    bool overwrite(std::size_t offset, ByteView bytes) override
    {
        if (offset + bytes.size() > m_disk.file.size())
            return false;
        std::copy(
            bytes.begin(), bytes.end(), m_disk.file.begin() + static_cast<std::ptrdiff_t>(offset));
        return true;
    }
    bool sync() override { return m_disk.syncs; }
    qint64 freeBytes() const override { return 1'000'000'000; }
    bool isFull() const override { return true; }
    QString systemText() const override { return QStringLiteral("no room"); }

private:
    FakeDisk &m_disk;
    bool m_failed = false;
};

capture::StreamLayout layout() { return {1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}}; }

capture::SampleBlock block(capture::Tick tick)
{
    return {1, tick, 40'000, std::vector<std::int16_t>(40'000, std::int16_t(tick / 40'000)), {}, 0};
}

support::RecordingFacts read(const Bytes &bytes)
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QFile file(path);
    if (file.open(QIODevice::WriteOnly))
        file.write(reinterpret_cast<const char *>(bytes.data()), qint64(bytes.size()));
    file.close();
    return support::readRecording(path);
}

/// Ten blocks of samples, or as many as the disk takes. @return samples that were counted as written
std::uint64_t record10(RecordingFile &file)
{
    if (!file.open())
        return 0;
    file.add(0, layout());
    for (capture::Tick i = 0; i < 10; ++i)
        file.add(i, block(i * 40'000));
    file.end();
    return file.counts().samples;
}

} // namespace

void TestRecordingFile::whatIsCountedIsInTheFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", "here"});
    QVERIFY(file.open());
    QVERIFY(file.add(0, layout()));
    QVERIFY(file.add(0, block(0)));
    // Counted means that another program can read it, though nothing was closed.
    QCOMPARE(qint64(file.counts().bytes), QFileInfo(path).size());
    QCOMPARE(support::readRecording(path).samples(), file.counts().samples);
    QCOMPARE(file.counts().safeBytes, 0U);
    QVERIFY(file.add(1, recorded::Note{0, 1, "x"}));
    QVERIFY(file.end());
    QCOMPARE(file.counts().safeBytes, file.counts().bytes);
    const auto facts = support::readRecording(path);
    QCOMPARE(qint64(file.counts().bytes), QFileInfo(path).size());
    QVERIFY(facts.damage.empty());
    QCOMPARE(facts.ending->reason, recorded::End::Reason::Stopped);
    QCOMPARE(facts.ending->samples, 40'000U);
    QCOMPARE(facts.all<recorded::Begin>().at(0).source, std::string("here"));
    QVERIFY(!file.add(2, recorded::Note{0, 1, "late"}));
}

void TestRecordingFile::itsPictureIsThereBeforeItsSamplesAreRead()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", "here"});
    QCOMPARE(record10(file), 400'000U);
    capture::Capture whole;
    const auto report = readRecording(path, whole);
    QVERIFY(report && report->damagedPlaces == 0);
    capture::Capture overview;
    QVERIFY(readOverview(path, overview));
    QVERIFY(overview.size(1) < 5000);
    QCOMPARE(overview.timeSpan()->from, whole.timeSpan()->from);
    QVERIFY(std::abs(overview.timeSpan()->to - whole.timeSpan()->to) < 0.02);
    QCOMPARE(overview.extremes(1, 0.0, 30.0).max, whole.extremes(1, 0.0, 30.0).max);

    // Notes that were added later are behind it.
    const QString noted = folder.filePath(QStringLiteral("n.pcapng"));
    QVERIFY(QFile::exists((saveNotes(path, noted, {{0, 1, "later"}}), noted)));
    capture::Capture again;
    QVERIFY(readOverview(noted, again));
    QCOMPARE(again.size(1), overview.size(1));

    // One that is damaged is told with the rest, and is none; so is one that was never written.
    QFile bytes(path);
    QVERIFY(bytes.open(QIODevice::ReadWrite));
    QByteArray all = bytes.readAll();
    const qsizetype place = all.lastIndexOf(QByteArrayLiteral("RS\x01\x0B"));
    QVERIFY(place > 0);
    all[place + 200] = char(~all[place + 200]);
    bytes.seek(0);
    bytes.write(all);
    bytes.close();
    capture::Capture none;
    QVERIFY(!readOverview(path, none));
    QVERIFY(none.channels().empty());
    capture::Capture sound;
    const auto damaged = readRecording(path, sound);
    QVERIFY(damaged && damaged->damagedPlaces == 1);
    QCOMPARE(sound.size(1), 400'000U);
    QFile interrupted(folder.filePath(QStringLiteral("i.pcapng")));
    QVERIFY(interrupted.open(QIODevice::WriteOnly));
    interrupted.write(all.first(place - 28)); // as far as the samples go
    interrupted.close();
    QVERIFY(!readOverview(interrupted.fileName(), none));
    QVERIFY(!readOverview(folder.filePath(QStringLiteral("nothing.pcapng")), none));
}

void TestRecordingFile::whatIsNotKnownHidesNoPicture_data()
{
    QTest::addColumn<Bytes>("stranger");
    QTest::addColumn<int>("times");
    QTest::addColumn<bool>("found");
    const auto ours = [](Bytes data) { return recorded::packetBlock({}, std::move(data)); };
    const Bytes later = ours({'R', 'S', 1, 77, 1, 2, 3});
    QTest::newRow("a later kind") << later << 1 << true;
    QTest::newRow("many") << later << 100 << true;
    const auto other = [](std::uint32_t type, std::uint32_t length, std::uint32_t again) {
        return ByteWriter().u32(type).u32(length).bytes(Bytes(length - 12)).u32(again).take();
    };
    QTest::newRow("another program's") << other(5, 64, 64) << 3 << true;
    QTest::newRow("its least") << other(5, 12, 12) << 1 << true;
    QTest::newRow("whose lengths differ") << other(5, 64, 32) << 1 << false;
    QTest::newRow("another section") << other(recorded::kSectionBlock, 64, 64) << 1 << false;
    QTest::newRow("as many bytes as take too long") << other(5, 1 << 20, 1 << 20) << 17 << false;
    QTest::newRow("as many as take too long") << other(5, 12, 12) << 5000 << false;
    QTest::newRow("an overview without sense") << ours({'R', 'S', 1, 11, 1, 2, 3}) << 1 << false;
    QTest::newRow("nobody's data") << ours({'X', 'Y', 1, 77}) << 1 << false;
    Bytes damaged = later;
    damaged[30] ^= 1U;
    QTest::newRow("damaged") << damaged << 1 << false;
}

/// Behind the end, and between it and the picture.
void TestRecordingFile::whatIsNotKnownHidesNoPicture()
{
    QFETCH(const Bytes, stranger);
    QFETCH(const int, times);
    QFETCH(const bool, found);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", "here"});
    QCOMPARE(record10(file), 400'000U);
    QFile bytes(path);
    QVERIFY(bytes.open(QIODevice::ReadWrite));
    const QByteArray all = bytes.readAll();
    const QByteArray strange =
        QByteArray(reinterpret_cast<const char *>(stranger.data()), qsizetype(stranger.size()))
            .repeated(times);
    std::uint32_t ofTheEnd = 0;
    std::memcpy(&ofTheEnd, all.constData() + all.size() - 4, 4);
    for (const qsizetype place : {all.size(), all.size() - qsizetype(ofTheEnd)}) {
        bytes.resize(0);
        bytes.seek(0);
        bytes.write(QByteArray(all).insert(place, strange));
        QVERIFY(bytes.flush());
        capture::Capture overview;
        QCOMPARE(readOverview(path, overview), found);
        QCOMPARE(overview.channels().empty(), !found);
    }
}

void TestRecordingFile::anOldFileIsLeftAlone()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QFile old(path);
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    QString text;
    QVERIFY(!makeDiskSink(path, text));
    QVERIFY(!text.isEmpty());
    QCOMPARE(QFileInfo(path).size(), 3);
    QVERIFY(!makeDiskSink(folder.filePath(QStringLiteral("no/folder.pcapng")), text));
}

void TestRecordingFile::whereverTheDiskFailsTheRecordingEndsWithAMark()
{
    for (int k = 1; k < 12; ++k) {
        FakeDisk disk;
        disk.appends = k;
        RecordingFile file(std::make_unique<FakeSink>(disk), {});
        const std::uint64_t counted = record10(file);
        QVERIFY(file.isOver());
        const auto facts = read(disk.file);
        QCOMPARE(facts.samples(), counted);
        QVERIFY(facts.ending.has_value());
        QCOMPARE(facts.ending->reason, recorded::End::Reason::DiskFull);
        QCOMPARE(facts.ending->text, std::string("no room"));
        // Two attempts more than succeeded, and never again.
        QCOMPARE(disk.calls, k + 2);
        QVERIFY(!file.add(9, block(400'000)));
        QCOMPARE(disk.calls, k + 2);
    }
}

void TestRecordingFile::aDiskWithoutRoomForAMarkGetsItInItsPlace()
{
    FakeDisk disk;
    disk.appends = 5;
    disk.takesMark = false;
    RecordingFile file(std::make_unique<FakeSink>(disk), {});
    const std::uint64_t counted = record10(file);
    const auto facts = read(disk.file);
    QVERIFY(facts.damage.empty());
    QCOMPARE(facts.samples(), counted);
    QCOMPARE(facts.ending->reason, recorded::End::Reason::DiskFull);
    QCOMPARE(quint64(disk.file.size()), file.counts().bytes);
}

void TestRecordingFile::hardlyAnyRoomLeftEndsItCleanly()
{
    FakeDisk disk;
    RecordingFile file(std::make_unique<FakeSink>(disk), {});
    QVERIFY(file.open() && file.add(0, layout()) && file.add(0, capture::SampleBlock(block(0))));
    file.endForWantOfRoom();
    QVERIFY(file.isOver());
    const auto facts = read(disk.file);
    QVERIFY(facts.damage.empty());
    QCOMPARE(facts.samples(), 40'000U);
    QCOMPARE(facts.ending->reason, recorded::End::Reason::DiskFull);
}

void TestRecordingFile::aFailedSyncEndsIt()
{
    FakeDisk disk;
    disk.syncs = false;
    RecordingFile file(std::make_unique<FakeSink>(disk), {});
    QVERIFY(file.open());
    QVERIFY(!file.sync());
    QVERIFY(file.isOver());
    QCOMPARE(file.counts().safeBytes, 0U);
    QVERIFY(read(disk.file).ending.has_value());
}

void TestRecordingFile::anEntryThatFitsNoBlockIsLeftOutAndCounted()
{
    FakeDisk disk;
    RecordingFile file(std::make_unique<FakeSink>(disk), {});
    QVERIFY(file.open());
    QVERIFY(file.add(0, recorded::Note{0, 0, std::string(100'000, 'x')}));
    QCOMPARE(file.leftOut(), 1U);
    QVERIFY(file.end());
    QVERIFY(read(disk.file).all<recorded::Note>().empty());
}

/// Times of a file made up by hand: differences of them would not fit any number.
void TestRecordingFile::whatHappenedYearsAwayIsPassedOver()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.pcapng"));
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", "board"});
    file.open();
    for (const recorded::Nanos at :
        {std::numeric_limits<recorded::Nanos>::min(), -recorded::kFarthest, recorded::Nanos{5},
            recorded::kFarthest, std::numeric_limits<recorded::Nanos>::max()})
        file.add(at, recorded::Happening{"stop", {}});
    file.end();
    capture::Capture capture;
    const auto report = readRecording(path, capture);
    QVERIFY(report);
    QCOMPARE(report->happenings.size(), std::size_t(1));
    QCOMPARE(report->happenings[0].first, recorded::Nanos{5});
}

QTEST_APPLESS_MAIN(TestRecordingFile)
#include "tst_recording_file.moc"
