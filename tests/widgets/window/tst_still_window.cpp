// Nothing that one could be about to click changes its place while messages, faults, stops and recordings come and go.
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/base/theme.h"
#include "widgets/scope/scope_view.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScreen>
#include <QTemporaryDir>

#include <cstdlib>
#include <map>

using drive::MotorState;
using drive::StopWord;

class TestStillWindow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->window.resize(1280, 720);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->workbench.setSessionClock([] { return TimePoint{}; });
        facts::connectBoard(device());
        facts::feed(device(), {facts::status(MotorState::Idle)});
        settle();
        m_before = places();
        QVERIFY(m_before.size() > 25);
    }
    void cleanup()
    {
        device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
    }

    void messagesLieOverThePicture()
    {
        for (const auto kind : {widgets::Banner::Kind::Note, widgets::Banner::Kind::Warning,
                 widgets::Banner::Kind::Bad}) {
            auto *banner = m_rig->find<widgets::Banner>("banner");
            banner->say(kind,
                QStringLiteral("A sentence that needs more than one line where there is little "
                               "room. ")
                    .repeated(4));
            QVERIFY(banner->isVisible());
            const auto *plot = m_rig->find<QWidget>("scopePlot");
            const QRect picture(plot->mapTo(&m_rig->window, QPoint()), plot->size());
            QVERIFY(picture.contains(banner->geometry()));
            const auto *text = m_rig->find<QLabel>("bannerText");
            QVERIFY(text->height() >= text->heightForWidth(text->width()));
            QCOMPARE(moved(), QString());
            m_rig->window.resize(1100, 700); // it goes along
            settle();
            QCOMPARE(banner->width(), plot->width());
            QCOMPARE(banner->pos(), plot->mapTo(&m_rig->window, QPoint()));
            auto *dock = m_rig->find<QDockWidget>("registerDock");
            dock->hide(); // the picture is elsewhere now
            settle();
            QCOMPARE(banner->pos(), plot->mapTo(&m_rig->window, QPoint()));
            dock->show();
            settle();
            m_rig->window.resize(1280, 720);
            settle();
            QVERIFY(banner->isVisible());
            const QImage with = m_rig->window.scope()->grab().toImage();
            banner->clear();
            QVERIFY(with == m_rig->window.scope()->grab().toImage()); // no picture has it
            QCOMPARE(moved(), QString());
        }
    }

    void faultsComeAndGo()
    {
        drive::MotorStatus fault = facts::status(MotorState::FaultNow);
        fault.faultsNow = {"OVER_VOLT"};
        facts::feed(device(), {fault});
        QCOMPARE(moved(), QString());
        fault.state = MotorState::FaultOver;
        fault.faultsNow.clear();
        fault.faultsPast = {"OVER_VOLT"};
        facts::feed(device(), {fault});
        QCOMPARE(moved(), QString());
        facts::feed(device(), {facts::status(MotorState::Idle)});
        QCOMPARE(moved(), QString());
    }

    void armingRunningAndStopping()
    {
        device().armedChanged(true);
        QCOMPARE(moved(), QString());
        for (const MotorState state : {MotorState::Starting, MotorState::Running})
            facts::feed(device(), {facts::status(state)});
        QCOMPARE(moved(), QString());
        for (const StopWord word :
            {StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, StopWord::Standstill}) {
            facts::feed(device(), {drive::StopProgress{1, word, {}}});
            QCOMPARE(moved(), QString());
        }
        device().armedChanged(false);
        facts::feed(device(), {facts::status(MotorState::Idle)});
        QCOMPARE(moved(), QString());
    }

    void armingARealBoard()
    {
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = QStringLiteral("/a/board");
        device().open(endpoint);
        facts::connectBoard(device());
        settle();
        m_before = places();
        for (const bool armed : {true, false}) {
            device().armedChanged(armed);
            QCOMPARE(moved(), QString());
        }
    }

    void recordingsBeginAndEnd()
    {
        QTemporaryDir folder;
        m_rig->files.answer = folder.filePath(QStringLiteral("a.pcapng"));
        auto *toggle = m_rig->find<QAction>("record");
        auto *line = m_rig->find<QWidget>("recordLine");
        toggle->trigger();
        QTRY_VERIFY(line->isVisible());
        QCOMPARE(moved(), QString());
        toggle->trigger();
        QTRY_VERIFY(!line->isVisible());
        QCOMPARE(moved(), QString());
    }

    /// What it covers stays readable: a message has the colours of the theme that is on.
    void aMessageFollowsTheTheme()
    {
        auto *banner = m_rig->find<widgets::Banner>("banner");
        widgets::applyTheme(widgets::Theme::Light);
        banner->say(widgets::Banner::Kind::Warning, QStringLiteral("Look."));
        widgets::applyTheme(widgets::Theme::Dark);
        settle();
        const QColor then = banner->palette().color(QPalette::Window);
        banner->say(widgets::Banner::Kind::Warning, QStringLiteral("Look."));
        const QColor fresh = banner->palette().color(QPalette::Window);
        banner->clear();
        widgets::applyTheme(widgets::Theme::Light);
        QCOMPARE(then, fresh);
        QVERIFY(then.lightness() < 128);
    }

    void aMenuInTheDarkShowsItsBoxes()
    {
        widgets::applyTheme(widgets::Theme::Dark);
        QMenu menu;
        menu.addAction(QStringLiteral("Grid"))->setCheckable(true);
        menu.popup(QPoint(100, 100));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        const QRect entry = menu.actionGeometry(menu.actions().first());
        const QImage seen = menu.grab().toImage();
        menu.close();
        widgets::applyTheme(widgets::Theme::Light);
        const int ground = qGray(seen.pixel(entry.right() - 4, entry.center().y()));
        int edge = 0; // pixels of the box, which stands before the words
        for (int x = entry.left() + 2; x < entry.left() + 20; ++x)
            for (int y = entry.top(); y <= entry.bottom(); ++y)
                edge += std::abs(qGray(seen.pixel(x, y)) - ground) > 24 ? 1 : 0;
        QVERIFY2(edge > 20, qPrintable(QString::number(edge)));
    }

    void theKeysFitSmallScreens()
    {
        for (QAction *action : m_rig->window.findChildren<QAction *>())
            if (action->shortcut() == QKeySequence(Qt::Key_F1))
                action->trigger();
        QTRY_VERIFY(m_rig->find<QWidget>("keys") && m_rig->find<QWidget>("keys")->isVisible());
        QWidget *keys = m_rig->find<QWidget>("keys")->window();
        settle();
        const QSize room = keys->screen()->availableSize();
        QVERIFY2(
            keys->height() < room.height() * 9 / 10, qPrintable(QString::number(keys->height())));
        QVERIFY2(keys->width() < room.width(), qPrintable(QString::number(keys->width())));
        keys->close();
    }

    void aHiccupOfTheLink()
    {
        using drive::LinkReason;
        using drive::LinkState;
        for (const LinkState state :
            {LinkState::Suspect, LinkState::Recovering, LinkState::Connected}) {
            facts::feed(device(), {drive::LinkChanged{state, LinkReason::None}});
            QCOMPARE(moved(), QString());
        }
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    void settle()
    {
        for (int round = 0; round < 3; ++round) // a layout, and what its change asks for
            QCoreApplication::processEvents();
    }
    /// What can be clicked or typed into, but for the message itself.
    std::map<QString, QRect> places()
    {
        std::map<QString, QRect> found;
        const auto *banner = m_rig->find<QWidget>("banner");
        for (const QWidget *widget : m_rig->window.findChildren<QWidget *>()) {
            const bool used = qobject_cast<const QAbstractButton *>(widget)
                || qobject_cast<const QLineEdit *>(widget)
                || qobject_cast<const QComboBox *>(widget)
                || qobject_cast<const QAbstractItemView *>(widget)
                || widget->objectName() == QLatin1String("scopePlot");
            if (used && !widget->objectName().isEmpty() && widget->isVisible()
                && widget->window() == &m_rig->window && !banner->isAncestorOf(widget))
                found[widget->objectName()] =
                    QRect(widget->mapTo(&m_rig->window, QPoint()), widget->size());
        }
        return found;
    }
    /// The first one that is elsewhere, in words. What comes or goes itself is none of it.
    QString moved()
    {
        settle();
        const auto now = places();
        for (const auto &[name, place] : m_before) {
            const auto at = now.find(name);
            if (at != now.end() && at->second.topLeft() != place.topLeft())
                return QStringLiteral("%1 from %2,%3 to %4,%5")
                    .arg(name, QString::number(place.x()), QString::number(place.y()),
                        QString::number(at->second.x()), QString::number(at->second.y()));
        }
        return {};
    }

    std::unique_ptr<facts::WindowRig> m_rig;
    std::map<QString, QRect> m_before;
};

QTEST_MAIN(TestStillWindow)
#include "tst_still_window.moc"
