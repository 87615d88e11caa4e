// A recording as a drive: the same samples and values, in the pace asked for, and no way to write.
#include "capture/capture.h"
#include "recorded/encoder.h"
#include "recorded/replay_drive.h"

#include <QtTest>

using namespace std::chrono_literals;
using namespace recorded;

namespace {

constexpr Nanos kSecond = 1'000'000'000;
constexpr RegisterId kSpeed = (45U << 6) | 1U;

/// Three seconds of one fast signal at 1 kHz in blocks of 100 ms, from 100 s on, a polled value and a state a second.
Bytes recording()
{
    Encoder encoder({0, "test", "board"}, Encoder::Config{.blockBytes = 200});
    Bytes file = encoder.head().bytes;
    const Nanos start = 100 * kSecond;
    encoder.add(start, Happening{"board", {{"firmware", "FW"}, {"version", "6.4.0"}}});
    encoder.add(start, capture::StreamLayout{1, 1000.0, 100.0, 1, {{9, "I_A", "A", 0.5, 0.0}}, {}});
    encoder.add(start, PolledRegister{kSpeed, "SPEED", "rpm"});
    for (capture::Tick tick = 0; tick < 3000; tick += 100) {
        const Nanos at = start + (tick + 100) * 1'000'000;
        capture::SampleBlock block{1, tick, 100, {}, {}, 0};
        for (capture::Tick i = 0; i < 100; ++i)
            block.fast.push_back(static_cast<std::int16_t>(tick + i));
        encoder.add(at - 100'000'000, std::move(block)); // the time of its beginning, as gathered
        encoder.flushAll();
        if (tick % 1000 == 900) {
            encoder.add(at, PolledValues{{{kSpeed, at, double(tick)}}});
            encoder.add(at,
                Happening{"motor state",
                    {{"motor", "1"}, {"state", "running"}, {"raw", "6"}, {"name", "RUN"},
                        {"faults now", "OVER_VOLT UNDER_VOLT"}}});
            encoder.add(at, Happening{"speed ramp", {{"rpm", "500"}}});
        }
    }
    encoder.end(start + 3 * kSecond, {});
    for (const Block &block : encoder.takeBlocks())
        file.insert(file.end(), block.bytes.begin(), block.bytes.end());
    return file;
}

/// Three seconds of a signal at 1 kHz, gathered as a live recording does: what is told meanwhile stands in front of
/// them.
/// @param full  the end lies in the place that was kept for it
Bytes gathered(bool full)
{
    Encoder encoder({0, "test", "board"});
    Bytes file = encoder.head().bytes;
    encoder.add(0, capture::StreamLayout{1, 1000.0, 0.0, 1, {{9, "I_A", "A", 0.5, 0.0}}, {}});
    for (capture::Tick tick = 0; tick < 3000; tick += 20) {
        const Nanos at = tick * 1'000'000;
        encoder.flush(at);
        encoder.add(at, capture::SampleBlock{1, tick, 20, std::vector<std::int16_t>(20, 7), {}, 0});
        if (tick % 100 == 40)
            encoder.add(at, Happening{"speed ramp", {{"rpm", "500"}}});
    }
    encoder.flushAll();
    if (!full)
        encoder.end(3 * kSecond, {});
    for (const Block &block : encoder.takeBlocks())
        file.insert(file.end(), block.bytes.begin(), block.bytes.end());
    if (full) {
        const auto end = encoder.endInReserve(3 * kSecond, {End::Reason::DiskFull, "", 0, 0});
        std::copy(end.bytes.begin(), end.bytes.end(),
            file.begin() + static_cast<std::ptrdiff_t>(end.offset));
    }
    return file;
}

bool near(std::uint64_t one, std::uint64_t other, std::uint64_t by = 40)
{
    return one + by >= other && one <= other + by;
}

struct Control : ReplayControl {
    ReplayPace wanted;
    bool isFull = false;
    std::uint64_t values = 0;
    std::vector<std::pair<Nanos, Entry>> entries;
    ReplayProgress last;
    ReplayPace pace() const override { return wanted; }
    bool full() const override { return isFull; }
    std::optional<std::uint64_t> goTo;
    std::optional<std::uint64_t> takeSeek() override { return std::exchange(goTo, std::nullopt); }
    void handed(std::uint64_t count) override { values += count; }
    void told(Nanos at, const Entry &entry) override { entries.emplace_back(at, entry); }
    void progressed(const ReplayProgress &progress) override { last = progress; }
};

/// A replay on a line that answers at once, in virtual time.
struct Bench {
    Control control;
    ReplayDrive drive{&control};
    Bytes file;
    std::size_t at = 0;
    bool told = false; ///< the end of the file
    TimePoint now{500s};
    std::vector<drive::Event> events;
    capture::Capture capture;

