// The MATLAB file, read back by a reader that shares no code with its writer (support/read_mat.py).
#include "session/files/mat_file.h"
#include "support/channels/every_channel.h"
#include "support/places.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace session;
using namespace capture;

class TestMatFile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyNumberReadsBack();
    void aRangeIsExact();
    void namesAreWhatMatlabTakes();
    void aPlaceThatTakesNoFileIsOneError();
    void aTemporaryFolderThatCannotBeMadeIsOneError();
    void allItHoldsIsBounded();
    void itIsCancelledAnywhere();
};

namespace {

QJsonObject matContents(const QString &path)
{
    QProcess python;
    python.start(QStandardPaths::findExecutable(QStringLiteral("python3")),
        {support::sourceFile(QStringLiteral("tests/support/read_mat.py")), path});
    if (!python.waitForFinished(60'000) || python.exitCode() != 0)
        qWarning() << "python3 says:" << python.readAllStandardError();
    return QJsonDocument::fromJson(python.readAllStandardOutput()).object();
}

/// Fast signals with a gap, a slow and a polled one.
Capture matRecording()
{
    Capture capture;
    capture.begin({1, 16000.0, 0.25, 1,
        {{1, "I A", "A", 0.0123456789, 0.0}, {2, "1_\u03a9", "\u03a9", -3.3e-7, 32768.0}},
        {{3, "SPEED", "rpm", 6.0, 0.0}}});
    for (Tick tick = 0; tick < 3000; tick += 100) {
        if (tick == 1500)
            continue; // lost
        SampleBlock block{1, tick, 100, {}, {{tick + 99, {static_cast<std::int32_t>(tick)}}},
            tick == 1600 ? 100 : 0};
        for (Tick i = 0; i < 200; ++i)
            block.fast.push_back(static_cast<std::int16_t>(i * 317 + tick * 11));
        capture.append(block);
    }
    capture.begin({2, 16000.0, 0.25, 1, {{1, "I A", "A", 0.0123456789, 0.0}}, {}});
    capture.append({2, 3000, 2, {7, -8}, {}, 0}); // now without the other one
    capture.appendPolled(9, "U", "V", 0.3, 24.1);
    capture.appendPolled(9, "U", "V", 0.31, 24.2);
    return capture;
}

} // namespace

void TestMatFile::everyNumberReadsBack()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.mat"));
    const Capture capture = matRecording();
    const MatResult result = writeMatFile(path, support::everyChannel(capture));
    QCOMPARE(result.file.error, FileError::None);
    QCOMPARE(result.rows, 2902U + 29U + 2U);
    const QJsonObject mat = matContents(path);
    QCOMPARE(mat.keys(), QStringLiteral("fast polled1 slow").split(QLatin1Char(' ')));
    const QJsonObject fast = mat.value(QLatin1String("fast")).toObject();
    const QJsonArray time = fast.value(QLatin1String("time")).toArray();
    const QJsonArray current = fast.value(QLatin1String("I_A")).toArray();
    const QJsonArray other = fast.value(QLatin1String("x1__")).toArray();
    QCOMPARE(time.size(), 2902);
    QCOMPARE(current.size(), 2902);
    QCOMPARE(other.size(), 2902);
    const Channel *a = capture.channel(*capture.find(1));
    const Channel *b = capture.channel(*capture.find(2));
    for (int i = 0; i < 2902; ++i) {
        QCOMPARE(time[i].toDouble(), toSeconds(a->timeOf(Index(i))));
        QCOMPARE(current[i].toDouble(), a->at(Index(i)));
        if (i < 2900)
            QCOMPARE(other[i].toDouble(), b->at(Index(i)));
        else
            QVERIFY(other[i].isNull()); // NaN, never 0
    }
    QCOMPARE(fast.value(QLatin1String("units")).toObject().value(QLatin1String("x1__")).toString(),
        QStringLiteral("\u03a9"));
    QCOMPARE(fast.value(QLatin1String("names")).toObject().value(QLatin1String("I_A")).toString(),
        QStringLiteral("I A"));
    const QJsonObject polled = mat.value(QLatin1String("polled1")).toObject();
    QCOMPARE(polled.value(QLatin1String("U")).toArray(), (QJsonArray{24.1, 24.2}));
    const QJsonObject slow = mat.value(QLatin1String("slow")).toObject();
    QCOMPARE(slow.value(QLatin1String("SPEED")).toArray().at(28).toDouble(), 2900.0 * 6.0);
}

void TestMatFile::aRangeIsExact()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.mat"));
    const MatResult result = writeMatFile(path, support::everyChannel(matRecording()),
        TimeSpan{0.25 + 160 / 16000.0, 0.25 + 320 / 16000.0});
    QCOMPARE(result.file.error, FileError::None);
    const QJsonObject fast = matContents(path).value(QLatin1String("fast")).toObject();
    QCOMPARE(fast.value(QLatin1String("time")).toArray().size(), 160);
    QCOMPARE(fast.value(QLatin1String("time")).toArray().at(0).toDouble(), 0.26);
}

