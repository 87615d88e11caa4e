// The Controller's dialogue on virtual time: how it connects, asks and is answered.
#include "support/virtual_link.h"

using namespace support;
using aspep::Beacon;
using aspep::Ping;

class TestController : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void connectsAsACapturedBoardDid();
    void aRequestIsAHeaderAPauseAndAPayload();
    void aResponseAnswersTheOpenRequestOnly();
    void anAnswerThatBeganBeforeTheRequestHadLeftIsNone();
    void asyncPacketsAreHandedOnOnceConnected();
    void anAsyncPacketThatLacksBytesIsNotHandedOn();
    void completeAsyncPacketsBeforeTheAnswerAreSkipped();
    void anAnswerLargerThanTheOfferIsNone();
    void silenceEndsTheAttemptsWithNoAnswer();
    void garbageEndsTheAttemptsWithOnlyGarbage();
    void aRefusalInTheOlderFrameIsRecognised();
    void anotherVersionEndsWithoutAgreement();
    void counterProposalsEndAfterTenRounds();
    void aBoardThatStaysUnconfiguredEndsWithoutAgreement();
    void aQuietLinkIsKeptAlive();
    void theTimeOutFollowsBaudRateAndSizes();
    void timeOutsCountFromTheTimeThePacketHasLeft();
    void anySplitOfTheStreamConnects();
};

namespace {

bool isLost(const VirtualLink &link, Controller::LostReason reason)
{
    const auto *lost = link.last<Controller::Lost>();
    return lost && lost->reason == reason && link.controller.state() == Controller::State::Idle;
}

} // namespace

namespace {

/// A board of the protocol before this one, as far as it reads frames: header, length, payload, sum. Lengths beyond 127
/// are dropped without a word; no frame of a Controller has a right sum.
class OlderBoard {
public:
    Bytes receive(const Bytes &bytes)
    {
        Bytes answer;
        for (const std::uint8_t byte : bytes) {
            m_frame.push_back(byte);
            if (m_frame.size() == 2 && byte > 127)
                m_frame.clear();
            if (m_frame.size() < 2 || m_frame.size() < std::size_t{3} + m_frame[1])
                continue;
            m_frame.clear();
            answer = hex("FF 01 0A 0B"); // bad sum
        }
        return answer;
    }

private:
    Bytes m_frame;
};

} // namespace

void TestController::connectsAsACapturedBoardDid()
{
    VirtualLink link;
    link.controller.connect(link.now);
    QCOMPARE(link.sent(), kWidest);
    link.hear(kBoard);
    QCOMPARE(link.sent(), kBoard); // its limits, taken over
    link.hear(kBoard);
    QCOMPARE(link.controller.state(), Controller::State::Pinging);
    QCOMPARE(link.sent(), hex("06 10 00 20"));
    link.hear(hex("36 10 00 D0"));
    QCOMPARE(link.controller.state(), Controller::State::Connected);
    QCOMPARE(link.events.size(), std::size_t{1});
    const auto *connected = link.last<Controller::Connected>();
    QVERIFY(connected && !connected->afterReset);
    QVERIFY((connected->agreed == Beacon{0, false, 7, 7, 32}));
}

void TestController::aRequestIsAHeaderAPauseAndAPayload()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(hex("10 00 49 00"), link.now);
    QVERIFY(!link.controller.canSend());
    const auto output = link.controller.takeOutput();
    QCOMPARE(output.size(), std::size_t{2});
    QCOMPARE(output[0].bytes, hex("49 00 00 70"));
    QCOMPARE(output[1].bytes, hex("10 00 49 00"));
    QVERIFY(output[1].gapBefore >= 1ms);
}

void TestController::aResponseAnswersTheOpenRequestOnly()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(hex("10 00 49 00"), link.now);
    link.hear(packet(true, hex("02 00"))); // nothing has left yet: no answer to it
    QCOMPARE(link.count<Controller::Response>(), 0);
    link.sent();
    link.hear(packet(true, hex("06 00")));
    QCOMPARE(link.count<Controller::Response>(), 1);
    QCOMPARE(link.last<Controller::Response>()->payload, hex("06 00"));
    QVERIFY(link.controller.canSend());
    link.hear(packet(true, hex("06 00")));
    QCOMPARE(link.count<Controller::Response>(), 1);
    QCOMPARE(link.controller.stats().unexpected, std::uint64_t{2});
}

