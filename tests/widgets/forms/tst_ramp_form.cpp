// The form of ramps on a simulated board in virtual time, its parts alone, and its keys in the real window.
#include "support/edit_bench.h"
#include "support/window_rig.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/motor_button.h"
#include "widgets/forms/ramp_form.h"
#include "widgets/forms/ramp_preview.h"

#include <QApplication>
#include <QComboBox>
#include <QJsonDocument>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QTest>

#include <cmath>

using namespace std::chrono_literals;
using drive::MotorAction;
using drive::MotorState;
using widgets::RampKind;
using widgets::RampProgress;
using Phase = widgets::RampProgress::Phase;

namespace {

/// A form on the board of an EditBench, its registers polled; questions are answered with yes.
struct RampBench : facts::EditBench {
    widgets::MotionGate gate{device, model};
    std::unique_ptr<widgets::RampForm> form;
    std::vector<drive::Wish> sent; ///< all that can move something
    int questionsOfMotion = 0;
    std::vector<double> fractions;

    explicit RampBench(const simulation::BoardOptions &options = {})
        : facts::EditBench(options)
        , form(std::make_unique<widgets::RampForm>(device, model, gate))
    {
        QObject::connect(
            &gate, &widgets::MotionGate::asked, &panel,
            [this] {
                ++questionsOfMotion;
                gate.confirm();
            },
            Qt::QueuedConnection);
        QObject::connect(
            &device, &widgets::Device::wishMade, &panel, [this](const drive::Wish &wish) {
                if (!std::holds_alternative<drive::Read>(wish.what)
                    && !std::holds_alternative<drive::Watch>(wish.what))
                    sent.push_back(wish);
            });
        form->show();
        look();
    }

    /// Polls what the form watches.
    void look()
    {
        device.submit(drive::Watch{form->watchedRegisters(), 50ms});
        pass(300ms);
    }
    /// Time goes on, for board, link and form; a heartbeat every 50 ms.
    bool pass(Duration time, const std::function<bool()> &done = {})
    {
        for (const TimePoint end = link.now + time; link.now < end;) {
            link.runFor(50ms);
            QCoreApplication::processEvents();
            model.refresh(ms());
            form->refresh(ms());
            fractions.push_back(form->progress().fraction());
            if (done && done())
                return true;
        }
        return !done;
    }
    bool reach(Phase phase, Duration within = 10s)
    {
        return pass(within, [&] { return form->progress().phase() == phase; });
    }
    bool start()
    {
        arm();
        device.submit(drive::Command{MotorAction::Start, 1});
        return pass(10s, [this] { return device.status(1).state == MotorState::Running; });
    }
    template <class T>
    T *find(const char *name) const
    {
        return form->findChild<T *>(QLatin1String(name));
    }
    void type(const char *name, const QString &text)
    {
        auto *edit = find<QLineEdit>(name);
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    void enter(const char *name)
    {
        QTest::keyClick(find<QLineEdit>(name), Qt::Key_Return);
        QCoreApplication::processEvents();
    }
    QString label(const char *name) const { return find<QLabel>(name)->text(); }
    double number(const char *name) { return model.shownValue(id(name)).value_or(std::nan("")); }
    const widgets::RampPicture &picture() const
    {
        return find<widgets::RampPreview>("rampPreview")->picture();
    }
};

simulation::BoardOptions positions()
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    for (const auto &option : simulation::buildOptions())
        if (option.name == "position")
            options.with.push_back(&option);
    return options;
}

RampProgress::Sight running(double reference, double measured)
{
    return {MotorState::Running, true, reference, measured};
}

} // namespace

