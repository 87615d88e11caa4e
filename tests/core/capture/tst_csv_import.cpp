// CSV files into a capture: ours come back to the last digit, those of other programs with their times and names, and
// what is no such file is one error that names its place.
#include "capture/csv_export.h"
#include "capture/csv_import.h"
#include "support/channels/every_channel.h"

#include <QtTest>

#include <cmath>
#include <map>

using namespace capture;

class TestCsvImport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void ourOwnFilesReadBackIdentical_data();
    void ourOwnFilesReadBackIdentical();
    void whatSeparatesIsNotGuessedFromNames_data();
    void whatSeparatesIsNotGuessedFromNames();
    void continentalIsAsSpreadsheetsWantIt();
    void itReadsTheSameHoweverItIsCut();
    void gapsAndEmptyFieldsAreGaps();
    void gapsOfEveryLengthComeBack_data();
    void gapsOfEveryLengthComeBack();
    void rowsThatComeUnevenlyAreNoGaps_data();
    void rowsThatComeUnevenlyAreNoGaps();
    void anotherRateIsNoGap();
    void aTimeColumnHasItsUnitWhateverItsName_data();
    void aTimeColumnHasItsUnitWhateverItsName();
    void filesOfPlotJugglerAreRead();
    void filesOfVescToolAreReadAcrossMidnight();
    void rowsWithTheTimeOfTheRowBeforeAreCounted();
    void timesAreExact();
    void whatIsNoCsvIsAnErrorWithItsPlace_data();
    void whatIsNoCsvIsAnErrorWithItsPlace();
    void rowsBeforeAnErrorStay();
    void anEndlessLineIsRefused();
    void aColumnWithoutANameIsCalledByItsPlace();
};

namespace {

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
    Tick tick = 0;
    for (int number = 0; number < 29; ++number, tick += 100) {
        const std::map<int, Tick> lossBefore{{1, 1}, {2, 2}, {9, 9}, {15, 100}, {20, 10}, {28, 5}};
        const auto loss = lossBefore.find(number);
        const Tick lost = loss == lossBefore.end() ? 0 : loss->second;
        tick += lost;
        SampleBlock block{1, tick, 100, {}, {{tick + 99, {static_cast<std::int32_t>(tick)}}}, lost};
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
    const std::string text = csv(support::everyChannel(capture), options);
    QCOMPARE(std::count(text.begin(), text.end(), '\n'), 2901);
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed(text) && import.finish());
    QCOMPARE(import.rows(), 2900U);
    QCOMPARE(csv(support::everyChannel(read), again), csv(support::everyChannel(capture), again));
    for (const std::size_t fast : {0U, 1U}) {
        const auto lost = support::everyChannel(capture)->at(fast).gaps(0, 10, 0.0);
        const auto found = read.channel(import.channels()[fast])->gaps(0, 10, 0.0);
        QCOMPARE(lost.size(), std::size_t(6));
        QCOMPARE(found.size(), lost.size());
        for (std::size_t i = 0; i < lost.size(); ++i)
            QVERIFY(found[i].from == lost[i].from && found[i].to == lost[i].to);
    }
    QCOMPARE(read.info(import.channels()[0])->name, std::string("I,A"));
    QCOMPARE(read.info(import.channels()[1])->name, std::string("=B\"x\""));
    QCOMPARE(read.info(import.channels()[3])->unit, std::string("V"));
}

void TestCsvImport::whatSeparatesIsNotGuessedFromNames_data()
{
    QTest::addColumn<QByteArray>("name");
    for (const char *name : {"B,1", "a;b;c", "x\ty\tz", "q\";,;\"r"}) {
        QTest::addRow("%s", name) << QByteArray(name);
    }
}

void TestCsvImport::whatSeparatesIsNotGuessedFromNames()
{
    QFETCH(QByteArray, name);
    Capture capture;
    capture.begin({1, 16000.0, 0.25, 1, {{1, name.toStdString(), "A", 0.5, 0.0}}, {}});
    capture.append({1, 0, 2, {3, -5}, {}, 0});
    for (const CsvDialect dialect : {CsvDialect::Plain, CsvDialect::Continental}) {
        CsvOptions options;
        options.dialect = dialect;
        Capture read;
        CsvImport import(read);
        QVERIFY(import.feed(csv(support::everyChannel(capture), options)) && import.finish());
        QCOMPARE(import.channels().size(), std::size_t(1));
        QCOMPARE(read.info(import.channels()[0])->name, name.toStdString());
        QCOMPARE(read.lastValue(import.channels()[0]), std::optional(-2.5));
    }
}

