// Measurements in the real window: choosing them, what they say and draw, statistics over records. The numbers are
// core's own business; here one of each kind shows that the right samples are asked.
#include "support/scope_window.h"
#include "widgets/measuring/measure_table.h"
#include "widgets/measuring/measure_text.h"
#include "widgets/scope/overlay.h"
#include "widgets/scope/trigger/control.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QTreeView>

#include <cmath>

using scope::Quantity;
using widgets::MeasureTable;

class TestMeasurePanel : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        // I_A: a square of 10 A, 100 ms a turn. I_B: goes from 0 to 200 A at 1 s and stays.
        m_rig->record(4000, [](int signal, int tick) {
            return signal == 0 ? (tick % 100 < 50 ? 10 : -10) : (tick < 1000 ? 0 : 100);
        });
        view().setRunning(false);
        view().setVisibleRange(0.0, 4.0);
        m_rig->draw();
        QTest::keyClick(&m_rig->window, Qt::Key_9, Qt::ControlModifier);
    }
    void cleanup() { m_rig.reset(); }

    void aMeasureIsChosenAndRead();
    void timesAreToldWithTheDigitsThatTheyHave();
    void theCursorsBoundIt();
    void whatCannotBeMeasuredIsSaidInWords();
    void theChosenRowIsDrawn();
    void recordsAreCounted();
    void everyRecordOfABatchIsCounted();
    void recordsAreCountedWhileTheNextFills();
    void betweenCursorsRecordsAreCountedThereToo();
    void phaseNeedsASecondTrace();
    void longPicturesAreMeasuredElsewhere();
    void aShortPictureDoesNotWaitForALongOne();
    void longRecordsAreCountedElsewhere();
    void whatWasClearedIsNotCounted();
    void itLeavesWhileALongOneIsMeasured();
    void theTableIsAModelAndACopy();
    void whatHasNothingToActOnCannotBePressed();
    void everyQuantityHasAName();

private:
    widgets::ScopeView &view() { return m_rig->scope(); }
    QTreeView *list() { return m_rig->find<QTreeView>("measureList"); }
    void choose(const char *box, int value)
    {
        auto *combo = m_rig->find<QComboBox>(box);
        combo->setCurrentIndex(combo->findData(value));
        QVERIFY(combo->currentIndex() >= 0);
    }
    void add(catalog::RegisterId reg, Quantity quantity)
    {
        choose("measureTrace", int(m_rig->id(reg)));
        choose("measureQuantity", int(quantity));
        QTest::mouseClick(m_rig->find<QWidget>("addMeasure"), Qt::LeftButton);
    }
    QString cell(int row, int column)
    {
        return list()->model()->index(row, column).data().toString();
    }

    /// Records of so many seconds from each upward edge on.
    widgets::TriggerControl &triggerOn(double length)
    {
        auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
        widgets::TriggerSetup setup = trigger->trigger().setup();
        setup.mode = scope::Mode::Normal;
        setup.level = 0.0;
        setup.hysteresis = 1.0;
        setup.length = length;
        setup.preTrigger = 0.0;
        trigger->setSetup(setup);
        return *trigger;
    }
    static int complete(const widgets::TriggerControl &trigger)
    {
        int count = 0;
        for (const scope::Record &record : trigger.trigger().history().records())
            count += record.state == scope::Record::State::Complete ? 1 : 0;
        return count;
    }

    static constexpr int kLong = 2 * int(MeasureTable::kSamplesAtOnce);
    std::unique_ptr<facts::ScopeWindow> m_rig;
};

