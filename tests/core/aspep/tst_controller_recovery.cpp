// What the Controller does when the line is not perfect, on virtual time.
#include "support/virtual_link.h"

using namespace support;
using aspep::Beacon;
using aspep::Nack;
using aspep::Ping;

class TestControllerRecovery : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aNackIsMendedByPingBeaconPing();
    void theParityTellsThatTheRequestRan();
    void aRequestWithoutResponseIsMendedAfterItsTimeOut();
    void silenceAloneIsMendedByAPing();
    void silenceThatLastsIsMendedByPings();
    void onlyTheExactEchoCounts();
    void aSwallowedPacketIsRepeated();
    void aResetIsSeenBeforeTheFirstBeacon();
    void aResetIsSeenThoughPingsAreLost();
    void aResetIsSeenByTheKeepAlive();
    void aResetDuringTheConnectionStartsItAnew();
    void anUnconfiguredReplyWithAnotherNumberIsNoise();
    void aBadHeaderIsFollowedBySilence();
    void aStreamThatNeverPausesIsEndedByABeacon();
    void aStallWithinAPacketIsWaitedFor();
    void aShortTailIsFilledByTheDialogue();
    void aLongTailIsEndedBySilence();
    void aPingThatOnlyEndedAPacketIsFollowedByBeacons();
    void aReplyThatHasOnlyBegunIsWaitedFor();
    void aReplyThatBeganBeforeItsPingConnectsNobody();
    void anAnswerWithNoPacketBehindItIsNone();
    void aLateResponseIsNotTakenForTheNext();
    void aLateEchoSendsTheDialogueBack();
    void stallsOfHalfASecondAreSurvived();
    void silenceIsSuspectThenLost();
    void theStreamGoesOnWhileTheDialogueIsMended();
    void aFloodDuringTheRecoveryEndsIt();
    void aNewConnectWaitsForTheLastReply();
};

namespace {

constexpr auto kConnected = Controller::State::Connected;
constexpr auto kRecovering = Controller::State::Recovering;

Bytes pong(bool parity = false) { return header(Ping{true, parity, 0, 0}); }

/// The rest of a recovery, from its first packet on; the board answers each at once.
void answerAll(VirtualLink &link, bool parity = false)
{
    for (int i = 0; i < 20 && link.controller.state() != kConnected; ++i) {
        const Bytes bytes = link.nextSent();
        if (bytes.empty())
            return;
        link.hear(isPing(bytes) ? pong(parity) : bytes);
    }
}

void ask(VirtualLink &link)
{
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
}

} // namespace

void TestControllerRecovery::aNackIsMendedByPingBeaconPing()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{4}));
    QCOMPARE(link.controller.state(), kRecovering);
    QVERIFY(!link.controller.canSend());
    QVERIFY(isPing(link.nextSent())); // has it been reset?
    link.hear(pong());
    QCOMPARE(link.nextSent(), kBoard);
    link.hear(kBoard);
    QCOMPARE(link.nextSent(), kBoard);
    link.hear(kBoard);
    QVERIFY(isPing(link.nextSent()));
    QCOMPARE(link.controller.state(), kRecovering);
    link.hear(pong());
    QCOMPARE(link.controller.state(), kConnected);
    QCOMPARE(link.events.size(), std::size_t{2});
    QVERIFY(link.last<Controller::NoResponse>()->executed == false);
    QVERIFY(std::holds_alternative<Controller::Recovered>(link.events.back()));
    QCOMPARE(link.controller.stats().nacks, std::uint64_t{1});
}

void TestControllerRecovery::theParityTellsThatTheRequestRan()
{
    VirtualLink link;
    link.connect();
    bool parity = false; // of the requests that the board has carried out
    for (const bool executed : {true, false, true, true}) {
        parity = parity != executed;
        ask(link);
        link.sleepUntilTimeout();
        answerAll(link, parity);
        QCOMPARE(link.controller.state(), kConnected);
        QVERIFY(link.last<Controller::NoResponse>()->executed == executed);
        ask(link);
        link.hear(packet(true, hex("00 00")));
        parity = !parity;
    }
    QCOMPARE(link.count<Controller::NoResponse>(), 4);
    QCOMPARE(link.count<Controller::Response>(), 4);
}

