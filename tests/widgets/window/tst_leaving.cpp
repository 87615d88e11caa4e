// A connection is not left while a motor may turn: closing the window, disconnecting and opening something else need
// fresh evidence of rest, or a connection that never armed and never saw a motor driven; else the motors are stopped
// and the user is asked. The clock of the device is the test's.
#include "support/window_rig.h"
#include "widgets/window/connect_bar.h"

#include <QAction>
#include <QMessageBox>
#include <QPointer>
#include <QSignalSpy>

using namespace std::chrono_literals;
using drive::MotorState;

class TestLeaving : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        m_now = TimePoint{} + 1h;
        m_rig->workbench.setSessionClock([this] { return m_now; });
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        facts::connectBoard(device());
        tell(MotorState::Idle);
        m_stops = std::make_unique<QSignalSpy>(&device(), &widgets::Device::stopWished);
        m_closes = std::make_unique<QSignalSpy>(&device(), &widgets::Device::closeWished);
    }
    void cleanup()
    {
        m_stops.reset();
        m_closes.reset();
        m_rig.reset();
    }

    void aConnectionThatOnlyLookedOnIsLeftAtOnce()
    {
        m_now += 1h; // the idle state is as old as that
        lose();
        QVERIFY(m_rig->window.close());
        QCOMPARE(m_stops->size(), 0);
    }

    void aStartWhoseAnswerWasLostIsNotLeftBehind()
    {
        start();
        lose(); // with the answer; the last state that was told is Idle
        m_now += 1s;
        QVERIFY(!m_rig->window.close());
        QCOMPARE(m_stops->size(), 1);
        QTRY_VERIFY(question("leaveQuestion"));
        QVERIFY(m_rig->window.isVisible());
        QCOMPARE(m_closes->size(), 0);
        press("leaveQuestion", QMessageBox::DestructiveRole);
        QVERIFY(m_rig->window.isVisible());
        press("leaveRunning", QMessageBox::DestructiveRole);
        QTRY_VERIFY(!m_rig->window.isVisible());
    }

    void disconnectingAsksTheSame()
    {
        start();
        lose();
        m_now += 1s;
        m_rig->window.connectBar()->connectOrDisconnect();
        QCOMPARE(m_closes->size(), 0);
        QCOMPARE(m_stops->size(), 1);
        QTRY_VERIFY(question("leaveQuestion"));
        press("leaveQuestion", QMessageBox::RejectRole); // stays
        QCOMPARE(m_closes->size(), 0);
        QVERIFY(device().portOpen());
    }

    void anIdleStateThatIsOldIsNoEvidence()
    {
        armed();
        m_now += 500ms;
        m_rig->window.connectBar()->connectOrDisconnect();
        QCOMPARE(m_closes->size(), 0);
        QCOMPARE(m_stops->size(), 1);
        tell(MotorState::Idle);
        QTRY_COMPARE(m_closes->size(), 1);
        QVERIFY(!question("leaveQuestion"));
    }

    void aFreshIdleStateIs()
    {
        armed();
        m_now += 499ms;
        QVERIFY(m_rig->window.close());
        QCOMPARE(m_stops->size(), 0);
    }

    void anIdleStateFromBeforeTheEndOfWhatWasAskedForIsNone()
    {
        armed();
        const drive::WishId start = device().submit(drive::Command{drive::MotorAction::Start, 1});
        facts::feed(device(),
            {status(MotorState::Idle), drive::Ended{start, drive::Outcome::Unknown, {}, {}}});
        QVERIFY(!m_rig->window.close());
        QCOMPARE(m_stops->size(), 1);
        tell(MotorState::Idle);
        QTRY_VERIFY(!m_rig->window.isVisible());
    }

    void everyMotorHasToBeSeenAtRest()
    {
        drive::Identified two = facts::identified();
        two.identity.motors = 2;
        facts::feed(device(), {two, status(MotorState::Idle)});
        QVERIFY(!m_rig->window.close()); // nothing was heard of the second one
        tell(MotorState::Idle, 2);
        QTRY_VERIFY(!m_rig->window.isVisible());
    }

    void aMotorThatIsLeftRunningIsAskedAboutOnce()
    {
        tell(MotorState::Running);
        m_rig->window.connectBar()->connectOrDisconnect();
        QCOMPARE(m_stops->size(), 0); // it is seen, and may be meant to turn
        press("notIdleQuestion", QMessageBox::DestructiveRole);
        QCOMPARE(m_closes->size(), 1);
        tell(MotorState::Running); // on its way already
        device().portChanged(session::PortState::Closed, {});
        QVERIFY(m_rig->window.close());
        QCOMPARE(m_stops->size(), 0);
    }

    void whatIsArmedAfterAChoiceToLeaveIsAskedAboutAnew()
    {
        tell(MotorState::Running);
        m_rig->window.connectBar()->connectOrDisconnect();
        press("notIdleQuestion", QMessageBox::DestructiveRole);
        device().armedChanged(true); // by whatever way
        QVERIFY(!m_rig->window.close());
        QCOMPARE(m_stops->size(), 1);
    }

    void withoutAPortThePersonIsToldThatNoStopCanLeave()
    {
        tell(MotorState::Running);
        device().portChanged(
            session::PortState::Closed, {session::PortProblem::Unplugged, QStringLiteral("gone")});
        QVERIFY(!m_rig->window.close());
        QTRY_VERIFY(question("leaveQuestion"));
        QVERIFY(question("leaveQuestion")
                    ->informativeText()
                    .startsWith(QStringLiteral("No port is open that could carry a stop.")));
        QVERIFY(m_rig->window.isVisible());
    }

    void anotherPortOrARecordingIsNotOpenedOverIt_data()
    {
        QTest::addColumn<QString>("action");
        for (const char *action : {"openRecording", "replayRecording", "importCsv", ""})
            QTest::newRow(action) << QString::fromLatin1(action);
    }
    void anotherPortOrARecordingIsNotOpenedOverIt()
    {
        QFETCH(const QString, action);
        tell(MotorState::Running);
        device().portChanged(
            session::PortState::Closed, {session::PortProblem::Other, QStringLiteral("broken")});
        QSignalSpy opens(&device(), &widgets::Device::openWished);
        if (action.isEmpty())
            m_rig->window.connectBar()->openSimulator();
        else
            m_rig->window.findChild<QAction *>(action)->trigger();
        QTRY_VERIFY(question("leaveQuestion"));
        QCOMPARE(opens.size(), 0);
        if (!action.isEmpty())
            return;
        press("leaveQuestion", QMessageBox::DestructiveRole);
        press("leaveRunning", QMessageBox::DestructiveRole);
        QTRY_COMPARE(opens.size(), 1);
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }

    drive::MotorStatus status(MotorState state, int motor = 1) const
    {
        drive::MotorStatus status = facts::status(state);
        status.motor = motor;
        status.at = m_now;
        return status;
    }
    void tell(MotorState state, int motor = 1) { facts::feed(device(), {status(state, motor)}); }
    void armed()
    {
        device().armedChanged(true);
        tell(MotorState::Idle);
    }
    void start()
    {
        armed();
        device().submit(drive::Command{drive::MotorAction::Start, 1});
    }
    void lose()
    {
        facts::feed(
            device(), {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::Silence}});
    }
    QMessageBox *question(const char *name) const
    {
        auto *box = m_rig->find<QMessageBox>(name);
        return box && box->isVisible() ? box : nullptr;
    }
    void press(const char *name, QMessageBox::ButtonRole role)
    {
        QMessageBox *box = question(name);
        QVERIFY(box);
        for (QAbstractButton *button : box->buttons())
            if (box->buttonRole(button) == role) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
    }

    TimePoint m_now;
    std::unique_ptr<facts::WindowRig> m_rig;
    std::unique_ptr<QSignalSpy> m_stops, m_closes;
};

QTEST_MAIN(TestLeaving)
#include "tst_leaving.moc"