class TestRampForm : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }

    void thePreviewOfARestingMotorBeginsAtStandstillAndEndsOnAStair()
    {
        RampBench bench;
        QCOMPARE(bench.number("SPEED_REF"), 1500.0); // nothing follows it
        bench.type("rampSpeed", QStringLiteral("3001"));
        bench.type("rampSpeedTime", QStringLiteral("500"));
        const auto &plan = bench.picture().plan;
        QVERIFY(plan.size() > 100);
        QCOMPARE(plan.front().value, 0.0);
        QCOMPARE(plan.back().value, 3000.0);
        QCOMPARE(plan.back().seconds, 0.5);
        for (const auto &point : plan)
            QCOMPARE(std::fmod(point.value, 6.0), 0.0);
        const QString note = bench.label("rampSpeedNote");
        QVERIFY2(note.contains(QStringLiteral("3001 becomes 3000")), qPrintable(note));
        QVERIFY2(note.contains(QStringLiteral("6000\u202frpm/s")), qPrintable(note));
        QVERIFY2(note.contains(QStringLiteral("500 step")), qPrintable(note));
        QVERIFY(bench.sent.empty());
    }

    void theStairsAreThoseThatTheDriveTells()
    {
        RampBench bench;
        drive::Identified board = *bench.link.identified;
        const auto planFor = [&](double step) {
            board.limits.front().speedStepRpm = step;
            facts::feed(bench.device, {board});
            bench.type("rampSpeed", QStringLiteral("1003"));
            bench.type("rampSpeedTime", QStringLiteral("500"));
            return bench.picture();
        };
        const auto stairs = planFor(10.0);
        QVERIFY(stairs.stairs);
        QVERIFY(stairs.plan.size() > 50);
        QCOMPARE(stairs.plan.back().value, 1000.0);
        for (const auto &point : stairs.plan)
            QCOMPARE(std::fmod(point.value, 10.0), 0.0);
        // One that tells none has a set-point as fine as it is typed.
        const auto line = planFor(drive::MotorLimits().speedStepRpm);
        QVERIFY(!line.stairs);
        QCOMPARE(line.plan.back().value, 1003.0);
    }

    void unarmedNothingIsSentAndTheReasonIsSaid()
    {
        RampBench bench;
        for (const char *name : {"rampSpeed", "rampTorque", "rampCurrent"}) {
            bench.type(name, QStringLiteral("1"));
            bench.enter(name);
            auto *button = bench.find<widgets::MotorButton>(
                qPrintable(QLatin1String(name) + QStringLiteral("Send")));
            QVERIFY(!button->isEnabled());
            QCOMPARE(button->toolTip(), QStringLiteral("Arm first."));
        }
        QVERIFY(!bench.find<widgets::MotorButton>("rampStop")->isEnabled());
        bench.form->stopRamp();
        QVERIFY(bench.sent.empty());
    }

    void whatIsNotUnderstoodOrTooMuchIsNotSent()
    {
        RampBench bench;
        bench.arm();
        for (const char *text : {"", "1e3", "1.234,5", "4001", "-4001", "nan", "0x10"}) {
            bench.type("rampSpeed", QString::fromLatin1(text));
            if (*text == '\0')
                bench.find<QLineEdit>("rampSpeed")->clear();
            bench.enter("rampSpeed");
            QVERIFY2(!bench.find<widgets::MotorButton>("rampSpeedSend")->isEnabled(), text);
        }
        bench.type("rampSpeed", QStringLiteral("1000"));
        for (const char *text : {"-1", "65536", "abc"}) {
            bench.type("rampSpeedTime", QString::fromLatin1(text));
            bench.enter("rampSpeedTime");
        }
        bench.type("rampTorque", QStringLiteral("5.1")); // nominal is 5 A
        bench.enter("rampTorque");
        bench.type("rampCurrent", QStringLiteral("4"));
        bench.type("rampCurrentId", QStringLiteral("4")); // together 5.7 A
        bench.enter("rampCurrentId");
        QVERIFY2(bench.label("rampCurrentNote").contains(QStringLiteral("limit")),
            qPrintable(bench.label("rampCurrentNote")));
        QVERIFY(bench.sent.empty());
    }

    void typedValuesAreSentAsEchoed_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::newRow("C") << QLocale::c();
        QTest::newRow("de_DE") << QLocale(QLocale::German, QLocale::Germany);
        QTest::newRow("tr_TR") << QLocale(QLocale::Turkish, QLocale::Turkey);
    }
    void typedValuesAreSentAsEchoed()
    {
        QFETCH(QLocale, locale);
        QLocale::setDefault(locale);
        RampBench bench;
        bench.arm();
        bench.type("rampSpeed", QStringLiteral("1501"));
        bench.type("rampSpeedTime", QStringLiteral("1250"));
        bench.enter("rampSpeedTime");
        QCOMPARE(bench.sent.size(), 1U);
        const auto speed = std::get<drive::SpeedRamp>(bench.sent[0].what);
        QCOMPARE(speed.rpm, 1500);
        QCOMPARE(speed.duration.count(), 1250);
        for (const char *text : {"0,75", "0.75"}) {
            bench.type("rampTorque", QString::fromLatin1(text));
            bench.type("rampTorqueTime", QStringLiteral("200"));
            bench.enter("rampTorque");
            QCOMPARE(std::get<drive::TorqueRamp>(bench.sent.back().what).amps, 0.75);
            bench.pass(200ms);
        }
        bench.type("rampCurrent", QStringLiteral("-0,5"));
        bench.type("rampCurrentId", QStringLiteral("-.25"));
        bench.enter("rampCurrent");
        const auto current = std::get<drive::CurrentReference>(bench.sent.back().what);
        QCOMPARE(current.iqAmps, -0.5);
        QCOMPARE(current.idAmps, -0.25);
    }

    void aSpeedRampReachesItsQuantisedTargetAndTheProgressEnds()
    {
        RampBench bench;
        QVERIFY(bench.start());
        bench.pass(1s);
        bench.fractions.clear();
        bench.type("rampSpeed", QStringLiteral("2503"));
        bench.type("rampSpeedTime", QStringLiteral("800"));
        bench.enter("rampSpeed");
        QVERIFY(bench.questionsOfMotion == 1); // 1000 rpm are more than a fifth of 4000
        QVERIFY(bench.reach(Phase::Ramping, 1s));
        QVERIFY(bench.label("rampProgressText").contains(QStringLiteral("left")));
        QVERIFY(bench.reach(Phase::Arrived));
        QVERIFY(std::is_sorted(bench.fractions.begin(), bench.fractions.end()));
        const bool between = std::any_of(bench.fractions.begin(), bench.fractions.end(),
            [](double fraction) { return fraction > 0.1 && fraction < 0.9; });
        QVERIFY(between);
        QCOMPARE(bench.number("SPEED_REF"), 2502.0);
        QVERIFY(std::abs(bench.number("SPEED_MEAS") - 2502.0) < 60.0);
        QCOMPARE(bench.find<QProgressBar>("rampProgress")->value(), 1000);
        QVERIFY(bench.label("rampProgressText").contains(QStringLiteral("2502")));
        // The picture keeps plan and measurement until something else is typed.
        QCOMPARE(bench.picture().plan.back().value, 2502.0);
        bench.type("rampSpeed", QStringLiteral("2000"));
        QCOMPARE(bench.picture().plan.front().value, 2502.0);
    }

    void stopRampEndsItWhereItIs()
    {
        RampBench bench;
        QVERIFY(bench.start());
        bench.pass(1s);
        bench.type("rampSpeed", QStringLiteral("3600"));
        bench.type("rampSpeedTime", QStringLiteral("4000"));
        bench.enter("rampSpeed");
        QVERIFY(bench.reach(Phase::Ramping, 1s));
        bench.pass(1500ms);
        QTest::mouseClick(bench.find<widgets::MotorButton>("rampStop"), Qt::LeftButton);
        QVERIFY(bench.reach(Phase::Replaced, 1s));
        bench.pass(500ms);
        const double stopped = bench.number("SPEED_REF");
        QVERIFY2(stopped > 1700.0 && stopped < 3000.0, qPrintable(QString::number(stopped)));
        bench.pass(2s);
        QCOMPARE(bench.number("SPEED_REF"), stopped);
        QVERIFY(std::abs(bench.number("SPEED_MEAS") - stopped) < 60.0);
    }

    void aRampOfAStandingMotorWaitsForItsStart()
    {
        RampBench bench;
        bench.arm();
        bench.type("rampSpeed", QStringLiteral("2001"));
        bench.enter("rampSpeed");
        QVERIFY(bench.reach(Phase::Waiting, 1s));
        bench.pass(1s);
        QVERIFY(bench.form->progress().phase() == Phase::Waiting);
        QCOMPARE(bench.find<QProgressBar>("rampProgress")->value(), 0);
        QVERIFY(bench.start());
        QVERIFY2(bench.reach(Phase::Arrived), qPrintable(bench.label("rampProgressText")));
        QCOMPARE(bench.number("SPEED_REF"), 2004.0); // 2001 is 333.5 stairs
    }

    void aFaultEndsTheProgress()
    {
        RampBench bench;
        QVERIFY(bench.start());
        bench.type("rampSpeed", QStringLiteral("3000"));
        bench.type("rampSpeedTime", QStringLiteral("3000"));
        bench.enter("rampSpeed");
        QVERIFY(bench.reach(Phase::Ramping, 1s));
        bench.link.board->setFaults(0x0002);
        QVERIFY(bench.reach(Phase::MotorStopped, 2s));
        QVERIFY(bench.label("rampProgressText").contains(QStringLiteral("runs no more")));
    }

    void aTorqueRampReachesItsTarget()
    {
        RampBench bench;
        QVERIFY(bench.start());
        bench.pass(1s);
        bench.link.board->setLoadTorque(1, 0.04); // what 1 A makes, so that the motor does not race
        bench.type("rampTorque", QStringLiteral("2"));
        bench.type("rampTorqueTime", QStringLiteral("300"));
        bench.enter("rampTorque");
        bench.pass(500ms);
        QVERIFY2(std::abs(bench.number("I_Q_REF") - 2.0) < 0.01,
            qPrintable(QString::number(bench.number("I_Q_REF"))));
        QVERIFY(bench.form->progress().fraction() == 1.0);
    }

    void aPositionIsOfferedWhereTheBoardControlsIt()
    {
        RampBench plain;
        QVERIFY(plain.find<QLineEdit>("rampPosition")->isHidden());
        RampBench bench(positions());
        QVERIFY(!bench.find<QLineEdit>("rampPosition")->isHidden());
        // No 0 by accident.
        QVERIFY(!bench.find<widgets::NumberEdit>("rampPosition")->sentValue());
        QVERIFY(!bench.find<QLineEdit>("rampPosition")->isUndoAvailable());
        QVERIFY(bench.start());
        bench.type("rampPosition", QStringLiteral("90"));
        bench.type("rampPositionTime", QStringLiteral("1500"));
        const QString note = bench.label("rampPositionNote");
        QVERIFY2(note.contains(QStringLiteral("1.5708\u202frad")), qPrintable(note));
        bench.enter("rampPosition");
        QCOMPARE(bench.questionsOfMotion, 1);
        QVERIFY2(bench.reach(Phase::Arrived, 5s), qPrintable(bench.label("rampProgressText")));
        QVERIFY2(std::abs(bench.number("CURRENT_POSITION") - 1.5708) < 0.05,
            qPrintable(QString::number(bench.number("CURRENT_POSITION"))));
        QCOMPARE(bench.picture().plan.back().value, 90.0);
    }

    void aMoveThatWouldRaceIsNotSent()
    {
        RampBench bench(positions());
        QVERIFY(bench.start());
        bench.type("rampPosition", QStringLiteral("36000")); // 100 turns
        for (const char *time : {"0", "1000"}) {
            bench.type("rampPositionTime", QString::fromLatin1(time));
            bench.enter("rampPositionTime");
            QVERIFY2(bench.label("rampPositionNote").contains(QStringLiteral("time")),
                qPrintable(bench.label("rampPositionNote")));
        }
        QVERIFY(bench.sent.size() == 1); // the start
    }

    void aStopLeavesNoOldSetPointInTheFields()
    {
        RampBench bench;
        bench.type("rampSpeed", QStringLiteral("3000"));
        bench.type("rampTorque", QStringLiteral("2"));
        bench.type("rampCurrentId", QStringLiteral("1"));
        facts::feed(bench.device, {drive::StopProgress{1, drive::StopWord::Requested, {}}});
        for (const char *name : {"rampSpeed", "rampTorque", "rampCurrent", "rampCurrentId"})
            QCOMPARE(bench.find<widgets::NumberEdit>(name)->sentValue(), std::optional(0.0));
    }

    void whatABoardDoesNotHaveSaysWhy()
    {
        simulation::BoardOptions options;
        options.profile = "six-step";
        RampBench bench(options);
        bench.arm();
        for (const char *name : {"rampTorqueSend", "rampCurrentSend"}) {
            const auto *button = bench.find<widgets::MotorButton>(name);
            QVERIFY(!button->isEnabled());
            QVERIFY2(button->toolTip().contains(QStringLiteral("torque")),
                qPrintable(button->toolTip()));
        }
    }

    void theSpaceBarSendsNothing()
    {
        RampBench bench;
        bench.arm();
        QCoreApplication::processEvents();
        for (const char *name :
            {"rampSpeedSend", "rampTorqueSend", "rampCurrentSend", "rampStop"}) {
            bench.find<widgets::MotorButton>(name)->setFocus();
            QTest::keyClick(bench.find<widgets::MotorButton>(name), Qt::Key_Space);
        }
        QVERIFY(bench.sent.empty());
    }

    void namedRampsFillTheFieldsAndSendNothing()
    {
        RampBench bench;
        bench.arm();
        auto *combo = bench.find<QComboBox>("rampPreset");
        auto *save = bench.find<QPushButton>("rampPresetSave");
        QVERIFY(!save->isEnabled() && !save->toolTip().isEmpty());
        bench.type("rampSpeed", QStringLiteral("1200"));
        bench.type("rampSpeedTime", QStringLiteral("750"));
        QTest::keyClicks(combo->lineEdit(), QStringLiteral("<b>run in</b>"));
        save->click();
        bench.type("rampCurrent", QStringLiteral("1.5"));
        bench.type("rampCurrentId", QStringLiteral("-0.5"));
        combo->setEditText(QStringLiteral("flux"));
        save->click();
        QCOMPARE(bench.form->presets().size(), 2);
        QCOMPARE(bench.form->presets()[0],
            (widgets::RampPreset{QStringLiteral("<b>run in</b>"), RampKind::Speed, 1200.0, 750.0}));
        QCOMPARE(bench.form->presets()[1],
            (widgets::RampPreset{QStringLiteral("flux"), RampKind::Current, 1.5, -0.5}));

        bench.type("rampSpeed", QStringLiteral("0"));
        combo->setCurrentIndex(0);
        Q_EMIT combo->activated(0);
        QCOMPARE(bench.find<widgets::NumberEdit>("rampSpeed")->sentValue(), std::optional(1200.0));
        QCOMPARE(
            bench.find<widgets::NumberEdit>("rampSpeedTime")->sentValue(), std::optional(750.0));
        QCOMPARE(bench.picture().plan.back().value, 1200.0);
        bench.find<QPushButton>("rampPresetDelete")->click();
        QCOMPARE(bench.form->presets().size(), 1);
        QVERIFY(bench.sent.empty());
    }

    void namedRampsSurviveTheFileOfSettings()
    {
        const QList<widgets::RampPreset> presets{
            {QStringLiteral("a \u00fc"), RampKind::Speed, -1500.0, 250.0},
            {QStringLiteral("b"), RampKind::Torque, 1.25, 100.0}};
        QCOMPARE(widgets::rampPresetsOf(widgets::rampPresetsJson(presets)), presets);
        const QJsonArray odd = QJsonDocument::fromJson(
            R"([{"name":"","kind":"speed","target":1,"second":1}, {"name":"x","kind":"warp",
                "target":1,"second":1}, {"name":"x","kind":"speed","target":"1","second":1}, 7,
                {"name":"x","kind":"speed","target":1e300,"second":1}, null])")
                                   .array();
        QVERIFY(odd.size() == 6);
        QVERIFY(widgets::rampPresetsOf(odd).isEmpty());
    }

    // The progress alone, moment by moment.

    void progressFollowsTheClockAndEndsWithTheMotor()
    {
        RampProgress progress;
        progress.begin(3000.0, 1000ms, 6.0, 0ms, running(0.0, 0.0));
        QVERIFY(progress.phase() == Phase::Ramping);
        progress.update(500ms, running(1500.0, 1450.0));
        QCOMPARE(progress.fraction(), 0.5);
        progress.update(1000ms, running(3000.0, 2700.0));
        QVERIFY(progress.phase() == Phase::Following);
        progress.update(1200ms, running(3000.0, 2990.0));
        QVERIFY(progress.phase() == Phase::Arrived);
        progress.update(1300ms, running(0.0, 0.0)); // it has ended: nothing brings it back
        QVERIFY(progress.phase() == Phase::Arrived);
    }

    void aRampThatWaitsBeginsWhereTheMotorIs()
    {
        RampProgress progress;
        progress.begin(3000.0, 1000ms, 6.0, 0ms, {MotorState::Idle, true, 900.0, 0.0});
        QVERIFY(progress.phase() == Phase::Waiting);
        QCOMPARE(progress.from(), 0.0); // not at a set-point that nothing follows
        progress.begin(3000.0, 1000ms, 6.0, 0ms, running(900.0, 880.0));
        QCOMPARE(progress.from(), 900.0);
    }

    void aSetPointThatLeavesTheRampEndsIt()
    {
        RampProgress progress;
        progress.begin(3000.0, 1000ms, 6.0, 0ms, running(1000.0, 1000.0));
        progress.update(100ms, running(1200.0, 1100.0));
        QVERIFY(progress.running());
        progress.update(200ms, running(900.0, 1200.0));
        QVERIFY(progress.phase() == Phase::Replaced);
        progress.begin(3000.0, 1000ms, 6.0, 0ms, running(1000.0, 1000.0));
        progress.update(1800ms, running(2000.0, 2000.0)); // held half-way
        QVERIFY(progress.phase() == Phase::Replaced);
    }

    void aLostLinkAndAMissingSetPointAreSaid()
    {
        RampProgress progress;
        progress.begin(3000.0, 1000ms, 6.0, 0ms, running(0.0, 0.0));
        progress.update(2s, {MotorState::Running, true, std::nullopt, std::nullopt});
        QVERIFY(progress.running()); // it cannot be known
        progress.update(3s, {MotorState::Running, false, 3000.0, 3000.0});
        QVERIFY(progress.phase() == Phase::LinkLost);
    }

    void theWholeFormIsWorkedByKeys()
    {
        facts::WindowRig rig;
        rig.sayYesToMotion();
        rig.window.resize(1280, 720);
        QVERIFY(QTest::qWaitForWindowExposed(&rig.window));
        auto &device = rig.workbench.device();
        rig.find<QPushButton>("connect")->click();
        QTRY_VERIFY(device.answering() && device.identified());
        device.setArmed(true);
        QTRY_VERIFY(device.armed());
        QTest::keyClick(&rig.window, Qt::Key_3, Qt::ControlModifier);
        QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("rampSpeed"));
        QTRY_VERIFY(
            rig.workbench.registers().shownValue(*rig.workbench.registers().idOf("SPEED_REF")));
        std::vector<drive::Wish> ramps;
        connect(&device, &widgets::Device::wishMade, this, [&](const drive::Wish &wish) {
            if (std::holds_alternative<drive::SpeedRamp>(wish.what))
                ramps.push_back(wish);
        });
        const auto keys = [](const char *text) {
            QTest::keyClicks(QApplication::focusWidget(), QString::fromLatin1(text));
        };
        keys("1201"); // the text is selected
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("rampSpeedTime"));
        keys("250");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(ramps.size(), 1U);
        QCOMPARE(std::get<drive::SpeedRamp>(ramps[0].what).rpm, 1200);
        QTRY_VERIFY(rig.find<QLabel>("rampProgressText")->text().contains(QStringLiteral("1200")));

        QStringList reached;
        for (int i = 0; i < 100; ++i) {
            QWidget *const at = QApplication::focusWidget();
            QVERIFY2(at != nullptr, qPrintable(reached.join(QLatin1Char(' '))));
            reached.append(at->objectName());
            QTest::keyClick(at, Qt::Key_Tab);
        }
        for (const char *name : {"rampSpeed", "rampSpeedTime", "rampSpeedSend", "rampTorque",
                 "rampTorqueTime", "rampCurrent", "rampCurrentId", "rampPreset", "rampStop"})
            QVERIFY2(reached.contains(QLatin1String(name)), name);

        auto *combo = rig.find<QComboBox>("rampPreset");
        combo->setFocus();
        keys("kept");
        rig.find<QPushButton>("rampPresetSave")->click();
        QCOMPARE(rig.window.settings().ramps.size(), 1);
        QCOMPARE(ramps.size(), 1U);
        device.setArmed(false);
    }
};

QTEST_MAIN(TestRampForm)
#include "tst_ramp_form.moc"
