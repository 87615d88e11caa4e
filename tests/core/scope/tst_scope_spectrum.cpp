// Spectra of known tones: their frequency and amplitude through every window, and the sum of all bins.
#include "capture/capture.h"
#include "scope/spectrum.h"
#include "support/channels/analytic_channel.h"
#include "support/near.h"

#include <QtTest>

#include <complex>

using support::near;
using namespace scope;
using support::fastChannel;
using support::kRate;
using support::kSecond;
using support::kTurn;

class TestScopeSpectrum : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void windowsReadTheirTextbookFigures();
    void tonesHaveTheirFrequencyAndAmplitude_data();
    void tonesHaveTheirFrequencyAndAmplitude();
    void theSumOfAllBinsIsTheMeanSquare();
    void bandsHaveTheRmsOfTheirTones();
    void peaksAreTonesAndNotTheirSkirts();
    void theLargestOfManyMaximaAreFoundWithoutACloseLookAtAll();
    void averagingCalmsTheNoise();
    void theLongestPieceIsUsed();
    void unevenSamplesHaveNoSpectrum();
    void valuesAtEqualDistancesHaveOne();
    void ordersAreMultiplesOfTheElectricalFrequency();
};

namespace {

/// Of everything from one frequency to another, both included.
double rmsOf(const Spectrum &spectrum, double fromHz, double toHz)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < spectrum.meanSquares.size(); ++k) {
        const double hertz = spectrum.frequency(static_cast<double>(k));
        if (hertz >= fromHz && hertz <= toHz)
            sum += spectrum.meanSquares[k];
    }
    return std::sqrt(sum);
}

constexpr std::array kWindows{
    Window::Rectangular, Window::Hann, Window::BlackmanHarris, Window::FlatTop};

Spectrum spectrum(const capture::Channel &channel, SpectrumSettings settings)
{
    return *spectrumOf(SampleRange(channel, 0, 1000 * kSecond), settings);
}

} // namespace

void TestScopeSpectrum::windowsReadTheirTextbookFigures()
{
    const std::array<double, 4> bandwidths{1.0, 1.5, 2.0044, 3.7702}; // bins
    const std::array<double, 4> losses{3.92, 1.42, 0.83, 0.01}; // dB, half a bin away
    for (std::size_t i = 0; i < kWindows.size(); ++i) {
        QVERIFY(near(noiseBandwidth(kWindows[i]), bandwidths[i], 1e-4));
        QVERIFY(near(-20 * std::log10(windowResponse(kWindows[i], 0.5)), losses[i], 0.01));
        // The response in words of sums: what a tone between bins reads in a transform of the window itself.
        const auto values = windowValues(kWindows[i], 4096);
        for (const double offset : {0.0, 0.3, 1.0, 2.6}) {
            std::complex<double> sum = 0.0;
            double all = 0.0;
            for (std::size_t n = 0; n < values.size(); ++n) {
                sum += values[n] * std::polar(1.0, kTurn * offset * double(n) / 4096.0);
                all += values[n];
            }
            QVERIFY(near(std::abs(sum) / all, std::abs(windowResponse(kWindows[i], offset)), 1e-5));
        }
    }
}

void TestScopeSpectrum::tonesHaveTheirFrequencyAndAmplitude_data()
{
    QTest::addColumn<int>("window");
    QTest::addColumn<double>("bin");
    QTest::addColumn<double>("binError");
    QTest::addColumn<double>("amplitudeError"); // relative
    const std::array<double, 4> bins{0.02, 0.01, 0.001, 0.001};
    const std::array<double, 4> amplitudes{0.02, 0.003, 0.001, 0.001};
    const std::array<const char *, 4> names{"rectangular", "Hann", "Blackman-Harris", "flat top"};
    for (std::size_t i = 0; i < kWindows.size(); ++i) {
        for (const double bin : {10.0, 37.25, 100.5, 555.9, 1990.0})
            QTest::addRow("%s, bin %g", names[i], bin)
                << int(kWindows[i]) << bin << bins[i] << amplitudes[i];
    }
}

void TestScopeSpectrum::tonesHaveTheirFrequencyAndAmplitude()
{
    QFETCH(const int, window);
    QFETCH(const double, bin);
    QFETCH(const double, binError);
    QFETCH(const double, amplitudeError);
    constexpr std::size_t kSize = 4096;
    const double hertz = bin * kRate / double(kSize);
    for (const double phase : {0.0, 0.7, 2.0, 4.4}) {
        const auto channel = fastChannel(
            kSize, [=](double t) { return 3.0 + 20.0 * std::sin(kTurn * hertz * t + phase); });
        const Spectrum found = spectrum(channel, {Window(window), 0, true});
        QCOMPARE(found.size, kSize);
        QVERIFY(near(found.mean, 3.0, 2.0));
        const auto peaks = findPeaks(found, 1);
        QCOMPARE(peaks.size(), 1U);
        QVERIFY(near(peaks[0].hertz / found.binHz, bin, binError));
        QVERIFY(near(peaks[0].amplitude / 20.0, 1.0, amplitudeError));
        if (bin == std::floor(bin)) // and without interpolation
            QVERIFY(near(found.amplitude(std::size_t(bin)), 20.0, 0.02));
    }
}

