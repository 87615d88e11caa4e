// The form of the gains: the lab gives ST's numbers, a preview makes edits and sends nothing, numerator and divisor go
// together, everything can be done with the keyboard, and nothing that is not understood becomes a gain.
#include "support/gain_bench.h"
#include "support/window_rig.h"
#include "widgets/forms/gain_label.h"
#include "widgets/forms/gain_texts.h"
#include "widgets/window/shortcut_guard.h"

#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QLabel>
#include <QLayout>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QWheelEvent>

#include <cmath>
#include <set>

using catalog::Value;
using facts::GainBench;
using widgets::RegisterModel;
using namespace std::chrono_literals;

namespace {

std::int64_t wantedOf(GainBench &bench, const char *name)
{
    return std::get<std::int64_t>(*bench.model.wanted(bench.id(name)));
}

QString textOf(GainBench &bench, const char *name)
{
    return bench.form.findChild<QLabel *>(QLatin1String(name))->text();
}

bool within(std::int64_t is, double wanted, double share)
{
    return std::abs(double(is) - wanted) <= share * wanted;
}

void typeMotor(GainBench &bench, const char *rs, const char *lq, const char *ld)
{
    bench.typeInto("labRs", QLatin1String(rs));
    bench.typeInto("labLq", QLatin1String(lq));
    bench.typeInto("labLd", QLatin1String(ld));
}

} // namespace

