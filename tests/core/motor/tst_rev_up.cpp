// The rev-up table: bytes and stages, the curve, and the mistakes.
#include "motor/ramp.h"
#include "motor/rev_up.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace motor;
using Mistake = RevUpMistake;

class TestRevUp : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bytesAndStagesAreTheSameThing();
    void bytesOfAnotherLengthAreRefused();
    void missingStagesRepeatTheLastWithoutTime();
    void neededTorqueIsInertiaAndFriction();
    void aSoundStartHasNoFinding();
    void theFourClassicMistakesAreMarked();
    void whatTheFirmwareWouldCutIsMarked();
    void unusedStagesRepeatTheLastThroughEveryEdit();
    void aStageIsAddedRemovedAndMoved();
    void noInputGivesAStageOutsideTheBounds();
    void startValuesAreThoseOfTheBook();
    void speedsComeInStepsOfSix();
    void aRampIsAStaircaseThatEndsOnItsTarget();
    void anotherDrivesStepsAreItsOwn();
    void aLongStaircaseIsThinnedOut();
};

namespace {

constexpr double kAmps = 60.175 / 32768.0;
const MechanicalLoad kLoad{0.039, 5e-5, 1.2e-4, 0.025};
const RevUpLimits kLimits{kLoad, 600.0, 5.0, 60.0, 4000.0};
/// Align with 2.5 A, speed up to 1200 rpm with 2.5 A.
const RevUp kSound{{0, 1361, 1000}, {1200, 1361, 1500}, {1200, 1361, 0}};

std::vector<Mistake> mistakesOf(const RevUp &stages, const RevUpLimits &limits = kLimits)
{
    std::vector<Mistake> mistakes;
    for (const RevUpFinding &finding : checkRevUp(stages, kAmps, limits))
        mistakes.push_back(finding.mistake);
    return mistakes;
}

bool near(double is, double wanted)
{
    return std::abs(is - wanted) < 1e-9 + 1e-9 * std::abs(wanted);
}

} // namespace

void TestRevUp::bytesAndStagesAreTheSameThing()
{
    std::mt19937 random(7);
    for (int round = 0; round < 1000; ++round) {
        RevUp stages(random() % (kRevUpStages + 1));
        for (RevUpStage &stage : stages)
            stage = {static_cast<std::int32_t>(random()), static_cast<std::int16_t>(random()),
                static_cast<std::uint16_t>(random())};
        const Bytes bytes = bytesOf(stages);
        QCOMPARE(bytes.size(), 8 * stages.size());
        QVERIFY(revUpOfBytes(bytes).value() == stages);
        Bytes any(40);
        for (std::uint8_t &byte : any)
            byte = static_cast<std::uint8_t>(random());
        QVERIFY(bytesOf(revUpOfBytes(any).value()) == any);
    }
}

void TestRevUp::bytesOfAnotherLengthAreRefused()
{
    for (std::size_t size = 0; size <= 80; ++size)
        QCOMPARE(revUpOfBytes(Bytes(size)).has_value(), size % 8 == 0 && size <= 40);
    QCOMPARE(bytesOf(RevUp(9)).size(), 40U);
}

void TestRevUp::missingStagesRepeatTheLastWithoutTime()
{
    const RevUp five = completed({{0, 1361, 1000}, {1200, 1361, 1500}});
    QCOMPARE(five.size(), kRevUpStages);
    for (std::size_t i = 2; i < five.size(); ++i)
        QVERIFY((five[i] == RevUpStage{1200, 1361, 0}));
    QCOMPARE(usedStages(five), 2U);
    QVERIFY(completed({}) == RevUp(5));
    QCOMPARE(usedStages(completed({})), 0U);
}

