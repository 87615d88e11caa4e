// Every file of the corpora through the fuzz targets, in the ordinary build: what a fuzzer once found stays found.
#include "support/corpus.h"

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
#define LLVMFuzzerTestOneInput fuzzFcp
#include "fuzz/fuzz_legacy.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveMcp
#include "fuzz/fuzz_drive_mcp.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveFcp
#include "fuzz/fuzz_drive_legacy.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveMcb
#include "fuzz/fuzz_drive_mcb.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzDriveAuto
#include "fuzz/fuzz_drive_auto.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzCsv
#include "fuzz/fuzz_csv.cpp"
#undef LLVMFuzzerTestOneInput
#define LLVMFuzzerTestOneInput fuzzExperiment
#include "fuzz/fuzz_experiment.cpp"
#undef LLVMFuzzerTestOneInput

class TestCorpus : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyFolderHasItsTarget();
    void everyFileIsTaken_data();
    void everyFileIsTaken();
    void everyBeginningAndEveryFlippedBitIsTaken_data() { everyFileIsTaken_data(); }
    void everyBeginningAndEveryFlippedBitIsTaken();
};

namespace {

const QMap<QString, support::FuzzTarget> kTargets{
    {QStringLiteral("fuzz_controller"), fuzzController},
    {QStringLiteral("fuzz_mcp"), fuzzMcp},
    {QStringLiteral("fuzz_datalog"), fuzzDatalog},
    {QStringLiteral("fuzz_trace"), fuzzTrace},
    {QStringLiteral("fuzz_recording"), fuzzRecording},
    {QStringLiteral("fuzz_mcb"), fuzzMcb},
    {QStringLiteral("fuzz_formula"), fuzzFormula},
    {QStringLiteral("fuzz_legacy"), fuzzFcp},
    {QStringLiteral("fuzz_drive_mcp"), fuzzDriveMcp},
    {QStringLiteral("fuzz_drive_legacy"), fuzzDriveFcp},
    {QStringLiteral("fuzz_drive_mcb"), fuzzDriveMcb},
    {QStringLiteral("fuzz_drive_auto"), fuzzDriveAuto},
    {QStringLiteral("fuzz_csv"), fuzzCsv},
    {QStringLiteral("fuzz_experiment"), fuzzExperiment},
};

/// Those that need more than core: tst_corpus_files and tst_corpus_settings.
const QStringList kElsewhere{QStringLiteral("fuzz_json"), QStringLiteral("fuzz_settings")};

} // namespace

void TestCorpus::everyFolderHasItsTarget()
{
    for (const QString &folder : QDir(support::corpora()).entryList({"fuzz_*"}, QDir::Dirs))
        QVERIFY2(kTargets.contains(folder) || kElsewhere.contains(folder), qPrintable(folder));
}

void TestCorpus::everyFileIsTaken_data() { support::addFilesOf(kTargets.keys()); }

void TestCorpus::everyFileIsTaken()
{
    QFETCH(QString, target);
    QFETCH(QString, path);
    support::playFile(kTargets.value(target), path);
}

void TestCorpus::everyBeginningAndEveryFlippedBitIsTaken()
{
    QFETCH(QString, target);
    QFETCH(QString, path);
    support::playSpoilt(kTargets.value(target), path);
}

QTEST_APPLESS_MAIN(TestCorpus)
#include "tst_corpus.moc"
