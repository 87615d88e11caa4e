// What a terminal is given of text from elsewhere.
#include "base/terminal_text.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

namespace {

/// Every character that a terminal obeys or that is drawn elsewhere than it stands.
QList<char16_t> dangerous()
{
    QList<char16_t> all;
    for (char16_t code = 0; code < 0xFFFF; ++code) {
        const auto category = QChar(code).category();
        const bool arabicSign = (code >= 0x600 && code <= 0x605) || code == 0x6DD || code == 0x70F
            || code == 0x890 || code == 0x891 || code == 0x8E2; // drawn, and where they stand
        if (category == QChar::Other_Control || category == QChar::Separator_Line
            || category == QChar::Separator_Paragraph
            || (category == QChar::Other_Format && !arabicSign))
            all.append(code);
    }
    return all;
}

} // namespace

class TestTerminalText : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatPeopleReadStays()
    {
        for (const char *text : {"", "STATUS = RUN (6)", "Drehzahl °C ±5 µs", "電動機 1",
                 "\xF0\x9F\x9B\x91 stop", "a\\u001b\"b"})
            QCOMPARE(terminalText(text), std::string(text));
    }

    void nothingReachesTheTerminalThatItObeys()
    {
        QVERIFY(dangerous().size() > 90);
        for (const char16_t code : dangerous()) {
            const QByteArray text = "a" + QString(QChar(code)).toUtf8() + "b";
            const QString shown = QString::fromStdString(
                terminalText({text.constData(), static_cast<std::size_t>(text.size())}));
            QCOMPARE(shown.size(), 3);
            QVERIFY2(shown.at(1) == QLatin1Char(' ') || shown.at(1) == QChar::ReplacementCharacter,
                qPrintable(QString::number(code, 16)));
        }
    }

    void bytesThatAreNoTextAreMarked()
    {
        using namespace std::string_literals;
        const std::string mark = "\xEF\xBF\xBD";
        QCOMPARE(terminalText("a\x9B"s + "31m"), "a" + mark + "31m"); // CSI in eight bits
        QCOMPARE(terminalText("\xC2"s), mark); // breaks off
        QCOMPARE(terminalText("\xC0\x9B"s), mark + mark); // a longer form of ESC
        QCOMPARE(terminalText("\xE0\x82\x9B"s), mark + mark + mark);
        QCOMPARE(terminalText("\xED\xA0\x80"s), mark + mark + mark); // half of a pair
        QCOMPARE(terminalText("\xF8\x88\x80\x80\x80"s).size(), 5 * mark.size());
    }

    void jsonStaysTheSameJson()
    {
        QString nasty;
        for (const char16_t code : dangerous())
            nasty += QString(QChar(code)) + QLatin1Char('x');
        nasty += QString::fromUtf8("\"\\ \xF3\xA0\x81\x81 ü");
        const QJsonArray array{nasty, 1.5, QJsonValue()};
        for (const auto form : {QJsonDocument::Compact, QJsonDocument::Indented}) {
            const QByteArray json = QJsonDocument(array).toJson(form);
            const std::string harmless =
                terminalJson({json.constData(), static_cast<std::size_t>(json.size())});
            QCOMPARE(QJsonDocument::fromJson(QByteArray::fromStdString(harmless)).array(), array);
            QCOMPARE(terminalText(harmless), harmless);
        }
    }
};

QTEST_APPLESS_MAIN(TestTerminalText)
#include "tst_terminal_text.moc"
