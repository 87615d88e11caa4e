// A recording of a session that runs: everything the drive tells is in the file, and whatever the disk does, the
// session goes on.
#include "core/session/fakes.h"
#include "session/recording/recording.h"
#include "support/recording_facts.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <numeric>

using namespace session;
using namespace std::chrono_literals;

class TestRecordingLive : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everythingThatIsToldIsInTheFile();
    void theMotionLogIsInTheFile();
    void aRecordingThatBeginsLateKnowsWhatHolds();
    void theBytesOfTheLineAreThereIfAskedFor();
    void whatFollowsFromBytesIsNotBeforeThem();
    void aSlowDiskStallsNobodyAndItsLossIsTold();
    void whatASlowDiskMissedIsDescribedAgain();
    void whatIsToldWhileARecordingEndsIsTakenAll();
    void aFullDiskEndsTheRecordingAndNotTheSession();
    void aFileThatIsThereAlreadyIsAnError();
    void leavingWithoutAStopEndsTheFile();
    void aSecondRecordingIsAWholeOne();
    void eachRecordingIsDatedWhenItBegins();
    void aNoteIsTakenUntilTheEndIsAskedFor();
};

namespace {

capture::StreamLayout twoCurrents()
{
    return {1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}, {2, "B", "A", 0.1, 0.0}}, {}};
}

capture::SampleBlock hundredTicks(capture::Tick tick)
{
    return {1, tick, 100, std::vector<std::int16_t>(200, std::int16_t(tick)), {}, 0};
}

/// A session with fakes behind it, a tap, and a recording.
struct LiveBench {
    TimePoint now{100s};
    fakes::FakeTransport::Log port;
    fakes::FakeDrive::Log board;
    std::shared_ptr<RecordingTap> tap;
    Session session;
    Recording recording;
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("r.pcapng"));
    QList<RecordingResult> results;
    int starts = 0;
    std::size_t batches = 0;

    explicit LiveBench(MakeSink sink = makeDiskSink, std::size_t bound = std::size_t{64} << 20)
        : tap(std::make_shared<RecordingTap>(bound))
        , session(tapped({.clock = [this] { return now; },
                             .transport =
                                 [this](const Endpoint &) {
                                     return std::make_unique<fakes::FakeTransport>(port);
                                 },
                             .drive =
                                 [this](const Endpoint &) {
                                     return std::make_unique<fakes::FakeDrive>(board);
                                 }},
              tap))
        , recording(tap, {0, 0}, std::move(sink))
    {
        QObject::connect(&session, &Session::batch, [this](const BatchPtr &) {
            ++batches;
            session.acknowledge();
        });
        QObject::connect(&recording, &Recording::started, [this] { ++starts; });
        QObject::connect(&recording, &Recording::finished,
            [this](const RecordingResult &result) { results.append(result); });
        session.open({});
    }
    void start(RecordingTap::Content content = RecordingTap::Content::Samples)
    {
        const int before = starts;
        recording.start(path, content, QStringLiteral("test"), QStringLiteral("fake"));
        QTRY_COMPARE(starts, before + 1);
    }
    void stop()
    {
        recording.stop();
        QTRY_VERIFY(!recording.running());
    }
    void tell(drive::Event event)
    {
        board.alive->events.push_back(std::move(event));
        now += 20ms;
        session.step(now);
    }
};

/// A sink whose disk is slow until it is let go, or takes so many blocks.
struct Gate {
    QSemaphore open;
    std::atomic<int> blocks = 1'000'000;
};
class GatedSink : public BlockSink {
public:
    GatedSink(Gate &gate, std::unique_ptr<BlockSink> inner)
        : m_gate(gate)
        , m_inner(std::move(inner))
    {
    }
    bool append(ByteView bytes) override
    {
        m_gate.open.acquire();
        m_gate.open.release();
        return m_gate.blocks-- > 0 && m_inner->append(bytes);
    }
    bool overwrite(std::size_t offset, ByteView bytes) override
    {
        return m_inner->overwrite(offset, bytes);
    }
    bool sync() override { return m_inner->sync(); }
    qint64 freeBytes() const override { return 1'000'000'000; }
    bool isFull() const override { return true; }
    QString systemText() const override { return QStringLiteral("no room"); }

private:
    Gate &m_gate;
    std::unique_ptr<BlockSink> m_inner;
};

MakeSink gated(Gate &gate)
{
    return [&gate](const QString &path, QString &text) -> std::unique_ptr<BlockSink> {
        return std::make_unique<GatedSink>(gate, makeDiskSink(path, text));
    };
}

} // namespace

