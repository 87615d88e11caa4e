// Values, requests and responses of MCP, against bytes from captures and recorded sessions.
#include "mcp/request.h"
#include "mcp/response.h"
#include "support/virtual_link.h"

using namespace mcp;
using support::hex;

class TestMcpCodec : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void namesAreTheFirmwares();
    void getIsNeverOddAndNeverEmpty();
    void getTellsTheBoardWhatItCanTake();
    void motorCommandsNeedAMotor();
    void setWritesEachTypeAtItsWidth();
    void setRefusesWhatDoesNotFit();
    void numbersPassThroughTheirFormat();
    void nothingThatIsNotFiniteBecomesBits();
    void recordedRequestsAreRead();
    void aBrokenSetListIsReadAsFarAsItGoes();
    void aGetAnswerHoldsTheValuesBeforeTheFailure();
    void aGetAnswerThatDoesNotFitIsRefused();
    void rawAndTextValuesAreBounded();
    void setAnswersComeInFourShapes();
    void aListOfStatusesEndsWithANok();
    void aCommandHasOneStatus();
    void onlyTheLowByteOfTheVersionCounts();
};

namespace {

const RegisterId kStatus1{0x0049};
const RegisterId kSpeedKp1{0x0091};
const RegisterId kSpeedRef1{0x0099};
const RegisterId kFwName{0x0020};
const RegisterId kGlobalConfig{0x0028};
constexpr std::size_t kRoom = 256;

Result<GetAnswer, CodecError> getAnswer(const std::vector<RegisterId> &ids, const char *bytes)
{
    const Bytes payload = hex(bytes);
    return decodeResponse(payload).and_then(
        [&](const Response &response) { return decodeGetAnswer(ids, response); });
}

Result<SetAnswer, CodecError> setAnswer(std::size_t count, const char *bytes)
{
    const Bytes payload = hex(bytes);
    return decodeResponse(payload).and_then(
        [&](const Response &response) { return decodeSetAnswer(count, response); });
}

} // namespace

void TestMcpCodec::namesAreTheFirmwares()
{
    QVERIFY(commandName(2) == "GET_REGISTER");
    QVERIFY(commandName(6) == "START_STOP");
    QVERIFY(commandName(14).empty());
    QVERIFY(commandName(32) == "USER_CMD");
    QVERIFY(commandName(64).empty());
    QVERIFY(statusName(0x0A) == "BAD_RAW_FORMAT");
    QVERIFY(statusName(0x0E).empty());
}

void TestMcpCodec::getIsNeverOddAndNeverEmpty()
{
    const std::vector<RegisterId> ids{kStatus1};
    QCOMPARE(*encodeGet(ids, kRoom), hex("10 00 49 00"));
    QCOMPARE(encodeGet({}, kRoom).error(), CodecError::Empty);
}

void TestMcpCodec::getTellsTheBoardWhatItCanTake()
{
    const std::vector<RegisterId> ids(15, kStatus1);
    QCOMPARE(encodeGet(ids, 32)->size(), std::size_t{32});
    QCOMPARE(encodeGet(ids, 31).error(), CodecError::TooLong);
    QVERIFY(getOrder(kSpeedRef1) < getOrder(kSpeedKp1) && getOrder(kSpeedKp1) < getOrder(kStatus1));
    QVERIFY(getOrder(kStatus1) < getOrder(kFwName) && getOrder(kFwName) < getOrder(kGlobalConfig));
}

void TestMcpCodec::motorCommandsNeedAMotor()
{
    QCOMPARE(*encodeCommand(CommandId::StartMotor, 1), hex("19 00"));
    QCOMPARE(*encodeCommand(CommandId::StopMotor, 2), hex("22 00"));
    for (const CommandId command :
        {CommandId::StartMotor, CommandId::StopMotor, CommandId::StopRamp, CommandId::FaultAck,
            CommandId::IqdRefClear, CommandId::SensorSwitch})
        QCOMPARE(encodeCommand(command, 0).error(), CodecError::NoMotor);
    QCOMPARE(encodeCommand(CommandId::StartMotor, 8).error(), CodecError::NoMotor);
    QCOMPARE(*encodeCommand(CommandId::GetMcpVersion, 0), hex("00 00"));
    QCOMPARE(*encodeCommand(CommandId::ProfilerCmd, 1, hex("04")), hex("69 00 04"));
}

