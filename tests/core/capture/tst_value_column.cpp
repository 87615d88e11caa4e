// The column of values: whatever form its full chunks take, it answers as the plain list of them would.
#include "capture/value_column.h"

#include <QtTest>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>

using namespace capture;

namespace {

constexpr std::size_t kChunk = ValueColumn::kChunkSamples;

/// A column and the plain list of what was appended.
struct Twin {
    ValueColumn column;
    std::vector<Nanos> times;
    std::vector<double> values;

    void append(Nanos step, double value)
    {
        const Nanos time = times.empty() ? step : times.back() + step;
        times.push_back(time);
        values.push_back(value);
        column.append(time, value, time + step);
    }
    void verifyAll() const { verify(column, values.size()); }
    /// @param of  a copy that was made when there were so many
    void verify(const ValueColumn &of, std::size_t count) const
    {
        QCOMPARE(of.end(), Index(count));
        for (Index i = of.begin(); i < count; ++i) {
            QCOMPARE(of.timeOf(i), times[i]);
            QCOMPARE(
                std::bit_cast<std::uint64_t>(of.at(i)), std::bit_cast<std::uint64_t>(values[i]));
        }
    }
    ValueRange plainExtremes(Index from, Index to) const
    {
        ValueRange range;
        for (Index i = std::max(from, column.begin()); i < to; ++i)
            range.include({values[i], values[i]});
        return range;
    }
};

struct Form {
    const char *name;
    bool equalSteps;
    std::uint32_t differentValues; ///< 0: hardly two are equal
    double mostBytes; ///< a sample
};
constexpr std::array kForms{Form{"like a recorded signal that came by a file", true, 60'000, 3.3},
    Form{"a flag", true, 2, 2.3}, Form{"computed", true, 0, 9.0}, Form{"polled", false, 1000, 10.5},
    Form{"polled and computed", false, 0, 17.0}};

Twin twinOf(const Form &form, std::size_t count, std::uint32_t seed)
{
    std::mt19937 random(seed);
    Twin twin;
    constexpr double kFactor = 3.3 / 65536.0 / 0.33 / 1.53;
    for (std::size_t i = 0; i < count; ++i) {
        const auto raw = static_cast<std::uint32_t>(random());
        const auto middle = form.differentValues / 2;
        const double value = form.differentValues != 0
            ? (double(raw % form.differentValues) - double(middle)) * kFactor
            : double(raw) * 1e-7 + double(i);
        twin.append(form.equalSteps ? 50'000 : 40'000 + raw % 20'000, value);
    }
    return twin;
}

} // namespace

class TestValueColumn : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyValueIsWhatWasAppended_data() { forms(); }
    void everyValueIsWhatWasAppended();
    void extremesAreExact_data() { forms(); }
    void extremesAreExact();
    void timesAreFoundWhereTheyAre_data() { forms(); }
    void timesAreFoundWhereTheyAre();
    void everyValueIsInOneSlice_data() { forms(); }
    void everyValueIsInOneSlice();
    void equalStepsAndRepeatedValuesTakeLittleMemory_data() { forms(); }
    void equalStepsAndRepeatedValuesTakeLittleMemory();
    void aCopyKeepsWhatItHadInTheMiddleOfAChunk_data() { forms(); }
    void aCopyKeepsWhatItHadInTheMiddleOfAChunk();
    void chunksComeBackFromAnArchiveInTheirForm_data() { forms(); }
    void chunksComeBackFromAnArchiveInTheirForm();
    void moreValuesThanCodesAreKeptAsTheyAre();
    void zerosKeepTheirSigns();

private:
    static void forms()
    {
        QTest::addColumn<int>("form");
        for (std::size_t i = 0; i < kForms.size(); ++i)
            QTest::newRow(kForms[i].name) << int(i);
    }
};

#define FORM                                                                                       \
    QFETCH(int, form);                                                                             \
    const Form &is = kForms[std::size_t(form)]

void TestValueColumn::everyValueIsWhatWasAppended()
{
    FORM;
    for (const std::size_t count :
        {std::size_t(1), kChunk - 1, kChunk, kChunk + 1, 5 * kChunk + 77})
        twinOf(is, count, 1).verifyAll();
}

void TestValueColumn::extremesAreExact()
{
    FORM;
    const Twin twin = twinOf(is, 3 * kChunk + 500, 2);
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        Index from = random() % twin.values.size();
        Index to = random() % (twin.values.size() + 1);
        if (i % 3 == 0)
            to = std::min<Index>(from + random() % 300, twin.values.size());
        if (i % 50 == 0)
            from = from / kChunk * kChunk;
        const ValueRange found = twin.column.extremes(from, to);
        const ValueRange wanted = twin.plainExtremes(from, to);
        QCOMPARE(found.min, wanted.min);
        QCOMPARE(found.max, wanted.max);
    }
}