/// However late its last byte comes, and whenever the request is told to have left.
void TestController::anAnswerThatBeganBeforeTheRequestHadLeftIsNone()
{
    const Bytes stale = packet(true, hex("02 00"));
    for (const bool toldEarly : {false, true}) {
        VirtualLink link({.baud = 9600}); // 4 ms for the header
        link.connect();
        link.now += 10ms;
        link.controller.sendRequest(hex("10 00 49 00"), link.now);
        static_cast<void>(link.controller.takeOutput());
        link.now += 5ms;
        link.hear(Bytes(stale.begin(), stale.begin() + 5));
        link.now += 5ms; // the payload has left by now
        if (toldEarly)
            link.controller.handleSent(link.now);
        link.hear(Bytes(stale.begin() + 5, stale.end()));
        QCOMPARE(link.count<Controller::Response>(), 0);
        QCOMPARE(link.controller.stats().unexpected, std::uint64_t{1});
        link.controller.handleSent(link.now);
        link.now += 1ms;
        link.hear(packet(true, hex("06 00")));
        QCOMPARE(link.count<Controller::Response>(), 1);
        QCOMPARE(link.last<Controller::Response>()->payload, hex("06 00"));
    }
}

void TestController::asyncPacketsAreHandedOnOnceConnected()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(hex("10 00 49 00"), link.now);
    link.sent();
    link.hear(
        packet(false, Bytes(2046, 7)) + packet(true, hex("06 00")) + packet(false, hex("01 02")));
    QCOMPARE(link.count<Controller::Response>(), 1);
    // What follows the other one may still say that it lacks something.
    QCOMPARE(link.count<Controller::Async>(), 1);
    const TimePoint came = link.now;
    link.wait(2ms);
    QCOMPARE(link.count<Controller::Async>(), 2);
    QCOMPARE(link.last<Controller::Async>()->at, came);
}

/// Payloads are not protected: the packet takes what it lacks from the next one, and that is seen behind it.
void TestController::anAsyncPacketThatLacksBytesIsNotHandedOn()
{
    const Bytes whole = packet(false, Bytes(200, 7));
    for (const std::ptrdiff_t lost : {1, 2, 20, 150}) {
        for (const bool apart : {false, true}) {
            VirtualLink link;
            link.connect();
            link.hear(whole + whole);
            Bytes cut = whole;
            cut.erase(cut.begin() + 40, cut.begin() + 40 + lost);
            const Bytes all = cut + whole;
            const std::ptrdiff_t end = apart ? static_cast<std::ptrdiff_t>(whole.size())
                                             : static_cast<std::ptrdiff_t>(all.size());
            link.hear({all.begin(), all.begin() + end});
            link.now += 1ms;
            link.hear({all.begin() + end, all.end()});
            QCOMPARE(link.count<Controller::Async>(), 2);
            link.hear(whole + whole + whole);
            link.wait(2ms);
            QVERIFY(link.count<Controller::Async>() > 2);
            for (const Controller::Event &event : link.events)
                if (const auto *async = std::get_if<Controller::Async>(&event))
                    QCOMPARE(async->payload, Bytes(200, 7));
        }
    }
}

void TestController::completeAsyncPacketsBeforeTheAnswerAreSkipped()
{
    VirtualLink link;
    link.controller.connect(link.now);
    QCOMPARE(link.sent(), kWidest);
    // What is inside looks like a Beacon of nothing at all.
    link.hear(packet(false, hex("05 00 00 50 05 00 00 50")) + kBoard);
    QCOMPARE(link.sent(), kBoard);
    QVERIFY(link.events.empty());
}

void TestController::anAnswerLargerThanTheOfferIsNone()
{
    VirtualLink link({.offer = {0, false, 7, 7, 32}});
    link.controller.connect(link.now);
    QCOMPARE(link.sent(), kBoard);
    link.hear(kWidest);
    QVERIFY(link.sent().empty());
    QCOMPARE(link.controller.stats().unexpected, std::uint64_t{1});
}

void TestController::silenceEndsTheAttemptsWithNoAnswer()
{
    VirtualLink link;
    link.controller.connect(link.now);
    int offers = 0;
    for (; link.controller.state() != Controller::State::Idle; ++offers) {
        QCOMPARE(link.sent(), kWidest);
        link.sleepUntilTimeout();
    }
    QVERIFY(4 * offers > 256); // a board that waits for the rest of a request has got it by then
    QVERIFY(isLost(link, Controller::LostReason::NoAnswer));
    QVERIFY(link.now - TimePoint{} < 3s);
    QVERIFY(!link.controller.nextTimeout());
}

void TestController::garbageEndsTheAttemptsWithOnlyGarbage()
{
    VirtualLink link;
    link.controller.connect(link.now);
    for (int i = 0; i < 5000 && link.controller.state() != Controller::State::Idle; ++i) {
        link.hear(Bytes(100, 0xFE));
        (void)link.sent();
        link.wait(1ms);
    }
    QVERIFY(isLost(link, Controller::LostReason::OnlyGarbage));
    QVERIFY(link.controller.stats().discardedBytes > 1000);
}