void TestMatFile::namesAreWhatMatlabTakes()
{
    QStringList taken{QStringLiteral("time")};
    const auto next = [&taken](const char *name) {
        taken.append(matName(QString::fromUtf8(name), taken));
        return taken.back();
    };
    QCOMPARE(next("I_Q_MEAS"), QStringLiteral("I_Q_MEAS"));
    QCOMPARE(next("I_Q_MEAS"), QStringLiteral("I_Q_MEAS_2"));
    QCOMPARE(next("time"), QStringLiteral("time_2"));
    QCOMPARE(next("SPEED@2"), QStringLiteral("SPEED_2"));
    QCOMPARE(next("\u03b1"), QStringLiteral("x_"));
    QCOMPARE(next(""), QStringLiteral("x"));
    QCOMPARE(next("_x"), QStringLiteral("x_x"));
    const QByteArray wide(100, 'w');
    QCOMPARE(next(wide.constData()).size(), 31);
    QCOMPARE(next(wide.constData()), QString(29, QLatin1Char('w')) + QStringLiteral("_2"));
}

void TestMatFile::aPlaceThatTakesNoFileIsOneError()
{
    QTemporaryDir folder;
    const MatResult result = writeMatFile(
        folder.filePath(QStringLiteral("no/folder/a.mat")), support::everyChannel(matRecording()));
    QCOMPARE(result.file.error, FileError::CannotOpen);
    QVERIFY(!result.file.systemText.isEmpty());
    QCOMPARE(writeMatFile(folder.path(), support::everyChannel(matRecording())).file.error,
        FileError::NotAFile);
}

void TestMatFile::aTemporaryFolderThatCannotBeMadeIsOneError()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.mat"));
    const QByteArray before = qgetenv("TMPDIR");
    QFile noFolder(folder.filePath(QStringLiteral("file")));
    QVERIFY(noFolder.open(QIODevice::WriteOnly));
    qputenv("TMPDIR", QFile::encodeName(noFolder.fileName()));
    const MatResult result = writeMatFile(path, support::everyChannel(matRecording()));
    before.isEmpty() ? qunsetenv("TMPDIR") : qputenv("TMPDIR", before);
    QCOMPARE(result.file.error, FileError::CannotWrite);
    QVERIFY(!result.file.systemText.isEmpty());
    QVERIFY2(!result.file.systemText.contains(QStringLiteral("no room")),
        qPrintable(result.file.systemText));
    QVERIFY(!QFile::exists(path));
}

/// All columns of all structures, not one of them.
void TestMatFile::allItHoldsIsBounded()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.mat"));
    const Snapshot channels = support::everyChannel(matRecording());
    constexpr std::size_t kAll = (2902 * 3 + 29 * 2 + 2 * 2) * sizeof(double);
    const MatResult over = writeMatFile(path, channels, {}, {}, kAll - 1);
    QVERIFY(over.tooLong);
    QVERIFY(!QFile::exists(path));
    QVERIFY(writeMatFile(path, channels, {}, {}, 1000).tooLong);
    const MatResult fits = writeMatFile(path, channels, {}, {}, kAll);
    QVERIFY(!fits.tooLong);
    QCOMPARE(fits.file.error, FileError::None);
    const TimeSpan some{0.25, 0.26}; // a range is bounded by what is in it
    QVERIFY(!writeMatFile(path, channels, some, {}, 160 * (3 * sizeof(double)) + 100).tooLong);
}

void TestMatFile::itIsCancelledAnywhere()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.mat"));
    Capture capture = matRecording();
    for (Tick tick = 4000; tick < 204'000; tick += 1000) // some times between two reports
        capture.append({2, tick, 1000, std::vector<std::int16_t>(1000, 5), {}, 0});
    const Snapshot channels = support::everyChannel(capture);
    std::vector<double> told;
    const auto tell = [&told](double fraction) {
        told.push_back(fraction);
        return true;
    };
    QCOMPARE(writeMatFile(path, channels, {}, tell).file.error, FileError::None);
    QVERIFY(std::is_sorted(told.begin(), told.end()));
    const auto in = [&told](double from, double to) {
        return std::count_if(
            told.begin(), told.end(), [=](double at) { return at > from && at < to; });
    };
    QVERIFY(in(0.0, 0.3) >= 4); // while it gathers
    QVERIFY(in(0.3, 0.95) >= 2); // and behind each structure
    QVERIFY(QFile::remove(path));
    for (std::size_t stop = 1; stop <= told.size(); ++stop) {
        std::size_t calls = 0;
        const MatResult result =
            writeMatFile(path, channels, {}, [&](double) { return ++calls < stop; });
        QCOMPARE(result.file.error, FileError::Cancelled);
        QCOMPARE(calls, stop);
        QVERIFY(!QFile::exists(path));
    }
}

QTEST_GUILESS_MAIN(TestMatFile)
#include "tst_mat_file.moc"
