// The codec of the older serial protocol where the vectors do not reach: bad lengths, bad bytes, both ends of the line,
// and the tables of both dialects.
#include "catalog/catalog.h"
#include "fcp/framer.h"
#include "fcp/register_table.h"
#include "fcp/reply.h"
#include "fcp/request.h"

#include <QtTest>

#include <random>

using namespace fcp;

class TestFcpCodec : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void checksumsLoseTheirCarry();
    void everyCutOfAFrameGivesTheSame();
    void aLengthOf128IsDroppedAndNothingElse();
    void aClientTakesOnlyHeadersOfBoards();
    void aChangedByteIsNeverAnotherFrame();
    void noBytesMakeTheFramerKeepMoreThanAFrame();
    void payloadsOfAnotherLengthAreNoRequest_data();
    void payloadsOfAnotherLengthAreNoRequest();
    void whatAFrameCannotHoldIsNotEncoded();
    void aRefusalMayBeEmptyOrUnknown();
    void answersOfAnotherLengthAreRefused();
    void versionsAreReadInEveryForm();
    void anAcknowledgedCommandTellsTheDialect();
    void bothTablesAreWhole();
    void dialectsDifferWhereTheyShould();
    void sharesOfTheBusAreInTenthsOfAPercent();
    void valuesAreOnlyReadInAWidthOfTheirRegister();
    void aTableWithAFlawIsRefused_data();
    void aTableWithAFlawIsRefused();
};

namespace {

Frame frameOf(std::uint8_t header, std::size_t size) { return {header, Bytes(size, 1)}; }

std::size_t countOf(Dialect dialect) { return registersOf(dialect).size(); }

} // namespace

void TestFcpCodec::checksumsLoseTheirCarry()
{
    QCOMPARE(int(checksumOf(Bytes{0x02, 0x01, 0x1E})), 0x21);
    QCOMPARE(int(checksumOf(Bytes{0xF0, 0x00})), 0xF0);
    QCOMPARE(int(checksumOf(Bytes{0x07, 0x06, 0xE8, 0x03, 0, 0, 0xFA, 0})), 0xF3);
    QCOMPARE(int(checksumOf(Bytes{0xF0, 0x04, 0xFF, 0xFF, 0xFF, 0xFF})), 0xF4);
    QCOMPARE(int(checksumOf(Bytes{0x01, 0x03, 0x05, 0xFB, 0xFB})), 0x00);
    Bytes longest(129, 0xFF);
    longest[0] = 0x02;
    longest[1] = 0x7F;
    longest[2] = 0x06;
    QCOMPARE(int(checksumOf(longest)), 0x87);
}

void TestFcpCodec::everyCutOfAFrameGivesTheSame()
{
    Bytes stream = encodeFrame(0x22, Bytes{0x05});
    const Bytes longest = encodeFrame(0x02, Bytes(kMaxPayload, 0xA5));
    stream.insert(stream.end(), longest.begin(), longest.end());
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
        Framer framer(Framer::Side::Board);
        std::vector<Frame> frames;
        for (ByteView part : {ByteView(stream).first(cut), ByteView(stream).subspan(cut)}) {
            Frame frame;
            while (framer.next(part, frame) == Framer::Step::Frame)
                frames.push_back(frame);
        }
        QCOMPARE(frames.size(), std::size_t(2));
        QCOMPARE(frames[0].payload, Bytes{0x05});
        QCOMPARE(frames[1].payload, Bytes(kMaxPayload, 0xA5));
        QVERIFY(!framer.midFrame());
    }
}

void TestFcpCodec::aLengthOf128IsDroppedAndNothingElse()
{
    const Bytes stream{0x02, 0x80, 0x02, 0x01, 0x1E, 0x21};
    Framer framer(Framer::Side::Board);
    ByteView bytes(stream);
    Frame frame;
    QVERIFY(framer.next(bytes, frame) == Framer::Step::TooLong);
    QVERIFY(framer.next(bytes, frame) == Framer::Step::Frame);
    QCOMPARE(frame.payload, Bytes{0x1E});
    QVERIFY(encodeFrame(0x02, Bytes(128, 0)).empty());
}

