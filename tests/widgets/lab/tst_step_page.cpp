// Steps of the speed and of currents through the real window on a simulated board with an encoder: what is asked, what
// a series leaves in the table, how a gain and its new step are two actions, and what ends one. The judge of the wire
// watches all of it.
#include "lab/evaluation/finding.h"
#include "session/recording/reader.h"
#include "widgets/base/steady_label.h"
#include "widgets/lab/experiment_bar.h"
#include "widgets/lab/lab_window.h"
#include "widgets/lab/live_gain.h"
#include "widgets/lab/plan_question.h"
#include "widgets/lab/step_overlay.h"
#include "widgets/lab/step_runs.h"
#include "widgets/lab/text.h"
#include "widgets/scope/view.h"

#include <QLineEdit>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolTip>
#include <QUndoStack>
#include <QWheelEvent>
#include <qcustomplot.h>

#include <memory>

using drive::MotorState;
using namespace std::chrono_literals;

namespace {

constexpr int kSeriesMs = 30'000; ///< a busy computer takes its time

/// A motor with an encoder, and the page open.
struct Bench : support::LabWindow {
    int actions = 0; ///< of the user, since the test set it to 0

    explicit Bench(const char *motor = "servo24", const QSize &size = {1280, 720},
        const std::vector<std::string> &with = {})
        : LabWindow(motor, size, 1, with)
    {
        open(Qt::Key_T, Qt::ControlModifier);
    }

    QPushButton *run() const { return find<QPushButton>("stepRun"); }
    QString said() const { return LabWindow::said("stepSentence"); }
    const QAbstractItemModel &rows() const { return *find<QTreeView>("stepRuns")->model(); }
    QString cell(int row, int column) const { return LabWindow::cell("stepRuns", row, column); }
    widgets::LiveGain *kp() const { return rig.window.findChild<widgets::LiveGain *>(); }

    bool connectBoard()
    {
        return LabWindow::connectBoard()
            && QTest::qWaitFor([this] { return kp()->digits().has_value(); });
    }
    bool arm() { return LabWindow::arm("stepRun"); }
    /// Short ones.
    void plan(int from, int to, int repeat = 1)
    {
        find<QLineEdit>("stepFrom")->setText(QString::number(from));
        find<QLineEdit>("stepTo")->setText(QString::number(to));
        find<QSpinBox>("stepHold")->setValue(200);
        find<QSpinBox>("stepApproach")->setValue(200);
        find<QSpinBox>("stepRepeat")->setValue(repeat);
    }
    void press(const char *name)
    {
        ++actions;
        LabWindow::press(name);
    }
    bool runToItsEnd()
    {
        const int before = rows().rowCount();
        press("stepRun");
        if (asks())
            agree();
        return QTest::qWaitFor([&] { return rows().rowCount() > before; }, kSeriesMs);
    }
    /// As the user turns the wheel over a field, one notch.
    void wheel(QWidget *over, int notches)
    {
        ++actions;
        const QPointF at = over->rect().center();
        QWheelEvent event(at, over->mapToGlobal(at), {}, QPoint(0, 120 * notches), Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(over, &event);
    }
};

} // namespace

class TestStepPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void itSaysWhyItCannotRun()
    {
        Bench bench;
        QVERIFY(bench.find("stepPage")->isVisible()); // by its key
        const auto refused = [&](const char *why) {
            return !bench.run()->isEnabled() && bench.run()->toolTip().contains(QLatin1String(why))
                && bench.said().contains(QLatin1String(why));
        };
        QVERIFY(refused("Connect to a board first."));
        QVERIFY(bench.connectBoard());
        QTRY_VERIFY(refused("Arm first."));
        QVERIFY(bench.arm());
        QVERIFY(bench.said().isEmpty());
        bench.plan(1000, 1000);
        QTRY_VERIFY(refused("there is no step"));
        bench.plan(1000, 1500, 100);
        bench.find<QSpinBox>("stepHold")->setValue(1000);
        QTRY_VERIFY(refused("ends within 60 s"));
        bench.find<QLineEdit>("stepTo")->setText(QStringLiteral("99999"));
        QTRY_VERIFY(refused("The limit is"));
        bench.plan(1000, 1500);
        QTRY_VERIFY(bench.run()->isEnabled());
        QTest::mouseClick(bench.find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY(refused("Connect to a board first."));
    }

