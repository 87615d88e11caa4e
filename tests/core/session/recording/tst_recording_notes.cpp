// Notes that are added to a closed recording: its own bytes stay, and whatever fails, what was there stays whole.
#include "session/recording/notes.h"
#include "session/recording/reader.h"
#include "support/notes_bench.h"
#include "support/recording_facts.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using recorded::Note;
using session::NotesResult;
using support::contentOf;
using support::kSecond;
using support::writeRecording;

namespace {

std::map<recorded::Nanos, std::string> notesOf(const QString &path)
{
    capture::Capture capture;
    std::map<recorded::Nanos, std::string> notes;
    if (const auto report = session::readRecording(path, capture))
        for (const Note &note : report->notes)
            notes[note.from] = note.text;
    return notes;
}

/// Long after the file was written.
session::NotesSource later() { return {-1, {}, QDateTime::currentDateTime().addSecs(3600)}; }

/// Why not; empty if saved.
QString whyNotSaved(const QString &source, const QString &target, const std::vector<Note> &notes,
    const std::function<bool(double)> &proceed = {})
{
    return session::saveNotes(source, target, notes, proceed, later()).why;
}

} // namespace

class TestRecordingNotes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath(QStringLiteral("a.pcapng"));
        writeRecording(m_path, true);
        m_before = contentOf(m_path);
    }

    void theyComeBehindItsOwnBytes()
    {
        QCOMPARE(whyNotSaved(m_path, m_path, {{kSecond, kSecond, "new words"}, {7, 7, "third"}}),
            QString());
        QVERIFY(contentOf(m_path).startsWith(m_before));
        const auto facts = support::readRecording(m_path);
        QVERIFY(facts.damage.empty());
        QCOMPARE(facts.samples(), 5000U);
        QVERIFY(facts.ending);
        QCOMPARE(facts.ending->reason, recorded::End::Reason::Stopped);
        const std::map<recorded::Nanos, std::string> notes{
            {7, "third"}, {kSecond, "new words"}, {2 * kSecond, "second"}};
        QCOMPARE(notesOf(m_path), notes);
    }

    void aNoteThatWasChangedIsOne()
    {
        QCOMPARE(whyNotSaved(m_path, m_path, {{kSecond, kSecond, "changed"}}), QString());
        capture::Capture capture;
        const auto report = session::readRecording(m_path, capture);
        QVERIFY(report);
        QCOMPARE(report->notes.size(), std::size_t(2));
        QCOMPARE(report->notes[0].text, std::string("changed"));
        QCOMPARE(report->notes[1].text, std::string("second"));
    }

    void aNoteThatWasDeletedIsTakenBack()
    {
        QCOMPARE(whyNotSaved(m_path, m_path, {recorded::noNote(kSecond)}), QString());
        QVERIFY(!notesOf(m_path).contains(kSecond));
        QCOMPARE(notesOf(m_path).size(), 1U);
        QCOMPARE(whyNotSaved(m_path, m_path, {{kSecond, kSecond, "again"}}), QString());
        QCOMPARE(notesOf(m_path)[kSecond], std::string("again"));
    }

    void aCopyLeavesTheFileAlone()
    {
        const QString copy = m_folder->filePath(QStringLiteral("copy.pcapng"));
        QCOMPARE(whyNotSaved(m_path, copy, {{3, 3, "in the copy"}}), QString());
        QCOMPARE(contentOf(m_path), m_before);
        QCOMPARE(notesOf(copy).size(), 3U);
    }

    void aFileThatGrewIsNotReplaced()
    {
        const QString path = m_folder->filePath(QStringLiteral("live.pcapng"));
        writeRecording(path, false);
        const QByteArray before = contentOf(path);
        session::NotesSource known = later();
        known.bytes = before.size() - 1;
        const auto result = session::saveNotes(path, path, {{3, 3, "third"}}, {}, known);
        QCOMPARE(result.outcome, NotesResult::Outcome::BeingWritten);
        QCOMPARE(contentOf(path), before);
        const QString copy = m_folder->filePath(QStringLiteral("copy.pcapng"));
        QCOMPARE(session::saveNotes(path, copy, {{3, 3, "third"}}, {}, known).why, QString());
        QCOMPARE(notesOf(copy).size(), 3U);
        known.bytes = before.size();
        QCOMPARE(session::saveNotes(path, path, {{3, 3, "third"}}, {}, known).why, QString());
    }

    void aFileThatChangedJustNowIsNotReplaced()
    {
        const QString path = m_folder->filePath(QStringLiteral("live.pcapng"));
        writeRecording(path, false);
        const QByteArray before = contentOf(path);
        session::NotesSource known{
            before.size(), {}, QFileInfo(path).lastModified().addMSecs(9'999)};
        QString other = m_folder->filePath(QStringLiteral("./live.pcapng")); // the same file
        auto result = session::saveNotes(path, other, {{3, 3, "third"}}, {}, known);
        QCOMPARE(result.outcome, NotesResult::Outcome::BeingWritten);
        QCOMPARE(contentOf(path), before);
        known.now = known.now.addMSecs(1);
        result = session::saveNotes(path, other, {{3, 3, "third"}}, {}, known);
        QCOMPARE(result.why, QString());
        // What this program wrote itself is not being written by another.
        known = result.target;
        QCOMPARE(session::saveNotes(path, path, {{4, 4, "fourth"}}, {}, known).why, QString());
        QCOMPARE(notesOf(path).size(), 4U);
    }

    /// Nothing below the window reads a clock.
    void whoTellsNoTimeReplacesNothingWithoutAnEnd()
    {
        const QString path = m_folder->filePath(QStringLiteral("live.pcapng"));
        writeRecording(path, false);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(
            QDateTime::currentDateTimeUtc().addSecs(-3600), QFileDevice::FileModificationTime));
        file.close();
        const auto save = [&path](const session::NotesSource &known) {
            return session::saveNotes(path, path, {{3, 3, "third"}}, {}, known).outcome;
        };
        QCOMPARE(save({}), NotesResult::Outcome::BeingWritten);
        QCOMPARE(save({-1, {}, QDateTime::currentDateTimeUtc()}), NotesResult::Outcome::Saved);
    }

    /// However long its recorder has been silent.
    void aFileThatIsRecordedIsNotReplaced()
    {
        const QString path = m_folder->filePath(QStringLiteral("live.pcapng"));
        QString text;
        auto recorder = std::make_unique<session::RecordingFile>(
            session::makeDiskSink(path, text), recorded::Begin{0, "test", "board"});
        QVERIFY(recorder->open());
        QVERIFY(recorder->add(kSecond, Note{kSecond, kSecond, "first"}) && recorder->flushAll());
        const QByteArray before = contentOf(path);
        const QString other = m_folder->filePath(QStringLiteral("./live.pcapng")); // the same file
        const auto result = session::saveNotes(path, other, {{3, 3, "third"}}, {}, later());
        QCOMPARE(result.outcome, NotesResult::Outcome::BeingWritten);
        QCOMPARE(contentOf(path), before);
        const QString copy = m_folder->filePath(QStringLiteral("copy.pcapng"));
        QCOMPARE(whyNotSaved(path, copy, {{3, 3, "third"}}), QString());
        recorder.reset();
        QCOMPARE(whyNotSaved(path, path, {{3, 3, "third"}}), QString());
        QCOMPARE(notesOf(path).size(), 2U);
        QVERIFY(!QFile::exists(path + QStringLiteral(".lock")));
    }

    /// A crash leaves its lock behind, and the number of its process.
    void aLockOfARecorderThatIsGoneIsNone()
    {
        const QString path = m_folder->filePath(QStringLiteral("live.pcapng"));
        writeRecording(path, false);
        QFile lock(path + QStringLiteral(".lock"));
        QVERIFY(lock.open(QIODevice::WriteOnly));
        lock.write("2147483646\nrotorscope\n" + QSysInfo::machineHostName().toUtf8() + "\n");
        lock.close();
        QCOMPARE(whyNotSaved(path, path, {{3, 3, "third"}}), QString());
        QVERIFY(!lock.exists());
    }

    void aFileWithAnEndMayHaveBeenWrittenJustNow()
    {
        QCOMPARE(session::saveNotes(m_path, m_path, {{3, 3, "third"}}).why, QString());
    }

    /// Wherever in its last block.
    void whatWasInterruptedStaysSo()
    {
        const QString path = m_folder->filePath(QStringLiteral("cut.pcapng"));
        writeRecording(path, false);
        const QByteArray whole = contentOf(path);
        for (int missing = 1; missing < 90; ++missing) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(whole.chopped(missing));
            file.close();
            QCOMPARE(whyNotSaved(path, path, {{3, 3, "third"}, {4, 4, "fourth"}}), QString());
            QVERIFY(contentOf(path).startsWith(whole.chopped(missing)));
            const auto facts = support::readRecording(path);
            QVERIFY(!facts.ending);
            QVERIFY(facts.damage.size() <= 1U); // where it is cut
            QCOMPARE(facts.samples(), 5000U);
            auto notes = notesOf(path);
            QCOMPARE(notes[kSecond], std::string("first"));
            QCOMPARE(notes[3], std::string("third"));
            QCOMPARE(notes[4], std::string("fourth"));
        }
    }

    void whoeverCancelsHasWhatWasThere()
    {
        QVERIFY(!whyNotSaved(m_path, m_path, {{3, 3, "third"}}, [](double) {
            return false;
        }).isEmpty());
        QCOMPARE(contentOf(m_path), m_before);
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1);
    }

    void whatIsNoRecordingIsRefused()
    {
        const QString path = m_folder->filePath(QStringLiteral("b.txt"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("something else");
        file.close();
        QVERIFY(!whyNotSaved(path, path, {{3, 3, "third"}}).isEmpty());
        QCOMPARE(contentOf(path), QByteArray("something else"));
        QVERIFY(!whyNotSaved(m_folder->filePath(QStringLiteral("none")), path, {}).isEmpty());
        QCOMPARE(contentOf(path), QByteArray("something else"));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QByteArray m_before;
};

QTEST_GUILESS_MAIN(TestRecordingNotes)
#include "tst_recording_notes.moc"
