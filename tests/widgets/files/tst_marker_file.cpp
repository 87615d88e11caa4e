// Markers of an opened recording through the real window: set, changed, deleted, saved, and asked about.
#include "session/recording/file.h"
#include "session/recording/reader.h"
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/files/job.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"
#include "widgets/window/exporting.h"

#include <QAction>
#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QThread>

#include <atomic>

using widgets::Banner;

namespace {

void writeNotedRecording(const QString &path, bool ended = true)
{
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", "board"});
    QVERIFY(file.open());
    file.add(0, capture::StreamLayout{1, 1000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    file.add(0, capture::SampleBlock{1, 0, 5000, std::vector<std::int16_t>(5000, 7), {}, 0});
    file.add(1'500'000'000, recorded::Note{1'500'000'000, 1'500'000'000, "look here"});
    if (ended)
        QVERIFY(file.end());
}

} // namespace

class TestMarkerFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("a.pcapng"));
        writeNotedRecording(m_path);
        m_rig = std::make_unique<facts::WindowRig>();
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    }
    void cleanup() { m_rig.reset(); }

    void nothingIsSavedThatIsSaved()
    {
        QVERIFY(!save()->isEnabled());
        QVERIFY(save()->toolTip().startsWith(QStringLiteral("There are no markers")));
        open();
        QVERIFY(!save()->isEnabled());
        QVERIFY(save()->toolTip().startsWith(QStringLiteral("All markers are saved")));
    }

    void aFileHasNoRowOfABoardsSignals()
    {
        const auto *strip = m_rig->find<QWidget>("channelStrip");
        QVERIFY(strip->isVisible());
        open();
        QVERIFY(!strip->isVisible());
        const auto *run = m_rig->find<QAction>("scopeRun");
        QCOMPARE(run->text(), QStringLiteral("File"));
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_COMPARE(scope().channels().size(), 4);
        QTRY_VERIFY(strip->isVisible());
        QVERIFY(m_rig->find<QWidget>("fastRate")->isVisible());
        QCOMPARE(run->text(), QStringLiteral("Run"));
    }

    void aMarkerIsInTheFileAfterwards()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        QVERIFY(save()->isEnabled());
        m_rig->files.answer = m_path;
        QTest::keyClick(&m_rig->window, Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Saved with its markers")));
        QCOMPARE(m_rig->files.asked.suggestedName, QStringLiteral("a.pcapng"));
        QVERIFY(!save()->isEnabled());
        const QStringList expected{QStringLiteral("look here"), QStringLiteral("it sticks")};
        open();
        QCOMPARE(markers(), expected);
    }

