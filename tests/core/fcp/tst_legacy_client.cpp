// The master of the older serial protocol against the simulated boards and against lines that lie: each request ends
// once, no answer is taken for another's, and a board that hangs in half a frame comes back.
#include "base/overloaded.h"
#include "fcp/client.h"
#include "simulation/fcp/board.h"
#include "support/start_notice.h"

#include <QtTest>

using namespace std::chrono_literals;
using fcp::Client;

namespace {

/// A client and a board, joined by a line whose bytes can be dropped or changed.
struct Pair {
    explicit Pair(simulation::FcpRig rig = {})
        : board(std::move(rig))
    {
    }

    void pump()
    {
        for (int round = 0; round < 4; ++round) {
            for (Output &output : client.takeOutput()) {
                sent.insert(sent.end(), output.bytes.begin(), output.bytes.end());
                Bytes bytes = std::move(output.bytes);
                if (toBoard)
                    bytes = toBoard(std::move(bytes));
                board.receive(bytes, now);
            }
            board.advance(now);
            Bytes bytes = board.takeOutput();
            if (toClient)
                bytes = toClient(std::move(bytes));
            if (!bytes.empty())
                client.receive(bytes, now);
            client.handleTimeout(now);
            for (Client::Event &event : client.takeEvents())
                events.push_back(std::move(event));
        }
    }
    void runFor(Duration time)
    {
        for (const TimePoint end = now + time; now < end; now += 100us)
            pump();
    }
    bool connect()
    {
        client.connect(now);
        runFor(6s);
        return client.connected() && client.canSend();
    }
    template <class T>
    std::vector<T> all() const
    {
        std::vector<T> found;
        for (const Client::Event &event : events)
            if (const auto *one = std::get_if<T>(&event))
                found.push_back(*one);
        return found;
    }
    void ask(fcp::Command command, Duration time = 6s, std::uint8_t motor = 1)
    {
        events.clear();
        sent.clear();
        client.send({motor, std::move(command)}, now);
        runFor(time);
    }
    /// How often the last request ended.
    std::size_t ends() const
    {
        return all<Client::Answer>().size() + all<Client::NoAnswer>().size();
    }

    TimePoint now{1s};
    Client client{Client::Config{}};
    simulation::FcpBoard board;
    std::function<Bytes(Bytes)> toBoard, toClient;
    Bytes sent;
    std::vector<Client::Event> events;
};

const fcp::GetRegister kSpeed{0x1E};

} // namespace

class TestFcpClient : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void itFindsABoardAndReadsItsName();
    void aBoardWhoseInfoHasAnotherLengthIsFoundAndFoundAgain();
    void withoutABoardItGivesUp();
    void aLineThatBabblesIsGivenUp();
    void aBoardThatBeginsToBabbleIsGivenUp();
    void aBoardOfTheNewerProtocolIsRecognised();
    void everyRequestNamesItsMotor();
    void aDamagedAnswerEndsTheRequestAndTheLineSettles();
    void aDamagedRequestIsKnownNotToHaveBeenExecuted();
    void aLostAnswerIsFollowedByTheRecovery();
    void aBoardThatHangsInAFrameComesBack();
    void whileAMotorTurnsNothingIsFilledUpFirst();
    void anAnswerOfAnotherLengthIsNotBelieved();
    void aLateAnswerIsNotTakenForTheNext();
    void aSecondAnswerIsNotTakenForTheNext();
    void aRefusalWithoutACodeIsARefusal();
    void aStopGoesAheadOfAnOpenRequest();
    void theAnswerToAStopEndsTheWait();
    void theEndOfAnotherAnswerIsNotThatToAStop();
    void whatCameBeforeAStopLeftIsNotItsAnswer();
    void aStopGoesOutWithoutABoard();
    void aRestartIsTold();
};

void TestFcpClient::itFindsABoardAndReadsItsName()
{
    Pair pair;
    QVERIFY(pair.connect());
    const auto found = pair.all<Client::Connected>();
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE(found[0].board.version, std::string("5.4.3"));
    QVERIFY(!found[0].again);
    pair.ask(kSpeed, 20ms);
    QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{1});
}

