// What a board says of itself is shown as text, whatever it says: never rich text, never a place holder, never more
// than one line, never able to hide or reorder what stands beside it.
#include "support/window_rig.h"
#include "widgets/base/device_text.h"
#include "widgets/base/messages.h"

#include <QLabel>

class TestNastyNames : public QObject {
    Q_OBJECT

    static QStringList names()
    {
        QStringList list{
            QStringLiteral("<img src='file:///etc/passwd'>"),
            QStringLiteral("<b>bold</b>"),
            QStringLiteral("<script>alert(1)</script>"),
            QStringLiteral("<a href=\"http://example.org\">x</a>"),
            QStringLiteral("<!-- x -->"),
            QStringLiteral("&lt;&amp;&#8238;"),
            QStringLiteral("%1"),
            QStringLiteral("%2 %1"),
            QStringLiteral("%99"),
            QStringLiteral("%L1"),
            QStringLiteral("%n"),
            QStringLiteral("%s%s%s%n"),
            QStringLiteral("{}"),
            QStringLiteral("$USER"),
            QStringLiteral("`id`"),
            QStringLiteral("../../x"),
            QStringLiteral("=HYPERLINK(\"x\")"),
            QStringLiteral("@SUM(1)"),
            QStringLiteral("+1"),
            QStringLiteral("-1"),
            QStringLiteral("&File"),
            QStringLiteral("a\tb"),
            QStringLiteral("a\nb\nc"),
            QStringLiteral("a\r\nb"),
            QStringLiteral("\a\b\f"),
            QStringLiteral("\u001b[31mred"),
            QStringLiteral("\u202Egnp.exe"),
            QStringLiteral("\u2066x\u2069"),
            QStringLiteral("\u200B"),
            QStringLiteral("\u200Fabc"),
            QStringLiteral("\uFEFFbom"),
            QStringLiteral("\u2028line"),
            QStringLiteral("\u2029paragraph"),
            QStringLiteral("\u00ADsoft"),
            QStringLiteral("e\u0301\u0301\u0301\u0301"),
            QStringLiteral("\uE000private"),
            QStringLiteral("\u0000x"),
            QStringLiteral("\u007F"),
            QStringLiteral("\u0085next"),
            QStringLiteral(" "),
            QString(),
            QStringLiteral("日本語のモーター"),
            QStringLiteral("мотор"),
            QStringLiteral("محرك"),
            QStringLiteral("🙂🙂🙂"),
            QString(64, QLatin1Char('x')),
            QString(65, QLatin1Char('x')),
            QString(5000, QLatin1Char('W')),
            QString(200, QLatin1Char('\n')),
            QString(90, QChar(0x202E)),
        };
        return list;
    }

private Q_SLOTS:
    void thereAreFiftyOfThem() { QCOMPARE(names().size(), 50); }

    void aDevicesTextIsOneBoundedLineWithoutHiddenCharacters()
    {
        for (const QString &name : names()) {
            const QString shown = widgets::deviceText(name.toStdString());
            QVERIFY(shown.size() <= widgets::kDeviceTextLength);
            for (const QChar c : shown) {
                QVERIFY(c.category() != QChar::Other_Control);
                QVERIFY(c.category() != QChar::Other_Format);
                QVERIFY(c.category() != QChar::Separator_Line);
                QVERIFY(c.category() != QChar::Separator_Paragraph);
            }
        }
    }

    void invalidUtf8IsReplaced()
    {
        QCOMPARE(widgets::deviceText(std::string_view("a\xff\xfe b")),
            QStringLiteral("a\uFFFD\uFFFD b"));
    }

    void placeHoldersStayWhatTheyAre()
    {
        drive::Ended ended;
        ended.outcome = drive::Outcome::Refused;
        ended.reason = "%1 %2 %3";
        const QString sentence = widgets::failureText(QStringLiteral("Start"), ended);
        QVERIFY2(sentence.contains(QStringLiteral("(%1 %2 %3)")), qPrintable(sentence));
        ended.reason = "%1 is beyond your own limit of 9 rpm";
        const QString known = widgets::failureText(QStringLiteral("Start"), ended);
        QVERIFY2(known.contains(QString::fromStdString(ended.reason)), qPrintable(known));
        session::PortError error;
        error.problem = session::PortProblem::Busy;
        error.detail = QStringLiteral("%1");
        QVERIFY(widgets::portProblemText(error, QStringLiteral("%2"))
                    .startsWith(QStringLiteral("%2 is in use (%1)")));
    }

    void everyLabelOfTheWindowIsPlainText()
    {
        facts::WindowRig rig;
        for (const QString &name : names()) {
            const std::string text = name.toStdString();
            drive::Identified board = facts::identified();
            board.identity.firmware = text;
            board.identity.version = text;
            board.identity.controlBoard = text;
            board.identity.powerBoards = {text};
            board.identity.motorNames = {text};
            board.identity.protocol = text;
            board.capabilities = {{drive::Feature::Start, false, text}};
            drive::MotorStatus status = facts::status(drive::MotorState::Starting);
            status.stateName = text;
            status.faultsNow = {text};
            status.faultsPast = {text};
            rig.workbench.device().portChanged(session::PortState::Open, {});
            facts::feed(rig.workbench.device(),
                {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None}, board,
                    status, drive::RegistersRead{{facts::reading(facts::kName, text)}}});
            checkLabels(rig.window);
            const QString shown = widgets::deviceText(text);
            QVERIFY(rig.find<QLabel>("motorState")->text().contains(shown));
            QVERIFY(rig.find<QLabel>("firmware")->text().contains(shown));
            const auto cell = rig.workbench.registers().indexOf(
                facts::kName, widgets::RegisterModel::ValueColumn);
            QCOMPARE(cell.data().toString(), shown);
        }
        rig.workbench.device().portChanged(session::PortState::Closed, {});
    }

private:
    static void checkLabels(const QWidget &window)
    {
        for (const QLabel *label : window.findChildren<QLabel *>()) {
            const bool fixed = label->buddy() || label->text().isEmpty();
            QVERIFY2(label->textFormat() == Qt::PlainText || fixed
                    || !Qt::mightBeRichText(label->text()),
                qPrintable(label->text()));
        }
        for (const QWidget *widget : window.findChildren<QWidget *>())
            QVERIFY2(!widget->toolTip().contains(QLatin1String("<img"))
                    && !widget->toolTip().contains(QLatin1String("<script")),
                qPrintable(widget->objectName() + QStringLiteral(": ") + widget->toolTip()));
    }
};

QTEST_MAIN(TestNastyNames)
#include "tst_nasty_names.moc"
