#include "support/window_rig.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/motor_button.h"
#include "widgets/control/panel.h"
#include "widgets/control/stop_alarm.h"
#include "widgets/control/stop_words.h"
#include "widgets/window/about_dialog.h"

#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QSignalSpy>
#include <QWindow>

#include <algorithm>

class TestStop : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&m_rig->window));
        m_rig->workbench.setSessionClock([] { return TimePoint{}; }); // the time of all states here
        facts::connectBoard(device());
        m_stops = std::make_unique<QSignalSpy>(&device(), &widgets::Device::stopWished);
    }
    void cleanup()
    {
        m_stops.reset();
        device().portChanged(session::PortState::Closed, {});
        m_rig.reset();
    }

    void escapeStopsOnceFromTheWindow()
    {
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 2);
    }

    void escapeStopsWithTheFocusInAText_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"registerSearch", "speed", "port", "baud", "rampTime",
                 "registerTree", "arm", "start", "connect"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void escapeStopsWithTheFocusInAText()
    {
        QFETCH(QString, name);
        auto *widget = m_rig->window.findChild<QWidget *>(name);
        QVERIFY(widget);
        widget->setFocus();
        QTest::keyClick(widget, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
    }

    void escapeStopsUnderAModalDialogAndStillClosesIt()
    {
        widgets::showAbout(&m_rig->window);
        auto *dialog = m_rig->window.findChild<QDialog *>(QString(), Qt::FindDirectChildrenOnly);
        QVERIFY(dialog);
        auto *about = qobject_cast<QDialog *>(QApplication::activeModalWidget());
        QVERIFY(about);
        QTest::keyClick(about, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!about->isVisible());
    }

    void escapeStopsUnderAMessageBox()
    {
        QMessageBox box(QMessageBox::Question, QStringLiteral("Title"), QStringLiteral("Text"),
            QMessageBox::Ok, &m_rig->window);
        box.open();
        QTest::keyClick(&box, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!box.isVisible());
    }

    void escapeStopsUnderADialogAfterAClickBesideIt()
    {
        QMessageBox box(QMessageBox::Question, QStringLiteral("Title"), QStringLiteral("Text"),
            QMessageBox::Ok, &m_rig->window);
        box.open();
        m_rig->window.activateWindow(); // as some window managers do on a click
        QTRY_COMPARE(QApplication::activeWindow(), &box);
        QTest::keyClick(QGuiApplication::focusWindow(), Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!box.isVisible());
    }

    void theStopButtonsActWhileADialogIsOpen_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"stopMotors", "stop"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void theStopButtonsActWhileADialogIsOpen()
    {
        QFETCH(QString, name);
        widgets::MainWindow &window = m_rig->window;
        const auto *button = window.findChild<widgets::StopButton *>(name);
        QVERIFY(button);
        onScreen(window);
        QDialog dialog(&window);
        auto *edit = new QLineEdit(&dialog);
        edit->setFocus();
        dialog.open();
        // In the window itself Qt throws it away.
        const QPoint inWindow = button->mapTo(&window, button->rect().center());
        QTest::mouseClick(window.windowHandle(), Qt::LeftButton, Qt::NoModifier, inWindow);
        QCOMPARE(m_stops->size(), 0);
        QTRY_VERIFY(onTop(name));
        QCOMPARE(onTop(name)->text(), button->text());
        pressAt(centreOf(*button));
        QCOMPARE(m_stops->size(), 1);
        QTRY_COMPARE(QApplication::activeWindow(), &dialog);
        QVERIFY(edit->hasFocus());

        window.move(window.pos() + QPoint(40, 30));
        QTRY_COMPARE(onTop(name)->geometry().topLeft(), button->mapToGlobal(QPoint()));
        pressAt(centreOf(*button));
        QCOMPARE(m_stops->size(), 2);
        dialog.close();
        QVERIFY(!onTop(name));
        pressAt(centreOf(*button)); // the button itself
        QCOMPARE(m_stops->size(), 3);
    }

    void theStopButtonsActUnderADialogOfADialog()
    {
        onScreen(m_rig->window);
        const QPoint place = centreOf(*m_rig->find<QWidget>("stop"));
        QFileDialog files(&m_rig->window);
        files.setOption(QFileDialog::DontUseNativeDialog);
        files.move(m_rig->window.pos()); // not over the button
        files.open();
        QMessageBox box(QMessageBox::Question, QStringLiteral("Title"), QStringLiteral("Text"),
            QMessageBox::Ok, &files);
        box.open();
        const auto belongsTo = [](const QWidget &dialog) {
            const QWidget *stop = onTop(QStringLiteral("stop"));
            return stop && stop->windowHandle()->transientParent() == dialog.windowHandle();
        };
        QTRY_VERIFY(belongsTo(box));
        // A stop may withdraw what is asked, and with it the button that is being pressed.
        connect(&device(), &widgets::Device::stopWished, &box, &QDialog::reject);
        pressAt(place);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!box.isVisible());
        QTRY_VERIFY(belongsTo(files));
        pressAt(place);
        QCOMPARE(m_stops->size(), 2);
    }

    void noStopButtonIsLaidOverADialogNorWhereThereIsNoneToPress()
    {
        auto *top = m_rig->find<QWidget>("stopMotors");
        auto *other = m_rig->find<QWidget>("stop");
        auto *menu = m_rig->window.menuWidget()->findChild<QMenuBar *>()->actions().at(0)->menu();
        menu->popup(m_rig->window.mapToGlobal(QPoint(5, 5)));
        QCoreApplication::processEvents();
        QVERIFY(!onTop(QStringLiteral("stop"))); // a menu is closed by a press
        menu->close();
        QDialog dialog(&m_rig->window);
        dialog.open();
        dialog.setGeometry(QRect(other->mapToGlobal(QPoint()), other->size()));
        QTRY_VERIFY(onTop(QStringLiteral("stopMotors")));
        QTRY_VERIFY(!onTop(QStringLiteral("stop")));
        dialog.move(dialog.pos() + QPoint(other->width() / 2, 0));
        QTRY_VERIFY(onTop(QStringLiteral("stop"))); // the half of it that is seen
        QVERIFY(!onTop(QStringLiteral("stop"))->mask().contains(QPoint(other->width() - 1, 5)));
        top->setEnabled(false);
        QTRY_VERIFY(!onTop(QStringLiteral("stopMotors")));
        top->setEnabled(true);
        QTRY_VERIFY(onTop(QStringLiteral("stopMotors")));
        top->hide();
        QTRY_VERIFY(!onTop(QStringLiteral("stopMotors")));
    }

    void escapeStopsWhileAMenuIsOpenAndStillClosesIt()
    {
        auto *menu = m_rig->window.menuWidget()->findChild<QMenuBar *>()->actions().at(0)->menu();
        menu->popup(m_rig->window.mapToGlobal(QPoint(5, 5)));
        QVERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!menu->isVisible());
    }

    void escapeStopsWhileAListIsOpen()
    {
        auto *combo = m_rig->find<QComboBox>("fastRate");
        combo->addItem(QStringLiteral("one"));
        combo->showPopup();
        QWidget *popup = QApplication::activePopupWidget();
        QVERIFY(popup);
        QTest::keyClick(popup, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
    }

    void holdingTheKeyIsOneAct()
    {
        QTest::keyPress(&m_rig->window, Qt::Key_Escape);
        for (int i = 0; i < 5; ++i) {
            QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier, QString(), true);
            QCoreApplication::sendEvent(&m_rig->window, &repeat);
        }
        QTest::keyRelease(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
    }

    void theButtonActsWhenItIsPressedNotWhenItIsLetGo()
    {
        for (const char *name : {"stopMotors", "stop"}) {
            m_stops->clear();
            auto *button = m_rig->find<widgets::StopButton>(name);
            QVERIFY(button->isEnabled());
            QVERIFY(button->height() >= 48);
            QTest::mousePress(button, Qt::LeftButton);
            QCOMPARE(m_stops->size(), 1);
            // Slid off.
            QTest::mouseRelease(button, Qt::LeftButton, Qt::NoModifier, QPoint(-50, -50));
            QCOMPARE(m_stops->size(), 1);
        }
    }

    void aStopDisarmsAtOnce()
    {
        device().armedChanged(true);
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QVERIFY(!device().armed());
    }

    void withoutAPortTheSessionIsTold()
    {
        device().portChanged(session::PortState::Closed, {}); // it may be opening one
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
    }

    void aStopWhileThePortIsBeingOpenedIsNotLost()
    {
        QSignalSpy words(&device(), &widgets::Device::stopAdvanced);
        device().portChanged(session::PortState::Closed, {});
        device().open({}); // the simulated board; the session has not heard of it yet
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QTRY_VERIFY(!words.empty());
    }

    void aPortThatGoesWithAnOpenStopIsAlarmedAtOnce()
    {
        QSignalSpy forgotten(&device(), &widgets::Device::forgetStopWished);
        auto *alarm = m_rig->find<widgets::StopAlarm>("stopAlarm");
        Q_EMIT device().stopsWanted({QStringLiteral("/dev/ttyACM0")});
        QVERIFY(alarm->isVisible());
        QVERIFY(textOf(*alarm).contains(QStringLiteral("/dev/ttyACM0")));
        QVERIFY(allTextFits(*alarm));
        auto *takeBack = m_rig->find<QPushButton>("takeStopBack");
        QVERIFY(takeBack->isVisible());
        alarm->reject(); // takes nothing back
        QCOMPARE(forgotten.size(), 0);
        Q_EMIT device().stopsWanted({});
        QVERIFY(!alarm->isVisible()); // the port is back: the stop goes on, with its own words
        Q_EMIT device().stopsWanted({QStringLiteral("/dev/ttyACM0")});
        QVERIFY(alarm->isVisible()); // and gone again
        Q_EMIT device().stopsWanted({});
        QVERIFY(textOf(*alarm).contains(QStringLiteral("open again")));
        QVERIFY(!takeBack->isVisible());
        Q_EMIT device().stopsWanted({QStringLiteral("/dev/ttyACM0")});
        takeBack->click();
        QCOMPARE(forgotten.size(), 1);
        QVERIFY(!alarm->isVisible());
        facts::feed(device(), {drive::StopProgress{1, drive::StopWord::NotConfirmed, {}}});
        Q_EMIT device().stopsWanted({});
        QVERIFY(!takeBack->isVisible()); // nothing of another port can be taken back here
    }

    void theAlarmTellsOfEachMotor()
    {
        using drive::StopWord;
        auto *alarm = m_rig->find<widgets::StopAlarm>("stopAlarm");
        facts::feed(device(),
            {drive::StopProgress{1, StopWord::NotConfirmed, {}},
                drive::StopProgress{2, StopWord::NotConfirmed, {}}});
        QVERIFY(textOf(*alarm).contains(QStringLiteral("Motor 1 was told to stop")));
        QVERIFY(textOf(*alarm).contains(QStringLiteral("Motor 2 was told to stop")));
        QVERIFY(allTextFits(*alarm));
        Q_EMIT device().stopsWanted(
            {QStringLiteral("/dev/ttyACM0"), QStringLiteral("/dev/ttyACM1")});
        QVERIFY(allTextFits(*alarm)); // it grows with its text
        Q_EMIT device().stopsWanted({});
        facts::feed(device(),
            {drive::StopProgress{1, StopWord::DriveIdle, {}},
                drive::StopProgress{1, StopWord::Standstill, {}}});
        QVERIFY(textOf(*alarm).contains(QStringLiteral("Motor 1: meanwhile standstill")));
        QVERIFY(textOf(*alarm).contains(QStringLiteral("Motor 2 was told to stop")));
    }

    void anAlarmSaysWhenAllItsMotorsWereMeasuredStanding()
    {
        using drive::StopWord;
        auto *alarm = m_rig->find<widgets::StopAlarm>("stopAlarm");
        facts::feed(device(),
            {drive::StopProgress{1, StopWord::NotConfirmed, {}},
                drive::StopProgress{2, StopWord::NotConfirmed, {}}});
        auto *headline = m_rig->find<QLabel>("stopAlarmText");
        const QString alarming = headline->text();
        for (const drive::StopProgress &progress : {drive::StopProgress{1, StopWord::DriveIdle, {}},
                 drive::StopProgress{1, StopWord::Standstill, {}},
                 drive::StopProgress{2, StopWord::DriveIdle, {}},
                 drive::StopProgress{2, StopWord::MayCoast, {}}}) {
            facts::feed(device(), {progress});
            QCOMPARE(headline->text(), alarming); // for one of them nothing was measured
        }
        facts::feed(device(), {drive::StopProgress{2, StopWord::Standstill, {}}});
        QCOMPARE(headline->text(), QStringLiteral("Confirmed late: standstill was measured."));
        QVERIFY(alarm->isVisible()); // it is to be read
        QVERIFY(!m_rig->find<QPushButton>("takeStopBack")->isVisible());
        QVERIFY(textOf(*alarm).contains(QStringLiteral("Motor 1: meanwhile standstill")));
        QVERIFY(textOf(*alarm).contains(QStringLiteral("At first nothing confirmed the stop.")));
        QVERIFY(allTextFits(*alarm));
        facts::feed(device(), {drive::StopProgress{1, StopWord::DriveIdle, {}}}); // stopped again
        QVERIFY(headline->text() != alarming);
        facts::feed(device(), {drive::StopProgress{1, StopWord::NotConfirmed, {}}});
        QCOMPARE(headline->text(), alarming);
    }

    void whereNothingWasHeardOfAStopAllMotorsOfTheBoardHaveToStand()
    {
        using drive::StopWord;
        Q_EMIT device().stopsWanted({QStringLiteral("/dev/ttyACM0")});
        auto *headline = m_rig->find<QLabel>("stopAlarmText");
        const QString alarming = headline->text();
        const drive::StopProgress first{1, StopWord::Standstill, {}};
        facts::feed(device(), {first}); // of a board at another port
        QCOMPARE(headline->text(), alarming);
        Q_EMIT device().stopsWanted({});
        QCOMPARE(headline->text(), alarming);
        facts::feed(device(), {first}); // the board has not told how many it has
        QCOMPARE(headline->text(), alarming);
        drive::Identified two = facts::identified();
        two.identity.motors = 2;
        facts::feed(device(), {two});
        QCOMPARE(headline->text(), alarming);
        facts::feed(device(), {drive::StopProgress{2, StopWord::Standstill, {}}});
        QVERIFY(headline->text() != alarming);
    }

    void theWordsAreToldOfEachMotor()
    {
        using drive::StopWord;
        const auto *words = m_rig->window.findChild<widgets::StopWords *>();
        for (const StopWord word :
            {StopWord::Requested, StopWord::Accepted, StopWord::DriveIdle, StopWord::Standstill})
            facts::feed(device(), {drive::StopProgress{1, word, {}}});
        QVERIFY(words->rested());
        facts::feed(device(), {drive::StopProgress{2, StopWord::Requested, {}}}); // becomes known
        QVERIFY(!words->rested());
        const QStringList lines = words->text().split(QLatin1Char('\n'));
        QCOMPARE(lines.size(), 7); // two names, four words, and one
        QCOMPARE(lines[0], QStringLiteral("Motor 1"));
        QCOMPARE(lines[5], QStringLiteral("Motor 2"));
        QVERIFY(lines[6].contains(QStringLiteral("requested")));
    }

    void whileTheLinkIsLostAStopIsStillSent()
    {
        for (const auto state : {drive::LinkState::Suspect, drive::LinkState::Recovering,
                 drive::LinkState::Lost, drive::LinkState::Connecting}) {
            m_stops->clear();
            facts::feed(device(), {drive::LinkChanged{state, drive::LinkReason::Silence}});
            QVERIFY(m_rig->find<widgets::StopButton>("stop")->isEnabled());
            QTest::mousePress(m_rig->find<QWidget>("stopMotors"), Qt::LeftButton);
            QTest::keyClick(&m_rig->window, Qt::Key_Escape);
            QCOMPARE(m_stops->size(), 2);
        }
    }

    void aPulledCableUnderATurningMotorIsToldWhenStopIsPressed()
    {
        auto *alarm = m_rig->find<widgets::StopAlarm>("stopAlarm");
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        device().portChanged(
            session::PortState::Closed, {session::PortProblem::Unplugged, QStringLiteral("gone")});
        QVERIFY(!alarm->isVisible());
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1); // for the port that is being opened again
        QVERIFY(alarm->isVisible());
        QTest::keyClick(alarm, Qt::Key_Escape); // closes it, and does not raise it again at once
        QVERIFY(!alarm->isVisible());
    }

    void escapeStopsAlsoWhereALaterFilterEatsTheKey()
    {
        // As the loop of a drag does; tst_stop_under_x11_posix has the real one.
        class Eater : public QObject {
        public:
            using QObject::QObject;

        protected:
            bool eventFilter(QObject *, QEvent *event) override
            {
                return event->type() == QEvent::ShortcutOverride
                    || event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
            }
        } eater;
        qApp->installEventFilter(&eater);
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 2);
    }

    void nothingIsLeftToTheDesktopThatWouldKeepTheKey()
    {
        QVERIFY(QCoreApplication::testAttribute(Qt::AA_DontUseNativeDialogs));
        QVERIFY(QCoreApplication::testAttribute(Qt::AA_DontUseNativeMenuBar));
        for (const QMenuBar *bar : m_rig->window.findChildren<QMenuBar *>())
            QVERIFY(!bar->isNativeMenuBar());
    }

    void escapeStopsWhileTheScopesMenuIsOpen()
    {
        auto *plot = m_rig->find<QWidget>("scopePlot");
        QTest::mouseClick(plot, Qt::RightButton, Qt::NoModifier, plot->rect().center());
        QPointer<QWidget> menu = QApplication::activePopupWidget();
        QVERIFY(menu);
        QTest::keyClick(menu.data(), Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!menu || !menu->isVisible());
    }

    void escapeStopsUnderAFileDialog()
    {
        // As widgets/base/file_prompt.cpp makes it: a system's own dialog would keep the key for itself.
        QFileDialog dialog(&m_rig->window);
        dialog.setOption(QFileDialog::DontUseNativeDialog);
        dialog.open();
        QTest::keyClick(&dialog, Qt::Key_Escape);
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(!dialog.isVisible());
    }

    void aStopThatIsNotConfirmedRaisesTheAlarm()
    {
        facts::feed(device(),
            {drive::StopProgress{1, drive::StopWord::Requested, {}},
                drive::StopProgress{1, drive::StopWord::NotConfirmed, {}}});
        auto *alarm = m_rig->find<widgets::StopAlarm>("stopAlarm");
        QVERIFY(alarm->isVisible());
        QVERIFY(alarm->isModal());
        QCOMPARE(m_rig->find<QLabel>("stopAlarmText")->text(),
            QStringLiteral("Stop NOT confirmed. Use the hardware stop."));
        std::vector<drive::Wish> wishes;
        connect(&device(), &widgets::Device::wishMade, this,
            [&](const drive::Wish &wish) { wishes.push_back(wish); });
        QTest::keyClick(alarm, Qt::Key_Escape);
        QVERIFY(!alarm->isVisible());
        QVERIFY(wishes.empty());
        QVERIFY(!device().armed());
    }

    void theWindowStaysWhileAMotorTurnsAndGoesOnceItIsIdle()
    {
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        QVERIFY(!m_rig->window.close());
        QCOMPARE(m_stops->size(), 1);
        QVERIFY(m_rig->window.isVisible());
        facts::feed(device(), {facts::status(drive::MotorState::Stopping)});
        QVERIFY(m_rig->window.isVisible());
        facts::feed(device(), {facts::status(drive::MotorState::Idle)});
        QVERIFY(!m_rig->window.isVisible());
    }

    void withoutEvidenceTheWindowAsksAndLeavingTakesTwoChoices()
    {
        facts::feed(device(), {facts::status(drive::MotorState::Running)});
        QVERIFY(!m_rig->window.close());
        QTRY_VERIFY(m_rig->find<QMessageBox>("leaveQuestion"));
        auto *question = m_rig->find<QMessageBox>("leaveQuestion");
        for (QAbstractButton *button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::DestructiveRole)
                QTest::mouseClick(button, Qt::LeftButton);
        auto *second = m_rig->find<QMessageBox>("leaveRunning");
        QVERIFY(second);
        QVERIFY(m_rig->window.isVisible());
        for (QAbstractButton *button : second->buttons())
            if (second->buttonRole(button) == QMessageBox::DestructiveRole)
                QTest::mouseClick(button, Qt::LeftButton);
        QTRY_VERIFY(!m_rig->window.isVisible());
    }

    void theWordsAreNeverThoseOfACertifiedStop()
    {
        QStringList texts{widgets::stopLimitsText()};
        for (const QWidget *widget : m_rig->window.findChildren<QWidget *>())
            texts << widget->toolTip() << widget->accessibleName()
                  << widget->property("text").toString();
        for (const QString &text : texts)
            for (const char *word : {"emergency", "safe", "STO ", "SS1"})
                QVERIFY2(!text.contains(QLatin1String(word), Qt::CaseSensitive), qPrintable(text));
    }

