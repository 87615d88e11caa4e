// The hurried way for Stop: when its bytes leave, whatever the link is doing.
#include "support/virtual_link.h"

using namespace support;
using aspep::Ping;

class TestControllerUrgent : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void onAnIdleLinkItGoesAtOnce();
    void behindAnAnswerThatComesItIsAnOrdinaryRequest();
    void behindAnAnswerThatFailsItFollowsADialogue();
    void withoutEchoesItGoesBlindInTime();
    void betweenBlindPacketsTheBoardCanBreathe();
    void onALostLinkItUsesTheAgreedSizes();
    void onALinkThatNeverWasItOffersTheMost();
    void unheardItUsesWhatWasAgreedBefore();
    void whileALinkIsOpenedAgainItUsesTheAgreedSizes();
    void aLinkThatItBringsBackHasItsLimits();
    void aResetThatItsDialogueMeetsIsTold();
    void howBytesCameTogetherChangesNothing();
    void aBlindStopThatIsAnsweredSaysSo();
    void nothingAnswersABlindStopThatHasNotLeft();
    void theEchoOfAnEarlierBeaconIsNotTheAnswer();
    void everyUrgentRequestEndsOnce();
    void noiseDoesNotHoldItUp();
    void aBeaconThatHasJustLeftIsNotSentAgain();
    void aPingThatHasJustLeftHasItsTime();
    void theBeaconThatEndsAStreamHasItsTime();
    void theLastBeaconHasItsTimeBeforeItGoesBlind();
    void whatABlindStopHearsIsMendedByABeacon_data();
    void whatABlindStopHearsIsMendedByABeacon();
};

namespace {

const Bytes kStop = hex("21 00");

bool endsWithStop(const Bytes &bytes)
{
    return bytes.size() >= 6 && Bytes(bytes.end() - 6, bytes.end()) == hex("29 00 00 E0 21 00");
}

int ends(const VirtualLink &link)
{
    return link.count<Controller::Response>() + link.count<Controller::NoResponse>();
}

} // namespace

void TestControllerUrgent::onAnIdleLinkItGoesAtOnce()
{
    VirtualLink link;
    link.connect();
    link.controller.sendUrgent(kStop, link.now);
    QVERIFY(endsWithStop(link.sent()));
    link.hear(packet(true, hex("00")));
    QCOMPARE(link.count<Controller::Response>(), 1);
    QVERIFY(link.controller.canSend());
}

void TestControllerUrgent::behindAnAnswerThatComesItIsAnOrdinaryRequest()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    QVERIFY(link.sent().empty());
    link.wait(3ms);
    link.hear(packet(true, hex("06 00")));
    QVERIFY(endsWithStop(link.sent()));
    link.hear(packet(true, hex("00")));
    QCOMPARE(link.count<Controller::Response>(), 2);
    QCOMPARE(link.count<Controller::NoResponse>(), 0);
    // A keep-alive Ping is an answer to wait for, too.
    link.wait(250ms);
    QVERIFY(isPing(link.sent()));
    link.controller.sendUrgent(kStop, link.now);
    QVERIFY(link.sent().empty());
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
}

void TestControllerUrgent::behindAnAnswerThatFailsItFollowsADialogue()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.nextSent(), kBoard);
    QVERIFY(link.now - TimePoint{} <= 50ms);
    QCOMPARE(link.count<Controller::NoResponse>(), 1); // the open request ends first
    link.wait(2ms);
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.wait(2ms);
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
    QCOMPARE(link.controller.state(), Controller::State::Connected);
    // It may have been reset: the Beacon hides that.
    QCOMPARE(link.count<Controller::Recovered>(), 0);
    QCOMPARE(link.count<Controller::Connected>(), 1);
    QVERIFY(!link.last<Controller::Connected>()->afterReset);
    link.hear(packet(true, hex("00")));
    QCOMPARE(link.count<Controller::Response>(), 1);
}

void TestControllerUrgent::withoutEchoesItGoesBlindInTime()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.wait(10ms);
    const TimePoint pressed = link.now;
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.nextSent(), kBoard);
    const Bytes blind = link.nextSent();
    QVERIFY(link.now - pressed <= 70ms);
    QCOMPARE(Bytes(blind.begin(), blind.begin() + 4), kBoard);
    QVERIFY(isPing(Bytes(blind.begin() + 4, blind.begin() + 8)));
    QVERIFY(endsWithStop(blind));
    QCOMPARE(blind.size(), std::size_t{14});
    while (ends(link) < 2)
        link.sleepUntilTimeout();
    // And then the link is mended as usual.
    QCOMPARE(link.controller.state(), Controller::State::Recovering);
}

