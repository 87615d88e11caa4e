// The master of MCB: every session of the vectors from its side, byte for byte, then what a bad wire and a bad slave do
// to it. Virtual time.
#include "support/mcb/bus.h"
#include "support/mcb/vectors.h"

#include <QtTest>

using namespace mcb;
using namespace std::chrono_literals;
using End = Master::End;
using Cause = Master::Cause;
using State = Master::State;
using support::McbBus;

class TestMcbMaster : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void sessionsOfTheVectorsAreSpoken_data();
    void sessionsOfTheVectorsAreSpoken();
    void theWayThroughTheCyclicStateIsSpoken();
    void aSlowAnswerIsWaitedFor();
    void noAnswerEndsInTime();
    void aSlowLineDoesNotPutOffTheEnd();
    void aDamagedAnswerIsAskedForAgain();
    void aDamagedFragmentSpoilsTheWholeValue();
    void aLostAckOfAWriteIsNeverRepeated();
    void anAnswerOfAnotherRegisterIsNone();
    void aStaleAnswerInTheRequestFrameIsNone();
    void codesWithSwappedWordsAreUnderstood();
    void aCrcErrorOfTheSlaveMeansNotDone();
    void deadLinesAreToldApart_data();
    void deadLinesAreToldApart();
    void aStuckReadyLineIsTold();
    void aFrameWaitsForTheEdge();
    void aSlaveThatResetsInTheCyclicStateIsNoticed_data();
    void aSlaveThatResetsInTheCyclicStateIsNoticed();
    void aSlaveOutOfStepByAByteIsPutBack_data();
    void aSlaveOutOfStepByAByteIsPutBack();
    void aSlaveThatIsCyclingIsBroughtBack();
    void aLostAckOfTheSwitchIsFoundOut_data();
    void aLostAckOfTheSwitchIsFoundOut();
    void lostCyclesAreCountedByTheirTicks();
    void aHurriedRequestDisturbsNoCycle();
    void aRefusedMappingStaysInTheConfigState();
    void aRequestCanBeCutOff();
    void whatHasNotLeftIsRecalled();
    void whatIsRecalledIsNotRepeated();
    void aRequestLeavesInTimeOrNever();
    void theProbeIsAcceptedByNoSlave();
};

namespace {

constexpr std::uint16_t kStatus = 0x011;

QJsonObject headRow() { return support::mcbVectors().front(); }
simulation::McbRig rig(int delay = 0)
{
    auto made = support::mcbRig(headRow(), {});
    made.replyDelay = delay;
    return made;
}
const Mapping kMapping{{{0x010, 2}, {0x01A, 4}}, {{kStatus, 2}, {0x060, 4}}};

void flip(Bytes &bytes) { bytes[3] ^= 0x10; }

} // namespace

void TestMcbMaster::sessionsOfTheVectorsAreSpoken_data()
{
    QTest::addColumn<QJsonObject>("row");
    for (const QJsonObject &row : support::mcbVectors())
        if (row[QLatin1String("kind")] == QLatin1String("transcript")
            && row[QLatin1String("name")] != QLatin1String("map_cycle_and_back"))
            QTest::newRow(qPrintable(row[QLatin1String("name")].toString())) << row;
}

