// Room for the plots at 1280 x 720, in German: one line for the trigger, and the chips fold while cursors and a tool
// are open.
#include "support/scope_window.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/signals/channel_strip.h"
#include "widgets/scope/trigger/control.h"

#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>
#include <QTranslator>

class TestScopeRoom : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
        QCoreApplication::installTranslator(&m_german);
    }
    void cleanupTestCase() { QCoreApplication::removeTranslator(&m_german); }
    void init()
    {
        QLocale::setDefault(QLocale(QLocale::German));
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(4000, [](int, int tick) { return tick % 100 < 50 ? -50 : 50; });
        m_rig->window.resize(1280, 720);
        m_rig->draw();
        QCOMPARE(m_rig->window.size(), QSize(1280, 720));
    }
    void cleanup() { m_rig.reset(); }

    void theTriggerTakesOneLineInGerman()
    {
        auto *trigger = m_rig->window.findChild<widgets::TriggerControl *>();
        widgets::TriggerSetup setup = trigger->trigger().setup();
        setup.mode = scope::Mode::Auto;
        setup.level = 0.0;
        setup.hysteresis = 1.0;
        setup.length = 0.05;
        trigger->setSetup(setup);
        m_rig->record(1000, [](int, int tick) { return tick % 100 < 50 ? -50 : 50; });
        m_rig->draw();
        QVERIFY(trigger->shown());
        const auto *bar = m_rig->find<QWidget>("triggerBar");
        QVERIFY2(m_rig->find<QLabel>("triggerState")->text().contains(QStringLiteral(" \u00b7 ")),
            qPrintable(m_rig->find<QLabel>("triggerState")->text()));
        const auto middleOf = [&](const char *name) {
            const auto *field = m_rig->find<QWidget>(name);
            return field->mapTo(bar, field->rect().center()).y();
        };
        for (const char *name :
            {"triggerForce", "triggerType", "triggerSource", "triggerLevel", "triggerMore"}) {
            QTRY_VERIFY2(std::abs(middleOf(name) - middleOf("triggerMode")) < 5, name);
            QVERIFY2(bar->width() >= m_rig->find<QWidget>(name)->mapTo(bar, QPoint()).x(), name);
        }
    }

    void theChipsFoldWhileCursorsAndAToolAreOpen()
    {
        auto *fold = m_rig->find<QToolButton>("foldChips");
        m_rig->scope().cursorActions().toggle();
        m_rig->draw();
        QVERIFY(!folded()); // there is room
        m_rig->find<QAction>("measureDockOpen")->trigger();
        m_rig->draw();
        QTRY_VERIFY(folded());
        QVERIFY(fold->text().contains(QStringLiteral("3 Signale")));
        for (int plot = 0; plot < m_rig->scope().plotCount(); ++plot)
            QTRY_VERIFY(m_rig->scope().plotRect(plot).height() >= 75);
        QTest::mouseClick(fold, Qt::LeftButton); // the user has the last word
        m_rig->draw();
        QVERIFY(!folded());
        m_rig->scope().cursorActions().toggle();
        m_rig->scope().cursorActions().toggle();
        m_rig->draw();
        QVERIFY(folded()); // until it is as new
        m_rig->scope().cursorActions().toggle();
        QTRY_VERIFY(!folded());
    }

    void chipsThatAPersonFoldedStayFolded()
    {
        auto *fold = m_rig->find<QToolButton>("foldChips");
        QTest::mouseClick(fold, Qt::LeftButton);
        QVERIFY(folded());
        m_rig->scope().cursorActions().toggle();
        m_rig->find<QAction>("measureDockOpen")->trigger();
        m_rig->draw();
        QVERIFY(folded());
        m_rig->scope().cursorActions().toggle();
        m_rig->draw();
        QVERIFY(folded());
        QTest::mouseClick(fold, Qt::LeftButton);
        QVERIFY(!folded());
    }

    void columnsThatFitNeedNoScrollBar()
    {
        m_rig->scope().cursorActions().toggle();
        m_rig->draw();
        const auto *table = m_rig->find<QTableView>("cursorTable");
        QTRY_VERIFY(table->isVisible());
        QCOMPARE(table->horizontalScrollBar()->maximum(), 0);
        const int line = table->verticalHeader()->defaultSectionSize();
        QVERIFY(table->height() < 5 * line);
    }

private:
    /// What the button of the chips says.
    bool folded() { return !m_rig->find<QToolButton>("foldChips")->text().startsWith(u'\u25be'); }

    QTranslator m_german;
    std::unique_ptr<facts::ScopeWindow> m_rig;
};

QTEST_MAIN(TestScopeRoom)
#include "tst_scope_room.moc"
