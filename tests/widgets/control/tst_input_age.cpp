// How late input is judged to be: by the window's own heart, and by time stamps that prove to be a clock's.
#include "widgets/control/input_age.h"

#include "drive/wish.h"

#include <QTest>

using namespace std::chrono_literals;
using drive::kWishExpiresAfter;
using widgets::InputAge;

namespace {

/// A window whose heart beats, with a clock of the window system's that is `ahead` of ours.
struct Bench {
    InputAge age;
    TimePoint now{1000s};
    std::chrono::milliseconds ahead{123'456};

    Duration delay() const { return now - age.madeAt(now); }
    std::uint64_t stampAt(TimePoint at) const
    {
        const auto ms =
            std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch() + ahead);
        return static_cast<std::uint32_t>(ms.count());
    }
    void live(Duration time, bool moving = false)
    {
        for (const TimePoint end = now + time; now < end; now += 100ms) {
            age.beat(now);
            if (moving)
                age.note(stampAt(now), now + 3ms); // they are never handled at once
        }
        age.beat(now);
    }
};

} // namespace

class TestInputAge : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsPressedInALiveWindowIsNew()
    {
        Bench bench;
        bench.live(10s);
        bench.age.note(0, bench.now);
        QVERIFY(bench.delay() == 0ns);
        bench.now += 450ms; // busy, but not for too long
        bench.age.note(0, bench.now);
        QVERIFY(bench.delay() == 0ns);
    }

    void whatWaitedInAFrozenWindowIsLateWhicheverComesFirst()
    {
        for (const bool beatFirst : {true, false}) {
            Bench bench;
            bench.live(10s);
            bench.now += 8s;
            if (beatFirst)
                bench.age.beat(bench.now);
            bench.age.note(0, bench.now);
            QVERIFY(bench.delay() == 8s);
            bench.age.beat(bench.now); // and in between
            bench.age.note(0, bench.now + 10ms);
            QVERIFY(bench.delay() == 8s);
        }
    }

    void afterTwoPunctualBeatsInputCountsAgain()
    {
        Bench bench;
        bench.live(10s);
        bench.now += 501ms;
        bench.age.beat(bench.now);
        bench.now += 100ms;
        bench.age.beat(bench.now);
        bench.age.note(0, bench.now);
        QVERIFY(bench.delay() > kWishExpiresAfter); // it may still be of the heap
        bench.now += 100ms;
        bench.age.beat(bench.now);
        QVERIFY(bench.delay() > kWishExpiresAfter); // what follows from the late one stays late
        bench.age.note(0, bench.now);
        QVERIFY(bench.delay() == 0ns);
    }

    void stampsThatKeepPaceTellWhatIsLate()
    {
        Bench bench;
        bench.live(5s, true);
        bench.age.note(bench.stampAt(bench.now - 700ms), bench.now); // a slow network
        QVERIFY(bench.delay() > 600ms && bench.delay() < 800ms);
        bench.age.note(bench.stampAt(bench.now), bench.now);
        QVERIFY(bench.delay() < 5ms);
    }

    void stampsBeginAnewAfterSevenWeeks()
    {
        Bench bench;
        bench.ahead = std::chrono::milliseconds(0x1'0000'0000) - 1'003'000ms;
        bench.live(20s, true);
        QVERIFY(bench.delay() < 5ms);
        bench.age.note(bench.stampAt(bench.now - 700ms), bench.now);
        QVERIFY(bench.delay() > 600ms && bench.delay() < 800ms);
    }

    void stampsThatAreNoClockCountForNothing()
    {
        Bench bench;
        std::uint64_t stamp = 0; // as QTest makes them up
        for (int i = 0; i < 200; ++i) {
            bench.live(i % 7 * 300ms);
            bench.age.note(stamp += 501, bench.now);
            QVERIFY(bench.delay() == 0ns);
        }
    }

    void aClockThatWasSetIsFoundAgain()
    {
        for (const auto step : {-3600'000ms, 3600'000ms}) {
            Bench bench;
            bench.live(5s, true);
            bench.ahead += step;
            bench.live(5s, true);
            QVERIFY(bench.delay() < 5ms);
            bench.age.note(bench.stampAt(bench.now - 700ms), bench.now);
            QVERIFY(bench.delay() > 600ms && bench.delay() < 800ms);
        }
    }

    void clocksThatDriftApartAreFollowed()
    {
        Bench bench;
        for (int i = 0; i < 3600; ++i) { // 200 ppm for an hour
            bench.live(1s, true);
            if (i % 5 == 0)
                bench.ahead -= 1ms;
            QVERIFY(bench.delay() < 100ms);
        }
    }

    void aFreezeDoesNotMakeTheStampsAgree()
    {
        Bench bench;
        bench.live(5s, true);
        const TimePoint frozen = bench.now;
        bench.now += 8s;
        for (int i = 0; i < 3; ++i)
            bench.age.beat(bench.now); // the other rule has forgotten it
        for (TimePoint at = frozen; at < bench.now - 600ms; at += 50ms) {
            bench.age.note(bench.stampAt(at), bench.now);
            QVERIFY(bench.delay() > kWishExpiresAfter);
        }
    }
};

QTEST_APPLESS_MAIN(TestInputAge)
#include "tst_input_age.moc"