void TestMcbMaster::sessionsOfTheVectorsAreSpoken()
{
    QFETCH(QJsonObject, row);
    McbBus bus(support::mcbRig(headRow(), row));
    QVERIFY(bus.meet());
    bus.sent.clear();
    const QJsonObject decoded = row[QLatin1String("decoded")].toObject();
    const QJsonObject operation = decoded[QLatin1String("operation")].toObject();
    const QJsonObject outcome = decoded[QLatin1String("outcome")].toObject();
    const QString what = operation[QLatin1String("op")].toString();
    Master::Request request;
    request.address = static_cast<std::uint16_t>(operation[QLatin1String("address")].toInt());
    request.command = what == QLatin1String("write") ? Command::Write
        : what == QLatin1String("info")              ? Command::GetInfo
                                                     : Command::Read;
    request.words = support::wordsOfHex(operation[QLatin1String("words")].toArray());
    const auto done = bus.ask(request);
    QVERIFY(done);
    const QJsonArray transfers = row[QLatin1String("transfers")].toArray();
    QVERIFY(bus.sent.size() >= static_cast<std::size_t>(transfers.size()));
    for (qsizetype i = 0; i < transfers.size(); ++i)
        QCOMPARE(support::hexOf(bus.sent[static_cast<std::size_t>(i)]),
            transfers[i].toArray()[0].toString());
    QCOMPARE(done->end == End::Ok, outcome[QLatin1String("ok")].toBool());
    if (done->end != End::Ok) {
        QCOMPARE(QString::number(done->code, 16).rightJustified(8, u'0'),
            outcome[QLatin1String("error")].toString());
        return;
    }
    if (outcome.contains(QLatin1String("words"))) {
        const Words words = support::wordsOfHex(outcome[QLatin1String("words")].toArray());
        QVERIFY(done->words.size() >= words.size());
        QVERIFY(std::equal(words.begin(), words.end(), done->words.begin()));
    }
    if (outcome.contains(QLatin1String("text"))) {
        const bool high =
            outcome[QLatin1String("string_order")] == QLatin1String("high byte first");
        const Info info{static_cast<std::uint8_t>(2 * done->words.size()), Type::Text};
        QCOMPARE(decodeValue(
                     info, done->words, high ? TextOrder::HighByteFirst : TextOrder::LowByteFirst),
            (Result<catalog::Value, ValueError>(
                outcome[QLatin1String("text")].toString().toStdString())));
    }
}

void TestMcbMaster::theWayThroughTheCyclicStateIsSpoken()
{
    QJsonObject row;
    for (const QJsonObject &one : support::mcbVectors())
        if (one[QLatin1String("name")] == QLatin1String("map_cycle_and_back"))
            row = one;
    QVERIFY(!row.isEmpty());
    McbBus bus(support::mcbRig(headRow(), row));
    QVERIFY(bus.meet());
    bus.sent.clear();
    bus.carry({0x0006, 0xCCCD, 0x3F8C}, kMapping);
    bus.master.switchOn(kMapping, 1ms, bus.now, false);
    QVERIFY(bus.runUntil([&] { return bus.cycles.size() == 2; }, 1s));
    QCOMPARE(bus.ended.back().end, End::Ok);
    bus.master.send({Command::Read, 0x6E0}, bus.now);
    QVERIFY(bus.runUntil([&] { return bus.ended.size() == 2; }, 1s));
    bus.master.send({Command::Read, 0x6E4}, bus.now);
    QVERIFY(bus.runUntil([&] { return bus.ended.size() == 3; }, 1s));
    bus.master.switchOff(bus.now);
    QVERIFY(bus.runUntil([&] { return bus.ended.size() == 4; }, 1s));
    bus.master.send({Command::Read, kStatus}, bus.now);
    QVERIFY(bus.runUntil([&] { return bus.ended.size() == 5; }, 1s));
    const QJsonArray transfers = row[QLatin1String("transfers")].toArray();
    QCOMPARE(bus.sent.size(), static_cast<std::size_t>(transfers.size()));
    for (qsizetype i = 0; i < transfers.size(); ++i)
        QCOMPARE(support::hexOf(bus.sent[static_cast<std::size_t>(i)]),
            transfers[i].toArray()[0].toString());
    QCOMPARE(bus.cycles.front().input, (Words{0x1637, 0x0000, 0x41C0}));
}

void TestMcbMaster::aSlowAnswerIsWaitedFor()
{
    McbBus bus(rig(40));
    QVERIFY(bus.meet());
    const auto done = bus.read(kStatus);
    QVERIFY(done);
    QCOMPARE(done->end, End::Ok);
    QCOMPARE(done->words.front(), std::uint16_t{0x1637});
}

void TestMcbMaster::noAnswerEndsInTime()
{
    McbBus bus(rig(1'000'000));
    QVERIFY(bus.meet());
    const TimePoint begun = bus.now;
    const auto done = bus.write(0x010, {6});
    QVERIFY(done);
    QCOMPARE(done->end, End::Unknown);
    QCOMPARE(done->cause, Cause::NoAnswer);
    QVERIFY(bus.now - begun <= 510ms);
    const auto second = bus.read(kStatus); // which is asked three times
    QVERIFY(second);
    QCOMPARE(second->end, End::Unknown);
    QVERIFY(bus.now - begun <= 2200ms); // with a silence behind each
}

