// What bounds the motion of a motor: the board's limits, the user's own, and expert mode where the board is silent.
#include "drive/mcp/limits.h"
#include "drive/mcp/scales.h"
#include "drive/set_point_check.h"
#include "support/link_pair.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>

using namespace drive;
using simulation::Lie;
using support::Session;
using namespace std::chrono_literals;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

simulation::BoardOptions lying(Lie lie)
{
    simulation::BoardOptions options;
    options.lies = {{lie, 1}};
    return options;
}

std::string reasonOfEnd(Session &session, WishId wish)
{
    return session.runUntilEnded(wish) ? session.ended[wish].front().reason : "never ended";
}

bool changedSomething(const Session &session, std::size_t since)
{
    return std::any_of(session.requests.begin() + static_cast<std::ptrdiff_t>(since),
        session.requests.end(), support::changesSomething);
}

} // namespace

class TestMotionLimits : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anyStructureGivesBoundsThatBound();
    void everyGapIsNamed();
    void whatTheBoardDoesNotTellMovesNothing_data();
    void whatTheBoardDoesNotTellMovesNothing();
    void anExpertMovesItAllTheSame();
    void expertModeEndsWithTheConnection();
    void expertModeIsForWhatIsUnknownOnly();
    void theLowerLimitWins();
    void loweringALimitEndsWhatWaits();
    void aMotorIsSalientByWhatItsBoardTells();
    void theSensorTellsWhatTheRatedFluxMeans();
    void limitsOfNoUseAreRefused();
    void ownLimitsOutliveTheConnection();
    void aStartThatWouldGoBeyondOnesOwnLimitIsRefused_data();
    void aStartThatWouldGoBeyondOnesOwnLimitIsRefused();
    void theLastRampSaysWhereAStartGoes_data();
    void theLastRampSaysWhereAStartGoes();
    void theLastTorqueSaysWhereAStartGoes();
    void aStartThatFollowsNoSetPointIsRefusedWithOnesOwnLimit();
    void stagesOfTheStartUpAreWithinTheLimits();
    void setPointsOfEveryFamilyAreBounded_data();
    void setPointsOfEveryFamilyAreBounded();
    void everyProfileTellsItsLimits();
};

void TestMotionLimits::anyStructureGivesBoundsThatBound()
{
    support::Random random(5);
    int known = 0;
    for (int round = 0; round < 20000; ++round) {
        Bytes raw(16);
        for (std::uint8_t &byte : raw)
            byte = static_cast<std::uint8_t>(random.next());
        if (round % 2 == 0) { // plausible numbers among the noise
            raw = ByteWriter().u32(4000).f32(32.0F).f32(5.0F).u16(24).u8(0).u8(0).take();
            raw[random.below(12)] = static_cast<std::uint8_t>(random.next());
        }
        McpMotorDescription description;
        description.application = *mcp::decodeApplicationConfig(raw);
        McpFacts board;
        board.limits = {limitsOf(description)};
        if (random.chance(0.3))
            board.user = {1000.0, 2.0};
        if (random.chance(0.3))
            board.expert = {1};
        const MotionBounds bounds = board.boundsOf(1);
        QVERIFY(bounds.rpm >= 0.0 && bounds.rpm <= kHighestRpm);
        QVERIFY(bounds.amps >= 0.0 && bounds.amps <= kHighestAmps);
        known += bounds.rpm > 0.0 && bounds.amps > 0.0 ? 1 : 0;
        const auto bits = random.next();
        double value = 0.0;
        std::memcpy(&value, &bits, sizeof value);
        for (const double asked : {value, kNan, kInfinity, -kInfinity, 1e300, 0.0, 1000.0, -3.0}) {
            const bool inside = std::isfinite(asked);
            const auto &own = board.user;
            const auto may = [&](double bound, double limit) {
                return inside && bound > 0.0 && std::abs(asked) <= bound
                    && (limit == 0.0 || std::abs(asked) <= limit);
            };
            QCOMPARE(refuseSpeed(board, 1, asked).empty(), may(bounds.rpm, own.maxSpeedRpm));
            QCOMPARE(refuseCurrent(board, 1, asked).empty(), may(bounds.amps, own.maxCurrentAmps));
        }
    }
    QVERIFY(known > 1000);
}

