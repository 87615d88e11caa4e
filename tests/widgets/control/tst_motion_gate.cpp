// What the user is asked before a motor moves: the gate on a simulated board in virtual time, and its dialog in the
// real window.
#include "support/edit_bench.h"
#include "support/window_rig.h"
#include "widgets/base/confirmation.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motion_question.h"
#include "widgets/control/panel.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>

using namespace std::chrono_literals;
using drive::MotorAction;
using drive::MotorState;

namespace {

/// A gate on the board of an EditBench. What it sends moves the simulated motor.
struct GateBench : facts::EditBench {
    widgets::MotionGate gate{device, model};
    std::vector<widgets::MotionQuestion> asked;
    QStringList failed;
    int sent = 0; ///< wishes that can move something

    GateBench()
    {
        link.judge.line().asksFirst = true;
        QObject::connect(&gate, &widgets::MotionGate::asked, &panel,
            [this](const widgets::MotionQuestion &question) { asked.push_back(question); });
        QObject::connect(&gate, &widgets::MotionGate::failed, &panel,
            [this](const QString &sentence) { failed.append(sentence); });
        QObject::connect(
            &device, &widgets::Device::wishMade, &panel, [this](const drive::Wish &wish) {
                if (!std::holds_alternative<drive::Read>(wish.what)
                    && !std::holds_alternative<drive::Watch>(wish.what))
                    ++sent;
            });
    }

    void sayYes()
    {
        judge::Act yes;
        yes.kind = judge::Act::Kind::Confirm;
        yes.at = link.now;
        link.judge.act(yes);
        gate.confirm();
    }
    void look()
    {
        for (const char *name : {"SPEED_REF", "SPEED_RAMP", "I_Q_REF", "I_D_REF", "CONTROL_MODE"})
            held(name);
        QCoreApplication::processEvents();
    }
    drive::WishContent start() const { return drive::Command{MotorAction::Start, 1}; }
    static drive::WishContent speed(std::int32_t rpm) { return drive::SpeedRamp{1, rpm, 300ms}; }
    /// Started and at 1000 rpm, without questions left.
    bool run()
    {
        arm();
        look();
        gate.want(QStringLiteral("Start"), start());
        sayYes();
        if (!link.runUntilState(MotorState::Running))
            return false;
        look();
        gate.want(QStringLiteral("Ramp"), speed(1000));
        sayYes();
        const bool there = link.runUntil(
            [this] { return std::abs(link.status[1].speedRpm.value_or(0) - 1000) < 30; }, 5s);
        link.runFor(500ms);
        look();
        asked.clear();
        sent = 0;
        return there;
    }
};

} // namespace