void TestFcpCodec::aClientTakesOnlyHeadersOfBoards()
{
    for (unsigned header = 0; header < 256; ++header) {
        const bool known = header == 0xF0 || header == 0xFF || header == 0xE0;
        const Bytes stream = encodeFrame(static_cast<std::uint8_t>(header), {});
        Framer framer(Framer::Side::Client);
        ByteView bytes(stream);
        Frame frame;
        QVERIFY(framer.next(bytes, frame)
            == (known ? Framer::Step::Frame : Framer::Step::UnknownHeader));
        QCOMPARE(bool(decodeReply({static_cast<std::uint8_t>(header), Bytes(13, 0x30)})), known);
        if (known)
            QVERIFY(decodeRequest({static_cast<std::uint8_t>(header), {}}).error()
                == RequestError::IsAReply);
    }
}

void TestFcpCodec::aChangedByteIsNeverAnotherFrame()
{
    const Bytes good = encodeFrame(0x01, Bytes{0x05, 0xDC, 0x05});
    for (std::size_t at = 0; at < good.size(); ++at) {
        for (unsigned bit = 0; bit < 8; ++bit) {
            Bytes bad = good;
            bad[at] = static_cast<std::uint8_t>(bad[at] ^ 1U << bit);
            Framer framer(Framer::Side::Board);
            ByteView bytes(bad);
            Frame frame;
            QVERIFY(framer.next(bytes, frame) != Framer::Step::Frame);
        }
    }
}

void TestFcpCodec::noBytesMakeTheFramerKeepMoreThanAFrame()
{
    std::mt19937 random(1);
    Framer framer(Framer::Side::Board);
    Frame frame;
    for (int i = 0; i < 20000; ++i) {
        const std::uint8_t byte = static_cast<std::uint8_t>(random());
        ByteView bytes(&byte, 1);
        framer.next(bytes, frame);
        QVERIFY(framer.missing() < kMaxPayload + kFrameOverhead);
        QVERIFY(framer.partialPayload().size() <= kMaxPayload);
        QVERIFY(frame.payload.size() <= kMaxPayload);
    }
}

void TestFcpCodec::payloadsOfAnotherLengthAreNoRequest_data()
{
    QTest::addColumn<int>("code");
    for (const int code : {0x02, 0x03, 0x06, 0x07, 0x08, 0x09, 0x0A, 0x0C, 0x0D, 0x12})
        QTest::addRow("%s", qPrintable(QString::number(code, 16))) << code;
}

void TestFcpCodec::payloadsOfAnotherLengthAreNoRequest()
{
    QFETCH(int, code);
    const std::size_t size = payloadSizeOf(std::uint8_t(code)).value();
    for (std::size_t other = 0; other <= kMaxPayload; ++other) {
        const auto request = decodeRequest(frameOf(std::uint8_t(code), other));
        if (other == size)
            QVERIFY(request);
        else
            QVERIFY(
                request.error() == (other < size ? RequestError::TooShort : RequestError::TooLong));
    }
}

void TestFcpCodec::whatAFrameCannotHoldIsNotEncoded()
{
    QVERIFY(encodeRequest({8, GetBoardInfo{}}).error() == RequestError::BadMotor);
    QVERIFY(encodeRequest({1, OtherRequest{0x20, {}}}).error() == RequestError::BadMotor);
    QVERIFY(encodeRequest({7, OtherRequest{0x10, {}}}).error() == RequestError::IsAReply);
    QVERIFY(encodeRequest({7, OtherRequest{0x1F, {}}}).error() == RequestError::IsAReply);
    QVERIFY(encodeRequest({1, GetProfilerInfo{Bytes(128, 0)}}).error() == RequestError::TooLong);
    for (const std::size_t width : {0, 3, 5})
        QVERIFY(
            encodeRequest({1, SetRegister{5, Bytes(width, 0)}}).error() == RequestError::BadWidth);
    QVERIFY(decodeRequest(frameOf(0x01, 1)).error() == RequestError::TooShort);
    QVERIFY(decodeRequest(frameOf(0x01, 4)).error() == RequestError::BadWidth);
    QVERIFY(decodeRequest(frameOf(0xF0, 0)).error() == RequestError::IsAReply);
}

void TestFcpCodec::aRefusalMayBeEmptyOrUnknown()
{
    QVERIFY(std::get<Nack>(decodeReply({0xFF, {}}).value()).error == std::nullopt);
    QCOMPARE(int(*std::get<Nack>(decodeReply({0xFF, {0x77}}).value()).error), 0x77);
    QVERIFY(errorName(0x77).empty());
}