void TestMotionLimits::everyGapIsNamed()
{
    for (const double odd : {0.0, -1.0, kNan, kInfinity, 1e9}) {
        MotorLimits limits{4000.0, 32.0, 5.0, 4.0, 0.1};
        QVERIFY(gapsIn(limits).empty());
        limits.maxSpeedRpm = odd;
        QVERIFY(gapsIn(limits) == std::vector{LimitGap::MaxSpeed});
        QCOMPARE(boundsOf(limits, {}, false).rpm, 0.0);
        QCOMPARE(boundsOf(limits, {}, false).amps, 5.0);
        limits.nominalCurrentAmps = odd;
        QVERIFY(gapsIn(limits) == (std::vector{LimitGap::MaxSpeed, LimitGap::NominalCurrent}));
        QCOMPARE(boundsOf(limits, {}, false).amps, 0.0);
        QCOMPARE(boundsOf(limits, {}, true).amps, 32.0); // what is known still bounds
        QCOMPARE(boundsOf(limits, {1500.0, 0.0}, true).rpm, 1500.0);
    }
}

void TestMotionLimits::whatTheBoardDoesNotTellMovesNothing_data()
{
    QTest::addColumn<int>("lie");
    QTest::newRow("nan") << int(Lie::NotANumber);
    QTest::newRow("infinite") << int(Lie::Infinite);
    QTest::newRow("zeros") << int(Lie::Zeros);
    QTest::newRow("huge") << int(Lie::Huge);
}

void TestMotionLimits::whatTheBoardDoesNotTellMovesNothing()
{
    QFETCH(int, lie);
    Session session(true, lying(Lie(lie)));
    QVERIFY(session.ready);
    const std::size_t before = session.requests.size();
    for (const std::string &reason :
        {reasonOfEnd(session, session.submit(Command{MotorAction::Start, 1})),
            reasonOfEnd(session, session.submit(TorqueRamp{1, 0.1, 100ms}))}) {
        QVERIFY2(reason.find("current") != std::string::npos, reason.c_str());
    }
    const std::string why = reasonOfEnd(session, session.submit(Command{MotorAction::Start, 1}));
    QVERIFY2(why.find("expert mode") != std::string::npos, why.c_str());
    QVERIFY(!changedSomething(session, before));
}

void TestMotionLimits::anExpertMovesItAllTheSame()
{
    Session session(true, lying(Lie::NotANumber));
    const WishId expert = session.submit(ExpertMode{1});
    QVERIFY(session.runUntilEnded(expert));
    QVERIFY(session.outcome(expert) == Outcome::Ok);
    QVERIFY(session.startMotor());
    // What is known bounds an expert, too.
    const WishId tooFast = session.submit(
        SpeedRamp{1, std::int32_t(session.identified->limits[0].maxSpeedRpm) + 1, 100ms});
    QVERIFY(session.runUntilEnded(tooFast));
    QVERIFY(session.outcome(tooFast) == Outcome::Refused);
}

void TestMotionLimits::expertModeEndsWithTheConnection()
{
    Session session(true, lying(Lie::NotANumber));
    QVERIFY(session.runUntilEnded(session.submit(ExpertMode{1})));
    session.toDrive.cut = true;
    QVERIFY(session.runUntil([&] { return session.link == LinkState::Lost; }, 10s));
    session.toDrive.cut = false;
    session.identified.reset();
    QVERIFY(session.runUntilIdentified(10s));
    session.drive->arm();
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(reasonOfEnd(session, start).find("expert mode") != std::string::npos);
}

void TestMotionLimits::expertModeIsForWhatIsUnknownOnly()
{
    Session session;
    for (const int motor : {0, 1, 2, 8}) {
        const WishId wish = session.submit(ExpertMode{motor});
        QVERIFY(session.runUntilEnded(wish));
        QVERIFY(session.outcome(wish) == Outcome::Refused);
    }
}

