// What MCP does on the simulated board where it surprises: lists with errors, values without room, old bytes.
#include "support/board_bench.h"

#include <QTest>

using namespace support;

namespace {

ByteWriter getWriter()
{
    ByteWriter request;
    request.u16(2U << 3);
    return request;
}

ByteWriter set()
{
    ByteWriter request;
    request.u16(1U << 3);
    return request;
}

} // namespace

class TestServer : public QObject {
    Q_OBJECT

private slots:
    void emptyListsAreRefusedForReadingOnly();
    void anUnknownTypeOrMotorEndsAList();
    void aMotorsRegisterIsUnknownWithoutItsMotor();
    void aValueThatIsMissingIsReadFromOldBytes();
    void aTextThatDoesNotFitIsAFormatError();
    void rampsDoNotLookAtTheRoom();
    void torqueRampIsWrittenLongAndReadShort();
    void currentReferencesReadBackWhileRunning();
    void aStartedToggleIsRefusedInOlderFirmware();
    void softResetHasNoAnswer();
    void userCommandsEchoBackwards();
    void theDatalogBelongsToTheLinkItIsOn();
    void theTextIsFollowedWhereItCanBe();
};

void TestServer::emptyListsAreRefusedForReadingOnly()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(getWriter().take()), Bytes{1});
    QCOMPARE(bench.ask(set().take()), Bytes{0});
}

void TestServer::anUnknownTypeOrMotorEndsAList()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(getWriter().u16(0x0049).u16(0x0001).u16(0x0049).take()), (Bytes{0, 7}));
    QCOMPARE(bench.ask(getWriter().u16(0x0049).u16(0x004A).u16(0x0049).take()), (Bytes{0, 1}));
    QCOMPARE(bench.ask(set().u16(0x0091).u16(100).u16(0x0092).u16(200).u16(0x00D1).u16(300).take()),
        (Bytes{0, 1}));
    // Written before it failed.
    QCOMPARE(bench.ask(getWriter().u16(0x0091).take()), (Bytes{100, 0, 0}));
}

void TestServer::aMotorsRegisterIsUnknownWithoutItsMotor()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(getWriter().u16(0x0048).take()), Bytes{5});
    QCOMPARE(bench.ask(getWriter().u16(0x0029).take()), Bytes{5});
    QCOMPARE(bench.ask(getWriter().u16(0x0021).take()), Bytes{5});
}

void TestServer::aValueThatIsMissingIsReadFromOldBytes()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(set().u16(0x0091).u16(0x1234).take()), Bytes{0});
    // The value is what lay behind the last request.
    QCOMPARE(bench.ask(set().u16(0x00D1).take()), Bytes{0});
    QCOMPARE(bench.ask(getWriter().u16(0x00D1).take()), (Bytes{0x34, 0x12, 0}));
    QCOMPARE(bench.ask(set().u16(0x01A9).u16(2).u16(600).take()), Bytes{0}); // a ramp of two bytes
}

void TestServer::aTextThatDoesNotFitIsAFormatError()
{
    BoardOptions options;
    options.txSyncMax = 32;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const Bytes answer = bench.ask(getWriter().u16(0x0020).u16(0x0020).take());
    QCOMPARE(answer.back(), 6);
    QCOMPARE(answer.size(), std::size_t{21});
}

void TestServer::rampsDoNotLookAtTheRoom()
{
    BoardOptions options;
    options.txSyncMax = 32;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const Bytes answer =
        bench.ask(getWriter().u16(0x01A9).u16(0x01A9).u16(0x01A9).u16(0x01A9).u16(0x0049).take());
    QCOMPARE(answer.size(), std::size_t{33}); // four times eight, one byte more than was agreed
    QCOMPARE(answer.back(), 8); // a scalar does look
}

void TestServer::torqueRampIsWrittenLongAndReadShort()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(set().u16(0x01E9).u16(6).s32(-300).u16(250).take()), Bytes{0});
    QCOMPARE(bench.ask(getWriter().u16(0x01E9).take()), (Bytes{4, 0, 0xD4, 0xFE, 250, 0, 0}));
    QCOMPARE(bench.get(mcp::reg::kControlMode), 4);
}

