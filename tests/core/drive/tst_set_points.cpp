// What bounds a set-point, and what is said when it is refused: numbers only, no board and no line. The borders belong
// to what is allowed.
#include "drive/motion_limits.h"
#include "drive/set_point_check.h"
#include "motor/rev_up.h"

#include <QTest>

#include <limits>

using namespace drive;
using namespace std::chrono_literals;
using Held = catalog::SetPoint; // what a register holds

namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

enum Id : RegisterId { Speed = 0x1000, Current = 0x2000, Gain = 0x3000 };

/// Two motors of 4000 rpm and 5 A; nothing is known of the second one.
BoardFacts boardFacts()
{
    const auto info = [](RegisterId id, const char *name, Held setPoint, const char *unit) {
        catalog::RegisterInfo one;
        one.id = id;
        one.name = name;
        one.setPoint = setPoint;
        one.unit = unit;
        return one;
    };
    BoardFacts facts;
    facts.motors = 2;
    facts.limits = {{4000.0, 32.0, 5.0, 4.0, 0.1}, {}};
    facts.catalog = std::make_shared<const catalog::Catalog>(
        std::vector{info(Speed, "SPEED", Held::Speed, "rpm"),
            info(Current, "CURRENT", Held::Current, "A"), info(Gain, "GAIN", Held::None, "rpm")},
        2, std::vector<catalog::Scales>(2));
    return facts;
}

/// Of the first motor.
std::vector<catalog::Scales> scalesOf(double ampsPerDigit)
{
    std::vector<catalog::Scales> scales(2);
    scales[0].ampsPerDigit = ampsPerDigit;
    return scales;
}

} // namespace

class TestSetPoints : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aLimitIsKnownUpToItsCeiling();
    void theLowerOfBothBounds();
    void theRealBoundsAreWithoutCeilings();
    void whatCanBound();
    void whatADigitAsksFor();
    void motorsAreCountedFromOne();
    void aRampHasAWireLength();
    void aStartNeedsEveryLimit();
    void aSetPointUpToTheBoundIsAllowed();
    void numbersForRegistersAreJudgedByTheirScale();
    void whatAWishSetsIsReadFromIt();
    void aWordOnTheWireHolds16Bits();
    void aStageMayHoldTheDigitNextToALimit();
    void everyPartOfASetPointIsLookedAt();
    void digitsAreRoundedAndClamped();
};

void TestSetPoints::aLimitIsKnownUpToItsCeiling()
{
    const std::pair<double, bool> speeds[] = {{kHighestRpm, true}, {kHighestRpm * 1.001, false},
        {0.5, true}, {0.0, false}, {-0.5, false}, {kNotANumber, false}, {kInfinite, false}};
    for (const auto &[rpm, known] : speeds)
        QCOMPARE(gapsIn({rpm, 32.0, 5.0, 4.0, 0.1}).empty(), known);
    for (const auto &[rpm, known] : speeds) { // the same of a current
        const double amps = rpm / 100.0;
        QCOMPARE(gapsIn({4000.0, amps, 5.0, 4.0, 0.1}).empty(), known);
        QCOMPARE(gapsIn({4000.0, 32.0, amps, 4.0, 0.1}).empty(), known);
    }
    QVERIFY(gapsIn({})
        == (std::vector{LimitGap::MaxSpeed, LimitGap::MaxCurrent, LimitGap::NominalCurrent}));
}