void TestMotionLimits::theLowerLimitWins()
{
    Session session;
    const MotorLimits board = session.identified->limits.at(0);
    const auto ends = [&](auto what) {
        const WishId wish = session.submit(what);
        return session.runUntilEnded(wish) ? session.outcome(wish) : Outcome::Unknown;
    };
    QVERIFY(ends(UserLimits{1000.0, 1.0}) == Outcome::Ok);
    QVERIFY(ends(SpeedRamp{1, 1001, 0ms}) == Outcome::Refused);
    QVERIFY(ends(SpeedRamp{1, -1001, 0ms}) == Outcome::Refused);
    QVERIFY(ends(SpeedRamp{1, 1000, 0ms}) == Outcome::Ok);
    QVERIFY(ends(Write{{{session.id("SPEED_REF"), std::int64_t{1001}}}}) == Outcome::Refused);
    QVERIFY(ends(TorqueRamp{1, 1.01, 0ms}) == Outcome::Refused);
    QVERIFY(ends(CurrentReference{1, 0.8, 0.8}) == Outcome::Refused);
    QVERIFY(ends(CurrentReference{1, 0.6, 0.6}) == Outcome::Ok);
    const WishId beyond = session.submit(SpeedRamp{1, 2000, 0ms});
    QVERIFY(reasonOfEnd(session, beyond).find("your own limit of 1000 rpm") != std::string::npos);

    QVERIFY(ends(UserLimits{1234.56, 1.0}) == Outcome::Ok);
    const WishId fine = session.submit(SpeedRamp{1, 2000, 0ms});
    QVERIFY(reasonOfEnd(session, fine).find("your own limit of 1234.56 rpm") != std::string::npos);

    QVERIFY(ends(UserLimits{1e6, 1e6}) == Outcome::Ok);
    QVERIFY(ends(SpeedRamp{1, std::int32_t(board.maxSpeedRpm) + 1, 0ms}) == Outcome::Refused);
    QVERIFY(ends(TorqueRamp{1, board.nominalCurrentAmps * 1.01, 0ms}) == Outcome::Refused);
    QVERIFY(ends(SpeedRamp{1, std::int32_t(board.maxSpeedRpm), 0ms}) == Outcome::Ok);
}

void TestMotionLimits::loweringALimitEndsWhatWaits()
{
    Session session;
    session.drive->arm();
    std::vector<WishId> ramps;
    for (const int rpm : {1500, 1600, 1700})
        ramps.push_back(session.submit(SpeedRamp{1, rpm, 0ms}));
    const WishId read = session.submit(Read{{session.id("SPEED_KP")}});
    const WishId stop = session.submit(Command{MotorAction::StopMotor, 1});
    const WishId limits = session.submit(UserLimits{1000.0, 0.0});
    for (const WishId wish : {ramps[0], ramps[1], ramps[2], read, stop, limits})
        QVERIFY(session.runUntilEnded(wish));
    QVERIFY(session.outcome(ramps[0]) != Outcome::Refused); // it had begun
    for (const WishId late : {ramps[1], ramps[2]}) {
        QVERIFY(session.outcome(late) == Outcome::NotSent);
        QVERIFY(reasonOfEnd(session, late).find("limits") != std::string::npos);
    }
    QVERIFY(session.outcome(read) == Outcome::Ok);
    QVERIFY(session.outcome(stop) == Outcome::Ok);
}

void TestMotionLimits::aMotorIsSalientByWhatItsBoardTells()
{
    const auto saliencyOf = [](float lq, float ld) {
        mcp::MotorConfig told;
        told.lq = lq;
        told.ld = ld;
        McpMotorDescription description;
        description.motor = told;
        return limitsOf(description).saliency_h;
    };
    QVERIFY(std::abs(saliencyOf(0.6e-3F, 0.25e-3F) - 0.35e-3) < 1e-9);
    const auto nan = static_cast<float>(kNan), infinity = static_cast<float>(kInfinity);
    QCOMPARE(saliencyOf(0.6e-3F, 0.0F), 0.0); // Ld is not told
    QCOMPARE(saliencyOf(0.25e-3F, 0.6e-3F), 0.0);
    QCOMPARE(saliencyOf(nan, 0.25e-3F), 0.0);
    QCOMPARE(saliencyOf(0.6e-3F, nan), 0.0);
    QCOMPARE(saliencyOf(infinity, 0.25e-3F), 0.0);
}