void TestFcpCodec::answersOfAnotherLengthAreRefused()
{
    QVERIFY(decodeReply(frameOf(0xE0, 12)).error() == ReplyError::BadLength);
    QVERIFY(decodeReply(frameOf(0xE0, 14)).error() == ReplyError::BadLength);
    for (std::size_t size = 0; size <= kMaxPayload; ++size) {
        const Bytes data(size, 0x41);
        QCOMPARE(decodeBoardInfo(data).has_value(), size > 0); // one dialect describes no layout
        QCOMPARE(decodeFirmwareVersion(data).has_value(), size == 32);
        QCOMPARE(decodeRevUp(data).has_value(), size == 8);
    }
    QVERIFY(decodeFirmwareVersion(Bytes(32, 0)).error() == ReplyError::BadText);
}

void TestFcpCodec::versionsAreReadInEveryForm()
{
    Bytes info(32, 0);
    std::copy_n("B10", 3, info.begin());
    QCOMPARE(decodeBoardInfo(info)->version, std::string("B.1.0"));
    std::fill(info.begin() + 3, info.end(), std::uint8_t{'x'});
    QCOMPARE(decodeBoardInfo(info)->name, std::string(29, 'x'));
    info[4] = 0xC3;
    QCOMPARE(decodeBoardInfo(info)->name.substr(0, 3), std::string("x?x"));

    QCOMPARE(firmwareVersionOf("FOC\tVer.4.3.0-RC2").version, std::string("4.3.0-RC2"));
    QCOMPARE(firmwareVersionOf("no tab").name, std::string("no tab"));
    QCOMPARE(firmwareVersionOf("no tab").version, std::string());
    QCOMPARE(firmwareVersionOf("name\t5.4.3").version, std::string());
    const std::string full(40, 'y');
    QCOMPARE(encodeFirmwareVersion(full).size(), kInfoSize);
    QCOMPARE(decodeFirmwareVersion(encodeFirmwareVersion(full))->text, std::string(32, 'y'));
    QCOMPARE(encodeBoardInfo({"5..", "n"})[1], std::uint8_t{'0'});
}

void TestFcpCodec::anAcknowledgedCommandTellsTheDialect()
{
    QVERIFY(decodeExecuteAck(1, {}) == Dialect::Stm32);
    QVERIFY(decodeExecuteAck(1, Bytes{1}) == Dialect::PowerPc);
    QVERIFY(decodeExecuteAck(1, Bytes{2}).error() == ReplyError::OtherCommand);
    QVERIFY(decodeExecuteAck(1, Bytes{1, 1}).error() == ReplyError::BadLength);
}

void TestFcpCodec::bothTablesAreWhole()
{
    const auto text = catalog::builtInTable("legacy");
    QVERIFY(readRegisterTable(text, Dialect::Stm32));
    QVERIFY(readRegisterTable(text, Dialect::PowerPc));
    QCOMPARE(countOf(Dialect::Stm32), std::size_t(137));
    QCOMPARE(countOf(Dialect::PowerPc), std::size_t(51));
    for (const Dialect dialect : {Dialect::Stm32, Dialect::PowerPc}) {
        for (const Register &entry : registersOf(dialect)) {
            const std::string &name = entry.info.name;
            QVERIFY2(entry.readBytes == 0 || entry.info.readable(), name.c_str());
            QVERIFY2(entry.writeBytes == 0 || entry.info.writable(), name.c_str());
            QVERIFY2(!entry.info.help.empty() && !entry.info.group.empty(), name.c_str());
            QVERIFY2(entry.info.unit.size() < 12, name.c_str()); // it stands behind each value
            const auto id = static_cast<std::uint8_t>(entry.info.id);
            QCOMPARE(findRegister(dialect, id), &entry);
        }
    }
    QVERIFY(findRegister(Dialect::Stm32, 0x89) == nullptr);
    QVERIFY(findRegister(Dialect::PowerPc, 0x23) == nullptr);
}

void TestFcpCodec::sharesOfTheBusAreInTenthsOfAPercent()
{
    for (const int id : {0x18, 0x21}) {
        const auto &info = findRegister(Dialect::Stm32, static_cast<std::uint8_t>(id))->info;
        QCOMPARE(info.unit, std::string("0.1 %"));
        QCOMPARE(info.least.value(), 0.0);
        QCOMPARE(info.greatest.value(), 1000.0);
    }
    QVERIFY(!findRegister(Dialect::Stm32, 0x05)->info.greatest); // a gain
}