void TestController::aRefusalInTheOlderFrameIsRecognised()
{
    VirtualLink link;
    link.controller.connect(link.now);
    OlderBoard board;
    while (link.controller.state() != Controller::State::Idle) {
        const Bytes answer = board.receive(link.sent());
        if (answer.empty())
            link.sleepUntilTimeout();
        else
            link.hear(answer);
    }
    QVERIFY(isLost(link, Controller::LostReason::OldProtocol));
    QVERIFY(link.now - TimePoint{} < 3s);

    // The next attempt forgets what was heard in this one.
    link.controller.connect(link.now);
    while (link.controller.state() != Controller::State::Idle) {
        (void)link.sent();
        link.sleepUntilTimeout();
    }
    QVERIFY(isLost(link, Controller::LostReason::NoAnswer));
}

void TestController::anotherVersionEndsWithoutAgreement()
{
    VirtualLink link;
    link.controller.connect(link.now);
    while (link.controller.state() != Controller::State::Idle) {
        QCOMPARE(link.sent(), kWidest);
        link.hear(header(Beacon{2, false, 7, 7, 32}));
        link.sleepUntilTimeout();
    }
    QVERIFY(isLost(link, Controller::LostReason::NoAgreement));
}

void TestController::counterProposalsEndAfterTenRounds()
{
    VirtualLink link;
    link.controller.connect(link.now);
    int rounds = 0;
    for (std::uint8_t units = 60; link.controller.state() != Controller::State::Idle;
         --units, ++rounds) {
        (void)link.sent();
        link.hear(header(Beacon{0, false, units, 7, 32}));
    }
    QCOMPARE(rounds, 11);
    QVERIFY(isLost(link, Controller::LostReason::NoAgreement));
}

void TestController::aBoardThatStaysUnconfiguredEndsWithoutAgreement()
{
    VirtualLink link;
    link.controller.connect(link.now);
    int packets = 0;
    for (; packets < 100 && link.controller.state() != Controller::State::Idle; ++packets) {
        const Bytes bytes = link.sent();
        if ((bytes.at(0) & 0xF) == 5)
            link.hear(kBoard);
        else
            link.hear(bytes); // a Ping reply that says "not configured" is the Ping itself
    }
    QVERIFY(packets < 100);
    QVERIFY(isLost(link, Controller::LostReason::NoAgreement));
}

void TestController::aQuietLinkIsKeptAlive()
{
    VirtualLink link;
    link.connect();
    for (std::uint16_t number = 2; number < 20; ++number) {
        const TimePoint before = link.now;
        QCOMPARE(link.nextSent(), header(Ping{false, false, 0, number}));
        QCOMPARE(link.now - before, Duration(250ms));
        QVERIFY(!link.controller.canSend());
        link.hear(header(Ping{true, false, 0, 15})); // the number as 6.2 cuts it
        QVERIFY(link.controller.canSend());
    }
    QVERIFY(link.events.empty());
}

void TestController::theTimeOutFollowsBaudRateAndSizes()
{
    VirtualLink fast;
    fast.connect();
    VirtualLink slow({.baud = 115200});
    slow.connect();
    const auto milliseconds = [](Duration d) {
        return std::chrono::duration_cast<std::chrono::milliseconds>(d).count();
    };
    QCOMPARE(milliseconds(fast.controller.responseTimeout()), 40);
    QCOMPARE(milliseconds(slow.controller.responseTimeout()), 323);
    VirtualLink patient({.patience = 500ms});
    patient.connect();
    QCOMPARE(milliseconds(patient.controller.responseTimeout()), 540);
}

void TestController::timeOutsCountFromTheTimeThePacketHasLeft()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(hex("10 00 49 00"), link.now);
    (void)link.controller.takeOutput();
    link.now += 30ms; // a busy host
    link.controller.handleSent(link.now);
    QCOMPARE(*link.controller.nextTimeout(), link.now + link.controller.responseTimeout());
}

void TestController::anySplitOfTheStreamConnects()
{
    const Bytes async = packet(false, hex("05 00 00 50 01 02"));
    for (std::size_t cut = 1; cut < async.size() + kBoard.size(); ++cut) {
        VirtualLink link;
        link.controller.connect(link.now);
        (void)link.sent();
        for (const Bytes &answer : {async + kBoard, async + kBoard, async + kConfigured}) {
            const auto middle = answer.begin() + static_cast<std::ptrdiff_t>(cut);
            link.hear({answer.begin(), middle});
            QVERIFY(link.sent().empty());
            link.hear({middle, answer.end()});
            (void)link.sent();
        }
        QCOMPARE(link.controller.state(), Controller::State::Connected);
    }
}

QTEST_APPLESS_MAIN(TestController)
#include "tst_controller.moc"