/// The question for the answer follows the one before at once there: none of them is the last by itself.
void TestMcbMaster::aSlowLineDoesNotPutOffTheEnd()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    bus.frameTime = 2ms;
    bool forgets = true;
    bus.toMaster = [&](Bytes &) {
        if (std::exchange(forgets, false))
            bus.resetSlave(); // with the request that it has just taken
    };
    const TimePoint begun = bus.now;
    const auto done = bus.read(kStatus);
    QVERIFY(done);
    QCOMPARE(done->end, End::Ok); // when it was asked again
    QVERIFY(bus.now - begun >= 500ms && bus.now - begun < 600ms);
}

void TestMcbMaster::aDamagedAnswerIsAskedForAgain()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    int damaged = 0;
    bus.toMaster = [&](Bytes &bytes) {
        if (bytes[1] != 0x0E && ++damaged == 1)
            flip(bytes);
    };
    const auto done = bus.read(kStatus);
    QVERIFY(done);
    QCOMPARE(damaged, 2);
    QCOMPARE(done->end, End::Ok);
    QCOMPARE(done->words.front(), std::uint16_t{0x1637});
}

void TestMcbMaster::aDamagedFragmentSpoilsTheWholeValue()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    int seen = 0;
    bus.toMaster = [&](Bytes &bytes) {
        if (bytes[0] == 0x6E && ++seen == 1) // the first fragment of two
            flip(bytes);
    };
    const auto done = bus.read(0x6E4);
    QVERIFY(done);
    QCOMPARE(done->end, End::Ok);
    QCOMPARE(done->words.size(), std::size_t{8});
    QCOMPARE(seen, 4);
}

void TestMcbMaster::aLostAckOfAWriteIsNeverRepeated()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    bus.sent.clear();
    bus.toMaster = [](Bytes &bytes) {
        if (bytes[0] == 0x01 && bytes[1] == 0x06)
            flip(bytes);
    };
    const auto done = bus.write(0x010, {6});
    QVERIFY(done);
    QCOMPARE(done->end, End::Unknown);
    QCOMPARE(done->cause, Cause::Damaged);
    const Bytes request = encodeFrame({0x010, Command::Write, false, {6}, {}});
    QCOMPARE(std::count(bus.sent.begin(), bus.sent.end(), request), 1);
    QCOMPARE(bus.slave->registers().find(0x010)->words.front(), std::uint16_t{6});
}

void TestMcbMaster::anAnswerOfAnotherRegisterIsNone()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    int foreign = 0;
    bus.toMaster = [&](Bytes &bytes) {
        const auto frame = decodeAnswer(bytes);
        if (frame && frame->command == Command::Ack && ++foreign == 1)
            bytes = encodeFrame({0x060, Command::Ack, false, {0xDEAD}, {}});
    };
    const auto done = bus.read(kStatus);
    QVERIFY(done);
    QCOMPARE(done->end, End::Ok);
    QCOMPARE(done->words.front(), std::uint16_t{0x1637});
    QCOMPARE(bus.master.stats().strays, std::uint64_t{1});
}

void TestMcbMaster::aStaleAnswerInTheRequestFrameIsNone()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    bool first = true;
    bus.toMaster = [&](Bytes &bytes) {
        if (std::exchange(first, false))
            bytes = encodeFrame({kStatus, Command::Ack, false, {0xDEAD}, {}});
    };
    const auto done = bus.read(kStatus);
    QVERIFY(done);
    QCOMPARE(done->words.front(), std::uint16_t{0x1637});
}

void TestMcbMaster::codesWithSwappedWordsAreUnderstood()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    bus.toMaster = [](Bytes &bytes) {
        if (decodeAnswer(bytes)->command == Command::ErrorOfRead)
            bytes = encodeFrame({0x123, Command::ErrorOfRead, false, {0x0602, 0x0000}, {}});
    };
    const auto done = bus.read(0x123);
    QVERIFY(done);
    QCOMPARE(done->end, End::Refused);
    QCOMPARE(done->code, std::uint32_t{0x06020000});
}

