// Events and markers in the real window: what is noted of a board's words and the user's wishes, where the lane shows
// it, and what the list does with it.
#include "support/scope_window.h"
#include "widgets/files/event_recorder.h"
#include "widgets/files/open_recording.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/events/icon.h"
#include "widgets/scope/events/lane.h"
#include "widgets/scope/events/log.h"
#include "widgets/scope/events/panel.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QClipboard>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTreeView>

using namespace std::chrono_literals;
using widgets::EventKind;
using widgets::EventLane;
using widgets::EventLog;

class TestScopeEvents : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(4000, [](int, int tick) { return tick; });
        scope().setRunning(false);
        scope().setVisibleRange(0.0, 4.0);
        m_rig->draw();
        m_before = lastId();
    }
    void cleanup() { m_rig.reset(); }

    void aCommandIsNotedAndHowItEnded();
    void whatAnExperimentAsksForIsNotedAtItsTime();
    void aWriteTellsOldAndNewValue();
    void statesAndFaultsHaveTheirOwnTime();
    void aFaultThatIsOverWhenTheBoardIsAskedIsNoted();
    void theSameFaultIsNotedAgainWhenItWasAcknowledgedInBetween();
    void lostSamplesAreNotedWhereTheyAreMissing();
    void soAreThoseOfABoardWithSlowSignalsOnly();
    void aLinkThatGoesAndComesBackIsNoted();
    void aLossIsOneLineHoweverItGoesOn();
    void aStopIsNoted();
    void mSetsAMarkerAtTheMouse();
    void aDoubleClickOnTheTimeAxisOrTheLaneSetsAMarker();
    void closeEventsAreCounted();
    void theNameOfTheLaneIsNeverCut();
    void arrowsGoFromEventToEvent();
    void theListJumpsEditsAndDeletes();
    void theListShowsMarkersOnlyAndCopies();
    void aMarkersLineIsDrawn();
    void clearingKeepsNotes();
    void theLogIsAModelInOrder();
    void theLogForgetsButNeverANote();
    void manyAtOnceAreShownAtOnce();
    void whatComesTogetherIsPaintedTogether();
    void aFileFillsTheLogInOneStep();
    void everyKindHasAShapeOfItsOwn();
    void theClockOfTheSessionIsFoundFromStamps();
    void eventsGoWithTheSamplesOfABoardWhoseClockDrifts();

private:
    widgets::ScopeView &scope() { return m_rig->scope(); }
    EventLog &log() { return scope().events(); }
    EventLane &lane() { return *m_rig->find<EventLane>("eventLane"); }
    quint32 lastId()
    {
        quint32 last = 0;
        for (const widgets::ScopeEvent &event : log().events())
            last = std::max(last, event.id);
        return last;
    }
    /// What was noted since init(), in the order of noting.
    QStringList noted()
    {
        QStringList lines;
        for (quint32 id = m_before + 1; id <= lastId(); ++id) {
            const widgets::ScopeEvent *event = log().find(id);
            lines.append(widgets::eventKindText(event->kind) + QLatin1Char(' ') + event->text);
        }
        return lines;
    }
    QTreeView *openList()
    {
        QTest::keyClick(&m_rig->window, Qt::Key_7, Qt::ControlModifier);
        return m_rig->find<QTreeView>("eventList");
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
    quint32 m_before = 0;
};

void TestScopeEvents::aCommandIsNotedAndHowItEnded()
{
    const auto id = m_rig->device().submit(drive::Command{drive::MotorAction::Start, 1});
    QCOMPARE(noted(), QStringList{QStringLiteral("Command Start")});
    facts::feed(m_rig->device(), {drive::Ended{id, drive::Outcome::Refused, "CMD_NOK", {}}});
    QCOMPARE(noted().size(), 1);
    QVERIFY(noted().first().startsWith(QStringLiteral("Command Start (")));
    m_rig->device().submit(drive::SpeedRamp{1, -1500, 250ms});
    QCOMPARE(noted().last(), QStringLiteral("Command Ramp to -1500 rpm in 250 ms"));
    m_rig->device().submit(drive::Read{{facts::kSpeed}}); // asks only
    QCOMPARE(noted().size(), 2);
}