void TestMeasurePanel::aMeasureIsChosenAndRead()
{
    add(facts::kCurrentA, Quantity::PeakToPeak);
    QCOMPARE(cell(0, MeasureTable::SignalColumn), QStringLiteral("I_A"));
    QCOMPARE(cell(0, MeasureTable::ValueColumn), QStringLiteral("20.0\u00a0A"));
    add(facts::kCurrentA, Quantity::Frequency);
    QCOMPARE(cell(1, MeasureTable::ValueColumn), QStringLiteral("10.0000\u00a0Hz"));
    add(facts::kCurrentA, Quantity::Duty);
    QCOMPARE(cell(2, MeasureTable::ValueColumn), QStringLiteral("50.00\u00a0%"));
    add(facts::kCurrentA, Quantity::Duty); // once is enough
    QCOMPARE(list()->model()->rowCount(), 3);
    QTest::mouseClick(m_rig->find<QWidget>("removeMeasure"), Qt::LeftButton);
    QCOMPARE(list()->model()->rowCount(), 2);
    list()->setFocus();
    QTest::keyClick(list(), Qt::Key_Delete);
    QCOMPARE(list()->model()->rowCount(), 1);
}

void TestMeasurePanel::whatHasNothingToActOnCannotBePressed()
{
    const auto enabled = [this] {
        QList<bool> all;
        for (const char *name : {"removeMeasure", "clearStatistics", "copyMeasures"})
            all.append(m_rig->find<QWidget>(name)->isEnabled());
        return all;
    };
    QCOMPARE(enabled(), (QList{false, false, false}));
    add(facts::kCurrentA, Quantity::Max);
    QCOMPARE(enabled(), (QList{true, true, true}));
    list()->setCurrentIndex({});
    QCOMPARE(enabled(), (QList{false, true, true}));
    list()->setCurrentIndex(list()->model()->index(0, 0));
    QTest::mouseClick(m_rig->find<QWidget>("removeMeasure"), Qt::LeftButton);
    QCOMPARE(enabled(), (QList{false, false, false}));
}

void TestMeasurePanel::timesAreToldWithTheDigitsThatTheyHave()
{
    const auto info = m_rig->workbench.capture().info(m_rig->id(facts::kCurrentA));
    QVERIFY(info);
    const auto text = [&](double seconds) {
        return widgets::measuredText(seconds, scope::UnitKind::Seconds, *info, 0.01, QLocale::c());
    };
    QCOMPARE(text(0.0279822), QStringLiteral("27.98\u2009ms"));
    QCOMPARE(text(1.23456), QStringLiteral("1.235\u2009s"));
    QCOMPARE(text(-62.5e-6), QStringLiteral("\u221262.50\u2009\u00b5s"));
    QCOMPARE(text(0.0), QStringLiteral("0\u2009\u00b5s"));
    add(facts::kCurrentA, Quantity::Period); // what it says has room in its column
    for (int column = MeasureTable::ValueColumn; column <= MeasureTable::MaxColumn; ++column)
        QVERIFY(list()->fontMetrics().horizontalAdvance(QStringLiteral("\u22121234.567 rpm"))
            < list()->columnWidth(column));
}

void TestMeasurePanel::theCursorsBoundIt()
{
    add(facts::kCurrentA, Quantity::Max);
    auto *range = m_rig->find<QComboBox>("measureRange");
    range->setCurrentIndex(1);
    Q_EMIT range->activated(1);
    QVERIFY(view().cursors().visible()); // they have to be seen
    view().cursors().move(widgets::CursorEnd::A, 0.099); // either order
    view().cursors().move(widgets::CursorEnd::B, 0.051);
    Q_EMIT m_rig->workbench.heartbeat({});
    QCOMPARE(cell(0, MeasureTable::ValueColumn), QStringLiteral("\u221210.0\u00a0A"));
}

void TestMeasurePanel::whatCannotBeMeasuredIsSaidInWords()
{
    add(facts::kCurrentB, Quantity::Frequency);
    QCOMPARE(cell(0, MeasureTable::ValueColumn), QStringLiteral("no full period"));
    m_rig->record(1000, [](int, int tick) { return tick - 4000; });
    view().setVisibleRange(4.0, 5.0); // it still rises where it should have settled
    add(facts::kCurrentB, Quantity::Settling);
    QCOMPARE(cell(1, MeasureTable::ValueColumn), QStringLiteral("not settled"));
    view().setVisibleRange(10.0, 20.0);
    Q_EMIT m_rig->workbench.heartbeat({});
    QCOMPARE(cell(0, MeasureTable::ValueColumn), QStringLiteral("no samples"));
}

