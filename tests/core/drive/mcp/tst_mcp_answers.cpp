// What the tasks of an MCP drive make of answers that no board gives to what was asked. Their shapes: mcp-aspep, 4.3 to
// 4.6. No board, no line.
#include "drive/mcp/writes.h"
#include "support/virtual_link.h"

#include <QTest>

using namespace drive;
using support::hex;
using namespace std::chrono_literals;

namespace {

constexpr TimePoint kAnswered{10s};
constexpr RegisterId kReference = 0x0099, kStatus = 0x0049, kGlobalConfig = 0x0028, kKp = 0x0091,
                     kKi = 0x00D1;

McpFacts factsOfBoard()
{
    McpFacts board;
    board.requestBytes = board.responseBytes = 128;
    board.catalog = std::make_shared<const catalog::Catalog>(
        catalog::readTable(catalog::builtInTable("mcp"), "std", 0x060402).value(), 1,
        std::vector<catalog::Scales>(1));
    return board;
}

/// What one answer to a GET of these is read as.
std::optional<std::vector<Reading>> readings(
    const McpFacts &board, const std::vector<RegisterId> &ids, const char *bytes)
{
    const Bytes payload = hex(bytes);
    return McpReads(board).readings(ids, mcp::decodeResponse(payload), kAnswered);
}

template <class Task>
void answer(Task &task, const char *bytes)
{
    const Bytes payload = hex(bytes);
    task.onResponse(mcp::decodeResponse(payload), kAnswered);
}

template <class What>
bool asksFor(const std::optional<McpRequest> &request)
{
    return request && std::holds_alternative<What>(*request);
}

} // namespace

class TestMcpAnswers : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatFitsIsRead();
    void whatDoesNotFitIsLost_data();
    void whatDoesNotFitIsLost();
    void aStructureOfAnotherSizeIsLost();
    void aCommandIsDoneWithAnOkAlone();
    void aListThatIsNotClearlyAnsweredIsReadBack_data();
    void aListThatIsNotClearlyAnsweredIsReadBack();
};

void TestMcpAnswers::whatFitsIsRead()
{
    const McpFacts board = factsOfBoard();
    const auto both = readings(board, {kReference, kStatus}, "8C 0A 00 00 06 00");
    QVERIFY(both && both->size() == 2);
    QVERIFY((*both)[0].value == Value(std::int64_t{2700}));
    QVERIFY((*both)[1].value == Value(std::int64_t{6}));
    // One, and the other is refused: asked once more.
    const auto one = readings(board, {kReference, kStatus}, "8C 0A 00 00 05");
    QVERIFY(one && one->size() == 1 && one->front().id == kReference);
    // A stub.
    const auto none = readings(board, {kKp}, "00");
    QVERIFY(none && none->size() == 1 && none->front().status == ReadStatus::NotSupported);
}

void TestMcpAnswers::whatDoesNotFitIsLost_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("no status") << QByteArray("");
    QTest::newRow("one missing") << QByteArray("8C 0A 00 00 00");
    QTest::newRow("all missing") << QByteArray("00");
    QTest::newRow("within a value") << QByteArray("8C 0A 00");
    QTest::newRow("within a value, refused") << QByteArray("8C 0A 05");
    QTest::newRow("bytes behind the last") << QByteArray("8C 0A 00 00 06 07 00");
    QTest::newRow("all there, and refused") << QByteArray("8C 0A 00 00 06 05");
}

void TestMcpAnswers::whatDoesNotFitIsLost()
{
    QFETCH(QByteArray, bytes);
    const McpFacts board = factsOfBoard();
    QVERIFY(!readings(board, {kReference, kStatus}, bytes.constData()));
    Reader<McpProtocol> reader(board);
    reader.start({kStatus, kReference});
    for (int i = 0; i < McpProtocol::kAttempts; ++i) {
        QVERIFY(!reader.gaveUp() && asksFor<McpGet>(reader.nextRequest()));
        const Bytes payload = hex(bytes.constData());
        QVERIFY(reader.onResponse(mcp::decodeResponse(payload), kAnswered).empty());
    }
    QVERIFY(reader.gaveUp() && reader.finished());
}

