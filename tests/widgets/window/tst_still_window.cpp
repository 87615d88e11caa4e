// Nothing that one could be about to click changes its place while messages, faults, stops and recordings come and go.
#include "support/still_places.h"
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/base/look/theme.h"
#include "widgets/control/state_strip.h"
#include "widgets/control/stop_alarm.h"
#include "widgets/registers/model.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/scope/view.h"
#include "widgets/window/first_steps.h"

#include <QAction>
#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTranslator>
#include <QTreeView>

#include <cstdlib>

using drive::LinkReason;
using drive::LinkState;
using drive::MotorState;
using drive::StopWord;

namespace {

constexpr std::uint32_t kReference = 0x98, kTorque = 0x8D0, kPower = 0x5A8, kHeat = 0x5D0,
                        kMode = 0x42, kGain = 0x148;

/// A board that tells all that the panels have a place for.
drive::Identified boardWith(int motors)
{
    using namespace catalog;
    drive::Identified board = facts::identified();
    const auto add = [](std::uint32_t id, const char *name, ValueType type, const char *unit) {
        RegisterInfo info = facts::makeRegister(id, name, "Measurements");
        info.type = type;
        info.unit = unit;
        return info;
    };
    std::vector<RegisterInfo> registers = board.catalog->registers();
    registers.push_back(add(kReference, "SPEED_REF", ValueType::S32, "rpm"));
    registers.push_back(add(kTorque, "I_Q_MEAS", ValueType::S16, ""));
    registers.back().quantity = Quantity::Current;
    registers.back().streaming = Streaming::Fast;
    registers.push_back(add(kPower, "MOTOR_POWER", ValueType::F32, "W"));
    registers.push_back(add(kHeat, "HEATS_TEMP", ValueType::S16, "\u00b0C"));
    registers.push_back(add(kMode, "CONTROL_MODE", ValueType::U8, ""));
    registers.push_back(add(kGain, "SPEED_KI", ValueType::S16, ""));
    registers.back().access = Access::ReadWrite;
    registers.back().effect = Effect::Kept;
    Scales scales;
    scales.ampsPerDigit = 0.002;
    board.catalog =
        std::make_shared<const Catalog>(std::move(registers), 1, std::vector<Scales>{scales});
    board.identity.motors = motors;
    board.limits.resize(std::size_t(motors), board.limits.front());
    board.requestBytes = board.responseBytes = 128;
    board.streamBytes = 2048;
    return board;
}

drive::MotorStatus named(MotorState state, const char *name)
{
    drive::MotorStatus status = facts::status(state);
    status.stateName = name;
    return status;
}

} // namespace