void TestMeasurePanel::theChosenRowIsDrawn()
{
    auto *overlay = m_rig->window.findChild<widgets::ScopeOverlay *>();
    add(facts::kCurrentA, Quantity::Max);
    QVERIFY(!overlay->measure().empty());
    QCOMPARE(overlay->measure().channel, m_rig->id(facts::kCurrentA));
    QCOMPARE(overlay->measure().levels.front().level, 10.0);
    QVERIFY(overlay->measure().text.contains(QStringLiteral("10.0")));
    QTest::mouseClick(m_rig->find<QWidget>("removeMeasure"), Qt::LeftButton);
    QVERIFY(overlay->measure().empty());
    add(facts::kCurrentA, Quantity::Max);
    m_rig->find<QWidget>("measureDock")->hide();
    QVERIFY(overlay->measure().empty());
}

void TestMeasurePanel::recordsAreCounted()
{
    add(facts::kCurrentA, Quantity::Mean);
    auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
    widgets::TriggerSetup setup = trigger->trigger().setup();
    setup.mode = scope::Mode::Normal;
    setup.level = 0.0;
    setup.hysteresis = 1.0;
    setup.length = 0.04;
    setup.preTrigger = 0.0;
    trigger->setSetup(setup);
    for (int i = 0; i < 10; ++i) // one record in each batch: the high half of the square
        m_rig->record(100, [](int, int tick) { return tick % 100 < 50 ? 10 : -10; });
    QVERIFY(cell(0, MeasureTable::CountColumn).toInt() >= 8);
    QCOMPARE(cell(0, MeasureTable::MeanColumn), QStringLiteral("10.0\u00a0A"));
    QCOMPARE(cell(0, MeasureTable::SigmaColumn), QStringLiteral("0.0\u00a0A"));
    const QString counted = cell(0, MeasureTable::CountColumn);
    Q_EMIT m_rig->workbench.heartbeat({}); // the same record again
    QCOMPARE(cell(0, MeasureTable::CountColumn), counted);
    QTest::mouseClick(m_rig->find<QWidget>("clearStatistics"), Qt::LeftButton);
    QCOMPARE(cell(0, MeasureTable::CountColumn), QStringLiteral("0"));
}

void TestMeasurePanel::everyRecordOfABatchIsCounted()
{
    add(facts::kCurrentA, Quantity::Max);
    add(facts::kCurrentA, Quantity::Mean);
    const widgets::TriggerControl &trigger = triggerOn(0.005);
    for (int batch = 0; batch < 4; ++batch) // ten records in each
        m_rig->record(100, [](int, int tick) { return tick % 10 < 5 ? tick / 100 : -10; });
    QVERIFY(complete(trigger) >= 38);
    QCOMPARE(cell(0, MeasureTable::CountColumn).toInt(), complete(trigger));
    QCOMPARE(cell(1, MeasureTable::CountColumn).toInt(), complete(trigger));
    // Each its own samples.
    QCOMPARE(cell(0, MeasureTable::MinColumn), QStringLiteral("40.0\u00a0A"));
    QCOMPARE(cell(0, MeasureTable::MaxColumn), QStringLiteral("43.0\u00a0A"));
}

void TestMeasurePanel::recordsAreCountedWhileTheNextFills()
{
    add(facts::kCurrentA, Quantity::Mean);
    const widgets::TriggerControl &trigger = triggerOn(0.25);
    for (int batch = 0; batch < 20; ++batch) // the next edge comes in the batch that ends a record
        m_rig->record(100, [](int, int tick) { return tick % 20 < 10 ? 10 : -10; });
    QVERIFY(complete(trigger) >= 6);
    QCOMPARE(cell(0, MeasureTable::CountColumn).toInt(), complete(trigger));
}