void TestScopeSpectrum::theSumOfAllBinsIsTheMeanSquare()
{
    for (const Window window : kWindows) {
        for (const std::size_t count : {16U, 100U, 1000U, 4096U, 6075U}) {
            const auto channel = fastChannel(
                count, [](double t) { return 2.0 + t; }, 3.0, 5);
            const Spectrum found = spectrum(channel, {window, 0, false});
            const auto values = windowValues(window, found.size);
            double weighted = 0.0;
            double weights = 0.0;
            for (std::size_t i = 0; i < found.size; ++i) {
                weighted += std::pow(values[i] * channel.at(i), 2);
                weights += values[i] * values[i];
            }
            double sum = 0.0;
            for (const double square : found.meanSquares)
                sum += square;
            QVERIFY(near(sum / (weighted / weights), 1.0, 1e-12));
        }
    }
}

void TestScopeSpectrum::bandsHaveTheRmsOfTheirTones()
{
    const auto channel = fastChannel(16000, [](double t) {
        return 5.0 * std::sin(kTurn * 400.3 * t) + 2.0 * std::sin(kTurn * 3000.8 * t + 1.0);
    });
    for (const Window window : {Window::Hann, Window::BlackmanHarris, Window::FlatTop}) {
        const Spectrum found = spectrum(channel, {window, 4096, true});
        QVERIFY(found.averaged > 5);
        QVERIFY(near(rmsOf(found, 300, 500), 5.0 / std::sqrt(2.0), 0.01));
        QVERIFY(near(rmsOf(found, 2900, 3100), 2.0 / std::sqrt(2.0), 0.01));
        QVERIFY(near(rmsOf(found, 1000, 2000), 0.0, 0.01));
    }
}

void TestScopeSpectrum::peaksAreTonesAndNotTheirSkirts()
{
    const auto channel = fastChannel(8192, [](double t) {
        return 20.0 * std::sin(kTurn * 301.7 * t) + 0.5 * std::sin(kTurn * 905.1 * t)
            + 0.1 * std::sin(kTurn * 1508.5 * t);
    });
    for (const Window window : {Window::Hann, Window::BlackmanHarris, Window::FlatTop}) {
        const auto peaks = findPeaks(spectrum(channel, {window, 0, true}), 10, 0.02);
        QCOMPARE(peaks.size(), 3U);
        QVERIFY(near(peaks[1].hertz, 905.1, 0.1));
        QVERIFY(near(peaks[1].amplitude, 0.5, 0.01));
        QVERIFY(near(peaks[2].hertz, 1508.5, 0.2));
        QVERIFY(near(peaks[2].amplitude, 0.1, 0.01));
    }
    QCOMPARE(findPeaks(spectrum(channel, {Window::Hann, 0, true}), 2).size(), 2U);
}

void TestScopeSpectrum::theLargestOfManyMaximaAreFoundWithoutACloseLookAtAll()
{
    const auto noise = [](Window window, std::size_t bins) {
        std::mt19937 random(7);
        std::exponential_distribution<double> square;
        Spectrum found;
        found.window = window;
        found.size = 2 * bins;
        found.binHz = 1.0;
        found.meanSquares.resize(bins + 1);
        std::generate(
            found.meanSquares.begin(), found.meanSquares.end(), [&] { return square(random); });
        return found;
    };
    for (const Window window :
        {Window::Rectangular, Window::Hann, Window::BlackmanHarris, Window::FlatTop}) {
        const Spectrum few = noise(window, 2048);
        const auto all = findPeaks(few, 2048);
        QVERIFY(all.size() > 20);
        QVERIFY(std::is_sorted(all.begin(), all.end(),
            [](const auto &a, const auto &b) { return a.amplitude > b.amplitude; }));
        const auto ten = findPeaks(few, 10);
        QCOMPARE(ten.size(), 10U);
        for (std::size_t i = 0; i < ten.size(); ++i)
            QCOMPARE(ten[i].bin, all[i].bin);

        const Spectrum many = noise(window, 1U << 19U);
        std::size_t maxima = 0;
        for (std::size_t k = 1; k + 1 < many.meanSquares.size(); ++k)
            maxima += many.meanSquares[k] > many.meanSquares[k - 1]
                    && many.meanSquares[k] > many.meanSquares[k + 1]
                ? 1
                : 0;
        std::size_t refined = 0;
        QCOMPARE(findPeaks(many, 10, 0.0, &refined).size(), 10U);
        QVERIFY2(refined < maxima / 20,
            qPrintable(
                QStringLiteral("%1 of %2").arg(QString::number(refined), QString::number(maxima))));
    }
}