void TestMcbMaster::aCrcErrorOfTheSlaveMeansNotDone()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    const auto refuseCrc =
        encodeFrame({0, Command::ErrorOfInfo, false, configOf(ErrorCode::BadCrc), {}});
    bool before = false;
    bus.toSlave = [&](Bytes &bytes) {
        before = (bytes[1] & 0x0E) == 0x04; // a write
        if (before)
            flip(bytes);
    };
    bool due = false;
    bus.toMaster = [&](Bytes &bytes) {
        if (std::exchange(due, before))
            bytes = refuseCrc;
    };
    const auto done = bus.write(0x010, {6});
    QVERIFY(done);
    QCOMPARE(done->end, End::NotSent);
    QCOMPARE(bus.slave->registers().find(0x010)->words.front(), std::uint16_t{0});
}

void TestMcbMaster::deadLinesAreToldApart_data()
{
    QTest::addColumn<int>("content"); // -1: nothing comes back
    QTest::addColumn<int>("cause");
    QTest::newRow("low") << 0x00 << int(Cause::DeadLow);
    QTest::newRow("high") << 0xFF << int(Cause::DeadHigh);
    QTest::newRow("silent") << -1 << int(Cause::NoAnswer);
    QTest::newRow("garbage") << 0x5A << int(Cause::Garbage);
}

void TestMcbMaster::deadLinesAreToldApart()
{
    QFETCH(int, content);
    QFETCH(int, cause);
    McbBus bus(rig());
    bus.toMaster = [=](Bytes &bytes) {
        if (content < 0)
            bytes.clear();
        std::fill(bytes.begin(), bytes.end(), static_cast<std::uint8_t>(content));
    };
    bus.master.connect(bus.now);
    bus.runFor(5s);
    QCOMPARE(bus.master.state(), State::Lost);
    QCOMPARE(bus.count<Master::Met>(), std::size_t{0});
    QCOMPARE(bus.count<Master::Lost>(), std::size_t{1});
    QCOMPARE(int(bus.last<Master::Lost>()->cause), cause);
    QVERIFY(!bus.master.nextTimeout());
}

void TestMcbMaster::aStuckReadyLineIsTold()
{
    McbBus bus(rig());
    bus.master.setReady(true, bus.now);
    QVERIFY(bus.meet()); // and the line stays low behind the first frame
    QCOMPARE(bus.master.state(), State::Config);
    const std::size_t frames = bus.sent.size();
    const TimePoint begun = bus.now;
    bus.master.send({Command::Write, 0x010, {6}}, bus.now);
    bus.runUntil([&] { return !bus.ended.empty(); }, 3s);
    QCOMPARE(bus.ended.size(), std::size_t{1});
    QCOMPARE(bus.ended.front().end, End::NotSent);
    QCOMPARE(bus.ended.front().cause, Cause::NotReady);
    QCOMPARE(bus.now - begun, Duration(1s));
    QCOMPARE(bus.last<Master::Lost>()->cause, Cause::NotReady);
    QCOMPARE(bus.sent.size(), frames); // nothing was clocked
}

void TestMcbMaster::aFrameWaitsForTheEdge()
{
    McbBus bus(rig());
    bus.master.setReady(true, bus.now);
    bus.master.connect(bus.now);
    bus.exchange();
    QCOMPARE(bus.sent.size(), std::size_t{1});
    bus.master.send({Command::Read, kStatus}, bus.now);
    bus.exchange();
    QCOMPARE(bus.sent.size(), std::size_t{1});
    for (int i = 0; i < 2; ++i) {
        bus.now += 5us;
        bus.master.setReady(true, bus.now);
        bus.exchange();
        QCOMPARE(bus.sent.size(), static_cast<std::size_t>(2 + i));
    }
    QCOMPARE(bus.ended.size(), std::size_t{1});
    QCOMPARE(bus.ended.front().end, End::Ok);
}