void TestMcpAnswers::aStructureOfAnotherSizeIsLost()
{
    McpFacts board = factsOfBoard();
    const auto read = [&](const char *bytes) { return readings(board, {kGlobalConfig}, bytes); };
    QVERIFY(!read("0A 00 00 02 03 06 01 02 0A 00 00 00")); // a byte short of its size
    QVERIFY(!read("02 00 01 02 03 00")); // one more
    QVERIFY(!read("0A 00")); // half a size
    QVERIFY(read("02 00 01 02 00").has_value());
    board.structureSizes[kGlobalConfig] = 10;
    QVERIFY(!read("02 00 01 02 00"));
    QVERIFY(read("0A 00 00 02 03 06 01 02 0A 00 00 00 00").has_value());
}

void TestMcpAnswers::aCommandIsDoneWithAnOkAlone()
{
    const auto end = [](const char *bytes) {
        const Bytes payload = hex(bytes);
        return McpProtocol::endIn(mcp::decodeResponse(payload));
    };
    QVERIFY(end("00").outcome == Outcome::Ok);
    QVERIFY(end("01").outcome == Outcome::Refused && end("01").reason == "CMD_NOK");
    QVERIFY(end("0A 01").outcome == Outcome::Refused && end("0A 01").reason == "BAD_RAW_FORMAT");
    for (const char *bytes : {"00 00", "00 01"})
        QVERIFY(end(bytes).outcome == Outcome::Refused);
    for (const char *bytes : {"", "00 00 00", "00 00 01"}) {
        QVERIFY(end(bytes).outcome == Outcome::Unknown);
        QCOMPARE(end(bytes).reason, "an answer that fits nothing");
    }
}

void TestMcpAnswers::aListThatIsNotClearlyAnsweredIsReadBack_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("no status") << QByteArray("");
    QTest::newRow("a refusal of all") << QByteArray("01");
    QTest::newRow("an OK behind good ones") << QByteArray("00 00 00");
    QTest::newRow("an OK behind a bad one") << QByteArray("00 04 00");
    QTest::newRow("no NOK at the end") << QByteArray("00 04 04");
    QTest::newRow("more than were written") << QByteArray("00 00 00 01");
}

/// Neither is taken for done, and neither is written a second time.
void TestMcpAnswers::aListThatIsNotClearlyAnsweredIsReadBack()
{
    QFETCH(QByteArray, bytes);
    const McpFacts board = factsOfBoard();
    McpWriteTask task(1, Write{{{kKp, std::int64_t{11}}, {kKi, std::int64_t{12}}}}, board);
    QVERIFY(asksFor<McpGet>(task.nextRequest(kAnswered)));
    answer(task, "01 00 02 00 00");
    const auto set = task.nextRequest(kAnswered);
    QVERIFY(asksFor<McpSet>(set));
    QCOMPARE(std::get<McpSet>(*set).writes.size(), std::size_t{2});
    answer(task, bytes.constData());
    QVERIFY(asksFor<McpGet>(task.nextRequest(kAnswered)));
    answer(task, "0B 00 02 00 00"); // one was taken
    QVERIFY(!task.nextRequest(kAnswered) && task.finished());
    const auto &writes = task.ended().writes;
    QCOMPARE(writes.size(), std::size_t{2});
    QVERIFY(writes[0].outcome == Outcome::Ok && writes[0].verified == true);
    QVERIFY(writes[1].outcome == Outcome::Refused);
    QCOMPARE(writes[1].reason, "no answer, and another value is read back");
}

QTEST_APPLESS_MAIN(TestMcpAnswers)
#include "tst_mcp_answers.moc"
