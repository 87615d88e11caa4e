// Esc stops the motors while Qt runs one of its own loops, proved on a real X server with a real pointer and real keys:
// a drag of a register over the scope, menus, lists and dialogs. The offscreen platform has no such drag. And so do the
// Stop buttons under dialogs, where Qt throws away what is pressed in the window itself.
#include "support/programs/x_server_posix.h"
#include "support/window_rig.h"
#include "widgets/window/connect_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSortFilterProxyModel>
#include <QTimer>
#include <QTreeView>

#include <functional>

using drive::MotorState;
using support::Hands;

namespace {

constexpr int kLong_ms = 30'000;
constexpr int kStep_ms = 20;
constexpr int kSteps = 8; ///< of the pointer, from the tree to the scope

/// Counts what a drag tells those under it.
class DragWatch : public QObject {
public:
    DragWatch() { qApp->installEventFilter(this); }
    int entered = 0, moved = 0, left = 0, dropped = 0;

protected:
    bool eventFilter(QObject *, QEvent *event) override
    {
        entered += event->type() == QEvent::DragEnter ? 1 : 0;
        moved += event->type() == QEvent::DragMove ? 1 : 0;
        left += event->type() == QEvent::DragLeave ? 1 : 0;
        dropped += event->type() == QEvent::Drop ? 1 : 0;
        return false;
    }
};

} // namespace

