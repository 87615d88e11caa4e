// What core says of experiments, in German, with its numbers, alone and together; and that a sentence of the lab's
// sources is known here, as far as five words or more of it stand together.
#include "support/places.h"
#include "widgets/lab/text.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>
#include <QtTest>

using widgets::labSentence;
using widgets::labText;

class TestLabText : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void englishStaysAsItIs();
    void theyAreGerman_data();
    void theyAreGerman();
    void everySentenceOfTheSourcesIsKnown();

private:
    QTranslator m_german;
};

namespace {

/// The English of a context, of the file that translators fill.
QStringList sourcesOf(const QString &context)
{
    QFile file(support::sourceFile(QStringLiteral("translations/rotorscope_de.ts")));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QXmlStreamReader xml(&file);
    QStringList all;
    QString in;
    while (!xml.atEnd()) {
        if (!xml.readNextStartElement())
            continue;
        if (xml.name() == QLatin1String("name"))
            in = xml.readElementText();
        else if (xml.name() == QLatin1String("source") && in == context)
            all.append(xml.readElementText());
    }
    return all;
}

/// The string literals of a C++ text, those that stand together as one; no names of files, keys or signals.
QStringList sentencesIn(const QString &code)
{
    static const QRegularExpression literals(
        QStringLiteral("\"(?:[^\"\\\\\\n]|\\\\.)*\"(?:\\s*\"(?:[^\"\\\\\\n]|\\\\.)*\")*"));
    static const QRegularExpression seams(QStringLiteral("\"\\s*\""));
    QStringList all;
    for (auto each = literals.globalMatch(code); each.hasNext();) {
        QString text = each.next().captured().remove(seams).trimmed();
        text = text.mid(1, text.size() - 2).trimmed();
        if (text.count(QLatin1Char(' ')) >= 4)
            all.append(text);
    }
    return all;
}

} // namespace

void TestLabText::initTestCase()
{
    QVERIFY(m_german.load(QStringLiteral(":/i18n/rotorscope_de.qm")));
    QLocale::setDefault(QLocale(QLocale::German));
}

void TestLabText::englishStaysAsItIs()
{
    QLocale::setDefault(QLocale::c());
    for (const char *words : {"no samples came for 0.5 s", "words that nobody knows",
             "the series ended early: the board reports a fault: SPEED_FDBK; the motor has to turn",
             "the motor did not get to its first speed: the board reports a fault: SPEED_FDBK"})
        QCOMPARE(labText(words), QString::fromUtf8(words));
    QLocale::setDefault(QLocale(QLocale::German));
}

