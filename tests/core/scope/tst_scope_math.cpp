// Math channels: values at the right instants, gaps where something is unknown, and the same result however the samples
// arrive.
#include "scope/math_channel.h"
#include "scope/measurer.h"
#include "support/channels/analytic_channel.h"
#include "support/channels/noisy_channel.h"

#include <QtTest>

#include <numbers>

using namespace scope;
using support::fastChannel;
using support::kRate;
using support::kSecond;

class TestScopeMath : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aMathChannelIsAChannelLikeAnyOther();
    void gapsStayGaps();
    void theOtherInputsHoldTheirSampleBefore();
    void theCloserValuesAreTheClock();
    void whatIsNotFiniteIsAGap();
    void nothingIsComputedBeforeItIsSettled();
    void resultsDoNotDependOnHowSamplesArrive_data();
    void resultsDoNotDependOnHowSamplesArrive();
    void signalsOfOneStreamAreComputedAsAnyOthers_data();
    void signalsOfOneStreamAreComputedAsAnyOthers();
    void workCanBeSharedOut();
};

namespace {

using Inputs = std::vector<const capture::Channel *>;

constexpr Nanos kEver = std::numeric_limits<Nanos>::max();

/// A math channel, and the channel that keeps all it computed.
struct KeptMath {
    MathChannel math;
    capture::Channel kept{
        {9, 0, "math", math.formula().unit(), 1.0, 0.0, capture::ChannelInfo::Kind::Slow}};

    const capture::Channel &channel() const { return kept; }
    bool update(const Inputs &inputs, Nanos until,
        std::size_t most = std::numeric_limits<std::size_t>::max())
    {
        const bool rest = math.update(inputs, until, most);
        std::span<const Nanos> times(math.results().times);
        std::span<const double> values(math.results().values);
        for (const MathResults::Piece &piece : math.results().pieces) {
            if (piece.begins)
                kept.values()->breakHere();
            kept.values()->append(
                times.first(piece.count), values.first(piece.count), piece.holdUntil);
            times = times.subspan(piece.count);
            values = values.subspan(piece.count);
        }
        return rest;
    }
};

KeptMath math(std::string_view text)
{
    const std::vector<FormulaName> names{{"X", "A"}, {"Y", "V"}};
    return {MathChannel(*Formula::compile(text, names))};
}
std::vector<double> values(const capture::Channel &channel)
{
    std::vector<double> result;
    for (Index i = channel.begin(); i < channel.end(); ++i)
        result.push_back(channel.at(i));
    return result;
}

} // namespace

void TestScopeMath::aMathChannelIsAChannelLikeAnyOther()
{
    const double turn = 2 * std::numbers::pi;
    const auto current = fastChannel(16000, [=](double t) { return 5 * std::sin(turn * 50 * t); });
    const auto voltage =
        fastChannel(16000, [=](double t) { return 20 * std::sin(turn * 50 * t + 1.0); });
    KeptMath power = math("X * Y");
    QVERIFY(!power.update(Inputs{&current, &voltage}, kEver));
    QCOMPARE(power.channel().size(), 16000U);
    QCOMPARE(power.channel().info().unit, std::string("W"));
    QCOMPARE(power.channel().info().name, std::string("math"));
    Measurer measurer(power.channel(), 0, kSecond);
    QVERIFY(std::abs(*measurer.measure(Quantity::Mean).value - 50 * std::cos(1.0)) < 0.02);
    QVERIFY(std::abs(*measurer.measure(Quantity::Frequency).value - 100.0) < 0.1);
    QCOMPARE(power.channel().timeOf(5), current.timeOf(5));
    QVERIFY(power.channel().valueAt(Nanos(6 * 62500 - 1)) == power.channel().at(5));
}

void TestScopeMath::gapsStayGaps()
{
    auto channel = fastChannel(100, [](double) { return 1.0; });
    const std::vector<std::int16_t> more(50, 2000);
    channel.fast()->append(capture::TickBase::of(kRate, 0), 300, 1, more);
    KeptMath slope = math("derivative(X)");
    slope.update(Inputs{&channel}, kEver);
    // No slope across the gap, and none at the first sample of a piece.
    QCOMPARE(values(slope.channel()), std::vector<double>(99 + 49, 0.0));
    QCOMPARE(slope.channel().values()->runs().size(), 2U);
    QVERIFY(!slope.channel().valueAt(channel.timeOf(100) - 1'000'000));
    KeptMath twice = math("2 * X");
    twice.update(Inputs{&channel}, kEver);
    QCOMPARE(twice.channel().size(), 150U);
    QCOMPARE(twice.channel().gaps(0.0, 1.0, 0.0).size(), 1U);
    QCOMPARE(twice.channel().gaps(0.0, 1.0, 0.0)[0].from, 100 / kRate);
}

