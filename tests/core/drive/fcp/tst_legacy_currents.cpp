// The currents of boards of the older protocol, which do not tell what a digit is worth: the user says it, for one
// motor and one connection, and a new scale moves nothing.
#include "support/fcp_bench.h"

#include "catalog/control_mode.h"
#include "drive/values.h"
#include "fcp/request.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace drive;
using namespace std::chrono_literals;
using support::boardOf;
using support::isRead;
using Bench = support::FcpBench;

class TestFcpCurrents : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void currentsNeedTheirScale();
    void aCurrentInAmpereIsWhatFlows();
    void aStartInTorqueControlIsWithinOnesOwnLimit();
    void aCurrentThatIsAskedForAtRestIsNotRefused();
    void aNewScaleMovesNothing();
    void theScaleIsForOneMotorAndOneConnection();
    void whatIsNoScaleIsRefused();
};

void TestFcpCurrents::currentsNeedTheirScale()
{
    Bench bench("legacy");
    bench.expert();
    const WishId torque = bench.submit(TorqueRamp{1, 0.5, 100ms});
    const WishId current = bench.submit(CurrentReference{1, 0.5, 0.0});
    QVERIFY(bench.runUntilEnded(torque) && bench.runUntilEnded(current));
    QCOMPARE(bench.outcome(torque), Outcome::Refused);
    QCOMPARE(bench.outcome(current), Outcome::Refused);
    for (const Bytes &frame : bench.requests)
        QVERIFY(isRead(frame));

    // With the scale that the user knows they go out, as digits.
    support::LinkPair pair(boardOf("legacy"));
    pair.connect();
    QVERIFY(pair.runUntilIdentified());
    const WishId scale = pair.submit(CurrentScale{1, 32.768});
    QCOMPARE(pair.outcome(scale), Outcome::Ok);
    pair.drive->arm();
    pair.submit(UserLimits{3000.0, 2.0});
    pair.submit(ExpertMode{1});
    const WishId known = pair.submit(CurrentReference{1, 0.5, -0.25});
    QVERIFY(pair.runUntilEnded(known));
    QCOMPARE(pair.outcome(known), Outcome::Ok);
    const Bytes wanted = fcp::encodeRequest({1, fcp::SetCurrentReference{500, -250}}).value();
    QCOMPARE(std::count(pair.requests.begin(), pair.requests.end(), wanted), 1);
    const WishId ramp = pair.submit(TorqueRamp{1, 1.0, 200ms});
    QVERIFY(pair.runUntilEnded(ramp));
    QCOMPARE(pair.outcome(ramp), Outcome::Ok);
    const WishId tooMuch = pair.submit(TorqueRamp{1, 2.5, 200ms});
    QVERIFY(pair.runUntilEnded(tooMuch));
    QCOMPARE(pair.outcome(tooMuch), Outcome::Refused);
}

void TestFcpCurrents::aCurrentInAmpereIsWhatFlows()
{
    // The scale is that of the simulated power stage itself: what it makes of a shunt's voltage.
    const double fullScale = simulation::plantOf(boardOf("legacy"))->inverter.maxReadable_a();
    Bench bench("legacy");
    bench.submit(CurrentScale{1, fullScale});
    bench.drive->arm();
    bench.exchange();
    QVERIFY(bench.start());
    bench.submit(UserLimits{3000.0, 2.0});
    const WishId known = bench.submit(CurrentReference{1, 1.5, 0.0});
    QVERIFY(bench.runUntilEnded(known));
    QCOMPARE(bench.outcome(known), Outcome::Ok);
    const auto digits = static_cast<std::int16_t>(std::lround(1.5 * 32768.0 / fullScale));
    const Bytes wanted = fcp::encodeRequest({1, fcp::SetCurrentReference{digits, 0}}).value();
    QCOMPARE(std::count(bench.requests.begin(), bench.requests.end(), wanted), 1);

    const RegisterId iq = bench.id("I_Q_MEAS");
    const catalog::Scale scale = bench.identified->catalog->readScale(iq);
    QCOMPARE(scale.unit, std::string("A"));
    double sum = 0.0;
    int count = 0;
    bench.onEvent = [&](const Event &event) {
        if (const auto *read = std::get_if<RegistersRead>(&event))
            for (const Reading &reading : read->readings)
                if (reading.id == iq) {
                    sum += asNumber(reading.value).value_or(0.0) * scale.factor;
                    ++count;
                }
    };
    Watch watch;
    watch.drawn = watch.registers = {iq};
    bench.submit(watch);
    bench.runFor(50ms);
    sum = count = 0;
    bench.runFor(100ms);
    QVERIFY(count > 50);
    QVERIFY2(std::abs(sum / count - 1.5) < 0.015, std::to_string(sum / count).c_str());
}

