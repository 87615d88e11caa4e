// When a set-point left, told from outside a drive: by the bytes around it and the packets of samples before it.
#include "drive/set_points/times.h"

#include <QTest>

#include <cmath>

using namespace drive;
using namespace std::chrono_literals;

namespace {

constexpr double kHz = 16000.0;
constexpr std::uint32_t kCount = 160; ///< samples a packet: 10 ms

/// A board whose count began at 0 s of its own, and packets that take their time.
struct PacketBench {
    SetPointTimes times;
    capture::Tick tick = 0;
    Duration behind; ///< of the axis, behind the clock here, as the first packet has it

    explicit PacketBench(Duration first = 0ms)
        : behind(first)
    {
        Identified board;
        board.streaming.linkBytesPerSecond = 1e6;
        times.onEvent(board, {});
        capture::StreamLayout layout{1, kHz, toSeconds(first), 1, {{9, "I_A", "A", 1.0, 0.0}}, {}};
        times.onEvent(StreamStarted{layout}, {});
    }
    /// Its last sample is taken at `at` of the true time, which is that of the clock here, and it comes `late`.
    void packet(Duration late)
    {
        capture::SampleBlock block{1, tick, kCount, {}, {}, 0};
        block.fast.resize(kCount);
        tick += kCount;
        const auto crossing = fromSeconds((12.0 + 2.0 * kCount) / 1e6);
        times.onEvent(block, TimePoint(trueTime() + crossing + late));
    }
    Duration trueTime() const { return fromSeconds(static_cast<double>(tick) / kHz); }
    std::optional<SetPointNews> news(WishId id, TimePoint now, Outcome outcome = Outcome::Ok)
    {
        Ended ended;
        ended.id = id;
        ended.outcome = outcome;
        return times.onEvent(ended, now);
    }
    std::optional<SentSetPoint> ends(WishId id, TimePoint now, Outcome outcome = Outcome::Ok)
    {
        const auto told = news(id, now, outcome);
        return told ? std::optional(std::get<SentSetPoint>(*told)) : std::nullopt;
    }
    std::optional<SetPointsEnd> status(MotorState state, Duration asked)
    {
        MotorStatus status;
        status.state = state;
        status.asked = TimePoint(asked);
        status.at = status.asked + 5ms;
        const auto told = times.onEvent(status, status.at);
        return told ? std::optional(std::get<SetPointsEnd>(*told)) : std::nullopt;
    }
};

Wish wish(WishId id, decltype(Wish::what) what)
{
    Wish made;
    made.id = id;
    made.what = std::move(what);
    return made;
}

} // namespace

