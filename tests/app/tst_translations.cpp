// The translations as files: complete, with the same place holders as their sources, and inside the program.
// Looks at translations/*.ts in the source folder, never at the wording.
#include "catalog/catalog.h"
#include "catalog/csv.h"
#include "catalog/names.h"
#include "support/places.h"

#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

#include <algorithm>

namespace {

struct Message {
    QString context;
    QString source;
    QStringList translations; ///< one, or one a plural form
    bool plural = false;
    bool finished = true;
};

/// Reads `<translation>`: plain text, or `<numerusform>`s.
void readTranslation(QXmlStreamReader &xml, Message &message)
{
    message.finished = xml.attributes().value(QLatin1String("type")).isEmpty();
    QString text;
    while (!(xml.readNext() == QXmlStreamReader::EndElement
               && xml.name() == QLatin1String("translation"))
        && !xml.atEnd()) {
        if (xml.isCharacters())
            text += xml.text();
        else if (xml.isStartElement() && xml.name() == QLatin1String("numerusform"))
            message.translations << xml.readElementText();
    }
    if (!message.plural)
        message.translations << text;
}

QList<Message> readMessages(const QString &name)
{
    QFile file(support::sourceFile(QStringLiteral("translations/%1.ts")).arg(name));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == QLatin1String("name"))
            context = xml.readElementText();
        else if (xml.name() == QLatin1String("message"))
            messages.append(
                {context, {}, {}, xml.attributes().hasAttribute(QLatin1String("numerus")), true});
        else if (xml.name() == QLatin1String("source"))
            messages.last().source = xml.readElementText();
        else if (xml.name() == QLatin1String("translation"))
            readTranslation(xml, messages.last());
    }
    return xml.hasError() ? QList<Message>() : messages;
}

/// All that matches, sorted, each once.
QStringList found(const QString &text, const QString &pattern)
{
    QStringList matches;
    auto match = QRegularExpression(pattern).globalMatch(text);
    while (match.hasNext())
        matches << match.next().captured();
    matches.sort();
    matches.removeDuplicates();
    return matches;
}

/// What is wrong with one translation of a message; empty if nothing is.
QString flaw(const Message &message, const QString &translation)
{
    const QString &source = message.source;
    if (translation.isEmpty())
        return QStringLiteral("empty");
    const QString numbers = QStringLiteral("%L?[1-9]");
    if (found(source, numbers) != found(translation, numbers))
        return QStringLiteral("other place holders");
    const QString tags = QStringLiteral("</?[a-zA-Z][^>]*>");
    if (found(source, tags) != found(translation, tags))
        return QStringLiteral("other tags");
    const QString names = QStringLiteral("\\b[A-Z][A-Z0-9]*_[A-Z0-9_]+\\b");
    if (found(source, names) != found(translation, names))
        return QStringLiteral("other names of registers");
    const QString digits = QStringLiteral("\\d+");
    if (message.context == QLatin1String("RegisterHelp")
        && found(source, digits) != found(translation, digits))
        return QStringLiteral("other numbers");
    const QRegularExpression mnemonic(QStringLiteral("&(?!&)[^ ]"));
    if (source.contains(mnemonic) != translation.contains(mnemonic))
        return QStringLiteral("a mnemonic on one side only");
    for (const auto end : {u'…', u':', u'.', u' ', u'\n'}) {
        if (source.endsWith(end) != translation.endsWith(end))
            return QStringLiteral("another ending");
    }
    return {};
}

/// Not the firmware's own word, which is all in capitals, nor the number of a bit.
bool isWord(const QString &name)
{
    return name != name.toUpper() && !name.startsWith(QLatin1String("bit "));
}

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void germanIsCompleteAndKeepsPlaceHolders_data();
    void germanIsCompleteAndKeepsPlaceHolders();
    void everyTextOfTheRegisterTablesIsTranslated_data();
    void everyTextOfTheRegisterTablesIsTranslated();
    void everyNameOfAValueIsTranslatedAndMeansOneValue();
    void everyNameInAStructureIsTranslated();
    void englishHasItsPlurals();
    void theProgramHoldsThem_data();
    void theProgramHoldsThem();
};

void TestTranslations::germanIsCompleteAndKeepsPlaceHolders_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("window") << QStringLiteral("rotorscope_de");
    QTest::newRow("registers") << QStringLiteral("registers_de");
}

void TestTranslations::germanIsCompleteAndKeepsPlaceHolders()
{
    QFETCH(QString, file);
    const auto messages = readMessages(file);
    QVERIFY(!messages.isEmpty());
    QStringList flaws;
    for (const Message &message : messages) {
        if (!message.finished)
            flaws << QStringLiteral("unfinished: %1 / %2").arg(message.context, message.source);
        if (message.plural && message.translations.size() != 2)
            flaws << QStringLiteral("needs two forms: %1").arg(message.source);
        for (const QString &translation : message.translations) {
            const QString what = flaw(message, translation);
            if (message.finished && !what.isEmpty())
                flaws << QStringLiteral("%1: %2 / %3").arg(what, message.context, message.source);
        }
    }
    QVERIFY2(flaws.isEmpty(), qPrintable(flaws.join(u'\n')));
}