void TestFcpCurrents::aStartInTorqueControlIsWithinOnesOwnLimit()
{
    Bench bench("legacy");
    bench.submit(CurrentScale{1, 40.0});
    bench.drive->arm();
    bench.exchange();
    QVERIFY(bench.start());
    QVERIFY(bench.runUntilEnded(bench.submit(CurrentReference{1, 1.0, 0.0})));
    bench.drive->stop(bench.now);
    QVERIFY(bench.runUntilState(MotorState::Idle));
    bench.runFor(3s);
    bench.drive->arm();
    const auto refusal = [&](double amps) {
        bench.submit(UserLimits{0.0, amps});
        const WishId start = bench.submit(Command{MotorAction::Start, 1});
        bench.runUntilEnded(start);
        return bench.outcome(start) == Outcome::Refused ? bench.ended[start].front().reason : "";
    };
    QVERIFY(refusal(2.9).starts_with("in torque control this board does not tell"));
    QVERIFY(bench.runUntilEnded(bench.submit(
        Write{{{bench.id("CONTROL_MODE"), catalog::kSpeedModeNumber}}, Reach::Everything})));
    QVERIFY(refusal(0.1).starts_with("REVUP_DATA is beyond your own limit"));
    QCOMPARE(refusal(2.9), std::string());
}

/// It is kept for the next start; until then the board shows 0.
void TestFcpCurrents::aCurrentThatIsAskedForAtRestIsNotRefused()
{
    for (const bool lost : {false, true}) {
        Bench bench("legacy");
        bench.submit(CurrentScale{1, 40.0});
        bench.drive->arm();
        bench.exchange();
        bench.submit(UserLimits{0.0, 2.0});
        bench.submit(ExpertMode{1});
        const RegisterId reference = bench.id("I_Q_REF"); // 0x08
        const auto sent = [&] {
            return std::any_of(bench.requests.begin(), bench.requests.end(), [](const Bytes &one) {
                return one.size() > 2 && one[0] == 0x21 && one[2] == 0x08;
            });
        };
        const WishId wish = bench.submit(Write{{{reference, std::int64_t{800}}}});
        QVERIFY(bench.runUntil(sent, 1s));
        bench.toDrive.cut = lost;
        bench.runFor(300ms);
        bench.toDrive.cut = false;
        QVERIFY(bench.runUntilEnded(wish));
        const Ended &ended = bench.ended.at(wish).front();
        QVERIFY2(ended.outcome == (lost ? Outcome::Unknown : Outcome::Ok), ended.reason.c_str());
        QCOMPARE(ended.writes.size(), std::size_t{1});
        QVERIFY(ended.writes[0].before && ended.writes[0].readBack == ended.writes[0].before);
        QVERIFY(!ended.writes[0].verified && !ended.writes[0].reason.empty());
    }
}