void TestScopeMath::theOtherInputsHoldTheirSampleBefore()
{
    const auto fast = fastChannel(
        10, [](double) { return 0.0; }, 0.0, 1, 1000.0);
    capture::Channel slow({2, 8, "Y", "V", 1.0, 0.0, capture::ChannelInfo::Kind::Slow});
    slow.values()->append(2'000'000, 5.0, 4'500'000);
    slow.values()->append(4'500'000, 7.0, 8'000'000);
    KeptMath sum = math("X + Y");
    sum.update(Inputs{&fast, &slow}, kEver);
    QCOMPARE(values(sum.channel()), (std::vector<double>{5, 5, 5, 7, 7, 7}));
    QCOMPARE(sum.channel().timeOf(sum.channel().begin()), Nanos(2'000'000));
    // The fastest kind is the clock, wherever it stands.
    KeptMath other = math("Y + X");
    other.update(Inputs{&fast, &slow}, kEver);
    QCOMPARE(other.channel().size(), 6U);
}

/// As of a math channel of fast signals beside a signal that the board records slowly.
void TestScopeMath::theCloserValuesAreTheClock()
{
    const auto sparse = support::slowChannel(
        100, [](double) { return 1.0; }, 1000.0);
    auto dense = support::slowChannel(
        1, [](double) { return 2.0; }, 16000.0);
    const auto tick = [](capture::Tick number) {
        return capture::TickBase::of(16000.0, 0.0).timeOf(number);
    };
    dense.values()->breakHere();
    for (capture::Tick i = 800; i < 1600; ++i)
        dense.values()->append(tick(i), 2.0, tick(i + 1));
    for (const char *text : {"X * Y", "Y * X"}) {
        KeptMath product = math(text);
        const bool first = product.math.formula().used().front() == 0;
        const Inputs inputs = first ? Inputs{&sparse, &dense} : Inputs{&dense, &sparse};
        const auto nothing = support::slowChannel(
            0, [](double) { return 2.0; }, 16000.0);
        product.update(first ? Inputs{&sparse, &nothing} : Inputs{&nothing, &sparse}, tick(900));
        product.update(inputs, tick(900));
        QCOMPARE(product.channel().size(), 101U);
        product.update(inputs, kEver);
        QCOMPARE(product.channel().size(), 801U);
    }
    const auto same = support::slowChannel(
        50, [](double) { return 3.0; }, 1000.0);
    KeptMath sum = math("X + Y");
    sum.update(Inputs{&same, &sparse}, kEver);
    QCOMPARE(sum.channel().size(), 50U);
}

void TestScopeMath::whatIsNotFiniteIsAGap()
{
    // Passes 0.
    const auto channel = fastChannel(9, [](double t) { return std::round(t * kRate) - 4.0; });
    KeptMath inverse = math("1 / X");
    inverse.update(Inputs{&channel}, kEver);
    QCOMPARE(inverse.channel().size(), 8U);
    QCOMPARE(inverse.channel().values()->runs().size(), 2U);
}

void TestScopeMath::nothingIsComputedBeforeItIsSettled()
{
    capture::Capture store;
    store.appendPolled(8, "Y", "V", 0.0, 1.0);
    const auto fast = fastChannel(16000, [](double) { return 0.0; });
    KeptMath sum = math("X + Y");
    const auto inputs = [&] { return Inputs{&fast, store.channel(*store.find(8))}; };
    QCOMPARE(settledUntil(inputs()), std::optional<Nanos>(1));
    sum.update(inputs(), *settledUntil(inputs()));
    QCOMPARE(sum.channel().size(), 1U);
    store.appendPolled(8, "Y", "V", 0.5, 3.0);
    sum.update(inputs(), *settledUntil(inputs()));
    QCOMPARE(sum.channel().size(), 8001U);
    QCOMPARE(sum.channel().at(7999), 1.0);
    QCOMPARE(sum.channel().at(8000), 3.0);
    const capture::Channel empty({3, 7, "", "", 1.0, 0.0, capture::ChannelInfo::Kind::Fast});
    QVERIFY(!settledUntil(Inputs{&fast, &empty}));
}

void TestScopeMath::resultsDoNotDependOnHowSamplesArrive_data()
{
    QTest::addColumn<QByteArray>("text");
    for (const char *text :
        {"X * 2 + Y", "derivative(X)", "lowpass(X, 200) - Y", "median(X, 5) + average(Y, 7)",
            "integral(X - Y)", "X > 0 ? X : Y", "sqrt(X) + highpass(derivative(Y), 50)"})
        QTest::newRow(text) << QByteArray(text);
}