/// The rated flux is Ke in standard firmware, and V/Hz in that of the HSO and ZeST sensors.
void TestMotionLimits::theSensorTellsWhatTheRatedFluxMeans()
{
    const auto torqueOf = [](int primarySensor, bool sixStep = false) {
        McpMotorDescription description;
        description.motor.emplace();
        description.motor->polePairs = 14.0F;
        description.motor->ratedFlux = 8.2F;
        description.firmware.emplace();
        description.firmware->primarySensor = static_cast<std::uint8_t>(primarySensor);
        description.firmware->sixStep = sixStep;
        return limitsOf(description).torquePerAmp;
    };
    // 8.2 V/krpm, rms between two wires: 4.567 mWb; 1.5 * 14 * 4.567 mWb
    const double ofKe = 1.5 * 8.2 * std::sqrt(2.0 / 3.0) / (1000.0 * std::numbers::pi / 30.0);
    // 8.2 V/Hz, peak of a phase: 1.305 Wb
    const double ofHertz = 1.5 * 14.0 * 8.2 / (2.0 * std::numbers::pi);
    for (const int sensor : {1, 2, 3, 4})
        QVERIFY(std::abs(torqueOf(sensor) - ofKe) < 1e-6);
    for (const int sensor : {5, 6})
        QVERIFY(std::abs(torqueOf(sensor) - ofHertz) < 1e-4);
    QVERIFY(std::abs(torqueOf(5, true) - ofKe) < 1e-6);
}

void TestMotionLimits::limitsOfNoUseAreRefused()
{
    Session session;
    QVERIFY(session.runUntilEnded(session.submit(UserLimits{1000.0, 1.0})));
    for (const double odd : {-1.0, kNan, kInfinity}) {
        for (const UserLimits &limits : {UserLimits{odd, 1.0}, UserLimits{1000.0, odd}}) {
            const WishId wish = session.submit(limits);
            QVERIFY(session.runUntilEnded(wish));
            QVERIFY(session.outcome(wish) == Outcome::Refused);
        }
    }
    const WishId beyond = session.submit(SpeedRamp{1, 1001, 0ms});
    QVERIFY(session.runUntilEnded(beyond)); // the limits before are still there
    QVERIFY(session.outcome(beyond) == Outcome::Refused);
}

void TestMotionLimits::ownLimitsOutliveTheConnection()
{
    support::LinkPair pair;
    pair.submit(UserLimits{1000.0, 1.0}); // even before there is one
    for (int round = 0; round < 2; ++round) {
        pair.identified.reset();
        pair.connect();
        QVERIFY(pair.runUntilIdentified());
        pair.drive->arm();
        const WishId beyond = pair.submit(SpeedRamp{1, 1001, 0ms});
        QVERIFY(pair.runUntilEnded(beyond));
        QVERIFY(pair.outcome(beyond) == Outcome::Refused);
    }
}

void TestMotionLimits::aStartThatWouldGoBeyondOnesOwnLimitIsRefused_data()
{
    QTest::addColumn<double>("rpm");
    QTest::addColumn<double>("amps");
    QTest::addColumn<bool>("starts");
    QTest::newRow("reference too fast") << 100.0 << 0.0 << false;
    QTest::newRow("start-up too strong") << 0.0 << 0.1 << false;
    QTest::newRow("within") << 3900.0 << 4.9 << true;
}

void TestMotionLimits::aStartThatWouldGoBeyondOnesOwnLimitIsRefused()
{
    QFETCH(double, rpm);
    QFETCH(double, amps);
    QFETCH(bool, starts);
    Session session;
    QVERIFY(session.runUntilEnded(session.submit(UserLimits{rpm, amps})));
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    QVERIFY(session.runUntilEnded(start));
    QCOMPARE(session.outcome(start) == Outcome::Ok, starts);
    QCOMPARE(support::count(session.requests, mcp::CommandId::StartMotor), starts ? 1U : 0U);
    if (!starts) {
        const std::string why = session.ended[start].front().reason;
        QVERIFY2(why.find("your own limit") != std::string::npos, why.c_str());
    }
}

void TestMotionLimits::theLastRampSaysWhereAStartGoes_data()
{
    // Asked for while it rests; the reference is 1380 rpm still, its start-up 1080.
    QTest::addColumn<int>("rpm");
    QTest::addColumn<double>("limit");
    QTest::addColumn<bool>("starts");
    QTest::newRow("the old reference is beyond the limit") << 498 << 1200.0 << true;
    QTest::newRow("backwards") << -498 << 1200.0 << true;
    QTest::newRow("the ramp is beyond the limit") << 1998 << 1500.0 << false;
    QTest::newRow("the ramp is beyond it backwards") << -1998 << 1500.0 << false;
    QTest::newRow("both are") << 1998 << 1000.0 << false;
}