void TestCsvImport::continentalIsAsSpreadsheetsWantIt()
{
    Capture capture;
    capture.begin(
        {1, 16000.0, 0.25, 1, {{1, "A;1", "A", 0.5, 0.0}, {2, "B,1", "A", 0.5, 0.0}}, {}});
    capture.append({1, 0, 2, {3, 4, -5, 0}, {}, 0});
    CsvOptions options;
    options.dialect = CsvDialect::Continental;
    QCOMPARE(csv(support::everyChannel(capture), options),
        std::string("\xEF\xBB\xBF"
                    "time [s];\"A;1 [A]\";\"B,1 [A]\"\r\n0,25;1,5;-2,5\r\n0,2500625;2;0\r\n"));
}

void TestCsvImport::itReadsTheSameHoweverItIsCut()
{
    const std::string text = csv(support::everyChannel(recording())).substr(0, 5000);
    const std::string whole = text.substr(0, text.rfind('\n'));
    std::string first;
    for (const std::size_t piece : {1U, 2U, 7U, 100U, 5000U}) {
        Capture read;
        CsvImport import(read);
        for (std::size_t at = 0; at < whole.size(); at += piece)
            QVERIFY(import.feed(std::string_view(whole).substr(at, piece)));
        QVERIFY(import.finish());
        const std::string again = csv(support::everyChannel(read));
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

void TestCsvImport::gapsOfEveryLengthComeBack_data()
{
    QTest::addColumn<double>("rate");
    for (const double rate : {1000.0, 16000.0, 30000.0, 12345.678})
        QTest::addRow("%g Hz", rate) << rate;
}

void TestCsvImport::gapsOfEveryLengthComeBack()
{
    QFETCH(double, rate);
    Capture capture;
    capture.begin({1, rate, 7.5, 1, {{1, "I", "A", 0.5, 0.0}}, {}});
    Tick tick = 0;
    for (Tick lost = 0; lost < 40; ++lost) {
        tick += lost;
        capture.append({1, tick, 37, std::vector<std::int16_t>(37, 5), {}, lost});
        tick += 37;
    }
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed(csv(support::everyChannel(capture))) && import.finish());
    const auto lost = support::everyChannel(capture)->front().gaps(0, 100, 0.0);
    const auto found = support::everyChannel(read)->front().gaps(0, 100, 0.0);
    QCOMPARE(lost.size(), std::size_t(39));
    QCOMPARE(found.size(), lost.size());
    for (std::size_t i = 0; i < lost.size(); ++i) {
        QVERIFY(std::abs(found[i].from - lost[i].from) < 2e-9); // its step has no finite decimal
        QVERIFY(std::abs(found[i].to - lost[i].to) < 1e-12);
    }
}

void TestCsvImport::rowsThatComeUnevenlyAreNoGaps_data()
{
    QTest::addColumn<QString>("distances"); // ms, again and again
    QTest::newRow("a close pair now and then") << "50 50 0.5 49.5 50 50 50";
    QTest::newRow("late and early again") << "50 1 50 99 50 50 51 49 50";
    QTest::newRow("one late") << "50 50 50 50 50 50 50 50 50 50 50 50 50 50 50 50 85 15";
    QTest::newRow("pairs") << "0.5 49.5";
    QTest::newRow("threes") << "2 2 46";
    QTest::newRow("of any length") << "3 17 6 11 2.5 8 14 9 5 23 1 12";
}

void TestCsvImport::rowsThatComeUnevenlyAreNoGaps()
{
    QFETCH(QString, distances);
    std::string text = "__time,A\n0,0\n";
    double time = 0.0;
    for (int round = 0; round < 20; ++round) {
        for (const QString &one : distances.split(QLatin1Char(' '))) {
            time += one.toDouble() / 1000.0;
            text += std::to_string(time) + ",1\n";
        }
    }
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed(text) && import.finish());
    QCOMPARE(support::everyChannel(read)->front().gaps(0, 1e6, 0.0).size(), std::size_t(0));
    QVERIFY(import.feed(std::to_string(time + 20.0) + ",1\n") && import.finish());
    // This is one.
    QCOMPARE(support::everyChannel(read)->front().gaps(0, 1e6, 0.0).size(), std::size_t(1));
}

