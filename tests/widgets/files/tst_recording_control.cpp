// Recording to a disk and opening it again, through the real window, the real session thread and the simulated board.
#include "session/files/snapshot_json.h"
#include "session/recording/reader.h"
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/base/lamp.h"
#include "widgets/control/motion_log_model.h"
#include "widgets/control/stop_words.h"
#include "widgets/files/open_recording.h"
#include "widgets/files/recording_control.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/ghosts.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"

#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTranslator>

#include <atomic>

using widgets::Banner;
using widgets::Lamp;

namespace {

/// A disk that is full after so many blocks.
class SmallDisk : public session::BlockSink {
public:
    SmallDisk(std::unique_ptr<BlockSink> inner, int blocks, qint64 free = 1'000'000'000)
        : m_inner(std::move(inner))
        , m_blocks(blocks)
        , m_free(free)
    {
    }
    bool append(ByteView bytes) override { return m_blocks-- > 0 && m_inner->append(bytes); }
    bool overwrite(std::size_t offset, ByteView bytes) override
    {
        return m_inner->overwrite(offset, bytes);
    }
    bool sync() override { return m_inner->sync(); }
    qint64 freeBytes() const override { return m_free; }
    bool isFull() const override { return true; }
    QString systemText() const override { return QStringLiteral("No space left on device"); }

private:
    std::unique_ptr<BlockSink> m_inner;
    int m_blocks;
    qint64 m_free;
};

std::unique_ptr<session::BlockSink> smallDisk(const QString &path, QString &text)
{
    auto inner = session::makeDiskSink(path, text);
    return inner ? std::make_unique<SmallDisk>(std::move(inner), 4) : nullptr;
}

/// A megabyte above what a recording leaves free for others.
std::unique_ptr<session::BlockSink> tightDisk(const QString &path, QString &text)
{
    auto inner = session::makeDiskSink(path, text);
    const qint64 free = session::RecordingLimits().endBytes + 1'000'000;
    return inner ? std::make_unique<SmallDisk>(std::move(inner), 1'000'000, free) : nullptr;
}

} // namespace

class TestRecordingControl : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_rig.reset(); }
    void cleanup() { m_rig.reset(); }

    void withoutAConnectionThereIsNothingToRecord()
    {
        makeRig();
        QVERIFY(!action("record")->isEnabled());
        QVERIFY(action("record")->toolTip().startsWith(QStringLiteral("Connect first")));
        QVERIFY(!line()->isVisible());
    }

    void whatIsRecordedOpensAgain()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("a.pcapng"));
        record(path);
        QVERIFY(m_rig->files.asked.suggestedName.endsWith(QStringLiteral("_motor.pcapng")));
        QTRY_VERIFY(line()->text().contains(QStringLiteral(" MB, ")));
        QVERIFY(line()->text().contains(QStringLiteral("a.pcapng: 0:00:0")));
        QVERIFY(line()->isVisible());
        QVERIFY(action("record")->isChecked());
        QVERIFY(eventTexts().contains(QStringLiteral("Recording to a.pcapng")));
        auto &events = scope()->events();
        const double now = capture().timeSpan()->to;
        scope()->cursorActions().setMarkerAt(now);
        const auto marker = std::find_if(events.events().begin(), events.events().end(),
            [](const auto &event) { return event.kind == widgets::EventKind::Marker; });
        QVERIFY(marker != events.events().end());
        events.setText(marker->id, QStringLiteral("look here"));
        const auto before = capture().timeSpan()->to;
        QTRY_VERIFY(capture().timeSpan()->to > before + 0.3);
        QTest::keyClick(&m_rig->window, Qt::Key_R, Qt::ControlModifier);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        QVERIFY(!action("record")->isChecked());
        QVERIFY(!line()->isVisible());
        QVERIFY(device().answering());

        capture::Capture independent;
        const auto report = session::readRecording(path, independent);
        QVERIFY(report.has_value());
        QVERIFY(report->damage.empty() && report->ending);
        QCOMPARE(report->ending->reason, recorded::End::Reason::Stopped);
        QVERIFY(report->samples > 1000);
        QCOMPARE(report->notes.back().text, std::string("look here"));

        disconnectFromBoard();
        openRecording(path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        QCOMPARE(banner()->kind(), Banner::Kind::Note);
        QCOMPARE(capture().channels().size(), independent.channels().size());
        QVERIFY(scope()->channels().size() >= 4);
        compare(capture(), independent);
        chooseOfFile();
        QVERIFY(eventTexts().contains(QStringLiteral("look here")));
        QCOMPARE(eventTexts().count(QStringLiteral("look here")), 1);
        QVERIFY(!eventTexts().contains(QStringLiteral("Recording to a.pcapng"))); // of before
        const auto range = scope()->visibleRange(); // of what is shown: what was streamed
        for (const auto &info : independent.channels()) {
            const auto span = independent.timeSpan(info.id);
            QVERIFY(info.kind == capture::ChannelInfo::Kind::Polled
                || (range.from <= span->from && range.to >= span->to));
        }
    }

    /// They were of the board that is gone.
    void theWordsOfAStopGoWhenAFileIsOpened()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("stopped.pcapng"));
        recordAfresh(path);
        action("record")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        auto *words = m_rig->find<widgets::StopWords>("stopWords");
        device().stop();
        QTRY_VERIFY(words->isVisible() && words->rested());
        disconnectFromBoard();
        QVERIFY(words->isVisible()); // until something else is in their place
        openRecording(path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        QVERIFY(!words->isVisible());
        QCOMPARE(words->text(), QString());
    }

    void whatTheRegistersHeldIsInTheFileAndCanBeCompared()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("registers.pcapng"));
        record(path);
        QTRY_COMPARE(snapshotsIn(path).size(), 1U); // without the user's asking
        m_rig->workbench.snapshots().make(); // as before a list of writes
        QTRY_COMPARE(m_rig->workbench.snapshots().kept().size(), 1U);
        QTest::keyClick(&m_rig->window, Qt::Key_R, Qt::ControlModifier);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));

        const auto recorded = snapshotsIn(path);
        QCOMPARE(recorded.size(), 2U);
        const auto all = session::readSnapshotJson(QByteArray::fromStdString(recorded[0].json));
        QVERIFY(all && all->entries.size() > 50 && all->find("SPEED_KP", 1) != nullptr);
        QCOMPARE(recorded[1].title, std::string("before a write"));

        disconnectFromBoard();
        openRecording(path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        // What was read for them is no signal.
        QVERIFY(capture().channels().size() < 20);
        m_rig->window.findChild<QAction *>(QStringLiteral("snapshotsDockOpen"))->trigger();
        auto *a = m_rig->find<QComboBox>("snapshotA");
        auto *b = m_rig->find<QComboBox>("snapshotB");
        const int first = a->findText(QStringLiteral("registers.pcapng at "), Qt::MatchStartsWith);
        QVERIFY(first > 0);
        QVERIFY(a->itemText(first + 1).startsWith(QStringLiteral("registers.pcapng at ")));
        choose(a, first);
        choose(b, first + 1);
        QCOMPARE(m_rig->find<QLabel>("snapshotSummary")->text(), QStringLiteral("No differences."));
        // Opened again, it is listed once.
        openRecording(path);
        QTRY_COMPARE(a->currentIndex(), -1);
        QCOMPARE(a->findText(QStringLiteral("registers.pcapng at "), Qt::MatchStartsWith), first);
    }

    void whatWasDoneToAMotorIsInTheFile()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("motion.pcapng"));
        record(path);
        QTRY_VERIFY(line()->text().contains(QStringLiteral(" MB, ")));
        device().setArmed(true);
        QTRY_VERIFY(device().armed());
        m_rig->acts.noteArming();
        m_rig->boards.act(judge::Act::Kind::Input); // a click on what follows
        device().submit(drive::Command{drive::MotorAction::AcknowledgeFaults, 1});
        device().setArmed(false);
        QTRY_VERIFY(m_rig->workbench.motionLog().rowCount() >= 3);
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        capture::Capture independent;
        const auto report = session::readRecording(path, independent);
        std::vector<std::string> acts;
        for (const auto &[at, happening] : report->happenings)
            if (happening.name == "motion")
                acts.push_back(happening.fields.front().second);
        QVERIFY(std::count(acts.begin(), acts.end(), "ARM") == 1);
        QVERIFY(std::count(acts.begin(), acts.end(), "FAULT_ACK") == 1);
        QVERIFY(std::count(acts.begin(), acts.end(), "DISARM") == 1);
    }

    void samplesThatAreNowhereElseAreAskedAbout()
    {
        makeRig();
        connectToBoard();
        disconnectFromBoard();
        const auto live = capture().channels().front().id;
        m_rig->files.answer = m_folder.filePath(QStringLiteral("a.pcapng"));
        QTest::keyClick(&m_rig->window, Qt::Key_O, Qt::ControlModifier);
        auto *question = m_rig->find<QMessageBox>("replaceQuestion");
        QVERIFY(question);
        QTest::keyClick(question, Qt::Key_Return); // neither Enter nor Esc replaces
        QTRY_VERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
        QVERIFY(capture().channel(live));
        m_rig->find<QAction>("importCsv")->trigger();
        question = m_rig->find<QMessageBox>("replaceQuestion");
        QVERIFY(question);
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
        QVERIFY(capture().channel(live));
        openRecording(m_folder.filePath(QStringLiteral("a.pcapng"))); // says yes
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        QVERIFY(!capture().channel(live));
        // What is on a disk already goes without a question.
        action("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
    }

    void whatIsAllInTheRecordingIsNotAskedAbout()
    {
        makeRig();
        connectToBoard();
        recordAfresh(m_folder.filePath(QStringLiteral("all.pcapng")));
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        const quint32 marker = markerId();
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        m_rig->files.answer.clear();
        action("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
        // A text that is in no file is worth the question.
        const QString before = scope()->events().find(marker)->text;
        scope()->events().setText(marker, QStringLiteral("after the end"));
        action("openRecording")->trigger();
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question);
        QVERIFY(question->text().contains(QStringLiteral("all.pcapng")));
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        // Nor does a recording count that is no longer there.
        scope()->events().setText(marker, before);
        action("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(QFile::resize(m_folder.filePath(QStringLiteral("all.pcapng")), 1000));
        action("openRecording")->trigger();
        QVERIFY(m_rig->find<QMessageBox>("replaceQuestion"));
    }

    /// While its file is being closed: it is in no file until it is saved.
    void aMarkerOfTheLastMomentIsAskedAboutAndSaved()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("late.pcapng"));
        recordAfresh(path);
        connect(&device(), &widgets::Device::portStateChanged, this, [this] {
            if (!device().portOpen())
                scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        });
        disconnectFromBoard();
        QVERIFY(markerId() != 0);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        m_rig->files.answer.clear();
        action("openRecording")->trigger();
        QVERIFY(m_rig->find<QMessageBox>("markersQuestion"));
        QTest::mouseClick(m_rig->find<QPushButton>("saveMarkersFirst"), Qt::LeftButton);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Saved with its markers")));
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        capture::Capture independent;
        const auto report = session::readRecording(path, independent);
        QVERIFY(report && report->ending && report->damage.empty());
        QCOMPARE(report->notes.size(), std::size_t(1));
        action("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
    }

    void aMarkerThatIsDeletedAfterTheEndLeavesTheFile()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("deleted.pcapng"));
        recordAfresh(path);
        const double time = capture().timeSpan()->to;
        scope()->cursorActions().setMarkerAt(time - 0.1);
        scope()->cursorActions().setMarkerAt(time);
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        QCOMPARE(notesIn(path), std::size_t(2));
        QVERIFY(!action("saveMarkers")->isEnabled());
        QVERIFY(scope()->events().removeMarker(markerId()));
        QVERIFY(action("saveMarkers")->isEnabled());
        action("openRecording")->trigger();
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question);
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        action("saveMarkers")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Saved with its markers")));
        QCOMPARE(notesIn(path), std::size_t(1));
        QVERIFY(!action("saveMarkers")->isEnabled());
        m_rig->files.answer.clear();
        action("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(!m_rig->find<QMessageBox>("replaceQuestion")); // the samples are in it as before
    }

    void markersOfBeforeARecordingCanBeToldToIt()
    {
        makeRig();
        connectToBoard();
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        const QString path = m_folder.filePath(QStringLiteral("before.pcapng"));
        recordAfresh(path);
        QVERIFY(action("saveMarkers")->isEnabled());
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to); // goes there by itself
        QVERIFY(!m_rig->window.close());
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question && question->text().contains(QStringLiteral("before it began")));
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        action("saveMarkers")->trigger();
        QVERIFY(!action("saveMarkers")->isEnabled());
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        QCOMPARE(notesIn(path), std::size_t(2));
        QVERIFY(!action("saveMarkers")->isEnabled());
    }

    /// Each is in the file of its time; that is where it stays.
    void aSecondRecordingAsksForNothingOfTheFirst()
    {
        makeRig();
        connectToBoard();
        recordAfresh(m_folder.filePath(QStringLiteral("first.pcapng")));
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        action("record")->trigger();
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("first.pcapng")));
        const QString second = m_folder.filePath(QStringLiteral("second.pcapng"));
        recordAfresh(second);
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        QVERIFY(!action("saveMarkers")->isEnabled());
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("second.pcapng")));
        QVERIFY(!action("saveMarkers")->isEnabled());
        QCOMPARE(notesIn(second), std::size_t(1));
    }

    void anExportHoldsNoMarkers()
    {
        makeRig();
        connectToBoard();
        disconnectFromBoard();
        m_rig->files.answer = m_folder.filePath(QStringLiteral("all.csv"));
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        m_rig->find<QComboBox>("exportRange")->setCurrentIndex(1);
        QTest::mouseClick(m_rig->find<QPushButton>("exportSave"), Qt::LeftButton);
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("all.csv")));
        m_rig->files.answer.clear();
        action("openRecording")->trigger();
        QVERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        action("openRecording")->trigger();
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question);
        QVERIFY(question->text().contains(QStringLiteral("not saved")));
    }

    void whatCameBeforeOrAfterTheRecordingIsAskedAbout_data()
    {
        QTest::addColumn<bool>("before");
        QTest::newRow("before it") << true;
        QTest::newRow("after it") << false;
    }
    void whatCameBeforeOrAfterTheRecordingIsAskedAbout()
    {
        QFETCH(bool, before);
        makeRig();
        connectToBoard();
        const QString path =
            m_folder.filePath(before ? QStringLiteral("c.pcapng") : QStringLiteral("d.pcapng"));
        if (before)
            record(path);
        else
            recordAfresh(path);
        QTRY_VERIFY(line()->text().contains(QStringLiteral(" MB, ")));
        if (!before) {
            action("record")->trigger();
            QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
            const auto ended = capture().timeSpan()->to;
            QTRY_VERIFY(capture().timeSpan()->to > ended + 0.2);
        }
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        m_rig->files.answer.clear();
        action("openRecording")->trigger();
        auto *question = m_rig->find<QMessageBox>("replaceQuestion");
        QVERIFY(question);
        QVERIFY(question->text().contains(QStringLiteral("not exported")));
    }

    void whatHasNoRoomInMemoryIsTold()
    {
        const QString path = m_folder.filePath(QStringLiteral("long.pcapng"));
        QString text;
        session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", ""});
        QVERIFY(file.open());
        file.add(0, capture::StreamLayout{1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
        for (capture::Tick tick = 0; tick < 500'000; tick += 1000)
            file.add(tick,
                capture::SampleBlock{
                    1, tick, 1000, std::vector<std::int16_t>(1000, std::int16_t(tick / 1000)), {}});
        QVERIFY(file.end());
        makeRig();
        QString sentence;
        bool whole = true;
        std::uint64_t kept = 0;
        widgets::openRecording(
            path, &m_rig->window,
            [&](widgets::OpenedRecording &opened) {
                sentence = widgets::openedText(opened, whole);
                kept = opened.capture.size(opened.capture.channels().front().id);
            },
            [](const QString &why) { QFAIL(qPrintable(why)); }, {.maxBytes = 600'000});
        QTRY_VERIFY(!sentence.isEmpty());
        QVERIFY(!whole);
        QVERIFY(kept > 100'000 && kept < 400'000);
        QVERIFY(sentence.contains(QString::number(500'000 - kept) + QStringLiteral(" samples")));
    }

    void whatADiskWasTooSlowForIsNamed()
    {
        widgets::OpenedRecording opened;
        opened.report.ending = recorded::End{};
        opened.report.lost.linkBytes = 4096;
        bool whole = true;
        const QString line = widgets::openedText(opened, whole);
        QVERIFY(!whole);
        QVERIFY2(line.contains(QLatin1String("It lacks 4096 bytes of the line, because")),
            qPrintable(line));
        opened.report.lost = {120, 0, 2};
        const QString both = widgets::openedText(opened, whole);
        QVERIFY2(both.contains(QLatin1String("120 samples, 2 other entries")), qPrintable(both));
        opened.report.lost = {1, 0, 0};
        const QString one = widgets::openedText(opened, whole);
        QVERIFY2(one.contains(QLatin1String("It lacks 1 sample, because")), qPrintable(one));
    }

    void whatADiskIsTooSlowForIsNamedMeanwhile()
    {
        makeRig();
        session::RecordingProgress progress;
        progress.lost.linkBytes = 4096;
        Q_EMIT m_rig->workbench.recording().progressed(progress);
        QVERIFY2(line()->text().endsWith(QLatin1String(", 4096 bytes of the line lost")),
            qPrintable(line()->text()));
    }

    void aConnectionAfterAnOpenedFileStartsAfresh()
    {
        makeRig();
        openRecording(m_folder.filePath(QStringLiteral("a.pcapng")));
        QTRY_VERIFY(!scope()->channels().isEmpty());
        const auto opened = capture().channels();
        connectToBoard();
        for (const auto &info : opened)
            QVERIFY(!capture().channel(info.id)); // ids are not used again
        QVERIFY(!eventTexts().contains(QStringLiteral("look here")));
        const auto &refused = capture().refused();
        QCOMPARE(
            refused.otherStream + refused.malformed + refused.backwards + refused.notFinite, 0U);
    }

    void aFullDiskEndsTheRecordingAndLeavesTheLink()
    {
        makeRig(&smallDisk);
        connectToBoard();
        record(m_folder.filePath(QStringLiteral("full.pcapng")));
        QTRY_COMPARE_WITH_TIMEOUT(line()->light(), Lamp::Light::Bad, 20'000);
        QVERIFY(line()->isVisible());
        QCOMPARE(banner()->kind(), Banner::Kind::Bad);
        QVERIFY(banner()->text().contains(QStringLiteral("full.pcapng")));
        QVERIFY(eventTexts().contains(QStringLiteral("Recording ended: disk full")));
        QVERIFY(!action("record")->isChecked());
        QVERIFY(device().answering());
        const auto before = capture().timeSpan()->to;
        QTRY_VERIFY(capture().timeSpan()->to > before + 0.2);
        QCOMPARE(device().counters().streamLostTicks, 0U);
        capture::Capture independent;
        const auto report =
            session::readRecording(m_folder.filePath(QStringLiteral("full.pcapng")), independent);
        QVERIFY(report && report->ending);
        QCOMPARE(report->ending->reason, recorded::End::Reason::DiskFull);
    }

    /// Not when the disk's last byte is gone: the recording ends before others suffer.
    void theTimeLeftIsThatOfTheRecording()
    {
        makeRig(&tightDisk);
        connectToBoard();
        record(m_folder.filePath(QStringLiteral("tight.pcapng")));
        QTRY_VERIFY2(line()->text().contains(QStringLiteral("disk full in 0:00:")),
            qPrintable(line()->text()));
        QCOMPARE(line()->light(), Lamp::Light::Waiting);
    }

    void recordingMakesNoWindowWider()
    {
        QTranslator german;
        QVERIFY(german.load(QStringLiteral(":/i18n/rotorscope_de")));
        QCoreApplication::installTranslator(&german);
        makeRig();
        m_rig->window.resize(1280, 720);
        connectToBoard();
        record(m_folder.filePath(QStringLiteral("wide.pcapng")));
        QTRY_VERIFY(line()->text().contains(QStringLiteral(" MB, ")));
        QCoreApplication::processEvents();
        QCOMPARE(m_rig->window.size(), QSize(1280, 720));
        m_rig.reset();
        QCoreApplication::removeTranslator(&german);
    }

    void aFileThatIsThereIsNotRecordedOver()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("there.pcapng"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("mine");
        file.close();
        record(path);
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("cannot be recorded")));
        QVERIFY(!action("record")->isChecked());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QCOMPARE(file.readAll(), QByteArray("mine"));
    }

    void whileConnectedNothingIsOpened()
    {
        makeRig();
        connectToBoard();
        openRecording(m_folder.filePath(QStringLiteral("a.pcapng")));
        QVERIFY(device().answering());
        QTest::mouseClick(m_rig->find<QPushButton>("disconnectAndGoOn"), Qt::LeftButton);
        const auto left = [this] {
            if (auto *replace = m_rig->find<QPushButton>("replaceYes"))
                QTest::mouseClick(replace, Qt::LeftButton); // what the board has sent until now
            return !device().portOpen();
        };
        QTRY_VERIFY(left());
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
    }

    /// A run of before is compared with the running picture; nothing is left for it.
    void whileConnectedARecordingIsAReference()
    {
        makeRig();
        connectToBoard();
        openRecording(m_folder.filePath(QStringLiteral("a.pcapng")));
        auto *beside = m_rig->find<QPushButton>("layAsReference");
        QVERIFY(beside);
        QTest::mouseClick(beside, Qt::LeftButton);
        QTRY_VERIFY2(banner()->text().contains(QStringLiteral("a.pcapng is reference A")),
            qPrintable(banner()->text()));
        QVERIFY(device().answering() && !m_rig->workbench.signalPlan().showsFile());
        QVERIFY(scope()->ghosts().isFromFile(widgets::Reference::A));
        const double before = capture().timeSpan()->to;
        QTRY_VERIFY(capture().timeSpan()->to > before + 0.2); // and the picture runs on
        QAction *next = action("nextEventA");
        QVERIFY(next->isEnabled() && !action("nextEventB")->isEnabled());
        action("openReference")->trigger(); // without the question: there is nothing to lose
        QTRY_VERIFY(scope()->ghosts().isFromFile(widgets::Reference::B));
    }

    void aFileThatIsNoRecordingLeavesThePicture()
    {
        makeRig();
        openRecording(m_folder.filePath(QStringLiteral("a.pcapng")));
        QTRY_VERIFY(!scope()->channels().isEmpty());
        const auto shown = scope()->channels();
        openRecording(m_folder.filePath(QStringLiteral("there.pcapng")));
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("cannot be opened")));
        // Why, whole.
        QVERIFY2(!banner()->text().contains(QChar(0x2026)), qPrintable(banner()->text()));
        QCOMPARE(scope()->channels(), shown);
        QVERIFY(capture().channel(shown.first()));
    }

    void disconnectingEndsTheFile()
    {
        makeRig();
        connectToBoard();
        const QString path = m_folder.filePath(QStringLiteral("b.pcapng"));
        record(path);
        QTRY_VERIFY(line()->text().contains(QStringLiteral(" MB, ")));
        scope()->cursorActions().setMarkerAt(capture().timeSpan()->to);
        QVERIFY(scope()->events().removeMarker(markerId())); // nor is it in the file
        disconnectFromBoard();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Recorded to ")));
        capture::Capture independent;
        const auto report = session::readRecording(path, independent);
        QVERIFY(report && report->ending);
        QVERIFY(report->notes.empty());
    }

    /// What was on the scope is there when its recording is opened, read one by one or not.
    void whatWasOnTheScopeIsShownOfTheFile()
    {
        makeRig();
        connectToBoard();
        const auto polled = device().catalog()->resolve("SPEED_MEAS");
        QVERIFY(polled);
        m_rig->window.selection()->add(*polled, 0);
        QTRY_VERIFY(capture().find(*polled) && scope()->plotOf(*capture().find(*polled)) >= 0);
        QVERIFY(
            capture().info(*capture().find(*polled))->kind == capture::ChannelInfo::Kind::Polled);
        const QString path = m_folder.filePath(QStringLiteral("polled.pcapng"));
        recordAfresh(path);
        disconnectFromBoard();
        openRecording(path);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        const auto channel = capture().find(*polled);
        QVERIFY(channel && scope()->plotOf(*channel) >= 0);
        QCOMPARE(scope()->channels().size(), 5); // and nothing else that was read for the tables
    }

    void durationsAreHoursMinutesSeconds()
    {
        QCOMPARE(widgets::durationText(0.9), QStringLiteral("0:00:00"));
        QCOMPARE(widgets::durationText(3723.2), QStringLiteral("1:02:03"));
        QCOMPARE(widgets::durationText(-1.0), QStringLiteral("0:00:00"));
    }

private:
    void makeRig(session::MakeSink sink = session::makeDiskSink)
    {
        m_rig =
            std::make_unique<facts::WindowRig>(facts::WindowRig::quietSettings(), std::move(sink));
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    }
    void connectToBoard()
    {
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_VERIFY(device().answering() && device().identified());
        QTRY_COMPARE(scope()->channels().size(), 4);
        QTRY_VERIFY(capture().size(scope()->channels().first()) > 1000);
    }
    /// What was only polled is not shown by itself, and can be.
    void chooseOfFile()
    {
        const qsizetype shown = scope()->channels().size();
        for (const auto id : scope()->channels())
            QVERIFY(capture().info(id)->kind != capture::ChannelInfo::Kind::Polled);
        auto *menu = m_rig->find<QMenu>("fileSignals");
        Q_EMIT qobject_cast<QMenu *>(menu->parentWidget())->aboutToShow();
        QVERIFY(menu->isEnabled());
        QCOMPARE(menu->actions().size(), qsizetype(capture().channels().size()));
        QAction *last = menu->actions().last();
        QVERIFY(last->text().contains(QStringLiteral("polled")) && !last->isChecked());
        menu->popup(m_rig->window.pos()); // one looks for several of them: it stays open
        const auto click = [menu](QAction *action) {
            menu->setActiveAction(action); // and is scrolled to
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        };
        click(last);
        QCOMPARE(scope()->channels().size(), shown + 1);
        QVERIFY(last->isChecked() && menu->isVisible());
        click(menu->actions().first());
        QCOMPARE(scope()->channels().size(), shown);
        QVERIFY(menu->isVisible());
        QTest::keyClick(menu, Qt::Key_Return);
        QCOMPARE(scope()->channels().size(), shown + 1);
        QTest::keyClick(menu, Qt::Key_Space);
        QCOMPARE(scope()->channels().size(), shown);
        QVERIFY(menu->isVisible());
        menu->close();
    }
    void disconnectFromBoard()
    {
        m_rig->window.connectBar()->disconnectNow();
        QTRY_VERIFY(!device().portOpen());
    }
    void record(const QString &path)
    {
        m_rig->files.answer = path;
        QTest::keyClick(&m_rig->window, Qt::Key_R, Qt::ControlModifier);
    }
    /// With nothing in the scope from before.
    void recordAfresh(const QString &path)
    {
        record(path);
        QTRY_VERIFY(line()->text().contains(QStringLiteral(" MB, ")));
        m_rig->workbench.signalPlan().clear();
        QTRY_VERIFY(capture().timeSpan().has_value());
        const auto first = capture().timeSpan()->from;
        QTRY_VERIFY(capture().timeSpan()->to > first + 0.3);
    }
    static std::vector<recorded::RegisterSnapshot> snapshotsIn(const QString &path)
    {
        capture::Capture independent;
        std::vector<recorded::RegisterSnapshot> found;
        if (const auto report = session::readRecording(path, independent))
            for (const auto &[at, what] : report->snapshots)
                found.push_back(what);
        return found;
    }
    static void choose(QComboBox *box, int index)
    {
        box->setCurrentIndex(index);
        Q_EMIT box->activated(index);
    }
    static std::size_t notesIn(const QString &path)
    {
        capture::Capture independent;
        const auto report = session::readRecording(path, independent);
        return report ? report->notes.size() : 99;
    }
    quint32 markerId()
    {
        for (const auto &event : scope()->events().events())
            if (event.kind == widgets::EventKind::Marker)
                return event.id;
        return 0;
    }
    void openRecording(const QString &path)
    {
        m_rig->files.answer = path;
        // Once a question was closed, nothing is active offscreen.
        action("openRecording")->trigger();
        if (auto *replace = m_rig->find<QPushButton>("replaceYes"))
            QTest::mouseClick(replace, Qt::LeftButton);
    }
    static void compare(const capture::Capture &a, const capture::Capture &b)
    {
        const auto ofA = a.channels(), ofB = b.channels();
        for (std::size_t c = 0; c < ofA.size(); ++c) {
            QCOMPARE(ofA[c].name, ofB[c].name);
            const capture::Channel *one = a.channel(ofA[c].id);
            const capture::Channel *other = b.channel(ofB[c].id);
            QCOMPARE(one->end() - one->begin(), other->end() - other->begin());
            for (capture::Index i = one->begin(); i < one->end(); ++i) {
                QCOMPARE(one->timeOf(i), other->timeOf(i));
                QCOMPARE(one->at(i), other->at(i));
            }
        }
    }

    QStringList eventTexts()
    {
        QStringList texts;
        for (const auto &event : scope()->events().events())
            texts.append(event.text);
        return texts;
    }
    QAction *action(const char *name) { return m_rig->find<QAction>(name); }
    Lamp *line() { return m_rig->find<Lamp>("recordLine"); }
    Banner *banner() { return m_rig->window.findChild<Banner *>(); }
    widgets::Device &device() { return m_rig->workbench.device(); }
    widgets::ScopeView *scope() { return m_rig->window.scope(); }
    capture::Capture &capture() { return m_rig->workbench.capture(); }

    QTemporaryDir m_folder;
    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestRecordingControl)
#include "tst_recording_control.moc"