void TestRecordingLive::everythingThatIsToldIsInTheFile()
{
    LiveBench bench;
    bench.start();
    bench.tell(drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None});
    bench.tell(drive::StreamStarted{twoCurrents()});
    for (capture::Tick tick = 0; tick < 1000; tick += 100)
        bench.tell(hundredTicks(tick));
    drive::MotorStatus status;
    status.stateName = "RUN";
    status.state = drive::MotorState::Running;
    bench.tell(status);
    bench.tell(status); // no news
    bench.session.submit({7, drive::SpeedRamp{1, 1500, 500ms}});
    bench.tell(drive::Ended{7, drive::Outcome::Ok, {}, {}});
    bench.session.stop();
    bench.recording.add(5, recorded::Note{1, 2, "look here"});
    bench.stop();
    QCOMPARE(bench.results.size(), 1);
    QCOMPARE(bench.results[0].outcome, RecordingOutcome::Stopped);

    const auto facts = support::readRecording(bench.path);
    QVERIFY(facts.damage.empty());
    QCOMPARE(facts.ending->reason, recorded::End::Reason::Stopped);
    QCOMPARE(facts.samples(), 2000U);
    QCOMPARE(facts.capture.size(*facts.capture.find(2)), 1000U);
    const std::vector<std::string> names{"link", "motor state", "speed ramp", "ended", "stop"};
    QCOMPARE(facts.happenings(), names);
    QCOMPARE(facts.all<recorded::Note>().size(), std::size_t(1));
    QVERIFY(facts.all<recorded::LinkBytes>().empty());
    QCOMPARE(bench.results[0].last.counts.samples, 2000U);
    QCOMPARE(qint64(bench.results[0].last.counts.bytes), QFileInfo(bench.path).size());
    QCOMPARE(bench.tap->waiting(), std::size_t(0));
}

/// The session's clock and the system's part: here the first goes on for an hour while the second does not.
void TestRecordingLive::eachRecordingIsDatedWhenItBegins()
{
    LiveBench bench;
    bench.now += 1h;
    const std::int64_t earliest = QDateTime::currentSecsSinceEpoch() - 3700;
    bench.start();
    const std::int64_t latest = QDateTime::currentSecsSinceEpoch() - 3700;
    bench.stop();
    const auto begins = support::readRecording(bench.path).all<recorded::Begin>();
    QCOMPARE(begins.size(), 1U);
    QVERIFY(begins[0].startSeconds >= earliest && begins[0].startSeconds <= latest);
}

void TestRecordingLive::aNoteIsTakenUntilTheEndIsAskedFor()
{
    const recorded::Note note{1, 2, "look here"};
    LiveBench bench;
    QVERIFY(!bench.recording.add(1, note));
    for (int round = 0; round < 2; ++round) {
        bench.path = bench.folder.filePath(QStringLiteral("%1.pcapng").arg(round));
        bench.start();
        QVERIFY(bench.recording.add(2, note));
        bench.recording.stop();
        QVERIFY(bench.recording.running()); // still, and yet its file takes no more
        QVERIFY(!bench.recording.add(3, note));
        QTRY_VERIFY(!bench.recording.running());
        QCOMPARE(support::readRecording(bench.path).all<recorded::Note>().size(), std::size_t(1));
    }
}

