#include "support/window_rig.h"
#include "widgets/base/look/theme.h"
#include "widgets/control/stop_alarm.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/time_window.h"
#include "widgets/scope/view.h"
#include "widgets/window/about_dialog.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHash>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QSet>
#include <QShortcut>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTranslator>

#include <algorithm>
#include <cmath>

namespace {

/// Of Qt's own German texts what names of keys need: they may not be installed.
class GermanKeys : public QTranslator {
public:
    bool isEmpty() const override { return false; }
    QString translate(const char *context, const char *source, const char *, int) const override
    {
        const bool ctrl = qstrcmp(context, "QShortcut") == 0 && qstrcmp(source, "Ctrl") == 0;
        return ctrl ? QStringLiteral("Strg") : QString();
    }
};

} // namespace

class TestAccessibility : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        // The first-steps card as well.
        m_rig = std::make_unique<facts::WindowRig>(widgets::Settings{});
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        facts::connectBoard(m_rig->workbench.device());
        for (const auto id : {facts::kCurrentA, facts::kSpeed})
            m_rig->window.selection()->add(id);
        QCoreApplication::processEvents();
    }
    void cleanup()
    {
        m_rig->workbench.device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
    }

    void everythingThatTakesTheFocusHasAName()
    {
        widgets::showAbout(&m_rig->window);
        widgets::showKeys(m_rig->window);
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        m_rig->find<widgets::StopAlarm>("stopAlarm")->raiseAlarm(1);
        int checked = 0;
        for (QWidget *widget : m_rig->window.findChildren<QWidget *>()) {
            if (widget->focusPolicy() == Qt::NoFocus || widget->focusProxy() || isInside(widget))
                continue;
            QAccessibleInterface *interface = QAccessible::queryAccessibleInterface(widget);
            QVERIFY(interface);
            const bool tabs = qobject_cast<QTabBar *>(widget); // Qt 6.4 tells the tabs' names only
            QVERIFY2(
                !(tabs ? widget->accessibleName() : interface->text(QAccessible::Name)).isEmpty(),
                qPrintable(QStringLiteral("%1 %2").arg(
                    QLatin1String(widget->metaObject()->className()), widget->objectName())));
            ++checked;
        }
        QVERIFY(checked > 25);
    }

    /// With each tool open in its turn: Tab alone comes by everything that can take the focus, and out again.
    void tabReachesEveryControl()
    {
        QApplication::setActiveWindow(&m_rig->window);
        m_rig->window.resize(1600, 1000);
        m_rig->window.scope()->cursorActions().toggle();
        QList<QAction *> tools{nullptr};
        for (QAction *action : m_rig->window.findChildren<QAction *>())
            if (action->objectName().endsWith(QStringLiteral("DockOpen")))
                tools.append(action);
        QVERIFY(tools.size() > 5);
        qsizetype bare = 0;
        for (QAction *tool : tools) {
            if (tool != nullptr)
                tool->trigger();
            QCoreApplication::processEvents();
            QSet<QWidget *> wanted = tabStops();
            QVERIFY(wanted.size() > (tool ? bare : 15)); // the tool's own are among them
            if (tool == nullptr)
                bare = wanted.size();
            m_rig->find<QWidget>("registerSearch")->setFocus();
            for (int i = 0; i < 400 && !wanted.isEmpty(); ++i) {
                QVERIFY(QApplication::focusWidget());
                wanted.remove(QApplication::focusWidget());
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            }
            QStringList missed;
            for (const QWidget *widget : wanted)
                missed.append(QLatin1String(widget->metaObject()->className()) + QLatin1Char(' ')
                    + widget->objectName());
            QVERIFY2(missed.isEmpty(),
                qPrintable((tool ? tool->objectName() : QStringLiteral("no tool"))
                    + QStringLiteral(": ") + missed.join(QStringLiteral(", "))));
        }
    }

    /// As one reads: what connects, then the panels at the sides, then the picture.
    void tabBeginsAtTheConnectBar()
    {
        QApplication::setActiveWindow(&m_rig->window);
        m_rig->window.resize(1600, 1000);
        QCoreApplication::processEvents();
        QList<QWidget *> stops;
        auto *first = m_rig->find<QWidget>("connectBar");
        QVERIFY(first);
        QWidget *next = &m_rig->window;
        while ((next = next->nextInFocusChain()) != &m_rig->window) {
            if (tabStops().contains(next))
                stops.append(next);
        }
        QVERIFY(stops.size() > 15);
        QVERIFY(first->isAncestorOf(stops.first()));
        const auto placeOf = [&stops](const QWidget *part) {
            const auto found = std::find_if(stops.begin(), stops.end(),
                [part](const QWidget *stop) { return part == stop || part->isAncestorOf(stop); });
            return found - stops.begin();
        };
        const QList<qsizetype> places{placeOf(first), placeOf(m_rig->find<QWidget>("stopMotors")),
            placeOf(m_rig->find<QWidget>("registerDock")),
            placeOf(m_rig->find<QWidget>("controlDock")), placeOf(m_rig->window.scope())};
        QVERIFY(std::is_sorted(places.begin(), places.end()));
        QVERIFY(places.last() < stops.size());
        QWidget *focused = stops.first(); // and the key goes that way
        focused->setFocus();
        for (int i = 0; i < 40 && QApplication::focusWidget() != m_rig->window.scope(); ++i)
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        QCOMPARE(QApplication::focusWidget(), m_rig->window.scope());
    }

    /// It is made late, and yet its place is the one that it is seen at.
    void tabGoesFromTheScopeThroughTheCursorsToTheChips()
    {
        QApplication::setActiveWindow(&m_rig->window);
        m_rig->window.resize(1600, 1000);
        m_rig->window.scope()->cursorActions().toggle();
        QCoreApplication::processEvents();
        m_rig->window.scope()->setFocus();
        QCOMPARE(QApplication::focusWidget(), m_rig->window.scope());
        QStringList order;
        while (order.size() < 100 && !order.contains(QStringLiteral("foldChips"))) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            order.append(QApplication::focusWidget()->objectName());
        }
        const QStringList first{QStringLiteral("eventLane"), QStringLiteral("cursorPair"),
            QStringLiteral("addCursorPair"), QStringLiteral("copyCursors"),
            QStringLiteral("hideCursors"), QStringLiteral("cursorTable")};
        QCOMPARE(order.mid(0, first.size()), first);
        QVERIFY(order.contains(QStringLiteral("foldChips")));
    }

    void whatCannotBePressedSaysWhy()
    {
        for (const char *name : {"start", "go", "stopRamp", "acknowledge"}) {
            const auto *button = m_rig->find<QWidget>(name);
            QVERIFY(!button->isEnabled());
            QVERIFY2(!button->toolTip().isEmpty(), name);
        }
    }

    void everyMenuHasEntriesAndNoKeyIsGivenTwice()
    {
        QList<QKeySequence> keys;
        const auto *bar = m_rig->window.menuWidget()->findChild<QMenuBar *>();
        QVERIFY(bar->actions().size() >= 6);
        for (const QAction *entry : bar->actions()) {
            QVERIFY(!entry->menu()->actions().isEmpty());
            for (const QAction *action : entry->menu()->actions())
                for (const QKeySequence &key : action->shortcuts()) {
                    QVERIFY2(!keys.contains(key), qPrintable(key.toString()));
                    keys.append(key);
                }
        }
    }

    void theKeysPageHasTheKeyOfEveryAction_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QString();
        QTest::newRow("German") << QStringLiteral("de");
    }
    /// As the menus name it, and with what they call it.
    void theKeysPageHasTheKeyOfEveryAction()
    {
        QFETCH(QString, language);
        GermanKeys ofQt;
        QTranslator translator;
        if (!language.isEmpty()) {
            QVERIFY(translator.load(QStringLiteral(":/i18n/rotorscope_") + language));
            QCoreApplication::installTranslator(&ofQt);
            QCoreApplication::installTranslator(&translator);
            cleanup();
            init();
        }
        widgets::showKeys(m_rig->window);
        QStringList words;
        for (const QLabel *label : m_rig->find<QWidget>("keys")->findChildren<QLabel *>())
            words.append(label->text());
        const QStringList keys = words.join(QStringLiteral(", ")).split(QStringLiteral(", "));
        int compared = 0;
        for (const QAction *action : m_rig->window.findChildren<QAction *>())
            for (const QKeySequence &key : action->shortcuts()) {
                const QString name = key.toString(QKeySequence::NativeText);
                const QString text = action->text().remove(QLatin1Char('&'));
                QVERIFY2(keys.contains(name), qPrintable(name + QLatin1Char(' ') + text));
                QVERIFY2(words.contains(text) || action->objectName() == QLatin1String("scopeRun"),
                    qPrintable(text));
                ++compared;
            }
        QVERIFY2(compared > 55, qPrintable(QString::number(compared)));
        QVERIFY(m_rig->window.findChildren<QShortcut *>().isEmpty()); // which no page would list
        QVERIFY(keys.contains(QStringLiteral("Esc")));
        QVERIFY(keys.contains(
            language.isEmpty() ? QStringLiteral("Ctrl+K") : QStringLiteral("Strg+K")));
    }

    /// The scope's own are taken in the whole window: a control that they move something in has them first.
    void pageAndEndKeysBelongToTheControlThatHasTheFocus()
    {
        QApplication::setActiveWindow(&m_rig->window);
        widgets::TimeWindow &time = m_rig->window.scope()->time();
        time.setFollowing(false);
        QSlider slider(&m_rig->window);
        slider.setRange(0, 100);
        slider.setValue(50);
        QSpinBox number(&m_rig->window);
        number.setRange(0, 100);
        number.setValue(50);
        QComboBox choice(&m_rig->window);
        for (int i = 0; i < 30; ++i)
            choice.addItem(QString::number(i));
        choice.setCurrentIndex(15);
        for (QWidget *control : std::initializer_list<QWidget *>{&slider, &number, &choice}) {
            control->show();
            control->setFocus();
            QTRY_VERIFY(control->hasFocus());
            QTest::keyClick(control, Qt::Key_PageDown);
            QTest::keyClick(control, Qt::Key_PageDown);
            QTest::keyClick(control, Qt::Key_PageUp);
        }
        QVERIFY(slider.value() != 50);
        QCOMPARE(number.value(), 40);
        QVERIFY(choice.currentIndex() != 15);
        for (QWidget *control : std::initializer_list<QWidget *>{&slider, &number, &choice}) {
            control->setFocus();
            QTRY_VERIFY(control->hasFocus());
            QTest::keyClick(control, Qt::Key_End);
            QVERIFY2(!time.following(), control->metaObject()->className());
        }
        QCOMPARE(choice.currentIndex(), 29);
        m_rig->window.scope()->setFocus();
        QTest::keyClick(m_rig->window.scope(), Qt::Key_End);
        QVERIFY(time.following());
    }

    void noLetterBelongsToAMenuAndAPageOrToTwoOfAPage_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QString();
        QTest::newRow("German") << QStringLiteral("de");
    }
    /// Else the key opens neither: it only goes from one to the other. With each tool open in its turn.
    void noLetterBelongsToAMenuAndAPageOrToTwoOfAPage()
    {
        QFETCH(QString, language);
        QTranslator translator;
        if (!language.isEmpty()) {
            QVERIFY(translator.load(QStringLiteral(":/i18n/rotorscope_") + language));
            QCoreApplication::installTranslator(&translator);
            cleanup();
            init();
        }
        m_rig->window.resize(1600, 1000);
        QStringList clashes;
        const QHash<QString, QStringList> menus = lettersOfMenus();
        clashesIn(menus, QStringLiteral("menu bar"), clashes);
        for (const QAction *entry : m_rig->window.menuWidget()->findChild<QMenuBar *>()->actions())
            clashesIn(lettersOf(entry->menu()->actions()), entry->text(), clashes);
        int tools = 0, letters = 0;
        QStringList docks;
        for (const QAction *tool : m_rig->window.findChildren<QAction *>())
            if (tool->objectName().endsWith(QStringLiteral("DockOpen")))
                docks.append(tool->objectName().chopped(4));
        for (QAction *tool : m_rig->window.findChildren<QAction *>()) {
            if (!tool->objectName().endsWith(QStringLiteral("DockOpen")))
                continue;
            tool->trigger();
            QCoreApplication::processEvents();
            ++tools;
            QHash<QString, QStringList> page;
            for (const QWidget *widget : m_rig->window.findChildren<QWidget *>()) {
                const QString dock = dockOf(widget);
                const bool others =
                    docks.contains(dock) && dock + QStringLiteral("Open") != tool->objectName();
                const bool seen = widget->isVisible() && !others;
                for (const QString &text : textsWithKeys(widget)) {
                    const QString key = QKeySequence::mnemonic(text).toString();
                    letters += key.isEmpty() ? 0 : 1;
                    if (!key.isEmpty() && seen)
                        page[key].append(text);
                    // What comes later, by a choice or a board, is not to take a menu's either.
                    if (menus.contains(key) && (seen || widget->window() == &m_rig->window))
                        clashes.append(QStringLiteral("%1: %2 of %3 and of the menu %4")
                                           .arg(dockOf(widget), key, text, menus[key].first()));
                }
            }
            clashesIn(page, tool->objectName(), clashes);
        }
        QVERIFY(tools > 8 && letters > 30);
        clashes.removeDuplicates();
        QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join(QLatin1Char('\n'))));
    }

    void nothingIsCutAtTheSmallestSize_data()
    {
        QTest::addColumn<int>("theme");
        QTest::addColumn<QString>("language");
        QTest::newRow("light") << int(widgets::Theme::Light) << QString();
        QTest::newRow("dark") << int(widgets::Theme::Dark) << QString();
        QTest::newRow("German") << int(widgets::Theme::Light) << QStringLiteral("de");
    }
    void nothingIsCutAtTheSmallestSize()
    {
        QFETCH(int, theme);
        QFETCH(QString, language);
        widgets::applyTheme(static_cast<widgets::Theme>(theme));
        QTranslator translator;
        QTranslator registers;
        if (!language.isEmpty()) {
            QVERIFY(translator.load(QStringLiteral(":/i18n/rotorscope_") + language));
            QVERIFY(registers.load(QStringLiteral(":/i18n/registers_") + language));
            QCoreApplication::installTranslator(&translator);
            QCoreApplication::installTranslator(&registers);
            cleanup();
            init();
        }
        m_rig->window.resize(1280, 720);
        QCoreApplication::processEvents();
        QCOMPARE(m_rig->window.size(), QSize(1280, 720));
        for (const char *name : {"port", "baud", "connect", "stopMotors", "portLamp", "boardLamp",
                 "motorState", "arm", "start", "stop", "acknowledge", "speed", "rampTime", "go",
                 "stopRamp", "fastRate", "registerSearch"}) {
            const auto *widget = m_rig->find<QWidget>(name);
            QVERIFY2(widget && widget->isVisible(), name);
            QVERIFY2(widget->width() >= widget->minimumSizeHint().width(), name);
            QVERIFY2(widget->height() >= widget->minimumSizeHint().height(), name);
            const QRect place(widget->mapTo(&m_rig->window, QPoint()), widget->size());
            QVERIFY2(m_rig->window.rect().contains(place), name);
            QVERIFY2(widget->visibleRegion().boundingRect() == widget->rect(), name);
        }
        QVERIFY(m_rig->find<QWidget>("registerTree")->width() >= 220);
        QVERIFY(m_rig->window.scope()->width() >= 400);
    }

    /// WCAG 2.1, 1.4.11: three to one against what is beside it.
    void anEmptyBoxIsSeenInBothThemes_data()
    {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << int(widgets::Theme::Light);
        QTest::newRow("dark") << int(widgets::Theme::Dark);
    }
    void anEmptyBoxIsSeenInBothThemes()
    {
        QFETCH(int, theme);
        widgets::applyTheme(static_cast<widgets::Theme>(theme));
        QCoreApplication::processEvents();
        auto *arm = m_rig->find<QCheckBox>("arm");
        QVERIFY(!arm->isChecked());
        const QImage image = arm->grab().toImage();
        const auto bright = [](const QColor &color) {
            const auto linear = [](double part) {
                return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
            };
            return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF())
                + 0.0722 * linear(color.blueF());
        };
        const double around = bright(arm->palette().color(QPalette::Window));
        double best = 1.0; // of the box alone, left of the words
        for (int x = 0; x < 16; ++x)
            for (int y = 0; y < image.height(); ++y) {
                const double edge = bright(image.pixelColor(x, y));
                best = std::max(
                    best, (std::max(edge, around) + 0.05) / (std::min(edge, around) + 0.05));
            }
        widgets::applyTheme(widgets::Theme::Light);
        QVERIFY2(best >= 3.0, qPrintable(QString::number(best)));
    }

    void theStopButtonCannotBeHidden()
    {
        m_rig->find<QWidget>("controlDock")->hide();
        m_rig->find<QWidget>("registerDock")->hide();
        QVERIFY(m_rig->find<QWidget>("stopMotors")->isVisible());
        QVERIFY(m_rig->find<QWidget>("statusMotor")->isVisible());
    }

