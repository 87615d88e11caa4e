// What core says of experiments, in German, with its numbers, alone and together; and that its sentences and those that
// the window knows are the same. They are looked for in the sources, as what stands in quotes there: a sentence is put
// together from it and from numbers and names.
#include "support/places.h"
#include "widgets/base/messages.h"
#include "widgets/lab/text.h"

#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>
#include <QTranslator>
#include <QtTest>

#include <algorithm>
#include <vector>

using widgets::labSentence;
using widgets::labText;

class TestLabText : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase();
    void englishStaysAsItIs();
    void theyAreGerman_data();
    void theyAreGerman();
    void coreAndTheWindowHaveTheSameSentences_data();
    void coreAndTheWindowHaveTheSameSentences();
    void eachIsFoundByItsOwnWords();

private:
    QTranslator m_german;
};

namespace {

const QString kLab = QStringLiteral("widgets/lab/text.cpp");
const QString kDrive = QStringLiteral("widgets/base/messages.cpp");

/// String literals that stand together.
const QString kLiterals =
    QStringLiteral("\"(?:[^\"\\\\\\n]|\\\\.)*\"(?:\\s*\"(?:[^\"\\\\\\n]|\\\\.)*\")*");

/// What they say.
QString saidBy(QString literals)
{
    static const QRegularExpression seams(QStringLiteral("\"\\s*\""));
    literals.remove(seams).replace(QLatin1String("\\u00b0"), QStringLiteral("\u00b0"));
    return literals.mid(1, literals.size() - 2);
}

/// Of a file, without its comments.
QString codeOf(const QString &path)
{
    static const QRegularExpression comments(QStringLiteral("//[^\\n]*"));
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).remove(comments)
                                          : QString();
}

