// The dictionary that is built in, and tables that are none.
#include "mcb/dictionary.h"

#include <QtTest>

using namespace mcb;

class TestMcbDictionary : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theBuiltInOneIsWhole();
    void itHasWhatEveryToolNeeds();
    void wrongTablesSayWhere_data();
    void wrongTablesSayWhere();
};

void TestMcbDictionary::theBuiltInOneIsWhole()
{
    const auto &entries = dictionary();
    QCOMPARE(entries.size(), 298U);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry &entry = entries[i];
        QVERIFY(i == 0 || entries[i - 1].address < entry.address);
        QVERIFY2(entry.info.type && !entry.name.empty() && entry.name != entry.olderName,
            entry.name.c_str());
        QVERIFY(entry.info.access != catalog::Access::None);
        QVERIFY((entry.info.size == 0) == (entry.info.type == Type::Text));
        QCOMPARE(findEntry(entry.address), &entry);
    }
    QCOMPARE(findEntry(0x000), nullptr);
    QCOMPARE(findEntry(0x7FF), nullptr);
}

void TestMcbDictionary::itHasWhatEveryToolNeeds()
{
    using catalog::Access;
    const Entry *control = findEntry(0x010);
    QVERIFY(control != nullptr);
    QCOMPARE(control->name, std::string("DRV_STATE_CONTROL"));
    QCOMPARE(control->olderName, std::string("CONTROL_WORD"));
    QVERIFY((control->info == Info{2, Type::UInt16, Cyclic::Rx, Access::ReadWrite}));
    const Entry *voltage = findEntry(0x060);
    QVERIFY((voltage->info == Info{4, Type::Float, Cyclic::Tx, Access::Read}));
    QCOMPARE(voltage->unit, std::string("V"));
    for (const std::uint16_t gain :
        {std::uint16_t{0x501}, std::uint16_t{0x506}}) // V for each A s that has been missing
        QCOMPARE(findEntry(gain)->unit, std::string("V/(A s)"));
    const Entry *limit = findEntry(0x025);
    QVERIFY(limit->olderName.empty()); // one name in both
    const Entry *mapping = findEntry(0x650);
    QCOMPARE(mapping->name, std::string("RX_MAPPED_REGISTERS")); // newer firmware has none
    QVERIFY(mapping->olderName.empty());
    QCOMPARE(findEntry(0x6DF)->info.access, Access::Write);
}

void TestMcbDictionary::wrongTablesSayWhere_data()
{
    QTest::addColumn<QByteArray>("rows");
    QTest::addColumn<int>("line");
    QTest::newRow("no such type") << QByteArray("0x010,A,B,UINT8,1,RW,rx,kept,,\n") << 2;
    QTest::newRow("no such access") << QByteArray("0x010,A,B,UINT16,2,X,rx,kept,,\n") << 2;
    QTest::newRow("no such direction") << QByteArray("0x010,A,B,UINT16,2,RW,up,kept,,\n") << 2;
    QTest::newRow("no size") << QByteArray("0x010,A,B,UINT16,two,RW,rx,kept,,\n") << 2;
    QTest::newRow("too large") << QByteArray("0x010,A,B,STRING,256,RW,rx,kept,,\n") << 2;
    QTest::newRow("no address") << QByteArray("010,A,B,UINT16,2,RW,rx,kept,,\n") << 2;
    QTest::newRow("above the last address") << QByteArray("0x800,A,B,UINT16,2,RW,rx,kept,,\n") << 2;
    QTest::newRow("no name") << QByteArray("0x010,,,UINT16,2,RW,rx,kept,,\n") << 2;
    QTest::newRow("no effect") << QByteArray("0x010,A,B,UINT16,2,RW,rx,,,\n") << 2;
    QTest::newRow("no such effect") << QByteArray("0x010,A,B,UINT16,2,RW,rx,odd,,\n") << 2;
    QTest::newRow("cut") << QByteArray("0x010,A,B\n") << 2;
    QTest::newRow("twice") << QByteArray("0x010,A,B,UINT16,2,RW,rx,kept,,\n"
                                         "0x011,A,B,UINT16,2,RW,rx,kept,,\n"
                                         "0x010,A,B,UINT16,2,RW,rx,kept,,\n")
                           << 4;
}

void TestMcbDictionary::wrongTablesSayWhere()
{
    QFETCH(QByteArray, rows);
    QFETCH(int, line);
    const QByteArray head =
        "address,name_summit,name_newer,type,size_bytes,access,cyclic,effect,unit,description\n";
    QVERIFY(readDictionary(head.toStdString() + "0x012,A,B,UINT16,2,RW,rx,kept,,\n").has_value());
    const std::string table = (head + rows).toStdString();
    const auto read = readDictionary(table);
    QVERIFY(!read);
    QCOMPARE(static_cast<int>(read.error().line), line);
    QVERIFY(!readDictionary("").has_value());
    QVERIFY(!readDictionary("address,name_summit\n0x010,A\n").has_value());
}

QTEST_APPLESS_MAIN(TestMcbDictionary)
#include "tst_mcb_dictionary.moc"
