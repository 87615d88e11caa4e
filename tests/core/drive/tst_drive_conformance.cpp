// What every drive does, whatever it speaks: the same few sentences for all protocols of the table, and for a toy that
// shows what a new one has to bring. Against simulated boards, on virtual time.
#include "core/drive/toy_drive.h"
#include "drive/motion_limits.h"
#include "drive/protocol_table.h"
#include "drive/values.h"
#include "simulation/simulated_board.h"

#include <QtTest>

#include <deque>
#include <functional>
#include <map>
#include <set>

using namespace drive;
using namespace std::chrono_literals;

namespace {

/// A row of the table, and the board that answers it.
struct Spoken {
    ProtocolRow row;
    std::unique_ptr<simulation::ByteDevice> (*board)(const ProtocolRow &row);
};

std::unique_ptr<simulation::ByteDevice> simulated(const ProtocolRow &row)
{
    simulation::BoardOptions options;
    if (!row.boards.front().empty())
        options.profile = row.boards.front();
    options.baud = row.baud != 0 ? row.baud : options.baud;
    return simulation::makeBoard(options);
}

const std::map<std::string, Spoken> &protocols()
{
    static const auto all = [] {
        std::map<std::string, Spoken> made;
        const auto add = [&](const ProtocolRow &row, auto board) {
            made.insert({std::string(row.choice.word), {row, board}});
        };
        ProtocolRow toy;
        toy.choice = {Protocol::Auto, "toy", "Toy", "boards of this test", true};
        toy.make = [](const LineOptions &, Search) -> std::unique_ptr<Drive> {
            return std::make_unique<support::toy::ToyDrive>();
        };
        add(toy, [](const ProtocolRow &) -> std::unique_ptr<simulation::ByteDevice> {
            return std::make_unique<support::toy::Board>();
        });
        for (const ProtocolRow &row : protocolTable())
            if (row.choice.protocol != Protocol::Auto)
                add(row, simulated);
        return made;
    }();
    return all;
}

/// A parameter that the board has and that can be written.
std::string gainOf(const catalog::Catalog &catalog)
{
    return catalog.find("SPEED_KP") != nullptr ? "SPEED_KP" : "CL_VEL_PID_KP";
}

/// Another value of the same parameter.
Value other(const Value &value)
{
    return std::holds_alternative<double>(value)
        ? Value(*asNumber(value) * 0.5)
        : Value(static_cast<std::int64_t>(*asNumber(value)) + 1);
}

/// A drive and a board, joined by a line that may be cut.
class ConformanceBench {
public:
    explicit ConformanceBench(const Spoken &spoken)
        : drive(spoken.row.make({spoken.row.choice.protocol, spoken.row.baud}, Search::No))
        , m_board(spoken.board(spoken.row))
        , m_baud(spoken.row.baud)
    {
    }

    bool runUntil(const std::function<bool()> &condition, Duration limit = 30s)
    {
        const TimePoint end = now + limit;
        for (;;) {
            pump();
            if (condition())
                return true;
            if (now >= end)
                return false;
            TimePoint next = std::min(m_board->nextWake(), now + 1ms);
            for (const auto &due : {drive->nextTimeout(),
                     m_line.empty() ? std::nullopt : std::optional(m_line.front().at)})
                if (due)
                    next = std::min(next, *due);
            now = std::max(next, now + 10us);
        }
    }
    bool meet()
    {
        drive->connect(now);
        return runUntil([this] { return identified && status; });
    }
    /// Armed, and with what the user adds where a board does not tell its limits.
    bool arm()
    {
        drive->arm();
        if (!gapsIn(identified->limits.front()).empty())
            return ask(UserLimits{1500.0, 0.0}).outcome == Outcome::Ok
                && ask(ExpertMode{1}).outcome == Outcome::Ok && drive->armed();
        return drive->armed();
    }
    template <class What>
    WishId submit(What what)
    {
        drive->submit({++m_lastWish, std::move(what)}, now);
        return m_lastWish;
    }
    template <class What>
    Ended ask(What what)
    {
        const WishId id = submit(std::move(what));
        return runUntil([&] { return ended.contains(id); }, 10s)
            ? ended.at(id)
            : Ended{id, Outcome::Unknown, "never", {}};
    }
    /// One round that reads this register, or little more.
    bool watchOnce(RegisterId id)
    {
        const int before = read[id];
        return ask(Watch{{id}, 100ms}).outcome == Outcome::Ok
            && runUntil([&] { return read[id] > before; }) && ask(Watch{}).outcome == Outcome::Ok;
    }
    bool start()
    {
        return ask(SpeedRamp{1, 900, 100ms}).outcome == Outcome::Ok
            && ask(Command{MotorAction::Start, 1}).outcome == Outcome::Ok
            && runUntil([this] { return status->state == MotorState::Running; });
    }
    RegisterId gain() const
    {
        return identified->catalog->resolve(gainOf(*identified->catalog)).value_or(0);
    }
    bool said(StopWord word) const
    {
        return std::find(words.begin(), words.end(), word) != words.end();
    }

