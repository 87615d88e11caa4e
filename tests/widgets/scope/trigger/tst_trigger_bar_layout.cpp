// The trigger bar has its place in the window, in every language, and keeps it while the state changes.
#include "support/trigger_test.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QTranslator>

using scope::AcquisitionState;
using widgets::TriggerType;

class TestTriggerBarLayout : public facts::TriggerTest {
    Q_OBJECT
private Q_SLOTS:
    void init() { open(); }
    void cleanup() { m_rig.reset(); }

    void theBarFits();
    void anEdgeTakesOneLine();
    void longWordsTakeTwoLines();
    void aChangingStateMovesNothing();
};

void TestTriggerBarLayout::theBarFits()
{
    normal();
    setup([](TriggerSetup &setup) { setup.type = TriggerType::RegisterWrite; });
    setup([](TriggerSetup &setup) { setup.type = TriggerType::Slew; });
    square(500);
    m_rig->window.resize(1280, 720);
    m_rig->draw();
    QCOMPARE(m_rig->window.width(), 1280);
    auto *bar = m_rig->find<QWidget>("triggerBar");
    const QLabel *state = m_rig->find<QLabel>("triggerState");
    QVERIFY(bar->rect().contains(state->geometry()));
    QVERIFY2(bar->minimumSizeHint().width() <= bar->width(),
        qPrintable(QString::number(bar->minimumSizeHint().width())));
}

void TestTriggerBarLayout::anEdgeTakesOneLine()
{
    normal();
    square(500);
    m_rig->window.resize(1280, 720);
    m_rig->draw();
    const auto *bar = m_rig->find<QWidget>("triggerBar");
    const auto lineOf = [&](const char *name) {
        return m_rig->find<QWidget>(name)->mapTo(bar, QPoint()).y();
    };
    for (const char *name : {"triggerSource", "triggerLevel", "triggerMore"})
        QVERIFY2(std::abs(lineOf(name) - lineOf("triggerMode")) < 8, name);
    // A long word is whole in the list though the box is narrow.
    auto *type = m_rig->find<QComboBox>("triggerType");
    type->showPopup();
    QVERIFY(type->view()->width() > type->width());
    QVERIFY(type->view()->width() >= type->view()->sizeHintForColumn(0));
    type->hidePopup();
}

void TestTriggerBarLayout::longWordsTakeTwoLines()
{
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/i18n/rotorscope_de")));
    QCoreApplication::installTranslator(&german);
    m_rig.reset();
    init();
    normal();
    square(500);
    const auto *bar = m_rig->find<QWidget>("triggerBar");
    const auto *level = m_rig->find<QWidget>("triggerLevel");
    const auto *mode = m_rig->find<QWidget>("triggerMode");
    // It never makes the window wider than the screen.
    QVERIFY2(bar->minimumSizeHint().width() < 400,
        qPrintable(QString::number(bar->minimumSizeHint().width())));
    m_rig->window.resize(m_rig->window.minimumSizeHint());
    m_rig->draw();
    QVERIFY(m_rig->window.width() <= 1280);
    for (const QWidget *field : {level, mode}) // the bar grows at the next turn of the loop
        QTRY_VERIFY(bar->rect().contains(QRect(field->mapTo(bar, QPoint()), field->size())));
    QVERIFY(level->mapTo(bar, QPoint()).y() > mode->mapTo(bar, QPoint()).y());
}

/// Neither the trigger's state, which changes many times a second, nor a picture that is held.
void TestTriggerBarLayout::aChangingStateMovesNothing()
{
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/i18n/rotorscope_de")));
    QCoreApplication::installTranslator(&german);
    m_rig.reset();
    init();
    m_rig->window.resize(1280, 720);
    normal(10.0); // a record that takes its time
    flat(500);
    const auto *more = m_rig->find<QWidget>("triggerMore");
    const auto places = [&] {
        m_rig->draw();
        QCoreApplication::sendPostedEvents();
        QCoreApplication::processEvents();
        return QList<int>{more->mapTo(&m_rig->window, QPoint()).x(), view().plotRect(0).height()};
    };
    QVERIFY(control().trigger().state() == AcquisitionState::Armed);
    control().trigger().force();
    square(100);
    QVERIFY(control().trigger().state() == AcquisitionState::Triggered);
    const QList<int> triggered = places();
    view().setRunning(false);
    QVERIFY(control().trigger().state() == AcquisitionState::Stop);
    QCOMPARE(places(), triggered);
    setup([](TriggerSetup &setup) { setup.length = 0.02; });
    view().setRunning(true);
    square(500);
    flat(100);
    QVERIFY(control().trigger().state() == AcquisitionState::Armed);
    QCOMPARE(places(), triggered);
}

QTEST_MAIN(TestTriggerBarLayout)
#include "tst_trigger_bar_layout.moc"
