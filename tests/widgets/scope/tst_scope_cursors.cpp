// The scope's cursors in the real window: keys, mouse, read-out, clipboard.
#include "support/scope_window.h"
#include "widgets/base/reading_text.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/cursor_table.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>

using widgets::CursorEnd;

class TestScopeCursors : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        // I_A counts the ticks; I_B stays at 10 digits, which are 20 A.
        m_rig->record(4000, [](int signal, int tick) { return signal == 0 ? tick : 10; });
        scope().setRunning(false);
        scope().setVisibleRange(0.0, 4.0);
        scope().setFocus();
        m_rig->draw();
    }
    void cleanup() { m_rig.reset(); }

    void cShowsTheCursorsInsideThePictureAndHidesThem();
    void theReadOutHoldsTheSampleBefore();
    void onASampleTheReadOutIsThatSample();
    void inAGapThereIsNoSample();
    void oneAndTwoTakeACursorToTheMouse();
    void withoutAMouseACursorComesIntoView();
    void arrowsMoveAnActiveCursorSampleBySample();
    void withoutAnActiveCursorArrowsMoveThePicture();
    void aCursorIsDragged();
    void severalPairsKeepTheirNamesAndPlaces();
    void theTableGoesToTheClipboard();
    void zoomAndClearLeaveTheTimesAlone();
    void theCursorsAreDrawn();
    void keysDoNothingWhileTextIsTyped();
    void theTableIsAModel();
    void timesAndInversesAreExact();
    void aTimeHasOneMarker();