private:
    QHash<QString, QStringList> lettersOfMenus() const
    {
        return lettersOf(m_rig->window.menuWidget()->findChild<QMenuBar *>()->actions());
    }
    static QHash<QString, QStringList> lettersOf(const QList<QAction *> &entries)
    {
        QHash<QString, QStringList> letters;
        for (const QAction *entry : entries)
            if (const QString key = QKeySequence::mnemonic(entry->text()).toString();
                !key.isEmpty())
                letters[key].append(entry->text());
        return letters;
    }
    static QString dockOf(const QWidget *widget)
    {
        for (const QWidget *one = widget; one; one = one->parentWidget())
            if (qobject_cast<const QDockWidget *>(one))
                return one->objectName();
        return QStringLiteral("the window");
    }
    static void clashesIn(
        const QHash<QString, QStringList> &letters, const QString &where, QStringList &clashes)
    {
        for (auto one = letters.begin(); one != letters.end(); ++one)
            if (one->size() > 1)
                clashes.append(QStringLiteral("%1: %2 of %3")
                                   .arg(where, one.key(), one->join(QStringLiteral(" and of "))));
    }
    /// Where an ampersand before a letter makes it a key.
    static QStringList textsWithKeys(const QWidget *widget)
    {
        QStringList texts;
        if (const auto *button = qobject_cast<const QAbstractButton *>(widget))
            texts.append(button->text());
        if (const auto *box = qobject_cast<const QGroupBox *>(widget))
            texts.append(box->title());
        if (const auto *label = qobject_cast<const QLabel *>(widget); label && label->buddy())
            texts.append(label->text());
        if (const auto *tabs = qobject_cast<const QTabBar *>(widget))
            for (int i = 0; i < tabs->count(); ++i)
                texts.append(tabs->tabText(i));
        return texts;
    }

    /// Parts of a control that take the focus for it.
    static bool isInside(const QWidget *widget)
    {
        for (const QWidget *parent = widget->parentWidget(); parent;
             parent = parent->parentWidget())
            if (parent->inherits("QAbstractSpinBox") || parent->inherits("QComboBox"))
                return true;
        return false;
    }

    /// What Tab has to come by; of buttons that exclude each other one is enough, the arrows do the rest.
    QSet<QWidget *> tabStops() const
    {
        QSet<QWidget *> stops;
        for (QWidget *widget : m_rig->window.findChildren<QWidget *>()) {
            const auto *button = qobject_cast<QAbstractButton *>(widget);
            const bool oneOfMany = button != nullptr && !button->isChecked()
                && (button->autoExclusive() || (button->group() && button->group()->exclusive()));
            const bool acts = button != nullptr || qobject_cast<QComboBox *>(widget)
                || (qobject_cast<QAbstractItemView *>(widget)
                    && !qobject_cast<QHeaderView *>(widget))
                || qobject_cast<QLineEdit *>(widget);
            if ((acts || (widget->focusPolicy() & Qt::TabFocus)) && widget->isVisible()
                && widget->isEnabled() && !widget->focusProxy() && !widget->isWindow()
                && !isInside(widget) && !oneOfMany
                && !widget->objectName().startsWith(QStringLiteral("qt_"))) // a menu does the same
                stops.insert(widget);
        }
        return stops;
    }

    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestAccessibility)
#include "tst_accessibility.moc"