void TestScopeEvents::whatAnExperimentAsksForIsNotedAtItsTime()
{
    drive::MotionEntry entry;
    entry.act = drive::MotionAct::SpeedRamp;
    entry.motor = 1;
    entry.detail = "1500 rpm in 200 ms";
    entry.asked = TimePoint(1500ms);
    entry.ended = TimePoint(1700ms);
    facts::feed(m_rig->device(), {entry}); // the user's, which was noted as it was asked for
    QCOMPARE(noted(), QStringList());
    entry.source = drive::Source::Script;
    facts::feed(m_rig->device(), {entry});
    QCOMPARE(
        noted(), QStringList{QStringLiteral("Command Experiment: Speed ramp 1500 rpm in 200 ms")});
    QCOMPARE(log().find(lastId())->seconds, 1.5);
    for (entry.asked += 60ms; entry.asked < TimePoint(2500ms); entry.asked += 60ms)
        facts::feed(m_rig->device(), {entry});
    QCOMPARE(noted().size(), 1); // the first of an excitation
    entry.asked += 200ms;
    facts::feed(m_rig->device(), {entry});
    QCOMPARE(noted().size(), 2);
    entry.act = drive::MotionAct::Start;
    entry.detail.clear();
    entry.outcome = drive::Outcome::Refused;
    facts::feed(m_rig->device(), {entry});
    QVERIFY2(noted().last().startsWith(QStringLiteral("Command Experiment: Start (")),
        qPrintable(noted().last()));
}

void TestScopeEvents::aWriteTellsOldAndNewValue()
{
    const auto id = m_rig->device().submit(drive::Write{{{facts::kVoltage, std::int64_t{30}}}});
    QCOMPARE(noted().size(), 0); // not written yet
    drive::WriteResult result;
    result.id = facts::kVoltage;
    result.before = std::int64_t{24};
    result.readBack = std::int64_t{30};
    result.verified = true;
    facts::feed(m_rig->device(), {drive::Ended{id, drive::Outcome::Ok, {}, {result}}});
    QCOMPARE(noted().size(), 1);
    QVERIFY2(noted().first().startsWith(QStringLiteral("Write BUS_VOLTAGE: 24"))
            && noted().first().contains(QStringLiteral("\u2192 30")),
        qPrintable(noted().first()));
}

void TestScopeEvents::statesAndFaultsHaveTheirOwnTime()
{
    drive::MotorStatus status = facts::status(drive::MotorState::Running);
    status.rawState = 6;
    status.stateName = "RUN";
    status.at = TimePoint(1500ms);
    facts::feed(m_rig->device(), {status});
    facts::feed(m_rig->device(), {status}); // the same again is no event
    status.state = drive::MotorState::FaultNow;
    status.rawState = 10;
    status.stateName = "FAULT_NOW";
    status.faultsNow = {"OVER_VOLT"};
    status.at = TimePoint(2500ms);
    facts::feed(m_rig->device(), {status});
    const auto range = log().in(1.4, 2.6);
    QStringList seen;
    for (std::size_t i = range.first; i < range.last; ++i)
        seen.append(
            QString::number(log().events()[i].seconds) + QLatin1Char(' ') + log().events()[i].text);
    QCOMPARE(seen,
        (QStringList{QStringLiteral("1.5 RUN"), QStringLiteral("2.5 OVER_VOLT"),
            QStringLiteral("2.5 FAULT_NOW")}));
}

