// The CSV text against what was recorded: read back it gives the same samples, and nothing is made up.
#include "capture/csv_export.h"

#include <QtTest>

#include <charconv>
#include <random>

using namespace capture;

class TestCsvExport : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theFileLooksAsDocumented();
    void theFastestThatHasSamplesMakesTheRows();
    void whatNoRowShowsIsKnown();
    void everyCodeReadsBackAsItself_data();
    void everyCodeReadsBackAsItself();
    void signalsOfAScaleKeepTheirOwnValues();
    void timesAreExactToTheTick();
    void lostRowsAreAbsent();
    void slowValuesAreHeldAndBlankWhereUnknown();
    void channelsOfDifferentTimesShareTheFileWithBlanks();
    void aRangeHoldsExactlyItsRows();
    void aHeldValueFromBeforeTheRangeIsShown();
    void perRateGivesEverySampleOnce();
    void columnsComeInTheOrderAsked();
    void namesThatASpreadsheetWouldRunAreMadeHarmless();
    void anEmptyCaptureIsAHeading();
    void progressEndsAtOne();
};

namespace {

StreamLayout layout(
    StreamId id, std::vector<StreamSignal> fast, std::vector<StreamSignal> slow = {})
{
    return {id, 16000.0, 0.0, 1, std::move(fast), std::move(slow)};
}

StreamSignal signal(catalog::RegisterId id, double factor = 0.5)
{
    return {id, "R" + std::to_string(id), "A", factor, 0.0};
}

SampleBlock blockOfCodes(
    StreamId stream, Tick tick, std::uint32_t count, std::vector<std::int16_t> codes)
{
    return {stream, tick, count, std::move(codes), {}, 0};
}

std::string textOf(const Snapshot &channels, CsvOptions options = {})
{
    CsvWriter writer(channels, options);
    std::string all;
    std::string_view piece;
    while (writer.next(piece))
        all += piece;
    return all;
}

Snapshot allOf(const Capture &capture)
{
    std::vector<ChannelId> ids;
    for (const ChannelInfo &info : capture.channels())
        ids.push_back(info.id);
    return capture.snapshot(ids);
}

QList<QByteArray> linesOf(const std::string &text)
{
    QList<QByteArray> lines = QByteArray::fromStdString(text).split('\n');
    lines.removeLast();
    return lines;
}

template <class Number>
Number parsed(const QByteArray &text)
{
    Number value{};
    const auto result = std::from_chars(text.begin(), text.end(), value);
    return result.ptr == text.end() ? value : Number(-12345678);
}

} // namespace

void TestCsvExport::theFileLooksAsDocumented()
{
    Capture capture;
    capture.begin(layout(1, {signal(1), signal(2, -0.1)}));
    capture.append(blockOfCodes(1, 0, 3, {1, 2, -3, 10, 0, 30}));
    QCOMPARE(textOf(allOf(capture)),
        std::string("time [s],R1 [A],R2 [A]\n"
                    "0,0.5,-1\n"
                    "0.0000625,1,-0\n"
                    "0.000125,-1.5,-3\n"));
}

void TestCsvExport::theFastestThatHasSamplesMakesTheRows()
{
    Capture capture;
    capture.begin(layout(1, {signal(1)})); // announced, and nothing came
    capture.appendPolled(5, "P", "rpm", 0.1, 1500.5);
    capture.appendPolled(5, "P", "rpm", 0.2, 1600.5);
    QCOMPARE(
        textOf(allOf(capture)), std::string("time [s],R1 [A],P [rpm]\n0.1,,1500.5\n0.2,,1600.5\n"));
    capture.append(blockOfCodes(1, 16000, 1, {7}));
    QCOMPARE(textOf(allOf(capture)), std::string("time [s],R1 [A],P [rpm]\n1,3.5,1600.5\n"));
    // Where it has none, the slower one makes them, and what was fast does not stay.
    capture.appendPolled(5, "P", "rpm", 1.5, 1.0);
    capture.appendPolled(5, "P", "rpm", 2.5, 2.0);
    CsvOptions behind;
    behind.range = TimeSpan{1.25, 3.0};
    QCOMPARE(
        textOf(allOf(capture), behind), std::string("time [s],R1 [A],P [rpm]\n1.5,,1\n2.5,,2\n"));
}