void TestRevUp::neededTorqueIsInertiaAndFriction()
{
    const double radps = 1200 * 2 * M_PI / 60;
    const double needed = neededTorque_nm({1200, 0, 1500}, 0.0, kLoad);
    QVERIFY(near(needed, 5e-5 * radps / 1.5 + 1.2e-4 * radps + 0.025));
    QVERIFY(near(neededTorque_nm({1200, 0, 1500}, 1200.0, kLoad), 1.2e-4 * radps + 0.025));
    QVERIFY(near(neededTorque_nm({0, 0, 1000}, 0.0, kLoad), 0.0));
    QVERIFY(std::isinf(neededTorque_nm({1200, 0, 0}, 0.0, kLoad)));
    QVERIFY(neededTorque_nm({0, 0, 1500}, 1200.0, kLoad) < needed); // friction helps to brake
    QVERIFY(near(neededTorque_nm({-1200, 0, 1500}, 0.0, kLoad), needed));
}

void TestRevUp::aSoundStartHasNoFinding()
{
    QVERIFY(mistakesOf(kSound).empty());
    RevUp backwards = kSound;
    for (RevUpStage &stage : backwards)
        stage.speed_rpm = -stage.speed_rpm;
    QVERIFY(mistakesOf(backwards).empty());
    QVERIFY(mistakesOf(kSound, {}).empty()); // nothing known, nothing said
}

void TestRevUp::theFourClassicMistakesAreMarked()
{
    const auto hasty = checkRevUp({{0, 1361, 1000}, {1200, 1361, 50}}, kAmps, kLimits);
    QCOMPARE(hasty.size(), 1U);
    QVERIFY(hasty[0].mistake == Mistake::TooLittleTorque);
    QCOMPARE(hasty[0].stage, 1U);
    QVERIFY(near(hasty[0].is, 0.039 * 1361 * kAmps));
    QVERIFY(near(hasty[0].limit, neededTorque_nm({1200, 0, 50}, 0.0, kLoad)));

    const auto slow = checkRevUp({{0, 1361, 1000}, {600, 1361, 1500}}, kAmps, kLimits);
    QCOMPARE(slow.size(), 1U);
    QVERIFY((slow[0] == RevUpFinding{Mistake::EndsTooSlow, 1, 600.0, 600.0}));
    QVERIFY(near(minimumStartSpeed_rpm(4000.0), 600.0));

    const auto hot = checkRevUp({{0, 3000, 1000}, {1200, 3000, 1500}}, kAmps, kLimits);
    QCOMPARE(hot.size(), 2U);
    QVERIFY(hot[1].mistake == Mistake::TooMuchCurrent);
    QVERIFY(near(hot[1].is, 3000 * kAmps));
    QCOMPARE(hot[1].limit, 5.0); // the lower one
    QVERIFY(mistakesOf({{0, 2723, 1000}, {1200, 2723, 1500}}).empty()); // 5 A, within a digit

    const auto jump = checkRevUp({{0, 1361, 0}, {1200, 1361, 1500}}, kAmps, kLimits);
    QCOMPARE(jump.size(), 1U);
    QVERIFY(jump[0].mistake == Mistake::StageWithoutTime);
    QCOMPARE(jump[0].stage, 0U);
}

void TestRevUp::whatTheFirmwareWouldCutIsMarked()
{
    RevUpLimits noLoad = kLimits;
    noLoad.load = {};
    QVERIFY(mistakesOf({{0, 1361, 1000}, {40000, 1361, 65535}}, noLoad)
        == std::vector{Mistake::SpeedDoesNotFit});
    QVERIFY(mistakesOf({{0, 1361, 1000}, {5000, 1361, 20000}})
        == std::vector{Mistake::SpeedBeyondLimit});
    QVERIFY(mistakesOf({{900, 1361, 0}, {-900, 1361, 9000}}).back() == Mistake::TurnsBack);
    QVERIFY(mistakesOf(RevUp(5)) == std::vector{Mistake::NoStage});
    QVERIFY(mistakesOf({}) == std::vector{Mistake::NoStage});
}