void TestRecordingLive::theMotionLogIsInTheFile()
{
    using drive::MotorAction;
    LiveBench bench;
    bench.start();
    for (const MotorAction action : {MotorAction::Start, MotorAction::StopMotor,
             MotorAction::StopRamp, MotorAction::AcknowledgeFaults})
        bench.session.submit({1, drive::Command{action, 2}});
    bench.tell(drive::MotionEntry{drive::MotionAct::SpeedRamp, 2, drive::Source::CommandLine,
        TimePoint(3500ms), TimePoint(3512ms), "500 rpm in 1000 ms", drive::Outcome::Refused,
        "motor is not running", std::nullopt, 1, {Bytes{0x31, 0xAB}}});
    drive::MotionEntry stop;
    stop.act = drive::MotionAct::Stop;
    stop.stop = drive::StopWord::NotConfirmed;
    bench.tell(stop);
    bench.stop();
    const auto happenings = support::readRecording(bench.path).all<recorded::Happening>();
    QCOMPARE(happenings.size(), std::size_t(6));
    const char *actions[] = {"start", "stop motor", "stop ramp", "acknowledge faults"};
    for (std::size_t i = 0; i < 4; ++i)
        QCOMPARE(
            happenings[i].fields[1], std::pair(std::string("action"), std::string(actions[i])));
    const recorded::Happening ramp{"motion",
        {{"act", "SPEED_RAMP"}, {"source", "command line"}, {"asked s", "3.5"}, {"took ms", "12"},
            {"outcome", "refused"}, {"requests", "1"}, {"motor", "2"},
            {"detail", "500 rpm in 1000 ms"}, {"reason", "motor is not running"},
            {"bytes", "31ab"}}};
    QVERIFY(happenings[4] == ramp);
    QCOMPARE(
        happenings[5].fields[4], std::pair(std::string("outcome"), std::string("NOT confirmed")));
}

void TestRecordingLive::aRecordingThatBeginsLateKnowsWhatHolds()
{
    LiveBench bench;
    bench.tell(drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None});
    bench.tell(drive::StreamStarted{twoCurrents()});
    bench.tell(hundredTicks(0));
    bench.start();
    bench.tell(hundredTicks(100));
    bench.tell(hundredTicks(200));
    bench.stop();
    const auto facts = support::readRecording(bench.path);
    QCOMPARE(facts.happenings(), std::vector<std::string>{"link"});
    QCOMPARE(facts.all<capture::StreamLayout>().size(), std::size_t(1));
    QCOMPARE(facts.capture.size(*facts.capture.find(1)), 200U);
}

void TestRecordingLive::theBytesOfTheLineAreThereIfAskedFor()
{
    LiveBench bench;
    bench.start(RecordingTap::Content::SamplesAndLink);
    bench.port.alive->hear("abc");
    bench.port.alive->hear("def");
    bench.board.alive->outputs.push_back({Bytes{1, 2}, {}});
    bench.now += 1ms;
    bench.session.step(bench.now);
    bench.stop();
    const auto facts = support::readRecording(bench.path);
    const auto link = facts.all<recorded::LinkBytes>();
    QCOMPARE(link.size(), std::size_t(2));
    QCOMPARE(link[0].direction, recorded::LinkBytes::Direction::Received);
    QCOMPARE(
        QByteArray(reinterpret_cast<const char *>(link[0].bytes.data()), 6), QByteArray("abcdef"));
    QCOMPARE(link[1].direction, recorded::LinkBytes::Direction::Sent);
    QCOMPARE(bench.board.received.size(), std::size_t(6)); // and the drive heard them all the same
}

/// On a line that answers within write(), as SPI does.
void TestRecordingLive::whatFollowsFromBytesIsNotBeforeThem()
{
    LiveBench bench;
    bench.start(RecordingTap::Content::SamplesAndLink);
    bench.board.alive->outputs.push_back({Bytes{1}, {}});
    bench.port.onWrite = [&] {
        bench.now += 3ms;
        bench.port.alive->hear("x");
        bench.board.alive->events.push_back(
            drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None});
    };
    bench.session.step(bench.now);
    bench.stop();
    using recorded::LinkBytes;
    std::optional<recorded::Nanos> heard, followed;
    const auto facts = support::readRecording(bench.path);
    for (const recorded::Item &item : facts.items) {
        const auto *bytes = std::get_if<LinkBytes>(&item.entry);
        if (bytes != nullptr && bytes->direction == LinkBytes::Direction::Received)
            heard = item.at;
        if (const auto *what = std::get_if<recorded::Happening>(&item.entry);
            what != nullptr && what->name == "link")
            followed = item.at;
    }
    QVERIFY(heard && followed);
    QVERIFY(*heard <= *followed);
}

