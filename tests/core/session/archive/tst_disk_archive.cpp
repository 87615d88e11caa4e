// The archive on a real disk: the same samples from there, little memory, nothing left behind, room given back; and
// folders that cannot be used cost nothing but the oldest samples.
#include "session/archive/disk_archive.h"
#include "support/capture_twins.h"
#include "support/once.h"

#include <QDir>
#include <QSignalSpy>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QtTest>

using capture::Capture;
using capture::Snapshot;
using session::ArchiveFailure;
using session::DiskArchive;

class TestDiskArchive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void samplesReadTheSameFromTheDisk();
    void aFileHasNoNameWhileItIsUsed();
    void theBudgetHolds();
    void clearingGivesTheRoomBack();
    void aCopyIsReadWhileTheRestMoves();
    void aCopyOutlivesTheArchive();
    void endingDoesNotWaitForWhatWaits();
    void aFolderThatCannotBeMadeIsToldOnce();
    void aDiskWithLittleRoomIsLeftToOthers();
    void whatAProgramLeftBehindIsRemoved();
    void theUsualBudgetHasBounds();
    void aDiskThatFailsWhileItIsReadIsNoDeath();
};

namespace {

constexpr std::size_t kInMemory = 4'000'000;
constexpr std::size_t kPieceBytes = 524288;
constexpr std::uint64_t kBudget = 64'000'000;

struct Bench {
    QTemporaryDir place;
    std::shared_ptr<DiskArchive> archive;
    QSignalSpy failures;
    CaptureTwins twins;

    /// @param below  the temporary folder; nothing: a folder that has to be made first
    explicit Bench(bool patient = true, const QString &below = QStringLiteral("a/samples"),
        std::uint64_t budget = kBudget, std::uint64_t leaveFree = 0)
        : archive(std::make_shared<DiskArchive>(
            DiskArchive::Config{place.filePath(below), budget, leaveFree, kPieceBytes}))
        , failures(archive.get(), &DiskArchive::failed)
        , twins({.maxBytes = kInMemory, .archive = archive, .patient = patient})
    {
    }
    Capture &small() { return twins.small; }
    QStringList files() const
    {
        return QDir(archive->folder())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }
};

} // namespace

void TestDiskArchive::samplesReadTheSameFromTheDisk()
{
    Bench bench;
    bench.twins.record(3'000'000);
    QCOMPARE(bench.small().released(), std::uint64_t(0));
    QVERIFY(bench.small().archivedBytes() > 3 * kInMemory);
    QVERIFY(bench.small().bytes() <= kInMemory + CaptureTwins::kSlack);
    QVERIFY(bench.archive->bytesOnDisk() >= bench.small().archivedBytes());
    bench.twins.verifyTheSame();
    const auto ids = bench.small().streaming();
    const auto span = *bench.small().timeSpan();
    QVERIFY(CaptureTwins::csvOf(bench.small(), ids, {span.from, span.from + 20.0})
        == CaptureTwins::csvOf(bench.twins.whole, ids, {span.from, span.from + 20.0}));
    QCOMPARE(bench.failures.size(), 0);
}

void TestDiskArchive::aFileHasNoNameWhileItIsUsed()
{
    Bench bench;
    bench.twins.record(1'000'000);
    QVERIFY(bench.small().archivedBytes() > 0);
    QVERIFY(QFileInfo(bench.archive->folder()).isDir());
    // At most the one that is being written.
    QVERIFY2(bench.files().size() <= 1, qPrintable(bench.files().join(QLatin1Char(' '))));
    auto none = support::once([&bench] { return bench.files().isEmpty(); });
    QTRY_VERIFY(none());
    bench.twins.verifyTheSame(50);
}