void TestFcpCodec::dialectsDifferWhereTheyShould()
{
    for (const int id :
        {0x05, 0x06, 0x07, 0x09, 0x0A, 0x0B, 0x0D, 0x0E, 0x0F, 0x14, 0x15, 0x16, 0x17}) {
        const auto number = static_cast<std::uint8_t>(id);
        QVERIFY(findRegister(Dialect::Stm32, number)->info.type == catalog::ValueType::S16);
        QVERIFY(findRegister(Dialect::PowerPc, number)->info.type == catalog::ValueType::U16);
    }
    QCOMPARE(findRegister(Dialect::PowerPc, 0x41)->readBytes, std::size_t(0));
    QCOMPARE(findRegister(Dialect::Stm32, 0x41)->readBytes, std::size_t(2));
    QCOMPARE(findRegister(Dialect::PowerPc, 0x5C)->writeBytes, std::size_t(2));
    QVERIFY(!findRegister(Dialect::Stm32, 0x5C)->info.readable());
    QCOMPARE(findRegister(Dialect::Stm32, 0x10)->writeBytes, std::size_t(4));
    QCOMPARE(findRegister(Dialect::Stm32, 0x10)->readBytes, std::size_t(2));
    QVERIFY(findRegister(Dialect::Stm32, 0x23)->dacSource);
    QVERIFY(!knowsFrame(Dialect::PowerPc, 0x0C) && knowsFrame(Dialect::Stm32, 0x0C));
    QVERIFY(!knowsFrame(Dialect::Stm32, 0x0E) && !knowsCommand(Dialect::PowerPc, 0x09));
}

void TestFcpCodec::valuesAreOnlyReadInAWidthOfTheirRegister()
{
    const Register &board = *findRegister(Dialect::Stm32, 0x72);
    QVERIFY(decodeValue(board, Bytes{9, 0}) == catalog::Value(std::int64_t{9}));
    QVERIFY(decodeValue(board, Bytes{9, 0, 1, 0}) == catalog::Value(std::int64_t{0x10009}));
    QVERIFY(decodeValue(board, Bytes{9}).error() == ReplyError::BadLength);
    const Register &gain = *findRegister(Dialect::Stm32, 0x05);
    QVERIFY(decodeValue(gain, Bytes{0xFE, 0xFF}) == catalog::Value(std::int64_t{-2}));
    for (const std::size_t width : {0, 1, 3, 4, 127})
        QVERIFY(decodeValue(gain, Bytes(width, 0)).error() == ReplyError::BadLength);
    const Register &angle = *findRegister(Dialect::Stm32, 0x83);
    QVERIFY(decodeValue(angle, encodeValue(angle, 1.5, 4)) == catalog::Value(1.5));
}

void TestFcpCodec::aTableWithAFlawIsRefused_data()
{
    QTest::addColumn<QByteArray>("row");
    QTest::newRow("no id") << QByteArray("x,A,u8,,,g,R,,1,,,,,d");
    QTest::newRow("id too large") << QByteArray("0x100,A,u8,,,g,R,,1,,,,,d");
    QTest::newRow("no name") << QByteArray("0x01,,u8,,,g,R,,1,,,,,d");
    QTest::newRow("unknown type") << QByteArray("0x01,A,u64,,,g,R,,1,,,,,d");
    QTest::newRow("unknown meaning") << QByteArray("0x01,A,u8 mood,,,g,R,,1,,,,,d");
    QTest::newRow("unknown access") << QByteArray("0x01,A,u8,,,g,X,,1,,,,,d");
    QTest::newRow("width of 3") << QByteArray("0x01,A,u8,,,g,R,,3,,,,,d");
    QTest::newRow("unknown need") << QByteArray("0x01,A,u8,,,g,R,,1,,steam,,,d");
    QTest::newRow("no effect") << QByteArray("0x01,A,u8,,,g,RW,,1,1,,,,d");
    QTest::newRow("too few fields") << QByteArray("0x01,A,u8");
    QTest::newRow("twice") << QByteArray("0x01,A,u8,,,g,R,,1,,,,,d\n0x01,B,u8,,,g,R,,1,,,,,d");
}

void TestFcpCodec::aTableWithAFlawIsRefused()
{
    QFETCH(QByteArray, row);
    const std::string_view built = catalog::builtInTable("legacy");
    const std::string head(built.substr(0, built.find('\n') + 1));
    QVERIFY(readRegisterTable(head + "0x01,A,u8,,,g,R,,1,,,,,d\n", Dialect::Stm32));
    QVERIFY(!readRegisterTable(head + row.toStdString() + '\n', Dialect::Stm32));
    QVERIFY(!readRegisterTable(row.toStdString(), Dialect::Stm32));
}

QTEST_APPLESS_MAIN(TestFcpCodec)
#include "tst_legacy_codec.moc"