void TestControllerRecovery::aRequestWithoutResponseIsMendedAfterItsTimeOut()
{
    VirtualLink link;
    link.connect();
    ask(link);
    const TimePoint asked = link.now;
    QVERIFY(isPing(link.nextSent()));
    QCOMPARE(link.now - asked, link.controller.responseTimeout());
    QCOMPARE(link.controller.stats().timeouts, std::uint64_t{1});
}

void TestControllerRecovery::silenceAloneIsMendedByAPing()
{
    VirtualLink link;
    link.connect();
    ask(link); // a busy host merged header and payload: the board has lost the packet, and streams on
    QVERIFY(isPing(link.nextSent()));
    link.hear(packet(false, hex("01 02")) + pong());
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.last<Controller::NoResponse>()->executed == false);
    QVERIFY(link.controller.canSend());
}

void TestControllerRecovery::silenceThatLastsIsMendedByPings()
{
    VirtualLink link;
    link.connect();
    ask(link);
    for (int i = 0; i < 4; ++i)
        QVERIFY(isPing(link.nextSent()));
    link.hear(pong());
    QCOMPARE(link.controller.state(), kConnected);
    QCOMPARE(link.count<Controller::Recovered>(), 1);
}

void TestControllerRecovery::onlyTheExactEchoCounts()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{4}));
    (void)link.nextSent();
    link.hear(pong());
    QCOMPARE(link.nextSent(), kBoard);
    for (const Beacon &other :
        {Beacon{0, false, 3, 7, 32}, Beacon{0, false, 7, 7, 0}, Beacon{0, false, 63, 127, 127}}) {
        link.hear(header(other));
        QVERIFY(link.sent().empty());
    }
    QCOMPARE(link.controller.stats().unexpected, std::uint64_t{3});
    link.hear(kBoard);
    QCOMPARE(link.nextSent(), kBoard); // never less than agreed: boards shrink for good
}

void TestControllerRecovery::aSwallowedPacketIsRepeated()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{1}));
    QVERIFY(isPing(link.nextSent())); // swallowed, as firmware does after an ERROR
    QVERIFY(isPing(link.nextSent())); // and this one
    QVERIFY(isPing(link.nextSent()));
    link.hear(pong());
    QCOMPARE(link.nextSent(), kBoard); // something bad was heard
    QCOMPARE(link.nextSent(), kBoard); // swallowed
    link.hear(kBoard);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

void TestControllerRecovery::aResetIsSeenBeforeTheFirstBeacon()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{2})); // its limit is 0 again
    const Bytes probe = link.nextSent();
    link.hear(probe); // "not configured" is the Ping itself
    QCOMPARE(link.nextSent(), kWidest);
    QVERIFY(!link.last<Controller::NoResponse>()->executed.has_value());
    link.hear(kBoard);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.last<Controller::Connected>()->afterReset);
    QCOMPARE(link.count<Controller::Recovered>(), 0);
}

/// A Beacon that matches would make the board forget that it has something to say.
void TestControllerRecovery::aResetIsSeenThoughPingsAreLost()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{2}));
    Bytes ping;
    for (int lost = 0; lost < 4; ++lost) {
        ping = link.nextSent();
        QVERIFY(isPing(ping));
    }
    link.hear(ping); // not configured
    QCOMPARE(link.nextSent(), kWidest);
    link.hear(kBoard);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.last<Controller::Connected>()->afterReset);
}

void TestControllerRecovery::aResetIsSeenByTheKeepAlive()
{
    VirtualLink link;
    link.connect();
    link.hear(link.nextSent());
    QCOMPARE(link.sent(), kWidest);
    link.hear(kBoard);
    answerAll(link);
    QVERIFY(link.last<Controller::Connected>()->afterReset);
}