/// What stands in quotes in these folders and files. Of a plan's file the command line alone speaks, in English.
QSet<QString> quotedIn(const QStringList &places)
{
    static const QRegularExpression literals(kLiterals);
    QStringList codes;
    for (const QString &place : places) {
        const QString path = support::sourceFile(place);
        if (!QFileInfo(path).isDir())
            codes.append(codeOf(path));
        QDirIterator files(path, {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
            QDirIterator::Subdirectories);
        while (files.hasNext())
            if (const QString file = files.next(); !file.endsWith(QLatin1String("plan_file.cpp")))
                codes.append(codeOf(file));
    }
    QSet<QString> all;
    for (const QString &code : std::as_const(codes))
        for (auto each = literals.globalMatch(code); each.hasNext();)
            all.insert(saidBy(each.next().captured()));
    return all;
}

/// The sentences that a table of the window has, in its order.
QStringList entriesOf(const QString &table)
{
    const QRegularExpression entry(
        QStringLiteral("QT_TRANSLATE_NOOP\\(\\s*\"\\w+\",\\s*(%1)\\)").arg(kLiterals));
    const QString code = codeOf(support::sourceFile(table));
    QStringList all;
    for (auto each = entry.globalMatch(code); each.hasNext();)
        all.append(saidBy(each.next().captured(1)));
    return all;
}

/// Those of the pieces that the sentence can be put together from, with its place holders between; empty: it cannot be.
QSet<QString> partsOf(const QString &sentence, const QSet<QString> &pieces)
{
    struct Step {
        qsizetype from, to;
        QString piece;
    };
    std::vector<Step> steps;
    for (qsizetype at = 0; at < sentence.size(); ++at) {
        const QString rest = sentence.mid(at);
        if (rest.size() > 1 && rest[0] == u'%' && rest[1].isDigit())
            steps.push_back({at, at + 2, {}});
        for (const QString &piece : pieces)
            if (rest.startsWith(piece))
                steps.push_back({at, at + piece.size(), piece});
    }
    QSet<qsizetype> reached{0}, leadOn{sentence.size()};
    for (const Step &step : steps)
        if (reached.contains(step.from))
            reached.insert(step.to);
    for (auto step = steps.rbegin(); step != steps.rend(); ++step)
        if (leadOn.contains(step->to))
            leadOn.insert(step->from);
    QSet<QString> parts;
    for (const Step &step : steps)
        if (reached.contains(step.from) && leadOn.contains(step.to))
            parts.insert(step.piece);
    return parts;
}

/// Sentences stand alone or with others.
QStringList partedAtSemicolons(const QString &text)
{
    return text.split(QStringLiteral("; "), Qt::SkipEmptyParts);
}

/// Three words, or one that goes on; else it is a key, a unit or part of a list.
bool isSentence(const QString &text)
{
    static const QRegularExpression word(QStringLiteral("[a-z]{2}"));
    const QString trimmed = text.trimmed();
    return trimmed.count(u' ') >= 2 || (trimmed != text && text.contains(word));
}

/// With 1.5 for %1, 2.5 for %2.
QString withNumbers(QString text, QChar point)
{
    for (int place = 1; place < 10; ++place)
        text.replace(QStringLiteral("%%1").arg(place), QString::number(place) + point + u'5');
    return text;
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
    QTest::newRow("what another program left")
        << "An experiment was cut off before it gave back what it had borrowed: SPEED_KP may hold "
           "what the experiment wrote; what it held before comes back with: rotorscope-cli set "
           "SPEED_KP=500"
        << QStringLiteral("Ein Versuch wurde abgebrochen, bevor er zurückgab, was er geliehen "
                          "hatte: SPEED_KP enthält vielleicht, was der Versuch geschrieben hat; "
                          "was vorher darin stand, kommt zurück mit: rotorscope-cli set "
                          "SPEED_KP=500");
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

void TestLabText::coreAndTheWindowHaveTheSameSentences_data()
{
    QTest::addColumn<QString>("table");
    QTest::addColumn<QStringList>("speakers"); // the window knows all that they say
    QTest::addColumn<QStringList>("others"); // and some of what these say
    QTest::addColumn<QStringList>("unknown"); // but for this
    // What recordings call their fields, plans and signals.
    QTest::newRow("the lab")
        << kLab << QStringList{QStringLiteral("core/lab")}
        << QStringList{QStringLiteral("core/session/link/session.cpp"),
               QStringLiteral("core/drive/wish.h"), QStringLiteral("widgets/lab/experiments.cpp")}
        << QStringList{QStringLiteral(", is "), QStringLiteral(", was "),
               QStringLiteral("Lq less Ld H"), QStringLiteral("current step plan"),
               QStringLiteral("dead time V"), QStringLiteral("integral A per rpm"),
               QStringLiteral("jump A per rpm"), QStringLiteral("proportional A per rpm"),
               QStringLiteral("position from the angle"), QStringLiteral("speed from the angle"),
               QStringLiteral("speed step rpm"), QStringLiteral("torque Nm per A")};
    // What the window does not ask for, or asks about before. What a protocol says of its registers is its own word.
    QStringList acts;
    for (const char *file : {"act_task.h", "set_point_check.cpp", "start_target.cpp",
             "task_drive.h", "wish.h", "wish_drive.cpp", "wish_queue.h"})
        acts.append(QStringLiteral("core/drive/") + QLatin1String(file));
    QTest::newRow("why a drive refuses an act")
        << kDrive << acts
        << QStringList{QStringLiteral("core/drive"),
               QStringLiteral("core/session/link/session.cpp")}
        << QStringList{QStringLiteral(" ms"), QStringLiteral(" of motor "),
               QStringLiteral("; to move it all the same takes "),
               QStringLiteral("a move lasts 1 to 65535 ms"), QStringLiteral("a ramp lasts 0 to "),
               QStringLiteral("an angle is at most 10000 rad"),
               QStringLiteral("every limit of this motor is known"), QStringLiteral("is not there"),
               QStringLiteral("no full-scale current is like that"),
               QStringLiteral("no limit is like that"),
               QStringLiteral("the board does not tell the "), QStringLiteral("there is no motor "),
               QStringLiteral("there is no such motor")};
}

/// Else the window would show one in English, or translate one that nobody says any more.
void TestLabText::coreAndTheWindowHaveTheSameSentences()
{
    QFETCH(const QString, table);
    QFETCH(const QStringList, speakers);
    QFETCH(const QStringList, others);
    QFETCH(QStringList, unknown);
    QSet<QString> pieces{QStringLiteral(" ")};
    for (const QString &quoted : quotedIn(speakers + others)) {
        pieces.insert(quoted);
        for (const QString &part : partedAtSemicolons(quoted))
            pieces.insert(part);
    }
    pieces.remove(QString());
    QSet<QString> used;
    QStringList unsaid, untranslated;
    for (const QString &entry : entriesOf(table)) {
        const QSet<QString> parts = partsOf(entry, pieces);
        if (parts.isEmpty())
            unsaid.append(entry);
        used.unite(parts);
    }
    QVERIFY2(unsaid.isEmpty(), qPrintable(unsaid.join(u'\n')));
    for (const QString &quoted : quotedIn(speakers)) {
        const QStringList parts = partedAtSemicolons(quoted);
        const bool known = used.contains(quoted)
            || std::all_of(parts.begin(), parts.end(),
                [&](const QString &part) { return used.contains(part); });
        if (isSentence(quoted) && !known)
            untranslated.append(quoted);
    }
    untranslated.sort();
    unknown.sort();
    QCOMPARE(untranslated.join(u'\n'), unknown.join(u'\n'));
}

/// None stands in the way of one behind it.
void TestLabText::eachIsFoundByItsOwnWords()
{
    QCoreApplication::installTranslator(&m_german);
    QStringList wrong;
    for (const QString &table : {kLab, kDrive})
        for (const QString &entry : entriesOf(table)) {
            const QString said = withNumbers(entry, u'.');
            const QString shown = table == kLab ? labText(said.toStdString())
                                                : widgets::reasonText(said).value_or(QString());
            const QString wanted = QCoreApplication::translate(
                table == kLab ? "Lab" : "Messages", entry.toUtf8().constData());
            if (shown != withNumbers(wanted, u','))
                wrong.append(shown);
        }
    QCoreApplication::removeTranslator(&m_german);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

QTEST_GUILESS_MAIN(TestLabText)
#include "tst_lab_text.moc"