    void aCopyIsWhatIsOpenFromThenOn()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        const QString copy = m_folder->filePath(QStringLiteral("copy.pcapng"));
        m_rig->files.answer = copy;
        save()->trigger();
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("copy.pcapng")));
        QCOMPARE(notesIn(m_path), QStringList{QStringLiteral("look here")});
        QCOMPARE(notesIn(copy).size(), 2);
        scope().events().removeMarker(scope().events().events().front().id);
        save()->trigger();
        QTRY_VERIFY(!save()->isEnabled());
        QCOMPARE(m_rig->files.asked.suggestedName, QStringLiteral("copy.pcapng"));
        QCOMPARE(notesIn(copy), QStringList{QStringLiteral("it sticks")});
    }

    void whatCannotBeWrittenStaysToBeSaved()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        m_rig->files.answer = m_folder->filePath(QStringLiteral("no such folder/b.pcapng"));
        save()->trigger();
        QTRY_COMPARE(banner()->kind(), Banner::Kind::Warning);
        QVERIFY(banner()->text().contains(QStringLiteral("could not be saved")));
        QVERIFY(save()->isEnabled());
        QCOMPARE(notesIn(m_path), QStringList{QStringLiteral("look here")});
    }

    void whatIsStillBeingRecordedIsNotReplaced()
    {
        m_path = m_folder->filePath(QStringLiteral("live.pcapng"));
        writeNotedRecording(m_path, false);
        m_rig->files.answer = m_path;
        m_rig->find<QAction>("openRecording")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
        QFile file(m_path);
        QVERIFY(file.open(QIODevice::Append));
        file.write("more");
        file.close();
        setMarker(2.0, QStringLiteral("it sticks"));
        save()->trigger();
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("still being recorded")));
        QCOMPARE(notesIn(m_path), QStringList{QStringLiteral("look here")});
        QVERIFY(save()->isEnabled());
        m_rig->files.answer = m_folder->filePath(QStringLiteral("copy.pcapng"));
        save()->trigger();
        QTRY_VERIFY(!save()->isEnabled());
        QCOMPARE(notesIn(m_rig->files.answer).size(), 2);
    }

    void unsavedOnesAreAskedAbout()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        m_rig->find<QAction>("openRecording")->trigger();
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question);
        QTest::keyClick(question, Qt::Key_Return); // neither Enter nor Esc throws them away
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QCOMPARE(markers().size(), 2);
        m_rig->find<QAction>("openRecording")->trigger();
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_COMPARE(markers(), QStringList{QStringLiteral("look here")});
        QVERIFY(!save()->isEnabled());
    }

    void aConnectionAsksBeforeTheyGo()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        m_rig->window.connectBar()->connectOrDisconnect();
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question);
        QVERIFY(!m_rig->window.connectBar()->connecting());
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QCOMPARE(markers().size(), 2);
        QVERIFY(!m_rig->window.connectBar()->connecting());
        m_rig->window.connectBar()->connectOrDisconnect();
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_COMPARE(scope().channels().size(), 4);
        QVERIFY(markers().isEmpty());
    }

    void leavingAsksBeforeTheyGo()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        QSignalSpy closed(&m_rig->window, &widgets::MainWindow::closed);
        QVERIFY(!m_rig->window.close());
        QVERIFY(!m_rig->window.close()); // and asks once
        QCOMPARE(
            m_rig->window.findChildren<QMessageBox *>(QStringLiteral("markersQuestion")).size(), 1);
        QTest::keyClick(m_rig->find<QMessageBox>("markersQuestion"), Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(m_rig->window.isVisible() && closed.isEmpty());
        QVERIFY(!m_rig->window.close());
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_COMPARE(closed.size(), 1);
        QVERIFY(!m_rig->window.isVisible());
    }

    void whoLeftThemIsNotAskedAgainBehindAnExport()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        std::atomic<bool> written = false;
        m_rig->window.findChild<widgets::Exporting *>()->write(QStringLiteral("Exporting"),
            [&written](const widgets::FileJob::Proceed &proceed) -> widgets::FileJob::Finish {
                while (proceed(0.5) && !written)
                    QThread::yieldCurrentThread();
                return {};
            });
        QSignalSpy closed(&m_rig->window, &widgets::MainWindow::closed);
        QVERIFY(!m_rig->window.close());
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        auto *box = m_rig->find<QMessageBox>("exportQuestion");
        QVERIFY(box);
        for (QAbstractButton *button : box->buttons())
            if (box->buttonRole(button) == QMessageBox::AcceptRole)
                QTest::mouseClick(button, Qt::LeftButton);
        written = true;
        QTRY_COMPARE(closed.size(), 1);
        QVERIFY(!m_rig->window.isVisible());
    }

    void whatIsSetWhileAFileIsReadIsAskedAbout()
    {
        open();
        m_rig->find<QAction>("openRecording")->trigger();
        setMarker(2.0, QStringLiteral("it sticks"));
        QTRY_VERIFY(m_rig->find<QMessageBox>("markersQuestion"));
        QCOMPARE(markers().size(), 2);
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_COMPARE(markers(), QStringList{QStringLiteral("look here")});
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion")); // and not once more
        QVERIFY(!save()->isEnabled());
    }

    void clearingAsksAndTakesThemAlong()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        m_rig->find<QAction>("clearRecorded")->trigger();
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question);
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(!scope().channels().isEmpty());
        m_rig->find<QAction>("clearRecorded")->trigger();
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(scope().channels().isEmpty());
        QVERIFY(markers().isEmpty());
    }

    void whatIsSavedFirstGoesOnAfterwards()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        m_rig->files.answer = m_path;
        QSignalSpy closed(&m_rig->window, &widgets::MainWindow::closed);
        QVERIFY(!m_rig->window.close());
        QTest::mouseClick(m_rig->find<QPushButton>("saveMarkersFirst"), Qt::LeftButton);
        QTRY_COMPARE(closed.size(), 1);
        QCOMPARE(notesIn(m_path).size(), 2);
    }

    void whatCannotBeSavedFirstKeepsTheWindow()
    {
        open();
        setMarker(2.0, QStringLiteral("it sticks"));
        m_rig->files.answer = m_folder->filePath(QStringLiteral("no such folder/b.pcapng"));
        QVERIFY(!m_rig->window.close());
        QTest::mouseClick(m_rig->find<QPushButton>("saveMarkersFirst"), Qt::LeftButton);
        QTRY_VERIFY(banner()->text().contains(QStringLiteral("could not be saved")));
        QVERIFY(m_rig->window.isVisible());
        QCOMPARE(markers().size(), 2);
    }

    /// And not into the file that was open before.
    void thoseOfAConnectionGoIntoAList()
    {
        open();
        connectToBoard();
        QVERIFY(!save()->isEnabled());
        setMarker(1.25, QStringLiteral("=sticks, \"loud\""));
        setMarker(0.5, QStringLiteral("starts"));
        QVERIFY(save()->isEnabled());
        m_rig->files.answer = m_folder->filePath(QStringLiteral("list.csv"));
        save()->trigger();
        QVERIFY(banner()->text().contains(QStringLiteral("list.csv")));
        QVERIFY(m_rig->files.asked.suggestedName.endsWith(QStringLiteral("_markers.csv")));
        QFile list(m_rig->files.answer);
        QVERIFY(list.open(QIODevice::ReadOnly));
        QCOMPARE(list.readAll(),
            QByteArray("time [s],marker\n0.5,starts\n1.25,\"'=sticks, \"\"loud\"\"\"\n"));
        QVERIFY(!save()->isEnabled());
        QCOMPARE(notesIn(m_path), QStringList{QStringLiteral("look here")});
        setMarker(1.5, QStringLiteral("again"));
        QVERIFY(save()->isEnabled());
    }

    void leavingAsksForThoseOfAConnection()
    {
        connectToBoard();
        setMarker(1.0, QStringLiteral("it sticks"));
        QSignalSpy closed(&m_rig->window, &widgets::MainWindow::closed);
        QVERIFY(!m_rig->window.close());
        auto *question = m_rig->find<QMessageBox>("markersQuestion");
        QVERIFY(question && question->text().contains(QStringLiteral("not saved")));
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QVERIFY(m_rig->window.isVisible() && closed.isEmpty());
        QVERIFY(m_rig->workbench.device().answering()); // the connection goes on
        m_rig->files.answer = m_folder->filePath(QStringLiteral("list.csv"));
        QVERIFY(!m_rig->window.close());
        QTest::mouseClick(m_rig->find<QPushButton>("saveMarkersFirst"), Qt::LeftButton);
        QTRY_COMPARE(closed.size(), 1);
        QVERIFY(QFile::exists(m_rig->files.answer));
    }

    void thoseOfAConnectionOutliveItAndClearing()
    {
        connectToBoard();
        setMarker(1.0, QStringLiteral("it sticks"));
        disconnectFromBoard();
        connectToBoard();
        disconnectFromBoard();
        m_rig->find<QAction>("clearRecorded")->trigger();
        QTest::mouseClick(m_rig->find<QPushButton>("clearYes"), Qt::LeftButton);
        QVERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
        QCOMPARE(markers(), QStringList{QStringLiteral("it sticks")});
        // There are no samples to be asked about, but a file takes the place of markers, too.
        m_rig->files.answer = m_path;
        m_rig->find<QAction>("openRecording")->trigger();
        QVERIFY(m_rig->find<QMessageBox>("markersQuestion"));
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_COMPARE(markers(), QStringList{QStringLiteral("look here")});
        QTRY_VERIFY(!m_rig->find<QMessageBox>("markersQuestion"));
    }

    void aQuestionAboutSamplesTellsOfMarkers()
    {
        connectToBoard();
        disconnectFromBoard();
        m_rig->find<QAction>("openRecording")->trigger();
        auto *question = m_rig->find<QMessageBox>("replaceQuestion");
        QVERIFY(question && !question->informativeText().contains(QStringLiteral("Markers")));
        QVERIFY(!m_rig->find<QPushButton>("replaceSaveMarkers"));
        QTest::keyClick(question, Qt::Key_Escape);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
        setMarker(1.0, QStringLiteral("it sticks"));
        m_rig->find<QAction>("openRecording")->trigger();
        question = m_rig->find<QMessageBox>("replaceQuestion");
        QVERIFY(question && question->informativeText().contains(QStringLiteral("Markers")));
        m_rig->files.answer = m_folder->filePath(QStringLiteral("list.csv"));
        QTest::mouseClick(m_rig->find<QPushButton>("replaceSaveMarkers"), Qt::LeftButton);
        QTRY_VERIFY(!m_rig->find<QMessageBox>("replaceQuestion"));
        QVERIFY(QFile::exists(m_rig->files.answer));
        QVERIFY(!save()->isEnabled());
    }

    void thoseOfAnImportAreAskedAbout()
    {
        QFile csv(m_folder->filePath(QStringLiteral("a.csv")));
        QVERIFY(csv.open(QIODevice::WriteOnly));
        csv.write("time [s],A\n0,1\n1,2\n2,3\n");
        csv.close();
        m_rig->files.answer = csv.fileName();
        m_rig->find<QAction>("importCsv")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Imported ")));
        setMarker(1.0, QStringLiteral("it sticks"));
        m_rig->window.connectBar()->connectOrDisconnect();
        QVERIFY(m_rig->find<QMessageBox>("markersQuestion"));
        QTest::mouseClick(m_rig->find<QPushButton>("leaveMarkers"), Qt::LeftButton);
        QTRY_COMPARE(scope().channels().size(), 4);
        QVERIFY(markers().isEmpty());
    }