void TestCsvExport::whatNoRowShowsIsKnown()
{
    Capture capture;
    QVERIFY(everySampleHasARow(allOf(capture)));
    capture.begin(layout(1, {signal(1)}));
    capture.appendPolled(5, "P", "rpm", 0.9, 1.0);
    QVERIFY(everySampleHasARow(allOf(capture)));
    capture.append(blockOfCodes(1, 16000, 100, std::vector<std::int16_t>(100, 7)));
    QVERIFY(everySampleHasARow(allOf(capture))); // it holds when the first row comes
    capture.appendPolled(5, "P", "rpm", 1.001, 2.0);
    QVERIFY(everySampleHasARow(allOf(capture)));
    capture.appendPolled(5, "P", "rpm", 1.00101, 3.0); // until the next row
    QVERIFY(everySampleHasARow(allOf(capture)));
    const std::string shown = textOf(allOf(capture));
    QVERIFY(shown.find(",2\n") != std::string::npos && shown.find(",3\n") != std::string::npos);
    // Between two rows as well: the one before is in none.
    capture.appendPolled(5, "P", "rpm", 1.00102, 4.0);
    QVERIFY(!everySampleHasARow(allOf(capture)));
    Capture after;
    after.begin(layout(1, {signal(1)}));
    after.append(blockOfCodes(1, 0, 100, std::vector<std::int16_t>(100, 7)));
    after.appendPolled(5, "P", "rpm", 60.0, 2.0);
    QVERIFY(!everySampleHasARow(allOf(after)));
    for (const Snapshot &part : splitByRate(allOf(after)))
        QVERIFY(everySampleHasARow(part));
}

void TestCsvExport::everyCodeReadsBackAsItself_data()
{
    QTest::addColumn<double>("factor");
    // As boards have it, with no short decimal form.
    QTest::newRow("of a current") << 3.3 / 65536.0 / 0.33 / 1.53;
    QTest::newRow("with the longest texts there are") << 1.2345678901e-15;
}

void TestCsvExport::everyCodeReadsBackAsItself()
{
    QFETCH(const double, factor);
    Capture capture;
    capture.begin(layout(1, {signal(1, factor)}));
    std::vector<std::int16_t> codes(65536);
    for (int i = 0; i < 65536; ++i)
        codes[std::size_t(i)] = static_cast<std::int16_t>(i - 32768);
    capture.append(blockOfCodes(1, 7, 65536, codes));
    const QList<QByteArray> lines = linesOf(textOf(allOf(capture)));
    QCOMPARE(lines.size(), 65537);
    for (int i = 0; i < 65536; ++i) {
        const QList<QByteArray> fields = lines[i + 1].split(',');
        const auto value = parsed<float>(fields[1]);
        QCOMPARE(value, static_cast<float>(codes[std::size_t(i)] * factor));
        QCOMPARE(std::lround(double(value) / factor), long(codes[std::size_t(i)]));
    }
}

void TestCsvExport::signalsOfAScaleKeepTheirOwnValues()
{
    Capture capture;
    capture.begin(layout(1, {signal(1, 0.5), signal(2, -0.1), signal(3, 0.5)}));
    capture.append(blockOfCodes(1, 0, 2, {1, 2, 1, 2, -1, 2}));
    QCOMPARE(textOf(allOf(capture)),
        std::string("time [s],R1 [A],R2 [A],R3 [A]\n0,0.5,-0.1,-0.5\n0.0000625,1,-0.2,1\n"));
}

