// Every vector of the older serial protocol through the codec, from bytes to meaning and from meaning to bytes.
#include "fcp/framer.h"
#include "fcp/register_table.h"
#include "fcp/reply.h"
#include "fcp/request.h"
#include "support/fcp_vectors.h"
#include "support/places.h"
#include "support/start_notice.h"

#include <QtTest>

#include <optional>

using namespace fcp;
using support::FcpConversation;
using support::FcpVector;

class TestFcpVectors : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void thereAreAll();
    void requestsAreReadAndMade_data();
    void requestsAreReadAndMade();
    void answersAreReadAndMade_data() { requestsAreReadAndMade_data(); }
    void answersAreReadAndMade();
};

namespace {

int member(const FcpVector &row, const char *key)
{
    return row.decoded[QLatin1String(key)].toInt();
}

bool has(const FcpVector &row, const char *key) { return row.decoded.contains(QLatin1String(key)); }

std::string text(const FcpVector &row, const char *key)
{
    return row.decoded[QLatin1String(key)].toString().toStdString();
}

const Register *registerOf(const FcpVector &row)
{
    return findRegister(row.dialect, static_cast<std::uint8_t>(member(row, "register")));
}

catalog::Value valueOf(const FcpVector &row)
{
    return static_cast<std::int64_t>(row.decoded[QLatin1String("value")].toDouble());
}

StageFields stageOf(const FcpVector &row)
{
    return {member(row, "rpm"), static_cast<std::int16_t>(member(row, "torque")),
        static_cast<std::uint16_t>(member(row, "ms"))};
}

/// What a row says in words; nothing where its words do not say all of the request.
std::optional<Command> commandOf(const FcpVector &row)
{
    const std::string name = text(row, "command");
    const auto byte = [&](const char *key) { return static_cast<std::uint8_t>(member(row, key)); };
    if (name == "GET_REG")
        return GetRegister{byte("register")};
    if (name == "SET_REG" && has(row, "value"))
        return SetRegister{byte("register"),
            encodeValue(*registerOf(row), valueOf(row), registerOf(row)->writeBytes)};
    if (name == "EXECUTE_CMD")
        return Execute{byte("id")};
    if (name == "GET_BOARD_INFO")
        return GetBoardInfo{};
    if (name == "GET_FW_VERSION")
        return GetFirmwareVersion{};
    if (name == "SET_RAMP")
        return SetRamp{member(row, "rpm"), static_cast<std::uint16_t>(member(row, "ms"))};
    if (name == "GET_REVUP_DATA")
        return GetRevUp{byte("stage")};
    if (name == "SET_REVUP_DATA")
        return SetRevUp{byte("stage"), stageOf(row)};
    if (name == "SET_CURRENT_REF")
        return SetCurrentReference{static_cast<std::int16_t>(member(row, "iq")),
            static_cast<std::int16_t>(member(row, "id"))};
    if (name == "SET_TORQUE_RAMP")
        return SetTorqueRamp{member(row, "torque"), static_cast<std::uint16_t>(member(row, "ms"))};
    return std::nullopt;
}

/// The frame that ends with the row's request, if one does.
std::optional<Framer::Step> feed(Framer &framer, const FcpVector &row, Frame &frame)
{
    ByteView bytes(row.request);
    std::optional<Framer::Step> last;
    while (!bytes.empty()) {
        last = framer.next(bytes, frame);
        if (*last == Framer::Step::NeedBytes)
            last.reset();
    }
    return last;
}

void checkRequest(const FcpVector &row, const Frame &frame)
{
    const auto request = decodeRequest(frame);
    QVERIFY(request);
    const auto bytes = encodeRequest(*request);
    QVERIFY(bytes);
    QCOMPARE(*bytes, row.request);
    if (has(row, "motor"))
        QCOMPARE(int(request->motor), member(row, "motor"));
    if (const auto command = commandOf(row)) {
        QVERIFY(request->command == *command);
        const auto made = encodeRequest({request->motor, *command});
        QVERIFY(made);
        QCOMPARE(*made, row.request);
    }
}

/// The data of an acknowledgement and back.
void checkData(const FcpVector &row, const Ack &ack)
{
    const std::string command = text(row, "command");
    if (command == "EXECUTE_CMD") {
        QVERIFY(decodeExecuteAck(row.request[2], ack.data) == row.dialect);
    } else if (has(row, "register") && has(row, "value") && !ack.data.empty()) {
        const auto value = decodeValue(*registerOf(row), ack.data);
        QVERIFY(value);
        QVERIFY(*value == valueOf(row));
        QCOMPARE(encodeValue(*registerOf(row), *value, ack.data.size()), ack.data);
    } else if (command == "GET_FW_VERSION") {
        const auto version = decodeFirmwareVersion(ack.data);
        QVERIFY(version);
        QCOMPARE(version->version, text(row, "version"));
        QCOMPARE(version->name, text(row, "name"));
        QCOMPARE(encodeFirmwareVersion(version->text), ack.data);
    } else if (has(row, "version")) {
        const auto info = decodeBoardInfo(ack.data);
        QVERIFY(info);
        QCOMPARE(info->version, text(row, "version"));
        if (has(row, "name"))
            QCOMPARE(info->name, text(row, "name"));
        if (ack.data[0] >= 0x20) // the integers of the text are read, never made
            QCOMPARE(encodeBoardInfo(*info), ack.data);
    } else if (command == "GET_REVUP_DATA") {
        const auto stage = decodeRevUp(ack.data);
        QVERIFY(stage);
        QVERIFY(*stage == stageOf(row));
        QCOMPARE(encodeRevUp(*stage), ack.data);
    } else {
        QVERIFY(ack.data.empty() || !has(row, "command"));
    }
}

void checkReply(const FcpVector &row, const Reply &reply)
{
    if (const auto *nack = std::get_if<Nack>(&reply)) {
        QVERIFY(nack->error.has_value());
        if (has(row, "error") && !row.openError)
            QCOMPARE(int(*nack->error), member(row, "error"));
        QVERIFY(!errorName(*nack->error).empty());
        QCOMPARE(encodeNack(static_cast<ErrorCode>(*nack->error)), row.reply);
    } else if (const auto *notice = std::get_if<StartNotice>(&reply)) {
        QVERIFY(notice->buildId == static_cast<std::uint32_t>(member(row, "uid")));
        QCOMPARE(notice->version, text(row, "version"));
        QCOMPARE(int(notice->controlBoard), member(row, "ctrbdid"));
        QCOMPARE(int(notice->powerBoard), member(row, "pwbdid"));
        QCOMPARE(int(notice->powerBoard2), member(row, "pwbdid2"));
        QCOMPARE(support::startNotice(*notice), row.reply);
    } else {
        QVERIFY2(!has(row, "error"), "a refusal was meant");
        QCOMPARE(encodeAck(std::get<Ack>(reply).data), row.reply);
        checkData(row, std::get<Ack>(reply));
    }
}

} // namespace