void TestMeasurePanel::betweenCursorsRecordsAreCountedThereToo()
{
    add(facts::kCurrentA, Quantity::Max);
    const widgets::TriggerControl &trigger = triggerOn(0.05);
    const auto ramps = [](int, int tick) { return tick % 100 < 50 ? tick % 100 + 1 : -10; };
    m_rig->record(100, ramps);
    m_rig->record(100, ramps);
    auto *range = m_rig->find<QComboBox>("measureRange");
    range->setCurrentIndex(1);
    Q_EMIT range->activated(1);
    const double zero = capture::toSeconds(trigger.shown()->trigger);
    view().cursors().move(widgets::CursorEnd::A, zero + 0.0105);
    view().cursors().move(widgets::CursorEnd::B, zero + 0.0205);
    QTest::mouseClick(m_rig->find<QWidget>("clearStatistics"), Qt::LeftButton);
    m_rig->record(1000, ramps); // several in one batch, of which one is shown
    QVERIFY(cell(0, MeasureTable::CountColumn).toInt() >= 9);
    QCOMPARE(cell(0, MeasureTable::MinColumn), cell(0, MeasureTable::MaxColumn));
    QCOMPARE(cell(0, MeasureTable::SigmaColumn), QStringLiteral("0.0\u00a0A"));
}

void TestMeasurePanel::phaseNeedsASecondTrace()
{
    auto *against = m_rig->find<QWidget>("measureAgainst");
    QVERIFY(!against->isVisible());
    choose("measureQuantity", int(Quantity::Phase));
    QVERIFY(against->isVisible());
    choose("measureAgainst", int(m_rig->id(facts::kCurrentB)));
    add(facts::kCurrentA, Quantity::Phase);
    QCOMPARE(cell(0, MeasureTable::SignalColumn), QStringLiteral("I_A to I_B"));
    QCOMPARE(cell(0, MeasureTable::ValueColumn), QStringLiteral("no full period"));
    choose("measureAgainst", int(m_rig->id(facts::kCurrentA)));
    add(facts::kCurrentA, Quantity::Phase);
    QCOMPARE(cell(1, MeasureTable::ValueColumn), QStringLiteral("0.00\u00a0\u00b0"));
}

/// What comes of it is told by an event: nothing of it can be there before the loop runs.
void TestMeasurePanel::longPicturesAreMeasuredElsewhere()
{
    m_rig->record(kLong, [](int, int) { return 1; });
    m_rig->record(kLong, [](int, int) { return 3; });
    view().setVisibleRange(4.0, 4.0 + kLong / 1000.0);
    add(facts::kCurrentA, Quantity::Mean);
    add(facts::kCurrentA, Quantity::Rms);
    const auto values = [&] {
        return QStringList{cell(0, MeasureTable::ValueColumn), cell(1, MeasureTable::ValueColumn)};
    };
    const QString one = QStringLiteral("1.0\u00a0A");
    const QString three = QStringLiteral("3.0\u00a0A");
    QVERIFY(!values().contains(one));
    const auto heartbeats = [&](const QString &until) {
        Q_EMIT m_rig->workbench.heartbeat({});
        return values() == QStringList{until, until};
    };
    QTRY_VERIFY(heartbeats(one)); // the second row was not there when the first one was begun
    view().setVisibleRange(4.0 + kLong / 1000.0, 4.0 + 2 * kLong / 1000.0);
    Q_EMIT m_rig->workbench.heartbeat({});
    QCOMPARE(values(), (QStringList{one, one}));
    QTRY_VERIFY(heartbeats(three));
    auto *overlay = m_rig->window.findChild<widgets::ScopeOverlay *>();
    QVERIFY(overlay->measure().text.contains(QStringLiteral("3.0")));
}

