// The list of ports: its order and its marks, whatever the system says.
#include "session/transports/port_list.h"

#include <QtTest>

using session::PortChoice;

class TestPortList : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theSimulatedBoardIsFirstThenStLinksThenOthers();
    void titlesAreTheDevicesWordsWithoutRepetition();
    void onlyStLinksWithAPortAreMarked();
};

namespace {
struct FakeSource : session::PortSource {
    QList<session::SystemPort> list;
    QList<session::SystemPort> ports() const override { return list; }
};
} // namespace

void TestPortList::theSimulatedBoardIsFirstThenStLinksThenOthers()
{
    FakeSource source;
    source.list = {{QStringLiteral("/dev/ttyUSB0"), {}, {}, {}, 0x0403, 0x6001},
        {QStringLiteral("/dev/ttyACM1"), {}, {}, {}, 0x0483, 0x374B},
        {QStringLiteral("/dev/ttyACM0"), {}, {}, {}, 0x0483, 0x3753}};
    QStringList paths;
    for (const PortChoice &choice : session::portChoices(source))
        paths.append(choice.path);
    QCOMPARE(paths,
        QStringList(
            {QStringLiteral("sim"), QStringLiteral("sim:legacy"), QStringLiteral("sim:powerpc"),
                QStringLiteral("sim:mcb"), QStringLiteral("/dev/ttyACM0"),
                QStringLiteral("/dev/ttyACM1"), QStringLiteral("/dev/ttyUSB0")}));
}

void TestPortList::titlesAreTheDevicesWordsWithoutRepetition()
{
    FakeSource source;
    source.list = {{QStringLiteral("/dev/ttyACM0"), QStringLiteral("STLINK-V3"),
        QStringLiteral("ST"), QStringLiteral("ST"), 0, 0}};
    QCOMPARE(session::portChoices(source).back().title, QStringLiteral("ST STLINK-V3"));
}

void TestPortList::onlyStLinksWithAPortAreMarked()
{
    QVERIFY(session::isStLink(0x0483, 0x374E));
    QVERIFY(!session::isStLink(0x0483, 0x3748)); // V2: no port
    QVERIFY(!session::isStLink(0x0483, 0x5740)); // ST's own USB device, not a debugger
    QVERIFY(!session::isStLink(0x1234, 0x374E));
}

QTEST_APPLESS_MAIN(TestPortList)
#include "tst_port_list.moc"
