// WishQueue: in which order wishes go, which of them are cut, and that each ends once. Tasks that ask nothing: no
// board, no line.
#include "drive/wish_queue.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;

namespace {

struct NoProtocol {
    struct Request { };
    struct Answer { };
};
using Queue = WishQueue<NoProtocol>;

constexpr TimePoint kAdded{10s};

class QueuedProbe final : public WishTask<NoProtocol> {
public:
    QueuedProbe(WishId id, Permission permission, bool reads)
        : WishTask(id, permission)
        , m_reads(reads)
    {
        freshen(kAdded);
    }
    std::optional<NoProtocol::Request> nextRequest(TimePoint) override { return {}; }
    void onResponse(const NoProtocol::Answer &, TimePoint) override { }
    void onNoResponse(std::optional<bool>, TimePoint) override { }
    bool onlyReads() const override { return m_reads; }
    void supersede(const Write &) override { ++superseded; }
    std::vector<Reading> takeReadings() override { return std::exchange(readings, {}); }
    void succeed() { end(Outcome::Ok); }

    int superseded = 0;
    std::vector<Reading> readings;

private:
    bool m_reads;
};

struct QueueBench {
    Queue queue;

    QueuedProbe *add(WishId id, bool reads = false, Permission permission = Permission::Always)
    {
        auto task = std::make_unique<QueuedProbe>(id, permission, reads);
        QueuedProbe *probe = task.get();
        return queue.add(std::move(task)) ? probe : nullptr;
    }
    std::vector<Event> collect(TimePoint now = kAdded)
    {
        std::vector<Event> events;
        queue.collect(events, now);
        return events;
    }
    /// The wishes that ended, by the events; each event has to be such an end.
    std::vector<WishId> ended()
    {
        std::vector<WishId> ids;
        for (const Event &event : collect())
            ids.push_back(std::get<Ended>(event).id);
        return ids;
    }
};

std::string reasonOf(const QueuedProbe *probe)
{
    return probe->finished() ? probe->ended().reason : "";
}

} // namespace

class TestWishQueue : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatActsGoesBeforeWhatReads();
    void theDrivesOwnGoesFirst();
    void tooManyAreRefused();
    void unarmedNothingActs();
    void whatIsTooLateIsCut();
    void allButOneAreCut();
    void onlyOneKindIsCut();
    void aNewerWriteIsToldToWhatActs();
    void eachEndIsToldOnceWithItsResults();
};

void TestWishQueue::whatActsGoesBeforeWhatReads()
{
    QueueBench bench;
    QVERIFY(bench.queue.next(true, kAdded) == nullptr);
    const QueuedProbe *read = bench.add(1, true);
    QueuedProbe *first = bench.add(2);
    const QueuedProbe *second = bench.add(3);
    QVERIFY(bench.queue.next(true, kAdded) == first);
    first->succeed();
    QVERIFY(bench.queue.next(true, kAdded) == second);
    bench.queue.cut("", nullptr, [](OpenWish &wish) { return !wish.onlyReads(); });
    QVERIFY(bench.queue.next(true, kAdded) == read);
}

void TestWishQueue::theDrivesOwnGoesFirst()
{
    QueueBench bench;
    for (std::size_t i = 0; i < Queue::kMaxWaiting; ++i)
        bench.add(1 + i);
    auto own = std::make_unique<QueuedProbe>(0, Permission::Always, false);
    QueuedProbe *probe = own.get();
    bench.queue.addFirst(std::move(own));
    QVERIFY(bench.queue.next(true, kAdded) == probe);
    probe->succeed();
    QVERIFY(bench.ended().empty()); // it was no wish
}

void TestWishQueue::tooManyAreRefused()
{
    for (const bool reads : {false, true}) {
        QueueBench bench;
        for (WishId id = 1; id <= 1000; ++id)
            QVERIFY(bench.add(id, reads) != nullptr);
        QVERIFY(bench.add(1001, reads) == nullptr);
        QVERIFY(bench.add(1002, !reads) != nullptr); // the others wait for themselves
    }
}

void TestWishQueue::unarmedNothingActs()
{
    QueueBench bench;
    const QueuedProbe *acts = bench.add(1, false, Permission::Armed);
    const QueuedProbe *always = bench.add(2);
    QVERIFY(bench.queue.next(true, kAdded) == acts);
    QVERIFY(bench.queue.next(false, kAdded) == always);
    QCOMPARE(reasonOf(acts), std::string("not armed"));
    QVERIFY(acts->ended().outcome == Outcome::NotSent);
}

