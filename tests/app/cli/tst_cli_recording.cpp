// Recordings as scripts see them: capture --record, show, export and evaluate. The real program, against its own
// simulated board.
#include "session/files/finding_json.h"
#include "session/files/snapshot_json.h"
#include "session/recording/file.h"
#include "support/lab_bench.h"
#include "support/places.h"
#include "support/programs/cli_run.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtEndian>
#include <QtTest>

using support::CliRun;
using support::typed;
using support::wordsOf;
using namespace std::chrono_literals;

class TestCliRecording : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void theRegistersComeOut();
    void captureRecordsWhatItWrites();
    void showSaysWhatIsInIt();
    void exportAndImportGiveTheSameFile();
    void aRangeBeyondNanosecondsIsWhatThereIsOfIt_data();
    void aRangeBeyondNanosecondsIsWhatThereIsOfIt();
    void rowsOfOneTimeAreLeftOutAndTold();
    void aWavFileIsReadByOthers();
    void aMatlabFileIsReadByOthers();
    void aDamagedRecordingIsExportedAndTold();
    void whatADiskWasTooSlowForIsNamed_data();
    void whatADiskWasTooSlowForIsNamed();
    void aFileThatIsThereIsNotRecordedOver();
    void aRecordingIsCalledPcapng_data();
    void aRecordingIsCalledPcapng();
    void eachOfSeveralExperimentsIsTold();
    void anExperimentThatIsCutOffIsEvaluatedAndTold();
    void otherFilesAreExitStatus5();
    void wrongUsageIsExitStatus2_data();
    void wrongUsageIsExitStatus2();

private:
    QTemporaryDir m_folder;
    QString path(const char *name) const { return m_folder.filePath(QString::fromLatin1(name)); }
};