void TestControllerUrgent::betweenBlindPacketsTheBoardCanBreathe()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    (void)link.nextSent();
    link.wait(20ms);
    const auto outputs = link.controller.takeOutput();
    QCOMPARE(outputs.size(), std::size_t{4});
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(outputs[i].gapBefore >= 2ms);
    QVERIFY(outputs[3].gapBefore >= 1ms); // header to payload
}

void TestControllerUrgent::onALostLinkItUsesTheAgreedSizes()
{
    VirtualLink link;
    link.connect();
    link.wait(2s);
    (void)link.sent();
    QCOMPARE(link.controller.state(), Controller::State::Idle);
    link.events.clear();
    for (int attempt = 0; attempt < 20; ++attempt) { // every 100 ms, whatever comes back
        link.controller.sendUrgent(kStop, link.now);
        link.collect();
        QCOMPARE(link.sent(), kBoard);
        QVERIFY(endsWithStop(link.nextSent()));
        link.wait(70ms);
        QCOMPARE(ends(link), attempt + 1);
    }
    QCOMPARE(link.controller.state(), Controller::State::Idle);
    QCOMPARE(link.count<Controller::Lost>(), 0);
    // The board is back.
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.sent(), kBoard);
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
    QCOMPARE(link.count<Controller::Connected>(), 1);
}

void TestControllerUrgent::onALinkThatNeverWasItOffersTheMost()
{
    VirtualLink link;
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.sent(), kWidest);
    link.hear(kBoard);
    QCOMPARE(link.sent(), kBoard);
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
}

void TestControllerUrgent::unheardItUsesWhatWasAgreedBefore()
{
    VirtualLink link;
    link.controller.remember({.rxUnits = 7, .txSyncUnits = 7, .txAsyncUnits = 32});
    link.controller.connect(link.now);
    QCOMPARE(link.sent(), kWidest);
    for (int attempt = 0; attempt < 20; ++attempt) {
        link.controller.sendUrgent(kStop, link.now);
        QCOMPARE(link.sent(), attempt == 0 ? Bytes() : kWidest); // the first has just left
        link.wait(20ms);
        const Bytes blind = link.sent();
        QCOMPARE(Bytes(blind.begin(), blind.begin() + 4), kBoard);
        QVERIFY(isPing(Bytes(blind.begin() + 4, blind.begin() + 8)));
        QVERIFY(endsWithStop(blind));
        QCOMPARE(blind.size(), std::size_t{14});
        link.wait(30ms);
    }
    // Another board, and the wire is whole.
    const Bytes small = header(aspep::Beacon{.rxUnits = 3, .txSyncUnits = 7, .txAsyncUnits = 8});
    link.wait(1s);
    const Bytes offered = link.sent();
    link.controller.sendUrgent(kStop, link.now);
    const Bytes all = offered + link.sent(); // the last one is not repeated if it has just left
    QVERIFY(all.size() >= kWidest.size());
    QCOMPARE(Bytes(all.end() - 4, all.end()), kWidest);
    link.hear(small);
    QCOMPARE(link.sent(), small);
    link.hear(small);
    QVERIFY(isPing(link.sent()));
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
    QCOMPARE(header(link.controller.agreed()), small);
}

void TestControllerUrgent::whileALinkIsOpenedAgainItUsesTheAgreedSizes()
{
    VirtualLink link;
    link.connect();
    link.wait(2s);
    (void)link.sent();
    link.controller.connect(link.now);
    QCOMPARE(link.nextSent(), kWidest);
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.sent(), Bytes()); // the offer has just left
    link.wait(20ms);
    const Bytes blind = link.sent();
    QCOMPARE(Bytes(blind.begin(), blind.begin() + 4), kBoard);
    QVERIFY(endsWithStop(blind));
}

void TestControllerUrgent::aLinkThatItBringsBackHasItsLimits()
{
    VirtualLink link;
    link.connect();
    link.wait(2s);
    (void)link.sent();
    link.controller.connect(link.now);
    link.wait(30ms);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    for (int i = 0; i < 20 && link.controller.state() != Controller::State::Connected; ++i) {
        const Bytes bytes = link.nextSent();
        link.hear(isPing(bytes) ? kConfigured : kBoard);
    }
    QVERIFY(endsWithStop(link.sent()));
    link.hear(packet(true, hex("00")));
    QVERIFY(link.controller.canSend());
    link.hear(header(aspep::Data{false, 4000}));
    QCOMPARE(link.controller.stats().tooLong, std::uint64_t{1});
}