void TestScopeEvents::aFaultThatIsOverWhenTheBoardIsAskedIsNoted()
{
    const auto faultsIn = [this](double from, double to) {
        QStringList seen;
        const auto range = log().in(from, to);
        for (std::size_t i = range.first; i < range.last; ++i)
            if (log().events()[i].kind == EventKind::Fault)
                seen.append(log().events()[i].text);
        return seen;
    };
    QSignalSpy told(&m_rig->workbench.eventRecorder(), &widgets::EventRecorder::stateChanged);
    const drive::LinkChanged closed{drive::LinkState::Closed, drive::LinkReason::None};
    const drive::LinkChanged connected{drive::LinkState::Connected, drive::LinkReason::None};
    facts::feed(m_rig->device(), {closed, connected});
    drive::MotorStatus status = facts::status(drive::MotorState::Running);
    status.faultsPast = {"UNDER_VOLT"}; // from before the connection
    status.at = TimePoint(1500ms);
    facts::feed(m_rig->device(), {status});
    QCOMPARE(faultsIn(1.4, 1.6), QStringList());
    status.state = drive::MotorState::FaultOver;
    status.faultsPast = {"UNDER_VOLT", "SPEED_FDBK"};
    status.at = TimePoint(2500ms);
    told.clear();
    facts::feed(m_rig->device(), {status});
    QCOMPARE(faultsIn(2.4, 2.6), QStringList{QStringLiteral("SPEED_FDBK")});
    QVERIFY(!told.empty()); // the trigger's
    QVERIFY(told[0][1].value<EventKind>() == EventKind::Fault);
    status.at = TimePoint(2700ms);
    facts::feed(m_rig->device(), {status}); // the same again is no event
    QCOMPARE(faultsIn(2.6, 2.8), QStringList());
    status.faultsNow = {"OVER_VOLT"};
    status.at = TimePoint(3000ms);
    facts::feed(m_rig->device(), {status});
    status.faultsNow = {}; // was told when it began
    status.faultsPast.push_back("OVER_VOLT");
    status.at = TimePoint(3100ms);
    facts::feed(m_rig->device(), {status});
    QCOMPARE(faultsIn(2.9, 3.2), QStringList{QStringLiteral("OVER_VOLT")});
}

/// Also when the board was never seen without it: it came back before the next reading.
void TestScopeEvents::theSameFaultIsNotedAgainWhenItWasAcknowledgedInBetween()
{
    const auto faults = [this] {
        return std::count_if(log().events().begin(), log().events().end(),
            [](const widgets::ScopeEvent &event) { return event.kind == EventKind::Fault; });
    };
    const auto read = [this](drive::MotorStatus status, std::chrono::milliseconds asked) {
        status.asked = TimePoint(asked);
        status.at = TimePoint(asked + 2ms);
        facts::feed(m_rig->device(), {status});
    };
    facts::feed(m_rig->device(),
        {drive::LinkChanged{drive::LinkState::Closed, drive::LinkReason::None},
            drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None}});
    read(facts::status(drive::MotorState::Idle), 1000ms);
    drive::MotorStatus over = facts::status(drive::MotorState::FaultOver);
    over.faultsPast = {"OVER_CURR"};
    read(over, 1100ms);
    QCOMPARE(faults(), 1);

    drive::MotionEntry acknowledged;
    acknowledged.act = drive::MotionAct::AcknowledgeFaults;
    acknowledged.motor = 1;
    acknowledged.ended = TimePoint(2000ms);
    acknowledged.outcome = drive::Outcome::Refused;
    facts::feed(m_rig->device(), {acknowledged});
    read(over, 2100ms);
    QCOMPARE(faults(), 1); // the board did not

    acknowledged.outcome = drive::Outcome::Ok;
    acknowledged.ended = TimePoint(3000ms);
    facts::feed(m_rig->device(), {acknowledged});
    read(over, 2999ms); // asked before
    read(over, 3001ms); // perhaps it had not forgotten yet
    QCOMPARE(faults(), 1);
    read(over, 3020ms);
    QCOMPARE(faults(), 2);
    read(over, 3120ms);
    QCOMPARE(faults(), 2); // once
}

void TestScopeEvents::lostSamplesAreNotedWhereTheyAreMissing()
{
    m_rig->lose(250);
    capture::SampleBlock block{1, m_rig->tick, 10, {}, {}, 250};
    block.fast.assign(20, 1);
    facts::feed(m_rig->device(), {block});
    const auto range = log().in(3.99, 4.01);
    QCOMPARE(range.last - range.first, std::size_t{1});
    const widgets::ScopeEvent &event = log().events()[range.first];
    QCOMPARE(event.seconds, 4.0);
    QVERIFY(event.kind == EventKind::Loss);
    QCOMPARE(event.text, QStringLiteral("250.0000\u2009ms of samples lost"));
}

