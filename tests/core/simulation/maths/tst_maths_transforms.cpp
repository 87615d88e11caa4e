// The arithmetic of the fast task: angles, transforms, circle limitation, modulation, at their edges and at random.
#include "simulation/maths/transforms.h"
#include "simulation/maths/voltage.h"
#include "simulation/plant/parameters.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace simulation;

namespace {

constexpr double kRoot3 = std::numbers::sqrt3;

/// The generator's numbers are the standard's; distributions are not.
class Digits {
public:
    std::int16_t next()
    {
        return static_cast<std::int16_t>(static_cast<std::uint16_t>(m_engine() >> 8U));
    }
    std::int16_t within(int most)
    {
        return static_cast<std::int16_t>(
            static_cast<int>(m_engine() % static_cast<unsigned>(2 * most + 1)) - most);
    }

private:
    std::mt19937 m_engine{20240607};
};

/// The case that failed.
template <class... Numbers>
QByteArray values(Numbers... numbers)
{
    return ((QByteArray::number(numbers) + ' ') + ...);
}

double radians(std::int16_t angle) { return angle * (kTurn / 65536.0); }

} // namespace

class TestMathsTransforms : public QObject {
    Q_OBJECT

private slots:
    void sineAndCosineAreWithinTheirBoundAtEveryAngle();
    void sineAndCosineAreSymmetric();
    void theAngleOfAVectorIsWithinOneDigit();
    void aPositiveSequenceTurnsPhaseBBehindPhaseA();
    void parkAndItsReverseReturnTheVector();
    void aBackEmfInStepWithTheAngleIsAllOnQ();
    void transformsSaturateAndNeverWrap();
    void theSquareRootIsCutToAWholeNumber();
    void theCircleLeavesWhatIsInside();
    void theCircleGivesDItsShareFirst();
    void modulationPutsTheVoltageOnThePhases();
    void modulationReachesTheHexagonAndCutsBeyond();
};

void TestMathsTransforms::sineAndCosineAreWithinTheirBoundAtEveryAngle()
{
    for (int i = -32768; i <= 32767; ++i) {
        const auto angle = static_cast<std::int16_t>(i);
        const Trig t = trig(angle);
        const double sine = std::min(32767.0, 32768.0 * std::sin(radians(angle)));
        const double cosine = std::min(32767.0, 32768.0 * std::cos(radians(angle)));
        if (std::abs(t.sine - sine) > 1.5 || std::abs(t.cosine - cosine) > 1.5)
            QFAIL(values(i, t.cosine, t.sine).constData());
    }
    QCOMPARE(trig(0), (Trig{32767, 0}));
    QCOMPARE(trig(16384), (Trig{0, 32767}));
    QCOMPARE(trig(-32768), (Trig{-32767, 0}));
    QCOMPARE(trig(-16384), (Trig{0, -32767}));
}

void TestMathsTransforms::sineAndCosineAreSymmetric()
{
    for (int i = 1; i <= 32767; ++i) {
        const Trig plus = trig(static_cast<std::int16_t>(i)),
                   minus = trig(static_cast<std::int16_t>(-i));
        QCOMPARE(minus, (Trig{plus.cosine, static_cast<std::int16_t>(-plus.sine)}));
        QCOMPARE(trig(wrapAngle(i + 16384)).sine, plus.cosine);
    }
}

void TestMathsTransforms::theAngleOfAVectorIsWithinOneDigit()
{
    for (const int length : {2000, 8000, 32767}) {
        for (int i = -32768; i <= 32767; i += 7) {
            const double angle = radians(static_cast<std::int16_t>(i));
            const auto x = static_cast<std::int16_t>(std::lrint(length * std::cos(angle)));
            const auto y = static_cast<std::int16_t>(std::lrint(length * std::sin(angle)));
            const double exact = std::atan2(y, x) * (65536.0 / kTurn);
            const double off = std::remainder(angleOf(x, y) - exact, 65536.0);
            if (std::abs(off) > 1.0)
                QFAIL(values(x, y, off).constData());
        }
    }
    QCOMPARE(angleOf(0, 0), std::int16_t{0});
    QCOMPARE(angleOf(32767, 0), std::int16_t{0});
    QCOMPARE(angleOf(0, 32767), std::int16_t{16384});
    QCOMPARE(angleOf(0, -32768), std::int16_t{-16384});
    QCOMPARE(angleOf(-32768, 0), std::int16_t{-32768});
    QCOMPARE(angleOf(-32768, -32768), std::int16_t{-24576});
}

