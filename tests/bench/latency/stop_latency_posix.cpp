// Measures how long it takes from the key event of Esc until the STOP is on the line: the real window and session
// thread, rotorscope-sim behind a pseudo-terminal at 1,843,200 baud, a datalog of four signals at the full control rate
// drawn beside it. In every fourth case the motor is starting; in every tenth the window is frozen for two seconds, and
// the key is pressed at a random instant of them. Prints a table; docs/performance.md says how it is read.
#include "aspep/packet.h"
#include "bench/latency/simulated_board_posix.h"
#include "bench/latency/tapped_line_posix.h"
#include "bench/latency/time_row.h"
#include "mcp/protocol.h"
#include "support/window_rig.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/window/application.h"

#include <QCheckBox>
#include <QTest>

#include <random>

namespace {

using bench::Clock;
using Millis = std::chrono::duration<double, std::milli>;

constexpr int kPatience_ms = 10'000;
constexpr int kFreeze_ms = 2000;
constexpr int kFreezeEvery = 10, kStartEvery = 4, kStartTries = 5;

template <class Condition>
bool until(Condition condition)
{
    return QTest::qWaitFor(condition, kPatience_ms);
}

int failed(const char *what)
{
    std::fprintf(stderr, "stop-latency: %s\n", what);
    return 1;
}

/// The packet that stops motor 1, header and payload as they follow each other on the line.
Bytes stopPacket()
{
    const auto header = aspep::encodeHeader(aspep::Data{false, 2});
    Bytes packet(header.begin(), header.end());
    const Bytes word =
        ByteWriter().u16(static_cast<unsigned>(mcp::CommandId::StopMotor) << 3 | 1U).take();
    packet.insert(packet.end(), word.begin(), word.end());
    return packet;
}

/// From the key to the line. Of a frozen window also from the end of the freeze: the key waits until then.
struct Times {
    std::vector<double> idle, starting, frozen, thawed;
};

class Bench {
public:
    Bench(facts::WindowRig &rig, bench::TappedLine &line, unsigned seed)
        : m_rig(rig)
        , m_line(line)
        , m_device(rig.workbench.device())
        , m_stop(stopPacket())
        , m_random(seed)
    {
        QObject::connect(&m_device, &widgets::Device::stopAdvanced, &rig.window,
            [this](const drive::StopProgress &progress) {
                m_rest = m_rest || progress.word == drive::StopWord::DriveIdle;
            });
        QObject::connect(
            &m_device, &widgets::Device::wishEnded, &rig.window, [this](const drive::Ended &ended) {
                if (ended.outcome != drive::Outcome::Ok)
                    m_why = ended.reason;
            });
    }

