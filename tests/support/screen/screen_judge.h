// The judge of the screen: whether what the window says is what the board is. It reads what the user reads, texts and
// accessible names of the real window in English, and compares it with the simulated board's truth; it never looks into
// the models behind. A statement may be as old as the link allows (kOld); what nothing was heard about for longer has
// to be marked as not known.
//
// Each rule is a function; what it finds names the widget, its text and the truth. Values, the picture, the trigger and
// the message over the scope have judges of their own beside this one.
#pragma once

#include "support/screen/judge_banner.h"
#include "support/screen/judge_export.h"
#include "support/screen/judge_files.h"
#include "support/screen/judge_picture.h"
#include "support/screen/judge_polled.h"
#include "support/screen/judge_trigger.h"
#include "support/screen/judge_values.h"
#include "support/screen/screen_moment.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QFileInfo>
#include <QLabel>
#include <QPersistentModelIndex>
#include <QSet>

#include <map>
#include <utility>

namespace support {

class ScreenJudge {
public:
    /// A state is polled every 250 ms, and doubted after 600 ms of silence.
    static constexpr Duration kOld = 1500ms;
    /// A value: polled four times a second, read again after a silence.
    static constexpr Duration kRead = 2500ms;
    static constexpr Duration kAwake = 400ms; ///< after a thread stood still
    static constexpr Duration kAsked = 300ms; ///< from one question for a state to the next
    static constexpr Duration kListed = 2500ms; ///< until a fault is in the list of events
    /// Until a port is closed, where a motor is stopped before.
    static constexpr Duration kLeft = 15s;

    ScreenJudge(const QWidget &window, JudgedWorld &world, int motors)
        : m_world(world)
        , m_motors(motors)
        , m_moment(window, world)
    {
        m_touch.follow(window);
    }

    /// Compares what is on the screen now. @return the first false statement; empty if there is none
    std::string look()
    {
        const bool frozen = m_world.frozen(); // first: once it runs again, that is trouble of now
        const Duration calm = m_world.sinceTrouble();
        m_moment.calm = calm;
        m_moment.more = m_moment.moreFor(kOld);
        const bool heard = m_world.silence() < kOld;
        if (!heard || calm < kOld || frozen || !m_moment.answers())
            m_unwell = m_world.now();
        m_unwell = std::max(m_unwell, m_world.linkChanged());
        m_moment.begin();
        m_moment.heard = heard;
        if (calm < kAwake || frozen)
            return m_moment.found();
        nothingIsKnownOfASilentBoard(heard);
        if (heard) {
            theStateIs();
            theStatusLineSaysTheSame();
            theFaultsAre();
            theSpeedIs(
                "SPEED_MEAS", &BoardHistory::Span::leastRpm, &BoardHistory::Span::greatestRpm);
            theSpeedIs("SPEED_REF", &BoardHistory::Span::leastReference,
                &BoardHistory::Span::greatestReference);
            theLimitIs();
            theStopWordsAreOver();
        }
        aBoardIsNamedThatAnswered();
        theChosenMotorStays();
        theListIs();
        m_values.look();
        m_picture.look();
        m_polled.look();
        m_trigger.look(m_unwell);
        m_banner.look();
        m_looks += 1;
        return m_moment.found();
    }

    void recordingBegins(const QString &path) { m_files.begins(path); }
    void recordingEnds() { m_files.ends(); }
    /// To be asked when the file is whole.
    std::string recordedAsSent() { return m_files.asSent(); }

    bool canJudgeExports() const { return m_exports.canJudge(); }
    std::string exportedAsSent(const QString &path) { return m_exports.asSent(path); }

    /// The user pressed what makes a trigger of its own.
    void forcesTrigger() { m_trigger.forced(); }

    /// The user pressed what closes the port, or the wait for one.
    void closes() { m_closed = m_world.now(); }

