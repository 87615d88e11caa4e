// A tool in a window of its own: Stop is in it, and Esc works in it.
#include "support/window_rig.h"
#include "widgets/control/motor_button.h"

#include <QDockWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QTabBar>
#include <QTabWidget>

class TestToolDocks : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->find<QAction>("gainsDockOpen")->trigger();
        m_dock = m_rig->find<QDockWidget>("gainsDock");
        m_stop = m_rig->find<widgets::StopButton>("gainsDockStop");
    }
    void cleanup() { m_rig.reset(); }

    void aFloatingToolHasAStopButton()
    {
        QSignalSpy stops(&m_rig->workbench.device(), &widgets::Device::stopWished);
        QVERIFY(!m_stop->isVisible()); // the window's own is there
        m_dock->setFloating(true);
        QVERIFY(QTest::qWaitForWindowExposed(m_dock));
        QVERIFY(m_dock->isWindow() && m_stop->isVisible());
        QTest::mousePress(m_stop, Qt::LeftButton);
        QCOMPARE(stops.size(), 1);
        QTest::mouseRelease(m_stop, Qt::LeftButton);
        m_dock->setFloating(false);
        QVERIFY(!m_stop->isVisible());
    }

    void escStopsInIt()
    {
        QSignalSpy stops(&m_rig->workbench.device(), &widgets::Device::stopWished);
        m_dock->setFloating(true);
        QVERIFY(QTest::qWaitForWindowExposed(m_dock));
        QTest::keyClick(m_dock->windowHandle(), Qt::Key_Escape);
        QCOMPARE(stops.size(), 1);
        QVERIFY(m_dock->isVisible()); // it is no dialog that Esc closes
    }

    /// On a small screen the page scrolls, and what it is for does not.
    void thePreviewOfTheGainLabIsSeenOnASmallScreen()
    {
        for (const QSize size : {QSize(1280, 720), QSize(960, 600)}) {
            m_rig->window.resize(size);
            QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
            auto *pages = m_rig->find<QTabWidget>("gainPages");
            pages->setCurrentIndex(1);
            for (const char *name : {"labPreview", "labFromBoard", "applyEdits"}) {
                auto *button = m_dock->findChild<QPushButton *>(QLatin1String(name));
                QTRY_VERIFY2(button->isVisible()
                        && button->visibleRegion().boundingRect().size() == button->size(),
                    name);
                const QRect place(button->mapTo(&m_rig->window, QPoint()), button->size());
                QVERIFY2(m_rig->window.rect().contains(place), name);
            }
            pages->setCurrentIndex(0);
            QVERIFY(!m_rig->find<QPushButton>("labPreview")->isVisible());
        }
    }

    /// At 200 % of 1920x1080 there is no room in the window: a tool stands before it, as high as what is in it, beside
    /// the control panel if it is narrow enough. The next one takes its place.
    void onATinyScreenToolsTakeOnePlaceInTurns()
    {
        m_dock->close();
        m_rig->window.resize(960, 540);
        m_rig->window.showWithin({976, 560});
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        const auto opened = [this](const char *name) {
            m_rig->find<QAction>((QByteArray(name) + "Open").constData())->trigger();
            return m_rig->find<QDockWidget>(name);
        };
        QVERIFY(opened("gainsDock")->isFloating());
        QCOMPARE(m_dock->pos().x(), m_rig->window.geometry().left());
        const auto *table = m_dock->findChild<QWidget *>(QStringLiteral("gainTable"));
        QVERIFY2(table->height() - table->sizeHint().height() < 24, "half of it is empty");
        QCOMPARE(table->visibleRegion().boundingRect().height(), table->height());
        QDockWidget *events = opened("eventDock");
        QVERIFY(m_dock->isHidden() && events->isFloating() && !events->isHidden());
        const auto *control = m_rig->find<QWidget>("controlPanel");
        const QRect panel(control->mapToGlobal(QPoint()), control->size());
        QVERIFY2(!events->geometry().intersects(panel), "the control panel is covered");
        events->move(events->pos() - QPoint(0, 100)); // where the user wants it: it stays
        opened("gainsDock");
        QVERIFY(!m_dock->isHidden() && !events->isHidden());
    }

    void oneEntryClosesAllThatAreOpen()
    {
        QAction *close = nullptr;
        for (const QMenu *menu : m_rig->window.findChildren<QMenu *>())
            for (QAction *entry : menu->actions())
                if (entry->objectName() == QLatin1String("closeTools"))
                    close = entry;
        if (close == nullptr)
            QFAIL("no such entry");
        const auto open = [this] {
            int count = 0;
            for (const QDockWidget *dock : m_rig->window.findChildren<QDockWidget *>())
                count +=
                    m_rig->find<QAction>((dock->objectName() + QStringLiteral("Open")).toLatin1())
                        != nullptr
                    && !dock->isHidden();
            return count;
        };
        m_rig->find<QAction>("eventDockOpen")->trigger();
        m_rig->find<QAction>("measureDockOpen")->trigger();
        m_rig->find<QDockWidget>("eventDock")->setFloating(true);
        QCOMPARE(open(), 3);
        QVERIFY(close->isEnabled());
        close->trigger();
        QCOMPARE(open(), 0);
        QVERIFY(!close->isEnabled());
    }

    /// Their tabs scroll.
    void namesOfManyToolsAreNotCut()
    {
        m_rig->window.resize(1280, 720);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        for (const char *name :
            {"eventDockOpen", "recordDockOpen", "measureDockOpen", "spectrumDockOpen",
                "mathDockOpen", "xyDockOpen", "snapshotsDockOpen", "revUpDockOpen", "rampDockOpen",
                "motorDockOpen", "notesDockOpen", "motionLogDockOpen", "stepDockOpen",
                "identifyDockOpen", "responseDockOpen", "tourDockOpen", "runBookDockOpen"})
            m_rig->find<QAction>(name)->trigger();
        QTabBar *tabs = nullptr;
        for (auto *bar :
            m_rig->window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly))
            if (bar->isVisible() && bar->count() > 10)
                tabs = bar;
        if (tabs == nullptr)
            QFAIL("the tools have no tabs");
        for (int i = 0; i < tabs->count(); ++i) {
            tabs->setCurrentIndex(i);
            const QString name = tabs->tabText(i);
            QTRY_VERIFY2(tabs->tabRect(i).width() > tabs->fontMetrics().horizontalAdvance(name),
                qPrintable(name));
            QVERIFY2(tabs->rect().contains(tabs->tabRect(i).center()), qPrintable(name));
        }
    }

    void everyToolCanFloatAndEachHasItsStop()
    {
        m_rig->window.finishTools();
        int tools = 0;
        for (QDockWidget *dock : m_rig->window.findChildren<QDockWidget *>()) {
            if (!(dock->features() & QDockWidget::DockWidgetFloatable))
                continue;
            ++tools;
            QVERIFY2(dock->findChild<widgets::StopButton *>(), qPrintable(dock->objectName()));
        }
        QVERIFY(tools >= 12);
    }

private:
    std::unique_ptr<facts::WindowRig> m_rig;
    QDockWidget *m_dock = nullptr;
    widgets::StopButton *m_stop = nullptr;
};

QTEST_MAIN(TestToolDocks)
#include "tst_tool_docks.moc"