void TestMathsTransforms::aPositiveSequenceTurnsPhaseBBehindPhaseA()
{
    for (int i = 0; i < 65536; i += 511) {
        const double angle = i * (kTurn / 65536.0);
        const Ab phases{static_cast<std::int16_t>(std::lrint(20000.0 * std::cos(angle))),
            static_cast<std::int16_t>(std::lrint(20000.0 * std::cos(angle - kTurn / 3.0)))};
        const AlphaBeta v = clarke(phases);
        QVERIFY(std::abs(v.alpha - 20000.0 * std::cos(angle)) < 2.0);
        QVERIFY(std::abs(v.beta + 20000.0 * std::sin(angle)) < 3.0);
        const Qd qd = park(v, trig(wrapAngle(i)));
        QVERIFY(std::abs(qd.q - 20000) < 4);
        QVERIFY(std::abs(qd.d) < 4);
    }
}

void TestMathsTransforms::parkAndItsReverseReturnTheVector()
{
    Digits digits;
    for (int i = 0; i < 100000; ++i) {
        const AlphaBeta v{digits.within(23000), digits.within(23000)};
        const Trig angle = trig(digits.next());
        const AlphaBeta back = reversePark(park(v, angle), angle);
        // cut twice, and cosine and sine are a digit off: 1/32768 of 32527 each
        if (std::abs(back.alpha - v.alpha) > 5 || std::abs(back.beta - v.beta) > 5)
            QFAIL(values(v.alpha, v.beta).constData());
    }
}

void TestMathsTransforms::aBackEmfInStepWithTheAngleIsAllOnQ()
{
    const Trig angle = trig(5000);
    const AlphaBeta bemf = reversePark({10000, 0}, angle);
    QVERIFY(std::abs(bemf.alpha - 10000.0 * std::cos(radians(5000))) < 2.0);
    QVERIFY(std::abs(bemf.beta + 10000.0 * std::sin(radians(5000))) < 2.0);
}

void TestMathsTransforms::transformsSaturateAndNeverWrap()
{
    Digits digits;
    const auto close = [](std::int16_t is, double exact) {
        return std::abs(is - std::clamp(exact, -32767.0, 32767.0)) < 4.0;
    };
    for (int i = 0; i < 100000; ++i) {
        const std::int16_t x = digits.next(), y = digits.next();
        const std::int16_t angle = digits.next();
        const double cosine = std::cos(radians(angle)), sine = std::sin(radians(angle));
        const AlphaBeta c = clarke({x, y});
        const Qd p = park({x, y}, trig(angle));
        const AlphaBeta r = reversePark({x, y}, trig(angle));
        const bool good = close(c.beta, -(x + 2.0 * y) / kRoot3)
            && close(p.q, x * cosine - y * sine) && close(p.d, x * sine + y * cosine)
            && close(r.alpha, x * cosine + y * sine) && close(r.beta, y * cosine - x * sine);
        if (!good)
            QFAIL(values(x, y, angle).constData());
    }
    QCOMPARE(clarke({-32768, -32768}), (AlphaBeta{-32768, 32767}));
    QCOMPARE(clarke({32767, 32767}), (AlphaBeta{32767, -32767}));
    QCOMPARE(park({-32768, 32767}, {32767, 32767}), (Qd{-32767, -1}));
}

