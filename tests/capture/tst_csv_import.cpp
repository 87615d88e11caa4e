// CSV files into a capture: ours come back to the last digit, those of other programs with their times and names, and
// what is no such file is one error that names its place.
#include "capture/csv_export.h"
#include "capture/csv_import.h"

#include <QtTest>

#include <cmath>

using namespace capture;

class TestCsvImport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ourOwnFilesReadBackIdentical_data();
    void ourOwnFilesReadBackIdentical();
    void continentalIsAsSpreadsheetsWantIt();
    void itReadsTheSameHoweverItIsCut();
    void gapsAndEmptyFieldsAreGaps();
    void filesOfPlotJugglerAreRead();
    void filesOfVescToolAreReadAcrossMidnight();
    void timesAreExact();
    void whatIsNoCsvIsAnErrorWithItsPlace_data();
    void whatIsNoCsvIsAnErrorWithItsPlace();
    void rowsBeforeAnErrorStay();
    void anEndlessLineIsRefused();
};

namespace {

Snapshot all(const Capture &capture)
{
    std::vector<ChannelId> ids;
    for (const ChannelInfo &info : capture.channels())
        ids.push_back(info.id);
    return capture.snapshot(ids);
}

std::string csv(const Snapshot &channels, CsvOptions options = {})
{
    CsvWriter writer(channels, options);
    std::string text;
    std::string_view piece;
    while (writer.next(piece))
        text += piece;
    return text;
}

/// Signals of every kind, with gaps, awkward names and awkward numbers.
Capture recording()
{
    Capture capture;
    capture.begin({1, 16000.0, 0.25, 1,
        {{1, "I,A", "A", 0.0123456789, 0.0}, {2, "=B\"x\"", "A", -3.3e-7, 32768.0}},
        {{3, "SPEED", "rpm", 6.0, 0.0}}});
    for (Tick tick = 0; tick < 3000; tick += 100) {
        if (tick == 1500)
            continue; // lost
        SampleBlock block{1, tick, 100, {}, {{tick + 99, {static_cast<std::int32_t>(tick)}}},
            tick == 1600 ? 100 : 0};
        for (int i = 0; i < 200; ++i)
            block.fast.push_back(static_cast<std::int16_t>(std::int64_t(i) * 317 + tick * 11));
        capture.append(block);
    }
    capture.appendPolled(9, "U", "V", 0.3, 24.1);
    capture.appendPolled(9, "U", "V", 0.31, -1e-300);
    return capture;
}

CsvError errorOf(std::string_view text)
{
    Capture capture;
    CsvImport import(capture);
    import.feed(text);
    import.finish();
    return import.error().value_or(CsvError{});
}

} // namespace

void TestCsvImport::ourOwnFilesReadBackIdentical_data()
{
    QTest::addColumn<int>("dialect");
    QTest::addColumn<int>("back");
    for (const int dialect : {0, 1}) {
        for (const int back : {0, 1})
            QTest::addRow("%d to %d", dialect, back) << dialect << back;
    }
}

void TestCsvImport::ourOwnFilesReadBackIdentical()
{
    QFETCH(int, dialect);
    QFETCH(int, back);
    CsvOptions options, again;
    options.dialect = static_cast<CsvDialect>(dialect);
    again.dialect = static_cast<CsvDialect>(back);
    const Capture capture = recording();
    const std::string text = csv(all(capture), options);
    QCOMPARE(std::count(text.begin(), text.end(), '\n'), 2901);
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed(text) && import.finish());
    QCOMPARE(import.rows(), 2900U);
    QCOMPARE(csv(all(read), again), csv(all(capture), again));
    QCOMPARE(read.info(import.channels()[0])->name, std::string("I,A"));
    QCOMPARE(read.info(import.channels()[1])->name, std::string("=B\"x\""));
    QCOMPARE(read.info(import.channels()[3])->unit, std::string("V"));
}

void TestCsvImport::continentalIsAsSpreadsheetsWantIt()
{
    Capture capture;
    capture.begin(
        {1, 16000.0, 0.25, 1, {{1, "A;1", "A", 0.5, 0.0}, {2, "B,1", "A", 0.5, 0.0}}, {}});
    capture.append({1, 0, 2, {3, 4, -5, 0}, {}, 0});
    CsvOptions options;
    options.dialect = CsvDialect::Continental;
    QCOMPARE(csv(all(capture), options),
        std::string("\xEF\xBB\xBF"
                    "time [s];\"A;1 [A]\";B,1 [A]\r\n0,25;1,5;-2,5\r\n0,2500625;2;0\r\n"));
}

void TestCsvImport::itReadsTheSameHoweverItIsCut()
{
    const std::string text = csv(all(recording())).substr(0, 5000);
    const std::string whole = text.substr(0, text.rfind('\n'));
    std::string first;
    for (const std::size_t piece : {1U, 2U, 7U, 100U, 5000U}) {
        Capture read;
        CsvImport import(read);
        for (std::size_t at = 0; at < whole.size(); at += piece)
            QVERIFY(import.feed(std::string_view(whole).substr(at, piece)));
        QVERIFY(import.finish());
        const std::string again = csv(all(read));
        if (first.empty())
            first = again;
        QCOMPARE(again, first);
        QCOMPARE(again, whole + '\n');
    }
}

void TestCsvImport::gapsAndEmptyFieldsAreGaps()
{
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed("time [s],A,B\n0,1,1\n0.001,2,\n0.002,3,3\n0.1,4,4\n0.101,5,nan\n"));
    QVERIFY(import.finish());
    const Channel *a = read.channel(import.channels()[0]);
    const Channel *b = read.channel(import.channels()[1]);
    QCOMPARE(a->size(), 5U);
    QCOMPARE(b->size(), 3U);
    QCOMPARE(a->gaps(0, 1, 0.0).size(), std::size_t(1));
    QCOMPARE(a->valueAt(0.0025), std::optional(3.0)); // holds for the usual distance
    QVERIFY(!a->valueAt(0.05));
    QVERIFY(!b->valueAt(0.0015));
}

