// The MCB slave: every session of the vectors byte for byte, then the rules that they do not touch. Virtual time.
#include "simulation/mcb/slave.h"

#include "support/mcb/vectors.h"

#include <QtTest>

using namespace mcb;
using simulation::McbRegister;
using simulation::McbRig;
using simulation::McbSlave;
using simulation::McbStream;

class TestMcbSlave : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sessionsAreAnsweredByteForByte_data();
    void sessionsAreAnsweredByteForByte();
    void sessionsAreTheSameAsAStream_data() { sessionsAreAnsweredByteForByte_data(); }
    void sessionsAreTheSameAsAStream();
    void infoIsAnswered_data();
    void infoIsAnswered();
    void accessIsKept();
    void aMasterThatAnswersIsTold();
    void aDamagedFrameChangesNothing();
    void aFrameOfAnotherLengthChangesNothing();
    void aNewRequestDropsTheAnswerBefore();
    void anAnswerThatNobodySawSwitchesNothing();
    void damageBesideTheAckStillSwitches();
    void piecesOfAnotherRegisterBeginAnew();
    void tooManyPiecesAreRefused();
    void mappingIsChecked_data();
    void mappingIsChecked();
    void theMappingIsFullAtThirtyTwoWords();
    void theShorterDirectionIsPadded();
    void onlyAGoodFrameReachesTheCyclicRegisters();
    void aMappingInForceStaysUntilItIsSwitched();
    void piecesOfTheStreamAreGathered();
    void anUnfinishedFrameIsDropped();
    void aResetForgetsEverything();
};

namespace {

constexpr std::uint16_t kState = 0x640, kRx = 0x650, kTx = 0x660;

QJsonObject headRow() { return support::mcbVectors().front(); }

McbRegister registerOf(
    Type type, std::uint8_t size, Cyclic cyclic, catalog::Access access, Words words)
{
    return {{size, type, cyclic, access}, std::move(words)};
}

/// A slave of row 0 with larger registers besides, and a master's words for it.
struct SlaveBench {
    McbRig rig = support::mcbRig(headRow(), {});
    std::optional<McbSlave> made;

    McbSlave &slave()
    {
        if (!made)
            made.emplace(rig);
        return *made;
    }
    Bytes send(const Frame &frame) { return slave().exchange(encodeFrame(frame)); }
    /// The answer to a request in the config state, after one idle frame.
    Frame ask(Command command, std::uint16_t address, ConfigWords config = {})
    {
        const auto idle = decodeAnswer(send({address, command, false, config, cyclic}));
        if (!idle || idle->command != Command::Idle)
            return {};
        return next();
    }
    Frame next()
    {
        return decodeAnswer(send({0, Command::Idle, false, {}, cyclic})).value_or(Frame());
    }
    /// 0: acknowledged.
    std::uint32_t write(std::uint16_t address, ConfigWords config)
    {
        const Frame answer = ask(Command::Write, address, config);
        if (answer.command == Command::Ack && answer.address == address)
            return 0;
        return answer.command == Command::ErrorOfWrite ? errorCodeOf(answer.config) : UINT32_MAX;
    }
    std::uint16_t read(std::uint16_t address) { return ask(Command::Read, address).config[0]; }
    bool goCyclic()
    {
        const bool done = write(kRx + 1, {0x010, 2, 0, 0}) == 0
            && write(kTx + 1, {0x060, 4, 0, 0}) == 0 && write(kRx, {1, 0, 0, 0}) == 0
            && write(kTx, {1, 0, 0, 0}) == 0 && write(kState, {2, 0, 0, 0}) == 0;
        cyclic = Words(2);
        return done && slave().cyclic();
    }

    Words cyclic; ///< what each frame carries
};

std::uint32_t number(ErrorCode code) { return static_cast<std::uint32_t>(code); }

} // namespace

void TestMcbSlave::sessionsAreAnsweredByteForByte_data()
{
    QTest::addColumn<QJsonObject>("row");
    for (const QJsonObject &row : support::mcbVectors()) {
        if (row["kind"].toString() == "transcript")
            QTest::newRow(qPrintable(row["name"].toString())) << row;
    }
}

