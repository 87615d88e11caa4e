// What an MCB drive does with requests while its servo is not ready for them.
#include "support/mcb/pair.h"

#include <QtTest>

using namespace drive;
using namespace std::chrono_literals;
using support::McbPair;

class TestMcbNotReady : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatWaitsForTheDriveEndsWithItsPermission_data();
    void whatWaitsForTheDriveEndsWithItsPermission();
};

void TestMcbNotReady::whatWaitsForTheDriveEndsWithItsPermission_data()
{
    QTest::addColumn<int>("what");
    QTest::newRow("disarmed") << 0;
    QTest::newRow("disconnected") << 1;
    QTest::newRow("too late") << 2;
    QTest::newRow("disarmed and armed again") << 3;
}

/// A drive that is not ready keeps requests waiting: cut off at any moment, none of them acts afterwards.
void TestMcbNotReady::whatWaitsForTheDriveEndsWithItsPermission()
{
    QFETCH(int, what);
    int leftBefore = 0;
    const int moments = what == 3 ? 40 : 12; // a start looks first at what it would start to
    for (int moment = 0; moment < moments; ++moment) {
        McbPair pair;
        QVERIFY(pair.meet());
        pair.drive->arm();
        pair.exchange();
        pair.look = 100us;
        const auto letThrough = [&](int frames) {
            for (int i = 0; i < frames; ++i) {
                pair.drive->handleReady(true, pair.now);
                pair.runFor(100us);
            }
        };
        pair.drive->handleReady(false, pair.now);
        pair.writes.clear();
        const WishId id = pair.submit(
            Command{what == 3 ? MotorAction::Start : MotorAction::AcknowledgeFaults, 1});
        letThrough(moment);
        const std::size_t before = pair.writes.size();
        leftBefore += before > 0 ? 1 : 0;
        if (what == 0)
            pair.drive->disarm();
        else if (what == 1)
            pair.drive->disconnect(pair.now);
        else if (what == 2)
            pair.runFor(600ms);
        if (what == 3) {
            pair.drive->disarm();
            pair.drive->arm();
        }
        letThrough(100);
        if (what != 2 || before == 0) // what was begun in time is finished
            QCOMPARE(pair.writes.size(), before);
        QCOMPARE(pair.ended[id].size(), std::size_t{1});
        QVERIFY(before > 0 || pair.ended[id].front().outcome == Outcome::NotSent);
    }
    QVERIFY(leftBefore > 0 && leftBefore < moments);
}

QTEST_GUILESS_MAIN(TestMcbNotReady)
#include "tst_mcb_not_ready.moc"