class TestGainsForm : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }

    // Must show 2: the two vectors of ST's generator.

    void theLabReproducesTheWorkedExample()
    {
        GainBench bench;
        for (const char *name : {"I_Q_KP", "I_Q_KI", "I_D_KP", "I_D_KI"})
            QVERIFY(bench.type(name, QStringLiteral("1")));
        QVERIFY(bench.apply());
        bench.look();
        typeMotor(bench, "0.35", "0.6", "0.6");
        bench.typeInto("labBandwidth", QStringLiteral("1500"));
        bench.button("labPreview")->click();
        QCOMPARE(wantedOf(bench, "I_Q_KP"), 4621);
        QCOMPARE(wantedOf(bench, "I_Q_KP_DIV"), 10);
        QCOMPARE(wantedOf(bench, "I_Q_KI"), 2696);
        QCOMPARE(wantedOf(bench, "I_Q_KI_DIV"), 14);
        QCOMPARE(wantedOf(bench, "I_D_KP"), 4621);
        QCOMPARE(bench.edits.pendingCount(), 4);
        QVERIFY(bench.writes.size() == 1); // that of the beginning
    }

    void theLabReproducesTheGeneratedProject()
    {
        GainBench bench;
        typeMotor(bench, "0,03", "0.117", "0.069849"); // either point
        bench.typeInto("labBandwidth", QStringLiteral("6000"));
        bench.button("labPreview")->click();
        QVERIFY(within(wantedOf(bench, "I_Q_KP"), 3614, 0.003));
        QCOMPARE(wantedOf(bench, "I_Q_KP_DIV"), 10);
        QVERIFY(within(wantedOf(bench, "I_Q_KI"), 925, 0.003));
        QCOMPARE(wantedOf(bench, "I_Q_KI_DIV"), 14);
        QVERIFY(within(wantedOf(bench, "I_D_KP"), 2158, 0.003));
        auto *table = bench.form.findChild<QTableWidget *>(QStringLiteral("labGains"));
        QVERIFY(table->item(0, 2)->text().startsWith(QString::number(wantedOf(bench, "I_Q_KP"))));
        QAbstractItemModelTester tester(
            table->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        bench.typeInto("labBandwidth", QStringLiteral("5000"));
    }

    void whatWaitsToBeWrittenFollowsTheForm()
    {
        GainBench bench;
        typeMotor(bench, "0.35", "0.6", "0.6");
        bench.typeInto("labBandwidth", QStringLiteral("1000"));
        bench.button("labPreview")->click();
        const auto first = wantedOf(bench, "I_Q_KP");
        bench.typeInto("labBandwidth", QStringLiteral("2500"));
        auto *table = bench.form.findChild<QTableWidget *>(QStringLiteral("labGains"));
        const auto second = wantedOf(bench, "I_Q_KP");
        QVERIFY(second != first);
        QVERIFY(table->item(0, 2)->text().startsWith(QString::number(second)));
        auto *told = bench.form.findChild<QLabel *>(QStringLiteral("labTold"));
        QVERIFY(told);
        QVERIFY(told->text().contains(QStringLiteral("wait")));
        QVERIFY(bench.apply());
        QCOMPARE(std::get<std::int64_t>(*bench.model.known(bench.id("I_Q_KP"))), second);
        QCOMPARE(told->text(), QString()); // nothing waits any more

        // A form that has no answer takes its edits back.
        bench.typeInto("labBandwidth", QStringLiteral("3000"));
        bench.button("labPreview")->click();
        QVERIFY(bench.edits.pendingCount() > 0);
        bench.typeInto("labBandwidth", QString());
        QCOMPARE(bench.edits.pendingCount(), 0);
        QVERIFY(told->text().contains(QStringLiteral("dropped")));

        // What the user has edited by hand since is theirs.
        bench.typeInto("labBandwidth", QStringLiteral("3000"));
        bench.button("labPreview")->click();
        QVERIFY(bench.type("I_Q_KP", QStringLiteral("77")));
        bench.typeInto("labBandwidth", QStringLiteral("2000"));
        QCOMPARE(wantedOf(bench, "I_Q_KP"), 77);
        QCOMPARE(bench.edits.pendingCount(), 1); // and the rest is no plan that is shown
        QVERIFY2(told->text().contains(QStringLiteral("by hand"))
                && told->text().contains(QStringLiteral("I_Q_KP")),
            qPrintable(told->text())); // for the table shows another number
        QVERIFY(bench.type("I_Q_KP", QStringLiteral("78"))); // and goes on to
        QVERIFY(told->text().contains(QStringLiteral("by hand")));
        bench.edits.revert();
        QCOMPARE(told->text(), QString());
    }

    void whatWaitsGoesWithTheBoardThatItIsFor()
    {
        GainBench bench;
        typeMotor(bench, "0.35", "0.6", "0.6");
        bench.typeInto("labBandwidth", QStringLiteral("1000"));
        bench.button("labPreview")->click();
        const int waits = bench.edits.pendingCount();
        QVERIFY(waits > 0);
        bench.model.togglePinned(bench.id("I_Q_KP")); // which is no other board
        QCOMPARE(bench.edits.pendingCount(), waits);
        QCOMPARE(*bench.field("labBandwidth")->value(), 1000.0);
        bench.model.setCatalog(bench.model.catalog(), 1); // found anew: nothing is known of it
        QCOMPARE(bench.edits.pendingCount(), 0);
        auto *told = bench.form.findChild<QLabel *>(QStringLiteral("labTold"));
        QVERIFY(told->text().contains(QStringLiteral("dropped")));
    }

    void undoAfterApplyIsThatOfTheWrite()
    {
        GainBench bench;
        const widgets::ShortcutGuard guard; // as in the window
        bench.form.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&bench.form));
        QAction undo;
        undo.setShortcut(QKeySequence::Undo);
        int undone = 0;
        connect(&undo, &QAction::triggered, this, [&] { ++undone; });
        bench.form.addAction(&undo);
        typeMotor(bench, "0.35", "0.6", "0.6"); // fields with texts of their own to undo
        bench.typeInto("labBandwidth", QStringLiteral("2200"));
        bench.button("labPreview")->click();
        bench.button("applyEdits")->setFocus();
        QVERIFY(bench.button("applyEdits")->hasFocus());
        bench.button("applyEdits")->click();
        QVERIFY(bench.settle());
        QVERIFY(!bench.button("applyEdits")->isEnabled());
        QWidget *focused = QApplication::focusWidget();
        QVERIFY(focused);
        QVERIFY2(qobject_cast<QLineEdit *>(focused) == nullptr, qPrintable(focused->objectName()));
        QTest::keySequence(focused, QKeySequence::Undo);
        QCOMPARE(undone, 1);
        // A field that was not typed into has nothing to undo.
        bench.field("labPolePairs")->setFocus();
        QTest::keySequence(bench.field("labPolePairs"), QKeySequence::Undo);
        QCOMPARE(undone, 2);
        bench.field("labInertia")->setFocus(); // which the board does not tell
        QTest::keySequence(bench.field("labInertia"), QKeySequence::Undo);
        QCOMPARE(undone, 3);
        QVERIFY(bench.field("labInertia")->text().isEmpty());
        bench.typeInto("labPolePairs", QStringLiteral("5"));
        QTest::keySequence(bench.field("labPolePairs"), QKeySequence::Undo);
        QCOMPARE(undone, 3);
    }

    void theMotorComesFromTheBoard()
    {
        GainBench bench;
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.35"));
        QCOMPARE(bench.field("labLq")->text(), QStringLiteral("0.6"));
        QCOMPARE(bench.field("labPolePairs")->text(), QStringLiteral("4"));
        QCOMPARE(bench.field("labFlux")->text(), QStringLiteral("6.5"));
        QCOMPARE(bench.field("labBandwidth")->text(), QStringLiteral("1500")); // what it has
        QCOMPARE(bench.field("labDelay")->text(), QStringLiteral("2"));
        QVERIFY(bench.field("labInertia")->text().isEmpty());
        QVERIFY(textOf(bench, "labFindings").contains(QStringLiteral("inertia")));
        QVERIFY(textOf(bench, "gainBoard").contains(QStringLiteral("544.5")));
        // What is typed stays until the board's numbers are asked for again.
        bench.typeInto("labRs", QStringLiteral("0.5"));
        bench.look();
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.5"));
        bench.button("labFromBoard")->click();
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.35"));
    }

    void whatWasMeasuredGoesBeforeTheBoardsAndNotBeforeWhatIsTyped()
    {
        GainBench bench;
        bench.typeInto("labLq", QStringLiteral("0.7"));
        widgets::MeasuredMotor found;
        found.rs_ohm = {0.42, 0.408, 0.432};
        found.lq_h = {0.65e-3, 0.638e-3, 0.662e-3};
        found.ld_h = {0.55e-3, 0.538e-3, 0.562e-3};
        found.flux_wb = {7e-3, std::nullopt, std::nullopt};
        found.inertia_kgm2 = {2.4e-5, 2.388e-5, 2.412e-5};
        bench.form.setMeasured(found);
        QCOMPARE(bench.field("labRs")->value(), std::optional(0.42));
        QCOMPARE(bench.field("labLq")->text(), QStringLiteral("0.7"));
        QCOMPARE(bench.field("labLd")->text(), QStringLiteral("0.55"));
        QCOMPARE(bench.field("labFlux")->text(), QStringLiteral("7"));
        QVERIFY(std::abs(*bench.field("labKe")->value() - 3.591) < 0.01); // 4 pole pairs
        QCOMPARE(bench.field("labInertia")->text(), QStringLiteral("240"));
        const auto told = [&] {
            return textOf(bench, "labFindings").replace(QChar(0x202f), QLatin1Char(' '));
        };
        QVERIFY2(told().contains(QStringLiteral("Measured, with 95 %: Rs from 408 m\u03a9 to 432 "
                                                "m\u03a9; Ld from 538 \u00b5H to 562 \u00b5H; "
                                                "Inertia from 238.8 ")),
            qPrintable(told()));
        QVERIFY2(told().contains(QStringLiteral("Measured, without an interval: Flux 7 mWb.")),
            qPrintable(told()));
        bench.look(); // which reads the board's again
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.42"));

        bench.button("labFromBoard")->click();
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.35"));
        QCOMPARE(bench.field("labLq")->text(), QStringLiteral("0.6"));
        bench.form.setMeasured(found); // nothing new was measured
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.35"));
        found.rs_ohm = {0.43, 0.42, 0.44};
        bench.form.setMeasured(found);
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.43"));
        bench.form.setMeasured({}); // another motor
        QCOMPARE(bench.field("labRs")->text(), QStringLiteral("0.35"));
        QVERIFY(bench.field("labInertia")->text().isEmpty());
        QVERIFY(!told().contains(QStringLiteral("Measured")));
    }

    /// Who types pole pairs has not typed a flux: the measured one is taken, and told, before it and behind it.
    void pairsOfPolesThatAreTypedLeaveTheFluxWhoseItIs()
    {
        GainBench bench;
        bench.typeInto("labPolePairs", QStringLiteral("8"));
        QCOMPARE(bench.field("labFlux")->text(), QStringLiteral("6.5")); // the board's
        const double ke = motor::keOfFlux_vrmsPerKrpm(6.5e-3, 8.0);
        QVERIFY(std::abs(*bench.field("labKe")->value() - ke) < 1e-3);
        widgets::MeasuredMotor found;
        found.flux_wb = {7e-3, std::nullopt, std::nullopt};
        bench.form.setMeasured(found);
        const auto isMeasured = [&](double polePairs) {
            const double wanted = motor::keOfFlux_vrmsPerKrpm(7e-3, polePairs);
            return bench.field("labFlux")->text() == QLatin1String("7")
                && std::abs(bench.field("labKe")->value().value_or(0.0) - wanted) < 1e-9
                && textOf(bench, "labFindings").contains(QLatin1String("Flux 7"));
        };
        QVERIFY(isMeasured(8.0));
        bench.typeInto("labPolePairs", QStringLiteral("5"));
        QVERIFY(isMeasured(5.0));
        bench.look(); // which reads the board's 4 again
        QVERIFY(isMeasured(5.0));
        bench.typeInto("labFlux", QStringLiteral("6"));
        QVERIFY(!textOf(bench, "labFindings").contains(QLatin1String("Flux 7")));
    }

    void aTypedInertiaOfThisNameStaysBeforeAMeasuredOne()
    {
        const QString motor = [] {
            GainBench bench;
            QSignalSpy spy(&bench.form, &widgets::GainsForm::inertiaRemembered);
            bench.typeInto("labInertia", QStringLiteral("300"));
            return spy.isEmpty() ? QString() : spy.first().first().toString();
        }();
        QVERIFY(!motor.isEmpty());
        GainBench bench({}, {{motor, 3e-5}});
        widgets::MeasuredMotor found;
        found.inertia_kgm2 = {2.4e-5, 2.39e-5, 2.41e-5};
        bench.form.setMeasured(found);
        QCOMPARE(bench.field("labInertia")->text(), QStringLiteral("300"));
        QVERIFY(!textOf(bench, "labFindings").contains(QStringLiteral("Measured")));
    }

    void fluxAndKeAreTheSameMagnets()
    {
        GainBench bench;
        bench.typeInto("labKe", QStringLiteral("6.67"));
        QVERIFY(std::abs(*bench.field("labFlux")->value() - 13.0) < 0.01);
        bench.typeInto("labPolePairs", QStringLiteral("8"));
        QVERIFY(std::abs(*bench.field("labFlux")->value() - 6.5) < 0.01);
        bench.typeInto("labFlux", QStringLiteral("6.5"));
        QVERIFY(std::abs(*bench.field("labKe")->value() - 6.67) < 0.01);
    }

    void aPreviewIsOneStepThatCanBeTakenBack()
    {
        GainBench bench;
        const auto before = bench.readAll();
        bench.typeInto("labInertia", QStringLiteral("500"));
        bench.typeInto("labBandwidth", QStringLiteral("1000"));
        const std::size_t requests =
            support::count(bench.link.requests, mcp::CommandId::SetRegister);
        bench.form.findChild<QSlider *>(QStringLiteral("labDampingSlider"))->setValue(700);
        bench.button("labPreview")->click();
        bench.link.runFor(300ms);
        QCOMPARE(support::count(bench.link.requests, mcp::CommandId::SetRegister), requests);
        QVERIFY(bench.readAll() == before); // nothing is sent by sliders or previews
        QCOMPARE(bench.edits.pendingCount(), 6);
        QVERIFY(textOf(bench, "labTold").contains(QLatin1Char('6')));
        QVERIFY(bench.model.editState(bench.id("SPEED_KI")) == RegisterModel::EditState::Pending);
        QVERIFY(bench.apply());
        QCOMPARE(bench.edits.steps().count(), 1);
        QVERIFY(bench.readAll() != before);
        bench.edits.undo();
        QVERIFY(bench.settle());
        QVERIFY(bench.readAll() == before);
    }

    void aPreviewOfTheSpeedLoopAloneIsWholeToo()
    {
        // Nothing but the inertia is typed: the bandwidth goes on following the board while the edits are made.
        GainBench bench;
        bench.typeInto("labInertia", QStringLiteral("250"));
        const motor::GainPlan plan = bench.lab()->plan();
        bench.button("labPreview")->click();
        for (const motor::PlannedGain &gain : plan.gains) {
            const std::string name = widgets::gainRegister(gain.id);
            QCOMPARE(wantedOf(bench, name.c_str()), gain.quantised.gain.numerator);
            QCOMPARE(wantedOf(bench, (name + "_DIV").c_str()), gain.quantised.gain.exponent);
        }
        QVERIFY(bench.edits.pendingCount() >= 2);
    }

    void numeratorAndDivisorGoTogether()
    {
        GainBench bench;
        QVERIFY(bench.type("I_Q_KP_DIV", QStringLiteral("15"))); // 4.5 does not fit that
        QVERIFY(bench.apply());
        bench.look();
        bench.typeInto("labBandwidth", QStringLiteral("1500"));
        bench.button("labPreview")->click();
        QCOMPARE(wantedOf(bench, "I_Q_KP"), 18486);
        QCOMPARE(wantedOf(bench, "I_Q_KP_DIV"), 12);
        QCOMPARE(bench.model.pending().size(), 2U);
        QVERIFY(bench.apply());
        QVERIFY(bench.held("I_Q_KP") == Value(std::int64_t{18486}));
        QVERIFY(bench.held("I_Q_KP_DIV") == Value(std::int64_t{12}));
    }

    void otherEditsAreNamed()
    {
        GainBench bench;
        QVERIFY(bench.type("SPEED_REF", QStringLiteral("900")));
        QVERIFY(bench.type("I_Q_KP", QStringLiteral("5"))); // the lab's own: replaced
        bench.typeInto("labBandwidth", QStringLiteral("1000"));
        bench.button("labPreview")->click();
        QVERIFY(textOf(bench, "labTold").contains(QStringLiteral("SPEED_REF")));
        QVERIFY(!textOf(bench, "labTold").contains(QStringLiteral("I_Q_KP")));
        QVERIFY(wantedOf(bench, "I_Q_KP") > 1000);
        // The board's own gains are no edits.
        bench.edits.revert();
        bench.typeInto("labBandwidth", QStringLiteral("1500"));
        bench.button("labPreview")->click();
        QCOMPARE(bench.edits.pendingCount(), 0);
        QVERIFY(textOf(bench, "labTold").contains(QStringLiteral("already")));
    }

    void whatMustNotBeWrittenCannotBePreviewed_data()
    {
        QTest::addColumn<QString>("field");
        QTest::addColumn<QString>("text");
        QTest::newRow("beyond the control rate") << "labBandwidth"
                                                 << "9700";
        QTest::newRow("no bandwidth") << "labBandwidth"
                                      << "";
        QTest::newRow("an exponent") << "labBandwidth"
                                     << "1e3";
        QTest::newRow("a group mark") << "labBandwidth"
                                      << "1.500,0";
        QTest::newRow("words") << "labBandwidth"
                               << "nan";
        QTest::newRow("negative") << "labBandwidth"
                                  << "-1500";
        QTest::newRow("hertz, words") << "labBandwidthHz"
                                      << "fast";
        QTest::newRow("no resistance") << "labRs"
                                       << "";
        QTest::newRow("resistance 0") << "labRs"
                                      << "0";
        QTest::newRow("huge inductance") << "labLq"
                                         << "9999";
        QTest::newRow("a bad inertia") << "labInertia"
                                       << "1e9";
        QTest::newRow("rings for ever") << "labDamping"
                                        << "1";
        QTest::newRow("a bad delay") << "labDelay"
                                     << "soon";
    }
    void whatMustNotBeWrittenCannotBePreviewed()
    {
        QFETCH(QString, field);
        QFETCH(QString, text);
        for (const char *locale : {"C", "de_DE", "tr_TR"}) {
            QLocale::setDefault(QLocale(QLatin1String(locale)));
            GainBench bench;
            QVERIFY(bench.button("labPreview")->isEnabled());
            bench.typeInto(field.toLatin1().constData(), text);
            QVERIFY2(!bench.button("labPreview")->isEnabled(), locale);
            QVERIFY(!bench.button("labPreview")->toolTip().isEmpty());
            bench.button("labPreview")->click();
            QCOMPARE(bench.edits.pendingCount(), 0);
        }
    }

    void noRandomTypingBecomesAGainThatIsNotFinite()
    {
        const QString letters = QStringLiteral("0123456789.,-+eEnaif x%");
        for (const char *locale : {"C", "de_DE", "tr_TR"}) {
            QLocale::setDefault(QLocale(QLatin1String(locale)));
            GainBench bench;
            support::Random random(11);
            for (int i = 0; i < 400; ++i) {
                const char *names[] = {"labRs", "labLq", "labLd", "labFlux", "labKe",
                    "labPolePairs", "labInertia", "labDelay", "labBandwidth", "labBandwidthHz",
                    "labDamping"};
                widgets::NumberEdit *field = bench.field(names[random.below(std::size(names))]);
                QString text;
                for (std::uint64_t n = random.below(6); n > 0; --n)
                    text += letters[qsizetype(random.below(std::uint64_t(letters.size())))];
                field->setText(text);
                Q_EMIT field->valueEdited();
                bench.button("labPreview")->click();
                for (const drive::RegisterWrite &write : bench.model.pending()) {
                    const auto rules = bench.model.rulesOf(write.id);
                    QVERIFY(rules->limits.holds(double(std::get<std::int64_t>(write.value))));
                }
            }
            QCOMPARE(bench.writes.size(), 0U);
        }
    }

    void whatTheBoardTellsTakesNoSelectionAway()
    {
        QWidget window;
        widgets::NumberEdit field("any", QStringLiteral("Any"), {}, 0.1, 1000.0, &window);
        field.setValue(5.0);
        field.setFocus();
        field.selectAll();
        field.setValue(7.5);
        QCOMPARE(field.selectedText(), QStringLiteral("7.5"));
        QTest::keyClick(&field, Qt::Key_Up);
        QTest::keyClicks(&field, QStringLiteral("12"));
        QCOMPARE(field.value(), std::optional(12.0));
    }

    void sliderAndFieldsSayTheSame()
    {
        GainBench bench;
        auto *slider = bench.form.findChild<QSlider *>(QStringLiteral("labBandwidthSlider"));
        for (const int position : {0, 100, 333, 500, 999, 1000}) {
            slider->setValue(position);
            const double radps = *bench.field("labBandwidth")->value();
            QVERIFY(std::abs(*bench.field("labBandwidthHz")->value() * 2 * M_PI - radps) < 1e-6);
            QVERIFY(radps >= 49.0 && radps <= 9600.0);
            QCOMPARE(slider->value(), position); // not moved by its own echo
            QVERIFY(!slider->accessibleDescription().isEmpty());
        }
        bench.typeInto("labBandwidthHz", QStringLiteral("100"));
        QVERIFY(std::abs(*bench.field("labBandwidth")->value() - 628.3) < 0.1);
        QVERIFY(std::abs(bench.lab()->plan().current->ruleBandwidth_radps - 628.3) < 1.0);
        // The wheel passes over what has no focus.
        bench.field("labRs")->setFocus();
        const int before = slider->value();
        QWheelEvent wheel({5, 5}, slider->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(slider, &wheel);
        QCOMPARE(slider->value(), before);
        QWheelEvent over({5, 5}, slider->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
            Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(bench.field("labLq"), &over);
        QCOMPARE(bench.field("labLq")->text(), QStringLiteral("0.6"));
    }

    void theSpeedLoopCanBeLeftOut()
    {
        GainBench bench;
        bench.typeInto("labInertia", QStringLiteral("500"));
        QCOMPARE(bench.lab()->plan().gains.size(), 6U);
        QVERIFY(textOf(bench, "labSpeedText").contains(QStringLiteral("17 %")));
        bench.form.findChild<QCheckBox *>(QStringLiteral("labSpeed"))->click();
        QCOMPARE(bench.lab()->plan().gains.size(), 4U);
        QVERIFY(textOf(bench, "labFindings").isEmpty());
    }

    void theInertiaIsRememberedForTheMotor()
    {
        QString name;
        double remembered = 0.0;
        {
            GainBench bench;
            QSignalSpy spy(&bench.form, &widgets::GainsForm::inertiaRemembered);
            bench.typeInto("labInertia", QStringLiteral("500"));
            name = spy.last().at(0).toString();
            remembered = spy.last().at(1).toDouble();
        }
        QVERIFY(!name.isEmpty());
        QCOMPARE(remembered, 5e-5);
        GainBench again({}, {{name, remembered}});
        QCOMPARE(again.field("labInertia")->text(), QStringLiteral("500"));
        GainBench other({}, {{QStringLiteral("Another motor"), remembered}});
        QVERIFY(other.field("labInertia")->text().isEmpty());
        other.form.setInertias({{name, 2.0 * remembered}}); // typed in another form
        QCOMPARE(other.field("labInertia")->text(), QStringLiteral("1000"));
    }

    // The regulators' page.

    void gainsAreShownInUnits()
    {
        GainBench bench;
        bench.pages()->setCurrentIndex(0);
        bench.look();
        QVERIFY(textOf(bench, "physical_I_Q_KP").startsWith(QStringLiteral("= 1.039")));
        QVERIFY(textOf(bench, "physical_I_Q_KP").endsWith(QStringLiteral("V/A")));
        QVERIFY(textOf(bench, "physical_SPEED_KP").endsWith(QStringLiteral("A/(rad/s)")));
        QVERIFY(textOf(bench, "physical_STOPLL_KI").contains(QStringLiteral("rad/s")));
        QVERIFY(textOf(bench, "physical_STOPLL_C1").contains(QStringLiteral("-24128")));
        // They follow what is typed before it is written.
        QVERIFY(bench.type("I_Q_KP", QStringLiteral("9242")));
        QCoreApplication::processEvents();
        QVERIFY(textOf(bench, "physical_I_Q_KP").startsWith(QStringLiteral("= 2.07")));
        QVERIFY(bench.type("I_Q_KP_DIV", QStringLiteral("11")));
        QCoreApplication::processEvents();
        QVERIFY(textOf(bench, "physical_I_Q_KP").startsWith(QStringLiteral("= 1.039")));
        // What this build does not have is not there.
        auto *weakening = bench.form.findChild<QWidget *>(QStringLiteral("raw_FLUXWK_KP"));
        QVERIFY(!weakening->isVisibleTo(&bench.form));
    }

    void everyBoardHasItsRegulators_data()
    {
        QTest::addColumn<QString>("profile");
        QTest::addColumn<QString>("motor");
        QTest::addColumn<QString>("shown");
        QTest::addColumn<bool>("lab");
        QTest::newRow("encoder") << "mcsdk-6.4"
                                 << "servo24"
                                 << "POSITION_KP" << true;
        QTest::newRow("6.1") << "mcsdk-6.1"
                             << "pm24"
                             << "I_Q_KP" << true;
        QTest::newRow("HSO") << "hso"
                             << "pm24"
                             << "FOC_KP_IDQ" << false;
        QTest::newRow("six-step") << "six-step"
                                  << "pm24"
                                  << "SPEED_KP" << false;
    }
    void everyBoardHasItsRegulators()
    {
        QFETCH(QString, profile);
        QFETCH(QString, motor);
        QFETCH(QString, shown);
        QFETCH(bool, lab);
        simulation::BoardOptions options;
        options.profile = profile.toStdString();
        options.motor = motor.toStdString();
        for (const auto &option : simulation::buildOptions())
            if (option.name == "position"
                && option.fits(simulation::buildFor(options.profile, options.motor).family))
                options.with.push_back(&option);
        GainBench bench(options);
        QCOMPARE(bench.button("labPreview")->isEnabled(), lab);
        QVERIFY(lab || !bench.button("labPreview")->toolTip().isEmpty());
        bench.pages()->setCurrentIndex(0);
        bench.look();
        const auto *physical = bench.form.findChild<QLabel *>(QStringLiteral("physical_") + shown);
        QVERIFY(physical->isVisibleTo(&bench.form));
        QVERIFY(!physical->text().isEmpty());
        QVERIFY(lab || !physical->toolTip().isEmpty()); // why there is no unit
    }

    // The keyboard.

    void everythingCanBeDoneWithTheKeyboard()
    {
        GainBench bench;
        bench.form.activateWindow();
        bench.form.focusFirst();
        std::set<QWidget *> reached;
        for (int i = 0; i < 60; ++i) {
            reached.insert(QApplication::focusWidget());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        for (const char *name : {"labRs", "labInertia", "labBandwidthSlider", "labBandwidth",
                 "labBandwidthHz", "labSpeed", "labDampingSlider", "labDamping", "labDelay",
                 "labGains", "labFromBoard", "labPreview"})
            QVERIFY2(reached.contains(bench.form.findChild<QWidget *>(QLatin1String(name))), name);

        // From the slider to the board without a mouse.
        auto *slider = bench.form.findChild<QSlider *>(QStringLiteral("labBandwidthSlider"));
        slider->setFocus();
        QTest::keyClick(slider, Qt::Key_PageDown);
        const double asked = *bench.field("labBandwidth")->value();
        QVERIFY(asked < 1400.0);
        bench.field("labBandwidth")->setFocus();
        QTest::keyClick(bench.field("labBandwidth"), Qt::Key_PageUp);
        QVERIFY(*bench.field("labBandwidth")->value() > 1.15 * asked);
        QTest::keyClick(bench.button("labPreview"), Qt::Key_Space);
        QCOMPARE(bench.edits.pendingCount(), 4);
        QTest::keyClick(
            bench.form.findChild<QPushButton *>(QStringLiteral("applyEdits")), Qt::Key_Space);
        QVERIFY(bench.settle());
        QCOMPARE(bench.edits.pendingCount(), 0);
        QCOMPARE(bench.edits.steps().count(), 1);

        // The other page.
        QTest::keyClick(&bench.form, Qt::Key_R, Qt::AltModifier);
        QCOMPARE(bench.pages()->currentIndex(), 0);
        bench.form.focusFirst();
        reached.clear();
        for (int i = 0; i < 60; ++i) {
            reached.insert(QApplication::focusWidget()->parentWidget());
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        }
        for (const char *name : {"raw_I_Q_KP", "raw_I_Q_KP_DIV", "raw_SPEED_KI", "field_STOPLL_C2"})
            QVERIFY2(reached.contains(bench.form.findChild<QWidget *>(QLatin1String(name))), name);
    }

    void sentencesAreAsHighAsTheyNeedToBe()
    {
        QWidget page;
        auto &label = *new widgets::GainLabel("label", &page);
        page.show(); // a hidden widget is not told of its size
        label.resize(100, 20);
        label.say(QStringLiteral("A sentence that is wrapped into several lines at such a width"));
        const int narrow = label.minimumHeight();
        label.resize(2000, label.height());
        QVERIFY2(2 * label.minimumHeight() < narrow,
            qPrintable(QStringLiteral("%1 of %2").arg(label.minimumHeight()).arg(narrow)));
        label.say({});
        QCOMPARE(label.minimumHeight(), 0);
    }

    void aPageThatIsNotSeenMakesTheOtherNoHigher()
    {
        GainBench bench; // its board has told what the lab needs for its sentences
        widgets::GainsForm form(bench.device, bench.model, bench.edits, bench.panel.actions().apply,
            bench.panel.actions().revert, {});
        form.resize(1000, 320);
        form.refresh(bench.ms());
        form.show();
        QVERIFY(!form.findChild<widgets::GainLabel *>(QStringLiteral("labSpeedText"))->isVisible());
        int needed = form.minimumSizeHint().height();
        if (form.layout()->hasHeightForWidth()) // what a scroll area looks at
            needed = std::max(needed, form.heightForWidth(1000));
        QVERIFY2(needed <= 320, qPrintable(QString::number(needed)));
    }

    void theWindowOpensItByItsKey()
    {
        facts::WindowRig rig;
        QVERIFY(QTest::qWaitForWindowExposed(&rig.window));
        auto *form = rig.find<QWidget>("gainsForm");
        QVERIFY(!form->isVisible());
        QTest::keyClick(&rig.window, Qt::Key_1, Qt::ControlModifier);
        QTRY_VERIFY(form->isVisible());
        QVERIFY(rig.workbench.watchList().registers().empty()); // no board, nothing to poll
    }
};

QTEST_MAIN(TestGainsForm)
#include "tst_gains_form.moc"
