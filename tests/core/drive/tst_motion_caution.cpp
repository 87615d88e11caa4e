// Which acts of motion the user is asked about first.
#include "drive/motion_caution.h"

#include <QTest>

#include <limits>

using namespace drive;
using namespace std::chrono_literals;
using Cautions = std::vector<MotionCaution>;

namespace {

/// A motor that runs at 1000 rpm under speed control; limits 4000 rpm and 5 A.
MotionScene running()
{
    MotionScene scene;
    scene.state = MotorState::Running;
    scene.startedBefore = true;
    scene.bounds = {4000.0, 5.0};
    scene.speedRpm = 1000.0;
    scene.speedReferenceRpm = 1000.0;
    scene.iqReferenceAmps = 1.0;
    scene.idReferenceAmps = 0.0;
    scene.torqueMode = false;
    return scene;
}

MotionScene torque()
{
    MotionScene scene = running();
    scene.torqueMode = true;
    return scene;
}

MotionScene idle()
{
    MotionScene scene = running();
    scene.state = MotorState::Idle;
    scene.speedRpm = 0.0;
    scene.speedReferenceRpm = 0.0;
    return scene;
}

WishContent speed(std::int32_t rpm) { return SpeedRamp{1, rpm, 500ms}; }

} // namespace

class TestMotionCaution : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onlyTheFirstStartIsAskedAbout();
    void stopsAndEndsAreNeverAskedAbout();
    void aStepOfMoreThanAFifthOfTheLimit();
    void aStepWithinWhatWasAgreedIsNotAskedAbout();
    void whatIsNotKnownCountsAsAStep();
    void turningTheOtherWay();
    void anotherModeWhileDriven();
    void torqueUnderAnOwnLimitOfSpeed();
    void currentsAreJudgedAsAVector();
    void whatIsNotDrivenHasNoMode();
    void theBordersBelongToTheQuietSide();
    void aPositionIsAlwaysAskedAbout();
    void whatEndsAnExperimentIsAskedAbout();
};

void TestMotionCaution::onlyTheFirstStartIsAskedAbout()
{
    MotionScene scene = idle();
    scene.startedBefore = false;
    const WishContent start = Command{MotorAction::Start, 1};
    QVERIFY(cautionsOf(start, scene) == Cautions{MotionCaution::FirstStart});
    scene.startedBefore = true;
    QVERIFY(cautionsOf(start, scene).empty());
}

void TestMotionCaution::stopsAndEndsAreNeverAskedAbout()
{
    for (const MotorAction action :
        {MotorAction::StopMotor, MotorAction::StopRamp, MotorAction::AcknowledgeFaults})
        QVERIFY(cautionsOf(Command{action, 1}, MotionScene{}).empty());
}

void TestMotionCaution::aStepOfMoreThanAFifthOfTheLimit()
{
    QVERIFY(cautionsOf(speed(1800), running()).empty());
    QVERIFY(cautionsOf(speed(1801), running()) == Cautions{MotionCaution::Step});
    QVERIFY(cautionsOf(speed(200), running()).empty());
    QVERIFY(cautionsOf(speed(199), running()) == Cautions{MotionCaution::Step});
    MotionScene own = running();
    own.bounds.rpm = 2000.0; // the user's own limit, the lower one
    QVERIFY(cautionsOf(speed(1401), own) == Cautions{MotionCaution::Step});
    QVERIFY(cautionsOf(TorqueRamp{1, 2.0, 0ms}, torque()).empty());
    QVERIFY(cautionsOf(TorqueRamp{1, 2.01, 0ms}, torque()) == Cautions{MotionCaution::Step});
}

void TestMotionCaution::aStepWithinWhatWasAgreedIsNotAskedAbout()
{
    MotionScene scene = running();
    scene.agreedRpm = 2500.0;
    QVERIFY(cautionsOf(speed(2500), scene).empty());
    QVERIFY(cautionsOf(speed(2501), scene) == Cautions{MotionCaution::Step});
    // Another question than the length of a step.
    QVERIFY(cautionsOf(speed(-1000), scene) == Cautions{MotionCaution::Reversal});
    scene.speedReferenceRpm = 2600.0; // from outside of it
    QVERIFY(cautionsOf(speed(1000), scene) == Cautions{MotionCaution::Step});
    scene.speedReferenceRpm.reset();
    QVERIFY(cautionsOf(speed(1000), scene) == Cautions{MotionCaution::StepFromUnknown});

    scene = torque();
    scene.agreedAmps = 4.0;
    QVERIFY(cautionsOf(TorqueRamp{1, 4.0, 500ms}, scene).empty());
    QVERIFY(cautionsOf(CurrentReference{1, 3.0, -2.0}, scene).empty());
    QVERIFY(cautionsOf(CurrentReference{1, 3.5, -2.5}, scene) == Cautions{MotionCaution::Step});
}