void TestRevUp::unusedStagesRepeatTheLastThroughEveryEdit()
{
    const RevUp edited = withStage(kSound, 1, {1500, 1400, 2000});
    QVERIFY((edited
        == RevUp{{0, 1361, 1000}, {1500, 1400, 2000}, {1500, 1400, 0}, {1500, 1400, 0},
            {1500, 1400, 0}}));
    // One that was set on purpose stays, and those before the edited one always do.
    const RevUp other{{0, 1361, 1000}, {1200, 1361, 1500}, {600, 1361, 0}, {600, 1361, 0}, {}};
    RevUp wanted = other;
    wanted[1] = {1500, 1400, 2000};
    QVERIFY(withStage(other, 1, {1500, 1400, 2000}) == wanted);
    QVERIFY(withStage(kSound, 9, {}) == completed(kSound));
    QVERIFY(withStage({}, 2, {60, 5, 7})[4] == (RevUpStage{60, 5, 0}));
}

void TestRevUp::aStageIsAddedRemovedAndMoved()
{
    const RevUp three = withStageAfter(kSound, 0);
    QCOMPARE(usedStages(three), 3U);
    QVERIFY(three[1] == kSound[0]);
    QVERIFY(three[2] == kSound[1]);
    QVERIFY(three[4] == (RevUpStage{1200, 1361, 0}));
    QVERIFY(withoutStage(three, 1) == completed(kSound));
    const RevUp swapped = withSwapped(kSound, 0, 1);
    QVERIFY(swapped[0] == kSound[1]);
    QVERIFY(swapped[4] == (RevUpStage{0, 1361, 0}));
    QVERIFY(withSwapped(kSound, 1, 2) == completed(kSound)); // the third is not used
    RevUp full = kSound;
    for (int i = 0; i < 9; ++i)
        full = withStageAfter(full, 4);
    QCOMPARE(usedStages(full), kRevUpStages);
    QVERIFY(withStageAfter(full, 0) == full);
    RevUp none = full;
    for (int i = 0; i < 9; ++i)
        none = withoutStage(none, 0);
    QCOMPARE(usedStages(none), 0U);
    QCOMPARE(usedStages(withStageAfter(none, 0)), 1U);
}

void TestRevUp::noInputGivesAStageOutsideTheBounds()
{
    const RevUpBounds bounds = revUpBounds(1600.0, 5.0, kAmps);
    QCOMPARE(bounds.speed_rpm, 1596);
    QCOMPARE(bounds.digits, 2722);
    QCOMPARE(revUpBounds(1600.0, 10.0, 10.0 / 2723).digits, 2723);
    QVERIFY((revUpBounds(0.0, 5.0, 0.0).digits == 32767));
    const RevUpStage old{600, 100, 500};
    QVERIFY((fittedStage(old, 1003.1, 99.6, 12.4, bounds) == RevUpStage{1002, 100, 12}));
    QVERIFY((fittedStage(old, 9e9, -9e9, 9e9, bounds) == RevUpStage{1596, -2722, 65535}));
    QVERIFY(fittedStage(old, std::nan(""), HUGE_VAL, -HUGE_VAL, bounds) == old);
    RevUpBounds pulse;
    pulse.pulse = true;
    QVERIFY((fittedStage(old, -9e9, -4.0, -4.0, pulse) == RevUpStage{-32766, 0, 0}));
}

void TestRevUp::startValuesAreThoseOfTheBook()
{
    const RevUp start = usualRevUp(5.0, 4000.0, kAmps);
    QCOMPARE(usedStages(start), 2U);
    QVERIFY((start[0] == RevUpStage{0, 1361, 2000}));
    QVERIFY((start[1] == RevUpStage{1200, 1361, 3000}));
    QVERIFY(usualRevUp(0.0, 4000.0, kAmps).empty()); // not known: no start values
    QVERIFY(usualRevUp(5.0, 0.0, kAmps).empty());
    const MechanicalLoad slow{0.039, 5e-5, 0.0, 0.0};
    QVERIFY(near(availableTorque_nm(start, 1, kAmps, slow), 0.039 * 1361 * kAmps));
    QVERIFY(near(availableTorque_nm(start, 0, kAmps, slow), 0.039 * 1361 * kAmps));
    QVERIFY(near(availableTorque_nm({{600, 1361, 50}}, 0, kAmps, slow), 0.0)); // from nothing
}

