// The corpus of the JSON files that Rotorscope reads through its fuzz target, as tst_corpus does it for core's.
#include "fuzz/fuzz_json.cpp"
#include "support/corpus.h"

class TestCorpusFiles : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyFileIsTaken_data() { support::addFilesOf({QStringLiteral("fuzz_json")}); }
    void everyFileIsTaken()
    {
        QFETCH(QString, path);
        support::playFile(LLVMFuzzerTestOneInput, path);
    }
    void everyBeginningAndEveryFlippedBitIsTaken_data() { everyFileIsTaken_data(); }
    void everyBeginningAndEveryFlippedBitIsTaken()
    {
        QFETCH(QString, path);
        support::playSpoilt(LLVMFuzzerTestOneInput, path);
    }
};

QTEST_APPLESS_MAIN(TestCorpusFiles)
#include "tst_corpus_files.moc"
