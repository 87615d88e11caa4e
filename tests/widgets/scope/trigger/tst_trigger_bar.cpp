// The trigger in the real window: modes and keys, what is set and what is shown, marks that are dragged, records of the
// past, references. Where a trigger is found is core's own business and tested there.
#include "support/trigger_test.h"
#include "widgets/base/fields/value_edit.h"
#include "widgets/files/event_recorder.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/record_table.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStyleOptionComboBox>
#include <QToolButton>
#include <QTranslator>
#include <QTreeView>

#include <cmath>

using scope::AcquisitionState;
using scope::Mode;
using widgets::TriggerControl;
using widgets::TriggerSetup;
using widgets::TriggerType;

class TestTriggerBar : public facts::TriggerTest {
    Q_OBJECT
private Q_SLOTS:
    void init() { open(); }
    void cleanup() { m_rig.reset(); }

    void rollIsWhatItWasBefore();
    void normalKeepsARecordAndSetsZeroAtItsTrigger();
    void autoRunsWithoutATrigger();
    void sTakesOneRecordAndStops();
    void tForcesATrigger();
    void spaceStopsAndArms();
    void zoomingARunningPictureSetsTheRecordsLength();
    void theLevelIsDragged();
    void thePositionIsDragged();
    void fieldsAppearWhereTheyMatter();
    void aLevelIsTypedStrictly();
    void aLevelThatMovesTakesNoSelectionAway();
    void digitsAreTypedWithEitherOfTheirNames();
    void valuesThatMakeNoSenseAreSaid();
    void everyTypeIsSearchedFor();
    void stateChangesAndWritesTrigger();
    void theWriteOfOneRegisterIsWaitedFor();
    void aSetPointTriggersWhenItIsSent();
    void allThatIsSetIsReadable();
    void theSettingsAreLeftWithoutEsc();
    void recordsAreSteppedPinnedAndNamed();
    void recordsGoWithTheirSamples();
    void recordsWhoseSamplesWereLetGoAreMarked();
    void theRecordsAreAModel();
    void aFileIsReplayedToTriggerOnIt();
    void endGoesBackToRoll();
    void aRecordSeenInRollIsLeftWhenThePictureRuns();
    void fittingStopsFirst();
    void anAgeNeverGoesBack();
    void cursorsKeepTheirPlaceFromTheTrigger();
    void aReferenceStaysBehind();
    void aReferenceOfTheTriggerIsNotDrawnInRoll();
    void aReplacedReferenceComesBack();
    void persistenceKeepsEarlierRecords();
    void persistenceIsClearedAndBeginsAnew();
    void singleKeysActWhereNoTextIsTyped();
};

void TestTriggerBar::rollIsWhatItWasBefore()
{
    QVERIFY(control().trigger().setup().mode == Mode::Roll);
    QVERIFY(control().trigger().state() == AcquisitionState::Roll);
    QVERIFY(view().time().following());
    QVERIFY(!view().triggerMarks().position);
    square(4000);
    m_rig->draw();
    QCOMPARE(view().visibleRange().to, 5.999);
    QVERIFY(control().trigger().history().records().empty());
    QTest::keyClick(&view(), Qt::Key_T); // nothing waits for it
    QVERIFY(control().trigger().history().records().empty());
}

void TestTriggerBar::normalKeepsARecordAndSetsZeroAtItsTrigger()
{
    normal();
    QVERIFY(control().trigger().state() == AcquisitionState::Armed);
    QVERIFY(stateWord().contains(QStringLiteral("Armed")));
    flat(60);
    QVERIFY(control().trigger().history().records().empty());
    square(200); // from tick 2060 on: rises at 2100
    QVERIFY(!control().trigger().history().records().empty());
    const double trigger = capture::toSeconds(control().shown()->trigger);
    QVERIFY(near(std::fmod(trigger + 0.0005, 0.1), 0.0)); // half way between two samples
    QCOMPARE(view().time().origin(), trigger);
    QVERIFY(near(span(), 0.05));
    QVERIFY(near(left(), trigger - 0.01)); // 20 % before it
    QVERIFY(near(*view().triggerMarks().position, trigger));
    const auto range = view().visibleRange();
    flat(500); // nothing comes: the last one stays
    m_rig->draw();
    QCOMPARE(view().visibleRange().from, range.from);
    QVERIFY(stateWord().contains(QStringLiteral("ago")));
}

void TestTriggerBar::autoRunsWithoutATrigger()
{
    normal();
    control().setMode(Mode::Auto);
    flat(1000);
    QVERIFY(control().trigger().state() == AcquisitionState::Auto);
    QVERIFY(!control().trigger().history().records().empty());
    QVERIFY(
        control().trigger().history().records().back().cause == scope::Record::Cause::Automatic);
    square(300);
    bool hit = false;
    for (const scope::Record &record : control().trigger().history().records())
        hit = hit || record.cause == scope::Record::Cause::Condition;
    QVERIFY(hit);
}

