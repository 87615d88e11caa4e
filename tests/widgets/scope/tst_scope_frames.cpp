// How often the scope draws: not at all unseen, seldom while nothing is driven, at once for a hand.
#include "support/scope_bench.h"
#include "support/scope_window.h"
#include "support/screen/text_catcher.h"
#include "widgets/measuring/spectrum_panel.h"

#include <QAction>
#include <QElapsedTimer>
#include <QSignalSpy>

using drive::MotorState;

class TestScopeFrames : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_rig = std::make_unique<facts::ScopeWindow>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_rig->record(7000, [](int, int tick) { return tick % 7; }); // more than fits
        m_rig->draw();
    }
    void cleanup() { m_rig.reset(); }

    /// At once, not with the next beat.
    void whatStoodBeforeThePortWasOpenedIsNoValueInTheLegend()
    {
        const auto legend = [this] {
            support::TextCatcher texts(view().shapesSize());
            view().drawShapes(texts);
            return texts.caught().filter(QStringLiteral("I_A  ")).value(0);
        };
        const auto beat = [this] { Q_EMIT m_rig->workbench.heartbeat(widgets::Milliseconds(0)); };
        beat();
        QVERIFY2(legend().contains(QLatin1Char('6')), qPrintable(legend()));
        m_rig->device().portChanged(session::PortState::Closed, {});
        beat();
        // Said to be old elsewhere.
        QVERIFY2(legend().contains(QLatin1Char('6')), qPrintable(legend()));
        m_rig->device().portChanged(session::PortState::Open, {});
        QVERIFY2(!legend().contains(QLatin1Char('6')), qPrintable(legend()));
    }

    void nobodySeesIt_data()
    {
        QTest::addColumn<bool>("minimised");
        QTest::newRow("hidden") << false;
        QTest::newRow("minimised") << true;
    }
    void nobodySeesIt()
    {
        QFETCH(bool, minimised);
        whileAnotherDrawsSomeFrames(); // what was under way
        if (minimised)
            m_rig->window.showMinimized();
        else
            m_rig->window.hide();
        const quint64 before = view().redraws();
        const double then = view().visibleRange().to;
        whileAnotherDrawsSomeFrames();
        view().redraw(); // nor for anything else
        whileAnotherDrawsSomeFrames();
        QCOMPARE(view().redraws(), before);
        m_rig->window.showNormal();
        QTRY_COMPARE(view().redraws(), before + 1);
        QVERIFY(view().visibleRange().to > then + 0.1); // with all that came meanwhile
        settled();
        QCOMPARE(view().redraws(), before + 1);
    }

    void nothingOfAToolIsDrawnUnseen_data() { nobodySeesIt_data(); }
    void nothingOfAToolIsDrawnUnseen()
    {
        QFETCH(bool, minimised);
        m_rig->find<QAction>("spectrumDockOpen")->trigger();
        auto *panel = m_rig->window.findChild<widgets::SpectrumPanel *>();
        const auto beat = [&] {
            record();
            Q_EMIT m_rig->workbench.heartbeat({});
        };
        const QSignalSpy seen(panel, &widgets::SpectrumPanel::shown);
        QTRY_VERIFY((beat(), !seen.isEmpty()));
        if (minimised)
            m_rig->window.showMinimized();
        else
            m_rig->window.hide();
        whileAnotherDrawsSomeFrames(); // what was under way
        const QSignalSpy unseen(panel, &widgets::SpectrumPanel::shown);
        for (int i = 0; i < 3; ++i) {
            beat();
            whileAnotherDrawsSomeFrames();
        }
        QCOMPARE(unseen.size(), 0);
        m_rig->window.showNormal();
        QTRY_VERIFY((beat(), !unseen.isEmpty()));
    }

    void everySampleIsKeptUnseen()
    {
        m_rig->window.showMinimized();
        const capture::ChannelId id = m_rig->id(facts::kCurrentA);
        const auto before = m_rig->workbench.capture().size(id);
        for (int i = 0; i < 100; ++i) {
            record();
            QCoreApplication::processEvents();
        }
        QCOMPARE(m_rig->workbench.capture().size(id), before + std::size_t{100} * kBatch);
    }

    void aPictureThatIsTakenUnseenIsOfNow()
    {
        m_rig->window.hide();
        const double then = view().visibleRange().to;
        record();
        QPixmap paper(view().shapesSize());
        view().drawShapes(paper);
        QVERIFY(view().visibleRange().to > then);
    }

    void atMostTwentyASecondWhileNoMotorIsDriven()
    {
        for (const MotorState state :
            {MotorState::Idle, MotorState::FaultNow, MotorState::FaultOver}) {
            facts::feed(m_rig->device(), {facts::status(state)});
            whileAnotherDrawsSomeFrames();
            const double apart = apartOf(8);
            QVERIFY2(apart >= 45.0, qPrintable(QString::number(apart)));
        }
    }

    void moreWhileOneIs()
    {
        facts::feed(m_rig->device(), {facts::status(MotorState::Running)});
        QTRY_VERIFY_WITH_TIMEOUT(apartOf(8) < 45.0, 60000); // however busy the machine is
        facts::feed(m_rig->device(), {facts::status(MotorState::Idle)});
        whileAnotherDrawsSomeFrames();
        const double apart = apartOf(8);
        QVERIFY2(apart >= 45.0, qPrintable(QString::number(apart)));
    }

    void aHandIsFollowedAtOnce()
    {
        record(); // a frame that has time
        const auto soon = [this] {
            QElapsedTimer clock;
            const quint64 before = view().redraws();
            clock.start();
            view().time().zoom(0.9);
            while (view().redraws() == before)
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
            return clock.elapsed() < 40;
        };
        QTRY_VERIFY(soon() && soon() && soon());
    }

private:
    widgets::ScopeView &view() { return m_rig->scope(); }
    void record()
    {
        m_rig->record(kBatch, [](int, int tick) { return tick % 7; });
    }
    void settled()
    {
        for (int round = 0; round < 5; ++round)
            QCoreApplication::processEvents();
    }
    /// Samples come, and time passes that can be counted in frames.
    void whileAnotherDrawsSomeFrames()
    {
        facts::Bench other({facts::signal(1, "A")});
        other.view.addChannel(other.id(1));
        while (other.view.redraws() < 8) {
            other.record(10, 1);
            record();
            QCoreApplication::processEvents();
        }
    }
    /// Milliseconds between two of so many frames of a stream. The mean: it is seen when they end, and one takes longer
    /// than another.
    double apartOf(int frames)
    {
        const quint64 before = view().redraws();
        const auto run = [this](quint64 until) {
            while (view().redraws() < until) {
                record();
                QCoreApplication::processEvents();
            }
        };
        run(before + 1);
        QElapsedTimer clock;
        clock.start();
        run(before + 1 + quint64(frames));
        return double(clock.nsecsElapsed()) / 1e6 / frames;
    }

    static constexpr int kBatch = 50;
    std::unique_ptr<facts::ScopeWindow> m_rig;
};

QTEST_MAIN(TestScopeFrames)
#include "tst_scope_frames.moc"
