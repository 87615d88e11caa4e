// Random runs of the models of the stop (stop.pml), played to the real drives on virtual time: the same acts, the same
// fates of packets, and at the end of each phase the same link, arming, STARTs, STOPs, words and motors.
// The short form plays the runs in tests/data/model; a few others are asked of spin each time, and
// 10,000 of each model with ROTORSCOPE_LONG=1.
//
// What the models leave open is left open here, too: how many STOPs and reads there are, and on a line that loses
// packets whether an OK is heard (accepted) and whether half a second passes (the alarm) before the state is.
#include "drive/stop_sequence.h"
#include "support/mcb/scripted_servo.h"
#include "support/places.h"
#include "support/scripted_boards.h"

#include <QFile>
#include <QProcess>
#include <QTest>

#include <deque>
#include <functional>

using namespace drive;
using namespace std::chrono_literals;
using support::Asked;

namespace {

constexpr unsigned kRequested = 1, kAccepted = 2, kIdle = 4, kAlarm = 8;
constexpr Duration kAnswerAfter = 2ms, kTwiceAfter = 200us;
/// A phase on a good line; the older protocol waits a second for each answer.
constexpr Duration kSettlesWithin = 12s;
/// A phase on a dead line: long enough to give the link up, twice.
constexpr Duration kDeadFor = 8s;

/// Of the words that the models have, too.
unsigned bitOf(StopWord word)
{
    switch (word) {
    case StopWord::Requested:
        return kRequested;
    case StopWord::Accepted:
        return kAccepted;
    case StopWord::DriveIdle:
        return kIdle;
    case StopWord::NotConfirmed:
        return kAlarm;
    default:
        return 0;
    }
}

struct Phase {
    char act = 'N'; ///< Nothing, Arm, Start, stop (X), Both
    int motor = 1;
    char line = 'C'; ///< Clean, Noisy, Mute, Dead
    bool obeys = true, reset = false;
    char startFate = 'd';
    QByteArray fates;
    // how it ended
    char link = 'U'; ///< Up, Lost
    bool armed = false;
    unsigned starts = 0, stops = 0; ///< bits of motors
    std::array<unsigned, 2> told{};
    std::array<bool, 2> drives{};
};

Phase phaseOf(const QByteArray &text)
{
    const QByteArrayList sides = text.split('|');
    const QByteArrayList chosen = sides.at(0).split(','), end = sides.at(1).split(',');
    Phase phase;
    phase.act = chosen.at(0).at(0);
    phase.motor = chosen.at(1).toInt();
    phase.line = chosen.at(2).at(0);
    phase.obeys = chosen.at(3) == "1";
    phase.reset = chosen.at(4) == "1";
    phase.startFate = chosen.at(5).at(0);
    phase.fates = chosen.at(6);
    phase.link = end.at(0).at(0);
    phase.armed = end.at(1) == "1";
    phase.starts = end.at(2).toUInt();
    phase.stops = end.at(3).toUInt();
    phase.told = {end.at(4).toUInt(), end.at(5).toUInt()};
    phase.drives = {end.at(6) == "1", end.at(7) == "1"};
    return phase;
}

/// A drive and a board on virtual time.
class Play {
public:
    explicit Play(std::unique_ptr<support::ScriptedBoard> board)
        : m_board(std::move(board))
        , m_drive(m_board->makeDrive())
    {
        m_drive->connect(m_now);
        look();
    }

    /// What is different from the model; empty if nothing is.
    QString run(const QByteArray &trace)
    {
        int number = 0;
        for (const QByteArray &text : trace.trimmed().split(';')) {
            ++number;
            if (const QString wrong = play(phaseOf(text)); !wrong.isEmpty())
                return QStringLiteral("phase %1 (%2): %3")
                    .arg(QString::number(number), QString::fromLatin1(text), wrong);
        }
        return {};
    }

private:
    struct Flying {
        TimePoint at;
        Bytes bytes;
    };