void TestTriggerBar::sTakesOneRecordAndStops()
{
    normal();
    QTest::keyClick(&view(), Qt::Key_S);
    QVERIFY(control().trigger().setup().mode == Mode::Single);
    QVERIFY(control().trigger().state() == AcquisitionState::Armed);
    const std::size_t before = control().trigger().history().records().size();
    square(1000);
    QCOMPARE(control().trigger().history().records().size(), before + 1);
    QVERIFY(!view().running());
    QVERIFY(control().trigger().state() == AcquisitionState::Stop);
    QVERIFY(stateWord().contains(QStringLiteral("Hold")));
    QTest::keyClick(&view(), Qt::Key_S); // the next one
    QVERIFY(view().running());
    square(1000);
    QCOMPARE(control().trigger().history().records().size(), before + 2);
}

void TestTriggerBar::tForcesATrigger()
{
    normal();
    flat(300);
    QVERIFY(control().trigger().history().records().empty());
    QTest::keyClick(&view(), Qt::Key_T);
    flat(100);
    QCOMPARE(control().trigger().history().records().size(), std::size_t{1});
    QVERIFY(control().trigger().history().records().back().cause == scope::Record::Cause::Forced);
}

void TestTriggerBar::spaceStopsAndArms()
{
    normal();
    square(500);
    QTest::keyClick(&view(), Qt::Key_Space);
    QVERIFY(control().trigger().state() == AcquisitionState::Stop);
    const std::size_t before = control().trigger().history().records().size();
    QVERIFY(before > 0);
    square(500);
    QCOMPARE(control().trigger().history().records().size(), before);
    view().setVisibleRange(0.0, 1.0); // looking around in the recording
    QVERIFY(near(control().trigger().setup().length, 0.05));
    QTest::keyClick(&view(), Qt::Key_Space);
    QVERIFY(control().trigger().state() == AcquisitionState::Armed);
    square(500);
    QVERIFY(control().trigger().history().records().size() > before);
    QVERIFY(near(span(), 0.05));
}

void TestTriggerBar::zoomingARunningPictureSetsTheRecordsLength()
{
    normal();
    square(500);
    const double trigger = view().time().origin();
    QTest::keyClick(&view(), Qt::Key_Plus);
    QVERIFY(control().trigger().setup().length < 0.04);
    QVERIFY(near(span(), control().trigger().setup().length));
    QVERIFY(near((trigger - left()) / span(), 0.2)); // the trigger stays at its place
    square(500);
    QVERIFY(near(span(), control().trigger().setup().length));
    QVERIFY(view().time().origin() > trigger);
}

void TestTriggerBar::theLevelIsDragged()
{
    normal();
    square(500);
    view().fitValues();
    m_rig->draw();
    const auto plotPoint = [this](double value) {
        const auto range = view().valueRangeOf(m_rig->id(facts::kCurrentA));
        const QRect area = view().plotRect(view().plotOf(m_rig->id(facts::kCurrentA)));
        const double share = (range.to - value) / (range.to - range.from);
        const QPoint shift = m_rig->plot().mapTo(&view(), QPoint(0, 0));
        return QPoint(area.right() + 5, area.top() + qRound(share * area.height())) - shift;
    };
    m_rig->drag(plotPoint(0.0), plotPoint(8.0));
    QVERIFY2(
        std::abs(control().trigger().setup().level - 8.0) < 10.0, "moved to where it was dragged");
    QVERIFY(control().trigger().setup().level > 2.0);
    QVERIFY(std::abs(m_rig->find<widgets::ValueEdit>("triggerLevel")->value()
                - control().trigger().setup().level)
        < 1e-9);
    QCOMPARE(view().triggerMarks().levels.front(), control().trigger().setup().level);
}

void TestTriggerBar::thePositionIsDragged()
{
    normal();
    square(500);
    QTest::keyClick(&view(), Qt::Key_Space);
    m_rig->draw();
    const double trigger = view().time().origin();
    const QRect area = view().plotRect(0);
    const QPoint shift = m_rig->plot().mapTo(&view(), QPoint(0, 0));
    const QPoint flag = QPoint(qRound(view().time().xOf(trigger)), area.top() + 3) - shift;
    m_rig->drag(flag, flag + QPoint(area.width() * 3 / 10, 0));
    QVERIFY(std::abs(control().trigger().setup().preTrigger - 0.5) < 0.02);
    QVERIFY(std::abs((trigger - left()) / span() - 0.5) < 0.02);
    QCOMPARE(view().time().origin(), trigger);
}