    /// Nobody loads this motor, which is said, and makes no row.
    void aShaftIsMovedWhereTheBoardControlsPositions()
    {
        const auto positionIn = [](const Bench &bench) {
            auto *kind = bench.find<QComboBox>("stepKind");
            return std::pair(kind, kind->findText(QStringLiteral("Position")));
        };
        {
            Bench other;
            QVERIFY(other.connectBoard());
            const auto [kind, row] = positionIn(other);
            QVERIFY(!(kind->model()->flags(kind->model()->index(row, 0)) & Qt::ItemIsEnabled));
            QVERIFY(kind->itemData(row, Qt::ToolTipRole)
                        .toString()
                        .contains(QLatin1String("does not control the position")));
        }
        Bench bench("servo24", {1280, 720}, {"position"});
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        const auto [kind, row] = positionIn(bench);
        kind->setCurrentIndex(row);
        QVERIFY(!bench.find("stepFrom")->isVisible());
        QCOMPARE(bench.find<QLineEdit>("stepTo")->text(), QStringLiteral("90.0"));
        auto *approach = bench.find<QSpinBox>("stepApproach");
        QCOMPARE(approach->value(), 300);
        approach->setValue(20); // no ramp of a speed
        kind->setCurrentIndex(0);
        QCOMPARE(approach->value(), 500);
        kind->setCurrentIndex(row);
        QCOMPARE(approach->value(), 20);
        approach->setValue(300);
        const auto greyed = [kind = kind, row = row] {
            return !(kind->model()->flags(kind->model()->index(row, 0)) & Qt::ItemIsEnabled);
        };
        bench.device().setUserLimits({3000.0, 0.0});
        QTRY_VERIFY(greyed());
        bench.device().setUserLimits({});
        QTRY_VERIFY(!greyed());
        bench.find<QSpinBox>("stepRepeat")->setValue(1);
        QTRY_VERIFY(bench.run()->isEnabled());
        bench.press("stepRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        QVERIFY2(words.contains(QString::fromUtf8("its shaft is moved by 90.0\u00b0 and back"))
                && words.contains(QLatin1String("ends by braking")),
            qPrintable(words));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
        bench.agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows().rowCount(), 1, kSeriesMs);
        QVERIFY(
            bench.cell(0, widgets::StepRuns::StepColumn).startsWith(QLatin1String("Position 90")));
        QVERIFY(bench.cell(0, widgets::StepRuns::RiseColumn).contains(QLatin1String("ms")));
        QVERIFY(bench.cell(0, widgets::StepRuns::KpColumn).contains(QLatin1String("digits")));
        QVERIFY(bench.find<widgets::StepOverlay>("stepOverlay")->curves() > 0);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.running(), Bench::kRunMs);
    }

    void aLoadIsAskedAboutAndWaitedFor()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.LabWindow::arm("stepLoad"));
        bench.press("stepLoad");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        QVERIFY2(words.contains(QStringLiteral("while you change its load")), qPrintable(words));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
        bench.agree();
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.said().contains(QLatin1String("put the load on")), kSeriesMs);
        QTRY_VERIFY_WITH_TIMEOUT(!bench.running(), Bench::kRunMs);
        QTRY_VERIFY2(
            bench.said().contains(QLatin1String("no load came or went"), Qt::CaseInsensitive),
            qPrintable(bench.said()));
        QCOMPARE(bench.rows().rowCount(), 0);
        QTRY_COMPARE(bench.state(), MotorState::Idle);
    }

    void threeSeriesAreSeenInASmallWindow()
    {
        Bench bench; // 1280x720
        auto *runs = bench.rig.window.findChild<widgets::StepRuns *>();
        for (int i = 0; i < 3; ++i)
            runs->add({});
        const auto *table = bench.find<QTreeView>("stepRuns");
        const auto seen = [&](const QModelIndex &row) {
            const QRect rect = table->visualRect(row);
            return rect.isValid()
                && table->viewport()->visibleRegion().contains(QPoint(4, rect.top()))
                && table->viewport()->visibleRegion().contains(QPoint(4, rect.bottom()));
        };
        for (int i = 0; i < 3; ++i)
            QTRY_VERIFY2(seen(runs->index(i, 0)), qPrintable(QString::number(i)));
    }

    void thePictureIsSeenInASmallWindow_data()
    {
        QTest::addColumn<bool>("german");
        QTest::newRow("English") << false;
        QTest::newRow("German") << true;
    }
    /// With all that it is made by beside it.
    void thePictureIsSeenInASmallWindow()
    {
        QFETCH(const bool, german);
        const support::Speaking speaking(german);
        Bench bench; // 1280x720
        QVERIFY(bench.connectBoard());
        const auto *picture =
            bench.rig.window.findChild<widgets::StepOverlay *>()->findChild<QCustomPlot *>();
        QTRY_VERIFY(support::isWhole(*picture));
        QVERIFY2(picture->height() >= 160, qPrintable(QString::number(picture->height())));
        QVERIFY2(picture->width() >= 300, qPrintable(QString::number(picture->width())));
        QTRY_COMPARE(support::cutParts(*bench.find("stepPage")), QString());
        QCOMPARE(bench.rig.window.size(), QSize(1280, 720));
    }

    /// How it ended is what counts: it gets the room beside the buttons, or below them, and a hint gives way to it.
    void howItEndedIsReadInASmallWindow()
    {
        Bench bench; // 1280x720
        QVERIFY(bench.connectBoard());
        auto *sentence = bench.find<widgets::SteadyLabel>("stepSentence");
        auto *bar = static_cast<widgets::ExperimentBar *>(sentence->parentWidget());
        QTRY_COMPARE(bench.said(), QStringLiteral("Arm first."));
        bar->tell(QStringLiteral("Done; the motor is as it was."));
        QCOMPARE(bench.said(), QStringLiteral("Done; the motor is as it was.\nArm first."));
        const QString interrupted = QStringLiteral(
            "Interrupted: every motor was stopped; the set-point is 1500 rpm now, it was 1000 rpm; "
            "SPEED_KP may hold what the experiment wrote, it was 1234; SPEED_KI may hold what the "
            "experiment wrote, it was 5678.\nThe gains were changed meanwhile: the row has the "
            "first.");
        bar->tell(interrupted);
        QTRY_VERIFY(!sentence->isCut());
        QVERIFY(bench.said().startsWith(interrupted.left(interrupted.indexOf(QLatin1Char('\n')))));
        QVERIFY(bench.run()->toolTip().contains(QLatin1String("Arm first.")));
        QCOMPARE(bench.rig.window.size(), QSize(1280, 720));
    }

    /// In 720 less the title of a window: the sentence takes its room from the page, and the picture keeps its axis.
    void thePictureIsWholeAboveALongSentence()
    {
        Bench bench("servo24", {1280, 702});
        QVERIFY(bench.connectBoard());
        auto *sentence = bench.find<widgets::SteadyLabel>("stepSentence");
        auto *bar = static_cast<widgets::ExperimentBar *>(sentence->parentWidget());
        const int beside = bar->height();
        bar->tell(QStringLiteral("word ").repeated(70));
        QTRY_VERIFY(bar->height() > beside); // it stands below the buttons
        const auto *picture =
            bench.rig.window.findChild<widgets::StepOverlay *>()->findChild<QCustomPlot *>();
        QTRY_VERIFY2(support::isWhole(*picture), qPrintable(QString::number(picture->height())));
        QCOMPARE(bench.rig.window.size(), QSize(1280, 702));
    }

    /// A register that goes on showing another value is named, and takes nothing from what was restored.
    void whatABoardGoesOnShowingIsSaid()
    {
        lab::Outcome outcome;
        outcome.shows = lab::ShownReference{"SPEED_REF", 1380.0, 996.0};
        const QString shows =
            QStringLiteral(" SPEED_REF shows 996 rpm until the next start, it showed 1380 rpm.");
        QCOMPARE(
            widgets::endText(outcome), QStringLiteral("Done; the motor is as it was.") + shows);
        outcome.end = lab::End::Refused;
        outcome.reason = "the start: it was refused";
        QCOMPARE(widgets::endText(outcome),
            QStringLiteral("Not carried out: the start: it was refused.") + shows);
    }

    /// Behind a fault nothing sends a Stop; where one was sent the reason says so.
    void onlyAStopThatWasSentIsSaid()
    {
        QCOMPARE(widgets::endText({lab::End::Aborted, "the board reports a fault: OVER_CURR", {}}),
            QStringLiteral("Ended: the board reports a fault: OVER_CURR."));
    }

    void whatIsOfferedRuns_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<int>("from");
        QTest::addColumn<int>("to");
        QTest::newRow("without a sensor") << QStringLiteral("pm24") << 1500 << 1800;
        QTest::newRow("a heavy rotor") << QStringLiteral("blower36") << 1150 << 1350;
    }
    void whatIsOfferedRuns()
    {
        QFETCH(const QString, motor);
        QFETCH(const int, from);
        QFETCH(const int, to);
        Bench bench(qPrintable(motor));
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        QCOMPARE(bench.find<QLineEdit>("stepFrom")->text(), QString::number(from));
        QCOMPARE(bench.find<QLineEdit>("stepTo")->text(), QString::number(to));
        QVERIFY2(bench.runToItsEnd(), qPrintable(bench.said()));
        QTRY_VERIFY2(bench.said().startsWith(QLatin1String("Done; ")), qPrintable(bench.said()));
    }

    void theQuestionShowsThePlanAndNoMovesNothing()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500, 3);
        bench.press("stepRun");
        QVERIFY(bench.asks());
        auto *dialog = bench.find<QMessageBox>("experimentQuestion");
        const QString words = dialog->informativeText();
        const char *const braking = "A step down brakes the motor, which feeds the bus: only the "
                                    "cap of the bus voltage bounds that.";
        for (const char *word :
            {"1000", "1500", "3 time", "200", "1750", "-250",
                "up to 250\u202frpm beyond the plan, and 1.25 times the nominal current.", braking})
            QVERIFY2(words.contains(QString::fromUtf8(word)), qPrintable(words));
        QVERIFY(dialog->findChild<widgets::PlanPicture *>()->isVisible());
        QTest::keyClick(dialog, Qt::Key_Return); // Enter does not say yes
        QTRY_VERIFY(!bench.asks());
        QVERIFY(!bench.running());
        QVERIFY(bench.state() == MotorState::Idle);
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
        bench.press("stepRun"); // and Esc takes the question away
        QVERIFY(bench.asks());
        QTest::keyClick(bench.find("experimentQuestion"), Qt::Key_Escape);
        QTRY_VERIFY(!bench.asks());
        QVERIFY(!bench.device().armed());
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
    }

    void aBusThatIsNotToldIsNotPromised()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        const auto subject = bench.rig.workbench.experiments().subject();
        QVERIFY(subject);
        lab::Experiment experiment{lab::StepPlan{.fromRpm = 1000, .toRpm = 1500}, *subject};
        const auto words = [&] {
            const widgets::Confirmation question = widgets::planQuestion({experiment}, {});
            const std::unique_ptr<QWidget> picture(question.picture);
            return question.lines.join(QLatin1Char('\n'));
        };
        const QString unbounded =
            QStringLiteral("This board does not tell its bus voltage: nothing bounds it.");
        QVERIFY(!words().contains(unbounded));
        experiment.subject.registers.bus = 0;
        QVERIFY(words().contains(unbounded));
        QVERIFY(!words().contains(QLatin1String("only the cap of the bus")));
    }

    void currentsAtRestAreInThePicture()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        const auto subject = bench.rig.workbench.experiments().subject();
        QVERIFY(subject && subject->seesRotor());
        const widgets::SpeedPlan steps =
            widgets::speedPlan({{lab::StepPlan{.fromRpm = 1000, .toRpm = 1500}, *subject}}, {});
        QVERIFY(steps.amps.isEmpty());
        const widgets::SpeedPlan rest =
            widgets::speedPlan({{lab::RestPlan{.lowAmps = 1.0, .highAmps = 2.5}, *subject}}, {});
        // From nothing to four currents, each 0.2 s there and 0.4 s held, and to nothing.
        QCOMPARE(rest.amps.size(), 10);
        QCOMPARE(rest.ampSeconds.size(), 10);
        QCOMPARE(rest.amps.first(), 0.0);
        QCOMPARE(rest.amps[1], 1.0);
        QCOMPARE(rest.amps[3], 1.5);
        QCOMPARE(rest.amps[8], 2.5);
        QCOMPARE(rest.amps.last(), 0.0);
        QCOMPARE(rest.ampSeconds[2], 0.6);
        QCOMPARE(rest.ampSeconds.last(), 2.4);
        for (const double rpm : rest.rpm)
            QCOMPARE(rpm, 0.0);
        const auto ofCurrents = [](const widgets::SpeedPlan &plan) {
            return widgets::PlanPicture(plan).findChild<QCustomPlot *>()->yAxis2->visible();
        };
        QVERIFY(ofCurrents(rest) && !ofCurrents(steps));
    }

    void aSeriesBecomesARowOfTheNumbersInItsRecording()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("run.pcapng"));
        recordASeries(path);
        if (!QTest::currentTestFailed())
            aReplayMovesNothing(path);
    }