void TestMotionCaution::whatIsNotKnownCountsAsAStep()
{
    MotionScene scene = running();
    scene.speedReferenceRpm.reset();
    QVERIFY(cautionsOf(speed(1000), scene) == Cautions{MotionCaution::StepFromUnknown});
    scene = running();
    scene.speedReferenceRpm = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(cautionsOf(speed(1000), scene) == Cautions{MotionCaution::Step});
    scene = running();
    scene.bounds = {};
    QVERIFY(cautionsOf(speed(1006), scene) == Cautions{MotionCaution::Step});
}

void TestMotionCaution::turningTheOtherWay()
{
    MotionScene slow = running();
    slow.speedRpm = slow.speedReferenceRpm = 300.0;
    QVERIFY(cautionsOf(speed(-300), slow) == Cautions{MotionCaution::Reversal});
    QVERIFY(cautionsOf(speed(0), slow).empty());
    slow.speedRpm = -300.0;
    slow.speedReferenceRpm = -300.0;
    QVERIFY(cautionsOf(speed(300), slow) == Cautions{MotionCaution::Reversal});
    slow.speedRpm = -9.0; // stands, as far as one can say
    QVERIFY(cautionsOf(speed(300), slow).empty());
    slow.speedRpm.reset();
    QVERIFY(cautionsOf(speed(300), slow) == Cautions{MotionCaution::Reversal});
    MotionScene coasting = idle();
    coasting.speedRpm = 800.0;
    QVERIFY(cautionsOf(speed(-300), coasting) == Cautions{MotionCaution::Reversal});
    QVERIFY(cautionsOf(TorqueRamp{1, -0.1, 0ms}, torque())
        == (Cautions{MotionCaution::Step, MotionCaution::Reversal}));
    MotionScene light = torque();
    light.iqReferenceAmps = 0.1;
    QVERIFY(cautionsOf(TorqueRamp{1, -0.1, 0ms}, light) == Cautions{MotionCaution::Reversal});
}

void TestMotionCaution::anotherModeWhileDriven()
{
    QVERIFY(cautionsOf(TorqueRamp{1, 1.0, 0ms}, running()) == Cautions{MotionCaution::OtherMode});
    QVERIFY(cautionsOf(speed(1000), torque()) == Cautions{MotionCaution::OtherMode});
    MotionScene scene = running();
    scene.torqueMode.reset();
    QVERIFY(cautionsOf(speed(1000), scene) == Cautions{MotionCaution::UnknownMode});
    QVERIFY(cautionsOf(TorqueRamp{1, 1.0, 0ms}, scene) == Cautions{MotionCaution::UnknownMode});
    QVERIFY(cautionsOf(TorqueRamp{1, 1.0, 0ms}, idle()).empty());
}

void TestMotionCaution::torqueUnderAnOwnLimitOfSpeed()
{
    MotionScene scene = torque();
    scene.ownSpeedLimitRpm = 1200.0;
    QVERIFY(cautionsOf(TorqueRamp{1, 1.0, 0ms}, scene) == Cautions{MotionCaution::NoSpeedLimit});
    QVERIFY(
        cautionsOf(CurrentReference{1, 1.7, 0.7}, scene) == Cautions{MotionCaution::NoSpeedLimit});
    scene.ownSpeedLimitRpm = 0.0;
    QVERIFY(cautionsOf(TorqueRamp{1, 1.0, 0ms}, scene).empty());
}

void TestMotionCaution::currentsAreJudgedAsAVector()
{
    QVERIFY(cautionsOf(CurrentReference{1, 1.7, 0.7}, torque()).empty());
    QVERIFY(cautionsOf(CurrentReference{1, 1.8, 0.8}, torque()) == Cautions{MotionCaution::Step});
    MotionScene scene = torque();
    scene.idReferenceAmps.reset();
    QVERIFY(cautionsOf(CurrentReference{1, 1.0, 0.0}, scene)
        == Cautions{MotionCaution::StepFromUnknown});
    scene = torque();
    scene.iqReferenceAmps.reset();
    QVERIFY(cautionsOf(CurrentReference{1, 1.0, 0.0}, scene)
        == Cautions{MotionCaution::StepFromUnknown});
    scene = torque(); // the length of both together, of what is and of what is to be
    scene.agreedAmps = 5.0;
    scene.iqReferenceAmps = 3.0;
    scene.idReferenceAmps = -4.0;
    QVERIFY(cautionsOf(CurrentReference{1, 3.0, 4.0}, scene).empty());
    scene.idReferenceAmps = -4.1;
    QVERIFY(cautionsOf(CurrentReference{1, 3.0, 4.0}, scene) == Cautions{MotionCaution::Step});
    scene = torque();
    scene.torqueMode = false;
    scene.speedRpm = -1000.0;
    QVERIFY(cautionsOf(CurrentReference{1, 1.0, 0.0}, scene)
        == (Cautions{MotionCaution::Reversal, MotionCaution::OtherMode}));
}