void TestMcpCodec::setWritesEachTypeAtItsWidth()
{
    // From recorded sessions: SPEED_KP, SPEED_REF, CONTROL_MODE, CURRENT_REF, MOTOR_NAME.
    const auto set = [](RegisterId id, const Value &value) {
        return *encodeSet(std::vector{RegisterValue{id, value}}, kRoom);
    };
    QCOMPARE(set(kSpeedKp1, 0xFB2EU), hex("08 00 91 00 2E FB"));
    QCOMPARE(set(kSpeedRef1, 1500U), hex("08 00 99 00 DC 05 00 00"));
    QCOMPARE(set({0x0089}, 3U), hex("08 00 89 00 03"));
    QCOMPARE(set({0x0369}, hex("FA 00 E2 FF")), hex("08 00 69 03 04 00 FA 00 E2 FF"));
    QCOMPARE(set({0x00E1}, std::string("abc")), hex("08 00 E1 00 61 62 63 00"));
}

void TestMcpCodec::setRefusesWhatDoesNotFit()
{
    const auto error = [](RegisterId id, const Value &value, std::size_t room = kRoom) {
        return encodeSet(std::vector{RegisterValue{id, value}}, room).error();
    };
    QCOMPARE(error(kStatus1, 256U), CodecError::OutOfRange);
    QCOMPARE(error(kStatus1, std::string("1")), CodecError::WrongKind);
    QCOMPARE(error({0x00C1}, 1U), CodecError::BadType); // type 0
    QCOMPARE(error(kGlobalConfig, Bytes(300, 0)), CodecError::TooLong);
    QCOMPARE(error(kSpeedRef1, 1U, 7), CodecError::TooLong);
    QCOMPARE(encodeSet({}, kRoom).error(), CodecError::Empty);
}

void TestMcpCodec::numbersPassThroughTheirFormat()
{
    using catalog::ValueType;
    QCOMPARE(std::get<std::int64_t>(interpret(Value{0xFFFCU}, ValueType::S16)), std::int64_t{-4});
    QCOMPARE(
        std::get<std::int64_t>(interpret(Value{0xFFFCU}, ValueType::U16)), std::int64_t{65532});
    QCOMPARE(std::get<double>(interpret(Value{0x3FC00000U}, ValueType::F32)), 1.5);
    QCOMPARE(std::get<std::uint32_t>(*bitsOf(std::int64_t{-4}, ValueType::S16)), 0xFFFCU);
    QCOMPARE(std::get<std::uint32_t>(*bitsOf(1.5, ValueType::F32)), 0x3FC00000U);
    QCOMPARE(std::get<std::uint32_t>(*bitsOf(3.0, ValueType::U8)), 3U);
    QCOMPARE(bitsOf(std::int64_t{40000}, ValueType::S16).error(), CodecError::OutOfRange);
    QCOMPARE(bitsOf(std::int64_t{-1}, ValueType::U32).error(), CodecError::OutOfRange);
    QCOMPARE(bitsOf(1.5, ValueType::S32).error(), CodecError::OutOfRange);
    QCOMPARE(bitsOf(std::string("7"), ValueType::U8).error(), CodecError::WrongKind);
}

void TestMcpCodec::nothingThatIsNotFiniteBecomesBits()
{
    for (const double value : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e300}) {
        for (const auto type :
            {catalog::ValueType::F32, catalog::ValueType::S32, catalog::ValueType::U8})
            QVERIFY(!bitsOf(value, type).has_value());
    }
}

void TestMcpCodec::recordedRequestsAreRead()
{
    const Bytes get = hex("10 00 91 00 D1 00");
    const auto request = decodeRequest(get);
    QVERIFY(request.has_value());
    QCOMPARE(request->command, std::uint16_t{2});
    QVERIFY((*decodeGetList(request->content) == std::vector<RegisterId>{{0x0091}, {0x00D1}}));
    const Bytes start = hex("19 00");
    QCOMPARE(int(decodeRequest(start)->motor), 1);
    QCOMPARE(decodeRequest(hex("19")).error(), CodecError::TooShort);
    QCOMPARE(decodeGetList(hex("49")).error(), CodecError::TooShort);
}

void TestMcpCodec::aBrokenSetListIsReadAsFarAsItGoes()
{
    // SPEED_KP, then SPEED_RAMP with a size of 200 that is not there.
    const SetList list =
        decodeSetList(hex("91 00 0B 00 A9 01 C8 00 E8 03 00 00 64 00 D1 00 15 00"));
    QCOMPARE(list.writes.size(), std::size_t{1});
    QVERIFY((list.writes[0] == RegisterValue{kSpeedKp1, Value{11U}}));
    QVERIFY(list.error == CodecError::TooShort);
    QVERIFY(decodeSetList(hex("C1 00 01")).error == CodecError::BadType);
}