class TestStopUnderX11 : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QCOMPARE(QGuiApplication::platformName(), QStringLiteral("xcb"));
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->sayYesToMotion();
        m_rig->window.move(0, 0);
        m_rig->window.activateWindow();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window, kLong_ms));
        QTRY_VERIFY_WITH_TIMEOUT(QGuiApplication::focusWindow(), kLong_ms);
        m_rig->window.connectBar()->openSimulator();
        QTRY_VERIFY_WITH_TIMEOUT(device().answering() && device().identified(), kLong_ms);
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, kLong_ms);
        m_stops = std::make_unique<QSignalSpy>(&device(), &widgets::Device::stopWished);
    }
    void cleanupTestCase()
    {
        m_stops.reset();
        m_rig.reset();
    }
    void init() { m_stops->clear(); }

    void escapeStopsTheMotorWhileARegisterIsDragged()
    {
        start();
        auto *tree = m_rig->find<QTreeView>("registerTree");
        auto *plot = m_rig->find<QWidget>("scopePlot");
        const QRect row = tree->visualRect(rowOf(*tree, "SPEED_MEAS"));
        QVERIFY(row.isValid());
        const QPoint from = tree->viewport()->mapToGlobal(row.center());
        const QPoint to = plot->mapToGlobal(plot->rect().center());
        DragWatch drag;
        bool pressed = false;
        int step = 0;
        // The user does not wait for the loop that runs meanwhile: the drag's own, and the test's before and after it.
        QTimer hand;
        connect(&hand, &QTimer::timeout, this, [&] {
            if (drag.entered == 0) {
                ++step;
                const QPoint trembling(step % 2, 0);
                QVERIFY(
                    Hands::move(from + (to - from) * std::min(step, kSteps) / kSteps + trembling));
            } else if (!std::exchange(pressed, true)) {
                QCOMPARE(m_stops->size(), 0);
                QVERIFY(Hands::key("Escape"));
            }
        });
        QVERIFY(Hands::move(from));
        QVERIFY(Hands::press());
        hand.start(kStep_ms);
        QTRY_VERIFY_WITH_TIMEOUT(pressed, kLong_ms);
        hand.stop();
        QTRY_COMPARE_WITH_TIMEOUT(m_stops->size(), 1, kLong_ms);
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, kLong_ms); // by the board's own word
        // And it ended the drag, as it always does.
        QTRY_VERIFY_WITH_TIMEOUT(drag.left > 0, kLong_ms);
        QVERIFY(Hands::release());
        QTRY_COMPARE_WITH_TIMEOUT(QGuiApplication::mouseButtons(), Qt::NoButton, kLong_ms);
        QCOMPARE(drag.dropped, 0);
        QCOMPARE(m_stops->size(), 1);
    }

    void escapeStopsInTheLoopsOfMenusAndDialogs_data()
    {
        QTest::addColumn<std::function<void(QWidget &)>>("run");
        using Run = std::function<void(QWidget &)>;
        QTest::newRow("menu") << Run([](QWidget &window) {
            QMenu menu(&window);
            menu.addMenu(QStringLiteral("more"))->addAction(QStringLiteral("one"));
            menu.exec(window.mapToGlobal(QPoint(200, 200)));
        });
        QTest::newRow("message") << Run([](QWidget &window) {
            QMessageBox box(QMessageBox::Question, QStringLiteral("Title"), QStringLiteral("Text"),
                QMessageBox::Ok, &window);
            box.exec();
        });
        QTest::newRow("dialog") << Run([](QWidget &window) { QDialog(&window).exec(); });
        QTest::newRow("file") << Run([](QWidget &window) { QFileDialog(&window).exec(); });
        QTest::newRow("list") << Run([](QWidget &window) {
            QComboBox &box = *window.findChild<QComboBox *>(QStringLiteral("baud"));
            box.setEnabled(true);
            box.showPopup();
        });
    }
    void escapeStopsInTheLoopsOfMenusAndDialogs()
    {
        QFETCH(const std::function<void(QWidget &)>, run);
        bool pressed = false;
        QTimer hand;
        connect(&hand, &QTimer::timeout, this, [&] {
            const QWidget *popup = QApplication::activePopupWidget();
            const QWidget *modal = QApplication::activeModalWidget();
            const bool focused = modal && QGuiApplication::focusWindow() == modal->windowHandle();
            if ((popup || focused) && !std::exchange(pressed, true))
                QVERIFY(Hands::key("Escape"));
        });
        hand.start(kStep_ms);
        run(m_rig->window);
        QTRY_VERIFY_WITH_TIMEOUT(pressed, kLong_ms);
        QTRY_COMPARE_WITH_TIMEOUT(m_stops->size(), 1, kLong_ms);
        QTRY_VERIFY_WITH_TIMEOUT(
            !QApplication::activePopupWidget() && !QApplication::activeModalWidget(), kLong_ms);
        QCOMPARE(m_stops->size(), 1);
    }

    void theStopButtonsStopTheMotorWhileADialogIsOpen_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"stopMotors", "stop"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void theStopButtonsStopTheMotorWhileADialogIsOpen()
    {
        QFETCH(QString, name);
        const auto *button = m_rig->window.findChild<QWidget *>(name);
        QVERIFY(button);
        start();
        QDialog dialog(&m_rig->window);
        dialog.resize(200, 100);
        dialog.open();
        const auto shown = [&name] {
            for (const QWidget *window : QApplication::topLevelWidgets())
                if (window->objectName() == name + QStringLiteral("OnTop"))
                    return QTest::qWaitForWindowExposed(window->windowHandle(), kLong_ms);
            return false;
        };
        QTRY_VERIFY_WITH_TIMEOUT(shown(), kLong_ms);
        m_stops->clear();
        QVERIFY(Hands::move(button->mapToGlobal(button->rect().center())));
        QVERIFY(Hands::press());
        QTRY_COMPARE_WITH_TIMEOUT(m_stops->size(), 1, kLong_ms); // before it is let go
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, kLong_ms);
        QVERIFY(Hands::release());
        QTRY_COMPARE_WITH_TIMEOUT(QGuiApplication::mouseButtons(), Qt::NoButton, kLong_ms);
        QVERIFY(dialog.isVisible());
        QTRY_COMPARE_WITH_TIMEOUT(QGuiApplication::focusWindow(), dialog.windowHandle(), kLong_ms);
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    MotorState state() { return device().status(1).state; }

    QModelIndex rowOf(QTreeView &tree, const char *name)
    {
        auto &model = m_rig->workbench.registers();
        const auto id = model.idOf(name);
        const auto *proxy = qobject_cast<QSortFilterProxyModel *>(tree.model());
        if (!id || !proxy)
            return {};
        const QModelIndex row = proxy->mapFromSource(model.indexOf(*id));
        tree.scrollTo(row);
        return row;
    }

    /// By a click, as its age counts; again where a computer stood still for so long that it was too old.
    void arm()
    {
        auto *box = m_rig->find<QCheckBox>("arm");
        QTRY_VERIFY_WITH_TIMEOUT(box->isEnabled(), kLong_ms);
        constexpr int kTries = 4;
        for (int i = 0; i < kTries && !device().armed(); ++i) {
            QVERIFY(Hands::move(box->mapToGlobal(QPoint(8, box->height() / 2))));
            QVERIFY(Hands::press());
            QVERIFY(Hands::release());
            (void)QTest::qWaitFor([this] { return device().armed(); }, kLong_ms / kTries);
        }
    }

    void start()
    {
        arm();
        QVERIFY(device().armed());
        for (const auto act :
            {judge::Act::Kind::Arm, judge::Act::Kind::Input, judge::Act::Kind::Confirm})
            m_rig->boards.act(act); // no input of this test, but the user's
        device().submit(drive::Command{drive::MotorAction::Start, 1});
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Running, kLong_ms);
    }

    std::unique_ptr<facts::WindowRig> m_rig;
    std::unique_ptr<QSignalSpy> m_stops;
};

static int runTest(int argc, char *argv[])
{
    const support::XServer server;
    if (!server.runs())
        qFatal("Xvfb does not start");
    qputenv("DISPLAY", server.display());
    qputenv("QT_QPA_PLATFORM", "xcb");
    widgets::Application application(argc, argv);
    TestStopUnderX11 test;
    return QTest::qExec(&test, argc, argv);
}
static const support::NamedTest namedTest(__FILE__, runTest);
#include "tst_stop_under_x11_posix.moc"