void TestMathsTransforms::theSquareRootIsCutToAWholeNumber()
{
    QCOMPARE(squareRoot(-1), 0);
    QCOMPARE(squareRoot(0), 0);
    for (std::int64_t i = 1; i < 40000; ++i) {
        QCOMPARE(squareRoot(i * i), i);
        QCOMPARE(squareRoot(i * i - 1), i - 1);
    }
}

void TestMathsTransforms::theCircleLeavesWhatIsInside()
{
    Digits digits;
    for (int i = 0; i < 10000; ++i) {
        const Qd v{digits.within(23169), digits.within(23169)};
        QCOMPARE(circleLimit(v, circleOf(32767)), v);
    }
    QCOMPARE(circleLimit({32767, 0}, circleOf(32767)), (Qd{32767, 0}));
}

void TestMathsTransforms::theCircleGivesDItsShareFirst()
{
    // room for q: sqrt(20000^2 - 12000^2) = 16000; a d beyond 19000: sqrt(20000^2 - 19000^2) = 6244.99
    QCOMPARE(circleLimit({-30000, 12000}, circleOf(20000)), (Qd{-16000, 12000}));
    QCOMPARE(circleLimit({30000, -25000}, circleOf(20000)), (Qd{6244, -19000}));
    QCOMPARE(circleLimit({-32768, -32768}, circleOf(0)), (Qd{0, 0}));
    Digits digits;
    for (int i = 0; i < 10000; ++i) {
        const Qd v{digits.next(), digits.next()};
        const auto max = static_cast<std::uint16_t>(std::abs(digits.within(32767)));
        const Qd cut = circleLimit(v, circleOf(max));
        QVERIFY(cut.q * cut.q + cut.d * cut.d <= max * max);
        QVERIFY(cut.q == 0 || (cut.q < 0) == (v.q < 0));
        QVERIFY(cut.d == 0 || (cut.d < 0) == (v.d < 0));
    }
}

void TestMathsTransforms::modulationPutsTheVoltageOnThePhases()
{
    constexpr std::uint16_t kPeriod = 5312; // 170 MHz, 16 kHz
    QCOMPARE(modulate({0, 0}, kPeriod), (Compare{2656, 2656, 2656}));
    for (int i = 0; i < 65536; i += 37) {
        const double angle = i * (kTurn / 65536.0);
        const AlphaBeta v = reversePark({32000, 0}, trig(wrapAngle(i)));
        const Duties duty = dutiesOf(modulate(v, kPeriod), kPeriod);
        const double mean = (duty.a + duty.b + duty.c) / 3.0;
        const double size = 32000.0 / 32768.0 / kRoot3; // of the bus
        QVERIFY(std::abs(duty.a - mean - size * std::cos(angle)) < 3e-4);
        QVERIFY(std::abs(duty.b - mean - size * std::cos(angle - kTurn / 3.0)) < 3e-4);
        QVERIFY(std::abs(duty.c - mean - size * std::cos(angle + kTurn / 3.0)) < 3e-4);
        const double middle =
            std::max({duty.a, duty.b, duty.c}) + std::min({duty.a, duty.b, duty.c});
        QVERIFY(std::abs(middle - 1.0) < 3e-4);
    }
}

void TestMathsTransforms::modulationReachesTheHexagonAndCutsBeyond()
{
    // Between two corners: the whole bus between B and C.
    const Compare tip = modulate({0, -32767}, 5312);
    QVERIFY(tip.b >= 5311 && tip.c <= 1);
    const Compare past = modulate({-32768, -32768}, 65535);
    QCOMPARE(past.a, std::uint16_t{0});
    QCOMPARE(past.b, std::uint16_t{65535});
    QCOMPARE(modulate({12345, -321}, 0), (Compare{0, 0, 0}));
    QCOMPARE(dutiesOf({0, 0, 0}, 0).a, 0.0);
}

QTEST_APPLESS_MAIN(TestMathsTransforms)
#include "tst_maths_transforms.moc"