class TestMotionGate : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }

    void theFirstStartIsAskedAboutOncePerConnection()
    {
        GateBench bench;
        bench.arm();
        bench.look();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 1U);
        QCOMPARE(bench.sent, 0);
        QVERIFY(bench.asked[0].lines.join(QLatin1Char('\n')).contains(QStringLiteral("Motor 1")));
        bench.gate.decline();
        QCOMPARE(bench.sent, 0);
        bench.gate.want(QStringLiteral("Start"), bench.start()); // judged anew
        QCOMPARE(bench.asked.size(), 2U);
        bench.sayYes();
        QCOMPARE(bench.sent, 1);
        QVERIFY(bench.link.runUntilState(MotorState::Running));
        bench.device.stop();
        bench.link.drive->stop(bench.link.now);
        QVERIFY(bench.link.runUntilState(MotorState::Idle));
        bench.link.runFor(2s);
        bench.arm();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 3U); // but for a Stop, after which it is a first one again
        bench.sayYes();
        QCOMPARE(bench.sent, 2);
    }

    void anExperimentIsEndedByAnAgreementOnly()
    {
        GateBench bench;
        QVERIFY(bench.run());
        bench.gate.setExperiment(true);
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(1006));
        QCOMPARE(bench.asked.size(), 1U);
        QVERIFY2(bench.asked[0]
                     .lines.join(QLatin1Char('\n'))
                     .contains(QStringLiteral("It ends the experiment")),
            qPrintable(bench.asked[0].lines.join(QLatin1Char('\n'))));
        QVERIFY(bench.asked[0].offer.isEmpty());
        bench.gate.decline();
        QCOMPARE(bench.sent, 0);
        bench.gate.setExperiment(false);
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(1006));
        QCOMPARE(bench.asked.size(), 1U);
        QCOMPARE(bench.sent, 1);
    }

    void stepsUpToWhatWasAgreedAreNotAskedAboutUntilDisarmed()
    {
        GateBench bench;
        QVERIFY(bench.run());
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(2200));
        QCOMPARE(bench.asked.size(), 1U);
        QVERIFY2(bench.asked[0].offer.contains(QStringLiteral("2200")),
            qPrintable(bench.asked[0].offer));
        bench.gate.agreeToSteps();
        bench.sayYes();
        QCOMPARE(bench.sent, 1);
        bench.link.runFor(4s);
        bench.look();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(1000));
        QCOMPARE(bench.asked.size(), 1U); // not asked
        QCOMPARE(bench.sent, 2);
        bench.link.runFor(4s);
        bench.look();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(2300));
        QCOMPARE(bench.asked.size(), 2U); // more than that
        bench.gate.decline();
        bench.device.armedChanged(false);
        bench.link.drive->disarm();
        bench.arm();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(2200));
        QCOMPARE(bench.asked.size(), 3U);
        bench.gate.decline();
        QCOMPARE(bench.sent, 2);
    }

    void onlyTheLengthOfAStepIsOffered()
    {
        GateBench bench;
        bench.arm();
        bench.look();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 1U);
        QCOMPARE(bench.asked[0].offer, QString());
        bench.gate.decline();
    }

    void afterAStopAStartIsAskedAboutAndSaysWhereItGoes()
    {
        GateBench bench;
        QVERIFY(bench.run());
        QCOMPARE(bench.gate.startText(1), QStringLiteral("996\u202frpm"));
        bench.link.drive->stop(bench.link.now);
        bench.device.stop();
        QVERIFY(bench.link.runUntilState(MotorState::Idle));
        bench.link.runFor(3s);
        bench.arm();
        bench.look();
        bench.asked.clear();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 1U);
        QVERIFY(!bench.gate.jogAgreed(1));
        const QString lines = bench.asked[0].lines.join(QLatin1Char('\n'));
        QVERIFY2(lines.contains(bench.gate.startText(1)) && !bench.gate.startText(1).isEmpty(),
            qPrintable(lines));
    }

    /// The drive was stopped by the session: a window that hung, an experiment that broke a bound.
    void afterAStopThatNobodyPressedAStartIsAskedAbout()
    {
        GateBench bench;
        QVERIFY(bench.run());
        bench.link.drive->stop(bench.link.now);
        QVERIFY(bench.link.runUntilState(MotorState::Idle));
        bench.link.runFor(3s);
        bench.arm();
        bench.look();
        bench.asked.clear();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 1U);
    }

    void whereNothingBoundsAStepItIsAskedAbout()
    {
        GateBench bench;
        QVERIFY(bench.run());
        drive::Identified board = *bench.link.identified;
        board.limits[0].maxSpeedRpm = 0.0;
        facts::feed(bench.device, {board});
        drive::Ended agreed;
        QObject::connect(&bench.device, &widgets::Device::wishMade, &bench.panel,
            [&](const drive::Wish &wish) { agreed.id = wish.id; });
        bench.device.becomeExpert(1);
        agreed.outcome = drive::Outcome::Ok; // the simulated board does tell its limit
        facts::feed(bench.device, {agreed});
        QVERIFY(bench.device.expert(1));
        bench.look();
        bench.asked.clear();
        bench.gate.want(QStringLiteral("Ramp"), GateBench::speed(26000));
        QCOMPARE(bench.asked.size(), 1U);
    }

    void aStartWhoseOutcomeComesAfterTheStopIsNoEarlierOne()
    {
        GateBench bench;
        bench.arm();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        bench.sayYes();
        bench.link.runFor(2ms); // on its way now
        bench.link.drive->stop(bench.link.now);
        bench.device.stop();
        QVERIFY(bench.link.runUntilState(MotorState::Idle));
        bench.link.runFor(3s);
        bench.arm();
        bench.asked.clear();
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 1U);
    }

    void whoAgreedToJogIsStillAskedAboutAStart()
    {
        GateBench bench;
        bench.arm();
        QVERIFY(!bench.gate.jog(QStringLiteral("Jog"), 1, 300));
        QCOMPARE(bench.asked.size(), 1U);
        bench.sayYes();
        QVERIFY(bench.gate.jogAgreed(1));
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 2U);
        QCOMPARE(bench.sent, 0);
    }

    void aStartThatWasRefusedIsStillTheFirst()
    {
        GateBench bench;
        bench.arm();
        bench.link.board->setFaults(0x0002);
        QVERIFY(bench.link.runUntilState(MotorState::FaultNow));
        bench.gate.want(QStringLiteral("Start"), bench.start());
        bench.sayYes();
        bench.link.runFor(200ms);
        QCOMPARE(bench.failed.size(), 1);
        QVERIFY2(bench.failed[0].contains(QStringLiteral("refused by the board")),
            qPrintable(bench.failed[0]));
        bench.gate.want(QStringLiteral("Start"), bench.start());
        QCOMPARE(bench.asked.size(), 2U);
    }

    void smallStepsAreSentAndLargeOnesAreAskedAbout()
    {
        GateBench bench;
        QVERIFY(bench.run());
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(1500));
        QCOMPARE(bench.asked.size(), 0U);
        QCOMPARE(bench.sent, 1);
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(3000));
        QCOMPARE(bench.asked.size(), 1U);
        QCOMPARE(bench.sent, 1);
        const QString text = bench.asked[0].lines.join(QLatin1Char('\n'));
        for (const char *part : {"Motor 1", "996\u202frpm", "3000\u202frpm", "20 %", "4000"})
            QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
        bench.sayYes();
        QCOMPARE(bench.sent, 2);
    }

    /// An experiment leaves one. Nothing follows it: a step begins where a start would go.
    void theReferenceThatIsLeftOverAtRestIsNoBeginningOfAStep()
    {
        GateBench bench;
        QVERIFY(bench.link.runUntilState(MotorState::Idle));
        bench.arm();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(1000));
        bench.sayYes(); // where it is asked about
        bench.link.runFor(500ms);
        bench.look();
        const QString target = bench.gate.startText(1);
        QVERIFY2(
            target == QStringLiteral("1000\u202frpm") || target == QStringLiteral("996\u202frpm"),
            qPrintable(target));
        facts::feed(bench.device,
            {drive::RegistersRead{{facts::reading(bench.id("SPEED_REF"), std::int64_t{3000})}}});
        bench.asked.clear();
        const auto textOf = [](const widgets::MotionQuestion &question) {
            return question.lines.join(QLatin1Char('\n'));
        };
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(2900));
        QCOMPARE(bench.asked.size(), 1U); // 1900 rpm are more than a fifth of 4000
        QVERIFY2(textOf(bench.asked[0]).contains(target), qPrintable(textOf(bench.asked[0])));
        bench.gate.decline();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(2000));
        QCOMPARE(bench.asked.size(), 2U);
        QVERIFY2(bench.asked[1].offer.contains(QStringLiteral("2000")),
            qPrintable(bench.asked[1].offer));
        bench.gate.decline();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(1300)); // a small one
        QCOMPARE(bench.asked.size(), 2U);
    }

    void aReversalAtSpeedIsAskedAbout()
    {
        GateBench bench;
        QVERIFY(bench.run());
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(300));
        QCOMPARE(bench.asked.size(), 0U);
        QVERIFY(bench.link.runUntil(
            [&] { return std::abs(bench.link.status[1].speedRpm.value_or(0) - 300) < 30; }, 5s));
        bench.link.runFor(200ms);
        bench.look();
        bench.gate.want(QStringLiteral("Ramp"), bench.speed(-300));
        QCOMPARE(bench.asked.size(), 1U);
        QVERIFY(bench.asked[0].lines.join(QLatin1Char(' ')).contains(QStringLiteral("against")));
    }

    void severalWishesOfOneActAreAskedAboutOnce()
    {
        GateBench bench;
        bench.arm();
        bench.look();
        bench.gate.want(QStringLiteral("Jog"),
            std::vector<drive::WishContent>{bench.speed(3000), bench.start()});
        QCOMPARE(bench.asked.size(), 1U);
        bench.gate.want(QStringLiteral("Start"), bench.start()); // the question is still open
        QCOMPARE(bench.asked.size(), 1U);
        bench.sayYes();
        QCOMPARE(bench.sent, 1); // the second waits for the end of the first
        bench.link.runFor(200ms);
        QCOMPARE(bench.sent, 2);
    }

    void nothingFollowsAWishThatDidNotEndWell()
    {
        GateBench bench;
        bench.arm();
        bench.look();
        bench.gate.want(QStringLiteral("Jog"),
            std::vector<drive::WishContent>{bench.speed(100000), bench.start()});
        bench.sayYes();
        bench.link.runFor(500ms);
        QCOMPARE(bench.sent, 1);
        QCOMPARE(bench.failed.size(), 1);
        QVERIFY2(bench.failed[0].contains(QStringLiteral("refused by this program")),
            qPrintable(bench.failed[0]));
    }

    void stopAndWhatEndsMotionIsNeverAsked()
    {
        GateBench bench;
        QVERIFY(bench.run());
        for (const MotorAction action : {MotorAction::StopRamp, MotorAction::AcknowledgeFaults})
            bench.gate.want(QStringLiteral("End"), drive::Command{action, 1});
        QCOMPARE(bench.asked.size(), 0U);
        QCOMPARE(bench.sent, 2);
    }

    void whatChangesMeanwhileWithdrawsTheQuestion_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("stop") << 0;
        QTest::newRow("disarmed") << 1;
        QTest::newRow("another motor") << 2;
    }
    void whatChangesMeanwhileWithdrawsTheQuestion()
    {
        QFETCH(int, what);
        GateBench bench;
        bench.arm();
        bench.look();
        QSignalSpy withdrawn(&bench.gate, &widgets::MotionGate::withdrawn);
        const QSignalSpy failed(&bench.gate, &widgets::MotionGate::failed);
        bench.gate.want(QStringLiteral("Start"), bench.start());
        switch (what) {
        case 0:
            bench.device.stop();
            break;
        case 1:
            bench.device.setArmed(false);
            break;
        default:
            bench.device.setMotor(2);
        }
        QCOMPARE(withdrawn.size(), 1);
        QCOMPARE(failed.size(), 0); // the user's own act
        bench.sayYes(); // too late
        QCOMPARE(bench.sent, 0);
    }

    void aHiccupLeavesTheQuestionOpen_data()
    {
        QTest::addColumn<int>("then");
        QTest::newRow("it answers again") << 0;
        QTest::newRow("the answer comes too early") << 1;
        QTest::newRow("the motor is as it was not") << 2;
        QTest::newRow("it stays silent") << 3;
    }
    void aHiccupLeavesTheQuestionOpen()
    {
        QFETCH(int, then);
        GateBench bench;
        bench.arm();
        bench.look();
        QSignalSpy withdrawn(&bench.gate, &widgets::MotionGate::withdrawn);
        bench.gate.want(QStringLiteral("Start"), bench.start());
        const auto link = [&](drive::LinkState state) {
            facts::feed(bench.device, {drive::LinkChanged{state, drive::LinkReason::None}});
        };
        link(drive::LinkState::Recovering);
        QCOMPARE(withdrawn.size(), 0);
        QVERIFY(bench.gate.asking());
        if (then == 2)
            facts::feed(bench.device, {facts::status(MotorState::Running)});
        if (then == 3)
            QTRY_COMPARE(withdrawn.size(), 1);
        if (then != 1)
            link(drive::LinkState::Connected);
        bench.sayYes();
        QCOMPARE(bench.sent, then == 0 ? 1 : 0);
        QCOMPARE(withdrawn.size(), then == 0 ? 0 : 1);
        QCOMPARE(bench.failed.size(), then == 0 ? 0 : 1);
        QVERIFY(!bench.gate.asking());
    }

    void enterDoesNotConfirmAndCancelIsTheDefault()
    {
        facts::WindowRig rig;
        connectAndArm(rig);
        auto *box = askForStart(rig);
        QVERIFY(box);
        auto *yes = rig.find<QPushButton>("motionConfirm");
        QVERIFY(yes && !yes->isDefault() && !yes->autoDefault());
        QVERIFY(box->defaultButton() != yes);
        QTest::keyClick(box, Qt::Key_Return);
        QTRY_VERIFY(!rig.find<QMessageBox>("motionQuestion"));
        QVERIFY(askForStart(rig));
        yes = rig.find<QPushButton>("motionConfirm");
        yes->setFocus();
        QTest::keyClick(yes, Qt::Key_Return);
        QTRY_VERIFY(!rig.find<QMessageBox>("motionQuestion"));
        QCOMPARE(m_starts, 0);
    }

    void aKeyThatWasHeldBeforeAnswersNothing()
    {
        facts::WindowRig rig;
        connectAndArm(rig);
        auto *box = askForStart(rig);
        QVERIFY(box);
        for (QWidget *widget : std::initializer_list<QWidget *>{
                 box->button(QMessageBox::Cancel), rig.find<QPushButton>("motionConfirm"), box})
            for (const int key : {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) {
                QKeyEvent repeat(QEvent::KeyPress, key, Qt::NoModifier, QString(), true);
                QCoreApplication::sendEvent(widget, &repeat);
                QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier, QString(), true);
                QCoreApplication::sendEvent(widget, &release);
                QVERIFY(box->isVisible());
            }
        QVERIFY(rig.workbench.motion().asking());
        QTest::keyClick(box->button(QMessageBox::Cancel), Qt::Key_Return);
        QTRY_VERIFY(!rig.workbench.motion().asking());
        QCOMPARE(m_starts, 0);
    }

    void escapeStopsFirstAndDeclines()
    {
        facts::WindowRig rig;
        connectAndArm(rig);
        QSignalSpy stops(&rig.workbench.device(), &widgets::Device::stopWished);
        QPointer<QMessageBox> box = askForStart(rig);
        QVERIFY(box);
        QTest::keyClick(box.data(), Qt::Key_Escape);
        QCOMPARE(stops.size(), 1);
        QTRY_VERIFY(!box);
        QCOMPARE(m_starts, 0);
        QVERIFY(!rig.workbench.device().armed());
    }

    void onlyTheButtonConfirms()
    {
        facts::WindowRig rig;
        connectAndArm(rig);
        QPointer<QMessageBox> box = askForStart(rig);
        QVERIFY(box);
        QTest::mouseClick(rig.find<QPushButton>("motionConfirm"), Qt::LeftButton);
        QTRY_VERIFY(!box);
        QCOMPARE(m_starts, 1);
    }

    void whatHasToBeTypedHasToBeTyped()
    {
        QWidget parent;
        parent.show();
        int yes = 0, no = 0;
        widgets::Confirmation question;
        question.typed = QStringLiteral("MOTOR 1");
        question.yes = QStringLiteral("Go on");
        const auto open = [&] {
            return widgets::askToConfirm(
                &parent, question, [&](bool agreed) { ++(agreed ? yes : no); });
        };
        QPointer<QDialog> dialog = open();
        auto *edit = dialog->findChild<QLineEdit *>(QStringLiteral("confirmationTyped"));
        auto *button = dialog->findChild<QPushButton *>(QStringLiteral("confirmationYes"));
        QVERIFY(!button->isEnabled());
        QVERIFY(edit->accessibleName().contains(QStringLiteral("\"MOTOR 1\""))); // the label's
        QVERIFY(edit->y() < button->mapTo(dialog, QPoint()).y()); // above the buttons
        QTest::keyClicks(edit, QStringLiteral("motor 1"));
        QVERIFY(!button->isEnabled());
        QTest::keyClick(edit, Qt::Key_Return); // not the word, and not a no either
        QVERIFY(dialog->isVisible());
        QTest::keyClick(button, Qt::Key_Return); // elsewhere the default is Cancel
        QTRY_VERIFY(!dialog);
        QCOMPARE(no, 1);
        for (const bool byEnter : {false, true}) {
            dialog = open();
            edit = dialog->findChild<QLineEdit *>(QStringLiteral("confirmationTyped"));
            edit->setText(QStringLiteral("MOTOR 1"));
            if (byEnter)
                QTest::keyClick(edit, Qt::Key_Return);
            else
                dialog->findChild<QPushButton *>(QStringLiteral("confirmationYes"))->click();
            QTRY_VERIFY(!dialog);
        }
        QCOMPARE(yes, 2);
        QCOMPARE(no, 1);
    }

    /// Single letters are keys of the scope: who believes to be there must not start a motor.
    void yesHasItsKeyAndALetterAloneAnswersNothing()
    {
        QWidget parent;
        parent.show();
        int yes = 0, no = 0;
        widgets::Confirmation question;
        question.offer = QStringLiteral("Do not ask again");
        for (const char *verb : {"Go on", "Clear"}) {
            question.yes = QLatin1String(verb);
            QPointer<QDialog> dialog = widgets::askToConfirm(
                &parent, question, [&](bool agreed) { ++(agreed ? yes : no); });
            QVERIFY(QTest::qWaitForWindowExposed(dialog));
            auto *button = dialog->findChild<QPushButton *>(QStringLiteral("confirmationYes"));
            const QKeySequence shortcut = button->shortcut();
            QVERIFY(!shortcut.isEmpty());
            for (QWidget *at : dialog->findChildren<QWidget *>()) {
                if (at != button && at->findChildren<QWidget *>().isEmpty())
                    QVERIFY(QKeySequence::mnemonic(textOf(at)) != shortcut);
                if (at->focusPolicy() & Qt::TabFocus)
                    QTest::keyClick(at, shortcut[0].key());
                QVERIFY(!button->isDown()); // nor on its way to a click
            }
            QCOMPARE(no, 0);
            button->click();
            QTRY_VERIFY(!dialog);
        }
        QCOMPARE(yes, 2);
    }

    /// From the tick in the dialog to the next step, in the window that asks.
    void whoTicksTheOfferIsNotAskedAboutTheWayBack()
    {
        facts::WindowRig rig;
        widgets::Device &device = rig.workbench.device();
        int asked = 0, ticked = 0;
        connect(
            &rig.workbench.motion(), &widgets::MotionGate::asked, this,
            [&] {
                ++asked;
                if (auto *offer = rig.find<QCheckBox>("confirmationOffer")) {
                    QTest::mouseClick(offer, Qt::LeftButton);
                    ticked += offer->isChecked() ? 1 : 0;
                }
                QTest::mouseClick(rig.find<QPushButton>("motionConfirm"), Qt::LeftButton);
            },
            Qt::QueuedConnection);
        QVERIFY(QTest::qWaitForWindowExposed(&rig.window));
        QTest::mouseClick(rig.find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY(device.answering() && device.identified());
        QTRY_COMPARE(device.status(1).state, MotorState::Idle);
        QTest::keyClick(rig.find<QCheckBox>("arm"), Qt::Key_Space);
        QTRY_VERIFY(rig.find<QPushButton>("start")->isEnabled());
        QTest::mouseClick(rig.find<QPushButton>("start"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(device.status(1).state, MotorState::Running, 15000);
        const int starts = asked;
        const auto goTo = [&](double rpm) {
            auto *speed = rig.window.findChild<widgets::ControlPanel *>()->speed();
            speed->setValue(rpm);
            QTest::keyClick(speed, Qt::Key_Return);
            const auto reference = *device.catalog()->resolve("SPEED_REF");
            QTRY_VERIFY_WITH_TIMEOUT(
                std::abs(rig.workbench.registers().shownValue(reference).value_or(0.0) - rpm)
                    < 12.0,
                15000);
        };
        goTo(3000.0);
        QCOMPARE(asked, starts + 1);
        QCOMPARE(ticked, 1);
        goTo(1200.0);
        goTo(3000.0);
        QCOMPARE(asked, starts + 1);
        QTest::keyClick(&rig.window, Qt::Key_Escape);
        QTRY_COMPARE_WITH_TIMEOUT(device.status(1).state, MotorState::Idle, 5000);
    }

    void anOfferIsTakenWithAYesAlone()
    {
        QWidget parent;
        parent.show();
        int offers = 0;
        widgets::Confirmation question;
        question.yes = QStringLiteral("Go on");
        question.offer = QStringLiteral("Do not ask again");
        question.onOffer = [&] { ++offers; };
        for (const bool yes : {false, true}) {
            QPointer<QDialog> dialog = widgets::askToConfirm(&parent, question, [](bool) {});
            auto *box = dialog->findChild<QCheckBox *>(QStringLiteral("confirmationOffer"));
            QVERIFY(box && !box->isChecked());
            QTest::mouseClick(box, Qt::LeftButton);
            if (yes)
                dialog->findChild<QPushButton *>(QStringLiteral("confirmationYes"))->click();
            else
                dialog->reject();
            QTRY_VERIFY(!dialog);
            QCOMPARE(offers, yes ? 1 : 0);
        }
    }

private:
    void connectAndArm(facts::WindowRig &rig)
    {
        m_starts = 0;
        widgets::Device &device = rig.workbench.device();
        connect(&device, &widgets::Device::wishMade, this, [this](const drive::Wish &wish) {
            const auto *command = std::get_if<drive::Command>(&wish.what);
            m_starts += command != nullptr && command->action == MotorAction::Start ? 1 : 0;
        });
        facts::connectBoard(device);
        device.armedChanged(true);
    }
    static QString textOf(const QWidget *widget)
    {
        const auto *button = qobject_cast<const QAbstractButton *>(widget);
        return button ? button->text() : QString();
    }
    static QMessageBox *askForStart(facts::WindowRig &rig)
    {
        rig.window.findChild<widgets::ControlPanel *>()->start();
        QMessageBox *open = nullptr;
        for (auto *box : rig.window.findChildren<QMessageBox *>(QStringLiteral("motionQuestion")))
            if (box->isVisible())
                open = box;
        return open;
    }

    int m_starts = 0;
};

QTEST_MAIN(TestMotionGate)
#include "tst_motion_gate.moc"
