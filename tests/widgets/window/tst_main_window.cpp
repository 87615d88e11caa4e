#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/base/flow_layout.h"
#include "widgets/base/form.h"
#include "widgets/base/lamp.h"
#include "widgets/control/big_numbers.h"
#include "widgets/control/readout_box.h"
#include "widgets/scope/drawing/stale_mark.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/first_steps.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QWheelEvent>

using drive::LinkReason;
using drive::LinkState;
using widgets::Lamp;

class TestMainWindow : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        // The session is left out: what it would be asked is seen here, what it would say is fed by hand.
        device().disconnect(SIGNAL(openWished(session::Endpoint)));
        device().disconnect(SIGNAL(closeWished()));
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        facts::connectBoard(device());
    }
    void cleanup()
    {
        device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
    }

    void aTypedPortIsInTheListTheNextTime()
    {
        device().portChanged(session::PortState::Closed, {});
        auto *connect = m_rig->find<QPushButton>("connect");
        QTest::mouseClick(connect, Qt::LeftButton); // no longer wanted
        m_rig->find<QComboBox>("port")->setEditText(QStringLiteral("/a/board"));
        QTest::mouseClick(connect, Qt::LeftButton);
        const widgets::Settings kept = m_rig->window.settings();
        QCOMPARE(kept.typedPorts, QStringList{QStringLiteral("/a/board")});
        const facts::WindowRig next(kept);
        QVERIFY(next.find<QComboBox>("port")->findData(QStringLiteral("/a/board")) >= 0);
    }

    /// A simulated board of the older protocol has its own; what was chosen comes back, and is what is kept.
    void theSpeedInUseIsShownWhileItIs()
    {
        device().portChanged(session::PortState::Closed, {});
        auto *connect = m_rig->find<QPushButton>("connect");
        QTest::mouseClick(connect, Qt::LeftButton); // no longer wanted
        widgets::ConnectBar &bar = *m_rig->window.connectBar();
        bar.setEndpoint(QStringLiteral("sim:legacy"), 921600);
        const auto *baud = m_rig->find<QComboBox>("baud");
        QTest::mouseClick(connect, Qt::LeftButton);
        QCOMPARE(baud->currentText(), QStringLiteral("115200"));
        QCOMPARE(device().endpoint().baud, 115200U);
        bar.refreshPorts();
        QCOMPARE(baud->currentText(), QStringLiteral("115200"));
        QCOMPARE(m_rig->window.settings().baud, 921600U);
        QTest::mouseClick(connect, Qt::LeftButton);
        QCOMPARE(baud->currentText(), QStringLiteral("921600"));
    }

    void theSpeedOfALineHasItsUnit()
    {
        device().portChanged(session::PortState::Closed, {});
        auto *connect = m_rig->find<QPushButton>("connect");
        QTest::mouseClick(connect, Qt::LeftButton); // no longer wanted
        m_rig->window.connectBar()->setEndpoint(QStringLiteral("sim"), 1'843'200);
        QTest::mouseClick(connect, Qt::LeftButton);
        device().portChanged(session::PortState::Open, {});
        QCOMPARE(m_rig->find<QWidget>("statusStrip")->findChild<Lamp *>()->text(),
            QStringLiteral("simulated board @ 1843200\u202fbaud"));
    }

    void anSpiDeviceHasAClockAndNoChoiceOfProtocols()
    {
        device().portChanged(session::PortState::Closed, {});
        auto *connect = m_rig->find<QPushButton>("connect");
        QTest::mouseClick(connect, Qt::LeftButton); // no longer wanted
        widgets::ConnectBar &bar = *m_rig->window.connectBar();
        const auto *rate = m_rig->find<QComboBox>("baud");
        const auto *protocol = m_rig->find<QComboBox>("protocol");
        bar.setProtocol(QStringLiteral("mcp"));
        QCOMPARE(rate->accessibleName(), QStringLiteral("Baud rate"));
        bar.setEndpoint(QStringLiteral("/dev/spidev9.9"), 20'000'000);
        QCOMPARE(rate->accessibleName(), QStringLiteral("Clock [Hz]"));
        QCOMPARE(rate->currentText(), QStringLiteral("20000000"));
        QCOMPARE(bar.baud(), 20'000'000U);
        QVERIFY(!protocol->isEnabled());
        QTest::mouseClick(connect, Qt::LeftButton);
        QVERIFY(device().endpoint().protocol == drive::Protocol::Mcb);
        QCOMPARE(device().endpoint().baud, 20'000'000U);
        device().portChanged(session::PortState::Open, {});
        const auto *link = m_rig->find<QWidget>("statusStrip")->findChild<Lamp *>();
        QCOMPARE(link->text(), QStringLiteral("/dev/spidev9.9 @ 20000000\u202fHz"));
        device().portChanged(session::PortState::Closed, {});
        QTest::mouseClick(connect, Qt::LeftButton);
        bar.setEndpoint(QStringLiteral("/dev/ttyACM9"), 0);
        QCOMPARE(rate->accessibleName(), QStringLiteral("Baud rate"));
        QCOMPARE(bar.baud(), 0U); // no serial port is so fast
        QVERIFY(protocol->isEnabled());
    }

    void aBoardWithoutABaudRateShowsNone()
    {
        device().portChanged(session::PortState::Closed, {});
        auto *connect = m_rig->find<QPushButton>("connect");
        QTest::mouseClick(connect, Qt::LeftButton); // no longer wanted
        widgets::ConnectBar &bar = *m_rig->window.connectBar();
        auto *rate = m_rig->find<QComboBox>("baud");
        rate->setEditText(QStringLiteral("none"));
        bar.setEndpoint(QStringLiteral("sim:mcb"), 0);
        QVERIFY(rate->isHidden());
        QTest::mouseClick(connect, Qt::LeftButton);
        QCOMPARE(device().endpoint().path, QStringLiteral("sim:mcb"));
        device().portChanged(session::PortState::Open, {});
        QCOMPARE(m_rig->find<QWidget>("statusStrip")->findChild<Lamp *>()->text(),
            QStringLiteral("simulated board"));
        device().portChanged(session::PortState::Closed, {});
        QTest::mouseClick(connect, Qt::LeftButton);
        QVERIFY(rate->isHidden());
        bar.setEndpoint(QStringLiteral("sim"), 921600);
        QVERIFY(!rate->isHidden());
    }

    void whereTheScreenHasNoRoomForItItTakesAllThereIs_data()
    {
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<bool>("fills");
        QTest::newRow("large") << QSize(1920, 1080) << false;
        QTest::newRow("low") << QSize(1920, 720) << true;
        QTest::newRow("narrow") << QSize(1280, 1080) << true;
        QTest::newRow("at 200 %, saved at 100 %") << QSize(960, 540) << true;
    }
    void whereTheScreenHasNoRoomForItItTakesAllThereIs()
    {
        QFETCH(QSize, screen);
        QFETCH(bool, fills);
        widgets::MainWindow &window = m_rig->window;
        window.hide();
        window.resize(1280, 720); // of the last time
        window.showWithin(screen);
        QVERIFY(window.isVisible());
        QCOMPARE(window.isMaximized(), fills);
    }

    void toolsAreMadeWhenTheyAreOpenedOrABoardIsToCome()
    {
        facts::NoPorts ports;
        facts::AnsweredPrompt files;
        widgets::Workbench workbench;
        widgets::MainWindow window(workbench, ports, files, facts::WindowRig::quietSettings());
        const auto made = [&window] { return window.findChildren<widgets::Form *>().size(); };
        const auto docks = window.findChildren<QDockWidget *>();
        QCOMPARE(made(), qsizetype{0});
        window.findChild<QAction *>(QStringLiteral("rampDockOpen"))->trigger();
        QCOMPARE(made(), qsizetype{1});
        workbench.device().disconnect(SIGNAL(openWished(session::Endpoint)), &workbench);
        Q_EMIT workbench.device().openWished({});
        QCOMPARE(made(), docks.size() - 2); // all but registers and control are tools
        window.finishTools();
        QCOMPARE(made(), docks.size() - 2);
    }

    void theOtherToolsAreMadeAfterTheFirstPicture()
    {
        facts::NoPorts ports;
        facts::AnsweredPrompt files;
        widgets::Workbench workbench;
        widgets::MainWindow window(workbench, ports, files, facts::WindowRig::quietSettings());
        window.show();
        const auto docks = window.findChildren<QDockWidget *>().size();
        QTRY_COMPARE(window.findChildren<widgets::Form *>().size(), docks - 2);
    }

    void portsAreAskedForAfterTheFirstPictureOrWhenTheirListOpens()
    {
        struct OnePort : session::PortSource {
            mutable int asked = 0;
            QList<session::SystemPort> ports() const override
            {
                ++asked;
                return {{QStringLiteral("/dev/ttyACM0"), {}, {}, {}, 0x0483, 0x374b}};
            }
        } ports;
        facts::AnsweredPrompt files;
        widgets::Workbench workbench;
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.port = QStringLiteral("/dev/ttyACM0");
        const QString name = QStringLiteral("/dev/ttyACM0 (ST-LINK)");
        {
            widgets::MainWindow window(workbench, ports, files, settings);
            auto *port = window.findChild<QComboBox *>(QStringLiteral("port"));
            QCOMPARE(ports.asked, 0);
            QCOMPARE(port->currentText(), settings.port); // chosen already
            QCOMPARE(window.connectBar()->path(), settings.port);
            QVERIFY(port->count() > 0); // the simulated boards
            window.show();
            QTRY_COMPARE(port->currentText(), name);
            QCOMPARE(ports.asked, 1);
            QCOMPARE(window.connectBar()->path(), settings.port);
        }
        widgets::MainWindow window(workbench, ports, files, settings);
        auto *port = window.findChild<QComboBox *>(QStringLiteral("port"));
        port->showPopup();
        QCOMPARE(ports.asked, 2);
        QCOMPARE(port->currentText(), name);
        port->hidePopup();
    }

    void aToolThatWasOpenIsThereAtOnce()
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        m_rig->find<QAction>("motorDockOpen")->trigger();
        settings.workspace.layout = m_rig->window.settings().workspace.layout;
        facts::NoPorts ports;
        facts::AnsweredPrompt files;
        widgets::Workbench workbench;
        widgets::MainWindow window(workbench, ports, files, settings);
        QCOMPARE(window.findChildren<widgets::Form *>().size(), qsizetype{1});
        window.show();
        QVERIFY(window.findChild<widgets::Form *>()->isVisible());
    }

    void anOpenPortIsNotYetABoard()
    {
        feed({LinkState::Connecting, LinkReason::None});
        QVERIFY(lamp("portLamp")->light() == Lamp::Light::On);
        QVERIFY(lamp("boardLamp")->light() == Lamp::Light::Waiting);
        feed({LinkState::Connected, LinkReason::None});
        QVERIFY(lamp("boardLamp")->light() == Lamp::Light::On);
        QCOMPARE(lamp("boardLamp")->text(), QStringLiteral("board answering"));
    }

    void theCardSaysNothingOfABoardThatDoesNotAnswer()
    {
        m_rig->find<widgets::FirstSteps>("firstSteps")->restart();
        feed({LinkState::Connected, LinkReason::None});
        auto *card = m_rig->find<QWidget>("firstSteps");
        QVERIFY(card->isVisible());
        feed({LinkState::Lost, LinkReason::Silence});
        QVERIFY(!card->isVisible());
        feed({LinkState::Connected, LinkReason::None});
        QVERIFY(card->isVisible());
    }

    void theCardOfARunningMotorIsOverWithItsFault()
    {
        m_rig->find<widgets::FirstSteps>("firstSteps")->restart();
        const auto *card = m_rig->find<QWidget>("firstSteps");
        const auto says = [card](const char *title) {
            const auto labels = card->findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(),
                [&](const QLabel *label) { return label->text() == QLatin1String(title); });
        };
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        QVERIFY(says("The motor is running"));
        facts::feed(device(), {facts::status(drive::MotorState::FaultNow)});
        QVERIFY(!says("The motor is running"));
        QVERIFY(card->isVisible() && says("Save what you see"));
    }

    void theCardLeavesItsPlaceToAnOpenTool()
    {
        m_rig->find<widgets::FirstSteps>("firstSteps")->restart();
        auto *card = m_rig->find<QWidget>("firstSteps");
        auto *gains = m_rig->find<QDockWidget>("gainsDock");
        auto *ramps = m_rig->find<QDockWidget>("rampDock");
        m_rig->find<QAction>("gainsDockOpen")->trigger();
        QTRY_VERIFY(!card->isVisible());
        m_rig->find<QAction>("rampDockOpen")->trigger(); // now a tab in front of the other
        QTRY_VERIFY(!ramps->visibleRegion().isEmpty());
        QVERIFY(!card->isVisible());
        ramps->close();
        QTRY_VERIFY(!gains->visibleRegion().isEmpty());
        QVERIFY(!card->isVisible());
        gains->close();
        QTRY_VERIFY(card->isVisible());
        m_rig->find<QAction>("gainsDockOpen")->trigger(); // still open when the window goes
    }

    void aSecondLineOfSignalsTakesItsPlaceAndCoversNothing()
    {
        auto *flow = new widgets::FlowLayout(5);
        QWidget page, chips;
        chips.setLayout(flow);
        for (int i = 0; i < 4; ++i) {
            auto *chip = new QWidget;
            chip->setFixedSize(100, 20);
            flow->addWidget(chip);
        }
        auto *above = new QWidget;
        above->setMinimumHeight(50);
        auto *column = new QVBoxLayout(&page);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(above);
        column->addWidget(&chips);
        page.resize(500, 70);
        page.show();
        QTRY_COMPARE(page.minimumSizeHint().height(), 70);
        page.resize(250, 70);
        QTRY_COMPARE(page.minimumSizeHint().height(), 95); // a top-level window grows by itself
        QTRY_VERIFY(page.height() >= 95);
        QVERIFY(chips.y() >= 50);
        page.resize(500, 95);
        QTRY_COMPARE(page.minimumSizeHint().height(), 70);
    }

    void aSilentBoardHatchesTheScopeUntilItAnswers()
    {
        auto *scope = m_rig->find<widgets::ScopeView>("scope");
        auto *mark = m_rig->find<QWidget>("staleMark");
        QVERIFY(!mark->isVisible());
        feed({LinkState::Suspect, LinkReason::None});
        QCOMPARE(scope->staleMark().why(), QStringLiteral("Not live: board silent"));
        QVERIFY(mark->isVisible());
        QCOMPARE(mark->size(), scope->size());
        feed({LinkState::Lost, LinkReason::Silence});
        QCOMPARE(scope->staleMark().why(), QStringLiteral("Not live: link lost"));
        feed({LinkState::Connected, LinkReason::None});
        QVERIFY(!mark->isVisible());
        // By the user: the picture is a recording.
        device().portChanged(session::PortState::Closed, {});
        QVERIFY(!mark->isVisible());
    }

    void onlyABoardThatAnsweredCanBeLostAndNoneIsNamedAtAClosedPort()
    {
        const auto lamp = [this] { return m_rig->find<QWidget>("boardLamp")->accessibleName(); };
        QVERIFY(!m_rig->find<QLabel>("firmware")->text().isEmpty());
        feed({LinkState::Lost, LinkReason::Silence});
        QVERIFY(lamp().contains(QStringLiteral("link lost")));
        device().portChanged(session::PortState::Closed, {});
        feed({LinkState::Closed, LinkReason::None});
        QVERIFY(lamp().contains(QStringLiteral("no board")));
        QVERIFY(m_rig->find<QLabel>("firmware")->text().isEmpty());
        QVERIFY(m_rig->find<QLabel>("boardName")->text().isEmpty());
        feed({LinkState::Connected, LinkReason::None});
        QVERIFY(!m_rig->find<QLabel>("firmware")->text().isEmpty());
        feed({LinkState::Lost, LinkReason::NoAnswer});
        QVERIFY(lamp().contains(QStringLiteral("no board found")));
        QVERIFY(m_rig->find<QLabel>("firmware")->text().isEmpty());
    }

    void theChosenMotorStaysShownWhenItsBoardIsToldAnew()
    {
        drive::Identified two = facts::identified();
        two.identity.motors = 2;
        two.limits.push_back(two.limits.front());
        facts::feed(device(), {two});
        auto *motor = m_rig->find<QComboBox>("motor");
        QTest::keyClick(motor, Qt::Key_Down);
        QCOMPARE(device().motor(), 2);
        facts::feed(device(), {two}); // with a scale that has become known
        QCOMPARE(device().motor(), 2);
        QCOMPARE(motor->currentIndex(), 1);
    }

    /// As it comes from the command line, or from a file manager.
    void aFileIsOpenedByItsSuffix()
    {
        facts::WindowRig rig; // without a board
        const auto said = [&rig] { return rig.find<widgets::Banner>("banner"); };
        const QTemporaryDir folder;
        QFile csv(folder.filePath(QStringLiteral("a.csv")));
        QVERIFY(csv.open(QIODevice::WriteOnly));
        csv.write("time [s],speed [rpm]\n0,10\n0.001,20\n0.002,30\n");
        csv.close();
        rig.window.openFile(csv.fileName());
        QTRY_COMPARE(rig.window.scope()->channels().size(), 1);
        QVERIFY2(said()->text().contains(QStringLiteral("a.csv")), qPrintable(said()->text()));
        QFile loud(folder.filePath(QStringLiteral("B.CSV"))); // as other systems write it
        QVERIFY(loud.open(QIODevice::WriteOnly));
        loud.write("time [s],speed [rpm],current [A]\n0,10,1\n0.001,20,1\n0.002,30,1\n");
        loud.close();
        rig.window.openFile(loud.fileName());
        QTRY_COMPARE(rig.window.scope()->channels().size(), 2);
        rig.window.openFile(folder.filePath(QStringLiteral("none.pcapng")));
        QTRY_VERIFY2(
            said()->text().contains(QStringLiteral("none.pcapng")), qPrintable(said()->text()));
        QCOMPARE(rig.window.scope()->channels().size(), 2);
        for (const char *name : {"none.workspace", "NONE.WORKSPACE"}) {
            rig.window.openFile(folder.filePath(QLatin1String(name)));
            QTRY_VERIFY2(said()->text().contains(QLatin1String(name)), qPrintable(said()->text()));
            QVERIFY(said()->text().contains(QStringLiteral("was not opened")));
        }
    }

    void aLostLinkStaysToldUntilTheBoardAnswers()
    {
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        feed({LinkState::Lost, LinkReason::Silence});
        QVERIFY(banner()->isVisible());
        QVERIFY(banner()->kind() == widgets::Banner::Kind::Bad);
        QVERIFY(banner()->text().startsWith(
            QStringLiteral("Link lost. The motor may still be turning (this drive has no "
                           "communication time-out).")));
        feed({LinkState::Connecting, LinkReason::None});
        QVERIFY(banner()->isVisible());
        feed({LinkState::Connected, LinkReason::None});
        QVERIFY(!banner()->isVisible());
    }

    void aBoardThatWasNeverMetIsNotSaidToTurnAMotor()
    {
        m_rig->find<QPushButton>("connect")->click();
        device().portChanged(session::PortState::Closed, {});
        m_rig->find<QPushButton>("connect")->click();
        device().portChanged(session::PortState::Open, {});
        feed({LinkState::Lost, LinkReason::NoAnswer});
        QVERIFY(banner()->text().contains(QStringLiteral("no board answers")));
        QVERIFY(!banner()->text().contains(QStringLiteral("turning")));
    }

    void whatWentOnWithoutTheWindowIsTold()
    {
        using Cause = session::Interruption::Cause;
        const auto tell = [this](const session::Interruption &what) {
            Q_EMIT device().interrupted(what);
            return banner()->text();
        };
        const QString stopped =
            tell({Cause::Interface, std::chrono::milliseconds(8240), true, true});
        QVERIFY2(stopped.contains(QStringLiteral("8.2 s")), qPrintable(stopped));
        QVERIFY2(
            stopped.contains(QStringLiteral("All motors were told to stop")), qPrintable(stopped));
        const QString disarmed = tell({Cause::Gap, std::chrono::hours(1), true, false});
        QVERIFY2(disarmed.contains(QStringLiteral("disarmed")), qPrintable(disarmed));
        QVERIFY(!disarmed.contains(QStringLiteral("told to stop")));
        QVERIFY(tell({Cause::Hold, {}, false, true}).contains(QStringLiteral("jog")));
        QVERIFY(tell({Cause::LateArming, {}, false, false}).contains(QStringLiteral("Not armed")));
    }

    void theWatchdogOfADriveIsShown()
    {
        auto *shown = m_rig->find<QLabel>("statusWatchdog");
        QCOMPARE(shown->text(), QStringLiteral("Drive watchdog: none"));
        drive::Identified board = facts::identified();
        board.identity.watchdog = std::chrono::milliseconds(500);
        facts::feed(device(), {board});
        QCOMPARE(shown->text(), QStringLiteral("Drive watchdog: 500 ms"));
        QVERIFY(
            shown->toolTip().contains(QStringLiteral("from a window that responds and is armed")));
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        feed({LinkState::Lost, LinkReason::Silence});
        QVERIFY(banner()->text().contains(QStringLiteral("stop it by itself after 500 ms")));
        QVERIFY(!banner()->text().contains(QStringLiteral("no communication time-out")));
        board.identity.watchdog.reset();
        facts::feed(device(), {board});
        QCOMPARE(shown->text(), QStringLiteral("Drive watchdog: none"));
    }

    void nothingOfABoardOutlivesItsConnectionInTheStatus()
    {
        drive::Identified board = facts::identified();
        facts::feed(device(), {board});
        const auto text = [this](const char *name) { return m_rig->find<QLabel>(name)->text(); };
        QVERIFY(!text("sizes").isEmpty());
        QVERIFY(!text("statusWatchdog").isEmpty());
        QVERIFY(!text("statusLost").isEmpty());
        QCOMPARE(m_rig->find<QAction>("scopeRun")->text(), QStringLiteral("Run"));
        device().portChanged(session::PortState::Closed, {});
        for (const char *name :
            {"sizes", "statusMotor", "statusFaults", "statusLost", "statusBad", "statusWatchdog"})
            QVERIFY2(text(name).isEmpty(), name);
        QCOMPARE(m_rig->find<QAction>("scopeRun")->text(), QStringLiteral("Run"));
    }

    void everyReasonIsASentence()
    {
        for (int reason = 1; reason <= int(LinkReason::OtherProtocol); ++reason) {
            feed({LinkState::Lost, static_cast<LinkReason>(reason)});
            QVERIFY(banner()->isVisible());
            QVERIFY(banner()->text().endsWith(QLatin1Char('.')));
        }
    }

    void aSuspectLinkShowsNoValueAsCurrent()
    {
        facts::feed(
            device(), {drive::RegistersRead{{facts::reading(facts::kSpeed, std::int64_t{1500})}}});
        QVERIFY(m_rig->workbench.registers().shownValue(facts::kSpeed));
        feed({LinkState::Suspect, LinkReason::None});
        QVERIFY(!m_rig->workbench.registers().shownValue(facts::kSpeed));
        QVERIFY(!m_rig->find<QPushButton>("start")->isEnabled());
    }

    void disconnectingFromATurningMotorAsks()
    {
        QSignalSpy closes(&device(), &widgets::Device::closeWished);
        QSignalSpy stops(&device(), &widgets::Device::stopWished);
        m_rig->workbench.setSessionClock([] { return TimePoint{}; }); // as the states below
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        QTest::keyClick(&m_rig->window, Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(closes.size(), 0);
        auto *question = m_rig->find<QMessageBox>("notIdleQuestion");
        QVERIFY(question);
        for (QAbstractButton *button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::AcceptRole)
                QTest::mouseClick(button, Qt::LeftButton);
        QCOMPARE(stops.size(), 1);
        QCOMPARE(closes.size(), 0); // not before there is evidence
        facts::feed(device(), {facts::status(drive::MotorState::Idle)});
        QCOMPARE(closes.size(), 1);
    }

    void disconnectingFromAnIdleMotorDoesNotAsk()
    {
        QSignalSpy closes(&device(), &widgets::Device::closeWished);
        QTest::keyClick(&m_rig->window, Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(closes.size(), 1);
    }

    void theWheelChangesNoChoiceWithoutFocus()
    {
        auto *baud = m_rig->find<QComboBox>("fastRate");
        QVERIFY(baud->count() > 2);
        const int before = baud->currentIndex();
        m_rig->window.setFocus();
        QWheelEvent wheel(QPointF(5, 5), baud->mapToGlobal(QPointF(5, 5)), {}, QPoint(0, -120),
            Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(baud, &wheel);
        QCOMPARE(baud->currentIndex(), before);
    }

    void whatIsVisibleIsPolledAndNothingElse()
    {
        auto &watch = m_rig->workbench.watchList();
        QTRY_VERIFY(!watch.registers().empty());
        const auto &asked = watch.registers();
        // The control panel's.
        QVERIFY(std::find(asked.begin(), asked.end(), facts::kSpeed) != asked.end());
        // Cannot be read.
        QVERIFY(std::find(asked.begin(), asked.end(), facts::kAngle) == asked.end());
        // Its group is closed.
        QVERIFY(std::find(asked.begin(), asked.end(), facts::kFlags) == asked.end());
    }

    void largeNumbersTakeThePlaceOfThePicture()
    {
        facts::connectBoard(device());
        auto *numbers = m_rig->find<widgets::BigNumbers>("bigNumbers");
        QVERIFY(numbers->watchedRegisters().empty()); // what is not seen is not polled
        QTest::keyClick(&m_rig->window, Qt::Key_F9);
        QVERIFY(numbers->isVisible() && !m_rig->window.scope()->isVisible());
        QVERIFY(m_rig->find<QWidget>("stopMotors")->isVisible());
        QCOMPARE(numbers->watchedRegisters().size(), 2U); // all that this board has
        QCOMPARE(numbers->valueText("SPEED_MEAS"), QStringLiteral("\u2013"));
        facts::feed(
            device(), {drive::RegistersRead{{facts::reading(facts::kSpeed, std::int64_t{1234})}}});
        QCOMPARE(numbers->valueText("SPEED_MEAS"), QStringLiteral("1234\u202frpm"));
        QVERIFY(numbers->accessibleDescription().contains(QStringLiteral("1234")));
        facts::feed(
            device(), {drive::LinkChanged{drive::LinkState::Suspect, drive::LinkReason::None}});
        QCOMPARE(numbers->valueText("SPEED_MEAS"), QStringLiteral("\u2013"));
        QTest::keyClick(&m_rig->window, Qt::Key_F9);
        QVERIFY(!numbers->isVisible() && m_rig->window.scope()->isVisible());
    }

    void readoutsAreWrittenOnceHoweverMuchComesTogether()
    {
        facts::connectBoard(device());
        auto *readouts = m_rig->window.findChild<widgets::ReadoutBox *>();
        QCoreApplication::processEvents();
        QSignalSpy written(readouts, &widgets::ReadoutBox::updated);
        std::vector<drive::Event> batch;
        for (std::int64_t i = 0; i < 50; ++i)
            batch.emplace_back(drive::RegistersRead{
                {facts::reading(facts::kSpeed, 1000 + i), facts::reading(facts::kCurrentA, i)}});
        facts::feed(device(), batch);
        QTRY_COMPARE(readouts->value("SPEED_MEAS"), 1049.0);
        QTRY_COMPARE(written.size(), 1);
    }

    void onesOwnLimitsAreKeptBetweenRuns()
    {
        device().setUserLimits({1200.0, 1.5});
        const widgets::Settings settings = m_rig->window.settings();
        QCOMPARE(settings.maxSpeedRpm, 1200.0);
        facts::WindowRig later(settings);
        QVERIFY(later.workbench.device().userLimits() == (drive::UserLimits{1200.0, 1.5}));
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    widgets::Banner *banner() { return m_rig->find<widgets::Banner>("banner"); }
    Lamp *lamp(const char *name) { return m_rig->find<Lamp>(name); }
    void feed(drive::LinkChanged link) { facts::feed(device(), {link}); }

    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestMainWindow)
#include "tst_main_window.moc"
