// Formulas: what they compute, in which unit, and what is refused where.
#include "scope/formula.h"
#include "scope/unit.h"
#include "simulation/maths/transforms.h"
#include "support/near.h"

#include <QtTest>

#include <clocale>
#include <cmath>
#include <locale>
#include <numbers>

using support::near;
using namespace scope;

class TestScopeFormula : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void arithmeticIsThatOfPeople_data();
    void arithmeticIsThatOfPeople();
    void mistakesAreNamedWithTheirPlace_data();
    void mistakesAreNamedWithTheirPlace();
    void unitsFollow_data();
    void unitsFollow();
    void unitsReadBack();
    void numbersDoNotDependOnTheLocale();
    void nothingCanBeAssigned();
    void derivativeAndIntegralAreEachOthersReverse();
    void filtersAreOfFirstOrder();
    void medianAndAverageLookBack();
    void unwrapCountsTurns();
    void framesAreThoseOfTheBoard();
    void framesAreExact();
    void whatIsNoNumberSpoilsNothingAfterIt();
};

namespace {

const std::vector<FormulaName> kNames{{"I_A", "A"}, {"I_B", "A"}, {"V_D", "V"}, {"ANGLE", "°"},
    {"SPEED", "rpm"}, {"pi_like", ""}, {"odd (2)", "A"}, {"e", "V"}, {"PHI", "rad"}};

/// The formula's value when the names are worth 1, 2, 3, ...
double constantOf(std::string_view text)
{
    auto formula = Formula::compile(text, kNames);
    if (!formula) {
        qWarning("error %d at %zu", int(formula.error().error), formula.error().position);
        return NAN;
    }
    std::vector<double> values;
    for (const std::size_t used : formula->used())
        values.push_back(double(used + 1));
    return formula->step(values, 0.1, false);
}
std::optional<FormulaFault> fault(std::string_view text)
{
    const auto formula = Formula::compile(text, kNames);
    return formula ? std::nullopt : std::optional(formula.error());
}
/// A formula of one channel, fed a list at equal distances.
std::vector<double> run(std::string_view text, const std::vector<double> &values, double seconds)
{
    auto formula = Formula::compile(text, kNames);
    std::vector<double> result;
    for (std::size_t i = 0; formula && i < values.size(); ++i)
        result.push_back(formula->step(std::span(&values[i], 1), seconds, i > 0));
    return result;
}

} // namespace

void TestScopeFormula::arithmeticIsThatOfPeople_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<double>("expected");
    const auto row = [](const char *text, double expected) {
        QTest::newRow(text) << QByteArray(text) << expected;
    };
    row("I_A + 2 * I_B", 5.0);
    row("(I_A + 2) * I_B", 6.0);
    row("-I_B^2", -4.0);
    row("2^3^2", 512.0);
    row("sqrt(V_D^2 + ANGLE^2)", 5.0);
    row("max(I_A, min(I_B, V_D))", 2.0);
    row("I_A > 0.5 ? I_B : V_D", 2.0);
    row("I_A > 1.5 && I_B > 1 ? 10 : 20", 20.0);
    row("[odd (2)] * 2 + [I_A]", 15.0);
    row("1.5e-3 * 1E+3", 1.5);
    row("sin(pi / 2)", 1.0);
    row("pi_like", 6.0);
    row("e", 8.0); // a channel of that name comes first
    row("  I_A\t", 1.0);
    row("atan2(I_A, I_A)", std::numbers::pi / 4);
    row("sign(-I_B) + abs(-3) + floor(2.7)", 4.0);
    row("ln(exp(2)) + log10(1000)", 5.0);
    row("average(I_A, 3) + lowpass(I_B, 10) * integral(V_D)", 1.0);
    row("derivative(I_A)", NAN);
}

void TestScopeFormula::arithmeticIsThatOfPeople()
{
    QFETCH(const QByteArray, text);
    QFETCH(const double, expected);
    QVERIFY(!fault(text.toStdString()));
    const double actual = constantOf(text.toStdString());
    QVERIFY(std::isnan(expected) ? std::isnan(actual) : near(actual, expected, 1e-12));
}