class TestStillWindow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void cleanup()
    {
        if (m_rig)
            device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
        QCoreApplication::removeTranslator(&m_german);
    }

    void nothingMoves_data()
    {
        QTest::addColumn<Happening>("happening");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("german");
        QTest::addColumn<QString>("tool"); // that is open below the scope; empty: none
        const std::pair<const char *, Happening> all[] = {
            {"messages", &TestStillWindow::messages},
            {"armed", &TestStillWindow::armed},
            {"run", &TestStillWindow::run},
            {"faults", &TestStillWindow::faults},
            {"stop", &TestStillWindow::stop},
            {"stops of two motors", &TestStillWindow::stopsOfTwoMotors},
            {"stop not confirmed", &TestStillWindow::stopNotConfirmed},
            {"hiccup of the link", &TestStillWindow::hiccup},
            {"link lost", &TestStillWindow::linkLost},
            {"board reset", &TestStillWindow::boardReset},
            {"recording", &TestStillWindow::recording},
            {"trigger", &TestStillWindow::trigger},
            {"values", &TestStillWindow::values},
            {"counters", &TestStillWindow::counters},
            {"polled signals", &TestStillWindow::polledSignals},
            {"picture held", &TestStillWindow::pictureHeld},
            {"first steps", &TestStillWindow::firstSteps},
            {"an edit, then the link lost", &TestStillWindow::editThenLinkLost},
        };
        for (const auto &[name, happening] : all) {
            QTest::addRow("%s", name) << happening << QSize(1280, 720) << false << QString();
            QTest::addRow("%s, German", name) << happening << QSize(1280, 720) << true << QString();
            QTest::addRow("%s, small", name) << happening << QSize(960, 600) << false << QString();
            QTest::addRow("%s, small and German", name)
                << happening << QSize(960, 600) << true << QString();
        }
        const auto beside = [](const char *name, Happening happening, const char *tool) {
            QTest::addRow("%s", name)
                << happening << QSize(1280, 720) << true << QString::fromLatin1(tool);
        };
        beside("faults, listed", &TestStillWindow::faults, "eventDock");
        beside("trigger, with a spectrum", &TestStillWindow::trigger, "spectrumDock");
        beside("link lost, with what was read", &TestStillWindow::linkLost, "motorDock");
    }
    void nothingMoves()
    {
        QFETCH(Happening, happening);
        QFETCH(QSize, size);
        QFETCH(bool, german);
        QFETCH(QString, tool);
        if (german) {
            QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
            QCoreApplication::installTranslator(&m_german);
        }
        open(size, happening == &TestStillWindow::stopsOfTwoMotors ? 2 : 1,
            happening == &TestStillWindow::firstSteps);
        QCOMPARE(m_rig->window.size(), size);
        if (!tool.isEmpty()) {
            m_rig->find<QAction>(qPrintable(tool + QStringLiteral("Open")))->trigger();
            settle();
            remember();
        }
        (this->*happening)();
        QVERIFY(m_steps > 0);
        QVERIFY2(m_moved.isEmpty(), qPrintable(m_moved));
    }

    void messagesLieOverThePicture()
    {
        open();
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
            QCOMPARE(m_places->moved(), QString());
            m_rig->window.resize(1100, 700); // it goes along
            settle();
            QCOMPARE(banner->width(), plot->width());
            const auto belowTheLegend = [&] {
                const auto *scope = m_rig->window.scope();
                return QPoint(plot->mapTo(&m_rig->window, QPoint()).x(),
                    scope->mapTo(&m_rig->window, scope->plotRect(0).topLeft()).y());
            };
            QTRY_COMPARE(banner->pos(), belowTheLegend());
            auto *dock = m_rig->find<QDockWidget>("registerDock");
            dock->hide(); // the picture is elsewhere now
            settle();
            QTRY_COMPARE(banner->pos(), belowTheLegend());
            dock->show();
            settle();
            m_rig->window.resize(1280, 720);
            settle();
            QVERIFY(banner->isVisible());
            const QImage with = m_rig->window.scope()->grab().toImage();
            banner->clear();
            QVERIFY(with == m_rig->window.scope()->grab().toImage()); // no picture has it
            QCOMPARE(m_places->moved(), QString());
        }
    }

    void nothingMovesWhenBoardsComeAndGo_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("german");
        QTest::addRow("large") << QSize(1280, 720) << false;
        QTest::addRow("large, German") << QSize(1280, 720) << true;
        QTest::addRow("small") << QSize(960, 600) << false;
        QTest::addRow("small and German") << QSize(960, 600) << true;
    }
    /// What is about a board, in the panel and around the picture; the traces and their chips come with it.
    void nothingMovesWhenBoardsComeAndGo()
    {
        QFETCH(QSize, size);
        QFETCH(bool, german);
        if (german) {
            QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
            QCoreApplication::installTranslator(&m_german);
        }
        widgets::Settings settings;
        settings.firstStepsDone = true;
        show(settings, size);
        m_rig->workbench.setSessionClock([] { return TimePoint{}; });
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        settle();
        // The line at the bottom is only read, and begins with what is connected; the chips of traces take a part of
        // the picture, as the traces do.
        remember({QStringLiteral("scope"), QStringLiteral("scopePlot"),
            QStringLiteral("channelStrip"), QStringLiteral("statusStrip")});
        drive::Identified plain = facts::identified(); // tells little of itself
        plain.capabilities = {{drive::Feature::PositionRamp, false, "no position"},
            {drive::Feature::TorqueRamp, false, "no torque"}};
        plain.states.clear();
        drive::Identified mute = boardWith(1); // no limit, and its scale has to be told
        mute.limits.front() = {};
        for (const drive::Identified &board : {boardWith(1), plain, boardWith(2), mute}) {
            session::Endpoint endpoint;
            endpoint.kind = session::Endpoint::Kind::Serial;
            endpoint.path = QStringLiteral("/dev/ttyACM0");
            endpoint.baud = 1843200;
            device().open(endpoint);
            look(QStringLiteral("opening"));
            device().portChanged(session::PortState::Open, {});
            look(QStringLiteral("open"));
            tell({drive::LinkChanged{LinkState::Connecting, LinkReason::None}}, "connecting");
            tell({drive::LinkChanged{LinkState::Connected, LinkReason::None}}, "connected");
            tell({board}, "met");
            tell({named(MotorState::Idle, "IDLE")}, "idle");
            device().close();
            device().portChanged(session::PortState::Closed, {});
            tell({drive::LinkChanged{LinkState::Closed, LinkReason::None}}, "closed");
            QVERIFY(!m_rig->find<widgets::StateStrip>("stateStrip")->isVisible());
        }
        QVERIFY2(m_moved.isEmpty(), qPrintable(m_moved));
    }

    /// The real session in its thread, all that a board tells while its motor is started, turns and stops.
    void nothingMovesWhileASimulatedMotorRuns()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->sayYesToMotion();
        m_rig->window.resize(1280, 720);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_COMPARE(m_rig->window.scope()->channels().size(), 4);
        QTRY_VERIFY(device().statusIsNow(1));
        settle();
        remember();
        connect(&m_rig->workbench, &widgets::Workbench::heartbeat, this,
            [this] { note(QStringLiteral("a heartbeat")); });
        QTest::keyClick(m_rig->find<QCheckBox>("arm"), Qt::Key_Space);
        QTRY_VERIFY(m_rig->find<QPushButton>("start")->isEnabled());
        look(QStringLiteral("armed"));
        QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(device().status(1).state, MotorState::Running, 15000);
        look(QStringLiteral("runs"));
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QTRY_COMPARE_WITH_TIMEOUT(device().status(1).state, MotorState::Idle, 5000);
        look(QStringLiteral("stopped"));
        QVERIFY(m_steps > 5);
        QVERIFY2(m_moved.isEmpty(), qPrintable(m_moved));
    }

    /// What it covers stays readable: a message has the colours of the theme that is on.
    void aMessageFollowsTheTheme()
    {
        open();
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

    void cardsWithoutTheirPlaceYetHaveNoHeight()
    {
        QTest::failOnWarning(QRegularExpression(QStringLiteral("egative")));
        widgets::Device device;
        QWidget around;
        around.resize(800, 700);
        widgets::FirstSteps cards(device, &around);
        cards.resize(160, 30);
        cards.restart();
        around.show();
        QVERIFY(QTest::qWaitForWindowExposed(&around));
        cards.resize(700, 30);
        QTRY_VERIFY(cards.height() > 30 && cards.height() < 200);
    }

    void aMenuInTheDarkShowsItsBoxes()
    {
        widgets::applyTheme(widgets::Theme::Dark);
        QMenu menu;
        menu.addAction(QStringLiteral("Grid"))->setCheckable(true);
        menu.addAction(QStringLiteral("Grid"))->setEnabled(false);
        menu.popup(QPoint(100, 100));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        const QRect entry = menu.actionGeometry(menu.actions().first());
        const QRect off = menu.actionGeometry(menu.actions().last());
        const QImage seen = menu.grab().toImage();
        menu.close();
        widgets::applyTheme(widgets::Theme::Light);
        const int ground = qGray(seen.pixel(entry.right() - 4, entry.center().y()));
        int edge = 0; // pixels of the box, which stands before the words
        for (int x = entry.left() + 2; x < entry.left() + 20; ++x)
            for (int y = entry.top(); y <= entry.bottom(); ++y)
                edge += std::abs(qGray(seen.pixel(x, y)) - ground) > 24 ? 1 : 0;
        QVERIFY2(edge > 20, qPrintable(QString::number(edge)));
        const auto brightest = [&seen](const QRect &words) {
            int most = 0; // behind the place of a box
            for (int x = words.left() + 24; x < words.right(); ++x)
                for (int y = words.top(); y <= words.bottom(); ++y)
                    most = std::max(most, qGray(seen.pixel(x, y)));
            return most;
        };
        // An entry that can be chosen is told from one that cannot, and that can still be read.
        QVERIFY2(brightest(entry) > brightest(off) + 40 && brightest(off) > ground + 40,
            qPrintable(QStringLiteral("%1 %2 on %3")
                           .arg(brightest(entry))
                           .arg(brightest(off))
                           .arg(ground)));
    }

    /// Whatever stands below the scope: a window that grew would have its Stop beside the screen.
    void noToolMakesALowScreensWindowLarger()
    {
        QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
        QCoreApplication::installTranslator(&m_german);
        open({960, 515});
        m_rig->window.showWithin({976, 563}); // with a frame around it
        m_rig->window.finishTools();
        int tools = 0;
        for (QDockWidget *dock : m_rig->window.findChildren<QDockWidget *>()) {
            const QByteArray name = dock->objectName().toLatin1() + "Open";
            auto *action = m_rig->window.findChild<QAction *>(QString::fromLatin1(name));
            if (action == nullptr)
                continue;
            ++tools;
            action->trigger();
            settle();
            QVERIFY2(m_rig->window.size() == QSize(960, 515), name.constData());
            const auto *own =
                dock->findChild<QWidget *>(dock->objectName() + QStringLiteral("Stop"));
            QVERIFY2(
                dock->isFloating() && own->isVisible() && dock->height() <= 515, name.constData());
            const auto *stop = m_rig->find<QWidget>("stop");
            QCOMPARE(stop->visibleRegion().boundingRect().size(), stop->size());
            dock->close();
        }
        QVERIFY(tools >= 12);
    }

    void everyToolLeavesTheScopeItsPlots()
    {
        open({1280, 720});
        m_rig->window.finishTools();
        int tools = 0;
        for (QDockWidget *dock : m_rig->window.findChildren<QDockWidget *>()) {
            auto *action =
                m_rig->window.findChild<QAction *>(dock->objectName() + QStringLiteral("Open"));
            if (action == nullptr)
                continue;
            ++tools;
            action->trigger();
            settle();
            QVERIFY(!dock->isFloating());
            const int height = m_rig->find<QWidget>("scopePlot")->height();
            QVERIFY2(height >= 150,
                qPrintable(dock->objectName() + QLatin1Char(' ') + QString::number(height)));
            dock->close();
        }
        QVERIFY(tools >= 12);
    }

    void toolsBesideOneAnotherKeepTheWindowSmall_data() { theWholeWindowFitsALowScreen_data(); }

    /// 1280 x 720 with a title bar, and every tool as a tab beside the others: the window may not ask for more than
    /// there is.
    void toolsBesideOneAnotherKeepTheWindowSmall()
    {
        QFETCH(const bool, german);
        if (german) {
            QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
            QCoreApplication::installTranslator(&m_german);
        }
        const QSize room(1280, 695);
        open(room);
        m_rig->window.finishTools();
        QStringList tall;
        for (QDockWidget *dock : m_rig->window.findChildren<QDockWidget *>()) {
            auto *action =
                m_rig->window.findChild<QAction *>(dock->objectName() + QStringLiteral("Open"));
            if (action == nullptr)
                continue;
            action->trigger();
            settle();
            tall.append(QStringLiteral("%1 %2 %3")
                            .arg(dock->objectName())
                            .arg(dock->minimumSizeHint().height())
                            .arg(m_rig->window.minimumSizeHint().height()));
        }
        QVERIFY2(m_rig->window.minimumSizeHint().height() <= room.height(),
            qPrintable(tall.join(QStringLiteral("; "))));
        QCOMPARE(m_rig->window.size(), room);
    }

    /// 1920 x 1080 at a scale of 2, with a title bar.
    void theWholeWindowFitsALowScreen_data()
    {
        QTest::addColumn<bool>("german");
        QTest::newRow("English") << false;
        QTest::newRow("German") << true;
    }
    void theWholeWindowFitsALowScreen()
    {
        QFETCH(const bool, german);
        if (german) {
            QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
            QCoreApplication::installTranslator(&m_german);
        }
        open({960, 515});
        QCOMPARE(m_rig->window.size(), QSize(960, 515));
        for (const char *name : {"stop", "start", "speed", "SPEED_MEAS"})
            QVERIFY2(!m_rig->find<QWidget>(name)->visibleRegion().isEmpty(), name);
        // Names that can be read go before raw numbers, which come back with the room.
        const auto *tree = m_rig->find<QTreeView>("registerTree");
        const auto hasRaw = [tree] {
            return !tree->isColumnHidden(widgets::RegisterModel::RawColumn);
        };
        QVERIFY(!hasRaw());
        QVERIFY(tree->columnWidth(widgets::RegisterModel::NameColumn) >= 120);
        QVERIFY(m_rig->window.settings().registerColumns.contains(QStringLiteral("raw")));
        m_rig->window.resize(1280, 720);
        settle();
        m_rig->window.resizeDocks(
            {m_rig->find<QDockWidget>("registerDock")}, {300}, Qt::Horizontal);
        QTRY_VERIFY(hasRaw());
    }

    /// At 200 % a screen of 1920 has 960.
    void nothingLiesOverItsNeighbourInANarrowWindow_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("german");
        for (const bool german : {false, true})
            for (const QSize size : {QSize(960, 540), QSize(1280, 720)})
                QTest::addRow("%d, %s", size.width(), german ? "German" : "English")
                    << size << german;
    }
    void nothingLiesOverItsNeighbourInANarrowWindow()
    {
        QFETCH(const QSize, size);
        QFETCH(const bool, german);
        if (german) {
            QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de")));
            QCoreApplication::installTranslator(&m_german);
        }
        open(size, 2);
        for (const QBoxLayout *layout : m_rig->window.findChildren<QBoxLayout *>())
            for (int i = 0; i < layout->count(); ++i)
                for (int j = 0; j < i; ++j) {
                    const QWidget *one = layout->itemAt(i)->widget();
                    const QWidget *other = layout->itemAt(j)->widget();
                    if (one && other && one->isVisible() && other->isVisible())
                        QVERIFY2(!one->geometry().intersects(other->geometry()),
                            qPrintable(QStringLiteral("%1 and %2")
                                           .arg(one->objectName(), other->objectName())));
                }
        QCOMPARE(m_rig->find<QComboBox>("port")->lineEdit()->cursorPosition(), 0);
    }

    void theKeysFitSmallScreens()
    {
        open();
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
        QCOMPARE(m_rig->find<QScrollArea>("keys")->horizontalScrollBar()->maximum(), 0);
        keys->close();
    }

