// The real window, the real session thread and the simulated board, while the window stands still: its thread does not
// come back to its event loop. What the board does meanwhile is told by the entries of the motion log afterwards.
#include "support/window_rig.h"
#include "widgets/control/panel.h"

#include <QCheckBox>
#include <QSignalSpy>
#include <QThread>

using namespace std::chrono_literals;
using drive::MotorState;
using session::Interruption;

namespace {

/// Nothing else runs in this thread, as when a disk does not answer.
void standStill(std::chrono::milliseconds time)
{
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end)
        QThread::yieldCurrentThread();
}

} // namespace

class TestFrozenWindow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_interruptions.clear();
        m_motions.clear();
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->sayYesToMotion();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        connect(&device(), &widgets::Device::interrupted, this,
            [this](const Interruption &what) { m_interruptions.push_back(what); });
        connect(&device(), &widgets::Device::motionLogged, this,
            [this](const drive::MotionEntry &entry) { m_motions.push_back(entry); });
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY(device().answering() && device().identified());
        QTRY_COMPARE(state(), MotorState::Idle);
    }
    void cleanup() { m_rig.reset(); }

    void itDisarmsAndAfterTwoSecondsStopsWhatItDrives()
    {
        startMotor();
        const TimePoint frozen = device().status(1).at;
        standStill(3500ms);
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, 5000);
        QVERIFY(!device().armed());
        QTRY_COMPARE(m_interruptions.size(), 1U);
        QVERIFY(m_interruptions[0].cause == Interruption::Cause::Interface
            || m_interruptions[0].cause == Interruption::Cause::Gap);
        QVERIFY(m_interruptions[0].disarmed && m_interruptions[0].stopped);
        const auto *stop = find(drive::MotionAct::Stop);
        QVERIFY(stop);
        const Duration after = stop->asked - frozen;
        // While it stood still.
        QVERIFY2(after < 3200ms, qPrintable(QString::number(toSeconds(after))));
        QVERIFY(find(drive::MotionAct::Disarm));
        QVERIFY(find(drive::MotionAct::Disarm)->asked < stop->asked);
        for (const drive::MotionEntry &entry : m_motions)
            QVERIFY(entry.act != drive::MotionAct::Arm || entry.asked <= frozen);
    }

    void whatWasTypedIntoItDoesNotActWhenItThaws()
    {
        arm();
        standStill(1500ms);
        QTest::keyClick(&m_rig->window, Qt::Key_Return, Qt::ControlModifier);
        QTRY_VERIFY(!device().armed());
        // The first things that are handled are those that waited: arming is one of them.
        standStill(1000ms);
        QTest::keyClick(m_rig->find<QCheckBox>("arm"), Qt::Key_Space);
        QTRY_VERIFY(std::any_of(
            m_interruptions.begin(), m_interruptions.end(), [](const Interruption &what) {
                return what.cause == Interruption::Cause::LateArming;
            }));
        QVERIFY(!device().armed());
        QCOMPARE(state(), MotorState::Idle);
        QVERIFY(!find(drive::MotionAct::Start) || find(drive::MotionAct::Start)->sent.empty());
        arm(); // and a user who does it again is obeyed
    }

    void aStopThatWaitedInItComesAtLast()
    {
        startMotor();
        standStill(900ms);
        QTest::keyClick(&m_rig->window, Qt::Key_Escape); // late, but a stop never is too late
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, 5000);
        QVERIFY(find(drive::MotionAct::Stop));
    }

    void askedToEndTheSessionStopsItsOwnMeanwhile()
    {
        startMotor();
        const TimePoint then = device().status(1).at;
        m_rig->workbench.atSession([](session::Session &session) { session.stopOwn(); });
        standStill(400ms);
        QTRY_VERIFY(find(drive::MotionAct::Stop));
        QVERIFY(find(drive::MotionAct::Stop)->asked < then + 400ms);
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, 5000);
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    MotorState state() { return device().status(1).state; }
    const drive::MotionEntry *find(drive::MotionAct act) const
    {
        for (const drive::MotionEntry &entry : m_motions)
            if (entry.act == act)
                return &entry;
        return nullptr;
    }
    /// Clicked until it is taken: what is clicked right after a freeze is not.
    void arm()
    {
        auto *box = m_rig->find<QCheckBox>("arm");
        QTRY_VERIFY(box->isEnabled());
        QTRY_VERIFY(device().armed() || (QTest::keyClick(box, Qt::Key_Space), false));
    }
    void startMotor()
    {
        arm();
        QTRY_VERIFY(m_rig->find<QPushButton>("start")->isEnabled());
        QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Running, 15000);
        m_motions.clear();
    }

    std::unique_ptr<facts::WindowRig> m_rig;
    std::vector<Interruption> m_interruptions;
    std::vector<drive::MotionEntry> m_motions;
};

QTEST_MAIN(TestFrozenWindow)
#include "tst_frozen_window.moc"