void TestTranslations::everyTextOfTheRegisterTablesIsTranslated_data()
{
    QTest::addColumn<QByteArray>("table");
    QTest::addColumn<QByteArray>("column");
    QTest::addColumn<QByteArray>("context");
    for (const char *name : {"mcp", "legacy", "mcb"})
        QTest::addRow("%s: what a register is", name)
            << QByteArray(name) << QByteArray("description") << QByteArray("RegisterHelp");
    for (const char *name : {"mcp", "legacy"}) // the source of the third knows no groups
        QTest::addRow("%s: groups", name)
            << QByteArray(name) << QByteArray("group") << QByteArray("RegisterGroups");
}

// As the program asks for it: by the text that core read, from the file that is built in.
void TestTranslations::everyTextOfTheRegisterTablesIsTranslated()
{
    QFETCH(QByteArray, table);
    QFETCH(QByteArray, column);
    QFETCH(QByteArray, context);
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/i18n/registers_de.qm")));
    const auto rows = catalog::readCsv(catalog::builtInTable(table.toStdString()));
    QVERIFY(rows && rows->size() > 100);
    const auto &names = rows->front().fields;
    const auto at = std::find(names.begin(), names.end(), column.toStdString());
    QVERIFY(at != names.end());
    const auto field = static_cast<std::size_t>(at - names.begin());
    QStringList missing;
    for (std::size_t row = 1; row < rows->size(); ++row) {
        const std::string &text = (*rows)[row].fields.at(field);
        QVERIFY(!text.empty());
        if (translator.translate(context.constData(), text.c_str()).isEmpty())
            missing << QString::fromStdString(text);
    }
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
}

// Names are typed, too: one that meant a second value could move a motor otherwise than was asked.
void TestTranslations::everyNameOfAValueIsTranslatedAndMeansOneValue()
{
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/i18n/registers_de.qm")));
    const auto rows = catalog::readCsv(catalog::builtInTable("mcp"));
    QVERIFY(rows && rows->front().fields.at(1) == "name");
    int named = 0;
    for (const catalog::CsvRow &row : *rows) {
        const std::string &name = row.fields.at(1);
        const bool flags = !catalog::namedFlags(name).empty();
        QMap<QString, std::int64_t> meanings;
        for (const auto &value : flags ? catalog::namedFlags(name) : catalog::namedValues(name)) {
            const QByteArray english(value.name.data(), qsizetype(value.name.size()));
            QStringList words{QString::fromLatin1(english)};
            if (isWord(words.first()))
                words << translator.translate("RegisterValues", english.constData());
            for (const QString &word : words) {
                QVERIFY2(!word.isEmpty(), english.constData());
                QVERIFY2(!flags || !word.contains(QRegularExpression(QStringLiteral("[,|+;]"))),
                    qPrintable(word)); // they stand between flags
                const std::int64_t first = meanings.value(word.toLower(), value.value);
                QVERIFY2(first == value.value, qPrintable(word));
                meanings.insert(word.toLower(), value.value);
            }
            ++named;
        }
    }
    QVERIFY(named > 50);
}

void TestTranslations::everyNameInAStructureIsTranslated()
{
    QTranslator translator;
    QVERIFY(translator.load(QStringLiteral(":/i18n/registers_de.qm")));
    std::vector<std::string> names = catalog::flagNames("flags 1", 0xFFFF);
    const auto append = [&names](const std::vector<std::string> &more) {
        names.insert(names.end(), more.begin(), more.end());
    };
    append(catalog::flagNames("flags 2", 0xFFFF));
    append(catalog::flagNames("flags", 0xFF));
    for (std::uint8_t number = 0; number < 16; ++number)
        for (const char *key : {"drive type", "primary sensor", "topology", "drive mode"})
            append({catalog::valueName(key, number)});
    int words = 0;
    for (const std::string &name : names) {
        const QString text = QString::fromStdString(name);
        if (!isWord(text))
            continue;
        QVERIFY2(!translator.translate("RegisterValues", name.c_str()).isEmpty(), qPrintable(text));
        ++words;
    }
    QVERIFY(words > 30);
}

void TestTranslations::englishHasItsPlurals()
{
    QStringList flaws;
    for (const Message &message : readMessages(QStringLiteral("rotorscope_en"))) {
        if (message.plural && (!message.finished || message.translations.size() != 2))
            flaws << message.source;
    }
    QVERIFY2(flaws.isEmpty(), qPrintable(flaws.join(u'\n')));
}

void TestTranslations::theProgramHoldsThem_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("German") << QStringLiteral(":/i18n/rotorscope_de.qm");
    QTest::newRow("German of registers") << QStringLiteral(":/i18n/registers_de.qm");
    QTest::newRow("English") << QStringLiteral(":/i18n/rotorscope_en.qm");
}

void TestTranslations::theProgramHoldsThem()
{
    QFETCH(QString, file);
    QTranslator translator;
    QVERIFY(translator.load(file));
}

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