    TimePoint now{1s};
    std::unique_ptr<Drive> drive;
    bool cut = false; ///< nothing gets through
    LinkState link = LinkState::Closed;
    std::optional<Identified> identified;
    std::optional<MotorStatus> status;
    std::map<WishId, Ended> ended;
    std::map<RegisterId, Reading> values;
    std::map<RegisterId, int> read; ///< how often it was read
    std::vector<StopWord> words;

private:
    struct Leaving {
        TimePoint at, end;
        Bytes bytes;
    };
    void pump()
    {
        m_board->advance(now);
        const Bytes heard = m_board->takeOutput();
        if (!heard.empty() && !cut)
            drive->receive(heard, now);
        drive->handleTimeout(now);
        for (Output &output : drive->takeOutput()) {
            if (output.dropsEarlier)
                m_line.clear();
            const TimePoint at = std::max(now, m_free + output.gapBefore);
            m_free = at + wireTime(output.bytes.size(), m_baud);
            m_line.push_back({at, m_free, std::move(output.bytes)});
        }
        while (!m_line.empty() && m_line.front().at <= now) {
            if (!cut)
                m_board->receive(m_line.front().bytes, m_line.front().at);
            m_line.pop_front();
            m_told = false;
        }
        if (m_line.empty() && now >= m_free && !std::exchange(m_told, true))
            drive->handleSent(now);
        for (Event &event : drive->takeEvents())
            std::visit([this](auto &what) { accept(what); }, event);
    }
    static Duration wireTime(std::size_t bytes, std::uint32_t baud)
    {
        return baud == 0 ? Duration{} : ::wireTime(bytes, baud);
    }
    void accept(LinkChanged &change) { link = change.state; }
    void accept(Identified &event) { identified = std::move(event); }
    void accept(MotorStatus &event) { status = std::move(event); }
    void accept(Ended &event) { ended[event.id] = std::move(event); }
    void accept(StopProgress &event) { words.push_back(event.word); }
    void accept(RegistersRead &event)
    {
        for (Reading &reading : event.readings) {
            ++read[reading.id];
            values[reading.id] = std::move(reading);
        }
    }
    template <class Other>
    void accept(Other &)
    {
    }

    std::unique_ptr<simulation::ByteDevice> m_board;
    std::uint32_t m_baud;
    std::deque<Leaving> m_line;
    TimePoint m_free{};
    bool m_told = true;
    WishId m_lastWish = 0;
};

} // namespace