void TestTriggerBar::fieldsAppearWhereTheyMatter()
{
    auto *type = m_rig->find<QComboBox>("triggerType");
    QVERIFY(!type->isVisible()); // a picture that rolls waits for nothing
    auto *mode = m_rig->find<QComboBox>("triggerMode");
    mode->setCurrentIndex(mode->findData(int(Mode::Normal)));
    Q_EMIT mode->activated(mode->currentIndex());
    QVERIFY(type->isVisible() && m_rig->find<QWidget>("triggerLevel")->isVisible());
    QTest::mouseClick(m_rig->find<QToolButton>("triggerMore"), Qt::LeftButton);
    auto *details = m_rig->find<QWidget>("triggerDetails");
    QVERIFY(details->isVisible());
    const auto visible = [this](
                             const char *name) { return m_rig->find<QWidget>(name)->isVisible(); };
    QVERIFY(visible("triggerHysteresis") && visible("triggerHoldOff") && visible("triggerPre"));
    QVERIFY(!visible("triggerUpper") && !visible("triggerLeast") && !visible("triggerCount"));
    const auto choose = [type](TriggerType wanted) {
        type->setCurrentIndex(type->findData(int(wanted)));
        Q_EMIT type->activated(type->currentIndex());
    };
    choose(TriggerType::Slew);
    QVERIFY(visible("triggerUpper") && visible("triggerLeast") && !visible("triggerCount"));
    QCOMPARE(view().triggerMarks().levels.size(), std::size_t{2});
    choose(TriggerType::NthEdge);
    QVERIFY(visible("triggerCount") && visible("triggerTime") && !visible("triggerUpper"));
    choose(TriggerType::Fault);
    QVERIFY(!visible("triggerLevel") && !visible("triggerSource") && !visible("triggerHysteresis"));
    QVERIFY(view().triggerMarks().levels.empty());
    details->hide();
}

void TestTriggerBar::aLevelIsTypedStrictly()
{
    normal();
    auto *level = m_rig->find<widgets::ValueEdit>("triggerLevel");
    const auto type = [level](const char *text) {
        level->setFocus();
        level->selectAll();
        QTest::keyClicks(level, QString::fromUtf8(text));
        QTest::keyClick(level, Qt::Key_Return);
    };
    type("5 A");
    QCOMPARE(control().trigger().setup().level, 5.0);
    QCOMPARE(level->text(), QStringLiteral("5\u00a0A"));
    for (const char *nonsense : {"1.2.3", "1e3", "", "5 V", "nan", "1,000.5"}) {
        type(nonsense);
        QCOMPARE(control().trigger().setup().level, 5.0);
        QCOMPARE(level->text(), QStringLiteral("5\u00a0A"));
    }
    type("-2,5");
    QCOMPARE(control().trigger().setup().level, -2.5);
    auto *holdOff = m_rig->find<widgets::ValueEdit>("triggerHoldOff");
    for (const auto &[text, seconds] :
        {std::pair{"20 ms", 0.02}, {"500us", 5e-4}, {"1 min", 60.0}}) {
        holdOff->setText(QString::fromUtf8(text));
        QVERIFY(holdOff->understood());
        QVERIFY(near(*holdOff->understood(), seconds));
    }
    holdOff->setText(QStringLiteral("2 h"));
    QVERIFY(!holdOff->understood());
    holdOff->setText(QStringLiteral("-1 ms"));
    QVERIFY(!holdOff->understood());
}

void TestTriggerBar::aLevelThatMovesTakesNoSelectionAway()
{
    QWidget window;
    widgets::ValueEdit edit(&window);
    edit.setPlain(QStringLiteral("A"), 0.1);
    edit.setValue(5.0);
    edit.setFocus();
    edit.selectAll();
    edit.setValue(7.0);
    QCOMPARE(edit.selectedText(), edit.text());
    QTest::keyClicks(&edit, QStringLiteral("3"));
    QCOMPARE(edit.text(), QStringLiteral("3"));
}

void TestTriggerBar::digitsAreTypedWithEitherOfTheirNames()
{
    widgets::ValueEdit edit;
    edit.setPlain(QStringLiteral("s16A"), 1.0);
    edit.setValue(7.0);
    QCOMPARE(edit.text(), QStringLiteral("7\u00a0digits"));
    for (const char *text : {"100", "100 digits", "100 s16A", "100s16a"}) {
        edit.setText(QString::fromUtf8(text));
        QVERIFY2(edit.understood() == 100.0, text);
    }
    for (const char *text : {"100 A", "100 s16V", "100 digits s16A"}) {
        edit.setText(QString::fromUtf8(text));
        QVERIFY2(!edit.understood(), text);
    }
}

void TestTriggerBar::valuesThatMakeNoSenseAreSaid()
{
    normal();
    setup([](TriggerSetup &setup) {
        setup.type = TriggerType::Window;
        setup.level = 5.0;
        setup.upper = 1.0;
    });
    QVERIFY(control().trigger().error() == scope::ConditionError::LevelsSwapped);
    QVERIFY(stateWord().contains(QStringLiteral("above")));
    setup([](TriggerSetup &setup) { setup.upper = 6.0; });
    QVERIFY(!control().trigger().error());
}