void TestMotionLimits::theLastRampSaysWhereAStartGoes()
{
    QFETCH(int, rpm);
    QFETCH(double, limit);
    QFETCH(bool, starts);
    simulation::BoardOptions options;
    options.motor = "servo24";
    Session session(true, options);
    QVERIFY(session.runUntilEnded(session.submit(SpeedRamp{1, rpm, 0ms})));
    const RegisterId reference = session.id("SPEED_REF");
    QVERIFY(session.runUntilEnded(session.submit(Read{{reference}})));
    QVERIFY(session.values.at(reference).value == Value(std::int64_t{1380}));

    QVERIFY(session.runUntilEnded(session.submit(UserLimits{limit, 0.0})));
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    const std::string why = reasonOfEnd(session, start);
    QCOMPARE(session.outcome(start) == Outcome::Ok, starts);
    QCOMPARE(support::count(session.requests, mcp::CommandId::StartMotor), starts ? 1U : 0U);
    if (!starts) {
        QVERIFY2(why.starts_with("SPEED_RAMP is beyond your own limit"), why.c_str());
        QVERIFY(session.ended.at(start).front().byProgram);
        return;
    }
    double fastest = 0.0;
    session.runUntil(
        [&] {
            if (session.status.contains(1))
                fastest = std::max(fastest, std::abs(session.status.at(1).speedRpm.value_or(0.0)));
            return false;
        },
        3s);
    QVERIFY2(fastest > 400.0 && fastest < limit, std::to_string(fastest).c_str());
}

void TestMotionLimits::theLastTorqueSaysWhereAStartGoes()
{
    simulation::BoardOptions options;
    options.motor = "servo24";
    Session session(true, options);
    const auto starts = [&](double amps) {
        session.runUntilEnded(session.submit(UserLimits{}));
        session.runUntilEnded(session.submit(TorqueRamp{1, amps, 0ms}));
        session.runUntilEnded(session.submit(UserLimits{0.0, 4.0}));
        return session.submit(Command{MotorAction::Start, 1});
    };
    for (const double amps : {5.0, -5.0}) {
        const std::string why = reasonOfEnd(session, starts(amps));
        QVERIFY2(why.starts_with("TORQUE_RAMP is beyond your own limit of 4 A"), why.c_str());
    }
    QCOMPARE(support::count(session.requests, mcp::CommandId::StartMotor), 0U);
    const WishId within = starts(0.2);
    const std::string why = reasonOfEnd(session, within);
    QVERIFY2(session.outcome(within) == Outcome::Ok, why.c_str());
    session.drive->stop(session.now);
    QVERIFY(session.runUntilState(MotorState::Idle));
    session.runFor(3s);
    // Of just the limit, whatever its digits are.
    for (double limit = 4.0; limit < 4.0012; limit += 0.0004) {
        session.drive->arm();
        session.runUntilEnded(session.submit(UserLimits{0.0, limit}));
        session.runUntilEnded(session.submit(TorqueRamp{1, limit, 0ms}));
        const WishId start = session.submit(Command{MotorAction::Start, 1});
        const std::string refused = reasonOfEnd(session, start);
        QVERIFY2(session.outcome(start) == Outcome::Ok, refused.c_str());
        session.drive->stop(session.now);
        QVERIFY(session.runUntilState(MotorState::Idle));
        session.runFor(3s);
    }
}

void TestMotionLimits::aStartThatFollowsNoSetPointIsRefusedWithOnesOwnLimit()
{
    simulation::BoardOptions options;
    options.profile = "hso";
    Session session(true, options);
    const RegisterId source = session.id("FOC_SPEED_SOURCE_SELECT"); // a potentiometer
    QVERIFY(session.runUntilEnded(
        session.submit(Write{{{source, std::int64_t{1}}}, Reach::Everything})));
    session.runUntilEnded(session.submit(UserLimits{3900.0, 0.0}));
    const WishId start = session.submit(Command{MotorAction::Start, 1});
    const std::string why = reasonOfEnd(session, start);
    QVERIFY(session.outcome(start) == Outcome::Refused);
    QVERIFY2(why.starts_with("FOC_SPEED_SOURCE_SELECT is on"), why.c_str());
}