void TestFcpCurrents::aNewScaleMovesNothing()
{
    Bench bench("legacy");
    bench.submit(CurrentScale{1, 60.0});
    bench.drive->arm();
    bench.exchange();
    QVERIFY(bench.start());
    bench.submit(UserLimits{3000.0, 2.0});
    QVERIFY(bench.runUntilEnded(bench.submit(CurrentReference{1, 1.0, 0.0})));
    const RegisterId reference = bench.id("I_Q_REF");
    const auto digits = [&] {
        bench.runUntilEnded(bench.submit(Read{{reference}}));
        return asNumber(bench.values.at(reference).value).value_or(0.0);
    };
    const double before = digits();
    QVERIFY(before > 500.0);

    // What still waits was meant by the scale before: it is not sent.
    const WishId waiting = bench.submit(
        Write{{{bench.id("SPEED_KP"), std::int64_t{1500}}, {reference, std::int64_t{800}}}});
    const WishId late = bench.submit(CurrentReference{1, 1.2, 0.0});
    const std::size_t sent = bench.requests.size();
    const WishId scale = bench.submit(CurrentScale{1, 30.0});
    QCOMPARE(bench.outcome(scale), Outcome::Ok);
    QVERIFY(!bench.drive->armed());
    QVERIFY(bench.runUntilEnded(waiting));
    QVERIFY(bench.outcome(late) == Outcome::NotSent);
    bench.runFor(300ms);
    for (std::size_t i = sent; i < bench.requests.size(); ++i)
        QVERIFY(isRead(bench.requests[i]) || i == sent); // at most the one under way
    QCOMPARE(digits(), before);
    QCOMPARE(bench.status.at(1).state, MotorState::Running);
    QCOMPARE(bench.identified->catalog->readScale(reference).factor, 30.0 / 32768.0);

    // The same again changes nothing, so the drive stays armed.
    bench.drive->arm();
    QVERIFY(bench.drive->armed());
    bench.submit(CurrentScale{1, 30.0});
    QVERIFY(bench.drive->armed());
}

void TestFcpCurrents::theScaleIsForOneMotorAndOneConnection()
{
    Bench bench("legacy", 2);
    bench.submit(CurrentScale{2, 60.0});
    const auto unit = [&](const char *name) {
        const auto &catalog = *bench.identified->catalog;
        return catalog.readScale(*catalog.resolve(name)).unit;
    };
    QCOMPARE(unit("I_Q_REF@2"), std::string("A"));
    QVERIFY(unit("I_Q_REF@1") != "A");
    bench.drive->arm();
    bench.submit(UserLimits{3000.0, 2.0});
    bench.submit(ExpertMode{1});
    bench.submit(ExpertMode{2});
    const WishId without = bench.submit(CurrentReference{1, 0.5, 0.0});
    const WishId with = bench.submit(CurrentReference{2, 0.5, 0.0});
    QVERIFY(bench.runUntilEnded(without) && bench.runUntilEnded(with));
    QCOMPARE(bench.outcome(without), Outcome::Refused);
    QCOMPARE(bench.outcome(with), Outcome::Ok);

    bench.drive->disconnect(bench.now); // another board may be there the next time
    bench.identified.reset();
    bench.connect();
    const WishId early = bench.submit(CurrentScale{1, 30.0}); // whose board is not identified yet
    bench.exchange();
    QCOMPARE(bench.outcome(early), Outcome::NotSent);
    QVERIFY(!bench.identified);
    QVERIFY(bench.runUntilIdentified());
    QVERIFY(unit("I_Q_REF@2") != "A");
    QVERIFY(!bench.capability(Feature::CurrentReference)->available);
    QVERIFY(bench.capability(Feature::CurrentScale)->available);
}

void TestFcpCurrents::whatIsNoScaleIsRefused()
{
    Bench bench("legacy");
    for (const double amps : {-1.0, 1e-9, 1e9, std::nan(""), HUGE_VAL})
        QCOMPARE(bench.outcome(bench.submit(CurrentScale{1, amps})), Outcome::Refused);
    QCOMPARE(bench.outcome(bench.submit(CurrentScale{3, 60.0})), Outcome::Refused);
    QCOMPARE(bench.outcome(bench.submit(CurrentScale{1, 60.0})), Outcome::Ok);
    QVERIFY(bench.capability(Feature::TorqueRamp)->available);
    QCOMPARE(bench.outcome(bench.submit(CurrentScale{1, 0.0})), Outcome::Ok); // not known again
    QVERIFY(!bench.capability(Feature::TorqueRamp)->available);

    support::LinkPair newer;
    newer.connect();
    QVERIFY(newer.runUntilIdentified());
    QCOMPARE(newer.outcome(newer.submit(CurrentScale{1, 60.0})), Outcome::Refused);
}

QTEST_APPLESS_MAIN(TestFcpCurrents)
#include "tst_legacy_currents.moc"
