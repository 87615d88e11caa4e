// A disk that takes no more while samples go there: what it has stays readable, the rest is kept in memory, and it goes
// round in what it has. A limit on the size of files gives the same short write as a full disk, without one.
#include "session/archive/disk_archive.h"
#include "support/capture_twins.h"
#include "support/once.h"
#include "support/programs/size_limit_posix.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <cerrno>

using session::ArchiveFailure;
using session::DiskArchive;
using support::SizeLimit;

class TestArchiveFullDisk : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whereverItFillsWhatIsThereIsRead_data();
    void whereverItFillsWhatIsThereIsRead();
    void aFolderThatTakesNoFilesIsToldOnce();
};

namespace {

constexpr std::size_t kMemory = 4'000'000;
constexpr std::size_t kPiece = 524288;

} // namespace

void TestArchiveFullDisk::whereverItFillsWhatIsThereIsRead_data()
{
    QTest::addColumn<qint64>("before");
    QTest::newRow("at once") << qint64(0);
    QTest::newRow("later") << qint64(1'200'000);
}

void TestArchiveFullDisk::whereverItFillsWhatIsThereIsRead()
{
    QFETCH(const qint64, before);
    QTemporaryDir folder;
    const auto archive =
        std::make_shared<DiskArchive>(DiskArchive::Config{folder.path(), 64'000'000, 0, kPiece});
    const QSignalSpy failures(archive.get(), &DiskArchive::failed);
    CaptureTwins twins({.maxBytes = kMemory, .archive = archive, .patient = true});
    twins.record(before);
    QCOMPARE(twins.small.released(), std::uint64_t(0));
    const std::uint64_t then = twins.small.archivedBytes();
    QCOMPARE(then > 0, before > 0);
    {
        const SizeLimit limit(100'000);
        twins.record(1'200'000);
        QTRY_COMPARE(failures.size(), 1); // however often it is tried
    }
    const auto failure = failures.front().front().value<ArchiveFailure>();
    QCOMPARE(failure.reason, ArchiveFailure::Reason::WriteFailed);
    QCOMPARE(failure.folder, folder.path());
    QCOMPARE(failure.systemText, qt_error_string(EFBIG));
    QVERIFY(twins.small.bytes() <= kMemory + CaptureTwins::kSlack);
    QVERIFY(twins.small.released() > 0);
    twins.verifyTheSame(50);
    // Half a piece is of no use.
    auto none = support::once([&folder] { return QDir(folder.path()).isEmpty(); });
    QTRY_VERIFY(none());
    auto bounded = support::once([&] { return archive->bytesOnDisk() <= then + 2 * kPiece; });
    QTRY_VERIFY(bounded());
}

void TestArchiveFullDisk::aFolderThatTakesNoFilesIsToldOnce()
{
    // A directory of the system in which no file can be made, not even by root.
    const auto archive = std::make_shared<DiskArchive>(
        DiskArchive::Config{QStringLiteral("/proc/self"), 64'000'000, 0, kPiece});
    const QSignalSpy failures(archive.get(), &DiskArchive::failed);
    CaptureTwins twins({.maxBytes = kMemory, .archive = archive, .patient = true});
    twins.record(1'000'000);
    QTRY_COMPARE(failures.size(), 1);
    QVERIFY(twins.small.bytes() <= kMemory + CaptureTwins::kSlack);
    twins.verifyTheSame(50);
}

QTEST_GUILESS_MAIN(TestArchiveFullDisk)
#include "tst_archive_full_disk_posix.moc"