void TestMeasurePanel::aShortPictureDoesNotWaitForALongOne()
{
    m_rig->record(kLong, [](int, int) { return 3; });
    m_rig->record(kLong, [](int, int) { return 4; });
    view().setVisibleRange(4.0, 4.0 + kLong / 1000.0);
    add(facts::kCurrentA, Quantity::Mean);
    QStringList shown;
    connect(list()->model(), &QAbstractItemModel::dataChanged, this,
        [&] { shown.append(cell(0, MeasureTable::ValueColumn)); });
    const auto measure = [this](double from, double to) {
        view().setVisibleRange(from, to);
        Q_EMIT m_rig->workbench.heartbeat({});
    };
    measure(0.0, 0.05);
    QCOMPARE(shown.value(0), QStringLiteral("10.0\u00a0A"));
    const QString newest = QStringLiteral("4.0\u00a0A");
    const auto isNewest = [&] {
        measure(4.0 + kLong / 1000.0, 4.0 + 2 * kLong / 1000.0);
        return shown.last() == newest;
    };
    QTRY_VERIFY(isNewest());
    QVERIFY(!shown.contains(QStringLiteral("3.0\u00a0A"))); // its answer came too late
}

void TestMeasurePanel::longRecordsAreCountedElsewhere()
{
    for (int i = 0; i < 4; ++i)
        add(facts::kCurrentA, widgets::allQuantities()[3 + i]);
    const widgets::TriggerControl &trigger = triggerOn(30.0);
    const auto edges = [](int, int tick) { return tick % 40000 < 5000 ? -10 : 10; };
    for (int batch = 0; batch < 20; ++batch) {
        const int before = cell(0, MeasureTable::CountColumn).toInt();
        const int completeBefore = complete(trigger);
        m_rig->record(5000, edges);
        QCOMPARE(cell(0, MeasureTable::CountColumn).toInt(), before);
        QTRY_COMPARE(cell(0, MeasureTable::CountColumn).toInt(),
            before + complete(trigger) - completeBefore);
    }
    QVERIFY(complete(trigger) >= 2);
    QCOMPARE(cell(1, MeasureTable::CountColumn), cell(0, MeasureTable::CountColumn));
}

void TestMeasurePanel::whatWasClearedIsNotCounted()
{
    for (int i = 0; i < 4; ++i)
        add(facts::kCurrentA, widgets::allQuantities()[3 + i]);
    const widgets::TriggerControl &trigger = triggerOn(30.0);
    const auto edges = [](int, int tick) { return tick % 40000 < 5000 ? -10 : 10; };
    while (complete(trigger) == 0)
        m_rig->record(5000, edges);
    QTest::mouseClick(m_rig->find<QWidget>("clearStatistics"), Qt::LeftButton);
    while (complete(trigger) == 1)
        m_rig->record(5000, edges);
    QTRY_COMPARE(cell(0, MeasureTable::CountColumn), QStringLiteral("1"));
}

void TestMeasurePanel::itLeavesWhileALongOneIsMeasured()
{
    m_rig->record(kLong, [](int, int) { return 3; });
    view().setVisibleRange(4.0, 4.0 + kLong / 1000.0);
    add(facts::kCurrentA, Quantity::Mean);
    m_rig.reset();
}

void TestMeasurePanel::theTableIsAModelAndACopy()
{
    QAbstractItemModelTester tester(
        list()->model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    add(facts::kCurrentA, Quantity::Max);
    QTest::mouseClick(m_rig->find<QWidget>("copyMeasures"), Qt::LeftButton);
    const QString text = QApplication::clipboard()->text();
    QCOMPARE(text.count(QLatin1Char('\n')), 2);
    QVERIFY(text.contains(QStringLiteral("I_A\tMaximum\t10.0\u00a0A\t")));
    for (int i = 0; i < 40; ++i)
        add(facts::kCurrentA, widgets::allQuantities()[i % 19]);
    QVERIFY(list()->model()->rowCount() <= MeasureTable::kMost);
}

void TestMeasurePanel::everyQuantityHasAName()
{
    QSet<QString> names;
    for (const Quantity quantity : widgets::allQuantities()) {
        names.insert(widgets::quantityText(quantity));
        QVERIFY(!widgets::quantityHelp(quantity).isEmpty());
    }
    QCOMPARE(names.size(), widgets::allQuantities().size());
    for (int why = 0; why <= int(scope::WhyNot::OtherFrequency); ++why)
        QVERIFY(!widgets::whyNotText(static_cast<scope::WhyNot>(why)).isEmpty());
}

QTEST_MAIN(TestMeasurePanel)
#include "tst_measure_panel.moc"
