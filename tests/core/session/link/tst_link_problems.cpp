// Why a link or a port ended, as the command line says it and the window translates it.
#include "session/link/problems.h"

#include <QSet>
#include <QtTest>

using namespace session;
using drive::LinkReason;

class TestLinkProblems : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachHasItsOwnSentence();
    void aPortProblemNamesThePortAndTheDetail();
};

// Of the first and the last of each table, too: they are in the order of their enumerations.
void TestLinkProblems::eachHasItsOwnSentence()
{
    QCOMPARE(linkProblemText(LinkReason::None), QString());
    QCOMPARE(portErrorText({}, QStringLiteral("x")), QString());
    QVERIFY(linkProblemText(LinkReason::NoAnswer).contains(QStringLiteral("no board answers")));
    QVERIFY(linkProblemText(LinkReason::BoardReset).contains(QStringLiteral("was reset")));
    QVERIFY(linkProblemText(LinkReason::DeadLine).contains(QStringLiteral("drives the line")));
    QVERIFY(linkProblemText(LinkReason::OtherProtocol).contains(QStringLiteral("newer firmware")));
    QSet<QString> all;
    for (int at = 1; at <= int(LinkReason::OtherProtocol); ++at)
        all.insert(linkProblemText(static_cast<LinkReason>(at)));
    for (int at = 1; at <= int(PortProblem::Other); ++at)
        all.insert(portErrorText({static_cast<PortProblem>(at), {}}, QStringLiteral("x")));
    QCOMPARE(all.size(), int(LinkReason::OtherProtocol) + int(PortProblem::Other));
    for (const QString &sentence : all)
        QVERIFY2(sentence.endsWith(QLatin1Char('.')), qPrintable(sentence));
}

void TestLinkProblems::aPortProblemNamesThePortAndTheDetail()
{
    const QString port = QStringLiteral("%2");
    const PortError busy{PortProblem::Busy, QStringLiteral("%1")};
    QVERIFY(portErrorText(busy, port).startsWith(QStringLiteral("%2 is in use (%1). ")));
    QVERIFY(portErrorText({PortProblem::Other, {}}, port)
                .startsWith(QStringLiteral("%2 cannot be opened. ")));
    // Devices of SPI belong to another group than serial ports.
    QVERIFY(portErrorText({PortProblem::NoPermission, {}}, port)
                .startsWith(QStringLiteral("You may not use %2. Join the group that owns it ")));
    const auto shouted = [](const char *english) { return QString::fromUtf8(english).toUpper(); };
    QCOMPARE(portErrorText({PortProblem::Unplugged, QStringLiteral("gone")}, port, shouted),
        QStringLiteral("%2 WAS UNPLUGGED. CHECK THE CABLE."));
}

QTEST_GUILESS_MAIN(TestLinkProblems)
#include "tst_link_problems.moc"