void TestTriggerBar::everyTypeIsSearchedFor()
{
    normal(0.02);
    for (int type = 0; type < widgets::kTriggerTypes; ++type) {
        const auto wanted = static_cast<TriggerType>(type);
        if (!widgets::fieldsOf(wanted).source)
            continue;
        setup([wanted](TriggerSetup &setup) {
            setup.type = wanted;
            setup.way = widgets::TriggerWay::First;
            setup.level = -5.0;
            setup.upper = 5.0;
            setup.least = 0.0;
            setup.most = 10.0;
            setup.time = 0.02;
            setup.count = 2;
        });
        if (wanted == TriggerType::NthEdge)
            setup([](TriggerSetup &setup) { setup.time = 0.0; });
        if (wanted == TriggerType::Window) // the trace is in it when it is down
            setup([](TriggerSetup &setup) { setup.level = -15.0; });
        QVERIFY(!control().trigger().error());
        const double before = double(m_rig->tick) / 1000.0;
        flat(30);
        square(970);
        QVERIFY2(
            control().shown() && capture::toSeconds(control().shown()->trigger) >= before - 0.001,
            qPrintable(widgets::typeText(wanted)));
    }
}

void TestTriggerBar::stateChangesAndWritesTrigger()
{
    normal();
    setup([](TriggerSetup &setup) { setup.type = TriggerType::StateChange; });
    flat(100);
    drive::MotorStatus status = facts::status(drive::MotorState::Running);
    status.rawState = 6;
    status.at = TimePoint(std::chrono::milliseconds(2090));
    facts::feed(m_rig->device(), {status});
    flat(100);
    QCOMPARE(control().trigger().history().records().size(), std::size_t{1});
    QVERIFY(near(view().time().origin(), 2.09));
    setup([](TriggerSetup &setup) { setup.type = TriggerType::Fault; });
    flat(300);
    QCOMPARE(control().trigger().history().records().size(), std::size_t{1});
    status.faultsNow = {"OVER_VOLT"};
    status.at = TimePoint(std::chrono::milliseconds(m_rig->tick));
    facts::feed(m_rig->device(), {status});
    flat(100);
    QCOMPARE(control().trigger().history().records().size(), std::size_t{2});
}

void TestTriggerBar::theWriteOfOneRegisterIsWaitedFor()
{
    normal();
    auto *type = m_rig->find<QComboBox>("triggerType");
    auto *which = m_rig->find<QComboBox>("triggerWritten");
    const auto choose = [](QComboBox *box, int index) {
        QVERIFY(index >= 0);
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    };
    QVERIFY(!which->isVisible());
    choose(type, type->findData(int(TriggerType::RegisterWrite)));
    QVERIFY(which->isVisible());
    QCOMPARE(which->currentText(), QStringLiteral("Any register"));
    const auto write = [this] {
        flat(100);
        Q_EMIT m_rig->workbench.eventRecorder().written(
            static_cast<double>(m_rig->tick - 10) / 1000.0, QStringLiteral("BUS_VOLTAGE@1"));
        flat(100);
        return control().trigger().history().records().size();
    };
    QCOMPARE(write(), std::size_t{1});
    // One that this board does not have stays chosen: a workspace of another board has named it.
    setup([](TriggerSetup &setup) { setup.written = QStringLiteral("SPEED_KI"); });
    QCOMPARE(which->currentText(), QStringLiteral("SPEED_KI"));
    QCOMPARE(write(), std::size_t{1});
    // The first motor's number is told only where there are several.
    setup([](TriggerSetup &setup) { setup.written = QStringLiteral("BUS_VOLTAGE"); });
    QCOMPARE(write(), std::size_t{2});
    choose(which, 0);
    QVERIFY(control().trigger().setup().written.isEmpty());
}

void TestTriggerBar::aSetPointTriggersWhenItIsSent()
{
    normal();
    auto *type = m_rig->find<QComboBox>("triggerType");
    const int choice = type->findText(QStringLiteral("Set-point"));
    QVERIFY(choice >= 0);
    type->setCurrentIndex(choice);
    Q_EMIT type->activated(choice);
    flat(100);
    using Kind = drive::SentSetPoint::Kind;
    const auto send = [&](Kind kind) {
        drive::SentSetPoint sent;
        sent.kind = kind;
        sent.seconds = static_cast<double>(m_rig->tick - 10) / 1000.0;
        Q_EMIT m_rig->workbench.setPoints().left(sent);
        QCoreApplication::processEvents();
        flat(100);
        return sent.seconds;
    };
    const auto count = [this] { return control().trigger().history().records().size(); };
    drive::MotionEntry start; // is none
    start.requests = 1;
    start.asked = start.ended = TimePoint(std::chrono::milliseconds(m_rig->tick - 10));
    facts::feed(m_rig->device(), {start});
    flat(100);
    QCOMPARE(count(), std::size_t{0});
    const double sent = send(Kind::Speed);
    QCOMPARE(count(), std::size_t{1});
    QVERIFY(near(view().time().origin(), sent));
    send(Kind::Current);
    send(Kind::Position);
    QCOMPARE(count(), std::size_t{3});
}