    /// What is sent is what the field said would be sent.
    /// @param echo  what stood below the field when it was agreed to
    /// @param rpm  of the set-point that left then
    /// @param step  of the board's set-points in rpm
    static std::string setPointAsSaid(const QString &echo, double rpm, double step)
    {
        static const QRegularExpression steps(QStringLiteral("rpm \\(steps of ([0-9.]+)"));
        if (const auto match = steps.match(echo);
            match.hasMatch() && match.captured(1).toDouble() != step)
            return "\"" + echo.toStdString() + "\", and the board has steps of "
                + std::to_string(step);
        static const QRegularExpression said(QStringLiteral("(?:= |becomes )(-?[0-9.]+).rpm"));
        const auto match = said.match(echo);
        if (!match.hasMatch() || std::abs(match.captured(1).toDouble() - rpm) < 1.0)
            return {};
        return "\"" + echo.toStdString() + "\", and " + std::to_string(rpm) + " rpm left";
    }

    /// A file is open in the place of a board: nothing on the screen is of that board any more.
    std::string asOfAFile(const QString &path) const
    {
        if (const QString title = m_moment.window().windowTitle();
            !title.contains(QFileInfo(path).fileName()))
            return "the title says \"" + title.toStdString() + "\", and "
                + QFileInfo(path).fileName().toStdString() + " is open";
        if (const QString text = said("firmware"); !text.isEmpty())
            return "firmware says \"" + text.toStdString() + "\", and a file is open";
        const auto *words = find<QWidget>("stopWords");
        for (const QLabel *word : words->findChildren<QLabel *>())
            if (word->isVisible() && !word->text().isEmpty())
                return "stopWords says \"" + word->text().toStdString() + "\", and a file is open";
        return {};
    }

    /// The planned gains that are shown as "NUMERATOR/2^EXPONENT", by register; without those of which it is said that
    /// another number waits.
    std::map<QString, int> plannedGains() const
    {
        std::map<QString, int> planned;
        const auto *told = find<QLabel>("labTold");
        const QString other =
            told != nullptr && told->isVisible() && told->text().contains(QLatin1String("by hand"))
            ? told->text()
            : QString();
        const auto *table = find<QAbstractItemView>("labGains");
        static const QRegularExpression fraction(QStringLiteral("^([-\u2212]?[0-9]+)(/|$)"));
        for (int row = 0;
             table != nullptr && table->isVisible() && row < table->model()->rowCount(); ++row) {
            const auto match = fraction.match(table->model()->index(row, 2).data().toString());
            const QString name = table->model()->index(row, 0).data().toString();
            if (match.hasMatch() && !other.contains(name))
                planned[name] = int(*number(match.captured(1)));
        }
        return planned;
    }
    /// What Apply wrote is what the table of planned gains showed.
    /// @param written  by the register's number on the wire of MCP
    std::string gainsAsShown(
        const std::map<QString, int> &planned, const std::map<std::uint32_t, double> &written) const
    {
        static const std::map<QString, std::uint32_t> numbers{{QStringLiteral("SPEED_KP"), 0x90},
            {QStringLiteral("SPEED_KI"), 0xD0}, {QStringLiteral("I_Q_KP"), 0x190},
            {QStringLiteral("I_Q_KI"), 0x1D0}, {QStringLiteral("I_D_KP"), 0x290},
            {QStringLiteral("I_D_KI"), 0x2D0}};
        for (const auto &[name, value] : planned) {
            const auto known = numbers.find(name);
            if (known == numbers.end())
                continue;
            const auto found = written.find(known->second | std::uint32_t(chosenMotor()));
            if (found != written.end()
                && static_cast<std::int16_t>(found->second) != static_cast<std::int16_t>(value))
                return "the table showed " + name.toStdString() + " = " + std::to_string(value)
                    + ", and " + std::to_string(int(found->second)) + " was written";
        }
        return {};
    }

    int looks() const { return m_looks; }
    int statements() const { return m_moment.statements; } ///< that were compared

private:
    using Motor = simulation::MotorState;

    template <class T>
    const T *find(const char *name) const
    {
        return m_moment.find<T>(name);
    }
    QString said(const char *name) const { return m_moment.said(name); }
    int chosenMotor() const { return m_moment.chosenMotor(); }
    BoardHistory::Span lately(int motor, Duration time) const
    {
        return m_world.lately(motor, time + m_moment.more);
    }
    void finds(const char *name, const QString &text, const std::string &truth)
    {
        m_moment.finds(QLatin1String(name), text, truth);
    }

