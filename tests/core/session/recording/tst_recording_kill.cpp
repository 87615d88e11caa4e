// A recorder that is killed at random moments: every block that it had reported as written reads back.
// The recorder is this very program, started again with --recorder FILE; it reports on its standard output.
#include "session/recording/file.h"
#include "support/recording_facts.h"

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

#include <iostream>
#include <random>

using namespace session;

class TestRecordingKill : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyBlockReportedAsWrittenReadsBack();
};

namespace {

constexpr std::uint32_t kRows = 500;

std::int16_t sampleAt(capture::Tick tick) { return static_cast<std::int16_t>(tick * 31); }

/// Records until it is killed; after each write it says how many samples are written.
int runRecorder(const QString &path)
{
    QString text;
    RecordingFile file(makeDiskSink(path, text), {0, "test", ""});
    if (!file.open())
        return 1;
    file.add(0, capture::StreamLayout{1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    for (capture::Tick tick = 0; !file.isOver(); tick += kRows) {
        capture::SampleBlock block{1, tick, kRows, {}, {}, 0};
        for (capture::Tick i = 0; i < kRows; ++i)
            block.fast.push_back(sampleAt(tick + i));
        file.add(tick, std::move(block));
        // Blocks of many sizes, and a sync now and then.
        if (tick % (capture::Tick(7) * kRows) == 0)
            file.flushAll();
        if (tick % (capture::Tick(400) * kRows) == 0)
            file.sync();
        std::cout << file.counts().samples << '\n' << std::flush;
    }
    return 2;
}

} // namespace

void TestRecordingKill::everyBlockReportedAsWrittenReadsBack()
{
    const bool longRun = qEnvironmentVariableIsSet("ROTORSCOPE_LONG");
    const int kills = longRun ? 200 : 10;
    std::mt19937 random(20261121);
    QTemporaryDir folder;
    int cut = 0;
    for (int kill = 0; kill < kills; ++kill) {
        const QString path = folder.filePath(QStringLiteral("%1.pcapng").arg(kill));
        QProcess recorder;
        recorder.start(QCoreApplication::applicationFilePath(),
            {QStringLiteral("tst_recording_kill"), QStringLiteral("--recorder"), path});
        QVERIFY(recorder.waitForStarted());
        const std::uint64_t until = random() % 400'000;
        std::uint64_t written = 0;
        QByteArray rest;
        const auto take = [&](const QByteArray &bytes) {
            rest += bytes;
            const qsizetype end = rest.lastIndexOf('\n');
            if (end < 0)
                return;
            const QByteArray lines = rest.first(end);
            written = lines.mid(lines.lastIndexOf('\n') + 1).toULongLong();
            rest.remove(0, end + 1);
        };
        while (written < until) {
            QVERIFY2(recorder.waitForReadyRead(30'000), "the recorder fell silent");
            take(recorder.readAllStandardOutput());
        }
        recorder.kill();
        QVERIFY(recorder.waitForFinished());
        take(recorder.readAllStandardOutput());
        QCOMPARE(recorder.exitStatus(), QProcess::CrashExit);

        const auto facts = support::readRecording(path);
        QVERIFY(!facts.ending);
        for (const recorded::Damage &damage : facts.damage) {
            QCOMPARE(damage.kind, recorded::Damage::Kind::CutShort);
            ++cut;
        }
        QVERIFY2(facts.samples() >= written,
            qPrintable(QStringLiteral("kill %1: %2 samples reported, %3 read")
                           .arg(QString::number(kill), QString::number(written),
                               QString::number(facts.samples()))));
        capture::Tick next = 0;
        for (const auto &block : facts.all<capture::SampleBlock>()) {
            QCOMPARE(block.firstTick, next);
            for (const std::int16_t code : block.fast)
                QCOMPARE(code, sampleAt(next++));
        }
        QFile::remove(path);
    }
    qInfo("%d kills, %d files cut within a block, no block lost", kills, cut);
}

static int runTest(int argc, char *argv[])
{
    QCoreApplication app(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 3 && arguments[1] == QLatin1String("--recorder"))
        return runRecorder(arguments[2]);
    TestRecordingKill test;
    return QTest::qExec(&test, argc, argv);
}
static const support::NamedTest namedTest(__FILE__, runTest);
#include "tst_recording_kill.moc"