void TestSetPoints::theLowerOfBothBounds()
{
    struct Row {
        MotorLimits limits;
        UserLimits user;
        bool expert = false;
        MotionBounds bounds;
    };
    const MotorLimits known{4000.0, 32.0, 5.0, 4.0, 0.1}, peak{4000.0, 3.0, 5.0, 4.0, 0.1};
    const Row rows[] = {
        {known, {}, false, {4000.0, 5.0}},
        {known, {}, true, {4000.0, 5.0}},
        {peak, {}, false, {4000.0, 3.0}},
        {known, {0.5, 0.5}, false, {0.5, 0.5}},
        {known, {5000.0, 6.0}, false, {4000.0, 5.0}},
        {{0.5, 0.5, 0.5}, {2.0, 2.0}, false, {0.5, 0.5}},
        {{}, {1000.0, 1.0}, false, {0.0, 0.0}},
        {{}, {1000.0, 1.0}, true, {1000.0, 1.0}},
        {{}, {}, true, {kHighestRpm, kHighestAmps}},
    };
    for (const Row &row : rows) {
        const MotionBounds bounds = boundsOf(row.limits, row.user, row.expert);
        QCOMPARE(bounds.rpm, row.bounds.rpm);
        QCOMPARE(bounds.amps, row.bounds.amps);
    }
}

void TestSetPoints::theRealBoundsAreWithoutCeilings()
{
    QVERIFY((realBoundsOf({}, {}) == MotionBounds{0.0, 0.0}));
    QVERIFY((realBoundsOf({}, {1000.0, 2.0}) == MotionBounds{1000.0, 2.0}));
    QVERIFY((realBoundsOf({0.5, 0.5, 0.5}, {}) == MotionBounds{0.5, 0.5}));
    QVERIFY((realBoundsOf({4000.0, 32.0, 5.0}, {9000.0, 9.0}) == MotionBounds{4000.0, 5.0}));
}

void TestSetPoints::whatCanBound()
{
    for (const auto &[number, good] : {std::pair(0.0, true), std::pair(0.5, true),
             std::pair(-0.5, false), std::pair(kNotANumber, false), std::pair(kInfinite, false)}) {
        QCOMPARE(isPlausible(UserLimits{number, 1.0}), good);
        QCOMPARE(isPlausible(UserLimits{1.0, number}), good);
    }
    for (const auto &[amps, good] :
        {std::pair(0.0, true), std::pair(1e-3, true), std::pair(0.9e-3, false),
            std::pair(kHighestAmps, true), std::pair(kHighestAmps * 1.001, false),
            std::pair(-1.0, false), std::pair(kNotANumber, false), std::pair(kInfinite, false)})
        QCOMPARE(isPlausible(CurrentScale{1, amps}), good);
}

void TestSetPoints::whatADigitAsksFor()
{
    struct Row {
        Held setPoint;
        double factor;
        const char *unit;
        double polePairs, torquePerAmp, asks;
    };
    const Row rows[] = {
        {Held::Speed, 6.0, "rpm", 0.0, 0.0, 6.0},
        {Held::Speed, 0.5, "rpm", 4.0, 0.0, 0.5},
        {Held::Speed, 2.0, "Hz", 4.0, 0.0, 30.0}, // electrical
        {Held::Speed, 2.0, "Hz", 1.0, 0.0, 120.0},
        {Held::Speed, 2.0, "Hz", 0.0, 0.0, 0.0},
        {Held::Speed, 2.0, "A", 4.0, 0.0, 0.0},
        {Held::Speed, 0.0, "rpm", 4.0, 0.0, 0.0},
        {Held::Speed, -6.0, "rpm", 4.0, 0.0, 0.0},
        {Held::Speed, kNotANumber, "rpm", 4.0, 0.0, 0.0},
        {Held::Speed, kInfinite, "rpm", 4.0, 0.0, 0.0},
        {Held::Current, 0.5, "A", 0.0, 0.0, 0.5},
        {Held::Current, 0.5, "rpm", 0.0, 0.0, 0.0},
        {Held::Torque, 3.0, "N m", 0.0, 0.5, 6.0},
        {Held::Torque, 3.0, "N m", 0.0, 0.0, 0.0},
        {Held::Torque, 3.0, "A", 0.0, 0.5, 0.0},
        {Held::None, 3.0, "rpm", 4.0, 0.5, 0.0},
    };
    for (const Row &row : rows) {
        catalog::RegisterInfo info;
        info.setPoint = row.setPoint;
        QCOMPARE(setPointPerDigit(info, {row.factor, row.unit},
                     {4000.0, 32.0, 5.0, row.polePairs, row.torquePerAmp}),
            row.asks);
    }
}

