// What is under the mouse: the values of the traces there, and what can be done with a trace by a right click.
#include "support/scope_window.h"
#include "widgets/measuring/measure_panel.h"
#include "widgets/scope/trigger/control.h"

#include <QComboBox>
#include <QMenu>
#include <QTreeView>

class TestTraceMenu : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void init()
    {
        m_rig = std::make_unique<facts::ScopeWindow>();
        m_rig->window.resize(1280, 720);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(3000, [](int, int tick) { return tick / 1000; });
        m_rig->draw();
    }
    void cleanup() { m_rig.reset(); }

    void theMouseReadsTheTraces()
    {
        auto *hover = m_rig->find<QWidget>("scopeHover");
        QVERIFY(!hover->isVisible());
        m_rig->moveMouse(m_rig->at(1.5));
        QVERIFY(hover->isVisible());
        const QImage there = hover->grab().toImage();
        m_rig->moveMouse(m_rig->at(2.5));
        QVERIFY(hover->grab().toImage() != there);
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&m_rig->plot(), &leave);
        QVERIFY(!hover->isVisible());
    }

    void itDoesNotStandInTheWayOfADrag()
    {
        auto *hover = m_rig->find<QWidget>("scopeHover");
        m_rig->moveMouse(m_rig->at(1.5));
        QVERIFY(hover->isVisible());
        QTest::mousePress(&m_rig->plot(), Qt::LeftButton, {}, m_rig->at(1.5));
        QVERIFY(!hover->isVisible());
        m_rig->moveMouse(m_rig->at(1.7), Qt::LeftButton);
        QVERIFY(!hover->isVisible());
        QTest::mouseRelease(&m_rig->plot(), Qt::LeftButton, {}, m_rig->at(1.7));
    }

    void aStepResponseIsMeasuredByOneEntry()
    {
        entry({QStringLiteral("I_A"), QStringLiteral("&Measure"), QStringLiteral("&Step response")})
            ->trigger();
        auto *list = m_rig->find<QTreeView>("measureList");
        QVERIFY(list->isVisible());
        QCOMPARE(list->model()->rowCount(), 4);
        for (int row = 0; row < 4; ++row)
            QCOMPARE(list->model()->index(row, 0).data().toString(), QStringLiteral("I_A"));
        entry({QStringLiteral("I_B"), QStringLiteral("&Measure"), QStringLiteral("RMS")})
            ->trigger();
        QCOMPARE(list->model()->rowCount(), 5);
    }

    void itIsTriggeredOn()
    {
        entry({QStringLiteral("I_B"), QStringLiteral("&Trigger on it")})->trigger();
        const widgets::Trigger &trigger = m_rig->workbench.trigger();
        QCOMPARE(trigger.source()->name, std::string("I_B"));
        QVERIFY(trigger.setup().mode == scope::Mode::Auto);
        widgets::TriggerSetup setup = trigger.setup();
        setup.type = widgets::TriggerType::Fault; // has no source
        m_rig->workbench.trigger().setSetup(setup);
        entry({QStringLiteral("I_A"), QStringLiteral("&Trigger on it")})->trigger();
        QCOMPARE(trigger.source()->name, std::string("I_A"));
        QVERIFY(trigger.setup().type == widgets::TriggerType::Edge);
    }

    void itsSpectrumAndItsXyPictureAreShown()
    {
        entry({QStringLiteral("I_B"), QStringLiteral("&Spectrum")})->trigger();
        auto *trace = m_rig->find<QComboBox>("spectrumTrace");
        QVERIFY(trace->isVisible());
        QCOMPARE(trace->currentText(), QStringLiteral("I_B"));
        entry({QStringLiteral("I_B"), QStringLiteral("&XY, upward")})->trigger();
        auto *upward = m_rig->find<QComboBox>("xyY");
        QVERIFY(upward->isVisible());
        QCOMPARE(upward->currentText(), QStringLiteral("I_B"));
    }

private:
    /// By the menu that the menu key opens.
    QAction *entry(const QStringList &path)
    {
        delete m_rig->find<QMenu>("scopeMenu");
        m_rig->scope().setFocus();
        QTest::keyClick(&m_rig->scope(), Qt::Key_Menu);
        QMenu *menu = m_rig->find<QMenu>("scopeMenu");
        QAction *found = nullptr;
        for (const QString &text : path) {
            found = nullptr;
            for (QAction *action : menu ? menu->actions() : QList<QAction *>())
                if (action->text() == text)
                    found = action;
            menu = found ? found->menu() : nullptr;
        }
        if (!found)
            qCritical() << "no such entry" << path;
        return found;
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

QTEST_MAIN(TestTraceMenu)
#include "tst_trace_menu.moc"