void TestScopeSpectrum::averagingCalmsTheNoise()
{
    const auto spread = [](const Spectrum &found) { // of the bins about their mean, relative
        double sum = 0.0;
        double squares = 0.0;
        for (std::size_t k = 10; k + 10 < found.meanSquares.size(); ++k) {
            sum += found.meanSquares[k];
            squares += found.meanSquares[k] * found.meanSquares[k];
        }
        const auto count = double(found.meanSquares.size() - 20);
        return std::sqrt(squares / count - std::pow(sum / count, 2)) / (sum / count);
    };
    SpectrumAverage average(64);
    for (std::uint32_t seed = 1; seed <= 64; ++seed)
        average.add(spectrum(fastChannel(
                                 2048, [](double) { return 0.0; }, 1.0, seed),
            {Window::Hann, 0, true}));
    QCOMPARE(average.count(), 64U);
    QVERIFY(near(rmsOf(average.mean(), 0, kRate), 1.0, 0.01));
    QVERIFY(near(spread(average.mean()), 1.0 / 8.0, 0.02));
    const auto one = spectrum(fastChannel(
                                  2048, [](double) { return 0.0; }, 1.0, 7),
        {});
    QVERIFY(near(spread(one), 1.0, 0.15));
    average.add(spectrum(fastChannel(
                             1024, [](double) { return 0.0; }, 1.0, 7),
        {}));
    QCOMPARE(average.count(), 1U); // another shape
    // One long record is averaged by itself.
    const auto longer = spectrum(fastChannel(
                                     65536, [](double) { return 0.0; }, 1.0, 3),
        {Window::Hann, 2048, true});
    QCOMPARE(longer.averaged, 63U);
    QVERIFY(spread(longer) < 0.2);
}

void TestScopeSpectrum::theLongestPieceIsUsed()
{
    auto channel = fastChannel(500, [](double) { return 0.0; });
    std::vector<std::int16_t> tone;
    for (int i = 0; i < 2000; ++i)
        tone.push_back(std::int16_t(1000 * std::sin(kTurn * 0.05 * i)));
    channel.fast()->append(capture::TickBase::of(kRate, 0), 1000, 1, tone);
    const Spectrum found = spectrum(channel, {Window::Hann, 0, true});
    QCOMPARE(found.size, 2000U);
    QCOMPARE(found.from, Nanos(62'500'000));
    QVERIFY(near(findPeaks(found, 1).at(0).hertz, 0.05 * kRate, 0.1));
}

void TestScopeSpectrum::unevenSamplesHaveNoSpectrum()
{
    capture::Capture store;
    std::mt19937 random(1);
    double time = 0.0;
    for (int i = 0; i < 200; ++i) {
        time += 0.01 + double(random() % 100) * 1e-4;
        store.appendPolled(7, "P", "A", time, double(i % 7));
    }
    const capture::Channel &channel = *store.channel(*store.find(7));
    const auto uneven = spectrumOf(SampleRange(channel, 0, 10 * kSecond), {});
    QVERIFY(!uneven && uneven.error() == NoSpectrum::NotUniform);
    const auto few = fastChannel(15, [](double) { return 1.0; });
    const auto none = spectrumOf(SampleRange(few, 0, kSecond), {});
    QVERIFY(!none && none.error() == NoSpectrum::TooFewSamples);
}

void TestScopeSpectrum::valuesAtEqualDistancesHaveOne()
{
    const auto channel = support::slowChannel(
        3000, [](double t) { return std::sin(kTurn * 12.3 * t); },
        700.0); // ticks of 1.428571 ms
    const Spectrum found = spectrum(channel, {Window::BlackmanHarris, 0, true});
    QVERIFY(near(findPeaks(found, 1).at(0).hertz, 12.3, 0.001));
}

void TestScopeSpectrum::ordersAreMultiplesOfTheElectricalFrequency()
{
    const OrderAxis axis = OrderAxis::ofSpeed(-3000, 4);
    QCOMPARE(axis.electricalHz, 200.0);
    QCOMPARE(axis.order(1000.0), 5.0);
    QCOMPARE(axis.hertz(6.0), 1200.0);
    QVERIFY(!OrderAxis::ofSpeed(0, 4).valid());
}

QTEST_APPLESS_MAIN(TestScopeSpectrum)
#include "tst_scope_spectrum.moc"