    explicit Bench(Bytes bytes = recording(), ReplayPace pace = {})
        : file(std::move(bytes))
    {
        control.wanted = pace;
        drive.connect(now);
        settle();
    }
    void settle()
    {
        for (std::vector<Output> outputs = drive.takeOutput(); !outputs.empty();
             outputs = drive.takeOutput()) {
            for (const Output &output : outputs) {
                ByteReader reader(output.bytes);
                const std::size_t wanted = reader.u32();
                if (const std::uint64_t place = reader.u64(); reader.ok())
                    at = static_cast<std::size_t>(place);
                const std::size_t count = std::min<std::size_t>(wanted, file.size() - at);
                drive.receive(ByteView(file).subspan(at, count), now);
                at += count;
            }
        }
        for (drive::Event &event : drive.takeEvents()) {
            if (const auto *started = std::get_if<drive::StreamStarted>(&event))
                capture.begin(started->layout);
            if (const auto *block = std::get_if<capture::SampleBlock>(&event))
                capture.append(*block);
            events.push_back(std::move(event));
        }
    }
    /// As a session does it: at every time-out, and not past `until`.
    void runFor(Duration time)
    {
        const TimePoint until = now + time;
        while (const auto next = drive.nextTimeout()) {
            if (*next > until)
                break;
            now = std::max(*next, now + 1ms);
            drive.handleTimeout(now);
            settle();
        }
        now = std::max(now, until);
        drive.handleTimeout(now);
        settle();
    }
    template <class T>
    std::vector<T> all() const
    {
        std::vector<T> found;
        for (const drive::Event &event : events)
            if (const auto *one = std::get_if<T>(&event))
                found.push_back(*one);
        return found;
    }
    std::uint64_t samples() const
    {
        std::uint64_t count = 0;
        for (const auto &block : all<capture::SampleBlock>())
            count += block.count;
        return count;
    }
};

} // namespace

