// Notes that are added to a closed recording: its own bytes stay, and whatever fails, what was there stays whole.
#include "session/recording_file.h"
#include "session/recording_notes.h"
#include "session/recording_reader.h"
#include "support/recording_facts.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

#include <csignal>
#include <sys/resource.h>

using record::Note;
using session::saveNotes;

namespace {

constexpr record::Nanos kSecond = 1'000'000'000;

/// No file of this process may grow past `bytes` while this lives.
struct SizeLimit {
    rlimit before{};
    explicit SizeLimit(rlim_t bytes)
    {
        std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before);
        const rlimit limit{bytes, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SizeLimit() { setrlimit(RLIMIT_FSIZE, &before); }
};

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void writeRecording(const QString &path, bool ended)
{
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", "board"});
    QVERIFY(file.open());
    file.add(0, capture::StreamLayout{1, 1000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    for (capture::Tick tick = 0; tick < 5000; tick += 1000) {
        file.add(tick * 1'000'000,
            capture::SampleBlock{1, tick, 1000, std::vector<std::int16_t>(1000, 7), {}, 0});
        file.flushAll();
    }
    file.add(kSecond, Note{kSecond, kSecond, "first"});
    file.add(2 * kSecond, Note{2 * kSecond, 2 * kSecond, "second"});
    if (ended)
        QVERIFY(file.end());
}

std::map<record::Nanos, std::string> notesOf(const QString &path)
{
    capture::Capture capture;
    std::map<record::Nanos, std::string> notes;
    if (const auto report = session::readRecording(path, capture))
        for (const Note &note : report->notes)
            notes[note.from] = note.text;
    return notes;
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
        QCOMPARE(saveNotes(m_path, m_path, {{kSecond, kSecond, "new words"}, {7, 7, "third"}}),
            QString());
        QVERIFY(contentOf(m_path).startsWith(m_before));
        const auto facts = support::readRecording(m_path);
        QVERIFY(facts.damage.empty());
        QCOMPARE(facts.samples(), 5000U);
        QVERIFY(facts.ending);
        QCOMPARE(facts.ending->reason, record::End::Reason::Stopped);
        const std::map<record::Nanos, std::string> notes{
            {7, "third"}, {kSecond, "new words"}, {2 * kSecond, "second"}};
        QCOMPARE(notesOf(m_path), notes);
    }

    void aNoteThatWasDeletedIsTakenBack()
    {
        QCOMPARE(saveNotes(m_path, m_path, {record::noNote(kSecond)}), QString());
        QVERIFY(!notesOf(m_path).contains(kSecond));
        QCOMPARE(notesOf(m_path).size(), 1U);
        QCOMPARE(saveNotes(m_path, m_path, {{kSecond, kSecond, "again"}}), QString());
        QCOMPARE(notesOf(m_path)[kSecond], std::string("again"));
    }

    void aCopyLeavesTheFileAlone()
    {
        const QString copy = m_folder->filePath(QStringLiteral("copy.pcapng"));
        QCOMPARE(saveNotes(m_path, copy, {{3, 3, "in the copy"}}), QString());
        QCOMPARE(contentOf(m_path), m_before);
        QCOMPARE(notesOf(copy).size(), 3U);
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
            QCOMPARE(saveNotes(path, path, {{3, 3, "third"}, {4, 4, "fourth"}}), QString());
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

    void whereverTheDiskFillsTheFileStaysWhole()
    {
        int failed = 0;
        for (qint64 room = 0; room < m_before.size() + 200; room += 397) {
            QString why;
            {
                const SizeLimit limit(static_cast<rlim_t>(room));
                why = saveNotes(m_path, m_path, {{3, 3, "third"}});
            }
            if (why.isEmpty())
                continue;
            ++failed;
            QCOMPARE(contentOf(m_path), m_before);
            QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 1); // and no rest
        }
        QVERIFY(failed > 10);
    }

    void whoeverCancelsHasWhatWasThere()
    {
        QVERIFY(
            !saveNotes(m_path, m_path, {{3, 3, "third"}}, [](double) { return false; }).isEmpty());
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
        QVERIFY(!saveNotes(path, path, {{3, 3, "third"}}).isEmpty());
        QCOMPARE(contentOf(path), QByteArray("something else"));
        QVERIFY(!saveNotes(m_folder->filePath(QStringLiteral("none")), path, {}).isEmpty());
        QCOMPARE(contentOf(path), QByteArray("something else"));
    }

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_path;
    QByteArray m_before;
};

QTEST_GUILESS_MAIN(TestRecordingNotes)
#include "tst_recording_notes_posix.moc"