void TestMcbSlave::sessionsAreAnsweredByteForByte()
{
    QFETCH(QJsonObject, row);
    McbSlave slave(support::mcbRig(headRow(), row));
    for (const auto &transfer : row["transfers"].toArray()) {
        const Bytes asked = support::bytesOfHex(transfer.toArray()[0].toString());
        QCOMPARE(slave.frameBytes(), asked.size());
        QCOMPARE(support::hexOf(slave.exchange(asked)), transfer.toArray()[1].toString());
    }
    QCOMPARE(slave.counts().badFrames + slave.counts().wrongLength, 0U);
}

void TestMcbSlave::sessionsAreTheSameAsAStream()
{
    QFETCH(QJsonObject, row);
    McbStream stream(support::mcbRig(headRow(), row));
    Bytes all;
    QString meant;
    for (const auto &transfer : row["transfers"].toArray()) {
        const Bytes asked = support::bytesOfHex(transfer.toArray()[0].toString());
        all.insert(all.end(), asked.begin(), asked.end());
        meant += transfer.toArray()[1].toString();
    }
    stream.receive(all, TimePoint{}); // all at once
    QCOMPARE(support::hexOf(stream.takeOutput()), meant);
    QVERIFY(stream.takeOutput().empty());
}

void TestMcbSlave::infoIsAnswered_data()
{
    QTest::addColumn<QJsonObject>("row");
    for (const QJsonObject &row : support::mcbVectors()) {
        if (row["kind"].toString() == "info")
            QTest::newRow(qPrintable(row["name"].toString())) << row;
    }
}

void TestMcbSlave::infoIsAnswered()
{
    QFETCH(QJsonObject, row);
    SlaveBench bench;
    bench.rig.registers[0x6DB] = registerOf(
        Type::UInt32, 4, Cyclic::ConfigOnly, catalog::Access::Write, {0, 0}); // not in row 0
    const Bytes idle = encodeFrame({});
    QVERIFY(bench.slave().exchange(support::bytesOfHex(row["request"].toString())) == idle);
    QCOMPARE(support::hexOf(bench.slave().exchange(idle)), row["reply"].toString());
}

void TestMcbSlave::accessIsKept()
{
    SlaveBench bench;
    bench.rig.registers[0x6DB] =
        registerOf(Type::UInt32, 4, Cyclic::ConfigOnly, catalog::Access::Write, {7, 0});
    const Frame refused = bench.ask(Command::Read, 0x6DB);
    QVERIFY(refused.command == Command::ErrorOfRead);
    QCOMPARE(errorCodeOf(refused.config), number(ErrorCode::AccessNotSupported));
    QCOMPARE(bench.write(0x6DB, {0x6173, 0x6576, 0, 0}), 0U);
    QVERIFY((bench.slave().registers().find(0x6DB)->words == Words{0x6173, 0x6576}));
    QCOMPARE(bench.write(0x011, {1, 0, 0, 0}), number(ErrorCode::AccessNotSupported));
    QCOMPARE(bench.write(0x123, {1, 0, 0, 0}), number(ErrorCode::NoSuchRegister));
    QCOMPARE(bench.read(0x011), 0x1637);
}

void TestMcbSlave::aMasterThatAnswersIsTold()
{
    for (const Command command :
        {Command::Ack, Command::ErrorOfInfo, Command::ErrorOfRead, Command::ErrorOfWrite}) {
        SlaveBench bench;
        const Frame answer = bench.ask(command, 0x010);
        QVERIFY(answer.command == Command::ErrorOfInfo);
        QCOMPARE(errorCodeOf(answer.config), number(ErrorCode::InvalidCommand));
    }
}

void TestMcbSlave::aDamagedFrameChangesNothing()
{
    SlaveBench bench;
    Bytes damaged = encodeFrame({0x010, Command::Write, false, {6, 0, 0, 0}, {}});
    damaged[3] ^= 1;
    QVERIFY(bench.slave().exchange(damaged) == encodeFrame({}));
    QVERIFY(bench.next() == Frame());
    QCOMPARE(bench.slave().counts().badFrames, 1U);
    QCOMPARE(bench.read(0x010), 0);
}