void TestScopeFormula::mistakesAreNamedWithTheirPlace_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("error");
    QTest::addColumn<int>("position"); // below 0: anywhere
    const auto row = [](const QByteArray &text, FormulaError error, int position) {
        QTest::newRow(text.left(40).constData()) << text << int(error) << position;
    };
    row("", FormulaError::Empty, 0);
    row("   ", FormulaError::Empty, -1);
    row("I_A +", FormulaError::Syntax, -1);
    row("I_A I_B", FormulaError::Syntax, 4);
    row("(I_A", FormulaError::Syntax, -1);
    row("I_A)", FormulaError::Syntax, 3);
    row("I_A, I_B", FormulaError::Syntax, 3);
    row("I_A + NOPE", FormulaError::UnknownName, 6);
    row("[nope]", FormulaError::UnknownName, 0);
    row("[I_A", FormulaError::Syntax, 0);
    row("nope(I_A)", FormulaError::UnknownName, 0);
    row("_0_ + 1", FormulaError::UnknownName, 0);
    row("I_A = 3", FormulaError::BadCharacter, 4);
    row("\"text\"", FormulaError::BadCharacter, 0);
    row("I_A; I_B", FormulaError::BadCharacter, 3);
    row("I_A + \xC2\xB5", FormulaError::BadCharacter, 6);
    row(QByteArray("I_A\0+1", 6), FormulaError::BadCharacter, 3);
    row("1.2.3", FormulaError::BadNumber, 0);
    row("I_A + 2x", FormulaError::BadNumber, 6);
    row("1e999", FormulaError::BadNumber, 0);
    row("1,5 * I_A", FormulaError::Syntax, 1);
    row("sin(I_A, I_B)", FormulaError::WrongArgumentCount, 0);
    row("1 + lowpass(I_A)", FormulaError::WrongArgumentCount, 4);
    row("min()", FormulaError::WrongArgumentCount, 0);
    row("sin()", FormulaError::Syntax, -1);
    row("lowpass(I_A, I_B)", FormulaError::NotConstant, 12);
    row("lowpass(I_A, 0)", FormulaError::OutOfRange, 12);
    row("median(I_A, 2.5)", FormulaError::OutOfRange, 11);
    row("average(I_A, 1e6)", FormulaError::OutOfRange, 12);
    row("unwrap(I_A)", FormulaError::NotAnAngle, 7);
    row("park_d(I_A, I_B, SPEED)", FormulaError::NotAnAngle, 16);
    row(QByteArray(501, ' '), FormulaError::TooLong, 500);
    row(QByteArray(40, '(') + "1" + QByteArray(40, ')'), FormulaError::TooDeep, 32);
    row(QByteArray("abs(").repeated(40) + "1" + QByteArray(40, ')'), FormulaError::TooDeep, -1);
    QByteArray many = "0";
    for (int i = 0; i < 33; ++i)
        many += "+integral(e)";
    row(many, FormulaError::TooDeep, -1);
}

void TestScopeFormula::mistakesAreNamedWithTheirPlace()
{
    QFETCH(const QByteArray, text);
    QFETCH(const int, error);
    QFETCH(const int, position);
    const auto found = fault(text.toStdString());
    QVERIFY(found);
    QCOMPARE(int(found->error), error);
    if (position >= 0)
        QCOMPARE(int(found->position), position);
    QVERIFY(found->position <= std::size_t(text.size()));
}

void TestScopeFormula::unitsFollow_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("unit");
    const auto row = [](const char *text, const char *unit) {
        QTest::newRow(text) << QByteArray(text) << QByteArray(unit);
    };
    row("I_A", "A");
    row("I_A * V_D", "W");
    row("1.5 * I_A * V_D + 0.2 * I_B * V_D", "W");
    row("V_D / I_A", "Ω");
    row("I_A / I_B", "");
    row("I_A * I_B", "A²");
    row("sqrt(I_A^2 + I_B^2)", "A");
    row("I_A + V_D", "");
    row("I_A + 1", "");
    row("max(I_A, I_B)", "A");
    row("abs(I_A)", "A");
    row("I_A > I_B ? I_A : I_B", "A");
    row("sin(I_A)", "");
    row("3", "");
    row("SPEED * 2", "rpm");
    row("derivative(I_A)", "A/s");
    row("derivative(derivative(I_A))", "A/s²");
    row("integral(V_D * I_A)", "J");
    row("integral(V_D)", "Wb");
    row("V_D / derivative(I_A)", "H");
    row("lowpass(I_A, 100)", "A");
    row("lowpass(I_A + V_D, 100)", "");
    row("clarke_beta(I_A, I_B)", "A");
    row("clarke_beta(I_A, V_D)", "");
    row("park_q(I_A, I_B, ANGLE)", "A");
    row("park_q(I_A, I_B, PHI)", "A");
    row("power(V_D, I_A, V_D, I_B)", "W");
    row("unwrap(ANGLE)", "°");
    row("derivative(unwrap(ANGLE))", "°/s");
}

