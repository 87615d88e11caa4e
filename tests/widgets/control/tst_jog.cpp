// Jogging on a simulated board in virtual time: the motor turns while something is held, and nothing that takes the
// hand or the eye away leaves it turning.
#include "support/edit_bench.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/jog_box.h"
#include "widgets/control/motion_gate.h"

#include <QApplication>
#include <QDialog>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>

using namespace std::chrono_literals;
using drive::MotorAction;
using drive::MotorState;
using widgets::JogButton;

namespace {

struct JogBench : facts::EditBench {
    widgets::MotionGate gate{device, model};
    QWidget window;
    widgets::JogBox box{device, gate, &window};
    QLineEdit other{&window}; ///< something else that can have the focus
    int questions = 0, starts = 0, ramps = 0, motorStops = 0, stops = 0;

    explicit JogBench(bool agree = true)
    {
        auto *layout = new QVBoxLayout(&window);
        layout->addWidget(&box);
        layout->addWidget(&other);
        QObject::connect(&gate, &widgets::MotionGate::asked, &window, [this, agree] {
            ++questions;
            if (agree)
                gate.confirm();
        });
        QObject::connect(
            &device, &widgets::Device::wishMade, &window, [this](const drive::Wish &wish) {
                if (const auto *command = std::get_if<drive::Command>(&wish.what)) {
                    starts += command->action == MotorAction::Start ? 1 : 0;
                    motorStops += command->action == MotorAction::StopMotor ? 1 : 0;
                }
                ramps += std::holds_alternative<drive::SpeedRamp>(wish.what) ? 1 : 0;
            });
        QObject::connect(&device, &widgets::Device::stopWished, &window, [this] {
            ++stops;
            link.drive->stop(link.now);
            link.exchange();
        });
        QObject::connect(
            &device, &widgets::Device::statusChanged, &window, [this] { box.refresh(ms()); });
        window.show();
        window.activateWindow();
        if (!QTest::qWaitForWindowExposed(&window) || !QTest::qWaitForWindowActive(&window))
            qFatal("the window does not become active");
        arm();
        box.follow();
    }
    ~JogBench() { link.onEvent = nullptr; }

    JogButton *button(const char *name = "jogForth") const
    {
        return window.findChild<JogButton *>(QLatin1String(name));
    }
    MotorState state() { return link.status[1].state; }
    /// The first press is asked about and moves nothing; the next one counts.
    void agree()
    {
        QTest::mousePress(button(), Qt::LeftButton);
        QTest::mouseRelease(button(), Qt::LeftButton);
    }
    bool press()
    {
        button()->setFocus();
        QTest::mousePress(button(), Qt::LeftButton);
        return link.runUntil([this] { return state() == MotorState::Running; }, 10s);
    }
    bool idleWithin(Duration limit)
    {
        return link.runUntil([this] { return state() == MotorState::Idle; }, limit);
    }
};

} // namespace