    bool connect()
    {
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = m_line.path();
        m_device.open(endpoint);
        if (!until([&] { return m_device.answering() && m_device.identified(); }))
            return false;
        m_rig.sayYesToMotion();
        m_rig.window.selection()->add(
            m_device.catalog()->resolve("STOPLL_ROT_SPEED").value_or(0), 1);
        return until([&] { return m_line.bytesFromBoard() > 500'000; }); // the datalog runs
    }

    /// Why the last wish failed, armed or not, connected or not.
    std::string state() const
    {
        return "last refusal: " + m_why + (m_device.armed() ? ", armed" : ", not armed")
            + (m_device.answering() ? ", connected, state " : ", not connected, state ")
            + m_device.status(1).stateName;
    }

    /// What went wrong; empty if a STOP came and the motor was seen idle after it.
    const char *stop(int number, Times &times)
    {
        const bool freeze = number % kFreezeEvery == 0;
        const bool start = number % kStartEvery == 1 || freeze;
        if (start && !startMotor())
            return "the motor did not start";
        pass(20.0 + double(m_random() % 60)); // no fixed phase against polling and packets
        m_rest = false;
        m_line.expect(m_stop);
        const Clock::time_point frozen = Clock::now();
        Clock::time_point key = frozen;
        if (freeze) {
            key += std::chrono::milliseconds(m_random() % kFreeze_ms);
            ::poll(nullptr, 0, kFreeze_ms); // the window thread does nothing else
        }
        const Clock::time_point thawed = Clock::now();
        QTest::keyClick(&m_rig.window, Qt::Key_Escape);
        if (!until([&] { return m_line.seen() != 0; }))
            return "no STOP came";
        if (!until([&] { return m_rest; }))
            return "the drive was not seen idle";
        const std::chrono::nanoseconds seen(m_line.seen());
        const auto since = [&](Clock::time_point when) {
            return Millis(seen - when.time_since_epoch()).count();
        };
        (freeze ? times.frozen : start ? times.starting : times.idle).push_back(since(key));
        if (freeze)
            times.thawed.push_back(since(thawed));
        return "";
    }

private:
    /// A line that was given up for a moment disarms, and an answer may be lost: then it is tried again.
    bool startMotor()
    {
        const auto turns = [this] {
            const auto state = m_device.status(1).state;
            return state == drive::MotorState::Starting || state == drive::MotorState::Running;
        };
        for (int i = 0; i < kStartTries; ++i) {
            if (!until([&] { return m_device.answering() && m_device.identified(); }))
                continue;
            // By an input of its own: what follows from the key of a frozen window is as late as that.
            if (auto *arm = m_rig.find<QCheckBox>("arm"); !arm->isChecked())
                QTest::mouseClick(arm, Qt::LeftButton, {}, QPoint(8, arm->height() / 2));
            if (!QTest::qWaitFor([&] { return m_device.armed(); }, 1000))
                continue;
            m_device.submit(drive::Command{drive::MotorAction::Start, 1});
            if (QTest::qWaitFor(turns, 1000))
                return true;
        }
        return false;
    }

    void pass(double milliseconds)
    {
        const auto end = Clock::now() + Millis(milliseconds);
        until([&] { return Clock::now() >= end; });
    }

    facts::WindowRig &m_rig;
    bench::TappedLine &m_line;
    widgets::Device &m_device;
    Bytes m_stop;
    std::mt19937 m_random;
    bool m_rest = false;
    std::string m_why;
};

int measure(int count, unsigned seed)
{
    bench::SimulatedBoard board;
    if (!board.started())
        return failed("the simulated board did not start");
    bench::TappedLine line(board.port());
    facts::WindowRig rig;
    Bench bench(rig, line, seed);
    if (!bench.connect())
        return failed("no connection, or no datalog");
    Times times;
    int lost = 0;
    const auto begun = Clock::now();
    const std::uint64_t bytes = line.bytesFromBoard();
    for (int number = 1; number <= count; ++number) {
        if (const char *wrong = bench.stop(number, times); *wrong != 0) {
            std::fprintf(stderr, "stop %d: %s; %s\n", number, wrong, bench.state().c_str());
            ++lost;
        }
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - begun).count();
    bench::printTimes("motor at rest:", times.idle);
    bench::printTimes("motor starting:", times.starting);
    bench::printTimes("window frozen 2 s, from the key:", times.frozen);
    bench::printTimes("the same, from the thaw:", times.thawed);
    std::printf(
        "%d of %d stops not seen or not confirmed; from the board %.1f kB/s; board and line "
        "at %s priority\n",
        lost, count, static_cast<double>(line.bytesFromBoard() - bytes) / seconds / 1000.0,
        board.realTime() ? "real-time" : "normal");
    rig.workbench.device().close();
    until([&] { return !rig.workbench.device().portOpen(); });
    return lost == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv)
{
    widgets::Application app(argc, argv); // which hears Esc
    const int count = argc > 1 ? QString::fromLocal8Bit(argv[1]).toInt() : 10'000;
    const unsigned seed = argc > 2 ? QString::fromLocal8Bit(argv[2]).toUInt() : 1;
    return count > 0 ? measure(count, seed)
                     : failed("usage: rotorscope-stop-latency [STOPS [SEED]]");
}
