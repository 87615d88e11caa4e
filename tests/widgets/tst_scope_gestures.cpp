// Signals are moved from plot to plot by hand in the real window, and the recording does not notice.
#include "support/scope_window.h"
#include "widgets/signal_selection.h"

#include <QSignalSpy>

class TestScopeGestures : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        QCoreApplication::processEvents(); // what the new board was asked for
        m_rig->record(1000, [](int, int tick) { return tick % 100; });
        m_rig->draw();
    }
    void cleanup() { m_rig.reset(); }

    void aMovedTraceStartsNoNewStream();
    void aSignalThatIsThereAlreadyIsNotStartedAnew();
    void plotsStayWhereAHandPutThemWhenTheRecordingIsCleared();

private:
    widgets::ScopeView &scope() { return m_rig->scope(); }
    int plotOf(catalog::RegisterId id) { return scope().plotOf(m_rig->id(id)); }
    QPoint legendOf(int plot)
    {
        return m_rig->plot().mapFrom(&scope(), scope().plotRect(plot).topLeft() + QPoint(20, 12));
    }
    QPoint below() { return {m_rig->plot().width() / 2, m_rig->plot().height() - 3}; }

    std::unique_ptr<facts::ScopeWindow> m_rig;
};

void TestScopeGestures::aMovedTraceStartsNoNewStream()
{
    QSignalSpy wishes(&m_rig->device(), &widgets::Device::wishMade);
    QCOMPARE(plotOf(facts::kCurrentA), plotOf(facts::kCurrentB));
    m_rig->drag(legendOf(0), below());
    QCoreApplication::processEvents();
    QCOMPARE(plotOf(facts::kCurrentA), 1);
    QCOMPARE(plotOf(facts::kCurrentB), 0);
    for (const auto &wish : wishes)
        QVERIFY(!std::holds_alternative<drive::Stream>(wish[0].value<drive::Wish>().what));
    m_rig->record(100, [](int, int) { return 7; });
    QCOMPARE(m_rig->workbench.capture().size(m_rig->id(facts::kCurrentA)), 1100U);
}

void TestScopeGestures::aSignalThatIsThereAlreadyIsNotStartedAnew()
{
    QSignalSpy wishes(&m_rig->device(), &widgets::Device::wishMade);
    Q_EMIT scope().registerDropped(facts::kCurrentB, 0); // where it is
    QCoreApplication::processEvents();
    Q_EMIT scope().registerDropped(facts::kCurrentB, -1); // beside all plots
    QCoreApplication::processEvents();
    QCOMPARE(plotOf(facts::kCurrentB), 1);
    for (const auto &wish : wishes)
        QVERIFY(!std::holds_alternative<drive::Stream>(wish[0].value<drive::Wish>().what));
}

void TestScopeGestures::plotsStayWhereAHandPutThemWhenTheRecordingIsCleared()
{
    m_rig->drag(legendOf(0), below());
    m_rig->draw();
    m_rig->drag(legendOf(0), m_rig->plot().mapFrom(&scope(), scope().plotRect(1).center()));
    QCOMPARE(scope().plotCount(), 1); // the one it left is gone
    m_rig->draw();
    m_rig->drag(legendOf(0), below());
    QCOMPARE(scope().plotCount(), 2);
    const int a = plotOf(facts::kCurrentA);
    m_rig->window.findChild<widgets::SignalSelection *>()->clearRecorded();
    QCOMPARE(scope().plotCount(), 2);
    QCOMPARE(plotOf(facts::kCurrentA), a);
    QCOMPARE(plotOf(facts::kCurrentB), 1 - a);
}

QTEST_MAIN(TestScopeGestures)
#include "tst_scope_gestures.moc"