void TestControllerRecovery::aResetDuringTheConnectionStartsItAnew()
{
    VirtualLink link;
    link.controller.connect(link.now);
    (void)link.sent();
    link.hear(kBoard);
    (void)link.sent();
    link.hear(kBoard);
    const Bytes ping = link.sent();
    QVERIFY(isPing(ping));
    link.hear(ping); // it was reset between Beacon and Ping
    QCOMPARE(link.sent(), kWidest);
    link.hear(kBoard);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

void TestControllerRecovery::anUnconfiguredReplyWithAnotherNumberIsNoise()
{
    VirtualLink link;
    link.connect();
    QVERIFY(isPing(link.nextSent()));
    link.hear(header(Ping{false, false, 0, 0x7777}));
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.sent().empty());
    QCOMPARE(link.controller.stats().unexpected, std::uint64_t{1});
    link.hear(pong());
    QVERIFY(link.controller.canSend());
}

void TestControllerRecovery::aBadHeaderIsFollowedBySilence()
{
    VirtualLink link;
    link.connect();
    ask(link);
    const TimePoint asked = link.now;
    link.wait(2ms);
    link.hear(hex("3A 03 00 E0") + Bytes(51, 0));
    QCOMPARE(link.controller.state(), kRecovering);
    QVERIFY(isPing(link.nextSent()));
    // The reply could still have come.
    QVERIFY(link.now - asked >= link.controller.responseTimeout());
    answerAll(link);
    QCOMPARE(link.controller.stats().badHeaderCrc, std::uint64_t{1});
    QCOMPARE(link.controller.stats().discardedBytes, std::uint64_t{55});
}

void TestControllerRecovery::aStreamThatNeverPausesIsEndedByABeacon()
{
    VirtualLink link;
    link.connect();
    link.hear(hex("FF FF FF FF"));
    const TimePoint bad = link.now;
    Bytes sent;
    for (int i = 0; i < 200 && sent.empty(); ++i) {
        link.hear(Bytes(100, 0x55)); // out of step, so its packets are noise
        link.wait(1ms);
        sent = link.sent();
    }
    QCOMPARE(sent, kBoard);
    QVERIFY(link.now - bad < 100ms);
    link.wait(60ms); // it has left the connection, and is silent
    QCOMPARE(link.controller.stats().discardedBytes > 1000, true);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
    // After that Beacon a board that was reset no longer says so.
    QCOMPARE(link.count<Controller::Recovered>(), 0);
    QCOMPARE(link.count<Controller::Connected>(), 1);
}

void TestControllerRecovery::aStallWithinAPacketIsWaitedFor()
{
    const Bytes async = packet(false, Bytes(1000, 7));
    VirtualLink link;
    link.connect();
    link.hear({async.begin(), async.begin() + 500});
    link.wait(300ms);
    QCOMPARE(link.controller.state(), kRecovering);
    QVERIFY(link.sent().empty());
    link.hear({async.begin() + 500, async.end()});
    QCOMPARE(link.controller.stats().torn, std::uint64_t{1});
    answerAll(link);
    QCOMPARE(link.count<Controller::Async>(), 1);
    QCOMPARE(link.controller.state(), kConnected);
}

void TestControllerRecovery::aShortTailIsFilledByTheDialogue()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(hex("3A 03 00 F0") + Bytes(50, 0)); // one byte of 51 is lost
    for (int i = 0; i < 20 && link.controller.state() != kConnected; ++i) {
        const Bytes bytes = link.nextSent();
        link.hear(isPing(bytes) ? pong() : bytes);
    }
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.now - TimePoint{} < 400ms);
}

