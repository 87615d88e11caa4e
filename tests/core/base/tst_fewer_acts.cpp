#include "support/fewer_acts.h"

#include <QtTest>

#include <numeric>

using support::fewerActs;

class TestFewerActs : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatAFailureNeedsIsLeft();
    void aFailureWithoutActsNeedsNone();
    void whenTimeIsOverWhatWasFoundIsLeft();
};

namespace {

std::vector<int> upTo(int count)
{
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), 0);
    return all;
}

bool holds(const std::vector<int> &acts, int act)
{
    return std::find(acts.begin(), acts.end(), act) != acts.end();
}

} // namespace

void TestFewerActs::whatAFailureNeedsIsLeft()
{
    int runs = 0;
    const auto left = fewerActs(
        upTo(200),
        [&runs](const std::vector<int> &acts) {
            ++runs;
            return holds(acts, 3) && holds(acts, 77) && holds(acts, 198);
        },
        [] { return true; });
    QCOMPARE(left, (std::vector<int>{3, 77, 198}));
    QVERIFY2(runs < 120, qPrintable(QString::number(runs)));
}

void TestFewerActs::aFailureWithoutActsNeedsNone()
{
    const auto left = fewerActs(
        upTo(25), [](const std::vector<int> &) { return true; }, [] { return true; });
    QVERIFY(left.empty());
}

void TestFewerActs::whenTimeIsOverWhatWasFoundIsLeft()
{
    int runs = 0;
    const auto left = fewerActs(
        upTo(200), [](const std::vector<int> &acts) { return holds(acts, 150); },
        [&runs] { return ++runs <= 2; });
    QCOMPARE(left.size(), std::size_t(50)); // the half, and the half of it
    QVERIFY(holds(left, 150));
}

QTEST_APPLESS_MAIN(TestFewerActs)
#include "tst_fewer_acts.moc"