void TestMcbSlave::aFrameOfAnotherLengthChangesNothing()
{
    SlaveBench bench;
    const Bytes idle = encodeFrame({});
    const Bytes longer = encodeFrame({0x010, Command::Write, false, {6, 0, 0, 0}, {1, 2, 3}});
    Bytes filled = idle;
    filled.resize(longer.size());
    QVERIFY(bench.slave().exchange(longer) == filled);
    const Bytes cut(idle.begin(), idle.begin() + 4);
    QVERIFY(bench.slave().exchange(ByteView(longer).first(4)) == cut);
    QVERIFY(bench.slave().exchange({}).empty());
    QCOMPARE(bench.slave().counts().wrongLength, 3U);
    QCOMPARE(bench.read(0x010), 0);
}

void TestMcbSlave::aNewRequestDropsTheAnswerBefore()
{
    SlaveBench bench;
    bench.send({0x6E4, Command::Read, false, {}, {}});
    QVERIFY(bench.next().pending); // the first of two pieces
    bench.send({0x011, Command::Read, false, {}, {}}); // while the second goes out
    const Frame answer = bench.next();
    QCOMPARE(answer.address, 0x011);
    QVERIFY(bench.next() == Frame());

    bench.rig.replyDelay = 2;
    bench.made.reset();
    bench.send({0x6E4, Command::Read, false, {}, {}});
    bench.send({0x011, Command::Read, false, {}, {}});
    QVERIFY(bench.next() == Frame());
    QVERIFY(bench.next() == Frame());
    QCOMPARE(bench.next().address, 0x011);
    QVERIFY(bench.next() == Frame());
}

void TestMcbSlave::anAnswerThatNobodySawSwitchesNothing()
{
    SlaveBench bench;
    QVERIFY(bench.goCyclic());
    // The ACK of "off" goes out in a frame of the wrong length.
    bench.send({kState, Command::Write, false, {1, 0, 0, 0}, bench.cyclic});
    bench.slave().exchange(encodeFrame({}));
    QVERIFY(bench.slave().cyclic());
    QCOMPARE(bench.read(kState), 2); // the state that is in force
    // Another request replaces it before it was sent.
    bench.rig.replyDelay = 1;
    bench.made.reset();
    bench.cyclic.clear();
    bench.send({kRx + 1, Command::Write, false, {0x010, 2, 0, 0}, {}});
    bench.next();
    bench.next();
    bench.send({kRx, Command::Write, false, {1, 0, 0, 0}, {}});
    bench.next();
    bench.next();
    bench.send({kState, Command::Write, false, {2, 0, 0, 0}, {}});
    bench.send({kState, Command::Read, false, {}, {}});
    bench.next();
    QVERIFY((bench.next() == Frame{kState, Command::Ack, false, {1, 0, 0, 0}, {}}));
    QVERIFY(!bench.slave().cyclic());
}

void TestMcbSlave::damageBesideTheAckStillSwitches()
{
    SlaveBench bench;
    QVERIFY(bench.goCyclic());
    bench.send({kState, Command::Write, false, {1, 0, 0, 0}, bench.cyclic});
    const Bytes damaged(bench.slave().frameBytes(), 0x55);
    const auto ack = decodeAnswer(bench.slave().exchange(damaged));
    QVERIFY(ack && ack->command == Command::Ack && ack->address == kState);
    QVERIFY(!bench.slave().cyclic());
    bench.cyclic.clear();
    QCOMPARE(bench.read(0x011), 0x1637);
}

void TestMcbSlave::piecesOfAnotherRegisterBeginAnew()
{
    SlaveBench bench;
    bench.send({0x7FF, Command::Write, true, {1, 2, 3, 4}, {}});
    QVERIFY(bench.next().command == Command::Ack);
    QCOMPARE(bench.write(0x014, {35, 0, 0, 0}), 0U);
    QCOMPARE(bench.read(0x014), 35);
    QCOMPARE(bench.read(0x7FF), 0x8000);
}

