// From place to place in what was recorded, by the trigger's own condition.
#include "support/scope_window.h"
#include "widgets/base/banner.h"
#include "widgets/base/fields/value_edit.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/trigger/control.h"
#include "widgets/window/searching.h"

#include <QAction>
#include <QSignalSpy>

class TestSearching : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        // I_A: 10 A for 50 ms from each second on, but for the third.
        m_rig->record(8000, [](int signal, int tick) {
            return signal == 0 && tick % 1000 < 50 && tick / 1000 != 3 && tick >= 1000 ? 10 : 0;
        });
        view().setRunning(false);
        m_flow = m_rig->window.findChild<widgets::Searching *>();
        m_said = std::make_unique<QSignalSpy>(m_flow, &widgets::Searching::said);
        setTrigger(widgets::TriggerType::Edge, 5.0);
    }
    void cleanup()
    {
        m_said.reset();
        m_rig.reset();
    }

    void itGoesFromPlaceToPlace()
    {
        view().setVisibleRange(0.0, 8.0);
        for (const double place : {1.0, 2.0, 4.0, 5.0, 6.0, 7.0}) {
            next();
            const auto seen = view().visibleRange();
            QCOMPARE(qRound(seen.span() * 1e6), 8'000'000);
            QVERIFY(std::abs((seen.from + seen.to) / 2 - place) < 1e-3);
            QVERIFY(sentence().contains(QStringLiteral("met at")));
        }
        next();
        QVERIFY(sentence().contains(QStringLiteral("not met")));
        QVERIFY(std::abs((view().visibleRange().from + view().visibleRange().to) / 2 - 7.0) < 1e-3);
    }

    void itBeginsWhereThePictureDoes()
    {
        view().setVisibleRange(4.5, 4.7);
        next();
        QVERIFY(view().visibleRange().has(5.0));
        view().setVisibleRange(0.2, 0.4); // somewhere else: the last place does not count
        next();
        QVERIFY(view().visibleRange().has(1.0));
    }

    void anotherConditionBeginsAnew()
    {
        view().setVisibleRange(0.0, 8.0);
        next();
        next();
        setTrigger(widgets::TriggerType::Level, 5.0);
        view().setVisibleRange(0.0, 8.0);
        next();
        QVERIFY(view().visibleRange().has(1.0));
        QVERIFY(!sentence().contains(QStringLiteral("2.0")));
    }

    void aFileIsSearchedByTheFieldsOfTheBar()
    {
        capture::Capture file;
        const auto trace = file.addImported("I", "A");
        for (int i = 0; i < 4000; ++i)
            file.appendImported(
                trace, i * 1'000'000LL, i / 1000 % 2 == 1 ? 3.0 : 0.0, (i + 1) * 1'000'000LL);
        auto *level = m_rig->find<widgets::ValueEdit>("triggerLevel");
        QVERIFY(!level->isVisible());
        m_rig->window.selection()->showFile(std::move(file));
        QVERIFY(level->isVisible());
        setTrigger(widgets::TriggerType::Edge, 2.0);
        view().setVisibleRange(0.0, 0.5);
        next();
        QVERIFY(view().visibleRange().has(1.0));
        next();
        QVERIFY(view().visibleRange().has(3.0));
    }

    void anEventIsNotInTheSamples()
    {
        setTrigger(widgets::TriggerType::Fault, 0.0);
        action()->trigger();
        QVERIFY(sentence().contains(QStringLiteral("list of events")));
    }

    void nothingRecordedIsNothingMet()
    {
        m_rig->workbench.capture().clear();
        action()->trigger();
        QVERIFY(sentence().contains(QStringLiteral("not met")));
    }

    void thePictureStaysAtTheUsersPlaceWhileItIsSearched()
    {
        view().setVisibleRange(0.0, 8.0);
        action()->trigger();
        QCOMPARE(view().visibleRange().to, 8.0); // what is found is told by an event
        action()->trigger(); // the first one ends
        QTRY_VERIFY(!m_said->isEmpty());
        QVERIFY(sentence().contains(QStringLiteral("met at")));
    }

    void theWindowClosesOverASearch()
    {
        action()->trigger();
        m_said.reset();
        m_rig.reset();
    }

    void itsKeyIsHeardOnTheScope()
    {
        view().setVisibleRange(0.0, 8.0);
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_N);
        QTRY_VERIFY(!m_said->isEmpty());
    }

private:
    widgets::ScopeView &view() { return m_rig->scope(); }
    QAction *action() { return m_rig->find<QAction>("nextTrigger"); }
    QString sentence() { return m_said->last().at(1).toString(); }
    void next()
    {
        const auto before = m_said->size();
        action()->trigger();
        QTRY_COMPARE(m_said->size(), before + 1);
    }
    void setTrigger(widgets::TriggerType type, double level)
    {
        auto *control = m_rig->window.findChild<widgets::TriggerControl *>();
        widgets::TriggerSetup setup = control->trigger().setup();
        setup.type = type;
        setup.level = level;
        setup.hysteresis = 1.0;
        control->setSetup(setup);
    }

    std::unique_ptr<facts::ScopeWindow> m_rig;
    widgets::Searching *m_flow = nullptr;
    std::unique_ptr<QSignalSpy> m_said;
};

QTEST_MAIN(TestSearching)
#include "tst_searching.moc"
