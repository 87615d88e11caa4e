// The corpus of the settings of the window through its fuzz target, as tst_corpus does it for core's.
#include "fuzz/fuzz_settings.cpp"
#include "support/corpus.h"

class TestCorpusSettings : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyFileIsTaken_data() { support::addFilesOf({QStringLiteral("fuzz_settings")}); }
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

QTEST_APPLESS_MAIN(TestCorpusSettings)
#include "tst_corpus_settings.moc"