    static std::optional<std::set<Motor>> statesOf(const QString &word)
    {
        static const std::map<QString, std::set<Motor>> words{
            {QStringLiteral("Idle"), {Motor::Idle}},
            {QStringLiteral("Starting"),
                {Motor::Alignment, Motor::Start, Motor::ChargeBootCap, Motor::OffsetCalib,
                    Motor::SwitchOver}},
            {QStringLiteral("Running"), {Motor::Run}}, {QStringLiteral("Stopping"), {Motor::Stop}},
            {QStringLiteral("Fault present"), {Motor::FaultNow}},
            {QStringLiteral("Fault latched"), {Motor::FaultNow, Motor::FaultOver}}};
        const auto found = words.find(word);
        return found == words.end() ? std::nullopt : std::optional(found->second);
    }
    static std::string namesOf(const std::set<Motor> &states)
    {
        std::string text = "the board was in state";
        for (const Motor state : states)
            text += " " + std::to_string(static_cast<int>(state));
        return text;
    }
    void stateIs(const char *name, int motor, QString word)
    {
        static const QRegularExpression ofMotor(QStringLiteral("^Motor (\\d): (.*)$"));
        static const QRegularExpression detail(QStringLiteral(" \\(.*\\)$"));
        if (const auto match = ofMotor.match(word); match.hasMatch()) {
            motor = match.captured(1).toInt();
            word = match.captured(2);
        }
        const auto states = statesOf(word.remove(detail));
        auto truth = lately(motor, kOld);
        if (!states || !truth.known)
            return;
        ++m_moment.statements;
        if (truth.states.contains(Motor::FaultOver) && truth.states.size() > 1)
            truth.states.insert(Motor::FaultNow); // the way there, for a turn of the firmware
        const bool was = std::any_of(states->begin(), states->end(),
            [&](Motor state) { return truth.states.contains(state); });
        if (!was)
            finds(name, word, namesOf(truth.states));
    }

    void nothingIsKnownOfASilentBoard(bool heard)
    {
        if (heard)
            return;
        ++m_moment.statements;
        const std::string truth = "and nothing was heard of the board";
        if (const QString text = said("motorState");
            statesOf(text.section(QLatin1String(": "), -1)))
            finds("motorState", text, truth);
        if (const QString text = said("boardLamp"); text.contains(QLatin1String("answering")))
            finds("boardLamp", text, truth);
        if (const QString text = said("faultsNow"); text.startsWith(QLatin1String("No fault")))
            finds("faultsNow", text, truth);
        if (const QString text = said("statusMotor"); text.startsWith(QLatin1String("Motor")))
            finds("statusMotor", text, truth);
        if (m_world.silence() > kRead)
            for (const char *name : {"SPEED_MEAS", "SPEED_REF"})
                if (const QString text = said(name); number(text))
                    finds(name, text, truth);
    }
    void theStateIs() { stateIs("motorState", chosenMotor(), said("motorState")); }
    void theStatusLineSaysTheSame() { stateIs("statusMotor", chosenMotor(), said("statusMotor")); }

    void theFaultsAre()
    {
        const auto truth = lately(chosenMotor(), kOld);
        if (!truth.known)
            return;
        const QString now = said("faultsNow"), past = said("faultsPast");
        m_moment.statements += !now.isEmpty() + !past.isEmpty();
        if (now.startsWith(QLatin1String("No fault")) && !truth.nonePresent)
            finds("faultsNow", now, "a fault is present");
        if (now.contains(QLatin1String("Present:")) && !truth.faultPresent)
            finds("faultsNow", now, "none is present");
        if (past.contains(QLatin1String("acknowledge")) && !truth.faultKept)
            finds("faultsPast", past, "none is kept");
    }

