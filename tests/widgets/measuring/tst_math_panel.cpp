// Math channels in the real window: a formula is written, checked, computed, drawn, triggered on, exported and kept.
// What the functions compute is core's own business.
#include "support/scope_window.h"
#include "widgets/measuring/math_channels.h"
#include "widgets/measuring/math_table.h"
#include "widgets/measuring/ready_formulas.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>
#include <cmath>

using widgets::MathChannels;
using widgets::MathTable;

class TestMathPanel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        start({});
    }
    void cleanup() { m_rig.reset(); }

    void aFormulaBecomesAChannelOfTheScope();
    void itGrowsWithTheSamplesAndGapsStayGaps();
    void whatIsWrongIsSaidWhereItIs();
    void aSignalThatIsLackingIsRecordedWithOneClick();
    void aChangedFormulaIsComputedAnew();
    void oneMayUseTheOnesBeforeItButNotItself();
    void aHiddenOneIsComputedStill();
    void itHasAChipLikeARecordedOne();
    void theTriggerTakesIt();
    void clearingTheRecordingBeginsItAnew();
    void aNewStreamLeavesItOnTheScope();
    void aSignalOfAnotherUnitDoesNotMoveIn();
    void itIsKeptAndWaitsForItsSignals();
    void aRemovedOneIsGoneEverywhere();
    void readyFormulasAreFilledIn();
    void readyFormulasAreOfOneMotor();
    void aLongRecordingIsComputedInTurns();
    void manyAreComputedInTurnsTogether();
    void theTableIsAModel();

private:
    void start(const QList<widgets::MathFormula> &formulas)
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.workspace.formulas = formulas;
        m_rig = std::make_unique<facts::ScopeWindow>(settings);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(1000, ramp);
        QTest::keyClick(&m_rig->window, Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    }
    /// I_A is its tick in A, I_B twice that.
    static int ramp(int, int tick) { return tick; }
    void write(const QString &name, const QString &formula)
    {
        m_rig->find<QLineEdit>("mathName")->setText(name);
        auto *field = m_rig->find<QLineEdit>("mathFormula");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, formula);
    }
    void add(const char *name, const char *formula)
    {
        write(QLatin1String(name), QLatin1String(formula));
        QTest::keyClick(m_rig->find<QLineEdit>("mathFormula"), Qt::Key_Return);
        settle();
    }
    /// Until everything there is has been computed.
    void settle()
    {
        QCoreApplication::processEvents();
        for (int i = 0; i < 5; ++i)
            m_rig->draw();
    }
    MathChannels &math() { return m_rig->workbench.math(); }
    widgets::ScopeView &view() { return m_rig->scope(); }
    capture::Capture &capture() { return m_rig->workbench.capture(); }
    QTreeView *list() { return m_rig->find<QTreeView>("mathList"); }
    QString verdict() { return m_rig->find<QLabel>("mathVerdict")->text(); }
    QString cell(int row, int column)
    {
        return list()->model()->index(row, column).data().toString();
    }
    capture::ChannelId channel(int row) { return math().entries()[std::size_t(row)].channel; }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

void TestMathPanel::aFormulaBecomesAChannelOfTheScope()
{
    write(QStringLiteral("Sum"), QStringLiteral("I_A + I_B"));
    QVERIFY2(verdict().contains(QStringLiteral("unit A")), qPrintable(verdict()));
    QTest::mouseClick(m_rig->find<QWidget>("applyMath"), Qt::LeftButton);
    const auto info = capture().info(channel(0));
    QVERIFY(info);
    QCOMPARE(info->name, std::string("Sum"));
    QCOMPARE(info->unit, std::string("A"));
    QCOMPARE(capture().size(channel(0)), std::uint64_t(1000));
    QCOMPARE(capture().valueAt(channel(0), 0.5), std::optional(1500.0));
    QCOMPARE(view().plotOf(channel(0)), view().plotOf(m_rig->id(facts::kCurrentA)));
    QVERIFY(view().colorOf(channel(0)) != view().colorOf(m_rig->id(facts::kCurrentA)));
    QCOMPARE(cell(0, MathTable::NameColumn), QStringLiteral("Sum"));
    QVERIFY2(cell(0, MathTable::ValueColumn).contains(QStringLiteral("2997")),
        qPrintable(cell(0, MathTable::ValueColumn)));
    auto *traces = m_rig->find<QComboBox>("measureTrace"); // and the other tools have it
    QVERIFY(traces->findData(channel(0)) >= 0);
}