private:
    void open()
    {
        m_rig->files.answer = m_path;
        m_rig->find<QAction>("openRecording")->trigger();
        QTRY_VERIFY(banner()->text().startsWith(QStringLiteral("Opened ")));
    }
    void connectToBoard()
    {
        m_rig->window.connectBar()->connectOrDisconnect();
        QTRY_COMPARE(scope().channels().size(), 4);
        QTRY_VERIFY(m_rig->workbench.capture().timeSpan().has_value());
    }
    void disconnectFromBoard()
    {
        m_rig->window.connectBar()->disconnectNow();
        QTRY_VERIFY(!m_rig->workbench.device().portOpen());
    }
    void setMarker(double seconds, const QString &text)
    {
        scope().events().setText(
            scope().events().add(widgets::EventKind::Marker, seconds, text), text);
    }
    QStringList markers()
    {
        QStringList texts;
        for (const auto &event : scope().events().events())
            if (event.kind == widgets::EventKind::Marker)
                texts.append(event.text);
        return texts;
    }
    static QStringList notesIn(const QString &path)
    {
        capture::Capture capture;
        QStringList texts;
        if (const auto report = session::readRecording(path, capture))
            for (const auto &note : report->notes)
                texts.append(QString::fromStdString(note.text));
        return texts;
    }
    QAction *save() { return m_rig->find<QAction>("saveMarkers"); }
    Banner *banner() { return m_rig->window.findChild<Banner *>(); }
    widgets::ScopeView &scope() { return *m_rig->window.scope(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestMarkerFile)
#include "tst_marker_file.moc"
