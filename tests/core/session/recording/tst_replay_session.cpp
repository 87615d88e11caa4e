// A recording through a session, as if a board were behind it: from the file to the batches, in virtual time.
#include "recorded/restore.h"
#include "session/recording/file.h"
#include "session/recording/replay.h"
#include "session/transports/recording_transport.h"
#include "support/recording_facts.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace session;
using namespace std::chrono_literals;

namespace {

constexpr capture::Tick kTicks = 64'000; ///< four seconds

/// Two fast signals and a slow one at 16 kHz; longer than one piece that is asked for.
void writeRecording(const QString &path)
{
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", "board"});
    file.open();
    file.add(0, recorded::Happening{"board", {{"firmware", "FW"}, {"version", "6.4.0"}}});
    file.add(0,
        capture::StreamLayout{1, 16000.0, 0.0, 1,
            {{9, "I_A", "A", 0.5, 0.0}, {17, "I_B", "A", 0.5, 0.0}}, {{25, "S", "rpm", 6.0, 0.0}}});
    for (capture::Tick tick = 0; tick < kTicks; tick += 160) {
        capture::SampleBlock block{
            1, tick, 160, {}, {{tick + 159, {static_cast<std::int32_t>(tick)}}}, 0};
        for (capture::Tick i = 0; i < 320; ++i)
            block.fast.push_back(static_cast<std::int16_t>(tick * 3 + i * 7));
        file.add((tick + 160) * 62'500, std::move(block));
        file.flush((tick + 160) * 62'500);
    }
    file.add(2'000'000'000, recorded::Note{2'000'000'000, 2'000'000'000, "look here"});
    file.end();
}

struct Bench {
    TimePoint now{100s};
    std::shared_ptr<Replay> replay = std::make_shared<Replay>();
    Session session;
    capture::Capture capture;
    std::vector<drive::Event> events;
    QList<PortError> errors;
    std::optional<ReplayState> state;
    std::vector<ReplayedEntry> entries;
    bool taking = true;
    std::vector<std::uint64_t> untaken;

    Bench()
        : session(replaying(
            {.clock = [this] { return now; },
                .transport = makeTransport,
                .drive = [](const Endpoint &) { return std::unique_ptr<drive::Drive>(); }},
            replay))
    {
        QObject::connect(&session, &Session::batch, [this](const BatchPtr &batch) {
            for (const drive::Event &event : batch->events) {
                if (const auto *started = std::get_if<drive::StreamStarted>(&event))
                    capture.begin(started->layout);
                if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
                    capture.append(*block);
                    if (taking)
                        replay->accept(capture::samplesOf(*block));
                }
                events.push_back(event);
            }
            session.acknowledge();
        });
        QObject::connect(&session, &Session::portChanged,
            [this](PortState, const PortError &why) { errors.append(why); });
        QObject::connect(
            replay.get(), &Replay::advanced, [this](const ReplayState &last) { state = last; });
        QObject::connect(replay.get(), &Replay::happened,
            [this](const ReplayedEntry &entry) { entries.push_back(entry); });
    }
    void open(const QString &path)
    {
        Endpoint endpoint;
        endpoint.kind = Endpoint::Kind::Trace;
        endpoint.path = path;
        session.open(endpoint);
    }
    void runFor(Duration time)
    {
        const TimePoint until = now + time;
        while (const auto next = session.nextStep()) {
            if (*next > until)
                break;
            now = std::max(*next, now + 1ms);
            session.step(now);
        }
        now = std::max(now, until);
        session.step(now);
    }
    std::uint64_t size() const
    {
        const auto found = capture.find(9);
        return found ? capture.size(*found) : 0;
    }
};

} // namespace

class TestReplaySession : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { writeRecording(m_path); }

    void whatIsReplayedIsWhatWasRecorded()
    {
        Bench bench;
        bench.open(m_path);
        bench.runFor(2s);
        QVERIFY(bench.size() > 25'000 && bench.size() <= 32'000);
        bench.runFor(4s);
        QVERIFY(bench.state && bench.state->ended);
        QCOMPARE(bench.state->fraction, 1.0);
        const auto file = support::readRecording(m_path);
        const auto replayed = bench.capture.channels(), recorded = file.capture.channels();
        QCOMPARE(replayed.size(), recorded.size());
        for (std::size_t c = 0; c < recorded.size(); ++c) {
            const capture::Channel *one = bench.capture.channel(replayed[c].id);
            const capture::Channel *other = file.capture.channel(recorded[c].id);
            QCOMPARE(one->size(), other->size());
            const capture::Nanos shift = one->timeOf(0) - other->timeOf(0);
            for (capture::Index i = 0; i < one->end(); ++i) {
                QCOMPARE(one->at(i), other->at(i));
                QCOMPARE(one->timeOf(i) - shift, other->timeOf(i));
            }
        }
        const auto &refused = bench.capture.refused();
        QCOMPARE(refused.backwards + refused.malformed + refused.otherStream, 0U);
        const auto note = std::find_if(bench.entries.begin(), bench.entries.end(),
            [](const auto &entry) { return std::holds_alternative<recorded::Note>(entry.entry); });
        QVERIFY(note != bench.entries.end());
    }

    void aReceiverThatTakesNothingIsWaitedFor()
    {
        Bench bench;
        bench.replay->setSpeed(0.0);
        bench.taking = false;
        bench.open(m_path);
        bench.runFor(10s);
        const std::uint64_t waiting = bench.size();
        QVERIFY2(waiting > 0 && waiting < 40'000, qPrintable(QString::number(waiting)));
        QVERIFY(!bench.state->ended);
        bench.replay->accept(10'000'000);
        bench.runFor(1s);
        QCOMPARE(bench.size(), std::uint64_t(kTicks));
    }

    void itClosesAtOnceAndCanBeOpenedAgain()
    {
        Bench bench;
        bench.open(m_path);
        bench.runFor(1s);
        bench.session.close();
        bench.runFor(1ms);
        QVERIFY(bench.session.closed());
        bench.open(m_path);
        bench.runFor(6s);
        QVERIFY(bench.size() > std::uint64_t(kTicks)); // behind what was replayed before
        QCOMPARE(bench.capture.refused().backwards, 0U);
    }

    void aFileThatIsNotThereIsAnError()
    {
        Bench bench;
        bench.open(m_folder.filePath(QStringLiteral("none.pcapng")));
        QCOMPARE(bench.errors.size(), 1);
        QCOMPARE(bench.errors[0].problem, PortProblem::NotFound);
    }

    void thePartsOfTheProgramsReplayWithoutAnybodyWatching()
    {
        Endpoint endpoint;
        endpoint.kind = Endpoint::Kind::Trace;
        endpoint.path = m_path;
        QVERIFY(isReplay(endpoint));
        const Parts parts = realParts();
        QVERIFY(dynamic_cast<recorded::ReplayDrive *>(parts.drive(endpoint).get()));
        QVERIFY(qobject_cast<RecordingTransport *>(parts.transport(endpoint).get()));
        endpoint.kind = Endpoint::Kind::Serial;
        QVERIFY(!isReplay(endpoint));
        QVERIFY(!dynamic_cast<recorded::ReplayDrive *>(parts.drive(endpoint).get()));
    }

private:
    QTemporaryDir m_folder;
    QString m_path = m_folder.filePath(QStringLiteral("a.pcapng"));
};

QTEST_GUILESS_MAIN(TestReplaySession)
#include "tst_replay_session.moc"