void TestScopeMath::resultsDoNotDependOnHowSamplesArrive()
{
    QFETCH(const QByteArray, text);
    std::size_t gaps = 0;
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        using support::NoisyChannel;
        const auto run = [&](std::size_t most, bool often) {
            NoisyChannel x(seed, NoisyChannel::Kind::Fast, NoisyChannel::Shape::Wave, 6000);
            NoisyChannel y(seed + 50,
                seed % 2 == 0 ? NoisyChannel::Kind::Polled : NoisyChannel::Kind::Fast,
                NoisyChannel::Shape::Wave, seed % 2 == 0 ? 60 : 6000);
            KeptMath result = math(text.toStdString());
            std::mt19937 random(seed);
            const auto update = [&](bool end) {
                if (!x.channel() || !y.channel())
                    return;
                Inputs inputs;
                for (const std::size_t used : result.math.formula().used())
                    inputs.push_back(used == 0 ? x.channel() : y.channel());
                if (const auto until = settledUntil(inputs))
                    result.update(inputs, end ? kEver : *until);
            };
            while (!x.done() || !y.done()) {
                if (!x.done() && (y.done() || random() % 2 == 0))
                    x.record(1 + random() % most);
                else
                    y.record(1 + random() % most);
                if (often)
                    update(false);
            }
            update(true);
            return result;
        };
        const KeptMath atOnce = run(500, false);
        const KeptMath often = run(40, true);
        QVERIFY(atOnce.channel().size() > 100);
        QVERIFY(values(atOnce.channel()) == values(often.channel()));
        const auto &runs = atOnce.channel().values()->runs();
        QCOMPARE(runs.size(), often.channel().values()->runs().size());
        for (std::size_t i = 0; i < runs.size(); ++i) {
            QCOMPARE(runs[i].first, often.channel().values()->runs()[i].first);
            QCOMPARE(runs[i].holdUntil, often.channel().values()->runs()[i].holdUntil);
        }
        gaps += runs.size();
    }
    QVERIFY(gaps > 12);
}

void TestScopeMath::signalsOfOneStreamAreComputedAsAnyOthers_data()
{
    resultsDoNotDependOnHowSamplesArrive_data();
}

/// They are read side by side. A nanosecond earlier one of them is of no stream with the other, and holds the same.
void TestScopeMath::signalsOfOneStreamAreComputedAsAnyOthers()
{
    QFETCH(const QByteArray, text);
    const auto channelOf = [](std::uint32_t seed, Nanos earlier) {
        capture::Channel channel({seed, seed, "", "", 0.01, 3.0, {}});
        capture::TickBase base = capture::TickBase::of(kRate, 2.0);
        base.origin -= earlier;
        std::mt19937 values(seed), lengths(5);
        capture::Tick tick = 7;
        for (int piece = 0; piece < 40; ++piece) {
            std::vector<std::int16_t> codes(1 + lengths() % 9000);
            for (std::int16_t &code : codes)
                code = static_cast<std::int16_t>(int(values() % 4001) - 2000);
            channel.fast()->append(base, tick, 1, codes);
            tick += static_cast<capture::Tick>(codes.size() + lengths() % 3); // some follow
        }
        return channel;
    };
    const capture::Channel x = channelOf(1, 0), y = channelOf(2, 0), earlier = channelOf(2, 1);
    KeptMath together = math(text.toStdString()), apart = math(text.toStdString());
    const auto inputs = [&](const capture::Channel &second) {
        Inputs all;
        for (const std::size_t used : together.math.formula().used())
            all.push_back(used == 0 ? &x : &second);
        return all;
    };
    std::mt19937 random(3);
    while (together.update(inputs(y), kEver, 1 + random() % 5000)) { }
    apart.update(inputs(earlier), kEver);
    QVERIFY(together.channel().size() > 100'000 / 4);
    QVERIFY(values(together.channel()) == values(apart.channel()));
    const auto &runs = together.channel().values()->runs();
    QCOMPARE(runs.size(), apart.channel().values()->runs().size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        QCOMPARE(runs[i].first, apart.channel().values()->runs()[i].first);
        QCOMPARE(runs[i].holdUntil, apart.channel().values()->runs()[i].holdUntil);
    }
}

void TestScopeMath::workCanBeSharedOut()
{
    const auto channel = fastChannel(1000, [](double t) { return t; });
    KeptMath sum = math("integral(X)");
    int calls = 1;
    while (sum.update(Inputs{&channel}, kEver, 64))
        ++calls;
    QCOMPARE(calls, 16);
    KeptMath whole = math("integral(X)");
    QVERIFY(!whole.update(Inputs{&channel}, kEver));
    QCOMPARE(values(sum.channel()), values(whole.channel()));
}

QTEST_APPLESS_MAIN(TestScopeMath)
#include "tst_scope_math.moc"