void TestSetPoints::motorsAreCountedFromOne()
{
    for (const int motor : {1, 2})
        QCOMPARE(refuseMotor(boardFacts(), motor), std::string());
    for (const int motor : {-1, 0, 3})
        QCOMPARE(refuseMotor(boardFacts(), motor), "there is no motor " + std::to_string(motor));
}

void TestSetPoints::aRampHasAWireLength()
{
    for (const auto time : {0ms, 1ms, 65535ms})
        QCOMPARE(refuseRampTime(time), std::string());
    for (const auto time : {-1ms, 65536ms})
        QCOMPARE(refuseRampTime(time), std::string("a ramp lasts 0 to 65535 ms"));
}

void TestSetPoints::aStartNeedsEveryLimit()
{
    BoardFacts facts = boardFacts();
    QCOMPARE(refuseStart(facts, 1), std::string());
    QCOMPARE(refuseStart(facts, 2),
        std::string("the board does not tell the greatest speed, greatest current, nominal current "
                    "of motor 2; to move it all the same takes expert mode"));
    facts.limits[1] = {4000.0, 32.0, 0.0, 4.0, 0.1};
    QCOMPARE(refuseStart(facts, 2),
        std::string("the board does not tell the nominal current of motor 2; to move it all the "
                    "same takes expert mode"));
    facts.expert = {2};
    QCOMPARE(refuseStart(facts, 2), std::string());
}

void TestSetPoints::aSetPointUpToTheBoundIsAllowed()
{
    BoardFacts facts = boardFacts();
    for (const double sign : {1.0, -1.0}) {
        QCOMPARE(refuseSpeed(facts, 1, sign * 4000.0), std::string());
        QCOMPARE(refuseSpeed(facts, 1, sign * 4000.1), std::string("beyond the limit of 4000 rpm"));
        QCOMPARE(refuseCurrent(facts, 1, sign * 5.0), std::string());
        QCOMPARE(refuseCurrent(facts, 1, sign * 5.1), std::string("beyond the limit of 5 A"));
    }
    for (const double odd : {kNotANumber, kInfinite, -kInfinite}) {
        QCOMPARE(refuseSpeed(facts, 1, odd), std::string("not a finite number"));
        QCOMPARE(refuseCurrent(facts, 1, odd), std::string("not a finite number"));
    }
    const std::string expert = " of motor 2; to move it all the same takes expert mode";
    QCOMPARE(refuseSpeed(facts, 2, 0.0), "the board does not tell the speed limit" + expert);
    QCOMPARE(refuseCurrent(facts, 2, 0.0), "the board does not tell the current limit" + expert);
    facts.user = {1234.56, 0.5};
    QCOMPARE(refuseSpeed(facts, 1, 0.25), std::string());
    QCOMPARE(refuseSpeed(facts, 1, 1300.0), std::string("beyond your own limit of 1234.56 rpm"));
    QCOMPARE(refuseCurrent(facts, 1, 0.6), std::string("beyond your own limit of 0.5 A"));
    facts.user = {0.5, 0.5};
    QCOMPARE(refuseSpeed(facts, 1, 0.5), std::string());
    QCOMPARE(refuseSpeed(facts, 1, 0.6), std::string("beyond your own limit of 0.5 rpm"));
    facts.user = {1234.5678, 0.5}; // six digits say enough
    QCOMPARE(refuseSpeed(facts, 1, 1300.0), std::string("beyond your own limit of 1234.57 rpm"));
}