void TestWishQueue::whatIsTooLateIsCut()
{
    QueueBench bench;
    const QueuedProbe *acts = bench.add(1, false, Permission::Armed);
    const QueuedProbe *always = bench.add(2);
    QVERIFY(bench.queue.next(true, kAdded + kWishExpiresAfter) == acts);
    QVERIFY(bench.queue.next(true, kAdded + kWishExpiresAfter + 1ms) == always);
    QCOMPARE(reasonOf(acts), std::string(kTooLate));
    QVERIFY(bench.queue.next(true, kAdded + 1h) == always);
}

void TestWishQueue::allButOneAreCut()
{
    for (const bool reads : {false, true}) {
        QueueBench bench;
        const QueuedProbe *inFlight = bench.add(1, reads);
        const QueuedProbe *acts = bench.add(2);
        const QueuedProbe *read = bench.add(3, true);
        bench.queue.cut("stopped", inFlight);
        QVERIFY(!inFlight->finished());
        QCOMPARE(reasonOf(acts), std::string("stopped"));
        QCOMPARE(reasonOf(read), std::string("stopped"));
        QCOMPARE(bench.ended(), (std::vector<WishId>{2, 3}));
        bench.queue.cut("closed", nullptr);
        QCOMPARE(bench.ended(), (std::vector<WishId>{1}));
    }
}

void TestWishQueue::onlyOneKindIsCut()
{
    QueueBench bench;
    const QueuedProbe *inFlight = bench.add(1, false, Permission::Armed);
    const QueuedProbe *armed = bench.add(2, false, Permission::Armed);
    const QueuedProbe *always = bench.add(3);
    const QueuedProbe *read = bench.add(4, true);
    bench.queue.cut("disarmed", inFlight,
        [](OpenWish &wish) { return wish.permission() == Permission::Armed; });
    QVERIFY(!inFlight->finished() && !always->finished() && !read->finished());
    QCOMPARE(reasonOf(armed), std::string("disarmed"));
    QCOMPARE(bench.ended(), (std::vector<WishId>{2}));
}

void TestWishQueue::aNewerWriteIsToldToWhatActs()
{
    QueueBench bench;
    const QueuedProbe *first = bench.add(1), *second = bench.add(2), *read = bench.add(3, true);
    bench.queue.supersede({});
    QCOMPARE(first->superseded, 1);
    QCOMPARE(second->superseded, 1);
    QCOMPARE(read->superseded, 0);
}

void TestWishQueue::eachEndIsToldOnceWithItsResults()
{
    QueueBench bench;
    QueuedProbe *probe = bench.add(7, true);
    QVERIFY(bench.collect().empty());
    probe->readings = {Reading{}};
    const auto some = bench.collect();
    QCOMPARE(some.size(), std::size_t{1});
    QVERIFY(std::holds_alternative<RegistersRead>(some[0]));
    probe->readings = {Reading{}};
    probe->motion() = MotionEntry{};
    probe->motion()->asked = kAdded;
    QCOMPARE(bench.collect().size(), std::size_t{1}); // its entry waits for its end
    probe->readings = {Reading{}};
    probe->cut("gone");
    const auto events = bench.collect(kAdded + 5ms);
    QCOMPARE(events.size(), std::size_t{3});
    QVERIFY(std::holds_alternative<RegistersRead>(events[0]));
    const auto &motion = std::get<MotionEntry>(events[1]);
    QVERIFY(motion.ended == kAdded + 5ms && motion.outcome == Outcome::NotSent);
    QCOMPARE(motion.reason, std::string("gone"));
    QCOMPARE(std::get<Ended>(events[2]).id, WishId{7});
    QVERIFY(bench.collect().empty());
    // No act ends before it was asked for, whichever clock told that.
    QueuedProbe *early = bench.add(8);
    early->motion() = MotionEntry{};
    early->motion()->asked = kAdded + 1s;
    early->succeed();
    const auto last = bench.collect(kAdded);
    QVERIFY(std::get<MotionEntry>(last.at(0)).ended == kAdded + 1s);
}

QTEST_APPLESS_MAIN(TestWishQueue)
#include "tst_wish_queue.moc"