class TestReplayDrive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itsPaceIsThatOfTheRecording()
    {
        Bench bench;
        for (std::uint64_t step = 0; step < 50; ++step) { // smoothly, not in the file's blocks
            QVERIFY(bench.samples() >= 20 * step);
            QVERIFY(bench.samples() <= 20 * step + 40);
            bench.runFor(20ms);
        }
        bench.runFor(500ms);
        QVERIFY(near(bench.samples(), 1500));
        bench.control.wanted.speed = 4.0;
        bench.runFor(250ms);
        QVERIFY(near(bench.samples(), 2450, 80));
        bench.runFor(1s);
        QCOMPARE(bench.samples(), 3000U);
        QCOMPARE(bench.control.values, 3003U); // and three readings
        QVERIFY(bench.control.last.ended);
    }

    void anEndInFrontChangesNoOrder()
    {
        for (const bool full : {false, true}) {
            Bench bench(gathered(full));
            for (std::uint64_t step = 0; step < 100; ++step) {
                QVERIFY(bench.samples() >= 20 * step);
                QVERIFY(bench.samples() <= 20 * step + 40);
                bench.runFor(20ms);
            }
            bench.runFor(3s);
            QCOMPARE(bench.samples(), 3000U);
            QVERIFY(bench.control.last.ended);
            QCOMPARE(bench.control.entries.size(), std::size_t(31));
            const auto &[at, last] = bench.control.entries.back();
            QVERIFY(std::holds_alternative<End>(last)); // once
            QCOMPARE(at, 503 * kSecond);
            QVERIFY(bench.control.last.bytes > bench.file.size() / 2);
        }
    }

    void aPauseLosesNothing()
    {
        Bench bench;
        bench.runFor(1s);
        bench.control.wanted.paused = true;
        QVERIFY(near(bench.samples(), 1000));
        const std::uint64_t held = bench.samples();
        bench.runFor(1h);
        QCOMPARE(bench.samples(), held);
        bench.control.wanted.paused = false;
        bench.runFor(1s);
        QVERIFY(near(bench.samples(), 1980, 60));
        bench.runFor(3s);
        QCOMPARE(bench.samples(), 3000U);
    }

    void goingForwardLeavesNothingOutAndStaysThere()
    {
        Bench bench;
        bench.control.wanted.paused = true;
        bench.control.goTo = bench.file.size() / 2;
        bench.runFor(100ms);
        QVERIFY(near(bench.samples(), 1500, 200));
        const std::uint64_t there = bench.samples();
        bench.runFor(1s);
        QCOMPARE(bench.samples(), there); // it is held
        bench.control.wanted.paused = false;
        bench.runFor(100ms);
        QVERIFY(near(bench.samples(), there + 100));
        bench.runFor(10s);
        QCOMPARE(bench.samples(), 3000U);
        for (capture::Tick tick = 0; const auto &block : bench.all<capture::SampleBlock>()) {
            QCOMPARE(block.firstTick, tick);
            tick += block.count;
        }
    }

    void goingBackBeginsAnewBehindWhatWasTold()
    {
        Bench bench;
        bench.runFor(2500ms);
        const std::uint64_t first = bench.samples();
        QVERIFY(near(first, 2500));
        const double until = bench.capture.timeSpan()->to;
        bench.control.goTo = bench.file.size() / 3;
        bench.runFor(60ms);
        QVERIFY(near(bench.samples(), first + 1000, 200));
        QVERIFY(bench.control.last.bytes < bench.file.size() / 2);
        bench.runFor(10s);
        QVERIFY(bench.control.last.ended);
        QCOMPARE(bench.samples(), first + 3000); // all of it, once more
        QVERIFY(bench.capture.timeSpan()->to > until + 2.9);
        QVERIFY(!bench.capture.clockMoved());
        QCOMPARE(bench.capture.refused().backwards, 0U);
        QCOMPARE(bench.all<drive::LinkChanged>().size(), std::size_t(2)); // one connection
        bench.control.goTo = 0; // also behind the end
        bench.runFor(500ms);
        QVERIFY(!bench.control.last.ended);
        QVERIFY(near(bench.samples(), first + 3500));
        bench.runFor(10s);
        QCOMPARE(bench.samples(), first + 6000);
        QVERIFY(!bench.capture.clockMoved());
    }

    void asFastAsItIsTakenItTakesNoTime()
    {
        Bench bench(recording(), {0.0, false});
        bench.runFor(10ms);
        QCOMPARE(bench.samples(), 3000U);
    }

    void whoeverIsFullIsWaitedFor()
    {
        Bench bench;
        bench.runFor(500ms);
        bench.control.isFull = true;
        const std::uint64_t held = bench.samples();
        QVERIFY(near(held, 500));
        bench.runFor(10s);
        QCOMPARE(bench.samples(), held);
        bench.control.isFull = false;
        bench.runFor(500ms); // half a second is caught up with, not ten
        QVERIFY(near(bench.samples(), 1500, 80));
        bench.runFor(3s);
        QCOMPARE(bench.capture.size(bench.capture.channels().front().id), 3000U);
    }

    void samplesAndValuesAreThoseOfTheRecordingOnTheAxisOfNow()
    {
        Bench bench;
        bench.runFor(5s);
        const auto channels = bench.capture.channels();
        QCOMPARE(channels.size(), std::size_t(1));
        QCOMPARE(channels[0].name, std::string("I_A"));
        const capture::Channel *channel = bench.capture.channel(channels[0].id);
        QCOMPARE(channel->size(), 3000U);
        for (capture::Index i = 0; i < 3000; ++i) {
            QCOMPARE(channel->at(i), 0.5 * double(i));
            QCOMPARE(channel->timeOf(i), 500 * kSecond + Nanos(i) * 1'000'000);
        }
        QVERIFY(channel->gaps(500.0, 503.0, 0.0).empty());
        const auto reads = bench.all<drive::RegistersRead>();
        QCOMPARE(reads.size(), std::size_t(3));
        QCOMPARE(reads[0].readings[0].id, kSpeed);
        QCOMPARE(std::get<double>(reads[1].readings[0].value), 1900.0);
        QVERIFY(reads[1].readings[0].at == TimePoint(502s));
    }

    void whoWasRecordedIsToldFirst()
    {
        Bench bench;
        bench.runFor(5s);
        const auto identified = bench.all<drive::Identified>().back();
        QCOMPARE(identified.identity.firmware, std::string("FW"));
        QCOMPARE(identified.catalog->nameOf(kSpeed), std::string("SPEED"));
        QCOMPARE(identified.catalog->readScale(kSpeed).unit, std::string("rpm"));
        QVERIFY(!identified.catalog->find(kSpeed)->writable());
        bool known = false;
        for (const drive::Event &event : bench.events) {
            known = known || std::holds_alternative<drive::Identified>(event);
            QVERIFY(known || !std::holds_alternative<drive::StreamStarted>(event));
        }
        const auto status = bench.all<drive::MotorStatus>().front();
        QCOMPARE(status.state, drive::MotorState::Running);
        QCOMPARE(status.stateName, std::string("RUN"));
        QCOMPARE(status.faultsNow, (std::vector<std::string>{"OVER_VOLT", "UNDER_VOLT"}));
        QVERIFY(status.at == TimePoint(501s));
        QCOMPARE(
            std::get<Happening>(bench.control.entries[0].second).name, std::string("speed ramp"));
        QCOMPARE(bench.control.entries[0].first, 501 * kSecond);
    }

    void nothingIsWrittenAndNothingMoves()
    {
        Bench bench;
        bench.runFor(1s);
        bench.drive.arm();
        QVERIFY(!bench.drive.armed());
        bench.drive.stop(bench.now);
        drive::WishId id = 0;
        const auto refuse = [&](decltype(drive::Wish::what) what) {
            bench.drive.submit({++id, std::move(what)}, bench.now);
            bench.settle();
            const auto ended = bench.all<drive::Ended>().back();
            return ended.id == id && ended.outcome == drive::Outcome::NotSent
                && !ended.reason.empty();
        };
        QVERIFY(refuse(drive::Write{{{kSpeed, std::int64_t(1)}}}));
        QVERIFY(refuse(drive::Command{drive::MotorAction::Start, 1}));
        QVERIFY(refuse(drive::SpeedRamp{1, 500, 100ms}));
        QVERIFY(refuse(drive::TorqueRamp{}));
        QVERIFY(refuse(drive::CurrentReference{}));
        QVERIFY(refuse(drive::PositionRamp{}));
        QVERIFY(refuse(drive::ExpertMode{1}));
        QVERIFY(refuse(drive::Stream{}));
        const auto identified = bench.all<drive::Identified>().back();
        QVERIFY(identified.capabilities.size() >= 8);
        for (const drive::Capability &capability : identified.capabilities)
            QVERIFY(!capability.available && !capability.reason.empty());
    }

    void readingGivesTheNewestOfTheRecording()
    {
        Bench bench;
        bench.runFor(2500ms);
        bench.drive.submit({5, drive::Read{{kSpeed, 77}}}, bench.now);
        bench.settle();
        const auto read = bench.all<drive::RegistersRead>().back();
        QCOMPARE(std::get<double>(read.readings[0].value), 1900.0);
        QCOMPARE(read.readings[1].status, drive::ReadStatus::NotSupported);
        QCOMPARE(bench.all<drive::Ended>().back().outcome, drive::Outcome::Ok);
    }

    void damageIsPassedAndCounted()
    {
        Bytes file = recording();
        for (std::size_t i = file.size() / 2; i < file.size() / 2 + 40; ++i)
            file[i] ^= 0x5A;
        Bench bench(std::move(file));
        bench.runFor(5s);
        QVERIFY(bench.samples() < 3000 && bench.samples() > 2000);
        QVERIFY(bench.all<drive::LinkCounters>().back().badPackets >= 1);
        QVERIFY(!bench.capture.channel(bench.capture.channels().front().id)
                     ->gaps(500.0, 503.0, 0.0)
                     .empty());
        QVERIFY(bench.control.last.ended);
    }

    void whatIsNoRecordingEndsAsLost()
    {
        Bench bench(Bytes(10'000, 0x55));
        bench.runFor(1s);
        const auto links = bench.all<drive::LinkChanged>();
        QCOMPARE(links.back().state, drive::LinkState::Lost);
        QCOMPARE(links.back().reason, drive::LinkReason::OnlyGarbage);
    }

    void timesThatCannotBeAreLeftOut()
    {
        Encoder encoder({0, "test", "board"});
        Bytes file = encoder.head().bytes;
        const Nanos most = std::numeric_limits<Nanos>::max();
        encoder.add(0, PolledRegister{kSpeed, "SPEED", "rpm"});
        encoder.add(0, PolledValues{{{kSpeed, most, 1.0}, {kSpeed, 5, 2.0}, {kSpeed, -most, 3.0}}});
        encoder.add(most, Happening{"far", {}});
        encoder.add(-most, Happening{"farther", {}});
        encoder.end(kSecond, {});
        for (const Block &block : encoder.takeBlocks())
            file.insert(file.end(), block.bytes.begin(), block.bytes.end());
        Bench bench(std::move(file));
        bench.runFor(3s);
        QVERIFY(bench.control.last.ended);
        const auto reads = bench.all<drive::RegistersRead>();
        QCOMPARE(reads.size(), std::size_t(1));
        QCOMPARE(reads[0].readings.size(), std::size_t(1));
        QCOMPARE(std::get<double>(reads[0].readings[0].value), 2.0);
    }

    void aDisconnectionIsTheLastWord()
    {
        for (const Duration run : {Duration(0s), Duration(1s), Duration(10s)}) {
            Bench bench;
            bench.runFor(run);
            bench.drive.disconnect(bench.now);
            bench.settle();
            QCOMPARE(bench.all<drive::LinkChanged>().back().state, drive::LinkState::Closed);
            const std::size_t events = bench.events.size();
            bench.runFor(10s);
            QCOMPARE(bench.events.size(), events);
        }
    }
};

QTEST_APPLESS_MAIN(TestReplayDrive)
#include "tst_replay_drive.moc"