void TestControllerRecovery::aLongTailIsEndedBySilence()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(hex("3A 03 00 F0") + Bytes(10, 0));
    const TimePoint torn = link.now;
    QVERIFY(isPing(link.nextSent()));
    QVERIFY(link.now - torn >= 500ms && link.now - torn < 700ms);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

/// Four bytes of an async packet were lost, and the answer to the Ping stood in for them: all looked well, and the line
/// had been out of step.
void TestControllerRecovery::aPingThatOnlyEndedAPacketIsFollowedByBeacons()
{
    VirtualLink link;
    link.connect();
    ask(link);
    Bytes torn = packet(false, Bytes(16, 0x11));
    torn.resize(torn.size() - 4);
    link.hear(torn);
    QVERIFY(isPing(link.nextSent()));
    link.now += 1ms;
    link.hear(pong());
    QCOMPARE(link.controller.state(), kRecovering);
    QVERIFY(isPing(link.nextSent()));
    link.hear(pong());
    QCOMPARE(link.controller.state(), kRecovering);
    QCOMPARE(link.nextSent(), kBoard);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

/// Three bytes of the reply before and the first of this one have a right check: the rest is still to come.
void TestControllerRecovery::aReplyThatHasOnlyBegunIsWaitedFor()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{4}));
    QVERIFY(isPing(link.nextSent()));
    link.now += 1ms;
    link.hear(hex("F6 90 60"));
    QVERIFY(isPing(link.nextSent()));
    link.now += 1ms;
    link.hear(hex("F6"));
    QVERIFY(link.sent().empty());
    link.now += 22us;
    link.hear(hex("A0 00 A0"));
    QVERIFY(link.sent().empty());
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

void TestControllerRecovery::aReplyThatBeganBeforeItsPingConnectsNobody()
{
    VirtualLink link;
    link.controller.connect(link.now);
    (void)link.sent();
    link.hear(kBoard);
    (void)link.sent();
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.hear(hex("F6 90 60"));
    QVERIFY(isPing(link.nextSent()));
    link.now += 1ms;
    link.hear(hex("F6"));
    QCOMPARE(link.count<Controller::Connected>(), 0);
    link.hear(hex("A0 00 A0"));
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

/// The end of the answer was lost, and the packet behind it made up for that.
void TestControllerRecovery::anAnswerWithNoPacketBehindItIsNone()
{
    VirtualLink link;
    link.connect();
    ask(link);
    Bytes torn = packet(true, Bytes(8, 0));
    torn.resize(torn.size() - 6);
    link.now += 1ms;
    link.hear(torn + packet(false, Bytes(32, 0)));
    QCOMPARE(link.count<Controller::Response>(), 0);
    QCOMPARE(link.controller.state(), kRecovering);
    answerAll(link, true);
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.last<Controller::NoResponse>()->executed == true);
}

void TestControllerRecovery::aLateResponseIsNotTakenForTheNext()
{
    VirtualLink link;
    link.connect();
    ask(link);
    (void)link.nextSent(); // the probe
    link.hear(packet(true, hex("06 00")) + pong(true));
    answerAll(link, true);
    QVERIFY(link.last<Controller::NoResponse>()->executed == true);
    QCOMPARE(link.count<Controller::Response>(), 0);
    QCOMPARE(link.controller.stats().unexpected, std::uint64_t{1});
    ask(link);
    link.hear(packet(true, hex("04 00")));
    QCOMPARE(link.last<Controller::Response>()->payload, hex("04 00"));
}

void TestControllerRecovery::aLateEchoSendsTheDialogueBack()
{
    VirtualLink link;
    link.connect();
    link.hear(kBoard); // a Beacon has been carried out late: requests would be swallowed now
    QCOMPARE(link.controller.state(), kRecovering);
    (void)link.nextSent();
    link.hear(pong());
    QCOMPARE(link.nextSent(), kBoard);
    QCOMPARE(link.nextSent(), kBoard); // repeated
    link.hear(kBoard + kBoard); // both answers come at once
    QCOMPARE(link.nextSent(), kBoard); // so none of them shows that the line is in step
    link.hear(kBoard);
    QCOMPARE(link.nextSent(), kBoard);
    link.hear(kBoard);
    QVERIFY(isPing(link.nextSent()));
    link.hear(kBoard); // still one more
    QCOMPARE(link.nextSent(), kBoard);
    link.hear(kBoard);
    answerAll(link);
    QCOMPARE(link.controller.state(), kConnected);
}