void TestMathPanel::itGrowsWithTheSamplesAndGapsStayGaps()
{
    add("D", "derivative(I_A)");
    QCOMPARE(capture().info(channel(0))->unit, std::string("A/s"));
    QVERIFY(view().plotOf(channel(0)) != view().plotOf(m_rig->id(facts::kCurrentA)));
    QCOMPARE(capture().size(channel(0)), std::uint64_t(999)); // none at the first sample
    m_rig->lose(100);
    m_rig->record(500, ramp);
    QCOMPARE(capture().size(channel(0)), std::uint64_t(999 + 499));
    QVERIFY(!capture().valueAt(channel(0), 1.05));
    QVERIFY(!capture().valueAt(channel(0), 1.1)); // nothing to subtract from
    const double after = capture().valueAt(channel(0), 1.2).value_or(0.0);
    QVERIFY2(std::abs(after - 1000.0) < 1e-6, qPrintable(QString::number(after)));
}

void TestMathPanel::whatIsWrongIsSaidWhereItIs()
{
    const auto refused = [this] { return !m_rig->find<QWidget>("applyMath")->isEnabled(); };
    write(QStringLiteral("X"), QStringLiteral("I_A + nothing"));
    QVERIFY2(verdict().contains(QStringLiteral("character 7")), qPrintable(verdict()));
    QVERIFY2(verdict().contains(QStringLiteral("nothing")), qPrintable(verdict()));
    QVERIFY(refused());
    write(QStringLiteral("X"), QStringLiteral("2*NO_D*I_A+I_B"));
    QVERIFY2(verdict().endsWith(QStringLiteral("called NO_D.")), qPrintable(verdict()));
    const auto *record = m_rig->find<QPushButton>("recordForMath");
    QVERIFY(record->isVisible() && !record->isEnabled()); // no board has that
    QTest::keyClick(m_rig->find<QLineEdit>("mathFormula"), Qt::Key_Return);
    QCOMPARE(list()->model()->rowCount(), 0);
    write(QStringLiteral("X"), QStringLiteral("min(I_A, (I_B)"));
    QVERIFY2(verdict().contains(QStringLiteral("character 4: What opens here is not closed")),
        qPrintable(verdict()));
    write(QStringLiteral("X"), QStringLiteral("lowpass(I_A, I_B)"));
    QVERIFY2(verdict().contains(QStringLiteral("not a signal")), qPrintable(verdict()));
    write(QStringLiteral("X"), QStringLiteral("1 + 1"));
    QVERIFY2(verdict().contains(QStringLiteral("no signal in it")), qPrintable(verdict()));
    QVERIFY(refused());
    write(QStringLiteral("I_B"), QStringLiteral("I_A"));
    QVERIFY2(verdict().contains(QStringLiteral("taken")), qPrintable(verdict()));
    QVERIFY(refused());
    write(QStringLiteral("2x"), QStringLiteral("I_A"));
    QVERIFY(refused());
    write(QStringLiteral("X"), QStringLiteral("I_A / I_B + 1"));
    QVERIFY2(verdict().contains(QStringLiteral("plain number")), qPrintable(verdict()));
    QVERIFY(!refused());
}

void TestMathPanel::aSignalThatIsLackingIsRecordedWithOneClick()
{
    auto *record = m_rig->find<QPushButton>("recordForMath");
    write(QStringLiteral("X"), QStringLiteral("I_A * BUS_VOLTAGE"));
    QVERIFY2(record->isEnabled(), qPrintable(verdict()));
    QVERIFY(record->toolTip().contains(QStringLiteral("BUS_VOLTAGE")));
    const auto &plan = m_rig->workbench.signalPlan();
    QVERIFY(!plan.find(facts::kVoltage));
    QTest::mouseClick(record, Qt::LeftButton);
    QVERIFY(plan.find(facts::kVoltage));
    drive::Reading volts = facts::reading(facts::kVoltage, std::int64_t{24});
    volts.at = TimePoint(std::chrono::milliseconds(900));
    const auto polled = [&plan](catalog::RegisterId id) {
        const auto &all = plan.planned().polled;
        return std::find(all.begin(), all.end(), id) != all.end();
    };
    QTRY_VERIFY(polled(facts::kVoltage));
    facts::feed(m_rig->device(), {drive::RegistersRead{{volts}}});
    QTRY_VERIFY2(m_rig->find<QWidget>("applyMath")->isEnabled(), qPrintable(verdict()));
    QVERIFY(!record->isEnabled());
}

