// The array as NumPy reads it.
#include "capture/npy_export.h"
#include "session/files/export_formats.h"
#include "support/channels/every_channel.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace capture;

class TestNpyExport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void numpyReadsEveryNumber();
    void aRangeIsExact();
    void anEmptyCaptureIsAnEmptyArray();
    void allItHoldsIsBounded();
};

namespace {

/// Debian's NumPy belongs to Debian's Python, which need not be the first of the path.
QString python()
{
    const QString ofTheSystem =
        QStandardPaths::findExecutable(QStringLiteral("python3"), {QStringLiteral("/usr/bin")});
    return ofTheSystem.isEmpty() ? QStandardPaths::findExecutable(QStringLiteral("python3"))
                                 : ofTheSystem;
}

/// Name and values of each field in their order; null where a value is NaN.
QJsonArray npyFields(const QString &path)
{
    QProcess program;
    program.start(python(),
        {QStringLiteral("-c"),
            QStringLiteral(
                "import json, sys, numpy\n"
                "a = numpy.load(sys.argv[1], allow_pickle=False)\n"
                "print(json.dumps([[n, [None if v != v else v for v in a[n].tolist()]] for n in "
                "a.dtype.names]))\n"),
            path});
    if (!program.waitForFinished(60'000) || program.exitCode() != 0)
        qWarning() << "python3 says:" << program.readAllStandardError();
    return QJsonDocument::fromJson(program.readAllStandardOutput()).array();
}

/// Two fast signals of the same name with a gap, the second with a name that Python has to quote; a polled one.
Capture npyRecording()
{
    Capture capture;
    capture.begin({1, 16000.0, 0.25, 1,
        {{1, "I", "A", 0.0123456789, 0.0}, {2, "I", "A", 1.0, 0.0},
            {3, "it's \u03a9\\\n", "", -3.3e-7, 32768.0}},
        {}});
    const auto append = [&capture](Tick tick, std::int64_t lost) {
        SampleBlock block{1, tick, 100, {}, {}, lost};
        for (Tick i = 0; i < 300; ++i)
            block.fast.push_back(static_cast<std::int16_t>(i * 317 + tick * 11));
        capture.append(block);
    };
    append(0, 0);
    append(100, 0);
    append(300, 100);
    capture.appendPolled(9, "seconds", "s", 0.25553, 24.1);
    return capture;
}

session::ExportOutcome write(const QString &path, const session::ExportWanted &wanted)
{
    return session::exportFormatOf(path)->write(path, wanted, {});
}

QJsonArray values(const QJsonArray &fields, int field) { return fields[field][1].toArray(); }

} // namespace

void TestNpyExport::numpyReadsEveryNumber()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.npy"));
    const Capture capture = npyRecording();
    const auto outcome = write(path, {support::everyChannel(capture), {}});
    QCOMPARE(outcome.file.error, session::FileError::None);
    constexpr int kRows = 300 + 1 + 1; // samples, the gap, the polled value
    QCOMPARE(outcome.rows, quint64(kRows));
    const QJsonArray fields = npyFields(path);
    const char *const names[] = {"tick", "seconds", "I", "I_2", "it's \u03a9\\\n", "seconds_2"};
    QCOMPARE(fields.size(), 6);
    for (int i = 0; i < 6; ++i) {
        QCOMPARE(fields[i][0].toString(), QString::fromUtf8(names[i]));
        QCOMPARE(values(fields, i).size(), kRows);
    }
    const Channel *first = capture.channel(*capture.find(1));
    const Channel *third = capture.channel(*capture.find(3));
    int row = 0;
    for (Index i = 0; i < 300; ++i, ++row) {
        if (values(fields, 2)[row].isNull()) { // the polled value, or the gap
            const bool gap = values(fields, 5)[row].isNull();
            QCOMPARE(values(fields, 0)[row].toInteger(), qint64(gap ? 200 : 88));
            ++row;
        }
        const Tick tick = static_cast<Tick>(i) + (i < 200 ? 0 : 100);
        QCOMPARE(values(fields, 0)[row].toInteger(), qint64(tick));
        QCOMPARE(values(fields, 1)[row].toDouble(), toSeconds(first->timeOf(i)));
        QCOMPARE(values(fields, 2)[row].toDouble(), first->at(i));
        QCOMPARE(values(fields, 4)[row].toDouble(), third->at(i));
        QVERIFY(values(fields, 5)[row].isNull()); // NaN, never 0
    }
    QCOMPARE(row, kRows);
}

void TestNpyExport::aRangeIsExact()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.NPY"));
    const auto outcome = write(path,
        {support::everyChannel(npyRecording()),
            TimeSpan{0.25 + 10 / 16000.0, 0.25 + 30 / 16000.0}});
    QCOMPARE(outcome.rows, 20U);
    const QJsonArray ticks = values(npyFields(path), 0);
    QCOMPARE(ticks.first().toInteger(), 10);
    QCOMPARE(ticks.last().toInteger(), 29);
}

void TestNpyExport::anEmptyCaptureIsAnEmptyArray()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.npy"));
    QCOMPARE(write(path, {support::everyChannel(Capture()), {}}).rows, 0U);
    QCOMPARE(npyFields(path).size(), 2);
}

void TestNpyExport::allItHoldsIsBounded()
{
    const Snapshot channels = support::everyChannel(npyRecording());
    constexpr std::size_t kAll = std::size_t{302} * 6 * sizeof(double);
    std::string_view piece;
    NpyWriter over(channels, {}, kAll - 1);
    QVERIFY(over.tooLong());
    QVERIFY(!over.next(piece));
    NpyWriter fits(channels, {}, kAll);
    QVERIFY(!fits.tooLong());
    QVERIFY(fits.next(piece));
    QCOMPARE(piece.size() % 64, kAll % 64); // behind a head of whole lines
    QVERIFY(!fits.next(piece));
    QCOMPARE(fits.progress(), 1.0);
}

QTEST_GUILESS_MAIN(TestNpyExport)
#include "tst_npy_export.moc"