void TestControllerRecovery::stallsOfHalfASecondAreSurvived()
{
    for (const auto stall : {100ms, 200ms, 350ms, 500ms}) {
        VirtualLink link;
        link.connect();
        ask(link);
        Bytes held;
        const TimePoint end = link.now + stall;
        while (link.now < end) { // what the board says meanwhile is held back by the line
            link.wait(5ms);
            if (const Bytes bytes = link.sent(); !bytes.empty())
                held = held + (isPing(bytes) ? pong(true) : bytes);
        }
        link.hear(packet(true, hex("06 00")) + held);
        answerAll(link, true);
        QCOMPARE(link.controller.state(), kConnected);
        QCOMPARE(link.count<Controller::Lost>(), 0);
        QVERIFY(link.last<Controller::NoResponse>()->executed == true);
    }
}

void TestControllerRecovery::silenceIsSuspectThenLost()
{
    VirtualLink link;
    link.connect();
    const TimePoint start = link.now;
    while (link.count<Controller::Suspect>() == 0) {
        (void)link.sent();
        link.sleepUntilTimeout();
    }
    QCOMPARE(link.now - start, Duration(500ms));
    while (link.count<Controller::Lost>() == 0) {
        (void)link.sent();
        link.sleepUntilTimeout();
    }
    QCOMPARE(link.now - start, Duration(1000ms));
    QCOMPARE(int(link.last<Controller::Lost>()->reason), int(Controller::LostReason::Silence));
    QCOMPARE(link.count<Controller::Suspect>(), 1);
    QVERIFY(!link.controller.nextTimeout());
}

void TestControllerRecovery::theStreamGoesOnWhileTheDialogueIsMended()
{
    VirtualLink link;
    link.connect();
    ask(link);
    link.hear(header(Nack{4}) + packet(false, hex("01 02")));
    for (int i = 0; i < 20 && link.controller.state() != kConnected; ++i) {
        const Bytes bytes = link.nextSent();
        link.hear(packet(false, hex("01 02")) + (isPing(bytes) ? pong() : bytes));
    }
    QCOMPARE(link.controller.state(), kConnected);
    QVERIFY(link.count<Controller::Async>() > 3);
    QVERIFY(link.now - TimePoint{} < 100ms); // in step, so no silence is needed
}

void TestControllerRecovery::aFloodDuringTheRecoveryEndsIt()
{
    VirtualLink link;
    link.connect();
    const TimePoint start = link.now;
    ask(link);
    for (int i = 0; i < 10000 && link.controller.state() != Controller::State::Idle; ++i) {
        link.hear(Bytes(50, 0x5A));
        link.wait(1ms);
        (void)link.sent();
    }
    QCOMPARE(link.controller.state(), Controller::State::Idle);
    QVERIFY(link.now - start < 5s);
    QCOMPARE(link.count<Controller::NoResponse>(), 1);
    QCOMPARE(link.count<Controller::Lost>(), 1);
}

void TestControllerRecovery::aNewConnectWaitsForTheLastReply()
{
    VirtualLink link;
    link.connect();
    ask(link);
    const TimePoint asked = link.now;
    link.controller.connect(link.now);
    link.collect();
    QCOMPARE(link.count<Controller::NoResponse>(), 1);
    QCOMPARE(link.nextSent(), kWidest);
    QVERIFY(link.now - asked >= link.controller.responseTimeout());
}

QTEST_APPLESS_MAIN(TestControllerRecovery)
#include "tst_controller_recovery.moc"
