// Numbers as text, read in the one way that all platforms have.
#include "base/text.h"

#include <QtTest>

#include <limits>

class TestText : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aDecimalIsReadAsFarAsItGoes_data();
    void aDecimalIsReadAsFarAsItGoes();
    void aWordForNoNumberIsRead();
    void aNumberIsTheWholeText();
};

constexpr double kBefore = -7.0;

void TestText::aDecimalIsReadAsFarAsItGoes_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("taken"); // characters; 0: it is no number
    QTest::addColumn<double>("value");
    const auto row = [](const char *text, int taken, double value = kBefore) {
        QTest::newRow(*text == '\0' ? "nothing" : text) << QByteArray(text) << taken << value;
    };
    row("0", 1, 0.0);
    row("12", 2, 12.0);
    row("-12.5", 5, -12.5);
    row("00.25", 5, 0.25);
    row(".5", 2, 0.5);
    row("-.5", 3, -0.5);
    row("5.", 2, 5.0);
    row("1.2.3", 3, 1.2);
    row("0.1", 3, 0.1);
    row("0.30000000000000004", 19, 0.1 + 0.2);
    row("1e3", 3, 1000.0);
    row("25E-1", 5, 2.5);
    row("1e+2", 4, 100.0);
    row("1e", 1, 1.0);
    row("1e+", 1, 1.0);
    row("1.e1x", 4, 10.0);
    row("3,5", 1, 3.0);
    row("1 000", 1, 1.0);
    row("0x10", 1, 0.0);
    row("1.7976931348623157e308", 22, std::numeric_limits<double>::max());
    row("inf", 3, std::numeric_limits<double>::infinity());
    row("-INFinity!", 9, -std::numeric_limits<double>::infinity());
    row("1e999", 5); // does not fit
    row("", 0);
    row("-", 0);
    row(".", 0);
    row("-.e1", 0);
    row("+1", 0);
    row(" 1", 0);
    row("--1", 0);
    row("e5", 0);
    row("in", 0);
}

void TestText::aDecimalIsReadAsFarAsItGoes()
{
    QFETCH(QByteArray, text);
    QFETCH(int, taken);
    QFETCH(double, value);
    for (const auto &read : {readDecimal, decimalOfStream}) {
        double found = kBefore;
        const auto result = read(text.constData(), text.constData() + text.size(), found);
        QCOMPARE(int(result.ptr - text.constData()), taken);
        QCOMPARE(result.ec,
            taken == 0             ? std::errc::invalid_argument
                : value == kBefore ? std::errc::result_out_of_range
                                   : std::errc{});
        QVERIFY(found == value); // to the last bit
    }
}

void TestText::aWordForNoNumberIsRead()
{
    const std::string_view text = "NaN";
    for (const auto &read : {readDecimal, decimalOfStream}) {
        double found = kBefore;
        const auto result = read(text.data(), text.data() + text.size(), found);
        QVERIFY(result.ec == std::errc{} && result.ptr == text.data() + text.size());
        QVERIFY(qIsNaN(found));
    }
}

void TestText::aNumberIsTheWholeText()
{
    QCOMPARE(numberIn<double>("-2.5e1"), std::optional(-25.0));
    for (const char *text : {"", " 1", "1 ", "+1", "1,5", "1e999"})
        QCOMPARE(numberIn<double>(text), std::nullopt);
    QCOMPARE(numberIn<int>("1f", 16), std::optional(31));
    QCOMPARE(numberIn<int>("1.0"), std::nullopt);
}

QTEST_GUILESS_MAIN(TestText)
#include "tst_text.moc"