void TestSetPoints::numbersForRegistersAreJudgedByTheirScale()
{
    const BoardFacts facts = boardFacts();
    const auto refuse = [&](RegisterId id, int motor, catalog::Value value) {
        const auto *info = facts.catalog->find(id);
        return refuseNumber(facts,
            {info != nullptr ? facts.catalog->withMotor(*info, motor) : id, std::move(value)});
    };
    QCOMPARE(refuse(Speed, 1, std::int64_t{4000}), std::string());
    QCOMPARE(refuse(Speed, 1, std::int64_t{-4001}), std::string("beyond the limit of 4000 rpm"));
    QCOMPARE(refuse(Speed, 1, 4000.5), std::string("beyond the limit of 4000 rpm"));
    QCOMPARE(refuse(Current, 1, std::int64_t{5}), std::string());
    QCOMPARE(refuse(Current, 1, std::int64_t{6}), std::string("beyond the limit of 5 A"));
    QVERIFY(!refuse(Speed, 2, std::int64_t{0}).empty()); // each motor by its own limits
    QCOMPARE(refuse(Gain, 1, std::int64_t{99999}), std::string());
    QCOMPARE(refuse(Speed, 1, Bytes{1, 2}), std::string()); // no number: its type refuses it
    QCOMPARE(refuse(0x7000, 1, std::int64_t{99999}), std::string());
    BoardFacts digits = boardFacts();
    catalog::RegisterInfo info = *digits.catalog->find(RegisterId{Speed});
    info.unit = "digits";
    digits.catalog = std::make_shared<const catalog::Catalog>(
        std::vector{info}, 2, std::vector<catalog::Scales>(2));
    QCOMPARE(refuseNumber(digits, {digits.catalog->withMotor(info, 2), std::int64_t{0}}),
        std::string("the scale of motor 2 is not known"));
}

void TestSetPoints::whatAWishSetsIsReadFromIt()
{
    struct Row {
        decltype(Wish::what) what;
        Feature feature;
        double first, second;
        std::chrono::milliseconds duration;
    };
    const Row rows[] = {{SpeedRamp{2, -900, 30ms}, Feature::SpeedRamp, -900.0, 0.0, 30ms},
        {TorqueRamp{2, 1.5, 40ms}, Feature::TorqueRamp, 1.5, 0.0, 40ms},
        {CurrentReference{2, 1.5, -2.5}, Feature::CurrentReference, 1.5, -2.5, 0ms}};
    for (const Row &row : rows) {
        const auto found = setPointOf(row.what);
        QVERIFY(found.has_value());
        QCOMPARE(found->feature, row.feature);
        QCOMPARE(found->motor, 2);
        QCOMPARE(found->first, row.first);
        QCOMPARE(found->second, row.second);
        QCOMPARE(found->duration.count(), row.duration.count());
    }
    QVERIFY(!setPointOf(Command{}));
    QVERIFY(!setPointOf(PositionRamp{}));
}

void TestSetPoints::aWordOnTheWireHolds16Bits()
{
    BoardFacts facts = boardFacts();
    QCOMPARE(refuseWireSpeed(facts, 1, 4001.0), std::string("beyond the limit of 4000 rpm"));
    facts.limits[0].maxSpeedRpm = 50000.0;
    facts.limits[0].wireRpm = 32767.0;
    for (const double sign : {1.0, -1.0}) {
        QCOMPARE(refuseWireSpeed(facts, 1, sign * 32767.0), std::string());
        QCOMPARE(refuseWireSpeed(facts, 1, sign * 32768.0),
            std::string("beyond the 32767 rpm that this protocol can hold"));
    }
}

