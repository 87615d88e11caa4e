// The workbench without a window: it connects to a simulated board, records, computes, triggers and exports.
#include "session/files/export_formats.h"
#include "widgets/window/workbench.h"

#include <QCoreApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include <algorithm>

using widgets::Workbench;

class TestWorkbench : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_bench = std::make_unique<Workbench>();
        m_bench->device().open(session::endpointFor(QStringLiteral("sim"), 1843200));
        QTRY_VERIFY_WITH_TIMEOUT(m_bench->device().answering(), 20'000);
        QTRY_VERIFY_WITH_TIMEOUT(seconds() > 0.2, 20'000);
    }
    void cleanup()
    {
        m_bench->device().close();
        QTRY_VERIFY(!m_bench->device().portOpen());
        m_bench.reset();
    }

    void noWidgetIsNeeded() { QVERIFY(!QCoreApplication::instance()->inherits("QGuiApplication")); }

    void whatIsToldIsInTheCapture()
    {
        int blocks = 0;
        const QObject here; // the bench goes on storing behind this
        connect(m_bench.get(), &Workbench::samplesStored, &here,
            [&](const capture::SampleBlock &block) {
                const auto streaming = capture().streaming();
                QVERIFY(!streaming.empty());
                const capture::Channel &channel = *capture().channel(streaming.front());
                QVERIFY(channel.size() >= block.count);
                ++blocks;
            });
        QTRY_VERIFY(blocks > 3);
        QCOMPARE(m_bench->signalPlan().wanted().size(), std::size_t(4)); // those of a first look
    }

    void itIsRecordedToADisk()
    {
        session::RecordingResult result;
        bool over = false;
        const QObject here;
        connect(&m_bench->recording(), &session::Recording::finished, &here,
            [&](const session::RecordingResult &told) {
                result = told;
                over = true;
            });
        const QString path = m_folder.filePath(QStringLiteral("a.pcapng"));
        m_bench->recording().start(path, session::RecordingTap::Content::Samples,
            QStringLiteral("tst_workbench"), QStringLiteral("simulated board"));
        const double from = seconds();
        QTRY_VERIFY(seconds() > from + 0.2);
        m_bench->recording().stop();
        QTRY_VERIFY(over);
        QCOMPARE(result.outcome, session::RecordingOutcome::Stopped);
        QVERIFY(result.complete);
        QVERIFY(QFile(path).size() > 1000);
    }

    void whatIsComputedIsTriggeredOn()
    {
        QVERIFY(m_bench->math().set(QStringLiteral("Sum"), QStringLiteral("I_A + 1000 * I_B")));
        const auto sum = [this] { return m_bench->math().entries().front().channel; };
        QTRY_VERIFY(sum() != 0 && capture().size(sum()) > 0);
        widgets::Trigger &trigger = m_bench->trigger();
        std::vector<scope::Record> records;
        const QObject here;
        connect(&trigger, &widgets::Trigger::recordCompleted, &here,
            [&records](const scope::Record &record) { records.push_back(record); });
        trigger.setSource(sum());
        widgets::TriggerSetup setup = trigger.setup();
        setup.mode = scope::Mode::Single;
        setup.level = 1e9; // a board that stands still never gets there
        trigger.setSetup(setup);
        QVERIFY(trigger.state() == scope::AcquisitionState::Armed);
        const double armed = seconds();
        QTRY_VERIFY(seconds() > armed + 0.2);
        QVERIFY(records.empty());
        trigger.force();
        QTRY_COMPARE(records.size(), std::size_t(1));
        QVERIFY(records.front().cause == scope::Record::Cause::Forced);
        QVERIFY(!trigger.running()); // a single one
        QVERIFY(trigger.state() == scope::AcquisitionState::Stop);
    }

    void itIsExported()
    {
        std::vector<capture::ChannelId> ids;
        for (const capture::ChannelId id : capture().streaming())
            ids.push_back(id);
        const QString path = m_folder.filePath(QStringLiteral("a.csv"));
        const auto outcome =
            session::exportFormatOf(path)->write(path, {capture().snapshot(ids), {}}, {});
        QCOMPARE(outcome.file.error, session::FileError::None);
        QVERIFY(outcome.rows > 100);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readLine().startsWith("time [s],"));
    }

    void theConnectionIsNoted()
    {
        const auto &events = m_bench->events().events();
        QVERIFY(std::any_of(events.begin(), events.end(),
            [](const auto &event) { return event.kind == widgets::EventKind::Recovery; }));
    }

    void allIsForgottenTogether()
    {
        widgets::Trigger &trigger = m_bench->trigger();
        trigger.setSource(capture().streaming().front());
        trigger.setMode(scope::Mode::Auto);
        QTRY_VERIFY(!trigger.history().records().empty());
        m_bench->signalPlan().clear();
        QVERIFY(trigger.history().records().empty());
        QVERIFY(!capture().timeSpan());
        QTRY_VERIFY(seconds() > 0.0); // recording goes on
    }

private:
    capture::Capture &capture() { return m_bench->capture(); }
    double seconds() // recorded
    {
        const auto span = capture().timeSpan();
        return span ? span->to - span->from : 0.0;
    }

    QTemporaryDir m_folder;
    std::unique_ptr<Workbench> m_bench;
};

QTEST_GUILESS_MAIN(TestWorkbench)
#include "tst_workbench.moc"