void TestControllerUrgent::aResetThatItsDialogueMeetsIsTold()
{
    for (Duration late{}; late < 20ms; late += 1ms) {
        VirtualLink link;
        link.connect();
        link.controller.sendRequest(kGetStatus, link.now);
        (void)link.sent();
        const Bytes probe = link.nextSent();
        QVERIFY(isPing(probe));
        link.wait(late);
        link.controller.sendUrgent(kStop, link.now);
        link.hear(probe); // "not configured" is the Ping itself
        for (int i = 0; i < 10 && link.controller.state() != Controller::State::Connected; ++i)
            link.hear(isPing(link.nextSent()) ? kConfigured : kBoard);
        QCOMPARE(link.count<Controller::Recovered>(), 0);
        QCOMPARE(link.count<Controller::Connected>(), 1);
        QVERIFY(link.last<Controller::Connected>()->afterReset);
    }
}

void TestControllerUrgent::howBytesCameTogetherChangesNothing()
{
    const Bytes noise = hex("FF FF FF FF");
    for (const bool together : {true, false}) {
        VirtualLink link;
        link.connect();
        link.controller.sendRequest(kGetStatus, link.now);
        (void)link.sent();
        link.controller.sendUrgent(kStop, link.now);
        QCOMPARE(link.nextSent(), kBoard);
        if (!together)
            link.hear(noise);
        link.hear(together ? noise + kBoard : kBoard);
        QCOMPARE(link.nextSent(), kBoard); // what was heard needs a second echo
        link.hear(kBoard);
        QVERIFY(isPing(link.sent()));
    }
}

void TestControllerUrgent::aBlindStopThatIsAnsweredSaysSo()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    (void)link.nextSent();
    QVERIFY(endsWithStop(link.nextSent()));
    link.hear(kBoard + kConfigured + packet(true, hex("00")));
    QCOMPARE(link.count<Controller::Response>(), 1);
    QCOMPARE(ends(link), 2);
    QCOMPARE(link.controller.state(), Controller::State::Recovering);
}

/// A Beacon, a Ping and its header go before it, each with its pause.
void TestControllerUrgent::nothingAnswersABlindStopThatHasNotLeft()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    (void)link.nextSent();
    link.wait(20ms);
    QCOMPARE(link.controller.takeOutput().size(), std::size_t{4});
    link.now += 5ms; // the header has left
    link.hear(packet(true, hex("00")));
    QCOMPARE(link.count<Controller::Response>(), 0);
    link.now += 1ms;
    link.controller.handleSent(link.now);
    link.hear(packet(true, hex("00")));
    QCOMPARE(link.count<Controller::Response>(), 1);
}

/// Else the Ping would follow a Beacon that has not left, and the board, which answers one packet after the other,
/// would miss both.
void TestControllerUrgent::theEchoOfAnEarlierBeaconIsNotTheAnswer()
{
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    (void)link.nextSent();
    QVERIFY(endsWithStop(link.nextSent())); // blind, and behind a Beacon
    link.controller.sendUrgent(kStop, link.now);
    link.collect();
    const auto offered = link.controller.takeOutput();
    QCOMPARE(offered.size(), std::size_t{1});
    QCOMPARE(offered[0].bytes, kBoard);
    link.hear(kBoard);
    QVERIFY(link.controller.takeOutput().empty());
    link.now += offered[0].gapBefore;
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
}

void TestControllerUrgent::everyUrgentRequestEndsOnce()
{
    VirtualLink link;
    link.connect();
    int asked = 0;
    for (int i = 0; i < 200; ++i) {
        if (link.controller.canSend() && i % 3 == 0) {
            link.controller.sendRequest(kGetStatus, link.now);
            ++asked;
        }
        if (i % 2 == 0) {
            link.controller.sendUrgent(kStop, link.now);
            ++asked;
        }
        link.collect();
        if (const Bytes bytes = link.sent(); !bytes.empty() && i % 7 != 0)
            link.hear(bytes.size() > 4 ? packet(true, hex("00"))
                    : isPing(bytes)    ? kConfigured
                                       : bytes);
        link.wait(std::chrono::milliseconds(i % 29));
        QVERIFY(asked - ends(link) >= 0 && asked - ends(link) <= 2);
    }
    link.controller.reset();
    link.collect();
    QCOMPARE(ends(link), asked);
    // Also where it waits behind a request.
    VirtualLink waiting;
    waiting.connect();
    waiting.controller.sendRequest(kGetStatus, waiting.now);
    waiting.controller.sendUrgent(kStop, waiting.now);
    waiting.controller.reset();
    waiting.collect();
    QCOMPARE(ends(waiting), 2);
}

void TestControllerUrgent::noiseDoesNotHoldItUp()
{
    VirtualLink link;
    link.connect();
    link.hear(Bytes(40, 0xFF));
    QCOMPARE(link.controller.state(), Controller::State::Recovering);
    const TimePoint pressed = link.now;
    link.controller.sendUrgent(kStop, link.now);
    Bytes sent;
    while (!endsWithStop(sent) && link.now - pressed < 1s) {
        link.hear(Bytes(10, 0xFF));
        link.wait(1ms);
        sent = sent + link.sent();
    }
    QVERIFY(link.now - pressed <= 22ms);
}

