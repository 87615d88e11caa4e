// Least squares whose answers are known.
#include "lab/maths/least_squares.h"
#include "support/link_pair.h"

#include <QTest>

using namespace lab;

namespace {

/// wanted = 2 a - 3 b + noise, in clusters of ten rows.
Rows rowsOf(std::size_t count, double noise, std::uint64_t seed, double perCluster = 0.0)
{
    support::Random random(seed);
    const auto uniform = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-52 - 1.0; };
    Rows rows;
    double common = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % 10 == 0)
            common = uniform() * perCluster;
        // A disturbance that lasts is worst for what lasts, too.
        rows.known.push_back({uniform() + (i / 10 % 2 == 0 ? 1.0 : -1.0), uniform() * 1e-6});
        rows.wanted.push_back(
            2.0 * rows.known.back()[0] - 3.0 * rows.known.back()[1] + uniform() * noise + common);
        rows.cluster.push_back(i / 10);
    }
    return rows;
}

constexpr std::array<std::size_t, 2> kBoth{0, 1};

} // namespace

class TestLeastSquares : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Noise of a column makes its unknown too small; an instrument of it, which moves along and has none, does not.
    void anInstrumentIsNotMisledByNoise()
    {
        support::Random random(3);
        const auto uniform = [&] {
            return static_cast<double>(random.next() >> 11) * 0x1p-52 - 1.0;
        };
        Rows rows;
        for (std::size_t i = 0; i < 4000; ++i) {
            const double moves = uniform(), other = uniform();
            rows.instruments.push_back({5.0 * moves + 2.0 * other, other});
            rows.known.push_back({moves + uniform(), other});
            rows.wanted.push_back(2.0 * moves - 3.0 * other + 0.1 * uniform());
            rows.cluster.push_back(i / 10);
        }
        const auto fit = leastSquares(rows, kBoth);
        QVERIFY(fit);
        for (const auto &[unknown, truth] : {std::pair(0U, 2.0), std::pair(1U, -3.0)}) {
            const Estimate estimate = fit->estimate(unknown);
            QVERIFY2(std::abs(estimate.value - truth) < 0.15,
                qPrintable(QString::number(estimate.value)));
            QVERIFY(*estimate.low <= truth && truth <= *estimate.high);
        }
        rows.instruments.clear();
        QVERIFY(leastSquares(rows, kBoth)->values[0] < 1.2);
    }

    void exactRowsGiveTheExactAnswer()
    {
        const auto fit = leastSquares(rowsOf(100, 0.0, 1), kBoth);
        QVERIFY(fit);
        QVERIFY(std::abs(fit->values[0] - 2.0) < 1e-9);
        QVERIFY(std::abs(fit->values[1] + 3.0) < 1e-3);
        QCOMPARE(fit->values[2], 0.0);
        QVERIFY(fit->residual < 1e-9);
    }

    /// 95 of 100 intervals hold the truth, also where the noise of a cluster is common to its rows.
    void intervalsHoldTheTruth()
    {
        for (const double perCluster : {0.0, 1.0}) {
            int held = 0;
            constexpr int kTries = 1000;
            for (int i = 0; i < kTries; ++i) {
                const auto fit = leastSquares(
                    rowsOf(400, 0.3, static_cast<std::uint64_t>(i) + 1, perCluster), kBoth);
                const Estimate estimate = fit->estimate(0);
                held += *estimate.low <= 2.0 && 2.0 <= *estimate.high ? 1 : 0;
            }
            const double share = held / double(kTries);
            QVERIFY2(share > 0.92 && share < 0.98,
                qPrintable(QStringLiteral("%1: %2").arg(perCluster).arg(share)));
        }
    }

    void aRowThatIsFarOffCountsForNothing()
    {
        Rows rows = rowsOf(200, 0.1, 1);
        rows.wanted[50] = 1000.0;
        const auto fit = leastSquares(rows, kBoth);
        QVERIFY(fit && std::abs(fit->values[0] - 2.0) < 0.05);
        QVERIFY(fit->rows < 200.0);
    }

    void whatDoesNotDetermineTheUnknownsGivesNothing()
    {
        Rows rows = rowsOf(100, 0.1, 1);
        for (Row &row : rows.known)
            row[1] = 2.0 * row[0];
        QVERIFY(!leastSquares(rows, kBoth));
        for (Row &row : rows.known)
            row[1] = 0.0;
        QVERIFY(!leastSquares(rows, kBoth));
        Rows few = rowsOf(20, 0.1, 1);
        QVERIFY(!leastSquares(few, kBoth)); // two clusters
        QVERIFY(!leastSquares(Rows{}, kBoth));
    }

    void theModelThatIsTrueIsChosen()
    {
        const Rows rows = rowsOf(400, 0.1, 3);
        const auto both = leastSquares(rows, kBoth);
        const auto one = leastSquares(rows, std::array<std::size_t, 1>{0});
        QVERIFY(explainsBetter(rows, *one, *both)); // the second is a millionth
        QVERIFY(!explainsBetter(rows, *both, *one));
        Rows clear = rows;
        for (std::size_t i = 0; i < clear.known.size(); ++i) {
            clear.known[i][1] *= 1e6;
            clear.wanted[i] -= 3.0 * clear.known[i][1];
        }
        QVERIFY(explainsBetter(clear, *leastSquares(clear, kBoth),
            *leastSquares(clear, std::array<std::size_t, 1>{0})));
    }

    /// Four rows are far off for the better model alone. In a small unit each row that counts makes a criterion better.
    void modelsAreComparedByTheRowsOfBoth()
    {
        constexpr double kUnit = 1e-12, kFarOff = 4.6;
        const auto sign = [](int way) { return way % 2 == 0 ? 1.0 : -1.0; };
        Rows rows;
        for (int i = 0; i < 404; ++i) {
            const bool off = i >= 400;
            const double a = off ? 0.0 : sign(i / 20), b = off ? 0.0 : sign(i / 2);
            rows.known.push_back({a, b});
            rows.wanted.push_back(kUnit * (2.0 * a + 0.5 * b + (off ? kFarOff : sign(i))));
            rows.cluster.push_back(static_cast<std::size_t>(i / 20));
        }
        const auto both = leastSquares(rows, kBoth);
        const auto one = leastSquares(rows, std::array<std::size_t, 1>{0});
        QVERIFY(both && one);
        QCOMPARE(both->rows, 400.0);
        QCOMPARE(one->rows, 404.0);
        QVERIFY(explainsBetter(rows, *both, *one));
        QVERIFY(!explainsBetter(rows, *one, *both));
    }
};

QTEST_APPLESS_MAIN(TestLeastSquares)
#include "tst_least_squares.moc"
