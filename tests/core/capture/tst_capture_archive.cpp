// A capture with little memory and an archive against one with memory for everything: the same answers, whatever the
// archive does; and what is given up where it cannot take more.
#include "support/capture_twins.h"

#include <QtTest>

#include <cstring>
#include <deque>

using namespace capture;

class TestCaptureArchive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingIsLostWhereTheArchiveTakesIt();
    void memoryHoldsTheLimitAndHardlyGrowsAfterwards();
    void anExportOfBothIsTheSame();
    void aSlowArchiveIsWaitedForWithinTheLimit();
    void anArchiveThatHangsCostsTheOldestOnly();
    void valuesThatAreReadInTurnMakeRoomToo();
    void whoIsPatientLosesNothing();
    void aFullArchiveGoesRound();
    void whatIsRefusedStaysInMemory();
    void anArchiveThatFailsMidwayGoesRoundInWhatItHas();
    void anArchiveThatRefusedIsTriedAgainOnDemand();
    void aSmallerBudgetLetsTheOldestGo();
    void aBudgetOfNothingIsMemoryOnly();
    void copiesReadOnWhereTheyDid();
    void clearingGivesTheRoomBack();
    void adoptedSamplesStayWhereTheyAre();
    void adoptingDropsWhatIsOnItsWay();
};

namespace {

constexpr std::size_t kMemory = 4'000'000;
constexpr std::size_t kPiece = 524288;

/// An archive in memory that takes, waits and refuses as a test tells it.
class FakeArchive : public SampleArchive {
public:
    std::uint64_t most = std::uint64_t{1} << 32;
    bool atOnce = true; ///< settles before store() returns
    int refuseFrom = -1; ///< the number of the first deposit that is refused
    int deposits = 0;
    int refused = 0;
    std::uint64_t held() const { return *m_held; }

    std::uint64_t budget() const override { return most; }
    std::size_t pieceBytes() const override { return kPiece; }
    std::shared_ptr<const Deposit> store(std::vector<Stretch> stretches) override
    {
        auto deposit = std::make_shared<Deposit>();
        m_waiting.push_back({deposit, std::move(stretches)});
        if (atOnce)
            settle();
        return deposit;
    }
    void settle(std::size_t count = 1'000'000)
    {
        for (; count > 0 && !m_waiting.empty(); --count) {
            auto [deposit, stretches] = std::move(m_waiting.front());
            m_waiting.pop_front();
            if (refuseFrom >= 0 && deposits >= refuseFrom) {
                ++refused;
                deposit->settle(Deposit::State::Refused);
                continue;
            }
            ++deposits;
            for (Stretch &stretch : stretches)
                stretch.data = copyOf(stretch);
            deposit->settle(Deposit::State::Stored, std::move(stretches));
        }
    }
    std::size_t waiting() const { return m_waiting.size(); }

private:
    std::shared_ptr<const std::byte> copyOf(const Stretch &stretch)
    {
        auto *copy = new std::byte[stretch.size];
        std::memcpy(copy, stretch.data.get(), stretch.size);
        *m_held += stretch.size;
        return {copy, [held = m_held, size = stretch.size](const std::byte *gone) {
                    delete[] gone;
                    *held -= size;
                }};
    }

    std::shared_ptr<std::atomic<std::uint64_t>> m_held =
        std::make_shared<std::atomic<std::uint64_t>>(0);
    std::deque<std::pair<std::shared_ptr<Deposit>, std::vector<Stretch>>> m_waiting;
};

struct Bench {
    std::shared_ptr<FakeArchive> archive = std::make_shared<FakeArchive>();
    CaptureTwins twins;

    explicit Bench(std::uint32_t seed = 1, bool patient = false)
        : twins({.maxBytes = kMemory, .archive = archive, .patient = patient}, seed)
    {
    }
    Capture &small() { return twins.small; }
    /// But for a piece that the capture has not looked at yet.
    bool holdsWhatIsRead()
    {
        const std::uint64_t read = small().archivedBytes();
        return archive->held() >= read && archive->held() <= read + kPiece;
    }
};

} // namespace

void TestCaptureArchive::nothingIsLostWhereTheArchiveTakesIt()
{
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        Bench bench(seed);
        bench.twins.record(3'500'000);
        QCOMPARE(bench.small().released(), std::uint64_t(0));
        QVERIFY(bench.archive->deposits > 20);
        QVERIFY(bench.holdsWhatIsRead());
        bench.twins.verifyTheSame(300);
    }
}