    static std::optional<double> number(const QString &text)
    {
        const auto found = ScreenMoment::number(text);
        return found ? std::optional(found->value) : std::nullopt;
    }
    void theSpeedIs(
        const char *name, double BoardHistory::Span::*least, double BoardHistory::Span::*greatest)
    {
        constexpr double kStep = 12.0; // two digits of the firmware
        const QString text = said(name);
        const auto shown = number(text);
        const auto truth = lately(chosenMotor(), kRead);
        if (!shown || !truth.known || !text.contains(QLatin1String("rpm")))
            return;
        ++m_moment.statements;
        if (*shown < truth.*least - kStep || *shown > truth.*greatest + kStep)
            finds(name, text,
                "it was " + std::to_string(truth.*least) + " to "
                    + std::to_string(truth.*greatest));
    }

    void theLimitIs()
    {
        static const QRegularExpression limit(QStringLiteral("^Limits: ([0-9]+)"));
        const QString text = said("limits");
        const auto match = limit.match(text);
        const double tells = lately(chosenMotor(), kRead).maxRpm;
        if (!match.hasMatch() || !(tells > 0.0))
            return;
        ++m_moment.statements;
        if (match.captured(1).toDouble() > tells + 6.0)
            finds("limits", text, "the board allows " + std::to_string(tells) + " rpm");
    }

    /// Words that a motor stands are gone when it turns again.
    void theStopWordsAreOver()
    {
        const auto *words = find<QWidget>("stopWords");
        const auto truth = lately(1, kOld);
        if (words == nullptr || !words->isVisible() || !truth.known || m_motors > 1)
            return;
        for (const QLabel *label : words->findChildren<QLabel *>()) {
            const bool rest = label->text().startsWith(QChar(0x25cf))
                && (label->text().contains(QLatin1String("drive idle"))
                    || label->text().contains(QLatin1String("standstill")));
            if (!rest || !label->isVisible())
                continue;
            ++m_moment.statements;
            if (!truth.rested)
                finds("stopWords", label->text(), "the motor is driven");
        }
    }

    void aBoardIsNamedThatAnswered()
    {
        const QString lamp = said("boardLamp"), name = said("firmware");
        m_moment.statements += 2;
        if (lamp.contains(QLatin1String("link lost")) && !m_world.everHeard())
            finds("boardLamp", lamp, "there never was a link");
        if (lamp.contains(QLatin1String("no board")) && !name.isEmpty())
            finds("firmware", name, "beside \"no board\"");
    }

    /// Only the user changes it while the port is open.
    void theChosenMotorStays()
    {
        const auto *box = find<QComboBox>("motor");
        const bool shown = box != nullptr && box->isVisible() && box->currentIndex() >= 0;
        const bool touched = std::exchange(m_touch.touched, false);
        if (!shown || touched || m_world.openings() != m_opening || m_choice < 0) {
            m_opening = m_world.openings();
            m_choice = shown ? box->currentIndex() : -1;
            return;
        }
        ++m_moment.statements;
        if (box->currentIndex() != m_choice)
            finds("motor", box->currentText(),
                "and nobody chose another one than number " + std::to_string(m_choice + 1));
    }

    /// The rows of the list of events that were not there at the last look, wherever they were put.
    std::vector<QModelIndex> newRows(const QAbstractItemView &list)
    {
        std::vector<QModelIndex> fresh;
        QSet<QPersistentModelIndex> seen;
        for (int row = 0; row < list.model()->rowCount(); ++row) {
            const QPersistentModelIndex index = list.model()->index(row, 0);
            if (!m_seen.contains(index))
                fresh.emplace_back(index);
            seen.insert(index);
        }
        m_seen = std::move(seen);
        return fresh;
    }
    void theListIs()
    {
        const auto *list = find<QAbstractItemView>("eventList");
        if (list == nullptr)
            return;
        const auto *onlyMarkers = find<QAbstractButton>("onlyMarkers");
        const bool all = onlyMarkers == nullptr || !onlyMarkers->isChecked();
        const std::vector<QModelIndex> fresh = newRows(*list);
        if (!all)
            m_hidden = m_world.now();
        if (m_hidden + kListed > m_world.now())
            return; // what is new has come before, perhaps
        for (const QModelIndex &row : fresh)
            theEventHappened(
                row.siblingAtColumn(1).data().toString(), row.siblingAtColumn(2).data().toString());
        eachFaultIsListed();
    }