/// The text of one dialect describes no layout of it.
void TestFcpClient::aBoardWhoseInfoHasAnotherLengthIsFoundAndFoundAgain()
{
    for (const std::size_t length : {1U, 3U, 9U, 40U}) {
        Pair pair;
        fcp::Framer framer(fcp::Framer::Side::Client);
        const auto other = [&](const Bytes &bytes) { // which come one by one
            Bytes out;
            fcp::Frame frame;
            for (ByteView left(bytes); !left.empty();)
                if (framer.next(left, frame) == fcp::Framer::Step::Frame)
                    out = frame.payload.size() == fcp::kInfoSize
                        ? fcp::encodeAck(Bytes(length, '7'))
                        : fcp::encodeFrame(frame.header, frame.payload);
            return out;
        };
        pair.toClient = other;
        QVERIFY(pair.connect());
        auto found = pair.all<Client::Connected>();
        QCOMPARE(found.size(), std::size_t{1});
        QCOMPARE(found[0].board.version, std::string(length < 3 ? "" : "7.7.7"));
        QCOMPARE(found[0].board.name.size(), length < 3 ? length : length - 3);
        pair.ask(kSpeed, 20ms);
        QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{1});
        pair.toClient = [](const Bytes &) { return Bytes(); };
        pair.ask(kSpeed, 1100ms); // its answer is lost, and the line recovers
        pair.toClient = other;
        pair.runFor(6s);
        found = pair.all<Client::Connected>();
        QVERIFY(found.size() == 1 && found[0].again && pair.client.canSend());
    }
}

void TestFcpClient::withoutABoardItGivesUp()
{
    Pair pair;
    pair.toBoard = [](const Bytes &) { return Bytes(); };
    QVERIFY(!pair.connect());
    const auto lost = pair.all<Client::Lost>();
    QCOMPARE(lost.size(), std::size_t{1});
    QVERIFY(lost[0].connecting && !lost[0].heardBytes && !lost[0].otherProtocol);
    QVERIFY(!pair.client.nextTimeout());
}

void TestFcpClient::aLineThatBabblesIsGivenUp()
{
    Pair pair;
    pair.toClient = [](const Bytes &) { return Bytes(20, 0x55); };
    pair.client.connect(pair.now);
    pair.runFor(2s);
    const auto lost = pair.all<Client::Lost>();
    QCOMPARE(lost.size(), 1U);
    QVERIFY(lost.front().heardBytes && lost.front().connecting && !lost.front().otherProtocol);
}

void TestFcpClient::aBoardThatBeginsToBabbleIsGivenUp()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.toClient = [](const Bytes &) { return Bytes(20, 0x55); };
    pair.ask(kSpeed);
    QCOMPARE(pair.ends(), 1U);
    const auto lost = pair.all<Client::Lost>();
    QCOMPARE(lost.size(), 1U);
    QVERIFY(!lost.front().connecting);
    pair.toClient = nullptr;
    QVERIFY(pair.connect()); // and found again when it is quiet
}

void TestFcpClient::aBoardOfTheNewerProtocolIsRecognised()
{
    Pair pair;
    pair.toBoard = [](const Bytes &) { return Bytes(); };
    pair.client.connect(pair.now);
    pair.runFor(60ms);
    pair.client.receive(Bytes{0x0F, 0x04, 0x04, 0xC0}, pair.now);
    pair.runFor(6s);
    const auto lost = pair.all<Client::Lost>();
    QCOMPARE(lost.size(), std::size_t{1});
    QVERIFY(lost[0].otherProtocol);
}

void TestFcpClient::everyRequestNamesItsMotor()
{
    simulation::FcpRig rig;
    rig.motors.resize(2);
    rig.motors[1].registers[0x1E] = -600;
    Pair pair(rig);
    QVERIFY(pair.connect());
    pair.ask(kSpeed, 20ms, 2);
    QCOMPARE(pair.sent, (Bytes{0x42, 0x01, 0x1E, 0x61}));
    const auto answers = pair.all<Client::Answer>();
    QCOMPARE(answers.size(), std::size_t{1});
    QCOMPARE(std::get<fcp::Ack>(answers[0].reply).data, (Bytes{0xA8, 0xFD, 0xFF, 0xFF}));
}

void TestFcpClient::aDamagedAnswerEndsTheRequestAndTheLineSettles()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.corruptAfter(3);
    pair.ask(kSpeed, 20ms);
    QCOMPARE(pair.ends(), std::size_t{1});
    QVERIFY(!pair.all<Client::NoAnswer>().at(0).executed);
    QVERIFY(!pair.client.canSend());
    pair.runFor(60ms);
    QVERIFY(pair.client.canSend());
    pair.ask(kSpeed, 20ms);
    QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{1});
}