private:
    widgets::ScopeView &scope() { return m_rig->scope(); }
    widgets::Cursors &cursors() { return scope().cursors(); }
    void key(Qt::Key key, Qt::KeyboardModifiers held = {}) { QTest::keyClick(&scope(), key, held); }
    QString cell(int row, int column)
    {
        const auto *model = m_rig->find<QTableView>("cursorTable")->model();
        return model->index(row, column).data().toString();
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

/// A recording has one for a time, and a key that is held is one wish.
void TestScopeCursors::aTimeHasOneMarker()
{
    const auto markers = [this] {
        const auto &events = scope().events().events();
        return std::count_if(events.begin(), events.end(),
            [](const auto &event) { return event.kind == widgets::EventKind::Marker; });
    };
    scope().cursorActions().setMarkerAt(1.0);
    scope().cursorActions().setMarkerAt(1.0 + 1e-11);
    QCOMPARE(markers(), 1);
    scope().cursorActions().setMarkerAt(1.0 + 1e-8);
    QCOMPARE(markers(), 2);
    cursors().move(CursorEnd::A, 2.0);
    key(Qt::Key_C);
    cursors().setActive(CursorEnd::A);
    QKeyEvent held(QEvent::KeyPress, Qt::Key_M, Qt::NoModifier, QStringLiteral("m"), true);
    QApplication::sendEvent(&scope(), &held);
    QCOMPARE(markers(), 2);
    key(Qt::Key_M);
    QCOMPARE(markers(), 3);
    for (const QAction *action : m_rig->window.findChildren<QAction *>())
        QVERIFY(action->shortcut() != QKeySequence(Qt::Key_M) || !action->autoRepeat());
}

void TestScopeCursors::cShowsTheCursorsInsideThePictureAndHidesThem()
{
    QVERIFY(!m_rig->find<QWidget>("cursorPanel")); // made when it is first shown
    key(Qt::Key_C);
    auto *panel = m_rig->find<QWidget>("cursorPanel");
    QVERIFY(cursors().visible() && panel && panel->isVisible());
    QTRY_VERIFY(panel->y() > scope().y() && panel->height() > 0); // below the picture
    QVERIFY(cursors().pair().a > 0.0 && cursors().pair().b < 4.0);
    QVERIFY(cursors().pair().a < cursors().pair().b);
    const double placed = cursors().pair().a;
    key(Qt::Key_C);
    QVERIFY(!cursors().visible() && !panel->isVisible());
    scope().setVisibleRange(0.5, 3.5);
    key(Qt::Key_C); // still in view: where it was left
    QCOMPARE(cursors().pair().a, placed);
    key(Qt::Key_C);
    scope().setVisibleRange(3.9, 4.0);
    key(Qt::Key_C); // nothing of it could be seen there
    QVERIFY(cursors().pair().a > 3.9 && cursors().pair().b < 4.0);
}

void TestScopeCursors::theReadOutHoldsTheSampleBefore()
{
    key(Qt::Key_C);
    cursors().move(CursorEnd::A, 0.1009); // nearly the next sample, but not yet
    cursors().move(CursorEnd::B, 0.1500);
    QCOMPARE(cell(0, 0), QStringLiteral("100.9000\u2009ms"));
    QCOMPARE(cell(2, 0), QStringLiteral("49.1000\u2009ms"));
    QCOMPARE(cell(0, 1), QStringLiteral("100\u00a0A"));
    QCOMPARE(cell(1, 1), QStringLiteral("150\u00a0A"));
    QCOMPARE(cell(2, 1), QStringLiteral("50\u00a0A"));
    QCOMPARE(cell(0, 2), QStringLiteral("20\u00a0A"));
    QCOMPARE(cell(2, 2), QStringLiteral("0\u00a0A"));
    QCOMPARE(m_rig->find<QLabel>("cursorInverse")->text(),
        QStringLiteral("1/\u0394t\u200220.367\u00a0Hz"));
}

/// Every one of them: as a floating-point number, some instants lie a hair before the sample they stand for.
void TestScopeCursors::onASampleTheReadOutIsThatSample()
{
    m_rig->mouseLeaves();
    key(Qt::Key_1);
    cursors().move(CursorEnd::A, 0.0);
    for (int sample = 0; sample < 4000; ++sample) {
        QCOMPARE(cell(0, 1), QString::number(sample) + QStringLiteral("\u00a0A"));
        key(Qt::Key_Right);
    }
}

void TestScopeCursors::inAGapThereIsNoSample()
{
    m_rig->lose(1000);
    m_rig->record(1000, [](int, int) { return 7; });
    key(Qt::Key_C);
    cursors().move(CursorEnd::A, 3.5);
    cursors().move(CursorEnd::B, 4.5); // lost
    QCOMPARE(cell(0, 1), QStringLiteral("3500\u00a0A"));
    QCOMPARE(cell(1, 1), QStringLiteral("no sample"));
    QCOMPARE(cell(2, 1), QStringLiteral("\u2013"));
    cursors().move(CursorEnd::B, 5.5);
    QCOMPARE(cell(1, 1), QStringLiteral("7\u00a0A"));
}

void TestScopeCursors::oneAndTwoTakeACursorToTheMouse()
{
    m_rig->moveMouse(m_rig->at(1.0));
    key(Qt::Key_1);
    QVERIFY(cursors().visible());
    QVERIFY(cursors().active() == CursorEnd::A);
    QVERIFY(std::abs(cursors().pair().a - 1.0) < 0.01);
    m_rig->moveMouse(m_rig->at(1.5));
    QVERIFY(std::abs(cursors().pair().a - 1.5) < 0.01);
    QTest::mouseClick(&m_rig->plot(), Qt::LeftButton, {}, m_rig->at(1.5));
    m_rig->moveMouse(m_rig->at(3.0)); // the click let it go
    QVERIFY(std::abs(cursors().pair().a - 1.5) < 0.01);
    key(Qt::Key_2);
    m_rig->moveMouse(m_rig->at(2.5));
    QVERIFY(std::abs(cursors().pair().b - 2.5) < 0.01);
    key(Qt::Key_2); // so does the same key
    m_rig->moveMouse(m_rig->at(3.5));
    QVERIFY(std::abs(cursors().pair().b - 2.5) < 0.01);
}

void TestScopeCursors::withoutAMouseACursorComesIntoView()
{
    key(Qt::Key_C);
    scope().setVisibleRange(3.9, 4.0);
    m_rig->mouseLeaves();
    key(Qt::Key_2);
    QVERIFY(cursors().pair().b > 3.9 && cursors().pair().b < 4.0);
    QVERIFY(cursors().pair().a < 3.9);
    const double there = cursors().pair().b;
    key(Qt::Key_2); // in view already: it only becomes the active one
    QCOMPARE(cursors().pair().b, there);
}

void TestScopeCursors::arrowsMoveAnActiveCursorSampleBySample()
{
    m_rig->mouseLeaves();
    key(Qt::Key_1);
    cursors().move(CursorEnd::A, 1.0004);
    key(Qt::Key_Right);
    QCOMPARE(cursors().pair().a, 1.001);
    key(Qt::Key_Right);
    QCOMPARE(cursors().pair().a, 1.002);
    key(Qt::Key_Left);
    QCOMPARE(cursors().pair().a, 1.001);
    key(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(cursors().pair().a, 1.011);
    cursors().move(CursorEnd::A, 1.0004);
    key(Qt::Key_Left);
    QCOMPARE(cursors().pair().a, 1.0);
    cursors().move(CursorEnd::A, 3.998);
    key(Qt::Key_Right, Qt::ShiftModifier);
    QCOMPARE(cursors().pair().a, 3.999); // the last sample; there is nothing behind it
    scope().setVisibleRange(0.0, 0.5);
    key(Qt::Key_Left); // it stays in view
    QVERIFY(scope().visibleRange().from < 3.998 && scope().visibleRange().to > 3.998);
}

void TestScopeCursors::withoutAnActiveCursorArrowsMoveThePicture()
{
    key(Qt::Key_C);
    const auto before = cursors().pair();
    key(Qt::Key_Right);
    QVERIFY(scope().visibleRange().from > 0.0);
    QCOMPARE(cursors().pair().a, before.a);
    m_rig->mouseLeaves();
    key(Qt::Key_1);
    key(Qt::Key_C);
    key(Qt::Key_Left); // hidden cursors are not moved
    QVERIFY(std::abs(scope().visibleRange().from) < 1e-9);
}

void TestScopeCursors::aCursorIsDragged()
{
    key(Qt::Key_C);
    cursors().move(CursorEnd::A, 1.0);
    cursors().move(CursorEnd::B, 3.0);
    m_rig->drag(m_rig->at(1.0), m_rig->at(2.0));
    QVERIFY(std::abs(cursors().pair().a - 2.0) < 0.01);
    QVERIFY(cursors().active() == CursorEnd::A);
    QCOMPARE(cursors().pair().b, 3.0);
    QCOMPARE(scope().visibleRange().from, 0.0); // the picture did not move with it
    m_rig->drag(m_rig->at(2.5), m_rig->at(2.4)); // beside a cursor it is the picture again
    QVERIFY(scope().visibleRange().from > 0.0);
    QVERIFY(!cursors().active());
}

void TestScopeCursors::severalPairsKeepTheirNamesAndPlaces()
{
    key(Qt::Key_C);
    cursors().move(CursorEnd::A, 1.0);
    auto *pairs = m_rig->find<QComboBox>("cursorPair");
    pairs->lineEdit()->selectAll();
    QTest::keyClicks(pairs->lineEdit(), QStringLiteral("Rise"));
    QTest::keyClick(pairs->lineEdit(), Qt::Key_Return);
    QTest::mouseClick(m_rig->find<QToolButton>("addCursorPair"), Qt::LeftButton);
    QCOMPARE(pairs->count(), 2);
    QCOMPARE(cursors().current(), 1);
    QVERIFY(cursors().pair().a != 1.0);
    pairs->setCurrentIndex(0);
    Q_EMIT pairs->activated(0);
    QCOMPARE(cursors().pair().name, QStringLiteral("Rise"));
    QCOMPARE(cursors().pair().a, 1.0);
    QTest::mouseClick(m_rig->find<QToolButton>("removeCursorPair"), Qt::LeftButton);
    QCOMPARE(pairs->count(), 1);
    QVERIFY(cursors().pair().name != QStringLiteral("Rise"));
    QVERIFY(!m_rig->find<QToolButton>("removeCursorPair")->isEnabled());
    for (int i = 0; i < 20; ++i)
        cursors().addPair(0.0, 1.0);
    QCOMPARE(int(cursors().pairs().size()), widgets::Cursors::kMostPairs);
    QVERIFY(!m_rig->find<QToolButton>("addCursorPair")->isEnabled());
}

void TestScopeCursors::theTableGoesToTheClipboard()
{
    key(Qt::Key_C);
    cursors().move(CursorEnd::A, 1.0);
    cursors().move(CursorEnd::B, 1.5);
    QTest::mouseClick(m_rig->find<QToolButton>("copyCursors"), Qt::LeftButton);
    QCOMPARE(QApplication::clipboard()->text(),
        QStringLiteral("Pair 1\tTime\tI_A\tI_B\n"
                       "A\t1.000000\u2009s\t1000\u00a0A\t20\u00a0A\n"
                       "B\t1.500000\u2009s\t1500\u00a0A\t20\u00a0A\n"
                       "\u0394\t500.0000\u2009ms\t500\u00a0A\t0\u00a0A\n"
                       "1/\u0394t\t2.0000\u00a0Hz\n"));
}

void TestScopeCursors::zoomAndClearLeaveTheTimesAlone()
{
    key(Qt::Key_C);
    const auto before = cursors().pair();
    scope().time().zoom(4.0);
    scope().time().pan(0.3);
    m_rig->workbench.signalPlan().clear();
    m_rig->draw();
    QCOMPARE(cursors().pair().a, before.a);
    QCOMPARE(cursors().pair().b, before.b);
    QCOMPARE(cell(0, 1), QStringLiteral("no sample"));
}

void TestScopeCursors::theCursorsAreDrawn()
{
    const auto pictureOf = [this] { return m_rig->plot().grab().toImage(); };
    key(Qt::Key_C);
    cursors().move(CursorEnd::A, 100.0);
    cursors().move(CursorEnd::B, 101.0);
    m_rig->draw();
    const QImage without = pictureOf();
    cursors().move(CursorEnd::A, 1.0);
    cursors().move(CursorEnd::B, 3.0);
    const quint64 redraws = scope().redraws();
    const QImage with = pictureOf();
    const auto changedRows = [&](double seconds) {
        const int at = m_rig->at(seconds).x();
        int rows = 0;
        for (int y = 0; y < with.height(); ++y) {
            bool changed = false; // a line between two columns may be in either
            for (int x = at - 1; x <= at + 1; ++x)
                changed = changed || with.pixel(x, y) != without.pixel(x, y);
            rows += changed ? 1 : 0;
        }
        return rows;
    };
    const int height = scope().plotRect(0).height();
    QVERIFY(changedRows(1.0) > height * 9 / 10); // whole
    QVERIFY(changedRows(3.0) > height / 2);
    QVERIFY(changedRows(3.5) == 0);
    cursors().move(CursorEnd::A, 3.5);
    QCoreApplication::processEvents();
    QCOMPARE(scope().redraws(), redraws); // no trace is drawn anew for it
}

void TestScopeCursors::keysDoNothingWhileTextIsTyped()
{
    key(Qt::Key_C);
    auto *name = m_rig->find<QComboBox>("cursorPair")->lineEdit();
    name->setFocus();
    name->selectAll();
    QTest::keyClicks(name, QStringLiteral("c12"));
    QVERIFY(cursors().visible());
    QVERIFY(!cursors().active());
    QCOMPARE(name->text(), QStringLiteral("c12"));
}

void TestScopeCursors::theTableIsAModel()
{
    key(Qt::Key_C);
    auto *model = m_rig->find<QTableView>("cursorTable")->model();
    QAbstractItemModelTester tester(model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model->rowCount(), 3);
    QCOMPARE(model->columnCount(), 3);
    QSignalSpy changes(model, &QAbstractItemModel::dataChanged);
    cursors().move(CursorEnd::A, 2.0);
    QCOMPARE(changes.size(), 1);
    m_rig->draw(); // nothing new to tell
    QCOMPARE(changes.size(), 1);
    scope().removeChannel(m_rig->id(facts::kCurrentB));
    m_rig->draw();
    QCOMPARE(model->columnCount(), 2);
    QCOMPARE(model->headerData(1, Qt::Horizontal).toString(), QStringLiteral("I_A"));
}

void TestScopeCursors::timesAndInversesAreExact()
{
    const QLocale locale = QLocale::c();
    QCOMPARE(widgets::exactTime(0.0, locale), QStringLiteral("0.0\u2009\u00b5s"));
    QCOMPARE(widgets::exactTime(-62.5e-6, locale), QStringLiteral("\u221262.5\u2009\u00b5s"));
    QCOMPARE(widgets::exactTime(0.01875, locale), QStringLiteral("18.7500\u2009ms"));
    QCOMPARE(widgets::spanTime(0.016, locale), QStringLiteral("16.0\u2009ms"));
    QCOMPARE(widgets::spanTime(0.35249, locale), QStringLiteral("352\u2009ms"));
    QCOMPARE(widgets::spanTime(1.23456, locale), QStringLiteral("1.23\u2009s"));
    QCOMPARE(widgets::spanTime(0.0, locale), QStringLiteral("0.0\u2009ms"));
    QCOMPARE(widgets::exactTime(12.3456789, locale), QStringLiteral("12.345679\u2009s"));
    QCOMPARE(widgets::inverseTime(0.0, locale), QStringLiteral("\u2013"));
    QCOMPARE(widgets::inverseTime(-62.5e-6, locale), QStringLiteral("16.000\u00a0kHz"));
    QCOMPARE(
        widgets::readingText({}, 0.1, QStringLiteral("A"), locale), QStringLiteral("no sample"));
    QCOMPARE(widgets::readingText(-1.25, 0.01, QStringLiteral("A"), locale),
        QStringLiteral("\u22121.25\u00a0A"));
}

QTEST_MAIN(TestScopeCursors)
#include "tst_scope_cursors.moc"