void TestMathPanel::aChangedFormulaIsComputedAnew()
{
    add("M", "I_A");
    add("Of_M", "M + 1 * M");
    const QColor color = view().colorOf(channel(0));
    QCOMPARE(capture().valueAt(channel(1), 0.5), std::optional(1000.0));
    add("M", "2 * I_A"); // the same unit: the same place
    QCOMPARE(list()->model()->rowCount(), 2);
    QCOMPARE(capture().valueAt(channel(0), 0.5), std::optional(1000.0));
    QCOMPARE(view().colorOf(channel(0)), color);
    QCOMPARE(capture().valueAt(channel(1), 0.5), std::optional(2000.0));
    QCOMPARE(int(capture().channels().size()), 4);
    add("M", "integral(I_A)"); // another one: to a plot of its own
    QVERIFY(view().plotOf(channel(0)) != view().plotOf(m_rig->id(facts::kCurrentA)));
    QCOMPARE(int(view().channels().size()), 4);
}

void TestMathPanel::oneMayUseTheOnesBeforeItButNotItself()
{
    add("First", "I_A");
    add("Second", "First * 2");
    write(QStringLiteral("First"), QStringLiteral("Second + 1"));
    QVERIFY(!m_rig->find<QWidget>("applyMath")->isEnabled());
    write(QStringLiteral("First"), QStringLiteral("First + 1"));
    QVERIFY(!m_rig->find<QWidget>("applyMath")->isEnabled());
    math().remove(QStringLiteral("First"));
    QCOMPARE(math().entries().size(), std::size_t(1));
    QCOMPARE(channel(0), 0U);
    QCOMPARE(cell(0, MathTable::ValueColumn), QStringLiteral("waits for its signals"));
}

