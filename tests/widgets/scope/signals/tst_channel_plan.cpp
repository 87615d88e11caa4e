#include "support/window_facts.h"
#include "widgets/scope/signals/channel_plan.h"

#include <QTest>

#include <cmath>

using widgets::Detour;
using widgets::Route;
using widgets::WantedSignal;

class TestChannelPlan : public QObject {
    Q_OBJECT

    /// The id of signal `n`, from 1; its low bits would name a motor.
    static constexpr catalog::RegisterId idOf(std::uint32_t n) { return 0x40 * n; }

    /// A board with `count` signals that can be recorded.
    static catalog::Catalog board(std::uint32_t count)
    {
        std::vector<catalog::RegisterInfo> registers;
        for (std::uint32_t n = 1; n <= count; ++n) {
            registers.push_back(facts::makeRegister(idOf(n), "S" + std::to_string(n), "Signals"));
            registers.back().streaming = catalog::Streaming::Fast;
        }
        registers.push_back(facts::makeRegister(idOf(100), "SLOW", "Signals"));
        return {std::move(registers), 1, {}};
    }
    static std::vector<WantedSignal> want(std::uint32_t count)
    {
        std::vector<WantedSignal> wanted;
        for (std::uint32_t n = 1; n <= count; ++n)
            wanted.push_back({idOf(n), Route::Fast, 0});
        return wanted;
    }
    static drive::StreamLimits limits(double baud) { return {16000.0, 10, 2048, baud / 10.0}; }

private Q_SLOTS:
    void theTableOfWhatFits_data()
    {
        QTest::addColumn<double>("baud");
        QTest::addColumn<int>("signalCount");
        QTest::addColumn<unsigned>("every");
        QTest::newRow("5 at 1843200") << 1843200.0 << 5 << 1U;
        QTest::newRow("6 at 1843200") << 1843200.0 << 6 << 2U;
        QTest::newRow("10 at 1843200") << 1843200.0 << 10 << 2U;
        QTest::newRow("2 at 921600") << 921600.0 << 2 << 1U;
        QTest::newRow("5 at 921600") << 921600.0 << 5 << 2U;
        QTest::newRow("1 at 115200") << 115200.0 << 1 << 4U;
        QTest::newRow("2 at 115200") << 115200.0 << 2 << 8U;
    }
    void theTableOfWhatFits()
    {
        QFETCH(double, baud);
        QFETCH(int, signalCount);
        QFETCH(unsigned, every);
        const auto count = static_cast<std::uint32_t>(signalCount);
        const auto plan = widgets::planChannels(want(count), board(12), limits(baud), 1);
        QCOMPARE(plan.stream.fastEvery, every);
        QCOMPARE(plan.stream.fast.size(), std::size_t{count});
        QCOMPARE(plan.rateLowered, every != 1);
        QVERIFY(plan.share <= widgets::kStreamShare);
        QCOMPARE(plan.fastHz, 16000.0 / every);
    }

    void thePlanSaysHowManyFitAtFullRate()
    {
        const auto fit = [](double tickHz, double baud) {
            drive::StreamLimits limits{tickHz, 20, 2048, baud / 10.0};
            return widgets::planChannels(want(1), board(12), limits, 1).fitAtFullRate;
        };
        QCOMPARE(fit(16000.0, 1843200.0), 5U);
        QCOMPARE(fit(20000.0, 1843200.0), 4U);
        // Three need 98 % of it, and something has to stay free.
        QCOMPARE(fit(30000.0, 1843200.0), 2U);
        QCOMPARE(fit(16000.0, 921600.0), 2U);
        QCOMPARE(fit(30000.0, 921600.0), 1U);
        QCOMPARE(fit(16000.0, 115200.0), 0U);
        drive::StreamLimits none{0.0, 0, 0, 184320.0};
        QCOMPARE(widgets::planChannels(want(1), board(12), none, 1).fitAtFullRate, 0U);
    }

    void thePlanTellsThePacketsAndWhatWasWishedFor()
    {
        const auto plan = widgets::planChannels(want(6), board(12), limits(1843200.0), 1);
        QVERIFY(plan.fullRateBytes > 192000.0); // 6 x 2 bytes x 16 kHz, and what frames them
        QVERIFY(plan.bytesPerSecond < 184320.0);
        QVERIFY(plan.packetSeconds < 0.0121); // rather emptier than late
        drive::StreamLimits small = limits(1843200.0);
        small.maxPacket = 128;
        const auto often = widgets::planChannels(want(2), board(12), small, 1);
        // Full packets.
        QVERIFY(std::abs(often.packetSeconds * often.bytesPerSecond - 128.0) < 0.01);
        const auto slow = widgets::planChannels(want(1), board(12), limits(115200.0), 64);
        QVERIFY(slow.packetSeconds < 0.0121);
        QCOMPARE(widgets::planChannels(want(0), board(12), limits(115200.0), 1).packetSeconds, 0.0);
    }