private:
    /// What is laid over that button, with its name.
    static widgets::StopButton *onTop(const QString &name)
    {
        for (QWidget *window : QApplication::topLevelWidgets())
            if (window->isVisible() && window->objectName() == name + QStringLiteral("OnTop"))
                return qobject_cast<widgets::StopButton *>(window);
        return nullptr;
    }
    /// Its right half, where the buttons are: the screen of the offscreen platform is smaller than it.
    static void onScreen(QWidget &window)
    {
        const QRect screen = window.screen()->geometry();
        window.move(screen.right() - 80 - window.width(), 0);
    }
    static QPoint centreOf(const QWidget &widget)
    {
        return widget.mapToGlobal(widget.rect().center());
    }
    /// In the window that is there, which may be blocked, as a pointer does it.
    static void pressAt(QPoint place)
    {
        QWindow *window = QGuiApplication::topLevelAt(place);
        QVERIFY(window);
        QTest::mouseClick(window, Qt::LeftButton, Qt::NoModifier, window->mapFromGlobal(place));
    }
    static QString textOf(const QWidget &dialog)
    {
        QString all;
        for (const auto *label : dialog.findChildren<QLabel *>())
            all += label->text() + QLatin1Char('\n');
        return all;
    }
    /// No label is lower than its text, with all the lines that its width makes.
    static bool allTextFits(const QWidget &dialog)
    {
        QCoreApplication::sendPostedEvents(); // the layout's own
        const auto labels = dialog.findChildren<QLabel *>();
        return std::all_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->height() >= label->heightForWidth(label->width());
        });
    }
    widgets::Device &device() { return m_rig->workbench.device(); }

    std::unique_ptr<facts::WindowRig> m_rig;
    std::unique_ptr<QSignalSpy> m_stops;
};

QTEST_MAIN(TestStop)
#include "tst_stop.moc"
