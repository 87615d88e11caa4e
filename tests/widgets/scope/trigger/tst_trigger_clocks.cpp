// The trigger of samples whose board counts another time than the session does: by its crystal, or because a computer
// slept.
#include "widgets/scope/trigger/trigger.h"

#include <QtTest>

#include <cmath>

class TestTriggerClocks : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsSaidOfARecordFollowsItsSamples_data();
    void whatIsSaidOfARecordFollowsItsSamples();
};

void TestTriggerClocks::whatIsSaidOfARecordFollowsItsSamples_data()
{
    QTest::addColumn<double>("leap"); // seconds, of the session's clock alone
    QTest::addColumn<double>("rate"); // of the board's clock
    QTest::newRow("one clock") << 0.0 << 1.0;
    QTest::newRow("a leap") << 4.0 << 1.0;
    QTest::newRow("the board's 1 % slow") << 0.0 << 0.99;
    QTest::newRow("the board's 1 % fast") << 0.0 << 1.01;
}

void TestTriggerClocks::whatIsSaidOfARecordFollowsItsSamples()
{
    QFETCH(double, leap);
    QFETCH(double, rate);
    constexpr double kTicksPerSecond = 1000.0, kPacket_s = 0.01, kNear_s = 0.15;
    using Kind = scope::EventTrigger::Kind;
    capture::Capture capture;
    double now = 0.0;
    widgets::Trigger trigger(capture, [&now] { return now; });
    capture.begin({1, kTicksPerSecond, 0.0, 1, {{1, "I_A", "A", 1.0, 0.0}}, {}});
    trigger.setSource(capture.channels().front().id);
    capture::Tick tick = 0;
    double lived = 0.0;
    const auto live = [&](double seconds) {
        for (const double end = lived + seconds; lived < end;) {
            lived += kPacket_s;
            now += kPacket_s;
            const auto reached =
                static_cast<capture::Tick>(std::llround(lived * rate * kTicksPerSecond));
            capture::SampleBlock block;
            block.stream = 1;
            block.firstTick = tick;
            block.count = static_cast<std::uint32_t>(reached - tick);
            block.fast.assign(block.count, 7);
            tick = reached;
            capture.append(block);
            trigger.advance();
        }
    };
    const auto sampled = [&] { return double(tick) / kTicksPerSecond; };
    for (const auto &[type, kind] : {std::pair(widgets::TriggerType::SetPoint, Kind::SetPoint),
             std::pair(widgets::TriggerType::Fault, Kind::Fault)}) {
        live(20.0);
        now += std::exchange(leap, 0.0);
        live(3.0);
        widgets::TriggerSetup setup = trigger.setup();
        setup.type = type;
        setup.mode = scope::Mode::Normal;
        setup.length = 0.2;
        trigger.setSetup(setup);
        live(0.5);
        const double at = sampled();
        trigger.event(kind, now, 1);
        live(1.0);
        QVERIFY(!trigger.history().records().empty());
        const double found = capture::toSeconds(trigger.history().records().back().trigger);
        QVERIFY2(std::abs(found - at) < kNear_s, qPrintable(QString::number(found - at)));
        const double age = trigger.now() - found;
        QVERIFY2(std::abs(age - 1.0) < kNear_s, qPrintable(QString::number(age)));
    }
}

QTEST_GUILESS_MAIN(TestTriggerClocks)
#include "tst_trigger_clocks.moc"