void TestMcpCodec::aGetAnswerHoldsTheValuesBeforeTheFailure()
{
    const std::vector<RegisterId> ids{kSpeedRef1, kStatus1, {0xE111}, kSpeedKp1};
    const auto answer = getAnswer(ids, "8C 0A 00 00 06 05");
    QVERIFY(answer.has_value());
    QCOMPARE(int(answer->status), 5);
    QVERIFY((answer->values == std::vector<Value>{2700U, 6U}));
    QVERIFY(getAnswer(ids, "05")->values.empty());
}

void TestMcpCodec::aGetAnswerThatDoesNotFitIsRefused()
{
    const std::vector<RegisterId> ids{kSpeedRef1, kStatus1};
    QCOMPARE(getAnswer(ids, "").error(), CodecError::Empty);
    // OK, but one is missing.
    QCOMPARE(getAnswer(ids, "8C 0A 00 00 00").error(), CodecError::TooShort);
    QCOMPARE(getAnswer(ids, "8C 0A 00 00 06 07 00").error(), CodecError::Leftover);
    QCOMPARE(getAnswer(ids, "8C 0A 00").error(), CodecError::TooShort);
    // Both are there, so none has failed. An empty list is refused (mcp-aspep, 4.5).
    QCOMPARE(getAnswer(ids, "8C 0A 00 00 06 05").error(), CodecError::Leftover);
    QVERIFY(getAnswer({}, "01")->values.empty());
}

void TestMcpCodec::rawAndTextValuesAreBounded()
{
    const std::vector<RegisterId> ids{kFwName, kGlobalConfig};
    const auto answer = getAnswer(ids, "41 42 00 0A 00 00 02 03 06 01 02 0A 00 00 00 00");
    QVERIFY(answer.has_value());
    QVERIFY((answer->values
        == std::vector<Value>{std::string("AB"), hex("00 02 03 06 01 02 0A 00 00 00")}));
    // The zero is the status.
    QCOMPARE(getAnswer(ids, "41 42 43 00").error(), CodecError::NoTerminator);
    QCOMPARE(getAnswer(ids, "41 00 FF FF 01 02 00").error(), CodecError::TooShort);
}

void TestMcpCodec::setAnswersComeInFourShapes()
{
    using Statuses = std::vector<std::uint8_t>;
    QVERIFY((setAnswer(3, "00")->registers == Statuses{0, 0, 0}));
    QVERIFY((setAnswer(1, "04")->registers == Statuses{4}));
    QVERIFY((setAnswer(6, "00 04 00 05 04 00 01")->registers == Statuses{0, 4, 0, 5, 4, 0}));
    QVERIFY((setAnswer(1, "0A 01")->registers == Statuses{0x0A}));
    QVERIFY((setAnswer(1, "07 01")->registers == Statuses{0x07}));
    // It stopped there.
    QVERIFY((setAnswer(3, "00 0A 01")->registers == Statuses{0, 0x0A}));
    QVERIFY(setAnswer(3, "01")->registers.empty()); // motor above the number of motors
    QCOMPARE(setAnswer(1, "00 00 01").error(), CodecError::Leftover);
    QCOMPARE(setAnswer(1, "").error(), CodecError::Empty);
}

/// If some of a list failed the last byte is 01, and if all are good there is one byte (mcp-aspep, 4.4).
void TestMcpCodec::aListOfStatusesEndsWithANok()
{
    for (const char *bytes : {"00 05 00", "00 00 00", "00 05 05", "00 00"})
        QCOMPARE(setAnswer(2, bytes).error(), CodecError::Leftover);
}

void TestMcpCodec::aCommandHasOneStatus()
{
    const auto status = [](const char *bytes) {
        const Bytes payload = hex(bytes);
        return decodeResponse(payload).map(statusOf).value_or(std::nullopt);
    };
    QVERIFY(status("00") == std::uint8_t{0});
    QVERIFY(status("01") == std::uint8_t{1});
    QVERIFY(status("0A 01") == std::uint8_t{0x0A}); // of a SET that was not parsed to its end
    QVERIFY(!status("00 00 01"));
    QVERIFY(!status(""));
}

void TestMcpCodec::onlyTheLowByteOfTheVersionCounts()
{
    const Bytes bytes = hex("01 54 20 4D 00");
    QCOMPARE(int(*versionOf(*decodeResponse(bytes))), 1);
    const Bytes refused = hex("02");
    QVERIFY(!versionOf(*decodeResponse(refused)));
}

QTEST_APPLESS_MAIN(TestMcpCodec)
#include "tst_mcp_codec.moc"
