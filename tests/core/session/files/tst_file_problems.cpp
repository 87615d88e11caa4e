// What files are refused with, as the command line says it and the window translates it.
#include "session/files/problems.h"

#include <QtTest>

using namespace session;
using What = capture::CsvError::What;

class TestFileProblems : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCsvProblemNamesItsPlace();
    void anExportProblemNamesTheFormatAndWhatFits();
    void aSnapshotProblemNamesItsLineAndRegister();
    void aRevUpProblemNamesItsStage();
    void whatIsNotInARecordingIsCounted();
    void eachPieceCanBeTranslated();
};

namespace {

QString shouted(const char *english) { return QString::fromLatin1(english).toUpper(); }

} // namespace

void TestFileProblems::aCsvProblemNamesItsPlace()
{
    QCOMPARE(csvProblemText({What::NoNumber, 3, 2, "%1"}),
        QStringLiteral("line 3, column 2: \"%1\" is no number"));
    QCOMPARE(csvProblemText({What::NoRows, 1, 0, {}}),
        QStringLiteral("line 1: there is a heading and nothing else"));
}

void TestFileProblems::anExportProblemNamesTheFormatAndWhatFits()
{
    const ExportFormat &wav = *exportFormatNamed("wav");
    QCOMPARE(exportProblemText(ExportProblem::None, wav), QString());
    QCOMPARE(exportProblemText(ExportProblem::DifferentRates, wav),
        QStringLiteral("No WAV file: the signals have different rates. Choose some of one rate."));
    for (const auto problem : {ExportProblem::TooManySignals, ExportProblem::TooLong})
        QCOMPARE(exportProblemText(problem, wav),
            QStringLiteral("No WAV file: it holds at most 64 signals and 4 GiB. Choose fewer "
                           "signals or a shorter range."));
}

void TestFileProblems::aSnapshotProblemNamesItsLineAndRegister()
{
    using enum SnapshotProblem;
    const QString file = QStringLiteral("%2.json");
    QCOMPARE(snapshotProblemText(file, {NotJson, 3, 0, {}, QStringLiteral("illegal value")}),
        QStringLiteral("%2.json cannot be used: in line 3 it is no JSON (illegal value)."));
    QCOMPARE(snapshotProblemText(file, {TooManyRegisters, 0, 0, {}, {}}),
        QStringLiteral("%2.json cannot be used: it has more registers than any board."));
    QCOMPARE(snapshotProblemText(file, {NoName, 5, 2, {}, {}}),
        QStringLiteral("%2.json cannot be used: line 5, register 2: it has no name."));
    QCOMPARE(snapshotProblemText(file, {Twice, 6, 3, QStringLiteral("SPEED_KP"), {}}),
        QStringLiteral("%2.json cannot be used: line 6, register SPEED_KP: it is there twice."));
}

void TestFileProblems::aRevUpProblemNamesItsStage()
{
    using Kind = RevUpFileError::Kind;
    const QString file = QStringLiteral("%2.json");
    QCOMPARE(revUpProblemText(file, {Kind::NotJson}),
        QStringLiteral("%2.json is no rev-up: it is not JSON."));
    QCOMPARE(revUpProblemText(file, {Kind::NoStages}),
        QStringLiteral("%2.json is no rev-up: it has no stages, or more than five."));
    QCOMPARE(revUpProblemText(file, {Kind::BadStage, 2}),
        QStringLiteral("%2.json is no rev-up: the numbers of its stage 2 do not fit."));
}

void TestFileProblems::whatIsNotInARecordingIsCounted()
{
    QCOMPARE(lostText({}), QString());
    QCOMPARE(
        lostText({120, 1, 2}), QStringLiteral("120 samples, 1 byte of the line, 2 other entries"));
    QCOMPARE(
        lostText({1, 4096, 1}), QStringLiteral("1 sample, 4096 bytes of the line, 1 other entry"));
    QCOMPARE(lostText({0, 2, 0}, shouted), QStringLiteral("2 BYTES OF THE LINE"));
}

void TestFileProblems::eachPieceCanBeTranslated()
{
    QCOMPARE(csvProblemText({What::TimeRunsBack, 9, 1, "x"}, shouted),
        QStringLiteral("LINE 9, COLUMN 1: THE TIME x IS BEFORE THE ONE ABOVE IT"));
    QVERIFY(exportProblemText(ExportProblem::TooLong, *exportFormatNamed("mat"), shouted)
                .contains(QStringLiteral("AT MOST 2 GIB OF NUMBERS")));
    const QString a = QStringLiteral("a"), gain = QStringLiteral("Kp");
    QCOMPARE(snapshotProblemText(a, {SnapshotProblem::NoId, 5, 2, gain, {}}, shouted),
        QStringLiteral("a CANNOT BE USED: LINE 5, REGISTER Kp: IT HAS NO ID."));
    QCOMPARE(revUpProblemText(a, {RevUpFileError::Kind::BadStage, 2}, shouted),
        QStringLiteral("a IS NO REV-UP: THE NUMBERS OF ITS STAGE 2 DO NOT FIT."));
}

QTEST_GUILESS_MAIN(TestFileProblems)
#include "tst_file_problems.moc"