    /// What the list tells that came by itself.
    void theEventHappened(const QString &kind, const QString &text)
    {
        const TimePoint now = m_world.now();
        ++m_moment.statements;
        if (kind == QLatin1String("Command") && text == QLatin1String("Disconnected")
            && m_world.sinceClosed() > kListed && m_closed + kLeft < now)
            finds("eventList", text, "nobody closed the port");
        if (kind == QLatin1String("Recovery"))
            m_metAt = now;
        const bool rests = text == QLatin1String("READY_TO_SWITCH_ON")
            || text == QLatin1String("SWITCH_ON_DISABLED"); // one state of a servo here
        if (kind == QLatin1String("State") && !rests && m_motors == 1 && m_metAt + kListed < now
            && m_unwell + kListed < now
            && m_world.lately(1, BoardHistory::kKept).states.size() == 1)
            finds("eventList", text, "the state has not changed");
        if (kind != QLatin1String("Fault") || text.contains(QLatin1String("not confirmed")))
            return;
        m_listed.push_back(now);
        bool had = false;
        for (int motor = 1; motor <= m_motors; ++motor) {
            const auto truth = m_world.lately(motor, BoardHistory::kKept);
            had = had || truth.faultPresent || truth.faultKept;
        }
        if (!had)
            finds("eventList", text, "the board had no fault");
    }

    /// A fault that came while the board was answering is in the list soon.
    void eachFaultIsListed()
    {
        const TimePoint now = m_world.now();
        const auto faults = m_world.faults();
        for (; m_judged < faults.size() && faults[m_judged].at + kListed < now; ++m_judged) {
            const TimePoint at = faults[m_judged].at;
            if (m_unwell + kOld > at || m_hidden + kListed > at)
                continue; // the board was not heard all the time, or not all rows were shown
            if (at > m_world.resetAt() && at - m_world.resetAt() < kAsked)
                continue; // that it had none in between could not be seen
            ++m_moment.statements;
            const bool listed = std::any_of(
                m_listed.begin(), m_listed.end(), [at](TimePoint seen) { return seen >= at; });
            if (!listed)
                finds("eventList", QStringLiteral("%1 faults").arg(m_listed.size()),
                    "a fault of motor " + std::to_string(faults[m_judged].motor)
                        + " is not among them, " + std::to_string(toSeconds(at - m_world.resetAt()))
                        + " s after a reset");
        }
    }

    /// Sees that the user touches a choice.
    class Touch : public QObject {
    public:
        bool touched = false;
        void follow(const QWidget &window)
        {
            auto *box = window.findChild<QComboBox *>(QStringLiteral("motor"));
            for (QWidget *part : {static_cast<QWidget *>(box), static_cast<QWidget *>(box->view()),
                     box->view()->viewport()})
                part->installEventFilter(this);
        }

    protected:
        bool eventFilter(QObject *, QEvent *event) override
        {
            touched = touched || event->type() == QEvent::KeyPress
                || event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel;
            return false;
        }
    };

    JudgedWorld &m_world;
    int m_motors;
    ScreenMoment m_moment;
    ValuesJudge m_values{m_moment};
    PictureJudge m_picture{m_moment};
    PolledJudge m_polled{m_moment};
    TriggerJudge m_trigger{m_moment};
    BannerJudge m_banner{m_moment};
    FilesJudge m_files{m_moment};
    ExportJudge m_exports{m_moment};
    TimePoint m_unwell{};
    TimePoint m_closed{-kLeft}; ///< none yet
    TimePoint m_metAt{}; ///< when the list told last that the board answers
    TimePoint m_hidden{-kListed}; ///< when the list did not show all rows
    QSet<QPersistentModelIndex> m_seen; ///< its rows at the last look
    std::vector<TimePoint> m_listed; ///< when each row of a fault was seen first
    std::size_t m_judged = 0; ///< of the board's faults
    Touch m_touch;
    int m_choice = -1; ///< of the motor, its row; -1: there was none
    int m_opening = 0; ///< of the port, for which it counts
    int m_looks = 0;
};

} // namespace support