/// One that hears frames fills its answer up; one that hears bytes takes a frame of twice the length for two.
void TestMcbMaster::aSlaveThatResetsInTheCyclicStateIsNoticed_data()
{
    QTest::addColumn<Mapping>("mapping");
    QTest::addColumn<bool>("bytes");
    const Mapping twice{{}, {{0x060, 4}, {0x060, 4}, {0x060, 4}}};
    QTest::newRow("by frames") << kMapping << false;
    QTest::newRow("by frames of twice the length") << twice << false;
    QTest::newRow("by bytes") << twice << true;
}

void TestMcbMaster::aSlaveThatResetsInTheCyclicStateIsNoticed()
{
    QFETCH(const Mapping, mapping);
    QFETCH(const bool, bytes);
    McbBus bus(rig());
    QVERIFY(bus.meet());
    QCOMPARE(bus.map(mapping)->end, End::Ok);
    bus.runFor(20ms);
    bus.resetSlave();
    const Bytes idle = encodeFrame(Frame{0, Command::Idle, false, {}, {}});
    if (bytes)
        bus.toMaster = [&](Bytes &answer) {
            if (answer.size() == 2 * kConfigFrameBytes)
                std::copy(idle.begin(), idle.end(), answer.begin() + kConfigFrameBytes);
        };
    bus.cycles.clear();
    QVERIFY(bus.runUntil([&] { return bus.count<Master::Back>() == 1; }, 2s));
    QVERIFY(bus.last<Master::Back>()->afterReset);
    QCOMPARE(bus.master.state(), State::Config);
    QVERIFY(bus.cycles.empty()); // no sample of a slave that sent none
    QCOMPARE(bus.read(kStatus)->end, End::Ok);
}

void TestMcbMaster::aSlaveOutOfStepByAByteIsPutBack_data()
{
    QTest::addColumn<bool>("cyclic");
    QTest::newRow("config state") << false;
    QTest::newRow("cyclic state") << true;
}

/// Noise on a byte stream. The slave takes no frame any more, and what it answers has a right check.
void TestMcbMaster::aSlaveOutOfStepByAByteIsPutBack()
{
    QFETCH(const bool, cyclic);
    Master master;
    simulation::McbStream slave(rig());
    TimePoint now{1s};
    std::vector<Master::Done> ended;
    const auto runUntil = [&](const auto &condition, Duration limit) {
        const TimePoint end = now + limit;
        while (!condition()) {
            for (auto outputs = master.takeOutput(); !outputs.empty();
                 outputs = master.takeOutput())
                for (const Output &output : outputs) {
                    slave.receive(output.bytes, now);
                    master.receive(slave.takeOutput(), now);
                }
            for (Master::Event &event : master.takeEvents())
                if (auto *done = std::get_if<Master::Done>(&event))
                    ended.push_back(std::move(*done));
            const auto next = master.nextTimeout();
            if (condition() || !next || *next > end)
                break;
            now = std::max(now, *next);
            slave.advance(now);
            master.handleTimeout(now);
        }
        return condition();
    };
    const auto answered = [&] { return !ended.empty() && ended.back().end == End::Ok; };
    master.connect(now);
    QVERIFY(runUntil([&] { return master.canSend(); }, 1s));
    if (cyclic) {
        master.switchOn(kMapping, 1ms, now);
        QVERIFY(runUntil(answered, 1s));
    }
    ended.clear();
    slave.receive(Bytes{0x55}, now);
    master.send({Command::Read, kStatus}, now);
    QVERIFY(runUntil(answered, 1s)); // was not at all
    QCOMPARE(ended.size(), std::size_t{1});

    // A Stop does not wait for the time-out: it takes the place of what is not answered.
    ended.clear();
    slave.receive(Bytes{0x55}, now);
    master.send({Command::Write, 0x010, {0x6}}, now);
    QVERIFY(!runUntil(answered, 100ms));
    master.cancel(now);
    master.send({Command::Write, 0x010, {0x6}}, now);
    QVERIFY(runUntil(answered, 100ms));
}