void TestControllerUrgent::aBeaconThatHasJustLeftIsNotSentAgain()
{
    VirtualLink link;
    link.controller.connect(link.now);
    QCOMPARE(link.sent(), kWidest);
    link.wait(1ms);
    link.controller.sendUrgent(kStop, link.now);
    QVERIFY(link.sent().empty());
    link.hear(kBoard);
    QCOMPARE(link.sent(), kBoard);
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
}

/// Of a recovery, or the one that connects: a Beacon right behind it would make the board miss both.
void TestControllerUrgent::aPingThatHasJustLeftHasItsTime()
{
    for (const bool answered : {true, false}) {
        VirtualLink link;
        link.connect();
        link.controller.sendRequest(kGetStatus, link.now);
        (void)link.sent();
        QVERIFY(isPing(link.nextSent())); // the answer did not come
        const TimePoint left = link.now;
        link.wait(5ms);
        link.controller.sendUrgent(kStop, link.now);
        QVERIFY(link.sent().empty());
        if (answered) {
            link.hear(kConfigured);
            QVERIFY(endsWithStop(link.sent()));
            continue;
        }
        const Bytes blind = link.nextSent();
        QCOMPARE(Bytes(blind.begin(), blind.begin() + 4), kBoard);
        QVERIFY(endsWithStop(blind));
        QVERIFY(link.now - left >= 20ms);
        QVERIFY(link.now - left <= 45ms);
    }
    VirtualLink link;
    link.controller.connect(link.now);
    (void)link.sent();
    link.hear(kBoard);
    (void)link.sent();
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.wait(1ms);
    link.controller.sendUrgent(kStop, link.now);
    QVERIFY(link.sent().empty());
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
}

void TestControllerUrgent::theBeaconThatEndsAStreamHasItsTime()
{
    VirtualLink link;
    link.connect();
    Bytes sent;
    while (sent.empty() && link.now < TimePoint{1s}) {
        link.hear(Bytes(40, 0x01)); // never pauses, and is no packet
        link.wait(2ms);
        sent = link.sent();
    }
    QCOMPARE(sent, kBoard);
    link.wait(1ms);
    link.controller.sendUrgent(kStop, link.now);
    QVERIFY(link.sent().empty());
    link.hear(kBoard);
    QVERIFY(isPing(link.sent()));
    link.hear(kConfigured);
    QVERIFY(endsWithStop(link.sent()));
}

void TestControllerUrgent::theLastBeaconHasItsTimeBeforeItGoesBlind()
{
    VirtualLink link;
    const TimePoint pressed = link.now;
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.sent(), kWidest);
    link.wait(9ms); // a busy host
    link.hear(kBoard);
    QCOMPARE(link.sent(), kBoard); // whose echo is lost
    const TimePoint left = link.now;
    QVERIFY(endsWithStop(link.nextSent()));
    QVERIFY(link.now - left >= 20ms);
    QVERIFY(link.now - pressed <= 40ms);
}

void TestControllerUrgent::whatABlindStopHearsIsMendedByABeacon_data()
{
    QTest::addColumn<QByteArray>("heard");
    const auto row = [](const char *name, const Bytes &bytes) {
        QTest::newRow(name) << QByteArray(
            reinterpret_cast<const char *>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    };
    row("a refusal", header(aspep::Nack{4}));
    row("a packet that breaks off", hex("05 C7"));
    row("no header", hex("12 34 56 78"));
}

void TestControllerUrgent::whatABlindStopHearsIsMendedByABeacon()
{
    QFETCH(QByteArray, heard);
    VirtualLink link;
    link.connect();
    link.controller.sendRequest(kGetStatus, link.now);
    (void)link.sent();
    link.controller.sendUrgent(kStop, link.now);
    QCOMPARE(link.nextSent(), kBoard);
    QVERIFY(endsWithStop(link.nextSent()));
    link.hear(Bytes(heard.begin(), heard.end()));
    bool offered = false;
    for (int i = 0; i < 30 && link.controller.state() != Controller::State::Connected; ++i) {
        const Bytes bytes = link.nextSent();
        offered = offered || bytes == kBoard;
        link.hear(isPing(bytes) ? kConfigured : bytes);
    }
    QCOMPARE(link.controller.state(), Controller::State::Connected);
    QVERIFY(offered);
}

QTEST_APPLESS_MAIN(TestControllerUrgent)
#include "tst_controller_urgent.moc"