void TestScopeFormula::unitsFollow()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, unit);
    const auto formula = Formula::compile(text.toStdString(), kNames);
    QVERIFY(formula);
    QCOMPARE(QByteArray::fromStdString(formula->unit()), unit);
}

void TestScopeFormula::unitsReadBack()
{
    for (const char *text :
        {"", "A", "W", "Ω", "H", "A/s", "A²", "1/s", "V/(A·s²)", "rpm/s", "Hz", "°/s", "A·V²"})
        QCOMPARE(Unit::of(text).text(), std::string(text));
    QVERIFY(Unit::of("V") * Unit::of("A") == Unit::of("W"));
    QVERIFY(Unit::of("J") / Unit::of("s") == Unit::of("W"));
    QVERIFY((Unit::of("A") / Unit::of("A")).isNumber());
    QCOMPARE(Unit::of("odd/(one").text(), std::string("odd/(one"));
    Unit root;
    root.add("V", 1);
    QCOMPARE(root.text(), std::string("V^(1/2)"));
}

void TestScopeFormula::numbersDoNotDependOnTheLocale()
{
    struct Comma : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale(), new Comma));
    std::setlocale(LC_ALL, "de_DE.UTF-8");
    QCOMPARE(constantOf("1234.5 + 0.25"), 1234.75);
    QVERIFY(fault("1234,5"));
    std::locale::global(before);
    std::setlocale(LC_ALL, "C.UTF-8");
}

void TestScopeFormula::nothingCanBeAssigned()
{
    for (const char *text : {"I_A = 1", "I_A == (I_B = 2)", "I_A += 1", "pi = 3", "I_A =1", "=1"})
        QVERIFY(fault(text));
    QVERIFY(!fault("I_A == I_B"));
    QVERIFY(!fault("I_A != I_B"));
}

void TestScopeFormula::derivativeAndIntegralAreEachOthersReverse()
{
    std::vector<double> wave;
    for (int i = 0; i < 2000; ++i)
        wave.push_back(3.0 + std::sin(0.01 * i));
    const auto slope = run("derivative(I_A)", wave, 1e-3);
    QVERIFY(std::isnan(slope[0]));
    for (std::size_t i = 1; i < wave.size(); ++i) // at the middle between the samples
        QVERIFY(near(slope[i], 10.0 * std::cos(0.01 * (double(i) - 0.5)), 1e-4));
    const auto area = run("integral(I_A)", wave, 1e-3);
    for (std::size_t i = 0; i < wave.size(); ++i)
        QVERIFY(near(area[i], 3e-3 * double(i) + 0.1 * (1 - std::cos(0.01 * double(i))), 1e-5));
    const auto back = run("integral(derivative(I_A))", wave, 1e-3);
    for (std::size_t i = 2; i < wave.size(); ++i)
        QVERIFY(near(back[i] - back[1], wave[i] - wave[1] - (slope[i] - slope[1]) * 0.5e-3, 1e-9));
}

void TestScopeFormula::filtersAreOfFirstOrder()
{
    std::vector<double> step(3000, 1.0);
    step[0] = 0.0;
    const double rate = 2 * std::numbers::pi * 20.0;
    const auto low = run("lowpass(I_A, 20)", step, 1e-4);
    const auto high = run("highpass(I_A, 20)", step, 1e-4);
    for (std::size_t i = 0; i < step.size(); ++i) {
        QVERIFY(near(low[i], 1.0 - std::exp(-rate * 1e-4 * double(i)), 1e-9));
        QVERIFY(near(low[i] + high[i], step[i], 1e-12));
    }
    // At its frequency a sine loses 3 dB.
    std::vector<double> sine;
    for (int i = 0; i < 20000; ++i)
        sine.push_back(std::sin(rate * 1e-4 * i));
    const auto damped = run("lowpass(I_A, 20)", sine, 1e-4);
    QVERIFY(near(*std::max_element(damped.begin() + 10000, damped.end()), std::sqrt(0.5), 0.006));
}

