// The translations as files: complete, with the same place holders as their sources, and inside the program.
// Looks at translations/*.ts in the source folder, never at the wording.
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTranslator>
#include <QXmlStreamReader>

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

QList<Message> readMessages(const QString &language)
{
    QFile file(QStringLiteral(ROTORSCOPE_SOURCE "/translations/rotorscope_%1.ts").arg(language));
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
    const QRegularExpression mnemonic(QStringLiteral("&(?!&)[^ ]"));
    if (source.contains(mnemonic) != translation.contains(mnemonic))
        return QStringLiteral("a mnemonic on one side only");
    for (const auto end : {u'…', u':', u'.', u' ', u'\n'}) {
        if (source.endsWith(end) != translation.endsWith(end))
            return QStringLiteral("another ending");
    }
    return {};
}

} // namespace

class TestTranslations : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void germanIsCompleteAndKeepsPlaceHolders();
    void everyGroupOfRegistersIsTranslated();
    void englishHasItsPlurals();
    void theProgramHoldsThem_data();
    void theProgramHoldsThem();
};

void TestTranslations::germanIsCompleteAndKeepsPlaceHolders()
{
    const auto messages = readMessages(QStringLiteral("de"));
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

void TestTranslations::everyGroupOfRegistersIsTranslated()
{
    QSet<QString> known;
    for (const Message &message : readMessages(QStringLiteral("de"))) {
        if (message.context == QLatin1String("RegisterGroups"))
            known.insert(message.source);
    }
    const QDir folder(QStringLiteral(ROTORSCOPE_SOURCE "/resources/registers"));
    int registers = 0;
    for (const QString &name : folder.entryList({QStringLiteral("*.csv")})) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const auto lines = QString::fromUtf8(file.readAll()).split(u'\n', Qt::SkipEmptyParts);
        const auto column = lines.first().split(u',').indexOf(QLatin1String("group"));
        if (name == QLatin1String("mcb.csv")) { // its source knows no groups
            QCOMPARE(column, -1);
            continue;
        }
        QVERIFY(column > 0); // no column before it holds a quoted comma
        for (const QString &line : lines.mid(1)) {
            const QString group = line.split(u',').value(column);
            QVERIFY2(known.contains(group), qPrintable(line));
            ++registers;
        }
    }
    QVERIFY(registers > 300);
}

void TestTranslations::englishHasItsPlurals()
{
    QStringList flaws;
    for (const Message &message : readMessages(QStringLiteral("en"))) {
        if (message.plural && (!message.finished || message.translations.size() != 2))
            flaws << message.source;
    }
    QVERIFY2(flaws.isEmpty(), qPrintable(flaws.join(u'\n')));
}

void TestTranslations::theProgramHoldsThem_data()
{
    QTest::addColumn<QString>("file");
    QTest::newRow("German") << QStringLiteral(":/i18n/rotorscope_de.qm");
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