void TestMotionLimits::stagesOfTheStartUpAreWithinTheLimits()
{
    Session session;
    const RegisterId id = session.id("REVUP_DATA");
    session.runUntilEnded(session.submit(Read{{id}}));
    const Bytes held = std::get<Bytes>(session.values.at(id).value);
    std::string why;
    const auto ends = [&](double rpm, double amps) {
        Bytes raw = held; // of a stage: rpm, digits, ms
        const auto digits = static_cast<std::int16_t>(std::lround(
            amps / session.identified->catalog->readScale(session.id("I_Q_REF")).factor));
        const Bytes stage = ByteWriter()
                                .u32(static_cast<std::uint32_t>(static_cast<std::int32_t>(rpm)))
                                .u16(static_cast<std::uint16_t>(digits))
                                .take();
        std::copy(stage.begin(), stage.end(), raw.begin());
        const WishId wish = session.submit(Write{{{id, raw}}, Reach::Parameters});
        why = reasonOfEnd(session, wish);
        return session.outcome(wish);
    };
    const MotionBounds bounds = boundsOf(session.identified->limits.at(0), {}, false);
    const std::size_t before = session.requests.size();
    QVERIFY(ends(bounds.rpm + 60.0, 0.5) == Outcome::Refused);
    QVERIFY(ends(600.0, bounds.amps * 1.1) == Outcome::Refused);
    const double digit = session.identified->catalog->readScale(session.id("I_Q_REF")).factor;
    QVERIFY(ends(600.0, bounds.amps + digit) == Outcome::Refused);
    QVERIFY(!changedSomething(session, before));
    QVERIFY2(ends(600.0, bounds.amps) == Outcome::Ok, why.c_str()); // the digit next to it
    QVERIFY2(ends(600.0, bounds.amps * 0.5) == Outcome::Ok, why.c_str());
}

void TestMotionLimits::setPointsOfEveryFamilyAreBounded_data()
{
    QTest::addColumn<QString>("profile");
    QTest::addColumn<QString>("name");
    const auto row = [](const char *profile, const char *name) {
        QTest::addRow("%s %s", profile, name) << profile << name;
    };
    row("mcsdk-6.4", "SPEED_REF");
    row("mcsdk-6.4", "I_Q_REF");
    row("mcsdk-6.4", "I_D_REF");
    row("six-step", "SPEED_REF");
    row("hso", "FOC_SPEEDREF_FREQ_PU");
    row("hso", "FOC_SPEEDREF_RAMPED_FREQ_PU");
    row("hso", "FOC_IQREF");
    row("hso", "FOC_IDREF");
    row("hso", "FOC_TORQUE_REF_NM");
}

void TestMotionLimits::setPointsOfEveryFamilyAreBounded()
{
    QFETCH(QString, profile);
    QFETCH(QString, name);
    simulation::BoardOptions options;
    options.profile = profile.toStdString();
    Session session(true, options);
    QVERIFY(session.ready);
    const RegisterId id = session.id(name.toStdString());
    const auto *info = session.identified->catalog->find(id);
    QVERIFY(info != nullptr);
    const MotorLimits limits = session.identified->limits.at(0);
    const double perDigit =
        setPointPerDigit(*info, session.identified->catalog->readScale(id), limits);
    QVERIFY(perDigit > 0.0);
    const MotionBounds bounds = boundsOf(limits, {}, false);
    const double bound = info->setPoint == catalog::SetPoint::Speed ? bounds.rpm : bounds.amps;
    QVERIFY(bound > 0.0);
    const auto ends = [&](double digits) {
        const WishId wish = session.submit(Write{{{id, static_cast<std::int64_t>(digits)}}});
        return session.runUntilEnded(wish) ? session.outcome(wish) : Outcome::Unknown;
    };
    const std::size_t before = session.requests.size();
    for (const double sign : {1.0, -1.0})
        for (const double share : {1.001, 1.5})
            QVERIFY(ends(sign * std::ceil(bound / perDigit * share + 1.0)) == Outcome::Refused);
    QVERIFY(!changedSomething(session, before));
    QVERIFY(ends(std::floor(bound / perDigit * 0.5)) == Outcome::Ok);
}

void TestMotionLimits::everyProfileTellsItsLimits()
{
    for (const std::string &profile : simulation::profileNames()) {
        simulation::BoardOptions options;
        options.profile = profile;
        Session session(false, options);
        QVERIFY(session.ready);
        QVERIFY2(gapsIn(session.identified->limits.at(0)).empty(), profile.c_str());
    }
}

QTEST_GUILESS_MAIN(TestMotionLimits)
#include "tst_motion_limits.moc"