void TestFcpClient::aDamagedRequestIsKnownNotToHaveBeenExecuted()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.toBoard = [](Bytes bytes) {
        bytes.back() ^= 1;
        return bytes;
    };
    pair.ask(fcp::Execute{0x01}, 20ms);
    QCOMPARE(pair.ends(), std::size_t{1});
    QCOMPARE(pair.all<Client::NoAnswer>().at(0).executed, std::optional<bool>(false));
}

void TestFcpClient::aLostAnswerIsFollowedByTheRecovery()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.mute(20ms);
    pair.ask(kSpeed, 900ms);
    QCOMPARE(pair.ends(), std::size_t{0});
    QCOMPARE(pair.all<Client::Suspect>().size(), std::size_t{1});
    pair.runFor(3s);
    QCOMPARE(pair.ends(), std::size_t{1});
    const auto found = pair.all<Client::Connected>();
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(found[0].again);
    QVERIFY(pair.client.canSend());
}

void TestFcpClient::aBoardThatHangsInAFrameComesBack()
{
    // Whichever byte of a request is lost: the frame timer of this firmware is dead, so it waits for ever.
    for (std::size_t lost = 0; lost < 6; ++lost) {
        Pair pair;
        QVERIFY(pair.connect());
        pair.toBoard = [&](Bytes bytes) {
            bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(lost));
            pair.toBoard = nullptr;
            return bytes;
        };
        pair.ask(fcp::SetRegister{0x05, {0xDC, 0x05}}, 6s);
        QCOMPARE(pair.ends(), std::size_t{1});
        QVERIFY2(pair.client.canSend(), std::to_string(lost).c_str());
        pair.ask(kSpeed, 20ms);
        QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{1});
    }
}

void TestFcpClient::whileAMotorTurnsNothingIsFilledUpFirst()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.client.setMotorDriven(true);
    pair.board.mute(20ms);
    pair.ask(kSpeed, 3s);
    QVERIFY(pair.client.canSend());
    QCOMPARE(std::count(pair.sent.begin(), pair.sent.end(), 0xFF), 0);
}

void TestFcpClient::anAnswerOfAnotherLengthIsNotBelieved()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.toClient = [](const Bytes &bytes) {
        return bytes.empty() ? bytes : Bytes{0xF0, 0x02, 0x01, 0x02, 0xF5};
    };
    pair.client.send({1, kSpeed}, pair.now); // four bytes are wanted
    pair.events.clear();
    pair.runFor(1ms);
    pair.toClient = nullptr;
    pair.runFor(200ms);
    QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{0});
    QCOMPARE(pair.all<Client::NoAnswer>().size(), std::size_t{1});
}

void TestFcpClient::aLateAnswerIsNotTakenForTheNext()
{
    Pair pair;
    QVERIFY(pair.connect());
    Bytes held;
    pair.toClient = [&](const Bytes &bytes) {
        held.insert(held.end(), bytes.begin(), bytes.end());
        return Bytes();
    };
    pair.ask(kSpeed, 1020ms);
    pair.toClient = nullptr;
    pair.client.receive(held, pair.now); // 20 ms after its time
    pair.runFor(3s);
    QCOMPARE(pair.ends(), std::size_t{1});
    QCOMPARE(pair.all<Client::NoAnswer>().size(), std::size_t{1});
    QVERIFY(pair.client.canSend());
}

void TestFcpClient::aSecondAnswerIsNotTakenForTheNext()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.ask(fcp::GetRegister{0x19}, 10ms);
    pair.board.inject(Bytes{0xF0, 0x00, 0xF0}); // a second, empty one
    pair.ask(kSpeed, 5ms);
    QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{0});
    pair.runFor(100ms);
    // From then on each answer is followed by a pause, so that even a command cannot take it for its own.
    pair.ask(kSpeed, 3ms);
    QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{1});
    pair.runFor(10ms);
    QVERIFY(pair.client.canSend());
}

void TestFcpClient::aRefusalWithoutACodeIsARefusal()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.mute(20ms);
    pair.ask(kSpeed, 5ms);
    pair.client.receive(Bytes{0xFF, 0x00, 0xFF}, pair.now);
    pair.runFor(5ms);
    const auto answers = pair.all<Client::Answer>();
    QCOMPARE(answers.size(), std::size_t{1});
    QVERIFY(!std::get<fcp::Nack>(answers[0].reply).error);
}

