// Leaving without a window: what is stopped, asked and told before a connection is left. The clock and the answers are
// the test's; tst_leaving has the same through the real window.
#include "support/answered_questions.h"
#include "support/window_facts.h"
#include "widgets/lab/experiments.h"
#include "widgets/window/leaving.h"

#include <QSignalSpy>
#include <QtTest>

using namespace std::chrono_literals;
using drive::MotorState;

class TestLeavingFlow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_now = TimePoint{} + 1h;
        m_left = 0;
        m_questions.open.clear();
        m_device = std::make_unique<widgets::Device>();
        m_leaving = std::make_unique<widgets::Leaving>(
            *m_device, [this] { return m_now; }, m_questions);
        m_stops = std::make_unique<QSignalSpy>(m_device.get(), &widgets::Device::stopWished);
        m_said = std::make_unique<QSignalSpy>(m_leaving.get(), &widgets::Leaving::said);
        facts::connectBoard(*m_device);
        tell(MotorState::Idle);
    }
    void cleanup()
    {
        m_said.reset();
        m_stops.reset();
        m_leaving.reset();
        m_device.reset();
    }

    void noWidgetIsNeeded() { QVERIFY(!QCoreApplication::instance()->inherits("QGuiApplication")); }

    void whatOnlyLookedOnIsLeftAtOnce()
    {
        m_now += 1h;
        leave();
        QCOMPARE(m_left, 1);
        QCOMPARE(m_stops->size(), 0);
        QCOMPARE(m_said->size(), 0);
        QVERIFY(m_questions.open.empty());
    }

    void aMotorIsStoppedFirst()
    {
        tell(MotorState::Running);
        leave();
        QCOMPARE(m_left, 0);
        QCOMPARE(m_stops->size(), 1);
        QCOMPARE(m_said->size(), 1);
        QCOMPARE(m_said->front().front().toString(), QStringLiteral("stopping"));
        QVERIFY(m_leaving->underWay());
        m_now += 1s;
        tell(MotorState::Stopping);
        QCOMPARE(m_left, 0);
        tell(MotorState::Idle);
        QCOMPARE(m_left, 1);
        QVERIFY(!m_leaving->underWay());
        QVERIFY(m_questions.open.empty());
    }

    /// Also where the motor rests: it may be about to be started. Its word may be later than the motor's.
    void anExperimentIsEndedFirstAndWhatItLeavesIsShown()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        experiments.begin({{}}, 0.0);
        m_now += 1s;
        tell(MotorState::Idle);
        leave();
        QCOMPARE(m_stops->size(), 1);
        m_now += 1s;
        tell(MotorState::Idle);
        QCOMPARE(m_left, 0);
        experiments.end({.end = lab::End::Interrupted,
            .reason = "every motor was stopped; REVUP_DATA may hold what the experiment wrote",
            .leaves = true});
        QCOMPARE(m_left, 0);
        QVERIFY(m_questions.asks("leftBehindQuestion"));
        QVERIFY(m_questions.open.back().more.contains(QStringLiteral("REVUP_DATA")));
        QCOMPARE(m_questions.usual(), QStringLiteral("Stay"));
        QVERIFY(m_questions.answer(QStringLiteral("Leave it so")));
        QCOMPARE(m_left, 1);
    }

    void anExperimentThatLeavesNothingIsNoQuestion()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        experiments.begin({{}}, 0.0);
        tell(MotorState::Running);
        leave();
        experiments.end({.end = lab::End::Interrupted, .reason = "every motor was stopped"});
        QCOMPARE(m_left, 0);
        m_now += 1s;
        tell(MotorState::Idle);
        QCOMPARE(m_left, 1);
        QVERIFY(m_questions.open.empty());
    }

    void whoClosesTwiceIsShownItAllTheSame()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        experiments.begin({{}}, 0.0);
        tell(MotorState::Running);
        leave();
        experiments.end({.end = lab::End::Interrupted, .reason = "left", .leaves = true});
        leave();
        m_now += 1s;
        tell(MotorState::Idle);
        QCOMPARE(m_left, 0);
        QVERIFY(m_questions.asks("leftBehindQuestion"));
    }

    /// As a torque, say, which nothing would bound then: it is no motor that is meant to turn on.
    void anExperimentIsNotLeftRunningByDisconnecting()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        experiments.begin({{}}, 0.0);
        tell(MotorState::Running);
        m_leaving->beforeDisconnecting([this] { ++m_left; });
        QVERIFY(m_questions.open.empty());
        QCOMPARE(m_stops->size(), 1);
        experiments.end({.end = lab::End::Interrupted, .reason = "left", .leaves = true});
        m_now += 1s;
        tell(MotorState::Idle);
        QVERIFY(m_questions.asks("leftBehindQuestion"));
        QVERIFY(m_questions.answer(QStringLiteral("Leave it so")));
        QCOMPARE(m_left, 1);
    }

    /// A tour goes on while a question waits: where its motor rests for a moment, that is no answer.
    void anExperimentThatRestsIsNoAnswer()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        tell(MotorState::Running);
        m_leaving->beforeDisconnecting([this] { ++m_left; });
        experiments.begin({{}}, 0.0);
        m_now += 1s;
        tell(MotorState::Idle);
        QVERIFY(m_questions.asks("notIdleQuestion"));
        QCOMPARE(m_left, 0);
        QVERIFY(m_questions.answer(QStringLiteral("Leave running")));
        QCOMPARE(m_left, 0);
        QCOMPARE(m_stops->size(), 1);
        m_now += 1s;
        tell(MotorState::Idle);
        experiments.end({.end = lab::End::Interrupted, .reason = "every motor was stopped"});
        QCOMPARE(m_left, 1);
    }

    void whoStayedIsNotShownLaterWhatWasLeftThen()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        experiments.begin({{}}, 0.0);
        notConfirmed();
        experiments.end({.end = lab::End::Lost, .reason = "left", .leaves = true});
        QVERIFY(m_questions.answer(QStringLiteral("Stay")));
        connectAgain();
        m_now += 1s;
        tell(MotorState::Running);
        leave();
        m_now += 1s;
        tell(MotorState::Idle);
        QVERIFY(m_questions.open.empty());
        QCOMPARE(m_left, 1);
    }
    void whoTriesAgainIsShownIt()
    {
        widgets::Experiments experiments(
            *m_device, std::make_shared<session::RecordingTap>(), [this] { return m_now; });
        m_leaving->watch(experiments);
        experiments.begin({{}}, 0.0);
        notConfirmed();
        experiments.end({.end = lab::End::Lost, .reason = "left", .leaves = true});
        QVERIFY(m_questions.answer(QStringLiteral("Try again")));
        QTRY_VERIFY(m_questions.asks("leaveQuestion"));
        connectAgain();
        m_now += 1s;
        tell(MotorState::Idle);
        QVERIFY(m_questions.asks("leftBehindQuestion"));
        QCOMPARE(m_left, 0);
    }

    void withoutEvidenceAPersonIsAskedTwice()
    {
        notConfirmed();
        QCOMPARE(m_questions.usual(), QStringLiteral("Try again"));
        QVERIFY(m_questions.answer(QStringLiteral("go all the same")));
        QCOMPARE(m_left, 0);
        QVERIFY(m_questions.asks("leaveRunning"));
        QCOMPARE(m_questions.usual(), QStringLiteral("Stay"));
        QVERIFY(m_questions.answer(QStringLiteral("Leave running")));
        QCOMPARE(m_left, 1);
        leave(); // the word holds until the next arming
        QCOMPARE(m_left, 2);
        m_device->armedChanged(true);
        leave();
        QCOMPARE(m_left, 2);
    }

    void whoStaysLeavesNothing()
    {
        notConfirmed();
        QVERIFY(m_questions.answer(QStringLiteral("Stay")));
        QVERIFY(m_questions.open.empty());
        notConfirmed();
        QVERIFY(m_questions.answer(QStringLiteral("go all the same")));
        QVERIFY(m_questions.answer(QStringLiteral("Stay")));
        QCOMPARE(m_left, 0);
        QVERIFY(m_leaving->mayTurn());
    }

    void anotherTryStopsAgain()
    {
        notConfirmed();
        m_stops->clear();
        QVERIFY(m_questions.answer(QStringLiteral("Try again")));
        QCOMPARE(m_stops->size(), 1);
        QTRY_VERIFY(m_questions.asks("leaveQuestion"));
        QCOMPARE(m_left, 0);
    }

    /// "A motor may still be turning" is not so any more where the board came back and says that it stands.
    void aQuestionEndsWhereTheMotorIsSeenAtRest()
    {
        notConfirmed();
        connectAgain();
        m_now += 1s;
        tell(MotorState::Stopping);
        QVERIFY(m_questions.asks("leaveQuestion"));
        QCOMPARE(m_left, 0);
        tell(MotorState::Idle);
        QVERIFY(m_questions.open.empty());
        QCOMPARE(m_left, 1);
        tell(MotorState::Idle);
        QCOMPARE(m_left, 1); // once
    }
    void theSecondQuestionEndsThenToo()
    {
        notConfirmed();
        QVERIFY(m_questions.answer(QStringLiteral("go all the same")));
        connectAgain();
        m_now += 1s;
        tell(MotorState::Idle);
        QVERIFY(m_questions.open.empty());
        QCOMPARE(m_left, 1);
    }
    void whoStayedIsNotMadeToLeaveLater()
    {
        notConfirmed();
        QVERIFY(m_questions.answer(QStringLiteral("Stay")));
        connectAgain();
        m_now += 1s;
        tell(MotorState::Idle);
        QCOMPARE(m_left, 0);
    }
    void aMotorThatCameToRestIsNotAskedAbout()
    {
        tell(MotorState::Running);
        m_leaving->beforeDisconnecting([this] { ++m_left; });
        QVERIFY(m_questions.asks("notIdleQuestion"));
        m_now += 1s;
        tell(MotorState::Idle);
        QVERIFY(m_questions.open.empty());
        QCOMPARE(m_left, 1);
        QCOMPARE(m_stops->size(), 0);
    }

    void whatIsToldDependsOnThePort()
    {
        notConfirmed();
        QVERIFY(m_questions.open.back().more.startsWith(
            QStringLiteral("No port is open that could carry a stop.")));
    }

    /// Enter, Esc and closing the box are safe in every question.
    void noQuestionIsLeftByEnterOrEsc()
    {
        notConfirmed();
        checkSafe();
        QVERIFY(m_questions.answer(QStringLiteral("go all the same")));
        checkSafe();
        QVERIFY(m_questions.answer(QStringLiteral("Stay")));
        connectAgain();
        tell(MotorState::Running);
        m_leaving->beforeDisconnecting([this] { ++m_left; });
        checkSafe();
    }

    void aMotorThatIsSeenToTurnIsAskedAboutBeforeItIsStopped()
    {
        tell(MotorState::Running);
        m_leaving->beforeDisconnecting([this] { ++m_left; });
        QVERIFY(m_questions.asks("notIdleQuestion"));
        QCOMPARE(m_questions.usual(), QStringLiteral("Stay connected"));
        QCOMPARE(m_stops->size(), 0);
        QVERIFY(m_questions.answer(QStringLiteral("Leave running")));
        QCOMPARE(m_left, 1);
        QCOMPARE(m_stops->size(), 0);

        m_leaving->beforeDisconnecting([this] { ++m_left; });
        QVERIFY(m_questions.answer(QStringLiteral("Stop motors, then disconnect")));
        QCOMPARE(m_left, 1);
        QCOMPARE(m_stops->size(), 1);
        m_now += 1s;
        tell(MotorState::Idle);
        QCOMPARE(m_left, 2);
    }

    void aMotorOfABoardThatIsSilentIsStoppedWithoutAQuestion()
    {
        tell(MotorState::Running);
        facts::feed(
            *m_device, {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::Silence}});
        m_leaving->beforeDisconnecting([this] { ++m_left; });
        QVERIFY(!m_questions.asks("notIdleQuestion"));
        QCOMPARE(m_stops->size(), 1);
        QCOMPARE(m_left, 0);
    }

    /// What goes on after one is left may leave again: closing asks for the markers then, and closes.
    void whatGoesOnMayLeaveAgain()
    {
        tell(MotorState::Running);
        m_leaving->before({QStringLiteral("stopping"), QStringLiteral("go all the same"),
            [this, kept = QString(100, QLatin1Char('x'))] {
                m_leaving->before({{}, {}, [this] { ++m_left; }});
                m_left += kept.size() == 100 ? 1 : 0;
            }});
        m_now += 1s;
        tell(MotorState::Idle);
        QCOMPARE(m_left, 2);
    }