private:
    using Happening = void (TestStillWindow::*)();

    widgets::Device &device() { return m_rig->workbench.device(); }
    void settle()
    {
        for (int round = 0; round < 3; ++round) // a layout, and what its change asks for
            QCoreApplication::processEvents();
    }

    /// With what it does a moment after its first picture: ports that are found change the width of their list.
    void show(const widgets::Settings &settings, const QSize &size)
    {
        m_rig = std::make_unique<facts::WindowRig>(settings);
        const QSignalSpy settled(&m_rig->window, &widgets::MainWindow::settled);
        m_rig->window.resize(size);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        QTRY_VERIFY(!settled.isEmpty());
    }

    /// A window in which a board was met, and that has its layout for it.
    void open(const QSize &size = {1280, 720}, int motors = 1, bool cards = false)
    {
        widgets::Settings settings;
        settings.firstStepsDone = !cards;
        show(settings, size);
        m_rig->workbench.setSessionClock([] { return TimePoint{}; });
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        session::Endpoint endpoint;
        endpoint.kind = session::Endpoint::Kind::Serial;
        endpoint.path = QStringLiteral("/dev/ttyACM0");
        endpoint.baud = 1843200;
        device().open(endpoint);
        device().portChanged(session::PortState::Open, {});
        facts::feed(device(),
            {drive::LinkChanged{LinkState::Connected, LinkReason::None}, boardWith(motors)});
        for (int motor = 1; motor <= motors; ++motor) {
            drive::MotorStatus idle = named(MotorState::Idle, "IDLE");
            idle.motor = motor;
            facts::feed(device(), {idle});
        }
        settle();
        remember();
    }
    void remember(const QStringList &alone = {})
    {
        m_places = std::make_unique<facts::StillPlaces>(m_rig->window,
            QStringList{QStringLiteral("banner"), QStringLiteral("staleMark")} + alone);
        QVERIFY(m_places->count() > 40);
        m_moved.clear();
        m_steps = 0;
    }
    /// Looks what the last thing that happened has moved, and keeps the first that did.
    void look(const QString &what)
    {
        settle();
        note(what);
    }
    void note(const QString &what)
    {
        ++m_steps;
        if (const QString moved = m_places->moved(); m_moved.isEmpty() && !moved.isEmpty())
            m_moved = what + QStringLiteral(": ") + moved;
    }
    void tell(std::vector<drive::Event> events, const char *what)
    {
        facts::feed(device(), std::move(events));
        look(QLatin1String(what));
    }

    // What can happen; each looks after each step.
    void messages()
    {
        auto *banner = m_rig->find<widgets::Banner>("banner");
        for (const auto kind : {widgets::Banner::Kind::Note, widgets::Banner::Kind::Warning,
                 widgets::Banner::Kind::Bad}) {
            banner->say(
                kind, QStringLiteral("A sentence that needs more than one line. ").repeated(4));
            look(QStringLiteral("said"));
            banner->clear();
            look(QStringLiteral("cleared"));
        }
    }

    void armed()
    {
        for (const bool on : {true, false}) {
            device().armedChanged(on);
            look(on ? QStringLiteral("armed") : QStringLiteral("disarmed"));
        }
    }

    void run()
    {
        device().armedChanged(true);
        for (const auto &[state, name] : {std::pair(MotorState::Starting, "CHARGE_BOOT_CAP"),
                 std::pair(MotorState::Starting, "ALIGNMENT"),
                 std::pair(MotorState::Starting, "SWITCH_OVER"),
                 std::pair(MotorState::Running, "RUN"),
                 std::pair(MotorState::Stopping, "A_STATE_THAT_NO_STRIP_HAS"),
                 std::pair(MotorState::Idle, "IDLE")})
            tell({named(state, name)}, name);
        for (const int mode : {3, 4, 0})
            tell({drive::RegistersRead{{facts::reading(kMode, std::int64_t{mode})}}},
                "control mode");
    }

    void faults()
    {
        const std::vector<std::string> one{"OVER_VOLT"},
            many{"OVER_VOLT", "UNDER_VOLT", "OVER_TEMP", "START_UP", "SPEED_FDBK", "OVER_CURR",
                "SW_ERROR"};
        drive::MotorStatus fault = named(MotorState::FaultNow, "FAULT_NOW");
        fault.faultsNow = one;
        tell({fault}, "a fault");
        fault.faultsNow = many;
        tell({fault}, "many faults");
        fault.faultsPast = many;
        fault.faultsNow = {"OVER_VOLT", "UNDER_VOLT", "OVER_TEMP", "START_UP"};
        tell({fault}, "some are over");
        fault = named(MotorState::FaultOver, "FAULT_OVER");
        fault.faultsPast = many;
        tell({fault}, "all are over");
        fault.faultsPast = one;
        tell({fault}, "one is over");
        tell({named(MotorState::Idle, "IDLE")}, "acknowledged");
    }

    void stop()
    {
        tell({named(MotorState::Running, "RUN")}, "running");
        for (const StopWord last : {StopWord::Standstill, StopWord::MayCoast}) {
            for (const StopWord word :
                {StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, last})
                tell({drive::StopProgress{1, word, {}}}, "a word of a stop");
            for (const int seconds : {1, 9, 10, 100, 1000, 100000}) {
                Q_EMIT m_rig->workbench.heartbeat(widgets::Milliseconds(1000 * seconds));
                look(QStringLiteral("%1 s after a stop").arg(seconds));
            }
            tell({named(MotorState::Starting, "ALIGNMENT"), named(MotorState::Running, "RUN")},
                "running again");
        }
    }

    void stopsOfTwoMotors()
    {
        for (const StopWord last : {StopWord::Standstill, StopWord::MayCoast}) {
            for (const StopWord word :
                {StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, last})
                for (const int motor : {1, 2})
                    tell({drive::StopProgress{motor, word, {}}}, "a word of a stop");
        }
    }

    /// Neither the window, nor the alarm itself while evidence comes: a hand is on its way to its buttons.
    void stopNotConfirmed()
    {
        tell({drive::StopProgress{1, StopWord::Requested, {}}}, "requested");
        tell({drive::StopProgress{1, StopWord::NotConfirmed, {}}}, "not confirmed");
        auto *alarm = m_rig->find<widgets::StopAlarm>("stopAlarm");
        QVERIFY(alarm->isVisible());
        const auto onScreen = [](const QWidget *widget) {
            return QRect(widget->mapToGlobal(QPoint()), widget->size());
        };
        for (const char *name : {"stop", "stopMotors"}) // what stops is not to be hidden
            QVERIFY2(
                !alarm->frameGeometry().intersects(onScreen(m_rig->find<QWidget>(name))), name);
        const facts::StillPlaces places(*alarm);
        const QRect before = onScreen(alarm);
        for (const StopWord word :
            {StopWord::Accepted, StopWord::DriveIdle, StopWord::MayCoast, StopWord::Standstill}) {
            tell({drive::StopProgress{1, word, {}}}, "evidence under an alarm");
            QCOMPARE(onScreen(alarm), before);
            QCOMPARE(places.moved(), QString());
        }
        alarm->close();
        look(QStringLiteral("alarm closed"));
    }

    void hiccup()
    {
        for (const LinkState state :
            {LinkState::Suspect, LinkState::Recovering, LinkState::Connected})
            tell({drive::LinkChanged{state, LinkReason::None}}, "hiccup");
        tell({named(MotorState::Idle, "IDLE")}, "heard again");
    }

    void linkLost()
    {
        tell({named(MotorState::Running, "RUN")}, "running");
        tell({drive::LinkChanged{LinkState::Lost, LinkReason::Silence}}, "lost");
        tell({drive::LinkChanged{LinkState::Connecting, LinkReason::None}}, "looked for");
        tell({drive::LinkChanged{LinkState::Lost, LinkReason::RecoveryFailed}}, "lost again");
        session::PortError pulled;
        pulled.problem = session::PortProblem::Unplugged;
        device().portChanged(session::PortState::Closed, pulled);
        look(QStringLiteral("unplugged"));
        device().portChanged(session::PortState::Open, {});
        look(QStringLiteral("plugged in"));
        tell({drive::LinkChanged{LinkState::Connecting, LinkReason::None}}, "looked for again");
        tell({drive::LinkChanged{LinkState::Connected, LinkReason::None}, boardWith(1),
                 named(MotorState::Idle, "IDLE")},
            "back");
    }

    /// What was written could be undone until then, and that it cannot is said.
    void editThenLinkLost()
    {
        device().disconnect(SIGNAL(wishMade(drive::Wish)));
        connect(
            &device(), &widgets::Device::wishMade, this,
            [this](const drive::Wish &wish) { facts::feed(device(), answersTo(wish)); },
            Qt::QueuedConnection);
        auto &edits = m_rig->workbench.edits();
        tell({drive::RegistersRead{{facts::reading(kGain, std::int64_t{100})}}}, "read");
        device().armedChanged(true);
        look(QStringLiteral("armed"));
        m_rig->workbench.registers().setPending(kGain, std::int64_t{120});
        look(QStringLiteral("typed"));
        edits.apply();
        QTRY_VERIFY2(edits.steps().count() == 1,
            qPrintable(m_rig->find<QLabel>("editsTold")->text() + edits.applyHint()));
        look(QStringLiteral("written"));
        m_rig->workbench.registers().setPending(kGain, std::int64_t{130});
        look(QStringLiteral("typed again"));
        tell({drive::LinkChanged{LinkState::Lost, LinkReason::Silence}}, "lost");
        QCOMPARE(edits.steps().count(), 0);
        session::PortError pulled;
        pulled.problem = session::PortProblem::Unplugged;
        device().portChanged(session::PortState::Closed, pulled);
        look(QStringLiteral("unplugged"));
        device().portChanged(session::PortState::Open, {});
        tell({drive::LinkChanged{LinkState::Connected, LinkReason::None}, boardWith(1),
                 named(MotorState::Idle, "IDLE")},
            "back");
        edits.revert();
        look(QStringLiteral("reverted"));
    }
    std::vector<drive::Event> answersTo(const drive::Wish &wish)
    {
        drive::Ended ended;
        ended.id = wish.id;
        drive::RegistersRead read;
        if (const auto *asked = std::get_if<drive::Read>(&wish.what))
            for (const catalog::RegisterId id : asked->registers)
                read.readings.push_back(facts::reading(id, std::int64_t{100}));
        if (const auto *write = std::get_if<drive::Write>(&wish.what))
            for (const drive::RegisterWrite &one : write->writes) {
                ended.writes.push_back(
                    {one.id, drive::Outcome::Ok, {}, std::int64_t{100}, one.value, true});
                read.readings.push_back(facts::reading(one.id, one.value));
            }
        return {read, ended};
    }

    void boardReset()
    {
        device().armedChanged(true);
        tell({drive::LinkChanged{LinkState::Recovering, LinkReason::None}}, "recovering");
        tell({drive::LinkChanged{LinkState::Connected, LinkReason::BoardReset}}, "reset");
        tell({named(MotorState::Idle, "IDLE")}, "idle");
    }

    void recording()
    {
        QTemporaryDir folder;
        m_rig->files.answer = folder.filePath(QStringLiteral("a.pcapng"));
        auto *toggle = m_rig->find<QAction>("record");
        auto *line = m_rig->find<QWidget>("recordLine");
        toggle->trigger();
        QTRY_VERIFY(line->isVisible());
        look(QStringLiteral("recording"));
        session::RecordingProgress much;
        much.counts.bytes = 123'456'789'012;
        much.lost.samples = 123456;
        Q_EMIT m_rig->workbench.recording().progressed(much);
        look(QStringLiteral("much recorded"));
        toggle->trigger();
        QTRY_VERIFY(!line->isVisible());
        look(QStringLiteral("ended"));
    }

    void record(int count, int digits, capture::Tick &tick)
    {
        capture::SampleBlock block{1, tick, static_cast<std::uint32_t>(count), {}, {}, 0};
        for (int signal = 0; signal < 2; ++signal)
            for (int i = 0; i < count; ++i)
                block.fast.push_back(
                    static_cast<std::int16_t>((tick + i) % 100 < 50 ? digits : -digits));
        tick += count;
        facts::feed(device(), {block});
    }
    void stream()
    {
        facts::feed(device(),
            {drive::StreamStarted{capture::StreamLayout{1, 1000.0, 0.0, 1,
                {{facts::kCurrentA, "I_A", "A", 0.002, 0.0},
                    {facts::kCurrentB, "I_B", "A", 0.002, 0.0}},
                {}}}});
    }

    void trigger()
    {
        capture::Tick tick = 0;
        stream();
        record(500, 5000, tick);
        auto *control = m_rig->window.findChild<widgets::TriggerControl *>();
        widgets::TriggerSetup setup = control->trigger().setup();
        setup.mode = scope::Mode::Normal;
        setup.length = 0.2;
        setup.hysteresis = 0.001;
        setup.level = 100.0; // nothing gets there
        control->setSetup(setup); // the hand's own choice gives the bar its fields
        settle();
        remember();
        record(500, 5000, tick);
        look(QStringLiteral("armed"));
        control->trigger().force();
        record(50, 5000, tick);
        look(QStringLiteral("forced"));
        record(1000, 5000, tick);
        look(QStringLiteral("fired"));
        for (int more = 0; more < 30; ++more)
            record(500, 5000, tick);
        Q_EMIT m_rig->workbench.heartbeat(widgets::Milliseconds(100'000));
        look(QStringLiteral("an old record"));
        control->trigger().force();
        record(1000, 5000, tick);
        look(QStringLiteral("fired again"));
        m_rig->window.scope()->setRunning(false);
        look(QStringLiteral("held"));
        m_rig->window.scope()->setRunning(true);
        look(QStringLiteral("runs on"));
    }

    void values()
    {
        capture::Tick tick = 0;
        stream();
        record(500, 0, tick);
        settle();
        remember();
        for (const double value : {0.0, 9.99, -99.9, 1234.5, -12345.6}) {
            const auto whole = static_cast<std::int64_t>(value);
            record(500, int(std::abs(whole)), tick);
            tell({drive::RegistersRead{{facts::reading(facts::kSpeed, whole),
                     facts::reading(kReference, whole), facts::reading(kTorque, whole),
                     facts::reading(facts::kVoltage, std::abs(whole)),
                     facts::reading(kPower, value), facts::reading(kHeat, whole)}}},
                qPrintable(QString::number(value)));
        }
    }

    void counters()
    {
        for (const std::uint64_t count : {9ULL, 1000ULL, 123'456'789ULL, 4'000'000'000'000ULL}) {
            drive::LinkCounters counters;
            counters.streamLostTicks = counters.badPackets = count;
            counters.bytesIn = m_bytes += count;
            facts::feed(device(), {counters});
            Q_EMIT m_rig->workbench.heartbeat(widgets::Milliseconds(m_beat += 3600'000));
            look(QStringLiteral("%1 counted").arg(count));
        }
    }

    void polledSignals()
    {
        TimePoint at{};
        for (const double hz : {0.4, 3.0, 9.8, 12.0, 250.0, 3.0}) {
            std::vector<drive::Reading> readings;
            for (int i = 0; i < 5; ++i) {
                drive::Reading one = facts::reading(facts::kSpeed, std::int64_t{i});
                one.at = at +=
                    std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1.0 / hz));
                readings.push_back(one);
            }
            facts::feed(device(), {drive::RegistersRead{readings}});
            Q_EMIT m_rig->workbench.heartbeat(widgets::Milliseconds(m_beat += 3600'000));
            look(QStringLiteral("%1 a second").arg(hz));
        }
    }

    void pictureHeld()
    {
        for (const bool runs : {false, true}) {
            m_rig->window.scope()->setRunning(runs);
            look(runs ? QStringLiteral("runs") : QStringLiteral("held"));
        }
    }

    /// The cards say something else, or nothing, without a place of their own.
    void firstSteps()
    {
        const bool low = m_rig->window.height() < 720; // the scope needs the place then
        QCOMPARE(m_rig->find<QWidget>("firstSteps")->isVisible(), !low);
        tell({drive::LinkChanged{LinkState::Suspect, LinkReason::None}}, "silent");
        tell({drive::LinkChanged{LinkState::Connected, LinkReason::None},
                 named(MotorState::Idle, "IDLE")},
            "heard again");
        tell({named(MotorState::Running, "RUN")}, "running");
        tell({named(MotorState::Idle, "IDLE")}, "idle again");
    }

    std::unique_ptr<facts::WindowRig> m_rig;
    std::unique_ptr<facts::StillPlaces> m_places;
    QTranslator m_german;
    QString m_moved;
    int m_steps = 0;
    qint64 m_beat = 0;
    std::uint64_t m_bytes = 0;
};

QTEST_MAIN(TestStillWindow)
#include "tst_still_window.moc"