void TestScopeEvents::soAreThoseOfABoardWithSlowSignalsOnly()
{
    facts::feed(m_rig->device(),
        {drive::StreamStarted{
            {2, 1000.0, 0.0, 1, {}, {{facts::kSpeed, "SPEED", "rpm", 1.0, 0.0}}}}});
    const auto block = [this](capture::Tick first, capture::Tick lost, int groups) {
        capture::SampleBlock one{2, first, 20, {}, {}, lost};
        for (int i = 0; i < groups; ++i, first += 5)
            one.slow.push_back({first + 4, {100 + i}});
        facts::feed(m_rig->device(), {one});
    };
    block(5000, 30, 4); // the first one: a beginning
    block(5020, 0, 4);
    QCOMPARE(log().in(4.5, 9.0).last - log().in(4.5, 9.0).first, std::size_t{0});
    block(5290, 250, 4);
    block(5400, 90, 0); // without a value, lost all the same
    const auto range = log().in(4.5, 9.0);
    QCOMPARE(range.last - range.first, std::size_t{2});
    QCOMPARE(log().events()[range.first].seconds, 5.04);
    QCOMPARE(log().events()[range.first].text, QStringLiteral("250.0000\u2009ms of samples lost"));
    QCOMPARE(log().events()[range.first + 1].seconds, 5.31);
}

void TestScopeEvents::aLinkThatGoesAndComesBackIsNoted()
{
    using drive::LinkReason;
    using drive::LinkState;
    const drive::MotorStatus idle = facts::status(drive::MotorState::Idle);
    facts::feed(m_rig->device(), {idle});
    m_before = lastId();
    facts::feed(m_rig->device(), {drive::LinkChanged{LinkState::Suspect, LinkReason::None}});
    facts::feed(m_rig->device(), {drive::LinkChanged{LinkState::Connected, LinkReason::None}});
    facts::feed(m_rig->device(), {idle}); // did not change
    QCOMPARE(noted().size(), 1); // a line that flickers does not bury what matters
    QVERIFY2(noted().first().startsWith(QStringLiteral("Loss board silent, for ")),
        qPrintable(noted().first()));
    facts::feed(
        m_rig->device(), {drive::LinkChanged{LinkState::Connected, LinkReason::BoardReset}});
    QVERIFY(noted().last().startsWith(QStringLiteral("Recovery ")));
    QCOMPARE(noted().size(), 2);
    facts::feed(m_rig->device(), {idle}); // of a board that began anew
    QCOMPARE(noted().size(), 3);
    facts::feed(m_rig->device(), {drive::LinkChanged{LinkState::Closed, LinkReason::None}});
    QCOMPARE(noted().size(), 3); // why is told next
    m_rig->device().portChanged(
        session::PortState::Closed, {session::PortProblem::Unplugged, QStringLiteral("gone")});
    QCOMPARE(noted().size(), 4);
    QVERIFY2(noted().last().startsWith(QStringLiteral("Loss ")), qPrintable(noted().last()));
}

void TestScopeEvents::aLossIsOneLineHoweverItGoesOn()
{
    using drive::LinkReason;
    using drive::LinkState;
    const auto link = [this](LinkState state, LinkReason reason = LinkReason::None) {
        facts::feed(m_rig->device(), {drive::LinkChanged{state, reason}});
    };
    m_before = lastId();
    link(LinkState::Recovering);
    QCOMPARE(noted(), QStringList{QStringLiteral("Loss recovering")});
    link(LinkState::Suspect);
    QCOMPARE(noted(), QStringList{QStringLiteral("Loss board silent")});
    link(LinkState::Recovering); // less than is known already
    QCOMPARE(noted(), QStringList{QStringLiteral("Loss board silent")});
    link(LinkState::Lost, LinkReason::Silence);
    QCOMPARE(noted(), QStringList{QStringLiteral("Loss link lost")});
    link(LinkState::Connecting);
    link(LinkState::Lost, LinkReason::Silence);
    QCOMPARE(noted(), QStringList{QStringLiteral("Loss link lost")});
    link(LinkState::Connected, LinkReason::BoardReset);
    QCOMPARE(noted().size(), 2);
    m_before = lastId();
    link(LinkState::Suspect); // the next one is one of its own
    m_rig->device().portChanged(
        session::PortState::Closed, {session::PortProblem::Unplugged, QStringLiteral("gone")});
    QCOMPARE(noted().size(), 1);
    QVERIFY2(noted().first().contains(QStringLiteral("unplugged")), qPrintable(noted().first()));
}

