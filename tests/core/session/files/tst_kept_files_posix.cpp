// Files that people keep, whatever happens: a save or an export that is killed leaves the whole old file or the whole
// new one, and no locale of the system changes a byte of any file, or what is read from one. Both are done by this very
// program, started again with a word that says what to do. 100 kills; with ROTORSCOPE_LONG=1 1,000 of them.
#include "capture/csv_import.h"
#include "session/files/export_formats.h"
#include "session/files/motion_log_file.h"
#include "session/files/motor_file.h"
#include "session/files/rev_up_json.h"
#include "session/files/snapshot_json.h"
#include "session/files/whole_file.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QLocale>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <clocale>
#include <iostream>
#include <random>
#include <set>

using namespace session;

class TestKeptFiles : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aKilledSaveLeavesAWholeFile_data();
    void aKilledSaveLeavesAWholeFile();
    void noLocaleChangesAFile();
    void actsAreLoggedInTheOrderInWhichTheyWereAskedFor();
    void theLogOfADayIsWritten();
};

namespace {

/// Values of every kind, with awkward numbers and names.
snapshots::Snapshot snapshotOf(int version, int entries)
{
    snapshots::Snapshot snapshot;
    snapshot.board.firmware = "version " + std::to_string(version);
    for (int i = 0; i < entries; ++i) {
        snapshots::Entry entry;
        entry.name = "REGISTER_I_" + std::to_string(i); // an I is another letter in Turkish
        entry.motor = 1;
        entry.id = static_cast<catalog::RegisterId>(0x49 + i);
        entry.tunable = true;
        if (i % 3 == 0) {
            entry.type = catalog::ValueType::F32;
            entry.value = 1234567.5 / (1 + i + version);
        } else {
            entry.type = catalog::ValueType::S16;
            entry.value = std::int64_t{i % 1000 - 500};
        }
        entry.shown = 0.001 * i + version;
        entry.unit = "A";
        snapshot.entries.push_back(std::move(entry));
    }
    return snapshot;
}

capture::Capture captureOf(int version)
{
    capture::Capture capture;
    capture.begin({1, 16000.0, 0.25, 1, {{1, "I_A", "A", 0.0123456789, 0.0}}, {}});
    capture::SampleBlock block{1, 0, 20'000, {}, {}, 0};
    for (int i = 0; i < 20'000; ++i)
        block.fast.push_back(static_cast<std::int16_t>(i * 7 + version));
    capture.append(block);
    return capture;
}

FileError exportCsv(const QString &path, int version)
{
    const capture::Capture capture = captureOf(version);
    return exportFormatNamed("csv")
        ->write(path, {capture.snapshot(std::array{capture.channels().front().id}), {}}, {})
        .file.error;
}

bool save(const QString &what, const QString &path, int version)
{
    if (what == QLatin1String("csv"))
        return exportCsv(path, version) == FileError::None;
    return writeWholeFile(path, snapshotJson(snapshotOf(version, 2000))).isEmpty();
}

/// Saves one version after the other over the same file until it is killed; says which is being written.
int runSaver(const QString &what, const QString &path)
{
    for (int version = 1;; ++version) {
        std::cout << version << '\n' << std::flush;
        if (!save(what, path, version % 50))
            return 1;
    }
}

/// Every file of ours, one behind the other, and what is read back from them.
QByteArray everyFile(const QString &folder)
{
    QByteArray all = snapshotJson(snapshotOf(3, 20));
    const auto snapshot = readSnapshotJson(all);
    all += snapshot ? snapshotJson(*snapshot) : QByteArray("no snapshot");
    const auto motor = readMotor("{\"motor\": {\"rs_ohm\": 0.35, \"polePairs\": 7}}");
    all += motor ? motorJson(motor->sheet())
                 : QByteArray::fromStdString(motorFileErrorText("f", motor.error()));
    const motor::RevUp stages = motor::usualRevUp(1.5, 3000.0, 0.00123);
    const QByteArray revUp = revUpJson(stages, 0.00123);
    all += revUp;
    if (const auto again = readRevUpJson(revUp, 0.00123))
        all += revUpJson(*again, 0.00123);
    drive::MotionEntry entry;
    entry.act = drive::MotionAct::Stop;
    all += motionLogText({{entry, QDateTime::fromMSecsSinceEpoch(1'700'000'000'123, Qt::UTC)}},
        QStringLiteral("kim"));
    const QString csv = folder + QStringLiteral("/run.csv");
    exportCsv(csv, 1);
    const auto text = readWholeFile(csv);
    all += text ? *text : QByteArray("no text");
    capture::Capture read;
    capture::CsvImport import(read);
    import.feed("time;I\n0,5;1,25\n1,5;-2,5\n");
    import.finish();
    all += QByteArray::number(qulonglong(import.rows()));
    for (const capture::ChannelInfo &info : read.channels())
        all += QByteArray::number(*read.lastValue(info.id), 'g', 17);
    return all;
}

drive::MotionEntry motionAsked(std::int64_t ms, drive::MotionAct act)
{
    drive::MotionEntry entry;
    entry.act = act;
    entry.asked = entry.ended = TimePoint(std::chrono::milliseconds(ms));
    return entry;
}

int runWriter(const QString &folder)
{
    std::setlocale(LC_ALL, "");
    QLocale::setDefault(QLocale::system());
    std::cout << QCryptographicHash::hash(everyFile(folder), QCryptographicHash::Sha256)
                     .toHex()
                     .constData()
              << ' ' << QLocale().decimalPoint().toStdString() << '\n';
    return 0;
}

} // namespace

void TestKeptFiles::aKilledSaveLeavesAWholeFile_data()
{
    QTest::addColumn<QString>("what");
    QTest::addRow("snapshot") << "snapshot";
    QTest::addRow("csv") << "csv";
}

void TestKeptFiles::aKilledSaveLeavesAWholeFile()
{
    QFETCH(QString, what);
    const int kills = qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0 ? 500 : 50;
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("kept"));
    QVERIFY(save(what, path, 0));
    std::set<QByteArray> whole;
    for (int version = 0; version < 50; ++version) {
        const QString other = folder.filePath(QStringLiteral("other"));
        QVERIFY(save(what, other, version));
        whole.insert(readWholeFile(other).value_or(QByteArray()));
    }
    QCOMPARE(whole.size(), std::size_t(50));
    std::mt19937 random(20261122);
    for (int kill = 0; kill < kills; ++kill) {
        QProcess saver;
        saver.start(QCoreApplication::applicationFilePath(),
            {QStringLiteral("tst_kept_files_posix"), QStringLiteral("--save"), what, path});
        QVERIFY(saver.waitForStarted());
        const auto versions = 1 + random() % 4;
        QByteArray said;
        while (said.count('\n') < int(versions)) {
            QVERIFY2(saver.waitForReadyRead(30'000), "the saver fell silent");
            said += saver.readAllStandardOutput();
        }
        // Somewhere within the next save: as long as the one before took is never waited.
        QElapsedTimer spin;
        spin.start();
        const qint64 until = random() % 3'000'000; // ns
        while (spin.nsecsElapsed() < until) { }
        saver.kill();
        QVERIFY(saver.waitForFinished());
        QCOMPARE(saver.exitStatus(), QProcess::CrashExit);
        const auto text = readWholeFile(path);
        QVERIFY(text.has_value());
        QVERIFY2(whole.contains(*text), qPrintable(QStringLiteral("kill %1").arg(kill)));
    }
}

/// Records are noted more or less late, which must not bring their times into another order.
void TestKeptFiles::actsAreLoggedInTheOrderInWhichTheyWereAskedFor()
{
    const auto at = [](qint64 ms) {
        return QDateTime::fromMSecsSinceEpoch(1'700'000'000'000 + ms, Qt::UTC);
    };
    using drive::MotionAct;
    const QList<QByteArray> lines = motionLogText(
        {{motionAsked(100, MotionAct::Start), at(108)}, {motionAsked(90, MotionAct::Arm), at(115)},
            {motionAsked(500, MotionAct::Stop), at(515)},
            {motionAsked(500, MotionAct::Stop), at(502)},
            {motionAsked(600, MotionAct::Stop), at(999'000)}},
        QStringLiteral("kim"))
                                        .split('\n');
    QStringList told;
    for (const QByteArray &line : lines.mid(1))
        if (!line.isEmpty())
            told.append(QString::fromLatin1(
                line.split(',')[0] + ' ' + line.split(',')[1].right(7) + ' ' + line.split(',')[5]));
    QCOMPARE(told,
        (QStringList{QStringLiteral("1 20.092Z ARM"), QStringLiteral("2 20.102Z START"),
            QStringLiteral("3 20.502Z STOP"), QStringLiteral("4 20.502Z STOP"),
            QStringLiteral("5 59.000Z STOP")})); // behind a sleep: another clock
}

/// A line for each, however many there are: what took as long as the square of their number never came to its end here.
void TestKeptFiles::theLogOfADayIsWritten()
{
    constexpr int kActs = 100'000;
    const QDateTime morning = QDateTime::fromMSecsSinceEpoch(1'700'000'000'000); // local
    std::vector<LoggedMotion> log;
    for (int i = 0; i < kActs; ++i)
        log.push_back(
            loggedNow(motionAsked(i, drive::MotionAct::SpeedRamp), morning.addMSecs(i + i % 7)));
    QCOMPARE(motionLogText(log, QStringLiteral("kim")).count('\n'), kActs + 1);
}

void TestKeptFiles::noLocaleChangesAFile()
{
    QTemporaryDir folder;
    QByteArray first;
    std::set<QByteArray> marks;
    for (const char *locale : {"C", "de_DE.UTF-8", "tr_TR.UTF-8", "ar_EG.UTF-8"}) {
        QProcess writer;
        auto environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("LC_ALL"), QString::fromLatin1(locale));
        environment.insert(QStringLiteral("LANG"), QString::fromLatin1(locale));
        writer.setProcessEnvironment(environment);
        writer.start(QCoreApplication::applicationFilePath(),
            {QStringLiteral("tst_kept_files_posix"), QStringLiteral("--write"), folder.path()});
        QVERIFY(writer.waitForFinished());
        const QList<QByteArray> said = writer.readAllStandardOutput().simplified().split(' ');
        QCOMPARE(said.size(), 2);
        if (first.isEmpty())
            first = said[0];
        QVERIFY2(said[0] == first, locale);
        marks.insert(said[1]);
    }
    QVERIFY2(marks.size() > 1, "no locale had another decimal mark: this shows nothing");
}

static int runTest(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments[1] == QLatin1String("--save"))
        return runSaver(arguments[2], arguments[3]);
    if (arguments.size() == 3 && arguments[1] == QLatin1String("--write"))
        return runWriter(arguments[2]);
    TestKeptFiles test;
    return QTest::qExec(&test, argc, argv);
}
static const support::NamedTest namedTest(__FILE__, runTest);
#include "tst_kept_files_posix.moc"