void TestLabText::theyAreGerman_data()
{
    QTest::addColumn<QString>("english");
    QTest::addColumn<QString>("german");
    QTest::newRow("numbers") << "no samples came for 0.5 s"
                             << QStringLiteral("0,5 s lang kamen keine Messwerte");
    QTest::newRow("names") << "I_D_REF is not 0, and would be afterwards: bring it to 0 first"
                           << QStringLiteral(
                                  "I_D_REF ist nicht 0 und wäre es nachher: erst auf 0 bringen");
    QTest::newRow("one in another")
        << "the run ended early: the board reports a fault: SPEED_FDBK"
        << QStringLiteral("der Lauf endete vorzeitig: das Board meldet einen Fehler: SPEED_FDBK");
    QTest::newRow("several")
        << "a speed of 654 rpm is below the 660 rpm that are allowed; every motor was told "
           "to stop; the set-point is 880 rpm now, it was 840 rpm"
        << QStringLiteral(
               "eine Drehzahl von 654 rpm liegt unter den erlaubten 660 rpm; jedem Motor "
               "wurde der Stopp befohlen; der Sollwert ist jetzt 880 rpm, er war 840 rpm");
    QTest::newRow("what came after what")
        << "the speed did not come to rest at 900 rpm; then the way back: it was refused; every "
           "motor was told to stop; the set-point is 900 rpm now, it was 840 rpm"
        << QStringLiteral("die Drehzahl kam bei 900 rpm nicht zur Ruhe; danach: der Weg zurück: es "
                          "wurde abgelehnt; jedem Motor wurde der Stopp befohlen; der Sollwert "
                          "ist jetzt 900 rpm, er war 840 rpm");
    QTest::newRow("the same twice")
        << "a step of it: it was refused (BAD_RAW); what was there before: it was refused"
        << QStringLiteral(
               "ein Schritt davon: es wurde abgelehnt (BAD_RAW); was vorher war: es wurde "
               "abgelehnt");
    QTest::newRow("why the drive refused it")
        << "the start: it was refused (SPEED_RAMP is beyond your own limit of 1234.5 rpm); the "
           "motor has to turn"
        << QStringLiteral("der Start: es wurde abgelehnt (SPEED_RAMP ist jenseits Ihrer eigenen "
                          "Grenze von 1234,5 rpm); der Motor muss drehen");
    QTest::newRow("a way back that can be typed")
        << "SPEED_KP may hold what the experiment wrote; what it held before comes back with: "
           "rotorscope-cli set SPEED_KP=500 SPEED_KI=30"
        << QStringLiteral("SPEED_KP enthält vielleicht, was der Versuch geschrieben hat; was "
                          "vorher darin stand, kommt zurück mit: rotorscope-cli set SPEED_KP=500 "
                          "SPEED_KI=30");
    QTest::newRow("three numbers")
        << "keep both speeds at 1284 rpm or above: this motor has no sensor, and a step to 1200 "
           "rpm goes on below the 1200 rpm that are needed to see its rotor"
        << QStringLiteral(
               "beide Drehzahlen bei 1284 rpm oder darüber wählen: dieser Motor hat keinen "
               "Sensor, und ein Sprung auf 1200 rpm geht noch unter die 1200 rpm, die nötig "
               "sind, um seinen Rotor zu sehen");
    QTest::newRow("what a board goes on showing")
        << "SPEED_REF shows 996 rpm until the next start, it showed 1380 rpm"
        << QStringLiteral(
               "SPEED_REF zeigt bis zum nächsten Start 996 rpm, vorher waren es 1380 rpm");
    QTest::newRow("of a session") << "every motor was stopped"
                                  << "jeder Motor wurde gestoppt";
    QTest::newRow("a number between") << "2 of 5 steps do not settle while their speed is held"
                                      << QStringLiteral("2 von 5 Sprüngen regeln nicht aus, "
                                                        "solange ihre Drehzahl gehalten wird");
    QTest::newRow("a list of two")
        << "the mean rise time and overshoot are those of 3 of 4 steps"
        << QStringLiteral("Mittel aus 3 von 4 Sprüngen: Anstiegszeit und "
                          "Überschwingen");
    QTest::newRow("a list of three")
        << "the mean rise time, overshoot and settling time are those of 1 of 2 steps"
        << QStringLiteral(
               "Mittel aus 1 von 2 Sprüngen: Anstiegszeit, Überschwingen und Ausregelzeit");
    QTest::newRow("a list of four")
        << "the mean rise time, overshoot, settling time and peak current are those of 1 of 2 steps"
        << QStringLiteral("Mittel aus 1 von 2 Sprüngen: Anstiegszeit, Überschwingen, Ausregelzeit "
                          "und Spitzenstrom");
    QTest::newRow("words that are not known")
        << "it was refused (BAD_RAW)" << QStringLiteral("es wurde abgelehnt (BAD_RAW)");
}

void TestLabText::theyAreGerman()
{
    QFETCH(QString, english);
    QFETCH(QString, german);
    QCoreApplication::installTranslator(&m_german);
    const QString text = labText(english.toStdString());
    const QString sentence = labSentence(english.toStdString());
    QCoreApplication::removeTranslator(&m_german);
    QCOMPARE(text, german);
    german[0] = german[0].toUpper();
    QCOMPARE(sentence, german + QLatin1Char('.'));
}

/// What is said of a plan's file is of the command line, which speaks English.
void TestLabText::everySentenceOfTheSourcesIsKnown()
{
    const QStringList known = sourcesOf(QStringLiteral("Lab"));
    QVERIFY(known.size() > 100);
    int looked = 0;
    QStringList missing;
    QDirIterator files(support::sourceFile(QStringLiteral("core/lab")),
        {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
        QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        if (file.fileName().endsWith(QLatin1String("plan_file.cpp")))
            continue;
        QString code = QString::fromUtf8(file.readAll());
        code.remove(QRegularExpression(QStringLiteral("//[^\\n]*")));
        for (const QString &sentence : sentencesIn(code)) {
            ++looked;
            if (std::none_of(known.begin(), known.end(),
                    [&](const QString &one) { return one.contains(sentence); }))
                missing.append(sentence);
        }
    }
    QVERIFY(looked > 80);
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
}

QTEST_GUILESS_MAIN(TestLabText)
#include "tst_lab_text.moc"
