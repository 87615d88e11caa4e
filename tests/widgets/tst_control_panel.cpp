#include "support/window_facts.h"
#include "widgets/control_panel.h"
#include "widgets/motion_gate.h"
#include "widgets/motor_button.h"
#include "widgets/setpoint_edit.h"
#include "widgets/setpoint_text.h"

#include <QCheckBox>
#include <QLabel>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QWheelEvent>

using widgets::SetpointError;

class TestControlPanel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void init()
    {
        m_device = std::make_unique<widgets::Device>();
        m_registers = std::make_unique<widgets::RegisterModel>();
        m_motion = std::make_unique<widgets::MotionGate>(*m_device, *m_registers);
        m_panel = std::make_unique<widgets::ControlPanel>(*m_device, *m_registers, *m_motion);
        // What is asked is the business of tst_motion_gate: here everything is agreed to.
        connect(m_motion.get(), &widgets::MotionGate::asked, m_motion.get(),
            &widgets::MotionGate::confirm);
        m_wishes.clear();
        connect(m_device.get(), &widgets::Device::wishMade, this,
            [this](const drive::Wish &wish) { m_wishes.push_back(wish); });
        connect(m_device.get(), &widgets::Device::armWished, m_device.get(),
            &widgets::Device::armedChanged); // the session's part
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
    }
    void cleanup()
    {
        m_panel.reset();
        m_motion.reset();
        m_registers.reset();
        m_device.reset();
    }

    void setPointsAreReadStrictly_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("ok");
        QTest::addColumn<double>("value");
        const auto good = [](const char *text, double value) {
            QTest::newRow(text) << QString::fromUtf8(text) << true << value;
        };
        const auto bad = [](const char *name, const char *text) {
            QTest::newRow(name) << QString::fromUtf8(text) << false << 0.0;
        };
        good("1500", 1500.0);
        good("-1500", -1500.0);
        good("+12", 12.0);
        good("1.234", 1.234);
        good("1,5", 1.5);
        good(" 7 ", 7.0);
        good(".5", 0.5);
        good("5.", 5.0);
        good("-0", 0.0);
        good("\u22123", -3.0);
        bad("nothing", "");
        bad("exponent", "1e3");
        bad("group", "1.234,5");
        bad("groups", "1,234,567");
        bad("apostrophe", "1'000");
        bad("space", "1 000");
        bad("hex", "0x10");
        bad("nan", "nan");
        bad("inf", "inf");
        bad("sign only", "-");
        bad("two signs", "--5");
        bad("point only", ".");
        bad("unit", "5 rpm");
        bad("long", "12345678901234567890");
        bad("arabic digits", "\u0661\u0662");
    }
    void setPointsAreReadStrictly()
    {
        QFETCH(QString, text);
        QFETCH(bool, ok);
        QFETCH(double, value);
        for (const QLocale &locale :
            {QLocale::c(), QLocale(QLocale::German), QLocale(QLocale::French)}) {
            QLocale::setDefault(locale);
            const auto read = widgets::readSetpoint(text);
            QCOMPARE(read.has_value(), ok);
            if (ok)
                QCOMPARE(*read, value);
            else
                QVERIFY(!widgets::setpointErrorText(read.error()).isEmpty());
        }
        QLocale::setDefault(QLocale::c());
    }

    void whatIsSentIsWhatIsEchoed()
    {
        facts::connectBoard(*m_device);
        auto *speed = m_panel->speed();
        speed->setText(QStringLiteral("1501"));
        QVERIFY2(speed->echo().contains(QStringLiteral("1500")), qPrintable(speed->echo()));
        QCOMPARE(speed->sentValue(), std::optional(1500.0));
        speed->setText(QStringLiteral("4001"));
        QVERIFY2(
            speed->echo().contains(QStringLiteral("4000")), qPrintable(speed->echo())); // the limit
        QVERIFY(!speed->sentValue());
        speed->setText(QStringLiteral("4000"));
        QCOMPARE(speed->sentValue(),
            std::optional(3996.0)); // a step of 6 rpm below the limit, not beyond it
    }

    void nothingIsSentWhileAPersonTypes()
    {
        arm();
        QTest::keyClicks(m_panel->speed(), QStringLiteral("1500"));
        QVERIFY(m_wishes.empty());
    }

    void enterSendsOneRamp()
    {
        arm();
        m_panel->speed()->setText(QStringLiteral("1500"));
        m_panel->findChild<QSpinBox *>(QStringLiteral("rampTime"))->setValue(250);
        QTest::keyClick(m_panel->speed(), Qt::Key_Return);
        QCOMPARE(m_wishes.size(), 1U);
        const auto &ramp = std::get<drive::SpeedRamp>(m_wishes[0].what);
        QCOMPARE(ramp.rpm, 1500);
        QCOMPARE(ramp.motor, 1);
        QCOMPARE(ramp.duration.count(), 250);
    }

    void aTextThatIsNotUnderstoodIsNotSent()
    {
        arm();
        for (const char *text : {"", "1e3", "4001", "-4001", "1.2.3"}) {
            m_panel->speed()->setText(QString::fromLatin1(text));
            QTest::keyClick(m_panel->speed(), Qt::Key_Return);
        }
        QVERIFY(m_wishes.empty());
    }

    void withoutArmNothingMovesAndTheReasonIsSaid()
    {
        facts::connectBoard(*m_device);
        for (const char *name : {"start", "go", "stopRamp", "acknowledge"}) {
            QVERIFY(!button(name)->isEnabled());
            QCOMPARE(button(name)->toolTip(), QStringLiteral("Arm first."));
        }
        m_panel->start();
        m_panel->speed()->setText(QStringLiteral("1500"));
        QTest::keyClick(m_panel->speed(), Qt::Key_Return);
        QVERIFY(m_wishes.empty());
        QVERIFY(button("stop")->isEnabled());
    }

    void startIsSentOnceArmed()
    {
        arm();
        QTest::mouseClick(button("start"), Qt::LeftButton);
        QCOMPARE(m_wishes.size(), 1U);
        QVERIFY(std::get<drive::Command>(m_wishes[0].what).action == drive::MotorAction::Start);
    }

    void theSpaceBarStartsNothing()
    {
        arm();
        for (const char *name : {"start", "go", "acknowledge", "stopRamp"}) {
            button(name)->setFocus();
            QTest::keyClick(button(name), Qt::Key_Space);
        }
        QVERIFY(m_wishes.empty());
    }

    void aRunningMotorIsNotStartedAgain()
    {
        arm();
        facts::feed(*m_device, {facts::status(drive::MotorState::Running)});
        m_panel->start();
        QVERIFY(m_wishes.empty());
        QVERIFY(!button("start")->isEnabled());
    }

    void aPresentFaultCannotBeAcknowledged()
    {
        arm();
        drive::MotorStatus fault = facts::status(drive::MotorState::FaultNow);
        fault.faultsNow = {"OVER_VOLT"};
        facts::feed(*m_device, {fault});
        m_panel->acknowledge();
        QVERIFY(m_wishes.empty());
        QVERIFY(label("faultsNow").contains(QStringLiteral("OVER_VOLT")));

        drive::MotorStatus over = facts::status(drive::MotorState::FaultOver);
        over.faultsPast = {"OVER_VOLT"};
        facts::feed(*m_device, {over});
        m_panel->acknowledge();
        QCOMPARE(m_wishes.size(), 1U);
        QVERIFY(label("faultsPast").contains(QStringLiteral("OVER_VOLT")));
    }

    void aLostLinkDisarms()
    {
        arm();
        facts::feed(
            *m_device, {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::Silence}});
        QVERIFY(!m_device->armed());
        QVERIFY(!button("start")->isEnabled());
    }

    void aStateThatIsNotKnownHasNoColour()
    {
        facts::connectBoard(*m_device);
        const auto colour = [this] {
            return m_panel->findChild<QLabel *>(QStringLiteral("motorState"))
                ->palette()
                .color(QPalette::Active, QPalette::WindowText);
        };
        const QColor plain = colour();
        facts::feed(*m_device, {facts::status(drive::MotorState::Running)});
        QVERIFY(colour() != plain);
        facts::feed(
            *m_device, {drive::LinkChanged{drive::LinkState::Suspect, drive::LinkReason::None}});
        QCOMPARE(colour(), plain);
    }

    void aStopDisarmsAndForgetsTheSetPoint()
    {
        arm();
        m_panel->speed()->setText(QStringLiteral("1500"));
        QSignalSpy stops(m_device.get(), &widgets::Device::stopWished);
        QTest::mousePress(button("stop"), Qt::LeftButton); // on press: the release never comes
        QCOMPARE(stops.size(), 1);
        QVERIFY(!m_device->armed());
        facts::feed(*m_device, {drive::StopProgress{1, drive::StopWord::Requested, {}}});
        QCOMPARE(m_panel->speed()->value(), std::optional(0.0));
        QTest::mouseRelease(button("stop"), Qt::LeftButton);
        QCOMPARE(stops.size(), 1);
        QVERIFY(m_wishes.empty());
    }

    void theWheelActsOnlyWhereItIsMeantTo()
    {
        auto *speed = m_panel->speed();
        facts::connectBoard(*m_device);
        speed->setText(QStringLiteral("600"));
        speed->setFocus();
        turnWheel(speed);
        QCOMPARE(speed->value(), std::optional(600.0)); // not armed
        m_device->setArmed(true);
        m_panel->findChild<QSpinBox *>(QStringLiteral("rampTime"))->setFocus();
        turnWheel(speed);
        QCOMPARE(speed->value(), std::optional(600.0)); // not focused
        speed->setFocus();
        turnWheel(speed);
        QCOMPARE(speed->value(), std::optional(606.0));
        QVERIFY(m_wishes.empty()); // stepping is not sending
    }

    void aRefusalIsTold()
    {
        arm();
        QSignalSpy failed(m_motion.get(), &widgets::MotionGate::failed);
        m_panel->start();
        drive::Ended ended;
        ended.id = m_wishes.at(0).id;
        ended.outcome = drive::Outcome::Refused;
        ended.reason = "CMD_NOK";
        facts::feed(*m_device, {ended});
        QCOMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().contains(QStringLiteral("CMD_NOK")));
    }

    void theLimitIsTheBoards()
    {
        facts::connectBoard(*m_device);
        QCOMPARE(m_panel->speed()->limit(), 4000.0);
    }

private:
    void arm()
    {
        facts::connectBoard(*m_device);
        auto *box = m_panel->findChild<QCheckBox *>(QStringLiteral("arm"));
        QTest::keyClick(box, Qt::Key_Space);
        QVERIFY(m_device->armed());
        QVERIFY(box->isChecked());
    }
    QPushButton *button(const char *name) const
    {
        return m_panel->findChild<QPushButton *>(QLatin1String(name));
    }
    QString label(const char *name) const
    {
        return m_panel->findChild<QLabel *>(QLatin1String(name))->text();
    }
    static void turnWheel(QWidget *widget)
    {
        QWheelEvent wheel(QPointF(5, 5), widget->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, 120),
            Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(widget, &wheel);
    }

    std::unique_ptr<widgets::Device> m_device;
    std::unique_ptr<widgets::RegisterModel> m_registers;
    std::unique_ptr<widgets::MotionGate> m_motion;
    std::unique_ptr<widgets::ControlPanel> m_panel;
    std::vector<drive::Wish> m_wishes;
};

QTEST_MAIN(TestControlPanel)
#include "tst_control_panel.moc"
