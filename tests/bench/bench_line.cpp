// N13: bytes of the line, read once a millisecond, to samples in the capture, with what the session does for them:
// drive, batcher, capture. A board on virtual time has made the bytes; the clock runs while a drive is told the same
// again.
#include "bench/paired.h"
#include "capture/capture.h"
#include "session/link/batcher.h"
#include "support/link_pair.h"

namespace {

using namespace bench;
using namespace std::chrono_literals;

constexpr Duration kRead = 1ms;
constexpr Duration kStreamed = 20s;

/// What a drive was told, in order.
struct Call {
    enum class What : std::uint8_t { Connect, Receive, Timeout, Sent, Submit } what;
    TimePoint at;
    Bytes bytes;
    drive::Wish wish;

    void tell(drive::Drive &drive) const
    {
        switch (what) {
        case What::Connect:
            return drive.connect(at);
        case What::Receive:
            return drive.receive(bytes, at);
        case What::Timeout:
            return drive.handleTimeout(at);
        case What::Sent:
            return drive.handleSent(at);
        case What::Submit:
            return drive.submit(wish, at);
        }
    }
};

/// Keeps what it is told, and hands bytes on in reads of a millisecond.
class Told : public drive::Drive {
public:
    Told(std::unique_ptr<drive::Drive> drive, std::vector<Call> &calls)
        : m_drive(std::move(drive))
        , m_calls(calls)
    {
    }
    void connect(TimePoint now) override { tell({Call::What::Connect, now, {}, {}}); }
    void disconnect(TimePoint now) override { m_drive->disconnect(now); }
    void receive(ByteView bytes, TimePoint now) override
    {
        if (m_read.empty())
            m_readAt = now + kRead;
        m_read.insert(m_read.end(), bytes.begin(), bytes.end());
    }
    void handleTimeout(TimePoint now) override
    {
        if (!m_read.empty() && m_readAt <= now)
            tell({Call::What::Receive, now, std::exchange(m_read, {}), {}});
        if (const auto due = m_drive->nextTimeout(); due && *due <= now)
            tell({Call::What::Timeout, now, {}, {}});
    }
    void handleSent(TimePoint now) override { tell({Call::What::Sent, now, {}, {}}); }
    std::vector<Output> takeOutput() override { return m_drive->takeOutput(); }
    std::vector<drive::Event> takeEvents() override { return m_drive->takeEvents(); }
    std::optional<TimePoint> nextTimeout() const override
    {
        const auto due = m_drive->nextTimeout();
        return m_read.empty() ? due : std::min(due.value_or(m_readAt), m_readAt);
    }
    void submit(drive::Wish wish, TimePoint now) override
    {
        tell({Call::What::Submit, now, {}, std::move(wish)});
    }
    void stop(TimePoint now) override { m_drive->stop(now); }
    bool stopOpen() const override { return m_drive->stopOpen(); }
    void arm() override { m_drive->arm(); }
    void disarm() override { m_drive->disarm(); }
    bool armed() const override { return m_drive->armed(); }
    void remember(const drive::LineMemory &memory) override { m_drive->remember(memory); }
    drive::LineMemory memory() const override { return m_drive->memory(); }

private:
    void tell(Call call)
    {
        call.tell(*m_drive);
        m_calls.push_back(std::move(call));
    }

    std::unique_ptr<drive::Drive> m_drive;
    std::vector<Call> &m_calls;
    Bytes m_read;
    TimePoint m_readAt{};
};

/// A board that streams, and all that the drive was told of it.
struct Line {
    std::vector<Call> calls;
    std::size_t streaming = 0; ///< the first of them to be timed
    std::uint64_t samples = 0;

    Line()
    {
        support::LinkPair pair;
        pair.replaceDrive(std::make_unique<Told>(drive::makeMcpDrive({}), calls));
        pair.connect();
        require(pair.runUntilIdentified(), "the simulated board did not connect");
        pair.submit(drive::Stream{
            {pair.id("I_A"), pair.id("I_B"), pair.id("I_Q_MEAS"), pair.id("STOPLL_ROT_SPEED")}, 1,
            {}, 1});
        pair.onEvent = [this](const drive::Event &event) {
            if (const auto *block = std::get_if<capture::SampleBlock>(&event))
                samples += block->fast.size();
        };
        pair.runFor(500ms);
        streaming = calls.size();
        samples = 0;
        pair.runFor(kStreamed);
        require(double(samples) > 0.95 * 4 * 16000.0 * toSeconds(kStreamed),
            "the simulated board did not log");
    }
};

void lineToSamples(benchmark::State &state)
{
    const Line line;
    std::vector<double> each;
    for ([[maybe_unused]] auto _ : state) {
        const auto drive = drive::makeMcpDrive({});
        session::Batcher batcher;
        capture::Capture capture;
        std::uint64_t samples = 0;
        const auto take = [&](TimePoint now) {
            (void)drive->takeOutput();
            for (drive::Event &event : drive->takeEvents())
                batcher.add(std::move(event));
            const session::BatchPtr batch = batcher.take(now);
            if (!batch)
                return;
            for (const drive::Event &event : batch->events) {
                if (const auto *started = std::get_if<drive::StreamStarted>(&event))
                    capture.begin(started->layout);
                if (const auto *block = std::get_if<capture::SampleBlock>(&event)) {
                    capture.append(*block);
                    samples += block->fast.size();
                }
            }
            batcher.acknowledge();
        };
        const auto tell = [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                line.calls[i].tell(*drive);
                take(line.calls[i].at);
            }
        };
        tell(0, line.streaming);
        const std::uint64_t before = samples;
        const double start = cpuSeconds();
        tell(line.streaming, line.calls.size());
        const double used = cpuSeconds() - start;
        const auto came = double(samples - before);
        require(came > 0.99 * double(line.samples) && capture.refused().backwards == 0,
            "the drive that is told the same gives other samples");
        each.push_back(used * 1e9 / came);
        state.SetIterationTime(used);
    }
    report({"N13 line", "4 signals at 16 kHz from reads of a millisecond into the capture",
        Measured(each), "the clock"});
}

} // namespace

BENCHMARK(lineToSamples)->Iterations(7)->UseManualTime();