private:
    void tell(MotorState state)
    {
        drive::MotorStatus status = facts::status(state);
        status.motor = 1;
        status.at = m_now;
        facts::feed(*m_device, {status});
    }
    void leave()
    {
        m_leaving->before(
            {QStringLiteral("stopping"), QStringLiteral("go all the same"), [this] { ++m_left; }});
    }
    void connectAgain()
    {
        m_device->portChanged(session::PortState::Open, {});
        facts::feed(
            *m_device, {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None}});
    }
    /// A motor turned, and there is no port that could carry a stop.
    void notConfirmed()
    {
        tell(MotorState::Running);
        m_device->portChanged(
            session::PortState::Closed, {session::PortProblem::Other, QStringLiteral("broken")});
        leave();
        QTRY_VERIFY(m_questions.asks("leaveQuestion"));
        QCOMPARE(m_left, 0);
    }
    void checkSafe()
    {
        using Kind = widgets::Answer::Kind;
        const widgets::Question &question = m_questions.open.back();
        const auto stays = std::count_if(question.answers.begin(), question.answers.end(),
            [](const widgets::Answer &answer) { return answer.kind == Kind::Stay; });
        QCOMPARE(stays, 1); // Esc
        QVERIFY(question.answers[question.usual].kind != Kind::Force);
        QVERIFY(question.answers[question.usual].kind != Kind::Lose);
    }

    TimePoint m_now;
    int m_left = 0;
    facts::AnsweredQuestions m_questions;
    std::unique_ptr<widgets::Device> m_device;
    std::unique_ptr<widgets::Leaving> m_leaving;
    std::unique_ptr<QSignalSpy> m_stops, m_said;
};

QTEST_GUILESS_MAIN(TestLeavingFlow)
#include "tst_leaving_flow.moc"