void TestMathPanel::aHiddenOneIsComputedStill()
{
    add("M", "I_A");
    const QModelIndex name = list()->model()->index(0, MathTable::NameColumn);
    QCOMPARE(name.data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
    list()->model()->setData(name, Qt::Unchecked, Qt::CheckStateRole);
    QCOMPARE(view().plotOf(channel(0)), -1);
    m_rig->record(10, ramp);
    QCOMPARE(capture().size(channel(0)), std::uint64_t(1010));
    list()->model()->setData(name, Qt::Checked, Qt::CheckStateRole);
    QVERIFY(view().plotOf(channel(0)) >= 0);
    Q_EMIT view().removeRequested(channel(0)); // Delete in the legend
    QCOMPARE(name.data(Qt::CheckStateRole).toInt(), int(Qt::Unchecked));
    QVERIFY(channel(0) != 0);
}

void TestMathPanel::itHasAChipLikeARecordedOne()
{
    const auto chip = [this] {
        for (QWidget *one : m_rig->window.findChildren<QWidget *>(QStringLiteral("chip_Sum")))
            if (one->isVisible())
                return one;
        return static_cast<QWidget *>(nullptr);
    };
    const auto press = [&](const QString &name) {
        for (QToolButton *button : chip()->findChildren<QToolButton *>())
            if (button->accessibleName() == name)
                return button->click();
        QFAIL(qPrintable(name));
    };
    QVERIFY(!chip());
    add("Sum", "I_A + I_B");
    QVERIFY(chip());
    const QColor color = view().colorOf(channel(0));
    QCOMPARE(chip()->grab().toImage().pixelColor(11, chip()->height() / 2), color);
    m_rig->find<QDockWidget>("mathDock")->hide();
    press(QStringLiteral("How Sum is computed"));
    QVERIFY(m_rig->find<QDockWidget>("mathDock")->isVisible());
    QCOMPARE(m_rig->find<QLineEdit>("mathFormula")->text(), QStringLiteral("I_A + I_B"));
    press(QStringLiteral("Remove Sum"));
    QTRY_VERIFY(!chip());
    QCOMPARE(view().plotOf(channel(0)), -1);
    QVERIFY(channel(0) != 0); // off the picture, still computed
    math().setShown(QStringLiteral("Sum"), true);
    QVERIFY(chip());
    math().remove(QStringLiteral("Sum"));
    QVERIFY(!chip());
}

void TestMathPanel::theTriggerTakesIt()
{
    add("M", "I_A - 1500 * I_A / I_A");
    auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
    trigger->trigger().setSource(channel(0));
    widgets::TriggerSetup setup = trigger->trigger().setup();
    setup.mode = scope::Mode::Normal;
    setup.level = 0.0;
    setup.hysteresis = 1.0;
    setup.length = 0.2;
    trigger->setSetup(setup);
    for (int i = 0; i < 10; ++i)
        m_rig->record(100, ramp);
    QCOMPARE(trigger->trigger().history().records().size(), std::size_t(1));
    const double at = capture::toSeconds(trigger->trigger().history().records().front().trigger);
    QVERIFY2(std::abs(at - 1.5) < 0.0011, qPrintable(QString::number(at)));
}

void TestMathPanel::clearingTheRecordingBeginsItAnew()
{
    add("M", "I_A");
    const capture::ChannelId before = channel(0);
    const QColor color = view().colorOf(before);
    m_rig->workbench.signalPlan().clear();
    m_rig->record(100, ramp);
    QVERIFY(channel(0) != before && channel(0) != 0);
    QCOMPARE(capture().size(channel(0)), std::uint64_t(100));
    QCOMPARE(view().colorOf(channel(0)), color);
}

void TestMathPanel::aNewStreamLeavesItOnTheScope()
{
    add("M", "I_A");
    const capture::ChannelId own = channel(0);
    m_rig->stream(); // another signal was added: the board begins anew
    QCOMPARE(channel(0), own);
    QVERIFY(view().plotOf(own) >= 0);
    m_rig->record(100, ramp);
    QCOMPARE(capture().size(own), std::uint64_t(1100));
}

void TestMathPanel::aSignalOfAnotherUnitDoesNotMoveIn()
{
    add("D", "derivative(I_A)");
    add("I", "integral(I_A)");
    const int own = view().plotOf(channel(1));
    QVERIFY(own > view().plotOf(channel(0)));
    widgets::SignalSelection &selection = *m_rig->window.selection();
    selection.add(facts::kVoltage);
    QCOMPARE(selection.plan().wanted().back().plot, own + 1);
}

void TestMathPanel::itIsKeptAndWaitsForItsSignals()
{
    add("M", "2 * I_A");
    add("Hidden", "I_B");
    math().setShown(QStringLiteral("Hidden"), false);
    QList<widgets::MathFormula> kept = m_rig->window.settings().workspace.formulas;
    QCOMPARE(kept.size(), 2);
    QVERIFY(!kept[1].shown);
    kept.append({QStringLiteral("Later"), QStringLiteral("not_there * 2"), true});
    m_rig.reset();
    start(kept);
    QCOMPARE(capture().valueAt(channel(0), 0.5), std::optional(1000.0));
    QVERIFY(view().plotOf(channel(0)) >= 0);
    QCOMPARE(view().plotOf(channel(1)), -1);
    QCOMPARE(channel(2), 0U);
    QCOMPARE(m_rig->window.settings().workspace.formulas, kept); // it is not forgotten for that
}

void TestMathPanel::aRemovedOneIsGoneEverywhere()
{
    add("M", "I_A");
    add("N", "I_B");
    const capture::ChannelId first = channel(0);
    list()->setFocus();
    list()->setCurrentIndex(list()->model()->index(0, 0));
    QTest::keyClick(list(), Qt::Key_Delete);
    QVERIFY(!capture().info(first));
    QCOMPARE(view().plotOf(first), -1);
    QCOMPARE(cell(0, MathTable::NameColumn), QStringLiteral("N"));
    // The row that is chosen now.
    QTest::mouseClick(m_rig->find<QWidget>("removeMath"), Qt::LeftButton);
    QCOMPARE(list()->model()->rowCount(), 0);
    QCOMPARE(m_rig->find<QLineEdit>("mathName")->text(), QStringLiteral("M1"));
}

void TestMathPanel::readyFormulasAreFilledIn()
{
    auto *menu = m_rig->find<QMenu>("readyMathMenu");
    Q_EMIT menu->aboutToShow();
    QAction *alpha = menu->actions().first();
    QVERIFY(alpha->isEnabled());
    alpha->trigger();
    QCOMPARE(
        m_rig->find<QLineEdit>("mathFormula")->text(), QStringLiteral("clarke_alpha(I_A, I_B)"));
    QVERIFY(m_rig->find<QWidget>("applyMath")->isEnabled());
    const std::vector<scope::FormulaName> names{{"I_A", "A"}, {"I_B", "A"},
        {"MECH_ANGLE", "\u00b0"}, {"HALL_EL_ANGLE", "\u00b0"}, {"V_D (2)", "V"}};
    int empty = 0;
    for (const widgets::ReadyFormula &ready : widgets::readyFormulas(names, {}, 1)) {
        QCOMPARE(ready.text.isEmpty(), !ready.missing.isEmpty());
        empty += ready.text.isEmpty() ? 1 : 0;
        if (!ready.text.isEmpty())
            QVERIFY2(
                scope::Formula::compile(ready.text.toStdString(), names), qPrintable(ready.text));
    }
    QCOMPARE(empty, 1); // no power without voltages
    QCOMPARE(widgets::inFormula(QStringLiteral("V_D (2)")), QStringLiteral("[V_D (2)]"));
    for (const widgets::ReadyFormula &ready : widgets::readyFormulas({}, {}, 0))
        QVERIFY(ready.text.isEmpty());
}

void TestMathPanel::readyFormulasAreOfOneMotor()
{
    const std::vector<scope::FormulaName> names{{"I_A@1", "A"}, {"I_A@2", "A"}, {"I_B@2", "A"},
        {"HALL_EL_ANGLE@1", "\u00b0"}, {"HALL_EL_ANGLE@2", "\u00b0"}};
    for (const int motor : {0, 2}) { // of a file: the one that has both
        const auto all = widgets::readyFormulas(names, {}, motor);
        QCOMPARE(all[0].text, QStringLiteral("clarke_alpha([I_A@2], [I_B@2])"));
        QCOMPARE(all[2].text,
            QStringLiteral("park_d(clarke_alpha([I_A@2], [I_B@2]), "
                           "clarke_beta([I_A@2], [I_B@2]), [HALL_EL_ANGLE@2])"));
        QVERIFY(scope::Formula::compile(all[2].text.toStdString(), names));
    }
    QCOMPARE(widgets::readyFormulas(names, {}, 1)[0].text, QString());
}

void TestMathPanel::aLongRecordingIsComputedInTurns()
{
    m_rig->record(50'000, [](int, int) { return 1; });
    write(QStringLiteral("M"), QStringLiteral("I_A + I_A"));
    QTest::keyClick(m_rig->find<QLineEdit>("mathFormula"), Qt::Key_Return);
    QVERIFY(capture().size(channel(0)) < 51'000); // it does not wait for all
    QTRY_COMPARE(capture().size(channel(0)), std::uint64_t(51'000));
}

void TestMathPanel::manyAreComputedInTurnsTogether()
{
    m_rig->record(50'000, [](int, int) { return 1; });
    QList<widgets::MathFormula> formulas;
    for (int i = 0; i < widgets::kMostMathFormulas; ++i)
        formulas.append({QStringLiteral("M%1").arg(i + 1), QStringLiteral("I_A + 1"), false});
    const auto computed = [this] {
        std::uint64_t values = 0;
        for (const MathChannels::Entry &entry : math().entries())
            values += capture().size(entry.channel);
        return values;
    };
    math().setFormulas(formulas);
    // However many there are, what is computed at once is the same.
    QVERIFY(computed() > 0);
    QVERIFY(computed() <= MathChannels::kInstantsAtOnce);
    const std::uint64_t before = computed();
    math().advance();
    QVERIFY(computed() > before);
    QVERIFY(computed() - before <= MathChannels::kInstantsAtOnce);
    QTRY_COMPARE(computed(), std::uint64_t(51'000) * formulas.size());
}

void TestMathPanel::theTableIsAModel()
{
    QAbstractItemModelTester tester(
        list()->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    for (int i = 0; i < 20; ++i)
        math().set(math().freeName(), QStringLiteral("I_A"));
    QCOMPARE(qsizetype(list()->model()->rowCount()), widgets::kMostMathFormulas);
    m_rig->record(10, ramp);
    math().remove(QStringLiteral("M3"));
    QCOMPARE(qsizetype(list()->model()->rowCount()), widgets::kMostMathFormulas - 1);
}

QTEST_MAIN(TestMathPanel)
#include "tst_math_panel.moc"