void TestValueColumn::timesAreFoundWhereTheyAre()
{
    FORM;
    const Twin twin = twinOf(is, 2 * kChunk + 500, 3);
    std::mt19937 random(8);
    for (int i = 0; i < 5000; ++i) {
        const Nanos time = twin.times[random() % twin.times.size()] + Nanos(random() % 3) - 1;
        const auto wanted = std::lower_bound(twin.times.begin(), twin.times.end(), time);
        QCOMPARE(twin.column.atOrAfter(time), Index(wanted - twin.times.begin()));
    }
    QCOMPARE(twin.column.atOrAfter(twin.times.back() + 1), twin.column.end());
    QCOMPARE(twin.column.atOrAfter(-5), Index(0));
}

void TestValueColumn::everyValueIsInOneSlice()
{
    FORM;
    const Twin twin = twinOf(is, 4 * kChunk + 99, 4);
    const double from = toSeconds(twin.times.front());
    const double to = toSeconds(twin.times.back() + 1);
    for (const std::size_t slices : {1U, 3U, 7U, 640U, 4000U}) {
        ValueRange all;
        double before = -1.0;
        twin.column.slices(
            capture::Slices::of(from, to, slices), [&](std::size_t slice, ValueRange range) {
                QVERIFY(double(slice) > before);
                before = double(slice);
                all.include(range);
            });
        const ValueRange wanted = twin.plainExtremes(0, twin.values.size());
        QCOMPARE(all.min, wanted.min);
        QCOMPARE(all.max, wanted.max);
    }
    // One peak of one value is in the slice where it is, or where its block was rounded to.
    Twin peak;
    constexpr std::size_t kPlace = 12'345;
    for (std::size_t i = 0; i < 40'000; ++i)
        peak.append(50'000, i == kPlace ? 9.0 : 1.0);
    int found = 0;
    const double end = 40'000 * 50e-6;
    peak.column.slices(capture::Slices::of(0.0, end, 16), [&](std::size_t slice, ValueRange range) {
        if (range.max == 9.0) {
            ++found;
            QCOMPARE(slice, kPlace * 16 / 40'000);
        }
    });
    QCOMPARE(found, 1);
}

void TestValueColumn::equalStepsAndRepeatedValuesTakeLittleMemory()
{
    FORM;
    constexpr std::size_t kCount = 1'000'000;
    const Twin twin = twinOf(is, kCount, 5);
    const double each = double(twin.column.bytes()) / double(kCount);
    QVERIFY2(each < is.mostBytes, qPrintable(QString::number(each)));
}

void TestValueColumn::aCopyKeepsWhatItHadInTheMiddleOfAChunk()
{
    FORM;
    Twin twin = twinOf(is, kChunk + 1000, 6);
    const ValueColumn copy = twin.column;
    const ValueRange before = copy.extremes(0, copy.end());
    const Twin more = twinOf(is, 4 * kChunk, 9);
    for (const double value : more.values)
        twin.append(is.equalSteps ? 50'000 : 45'000, value + 1000.0);
    twin.verify(copy, kChunk + 1000);
    QCOMPARE(copy.extremes(0, copy.end()).max, before.max);
    twin.verifyAll();
}

void TestValueColumn::chunksComeBackFromAnArchiveInTheirForm()
{
    FORM;
    Twin twin = twinOf(is, 6 * kChunk + 10, 10);
    const std::size_t whole = twin.column.bytes();
    std::uint64_t handed = 0;
    const std::uint64_t all = twin.column.archivableBytes();
    while (twin.column.archivableBytes() > 0) {
        const Index first = twin.column.toArchive();
        const std::size_t bytes = twin.column.chunkBytes();
        std::vector<Stretch> stretches;
        twin.column.handOver(stretches);
        QCOMPARE(stretches.size(), std::size_t(1));
        QCOMPARE(stretches[0].size, bytes);
        const std::shared_ptr<std::byte[]> disk(new std::byte[bytes]);
        std::memcpy(disk.get(), stretches[0].data.get(), bytes);
        stretches[0].data = {disk, disk.get()};
        twin.column.place(first, stretches);
        handed += bytes;
    }
    QCOMPARE(handed, all);
    QCOMPARE(twin.column.archivedBytes(), all);
    QCOMPARE(twin.column.bytes(), whole - std::size_t(all));
    twin.verifyAll();
    while (twin.column.canRelease())
        twin.column.releaseOldest();
    QCOMPARE(twin.column.archivedBytes(), std::uint64_t(0));
    twin.verifyAll();
}

void TestValueColumn::moreValuesThanCodesAreKeptAsTheyAre()
{
    Twin twin;
    constexpr int kMore = 100'000; // a code has 65,536
    for (int i = 0; i < kMore; ++i)
        twin.append(1000, double(i) / 3.0);
    for (int i = 0; i < kMore; ++i) // known ones have their codes
        twin.append(1000, double(i % 50'000) / 3.0);
    twin.verifyAll();
}

void TestValueColumn::zerosKeepTheirSigns()
{
    Twin twin;
    for (std::size_t i = 0; i < 2 * kChunk; ++i)
        twin.append(1000, i % 2 == 0 ? 0.0 : -0.0);
    twin.verifyAll();
}

QTEST_APPLESS_MAIN(TestValueColumn)
#include "tst_value_column.moc"
