// WishQueue: in which order wishes go, which of them are cut, and that each ends once. Tasks that ask nothing: no board, no
// line.
#include "drive/wish_queue.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;

namespace {

struct Nothing {
    struct Request { };
    struct Answer { };
};
using Queue = WishQueue<Nothing>;

constexpr TimePoint t{10s};

class Probe final : public WishTask<Nothing> {
public:
    Probe(WishId id, Permission permission, bool reads)
        : WishTask(id, permission)
        , m_reads(reads)
    {
        freshen(t);
    }
    std::optional<Nothing::Request> nextRequest(TimePoint) override { return {}; }
    void onResponse(const Nothing::Answer &, TimePoint) override { }
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

struct Bench {
    Queue queue;

    Probe *add(WishId id, bool reads = false, Permission permission = Permission::Always)
    {
        auto task = std::make_unique<Probe>(id, permission, reads);
        Probe *probe = task.get();
        return queue.add(std::move(task)) ? probe : nullptr;
    }
    std::vector<Event> collect(TimePoint now = t)
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

std::string reasonOf(const Probe *probe) { return probe->finished() ? probe->ended().reason : ""; }

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
    Bench bench;
    QVERIFY(bench.queue.next(true, t) == nullptr);
    const Probe *read = bench.add(1, true);
    Probe *first = bench.add(2);
    const Probe *second = bench.add(3);
    QVERIFY(bench.queue.next(true, t) == first);
    first->succeed();
    QVERIFY(bench.queue.next(true, t) == second);
    bench.queue.cut("", nullptr, [](OpenWish &wish) { return !wish.onlyReads(); });
    QVERIFY(bench.queue.next(true, t) == read);
}

void TestWishQueue::theDrivesOwnGoesFirst()
{
    Bench bench;
    for (std::size_t i = 0; i < Queue::kMaxWaiting; ++i)
        bench.add(1 + i);
    auto own = std::make_unique<Probe>(0, Permission::Always, false);
    Probe *probe = own.get();
    bench.queue.addFirst(std::move(own));
    QVERIFY(bench.queue.next(true, t) == probe);
    probe->succeed();
    QVERIFY(bench.ended().empty()); // nobody asked for it
}

void TestWishQueue::tooManyAreRefused()
{
    for (const bool reads : {false, true}) {
        Bench bench;
        for (WishId id = 1; id <= 1000; ++id)
            QVERIFY(bench.add(id, reads) != nullptr);
        QVERIFY(bench.add(1001, reads) == nullptr);
        QVERIFY(bench.add(1002, !reads) != nullptr); // the others wait for themselves
    }
}

void TestWishQueue::unarmedNothingActs()
{
    Bench bench;
    const Probe *acts = bench.add(1, false, Permission::Armed);
    const Probe *always = bench.add(2);
    QVERIFY(bench.queue.next(true, t) == acts);
    QVERIFY(bench.queue.next(false, t) == always);
    QCOMPARE(reasonOf(acts), std::string("not armed"));
    QVERIFY(acts->ended().outcome == Outcome::NotSent);
}

void TestWishQueue::whatIsTooLateIsCut()
{
    Bench bench;
    const Probe *acts = bench.add(1, false, Permission::Armed);
    const Probe *always = bench.add(2);
    QVERIFY(bench.queue.next(true, t + kWishExpiresAfter) == acts);
    QVERIFY(bench.queue.next(true, t + kWishExpiresAfter + 1ms) == always);
    QCOMPARE(reasonOf(acts), std::string(kTooLate));
    QVERIFY(bench.queue.next(true, t + 1h) == always);
}

void TestWishQueue::allButOneAreCut()
{
    for (const bool reads : {false, true}) {
        Bench bench;
        const Probe *inFlight = bench.add(1, reads);
        const Probe *acts = bench.add(2);
        const Probe *read = bench.add(3, true);
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
    Bench bench;
    const Probe *inFlight = bench.add(1, false, Permission::Armed);
    const Probe *armed = bench.add(2, false, Permission::Armed);
    const Probe *always = bench.add(3);
    const Probe *read = bench.add(4, true);
    bench.queue.cut("disarmed", inFlight,
        [](OpenWish &wish) { return wish.permission() == Permission::Armed; });
    QVERIFY(!inFlight->finished() && !always->finished() && !read->finished());
    QCOMPARE(reasonOf(armed), std::string("disarmed"));
    QCOMPARE(bench.ended(), (std::vector<WishId>{2}));
}

void TestWishQueue::aNewerWriteIsToldToWhatActs()
{
    Bench bench;
    const Probe *first = bench.add(1), *second = bench.add(2), *read = bench.add(3, true);
    bench.queue.supersede({});
    QCOMPARE(first->superseded, 1);
    QCOMPARE(second->superseded, 1);
    QCOMPARE(read->superseded, 0);
}

void TestWishQueue::eachEndIsToldOnceWithItsResults()
{
    Bench bench;
    Probe *probe = bench.add(7, true);
    QVERIFY(bench.collect().empty());
    probe->readings = {Reading{}};
    const auto some = bench.collect();
    QCOMPARE(some.size(), std::size_t{1});
    QVERIFY(std::holds_alternative<RegistersRead>(some[0]));
    probe->readings = {Reading{}};
    probe->motion() = MotionRecord{};
    probe->motion()->asked = t;
    QCOMPARE(bench.collect().size(), std::size_t{1}); // its record waits for its end
    probe->readings = {Reading{}};
    probe->cut("gone");
    const auto events = bench.collect(t + 5ms);
    QCOMPARE(events.size(), std::size_t{3});
    QVERIFY(std::holds_alternative<RegistersRead>(events[0]));
    const auto &motion = std::get<MotionRecord>(events[1]);
    QVERIFY(motion.ended == t + 5ms && motion.outcome == Outcome::NotSent);
    QCOMPARE(motion.reason, std::string("gone"));
    QCOMPARE(std::get<Ended>(events[2]).id, WishId{7});
    QVERIFY(bench.collect().empty());
    // No act ends before it was asked for, whichever clock told that.
    Probe *early = bench.add(8);
    early->motion() = MotionRecord{};
    early->motion()->asked = t + 1s;
    early->succeed();
    const auto last = bench.collect(t);
    QVERIFY(std::get<MotionRecord>(last.at(0)).ended == t + 1s);
}

QTEST_APPLESS_MAIN(TestWishQueue)
#include "tst_wish_queue.moc"
