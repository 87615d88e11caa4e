// Colours that the user gives traces, through the menus of the real window; they are remembered by the signal's name.
#include "support/scope_window.h"
#include "widgets/base/trace_colors.h"
#include "widgets/scope/colors.h"
#include "widgets/scope/signals/selection.h"

#include <QContextMenuEvent>
#include <QMenu>
#include <QToolButton>

class TestTraceColor : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { open(facts::WindowRig::quietSettings()); }
    void cleanup() { m_rig.reset(); }

    void theMenuOfThePlotsGivesAColour()
    {
        const QColor other = m_rig->scope().colorOf(m_rig->id(facts::kCurrentB));
        QCOMPARE(choose(QStringLiteral("I_A"), 4), true);
        QCOMPARE(color(), widgets::traceColor(4, dark()));
        QCOMPARE(m_rig->scope().colorOf(m_rig->id(facts::kCurrentB)), other);
        QCOMPARE(m_rig->window.settings().workspace.traceColors,
            (QMap<QString, int>{{QStringLiteral("I_A"), 4}}));
        QVERIFY(choose(QStringLiteral("I_A"), -1)); // by itself again
        QCOMPARE(color(), widgets::traceColor(0, dark()));
        QVERIFY(m_rig->window.settings().workspace.traceColors.isEmpty());
    }

    void byItselfATraceGetsTheColourItHad()
    {
        QCOMPARE(color(), widgets::traceColor(0, dark()));
        QVERIFY(choose(QStringLiteral("I_A"), 0)); // the very one that it has by itself
        QVERIFY(choose(QStringLiteral("I_A"), -1));
        QCOMPARE(color(), widgets::traceColor(0, dark()));
    }

    /// Before its first sample a signal has a chip, and no channel.
    void aSignalThatIsNotDrawnYetCanBeGivenAColour()
    {
        m_rig->window.selection()->add(facts::kSpeed);
        QVERIFY(!m_rig->workbench.capture().find(facts::kSpeed));
        QMenu menu;
        m_rig->window.selection()->fillColors(menu, facts::kSpeed);
        QCOMPARE(menu.actions().size(), widgets::kTraceColors + 2);
        QVERIFY(menu.actions().last()->isChecked());
        menu.actions().at(3)->trigger();
        QCOMPARE(m_rig->window.settings().workspace.traceColors.value(
                     m_rig->window.selection()->nameOf(facts::kSpeed), -1),
            3);
        QMenu again;
        m_rig->window.selection()->fillColors(again, facts::kSpeed);
        QVERIFY(again.actions().at(3)->isChecked());
    }

    void theChosenOneIsMarkedAndNamed()
    {
        QVERIFY(choose(QStringLiteral("I_A"), 2));
        QMenu menu;
        m_rig->scope().colors().fill(menu, m_rig->id(facts::kCurrentA));
        QCOMPARE(menu.actions().size(), widgets::kTraceColors + 2);
        for (int slot = 0; slot < widgets::kTraceColors; ++slot) {
            QCOMPARE(menu.actions()[slot]->isChecked(), slot == 2);
            QVERIFY(menu.actions()[slot]->text().size() > 4);
        }
        QVERIFY(!menu.actions().last()->isChecked());
    }

    void theMenuKeyOnAChipOpensItsMenu()
    {
        auto *chip = m_rig->find<QWidget>("chip_I_A");
        QVERIFY(chip);
        auto *tag = chip->findChild<QToolButton *>();
        QContextMenuEvent event(QContextMenuEvent::Keyboard, tag->rect().center(),
            tag->mapToGlobal(tag->rect().center()));
        QApplication::sendEvent(tag, &event);
        auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
        QVERIFY(menu);
        QMenu *colors = menu->actions().last()->menu();
        QVERIFY(colors);
        Q_EMIT colors->aboutToShow();
        colors->actions().at(5)->trigger();
        menu->close();
        QCOMPARE(color(), widgets::traceColor(5, dark()));
        // The chip is made anew in its colour.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        const QImage image = m_rig->find<QWidget>("chip_I_A")->grab().toImage();
        const qreal scale = image.devicePixelRatio();
        QCOMPARE(
            image.pixelColor(int(11 * scale), image.height() / 2), widgets::traceColor(5, dark()));
    }

    void itIsRemembered()
    {
        QVERIFY(choose(QStringLiteral("I_B"), 6));
        const widgets::Settings settings =
            widgets::settingsFromJson(widgets::toJson(m_rig->window.settings()));
        m_rig.reset();
        open(settings);
        QCOMPARE(
            m_rig->scope().colorOf(m_rig->id(facts::kCurrentB)), widgets::traceColor(6, dark()));
    }

    /// One of a signal that is not shown makes room; what is seen keeps its colour.
    void aFullListTakesAnotherColour()
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.workspace.traceColors[QStringLiteral("I_B")] = 6;
        for (int i = 0; settings.workspace.traceColors.size() < 500; ++i)
            settings.workspace.traceColors[QStringLiteral("Board %1").arg(i)] =
                i % widgets::kTraceColors;
        m_rig.reset();
        open(settings);
        QVERIFY(choose(QStringLiteral("I_A"), 4));
        QCOMPARE(color(), widgets::traceColor(4, dark()));
        const QMap<QString, int> now = m_rig->window.settings().workspace.traceColors;
        QCOMPARE(now.size(), 500);
        QCOMPARE(now.value(QStringLiteral("I_A"), -1), 4);
        QCOMPARE(now.value(QStringLiteral("I_B"), -1), 6);
        QVERIFY(choose(QStringLiteral("I_A"), -1)); // none of the others
        QCOMPARE(m_rig->window.settings().workspace.traceColors.size(), 499);
    }

    void slotsThatAreNoneAreLeftOut()
    {
        const auto settings = widgets::settingsFromJson(
            R"({"workspace": {"traceColors": {"A": 8, "B": -1, "C": "red", "D": 7}}})");
        QCOMPARE(settings.workspace.traceColors, (QMap<QString, int>{{QStringLiteral("D"), 7}}));
    }

private:
    void open(const widgets::Settings &settings)
    {
        m_rig = std::make_unique<facts::ScopeWindow>(settings);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(100, [](int, int tick) { return tick; });
        m_rig->draw();
    }
    bool dark() { return widgets::isDark(m_rig->scope().palette()); }
    QColor color() { return m_rig->scope().colorOf(m_rig->id(facts::kCurrentA)); }

    /// By the menu that the menu key opens; -1: by itself.
    bool choose(const QString &name, int slot)
    {
        m_rig->scope().setFocus();
        QTest::keyClick(&m_rig->scope(), Qt::Key_Menu);
        auto *menu = m_rig->find<QMenu>("scopeMenu");
        bool chosen = false;
        for (const QAction *trace : menu ? menu->actions() : QList<QAction *>())
            for (const QAction *entry : trace->text() == name && trace->menu()
                    ? trace->menu()->actions()
                    : QList<QAction *>())
                if (entry->text() == QLatin1String("&Colour")) {
                    const auto colors = entry->menu()->actions();
                    (slot < 0 ? colors.last() : colors.at(slot))->trigger();
                    chosen = true;
                }
        delete menu;
        m_rig->draw();
        return chosen;
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

QTEST_MAIN(TestTraceColor)
#include "tst_trace_color.moc"