void TestFcpVectors::thereAreAll()
{
    std::size_t rows = 0;
    for (const FcpConversation &conversation : support::readFcpVectors())
        rows += conversation.size();
    QFile file(support::dataFile(QStringLiteral("vectors/legacy.jsonl")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(qsizetype(rows), file.readAll().count('\n') - 1); // all but the head
    QVERIFY(rows > 140);
}

void TestFcpVectors::requestsAreReadAndMade_data()
{
    QTest::addColumn<int>("index");
    const auto all = support::readFcpVectors();
    for (std::size_t i = 0; i < all.size(); ++i)
        QTest::addRow("%s", qPrintable(all[i].front().name)) << int(i);
}

void TestFcpVectors::requestsAreReadAndMade()
{
    QFETCH(int, index);
    const auto conversation = support::readFcpVectors()[std::size_t(index)];
    Framer framer(Framer::Side::Board);
    Frame frame;
    for (const FcpVector &row : conversation) {
        if (row.event.startsWith(QLatin1String("rx_")))
            framer.reset();
        const bool continues = framer.midFrame();
        const auto step = feed(framer, row, frame);
        const bool damaged = row.name == QLatin1String("bad_checksum") || continues;
        if (row.request.empty() || row.reply.empty())
            QVERIFY(!step); // nothing that could be answered
        else
            QVERIFY(step == (damaged ? Framer::Step::BadChecksum : Framer::Step::Frame));
        if (step == Framer::Step::Frame)
            checkRequest(row, frame);
    }
}

void TestFcpVectors::answersAreReadAndMade()
{
    QFETCH(int, index);
    const auto conversation = support::readFcpVectors()[std::size_t(index)];
    for (const FcpVector &row : conversation) {
        if (row.reply.empty())
            continue;
        Framer framer(Framer::Side::Client);
        Frame frame;
        ByteView bytes(row.reply);
        QVERIFY(framer.next(bytes, frame) == Framer::Step::Frame);
        QVERIFY(bytes.empty());
        const auto reply = decodeReply(frame);
        QVERIFY(reply);
        checkReply(row, *reply);
    }
}

QTEST_APPLESS_MAIN(TestFcpVectors)
#include "tst_legacy_vectors.moc"
