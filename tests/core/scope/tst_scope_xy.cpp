// Pairs of channels: matched by time, broken where nothing is known and where an angle passes its end.
#include "scope/xy.h"
#include "support/channels/analytic_channel.h"

#include <QtTest>

using namespace scope;
using support::fastChannel;
using support::kRate;
using support::kSecond;
using support::kTurn;

class TestScopeXy : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCircleIsRound();
    void samplesOfOneTickMeetAtAnyRate();
    void theSlowerChannelHolds();
    void gapsBreakTheLine();
    void anAnglesEndMakesNoSpike();
    void longTracesAreThinnedOut();
    void nothingMakesNoPoints();
    void theHexagonIsWhatTheBusAllows();
};

namespace {
constexpr Nanos kSample = 62'500; // at 16 kHz

std::size_t breaks(const XyTrace &trace)
{
    return std::size_t(std::count_if(trace.points.begin(), trace.points.end(),
        [](const XyPoint &point) { return point.first; }));
}
} // namespace

void TestScopeXy::aCircleIsRound()
{
    const auto alpha = fastChannel(1000, [](double t) { return 5 * std::cos(kTurn * 50 * t); });
    const auto beta = fastChannel(1000, [](double t) { return 5 * std::sin(kTurn * 50 * t); });
    const XyTrace trace = xyTrace(alpha, beta, 0, kSecond, {});
    QCOMPARE(trace.points.size(), 1000U);
    QCOMPARE(trace.every, 1U);
    QCOMPARE(breaks(trace), 1U);
    QVERIFY(trace.points[0].first);
    for (std::size_t i = 0; i < trace.points.size(); ++i) {
        QVERIFY(std::abs(std::hypot(trace.points[i].x, trace.points[i].y) - 5.0) < 0.002);
        QCOMPARE(trace.points[i].time, alpha.timeOf(i));
    }
    const XyTrace part = xyTrace(alpha, beta, 10 * kSample, 20 * kSample, {});
    QCOMPARE(part.points.size(), 10U);
    QCOMPARE(part.points[0].x, trace.points[10].x);
}

void TestScopeXy::samplesOfOneTickMeetAtAnyRate()
{
    for (const double rate : {30000.0, 7777.7, 48123.456}) { // ticks that are no whole nanoseconds
        const auto ramp = [=](double t) { return std::fmod(t * rate, 1000.0) / 100.0; };
        const auto x = fastChannel(20000, ramp, 0.0, 1, rate, 123456789);
        const auto y = fastChannel(20000, ramp, 0.0, 2, rate, 123456789);
        const XyTrace trace = xyTrace(x, y, 0, std::numeric_limits<Nanos>::max(), {});
        QCOMPARE(trace.points.size(), 20000U);
        for (const XyPoint &point : trace.points)
            QCOMPARE(point.x, point.y);
    }
}

void TestScopeXy::theSlowerChannelHolds()
{
    const auto fast = fastChannel(16, [](double t) { return t * kRate; });
    capture::Channel slow({2, 8, "Y", "V", 1.0, 0.0, capture::ChannelInfo::Kind::Slow});
    slow.values()->append(4 * kSample, 1.0, 8 * kSample);
    slow.values()->append(8 * kSample, 2.0, 12 * kSample);
    const XyTrace trace = xyTrace(fast, slow, 0, kSecond, {});
    QCOMPARE(trace.points.size(), 8U); // from sample 4 to 11
    for (std::size_t i = 0; i < 8; ++i) {
        QCOMPARE(trace.points[i].x, double(4 + i));
        QCOMPARE(trace.points[i].y, i < 4 ? 1.0 : 2.0);
    }
    const XyTrace turned = xyTrace(slow, fast, 0, kSecond, {});
    QCOMPARE(turned.points.size(), 8U);
    QCOMPARE(turned.points[5].y, 9.0);
    // A value from before.
    QCOMPARE(xyTrace(fast, slow, 6 * kSample, kSecond, {}).points.size(), 6U);
}

void TestScopeXy::gapsBreakTheLine()
{
    auto x = fastChannel(100, [](double) { return 1.0; });
    auto y = fastChannel(40, [](double) { return 2.0; });
    const std::vector<std::int16_t> more(30, 3000);
    y.fast()->append(capture::TickBase::of(kRate, 0), 60, 1, more);
    const XyTrace trace = xyTrace(x, y, 0, kSecond, {});
    QCOMPARE(trace.points.size(), 70U);
    QCOMPARE(breaks(trace), 2U);
    QVERIFY(trace.points[40].first);
    // However few points are left, the gap is between two of them.
    XySettings few;
    few.most = 7;
    QCOMPARE(breaks(xyTrace(x, y, 0, kSecond, few)), 2U);
}

void TestScopeXy::anAnglesEndMakesNoSpike()
{
    const auto current = fastChannel(1600, [](double t) { return std::sin(kTurn * 50 * t); });
    const auto angle = fastChannel(
        1600, [](double t) { return std::remainder(t * 50 * 20 + 1.0, 20.0); }); // 5 turns of 20
    XySettings settings;
    settings.turnX = 20.0;
    const XyTrace trace = xyTrace(angle, current, 0, kSecond, settings);
    QCOMPARE(breaks(trace), 6U);
    for (std::size_t i = 1; i < trace.points.size(); ++i)
        QVERIFY(trace.points[i].first || std::abs(trace.points[i].x - trace.points[i - 1].x) < 1.0);
    settings.turnX = 0.0;
    settings.turnY = 20.0;
    QCOMPARE(breaks(xyTrace(current, angle, 0, kSecond, settings)), 6U);
    QCOMPARE(breaks(xyTrace(angle, current, 0, kSecond, {})), 1U);
}

void TestScopeXy::longTracesAreThinnedOut()
{
    const auto x = fastChannel(50000, [](double t) { return t; });
    const auto y = fastChannel(50000, [](double t) { return -t; });
    XySettings settings;
    settings.most = 1000;
    const XyTrace trace = xyTrace(x, y, 0, 100 * kSecond, settings);
    QCOMPARE(trace.every, 50U);
    QCOMPARE(trace.points.size(), 1000U);
    QCOMPARE(trace.points[3].time, x.timeOf(150));
}

void TestScopeXy::nothingMakesNoPoints()
{
    const auto x = fastChannel(10, [](double) { return 0.0; });
    const auto empty = fastChannel(0, [](double) { return 0.0; });
    QVERIFY(xyTrace(x, empty, 0, kSecond, {}).points.empty());
    QVERIFY(xyTrace(empty, x, 0, kSecond, {}).points.empty());
    QVERIFY(xyTrace(x, x, kSecond, 0, {}).points.empty());
}

void TestScopeXy::theHexagonIsWhatTheBusAllows()
{
    const auto corners = voltageHexagon(24.0);
    QCOMPARE(corners[0].x, 16.0);
    for (std::size_t i = 0; i < 6; ++i) {
        const XyPoint &one = corners[i];
        const XyPoint &next = corners[(i + 1) % 6];
        QVERIFY(std::abs(std::hypot(one.x, one.y) - 16.0) < 1e-12);
        // The circle touches the middle of each side.
        QVERIFY(
            std::abs(std::hypot((one.x + next.x) / 2, (one.y + next.y) / 2) - linearVoltage(24.0))
            < 1e-12);
        QVERIFY(one.x * next.y - one.y * next.x > 0); // counterclockwise
    }
}

QTEST_APPLESS_MAIN(TestScopeXy)
#include "tst_scope_xy.moc"