/// The whole name of the trace and the whole level with its unit, where there is room.
void TestTriggerBar::allThatIsSetIsReadable()
{
    constexpr catalog::RegisterId kSpeed = 0x4321;
    capture::StreamLayout layout = facts::ScopeWindow::layout();
    layout.id = 2;
    layout.fast[0] = {kSpeed, "STOPLL_ROT_SPEED", "rpm", 0.01, 0.0};
    facts::feed(m_rig->device(), {drive::StreamStarted{layout}});
    QVERIFY(m_rig->workbench.capture().find(kSpeed));
    view().addChannel(m_rig->id(kSpeed), 0);
    m_rig->window.resize(1600, 900);
    normal();
    control().trigger().setSource(m_rig->id(kSpeed));
    setup([](TriggerSetup &setup) { setup.level = -1002.5; });
    m_rig->draw();
    const auto *source = m_rig->find<QComboBox>("triggerSource");
    QStyleOptionComboBox option;
    option.initFrom(source);
    const QRect room = source->style()->subControlRect(
        QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, source);
    const auto widthOf = [](const QWidget *widget, const QString &text) {
        return widget->fontMetrics().horizontalAdvance(text);
    };
    QVERIFY(widthOf(source, QStringLiteral("STOPLL_ROT_SPEED")) <= room.width());
    const auto *level = m_rig->find<widgets::ValueEdit>("triggerLevel");
    QVERIFY2(widthOf(level, level->text()) + 8 <= level->width(), qPrintable(level->text()));
}

void TestTriggerBar::theSettingsAreLeftWithoutEsc()
{
    normal();
    QTest::mouseClick(m_rig->find<QWidget>("triggerMore"), Qt::LeftButton);
    auto *details = m_rig->find<QWidget>("triggerDetails");
    QVERIFY(details->isVisible());
    QTest::mouseClick(m_rig->find<QPushButton>("triggerDetailsClose"), Qt::LeftButton);
    QVERIFY(!details->isVisible());
}

