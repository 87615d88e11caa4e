// Notes that are added to a closed recording on a disk that fills up: what was there stays whole.
#include "session/recording/notes.h"
#include "support/notes_bench.h"
#include "support/programs/size_limit_posix.h"

#include <QDir>
#include <QTemporaryDir>
#include <QtTest>

using support::contentOf;
using support::SizeLimit;

class TestRecordingNotesFullDisk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whereverTheDiskFillsTheFileStaysWhole()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("a.pcapng"));
        support::writeRecording(path, true);
        const QByteArray before = contentOf(path);
        int failed = 0;
        for (qint64 room = 0; room < before.size() + 200; room += 397) {
            QString why;
            {
                const SizeLimit limit(static_cast<rlim_t>(room));
                why = session::saveNotes(path, path, {{3, 3, "third"}}).why;
            }
            if (why.isEmpty())
                continue;
            ++failed;
            QCOMPARE(contentOf(path), before);
            QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1); // and no rest
        }
        QVERIFY(failed > 10);
    }
};

QTEST_GUILESS_MAIN(TestRecordingNotesFullDisk)
#include "tst_recording_notes_full_disk_posix.moc"
