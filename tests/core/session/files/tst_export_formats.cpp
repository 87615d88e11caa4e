// An exported file: whole or not there at all, whatever the disk does.
#include "session/files/export_formats.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace session;

class TestExportFormats : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theFileHoldsWhatTheWriterSays();
    void aFolderThatIsNotThereIsOneError();
    void aFolderIsNotReplaced();
    void cancellingLeavesTheOldFile();
};

namespace {

capture::Snapshot recording(int samples)
{
    capture::Capture capture;
    capture.begin({1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}, {2, "B", "A", 0.1, 0.0}}, {}});
    for (int tick = 0; tick < samples; tick += 1000)
        capture.append({1, tick, 1000, std::vector<std::int16_t>(2000, 1234), {}, 0});
    const std::vector<capture::ChannelId> ids{*capture.find(1), *capture.find(2)};
    return capture.snapshot(ids);
}

QByteArray contents(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString &path, const QByteArray &text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

ExportOutcome writeCsv(const QString &path, const capture::Snapshot &channels,
    const std::function<bool(double)> &proceed = {})
{
    return exportFormatNamed("csv")->write(path, {channels, {}}, proceed);
}

} // namespace

void TestExportFormats::theFileHoldsWhatTheWriterSays()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    const ExportOutcome result = writeCsv(path, recording(50'000));
    QCOMPARE(result.file.error, FileError::None);
    QCOMPARE(result.rows, 50'000U);
    const QByteArray text = contents(path);
    QCOMPARE(text.size(), result.file.bytes);
    QVERIFY(text.startsWith("time [s],A [A],B [A]\n0,123.4,123.4\n"));
    QCOMPARE(text.count('\n'), 50'001);
}

void TestExportFormats::aFolderThatIsNotThereIsOneError()
{
    QTemporaryDir folder;
    const ExportOutcome result =
        writeCsv(folder.filePath(QStringLiteral("no/such/folder/a.csv")), recording(1000));
    QCOMPARE(result.file.error, FileError::CannotOpen);
    QVERIFY(!result.file.systemText.isEmpty());
}

void TestExportFormats::aFolderIsNotReplaced()
{
    QTemporaryDir folder;
    QCOMPARE(writeCsv(folder.path(), recording(1000)).file.error, FileError::NotAFile);
    QVERIFY(QFileInfo(folder.path()).isDir());
}

void TestExportFormats::cancellingLeavesTheOldFile()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.csv"));
    put(path, "old");
    const ExportOutcome result =
        writeCsv(path, recording(200'000), [](double fraction) { return fraction < 0.3; });
    QCOMPARE(result.file.error, FileError::Cancelled);
    QCOMPARE(contents(path), QByteArray("old"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
}

QTEST_GUILESS_MAIN(TestExportFormats)
#include "tst_export_formats.moc"
