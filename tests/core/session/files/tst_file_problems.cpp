// What files are refused with, as the command line says it and the window translates it.
#include "session/files/file_problems.h"

#include <QtTest>

using namespace session;
using What = capture::CsvError::What;

class TestFileProblems : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aCsvProblemNamesItsPlace();
    void anExportProblemNamesTheFormatAndWhatFits();
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

void TestFileProblems::eachPieceCanBeTranslated()
{
    QCOMPARE(csvProblemText({What::TimeRunsBack, 9, 1, "x"}, shouted),
        QStringLiteral("LINE 9, COLUMN 1: THE TIME x IS BEFORE THE ONE ABOVE IT"));
    QVERIFY(exportProblemText(ExportProblem::TooLong, *exportFormatNamed("mat"), shouted)
                .contains(QStringLiteral("AT MOST 2 GIB OF NUMBERS")));
}

QTEST_GUILESS_MAIN(TestFileProblems)
#include "tst_file_problems.moc"