class TestJog : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theFirstStartIsAgreedToBeforeAnythingMoves()
    {
        JogBench bench;
        QVERIFY(bench.button()->isEnabled());
        bench.agree();
        bench.link.runFor(500ms);
        QCOMPARE(bench.questions, 1);
        QCOMPARE(bench.starts + bench.ramps + bench.motorStops, 0);
        QVERIFY(bench.state() == MotorState::Idle);
        QVERIFY(bench.press());
        QCOMPARE(bench.questions, 1);
    }

    void theQuestionComesWhenTheKeyIsLetGo()
    {
        JogBench bench(false);
        QStringList lines;
        connect(&bench.gate, &widgets::MotionGate::asked, this,
            [&](const widgets::MotionQuestion &question) { lines = question.lines; });
        bench.button()->setFocus();
        QTest::keyPress(bench.button(), Qt::Key_Return);
        bench.link.runFor(300ms);
        QCOMPARE(bench.questions, 0); // a key that is held must not answer it
        bench.other.setFocus();
        QTest::keyRelease(bench.button(), Qt::Key_Return);
        QCOMPARE(bench.questions, 0); // lost, not let go
        bench.button()->setFocus();
        QTest::keyClick(bench.button(), Qt::Key_Return);
        QTRY_COMPARE(bench.questions, 1);
        const QString text = lines.join(QLatin1Char('\n'));
        QVERIFY2(text.contains(QStringLiteral("start, then to 396\u202frpm")), qPrintable(text));
        bench.link.runFor(300ms);
        QCOMPARE(bench.starts + bench.ramps, 0);
    }

    void itTurnsWhileHeldAndStopsWhenLetGo()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        QCOMPARE(bench.ramps, 1);
        QCOMPARE(bench.starts, 1);
        bench.link.runFor(500ms);
        QVERIFY(bench.state() == MotorState::Running); // as long as it is held
        QVERIFY(bench.box.jog().held());
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QCOMPARE(bench.motorStops, 1);
        QVERIFY(bench.idleWithin(500ms));
        bench.link.runFor(2s);
        QCOMPARE(bench.stops, 0); // there was evidence: no alarm, still armed
        QVERIFY(bench.device.armed());
        QVERIFY(!bench.box.jog().underWay());
        QVERIFY(bench.press()); // and again, unasked
        QCOMPARE(bench.questions, 1);
    }

    void aReleaseBesideTheButtonIsARelease()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        QTest::mouseRelease(bench.button(), Qt::LeftButton, Qt::NoModifier, QPoint(-300, -300));
        QVERIFY(bench.idleWithin(500ms));
    }

    void theKeyHoldsAsWellAndRepeatsCountOnce()
    {
        JogBench bench;
        bench.agree();
        bench.button()->setFocus();
        QTest::keyPress(bench.button(), Qt::Key_Return);
        const auto repeat = [&](QEvent::Type type) {
            QKeyEvent event(type, Qt::Key_Return, Qt::NoModifier, QString(), true);
            QCoreApplication::sendEvent(bench.button(), &event);
        };
        for (int i = 0; i < 20; ++i) {
            repeat(QEvent::KeyRelease);
            repeat(QEvent::KeyPress);
            bench.link.runFor(30ms);
        }
        QVERIFY(bench.link.runUntil([&] { return bench.state() == MotorState::Running; }, 10s));
        QCOMPARE(bench.starts, 1);
        QCOMPARE(bench.motorStops, 0);
        QTest::keyRelease(bench.button(), Qt::Key_Return);
        QTRY_COMPARE(bench.motorStops, 1);
        QVERIFY(bench.idleWithin(500ms));
        QTest::keyClick(bench.button(), Qt::Key_Space); // the picture's
        bench.link.runFor(200ms);
        QCOMPARE(bench.starts, 1);
    }

    void onlyWhatIsHeldSaysThatItIs()
    {
        JogBench bench;
        QSignalSpy held(&bench.device, &widgets::Device::held);
        QSignalSpy released(&bench.device, &widgets::Device::released);
        bench.agree(); // nothing moves yet
        QCOMPARE(held.size(), 0);
        QTest::mousePress(bench.button(), Qt::LeftButton);
        QCOMPARE(held.size(), 1); // before the motor is asked for anything
        QCOMPARE(held[0][0].toInt(), 1);
        QTRY_VERIFY(held.size() >= 5); // by itself, while nothing else goes on
        QCOMPARE(released.size(), 0);
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QCOMPARE(released.size(), 1);
        const auto before = held.size();
        for (int i = 0; i < 100; ++i)
            bench.box.refresh(widgets::Milliseconds(i * 10)); // the window's heart
        bool later = false;
        QTimer::singleShot(200, this, [&] { later = true; });
        QTRY_VERIFY(later);
        QCOMPARE(held.size(), before);
        QCOMPARE(released.size(), 1);
    }

    void everyEndOfAHoldIsToldOnce()
    {
        for (const bool stop : {true, false}) {
            JogBench bench;
            bench.agree();
            QVERIFY(bench.press());
            QSignalSpy released(&bench.device, &widgets::Device::released);
            stop ? bench.device.stop() : bench.other.setFocus();
            QCOMPARE(released.size(), 1);
            QTest::mouseRelease(bench.button(), Qt::LeftButton);
            QCOMPARE(released.size(), 1);
        }
    }

    void aHoldThatTheSessionEndedIsOver()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        // The window stood still; the session has sent the stop of this motor.
        bench.link.drive->submit(
            {.id = 0, .what = drive::Command{MotorAction::StopMotor, 1}}, bench.link.now);
        bench.link.exchange();
        Q_EMIT bench.device.interrupted({session::Interruption::Cause::Hold, 400ms, false, true});
        QVERIFY(!bench.box.jog().held());
        QVERIFY(bench.idleWithin(500ms));
        QVERIFY(!bench.box.jog().underWay());
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        bench.link.runFor(1s);
        QCOMPARE(bench.stops, 0);
        QCOMPARE(bench.motorStops, 0); // none of its own
    }

    void aRepeatThatIsNotMarkedIsNoRelease()
    {
        JogBench bench;
        bench.agree();
        bench.button()->setFocus();
        QTest::keyPress(bench.button(), Qt::Key_Return);
        QVERIFY(bench.link.runUntil([&] { return bench.state() == MotorState::Running; }, 10s));
        for (const QEvent::Type type : {QEvent::KeyRelease, QEvent::KeyPress}) {
            QKeyEvent event(type, Qt::Key_Return, Qt::NoModifier);
            event.setTimestamp(39479307); // both: as X11 sends them
            QCoreApplication::sendEvent(bench.button(), &event);
        }
        bool later = false;
        QTimer::singleShot(100, this, [&] { later = true; });
        QTRY_VERIFY(later);
        QCOMPARE(bench.motorStops, 0);
        QVERIFY(bench.box.jog().held());
        QTest::keyRelease(bench.button(), Qt::Key_Return);
        QTRY_COMPARE(bench.motorStops, 1);
        QCOMPARE(bench.starts, 1);
    }

    void whateverTakesTheHandAwayStopsEveryMotor_data()
    {
        QTest::addColumn<QString>("what");
        for (const char *what : {"focus", "window", "program", "dialog", "hidden", "minimised",
                 "closed", "suspect", "lost", "motor", "disarmed"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void whateverTakesTheHandAwayStopsEveryMotor()
    {
        QFETCH(QString, what);
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        QWidget second;
        QDialog dialog(&bench.window);
        if (what == QLatin1String("focus")) {
            bench.other.setFocus();
        } else if (what == QLatin1String("window")) {
            second.show();
            second.activateWindow();
            QVERIFY(QTest::qWaitForWindowActive(&second));
        } else if (what == QLatin1String("program")) {
            Q_EMIT qGuiApp->applicationStateChanged(Qt::ApplicationInactive);
        } else if (what == QLatin1String("dialog")) {
            dialog.setAttribute(Qt::WA_ShowWithoutActivating); // a desktop that gives no focus
            dialog.open();
        } else if (what == QLatin1String("hidden")) {
            bench.box.hide();
        } else if (what == QLatin1String("minimised")) {
            bench.window.showMinimized();
        } else if (what == QLatin1String("closed")) {
            bench.window.close();
        } else if (what == QLatin1String("lost")) {
            facts::feed(bench.device,
                {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::Silence}});
        } else if (what == QLatin1String("suspect")) {
            facts::feed(bench.device,
                {drive::LinkChanged{drive::LinkState::Suspect, drive::LinkReason::None}});
        } else if (what == QLatin1String("motor")) {
            bench.device.setMotor(2);
        } else {
            bench.device.setArmed(false);
        }
        QCOMPARE(bench.stops, 1);
        QVERIFY(!bench.box.jog().underWay());
        QVERIFY(bench.idleWithin(1s));
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        bench.link.runFor(300ms);
        QCOMPARE(bench.starts, 1);
        QCOMPARE(bench.stops, 1);
    }

    void aPortThatIsGoneEndsIt()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        bench.device.portChanged(session::PortState::Closed, {});
        QVERIFY(!bench.box.jog().underWay());
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QVERIFY(!bench.button()->isEnabled());
        QCOMPARE(bench.motorStops, 0);
    }

    void theFirstOfTwoHoldsThatEndsIsTheEnd()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        QTest::keyPress(bench.button(), Qt::Key_Return); // the key as well
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QCOMPARE(bench.motorStops, 1);
        QVERIFY(bench.idleWithin(500ms));
        QTest::keyRelease(bench.button(), Qt::Key_Return);
        bench.link.runFor(300ms);
        QCOMPARE(bench.starts, 1);
        QCOMPARE(bench.motorStops, 1);
    }

    void theOtherWayIsShutMeanwhile()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        QVERIFY(!bench.button("jogBack")->isEnabled());
        QTest::mousePress(bench.button("jogBack"), Qt::LeftButton);
        QTest::mouseRelease(bench.button("jogBack"), Qt::LeftButton);
        QTest::keyClick(bench.button("jogBack"), Qt::Key_Return);
        bench.link.runFor(300ms);
        QCOMPARE(bench.ramps, 1);
        QVERIFY(bench.box.jog().held());
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QVERIFY(bench.idleWithin(500ms));
        bench.link.runFor(300ms);
        QVERIFY(bench.button("jogBack")->isEnabled());
    }

    void lettingGoWhileAQuestionIsOpenStopsForGood()
    {
        JogBench bench(false);
        bench.agree();
        bench.gate.confirm();
        QVERIFY(bench.press());
        // Something else asks, in whatever way it came to that: the gate takes nothing now.
        bench.gate.want(QStringLiteral("Speed ramp"), drive::SpeedRamp{1, 4000, 1s});
        QVERIFY(bench.gate.asking());
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QCOMPARE(bench.stops, 1);
        QVERIFY(!bench.gate.asking()); // a stop withdraws it
        QVERIFY(bench.idleWithin(1s));
    }

    void theKeysFocusStaysForTheNextTime()
    {
        JogBench bench;
        bench.agree();
        bench.button()->setFocus();
        for (int i = 1; i <= 3; ++i) {
            QTest::keyPress(bench.button(), Qt::Key_Return);
            QVERIFY(bench.link.runUntil([&] { return bench.state() == MotorState::Running; }, 10s));
            QTest::keyRelease(bench.button(), Qt::Key_Return);
            QTRY_COMPARE(bench.motorStops, i);
            QVERIFY(bench.idleWithin(500ms));
            bench.link.runFor(100ms);
            QVERIFY(bench.button()->hasFocus());
            QVERIFY(bench.button()->isEnabled());
            QCOMPARE(bench.starts, i);
        }
    }

    void withoutASpeedOrALimitItDoesNotBegin()
    {
        JogBench bench;
        bench.agree();
        auto *speed = bench.window.findChild<widgets::NumberEdit *>(QStringLiteral("jogSpeed"));
        speed->setText(QStringLiteral("0"));
        QVERIFY(!bench.button()->isEnabled());
        QVERIFY(!bench.button()->toolTip().isEmpty());
        bench.box.jog().hold(0);
        QVERIFY(!bench.box.jog().underWay());

        // An expert's board that tells no speed: nothing says what would be slow.
        drive::Identified board = *bench.device.identified();
        board.limits[0].maxSpeedRpm = 0.0;
        facts::feed(bench.device, {board, facts::status(MotorState::Idle)});
        bench.device.setArmed(true);
        speed->setText(QStringLiteral("60"));
        bench.box.follow();
        QVERIFY(!bench.button()->isEnabled());
        QVERIFY2(bench.button()->toolTip().contains(QStringLiteral("limit")),
            qPrintable(bench.button()->toolTip()));
        bench.box.jog().hold(60);
        bench.link.runFor(300ms);
        QVERIFY(!bench.box.jog().underWay());
        QCOMPARE(bench.ramps, 0);
    }

    void aStopEndsItOnce()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        bench.device.stop(); // what Esc does
        QCOMPARE(bench.stops, 1);
        QVERIFY(!bench.box.jog().underWay());
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QVERIFY(bench.idleWithin(1s));
        QCOMPARE(bench.stops, 1);
        QVERIFY(!bench.device.armed());
    }

    void letGoBeforeItStartedItDoesNotStart()
    {
        JogBench bench;
        bench.agree();
        bench.button()->setFocus();
        QTest::mousePress(bench.button(), Qt::LeftButton);
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        bench.link.runFor(3s);
        QCOMPARE(bench.starts, 0);
        QVERIFY(bench.state() == MotorState::Idle);
        QVERIFY(!bench.box.jog().underWay());
    }

    void whatDoesNotStopWhenLetGoIsStoppedForGood()
    {
        JogBench bench;
        bench.agree();
        QVERIFY(bench.press());
        // The one STOP of letting go is lost on its way.
        int lost = 0;
        bench.link.loses = [&](const Bytes &bytes) {
            const bool isStop = bytes == Bytes{0x21, 0x00}; // command 4 of motor 1
            return isStop && lost++ == 0;
        };
        QTest::mouseRelease(bench.button(), Qt::LeftButton);
        QVERIFY(bench.idleWithin(3s));
        QCOMPARE(lost > 0, true);
        QVERIFY(!bench.box.jog().underWay());
    }

    void itIsSlowAndBeginsAtAnIdleMotorOnly()
    {
        JogBench bench;
        auto *speed = bench.window.findChild<widgets::NumberEdit *>(QStringLiteral("jogSpeed"));
        QCOMPARE(speed->limit(), 800.0); // a fifth of 4000 rpm
        QVERIFY(speed->sentValue().value_or(0.0) > 0.0);
        speed->setText(QStringLiteral("801"));
        QVERIFY(!bench.button()->isEnabled());
        speed->setText(QStringLiteral("600"));
        QVERIFY(bench.button()->isEnabled());
        bench.device.setUserLimits({1000.0, 0.0});
        QCOMPARE(speed->limit(), 200.0);
        facts::feed(bench.device, {facts::status(MotorState::Running)});
        bench.box.follow();
        QVERIFY(!bench.button()->isEnabled());
        QVERIFY(!bench.button()->toolTip().isEmpty());
    }

    void backwardsIsBackwards()
    {
        JogBench bench;
        bench.agree();
        std::int32_t rpm = 0;
        connect(&bench.device, &widgets::Device::wishMade, this, [&](const drive::Wish &wish) {
            if (const auto *ramp = std::get_if<drive::SpeedRamp>(&wish.what))
                rpm = ramp->rpm;
        });
        QTest::mousePress(bench.button("jogBack"), Qt::LeftButton);
        QVERIFY(rpm < 0);
        QTest::mouseRelease(bench.button("jogBack"), Qt::LeftButton);
    }
};

QTEST_MAIN(TestJog)
#include "tst_jog.moc"