void TestCaptureArchive::memoryHoldsTheLimitAndHardlyGrowsAfterwards()
{
    Bench bench;
    bench.twins.record(1'500'000);
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    const std::size_t then = bench.small().bytes();
    const std::uint64_t archivedThen = bench.small().archivedBytes();
    bench.twins.record(4'000'000);
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    // Two pieces more or less, and the extremes of what has moved: 1 % of it.
    const std::uint64_t moved = bench.small().archivedBytes() - archivedThen;
    QVERIFY(moved > 15'000'000);
    QVERIFY2(bench.small().bytes() <= then + 2 * kPiece + moved / 100,
        qPrintable(QString::number(bench.small().bytes())));
}

void TestCaptureArchive::anExportOfBothIsTheSame()
{
    Bench bench;
    bench.twins.record(1'200'000);
    QVERIFY(bench.archive->deposits > 5);
    const std::vector<ChannelId> ids = bench.small().streaming();
    const auto span = *bench.small().timeSpan();
    // Old and new, over the place where memory begins.
    const TimeSpan some{span.from, span.from + (span.to - span.from) / 8};
    const TimeSpan late{span.to - (span.to - span.from) / 4, span.to};
    for (const TimeSpan range : {some, late}) {
        const std::string text = CaptureTwins::csvOf(bench.small(), ids, range);
        QVERIFY(text.size() > 1'000'000);
        QVERIFY(text == CaptureTwins::csvOf(bench.twins.whole, ids, range));
    }
}