void TestCsvExport::timesAreExactToTheTick()
{
    QCOMPARE(csvTime(0), std::string("0"));
    QCOMPARE(csvTime(62500), std::string("0.0000625"));
    QCOMPARE(csvTime(1'000'000'000), std::string("1"));
    QCOMPARE(csvTime(-1'500'000'000), std::string("-1.5"));
    QCOMPARE(csvTime(86'400'000'000'000'001), std::string("86400000.000000001"));
    Capture capture;
    StreamLayout odd = layout(1, {signal(1)});
    odd.tickHz = 30000; // no whole number of nanoseconds
    odd.originSeconds = 3600.0;
    capture.begin(odd);
    std::vector<std::int16_t> codes(90'000, 1);
    capture.append(blockOfCodes(1, 0, 90'000, codes));
    const QList<QByteArray> lines = linesOf(textOf(allOf(capture)));
    QCOMPARE(lines[2].split(',')[0], QByteArray("3600.000033333"));
    for (int i = 0; i < 90'000; i += 7) {
        const auto time = parsed<double>(lines[i + 1].split(',')[0]);
        QCOMPARE(std::lround((time - 3600.0) * 30000.0), long(i));
    }
}

void TestCsvExport::lostRowsAreAbsent()
{
    Capture capture;
    capture.begin(layout(1, {signal(1)}));
    capture.append(blockOfCodes(1, 0, 2, {2, 4}));
    SampleBlock later = blockOfCodes(1, 16000, 2, {6, 8});
    later.lostTicks = 15998;
    capture.append(later);
    QCOMPARE(textOf(allOf(capture)),
        std::string("time [s],R1 [A]\n0,1\n0.0000625,2\n1,3\n1.0000625,4\n"));
}

void TestCsvExport::slowValuesAreHeldAndBlankWhereUnknown()
{
    Capture capture;
    capture.begin(layout(1, {signal(1, 1)}, {signal(9, 0.1)}));
    SampleBlock first = blockOfCodes(1, 0, 3, {1, 2, 3});
    first.slow.push_back({1, {100001}});
    capture.append(first);
    SampleBlock later = blockOfCodes(1, 1600, 3, {4, 5, 6});
    later.lostTicks = 1597;
    later.slow.push_back({1602, {-7}});
    capture.append(later);
    QCOMPARE(textOf(allOf(capture)),
        std::string("time [s],R1 [A],R9 [A]\n"
                    "0,1,\n"
                    "0.0000625,2,10000.1\n"
                    "0.000125,3,10000.1\n"
                    "0.1,4,\n"
                    "0.1000625,5,\n"
                    "0.100125,6,-0.7000000000000001\n"));
}

void TestCsvExport::channelsOfDifferentTimesShareTheFileWithBlanks()
{
    Capture capture;
    capture.begin(layout(1, {signal(1, 1)}));
    capture.append(blockOfCodes(1, 0, 2, {1, 2}));
    capture.begin(layout(2, {signal(2, 1), signal(1, 1)}));
    capture.append(blockOfCodes(2, 16, 2, {10, 20, 3, 4}));
    capture.begin(layout(3, {signal(2, 1)}));
    capture.append(blockOfCodes(3, 32, 1, {30}));
    QCOMPARE(textOf(allOf(capture)),
        std::string("time [s],R1 [A],R2 [A]\n0,1,\n0.0000625,2,\n0.001,3,10\n0.0010625,4,20\n"
                    "0.002,,30\n"));
}

void TestCsvExport::aRangeHoldsExactlyItsRows()
{
    Capture capture;
    capture.begin(layout(1, {signal(1)}));
    capture.append(blockOfCodes(1, 0, 40000, std::vector<std::int16_t>(40000, 1)));
    CsvOptions options;
    options.range = TimeSpan{1.0, 2.0};
    const QList<QByteArray> lines = linesOf(textOf(allOf(capture), options));
    QCOMPARE(lines.size(), 16001);
    QCOMPARE(lines[1], QByteArray("1,0.5"));
    QCOMPARE(lines.last(), QByteArray("1.9999375,0.5"));
}

void TestCsvExport::aHeldValueFromBeforeTheRangeIsShown()
{
    Capture capture;
    capture.begin(layout(1, {signal(1, 1)}));
    capture.append(blockOfCodes(1, 0, 16000, std::vector<std::int16_t>(16000, 1)));
    capture.appendPolled(5, "P", "rpm", 0.1, 1500.5);
    CsvOptions options;
    options.range = TimeSpan{0.5, 0.50005};
    QCOMPARE(
        textOf(allOf(capture), options), std::string("time [s],R1 [A],P [rpm]\n0.5,1,1500.5\n"));
}

void TestCsvExport::perRateGivesEverySampleOnce()
{
    Capture capture;
    capture.begin(layout(1, {signal(1, 1), signal(2, 1)}, {signal(9, 1)}));
    SampleBlock first = blockOfCodes(1, 0, 2, {1, 2, 3, 4});
    first.slow.push_back({0, {9}});
    capture.append(first);
    capture.appendPolled(5, "P", "rpm", 0.25, 1500.5);
    capture.appendPolled(6, "Q", "", 0.5, 1e30);
    const auto files = splitByRate(allOf(capture));
    QCOMPARE(files.size(), std::size_t(4));
    QCOMPARE(linesOf(textOf(files[0])).size(), 3);
    QCOMPARE(textOf(files[1]), std::string("time [s],R9 [A]\n0,9\n"));
    QCOMPARE(textOf(files[2]), std::string("time [s],P [rpm]\n0.25,1500.5\n"));
    QCOMPARE(textOf(files[3]), std::string("time [s],Q\n0.5,1e+30\n"));
}

void TestCsvExport::columnsComeInTheOrderAsked()
{
    Capture capture;
    capture.begin(layout(1, {signal(1, 1), signal(2, 1)}, {signal(9, 1)}));
    SampleBlock first = blockOfCodes(1, 0, 1, {1, 2});
    first.slow.push_back({0, {9}});
    capture.append(first);
    const std::vector<ChannelId> order{*capture.find(9), *capture.find(2), *capture.find(1)};
    QCOMPARE(
        textOf(capture.snapshot(order)), std::string("time [s],R9 [A],R2 [A],R1 [A]\n0,9,2,1\n"));
}

void TestCsvExport::namesThatASpreadsheetWouldRunAreMadeHarmless()
{
    const auto heading = [](const char *name, const char *unit) {
        return csvHeading({0, 0, name, unit, 1.0, 0.0, ChannelInfo::Kind::Fast});
    };
    QCOMPARE(heading("I_Q", "A"), std::string("I_Q [A]"));
    QCOMPARE(heading("=1+1", ""), std::string("'=1+1"));
    QCOMPARE(heading("@x", "V"), std::string("'@x [V]"));
    QCOMPARE(heading("-a", ""), std::string("'-a"));
    QCOMPARE(heading("\tb", ""), std::string("\"'\tb\""));
    QCOMPARE(heading("a;b", ""), std::string("\"a;b\""));
    QCOMPARE(heading("a,b", "A"), std::string("\"a,b [A]\""));
    QCOMPARE(heading("a\"b", ""), std::string("\"a\"\"b\""));
    QCOMPARE(heading("\xC3\xA9", "\xC2\xB0"), std::string("\xC3\xA9 [\xC2\xB0]"));
}

void TestCsvExport::anEmptyCaptureIsAHeading()
{
    Capture capture;
    capture.begin(layout(1, {signal(1)}));
    QCOMPARE(textOf(allOf(capture)), std::string("time [s],R1 [A]\n"));
}

void TestCsvExport::progressEndsAtOne()
{
    Capture capture;
    capture.begin(layout(1, {signal(1), signal(2)}));
    for (Tick tick = 0; tick < 300'000; tick += 1000)
        capture.append(blockOfCodes(1, tick, 1000, std::vector<std::int16_t>(2000, 12345)));
    CsvWriter writer(allOf(capture));
    std::string_view piece;
    double last = -1;
    int pieces = 0;
    bool whole = true; // but for the last piece
    while (writer.next(piece)) {
        QVERIFY(whole);
        QVERIFY(writer.progress() >= last);
        last = writer.progress();
        whole = piece.size() == std::size_t(1) << 20;
        QVERIFY(piece.size() <= std::size_t(1) << 20);
        ++pieces;
    }
    QCOMPARE(last, 1.0);
    QVERIFY(!writer.next(piece) && piece.empty());
    QCOMPARE(writer.rows(), std::uint64_t(300'000));
    QVERIFY(pieces > 3);
}

QTEST_APPLESS_MAIN(TestCsvExport)
#include "tst_csv_export.moc"
