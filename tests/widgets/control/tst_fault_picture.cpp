// A fault in the real window: one click shows what was recorded around it, also after everything was cleared.
#include "support/judged_line.h"
#include "support/window_rig.h"
#include "widgets/scope/time_window.h"
#include "widgets/scope/view.h"

#include <QComboBox>
#include <QLabel>
#include <QToolButton>

class TestFaultPicture : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void init()
    {
        m_world = std::make_unique<support::JudgedWorld>(
            simulation::BoardOptions(), drive::Protocol::Mcp);
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.port = QStringLiteral("/dev/ttyTest");
        settings.protocol = QStringLiteral("mcp");
        m_rig =
            std::make_unique<facts::WindowRig>(settings, session::makeDiskSink, m_world->parts());
        m_rig->window.resize(1280, 720);
        m_world->act(judge::Act::Kind::Input);
        m_rig->find<QPushButton>("connect")->click();
        QTRY_VERIFY_WITH_TIMEOUT(recorded() > 0.3, 20'000);
    }
    void cleanup()
    {
        m_rig.reset();
        m_world.reset();
    }

    void oneClickShowsWhatWasRecordedAroundIt()
    {
        auto *causes = m_rig->find<QToolButton>("faultCauses");
        QVERIFY(!causes->isVisible());
        m_world->fault = 0x0002;
        QTRY_VERIFY_WITH_TIMEOUT(causes->isVisible(), 20'000);
        causes->click();
        auto *help = m_rig->find<QWidget>("faultHelp");
        QVERIFY(help && help->isVisible());
        const auto picture = [help] { return help->findChild<widgets::ScopeView *>(); };
        QTRY_VERIFY_WITH_TIMEOUT(picture() != nullptr && picture()->isVisible(), 20'000);
        QCOMPARE(picture()->channels().size(), m_rig->window.scope()->channels().size());
        const auto range = picture()->visibleRange();
        const double zero = picture()->time().origin();
        QCOMPARE(range.from, zero - 1.0);
        QCOMPARE(range.to, zero + 0.5);
        const QString says = help->findChild<QLabel *>(QStringLiteral("faultRecordSays"))->text();
        QVERIFY2(says.contains(QStringLiteral("I_Q_MEAS")), qPrintable(says));
        QVERIFY(!help->grab().isNull());

        m_rig->workbench.signalPlan().clear(); // what the scope shows is gone, and this stays
        const auto shown = picture()->channels();
        QVERIFY(!shown.isEmpty());
        auto *choice = help->findChild<QComboBox *>(QStringLiteral("faultRecord"));
        QVERIFY(choice != nullptr);
        QCOMPARE(choice->count(), 1);
        QVERIFY(choice->currentText().contains(QStringLiteral("motor 1")));
    }

    /// Else its Stop is below the edge of a small screen.
    void isNoLargerThanTheWindow()
    {
        m_rig->window.resize(960, 540);
        m_world->fault = 0x0002;
        auto *causes = m_rig->find<QToolButton>("faultCauses");
        QTRY_VERIFY_WITH_TIMEOUT(causes->isVisible(), 20'000);
        causes->click();
        auto *help = m_rig->find<QWidget>("faultHelp");
        QVERIFY(help && help->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(help->findChild<widgets::ScopeView *>() != nullptr, 20'000);
        QVERIFY2(
            help->height() <= m_rig->window.height(), qPrintable(QString::number(help->height())));
        auto *stop = help->findChild<QWidget *>(QStringLiteral("faultHelpStop"));
        QVERIFY(help->rect().contains(stop->geometry()));
    }

    void withoutAFaultNothingIsDrawn()
    {
        m_rig->find<QAction>("explainFaults")->trigger();
        auto *help = m_rig->find<QWidget>("faultHelp");
        QVERIFY(help && help->isVisible());
        auto *choice = help->findChild<QComboBox *>(QStringLiteral("faultRecord"));
        QVERIFY(choice && !choice->isVisible());
        QVERIFY(help->findChild<widgets::ScopeView *>() == nullptr);
    }

private:
    double recorded() const
    {
        const auto span = m_rig->workbench.capture().timeSpan();
        return span ? span->to - span->from : 0.0;
    }

    std::unique_ptr<support::JudgedWorld> m_world;
    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestFaultPicture)
#include "tst_fault_picture.moc"