void TestTriggerBar::recordsAreSteppedPinnedAndNamed()
{
    normal(0.02);
    square(1000);
    const auto records = control().trigger().history().records();
    QVERIFY(records.size() >= 5);
    QTest::keyClick(&view(), Qt::Key_PageUp);
    QVERIFY(!view().running());
    QCOMPARE(control().shown()->id, records[records.size() - 2].id);
    QTest::keyClick(&view(), Qt::Key_PageDown);
    QCOMPARE(control().shown()->id, records.back().id);
    QTest::keyClick(&view(), Qt::Key_PageDown); // there is no later one
    QCOMPARE(control().shown()->id, records.back().id);

    const auto *show = m_rig->find<QPushButton>("showRecord");
    QVERIFY(!show->isEnabled()); // none is chosen
    QTest::keyClick(&m_rig->window, Qt::Key_8, Qt::ControlModifier);
    auto *list = m_rig->find<QTreeView>("recordList");
    QVERIFY(list->isVisible());
    QCOMPARE(list->model()->rowCount(), int(records.size()));
    list->setCurrentIndex(list->model()->index(3, 0));
    QVERIFY(show->isEnabled());
    QTest::keyClick(list, Qt::Key_Return);
    const scope::RecordId third = records[records.size() - 4].id;
    QCOMPARE(control().shown()->id, third);
    list->model()->setData(list->model()->index(3, 0), Qt::Checked, Qt::CheckStateRole);
    QTest::keyClick(list, Qt::Key_F2);
    auto *editor = list->findChild<QLineEdit *>();
    QVERIFY(editor);
    QTest::keyClicks(editor, QStringLiteral("load on"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(QString::fromStdString(control().trigger().history().find(third)->label),
        QStringLiteral("load on"));
    view().setRunning(true);
    square(20000); // far more records than are kept
    QVERIFY(control().trigger().history().find(third));
    QVERIFY(!control().trigger().history().find(records.front().id));
}

void TestTriggerBar::recordsGoWithTheirSamples()
{
    normal(0.02);
    square(1000);
    view().ghosts().keep(widgets::Reference::A);
    control().setPersistence(3);
    control().trigger().setPinned(control().trigger().history().records().back().id, true);
    QVERIFY(view().time().origin() > 0.0);
    QVERIFY(view().ghosts().count() > 0);
    m_rig->workbench.signalPlan().clear();
    QVERIFY(control().trigger().history().records().empty());
    QVERIFY(!control().shown());
    QCOMPARE(view().time().origin(), 0.0);
    QCOMPARE(view().ghosts().count(), 0);
    QVERIFY(view().ghosts().hasReference()); // a copy of its own
    QVERIFY(control().trigger().state() == AcquisitionState::Armed);
    square(1000);
    const std::size_t again = control().trigger().history().records().size();
    QVERIFY(again >= 8 && again <= 10); // none from before, none that nothing triggered
    QVERIFY(view().ghosts().count() > 0);

    capture::Capture file;
    file.begin({7, 1000.0, 0.0, 1, {{900, "F", "A", 1.0, 0.0}}, {}});
    capture::SampleBlock block{7, 0, 60000, {}, {}, 0};
    block.fast.assign(60000, 3);
    file.append(block);
    m_rig->window.selection()->showFile(std::move(file));
    m_rig->draw();
    QVERIFY(control().trigger().history().records().empty());
    QCOMPARE(view().time().origin(), 0.0);
    QCOMPARE(view().ghosts().count(), 0);
    QTest::keyClick(&view(), Qt::Key_PageUp); // nothing of the board over the file
    QVERIFY(!control().shown());
    QCOMPARE(view().visibleRange().to, 60.0);
}

void TestTriggerBar::recordsWhoseSamplesWereLetGoAreMarked()
{
    capture::Capture &capture = m_rig->workbench.capture();
    m_rig->workbench.signalPlan().clear();
    capture = capture::Capture({.maxBytes = 1'000'000});
    m_rig->stream();
    capture.appendPolled(900, "ONCE", "V", 0.001, 1.0); // kept for ever
    square(200);
    normal(0.02);
    square(300);
    const auto records = control().trigger().history().records();
    QVERIFY(records.size() >= 2);
    control().trigger().setPinned(records.front().id, true);
    setup([](TriggerSetup &setup) { setup.level = 50.0; }); // nothing gets there
    QSignalSpy told(&control().trigger(), &widgets::Trigger::historyChanged);
    for (int i = 0; i < 30 && control().trigger().history().records().size() > 1; ++i)
        flat(50000);
    QCOMPARE(control().trigger().history().records().size(), std::size_t{1});
    QVERIFY(
        control().trigger().history().records().front().state == scope::Record::State::Released);
    QVERIFY(!told.isEmpty());
}

void TestTriggerBar::theRecordsAreAModel()
{
    widgets::RecordTable table(control());
    QAbstractItemModelTester tester(&table, QAbstractItemModelTester::FailureReportingMode::QtTest);
    normal(0.02);
    square(1000);
    table.refresh();
    QVERIFY(table.rowCount() >= 5);
    QVERIFY(!table.setData(table.index(0, 1), 1, Qt::EditRole));
    QVERIFY(table.setData(table.index(0, 0), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(table.data(table.index(0, 0), Qt::CheckStateRole).toInt(), int(Qt::Checked));
    QCOMPARE(table.rowOf(control().trigger().history().records().back().id), 0);
    square(1000);
    table.refresh();
}

void TestTriggerBar::aFileIsReplayedToTriggerOnIt()
{
    normal();
    m_rig->device().portChanged(session::PortState::Closed, {});
    capture::Capture file;
    const auto trace = file.addImported("I", "A");
    for (int i = 0; i < 1000; ++i)
        file.appendImported(trace, i * 1'000'000LL, i % 100, (i + 1) * 1'000'000LL);
    m_rig->window.selection()->showFile(std::move(file));
    QVERIFY2(stateWord().contains(QStringLiteral("replay it")), qPrintable(stateWord()));
    auto *mode = m_rig->find<QComboBox>("triggerMode");
    QVERIFY(mode->isEnabled()); // it may be ended
    control().setMode(Mode::Roll);
    QVERIFY(!mode->isEnabled());
    for (const char *button : {"triggerSingle", "triggerForce"})
        QVERIFY(!m_rig->find<QToolButton>(button)->isEnabled());
    QTest::keyClick(&view(), Qt::Key_S);
    control().single();
    control().setMode(Mode::Auto);
    control().trigger().force();
    QVERIFY(control().trigger().setup().mode == Mode::Roll);
    m_rig->workbench.signalPlan().clear();
    QVERIFY(mode->isEnabled());
    QVERIFY2(!stateWord().contains(QStringLiteral("replay it")), qPrintable(stateWord()));
}

void TestTriggerBar::endGoesBackToRoll()
{
    normal();
    square(500);
    QTest::keyClick(&view(), Qt::Key_End);
    QVERIFY(control().trigger().setup().mode == Mode::Roll);
    const QString said = m_rig->find<QLabel>("bannerText")->text(); // not behind one's back
    QVERIFY2(said.contains(QStringLiteral("Normal")) && said.contains(QStringLiteral("Roll")),
        qPrintable(said));
    QCOMPARE(view().time().origin(), 0.0);
    QVERIFY(view().time().following());
    QVERIFY(!view().triggerMarks().position);
    square(4000);
    m_rig->draw();
    QCOMPARE(view().visibleRange().to, double(m_rig->tick - 1) / 1000.0);
}

void TestTriggerBar::aRecordSeenInRollIsLeftWhenThePictureRuns()
{
    normal();
    square(500);
    control().setMode(Mode::Roll);
    for (const Qt::Key goOn : {Qt::Key_Space, Qt::Key_End}) {
        QTest::keyClick(&view(), Qt::Key_PageUp);
        QVERIFY(control().shown() && view().time().origin() > 0.0);
        QTest::keyClick(&view(), goOn);
        QVERIFY(!control().shown());
        QCOMPARE(view().time().origin(), 0.0);
    }
}

void TestTriggerBar::fittingStopsFirst()
{
    normal();
    square(500);
    QTest::keyClick(&view(), Qt::Key_F);
    QVERIFY(!view().running());
    QCOMPARE(left(), 0.0);
    QVERIFY(near(control().trigger().setup().length, 0.05));
}

void TestTriggerBar::anAgeNeverGoesBack()
{
    QCOMPARE(widgets::ageText(0.94), QStringLiteral("0.9 s ago"));
    QCOMPARE(widgets::ageText(0.97), QStringLiteral("1 s ago"));
    QCOMPARE(widgets::ageText(119.9), QStringLiteral("119 s ago"));
    QCOMPARE(widgets::ageText(121.0), QStringLiteral("2 min ago"));
}

void TestTriggerBar::cursorsKeepTheirPlaceFromTheTrigger()
{
    normal(0.02);
    square(500);
    view().cursorActions().toggle();
    const auto fromTrigger = [this] {
        const double zero = capture::toSeconds(control().shown()->trigger);
        return std::pair(view().cursors().pair().a - zero, view().cursors().pair().b - zero);
    };
    const auto before = fromTrigger();
    const scope::RecordId shown = control().shown()->id;
    square(500);
    QVERIFY(control().shown()->id != shown);
    QVERIFY(std::abs(fromTrigger().first - before.first) < 1e-9);
    QVERIFY(std::abs(fromTrigger().second - before.second) < 1e-9);
    QTest::keyClick(&m_rig->window, Qt::Key_PageUp); // an earlier one, too
    QVERIFY(std::abs(fromTrigger().first - before.first) < 1e-9);
    // What the cursors' table says of it is that, and not what the record before had.
    double told = 0.0;
    connect(&view().cursors(), &widgets::Cursors::changed, this,
        [&] { told = view().cursors().pair().a - view().time().origin(); });
    QTest::keyClick(&m_rig->window, Qt::Key_PageUp);
    QVERIFY(std::abs(told - before.first) < 1e-9);
    view().cursors().disconnect(this);
}

void TestTriggerBar::aReferenceStaysBehind()
{
    normal();
    square(500);
    view().fitValues();
    m_rig->draw();
    const QImage before = m_rig->plot().grab().toImage();
    QTest::keyClick(&view(), Qt::Key_R);
    QVERIFY(view().ghosts().hasReference());
    setup([](TriggerSetup &setup) { setup.way = widgets::TriggerWay::Second; });
    square(500); // the other edge: the reference differs from what comes
    m_rig->draw();
    const QImage with = m_rig->plot().grab().toImage();
    QTest::keyClick(&view(), Qt::Key_R, Qt::ShiftModifier);
    QVERIFY(!view().ghosts().hasReference());
    QTest::keyClick(&view(), Qt::Key_B); // the other one
    QVERIFY(view().ghosts().hasReference(widgets::Reference::B));
    QVERIFY(!view().ghosts().hasReference(widgets::Reference::A));
    QTest::keyClick(&m_rig->window, Qt::Key_8, Qt::ControlModifier);
    QVERIFY(!m_rig->find<QWidget>("dropReference")->isEnabled());
    QTest::mouseClick(m_rig->find<QWidget>("dropReferenceB"), Qt::LeftButton);
    QVERIFY(!view().ghosts().hasReference());
    QVERIFY(!m_rig->find<QWidget>("dropReferenceB")->isEnabled());
    QTest::mouseClick(m_rig->find<QWidget>("keepReferenceB"), Qt::LeftButton);
    QVERIFY(view().ghosts().hasReference(widgets::Reference::B));
    QTest::keyClick(&view(), Qt::Key_B, Qt::ShiftModifier);
    QVERIFY(!view().ghosts().hasReference());
    m_rig->draw();
    const QImage without = m_rig->plot().grab().toImage();
    QVERIFY(with != without);
    QVERIFY(before != without);
    m_rig->workbench.signalPlan().clear();
    QTest::keyClick(&view(), Qt::Key_R); // nothing is shown: nothing to keep
    m_rig->draw();
}

/// It would lie at the left edge, where nothing belongs to it.
void TestTriggerBar::aReferenceOfTheTriggerIsNotDrawnInRoll()
{
    normal();
    square(500);
    m_rig->draw();
    QTest::keyClick(&view(), Qt::Key_R);
    control().setMode(Mode::Roll);
    view().setRunning(false);
    view().fitValues();
    m_rig->draw();
    const QImage with = m_rig->plot().grab().toImage();
    QTest::keyClick(&view(), Qt::Key_R, Qt::ShiftModifier);
    m_rig->draw();
    QVERIFY(with == m_rig->plot().grab().toImage());
}

/// A key that was meant for a field must not cost what one compares with.
void TestTriggerBar::aReplacedReferenceComesBack()
{
    normal();
    square(500);
    view().fitValues();
    QTest::keyClick(&view(), Qt::Key_R);
    const auto said = [&] { return m_rig->find<QLabel>("bannerText")->text(); };
    QVERIFY2(!said().contains(QStringLiteral("reference A")), qPrintable(said()));
    setup([](TriggerSetup &setup) { setup.way = widgets::TriggerWay::Second; });
    square(500);
    view().setRunning(false);
    m_rig->draw();
    const QImage first = m_rig->plot().grab().toImage();
    QTest::keyClick(&view(), Qt::Key_R); // by mistake
    QCOMPARE(said(),
        QStringLiteral("There was a reference A already. It is replaced; Shift+R brings it back."));
    m_rig->draw();
    QVERIFY(first != m_rig->plot().grab().toImage());
    QTest::keyClick(&view(), Qt::Key_R, Qt::ShiftModifier);
    m_rig->draw();
    QVERIFY(view().ghosts().hasReference());
    QVERIFY(first == m_rig->plot().grab().toImage());
    QCOMPARE(said(), QStringLiteral("Reference A is again the one before."));
    QTest::keyClick(&view(), Qt::Key_R, Qt::ShiftModifier);
    QVERIFY(!view().ghosts().hasReference());
}

void TestTriggerBar::persistenceKeepsEarlierRecords()
{
    normal(0.02);
    QTest::keyClick(&m_rig->window, Qt::Key_8, Qt::ControlModifier);
    m_rig->find<QSpinBox>("persistence")->setValue(4);
    square(1000);
    QCOMPARE(view().ghosts().count(), 4);
    m_rig->draw();
    m_rig->find<QSpinBox>("persistence")->setValue(0);
    QCOMPARE(view().ghosts().count(), 0);
}

void TestTriggerBar::persistenceIsClearedAndBeginsAnew()
{
    normal(0.02);
    QTest::keyClick(&m_rig->window, Qt::Key_8, Qt::ControlModifier);
    auto *clear = m_rig->find<QPushButton>("clearPersistence");
    QVERIFY(!clear->isEnabled());
    m_rig->find<QSpinBox>("persistence")->setValue(4);
    square(1000);
    QCOMPARE(view().ghosts().count(), 4);
    QTest::mouseClick(clear, Qt::LeftButton);
    QCOMPARE(view().ghosts().count(), 0);
    square(1000);
    QCOMPARE(view().ghosts().count(), 4);
    // Where an edge the other way was the trigger, the signal stood half a period further.
    setup([](TriggerSetup &setup) { setup.way = widgets::TriggerWay::Second; });
    const auto first = control().shown()->id;
    while (control().shown()->id == first)
        square(10);
    QCOMPARE(view().ghosts().count(), 0);
    square(1000);
    QCOMPARE(view().ghosts().count(), 4);
    // What is only framed in another way stays comparable.
    setup([](TriggerSetup &setup) { setup.preTrigger = 0.7; });
    square(100);
    QCOMPARE(view().ghosts().count(), 4);
}

void TestTriggerBar::singleKeysActWhereNoTextIsTyped()
{
    normal();
    auto *type = m_rig->find<QComboBox>("triggerType");
    type->setFocus();
    const int before = type->currentIndex();
    QTest::keyClick(type, Qt::Key_C);
    QVERIFY(view().cursors().visible());
    QCOMPARE(type->currentIndex(), before); // not the first entry with a C
    auto *button = m_rig->find<QAbstractButton>("triggerSingle");
    button->setFocus();
    QTest::keyClick(button, Qt::Key_C);
    QVERIFY(!view().cursors().visible());
    QTest::keyClick(button, Qt::Key_G);
    QVERIFY(!view().gridVisible());
    QTest::keyClick(&m_rig->window, Qt::Key_M, Qt::ControlModifier | Qt::ShiftModifier);
    auto *text = m_rig->find<QLineEdit>("mathFormula");
    QTest::keyClicks(text, QStringLiteral("cos"));
    QVERIFY(!view().cursors().visible());
    QCOMPARE(text->text(), QStringLiteral("cos"));
}

QTEST_MAIN(TestTriggerBar)
#include "tst_trigger_bar.moc"