void TestServer::currentReferencesReadBackWhileRunning()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    const Bytes write = set().u16(0x0369).u16(4).s16(400).s16(-30).take();
    QCOMPARE(bench.ask(write), Bytes{0});
    // Not running: no effect yet.
    QCOMPARE(bench.ask(getWriter().u16(0x0369).take()), (Bytes{4, 0, 0, 0, 0, 0, 0}));
    QCOMPARE(bench.command(3), Bytes{0});
    QVERIFY(bench.waitForState(6));
    QCOMPARE(bench.ask(write), Bytes{0});
    QCOMPARE(bench.ask(getWriter().u16(0x0369).take()), (Bytes{4, 0, 0x90, 0x01, 0xE2, 0xFF, 0}));
    QCOMPARE(bench.ask(set().u16(0x0951).u16(500).take()), Bytes{0});
    QCOMPARE(bench.ask(getWriter().u16(0x0951).take()), (Bytes{0xF4, 0x01, 0}));
    QCOMPARE(bench.command(9), Bytes{0});
    QCOMPARE(bench.ask(getWriter().u16(0x0369).take()), (Bytes{4, 0, 0, 0, 0, 0, 0}));
}

void TestServer::aStartedToggleIsRefusedInOlderFirmware()
{
    for (const bool older : {false, true}) {
        BoardOptions options;
        options.profile = older ? "mcsdk-6.2" : "mcsdk-6.4";
        BoardBench bench(options);
        QVERIFY(bench.connect());
        QCOMPARE(bench.command(6), (Bytes{static_cast<std::uint8_t>(older ? 1 : 0)}));
        QVERIFY(bench.waitForState(6));
        QCOMPARE(bench.command(6), Bytes{0});
        QCOMPARE(bench.get(mcp::reg::kStatus), 8);
    }
}

void TestServer::softResetHasNoAnswer()
{
    BoardBench bench;
    QVERIFY(bench.connect());
    QCOMPARE(bench.command(15), Bytes{});
    bench.send(aspep::Ping{.number = 4});
    const auto reply = bench.packets(3ms);
    QCOMPARE(reply.size(), std::size_t{1});
    QCOMPARE(reply[0].header, aspep::Header{(aspep::Ping{.number = 4})});
    QVERIFY(bench.connect());
}

void TestServer::userCommandsEchoBackwards()
{
    BoardOptions options;
    options.userCallbacks = 2;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(ByteWriter().u16(0x0100).u8(1).u8(2).u8(3).take()), (Bytes{3, 2, 1, 0}));
    QCOMPARE(bench.ask(ByteWriter().u16(0x0108).u8(1).take()), Bytes{0x42});
    QCOMPARE(bench.ask(ByteWriter().u16(0x0110).u8(1).take()), Bytes{0x0D});
}

void TestServer::theDatalogBelongsToTheLinkItIsOn()
{
    BoardOptions options;
    options.linkId = 1;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    const auto stop = [&](unsigned id) { return set().u16(id).u16(2).u16(0).take(); };
    QCOMPARE(bench.ask(stop(0x0529)), Bytes{5});
    QCOMPARE(bench.ask(stop(0x0569)), Bytes{0});
    QCOMPARE(bench.ask(stop(0x0568)), Bytes{5});
}

void TestServer::theTextIsFollowedWhereItCanBe()
{
    BoardOptions options;
    options.profile = "spec";
    options.txSyncMax = 32;
    BoardBench bench(options);
    QVERIFY(bench.connect());
    QCOMPARE(bench.ask(getWriter().u16(0x00A9).take()).size(), std::size_t{14 + 2 + 1});
    QCOMPARE(bench.ask(getWriter().u16(0x0129).take()), Bytes{5});
    QCOMPARE(bench.ask(getWriter().u16(0x01E9).take()).size(), std::size_t{6 + 2 + 1});
    QCOMPARE(bench.ask(set().u16(0x0091).u16(1).u16(0x07D1).u16(1).take()), (Bytes{1, 4, 1}));
    QCOMPARE(bench.ask(getWriter().u16(0x0020).u16(0x0020).take()).back(), 8);
    QCOMPARE(bench.ask(getWriter().u16(0x01A9).u16(0x01A9).u16(0x01A9).u16(0x01A9).take()).size(),
        std::size_t{25});
    QCOMPARE(bench.ask(ByteWriter().u16(0).take()), (Bytes{1, 0, 0, 0, 0}));
    QCOMPARE(bench.ask(set().u16(0x0529).u16(2).u16(0).take()), Bytes{0}); // as shipped
    QCOMPARE(bench.ask(set().u16(0x0528).u16(5).u32(0).u8(0).take()), Bytes{0}); // as printed
    QCOMPARE(bench.ask(getWriter().u16(0x0528).take()), (Bytes{5, 0, 0, 0, 0, 0, 0, 0}));
}

QTEST_APPLESS_MAIN(TestServer)
#include "tst_server.moc"