void TestMcbMaster::aSlaveThatIsCyclingIsBroughtBack()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    QCOMPARE(bus.map(kMapping)->end, End::Ok);
    bus.carry({6, 0, 0}, kMapping);
    bus.runFor(5ms);
    QVERIFY(bus.slave->cyclic());
    bus.master = Master();
    bus.events.clear();
    QVERIFY(bus.meet());
    QVERIFY(!bus.slave->cyclic());
    QCOMPARE(bus.count<Master::Met>(), std::size_t{1});
    QCOMPARE(bus.read(kStatus)->end, End::Ok);
}

void TestMcbMaster::aLostAckOfTheSwitchIsFoundOut_data()
{
    QTest::addColumn<bool>("on");
    QTest::addColumn<bool>("requestLost");
    for (const bool on : {true, false})
        for (const bool lost : {true, false})
            QTest::addRow("%s, %s lost", on ? "on" : "off", lost ? "request" : "ACK") << on << lost;
}

void TestMcbMaster::aLostAckOfTheSwitchIsFoundOut()
{
    QFETCH(bool, on);
    QFETCH(bool, requestLost);
    McbBus bus(rig());
    QVERIFY(bus.meet());
    if (!on)
        QCOMPARE(bus.map(kMapping)->end, End::Ok);
    int left = 1;
    const std::uint8_t value = on ? 2 : 1;
    bus.toSlave = [&](Bytes &bytes) {
        if (requestLost && bytes[0] == 0x64 && bytes[1] == 0x04 && bytes[3] == value && left-- > 0)
            flip(bytes);
    };
    bus.toMaster = [&](Bytes &bytes) {
        if (!requestLost && bytes[0] == 0x64 && bytes[1] == 0x06 && bytes[3] == value && left-- > 0)
            flip(bytes);
    };
    bus.ended.clear();
    if (on)
        bus.master.switchOn(kMapping, 1ms, bus.now);
    else
        bus.master.switchOff(bus.now);
    QVERIFY(bus.runUntil([&] { return !bus.ended.empty(); }, 5s));
    QCOMPARE(bus.ended.size(), std::size_t{1});
    QCOMPARE(bus.ended.front().end, requestLost ? End::NotSent : End::Ok);
    QCOMPARE(bus.slave->cyclic(), on != requestLost);
    QCOMPARE(bus.master.state(), bus.slave->cyclic() ? State::Cyclic : State::Config);
    QCOMPARE(bus.read(kStatus)->end, End::Ok);
}

void TestMcbMaster::lostCyclesAreCountedByTheirTicks()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    QCOMPARE(bus.map(kMapping)->end, End::Ok);
    bus.cycles.clear();
    int number = 0;
    bus.toMaster = [&](Bytes &bytes) {
        if (++number == 5)
            flip(bytes);
    };
    bus.runFor(10ms);
    QVERIFY(bus.cycles.size() >= 8);
    for (std::size_t i = 1; i < bus.cycles.size(); ++i)
        QCOMPARE(bus.cycles[i].tick - bus.cycles[i - 1].tick, std::int64_t{i == 4 ? 2 : 1});
    QCOMPARE(bus.master.stats().cyclesLost, std::uint64_t{1});
}

void TestMcbMaster::aHurriedRequestDisturbsNoCycle()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    bus.master.switchOn(kMapping, 100ms, bus.now);
    QVERIFY(bus.runUntil([&] { return bus.cycles.size() == 2; }, 5s));
    bus.runFor(30ms);
    bus.master.setHurried(true, bus.now);
    const TimePoint asked = bus.now;
    QCOMPARE(bus.write(0x010, {6})->end, End::Ok);
    QVERIFY(bus.now - asked <= 5ms);
    bus.runFor(280ms);
    QCOMPARE(bus.cycles.size(), std::size_t{5});
    for (std::size_t i = 1; i < bus.cycles.size(); ++i) {
        QCOMPARE(bus.cycles[i].tick, std::int64_t(i));
        QCOMPARE(bus.cycles[i].at - bus.cycles[0].at, Duration(i * 100ms));
    }
    QCOMPARE(bus.master.stats().cyclesLost, std::uint64_t{0});
}