void TestMcbSlave::tooManyPiecesAreRefused()
{
    SlaveBench bench;
    bench.send({0x014, Command::Write, true, {35, 0, 0, 0}, {}});
    QVERIFY(bench.next().command == Command::Ack);
    QCOMPARE(bench.write(0x014, {36, 0, 0, 0}), number(ErrorCode::General));
    QCOMPARE(bench.read(0x014), 34);
    for (std::size_t words = 0; words < kMostValueWords; words += kConfigWords)
        bench.send({0x014, Command::Write, true, {}, {}});
    QVERIFY(bench.next().command == Command::Ack);
    bench.send({0x014, Command::Write, true, {}, {}});
    QVERIFY(bench.next().command == Command::ErrorOfWrite);
}

void TestMcbSlave::mappingIsChecked_data()
{
    QTest::addColumn<int>("address");
    QTest::addColumn<int>("low");
    QTest::addColumn<int>("high");
    QTest::addColumn<quint32>("code");
    const auto row = [](const char *name, int address, int low, int high, ErrorCode code) {
        QTest::newRow(name) << address << low << high << quint32{number(code)};
    };
    row("a register that is not there", kRx + 1, 0x123, 2, ErrorCode::NoSuchRegister);
    row("rx of a tx register", kRx + 1, 0x011, 2, ErrorCode::CannotBeMapped);
    row("tx of an rx register", kTx + 1, 0x010, 2, ErrorCode::CannotBeMapped);
    row("config only", kTx + 1, 0x6E0, 4, ErrorCode::CannotBeMapped);
    row("the state itself", kRx + 1, kState, 2, ErrorCode::CannotBeMapped);
    row("of another size", kRx + 1, 0x010, 4, ErrorCode::CannotBeMapped);
    row("a gap", kRx + 2, 0x010, 2, ErrorCode::BadCyclicIndex);
    row("a gap in the other list", kTx + 15, 0x011, 2, ErrorCode::BadCyclicIndex);
    row("too many entries", kRx, 16, 0, ErrorCode::BadCyclicIndex);
    row("nothing mapped", kState, 2, 0, ErrorCode::MappingRefused);
    row("no such state", kState, 3, 0, ErrorCode::CyclicNotReachable);
}

void TestMcbSlave::mappingIsChecked()
{
    QFETCH(int, address);
    QFETCH(int, low);
    QFETCH(int, high);
    QFETCH(quint32, code);
    SlaveBench bench;
    const auto where = static_cast<std::uint16_t>(address);
    const std::uint16_t before = bench.read(where);
    QCOMPARE(bench.write(
                 where, {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(high), 0, 0}),
        code);
    QCOMPARE(bench.read(where), before);
    QVERIFY(!bench.slave().cyclic());
    // A count without its entries is found when cyclic is switched on.
    QCOMPARE(bench.write(kTx, {2, 0, 0, 0}), 0U);
    QCOMPARE(bench.write(kTx + 1, {0x011, 2, 0, 0}), 0U);
    QCOMPARE(bench.write(kState, {2, 0, 0, 0}), number(ErrorCode::MappingRefused));
    QCOMPARE(bench.write(kTx, {1, 0, 0, 0}), 0U);
    QCOMPARE(bench.write(kState, {2, 0, 0, 0}), 0U);
    QVERIFY(bench.slave().cyclic());
}

void TestMcbSlave::theMappingIsFullAtThirtyTwoWords()
{
    SlaveBench bench;
    bench.rig.registers[0x100] = registerOf(
        Type::Text, 61, Cyclic::Tx, catalog::Access::Read, Words(31, 0x4141)); // rounded up
    QCOMPARE(bench.write(kTx + 1, {0x100, 61, 0, 0}), 0U);
    QCOMPARE(bench.write(kTx + 2, {0x011, 2, 0, 0}), 0U);
    QCOMPARE(bench.write(kTx + 3, {0x011, 2, 0, 0}), 0U);
    QCOMPARE(bench.write(kTx, {3, 0, 0, 0}), 0U);
    QCOMPARE(bench.write(kState, {2, 0, 0, 0}), number(ErrorCode::TooMuchMapped));
    QCOMPARE(bench.slave().frameBytes(), kConfigFrameBytes);
    QCOMPARE(bench.write(kTx, {2, 0, 0, 0}), 0U);
    QCOMPARE(bench.write(kState, {2, 0, 0, 0}), 0U);
    QCOMPARE(bench.slave().frameBytes(), kMostFrameBytes);
}