void TestCaptureArchive::aSlowArchiveIsWaitedForWithinTheLimit()
{
    Bench bench;
    bench.archive->atOnce = false;
    std::size_t mostWaiting = 0;
    for (int i = 0; i < 60; ++i) {
        bench.twins.record(40'000);
        mostWaiting = std::max(mostWaiting, bench.archive->waiting());
        bench.archive->settle(1);
    }
    QVERIFY2(mostWaiting >= 1 && mostWaiting * kPiece <= kMemory / 4 + kPiece,
        qPrintable(QString::number(mostWaiting)));
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    QCOMPARE(bench.small().released(), std::uint64_t(0));
    bench.twins.verifyTheSame();
}

void TestCaptureArchive::anArchiveThatHangsCostsTheOldestOnly()
{
    Bench bench;
    bench.archive->atOnce = false;
    bench.twins.record(2'000'000);
    QVERIFY(bench.archive->waiting() > 0);
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    QVERIFY(bench.small().released() > 0);
    bench.twins.verifyTheSame(50);
    // It comes back: what it finally took is not kept any more, and what follows goes there.
    bench.archive->settle();
    bench.archive->atOnce = true;
    const std::uint64_t released = bench.small().released();
    bench.twins.record(2'000'000);
    QCOMPARE(bench.small().released(), released);
    QVERIFY(bench.holdsWhatIsRead());
    bench.twins.verifyTheSame();
}

void TestCaptureArchive::valuesThatAreReadInTurnMakeRoomToo()
{
    constexpr std::uint64_t kValues = 2'000'000; // 32 MB
    constexpr std::size_t kRoom = 4 * kMemory;
    constexpr std::size_t kUnseen = std::size_t(65536) * 24; // between two looks
    const auto record = [](Capture &capture) {
        for (std::uint64_t i = 0; i < kValues; ++i)
            capture.appendPolled(40, "P", "K", double(i) * 0.01 + double(i % 3) * 0.001, double(i));
        return *capture.find(40);
    };
    const auto archive = std::make_shared<FakeArchive>();
    Capture whole({.maxBytes = kRoom, .archive = archive});
    const ChannelId id = record(whole);
    QVERIFY(whole.bytes() <= kRoom + kUnseen);
    QCOMPARE(whole.size(id), kValues);
    QCOMPARE(whole.channel(id)->at(5), 5.0);
    QVERIFY(archive->deposits > 20);
    Capture newest({.maxBytes = kRoom});
    const ChannelId other = record(newest);
    QVERIFY(newest.bytes() <= kRoom + kUnseen);
    QCOMPARE(newest.size(other) + newest.released(), kValues);
    QCOMPARE(newest.lastValue(other), std::optional(double(kValues - 1)));
}

void TestCaptureArchive::whoIsPatientLosesNothing()
{
    /// Settles when it is waited for, in another thread.
    class Late : public FakeArchive {
    public:
        ~Late() override { m_thread.wait(); }
        std::shared_ptr<const Deposit> store(std::vector<Stretch> stretches) override
        {
            atOnce = false;
            m_thread.wait();
            auto deposit = FakeArchive::store(std::move(stretches));
            m_thread.archive = this;
            m_thread.start();
            return deposit;
        }

    private:
        struct Thread : QThread {
            FakeArchive *archive = nullptr;
            void run() override { archive->settle(1); }
        } m_thread;
    };
    const auto archive = std::make_shared<Late>();
    CaptureTwins twins({.maxBytes = kMemory, .archive = archive, .patient = true});
    twins.record(2'000'000);
    QCOMPARE(twins.small.released(), std::uint64_t(0));
    QVERIFY(twins.small.bytes() <= kMemory + CaptureTwins::kSlack);
    twins.verifyTheSame(50);
}

void TestCaptureArchive::aFullArchiveGoesRound()
{
    Bench bench;
    bench.archive->most = 6'000'000;
    std::uint64_t most = 0;
    for (int i = 0; i < 60; ++i) {
        bench.twins.record(50'000);
        most = std::max(most, bench.archive->held());
    }
    QVERIFY(bench.small().released() > 0);
    QVERIFY2(most <= 6'000'000 && most > 5'000'000, qPrintable(QString::number(most)));
    QVERIFY(bench.small().archivedBytes() > 5'000'000);
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    bench.twins.verifyTheSame();
}

void TestCaptureArchive::whatIsRefusedStaysInMemory()
{
    Bench bench;
    bench.archive->refuseFrom = 0;
    bench.twins.record(2'000'000);
    QCOMPARE(bench.archive->refused, 1); // it is not asked again and again
    QCOMPARE(bench.small().archiveRoom(), std::uint64_t(0));
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    QVERIFY(bench.small().bytes() > kMemory * 3 / 4); // all of it is used
    QVERIFY(bench.small().released() > 0);
    bench.twins.verifyTheSame(50);
}

void TestCaptureArchive::anArchiveThatFailsMidwayGoesRoundInWhatItHas()
{
    Bench bench;
    bench.archive->refuseFrom = 12;
    bench.archive->atOnce = false;
    // Several are on their way when the first is refused.
    for (int i = 0; i < 100 && bench.archive->refused == 0; ++i) {
        bench.twins.record(30'000);
        if (i % 2 == 1)
            bench.archive->settle();
    }
    bench.twins.record(70'000); // it looks again
    QVERIFY(bench.archive->refused > 0);
    QVERIFY(bench.small().archiveRoom() <= 12 * kPiece);
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    bench.twins.verifyTheSame();
    // The disk takes again what was freed on it.
    bench.archive->refuseFrom = -1;
    bench.archive->atOnce = true;
    bench.archive->settle();
    const int deposits = bench.archive->deposits;
    bench.twins.record(500'000);
    QVERIFY(bench.archive->deposits > deposits);
    QVERIFY(bench.small().archivedBytes() <= 12 * kPiece);
    bench.twins.verifyTheSame();
}

void TestCaptureArchive::anArchiveThatRefusedIsTriedAgainOnDemand()
{
    Bench bench;
    bench.archive->refuseFrom = 0;
    bench.twins.record(1'000'000);
    bench.archive->refuseFrom = -1;
    bench.twins.record(300'000);
    QCOMPARE(bench.archive->deposits, 0);
    bench.small().tryArchiveAgain();
    // Memory is full to the brim: until there is room in it the oldest go.
    bench.twins.record(200'000);
    const std::uint64_t released = bench.small().released();
    bench.twins.record(1'000'000);
    QVERIFY(bench.archive->deposits > 0);
    QCOMPARE(bench.small().released(), released);
    bench.twins.verifyTheSame(50);
}

void TestCaptureArchive::aSmallerBudgetLetsTheOldestGo()
{
    Bench bench;
    bench.twins.record(2'000'000);
    QCOMPARE(bench.small().released(), std::uint64_t(0));
    bench.archive->most = 4'000'000;
    bench.twins.record(70'000);
    QVERIFY(bench.small().released() > 0);
    QVERIFY(bench.archive->held() <= 4'000'000);
    QVERIFY(bench.archive->held() > 3'000'000);
    bench.twins.verifyTheSame();
}

void TestCaptureArchive::aBudgetOfNothingIsMemoryOnly()
{
    Bench bench;
    bench.archive->most = 0;
    bench.twins.record(2'000'000);
    QCOMPARE(bench.archive->deposits, 0);
    QVERIFY(bench.small().bytes() > kMemory * 3 / 4);
    QVERIFY(bench.small().bytes() <= kMemory + CaptureTwins::kSlack);
    bench.twins.verifyTheSame(50);
}

void TestCaptureArchive::copiesReadOnWhereTheyDid()
{
    Bench bench;
    bench.twins.record(300'000); // all in memory
    const std::vector<ChannelId> ids = bench.small().streaming();
    const Snapshot before = bench.small().snapshot(ids);
    const auto *codes = before->front().fast()->codes(0, 1).data();
    bench.twins.record(2'000'000);
    const Snapshot after = bench.small().snapshot(ids);
    QVERIFY(bench.small().channel(ids.front())->archivedBytes() > 0);
    QCOMPARE(before->front().fast()->codes(0, 1).data(), codes);
    QVERIFY(after->front().fast()->codes(0, 1).data() != codes);
    bench.small().clear();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        CaptureTwins::verifyColumn(after->at(i), *bench.twins.whole.channel(ids[i]));
        const Channel &old = before->at(i);
        for (Index k = old.begin(); k < old.end(); ++k)
            if (old.at(k) != after->at(i).at(k))
                QFAIL("a copy reads something else");
    }
}

void TestCaptureArchive::clearingGivesTheRoomBack()
{
    Bench bench;
    bench.archive->atOnce = false;
    for (int i = 0; i < 30; ++i) {
        bench.twins.record(40'000);
        bench.archive->settle(1);
    }
    bench.twins.record(100'000);
    QVERIFY(bench.archive->waiting() > 0);
    QVERIFY(bench.archive->held() > 0);
    bench.small().clear();
    bench.twins.whole.clear();
    bench.archive->settle(); // too late: not wanted any more
    QCOMPARE(bench.archive->held(), std::uint64_t(0));
    QCOMPARE(bench.small().archivedBytes(), std::uint64_t(0));
    bench.archive->atOnce = true;
    bench.twins.record(1'000'000);
    QCOMPARE(bench.small().released(), std::uint64_t(0));
    bench.twins.verifyTheSame(50);
}

void TestCaptureArchive::adoptedSamplesStayWhereTheyAre()
{
    Bench bench;
    bench.twins.record(1'500'000);
    const std::uint64_t held = bench.archive->held();
    const auto old = bench.small().channels();
    Capture other({.maxBytes = kMemory, .archive = bench.archive});
    other.adopt(std::move(bench.twins.small));
    QCOMPARE(bench.archive->held(), held);
    QCOMPARE(other.archivedBytes(), held);
    const auto now = other.channels();
    QCOMPARE(now.size(), old.size());
    for (std::size_t i = 0; i < now.size(); ++i)
        CaptureTwins::verifyColumn(
            *other.channel(now[i].id), *bench.twins.whole.channel(old[i].id));
}

void TestCaptureArchive::adoptingDropsWhatIsOnItsWay()
{
    Bench bench;
    bench.archive->atOnce = false;
    bench.twins.record(500'000);
    QVERIFY(bench.archive->waiting() > 0);
    Capture other({.maxBytes = kMemory, .archive = bench.archive});
    other.adopt(std::move(bench.twins.small));
    bench.twins.small = std::move(other);
    bench.archive->settle();
    QCOMPARE(bench.archive->held(), std::uint64_t(0));
    // The channels go on, into the archive too.
    bench.archive->atOnce = true;
    Capture whole({.maxBytes = CaptureTwins::kUnlimited});
    whole.adopt(std::move(bench.twins.whole));
    bench.twins.whole = std::move(whole);
    bench.twins.begin(2);
    bench.twins.record(1'000'000);
    QVERIFY(bench.archive->held() > 0);
    QCOMPARE(bench.small().released(), std::uint64_t(0));
    bench.twins.verifyTheSame(50);
}

QTEST_APPLESS_MAIN(TestCaptureArchive)
#include "tst_capture_archive.moc"