void TestRecordingLive::aSlowDiskStallsNobodyAndItsLossIsTold()
{
    Gate gate;
    gate.open.release();
    LiveBench bench(gated(gate), 200'000);
    bench.start();
    bench.tell(drive::StreamStarted{twoCurrents()});
    gate.open.acquire(); // from now on each write takes for ever
    const std::size_t before = bench.batches;
    for (capture::Tick tick = 0; tick < 100'000; tick += 100)
        bench.tell(hundredTicks(tick)); // comes back at once each time
    QCOMPARE(bench.batches, before + 1000);
    QVERIFY(bench.tap->waiting() <= 200'000);
    gate.open.release();
    QTRY_COMPARE(bench.tap->waiting(), std::size_t(0));
    bench.tell(hundredTicks(100'000));
    bench.stop();
    const RecordingProgress &last = bench.results[0].last;
    QVERIFY(last.lost.samples > 0);
    const auto facts = support::readRecording(bench.path);
    QVERIFY(facts.damage.empty());
    QCOMPARE(facts.samples() + last.lost.samples, 1001U * 200U);
    // More than one stretch where the writer was late with its first piece: there was room again behind it.
    const auto lost = facts.all<recorded::Lost>();
    QCOMPARE(std::accumulate(lost.begin(), lost.end(), std::uint64_t(0),
                 [](std::uint64_t sum, const recorded::Lost &one) { return sum + one.samples; }),
        last.lost.samples);
    const auto blocks = facts.all<capture::SampleBlock>();
    QCOMPARE(blocks.back().firstTick, capture::Tick(100'000));
    QCOMPARE(blocks.back().lostTicks, capture::Tick(lost.back().samples / 2));
}

void TestRecordingLive::whatASlowDiskMissedIsDescribedAgain()
{
    Gate gate;
    gate.open.release();
    LiveBench bench(gated(gate), 200'000);
    bench.start();
    bench.tell(drive::StreamStarted{twoCurrents()});
    gate.open.acquire();
    capture::Tick tick = 0;
    for (; tick < 100'000; tick += 100)
        bench.tell(hundredTicks(tick));
    capture::StreamLayout other = twoCurrents();
    other.id = 2;
    other.fast = {{7, "C", "V", 0.5, 0.0}};
    for (int i = 0; i < 5; ++i) // the first may find room, the last does not
        bench.tell(drive::StreamStarted{i < 4 ? twoCurrents() : other});
    const auto one = [](capture::Tick at) {
        return capture::SampleBlock{2, at, 100, std::vector<std::int16_t>(100, 5), {}, 0};
    };
    bench.tell(one(0));
    gate.open.release();
    QTRY_COMPARE(bench.tap->waiting(), std::size_t(0));
    bench.tell(one(100));
    bench.stop();

    const auto facts = support::readRecording(bench.path);
    QVERIFY(facts.damage.empty());
    const auto channels = facts.capture.channels();
    const auto named = std::find_if(channels.begin(), channels.end(),
        [](const capture::ChannelInfo &channel) { return channel.name == "C"; });
    QVERIFY(named != channels.end());
    QCOMPARE(facts.capture.size(named->id), capture::Index(100));
    QCOMPARE(facts.all<recorded::Lost>().empty(), false);
}

void TestRecordingLive::whatIsToldWhileARecordingEndsIsTakenAll()
{
    const QTemporaryDir folder;
    const auto tap = std::make_shared<RecordingTap>();
    // Connected before the recorder is, it ends the recording between the session's look whether one runs and its word.
    std::unique_ptr<Recording> recording;
    connect(
        tap.get(), &RecordingTap::told, tap.get(),
        [&recording] {
            recording->stop();
            QTRY_VERIFY(!recording->running());
        },
        Qt::DirectConnection);
    recording = std::make_unique<Recording>(tap, RecordingLimits{0, 0}, makeDiskSink);
    bool started = false;
    connect(recording.get(), &Recording::started, recording.get(), [&started] { started = true; });
    recording->start(folder.filePath(QStringLiteral("r.pcapng")), RecordingTap::Content::Samples,
        QStringLiteral("test"), QStringLiteral("fake"));
    QTRY_VERIFY(started);
    tap->onEvent(drive::StreamStarted{twoCurrents()}, TimePoint(1s));
    QVERIFY(!recording->running());
    QTRY_COMPARE(tap->waiting(), std::size_t(0));
}

void TestRecordingLive::aFullDiskEndsTheRecordingAndNotTheSession()
{
    Gate gate;
    gate.open.release();
    gate.blocks = 3; // the head, the layout and one of samples
    LiveBench bench(gated(gate));
    bench.start();
    bench.tell(drive::StreamStarted{twoCurrents()});
    for (capture::Tick tick = 0; bench.results.isEmpty() && tick < 10'000'000; tick += 100) {
        bench.tell(hundredTicks(tick));
        QCoreApplication::processEvents();
    }
    QTRY_COMPARE(bench.results.size(), 1);
    QCOMPARE(bench.results[0].outcome, RecordingOutcome::DiskFull);
    QCOMPARE(bench.results[0].systemText, QStringLiteral("no room"));
    QVERIFY(!bench.recording.running());
    const std::size_t before = bench.batches;
    bench.tell(hundredTicks(20'000'000));
    QCOMPARE(bench.batches, before + 1);
    QVERIFY(!bench.session.closed());
    QTRY_COMPARE(bench.tap->waiting(), std::size_t(0));
    const auto facts = support::readRecording(bench.path);
    QCOMPARE(facts.ending->reason, recorded::End::Reason::DiskFull);
    QCOMPARE(facts.samples(), bench.results[0].last.counts.samples);
}

void TestRecordingLive::aFileThatIsThereAlreadyIsAnError()
{
    LiveBench bench;
    QFile old(bench.path);
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    bench.recording.start(bench.path, RecordingTap::Content::Samples, {}, {});
    QTRY_COMPARE(bench.results.size(), 1);
    QCOMPARE(bench.results[0].outcome, RecordingOutcome::CannotOpen);
    QVERIFY(!bench.results[0].systemText.isEmpty());
    QCOMPARE(bench.starts, 0);
    QCOMPARE(QFileInfo(bench.path).size(), 3);
}

void TestRecordingLive::leavingWithoutAStopEndsTheFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("r.pcapng"));
    {
        LiveBench bench;
        bench.path = path;
        bench.start();
        bench.tell(drive::StreamStarted{twoCurrents()});
        bench.tell(hundredTicks(0));
    }
    const auto facts = support::readRecording(path);
    QCOMPARE(facts.samples(), 200U);
    QVERIFY(facts.ending.has_value());
}

void TestRecordingLive::aSecondRecordingIsAWholeOne()
{
    LiveBench bench;
    bench.start();
    bench.tell(drive::StreamStarted{twoCurrents()});
    bench.tell(hundredTicks(0));
    bench.stop();
    bench.tell(hundredTicks(100)); // not recorded
    bench.path = bench.folder.filePath(QStringLiteral("second.pcapng"));
    bench.start();
    bench.tell(hundredTicks(200));
    bench.stop();
    const auto facts = support::readRecording(bench.path);
    QCOMPARE(facts.samples(), 200U);
    QCOMPARE(facts.all<capture::SampleBlock>().at(0).firstTick, capture::Tick(200));
    QVERIFY(facts.damage.empty());
}

QTEST_GUILESS_MAIN(TestRecordingLive)
#include "tst_recording_live.moc"