void TestMcbSlave::theShorterDirectionIsPadded()
{
    SlaveBench bench;
    QCOMPARE(bench.write(kRx + 1, {0x01A, 4, 0, 0}), 0U);
    QCOMPARE(bench.write(kTx + 1, {0x011, 2, 0, 0}), 0U);
    QCOMPARE(bench.write(kRx, {1, 0, 0, 0}), 0U);
    QCOMPARE(bench.write(kTx, {1, 0, 0, 0}), 0U);
    QCOMPARE(bench.write(kState, {2, 0, 0, 0}), 0U);
    bench.cyclic = {0xCCCD, 0x3F8C};
    QVERIFY((bench.next().cyclic == Words{0x1637, 0}));
    QVERIFY((bench.slave().registers().find(0x01A)->words == Words{0xCCCD, 0x3F8C}));
}

void TestMcbSlave::onlyAGoodFrameReachesTheCyclicRegisters()
{
    SlaveBench bench;
    QVERIFY(bench.goCyclic());
    bench.cyclic = {6, 0};
    Bytes damaged = encodeFrame({0, Command::Idle, false, {}, bench.cyclic});
    damaged.back() ^= 1;
    bench.slave().exchange(damaged);
    QVERIFY((bench.slave().registers().find(0x010)->words == Words{0}));
    bench.next();
    QVERIFY((bench.slave().registers().find(0x010)->words == Words{6}));
}

void TestMcbSlave::aMappingInForceStaysUntilItIsSwitched()
{
    SlaveBench bench;
    QVERIFY(bench.goCyclic());
    QCOMPARE(bench.write(kTx + 1, {0, 0, 0, 0}), 0U);
    QVERIFY((bench.next().cyclic == Words{0, 0x41C0}));
    QCOMPARE(bench.slave().frameBytes(), frameBytes(2));
}

void TestMcbSlave::piecesOfTheStreamAreGathered()
{
    McbStream stream(support::mcbRig(headRow(), {}));
    const Bytes request = encodeFrame({0x011, Command::Read, false, {}, {}});
    TimePoint now{};
    for (const std::uint8_t byte : request) {
        QVERIFY(stream.takeOutput().empty());
        stream.receive(ByteView(&byte, 1), now);
        now += McbStream::kUnfinished - Duration(1);
        stream.advance(now);
    }
    QVERIFY(stream.takeOutput() == encodeFrame({}));
    QVERIFY(stream.nextWake() == TimePoint::max());
}

void TestMcbSlave::anUnfinishedFrameIsDropped()
{
    McbStream stream(support::mcbRig(headRow(), {}));
    const Bytes request = encodeFrame({0x011, Command::Read, false, {}, {}});
    TimePoint now{};
    stream.receive(ByteView(request).first(11), now);
    QVERIFY(stream.nextWake() == now + McbStream::kUnfinished);
    now = stream.nextWake();
    stream.advance(now);
    QVERIFY(stream.nextWake() == TimePoint::max());
    stream.receive(request, now);
    QVERIFY(stream.takeOutput() == encodeFrame({}));
    // Also when it was not called in time.
    stream.receive(ByteView(request).first(11), now);
    now += std::chrono::seconds(1);
    stream.receive(encodeFrame({}), now);
    QVERIFY(decodeAnswer(stream.takeOutput())->address == 0x011);
}

void TestMcbSlave::aResetForgetsEverything()
{
    McbStream stream(support::mcbRig(headRow(), {}));
    stream.receive(encodeFrame({0x014, Command::Write, false, {35, 0, 0, 0}, {}}), TimePoint{});
    stream.receive(Bytes(5), TimePoint{});
    stream.reset();
    QVERIFY(stream.takeOutput().empty());
    stream.receive(encodeFrame({0x014, Command::Read, false, {}, {}}), TimePoint{});
    stream.receive(encodeFrame({}), TimePoint{});
    const Bytes output = stream.takeOutput();
    QCOMPARE(output.size(), 2 * kConfigFrameBytes);
    QCOMPARE(decodeAnswer(ByteView(output).last(kConfigFrameBytes))->config[0], 34);
}

QTEST_APPLESS_MAIN(TestMcbSlave)
#include "tst_mcb_slave.moc"
