// What the window does in several steps, without the window: opening, replacing and exporting, with the test's answers.
#include "session/recording/file.h"
#include "support/answered_files.h"
#include "support/answered_questions.h"
#include "widgets/files/export_order.h"
#include "widgets/files/marker_file.h"
#include "widgets/files/recording_control.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"
#include "widgets/window/exporting.h"
#include "widgets/window/leaving.h"
#include "widgets/window/opening.h"
#include "widgets/window/replacing.h"
#include "widgets/window/workbench.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThread>
#include <QtTest>

#include <atomic>

using widgets::Banner;

namespace {

void writeRecording(const QString &path)
{
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", "board"});
    QVERIFY(file.open());
    file.add(0, capture::StreamLayout{1, 1000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    file.add(0, capture::SampleBlock{1, 0, 5000, std::vector<std::int16_t>(5000, 7), {}, 0});
    QVERIFY(file.end());
}

/// With an outline at its end, in which one sample is a peak.
void writeLarge(const QString &path)
{
    QFile::remove(path);
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", "board"});
    QVERIFY(file.open());
    file.add(0, capture::StreamLayout{1, 1000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    for (capture::Tick i = 0; i < 10; ++i) {
        std::vector<std::int16_t> codes(40'000, 7);
        codes[12'345] = i == 5 ? 400 : 7;
        file.add(i, capture::SampleBlock{1, i * 40'000, 40'000, std::move(codes), {}, 0});
    }
    QVERIFY(file.end());
}

struct Flows {
    widgets::Workbench bench;
    QWidget host; ///< for actions and the line of the recording
    widgets::ScopeView scope{bench.capture(), bench.events(), &host};
    widgets::SignalSelection selection{bench.device(), bench.capture(), bench.signalPlan(), scope};
    facts::AnsweredPrompt files;
    facts::AnsweredQuestions questions;
    bool connecting = false;
    widgets::RecordingControl record{
        {bench.recording(), bench.device(), bench.events(), files, [] { return 0.0; }}, {}, &host};
    widgets::MarkerFile markers{bench.events(), files, record, &host};
    widgets::Leaving leaving{bench.device(), [this] { return bench.sessionTime(); }, questions};
    widgets::Replacing replacing{{bench, markers, record, questions}};
    widgets::Exporting exporting{{bench, scope, files, replacing, questions, nullptr}, {}};
    widgets::Opening opening{
        {bench, selection, markers, leaving, replacing, files, [this] { return connecting; },
            [] { return QString(); }, [] { return QString(); }, questions, nullptr}};
};

} // namespace

class TestFlows : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_flows = std::make_unique<Flows>();
        m_folder = std::make_unique<QTemporaryDir>();
        m_said.clear();
        const auto hear = [this](Banner::Kind kind, const QString &sentence) {
            m_kind = kind;
            m_said = sentence;
        };
        connect(&m_flows->opening, &widgets::Opening::said, this, hear);
        connect(&m_flows->exporting, &widgets::Exporting::said, this, hear);
        m_path = m_folder->filePath(QStringLiteral("a.pcapng"));
        writeRecording(m_path);
        m_flows->files.answer = m_path;
    }
    void cleanup()
    {
        QThreadPool::globalInstance()->waitForDone();
        QCoreApplication::processEvents(); // what was read is used here
        m_flows.reset();
    }

    void aRecordingIsOpened()
    {
        QSignalSpy snapshots(&m_flows->opening, &widgets::Opening::snapshotsChanged);
        m_flows->opening.askForRecording();
        QTRY_VERIFY(m_said.startsWith(QStringLiteral("Opened ")));
        QCOMPARE(m_kind, Banner::Kind::Note);
        QVERIFY(plan().showsFile());
        QCOMPARE(m_flows->scope.channels().size(), 1);
        QCOMPARE(snapshots.size(), 1);
        QCOMPARE(m_flows->opening.snapshots().path, m_path);
        QVERIFY(m_flows->questions.open.empty());
    }

    void aLargeRecordingHasItsOutlineFirst()
    {
        writeLarge(m_path);
        const auto opening = forLarge();
        bool outlined = false;
        connect(opening.get(), &widgets::Opening::outlineShown, &m_flows->exporting,
            &widgets::Exporting::setOutline);
        QSignalSpy refused(&m_flows->exporting, &widgets::Exporting::said);
        connect(opening.get(), &widgets::Opening::said, this, [&](Banner::Kind, const QString &) {
            const auto &capture = m_flows->bench.capture();
            if (std::exchange(outlined, true))
                return;
            QVERIFY(capture.channels().at(0).name == "A (overview)");
            QCOMPARE(capture.extremes(lastId(), 0.0, 400.0).max, 40.0F);
            QVERIFY(capture.size(lastId()) < 20'000);
            m_flows->exporting.ask(); // extremes are no samples
            QCOMPARE(refused.size(), 1);
            QVERIFY(refused.at(0).at(1).toString().contains(QLatin1String("still being read")));
        });
        opening->openPath(m_path);
        QTRY_VERIFY(plan().showsFile() && m_flows->bench.capture().size(lastId()) == 400'000);
        QVERIFY(outlined);
        QCOMPARE(m_flows->bench.capture().info(lastId())->name, std::string("A"));
    }

    void anOutlineGoesWhereTheRestCannotBeRead()
    {
        writeLarge(m_path);
        const auto opening = forLarge();
        QStringList said;
        connect(opening.get(), &widgets::Opening::said, this,
            [&](Banner::Kind, const QString &sentence) {
                said.append(sentence);
                QFile::remove(m_path); // a drive that was pulled, say
            });
        opening->openPath(m_path);
        QTRY_COMPARE(said.size(), 2);
        QTRY_VERIFY(m_flows->bench.capture().channels().empty());
        QVERIFY(opening->shown().isEmpty());
    }

    void nothingTakesThePlaceOfAConnection()
    {
        m_flows->connecting = true;
        const QSignalSpy left(&m_flows->opening, &widgets::Opening::disconnectWanted);
        for (const auto ask : {&widgets::Opening::askForRecording, &widgets::Opening::askForReplay,
                 &widgets::Opening::askForCsv}) {
            (m_flows->opening.*ask)();
            (m_flows->opening.*ask)(); // once is enough
            QCOMPARE(m_flows->questions.open.size(), std::size_t{1});
            QVERIFY(m_flows->questions.asks("disconnectQuestion"));
            m_flows->questions.withdraw("disconnectQuestion");
        }
        QCOMPARE(left.size(), 0);
        QVERIFY(!plan().showsFile());
    }

    void aConnectionIsLeftFirstWhereThatIsWanted()
    {
        m_flows->connecting = true;
        std::function<void()> goOn;
        connect(&m_flows->opening, &widgets::Opening::disconnectWanted, this,
            [&goOn](const std::function<void()> &next) { goOn = next; });
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Disconnect and go on")));
        QVERIFY(goOn);
        m_flows->opening.whenDisconnected(goOn);
        QVERIFY(m_said.isEmpty()); // its port is not closed yet
        m_flows->connecting = false;
        Q_EMIT m_flows->bench.device().portStateChanged();
        QTRY_VERIFY(m_said.startsWith(QStringLiteral("Opened ")));
        QVERIFY(plan().showsFile());
    }

    /// Who says no to the second question has the board still.
    void whatItHoldsIsAskedAboutBeforeAConnectionIsLeft()
    {
        sample();
        m_flows->connecting = true;
        std::vector<std::function<void()>> left;
        connect(&m_flows->opening, &widgets::Opening::disconnectWanted, this,
            [&left](const std::function<void()> &next) { left.push_back(next); });
        for (const auto ask : {&widgets::Opening::askForRecording, &widgets::Opening::askForReplay,
                 &widgets::Opening::askForCsv}) {
            (m_flows->opening.*ask)();
            QVERIFY(m_flows->questions.answer(QStringLiteral("&Disconnect and go on")));
            QVERIFY(m_flows->questions.asks("replaceQuestion"));
            QVERIFY(m_flows->questions.answer({}));
            QVERIFY(left.empty());
        }
        m_flows->opening.openPath(m_path);
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Disconnect and go on")));
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Replace")));
        QCOMPARE(left.size(), std::size_t{1});
        m_flows->connecting = false;
        m_flows->opening.whenDisconnected(left.front());
        QVERIFY(m_flows->questions.open.empty()); // it was answered
        QTRY_VERIFY(plan().showsFile());
    }

    void anAnswerIsForOneTimeOnly()
    {
        sample();
        m_flows->connecting = true;
        std::function<void()> goOn;
        connect(&m_flows->opening, &widgets::Opening::disconnectWanted, this,
            [&goOn](const std::function<void()> &next) { goOn = next; });
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Disconnect and go on")));
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Replace")));
        m_flows->files.answer.clear(); // no file is chosen
        m_flows->connecting = false;
        m_flows->opening.whenDisconnected(goOn);
        QVERIFY(m_flows->questions.open.empty());
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.asks("replaceQuestion"));
    }

    void aConnectionThatCameMeanwhileStays()
    {
        m_flows->opening.askForRecording();
        m_flows->connecting = true; // while it is read
        QThreadPool::globalInstance()->waitForDone();
        QCoreApplication::processEvents();
        QVERIFY(!plan().showsFile());
        QVERIFY(m_said.isEmpty());
    }

    void aReplayIsHandedOn()
    {
        QSignalSpy wanted(&m_flows->opening, &widgets::Opening::replayWanted);
        m_flows->opening.askForReplay();
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(wanted.front().front().toString(), m_path);
        m_flows->files.answer = m_folder->filePath(QStringLiteral("text"));
        QFile other(m_flows->files.answer);
        QVERIFY(other.open(QIODevice::WriteOnly) && other.write("no recording") > 0);
        other.close();
        m_flows->opening.askForReplay();
        QCOMPARE(wanted.size(), 1);
        QVERIFY(m_said.endsWith(QStringLiteral("is no recording of Rotorscope.")));
    }

    void samplesThatAreInNoFileAreAskedAbout()
    {
        sample();
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.asks("replaceQuestion"));
        QVERIFY(m_flows->questions.usual().isEmpty()); // Cancel
        QVERIFY(m_flows->questions.answer({}));
        QVERIFY(!plan().showsFile());
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Replace")));
        QTRY_VERIFY(plan().showsFile());
    }

    void exportingFirstIsOffered()
    {
        QSignalSpy wanted(&m_flows->replacing, &widgets::Replacing::exportWanted);
        sample();
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Export first\u2026")));
        QCOMPARE(wanted.size(), 1);
        QVERIFY(!plan().showsFile());
    }

    void whatWasExportedIsNotAskedAbout()
    {
        sample();
        exportAll();
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.open.empty());
        QTRY_VERIFY(plan().showsFile());
    }

    void changedMarkersAreAskedAbout()
    {
        m_flows->opening.askForRecording();
        QTRY_VERIFY(plan().showsFile());
        m_flows->bench.events().add(widgets::EventKind::Marker, 2.0, QStringLiteral("here"));
        int gone = 0;
        m_flows->replacing.beforeMarkersGo([&gone] { ++gone; });
        QVERIFY(m_flows->questions.asks("markersQuestion"));
        m_flows->replacing.beforeMarkersGo([&gone] { ++gone; }); // is asked already
        QCOMPARE(m_flows->questions.open.size(), std::size_t(1));
        QVERIFY(m_flows->questions.answer({}));
        QCOMPARE(gone, 0);
        m_flows->replacing.beforeMarkersGo([&gone] { ++gone; });
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Leave unsaved")));
        QCOMPARE(gone, 1);
    }

    void clearingAsksWhereOpeningDoes()
    {
        sample();
        m_flows->replacing.clear();
        QVERIFY(m_flows->questions.asks("clearQuestion"));
        QVERIFY(m_flows->questions.usual().isEmpty()); // neither Enter nor Esc clears
        QVERIFY(m_flows->questions.answer({}));
        QVERIFY(m_flows->bench.capture().timeSpan());
        m_flows->replacing.clear();
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Clear")));
        QVERIFY(!m_flows->bench.capture().timeSpan());
        m_flows->replacing.clear(); // there is nothing left to ask about
        QVERIFY(m_flows->questions.open.empty());
    }

    void clearingAsksForMarkersOfAFile()
    {
        m_flows->opening.askForRecording();
        QTRY_VERIFY(plan().showsFile());
        m_flows->bench.events().add(widgets::EventKind::Marker, 2.0, QStringLiteral("here"));
        m_flows->replacing.clear();
        QVERIFY(plan().showsFile());
        QVERIFY(m_flows->questions.answer(QStringLiteral("&Leave unsaved")));
        QVERIFY(!plan().showsFile());
        QVERIFY(m_flows->bench.events().events().empty());
    }

    void anExportIsTold()
    {
        QSignalSpy exported(&m_flows->exporting, &widgets::Exporting::exported);
        sample();
        const QString path = exportAll();
        QCOMPARE(exported.size(), 1);
        QCOMPARE(m_kind, Banner::Kind::Note);
        QCOMPARE(m_flows->exporting.folder(), m_folder->path());
        QVERIFY(QFile::exists(path));
    }

    void anExportWithoutSamplesIsToldAsSuch()
    {
        QSignalSpy exported(&m_flows->exporting, &widgets::Exporting::exported);
        sample(); // of the first 0.1 s
        carryOut(m_folder->filePath(QStringLiteral("late.csv")), capture::TimeSpan{100.0, 200.0});
        QTRY_VERIFY2(m_said.contains(QStringLiteral("holds no samples")), qPrintable(m_said));
        QCOMPARE(m_kind, Banner::Kind::Warning);
        QCOMPARE(exported.size(), 0);
    }

    void anExportThatFailedIsToldAndNothingIsTakenForKept()
    {
        sample();
        carryOut(m_folder->filePath(QStringLiteral("no such folder/a.csv")));
        QTRY_COMPARE(m_kind, Banner::Kind::Warning);
        m_flows->opening.askForRecording();
        QVERIFY(m_flows->questions.asks("replaceQuestion"));
    }

    void closingOverAnExportAsks()
    {
        QSignalSpy closes(&m_flows->exporting, &widgets::Exporting::closeWanted);
        QVERIFY(m_flows->exporting.mayClose());
        std::atomic<bool> written = false;
        const auto job = [&written](const widgets::FileJob::Proceed &proceed) {
            while (proceed(0.5) && !written)
                QThread::yieldCurrentThread();
            return widgets::FileJob::Finish();
        };
        m_flows->exporting.write(QStringLiteral("one"), job);
        QVERIFY(!m_flows->exporting.mayClose());
        QCOMPARE(m_flows->questions.usual(), QStringLiteral("Close when it is written"));
        QVERIFY(m_flows->questions.answer({})); // stays
        QVERIFY(!m_flows->exporting.mayClose());
        QVERIFY(m_flows->questions.answer(m_flows->questions.usual()));
        QCOMPARE(closes.size(), 0);
        written = true;
        QTRY_COMPARE(closes.size(), 1);
        QVERIFY(m_flows->exporting.mayClose());

        written = false;
        m_flows->exporting.write(QStringLiteral("two"), job);
        QVERIFY(!m_flows->exporting.mayClose());
        QVERIFY(m_flows->questions.answer(QStringLiteral("Close without it")));
        QCOMPARE(closes.size(), 2);
        QVERIFY(m_flows->exporting.mayClose()); // it is cancelled
    }

    void aQuestionAboutAnExportGoesWithIt()
    {
        std::atomic<bool> written = false;
        m_flows->exporting.write(
            QStringLiteral("one"), [&written](const widgets::FileJob::Proceed &proceed) {
                while (proceed(0.5) && !written)
                    QThread::yieldCurrentThread();
                return widgets::FileJob::Finish();
            });
        QVERIFY(!m_flows->exporting.mayClose());
        QVERIFY(m_flows->questions.asks("exportQuestion"));
        written = true;
        QTRY_VERIFY(!m_flows->questions.asks("exportQuestion"));
    }

private:
    capture::ChannelId lastId() const { return m_flows->bench.capture().channels().back().id; }
    /// Shows the outline of files of any size.
    std::unique_ptr<widgets::Opening> forLarge()
    {
        Flows &f = *m_flows;
        return std::make_unique<widgets::Opening>(widgets::Opening::Parts{f.bench, f.selection,
            f.markers, f.leaving, f.replacing, f.files, [] { return false; },
            [] { return QString(); }, [] { return QString(); }, f.questions, nullptr, {}, 1});
    }
    widgets::SignalPlan &plan() { return m_flows->bench.signalPlan(); }

    /// As of a connection that is over.
    void sample()
    {
        capture::Capture &capture = m_flows->bench.capture();
        capture.begin({1, 1000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
        capture.append({1, 0, 100, std::vector<std::int16_t>(100, 7), {}, 0});
        QVERIFY(capture.timeSpan());
    }
    void carryOut(const QString &path, std::optional<capture::TimeSpan> range = {})
    {
        widgets::ExportOrder order;
        order.format = session::exportFormatOf(path);
        order.path = path;
        order.range = range;
        std::vector<capture::ChannelId> ids;
        for (const auto &info : m_flows->bench.capture().channels())
            ids.push_back(info.id);
        order.parts = {{path, m_flows->bench.capture().snapshot(ids)}};
        m_flows->exporting.carryOut(order);
    }
    QString exportAll()
    {
        QString path = m_folder->filePath(QStringLiteral("all.csv"));
        carryOut(path);
        [this] { QTRY_VERIFY(m_said.startsWith(QStringLiteral("Exported to "))); }();
        return path;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    std::unique_ptr<Flows> m_flows;
    QString m_said;
    Banner::Kind m_kind = Banner::Kind::Note;
};

QTEST_MAIN(TestFlows)
#include "tst_flows.moc"