namespace {

QByteArray contents(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

/// Of the block that lies across the middle. Its length, which it repeats at its end, may be damaged without any harm.
qsizetype firstDataInTheMiddle(const QByteArray &file)
{
    constexpr qsizetype kHead = 28;
    qsizetype at = 0;
    for (qsizetype next = 0; next < file.size() / 2;) {
        at = next;
        next += std::max<qsizetype>(12, qFromLittleEndian<qint32>(file.constData() + at + 4));
    }
    return at + kHead;
}

} // namespace

/// One recording for all tests.
void TestCliRecording::initTestCase()
{
    QStringList arguments =
        wordsOf("--port sim --json capture --hf I_A,I_B --mf I_Q_MEAS --mf-rate "
                "15 --seconds 0.5 --link");
    arguments << QStringLiteral("-o") << path("a.csv") << QStringLiteral("--record")
              << path("a.pcapng");
    const CliRun result = typed(arguments);
    COMPARE_STATUS(result, 0);
    QCOMPARE(result.object().value(QLatin1String("rows")).toInt(), 8000);
    QVERIFY(result.object().value(QLatin1String("recording_samples")).toInt() >= 16'500);
    QCOMPARE(result.object().value(QLatin1String("recording_bytes")).toInt(),
        contents(path("a.pcapng")).size());
}

/// What the board held is in the recording, as the file that can be compared and restored.
void TestCliRecording::theRegistersComeOut()
{
    COMPARE_STATUS(
        typed({QStringLiteral("export"), path("a.pcapng"), QStringLiteral("-o"), path("a.json")}),
        0);
    const auto snapshot = session::readSnapshotJson(contents(path("a.json")));
    QVERIFY(snapshot && snapshot->entries.size() > 50);
    const CliRun same = typed({QStringLiteral("diff"), path("a.json"), path("a.json")});
    COMPARE_STATUS(same, 0);
    const CliRun early = typed({QStringLiteral("export"), path("a.pcapng"), QStringLiteral("-o"),
        path("none.json"), QStringLiteral("--to"), QStringLiteral("0.0001")});
    COMPARE_STATUS(early, 2);
    QVERIFY(!QFile::exists(path("none.json")));
}

/// The CSV of the run is exactly the beginning of what the recording holds.
void TestCliRecording::captureRecordsWhatItWrites()
{
    const CliRun result = typed({QStringLiteral("export"), path("a.pcapng"), QStringLiteral("-o"),
        path("all.csv"), QStringLiteral("--json")});
    COMPARE_STATUS(result, 0);
    QVERIFY(result.object().value(QLatin1String("complete")).toBool());
    const QList<QByteArray> direct = contents(path("a.csv")).split('\n');
    const QList<QByteArray> recorded = contents(path("all.csv")).split('\n');
    QVERIFY(recorded.size() >= direct.size());
    for (qsizetype row = 1; row < direct.size() - 1;
         ++row) // times differ: 0 s there, the session's here
        QCOMPARE(recorded[row].mid(recorded[row].indexOf(',')),
            direct[row].mid(direct[row].indexOf(',')));
    QCOMPARE(recorded[0], direct[0]);
}

void TestCliRecording::showSaysWhatIsInIt()
{
    const CliRun result =
        typed({QStringLiteral("--json"), QStringLiteral("show"), path("a.pcapng")});
    COMPARE_STATUS(result, 0);
    const QJsonObject json = result.object();
    QCOMPARE(json.value(QLatin1String("ending")).toString(), QStringLiteral("stopped"));
    QCOMPARE(json.value(QLatin1String("source")).toString(), QStringLiteral("sim"));
    QVERIFY(json.value(QLatin1String("link_bytes")).toInt() > 2 * 16'000);
    QVERIFY(json.value(QLatin1String("damage")).toArray().isEmpty());
    const QJsonArray channels = json.value(QLatin1String("channels")).toArray();
    QCOMPARE(channels.size(), 3);
    QCOMPARE(channels[0].toObject().value(QLatin1String("name")).toString(), QStringLiteral("I_A"));
    QCOMPARE(
        channels[2].toObject().value(QLatin1String("kind")).toString(), QStringLiteral("slow"));
    const CliRun text =
        typed({QStringLiteral("show"), path("a.pcapng"), QStringLiteral("--events")});
    COMPARE_STATUS(text, 0);
    QVERIFY(text.out.contains(QLatin1String("link state=connected")));
    QVERIFY(text.out.contains(QLatin1String("I_A [A] fast: ")));
}

void TestCliRecording::exportAndImportGiveTheSameFile()
{
    const auto convert = [this](const char *from, const char *to, const QStringList &more = {}) {
        const CliRun result =
            typed(QStringList{QStringLiteral("export"), path(from), QStringLiteral("-o"), path(to)}
                + more);
        COMPARE_STATUS(result, 0);
    };
    convert("a.pcapng", "plain.csv");
    convert("plain.csv", "continental.csv", {QStringLiteral("--continental")});
    convert("continental.csv", "again.csv");
    QCOMPARE(contents(path("again.csv")), contents(path("plain.csv")));
    QVERIFY(contents(path("continental.csv")).startsWith("\xEF\xBB\xBFtime [s];I_A [A];"));
    convert("plain.csv", "part.csv", wordsOf("--signals I_B --from 0.2 --to 0.3"));
    QVERIFY(contents(path("part.csv")).startsWith("time [s],I_B [A]\n"));
    QVERIFY(contents(path("part.csv")).count('\n') <= 1601);
}

void TestCliRecording::aRangeBeyondNanosecondsIsWhatThereIsOfIt_data()
{
    QTest::addColumn<QString>("range");
    QTest::addColumn<bool>("all");
    QTest::newRow("to") << QStringLiteral("--to 1e10") << true;
    QTest::newRow("from") << QStringLiteral("--from -1e300") << true;
    QTest::newRow("both") << QStringLiteral("--from -1e10 --to 1e300") << true;
    QTest::newRow("behind it") << QStringLiteral("--from 1e10") << false;
    QTest::newRow("before it") << QStringLiteral("--to -1e300") << false;
}

void TestCliRecording::aRangeBeyondNanosecondsIsWhatThereIsOfIt()
{
    QFETCH(QString, range);
    QFETCH(bool, all);
    const auto rows = [this](const QString &options) {
        const CliRun run = typed(QStringList{QStringLiteral("--json"), QStringLiteral("export"),
                                     path("a.pcapng"), QStringLiteral("-o"), path("range.csv")}
            + wordsOf(options));
        return run.status == 0 ? run.object().value(QLatin1String("rows")).toInt(-1) : -1;
    };
    const int whole = rows({});
    QVERIFY(whole >= 8000);
    QCOMPARE(rows(range), all ? whole : 0);
}

void TestCliRecording::rowsOfOneTimeAreLeftOutAndTold()
{
    const auto exported = [this](const QByteArray &text) {
        put(path("same.csv"), text);
        return typed({QStringLiteral("--json"), QStringLiteral("export"), path("same.csv"),
            QStringLiteral("-o"), path("once.csv")});
    };
    const CliRun some = exported("time [s],A\n0,1\n0,2\n1,3\n1,4\n");
    COMPARE_STATUS(some, 4);
    QVERIFY2(some.err.contains(
                 QLatin1String("2 rows have the time of the row before and were left out")),
        qPrintable(some.err));
    QVERIFY(!some.object().value(QLatin1String("complete")).toBool(true));
    QCOMPARE(contents(path("once.csv")), QByteArray("time [s],A\n0,1\n1,3\n"));
    const CliRun vesc = exported("ms_today;A;\n0;1;\n0;1;\n50;2;\n");
    COMPARE_STATUS(vesc, 0);
    QVERIFY(vesc.object().value(QLatin1String("complete")).toBool());
}

/// Python's own reader sees every frame.
void TestCliRecording::aWavFileIsReadByOthers()
{
    const CliRun result = typed({QStringLiteral("export"), path("a.pcapng"), QStringLiteral("-o"),
        path("a.wav"), QStringLiteral("--json")});
    COMPARE_STATUS(result, 0);
    const QString python = QStandardPaths::findExecutable(QStringLiteral("python3"));
    QVERIFY2(!python.isEmpty(), "python3 is missing; ./dev setup installs it");
    QProcess reader;
    reader.start(python,
        {QStringLiteral("-c"),
            QStringLiteral("import sys, wave\nw = wave.open(sys.argv[1])\n"
                           "d = w.readframes(w.getnframes())\n"
                           "print(w.getnchannels(), w.getsampwidth(), w.getframerate(), "
                           "w.getnframes(), len(d))"),
            path("a.wav")});
    QVERIFY(reader.waitForFinished(30'000));
    const int frames = result.object().value(QLatin1String("rows")).toInt();
    QCOMPARE(QString::fromLatin1(reader.readAllStandardOutput()).trimmed(),
        QStringLiteral("2 2 16000 %1 %2")
            .arg(QString::number(frames), QString::number(frames * 4)));
}

/// A reader of our own, in Python, that shares nothing with the writer.
void TestCliRecording::aMatlabFileIsReadByOthers()
{
    const CliRun result = typed({QStringLiteral("export"), path("a.pcapng"), QStringLiteral("-o"),
        path("a.mat"), QStringLiteral("--json")});
    COMPARE_STATUS(result, 0);
    QProcess reader;
    reader.start(QStandardPaths::findExecutable(QStringLiteral("python3")),
        {support::sourceFile(QStringLiteral("tests/support/read_mat.py")), path("a.mat")});
    QVERIFY2(reader.waitForFinished(30'000), "python3 is missing; ./dev setup installs it");
    const QJsonObject mat = QJsonDocument::fromJson(reader.readAllStandardOutput()).object();
    const QJsonObject fast = mat.value(QLatin1String("fast")).toObject();
    const qsizetype samples = fast.value(QLatin1String("time")).toArray().size();
    QVERIFY(samples > 0);
    for (const char *column : {"I_A", "I_B"})
        QCOMPARE(fast.value(QLatin1String(column)).toArray().size(), samples);
    qsizetype rows = 0;
    for (const QJsonValue &rate : mat)
        rows += rate.toObject().value(QLatin1String("time")).toArray().size();
    QCOMPARE(result.object().value(QLatin1String("rows")).toInteger(), rows);
}

void TestCliRecording::aDamagedRecordingIsExportedAndTold()
{
    QByteArray bytes = contents(path("a.pcapng"));
    const qsizetype middle = firstDataInTheMiddle(bytes);
    bytes[middle] = static_cast<char>(~bytes[middle]);
    bytes.chop(20);
    put(path("damaged.pcapng"), bytes);
    const CliRun shown =
        typed({QStringLiteral("--json"), QStringLiteral("show"), path("damaged.pcapng")});
    COMPARE_STATUS(shown, 4);
    QCOMPARE(
        shown.object().value(QLatin1String("ending")).toString(), QStringLiteral("interrupted"));
    const QJsonArray damage = shown.object().value(QLatin1String("damage")).toArray();
    QCOMPARE(damage.size(), 2);
    const QJsonObject first = damage[0].toObject();
    const int offset = first.value(QLatin1String("offset")).toInt();
    QVERIFY(offset <= middle);
    QVERIFY(offset + first.value(QLatin1String("bytes")).toInt() > middle);
    QVERIFY(shown.err.contains(QLatin1String("is not whole: bytes ")));
    const CliRun exported = typed(
        {QStringLiteral("export"), path("damaged.pcapng"), QStringLiteral("-o"), path("d.csv")});
    COMPARE_STATUS(exported, 4);
    QVERIFY(contents(path("d.csv")).count('\n') > 1000);
}

void TestCliRecording::whatADiskWasTooSlowForIsNamed_data()
{
    QTest::addColumn<quint64>("samples");
    QTest::addColumn<quint64>("linkBytes");
    QTest::addColumn<quint64>("others");
    QTest::addColumn<QString>("said");
    QTest::newRow("the line") << quint64(0) << quint64(4096) << quint64(0)
                              << QStringLiteral("it lacks 4096 bytes of the line, because");
    QTest::newRow("an event") << quint64(0) << quint64(0) << quint64(1)
                              << QStringLiteral("it lacks 1 other entry, because");
    QTest::newRow("all") << quint64(120) << quint64(1) << quint64(2)
                         << QStringLiteral("it lacks 120 samples, 1 byte of the line, 2 other "
                                           "entries, because the disk was too slow.");
}

void TestCliRecording::whatADiskWasTooSlowForIsNamed()
{
    QFETCH(const quint64, samples);
    QFETCH(const quint64, linkBytes);
    QFETCH(const quint64, others);
    QFETCH(const QString, said);
    QFile::remove(path("slow.pcapng")); // of the row before
    QString why;
    session::RecordingFile file(
        session::makeDiskSink(path("slow.pcapng"), why), {1'700'000'000, "test", "sim"});
    QVERIFY(file.open());
    QVERIFY(file.add(1000, recorded::Lost{samples, linkBytes, others}));
    QVERIFY(file.end());
    const CliRun shown = typed({QStringLiteral("show"), path("slow.pcapng")});
    COMPARE_STATUS(shown, 4);
    QVERIFY2(shown.err.contains(said), qPrintable(shown.err));
    const QJsonObject json =
        typed({QStringLiteral("--json"), QStringLiteral("show"), path("slow.pcapng")}).object();
    QCOMPARE(quint64(json[QLatin1String("lost_samples")].toInteger()), samples);
    QCOMPARE(quint64(json[QLatin1String("lost_link_bytes")].toInteger()), linkBytes);
    QCOMPARE(quint64(json[QLatin1String("lost_others")].toInteger()), others);
}

void TestCliRecording::aFileThatIsThereIsNotRecordedOver()
{
    put(path("old.pcapng"), "old");
    QStringList arguments = wordsOf("--port sim capture --hf I_A --seconds 0.1 --start --record");
    arguments << path("old.pcapng");
    const CliRun result = typed(arguments);
    COMPARE_STATUS(result, 5);
    QCOMPARE(contents(path("old.pcapng")), QByteArray("old"));
    QVERIFY(!result.err.contains(QLatin1String("motor was stopped"))); // it was never started
}

void TestCliRecording::aRecordingIsCalledPcapng_data()
{
    QTest::addColumn<QString>("line");
    for (const char *line :
        {"step speed --from 1000 --to 1500 -o", "identify electrical -o", "response speed -o",
            "experiment plan.json -o", "capture --hf I_A --seconds 0.1 --record"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

void TestCliRecording::aRecordingIsCalledPcapng()
{
    QFETCH(QString, line);
    for (const QString &name : {path("foo.csv"), path("foo"), QString()}) {
        const CliRun run = typed(wordsOf(QStringLiteral("--port sim ") + line) << name);
        COMPARE_STATUS(run, 2);
        const QLatin1String said(name.isEmpty() ? "empty value" : "pcapng");
        QVERIFY2(run.oneLineOfError() && run.err.contains(said), qPrintable(run.err));
        QVERIFY(!QFile::exists(name));
    }
}

/// As the window keeps a long day: each says what it said by itself, byte for byte.
void TestCliRecording::eachOfSeveralExperimentsIsTold()
{
    support::LabBench bench;
    QString why;
    session::RecordingFile file(
        session::makeDiskSink(path("day.pcapng"), why), {1'700'000'000, "test", "sim"});
    QVERIFY(file.open());
    bench.eachEntry = [&file](recorded::Nanos at, const recorded::Entry &entry) {
        QVERIFY(file.add(at, entry));
    };
    QStringList said;
    for (const int rpm : {1500, 1300}) {
        bench.happenings.clear(); // a recording of its own
        bench.steps = {.fromRpm = 1000, .toRpm = rpm, .hold = 200ms};
        const lab::Outcome outcome = bench.run();
        QVERIFY2(outcome.end == lab::End::Complete, qPrintable(support::outcomeText(outcome)));
        const auto series = bench.series();
        QVERIFY2(series && series->rise_s, series ? "no rise" : series.error().c_str());
        said.append(QString::fromUtf8(
            session::findingJson(static_cast<const lab::MeasuredSteps &>(*series))));
    }
    lab::SpinPlan tooFast = lab::spinPlanFor(bench.experiment.subject, {});
    tooFast.highRpm = 9000;
    bench.experiment.plan = tooFast;
    QVERIFY(bench.run().end == lab::End::Refused);
    QVERIFY(file.end());

    const auto evaluated = [this](const QString &options) {
        return typed(QStringList{QStringLiteral("evaluate"), path("day.pcapng")}
            + options.split(QLatin1Char(' '), Qt::SkipEmptyParts));
    };
    const CliRun all = evaluated(QStringLiteral("--json"));
    COMPARE_STATUS(all, 1);
    QCOMPARE(all.out, said.join(QLatin1Char('\n')) + QStringLiteral("\nnull\n"));
    for (const char *words :
        {"Run 3: The experiment ended early: ", "day.pcapng: not conclusive: run 3 of 3."})
        QVERIFY2(all.err.contains(QLatin1String(words)), qPrintable(all.err));
    const CliRun text = evaluated({});
    COMPARE_STATUS(text, 1);
    for (const char *words :
        {"Run 1 of 3: step speed, at ", "Run 2 of 3: step", "Run 3 of 3: identify mechanical, at "})
        QVERIFY2(text.out.contains(QLatin1String(words)), qPrintable(text.out));

    const CliRun second = evaluated(QStringLiteral("--json --run 2"));
    COMPARE_STATUS(second, 0);
    QCOMPARE(second.out, said[1] + QLatin1Char('\n'));
    QVERIFY(!evaluated(QStringLiteral("--run 2")).out.contains(QLatin1String("Run 2")));
    const CliRun third = evaluated(QStringLiteral("--run 3"));
    COMPARE_STATUS(third, 1);
    QVERIFY2(third.out.isEmpty() && third.err.count(QLatin1Char('\n')) == 1,
        qPrintable(third.out + third.err));
    const CliRun none = evaluated(QStringLiteral("--run 4"));
    COMPARE_STATUS(none, 2);
    QVERIFY2(none.err.contains(QLatin1String("has no run 4, only 3.")), qPrintable(none.err));
}

/// As of a program that was killed. What is not known of a step is not 0, and a file that is torn is not whole.
void TestCliRecording::anExperimentThatIsCutOffIsEvaluatedAndTold()
{
    support::LabBench bench;
    QString why;
    session::RecordingFile file(
        session::makeDiskSink(path("killed.pcapng"), why), {1'700'000'000, "test", "sim"});
    QVERIFY(file.open());
    bench.eachEntry = [&file](recorded::Nanos at, const recorded::Entry &entry) {
        QVERIFY(file.add(at, entry));
    };
    bench.steps = {.fromRpm = 1000, .toRpm = 1500};
    bench.begin();
    constexpr std::size_t kAskedDown = 4; // at rest, to the first speed, up, down
    QVERIFY(bench.runUntil([&] { return bench.asked<drive::SpeedRamp>().size() >= kAskedDown; }));
    bench.pair.runFor(60ms);
    QVERIFY(file.end());

    const auto evaluated = [this](const char *name, const QStringList &options) {
        return typed(QStringList{QStringLiteral("evaluate"), path(name)} + options);
    };
    const QStringList json{QStringLiteral("--json")};
    const CliRun killed = evaluated("killed.pcapng", json);
    COMPARE_STATUS(killed, 0);
    QVERIFY2(killed.err.contains(QLatin1String("The recording ends before the series does.")),
        qPrintable(killed.err));
    QVERIFY2(
        killed.out.count(QLatin1String("\"instant_error_s\":null")) == 1, qPrintable(killed.out));
    const CliRun text = evaluated("killed.pcapng", {});
    const QStringList cut = wordsOf(text.lines().value(2));
    QVERIFY2(cut.size() == 7 && cut.mid(2).count(QStringLiteral("-")) == 5, qPrintable(text.out));

    QByteArray bytes = contents(path("killed.pcapng"));
    bytes.chop(20);
    put(path("torn.pcapng"), bytes);
    const CliRun torn = evaluated("torn.pcapng", json);
    COMPARE_STATUS(torn, 4);
    QCOMPARE(torn.out, killed.out);
    QVERIFY2(torn.err.contains(QLatin1String("torn.pcapng is not whole: it ends within a block")),
        qPrintable(torn.err));
}

void TestCliRecording::otherFilesAreExitStatus5()
{
    put(path("text.pcapng"), "hello\n");
    put(path("bad.csv"), "time [s],A\n0,1\n1,x\n");
    for (const char *name : {"text.pcapng", "missing.pcapng"}) {
        const CliRun result = typed({QStringLiteral("show"), path(name)});
        COMPARE_STATUS(result, 5);
        QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
    }
    const CliRun result =
        typed({QStringLiteral("export"), path("bad.csv"), QStringLiteral("-o"), path("new.csv")});
    COMPARE_STATUS(result, 5);
    QVERIFY(result.err.contains(QLatin1String("line 3, column 2: \"x\" is no number")));
    QVERIFY(!QFile::exists(path("new.csv")));
}

void TestCliRecording::wrongUsageIsExitStatus2_data()
{
    QTest::addColumn<QString>("line");
    for (const char *line :
        {"show", "export x.pcapng", "export x.pcapng -o x.xls", "export -o x.csv",
            "export x.pcapng -o x.csv --from 2 --to 1", "export x.pcapng -o x.csv --from 1,5",
            "export x.pcapng -o x.csv --from nan", "export x.pcapng -o x.csv --to inf",
            "--port sim capture --hf I_A --seconds 1 -o x.csv --link", "evaluate",
            "evaluate x.pcapng --run 0", "evaluate x.pcapng --run last"})
        QTest::newRow(line) << QString::fromLatin1(line);
}

void TestCliRecording::wrongUsageIsExitStatus2()
{
    QFETCH(QString, line);
    const CliRun result = typed(line);
    COMPARE_STATUS(result, 2);
    QCOMPARE(result.err.count(QLatin1Char('\n')), 1);
}

QTEST_GUILESS_MAIN(TestCliRecording)
#include "tst_cli_recording.moc"