private:
    void recordASeries(const QString &path)
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500);
        const auto wanted = bench.rig.workbench.signalPlan().named();
        const auto shown = bench.rig.window.scope()->channels();
        const auto streamed = streaming(bench);
        QVERIFY(!streamed.isEmpty());

        session::Recording &recording = bench.rig.workbench.recording();
        recording.start(path, session::RecordingTap::Content::Samples, QStringLiteral("test"),
            QStringLiteral("sim"));
        QSignalSpy finished(&recording, &session::Recording::finished);
        QVERIFY(bench.runToItsEnd());
        QVERIFY2(bench.said().contains(QLatin1String("the motor is as it was")),
            qPrintable(bench.said()));
        QTRY_COMPARE(bench.state(), MotorState::Idle);
        recording.stop();
        QTRY_COMPARE(finished.size(), 1);

        // The same numbers as evaluate tells from the file.
        capture::Capture capture;
        const auto report = session::readRecording(path, capture);
        QVERIFY(report);
        const auto series = lab::stepSeries(capture, report->happenings);
        QVERIFY2(series, series ? "" : series.error().c_str());
        const auto *runs = bench.rig.window.findChild<widgets::StepRuns *>();
        const lab::StepSeries &told = runs->results().front().series;
        QCOMPARE(told.runs.size(), 2U);
        QVERIFY(told.rise_s && told.overshoot_pct && told.peakIq_a);
        QVERIFY(told.rise_s == series->rise_s);
        QVERIFY(told.overshoot_pct == series->overshoot_pct);
        QVERIFY(told.settling_s == series->settling_s);
        QVERIFY(told.peakIq_a == series->peakIq_a);
        QVERIFY(told.runs[0].at == series->runs[0].at && told.runs[0].found);

        using Runs = widgets::StepRuns;
        QVERIFY(bench.cell(0, Runs::RiseColumn).endsWith(QLatin1String("ms")));
        QVERIFY(bench.cell(0, Runs::OvershootColumn).endsWith(QLatin1Char('%')));
        QVERIFY(bench.cell(0, Runs::PeakColumn).endsWith(QLatin1Char('A')));
        QVERIFY(bench.cell(0, Runs::KpColumn).endsWith(QLatin1String("A/(rad/s)")));
        QVERIFY2(bench.cell(0, Runs::KiColumn).endsWith(QLatin1String("A/rad")),
            qPrintable(bench.cell(0, Runs::KiColumn)));
        QVERIFY(bench.cell(0, Runs::BusColumn).endsWith(QLatin1Char('V')));
        QCOMPARE(bench.rig.window.findChild<widgets::StepOverlay *>()->curves(), 1);

        // The scope goes on with what was recorded before.
        QTRY_COMPARE(streaming(bench), streamed);
        QVERIFY(bench.rig.workbench.signalPlan().named() == wanted);
        QCOMPARE(bench.rig.window.scope()->channels(), shown);
    }

    void aReplayMovesNothing(const QString &path)
    {
        facts::WindowRig rig;
        QApplication::setActiveWindow(&rig.window);
        QTest::keyClick(&rig.window, Qt::Key_T, Qt::ControlModifier);
        session::Endpoint replay;
        replay.kind = session::Endpoint::Kind::Trace;
        replay.path = path;
        rig.workbench.device().open(replay);
        QTRY_VERIFY(rig.find<QLabel>("stepSentence")
                        ->text()
                        .contains(QLatin1String("This is a replay of a recording")));
        QVERIFY(!rig.find<QPushButton>("stepRun")->isEnabled());
    }

