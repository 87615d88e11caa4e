// Every file of the corpora through the fuzz targets, in the ordinary build: what a fuzzer once found stays found.
#include "fuzz/script.h"

#include <QDir>
#include <QtTest>

// Each target is one function of the same name; here they stand side by side.
#define LLVMFuzzerTestOneInput fuzzController
#include "fuzz/fuzz_controller.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzMcp
#include "fuzz/fuzz_mcp.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDatalog
#include "fuzz/fuzz_datalog.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzTrace
#include "fuzz/fuzz_trace.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzRecording
#include "fuzz/fuzz_recording.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzMcb
#include "fuzz/fuzz_mcb.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzFormula
#include "fuzz/fuzz_formula.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzLegacy
#include "fuzz/fuzz_legacy.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveMcp
#include "fuzz/fuzz_drive_mcp.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveLegacy
#include "fuzz/fuzz_drive_legacy.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveMcb
#include "fuzz/fuzz_drive_mcb.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveAuto
#include "fuzz/fuzz_drive_auto.cpp"
#undef LLVMFuzzerTestOneInput

class TestCorpus : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyFileIsTaken_data();
    void everyFileIsTaken();
    void everyBeginningAndEveryFlippedBitIsTaken_data() { everyFileIsTaken_data(); }
    void everyBeginningAndEveryFlippedBitIsTaken();
};

namespace {

using Target = int (*)(const std::uint8_t *, std::size_t);

Target targetOf(const QString &name)
{
    return name == "fuzz_controller"  ? fuzzController
        : name == "fuzz_mcp"          ? fuzzMcp
        : name == "fuzz_mcb"          ? fuzzMcb
        : name == "fuzz_datalog"      ? fuzzDatalog
        : name == "fuzz_trace"        ? fuzzTrace
        : name == "fuzz_recording"    ? fuzzRecording
        : name == "fuzz_formula"      ? fuzzFormula
        : name == "fuzz_legacy"       ? fuzzLegacy
        : name == "fuzz_drive_mcp"    ? fuzzDriveMcp
        : name == "fuzz_drive_mcb"    ? fuzzDriveMcb
        : name == "fuzz_drive_auto"   ? fuzzDriveAuto
        : name == "fuzz_drive_legacy" ? fuzzDriveLegacy
                                      : nullptr;
}

int play(Target target, const QByteArray &bytes)
{
    return target(reinterpret_cast<const std::uint8_t *>(bytes.constData()),
        static_cast<std::size_t>(bytes.size()));
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

void TestCorpus::everyFileIsTaken_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("path");
    const QDir corpora(QStringLiteral(ROTORSCOPE_TEST_DATA "/corpus"));
    for (const QFileInfo &folder : corpora.entryInfoList({"fuzz_*"}, QDir::Dirs, QDir::Name)) {
        for (const QFileInfo &file : QDir(folder.filePath()).entryInfoList(QDir::Files, QDir::Name))
            QTest::addRow("%s %s", qPrintable(folder.fileName()), qPrintable(file.fileName()))
                << folder.fileName() << file.filePath();
    }
}

void TestCorpus::everyFileIsTaken()
{
    QFETCH(QString, target);
    QFETCH(QString, path);
    QVERIFY2(targetOf(target), "a corpus without its target");
    const QByteArray bytes = contentOf(path);
    QVERIFY(!bytes.isEmpty());
    QCOMPARE(play(targetOf(target), bytes), 0); // a finding aborts
}

void TestCorpus::everyBeginningAndEveryFlippedBitIsTaken()
{
    QFETCH(QString, target);
    QFETCH(QString, path);
    const QByteArray bytes = contentOf(path);
    const qsizetype step =
        std::max<qsizetype>(1, bytes.size() / 50); // a fair sample of the long ones
    for (qsizetype at = 0; at < bytes.size(); at += step) {
        QCOMPARE(play(targetOf(target), bytes.first(at)), 0);
        QByteArray flipped = bytes;
        flipped[at] = static_cast<char>(flipped[at] ^ 1 << at % 8);
        QCOMPARE(play(targetOf(target), flipped), 0);
    }
}

QTEST_APPLESS_MAIN(TestCorpus)
#include "tst_corpus.moc"