    QString play(const Phase &phase)
    {
        runUntil([this] { return !m_owed; }, 2s); // the phase begins on a free line
        m_phase = phase;
        m_fates.assign(phase.fates.begin(), phase.fates.end());
        m_starts = m_stops = 0;
        m_told = {};
        const bool wasUp = m_link == LinkState::Connected;
        const bool wasOpen = m_open;
        m_board->obeys = phase.obeys;
        if (phase.reset)
            deliver(m_board->reset(), 'd');
        m_actAt = m_now;
        act();
        if (phase.line == 'C' || phase.line == 'N') {
            runUntil([this] { return settled(); }, kSettlesWithin);
            if (!settled())
                return QStringLiteral("is not settled, link %1").arg(int(m_link));
        } else {
            runUntil([] { return false; }, kDeadFor);
        }
        return judge(wasUp, wasOpen);
    }

    void act()
    {
        switch (m_phase.act) {
        case 'A':
            m_drive->arm();
            if (m_drive->armed())
                m_open = false;
            look();
            break;
        case 'S':
        case 'B':
            for (const auto &wish : {decltype(Wish::what)(UserLimits{3000.0, 0.0}),
                     decltype(Wish::what)(ExpertMode{m_phase.motor}),
                     decltype(Wish::what)(Command{MotorAction::Start, m_phase.motor})})
                submit(wish);
            if (m_phase.act == 'B') {
                runUntil([] { return false; },
                    Duration((m_phase.fates.size() + m_phase.motor) * 700'000));
                stop();
            }
            break;
        case 'X':
            stop();
            break;
        default:
            break;
        }
    }
    void submit(const decltype(Wish::what) &what)
    {
        if (std::holds_alternative<UserLimits>(what) && !m_board->needsExpert())
            return;
        if (std::holds_alternative<ExpertMode>(what) && !m_board->needsExpert())
            return;
        Wish wish;
        wish.id = ++m_wish;
        wish.what = what;
        m_drive->submit(wish, m_now);
        look();
    }
    void stop()
    {
        m_drive->stop(m_now);
        m_open = true;
        look();
    }

    bool known() const { return m_identified; }
    std::size_t motors() const { return static_cast<std::size_t>(m_board->motors()); }
    bool settled() const
    {
        if (m_link != LinkState::Connected || !known() || m_owed || m_ended < m_wish)
            return false;
        if (m_now < m_actAt + 300ms) // a link that is about to be found broken
            return false;
        if (!m_fates.empty() && m_now < m_actAt + 2s)
            return false;
        if (m_now < m_badAt + 2 * m_board->late() + 500ms) // what fared badly is mended
            return false;
        if (!m_open)
            return true;
        for (std::size_t motor = 0; motor < motors(); ++motor) {
            const unsigned words = m_words.at(motor);
            const bool driven = m_board->drives.at(motor);
            const bool done = (words & kIdle) != 0;
            const bool alarmed = (words & kAlarm) != 0 && !m_phase.obeys && driven;
            if (!done && !alarmed)
                return false;
        }
        return true;
    }

    QString judge(bool wasUp, bool wasOpen) const
    {
        const auto differs = [](const char *what, unsigned is, unsigned should) {
            return QStringLiteral("%1 is %2 and not %3")
                .arg(QLatin1String(what), QString::number(is), QString::number(should));
        };
        const bool dead = m_phase.line == 'D' || m_phase.line == 'M';
        const bool up = m_link == LinkState::Connected;
        if (up != (m_phase.link == 'U'))
            return differs("link", up, m_phase.link == 'U');
        if (m_drive->armed() != m_phase.armed)
            return differs("armed", m_drive->armed(), m_phase.armed);
        // A start and a stop at once: whether the START had left is the race.
        if (m_phase.act == 'B' ? (m_starts & ~(1U << (m_phase.motor - 1))) != 0
                               : m_starts != m_phase.starts)
            return differs("STARTs", m_starts, m_phase.starts);
        const bool stopWanted = m_phase.act == 'X' || m_phase.act == 'B';
        if ((m_phase.stops & ~m_stops) != 0 && stopWanted)
            return differs("STOPs", m_stops, m_phase.stops);
        const bool ofStart = m_phase.act == 'S' && m_board->beginsStartsWithStop();
        if (m_stops != 0 && !stopWanted && !wasOpen && !ofStart)
            return differs("STOPs that nobody asked for", m_stops, 0);
        for (std::size_t motor = 0; motor < motors(); ++motor) {
            if (m_board->drives.at(motor) != m_phase.drives.at(motor))
                return differs("driven", m_board->drives.at(motor), m_phase.drives.at(motor));
            unsigned exact = kIdle;
            if (stopWanted)
                exact |= m_phase.act == 'X' || m_phase.told.at(motor) != 0 ? kRequested : 0U;
            if (m_phase.line == 'C' && wasUp && !wasOpen && stopWanted && !m_phase.reset)
                exact |= m_phase.obeys || m_phase.drives.at(motor) ? kAccepted | kAlarm : kAccepted;
            if (dead && stopWanted && !wasOpen)
                exact |= kAlarm;
            if ((m_told.at(motor) & exact) != (m_phase.told.at(motor) & exact))
                return differs("told", m_told.at(motor), m_phase.told.at(motor));
        }
        return {};
    }

    // ---- the line ----

    void runUntil(const std::function<bool()> &condition, Duration limit)
    {
        const TimePoint end = m_now + limit;
        look();
        for (int still = 0; !condition() && m_now < end;) {
            TimePoint next = end;
            if (const auto due = m_drive->nextTimeout())
                next = std::min(next, std::max(*due, m_now));
            if (!m_toDrive.empty())
                next = std::min(next, std::max(m_toDrive.front().at, m_now));
            if (!m_sending.empty())
                next = std::min(next, std::max(sendAt(), m_now));
            still = next == m_now ? still + 1 : 0;
            if (still > 1000)
                qFatal("the drive wants to be called at once, for ever");
            m_now = next;
            sendDue();
            while (!m_toDrive.empty() && m_toDrive.front().at <= m_now) {
                const Bytes bytes = std::move(m_toDrive.front().bytes);
                m_toDrive.pop_front();
                m_owed = m_owed && !m_toDrive.empty();
                m_drive->receive(bytes, m_now);
                look();
            }
            if (const auto due = m_drive->nextTimeout(); due && *due <= m_now)
                m_drive->handleTimeout(m_now);
            look();
        }
    }

    TimePoint sendAt() const { return m_sentAt + m_sending.front().gapBefore; }
    void sendDue()
    {
        bool left = false;
        while (!m_sending.empty() && sendAt() <= m_now) {
            const Bytes bytes = std::move(m_sending.front().bytes);
            m_sending.pop_front();
            m_sentAt = m_now;
            left = true;
            if (m_board->accept(bytes))
                carry(m_board->asked());
        }
        if (left && m_sending.empty())
            m_drive->handleSent(m_now);
    }
    void carry(const Asked &asked)
    {
        if (asked.what == Asked::What::Start)
            m_starts |= 1U << (asked.motor - 1);
        if (asked.what == Asked::What::Stop)
            m_stops |= 1U << (asked.motor - 1);
        char fate = 'd';
        if (m_phase.line == 'D') {
            fate = 'q';
        } else if (m_phase.line == 'M') {
            fate = 'a';
        } else if (asked.what == Asked::What::Start && m_phase.line == 'N') {
            fate = m_phase.startFate;
        } else if (!m_fates.empty() && asked.what != Asked::What::Fetch) {
            fate = m_fates.front();
            m_fates.pop_front();
        }
        if (fate != 'd')
            m_badAt = m_now;
        if (m_phase.line == 'C' || m_phase.line == 'N')
            fate = m_board->fares(fate);
        if (fate == 'q')
            return;
        const Bytes answer = m_board->answer();
        if (fate != 'a')
            deliver(answer, fate);
    }
    void deliver(const Bytes &answer, char fate)
    {
        if (answer.empty() || m_phase.line == 'D' || m_phase.line == 'M')
            return;
        TimePoint at = m_now + (fate == 'l' ? m_board->late() : kAnswerAfter);
        if (!m_toDrive.empty())
            at = std::max(at, m_toDrive.back().at);
        m_toDrive.push_back({at, answer});
        if (fate == 't')
            m_toDrive.push_back({at + kTwiceAfter, answer});
        m_owed = true;
    }
    void look()
    {
        for (Event &event : m_drive->takeEvents())
            note(event);
        for (Output &output : m_drive->takeOutput()) {
            m_sentAt = m_sending.empty() ? std::max(m_sentAt, m_now) : m_sentAt;
            m_sending.push_back(std::move(output));
        }
    }
    void note(const Event &event)
    {
        if (const auto *link = std::get_if<LinkChanged>(&event)) {
            m_link = link->state;
            if (link->state == LinkState::Lost || link->reason == LinkReason::BoardReset)
                m_identified = false;
        } else if (std::holds_alternative<Ended>(event)) {
            ++m_ended;
        } else if (std::holds_alternative<Identified>(event)) {
            m_identified = true;
        } else if (const auto *stop = std::get_if<StopProgress>(&event)) {
            const unsigned bit = bitOf(stop->word);
            const auto motor = static_cast<std::size_t>(stop->motor - 1);
            m_told.at(motor) |= bit;
            m_words.at(motor) = stop->word == StopWord::Requested ? bit : m_words.at(motor) | bit;
        }
    }

    std::unique_ptr<support::ScriptedBoard> m_board;
    std::unique_ptr<Drive> m_drive;
    TimePoint m_now{1s}, m_sentAt{1s}, m_actAt{}, m_badAt{};
    Phase m_phase;
    std::deque<char> m_fates;
    std::deque<Flying> m_toDrive;
    std::deque<Output> m_sending;
    bool m_owed = false; ///< an answer is on its way
    WishId m_wish = 0, m_ended = 0; ///< how many were asked for, and have ended
    LinkState m_link = LinkState::Closed;
    bool m_identified = false, m_open = false;
    unsigned m_starts = 0, m_stops = 0;
    std::array<unsigned, 2> m_told{}, m_words{};
};

std::unique_ptr<support::ScriptedBoard> boardOf(const QByteArray &model)
{
    if (model == "mcp")
        return std::make_unique<support::ScriptedMcpBoard>();
    if (model == "mcb")
        return std::make_unique<support::ScriptedServo>();
    return std::make_unique<support::ScriptedFcpBoard>();
}

QString playAll(const QByteArray &model, const QByteArrayList &traces, int first = 1)
{
    int number = first - 1;
    for (const QByteArray &trace : traces) {
        ++number;
        if (trace.isEmpty())
            continue;
        Play play(boardOf(model));
        if (const QString wrong = play.run(trace); !wrong.isEmpty())
            return QStringLiteral("run %1, %2").arg(QString::number(number), wrong);
    }
    return {};
}

} // namespace

class TestStopModel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theDrivesDoWhatTheModelsDo_data()
    {
        QTest::addColumn<QByteArray>("model");
        for (const char *model : {"mcp", "legacy", "mcb"})
            QTest::newRow(model) << QByteArray(model);
    }
    void theDrivesDoWhatTheModelsDo()
    {
        QFETCH(QByteArray, model);
        QFile file(
            support::dataFile(QStringLiteral("model/%1.txt")).arg(QString::fromLatin1(model)));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArrayList traces = file.readAll().trimmed().split('\n');
        QVERIFY(traces.size() >= 100);
        const QString wrong = playAll(model, traces);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    }

    void freshRunsOfTheModelsToo_data() { theDrivesDoWhatTheModelsDo_data(); }
    /// Seeds that the files do not have; a failure names its seed.
    void freshRunsOfTheModelsToo()
    {
        QFETCH(QByteArray, model);
        const bool isLong = qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0;
        const int count = isLong ? 10'000 : 20;
        constexpr int kFirst = 1001, kAtOnce = 500;
        for (int first = kFirst; first < kFirst + count; first += kAtOnce) {
            QProcess spin;
            spin.start(QStringLiteral("python3"),
                {support::sourceFile(QStringLiteral("tests/model/traces.py")),
                    QString::fromLatin1(model), QString::number(first),
                    QString::number(std::min(count, kAtOnce))});
            QVERIFY(spin.waitForFinished(600'000));
            QVERIFY2(spin.exitCode() == 0, spin.readAllStandardError().constData());
            const QByteArrayList traces = spin.readAllStandardOutput().trimmed().split('\n');
            QCOMPARE(traces.size(), std::min(count, kAtOnce));
            const QString wrong = playAll(model, traces, first);
            QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
        }
    }
};

QTEST_GUILESS_MAIN(TestStopModel)
#include "tst_stop_model.moc"
