// Means with their intervals, and values that stand apart.
#include "lab/maths/statistics.h"
#include "support/link_pair.h"

#include <QTest>

using namespace lab;

class TestLabStatistics : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void oneValueHasNoInterval()
    {
        QVERIFY(!meanOf({}));
        const std::vector<double> one{3.5};
        QVERIFY(*meanOf(one) == (Estimate{3.5, {}, {}}));
    }
    void theIntervalIsStudents()
    {
        // Worked by hand: mean 5, sample deviation sqrt(20 / 3), t(3) = 3.182.
        const std::vector<double> four{2.0, 4.0, 6.0, 8.0};
        const Estimate mean = *meanOf(four);
        QCOMPARE(mean.value, 5.0);
        const double half = 3.182 * std::sqrt(20.0 / 3.0) / 2.0;
        QVERIFY(std::abs(*mean.high - 5.0 - half) < 1e-9);
        QVERIFY(std::abs(5.0 - *mean.low - half) < 1e-9);
    }
    void aScaleThatIsUnsureWidensIt()
    {
        const Estimate wide = withScale({10.0, 9.7, 10.3}, 0.04); // 0.3 and 0.4 to either side
        QVERIFY(std::abs(*wide.low - 9.5) < 1e-12 && std::abs(*wide.high - 10.5) < 1e-12);
        QCOMPARE(wide.value, 10.0);
    }
    /// 95 of 100 intervals hold the true value: 4,000 series of each length, so the share is known to 0.4 points.
    void intervalsHoldTheTruthAsOftenAsTheySay_data()
    {
        QTest::addColumn<int>("length");
        for (const int length : {2, 3, 5, 10, 31, 60})
            QTest::addRow("%d", length) << length;
    }
    void intervalsHoldTheTruthAsOftenAsTheySay()
    {
        QFETCH(const int, length);
        support::Random random(7);
        const auto uniform = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
        int held = 0;
        constexpr int kSeries = 4000;
        for (int i = 0; i < kSeries; ++i) {
            std::vector<double> values;
            for (int k = 0; k < length; ++k) // Box and Muller
                values.push_back(10.0
                    + std::sqrt(-2.0 * std::log(1.0 - uniform()))
                        * std::cos(6.283185307179586 * uniform()));
            const Estimate mean = *meanOf(values);
            held += *mean.low <= 10.0 && 10.0 <= *mean.high ? 1 : 0;
        }
        const double share = held / double(kSeries);
        QVERIFY2(std::abs(share - 0.95) < 0.012, qPrintable(QString::number(share)));
    }
    /// What differs from kind to kind is no spread of a measurement.
    void theMiddleOfTwoKindsKnowsNothingOfTheirDifference()
    {
        const std::vector<double> up{13.0, 14.0, 15.0}, down{23.0, 24.0, 25.0};
        const Estimate both = *meanOfBoth(up, down);
        QCOMPARE(both.value, 19.0);
        // Pooled variance 1, four degrees of freedom, two means of three: 2.776 * sqrt(2 / 3) / 2.
        QVERIFY(std::abs(*both.high - 19.0 - 2.776 * std::sqrt(2.0 / 3.0) / 2.0) < 1e-9);
        QVERIFY(*meanOfBoth(up, {}) == *meanOf(up));
        QVERIFY(*meanOfBoth({}, down) == *meanOf(down));
        QVERIFY(!meanOfBoth({}, {}));
        QVERIFY(!meanOfBoth(std::vector{1.0}, std::vector{3.0})->low);
    }
    void digitsFollowTheInterval()
    {
        QCOMPARE(lastPlaceOf({0.3521, 0.3398, 0.3644}), 1e-3);
        QCOMPARE(lastPlaceOf({2.4e-5, 2.3e-5, 2.5e-5}), 1e-7);
        QCOMPARE(lastPlaceOf({500.0, 100.0, 900.0}), 10.0);
        QCOMPARE(lastPlaceOf({0.0, 0.0, 0.04}), 1e-3); // what cannot be below 0
        QCOMPARE(lastPlaceOf({3.5, {}, {}}), 0.0);
        QCOMPARE(lastPlaceOf({3.5, 3.5, 3.5}), 0.0);
    }
    void whatStandsApartIsNamed()
    {
        const std::vector<double> values{10.0, 10.1, 9.9, 10.05, 9.95, 12.0};
        QCOMPARE(outliersOf(values, 0.0), (std::vector<std::size_t>{5}));
        QVERIFY(outliersOf(values, 3.0).empty());
    }
    /// The deviation of mostly equal values is zero: the resolution decides then.
    void mostlyEqualValuesHideNoOutlier()
    {
        const std::vector<double> values{20.0, 20.0, 20.0, 20.0, 20.0, 26.0};
        QCOMPARE(outliersOf(values, 1.0), (std::vector<std::size_t>{5}));
        QVERIFY(outliersOf(values, 6.0).empty());
        const std::vector<double> three{20.0, 20.0, 26.0};
        QVERIFY(outliersOf(three, 1.0).empty());
    }
};

QTEST_APPLESS_MAIN(TestLabStatistics)
#include "tst_lab_statistics.moc"
