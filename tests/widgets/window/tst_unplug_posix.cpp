// A board on a (pseudo) serial port whose cable is pulled in the middle of a packet while its motor turns: the window
// says so, believes nothing any more, moves nothing, and finds the board again when it is back.
#include "support/board_on_terminal.h"
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/base/lamp.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSemaphore>
#include <QTemporaryDir>
#include <QThread>

using drive::MotorState;
using support::BoardOnTerminal;

namespace {

constexpr int kPatience = 20000; // a busy machine is slow, not wrong

/// The board in a thread of its own: a busy window must not be the reason why it is silent.
class BoardInThread {
public:
    BoardInThread()
    {
        m_context.moveToThread(&m_thread);
        m_thread.start();
        call([this] {
            simulation::BoardOptions options;
            options.baud = kBaud;
            m_board = std::make_unique<BoardOnTerminal>(options);
            m_path = m_board->path();
        });
    }
    ~BoardInThread()
    {
        call([this] { m_board.reset(); });
        m_thread.quit();
        m_thread.wait();
    }

    static constexpr quint32 kBaud = 230400;

    const QString &path() const { return m_path; }
    void unplugInTheMiddle()
    {
        call([this] { m_board->unplugInTheMiddle(); });
    }
    bool unplugged()
    {
        bool is = false;
        call([this, &is] { is = m_board->unplugged(); });
        return is;
    }

private:
    template <class Function>
    void call(Function function)
    {
        QSemaphore done; // ThreadSanitizer does not see the one in a blocking connection
        const auto work = [&] {
            function();
            done.release();
        };
        QMetaObject::invokeMethod(&m_context, work, Qt::QueuedConnection);
        done.acquire();
    }

    QThread m_thread;
    QObject m_context;
    std::unique_ptr<BoardOnTerminal> m_board;
    QString m_path;
};

} // namespace

class TestUnplug : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("board"));
        plugIn();
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.port = m_path;
        settings.baud = BoardInThread::kBaud;
        m_rig = std::make_unique<facts::WindowRig>(settings);
        m_rig->sayYesToMotion();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    }
    void cleanup()
    {
        m_rig.reset();
        m_board.reset();
        m_folder.reset();
    }

    void aPulledCableIsToldAndThePluggedOneFoundAgain()
    {
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(device().answering() && device().identified(), kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(m_rig->window.scope()->channels().size(), 4, kPatience);
        QTest::keyClick(m_rig->find<QCheckBox>("arm"), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(m_rig->find<QPushButton>("start")->isEnabled(), kPatience);
        QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(device().status(1).state, MotorState::Running, kPatience);

        m_wishes.clear();
        connect(&device(), &widgets::Device::wishMade, this,
            [this](const drive::Wish &wish) { m_wishes.push_back(wish); });
        m_board->unplugInTheMiddle();
        QTRY_VERIFY_WITH_TIMEOUT(m_board->unplugged(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!device().portOpen(), kPatience);
        auto *banner = m_rig->find<widgets::Banner>("banner");
        QTRY_VERIFY_WITH_TIMEOUT(banner->isVisible(), kPatience);
        QVERIFY2(banner->text().contains(QStringLiteral("unplugged")), qPrintable(banner->text()));
        QVERIFY(banner->text().contains(QStringLiteral("may still be turning")));
        QVERIFY(!device().armed());
        QVERIFY(!m_rig->find<QPushButton>("start")->isEnabled());
        QCOMPARE(m_rig->find<widgets::Lamp>("portLamp")->text(), QStringLiteral("port not open"));
        QVERIFY(
            !m_rig->workbench.registers().shownValue(*device().catalog()->resolve("BUS_VOLTAGE")));
        // It is being looked for.
        QCOMPARE(m_rig->find<QPushButton>("connect")->text(), QStringLiteral("Disconnect"));

        plugIn();
        QTRY_VERIFY_WITH_TIMEOUT(device().answering() && device().portOpen(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!banner->isVisible(), kPatience);
        QVERIFY(!device().armed());
        const auto channel = m_rig->workbench.capture().find(*device().catalog()->resolve("I_A"));
        QVERIFY(channel);
        const auto before = m_rig->workbench.capture().size(*channel);
        QTRY_VERIFY_WITH_TIMEOUT(
            m_rig->workbench.capture().size(*channel) > before + 1000, kPatience);
        for (const drive::Wish &wish : m_wishes) // nothing moves by itself
            QVERIFY(std::holds_alternative<drive::Stream>(wish.what)
                || std::holds_alternative<drive::Watch>(wish.what));
    }

    void aPortThatIsNotThereIsOneSentence()
    {
        m_rig->window.connectBar()->setEndpoint(
            m_folder->filePath(QStringLiteral("nothing")), 115200);
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(m_rig->find<widgets::Banner>("banner")->isVisible(), kPatience);
        QVERIFY(
            m_rig->find<QLabel>("bannerText")->text().contains(QStringLiteral("There is no port")));
        QTRY_COMPARE_WITH_TIMEOUT(
            m_rig->find<QPushButton>("connect")->text(), QStringLiteral("Connect"), kPatience);
    }

    void enterInThePortFieldConnects()
    {
        QLineEdit *typed = m_rig->find<QComboBox>("port")->lineEdit();
        typed->setFocus();
        typed->selectAll();
        QTest::keyClicks(typed, m_path);
        QTest::keyClick(typed, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(device().portOpen(), kPatience);
        QCOMPARE(device().endpoint().path, m_path);
    }

    void whatIsNotABaudRateIsRefusedBeforeAnythingIsOpened()
    {
        m_rig->window.connectBar()->setEndpoint(m_path, 115200);
        m_rig->find<QComboBox>("baud")->setEditText(QStringLiteral("fast"));
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QVERIFY(
            m_rig->find<QLabel>("bannerText")->text().contains(QStringLiteral("not a baud rate")));
        QVERIFY(!device().portOpen());
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    void plugIn()
    {
        m_board = std::make_unique<BoardInThread>();
        QFile::remove(m_path);
        QVERIFY(QFile::link(m_board->path(), m_path));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    std::unique_ptr<BoardInThread> m_board;
    std::unique_ptr<facts::WindowRig> m_rig;
    std::vector<drive::Wish> m_wishes;
};

QTEST_MAIN(TestUnplug)
#include "tst_unplug_posix.moc"
