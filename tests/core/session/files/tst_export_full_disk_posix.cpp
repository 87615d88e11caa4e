// A disk that is full after so many bytes, for each such number: a limit on the file's size gives the same short
// write as a full disk, without one.
#include "session/files/export_formats.h"
#include "support/programs/size_limit_posix.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include <cerrno>
#include <sys/stat.h>

using namespace session;
using support::SizeLimit;

class TestExportFullDisk : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whereverItFillsTheOldFileStays();
    void noRoomIsKeptBehindTheEnd();
};

namespace {

capture::Snapshot wholeRecording()
{
    capture::Capture capture;
    capture.begin({1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    for (int tick = 0; tick < 200'000; tick += 1000)
        capture.append({1, tick, 1000, std::vector<std::int16_t>(1000, 1234), {}, 0});
    const std::vector<capture::ChannelId> ids{*capture.find(1)};
    return capture.snapshot(ids);
}

FileResult exported(const QString &path, const capture::Snapshot &channels)
{
    return exportFormatNamed("csv")->write(path, {channels, {}}, {}).file;
}

} // namespace

void TestExportFullDisk::whereverItFillsTheOldFileStays()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    QFile old(path);
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    const capture::Snapshot snapshot = wholeRecording();
    const FileResult full = exported(folder.filePath(QStringLiteral("b.csv")), snapshot);
    QCOMPARE(full.error, FileError::None);
    for (qint64 bytes = 0; bytes < full.bytes; bytes += 1 + full.bytes / 37) {
        FileResult result;
        {
            const SizeLimit limit(static_cast<rlim_t>(bytes));
            result = exported(path, snapshot);
        }
        QCOMPARE(result.error, FileError::CannotWrite);
        QCOMPARE(result.systemText, qt_error_string(EFBIG));
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
        old.close();
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
    }
}

void TestExportFullDisk::noRoomIsKeptBehindTheEnd()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    const FileResult result = exported(path, wholeRecording());
    QCOMPARE(result.error, FileError::None);
    QVERIFY(result.bytes > 1'000'000); // several pieces
    struct stat file { };
    QCOMPARE(stat(QFile::encodeName(path).constData(), &file), 0);
    constexpr qint64 kBlock = 512; // of st_blocks
    QVERIFY2(qint64(file.st_blocks) * kBlock < result.bytes + 100'000,
        qPrintable(QString::number(file.st_blocks)));
}

QTEST_GUILESS_MAIN(TestExportFullDisk)
#include "tst_export_full_disk_posix.moc"
