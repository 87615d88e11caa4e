// The tour through the real window, from gains that are wrong to proved ones, on boards with an encoder, with Hall
// sensors and without a sensor: what is asked, what each station says, and that what a board cannot have is told. The
// judge of the wire watches all of it.
#include "widgets/lab/lab_window.h"
#include "widgets/lab/loop/tuning.h"
#include "widgets/lab/tour_steps.h"

#include <QElapsedTimer>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QUndoStack>

using drive::MotorState;
using support::LabWindow;
using Steps = widgets::TourSteps;
using State = Steps::State;

namespace {

Steps &stepsOf(LabWindow &bench)
{
    return *static_cast<Steps *>(bench.find<QTreeView>("tourSteps")->model());
}
QString tourText(LabWindow &bench)
{
    QStringList lines;
    for (int row = 0; row < Steps::kSteps; ++row)
        lines.append(bench.cell("tourSteps", row, Steps::StepColumn) + QStringLiteral(": ")
            + bench.cell("tourSteps", row, Steps::StateColumn) + QStringLiteral(", ")
            + bench.cell("tourSteps", row, Steps::ResultColumn));
    return lines.join(QLatin1Char('\n')) + QLatin1Char('\n') + bench.said("tourSentence");
}

void scaleGains(LabWindow &bench, double factor)
{
    QTRY_VERIFY(bench.held("SPEED_KP") > 0 && bench.held("SPEED_KI") > 0);
    if (factor == 1.0)
        return;
    widgets::RegisterModel &registers = bench.rig.workbench.registers();
    widgets::RegisterEdits &edits = bench.rig.workbench.edits();
    const std::int64_t kp = std::llround(factor * double(bench.held("SPEED_KP"))),
                       ki = std::llround(factor * double(bench.held("SPEED_KI")));
    edits.write(QStringLiteral("wrong gains"),
        {{registers.idOf("SPEED_KP").value_or(0), kp},
            {registers.idOf("SPEED_KI").value_or(0), ki}});
    QTRY_COMPARE_WITH_TIMEOUT(bench.held("SPEED_KP"), kp, 10'000);
    QTRY_COMPARE_WITH_TIMEOUT(bench.held("SPEED_KI"), ki, 10'000);
    QTRY_VERIFY(!edits.underWay());
}

} // namespace

class TestTourPage : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    /// Hall sensors and none take their time: they are looked at in long runs.
    void fromWrongGainsToProvedOnes_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<int>("length_s");
        QTest::addColumn<double>("factor"); // of the gains that suit the board's motor
        QTest::newRow("encoder, four times the gains") << QStringLiteral("servo24") << 6 << 4.0;
        if (qEnvironmentVariableIsSet("ROTORSCOPE_LONG")) {
            QTest::newRow("encoder, a quarter of the gains")
                << QStringLiteral("servo24") << 6 << 0.25;
            QTest::newRow("Hall") << QStringLiteral("blower36") << 16 << 1.0;
            QTest::newRow("sensorless") << QStringLiteral("pm24") << 16 << 1.0;
        }
    }
    void fromWrongGainsToProvedOnes()
    {
        QFETCH(const QString, motor);
        QFETCH(const int, length_s);
        QFETCH(const double, factor);
        LabWindow bench(motor.toStdString());
        bench.open(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.connectBoard());
        QTRY_VERIFY(bench.cell("tourSteps", Steps::Check, Steps::ResultColumn)
                        .contains(QLatin1String("Arm first")));
        QTRY_VERIFY(
            bench.find<QPushButton>("tourRun")->toolTip().contains(QLatin1String("Arm first")));
        QVERIFY2(bench.said("tourSentence").isEmpty(), qPrintable(tourText(bench))); // once
        QVERIFY(bench.arm("tourRun"));
        QTRY_COMPARE(stepsOf(bench).state(Steps::Check), State::Done);
        bench.find<QSpinBox>("tourLength")->setValue(length_s);
        QVERIFY(!bench.find<QPushButton>("tourProveRun")->isEnabled());
        scaleGains(bench, factor);
        if (QTest::currentTestFailed())
            return;
        QTRY_VERIFY(bench.find<QPushButton>("tourRun")->isEnabled());
        const auto kp = bench.held("SPEED_KP"), ki = bench.held("SPEED_KI");
        const int steps = bench.rig.workbench.edits().steps().count();
        QElapsedTimer time;
        time.start();

        bench.press("tourRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        QVERIFY2(words.contains(QLatin1String("5. 5 time")), qPrintable(words));
        bench.agree();
        // One station after the other, without another question.
        QVERIFY(QTest::qWaitFor(
            [&] {
                const State state = stepsOf(bench).state(Steps::Response);
                return (state != State::Waits && state != State::Runs)
                    || stepsOf(bench).state(Steps::Windings) == State::Ended
                    || stepsOf(bench).state(Steps::Mechanics) == State::Ended;
            },
            2 * LabWindow::kRunMs));
        const QString told = tourText(bench);
        qInfo("%s", qPrintable(told));
        // What is not conclusive is told with its reason.
        const bool encoder = motor == QLatin1String("servo24");
        for (const Steps::Step step : {Steps::Windings, Steps::Mechanics, Steps::Response}) {
            QVERIFY2(stepsOf(bench).state(step) == State::Done
                    || (!encoder && stepsOf(bench).state(step) == State::Unclear),
                qPrintable(told));
            QVERIFY(!bench.cell("tourSteps", step, Steps::ResultColumn).isEmpty());
        }
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
        QCOMPARE(bench.held("SPEED_KP"), kp); // nothing is written yet
        QCOMPARE(bench.rig.workbench.edits().steps().count(), steps);
        if (stepsOf(bench).state(Steps::Response) == State::Unclear) {
            QVERIFY(!bench.find<QPushButton>("tourProveRun")->isEnabled());
            QVERIFY(stepsOf(bench).state(Steps::Gains) == State::Unclear
                || stepsOf(bench).state(Steps::Gains) == State::PassedOver);
            QCOMPARE(stepsOf(bench).state(Steps::Proof), State::PassedOver);
            return;
        }
        QTRY_VERIFY(bench.find<QPushButton>("tourProveRun")->isEnabled());

        bench.press("tourProveRun");
        QVERIFY(QTest::qWaitFor([&] { return bench.running(); }, 10'000));
        QVERIFY(!bench.asks());
        QVERIFY(QTest::qWaitFor([&] { return !bench.running(); }, LabWindow::kRunMs));
        QTRY_VERIFY_WITH_TIMEOUT(stepsOf(bench).state(Steps::Proof) != State::Runs, 20'000);
        qInfo("%s", qPrintable(tourText(bench)));
        qInfo("%s: %lld s, %d confirmations besides arming", qPrintable(motor),
            time.elapsed() / 1000, bench.questions);
        QCOMPARE(bench.questions, 1);
        QCOMPARE(bench.rig.workbench.edits().steps().count(), steps + 1);
        QVERIFY(bench.held("SPEED_KP") != kp || bench.held("SPEED_KI") != ki);
        // The noisy speed of a board without an encoder may be worse than its prediction: that is told, with the way
        // back.
        const QString proof = bench.cell("tourSteps", Steps::Proof, Steps::ResultColumn);
        QVERIFY2(stepsOf(bench).state(Steps::Proof) == State::Done
                || (!encoder
                    && (proof.contains(QLatin1String("than predicted"))
                        || proof.contains(QLatin1String("Neither proved")))),
            qPrintable(tourText(bench)));

        QString toldOfWrite;
        const QObject listener;
        connect(&bench.rig.workbench.edits(), &widgets::RegisterEdits::told, &listener,
            [&](const QString &sentence, bool) { toldOfWrite = sentence; });
        bench.press("tourBack");
        const auto isBack = [&] {
            // On a machine that stalls it may be too late to be sent, which is said; then it is asked for again.
            if (toldOfWrite.contains(QLatin1String(drive::kTooLate))) {
                toldOfWrite.clear();
                bench.press("tourBack");
            }
            return bench.held("SPEED_KP") == kp;
        };
        QVERIFY2(QTest::qWaitFor(isBack, 10'000), qPrintable(toldOfWrite));
        QTRY_COMPARE(bench.held("SPEED_KI"), ki);
        QTRY_VERIFY(!bench.rig.workbench.edits().underWay());
    }

    void withoutAResponseTheRestIsPassedOver_data()
    {
        QTest::addColumn<bool>("before"); // the page of the response has measured a good one
        QTest::newRow("the first one") << false;
        QTest::newRow("one from before") << true;
    }
    /// Gains that are changed meanwhile make the response that of no loop: what follows from it is not waited for, and
    /// nothing follows from another one.
    void withoutAResponseTheRestIsPassedOver()
    {
        QFETCH(const bool, before);
        LabWindow bench("servo24");
        const auto page = [&bench](Qt::Key key) {
            bench.open(key, Qt::ControlModifier | Qt::ShiftModifier);
        };
        page(before ? Qt::Key_F : Qt::Key_G);
        QVERIFY(bench.connectBoard());
        if (before) {
            QVERIFY(bench.arm("speedResponseRun"));
            bench.find<QSpinBox>("responseLength")->setValue(6);
            QVERIFY(bench.runToItsEnd("speedResponseRun"));
            QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
            page(Qt::Key_G);
        }
        QVERIFY(bench.arm("tourRun"));
        QTRY_COMPARE(bench.find<QPushButton>("tourProveRun")->isEnabled(), before);
        bench.find<QSpinBox>("tourLength")->setValue(4);
        const auto kp = bench.held("SPEED_KP");
        bench.press("tourRun");
        QVERIFY(bench.asks());
        bench.agree();
        QTRY_COMPARE_WITH_TIMEOUT(
            stepsOf(bench).state(Steps::Response), State::Runs, 2 * LabWindow::kRunMs);
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Running, 20'000);
        bench.rig.workbench.edits().write(QStringLiteral("another gain"),
            {{bench.rig.workbench.registers().idOf("SPEED_KP").value_or(0), kp / 2}});
        QTRY_COMPARE_WITH_TIMEOUT(
            stepsOf(bench).state(Steps::Response), State::Unclear, LabWindow::kRunMs);
        QCOMPARE(stepsOf(bench).state(Steps::Gains), State::PassedOver);
        QCOMPARE(stepsOf(bench).state(Steps::Proof), State::PassedOver);
        QTRY_VERIFY(bench.find<QPushButton>("tourProveRun")
                        ->toolTip()
                        .contains(QLatin1String("was not conclusive")));
        QVERIFY(!bench.find<QPushButton>("tourProveRun")->isEnabled());
    }

    void whatOneStationLeftEndsTheTour()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("tourRun"));
        widgets::Experiments &experiments = bench.rig.workbench.experiments();
        bench.press("tourRun");
        bench.agree();
        QTRY_VERIFY(bench.running());
        experiments.end({.reason = {}, .at = bench.world.now()}); // the windings are of two parts
        QVERIFY(bench.running());
        QSignalSpy wished(&experiments, &widgets::Experiments::wished);
        experiments.end({.reason = "the set-point is 900 rpm now, it was 0 rpm",
            .at = bench.world.now(),
            .leaves = true});
        QTRY_COMPARE_WITH_TIMEOUT(stepsOf(bench).state(Steps::Mechanics), State::Ended, 20'000);
        const QString why = bench.cell("tourSteps", Steps::Mechanics, Steps::ResultColumn);
        QVERIFY2(why.contains(QLatin1String("Not continued: The set-point is 900 rpm now")),
            qPrintable(tourText(bench)));
        QCOMPARE(wished.size(), 0);
        QTest::keyClick(&bench.rig.window, Qt::Key_Escape); // the board's goes on
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
    }

    /// Windings and response need a speed at rest. The gains of the next response are no part of what was agreed to.
    void behindASwingItGoesOnAndAsksForGentlerGains()
    {
        LabWindow bench("servo24");
        bench.open(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("tourRun"));
        scaleGains(bench, 1.0);
        if (QTest::currentTestFailed())
            return;
        widgets::Experiments &experiments = bench.rig.workbench.experiments();
        // How each one ends is told here; none reaches the board.
        QObject::disconnect(&experiments, &widgets::Experiments::wished, nullptr, nullptr);
        std::vector<lab::Experiment> wished;
        const QObject listener;
        connect(&experiments, &widgets::Experiments::wished, &listener,
            [&wished](const lab::Experiment &one) { wished.push_back(one); });
        const auto *button = bench.find<QPushButton>("tourRun");
        const QString start = button->text();
        const auto swings = [&] {
            experiments.end({.end = lab::End::Refused,
                .reason = "the speed did not come to rest at 1600 rpm",
                .at = bench.world.now(),
                .swings = true});
        };
        bench.press("tourRun");
        bench.agree();
        QTRY_VERIFY(bench.running());
        experiments.end({.reason = {}, .at = bench.world.now()}); // the windings are of two parts
        QVERIFY(bench.running());
        swings();
        QTRY_COMPARE(stepsOf(bench).state(Steps::Mechanics), State::Runs);
        QCOMPARE(stepsOf(bench).state(Steps::Windings), State::Ended);
        QVERIFY(bench.running() && !bench.asks());
        experiments.end({.reason = {}, .at = bench.world.now()});
        QTRY_COMPARE(stepsOf(bench).state(Steps::Response), State::Runs);
        QVERIFY(bench.running() && !bench.asks());
        QCOMPARE(wished.size(), 4U);

        swings();
        QTRY_COMPARE(stepsOf(bench).state(Steps::Response), State::Ended);
        const QString told = bench.cell("tourSteps", Steps::Response, Steps::ResultColumn);
        QVERIFY2(told.contains(QLatin1String("It swings with its gains"))
                && told.contains(QLatin1String("Go on with the tour")),
            qPrintable(told));
        QVERIFY(button->text() != start);
        QVERIFY(!bench.running() && !bench.asks());
        QCOMPARE(wished.size(), 4U); // nothing by itself
        QTRY_VERIFY(button->isEnabled());
        // Whoever writes others meanwhile has these measured, to which the first question was; so its tool tip says.
        scaleGains(bench, 2.0);
        if (QTest::currentTestFailed())
            return;
        QTRY_VERIFY(button->isEnabled());
        QVERIFY2(button->toolTip().contains(QLatin1String("others are taken as they are")),
            qPrintable(button->toolTip()));
        bench.press("tourRun");
        if (bench.asks())
            bench.agree();
        QTRY_COMPARE(stepsOf(bench).state(Steps::Response), State::Runs);
        QCOMPARE(wished.size(), 5U);
        QCOMPARE(std::get<lab::ResponsePlan>(wished.back().plan).kp, 0);
        swings();
        QTRY_COMPARE(stepsOf(bench).state(Steps::Response), State::Ended);
        QTRY_VERIFY(button->isEnabled());
        bench.press("tourRun");
        QVERIFY(bench.asks());
        const QString words = bench.find<QMessageBox>("experimentQuestion")->informativeText();
        const QString kp = QString::number(bench.held("SPEED_KP") / 4);
        QVERIFY2(words.contains(QStringLiteral("Its gains are Kp ") + kp)
                && !words.contains(QLatin1String("At rest")),
            qPrintable(words));
        bench.agree();
        QTRY_COMPARE(stepsOf(bench).state(Steps::Response), State::Runs);
        QCOMPARE(stepsOf(bench).state(Steps::Windings), State::Ended); // as it was
        QCOMPARE(wished.size(), 6U);
        QCOMPARE(std::get<lab::ResponsePlan>(wished.back().plan).kp, kp.toInt());
        experiments.end({.reason = {}, .at = bench.world.now()}); // of which nothing is known
        QTRY_COMPARE(stepsOf(bench).state(Steps::Response), State::Unclear);
        QCOMPARE(button->text(), start);
    }

    void escEndsTheWholeTour()
    {
        LabWindow bench("servo24", {960, 540});
        bench.open(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.connectBoard());
        QVERIFY(bench.arm("tourRun"));
        bench.press("tourRun");
        bench.agree();
        QTRY_VERIFY_WITH_TIMEOUT(bench.world.counts().starts > 0, 20'000);
        QTest::keyClick(&bench.rig.window, Qt::Key_Escape);
        QTRY_VERIFY(!bench.running());
        QTRY_COMPARE(stepsOf(bench).state(Steps::Windings), State::Ended);
        QCOMPARE(stepsOf(bench).state(Steps::Mechanics), State::Waits);
        QTRY_COMPARE_WITH_TIMEOUT(bench.state(), MotorState::Idle, 10'000);
        QCOMPARE(bench.world.counts().starts, 1);
    }

    void aBoardThatRecordsNothingIsToldAtTheFirstStation()
    {
        support::OlderBoardWindow old;
        old.open(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        const auto told = [&] {
            return old.rig.find<QTreeView>("tourSteps")
                ->model()
                ->index(Steps::Check, Steps::ResultColumn)
                .data()
                .toString();
        };
        QTRY_COMPARE(told(), old.rig.workbench.experiments().obstacle());
        QVERIFY(!old.rig.find<QPushButton>("tourRun")->isEnabled());
    }
};

QTEST_MAIN(TestTourPage)
#include "tst_tour_page.moc"