private Q_SLOTS:
    void aCurrentIsSteppedAsTheSpeedIs_data()
    {
        QTest::addColumn<bool>("flux");
        QTest::addColumn<QString>("from");
        QTest::addColumn<QString>("to");
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("axis");
        QTest::newRow("torque") << false << QStringLiteral("0.4") << QStringLiteral("0.8")
                                << QStringLiteral("Torque 0.40 \u2192 0.80\u202fA, 1\u00d7")
                                << QStringLiteral("Iq [A]");
        QTest::newRow("flux") << true << QStringLiteral("0") << QStringLiteral("-1.5")
                              << QStringLiteral("Flux 0.00 \u2192 \u22121.50\u202fA, 1\u00d7")
                              << QStringLiteral("Id [A]");
    }
    /// Asked about, carried out, and told by the numbers that its recording has.
    void aCurrentIsSteppedAsTheSpeedIs()
    {
        QFETCH(const bool, flux);
        QFETCH(const QString, from);
        QFETCH(const QString, to);
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500);
        auto *kind = bench.find<QComboBox>("stepKind");
        QCOMPARE(kind->accessibleName(), QStringLiteral("What is stepped"));
        QVERIFY(bench.find<QSpinBox>("stepApproach")->isVisible());
        kind->setFocus();
        QTest::keyClick(kind, Qt::Key_End); // the last of them
        QCOMPARE(kind->currentText(), QStringLiteral("Flux"));
        kind->setCurrentIndex(flux ? 2 : 1);
        QVERIFY(!bench.find<QSpinBox>("stepApproach")->isVisible());
        const auto subject = bench.rig.workbench.experiments().subject();
        QVERIFY(subject); // as the command line has it without --speed
        QCOMPARE(bench.find<QLineEdit>("stepSpeed")->text(),
            QString::number(
                lab::currentStepPlanFor(*subject, flux, 0.0, 1.0, bench.device().userLimits())
                    .rpm));
        QCOMPARE(bench.find<QSpinBox>("stepHold")->value(), 20);
        bench.find<QLineEdit>("stepFrom")->setText(from);
        bench.find<QLineEdit>("stepTo")->setText(to);
        QTRY_VERIFY2(bench.run()->isEnabled(), qPrintable(bench.said()));

        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("run.pcapng"));
        session::Recording &recording = bench.rig.workbench.recording();
        recording.start(path, session::RecordingTap::Content::Samples, QStringLiteral("test"),
            QStringLiteral("sim"));
        QSignalSpy finished(&recording, &session::Recording::finished);
        bench.press("stepRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        QVERIFY2(words.contains(QLatin1String("its current jumps from")), qPrintable(words));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
        bench.agree();
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows().rowCount(), 1, kSeriesMs);
        QVERIFY2(bench.said().contains(QLatin1String("the motor is as it was")),
            qPrintable(bench.said()));
        QTRY_COMPARE(bench.state(), MotorState::Idle);
        recording.stop();
        QTRY_COMPARE(finished.size(), 1);

        capture::Capture capture;
        const auto report = session::readRecording(path, capture);
        QVERIFY(report);
        QCOMPARE(lab::nameOfRun(lab::runsIn(report->happenings).front()),
            std::string(flux ? "step flux" : "step torque"));
        const auto found = lab::findingIn(capture, report->happenings); // as evaluate does
        QVERIFY2(found, found ? "" : found.error().c_str());
        const auto &evaluated = std::get<lab::MeasuredSteps>(*found);
        const auto *runs = bench.rig.window.findChild<widgets::StepRuns *>();
        const lab::StepSeries &told = runs->results().front().series;
        QCOMPARE(told.runs.size(), 2U);
        QVERIFY(told.rise_s && told.rise_s->value > 0.0 && told.rise_s->value < 0.02);
        QVERIFY(told.rise_s == evaluated.rise_s);
        QVERIFY(told.overshoot_pct == evaluated.overshoot_pct);
        QVERIFY(told.settling_s == evaluated.settling_s);
        QVERIFY(told.peakIq_a && told.peakIq_a == evaluated.peakIq_a);

        using Runs = widgets::StepRuns;
        QTEST(bench.cell(0, Runs::StepColumn), "step");
        QVERIFY(bench.cell(0, Runs::RiseColumn).endsWith(QLatin1String("ms")));
        const QString kp = bench.cell(0, Runs::KpColumn); // of the loop that was stepped
        QVERIFY2(!kp.isEmpty() && !kp.contains(QLatin1String("rad")), qPrintable(kp));
        const auto *picture = bench.rig.window.findChild<widgets::StepOverlay *>();
        QCOMPARE(picture->curves(), 1);
        QTEST(picture->findChild<QCustomPlot *>()->yAxis->label(), "axis");

        kind->setCurrentIndex(0); // with what was typed for it
        QCOMPARE(picture->curves(), 0);
        QCOMPARE(bench.find<QLineEdit>("stepTo")->text(), QStringLiteral("1500"));
        QCOMPARE(bench.find<QSpinBox>("stepHold")->value(), 200);
        kind->setCurrentIndex(flux ? 2 : 1);
        QCOMPARE(bench.find<QLineEdit>("stepTo")->text(), to);
    }

    void aCurrentBeyondItsCapsMovesNothing()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        auto *kind = bench.find<QComboBox>("stepKind");
        const auto refused = [&](const char *from, const char *to, const char *why) {
            bench.find<QLineEdit>("stepFrom")->setText(QLatin1String(from));
            bench.find<QLineEdit>("stepTo")->setText(QLatin1String(to));
            return QTest::qWaitFor([&] {
                return !bench.run()->isEnabled()
                    && bench.run()->toolTip().contains(QLatin1String(why));
            });
        };
        kind->setCurrentIndex(1);
        QTRY_VERIFY2(bench.run()->isEnabled(), qPrintable(bench.said())); // what is offered
        QVERIFY(refused("0.4", "99", "The limit is"));
        QVERIFY(refused("-0.4", "0.4", "push the same way"));
        QVERIFY(refused("0.4", "0.4", "there is no step"));
        kind->setCurrentIndex(2);
        QTRY_VERIFY2(bench.run()->isEnabled(), qPrintable(bench.said()));
        QVERIFY(refused("0", "-6", "that are allowed")); // 0.7 of 7 A
        bench.device().setUserLimits({0.0, 0.5});
        QVERIFY(refused("0", "-0.8", "The limit is"));
        bench.press("stepRun");
        QVERIFY(!bench.asks());
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
    }

    /// The measure of the page: change a gain and see the new step, in two actions.
    void aChangedGainAndItsNewStepAreTwoActions()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500);
        bench.kp()->setFocus();
        QVERIFY(bench.runToItsEnd());
        QTRY_VERIFY(bench.run()->isEnabled());
        const auto before = bench.held("SPEED_KP");
        const int steps = bench.rig.workbench.edits().steps().count();
        using Runs = widgets::StepRuns;
        const QString first = bench.cell(0, Runs::KpColumn);

        QVERIFY(bench.kp()->hasFocus());
        bench.actions = 0;
        bench.wheel(bench.kp(), 1);
        QVERIFY(bench.runToItsEnd()); // asks nothing: the caps are the same
        QCOMPARE(bench.actions, 2);
        QVERIFY(!bench.asks());

        QCOMPARE(bench.held("SPEED_KP"), std::int64_t(std::llround(double(before) * 1.05)));
        QCOMPARE(bench.rows().rowCount(), 2);
        QVERIFY(bench.cell(1, Runs::KpColumn) != first);
        QVERIFY(bench.cell(1, Runs::RiseColumn).contains(QLatin1Char('('))); // the difference
        QVERIFY(!bench.cell(0, Runs::RiseColumn).contains(QLatin1Char('(')));
        QCOMPARE(bench.rig.window.findChild<widgets::StepOverlay *>()->curves(), 2);

        // The same by keys alone.
        QVERIFY(bench.kp()->hasFocus());
        QTRY_VERIFY(bench.run()->isEnabled());
        QTest::keyClick(bench.kp(), Qt::Key_Down);
        QTest::keyClick(bench.kp(), Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE_WITH_TIMEOUT(bench.rows().rowCount(), 3, kSeriesMs);
        QCOMPARE(bench.cell(2, Runs::KpColumn), first);

        // Each notch is a step of the list that can be taken back.
        QCOMPARE(bench.rig.workbench.edits().steps().count(), steps + 2);
        bench.rig.workbench.edits().undo();
        QTRY_COMPARE(bench.held("SPEED_KP"), std::int64_t(std::llround(double(before) * 1.05)));
        bench.rig.workbench.edits().undo();
        QTRY_COMPARE(bench.held("SPEED_KP"), before);
    }

    /// Also the keys that the scope has in the whole window, and as fast as they come.
    void everyNotchIsWrittenWhileArmedAndNoneBefore()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(!bench.kp()->isEnabled());
        QVERIFY(bench.kp()->toolTip().contains(QLatin1String("Arm first")));
        QVERIFY(bench.arm());
        const auto before = bench.held("SPEED_KP");
        bench.kp()->setFocus();
        std::int64_t wanted = before;
        const auto notches = [&](int count) {
            wanted = std::llround(double(wanted) * std::pow(1.05, count));
        };
        bench.kp()->selectAll();
        for (int i = 0; i < 4; ++i) { // the board is slower than these
            QTest::keyClick(bench.kp(), Qt::Key_Up);
            notches(1);
        }
        QTest::keyClick(bench.kp(), Qt::Key_PageDown);
        notches(-10);
        QTRY_COMPARE(bench.held("SPEED_KP"), wanted);
        QTRY_VERIFY(bench.kp()->settled());
        QCOMPARE(bench.kp()->text(), QString::number(wanted));
        // What is typed next takes its place.
        QCOMPARE(bench.kp()->selectedText(), QString::number(wanted));

        bench.kp()->selectAll(); // typed, it is written with Enter alone
        QToolTip::showText({}, QStringLiteral("of something else"), &bench.rig.window);
        const QSignalSpy read(&bench.device(), &widgets::Device::readingsArrived);
        // What is read meanwhile takes neither the selection nor a tool tip away.
        QTRY_VERIFY(read.size() > 5);
        QCOMPARE(QToolTip::text(), QStringLiteral("of something else"));
        QToolTip::hideText();
        QTest::keyClicks(bench.kp(), QStringLiteral("4000"));
        QCOMPARE(bench.kp()->text(), QStringLiteral("4000"));
        QTest::keyClick(bench.kp(), Qt::Key_Tab);
        QTRY_COMPARE(bench.kp()->text(), QString::number(wanted));
        bench.kp()->setFocus();
        bench.kp()->selectAll();
        QTest::keyClicks(bench.kp(), QStringLiteral("4000"));
        QTest::keyClick(bench.kp(), Qt::Key_Return);
        QTRY_COMPARE(bench.held("SPEED_KP"), 4000);
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
    }

    void widerCapsAreAskedAboutAgainAndSoIsEverythingAfterDisarming()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500);
        QVERIFY(bench.runToItsEnd());
        bench.plan(1200, 1700); // beyond what was agreed to
        QTRY_VERIFY(bench.run()->isEnabled());
        bench.press("stepRun");
        QVERIFY(bench.asks());
        bench.agree();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.running() && bench.rows().rowCount() == 2, kSeriesMs);
        QTest::mouseClick(bench.find<QCheckBox>("arm"), Qt::LeftButton, {},
            QPoint(8, bench.find<QCheckBox>("arm")->height() / 2));
        QTRY_VERIFY(!bench.device().armed());
        QVERIFY2(bench.arm(), qPrintable(bench.said()));
        bench.plan(1000, 1500);
        QTRY_VERIFY(bench.run()->isEnabled());
        bench.press("stepRun");
        QVERIFY(bench.asks());
    }

    /// Yes to one short step is none to a hundred.
    void aLongerSeriesIsAskedAboutAgain()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500, 2);
        QVERIFY(bench.runToItsEnd());
        bench.plan(1000, 1500, 1); // asks nothing
        QTRY_VERIFY(bench.run()->isEnabled());
        bench.press("stepRun");
        QVERIFY(!bench.asks());
        QTRY_VERIFY_WITH_TIMEOUT(!bench.running() && bench.rows().rowCount() == 2, kSeriesMs);
        bench.plan(1000, 1500, 3);
        QTRY_VERIFY(bench.run()->isEnabled());
        bench.press("stepRun");
        QVERIFY(bench.asks());
        QVERIFY(!bench.running());
    }

    /// What is told of it later is told of a copy.
    void aRefusalAtOnceTakesNothingFromWhatListensBehindIt()
    {
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500);
        widgets::Experiments &experiments = bench.rig.workbench.experiments();
        disconnect(&experiments, &widgets::Experiments::wished, nullptr, nullptr);
        connect(&experiments, &widgets::Experiments::wished, this, [&] {
            experiments.end(
                {.end = lab::End::Refused, .reason = "no port is open", .at = bench.world.now()});
        });
        const QSignalSpy wished(&experiments, &widgets::Experiments::wished);
        bench.press("stepRun");
        bench.agree();
        QTRY_COMPARE(wished.size(), 1);
        QVERIFY(!bench.running());
        const auto asked = wished.front().front().value<lab::Experiment>();
        QCOMPARE(std::get<lab::StepPlan>(asked.plan).toRpm, 1500);
        QCOMPARE(asked.subject.nameOf(asked.subject.registers.bus), std::string("BUS_VOLTAGE"));
        QTRY_VERIFY(bench.said().startsWith(QLatin1String("Not carried out: no port is open")));
        QCOMPARE(bench.world.counts().setPoints + bench.world.counts().starts, 0);
    }

    void escAndCancelStopTheMotorInTheMiddle_data()
    {
        QTest::addColumn<bool>("byKey");
        QTest::newRow("Esc") << true;
        QTest::newRow("Cancel") << false;
    }
    void escAndCancelStopTheMotorInTheMiddle()
    {
        QFETCH(bool, byKey);
        Bench bench;
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm());
        bench.plan(1000, 1500, 20);
        bench.press("stepRun");
        bench.agree();
        QTRY_VERIFY_WITH_TIMEOUT(bench.said().startsWith(QLatin1String("Step 2 of 40")), kSeriesMs);
        if (byKey)
            QTest::keyClick(&bench.rig.window, Qt::Key_Escape);
        else
            bench.press("stepCancel");
        QVERIFY(!bench.device().armed());
        QTRY_VERIFY(!bench.running());
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
        QVERIFY2(bench.said().contains(QLatin1String("Interrupted: ")), qPrintable(bench.said()));
        const auto &events = bench.rig.workbench.events().events();
        const auto noted = [&](const char *text) {
            return std::any_of(events.begin(), events.end(), [&](const widgets::ScopeEvent &event) {
                return event.text.contains(QLatin1String(text));
            });
        };
        QVERIFY(noted("Experiment: Start"));
        QVERIFY(noted("Experiment: Speed ramp 1500 rpm in 0 ms"));
        QVERIFY(noted("Experiment: Interrupted: "));
        const int setPoints = bench.world.counts().setPoints;
        const auto since = bench.rig.workbench.now();
        QTRY_VERIFY(bench.rig.workbench.now() > since + 500ms);
        QCOMPARE(bench.world.counts().setPoints, setPoints);
        QVERIFY(!bench.run()->isEnabled());
    }

    /// With how well that is known. Whether it is conclusive depends on how often this computer has time to read.
    void aBoardThatRecordsNothingIsSteppedByWhatIsRead()
    {
        support::OlderBoardWindow old;
        old.open(Qt::Key_T, Qt::ControlModifier);
        facts::WindowRig &rig = old.rig;
        widgets::Device &device = rig.workbench.device();
        const widgets::Experiments &experiments = rig.workbench.experiments();
        auto *run = rig.find<QPushButton>("stepRun");
        const auto refused = [run](const char *why) {
            return !run->isEnabled() && run->toolTip().contains(QLatin1String(why));
        };
        QTRY_VERIFY2(refused("agree to expert mode"), qPrintable(run->toolTip()));
        QVERIFY(!experiments.subject()); // for what is recorded
        device.becomeExpert(1);
        QTRY_VERIFY2(refused("Arm first."), qPrintable(run->toolTip()));
        old.arm();
        QTRY_VERIFY2(refused("how fast this motor may turn"), qPrintable(run->toolTip()));
        device.setUserLimits({4000.0, 0.0});
        QTRY_VERIFY2(run->isEnabled(), qPrintable(run->toolTip()));
        // Twice the least speed of an observer is 0.3 of the user's limit, as it is of a board's.
        QCOMPARE(rig.find<QLineEdit>("stepFrom")->text(), QStringLiteral("1500"));
        QCOMPARE(rig.find<QLineEdit>("stepTo")->text(), QStringLiteral("1800"));

        const auto currents = rig.find<QComboBox>("stepKind")->model()->index(1, 0);
        QVERIFY(!currents.flags().testFlag(Qt::ItemIsEnabled)); // and says why
        QVERIFY(!currents.data(Qt::ToolTipRole).toString().isEmpty());

        rig.find<QLineEdit>("stepTo")->setText(QStringLiteral("1650"));
        QTRY_VERIFY2(run->isEnabled(), qPrintable(run->toolTip()));
        QTest::mouseClick(run, Qt::LeftButton);
        auto *question = rig.find<QMessageBox>("experimentQuestion");
        QVERIFY(question);
        const QString asked = question->informativeText(); // nothing tells its current
        QVERIFY2(asked.contains(QStringLiteral("While it starts, only 4000\u202frpm bound it.")),
            qPrintable(asked));
        QTest::mouseClick(question->findChild<QPushButton *>(QStringLiteral("experimentConfirm")),
            Qt::LeftButton);
        QTRY_VERIFY(experiments.running());
        QTRY_VERIFY_WITH_TIMEOUT(!experiments.running(), kSeriesMs);
        QTRY_VERIFY_WITH_TIMEOUT(run->isEnabled(), kSeriesMs); // evaluated
        const QString said = rig.find<QLabel>("stepSentence")->text();
        QVERIFY2(said.startsWith(QLatin1String("Done; ")), qPrintable(said));
        QVERIFY2(
            said.contains(QLatin1String("The board records nothing: its speed was read once in")),
            qPrintable(said));
        const QAbstractItemModel &rows = *rig.find<QTreeView>("stepRuns")->model();
        const bool conclusive = !said.contains(QLatin1String("Not conclusive: "));
        QCOMPARE(rows.rowCount(), conclusive ? 1 : 0);
        QCOMPARE(rig.window.findChild<widgets::StepOverlay *>()->curves(), conclusive ? 1 : 0);
        QTRY_COMPARE_WITH_TIMEOUT(device.status(1).state, MotorState::Idle, 10'000);
    }

private:
    static QStringList streaming(Bench &bench)
    {
        QStringList names;
        const capture::Capture &capture = bench.rig.workbench.capture();
        for (const auto id : capture.streaming())
            names.append(QString::fromStdString(capture.info(id)->name));
        return names;
    }
};

QTEST_MAIN(TestStepPage)
#include "tst_step_page.moc"