class TestDriveConformance : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itIsMetAndDescribed_data() { rows(); }
    void itIsMetAndDescribed()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet());
        QVERIFY(bench.link == LinkState::Connected);
        QVERIFY(bench.status->state == MotorState::Idle);
        QVERIFY(!bench.identified->identity.protocol.empty());
        QVERIFY(bench.identified->catalog->find(gainOf(*bench.identified->catalog)) != nullptr);
        QVERIFY(!bench.drive->armed());
    }
    void itSaysOfAllWhetherItCan_data() { rows(); }
    void itSaysOfAllWhetherItCan()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet());
        std::set<Feature> told;
        for (const Capability &one : bench.identified->capabilities) {
            QVERIFY(told.insert(one.feature).second);
            QCOMPARE(one.reason.empty(), one.available);
        }
        QCOMPARE(told.size(), kFeatures);
        QVERIFY(bench.identified->limits.front().speedStepRpm > 0.0);
    }
    void nothingActsUnarmed_data() { rows(); }
    void nothingActsUnarmed()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet());
        const RegisterId id = bench.gain();
        QVERIFY(bench.ask(Write{{{id, std::int64_t{1}}}}).outcome == Outcome::NotSent);
        QVERIFY(bench.ask(SpeedRamp{1, 100, 100ms}).outcome == Outcome::NotSent);
        QVERIFY(bench.ask(Command{MotorAction::Start, 1}).outcome == Outcome::NotSent);
        QVERIFY(bench.status->state == MotorState::Idle);
    }
    void aWriteHasItsLedger_data() { rows(); }
    void aWriteHasItsLedger()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        const RegisterId id = bench.gain();
        QVERIFY(bench.ask(Read{{id}}).outcome == Outcome::Ok);
        const Value before = bench.values.at(id).value;
        const Value wanted = other(before);
        const Ended end = bench.ask(Write{{{id, wanted}}});
        QCOMPARE(end.reason, std::string());
        QVERIFY(end.outcome == Outcome::Ok);
        const WriteResult &result = end.writes.front();
        QVERIFY(result.before == before);
        QVERIFY(sameValue(wanted, result.readBack.value()));
        QVERIFY(result.verified == true);
    }
    /// The question would keep the write from the wire.
    void whatWasReadAMomentAgoIsNotAskedBeforeAWrite_data() { rows(); }
    void whatWasReadAMomentAgoIsNotAskedBeforeAWrite()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        const RegisterId id = bench.gain();
        QVERIFY(bench.watchOnce(id));
        const Value first = bench.values.at(id).value;
        const Value second = other(first);
        int asked = bench.read[id];
        const WriteResult known = bench.ask(Write{{{id, second}}}).writes.front();
        QVERIFY(known.before == first);
        QVERIFY(known.verified == true);
        QCOMPARE(bench.read[id] - asked, 1); // behind it

        asked = bench.read[id];
        const WriteResult written = bench.ask(Write{{{id, first}}}).writes.front();
        QVERIFY(sameValue(second, written.before.value())); // it was written since
        QVERIFY(written.verified == true);
        QCOMPARE(bench.read[id] - asked, 2);
    }
    void whatWasReadLongerAgoIsAskedBeforeAWrite_data() { rows(); }
    void whatWasReadLongerAgoIsAskedBeforeAWrite()
    {
        for (const bool doubted : {false, true}) {
            ConformanceBench bench(spoken());
            QVERIFY(bench.meet() && bench.arm());
            const RegisterId id = bench.gain();
            QVERIFY(bench.watchOnce(id));
            const int asked = bench.read[id];
            if (doubted) {
                bench.drive->doubt(bench.now); // the computer slept, on a clock that did not
                const auto believed = [&] {
                    bench.drive->arm();
                    return bench.drive->armed();
                };
                QVERIFY(bench.runUntil(believed, LatelyRead::kHolds / 2));
            } else {
                bench.runUntil([] { return false; }, LatelyRead::kHolds + 1ms);
            }
            const Value value = bench.values.at(id).value;
            const WriteResult result = bench.ask(Write{{{id, other(value)}}}).writes.front();
            QVERIFY(result.before == value && result.verified == true);
            QCOMPARE(bench.read[id] - asked, 2);
        }
    }
    /// A snapshot of a whole board takes seconds, and what a running experiment watches may end it.
    void whatIsWatchedIsReadBesideMuchElse_data() { rows(); }
    void whatIsWatchedIsReadBesideMuchElse()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        const RegisterId id = bench.gain();
        constexpr int kReads = 12, kEach = 16;
        QVERIFY(bench.ask(Watch{{id}, 1ms}).outcome == Outcome::Ok);
        const int before = bench.read[id];
        WishId last = 0;
        for (int i = 0; i < kReads; ++i)
            last = bench.submit(Read{std::vector<RegisterId>(kEach, id)});
        QVERIFY(bench.runUntil([&] { return bench.ended.contains(last); }));
        QVERIFY(bench.ended.at(last).outcome == Outcome::Ok);
        const int watched = bench.read[id] - before - kReads * kEach;
        QVERIFY2(watched >= kReads / 4, qPrintable(QString::number(watched)));
    }
    void whatIsNotThereIsRefused_data() { rows(); }
    void whatIsNotThereIsRefused()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        constexpr RegisterId kNone = 0x7FF9;
        const Ended end = bench.ask(Write{{{kNone, std::int64_t{1}}}});
        QVERIFY(end.outcome == Outcome::Refused);
        QVERIFY(!end.reason.empty());
        QVERIFY(bench.ask(Command{MotorAction::Start, 9}).outcome == Outcome::Refused);
    }
    void noSpeedBeyondTheLimitLeaves_data() { rows(); }
    void noSpeedBeyondTheLimitLeaves()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        QVERIFY(bench.ask(UserLimits{800.0, 0.0}).outcome == Outcome::Ok);
        const Ended end = bench.ask(SpeedRamp{1, 801, 100ms});
        QVERIFY(end.outcome == Outcome::Refused);
        QVERIFY(end.reason.find("your own limit") != std::string::npos);
        QVERIFY(bench.ask(SpeedRamp{1, 800, 100ms}).outcome == Outcome::Ok);
    }
    void aMotorRunsAndIsStopped_data() { rows(); }
    void aMotorRunsAndIsStopped()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        QVERIFY(bench.start());
        bench.drive->stop(bench.now);
        QVERIFY(!bench.drive->armed());
        QVERIFY(bench.drive->stopOpen());
        QVERIFY(bench.runUntil(
            [&] { return bench.said(StopWord::Standstill) || bench.said(StopWord::MayCoast); }));
        QVERIFY(bench.said(StopWord::Requested) && bench.said(StopWord::Accepted));
        QVERIFY(bench.said(StopWord::DriveIdle) && !bench.said(StopWord::NotConfirmed));
        QVERIFY(!bench.drive->stopOpen());
        QVERIFY(bench.ask(Command{MotorAction::Start, 1}).outcome == Outcome::NotSent);
    }
    void aStopThatNobodyHearsIsAlarmed_data() { rows(); }
    void aStopThatNobodyHearsIsAlarmed()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        QVERIFY(bench.start());
        bench.cut = true;
        bench.drive->stop(bench.now);
        QVERIFY(bench.runUntil([&] { return bench.said(StopWord::NotConfirmed); }, 1s));
        bench.cut = false;
        QVERIFY(bench.runUntil([&] { return bench.said(StopWord::DriveIdle); }));
    }
    void aLostLinkEndsWishesAndComesBack_data() { rows(); }
    void aLostLinkEndsWishesAndComesBack()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        const RegisterId id = bench.gain();
        bench.cut = true;
        QVERIFY(bench.ask(Read{{id}}).outcome != Outcome::Ok);
        QVERIFY(bench.runUntil([&] { return bench.link == LinkState::Lost; }));
        QVERIFY(!bench.drive->armed());
        bench.identified.reset();
        bench.cut = false;
        QVERIFY(bench.runUntil([&] { return bench.identified.has_value(); }));
        QVERIFY(bench.link == LinkState::Connected);
        QVERIFY(!bench.drive->armed());
        QVERIFY(bench.ask(Read{{id}}).outcome == Outcome::Ok);
    }
    void disconnectingClosesIt_data() { rows(); }
    void disconnectingClosesIt()
    {
        ConformanceBench bench(spoken());
        QVERIFY(bench.meet() && bench.arm());
        bench.drive->disconnect(bench.now);
        QVERIFY(bench.runUntil([&] { return bench.link == LinkState::Closed; }, 2s));
        QVERIFY(!bench.drive->armed());
    }

private:
    static void rows()
    {
        QTest::addColumn<std::string>("protocol");
        for (const auto &[name, protocol] : protocols())
            QTest::newRow(name.c_str()) << name;
    }
    static const Spoken &spoken()
    {
        QFETCH(std::string, protocol);
        return protocols().at(protocol);
    }
};

QTEST_APPLESS_MAIN(TestDriveConformance)
#include "tst_drive_conformance.moc"