void TestCsvImport::anotherRateIsNoGap()
{
    for (const int slower : {2, 10, 100}) {
        std::string text = "time [ms],A\n";
        int time = 0;
        for (int row = 0; row < 300; ++row) {
            text += std::to_string(time) + ",1\n";
            time += row >= 100 && row < 200 ? slower : 1;
        }
        Capture read;
        CsvImport import(read);
        QVERIFY(import.feed(text) && import.finish());
        QCOMPARE(support::everyChannel(read)->front().size(), 300U);
        QCOMPARE(support::everyChannel(read)->front().gaps(0, 1e6, 0.0).size(), std::size_t(0));
    }
}

void TestCsvImport::aTimeColumnHasItsUnitWhateverItsName_data()
{
    QTest::addColumn<QByteArray>("heading");
    QTest::addColumn<qint64>("nanos");
    const auto row = [](const char *heading, Nanos nanos) {
        QTest::newRow(heading) << QByteArray(heading) << qint64(nanos);
    };
    row("Time [ms],A", 5'000'000);
    row("Zeit [ms],A", 5'000'000);
    row("TIME [us],A", 5'000);
    row("TimeStamp [ns],A", 5);
    row("Zeit [s],A", 5'000'000'000);
    row("when,A", 5'000'000'000);
    row("time[ms],A", 5'000'000);
    row("Zeit[us],A", 5'000);
    row("t[0],time[ns]", 1); // the time is behind its value
    row("MS_Today,A", 5'000'000);
    row("ms_today [s],A", 5'000'000'000);
}

void TestCsvImport::aTimeColumnHasItsUnitWhateverItsName()
{
    QFETCH(QByteArray, heading);
    Capture read;
    CsvImport import(read);
    QVERIFY(import.feed(heading.toStdString() + "\n5,1\n") && import.finish());
    QTEST(qint64(read.channel(import.channels()[0])->timeOf(0)), "nanos");
    // Behind the values, only a name tells which column it is.
    Capture other;
    CsvImport second(other);
    QVERIFY(second.feed("A,Time [ms]\n1,5\n") && second.finish());
    QCOMPARE(other.channel(second.channels()[0])->timeOf(0), Nanos(5'000'000));
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
    QCOMPARE(import.channels().size(), std::size_t(3));
    const ValueColumn *current = read.channel(import.channels()[1])->values();
    QCOMPARE(current->at(1), -1.25);
    QCOMPARE(current->timeOf(0), Nanos(86'399'900'000'000));
    QCOMPARE(current->timeOf(2), Nanos(86'400'050'000'000));
}

void TestCsvImport::rowsWithTheTimeOfTheRowBeforeAreCounted()
{
    const auto leftOut = [](std::string_view text, std::uint64_t rows) {
        Capture read;
        CsvImport import(read);
        const bool whole = import.feed(text) && import.finish() && import.rows() == rows;
        return whole ? std::optional(import.leftOut()) : std::nullopt;
    };
    QCOMPARE(leftOut("time [s],A\n0,1\n0,2\n1,3\n1,4\n1.0,5\n2,6\n", 3),
        std::optional(std::uint64_t(3)));
    QCOMPARE(leftOut("time [s],A\n0,1\n1,1\n", 2), std::optional(std::uint64_t(0)));
    // Its way.
    QCOMPARE(leftOut("ms_today;A;\n0;1;\n0;1;\n50;2;\n", 2), std::optional(std::uint64_t(0)));
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

void TestCsvImport::aColumnWithoutANameIsCalledByItsPlace()
{
    Capture capture;
    CsvImport import(capture);
    QVERIFY(import.feed("time;A;\t\n0;1;2\n1;3;4\n") && import.finish());
    QCOMPARE(capture.channels().back().name, std::string("#3"));
    Capture again; // what is written of it is read again
    CsvImport second(again);
    QVERIFY(second.feed(csv(support::everyChannel(capture))) && second.finish());
    QCOMPARE(again.channels().size(), std::size_t(2));
}

QTEST_APPLESS_MAIN(TestCsvImport)
#include "tst_csv_import.moc"