void TestMotionCaution::whatIsNotDrivenHasNoMode()
{
    constexpr std::pair<MotorState, bool> states[] = {{MotorState::Idle, false},
        {MotorState::FaultNow, false}, {MotorState::FaultOver, false}, {MotorState::Unknown, true},
        {MotorState::Starting, true}, {MotorState::Running, true}, {MotorState::Stopping, true}};
    for (const auto &[state, driven] : states) {
        MotionScene scene = torque();
        scene.state = state;
        QVERIFY(cautionsOf(speed(1000), scene)
            == (driven ? Cautions{MotionCaution::OtherMode} : Cautions{}));
        scene.torqueMode = false;
        scene.speedRpm.reset(); // a motor that is not driven need not have one
        QVERIFY(cautionsOf(speed(1000), scene)
            == (driven ? Cautions{MotionCaution::Reversal} : Cautions{}));
    }
}

void TestMotionCaution::theBordersBelongToTheQuietSide()
{
    MotionScene scene = running();
    scene.agreedRpm = 2500.0;
    scene.speedReferenceRpm = -2500.0;
    QVERIFY(cautionsOf(speed(2500), scene).empty());
    scene = running();
    scene.speedRpm = -10.0; // stands just yet
    QVERIFY(cautionsOf(speed(1000), scene).empty());
    scene.speedRpm = -10.1;
    QVERIFY(cautionsOf(speed(1000), scene) == Cautions{MotionCaution::Reversal});
    scene.speedRpm = scene.speedReferenceRpm = -300.0; // to rest, out of either direction
    QVERIFY(cautionsOf(speed(0), scene).empty());
    QVERIFY(cautionsOf(speed(1), scene) == Cautions{MotionCaution::Reversal});
    scene = torque();
    scene.ownSpeedLimitRpm = 1.0;
    scene.iqReferenceAmps = 0.5;
    for (const double amps : {0.5, 1.0})
        for (const WishContent &act :
            {WishContent(TorqueRamp{1, amps, 0ms}), WishContent(CurrentReference{1, amps, 0.0})})
            QVERIFY(cautionsOf(act, scene) == Cautions{MotionCaution::NoSpeedLimit});
    QVERIFY(cautionsOf(TorqueRamp{1, 0.0, 0ms}, scene).empty()); // without torque nothing runs away
    QVERIFY(cautionsOf(CurrentReference{1, 0.0, 0.5}, scene).empty());
}

void TestMotionCaution::aPositionIsAlwaysAskedAbout()
{
    for (const MotionScene &scene : {idle(), running()})
        QVERIFY(cautionsOf(PositionRamp{1, 0.0, 0ms}, scene) == Cautions{MotionCaution::Position});
    QVERIFY(cautionsOf(Read{}, MotionScene{}).empty());
}

void TestMotionCaution::whatEndsAnExperimentIsAskedAbout()
{
    MotionScene scene = running();
    scene.experiment = true;
    const Cautions ends{MotionCaution::EndsExperiment};
    QVERIFY(cautionsOf(speed(1000), scene) == ends);
    QVERIFY(cautionsOf(Command{MotorAction::Start, 1}, scene) == ends);
    QVERIFY(cautionsOf(PositionRamp{1, 0.0, 0ms}, scene).back() == MotionCaution::EndsExperiment);
    for (const MotorAction action :
        {MotorAction::StopMotor, MotorAction::StopRamp, MotorAction::AcknowledgeFaults})
        QVERIFY(cautionsOf(Command{action, 1}, scene).empty());
    scene.torqueMode = true;
    for (const WishContent &act :
        {WishContent(TorqueRamp{1, 1.0, 0ms}), WishContent(CurrentReference{1, 1.0, 0.0})})
        QVERIFY(cautionsOf(act, scene) == ends);
}

QTEST_GUILESS_MAIN(TestMotionCaution)
#include "tst_motion_caution.moc"