void TestScopeFormula::medianAndAverageLookBack()
{
    const std::vector<double> values{1, 9, 2, 8, 3, 7, 100, 4};
    const auto median = run("median(I_A, 3)", values, 1.0);
    QCOMPARE(median, (std::vector<double>{1, 5, 2, 8, 3, 7, 7, 7}));
    const auto average = run("average(I_A, 2)", values, 1.0);
    QCOMPARE(average, (std::vector<double>{1, 5, 5.5, 5, 5.5, 5, 53.5, 52}));
    QCOMPARE(run("median(I_A, 1)", values, 1.0), values);
}

void TestScopeFormula::unwrapCountsTurns()
{
    std::vector<double> angle;
    std::vector<double> expected;
    for (int i = 0; i < 500; ++i) {
        expected.push_back(100.0 + (i < 250 ? i : 500 - i) * 17.0);
        angle.push_back(std::remainder(expected.back(), 360.0));
    }
    auto formula = Formula::compile("unwrap(ANGLE)", kNames);
    for (std::size_t i = 0; i < angle.size(); ++i)
        QVERIFY(near(formula->step(std::span(&angle[i], 1), 1.0, i > 0), expected[i], 1e-9));
    QVERIFY(near(formula->step(std::span(&angle[7], 1), 1.0, false), angle[7], 1e-9)); // anew
}

void TestScopeFormula::framesAreThoseOfTheBoard()
{
    auto beta = Formula::compile("clarke_beta(I_A, I_B)", kNames);
    auto d = Formula::compile("park_d(I_A, I_B, ANGLE)", kNames);
    auto q = Formula::compile("park_q(I_A, I_B, ANGLE)", kNames);
    for (int i = 0; i < 200; ++i) {
        const double a = 9000.0 * std::sin(0.31 * i);
        const double b = 7000.0 * std::cos(0.17 * i);
        const auto code = [](double constantOf) {
            return static_cast<std::int16_t>(std::lround(constantOf));
        };
        const std::array<double, 2> phases{double(code(a)), double(code(b))};
        const auto board = simulation::clarke({code(a), code(b)});
        QVERIFY(near(beta->step(phases, 1.0, true), double(board.beta), 3.0));
        const double degrees = std::remainder(7.7 * i, 360.0);
        const auto turned = simulation::park({code(a), code(b)},
            simulation::trig(static_cast<std::int16_t>(degrees * 65536.0 / 360.0)));
        const std::array<double, 3> values{phases[0], phases[1], degrees};
        QVERIFY(near(d->step(values, 1.0, true), double(turned.d), 60.0)); // its table of sines
        QVERIFY(near(q->step(values, 1.0, true), double(turned.q), 60.0));
    }
}

void TestScopeFormula::framesAreExact()
{
    const auto at = [](const char *text, double angle) {
        auto formula = Formula::compile(text, kNames);
        const double radians = angle * std::numbers::pi / 180;
        const std::array<double, 3> values{std::sin(radians), std::cos(radians), angle};
        return formula->step(values, 1.0, true);
    };
    for (const double angle : {0.0, 30.0, 200.0}) {
        QVERIFY(near(at("park_d(I_A, I_B, ANGLE)", angle), 1.0, 1e-12));
        QVERIFY(near(at("park_q(I_A, I_B, ANGLE)", angle), 0.0, 1e-12));
    }
    auto beta = Formula::compile("clarke_beta(I_A, I_B)", kNames);
    const std::array<double, 2> values{-0.5, 1.0}; // phase b at its peak
    QVERIFY(near(beta->step(values, 1.0, true), -std::sqrt(3.0) / 2, 1e-12));
}

void TestScopeFormula::whatIsNoNumberSpoilsNothingAfterIt()
{
    const auto result = run("lowpass(1 / I_A, 5)", {1.0, 0.0, 2.0, 2.0}, 0.1);
    QCOMPARE(result[0], 1.0);
    QVERIFY(!std::isfinite(result[1]));
    QCOMPARE(result[2], 0.5); // begins anew
    QCOMPARE(result[3], 0.5);
}

QTEST_APPLESS_MAIN(TestScopeFormula)
#include "tst_scope_formula.moc"