/// As a set-point of just the limit is sent as that digit.
void TestSetPoints::aStageMayHoldTheDigitNextToALimit()
{
    BoardFacts facts = boardFacts();
    facts.limits[0].wireRpm = 32767.0;
    const auto refuse = [&](int digits) {
        return refuseStages(
            facts, 1, motor::bytesOf({{0, 1, 100}, {900, static_cast<std::int16_t>(digits), 0}}));
    };
    const std::string beyond = "beyond the limit of 5 A";
    const std::pair<double, int> rows[] = {{2723.0, 2723}, {2722.7, 2723}, {2722.4, 2722}};
    for (const auto &[digitsOfLimit, most] : rows) {
        facts.scales = scalesOf(5.0 / digitsOfLimit);
        QCOMPARE(int{digitsOf(facts, 1, 5.0)}, most);
        for (const int sign : {1, -1}) {
            QCOMPARE(refuse(sign * most), std::string());
            QCOMPARE(refuse(sign * (most + 1)), beyond);
        }
        QCOMPARE(refuse(-32768), beyond);
    }
    facts.scales = scalesOf(1.0);
    facts.user.maxCurrentAmps = 0.4; // less than half a digit
    QCOMPARE(refuse(1), std::string("beyond your own limit of 0.4 A"));
    facts.scales = scalesOf(0.0); // six-step
    QCOMPARE(refuse(32767), std::string());
}

void TestSetPoints::everyPartOfASetPointIsLookedAt()
{
    BoardFacts facts = boardFacts();
    facts.scales = scalesOf(0.001);
    const SetPoint speed{Feature::SpeedRamp, 1, 4000.0, 0.0, 10ms};
    const SetPoint current{Feature::CurrentReference, 1, 3.0, -4.0, {}};
    QCOMPARE(refuseSetPoint(facts, speed), std::string());
    QCOMPARE(refuseSetPoint(facts, current), std::string());
    const auto with = [&](SetPoint one, auto change) {
        change(one);
        return refuseSetPoint(facts, one);
    };
    for (const SetPoint &one : {speed, current}) {
        QCOMPARE(with(one, [](SetPoint &it) { it.motor = 3; }), std::string("there is no motor 3"));
        QCOMPARE(with(one, [](SetPoint &it) { it.duration = -1ms; }),
            std::string("a ramp lasts 0 to 65535 ms"));
    }
    QCOMPARE(with(speed, [](SetPoint &it) { it.first = -4001.0; }),
        std::string("beyond the limit of 4000 rpm"));
    QCOMPARE(with(current, [](SetPoint &it) { it.second = 4.1; }), // the whole of both parts
        std::string("beyond the limit of 5 A"));
    // A speed needs no scale of currents, a current needs it.
    facts.scales.clear();
    QCOMPARE(refuseSetPoint(facts, speed), std::string());
    QCOMPARE(refuseSetPoint(facts, current), facts.reasonAgainstAmps(1));
    QVERIFY(!facts.reasonAgainstAmps(1).empty());
    // 5 A are allowed, and 32767 digits of them fit.
    facts.scales = scalesOf(5.0 / 32767.0);
    for (const auto &[iq, id] : {std::pair(5.0, 0.0), std::pair(0.0, -5.0), std::pair(-3.0, 4.0)})
        QCOMPARE(refuseSetPoint(facts, {Feature::CurrentReference, 1, iq, id, {}}), std::string());
    facts.scales = scalesOf(5.0 / 32768.0);
    for (const auto &[iq, id] : {std::pair(5.0, 0.0), std::pair(0.0, -5.0)})
        QCOMPARE(refuseSetPoint(facts, {Feature::CurrentReference, 1, iq, id, {}}),
            std::string("beyond what 16 bits hold"));
    facts.capabilities = {
        {Feature::SpeedRamp, false, "not built in"}, {Feature::CurrentReference, true, {}}};
    QCOMPARE(refuseSetPoint(facts, speed), std::string("not built in"));
}

void TestSetPoints::digitsAreRoundedAndClamped()
{
    BoardFacts facts = boardFacts();
    facts.scales = scalesOf(0.5);
    const std::pair<double, int> rows[] = {{0.0, 0}, {1.2, 2}, {1.3, 3}, {-1.3, -3},
        {16383.5, 32767}, {20000.0, 32767}, {-20000.0, -32767}};
    for (const auto &[amps, digits] : rows)
        QCOMPARE(int{digitsOf(facts, 1, amps)}, digits);
}

QTEST_APPLESS_MAIN(TestSetPoints)
#include "tst_set_points.moc"