    void aRateThatFitsIsLeftAlone()
    {
        const auto plan = widgets::planChannels(want(2), board(12), limits(1843200.0), 3);
        QCOMPARE(plan.stream.fastEvery, 3U);
        QVERIFY(!plan.rateLowered);
    }

    void whatTheBoardCannotRecordIsPolled()
    {
        auto wanted = want(1);
        wanted.push_back({idOf(100), Route::Fast, 0});
        const auto plan = widgets::planChannels(wanted, board(12), limits(1843200.0), 1);
        QCOMPARE(plan.polled, std::vector<catalog::RegisterId>(1, idOf(100)));
        QVERIFY(plan.signalList[1].detour == Detour::NotStreamable);
    }

    void moreSignalsThanTheBoardTakesArePolled()
    {
        const auto plan = widgets::planChannels(want(12), board(12), limits(1843200.0), 1);
        QCOMPARE(plan.stream.fast.size(), 10U);
        QCOMPARE(plan.polled, (std::vector<catalog::RegisterId>{idOf(11), idOf(12)}));
        QVERIFY(plan.signalList[11].detour == Detour::TooManySignals);
    }

    void aVerySlowLinkPollsTheLastOnes()
    {
        const auto plan = widgets::planChannels(want(10), board(12), limits(9600.0), 1);
        QVERIFY(plan.stream.fast.size() < 10);
        QCOMPARE(plan.stream.fast.size() + plan.polled.size(), 10U);
        QVERIFY(plan.share <= widgets::kStreamShare);
        QVERIFY(plan.signalList[9].detour == Detour::LinkFull);
    }

    void slowSignalsCostLess()
    {
        auto slow = want(5);
        slow[4].route = Route::Slow;
        const auto all = widgets::planChannels(want(5), board(12), limits(1843200.0), 1);
        const auto some = widgets::planChannels(slow, board(12), limits(1843200.0), 1);
        QCOMPARE(some.stream.slow.size(), 1U);
        QVERIFY(some.bytesPerSecond < all.bytesPerSecond);
    }

    void aBoardWithoutStreamingPollsEverything()
    {
        const auto plan = widgets::planChannels(want(3), board(12), {}, 1);
        QVERIFY(plan.stream.fast.empty());
        QCOMPARE(plan.polled.size(), 3U);
        QCOMPARE(plan.bytesPerSecond, 0.0);
    }

    /// As in an exchange with a servo drive: whatever is streamed, each period has its header and its CRC.
    void framesOfTheirOwnAreCountedWhole()
    {
        auto registers = board(15).registers();
        for (catalog::RegisterInfo &one : registers)
            one.type = catalog::ValueType::F32;
        registers.front().type = catalog::ValueType::U16;
        const catalog::Catalog known(std::move(registers), 1, {});
        drive::StreamLimits limits{1000.0, 15, 76, 76000.0};
        limits.frameOverhead = 12;
        const auto plan = widgets::planChannels(want(4), known, limits, 1);
        QCOMPARE(plan.bytesPerSecond, 1000.0 * (12 + 2 + 3 * 4));
        QCOMPARE(plan.share, 26.0 / 76.0);
        QCOMPARE(plan.packetSeconds, 0.001);
        QCOMPARE(plan.fitAtFullRate, 15U);
        QCOMPARE(widgets::planChannels(want(4), known, limits, 4).bytesPerSecond, 6500.0);
        auto slow = want(4);
        slow[3].route = Route::Slow; // goes along in each of them
        QCOMPARE(widgets::planChannels(slow, known, limits, 1).bytesPerSecond, 26000.0);
        // Nearly all of the link: requests travel in the same frames.
        const auto full = widgets::planChannels(want(15), known, limits, 1);
        QCOMPARE(full.bytesPerSecond, 70000.0);
        QVERIFY(!full.rateLowered && full.polled.empty());
    }

    void nothingWantedIsAnEmptyStream()
    {
        const auto plan = widgets::planChannels({}, board(12), limits(1843200.0), 1);
        QVERIFY(plan.stream.fast.empty() && plan.stream.slow.empty() && plan.polled.empty());
        QCOMPARE(plan.bytesPerSecond, 0.0);
    }
};

QTEST_MAIN(TestChannelPlan)
#include "tst_channel_plan.moc"