void TestDiskArchive::theBudgetHolds()
{
    Bench bench(true, QStringLiteral("samples"), 6'000'000);
    std::uint64_t most = 0;
    for (int i = 0; i < 50; ++i) {
        bench.twins.record(60'000);
        most = std::max(most, bench.small().archivedBytes());
    }
    QVERIFY(bench.small().released() > 0);
    QVERIFY(most <= 6'000'000 && most > 4'000'000);
    auto bounded = support::once([&bench] {
        return bench.archive->bytesOnDisk() <= 6'000'000 + 2 * bench.archive->pieceBytes();
    });
    QTRY_VERIFY(bounded());
    bench.twins.verifyTheSame(50);
}

void TestDiskArchive::clearingGivesTheRoomBack()
{
    Bench bench;
    bench.twins.record(2'000'000);
    QVERIFY(bench.archive->bytesOnDisk() > 5'000'000);
    bench.small().clear();
    bench.twins.whole.clear();
    auto empty = support::once([&bench] { return bench.archive->bytesOnDisk() == 0; });
    QTRY_VERIFY(empty());
    bench.twins.record(1'000'000);
    bench.twins.verifyTheSame(50);
}

/// Readers of a copy and the capture that goes on share nothing that is written.
void TestDiskArchive::aCopyIsReadWhileTheRestMoves()
{
    struct Reader : QThread {
        Snapshot copy;
        std::uint64_t sum = 0;
        std::atomic<bool> done{
            false}; ///< wait() says so too, but ThreadSanitizer does not see that
        void run() override
        {
            for (int round = 0; round < 20; ++round)
                for (const capture::Channel &channel : *copy)
                    for (capture::Index i = channel.begin(); i < channel.end(); i += 61)
                        sum += static_cast<std::uint64_t>(channel.fast()->at(i) + 40000);
            copy.reset(); // the last of some pieces is let go here
            done.store(true, std::memory_order_release);
        }
    };
    Bench bench;
    bench.twins.record(800'000);
    std::vector<capture::ChannelId> ids = bench.small().streaming();
    ids.resize(CaptureTwins::kFast);
    Reader small;
    Reader whole;
    small.copy = bench.small().snapshot(ids);
    std::vector<capture::Channel> same;
    for (std::size_t i = 0; i < ids.size(); ++i)
        same.push_back(*bench.twins.whole.channel(ids[i]));
    const bool nothingReleased = bench.small().released() == 0;
    whole.copy = std::make_shared<const std::vector<capture::Channel>>(std::move(same));
    small.start();
    whole.start();
    bench.twins.record(1'500'000);
    bench.small().clear();
    QVERIFY(small.wait() && whole.wait());
    QVERIFY(small.done.load(std::memory_order_acquire));
    QVERIFY(whole.done.load(std::memory_order_acquire));
    QVERIFY(nothingReleased);
    QCOMPARE(small.sum, whole.sum);
    auto empty = support::once([&bench] { return bench.archive->bytesOnDisk() == 0; });
    QTRY_VERIFY(empty());
}

void TestDiskArchive::aCopyOutlivesTheArchive()
{
    Snapshot copy;
    std::unique_ptr<Capture> whole;
    {
        Bench bench;
        bench.twins.record(1'500'000);
        QVERIFY(bench.small().archivedBytes() > 0);
        copy = bench.small().snapshot(bench.small().streaming());
        whole = std::make_unique<Capture>(std::move(bench.twins.whole));
        bench.twins.whole = Capture();
    }
    for (const capture::Channel &channel : *copy)
        CaptureTwins::verifyColumn(channel, *whole->channel(channel.info().id));
    copy.reset();
}

void TestDiskArchive::endingDoesNotWaitForWhatWaits()
{
    Bench bench(false);
    std::vector<std::shared_ptr<const capture::Deposit>> deposits;
    const std::shared_ptr<const std::byte> bytes(
        new std::byte[kPieceBytes]{}, [](const std::byte *gone) { delete[] gone; });
    for (int i = 0; i < 400; ++i)
        deposits.push_back(bench.archive->store({{bytes, kPieceBytes}}));
    bench.small() = Capture();
    bench.archive.reset();
    const auto stored = std::count_if(deposits.begin(), deposits.end(),
        [](const auto &deposit) { return deposit->state() == capture::Deposit::State::Stored; });
    QVERIFY(stored < 400);
}

void TestDiskArchive::aFolderThatCannotBeMadeIsToldOnce()
{
    Bench bench(true, QStringLiteral("file/samples"));
    QFile file(bench.place.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    bench.twins.record(1'500'000);
    bench.small().tryArchiveAgain();
    bench.twins.record(300'000);
    QTRY_COMPARE(bench.failures.size(), 1);
    const auto failure = bench.failures.front().front().value<ArchiveFailure>();
    QCOMPARE(failure.reason, ArchiveFailure::Reason::NoFolder);
    QCOMPARE(failure.folder, bench.place.filePath(QStringLiteral("file/samples")));
    QVERIFY(bench.small().bytes() <= kInMemory + CaptureTwins::kSlack);
    QVERIFY(bench.small().bytes() > kInMemory * 3 / 4);
    bench.twins.verifyTheSame(50);
    // The user has put it right, and says so.
    QVERIFY(file.remove());
    bench.archive->setBudget(kBudget);
    bench.small().tryArchiveAgain();
    bench.twins.record(500'000);
    QVERIFY(bench.small().archivedBytes() > 0);
    bench.twins.verifyTheSame(50);
}

void TestDiskArchive::aDiskWithLittleRoomIsLeftToOthers()
{
    Bench bench(true, QStringLiteral("samples"), kBudget, std::uint64_t{1} << 60);
    bench.twins.record(1'000'000);
    QTRY_COMPARE(bench.failures.size(), 1);
    QCOMPARE(bench.failures.front().front().value<ArchiveFailure>().reason,
        ArchiveFailure::Reason::LittleRoom);
    QCOMPARE(bench.small().archivedBytes(), std::uint64_t(0));
    QCOMPARE(bench.archive->bytesOnDisk(), std::uint64_t(0));
    QVERIFY(bench.files().isEmpty());
    bench.twins.verifyTheSame(50);
}

void TestDiskArchive::whatAProgramLeftBehindIsRemoved()
{
    Bench bench;
    QVERIFY(QDir().mkpath(bench.archive->folder()));
    const auto make = [&bench](const char *name, qint64 secondsAgo) {
        QFile file(QDir(bench.archive->folder()).filePath(QLatin1String(name)));
        return file.open(QIODevice::WriteOnly) && file.write("x") == 1 && file.flush()
            && file.setFileTime(QDateTime::currentDateTime().addSecs(-secondsAgo),
                QFileDevice::FileModificationTime);
    };
    QVERIFY(make("old.samples", 100'000));
    QVERIFY(make("new.samples", 60)); // of a program that runs
    QVERIFY(make("other.txt", 100'000));
    bench.twins.record(1'000'000);
    // What is being written has a name, too, until the disk has it.
    const QStringList left{QStringLiteral("new.samples"), QStringLiteral("other.txt")};
    auto cleaned = support::once([&bench, &left] { return bench.files() == left; });
    QTRY_VERIFY(cleaned());
}

void TestDiskArchive::theUsualBudgetHasBounds()
{
    const QTemporaryDir place;
    const std::uint64_t budget =
        session::usualArchiveBudget(place.filePath(QStringLiteral("not/there/yet")));
    QCOMPARE(budget, session::usualArchiveBudget(place.path()));
    QVERIFY(budget <= 16'000'000'000);
    const QStorageInfo disk(place.path());
    QCOMPARE(budget == 0, disk.fileSystemType() == "tmpfs");
}

/// A file that becomes shorter under its mapping cannot be read: as with a disk that dies.
void TestDiskArchive::aDiskThatFailsWhileItIsReadIsNoDeath()
{
    QTemporaryDir place;
    std::atomic<bool> harm{false};
    const auto archive = std::make_shared<DiskArchive>(DiskArchive::Config{.folder = place.path(),
        .budget = kBudget,
        .leaveFree = 0,
        .pieceBytes = kPieceBytes,
        .mapped = [&harm](const QString &path) {
            if (harm)
                QFile::resize(path, 4096);
        }});
    QSignalSpy failures(archive.get(), &DiskArchive::failed);
    CaptureTwins twins({.maxBytes = kInMemory, .archive = archive, .patient = true});
    twins.record(1'000'000);
    harm = true;
    twins.record(2'000'000);
    QVERIFY(twins.small.archivedBytes() > kInMemory);
    const auto ids = twins.small.streaming();
    const auto span = *twins.small.timeSpan();
    // Reads all there is.
    QVERIFY(!CaptureTwins::csvOf(twins.small, ids, {span.from, span.to}).empty());
    QCOMPARE(archive->budget(), std::uint64_t(0));
    QTRY_COMPARE(failures.size(), 1);
    QVERIFY(failures.front().front().value<ArchiveFailure>().reason
        == ArchiveFailure::Reason::ReadFailed);
    harm = false;
    twins.record(60'000); // the capture lets go of what it can trust no more
    QCOMPARE(twins.small.archivedBytes(), std::uint64_t(0));
    QVERIFY(twins.small.released() > 0);
    twins.verifyTheSame(50); // and what is left is true
    archive->setBudget(kBudget);
    QCOMPARE(archive->budget(), kBudget);
}

QTEST_GUILESS_MAIN(TestDiskArchive)
#include "tst_disk_archive.moc"
