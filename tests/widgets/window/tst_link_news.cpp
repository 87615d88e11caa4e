// What the banner says of the link: each happening once, for as long as it matters.
#include "support/window_rig.h"
#include "widgets/base/banner.h"

#include <QToolButton>

using drive::LinkReason;
using drive::LinkState;

class TestLinkNews : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = QStringLiteral("/dev/ttyACM0");
        device().open(endpoint);
        facts::connectBoard(device());
        banner()->clear();
    }
    void cleanup()
    {
        device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
    }

    void aResetIsToldUntilTheBoardIsArmed()
    {
        link(LinkState::Connected, LinkReason::BoardReset);
        const QString told = banner()->text();
        QVERIFY(told.contains(QStringLiteral("was reset")));
        for (const LinkState state :
            {LinkState::Recovering, LinkState::Suspect, LinkState::Connected}) {
            link(state); // its first steps are often like that
            QCOMPARE(banner()->text(), told);
        }
        device().armedChanged(true);
        QVERIFY(banner()->isHidden());
        link(LinkState::Suspect);
        link(LinkState::Connected);
        QVERIFY(banner()->isHidden());
    }

    void aResetIsNoNewsBesideALostLink()
    {
        link(LinkState::Connected, LinkReason::BoardReset);
        link(LinkState::Lost, LinkReason::Silence);
        QVERIFY(banner()->text().contains(QStringLiteral("Link lost")));
        link(LinkState::Connected);
        QVERIFY(banner()->isHidden());
    }

    void aLossThatWasReadIsNotToldAgainByTheNextAttempt()
    {
        link(LinkState::Lost, LinkReason::Silence);
        close();
        for (const LinkState state : {LinkState::Connecting, LinkState::Lost}) {
            link(state, state == LinkState::Lost ? LinkReason::Silence : LinkReason::None);
            QVERIFY(banner()->isHidden());
        }
        link(LinkState::Connected);
        link(LinkState::Lost, LinkReason::Silence); // another one
        QVERIFY(banner()->isVisible());
    }

    void aCableThatIsOutIsToldOnce()
    {
        const session::PortError pulled{session::PortProblem::Unplugged, QStringLiteral("gone")};
        device().portChanged(session::PortState::Closed, pulled);
        QVERIFY(banner()->text().contains(QStringLiteral("unplugged")));
        close();
        device().portChanged(session::PortState::Closed, pulled); // it was tried to open it again
        QVERIFY(banner()->isHidden());
        device().portChanged(session::PortState::Open, {});
        link(LinkState::Connected);
        device().portChanged(session::PortState::Closed, pulled);
        QVERIFY(banner()->isVisible());
    }

    void whatWasDrivenLastIsToldWithTheLoss_data()
    {
        QTest::addColumn<int>("state");
        QTest::addColumn<QString>("words");
        const QString turning = QStringLiteral("may still be turning");
        QTest::newRow("not known") << static_cast<int>(drive::MotorState::Unknown) << turning;
        QTest::newRow("running") << static_cast<int>(drive::MotorState::Running) << turning;
        QTest::newRow("stopping") << static_cast<int>(drive::MotorState::Stopping) << turning;
        for (const drive::MotorState rest :
            {drive::MotorState::Idle, drive::MotorState::FaultNow, drive::MotorState::FaultOver})
            QTest::addRow("at rest, %d", static_cast<int>(rest))
                << static_cast<int>(rest) << QStringLiteral("No motor was driven");
    }

    void whatWasDrivenLastIsToldWithTheLoss()
    {
        QFETCH(const int, state);
        QFETCH(const QString, words);
        tell(static_cast<drive::MotorState>(state), std::chrono::seconds(1));
        link(LinkState::Lost, LinkReason::Silence);
        QVERIFY2(banner()->text().contains(words), qPrintable(banner()->text()));
        device().portChanged(
            session::PortState::Closed, {session::PortProblem::Unplugged, QStringLiteral("gone")});
        QVERIFY2(banner()->text().contains(words), qPrintable(banner()->text()));
    }

    /// A START that may have arrived is no rest, whatever was heard before it.
    void whatMayHaveArrivedCountsAsDriven()
    {
        tell(drive::MotorState::Idle, std::chrono::seconds(1));
        start(drive::Outcome::Unknown);
        link(LinkState::Lost, LinkReason::Silence);
        QVERIFY(banner()->text().contains(QStringLiteral("may still be turning")));
        device().portChanged(
            session::PortState::Closed, {session::PortProblem::Unplugged, QStringLiteral("gone")});
        QVERIFY(banner()->text().contains(QStringLiteral("may still be turning")));
    }

    /// A board may say once more that it is idle when it has just taken a START.
    void whatWasJustStartedCountsAsDriven()
    {
        tell(drive::MotorState::Idle, std::chrono::seconds(1));
        start(drive::Outcome::Ok);
        tell(drive::MotorState::Idle, std::chrono::milliseconds(1100));
        tell(drive::MotorState::Idle, std::chrono::milliseconds(1200));
        link(LinkState::Lost, LinkReason::Silence);
        QVERIFY(banner()->text().contains(QStringLiteral("may still be turning")));
    }

    void aFirmwareThatIsNotKnownIsToldOnce()
    {
        drive::Identified board = facts::identified();
        board.identity.knownFirmware = false;
        facts::feed(device(), {board});
        QVERIFY(banner()->text().contains(QStringLiteral("not known")));
        close();
        link(LinkState::Suspect);
        link(LinkState::Connected);
        QVERIFY(banner()->isHidden());
    }

    /// What others said stays while the link has nothing new to say.
    void whatIsKnownTakesNoOthersPlace()
    {
        link(LinkState::Connected, LinkReason::BoardReset);
        m_rig->window.warn(QStringLiteral("Look."));
        link(LinkState::Recovering);
        link(LinkState::Connected);
        QCOMPARE(banner()->text(), QStringLiteral("Look."));
        device().armedChanged(true);
        QCOMPARE(banner()->text(), QStringLiteral("Look."));
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    widgets::Banner *banner() { return m_rig->find<widgets::Banner>("banner"); }
    void link(LinkState state, LinkReason reason = LinkReason::None)
    {
        facts::feed(device(), {drive::LinkChanged{state, reason}});
    }
    void tell(drive::MotorState state, Duration at)
    {
        drive::MotorStatus status = facts::status(state);
        status.at = TimePoint(at);
        facts::feed(device(), {status});
    }
    void start(drive::Outcome outcome)
    {
        drive::Ended ended;
        ended.id = device().submit(drive::Command{drive::MotorAction::Start, 1});
        ended.outcome = outcome;
        facts::feed(device(), {ended});
    }
    void close() { banner()->findChild<QToolButton *>()->click(); }

    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestLinkNews)
#include "tst_link_news.moc"
