// What goes before a connection is left, without a window: what counts as a motor that may turn, and what ends the wait
// for the evidence. The clock is the test's; nothing waits for the two seconds.
#include "support/window_facts.h"
#include "widgets/window/shutdown.h"

#include <QSignalSpy>
#include <QTest>

using namespace std::chrono_literals;
using drive::MotorState;
using widgets::Device;
using widgets::Shutdown;

class TestShutdown : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_device = std::make_unique<Device>();
        m_shutdown = std::make_unique<Shutdown>(*m_device, [this] { return m_now; });
        m_confirmed = std::make_unique<QSignalSpy>(m_shutdown.get(), &Shutdown::confirmed);
        m_notConfirmed = std::make_unique<QSignalSpy>(m_shutdown.get(), &Shutdown::notConfirmed);
        m_stops = std::make_unique<QSignalSpy>(m_device.get(), &Device::stopWished);
    }

    void cleanup()
    {
        m_shutdown.reset();
        m_device.reset();
    }

    void whatWasNeverArmedTurnsNothing()
    {
        QVERIFY(!m_shutdown->mayTurn()); // no port, no board
        m_device->portChanged(session::PortState::Open, {});
        m_device->setArmed(false);
        QVERIFY(!m_shutdown->mayTurn());
        link(drive::LinkState::Connected);
        facts::feed(*m_device, {facts::identified()});
        tell(MotorState::Idle);
        m_now += 1h;
        QVERIFY(!m_shutdown->mayTurn());
    }

    /// As it is asked for, as the session says it, as the board shows it.
    void eachWayToBeArmedCounts()
    {
        facts::connectBoard(*m_device);
        tell(MotorState::Idle);
        m_device->setArmed(true);
        m_now += 1s; // the state is old
        QVERIFY(m_shutdown->mayTurn());
        m_device->open({});
        QVERIFY(!m_shutdown->mayTurn()); // another connection
        m_device->armedChanged(true); // of one motor, of which nothing was heard
        QVERIFY(m_shutdown->mayTurn());
        m_device->close();
        QVERIFY(!m_shutdown->mayTurn()); // the user was asked before
        m_device->open({});
        tell(MotorState::Running);
        QVERIFY(m_shutdown->mayTurn());
        m_shutdown->leaveAsTheyAre();
        QVERIFY(!m_shutdown->mayTurn());
    }

    void aBoardThatDoesNotSayWhatItIsHasOneMotor()
    {
        m_device->portChanged(session::PortState::Open, {});
        link(drive::LinkState::Connected);
        m_device->setArmed(true);
        tell(MotorState::Idle);
        QVERIFY(!m_shutdown->mayTurn());
        m_now += 1s;
        QVERIFY(m_shutdown->mayTurn());
    }

    void whatIsUnderWayMayMoveIt()
    {
        facts::connectBoard(*m_device);
        m_device->setArmed(true);
        const auto start = m_device->submit(drive::Command{drive::MotorAction::Start, 1});
        tell(MotorState::Idle);
        QVERIFY(m_shutdown->mayTurn());
        facts::feed(*m_device, {drive::Ended{start, drive::Outcome::Ok, {}, {}}});
        QVERIFY(m_shutdown->mayTurn()); // the state is older than the end
        tell(MotorState::Idle);
        QVERIFY(!m_shutdown->mayTurn());
    }

    /// A board that was found running is no less in motion for what it has not told yet.
    void aBoardThatAnswersAndHasNotToldMayTurn()
    {
        m_device->portChanged(session::PortState::Open, {});
        link(drive::LinkState::Connected);
        QVERIFY(m_shutdown->mayTurn());
        facts::feed(*m_device, {facts::identified()});
        QVERIFY(m_shutdown->mayTurn());
        link(drive::LinkState::Lost);
        QVERIFY(!m_shutdown->mayTurn());
        link(drive::LinkState::Connected);
        drive::Identified foreign = facts::identified();
        foreign.identity.knownFirmware = false; // nothing of it is known, nor will be
        facts::feed(*m_device, {foreign});
        QVERIFY(!m_shutdown->mayTurn());
    }

    void aRecordingTurnsNothing()
    {
        session::Endpoint file;
        file.kind = session::Endpoint::Kind::Trace;
        m_device->open(file);
        facts::connectBoard(*m_device);
        tell(MotorState::Running);
        QVERIFY(!m_shutdown->mayTurn());
        m_device->open({});
        tell(MotorState::Running);
        QVERIFY(m_shutdown->mayTurn());
    }

    void whereNoPortIsOpenItEndsAtOnceAndOnce()
    {
        QVERIFY(!m_shutdown->underWay());
        m_shutdown->begin();
        m_shutdown->begin();
        QVERIFY(m_shutdown->underWay());
        QTRY_COMPARE(m_notConfirmed->size(), 1);
        QVERIFY(!m_shutdown->underWay());
        QCOMPARE(m_confirmed->size(), 0);
    }

    void whatIsSeenAtRestEndsIt()
    {
        facts::connectBoard(*m_device);
        m_device->setArmed(true);
        tell(MotorState::Idle); // nothing is under way: nothing is confirmed
        QCOMPARE(m_confirmed->size(), 0);
        m_shutdown->begin();
        m_shutdown->begin();
        QCOMPARE(m_stops->size(), 1);
        tell(MotorState::Running);
        QCOMPARE(m_confirmed->size(), 0);
        tell(MotorState::Idle);
        QCOMPARE(m_confirmed->size(), 1);
        QVERIFY(!m_shutdown->underWay());
        tell(MotorState::Idle);
        QCOMPARE(m_confirmed->size(), 1);
        QCOMPARE(m_notConfirmed->size(), 0);
    }

    void aStateThatCameAsTheLinkWasLostEndsNothing()
    {
        facts::connectBoard(*m_device);
        m_device->setArmed(true);
        m_shutdown->begin();
        link(drive::LinkState::Recovering);
        tell(MotorState::Idle);
        QCOMPARE(m_confirmed->size(), 0);
        QVERIFY(m_shutdown->underWay());
    }

private:
    void tell(MotorState state)
    {
        drive::MotorStatus status = facts::status(state);
        status.motor = 1;
        status.at = m_now;
        facts::feed(*m_device, {status});
    }
    void link(drive::LinkState state)
    {
        facts::feed(*m_device, {drive::LinkChanged{state, drive::LinkReason::None}});
    }

    TimePoint m_now = TimePoint{} + 1h;
    std::unique_ptr<Device> m_device;
    std::unique_ptr<Shutdown> m_shutdown;
    std::unique_ptr<QSignalSpy> m_confirmed, m_notConfirmed, m_stops;
};

QTEST_MAIN(TestShutdown)
#include "tst_shutdown.moc"