class TestSetPointTimes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void itLeftWithTheLastBytesBeforeItsAnswer()
    {
        PacketBench bench;
        bench.times.onSent(TimePoint(1s)); // something else
        bench.times.onWish(wish(7, SpeedRamp{1, -1500, 250ms}));
        bench.times.onReceived(TimePoint(1s + 2ms)); // its answer
        bench.times.onSent(TimePoint(1s + 3ms)); // the head
        bench.times.onSent(TimePoint(1s + 4ms)); // and the rest of the request
        bench.times.onReceived(TimePoint(1s + 5ms)); // samples in between
        bench.times.onReceived(TimePoint(1s + 6ms));
        bench.times.onSent(TimePoint(1s + 6ms)); // what comes next is not ours
        const auto sent = bench.ends(7, TimePoint(1s + 6ms));
        QVERIFY(sent);
        QCOMPARE(sent->wish, WishId{7});
        QVERIFY(sent->kind == SentSetPoint::Kind::Speed);
        QCOMPARE(sent->value, -1500.0);
        QCOMPARE(sent->ramp.count(), 250);
        QVERIFY(std::abs(sent->seconds - 1.004) < 1e-9);
        QVERIFY(std::abs(sent->within_s - 0.002) < 1e-9);
        QVERIFY(!bench.ends(7, TimePoint(2s))); // once
    }

    void theOtherKindsAreTold()
    {
        PacketBench bench;
        bench.times.onWish(wish(1, TorqueRamp{2, 1.5, 100ms}));
        bench.times.onWish(wish(2, CurrentReference{1, -0.5, 0.1}));
        bench.times.onWish(wish(3, PositionRamp{1, 3.0, 1s}));
        bench.times.onWish(wish(4, Command{MotorAction::Start, 1}));
        const auto torque = bench.ends(1, TimePoint(1s)), current = bench.ends(2, TimePoint(1s)),
                   position = bench.ends(3, TimePoint(1s));
        QVERIFY(torque && torque->kind == SentSetPoint::Kind::Current);
        QCOMPARE(torque->motor, 2);
        QCOMPARE(torque->value, 1.5);
        QVERIFY(current && current->kind == SentSetPoint::Kind::Current);
        QCOMPARE(current->value, -0.5);
        QVERIFY(position && position->kind == SentSetPoint::Kind::Position);
        QCOMPARE(position->ramp.count(), 1000);
        QVERIFY(!bench.ends(4, TimePoint(1s)));
    }

    void whatDidNotLeaveIsNoSetPoint()
    {
        PacketBench bench;
        for (const Outcome outcome : {Outcome::Refused, Outcome::NotSent}) {
            bench.times.onWish(wish(1, SpeedRamp{1, 100, 0ms}));
            QVERIFY(!bench.ends(1, TimePoint(1s), outcome));
        }
        bench.times.onWish(wish(1, SpeedRamp{1, 100, 0ms})); // its answer was lost
        bench.times.onSent(TimePoint(1s));
        bench.times.onReceived(TimePoint(1s + 100ms));
        const auto sent = bench.ends(1, TimePoint(2s), Outcome::Unknown);
        QVERIFY(sent && std::abs(sent->within_s - 1.0) < 1e-9);
        QVERIFY(!sent->sure);
    }

    void aRampThatIsStoppedStaysFromThenOn()
    {
        PacketBench bench;
        bench.times.onWish(wish(4, Command{MotorAction::StopRamp, 2}));
        bench.times.onSent(TimePoint(1s));
        bench.times.onReceived(TimePoint(1s + 2ms));
        const auto told = bench.news(4, TimePoint(1s + 2ms));
        const auto *end = told ? std::get_if<SetPointsEnd>(&*told) : nullptr;
        QVERIFY(end && end->held);
        QCOMPARE(end->motor, 2);
        QCOMPARE(end->wish, WishId{4});
        QVERIFY(std::abs(end->seconds - 1.0) < 1e-9);
        QVERIFY(std::abs(end->within_s - 0.002) < 1e-9);
        bench.times.onWish(wish(5, Command{MotorAction::StopRamp, 2}));
        QVERIFY(!bench.news(5, TimePoint(2s), Outcome::Refused)); // it goes on
        bench.times.onWish(wish(6, Command{MotorAction::StopRamp, 2}));
        const auto lost = bench.news(6, TimePoint(3s), Outcome::Unknown);
        QVERIFY(lost && !std::get<SetPointsEnd>(*lost).held);
        bench.times.onWish(wish(7, Command{MotorAction::StopMotor, 1}));
        const auto stopped = bench.news(7, TimePoint(4s));
        QVERIFY(stopped && !std::get<SetPointsEnd>(*stopped).held);
        const SetPointsEnd stop = bench.times.onStop(TimePoint(5s));
        QCOMPARE(stop.motor, 0);
        QCOMPARE(stop.seconds, 5.0);
        QVERIFY(!stop.held);
    }

    /// Since the last reading at which it was: what was between them is unknown.
    void aMotorThatIsDrivenNoMoreFollowsNothing()
    {
        for (const MotorState over : {MotorState::Idle, MotorState::FaultNow}) {
            PacketBench bench;
            QVERIFY(!bench.status(MotorState::Idle, 0s)); // nothing was driven before
            QVERIFY(!bench.status(MotorState::Starting, 900ms));
            QVERIFY(!bench.status(MotorState::Running, 1s));
            const auto end = bench.status(over, 1s + 100ms);
            QVERIFY(end && !end->held);
            QCOMPARE(end->motor, 1);
            QVERIFY(std::abs(end->seconds - 1.0) < 1e-9);
            QVERIFY(!bench.status(over, 2s)); // told once
        }
    }

    void aMotorThatStandsRampsNothing()
    {
        PacketBench bench;
        const auto runs = [&](WishId id) {
            bench.times.onWish(wish(id, SpeedRamp{1, 100, 1s}));
            return bench.ends(id, TimePoint(1s))->runs;
        };
        QVERIFY(runs(1)); // unknown: not said to stand
        bench.status(MotorState::Idle, 1s);
        QVERIFY(!runs(2));
        bench.times.onWish(wish(3, Command{MotorAction::Start, 1}));
        QVERIFY(runs(4)); // it may have begun
        bench.status(MotorState::Starting, 2s);
        QVERIFY(!runs(5));
        bench.status(MotorState::Running, 3s);
        QVERIFY(runs(6));
    }

    void aRegisterThatIsWrittenPastItEndsIt()
    {
        PacketBench bench;
        std::vector<catalog::RegisterInfo> registers(2);
        registers[0].id = 0x40;
        registers[0].name = "SPEED_KP";
        registers[0].effect = catalog::Effect::Kept;
        registers[1].id = 0x80;
        registers[1].name = "SPEED_RAMP";
        registers[1].effect = catalog::Effect::Reference;
        registers[0].perMotor = registers[1].perMotor = false;
        Identified board;
        board.catalog = std::make_shared<const catalog::Catalog>(
            std::move(registers), 1, std::vector<catalog::Scales>{});
        bench.times.onEvent(board, {});
        bench.times.onWish(wish(1, Write{{{0x40, std::int64_t{3}}}, {}}));
        QVERIFY(!bench.news(1, TimePoint(1s)));
        for (const auto outcome : {Outcome::Ok, Outcome::Unknown, Outcome::Refused}) {
            bench.times.onWish(
                wish(2, Write{{{0x40, std::int64_t{3}}, {0x80, std::int64_t{3}}}, {}}));
            const auto told = bench.news(2, TimePoint(1s), outcome); // a part of it is there
            QVERIFY(told && !std::get<SetPointsEnd>(*told).held);
        }
        bench.times.onWish(wish(2, Write{{{0x80, std::int64_t{3}}}, {}}));
        QVERIFY(!bench.news(2, TimePoint(1s), Outcome::NotSent));
    }

    void whatALinkTookAlongIsNotKnown()
    {
        PacketBench bench;
        const auto told = [&](LinkState state, LinkReason reason) {
            const auto news = bench.times.onEvent(LinkChanged{state, reason}, TimePoint(9s));
            return news ? std::get<SetPointsEnd>(*news).seconds : -1.0;
        };
        bench.times.onReceived(TimePoint(7s));
        QCOMPARE(told(LinkState::Suspect, LinkReason::None), -1.0);
        QCOMPARE(told(LinkState::Lost, LinkReason::Silence), 7.0); // not heard since
        QCOMPARE(told(LinkState::Connected, LinkReason::None), -1.0);
        QCOMPARE(told(LinkState::Connected, LinkReason::BoardReset), 9.0);
    }

    /// A first packet that came 20 ms late puts the axis 20 ms behind; the ones after it tell.
    void aLateFirstPacketIsAllowedFor()
    {
        PacketBench bench(20ms);
        for (int i = 0; i < 100; ++i)
            bench.packet(i == 0 ? Duration(20ms) : i % 5 ? Duration(3ms) : Duration(0));
        bench.times.onWish(wish(1, SpeedRamp{1, 100, 0ms}));
        const TimePoint left(bench.trueTime());
        bench.times.onSent(left);
        bench.times.onReceived(left + 1ms);
        const auto sent = bench.ends(1, left + 1ms);
        QVERIFY(sent);
        // What is sampled now stands 20 ms later on the axis, and so does it.
        QVERIFY2(std::abs(sent->seconds - toSeconds(left.time_since_epoch()) - 0.020) < 1e-6,
            qPrintable(QString::number(sent->seconds)));
    }

    /// Crystals differ by 100 millionths: after ten minutes that are 60 ms.
    void clocksThatDriftApartAreFollowed()
    {
        for (const double drift : {1e-4, -1e-4}) {
            PacketBench bench;
            double worst = 0.0;
            for (int i = 0; i < 60000; ++i) {
                capture::SampleBlock block{1, bench.tick, kCount, {}, {}, 0};
                block.fast.resize(kCount);
                bench.tick += kCount;
                const double axis = static_cast<double>(bench.tick) / kHz;
                const double here = axis * (1.0 + drift);
                bench.times.onEvent(block,
                    TimePoint(fromSeconds(here + (12.0 + 2.0 * kCount) / 1e6 + (i % 7) * 1e-4)));
                if (i % 1000 != 999)
                    continue;
                bench.times.onWish(wish(1, SpeedRamp{1, 100, 0ms}));
                bench.times.onSent(TimePoint(fromSeconds(here)));
                bench.times.onReceived(TimePoint(fromSeconds(here)));
                const auto sent = bench.ends(1, TimePoint(fromSeconds(here)));
                worst = std::max(worst, std::abs(sent->seconds - axis));
            }
            QVERIFY2(worst < 3e-4, qPrintable(QString::number(worst)));
        }
    }

    /// Another board, or the same after a reset, has another axis.
    void aNewAxisIsLearntAnew()
    {
        PacketBench bench(50ms);
        bench.packet(0ms);
        capture::StreamLayout layout{2, kHz, 0.0, 1, {}, {}};
        bench.times.onEvent(StreamStarted{layout}, {});
        bench.times.onWish(wish(1, SpeedRamp{1, 100, 0ms}));
        bench.times.onSent(TimePoint(1s));
        bench.times.onReceived(TimePoint(1s));
        QCOMPARE(bench.ends(1, TimePoint(1s))->seconds, 1.0);
    }
};

QTEST_APPLESS_MAIN(TestSetPointTimes)
#include "tst_set_point_times.moc"