void TestScopeEvents::aStopIsNoted()
{
    m_rig->device().armedChanged(true);
    m_rig->device().stop();
    QCOMPARE(noted(),
        (QStringList{QStringLiteral("Command Armed"), QStringLiteral("Command Stop motors"),
            QStringLiteral("Command Disarmed")}));
}

void TestScopeEvents::mSetsAMarkerAtTheMouse()
{
    scope().setFocus();
    m_rig->moveMouse(m_rig->at(3.0));
    QTest::keyClick(&scope(), Qt::Key_M);
    auto range = log().in(2.99, 3.01);
    QCOMPARE(range.last - range.first, std::size_t{1});
    QCOMPARE(log().events()[range.first].text, QStringLiteral("Marker 1"));
    m_rig->mouseLeaves();
    scope().cursorActions().toggle();
    scope().cursors().move(widgets::CursorEnd::A, 1.25);
    scope().cursors().setActive(widgets::CursorEnd::A);
    QTest::keyClick(&scope(), Qt::Key_M);
    range = log().in(1.25, 1.25);
    QCOMPARE(log().events().at(range.first).text, QStringLiteral("Marker 2"));
}

void TestScopeEvents::aDoubleClickOnTheTimeAxisOrTheLaneSetsAMarker()
{
    const QRect area = scope().plotRect(scope().plotCount() - 1);
    const QPoint shift = m_rig->plot().mapTo(&scope(), QPoint(0, 0));
    const int x = qRound(scope().time().xOf(2.0));
    QTest::mouseDClick(
        &m_rig->plot(), Qt::LeftButton, {}, QPoint(x, area.bottom() + 10 - shift.y()));
    QCOMPARE(log().in(1.99, 2.01).last - log().in(1.99, 2.01).first, std::size_t{1});
    QTest::mouseDClick(&lane(), Qt::LeftButton, {}, QPoint(qRound(scope().time().xOf(3.5)), 5));
    QCOMPARE(log().in(3.49, 3.51).last - log().in(3.49, 3.51).first, std::size_t{1});
    // On the traces a double click is two clicks.
    QTest::mouseDClick(&m_rig->plot(), Qt::LeftButton, {}, m_rig->at(1.0));
    QCOMPARE(log().in(0.9, 1.1).last - log().in(0.9, 1.1).first, std::size_t{0});
}

void TestScopeEvents::closeEventsAreCounted()
{
    scope().setVisibleRange(100.0, 200.0);
    for (int i = 0; i < 5; ++i)
        log().add(EventKind::Write, 120.0 + i * 0.01, QStringLiteral("w%1").arg(i));
    log().add(EventKind::Fault, 120.03, QStringLiteral("bad"));
    log().add(EventKind::State, 180.0, QStringLiteral("RUN"));
    auto clusters = lane().clusters();
    QCOMPARE(clusters.size(), std::size_t{2});
    QCOMPARE(clusters[0].count(), std::size_t{6});
    QVERIFY(clusters[0].worst == EventKind::Fault); // the worst of them gives the sign
    QVERIFY(lane().textOf(clusters[0]).contains(QStringLiteral("bad")));
    QCOMPARE(lane().textOf(clusters[0]).count(QLatin1Char('\n')), 5);
    QCOMPARE(clusters[1].count(), std::size_t{1});
    scope().setVisibleRange(120.0, 120.05); // near enough, each is seen
    clusters = lane().clusters();
    QCOMPARE(clusters.size(), std::size_t{5}); // the fault shares its time with a write
    for (int i = 0; i < 40; ++i)
        log().add(EventKind::Write, 150.0, QStringLiteral("x"));
    scope().setVisibleRange(100.0, 200.0);
    QVERIFY(lane().textOf(lane().clusters()[1]).endsWith(QStringLiteral("and 28 more")));
}

void TestScopeEvents::theNameOfTheLaneIsNeverCut()
{
    QFont large = scope().font(); // a long word of another language is no different
    large.setPixelSize(30);
    scope().setFont(large);
    m_rig->draw();
    QVERIFY(lane().nameWidth() > 80);
    QVERIFY(scope().plotRect(0).left() >= lane().nameWidth());
}

