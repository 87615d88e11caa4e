#include "support/window_facts.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/control/fault_help.h"
#include "widgets/control/fault_texts.h"
#include "widgets/control/limits_dialog.h"
#include "widgets/control/motion_gate.h"
#include "widgets/control/motion_question.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/panel.h"
#include "widgets/control/state_strip.h"
#include "widgets/control/stop_words.h"
#include "widgets/scope/events/fault_records.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>

#include <numbers>

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

    /// Nor does anything in it need more lines then.
    void aNarrowerPanelHasNoScrollBarWhileThereIsRoom()
    {
        auto *scroll = m_panel->findChild<QScrollArea *>(QStringLiteral("controlScroll"));
        facts::connectBoard(*m_device);
        m_device->setUserLimits({1500.0, 2.5});
        m_panel->resize(700, 1200);
        QCoreApplication::processEvents();
        const int wide = scroll->height();
        m_panel->resize(m_panel->minimumSizeHint().width(), 1200);
        QTRY_COMPARE(scroll->verticalScrollBar()->maximum(), 0);
        QCOMPARE(scroll->height(), wide);
        QVERIFY(!scroll->verticalScrollBar()->isVisible());
    }

    /// Which is on the screen while the pointer rests on the button.
    void theToolTipOfAReasonGoesWithTheReason()
    {
        facts::connectBoard(*m_device);
        auto *start = m_panel->findChild<widgets::MotorButton *>(QStringLiteral("start"));
        QVERIFY(!start->isEnabled()); // disarmed
        const QPoint at = start->mapTo(m_panel.get(), start->rect().center());
        QTest::mouseMove(m_panel->windowHandle(), at);
        QTRY_VERIFY(start->underMouse());
        QToolTip::showText(start->mapToGlobal(start->rect().center()), start->toolTip(), start);
        QVERIFY(QToolTip::isVisible());
        m_device->armedChanged(true);
        QVERIFY(start->isEnabled());
        QTRY_VERIFY(!QToolTip::isVisible());
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
        // The limit.
        QVERIFY2(speed->echo().contains(QStringLiteral("4000")), qPrintable(speed->echo()));
        QVERIFY(!speed->sentValue());
        speed->setText(QStringLiteral("4000"));
        // A step of 6 rpm below the limit, not beyond it.
        QCOMPARE(speed->sentValue(), std::optional(3996.0));
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
        edit("rampTime")->setText(QStringLiteral("250"));
        QTest::keyClick(m_panel->speed(), Qt::Key_Return);
        QCOMPARE(m_wishes.size(), 1U);
        const auto &ramp = std::get<drive::SpeedRamp>(m_wishes[0].what);
        QCOMPARE(ramp.rpm, 1500);
        QCOMPARE(ramp.motor, 1);
        QCOMPARE(ramp.duration.count(), 250);
    }

    void theTimeIsReadAsStrictly()
    {
        arm();
        m_panel->speed()->setText(QStringLiteral("600"));
        for (const QLocale &locale : {QLocale::c(), QLocale(QLocale::German)}) {
            QLocale::setDefault(locale);
            for (const char *text : {"", "1.500,0", "1 500", "-1", "65536", "1e3"}) {
                edit("rampTime")->setText(QString::fromLatin1(text));
                QTest::keyClick(m_panel->speed(), Qt::Key_Return);
                QVERIFY2(m_wishes.empty(), text);
                QVERIFY(!button("go")->isEnabled());
                QCOMPARE(label("speedEcho"), // and why, and which of the two fields
                    QStringLiteral("\u2716 Ramp time: ") + edit("rampTime")->echo());
                QVERIFY(m_panel->findChild<QLabel *>(QStringLiteral("speedEcho"))->isEnabled());
            }
        }
        QLocale::setDefault(QLocale::c());
        edit("rampTime")->setText(QStringLiteral("65535"));
        QTest::keyClick(edit("rampTime"), Qt::Key_Return);
        QCOMPARE(std::get<drive::SpeedRamp>(m_wishes.at(0).what).duration.count(), 65535);
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
        edit("rampTime")->setFocus();
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

    void theStripLightsTheFirmwaresState()
    {
        facts::connectBoard(*m_device);
        auto *strip = m_panel->findChild<widgets::StateStrip *>();
        QVERIFY(strip->litName().isEmpty()); // a state without a name lights nothing
        const auto show = [&](drive::MotorState state, const char *name) {
            drive::MotorStatus status = facts::status(state);
            status.stateName = name;
            facts::feed(*m_device, {status});
        };
        const QImage dark = strip->grab().toImage();
        show(drive::MotorState::Starting, "CHARGE_BOOT_CAP");
        QCOMPARE(strip->litName(), QStringLiteral("CHARGE_BOOT_CAP"));
        QVERIFY(strip->accessibleName().contains(QStringLiteral("CHARGE_BOOT_CAP")));
        const QImage charging = strip->grab().toImage();
        QVERIFY(charging != dark);
        show(drive::MotorState::Running, "RUN");
        QVERIFY(strip->grab().toImage() != charging);
        show(drive::MotorState::Unknown, "NEVER_HEARD_OF");
        QVERIFY(strip->litName().isEmpty());
        QVERIFY(label("motorState").contains(QStringLiteral("NEVER_HEARD_OF")));
        show(drive::MotorState::Running, "RUN");
        facts::feed(
            *m_device, {drive::LinkChanged{drive::LinkState::Suspect, drive::LinkReason::None}});
        QVERIFY(strip->litName().isEmpty());
        QCOMPARE(strip->grab().toImage(), dark);
    }

    /// As an MCB drive has them, in the panel of a window that is 1280 wide.
    void aLongNameOfAStateIsReadWhole()
    {
        using drive::MotorState;
        widgets::StateStrip strip;
        strip.setSteps({{MotorState::Idle, {"SWITCH_ON_DISABLED"}},
            {MotorState::Starting, {"SWITCHED_ON"}}, {MotorState::Running, {"OPERATION_ENABLED"}},
            {MotorState::Stopping, {"QUICK_STOP_ACTIVE"}},
            {MotorState::FaultNow, {"FAULT_REACTION_ACTIVE"}}, {MotorState::FaultOver, {"FAULT"}}});
        strip.resize(306, strip.sizeHint().height());
        drive::MotorStatus status = facts::status(MotorState::Running);
        status.stateName = "OPERATION_ENABLED";
        strip.show(status, true);
        QCOMPARE(strip.textIn(2), QStringLiteral("\u25cf OPERATION_ENABLED"));
        QCOMPARE(strip.textIn(0), QStringLiteral("SWITCH_ON_DISABLED"));
    }

    void faultsAreExplained()
    {
        facts::connectBoard(*m_device);
        auto *causes = m_panel->findChild<QToolButton *>(QStringLiteral("faultCauses"));
        QVERIFY(!causes->isVisible());
        drive::MotorStatus fault = facts::status(drive::MotorState::FaultNow);
        fault.faultsNow = {"START_UP"};
        fault.faultsPast = {"OVER_VOLT", "bit 11"};
        facts::feed(*m_device, {fault});
        QVERIFY(causes->isVisible());
        QSignalSpy wanted(m_panel.get(), &widgets::ControlPanel::causesWanted);
        causes->click();
        QCOMPARE(wanted.size(), 1);
        const capture::Capture capture;
        const widgets::FaultRecords records(capture);
        widgets::FaultHelp shown(*m_device, records);
        auto *help = &shown;
        help->setAttribute(Qt::WA_DeleteOnClose, false);
        help->present();
        QVERIFY(help->isVisible() && !help->isModal());
        QVERIFY(help->findChild<widgets::StopButton *>()->height() >= 48);
        const QString text = help->plainText();
        qsizetype at = 0; // in this order
        for (const char *part :
            {"START_UP", "ramp longer", "G2", "OVER_VOLT", "brakes", "bit 11"}) {
            at = text.indexOf(QString::fromUtf8(part), at);
            QVERIFY2(at >= 0, part);
        }
        facts::feed(*m_device, {facts::status(drive::MotorState::Idle)});
        QVERIFY(!help->plainText().contains(QStringLiteral("START_UP")));
    }

    void aFaultThatIsPresentIsNotToldTwice()
    {
        facts::connectBoard(*m_device);
        drive::MotorStatus fault = facts::status(drive::MotorState::FaultNow);
        fault.faultsNow = {"OVER_VOLT"}; // firmware has it among the past ones as well
        fault.faultsPast = {"OVER_VOLT", "SPEED_FDBK"};
        facts::feed(*m_device, {fault});
        QVERIFY(label("faultsNow").contains(QStringLiteral("OVER_VOLT")));
        QVERIFY(!label("faultsPast").contains(QStringLiteral("OVER_VOLT")));
        QVERIFY(label("faultsPast").contains(QStringLiteral("SPEED_FDBK")));
        const capture::Capture capture;
        const widgets::FaultRecords records(capture);
        const QString text = widgets::FaultHelp(*m_device, records).plainText();
        QCOMPARE(text.count(QStringLiteral("OVER_VOLT")), 1);
    }

    void everyFaultHasCausesAndRemedies()
    {
        for (int kind = 0; kind <= int(catalog::FaultKind::DriverProtection); ++kind) {
            const widgets::FaultText text = widgets::faultText(catalog::FaultKind(kind));
            QVERIFY(!text.meaning.isEmpty());
            QVERIFY(!text.causes.isEmpty());
            for (const auto &cause : text.causes)
                QVERIFY(!cause.cause.isEmpty());
        }
    }

    void eachKindOfSetPointIsItsOwnWish()
    {
        arm();
        auto *mode = m_panel->findChild<QComboBox *>(QStringLiteral("setpointMode"));
        QVERIFY(edit("speed")->isVisible() && !edit("torque")->isVisible());
        mode->setCurrentIndex(1);
        QVERIFY(m_wishes.empty()); // choosing sends nothing
        QVERIFY(!edit("speed")->isVisible() && edit("torque")->isVisible());
        QCOMPARE(edit("torque")->limit(), 5.0);
        edit("torque")->setText(QStringLiteral("-1,25"));
        QTest::keyClick(edit("torque"), Qt::Key_Return);
        QCOMPARE(m_wishes.size(), 1U);
        QCOMPARE(std::get<drive::TorqueRamp>(m_wishes[0].what).amps, -1.25);
        edit("torque")->setText(QStringLiteral("5.01"));
        QTest::keyClick(edit("torque"), Qt::Key_Return);
        QCOMPARE(m_wishes.size(), 1U);

        mode->setCurrentIndex(2);
        edit("iqReference")->setText(QStringLiteral("1"));
        edit("idReference")->setText(QStringLiteral("x"));
        QVERIFY(!button("go")->isEnabled());
        QTest::keyClick(edit("iqReference"), Qt::Key_Return);
        QCOMPARE(m_wishes.size(), 1U);
        edit("idReference")->setText(QStringLiteral("-0.5"));
        QTest::mouseClick(button("go"), Qt::LeftButton);
        QCOMPARE(m_wishes.size(), 2U);
        const auto &both = std::get<drive::CurrentReference>(m_wishes[1].what);
        QCOMPARE(both.iqAmps, 1.0);
        QCOMPARE(both.idAmps, -0.5);
    }

    void aMoveOfTheShaftIsAWishOfItsOwn()
    {
        constexpr std::uint32_t kShaft = 0xA58;
        arm();
        drive::Identified board = facts::identified();
        std::vector<catalog::RegisterInfo> registers = board.catalog->registers();
        registers.push_back(facts::makeRegister(kShaft, "CURRENT_POSITION", "Position"));
        registers.back().type = catalog::ValueType::F32;
        registers.back().unit = "rad";
        board.catalog = std::make_shared<const catalog::Catalog>(
            std::move(registers), 1, std::vector<catalog::Scales>(1));
        facts::feed(*m_device, {board});
        m_device->setArmed(true);
        m_registers->setCatalog(board.catalog, 1);
        const auto watched = m_panel->watchedRegisters();
        QVERIFY(std::find(watched.begin(), watched.end(), kShaft) != watched.end());
        auto *mode = m_panel->findChild<QComboBox *>(QStringLiteral("setpointMode"));
        mode->setCurrentIndex(mode->findText(QStringLiteral("Position")));
        QVERIFY(edit("position")->isVisible() && !edit("speed")->isVisible());
        QCOMPARE(label("shaftNow"), QStringLiteral("\u2013")); // it was not read yet
        m_registers->accept({facts::reading(kShaft, std::numbers::pi)}, {});
        facts::feed(*m_device, {facts::status(drive::MotorState::Running)});
        QCOMPARE(label("shaftNow"), QStringLiteral("180.0\u202f\u00b0"));
        QTest::keyClick(edit("position"), Qt::Key_Return); // an empty field is no zero
        QVERIFY(m_wishes.empty() && !button("go")->isEnabled());
        QVERIFY(!button("stopRamp")->isEnabled());
        QVERIFY(button("stopRamp")->toolTip().contains(QStringLiteral("Stop")));

        edit("position")->setText(QStringLiteral("36180")); // a hundred turns away
        edit("rampTime")->setText(QStringLiteral("500"));
        QVERIFY(!button("go")->isEnabled());
        QVERIFY2(label("speedEcho").contains(QStringLiteral("the limit is 4000")),
            qPrintable(label("speedEcho")));
        edit("rampTime")->setText(QStringLiteral("0"));
        QTest::keyClick(edit("position"), Qt::Key_Return);
        QVERIFY(m_wishes.empty());

        edit("position")->setText(QStringLiteral("-90"));
        edit("rampTime")->setText(QStringLiteral("1500"));
        QVERIFY(button("go")->isEnabled());
        QVERIFY(label("speedEcho").contains(QStringLiteral("rpm on the way")));
        QTest::keyClick(edit("position"), Qt::Key_Return);
        QCOMPARE(m_wishes.size(), 1U);
        const auto &ramp = std::get<drive::PositionRamp>(m_wishes[0].what);
        QVERIFY(std::abs(ramp.radians + std::numbers::pi / 2) < 1e-9);
        QCOMPARE(ramp.duration.count(), 1500);
        facts::feed(*m_device, {drive::StopProgress{1, drive::StopWord::Requested, {}}});
        QVERIFY(edit("position")->text().isEmpty()); // nothing is left to be sent by accident
        QVERIFY(!edit("position")->isUndoAvailable());
    }

    void expertModeIsNoLimitToJogUnder()
    {
        facts::connectBoard(*m_device);
        drive::Identified board = facts::identified();
        board.limits[0].maxSpeedRpm = 0.0;
        board.limits[0].maxCurrentAmps = board.limits[0].nominalCurrentAmps = 0.0;
        facts::feed(*m_device, {board, facts::status(drive::MotorState::Idle)});
        m_device->setArmed(true);
        m_device->becomeExpert(1);
        drive::Ended agreed;
        agreed.id = m_wishes.back().id;
        agreed.outcome = drive::Outcome::Ok;
        facts::feed(*m_device, {agreed});
        QVERIFY(m_device->expert(1));
        QVERIFY(label("limits").contains(QStringLiteral("Limits: none")));
        QVERIFY(!label("limits").contains(QStringLiteral("500000")));
        QVERIFY(!button("jogForth")->isEnabled());
        QVERIFY(button("jogForth")->toolTip().contains(QStringLiteral("one of your own")));
        m_device->setUserLimits({1200.0, 0.0});
        QVERIFY(button("jogForth")->isEnabled());
        QCOMPARE(edit("jogSpeed")->value(), std::optional(120.0)); // a tenth
        QCOMPARE(edit("jogSpeed")->limit(), 240.0);
    }

    void whatTheBoardDoesNotHaveSaysWhy()
    {
        facts::connectBoard(*m_device);
        drive::Identified board = facts::identified();
        board.capabilities = {{drive::Feature::TorqueRamp, false, "No torque here."}};
        facts::feed(*m_device, {board});
        m_device->setArmed(true);
        m_panel->findChild<QComboBox *>(QStringLiteral("setpointMode"))->setCurrentIndex(1);
        QVERIFY(!button("go")->isEnabled());
        QVERIFY(button("go")->toolTip().contains(QStringLiteral("No torque here.")));
        const auto *mode = m_panel->findChild<QComboBox *>(QStringLiteral("setpointMode"));
        const auto enabled = [&](int row) {
            return bool(mode->model()->flags(mode->model()->index(row, 0)) & Qt::ItemIsEnabled);
        };
        QVERIFY(enabled(0) && !enabled(1)); // grey in the list, with the reason
        QVERIFY(mode->itemData(1, Qt::ToolTipRole)
                    .toString()
                    .contains(QStringLiteral("No torque here.")));
        facts::feed(*m_device, {facts::identified()});
        QVERIFY(enabled(1));
    }

    void onesOwnLimitIsTheLowerOne()
    {
        facts::connectBoard(*m_device);
        m_device->setUserLimits({2000.0, 100.0});
        QCOMPARE(m_panel->speed()->limit(), 2000.0);
        QVERIFY(label("limits").contains(QStringLiteral("2000\u202frpm (yours)")));
        QVERIFY(label("limits").contains(QStringLiteral("5.00\u202fA")));
        QVERIFY(std::get<drive::UserLimits>(m_wishes.back().what)
            == (drive::UserLimits{2000.0, 100.0}));
        m_device->setUserLimits({});
        QCOMPARE(m_panel->speed()->limit(), 4000.0);
    }

    void withoutLimitsAPersonHasToAgreeFirst()
    {
        facts::connectBoard(*m_device);
        drive::Identified board = facts::identified();
        board.limits[0].nominalCurrentAmps = 0.0;
        facts::feed(*m_device, {board, facts::status(drive::MotorState::Idle)});
        m_device->setArmed(true);
        QSignalSpy needed(m_motion.get(), &widgets::MotionGate::expertNeeded);
        m_panel->start();
        m_panel->speed()->setText(QStringLiteral("600"));
        QTest::keyClick(m_panel->speed(), Qt::Key_Return);
        QCOMPARE(needed.size(), 2);
        QVERIFY(m_wishes.empty());
        m_panel->stopRamp(); // what ends motion needs no limits
        QCOMPARE(m_wishes.size(), 1U);

        widgets::askForExpert(*m_device, 1, m_panel.get());
        auto *question = m_panel->findChild<QDialog *>(QStringLiteral("expertQuestion"));
        auto *yes = question->findChild<QPushButton *>(QStringLiteral("expertConfirm"));
        QVERIFY(!yes->isEnabled());
        question->findChild<QLineEdit *>(QStringLiteral("confirmationTyped"))
            ->setText(QStringLiteral("motor 1"));
        yes->click();
        QCOMPARE(std::get<drive::ExpertMode>(m_wishes.back().what).motor, 1);
        drive::Ended done;
        done.id = m_wishes.back().id;
        facts::feed(*m_device, {done});
        QVERIFY(m_device->expert(1));
        QVERIFY(label("limits").contains(QStringLiteral("Expert mode")));
        m_panel->start();
        QVERIFY(std::holds_alternative<drive::Command>(m_wishes.back().what));
        facts::feed(
            *m_device, {drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::Silence}});
        QVERIFY(!m_device->expert(1)); // ends with the connection
    }

    void limitsAreTypedStrictly()
    {
        widgets::LimitsDialog dialog({1500.0, 0.0});
        std::vector<drive::UserLimits> chosen;
        connect(&dialog, &widgets::LimitsDialog::chosen, this,
            [&](const drive::UserLimits &limits) { chosen.push_back(limits); });
        auto *speed = dialog.findChild<QLineEdit *>(QStringLiteral("limitSpeed"));
        auto *current = dialog.findChild<QLineEdit *>(QStringLiteral("limitCurrent"));
        auto *ok = dialog.findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok);
        QCOMPARE(speed->text(), QStringLiteral("1500"));
        QVERIFY(current->text().isEmpty());
        for (const char *odd : {"0", "-5", "1e3", "1.2.3", "nan", "x"}) {
            current->setText(QString::fromLatin1(odd));
            QVERIFY2(!ok->isEnabled(), odd);
        }
        current->setText(QStringLiteral("2,5"));
        speed->clear();
        dialog.setAttribute(Qt::WA_DeleteOnClose, false);
        ok->click();
        QCOMPARE(chosen.size(), 1U);
        QVERIFY(chosen[0] == (drive::UserLimits{0.0, 2.5}));
    }

    void stateAndStopStayInViewInALowWindow()
    {
        arm();
        m_panel->resize(m_panel->minimumSizeHint().width(), 430);
        facts::feed(*m_device, {drive::StopProgress{1, drive::StopWord::Requested, {}}});
        QCoreApplication::processEvents();
        for (const char *name : {"motorState", "stateStrip", "arm", "start", "stop"}) {
            const auto *widget = m_panel->findChild<QWidget *>(QLatin1String(name));
            const QRect place(widget->mapTo(m_panel.get(), QPoint()), widget->size());
            QVERIFY2(m_panel->rect().contains(place), name);
        }
        auto *scroll = m_panel->findChild<QScrollArea *>(QStringLiteral("controlScroll"));
        QVERIFY(scroll->widget()->width() <= scroll->viewport()->width()); // nothing cut at a side
    }

    void theWordsOfAStopGoWhenTheMotorTurnsAgain()
    {
        arm();
        const auto *words = m_panel->findChild<widgets::StopWords *>();
        using drive::MotorState;
        facts::feed(*m_device, {facts::status(MotorState::Running)});
        for (const auto word :
            {drive::StopWord::Requested, drive::StopWord::Accepted, drive::StopWord::DriveIdle}) {
            facts::feed(*m_device, {drive::StopProgress{1, word, {}}});
            facts::feed(*m_device, {facts::status(MotorState::Running)});
            QVERIFY(words->isVisible()); // it still turns: the stop is not over
        }
        facts::feed(*m_device,
            {facts::status(MotorState::Idle),
                drive::StopProgress{1, drive::StopWord::Standstill, {}}});
        QVERIFY(words->isVisible());
        facts::feed(*m_device, {facts::status(MotorState::Starting)});
        QVERIFY(!words->isVisible());
        facts::feed(*m_device, {drive::StopProgress{1, drive::StopWord::Requested, {}}});
        QVERIFY(words->isVisible());
    }

    void aStateOfBeforeASilenceIsNotTakenForThePresent()
    {
        facts::connectBoard(*m_device);
        facts::feed(*m_device, {facts::status(drive::MotorState::Running)});
        const auto *state = m_panel->findChild<QLabel *>(QStringLiteral("motorState"));
        QCOMPARE(state->text(), QStringLiteral("Running"));
        using drive::LinkReason;
        using drive::LinkState;
        facts::feed(*m_device, {drive::LinkChanged{LinkState::Recovering, LinkReason::None}});
        facts::feed(*m_device, {drive::LinkChanged{LinkState::Connected, LinkReason::None}});
        // And has not told its state yet.
        QCOMPARE(state->text(), QStringLiteral("board answering"));
        QVERIFY(!state->isEnabled());
        facts::feed(*m_device, {facts::status(drive::MotorState::Idle)});
        QCOMPARE(state->text(), QStringLiteral("Idle"));
        QVERIFY(state->isEnabled());
    }

    void wordsOfRestGoWhenTheMotorIsStartedBeforeTheLastOfThem()
    {
        facts::connectBoard(*m_device);
        auto *words = m_panel->findChild<widgets::StopWords *>();
        for (const auto word : {drive::StopWord::Requested, drive::StopWord::DriveIdle})
            facts::feed(*m_device, {drive::StopProgress{1, word, {}}});
        facts::feed(*m_device, {facts::status(drive::MotorState::Idle)});
        QVERIFY(words->isVisible());
        facts::feed(*m_device, {facts::status(drive::MotorState::Starting)});
        QVERIFY(!words->isVisible());
    }

    void whatNothingMeasuresIsNoStandstillAndGoesWithItsBoard()
    {
        facts::connectBoard(*m_device);
        auto *words = m_panel->findChild<widgets::StopWords *>();
        for (const auto word : {drive::StopWord::Requested, drive::StopWord::Accepted,
                 drive::StopWord::DriveIdle, drive::StopWord::MayCoast})
            facts::feed(*m_device, {drive::StopProgress{1, word, {}}});
        QVERIFY(words->rested());
        QVERIFY(words->isVisible());
        QVERIFY(
            words->text().contains(QStringLiteral("speed not measurable: the rotor may coast")));
        QVERIFY(!words->text().contains(QStringLiteral("standstill")));
        facts::feed(*m_device, {drive::StopProgress{2, drive::StopWord::Requested, {}}});
        QVERIFY(!words->rested());
        m_device->open({}); // another board: what is told of this one would be told of that one
        QVERIFY(!words->isVisible());
        QVERIFY(words->text().isEmpty());
        facts::connectBoard(*m_device); // which has one motor
        for (const auto word :
            {drive::StopWord::Requested, drive::StopWord::DriveIdle, drive::StopWord::Standstill})
            facts::feed(*m_device, {drive::StopProgress{1, word, {}}});
        QVERIFY(words->rested());
        QVERIFY(!words->text().contains(QStringLiteral("Motor 2")));
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
    widgets::NumberEdit *edit(const char *name) const
    {
        return m_panel->findChild<widgets::NumberEdit *>(QLatin1String(name));
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
