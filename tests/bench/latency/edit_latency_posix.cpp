// Measures how long it takes from Enter in the editor of a register until the bytes that write it are on the line: the
// real window and session thread, rotorscope-sim behind a pseudo-terminal at 1,843,200 baud, a datalog of four
// signals at the full control rate running beside it. Prints a table; docs/performance.md says how it is read.
#include "bench/latency/simulated_board_posix.h"
#include "bench/latency/tapped_line_posix.h"
#include "bench/latency/time_row.h"
#include "support/window_rig.h"
#include "widgets/registers/panel.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/window/connect_bar.h"

#include <QAbstractProxyModel>
#include <QAction>

#include <QApplication>
#include <QLineEdit>
#include <QTest>

#include <cstdio>
#include <random>

namespace {

using bench::Clock;

constexpr int kPatience_ms = 10'000;

template <class Condition>
bool until(Condition condition)
{
    return QTest::qWaitFor(condition, kPatience_ms);
}

int failed(const char *what)
{
    std::fprintf(stderr, "edit-latency: %s\n", what);
    return 1;
}

class Bench {
public:
    Bench(facts::WindowRig &rig, bench::TappedLine &line)
        : m_rig(rig)
        , m_line(line)
        , m_device(rig.workbench.device())
    {
    }

    bool connect()
    {
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = m_line.path();
        m_device.open(endpoint);
        if (!until([&] { return m_device.answering() && m_device.identified(); }))
            return false;
        m_id = m_device.catalog()->resolve("SPEED_KP").value_or(0);
        m_rig.window.selection()->add(
            m_device.catalog()->resolve("STOPLL_ROT_SPEED").value_or(0), 1);
        m_device.setArmed(true);
        QObject::connect(&m_rig.workbench.edits(), &widgets::RegisterEdits::told, &m_rig.window,
            [this](const QString &sentence, bool) { m_told = sentence; });
        return until([&] { return m_device.armed(); })
            && until([&] { return m_line.bytesFromBoard() > 500'000; }); // the datalog runs
    }

    /// Milliseconds; negative if it failed.
    double edit(int value)
    {
        auto &model = m_rig.workbench.registers();
        widgets::RegisterPanel &panel = *m_rig.window.findChild<widgets::RegisterPanel *>();
        const auto *proxy =
            qobject_cast<QAbstractProxyModel *>(panel.findChild<QTreeView *>()->model());
        const QModelIndex cell =
            proxy->mapFromSource(model.indexOf(m_id, widgets::RegisterModel::ValueColumn));
        panel.findChild<QTreeView *>()->expand(cell.parent());
        panel.findChild<QTreeView *>()->scrollTo(cell);
        panel.findChild<QTreeView *>()->setCurrentIndex(cell);
        QCoreApplication::processEvents();
        panel.editCurrent();
        auto *editor = panel.findChild<QLineEdit *>(QStringLiteral("registerEntry"));
        if (editor == nullptr)
            return -1.0;
        editor->selectAll();
        QTest::keyClicks(editor, QString::number(value));
        QCoreApplication::processEvents();
        const auto id = static_cast<std::uint16_t>(m_id);
        const auto number = static_cast<std::uint16_t>(value);
        m_line.expect(ByteWriter().u16(1U << 3).u16(id).u16(number).take()); // SET_REGISTER
        const Clock::time_point enter = Clock::now();
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents(); // the editor hands its text over
        if (const QString hint = m_rig.workbench.edits().applyHint(); !hint.isEmpty())
            m_told = hint;
        panel.actions().apply->trigger();
        if (!until([&] { return m_line.seen() != 0; })
            || !until([&] { return !m_rig.workbench.edits().underWay(); }))
            return -1.0;
        const std::chrono::nanoseconds seen(m_line.seen());
        return std::chrono::duration<double, std::milli>(seen - enter.time_since_epoch()).count();
    }

    const QString &told() const { return m_told; } ///< how the last write ended

private:
    facts::WindowRig &m_rig;
    bench::TappedLine &m_line;
    widgets::Device &m_device;
    QString m_told;
    catalog::RegisterId m_id = 0;
};

int measure(int count)
{
    bench::SimulatedBoard board;
    if (!board.started())
        return failed("the simulated board did not start");
    bench::TappedLine line(board.port());
    facts::WindowRig rig;
    Bench bench(rig, line);
    if (!bench.connect())
        return failed("no connection, or no datalog");
    std::mt19937 random(1);
    std::vector<double> clean, disturbed;
    widgets::Device &device = rig.workbench.device();
    const auto start = Clock::now();
    const std::uint64_t bytes = line.bytesFromBoard();
    const drive::LinkCounters before = device.counters();
    for (int i = 0; i < count; ++i) {
        const std::uint64_t timeouts = device.counters().timeouts;
        const double ms = bench.edit(5000 + i);
        // The user's pauses, no fixed phase against polling and packets, and long enough for the counters to come.
        const auto resume = Clock::now() + std::chrono::milliseconds(300 + random() % 200);
        until([&] { return Clock::now() >= resume; });
        if (ms < 0.0)
            std::fprintf(stderr, "edit %d did not arrive: %s\n", i, qPrintable(bench.told()));
        else
            (device.counters().timeouts == timeouts ? clean : disturbed).push_back(ms);
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const double rate = static_cast<double>(line.bytesFromBoard() - bytes) / seconds / 1000.0;
    bench::printTimes("nothing lost on the line:", clean);
    bench::printTimes("a packet was lost meanwhile:", disturbed);
    const drive::LinkCounters after = device.counters();
    std::printf(
        "from the board %.1f kB/s, control periods lost %llu, time-outs %llu; board and line at "
        "%s priority\n",
        rate, static_cast<unsigned long long>(after.streamLostTicks - before.streamLostTicks),
        static_cast<unsigned long long>(after.timeouts - before.timeouts),
        board.realTime() ? "real-time" : "normal");
    rig.workbench.device().close();
    until([&] { return !rig.workbench.device().portOpen(); });
    return 0;
}

} // namespace

int main(int argc, char **argv)
{
    widgets::Application app(argc, argv);
    const int count = argc > 1 ? QString::fromLocal8Bit(argv[1]).toInt() : 500;
    return count > 0 ? measure(count) : failed("usage: rotorscope-edit-latency [EDITS]");
}
