// Every entry of the menus and every tool, triggered once in the real window: without a board, with one whose motor
// rests, with one whose motor turns, and with a file. What is asked is left open while the board goes on, and then
// given up. Nothing may end the program, stay in the way, or take Stop away.
#include "support/window_rig.h"
#include "widgets/control/motion_gate.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"

#include <QAction>
#include <QCheckBox>
#include <QDialog>
#include <QSignalSpy>
#include <QTemporaryFile>

namespace {

enum class Beside { Nothing, Rest, Turning, File };

} // namespace

class TestEveryAction : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void cleanup() { m_rig.reset(); }
    void nothingEndsTheProgramOrStaysInTheWay_data();
    void nothingEndsTheProgramOrStaysInTheWay();

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    QStringList actions() const;
    void prepare(Beside beside);
    void giveUpWhatIsAsked();

    std::unique_ptr<facts::WindowRig> m_rig;
    QTemporaryFile m_csv;
};

void TestEveryAction::initTestCase()
{
    QVERIFY(m_csv.open());
    m_csv.write("Time [s],U [V]\n");
    for (int i = 0; i < 1000; ++i)
        m_csv.write(QByteArray::number(i / 1000.0) + ',' + QByteArray::number(i % 10) + '\n');
    QVERIFY(m_csv.flush());
}

void TestEveryAction::nothingEndsTheProgramOrStaysInTheWay_data()
{
    QTest::addColumn<int>("beside");
    QTest::newRow("no board") << int(Beside::Nothing);
    QTest::newRow("a motor at rest") << int(Beside::Rest);
    QTest::newRow("a motor that turns") << int(Beside::Turning);
    QTest::newRow("a file") << int(Beside::File);
}

QStringList TestEveryAction::actions() const
{
    QStringList names;
    for (const QAction *action : m_rig->window.findChildren<QAction *>())
        if (!action->objectName().isEmpty() && action->objectName() != QLatin1String("quit")
            && !action->objectName().startsWith(QLatin1String("qt_")))
            names.append(action->objectName());
    names.removeDuplicates();
    return names;
}

/// Again where an entry before has ended it.
void TestEveryAction::prepare(Beside beside)
{
    if (beside == Beside::Nothing)
        return;
    if (beside == Beside::File) {
        if (m_rig->window.scope()->channels().isEmpty()) {
            m_rig->files.answer = m_csv.fileName();
            m_rig->find<QAction>("importCsv")->trigger();
            m_rig->files.answer.clear();
            QTRY_VERIFY(!m_rig->window.scope()->channels().isEmpty());
        }
        return;
    }
    if (!device().portOpen())
        m_rig->window.connectBar()->connectOrDisconnect();
    QTRY_VERIFY(device().answering() && device().identified());
    if (beside == Beside::Rest || device().status(1).state == drive::MotorState::Running)
        return;
    auto *arm = m_rig->find<QCheckBox>("arm");
    QTRY_VERIFY(arm->isEnabled());
    if (!arm->isChecked())
        QTest::mouseClick(arm, Qt::LeftButton);
    QTRY_VERIFY(m_rig->find<QPushButton>("start")->isEnabled());
    QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
    QTRY_VERIFY(device().status(1).state == drive::MotorState::Running);
}

void TestEveryAction::giveUpWhatIsAsked()
{
    for (int i = 0; i < 10 && QApplication::activePopupWidget() != nullptr; ++i)
        QApplication::activePopupWidget()->close();
    for (QWidget *window : QApplication::topLevelWidgets())
        if (auto *dialog = qobject_cast<QDialog *>(window); dialog && dialog->isVisible())
            dialog->reject();
    for (auto *dialog : m_rig->window.findChildren<QDialog *>())
        if (dialog->isVisible())
            dialog->reject();
    QCoreApplication::processEvents();
}

void TestEveryAction::nothingEndsTheProgramOrStaysInTheWay()
{
    QFETCH(int, beside);
    const auto with = static_cast<Beside>(beside);
    m_rig = std::make_unique<facts::WindowRig>();
    m_rig->sayYesToMotion();
    QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    prepare(with);
    QSignalSpy states(&device(), &widgets::Device::statusChanged);
    int triggered = 0;
    for (const QString &name : actions()) {
        auto *action = m_rig->window.findChild<QAction *>(name);
        if (action == nullptr || !action->isEnabled())
            continue;
        m_rig->boards.act(judge::Act::Kind::Input);
        action->trigger();
        ++triggered;
        const qsizetype before = states.size();
        if (device().portOpen())
            QTRY_VERIFY2(states.size() > before + 1 || !device().portOpen(), qPrintable(name));
        giveUpWhatIsAsked();
        QVERIFY2(QApplication::activeModalWidget() == nullptr, qPrintable(name));
        const auto *stop = m_rig->find<QAbstractButton>("stopMotors");
        QVERIFY2(stop->isVisible() && stop->isEnabled() && !stop->visibleRegion().isEmpty(),
            qPrintable(name));
        prepare(with);
    }
    QVERIFY2(triggered > 30, qPrintable(QString::number(triggered)));
}

QTEST_MAIN(TestEveryAction)
#include "tst_every_action.moc"