void TestCsvImport::filesOfPlotJugglerAreRead()
{
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed("__time,/motor/speed,/motor/iq\n1700000000.123456,1500,0.5\n"
                        "1700000000.124456,,0.25\n1700000000.125456,1.5e3,\n"));
    QVERIFY(import.finish());
    QCOMPARE(import.rows(), 3U);
    QCOMPARE(read.info(import.channels()[0])->name, std::string("/motor/speed"));
    QCOMPARE(read.channel(import.channels()[0])->values()->timeOf(0), Nanos(1700000000123456000));
    QCOMPARE(read.size(import.channels()[0]), 2U);
    QCOMPARE(read.lastValue(import.channels()[0]), std::optional(1500.0));
}

void TestCsvImport::filesOfVescToolAreReadAcrossMidnight()
{
    Capture read;
    CsvImport import(read);
    QVERIFY(
        import.feed("ms_today;input_voltage;current_motor;erpm;\r\n86399900;48.1;1.5;1000;\r\n"
                    "86399900;48.1;1.5;1000;\r\n86399950;48.2;-1.25;1001;\r\n50;48.3;0;1002;\r\n"));
    QVERIFY(import.finish());
    QCOMPARE(import.rows(), 3U);
    QCOMPARE(import.repeatedTimes(), 1U);
    QCOMPARE(import.channels().size(), std::size_t(3));
    const ValueColumn *current = read.channel(import.channels()[1])->values();
    QCOMPARE(current->at(1), -1.25);
    QCOMPARE(current->timeOf(0), Nanos(86'399'900'000'000));
    QCOMPARE(current->timeOf(2), Nanos(86'400'050'000'000));
}

void TestCsvImport::timesAreExact()
{
    Capture read;
    CsvImport import(read);
    QVERIFY(
        import.feed("A,time [ms]\n1,-0.000001\n2,0\n3,0.0000005\n4,1e3\n5,86400000000.000001\n"));
    QVERIFY(import.finish());
    const ValueColumn *column = read.channel(import.channels()[0])->values();
    const std::vector<Nanos> expected{-1, 0, 1, 1'000'000'000, 86'400'000'000'000'001};
    for (std::size_t i = 0; i < expected.size(); ++i)
        QCOMPARE(column->timeOf(i), expected[i]);
}

void TestCsvImport::whatIsNoCsvIsAnErrorWithItsPlace_data()
{
    using What = CsvError::What;
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("what");
    QTest::addColumn<int>("line");
    QTest::addColumn<int>("column");
    const auto row = [](const char *text, What what, int line, int column) {
        QTest::newRow(text) << QByteArray(text) << static_cast<int>(what) << line << column;
    };
    row("", What::NoHeading, 0, 0);
    row("1,2,3\n4,5,6\n", What::NoHeading, 1, 1);
    row("time [s]\n1\n", What::NoSignals, 1, 1);
    row("time [s],A\n", What::NoRows, 1, 0);
    row("time [s],A\n0,1\n1,x\n", What::NoNumber, 3, 2);
    row("time [s],A\n0,1\n1,1.5.2\n", What::NoNumber, 3, 2);
    row("time [s],A\n0,1\n,2\n", What::NoTime, 3, 1);
    row("time [s],A\n0,1\nnan,2\n", What::NoTime, 3, 1);
    row("time [s],A\n1e300,1\n", What::NoTime, 2, 1);
    row("time [s],A\n0,1\n1\n", What::OtherNumberOfFields, 3, 2);
    row("time [s],A\n0,1\n1,2,3\n", What::OtherNumberOfFields, 3, 3);
    row("time [s];A\n0;1\n1;2,5,5\n", What::NoNumber, 3, 2);
    row("time [s],A\n1,1\n0.5,2\n", What::TimeRunsBack, 3, 1);
}

void TestCsvImport::whatIsNoCsvIsAnErrorWithItsPlace()
{
    QFETCH(QByteArray, text);
    QFETCH(int, what);
    QFETCH(int, line);
    QFETCH(int, column);
    const CsvError error = errorOf(text.toStdString());
    QCOMPARE(static_cast<int>(error.what), what);
    QCOMPARE(int(error.line), line);
    QCOMPARE(int(error.column), column);
}

void TestCsvImport::rowsBeforeAnErrorStay()
{
    Capture read;
    CsvImport import(read);
    QVERIFY(!import.feed("time [s],A,B\n0,1,1\n1,2,x\n2,3,3\n"));
    QVERIFY(!import.finish());
    QCOMPARE(import.rows(), 1U);
    for (const ChannelId id : import.channels())
        QCOMPARE(read.size(id), 1U); // never half a row
}

void TestCsvImport::anEndlessLineIsRefused()
{
    Capture read;
    CsvImport import(read);
    const std::string piece(100'000, 'x');
    bool goesOn = true;
    for (int i = 0; goesOn && i < 100; ++i)
        goesOn = import.feed(piece);
    QVERIFY(!goesOn);
    QCOMPARE(import.error()->what, CsvError::What::LineTooLong);
    std::string wide = "time [s]";
    for (int i = 0; i < 2000; ++i)
        wide += ",a";
    QCOMPARE(errorOf(wide + "\n").what, CsvError::What::TooManyColumns);
}

QTEST_APPLESS_MAIN(TestCsvImport)
#include "tst_csv_import.moc"