void TestMcbMaster::aRefusedMappingStaysInTheConfigState()
{
    McbBus bus(rig());
    QVERIFY(bus.meet());
    const auto done = bus.map({{}, {{0x010, 2}}}); // the control word goes the other way
    QVERIFY(done);
    QCOMPARE(done->end, End::Refused);
    QCOMPARE(done->code, std::uint32_t(ErrorCode::CannotBeMapped));
    QCOMPARE(done->request.address, std::uint16_t{0x661});
    QCOMPARE(bus.master.state(), State::Config);
    QVERIFY(bus.master.canSend());
}

void TestMcbMaster::aRequestCanBeCutOff()
{
    McbBus bus(rig(1'000'000));
    QVERIFY(bus.meet());
    bus.master.send({Command::Read, 0x6E4}, bus.now);
    bus.exchange();
    bus.master.cancel(bus.now);
    QVERIFY(bus.master.canSend());
    bus.master.send({Command::Write, 0x010, {0}}, bus.now);
    bus.exchange();
    QCOMPARE(bus.ended.size(), std::size_t{1});
    QCOMPARE(bus.ended.front().end, End::Unknown);
    QCOMPARE(bus.ended.front().cause, Cause::Cancelled);
    QCOMPARE(bus.slave->registers().find(0x010)->words.front(), std::uint16_t{0});
}

void TestMcbMaster::whatHasNotLeftIsRecalled()
{
    McbBus bus(rig());
    bus.master.setReady(true, bus.now);
    QVERIFY(bus.meet()); // and the line stays low behind the first frame
    const std::size_t frames = bus.sent.size();
    QVERIFY(!bus.master.recall(bus.now));
    bus.master.send({Command::Write, 0x010, {6}}, bus.now);
    QVERIFY(bus.master.recall(bus.now));
    QVERIFY(bus.master.canSend());
    bus.master.setReady(true, bus.now);
    bus.exchange();
    QCOMPARE(bus.sent.size(), frames);
    QCOMPARE(bus.ended.size(), std::size_t{1});
    QCOMPARE(bus.ended.front().end, End::NotSent);
}

void TestMcbMaster::whatIsRecalledIsNotRepeated()
{
    const auto refuseCrc =
        encodeFrame({0, Command::ErrorOfInfo, false, configOf(ErrorCode::BadCrc), {}});
    for (const bool recalled : {false, true}) {
        McbBus bus(rig());
        QVERIFY(bus.meet());
        int writes = 0;
        bool wrote = false, due = false;
        bus.toSlave = [&](Bytes &bytes) {
            wrote = (bytes[1] & 0x0E) == 0x04;
            if (!wrote)
                return;
            ++writes;
            flip(bytes);
            if (recalled)
                bus.master.recall(bus.now);
        };
        bus.toMaster = [&](Bytes &bytes) {
            if (std::exchange(due, wrote))
                bytes = refuseCrc;
        };
        const auto done = bus.write(0x010, {6});
        QVERIFY(done);
        QCOMPARE(done->end, End::NotSent);
        QCOMPARE(writes, recalled ? 1 : 3);
    }
}

void TestMcbMaster::aRequestLeavesInTimeOrNever()
{
    McbBus bus(rig());
    bus.master.setReady(true, bus.now);
    QVERIFY(bus.meet());
    const std::size_t frames = bus.sent.size();
    const TimePoint by = bus.now + 300ms;
    bus.master.send({Command::Write, 0x010, {6}, false, by}, bus.now);
    QVERIFY(bus.runUntil([&] { return !bus.ended.empty(); }, 2s));
    QCOMPARE(bus.now - by, Duration(0));
    QCOMPARE(bus.ended.front().end, End::NotSent);
    QCOMPARE(bus.sent.size(), frames);
    QVERIFY(bus.master.canSend()); // the line has its own time
}

void TestMcbMaster::theProbeIsAcceptedByNoSlave()
{
    for (std::size_t words = 0; words <= kMostCyclicWords; ++words)
        QVERIFY(!decodeFrame(Bytes(frameBytes(words), 0xFF)));
}

QTEST_GUILESS_MAIN(TestMcbMaster)
#include "tst_mcb_master.moc"
