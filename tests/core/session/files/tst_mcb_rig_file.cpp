// Rig files of the MCB slave: what is read, and that what is wrong is named.
#include "session/files/mcb_rig_file.h"

#include <QTest>

using namespace session;

class TestMcbRigFile : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRigIsRead();
    void whatIsWrongIsNamed_data();
    void whatIsWrongIsNamed();
    void aFileThatIsNotThereIsAnError();
};

void TestMcbRigFile::aRigIsRead()
{
    const auto rig = readMcbRig(R"({"protocol": "mcb", "reply_delay": 3, "colour": "red",
        "registers": {"0x010": {"type": "UINT16", "size": 2, "cyclic": "rx", "access": "rw", "words": ["002a"]},
                      "0x7FF": {"type": "STRING", "size": 5, "cyclic": "config", "access": "r", "words": ["302E"]}}})");
    QVERIFY(rig.has_value());
    QCOMPARE(rig->replyDelay, 3);
    QCOMPARE(rig->registers.size(), 2U);
    const simulation::McbRegister control{
        {2, mcb::Type::UInt16, mcb::Cyclic::Rx, catalog::Access::ReadWrite}, {0x2A}};
    const simulation::McbRegister text{
        {5, mcb::Type::Text, mcb::Cyclic::ConfigOnly, catalog::Access::Read}, {0x302E, 0, 0}};
    QVERIFY(rig->registers.at(0x010) == control);
    QVERIFY(rig->registers.at(0x7FF) == text);
    const auto prompt = readMcbRig(R"({"protocol": "mcb", "registers": {}})");
    QCOMPARE(prompt->replyDelay, 0);
}

void TestMcbRigFile::whatIsWrongIsNamed_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("named");
    const auto row = [](const char *name, const char *from, const char *to, const char *named) {
        QTest::newRow(name) << QByteArray(from) << QByteArray(to) << QString::fromLatin1(named);
    };
    row("no JSON", "{", "", "JSON");
    row("another protocol", "mcb", "legacy", "protocol");
    row("negative delay", ": 1,", ": -1,", "reply_delay");
    row("half a frame", ": 1,", ": 1.5,", "reply_delay");
    row("endless delay", ": 1,", ": 1e9,", "reply_delay");
    row("no registers", "registers", "other", "registers");
    row("address beyond the last", "0x010", "0x800", "0x800");
    row("address without 0x", "0x010", "010", "\"010\"");
    row("unknown type", "UINT16", "UINT8", "registers.0x010: type");
    row("no size", "\"size\": 2", "\"size\": 0", "registers.0x010: size");
    row("too large", "\"size\": 2", "\"size\": 256", "registers.0x010: size");
    row("unknown direction", "\"rx\"", "\"up\"", "registers.0x010: cyclic");
    row("unknown access", "\"rw\"", "\"x\"", "registers.0x010: access");
    row("too many words", "[\"0001\"]", "[\"0001\", \"0002\"]", "registers.0x010: words");
    row("a word that is none", "\"0001\"", "\"1ffff\"", "registers.0x010: words");
    row("numbers for words", "\"0001\"", "1", "registers.0x010: words");
    row("no list of words", "[\"0001\"]", "\"0001\"", "registers.0x010: words");
}

void TestMcbRigFile::whatIsWrongIsNamed()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, named);
    QByteArray json = R"({"protocol": "mcb", "reply_delay": 1, "registers": {"0x010":
        {"type": "UINT16", "size": 2, "cyclic": "rx", "access": "rw", "words": ["0001"]}}})";
    QVERIFY(readMcbRig(json).has_value());
    const qsizetype place = json.indexOf(from);
    QVERIFY(place >= 0);
    json.replace(place, from.size(), to);
    const auto rig = readMcbRig(json);
    QVERIFY(!rig);
    QVERIFY2(rig.error().contains(named), qPrintable(rig.error()));
}

void TestMcbRigFile::aFileThatIsNotThereIsAnError()
{
    const auto rig = readMcbRigFile(QStringLiteral("/nowhere/rig.json"));
    QVERIFY(!rig && !rig.error().isEmpty());
}

QTEST_APPLESS_MAIN(TestMcbRigFile)
#include "tst_mcb_rig_file.moc"