void TestRevUp::speedsComeInStepsOfSix()
{
    QCOMPARE(quantisedSpeed_rpm(3001.0), 3000.0);
    QCOMPARE(quantisedSpeed_rpm(3005.9), 3000.0);
    QCOMPARE(quantisedSpeed_rpm(-3005.0), -3000.0);
    QCOMPARE(quantisedSpeed_rpm(5.0), 0.0);
    QVERIFY(!std::signbit(quantisedSpeed_rpm(-5.0)));
    QCOMPARE(quantisedSpeed_rpm(1e9), 196602.0);
    QCOMPARE(quantisedSpeed_rpm(std::nan("")), 0.0);
}

void TestRevUp::aRampIsAStaircaseThatEndsOnItsTarget()
{
    const auto ramp = rampPreview(1000.0, 1030.0, 2.0, 6.0); // 996 -> 1026
    QCOMPARE(ramp.size(), 6U);
    QVERIFY((ramp.front() == RampPoint{0.0, 996.0}));
    QVERIFY((ramp.back() == RampPoint{2.0, 1026.0}));
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        QVERIFY(near(ramp[i].speed_rpm - ramp[i - 1].speed_rpm, 6.0));
        QVERIFY(near(ramp[i].time_s - ramp[i - 1].time_s, 0.4));
    }
    QCOMPARE(rampPreview(1200.0, -1200.0, 0.0, 6.0).size(), 2U);
    QCOMPARE(rampPreview(1200.0, 1203.0, 5.0, 6.0).size(), 2U);
    QVERIFY(near(rampAcceleration_rpmps(0.0, 3001.0, 1.5, 6.0), 2000.0));
    QVERIFY(std::isinf(rampAcceleration_rpmps(0.0, 3000.0, 0.0, 6.0)));
    QCOMPARE(rampAcceleration_rpmps(3000.0, 3001.0, 0.0, 6.0), 0.0);
}

void TestRevUp::anotherDrivesStepsAreItsOwn()
{
    QCOMPARE(quantisedSpeed_rpm(1009.0, 10.0), 1000.0);
    QCOMPARE(quantisedSpeed_rpm(1e9, 10.0), 327670.0);
    QCOMPARE(quantisedSpeed_rpm(-1009.5, 0.0), -1009.5); // it has none
    const auto ramp = rampPreview(1000.0, 1039.0, 3.0, 10.0);
    QCOMPARE(ramp.size(), 4U);
    for (std::size_t i = 0; i < ramp.size(); ++i)
        QVERIFY(near(ramp[i].speed_rpm, 1000.0 + 10.0 * double(i)));
    QVERIFY(near(rampAcceleration_rpmps(0.0, 3009.0, 1.5, 10.0), 2000.0));
    QVERIFY(near(rampAcceleration_rpmps(0.0, 3001.5, 1.5, 0.0), 2001.0));
    const RevUpBounds bounds = revUpBounds(1609.0, 5.0, kAmps, 10.0);
    QCOMPARE(bounds.speed_rpm, 1600);
    QVERIFY((fittedStage({}, 1003.1, 0.0, 0.0, bounds) == RevUpStage{1000, 0, 0}));
    QVERIFY((fittedStage({}, -9e9, 0.0, 0.0, bounds) == RevUpStage{-1600, 0, 0}));
    QVERIFY((keptByFirmware({{1009, 1, 1}}, 10.0) == RevUp{{1000, 1, 1}}));
}

void TestRevUp::aLongStaircaseIsThinnedOut()
{
    const auto ramp = rampPreview(-30000.0, 30000.0, 10.0, 6.0, 100);
    QCOMPARE(ramp.size(), 100U);
    for (std::size_t i = 1; i < ramp.size(); ++i) {
        QVERIFY(ramp[i].time_s > ramp[i - 1].time_s);
        QVERIFY(ramp[i].speed_rpm > ramp[i - 1].speed_rpm);
        QVERIFY(near(std::fmod(ramp[i].speed_rpm, 6.0), 0.0));
    }
}

QTEST_APPLESS_MAIN(TestRevUp)
#include "tst_rev_up.moc"
