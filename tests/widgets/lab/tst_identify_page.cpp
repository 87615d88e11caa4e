// The identification of a motor through the real window: what is asked, what stands in the table beside board and motor
// file, and that figures come into the motor description only when they are wanted, and out again.
#include "simulation/plant/presets.h"
#include "widgets/base/banner.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/base/si_text.h"
#include "widgets/base/steady_label.h"
#include "widgets/forms/motor_form.h"
#include "widgets/lab/experiment_bar.h"
#include "widgets/lab/identify_page.h"
#include "widgets/lab/lab_window.h"
#include "widgets/lab/text.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLineEdit>
#include <QMessageBox>
#include <QRegularExpression>
#include <QSignalSpy>

#include <cmath>

using drive::MotorState;
using support::LabWindow;
using Findings = widgets::MotorFindings;

namespace {

Findings &findingsOf(LabWindow &bench)
{
    return *static_cast<Findings *>(bench.find<QTreeView>("identifyTable")->model());
}

QString toldOf(LabWindow &bench)
{
    QStringList lines;
    for (int row = 0; row < Findings::kRows; ++row)
        for (const int column : {Findings::QuantityColumn, Findings::MeasuredColumn,
                 Findings::IntervalColumn, Findings::NoteColumn})
            lines.append(bench.cell("identifyTable", row, column));
    return lines.join(QStringLiteral(" | ")) + QLatin1Char('\n') + bench.said("identifySentence");
}

/// Every sentence of the page while something runs.
std::shared_ptr<QStringList> saidMeanwhile(LabWindow &bench)
{
    auto all = std::make_shared<QStringList>();
    QObject::connect(&bench.rig.workbench.experiments(), &widgets::Experiments::progressed,
        &bench.rig.window, [all, &bench] { all->append(bench.said("identifySentence")); });
    return all;
}

/// How many of them tell a speed of the turning motor. @return  -1: the motor at rest has one, too
int speedsIn(const QStringList &sentences)
{
    static const QRegularExpression turning(
        QStringLiteral("^Inductances and flux: \\d+ s of about \\d+ s, (\\d+)\u202frpm$"));
    int count = 0;
    for (const QString &one : sentences) {
        if (one.startsWith(QLatin1String("Resistance")) && one.contains(QLatin1String("rpm")))
            return -1;
        const auto match = turning.match(one);
        count += match.hasMatch() && match.captured(1).toInt() > 500 ? 1 : 0;
    }
    return count;
}

} // namespace

class TestIdentifyPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theDigitsThatAreShownFollowTheInterval()
    {
        Findings findings;
        lab::Electrics windings;
        windings.rs_ohm = {0.351234, 0.339876, 0.362592};
        windings.ld_h = {0.99961e-3, 0.98761e-3, 1.01161e-3};
        findings.accept(windings);
        lab::Mechanics mechanics;
        mechanics.inertia_kgm2 = {2.40004e-5, 2.38765e-5, 2.41243e-5};
        mechanics.viscous_nms = {0.0, 0.0, 4.1234e-5};
        mechanics.fan_nms2 = {0.0, 0.0, 1.23456e-6};
        findings.accept(mechanics);
        const auto cell = [&](int row, int column) {
            return findings.index(row, column).data().toString().replace(QChar(0x202f), u' ');
        };
        using F = Findings;
        QCOMPARE(cell(F::Resistance, F::MeasuredColumn), QStringLiteral("351 m\u03a9"));
        QCOMPARE(
            cell(F::Resistance, F::IntervalColumn), QStringLiteral("340 m\u03a9 to 363 m\u03a9"));
        QCOMPARE(cell(F::Ld, F::MeasuredColumn), QStringLiteral("1.000 mH"));
        QCOMPARE(cell(F::Ld, F::IntervalColumn), QStringLiteral("988 \u00b5H to 1.012 mH"));
        QCOMPARE(cell(F::Inertia, F::MeasuredColumn), QStringLiteral("240.0 g cm\u00b2"));
        QCOMPARE(cell(F::Viscous, F::IntervalColumn), QStringLiteral("0 N m s to 41 \u00b5N m s"));
        QVERIFY2(cell(F::Fan, F::NoteColumn).contains(QStringLiteral("at most 1.23 \u00b5N")),
            qPrintable(cell(F::Fan, F::NoteColumn)));
        QCOMPARE(findings.measured().rs_ohm, std::optional(0.351234)); // what is kept is not cut
    }

    void eachDirectionHasItsInertia()
    {
        Findings findings;
        lab::Mechanics mechanics;
        mechanics.inertia_kgm2 = {2.4e-5, 2.38e-5, 2.42e-5};
        findings.accept(mechanics);
        const auto note = [&](Findings::Row row = Findings::Inertia) {
            return findings.index(row, Findings::NoteColumn)
                .data()
                .toString()
                .replace(QChar(0x202f), u' ');
        };
        QVERIFY2(!note().contains(QLatin1String("forwards")), qPrintable(note()));
        mechanics.both = {
            {2.38e-5, 2.36e-5, 2.40e-5}, {2.42e-5, 2.40e-5, 2.44e-5}, {-3.2e-3, -3.4e-3, -3.0e-3}};
        findings.accept(mechanics);
        QVERIFY2(note(Findings::Dry).contains(QStringLiteral("-3.20 mN m that is always there")),
            qPrintable(note(Findings::Dry)));
        QVERIFY2(note().startsWith(
                     QStringLiteral("238.0 g cm\u00b2 forwards, 242.0 g cm\u00b2 backwards.")),
            qPrintable(note()));
    }

    /// By one question, and one after the other.
    void bothDirectionsAreAskedAbout()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("mechanicalRun"));
        auto *both = bench.find<QCheckBox>("identifyBothWays");
        QTest::keyClick(both, Qt::Key_Space);
        QVERIFY(both->isChecked());
        bench.press("mechanicalRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        QVERIFY2(words.contains(QStringLiteral("1. For 16"))
                && words.contains(QStringLiteral("2. Backwards, for 16")),
            qPrintable(words));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
        bench.agree();
        QTRY_VERIFY(bench.running());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.running(), 2 * LabWindow::kRunMs);
        QTRY_VERIFY2(bench.cell("identifyTable", Findings::Inertia, Findings::NoteColumn)
                         .contains(QLatin1String("backwards")),
            qPrintable(toldOf(bench)));
        QVERIFY2(bench.said("identifySentence").contains(QLatin1String("the motor is as it was")),
            qPrintable(bench.said("identifySentence")));
        QCOMPARE(bench.questions, 1);
    }

    /// A row says why its own figure is missing, not what is to be said of others.
    void aNoteStandsWhereAFigureIsMissing()
    {
        Findings findings;
        lab::Electrics windings;
        windings.ld_h = {1e-3, 0.9e-3, 1.1e-3};
        windings.lq_h = {1e-3, 0.9e-3, 1.1e-3};
        windings.notes = {"the rotor swung"};
        findings.accept(windings);
        const auto note = [&](int row) {
            return findings.index(row, Findings::NoteColumn).data().toString();
        };
        for (const int row : {Findings::Resistance, Findings::DeadTime, Findings::Flux})
            QCOMPARE(note(row), QStringLiteral("The rotor swung."));
        QVERIFY(note(Findings::Ld).isEmpty() && note(Findings::Lq).isEmpty());
        lab::Mechanics mechanics;
        mechanics.notes = {"it has Hall sensors"};
        findings.accept(mechanics);
        QVERIFY2(!note(Findings::Inertia).contains(QLatin1String("Hall")),
            qPrintable(note(Findings::Inertia)));
    }

    void bothAreMeasuredAndUsedAndTakenBack()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.find("identifyPage")->isVisible());
        QTRY_VERIFY(bench.said("identifySentence").contains(QLatin1String("Connect to a board")));
        QVERIFY(bench.connectBoard());
        QTRY_COMPARE(bench.said("identifySentence"), bench.rig.workbench.experiments().obstacle());
        QVERIFY(!bench.find<QPushButton>("identifyUse")->isEnabled());
        QVERIFY(bench.arm("electricalRun"));
        const auto truth = [&](int row) {
            return bench.cell("identifyTable", row, Findings::BoardColumn);
        };
        QTRY_VERIFY(truth(Findings::Resistance).contains(QStringLiteral("\u03a9")));

        bench.press("electricalRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        for (const char *word : {"1. At rest: currents from", "2. For 12", "Stopped below"})
            QVERIFY2(words.contains(QLatin1String(word)), qPrintable(words));
        QTest::keyClick(bench.find("experimentQuestion"), Qt::Key_Return); // is no yes
        QTRY_VERIFY(!bench.asks());
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);

        const auto meanwhile = saidMeanwhile(bench);
        QVERIFY2(bench.runToItsEnd("electricalRun"), qPrintable(toldOf(bench)));
        QVERIFY2(speedsIn(*meanwhile) > 10, qPrintable(meanwhile->join(QLatin1Char('\n'))));
        QVERIFY2(bench.said("identifySentence").contains(QLatin1String("the motor is as it was")),
            qPrintable(bench.said("identifySentence")));
        QVERIFY2(bench.runToItsEnd("mechanicalRun"), qPrintable(toldOf(bench)));
        QCOMPARE(bench.questions, 2); // the mechanics are another kind of motion
        QTRY_COMPARE(bench.state(), MotorState::Idle);
        const motor::MotorSheet measured = findingsOf(bench).measured();
        QVERIFY2(measured.rs_ohm && measured.ld_h && measured.lq_h && measured.flux_wb
                && measured.inertia_kgm2 && measured.viscous_nms && measured.coulomb_nm,
            qPrintable(toldOf(bench)));
        // As good as tests of the evaluations say is for them; here it is the right motor in the right row.
        const double inertia = simulation::findPreset("servo24")->motor.inertia_kgm2;
        QVERIFY2(std::abs(*measured.inertia_kgm2 / inertia - 1.0) < 0.05,
            qPrintable(QString::number(*measured.inertia_kgm2)));
        QVERIFY(bench.cell("identifyTable", Findings::Inertia, Findings::MeasuredColumn)
                    .endsWith(QStringLiteral("g cm\u00b2")));
        QVERIFY(bench.cell("identifyTable", Findings::Resistance, Findings::IntervalColumn)
                    .contains(QLatin1String(" to ")));
        QVERIFY(bench.cell("identifyTable", Findings::Inertia, Findings::NoteColumn)
                    .contains(QLatin1String("Model: viscous and dry friction")));

        // Into the description beside the board's, and out of it, as one step each.
        const auto file = [&](int row) {
            return bench.cell("identifyTable", row, Findings::FileColumn);
        };
        const QString none = QStringLiteral("\u2013");
        QCOMPARE(file(Findings::Inertia), none);
        bench.press("identifyUse");
        QCOMPARE(file(Findings::Inertia), // to its last digit
            widgets::siText(*measured.inertia_kgm2 * 1e7, QStringLiteral("g cm\u00b2")));
        auto *form = bench.rig.window.findChild<widgets::MotorForm *>();
        QVERIFY(form->model().hasFile());
        QVERIFY(bench.find<QPushButton>("motorBack")->isEnabled());
        bench.press("identifyBack");
        QCOMPARE(file(Findings::Inertia), none);
        QVERIFY(!form->model().hasFile());
        QVERIFY(!bench.find<QPushButton>("identifyBack")->isEnabled());

        // Gains are computed from what was measured.
        bench.open(Qt::Key_1, Qt::ControlModifier);
        QTRY_VERIFY(bench.find<widgets::NumberEdit>("labRs"));
        const auto shown = [&](const char *name) {
            return bench.find<widgets::NumberEdit>(name)->value();
        };
        QCOMPARE(shown("labRs"), measured.rs_ohm);
        QCOMPARE(shown("labLd"), std::optional(*measured.ld_h * 1e3));
        QCOMPARE(shown("labLq"), std::optional(*measured.lq_h * 1e3));
    }

    /// At half of what is allowed where it rests, with the resistance that was measured before.
    void aPowerIsAskedAboutMeasuredAndTold()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("powerRun"));
        lab::Electrics windings;
        windings.rs_ohm = {0.19, 0.18, 0.20};
        windings.deadTime_v = {0.4, 0.39, 0.41};
        findingsOf(bench).accept(windings);
        bench.press("powerRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        QVERIFY2(words.contains(QStringLiteral("For 5\u202fs it is held at ")), qPrintable(words));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
        bench.agree();
        QTRY_VERIFY(bench.running());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.running(), LabWindow::kRunMs);
        QTRY_VERIFY(bench.said("identifySentence").contains(QLatin1String("Efficiency")));
        const QString said = bench.said("identifySentence");
        for (const char *figure : {"Speed: ", "Electrical power: ", "Copper losses: ",
                 "Shaft power: ", "Efficiency: ", "the motor is as it was"})
            QVERIFY2(said.contains(QLatin1String(figure)), qPrintable(said));
        QVERIFY2(!said.contains(QLatin1String("not known")), qPrintable(said));
        QTRY_COMPARE(bench.state(), MotorState::Idle);
        QCOMPARE(bench.questions, 1);
    }

    /// Refused, or ended early: what was measured before is as true as it was.
    void aRunThatTellsNothingLeavesTheRows()
    {
        LabWindow bench("servo24");
        QVERIFY(bench.connectBoard());
        widgets::Identification identification(bench.device(), bench.rig.workbench.experiments());
        Findings &findings = identification.findings();
        lab::Electrics windings;
        windings.rs_ohm = {0.35, 0.34, 0.36};
        windings.ld_h = {1e-3, 0.9e-3, 1.1e-3};
        findings.accept(windings);
        const auto run = identification.electricalRun();
        QVERIFY(run);
        const auto toldOfEnd = [&](lab::End end) {
            widgets::Experiments::Run ended;
            ended.outcome.end = end;
            ended.outcome.reason = "the motor is not in speed control";
            return run->evaluate(ended)();
        };
        QVERIFY(toldOfEnd(lab::End::Refused).isEmpty());
        QCOMPARE(findings.measured().rs_ohm, std::optional(0.35));
        QVERIFY(!toldOfEnd(lab::End::Interrupted).isEmpty());
        QCOMPARE(findings.measured().ld_h, std::optional(1e-3));
        lab::Electrics atRest;
        atRest.rs_ohm = {0.4, 0.39, 0.41};
        findings.accept(atRest, false);
        QCOMPARE(findings.measured().rs_ohm, std::optional(0.4));
        QCOMPARE(findings.measured().ld_h, std::optional(1e-3));
        QVERIFY(!toldOfEnd(lab::End::Complete).isEmpty());
        QVERIFY(!findings.measured().rs_ohm && !findings.measured().ld_h);
    }

    /// The figures of one motor beside the values of another could be taken into its motor file.
    void whatIsOfAnotherMotorIsNotShown()
    {
        LabWindow bench("servo24", {1280, 720}, 2);
        QVERIFY(bench.connectBoard());
        widgets::Identification identification(bench.device(), bench.rig.workbench.experiments());
        Findings &findings = identification.findings();
        const auto run = identification.electricalRun();
        QVERIFY(run);
        const auto shown = [&] { // of a run that tells nothing, which empties the rows
            widgets::Experiments::Run ended;
            ended.outcome.end = lab::End::Complete;
            lab::Electrics windings;
            windings.rs_ohm = {0.35, 0.34, 0.36};
            const auto show = run->evaluate(ended);
            findings.accept(windings);
            return !show().isEmpty();
        };
        bench.device().setMotor(2);
        QVERIFY(!shown());
        QCOMPARE(findings.measured().rs_ohm, std::optional(0.35));
        bench.device().setMotor(1);
        QVERIFY(shown());
        QVERIFY(!findings.measured().rs_ohm);
        bench.press("connect");
        QTRY_VERIFY(!bench.device().portOpen());
        QVERIFY(bench.connectBoard()); // which may be another one
        QVERIFY(!shown());
        QCOMPARE(findings.measured().rs_ohm, std::optional(0.35));
    }

    /// What a start-up held is forty bytes that are to be typed back.
    void whatIsLeftIsReadAndCopiedInASmallWindow()
    {
        const support::Speaking german(true);
        LabWindow bench("servo24", {960, 600});
        bench.rig.window.showWithin({976, 648}); // with a frame around it
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        QString bytes(QStringLiteral("2c 01"));
        for (int i = 1; i < 20; ++i)
            bytes += QStringLiteral(" e8 03");
        const QString set = QStringLiteral("rotorscope-cli set REVUP_DATA=\"%1\"").arg(bytes);
        lab::Outcome outcome;
        outcome.end = lab::End::Interrupted;
        outcome.reason = "every motor was stopped; the set-point is 1500 rpm now, it was 1000 rpm; "
                         "REVUP_DATA may hold what the experiment wrote; what it held before comes "
                         "back with: "
            + set.toStdString();
        auto *sentence = bench.find<widgets::SteadyLabel>("identifySentence");
        auto *bar = static_cast<widgets::ExperimentBar *>(sentence->parentWidget());
        bar->tell(widgets::endText(outcome));
        QVERIFY2(sentence->text().startsWith(QLatin1String("Unterbrochen: ")),
            qPrintable(sentence->text()));
        const auto fits = [sentence] {
            const QRect room = sentence->contentsRect();
            const QRect needed = sentence->fontMetrics().boundingRect(
                room.adjusted(0, 0, 0, 1000), Qt::TextWordWrap, sentence->text());
            return needed.height() <= room.height() && needed.width() <= room.width();
        };
        QTRY_VERIFY(support::isWhole(*sentence) && fits() && !sentence->isCut());
        QCOMPARE(bench.rig.window.size(), QSize(960, 600));
        QVERIFY(support::isWhole(*bench.find("stopMotors")));

        sentence->setFocus(Qt::TabFocusReason);
        // Of a floating tool, which need not be active.
        QCOMPARE(sentence->window()->focusWidget(), sentence);
        QTest::keyClick(sentence, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClick(sentence, Qt::Key_C, Qt::ControlModifier);
        QVERIFY2(QGuiApplication::clipboard()->text().contains(set),
            qPrintable(QGuiApplication::clipboard()->text()));
    }

    /// By a program that was killed: this one has met its board.
    void whatAnotherProgramLeftIsSaidOverThePicture()
    {
        const support::Speaking german(true);
        LabWindow bench("servo24");
        QVERIFY(bench.connectBoard());
        Q_EMIT bench.rig.workbench.lentNote().left(QStringLiteral(
            "REVUP_DATA may hold what the experiment wrote; what it held before comes "
            "back with: rotorscope-cli set REVUP_DATA=\"2C 01\""));
        const auto *banner = bench.find<widgets::Banner>("banner");
        QTRY_VERIFY(banner->isVisible());
        QVERIFY2(
            banner->text().contains(QStringLiteral(
                "geliehen hatte: REVUP_DATA enth\u00e4lt vielleicht, was der Versuch geschrieben "
                "hat; was vorher darin stand, kommt zur\u00fcck mit: rotorscope-cli set "
                "REVUP_DATA=\"2C 01\".")),
            qPrintable(banner->text()));
    }

    void cancelStopsTheMotorAndTheOtherPartIsNotBegun()
    {
        LabWindow bench("servo24", {960, 540});
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("electricalRun"));
        bench.press("electricalRun");
        bench.agree();
        QTRY_VERIFY(bench.said("identifySentence").startsWith(QLatin1String("Resistance")));
        QTRY_VERIFY_WITH_TIMEOUT(bench.world.counts().starts > 0, 20'000);
        bench.press("identifyCancel");
        QVERIFY(!bench.device().armed());
        QTRY_VERIFY(!bench.running());
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
        QTRY_VERIFY(bench.said("identifySentence").contains(QLatin1String("Interrupted: ")));
        QCOMPARE(bench.world.counts().starts, 1);
    }

    /// A start-up without a speed, say, with which the other part would start the motor.
    void whatOnePartLeftEndsBoth()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("electricalRun"));
        widgets::Experiments &experiments = bench.rig.workbench.experiments();
        QSignalSpy wished(&experiments, &widgets::Experiments::wished);
        bench.press("electricalRun");
        bench.agree();
        QTRY_VERIFY(bench.running());
        experiments.end({.reason = "REVUP_DATA may hold what the experiment wrote",
            .at = bench.world.now(),
            .leaves = true});
        QVERIFY(!bench.running());
        QCOMPARE(wished.size(), 1);
        QTRY_VERIFY2(
            bench.said("identifySentence")
                .contains(QLatin1String("Interrupted: REVUP_DATA may hold what the "
                                        "experiment wrote; what comes next was not begun")),
            qPrintable(bench.said("identifySentence")));
        QTest::keyClick(&bench.rig.window, Qt::Key_Escape); // the board's goes on
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
    }

    void torqueControlIsSaidBeforeThePress()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("electricalRun"));
        bench.find<QComboBox>("setpointMode")->setCurrentIndex(1);
        auto *torque = bench.find<QLineEdit>("torque");
        torque->setText(QStringLiteral("0"));
        QTest::keyClick(torque, Qt::Key_Return);
        bench.press("motionConfirm"); // it is not known from where the current moves
        for (const char *name : {"electricalRun", "mechanicalRun"}) {
            const auto *run = bench.find<QPushButton>(name);
            QTRY_VERIFY(!run->isEnabled());
            QTRY_VERIFY2(run->toolTip().contains(QLatin1String("with Go or a speed ramp")),
                qPrintable(run->toolTip()));
        }
        QVERIFY(bench.device().armed());
    }

    /// Its mechanics are measured once its user has said what a current is worth; nothing else is.
    void ofABoardThatRecordsNothingTheRestIsGreyWithTheReason()
    {
        support::OlderBoardWindow old;
        old.open(Qt::Key_I, Qt::ControlModifier);
        widgets::Device &device = old.rig.workbench.device();
        const auto grey = [&](const char *name, const QString &why) {
            const auto *run = old.rig.find<QPushButton>(name);
            return !run->isEnabled() && run->toolTip().contains(why);
        };
        for (const char *name : {"electricalRun", "mechanicalRun"})
            QTRY_VERIFY(grey(name, QStringLiteral("agree to expert mode")));
        device.becomeExpert(1);
        device.setUserLimits({4000.0, 0.0});
        QTRY_VERIFY(grey("mechanicalRun", QStringLiteral("Arm first.")));
        old.arm();
        const auto recorded = old.rig.workbench.experiments().subject();
        QVERIFY(!recorded);
        QTRY_VERIFY(grey("electricalRun", recorded.error()));
        QTRY_VERIFY(grey("mechanicalRun", QStringLiteral("Nothing tells its current in A")));
        device.setCurrentScale(1, 60.175); // which disarms
        QTRY_VERIFY(grey("mechanicalRun", QStringLiteral("Arm first.")));
        old.arm();
        QTRY_VERIFY2(grey("mechanicalRun", QStringLiteral("Nothing tells which torque")),
            qPrintable(old.rig.find<QPushButton>("mechanicalRun")->toolTip()));

        QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("motor.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"motor": {"polePairs": 5, "flux_wb": 0.0064}})");
        file.close();
        old.rig.files.answer = file.fileName();
        old.rig.find<QPushButton>("motorOpen")->click();
        auto *run = old.rig.find<QPushButton>("mechanicalRun");
        QTRY_VERIFY2(run->isEnabled(), qPrintable(run->toolTip()));
        QTest::mouseClick(run, Qt::LeftButton);
        auto *question = old.rig.find<QMessageBox>("experimentQuestion");
        QVERIFY(question);
        const QString words = question->informativeText().replace(QChar(0x202f), u' ');
        for (const char *part : {"ramps lead it from 1600 rpm to 2800 rpm", "taken for 48 mN m",
                 "brakes a heavy rotor"})
            QVERIFY2(words.contains(QLatin1String(part)), qPrintable(words));
        QTest::keyClick(question, Qt::Key_Escape);
        QVERIFY(!old.rig.workbench.experiments().running());
    }
    void aTachometerTellsThePolePairs()
    {
        Findings findings;
        findings.setPolePairs({7, 6.98});
        QCOMPARE(findings.index(Findings::PolePairs, Findings::MeasuredColumn).data().toString(),
            QStringLiteral("7"));
        QVERIFY(findings.index(Findings::PolePairs, Findings::NoteColumn)
                    .data()
                    .toString()
                    .contains(QStringLiteral("6.98")));
        QCOMPARE(findings.measured().polePairs, std::optional(7.0));
        findings.fail(false, QStringLiteral("why"));
        findings.fail(true, QStringLiteral("why"));
        QVERIFY(findings.any());

        LabWindow bench("servo24");
        bench.open(Qt::Key_I, Qt::ControlModifier);
        QVERIFY(bench.connectBoard());
        auto *rpm = bench.find<QLineEdit>("identifyTachometer");
        rpm->setText(QStringLiteral("1500"));
        QTest::keyClick(rpm, Qt::Key_Return);
        QTRY_VERIFY2(bench.said("identifySentence").contains(QLatin1String("An encoder tells")),
            qPrintable(bench.said("identifySentence")));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
    }
    void theTorqueOfAnAmpereIsTheMotorFiles()
    {
        Findings findings;
        QCOMPARE(findings.torqueConstant_nm(), 0.0);
        motor::MotorSheet file;
        file.polePairs = 5.0;
        findings.setKnown({}, file);
        QCOMPARE(findings.torqueConstant_nm(), 0.0);
        file.flux_wb = 6.4e-3;
        findings.setKnown({}, file);
        QCOMPARE(findings.torqueConstant_nm(), 0.048);
    }
};

QTEST_MAIN(TestIdentifyPage)
#include "tst_identify_page.moc"