void TestScopeEvents::arrowsGoFromEventToEvent()
{
    scope().setVisibleRange(100.0, 110.0);
    const quint32 first = log().add(EventKind::State, 101.0, QStringLiteral("one"));
    const quint32 second = log().add(EventKind::Marker, 190.0, QStringLiteral("two"));
    lane().setFocus();
    QTest::keyClick(&lane(), Qt::Key_Right);
    QCOMPARE(lane().selected(), first);
    QVERIFY(lane().accessibleDescription().contains(QStringLiteral("one")));
    QTest::keyClick(&lane(), Qt::Key_Right);
    QCOMPARE(lane().selected(), second);
    QVERIFY(scope().visibleRange().from < 190.0 && scope().visibleRange().to > 190.0);
    QTest::keyClick(&lane(), Qt::Key_Left);
    QCOMPARE(lane().selected(), first);
    QTest::keyClick(&lane(), Qt::Key_Delete); // what happened stays
    QVERIFY(log().find(first));
    QTest::keyClick(&lane(), Qt::Key_Right);
    QTest::keyClick(&lane(), Qt::Key_Delete);
    QVERIFY(!log().find(second));
}

void TestScopeEvents::theListJumpsEditsAndDeletes()
{
    const quint32 marker = log().add(EventKind::Marker, 50.0, QStringLiteral("here"));
    log().add(EventKind::State, 60.0, QStringLiteral("RUN"));
    QTreeView *list = openList();
    QVERIFY(list->isVisible());
    const int last = list->model()->rowCount() - 1;
    list->setCurrentIndex(list->model()->index(last, 0));
    QTest::keyClick(list, Qt::Key_Return);
    QVERIFY(scope().visibleRange().from < 60.0 && scope().visibleRange().to > 60.0);
    QTest::keyClick(list, Qt::Key_F2);
    QVERIFY(!list->findChild<QLineEdit *>()); // what happened is not rewritten
    list->setCurrentIndex(list->model()->index(last - 1, 0));
    QTest::keyClick(list, Qt::Key_F2);
    auto *editor = list->findChild<QLineEdit *>();
    QVERIFY(editor);
    editor->selectAll();
    QTest::keyClicks(editor, QStringLiteral("load on"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(log().find(marker)->text, QStringLiteral("load on"));
    list->setCurrentIndex(list->model()->index(last - 1, 0));
    QTest::keyClick(list, Qt::Key_Delete);
    QVERIFY(!log().find(marker));
    QCOMPARE(list->model()->rowCount(), last);
}

void TestScopeEvents::theListShowsMarkersOnlyAndCopies()
{
    log().add(EventKind::Marker, 50.0, QStringLiteral("here"));
    log().add(EventKind::Marker, 51.5, QStringLiteral("there"));
    QTreeView *list = openList();
    QVERIFY(list->model()->rowCount() > 2);
    const auto *remove = m_rig->find<QWidget>("deleteMarker");
    for (int row = 0; row < list->model()->rowCount(); ++row) {
        const QModelIndex event = list->model()->index(row, 0);
        list->setCurrentIndex(event);
        QCOMPARE(
            remove->isEnabled(), event.data(EventLog::KindRole).toInt() == int(EventKind::Marker));
    }
    m_rig->find<QCheckBox>("onlyMarkers")->setChecked(true);
    QVERIFY(!remove->isEnabled()); // none is chosen any more
    list->setCurrentIndex(list->model()->index(0, 0));
    QVERIFY(remove->isEnabled());
    list->clearSelection();
    QVERIFY(!remove->isEnabled());
    QCOMPARE(list->model()->rowCount(), 2);
    QTest::mouseClick(m_rig->find<QWidget>("copyEvents"), Qt::LeftButton);
    QCOMPARE(QApplication::clipboard()->text(),
        QStringLiteral("50.0000\u2009s\tMarker\there\n51.5000\u2009s\tMarker\tthere\n"));
    scope().time().setOrigin(50.0);
    QCOMPARE(list->model()->index(1, 0).data().toString(), QStringLiteral("1.5000\u2009s"));
}

void TestScopeEvents::aMarkersLineIsDrawn()
{
    const QImage without = m_rig->plot().grab().toImage();
    log().add(EventKind::Marker, 2.0, QStringLiteral("here"));
    const QImage with = m_rig->plot().grab().toImage();
    const int x = m_rig->at(2.0).x();
    int rows = 0;
    for (int y = 0; y < with.height(); ++y)
        rows += with.pixel(x, y) != without.pixel(x, y) ? 1 : 0;
    QVERIFY(rows > scope().plotRect(0).height() / 3);
}

void TestScopeEvents::clearingKeepsNotes()
{
    const quint32 marker = log().add(EventKind::Marker, 2.0, QStringLiteral("keep"));
    m_rig->workbench.signalPlan().clear();
    scope().time().zoom(10.0);
    QVERIFY(log().find(marker));
    QCOMPARE(log().find(marker)->seconds, 2.0);
}

void TestScopeEvents::theLogIsAModelInOrder()
{
    EventLog log;
    QAbstractItemModelTester tester(&log, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(log.add(EventKind::State, std::nan(""), QString()), 0U);
    const quint32 marker = log.add(EventKind::Marker, 3.0, QStringLiteral("m"));
    log.add(EventKind::State, 1.0, QStringLiteral("late"));
    QCOMPARE(log.events().front().text, QStringLiteral("late"));
    QVERIFY(!log.removeMarker(log.events().front().id));
    QVERIFY(log.removeMarker(marker));
}

void TestScopeEvents::theLogForgetsButNeverANote()
{
    EventLog log;
    const quint32 kept = log.add(EventKind::Marker, 0.5, QStringLiteral("kept"));
    for (std::size_t i = 0; i <= EventLog::kMost; ++i)
        log.add(EventKind::State, 10.0 + double(i), QStringLiteral("s"));
    QVERIFY(log.events().size() <= EventLog::kMost);
    QVERIFY(log.find(kept)); // a note outlives what the program noted
    QVERIFY(log.events()[1].seconds > 10.0);
    const auto range = log.in(20.0, 5000.0);
    QVERIFY(log.events()[range.first].seconds >= 20.0);
    QVERIFY(log.events()[range.last - 1].seconds <= 5000.0);
}

void TestScopeEvents::manyAtOnceAreShownAtOnce()
{
    QTreeView *list = openList();
    const QSignalSpy scrolls(list->verticalScrollBar(), &QScrollBar::valueChanged);
    QCoreApplication::processEvents();
    for (const bool seen : {true, false}) {
        m_rig->find<QWidget>("eventDock")->setVisible(seen);
        QCoreApplication::processEvents();
        const qsizetype before = scrolls.size();
        for (int i = 0; i < 5000; ++i)
            log().add(EventKind::State, 4.0 + i * 1e-4, QStringLiteral("RUN"));
        QCOMPARE(scrolls.size(), before); // each would look at all rows there are
        QCoreApplication::processEvents();
        QCOMPARE(scrolls.size() > before, seen);
    }
    m_rig->find<QWidget>("eventDock")->show();
    QTRY_COMPARE(list->verticalScrollBar()->value(), list->verticalScrollBar()->maximum());
    QVERIFY(list->model() == &log()); // nothing that looks at every row stands between
    m_rig->find<QCheckBox>("onlyMarkers")->setChecked(true);
    QCOMPARE(list->model()->rowCount(), 0);
}

void TestScopeEvents::whatComesTogetherIsPaintedTogether()
{
    struct Paints : QObject {
        bool eventFilter(QObject *, QEvent *event) override
        {
            count += event->type() == QEvent::Paint ? 1 : 0;
            return false;
        }
        int count = 0;
    };
    QTreeView *list = openList();
    QTRY_VERIFY(list->updatesEnabled());
    QCoreApplication::processEvents();
    Paints paints;
    list->viewport()->installEventFilter(&paints);
    for (int round = 0; round < 2; ++round) {
        log().add(EventKind::State, 4.0 + round, QStringLiteral("RUN"));
        QVERIFY(!list->updatesEnabled());
        log().add(EventKind::State, 4.5 + round, QStringLiteral("IDLE"));
        const int before = paints.count;
        QTRY_VERIFY(list->updatesEnabled() && paints.count > before);
        const QModelIndex last = log().index(log().rowCount() - 1, EventLog::TextColumn);
        QVERIFY(list->viewport()->rect().intersects(list->visualRect(last)));
    }
}

void TestScopeEvents::aFileFillsTheLogInOneStep()
{
    session::RecordingReport report;
    constexpr int kHappenings = 20'000;
    for (int i = 0; i < kHappenings; ++i)
        report.happenings.push_back({capture::toNanos(1.0 + i * 1e-3),
            {"motor state", {{"motor", "1"}, {"state", i % 2 == 0 ? "idle" : "running"}}}});
    report.notes.push_back({capture::toNanos(0.5), capture::toNanos(0.5), "first of all"});
    QSignalSpy inserted(&log(), &QAbstractItemModel::rowsInserted);
    QSignalSpy reset(&log(), &QAbstractItemModel::modelReset);
    widgets::fillEvents(log(), report);
    QCOMPARE(inserted.size(), 0);
    QCOMPARE(reset.size(), 1);
    QCOMPARE(log().events().size(), EventLog::kMost);
    QCOMPARE(log().events().front().text, QStringLiteral("first of all")); // a marker is kept
    QVERIFY(std::abs(log().events().back().seconds - (1.0 + (kHappenings - 1) * 1e-3)) < 1e-9);
    QVERIFY(std::is_sorted(log().events().begin(), log().events().end(),
        [](const auto &a, const auto &b) { return a.seconds < b.seconds; }));
    QVERIFY(log().find(log().events().back().id) == &log().events().back());
}

void TestScopeEvents::everyKindHasAShapeOfItsOwn()
{
    const auto shapeOf = [](EventKind kind) { // without its colour
        const QImage image = widgets::eventIcon(kind, QPalette()).pixmap(32).toImage();
        QByteArray shape;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                shape.append(qAlpha(image.pixel(x, y)) > 128 ? '#' : '.');
        }
        return shape;
    };
    QSet<QByteArray> shapes;
    for (int kind = 0; kind <= int(EventKind::Fault); ++kind)
        shapes.insert(shapeOf(static_cast<EventKind>(kind)));
    QCOMPARE(shapes.size(), int(EventKind::Fault) + 1);
}

void TestScopeEvents::theClockOfTheSessionIsFoundFromStamps()
{
    widgets::SessionClock clock;
    QCOMPARE(clock.secondsAt(1000ms), 1.0);
    clock.stamped(TimePoint(900ms), 1000ms); // 100 ms under way
    clock.stamped(TimePoint(1190ms), 1200ms); // 10 ms
    clock.stamped(TimePoint(1200ms), 1300ms); // late again: tells nothing new
    QVERIFY(std::abs(clock.secondsAt(2000ms) - 1.99) < 1e-9);
    clock.stamped(TimePoint(0ms), 5000ms); // another session's clock
    QVERIFY(std::abs(clock.secondsAt(6000ms) - 1.0) < 1e-9);
}

void TestScopeEvents::eventsGoWithTheSamplesOfABoardWhoseClockDrifts()
{
    widgets::Device device;
    capture::Capture capture;
    EventLog log;
    widgets::Milliseconds now{0};
    widgets::EventRecorder recorder(device, capture, log, [&now] { return now; });
    facts::connectBoard(device);
    const capture::StreamLayout layout = facts::ScopeWindow::layout();
    capture.begin(layout);
    facts::feed(device, {drive::StreamStarted{layout}});
    capture::Tick tick = 0;
    const auto at = [&now] { return TimePoint(std::chrono::duration_cast<Duration>(now)); };
    for (int tenth = 0; tenth < 600; ++tenth) { // a minute of a board that counts 1 % too fast
        now += 100ms;
        drive::MotorStatus status = facts::status(drive::MotorState::Running);
        status.at = at();
        facts::feed(device, {status});
        capture::SampleBlock block{1, tick, 101, {}, {}, 0};
        block.fast.assign(std::size_t{2} * block.count, 1);
        tick += block.count;
        capture.append(block);
        recorder.stored(block);
    }
    drive::MotorStatus fault = facts::status(drive::MotorState::FaultNow);
    fault.faultsNow = {"OVER_VOLT"};
    fault.at = at();
    QSignalSpy faulted(&recorder, &widgets::EventRecorder::faulted);
    facts::feed(device, {fault});
    QCOMPARE(faulted.size(), 1);
    const double seconds = faulted.first().first().toDouble(), sampled = double(tick) * 1e-3;
    QVERIFY2(std::abs(seconds - sampled) < 0.15, qPrintable(QString::number(seconds)));
    QVERIFY(std::abs(recorder.samplesNow() - sampled) < 0.15);
}

QTEST_MAIN(TestScopeEvents)
#include "tst_scope_events.moc"