void TestFcpClient::aStopGoesAheadOfAnOpenRequest()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.mute(200ms);
    pair.ask(kSpeed, 10ms);
    pair.client.sendUrgent({1, fcp::Execute{0x02}}, pair.now);
    const TimePoint asked = pair.now;
    pair.sent.clear();
    while (pair.sent.empty() && pair.now < asked + 1s)
        pair.runFor(1ms);
    QVERIFY(pair.now - asked <= Client::kGrace + 20ms);
    QCOMPARE(pair.sent, (Bytes{0x23, 0x01, 0x02, 0x26}));
    QCOMPARE(pair.all<Client::NoAnswer>().size(), std::size_t{1}); // the request's, once
    QCOMPARE(pair.all<Client::Answer>().size(), std::size_t{0});
    // Either answer may still be on its way: nothing is asked until the time for it is over.
    pair.sent.clear();
    for (const TimePoint end = pair.now + Client::kAnswerTime - 10ms; pair.now < end;) {
        pair.runFor(1ms);
        QVERIFY(!pair.client.canSend());
    }
    QVERIFY(pair.sent.empty());
    pair.runFor(2s); // and then it makes sure of the board first
    QVERIFY(pair.client.canSend());
    QCOMPARE(pair.client.stats().recoveries, std::uint64_t{1});
}

void TestFcpClient::theAnswerToAStopEndsTheWait()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.mute(30ms);
    pair.ask(kSpeed, 10ms);
    pair.client.sendUrgent({1, fcp::Execute{0x02}}, pair.now);
    pair.sent.clear();
    pair.runFor(Client::kGrace + 2 * Client::kSettle);
    QCOMPARE(pair.sent, (Bytes{0x23, 0x01, 0x02, 0x26}));
    QVERIFY(pair.client.canSend());
    QCOMPARE(pair.client.stats().recoveries, std::uint64_t{0});
}

void TestFcpClient::theEndOfAnotherAnswerIsNotThatToAStop()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.mute(10s);
    pair.ask(kSpeed, 10ms);
    pair.client.sendUrgent({1, fcp::Execute{0x02}}, pair.now);
    const TimePoint asked = pair.now;
    pair.sent.clear();
    while (pair.sent.empty() && pair.now < asked + 1s)
        pair.runFor(1ms);
    const TimePoint left = pair.now;
    pair.client.receive(Bytes{0xF4}, pair.now); // the last byte of an answer that was torn
    while (pair.now < left + Client::kAnswerTime - 10ms) {
        pair.runFor(1ms);
        QVERIFY(!pair.client.canSend());
    }
}

void TestFcpClient::whatCameBeforeAStopLeftIsNotItsAnswer()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.board.mute(10s);
    pair.ask(kSpeed, 10ms);
    pair.client.sendUrgent({1, fcp::Execute{0x02}}, pair.now);
    pair.sent.clear();
    // The answer that it waits for, and more, at once.
    pair.client.receive(Bytes{0xF0, 0x04, 0, 0, 0, 0x50, 0x45, 0x4F, 0x5F, 0x4F}, pair.now);
    const TimePoint left = pair.now;
    pair.pump();
    QCOMPARE(pair.sent, (Bytes{0x23, 0x01, 0x02, 0x26}));
    while (pair.now < left + Client::kAnswerTime - 10ms) {
        pair.runFor(1ms);
        QVERIFY(!pair.client.canSend());
    }
}

void TestFcpClient::aStopGoesOutWithoutABoard()
{
    Pair pair;
    pair.client.sendUrgent({1, fcp::Execute{0x02}}, pair.now);
    pair.pump();
    QCOMPARE(pair.sent, (Bytes{0x23, 0x01, 0x02, 0x26}));
    QCOMPARE(pair.events.size(), std::size_t{0});
}

void TestFcpClient::aRestartIsTold()
{
    Pair pair;
    QVERIFY(pair.connect());
    pair.events.clear();
    pair.board.inject(support::startNotice({0xD1B, "5.4.3", 9, 10, 0}));
    pair.runFor(5ms);
    QCOMPARE(pair.all<Client::Restarted>().size(), std::size_t{1});
}

QTEST_APPLESS_MAIN(TestFcpClient)
#include "tst_legacy_client.moc"
