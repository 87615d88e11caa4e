// Inertia and friction of boards that record nothing by themselves: from speed and current that are read one after the
// other while ramps lead the motor up and down.
#include "core/lab/estimate_checks.h"
#include "core/lab/older_bench.h"
#include "lab/evaluation/finding.h"
#include "motor/constants.h"

using lab::End;
using support::OlderBench;
using support::olderServo;
using namespace std::chrono_literals;

namespace {

double torqueConstantOf(const simulation::MotorParameters &motor)
{
    return motor::ktOfFlux_nmpa(motor.flux_wb, motor.polePairs);
}

/// With what its user says: the full scale of its currents, and what torque an ampere makes.
struct MechanicsBench : OlderBench {
    explicit MechanicsBench(const simulation::BoardOptions &options, double mostRpm = 3000.0)
        : OlderBench(options, options.plant->inverter.maxReadable_a())
    {
        pair.submit(drive::UserLimits{mostRpm, 0.0});
        experiment.subject.limits.torquePerAmp = torqueConstantOf(options.plant->motor);
        experiment.plan = lab::spinPlanFor(experiment.subject, {mostRpm, 0.0});
    }
    Result<lab::Finding, std::string> finding() const
    {
        return lab::findingIn(capture, happenings);
    }
};

} // namespace

class TestPolledMechanics : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theMechanicsAreThoseOfTheMotor_data();
    void theMechanicsAreThoseOfTheMotor();
    void aRunningMotorComesBackGently();
    void aFaultOnARampEndsItAndIsNamed();
    void bothDirectionsAreOneRun();
    void readsThatAreMissingTakeNothingButThemselves();
    void withoutATorqueNothingIsBegun();
    void ofAFileThatSaysYearsNothingIsCounted();
};

void TestPolledMechanics::theMechanicsAreThoseOfTheMotor_data()
{
    QTest::addColumn<QByteArray>("motor");
    QTest::addColumn<quint32>("baud");
    QTest::addColumn<double>("heavier");
    QTest::addColumn<bool>("absorbs");
    QTest::newRow("an encoder") << QByteArray("servo24") << 115200U << 1.0 << false;
    QTest::newRow("a slow line") << QByteArray("servo24") << 19200U << 1.0 << true;
    QTest::newRow("a flywheel") << QByteArray("servo24") << 115200U << 8.0 << true;
    QTest::newRow("no sensor") << QByteArray("pm24") << 115200U << 1.0 << false;
    QTest::newRow("a blower") << QByteArray("blower36") << 115200U << 1.0 << false;
}

void TestPolledMechanics::theMechanicsAreThoseOfTheMotor()
{
    QFETCH(const QByteArray, motor);
    QFETCH(const quint32, baud);
    QFETCH(const double, heavier);
    QFETCH(const bool, absorbs);
    simulation::BoardOptions options = olderServo(baud, motor.constData());
    options.plant->motor.inertia_kgm2 *= heavier;
    options.plant->inverter.supplyAbsorbs = absorbs;
    const simulation::PlantParameters truth = *options.plant;
    MechanicsBench bench(options);
    QVERIFY(bench.pair.ready);
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(!outcome.leaves, outcome.reason.c_str());
    QCOMPARE(bench.stops, 0);
    QVERIFY(bench.asked<drive::Stream>().empty() && bench.asked<drive::TorqueRamp>().empty());
    const auto finding = bench.finding();
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::Mechanics>(*finding);
    VERIFY_WITHIN(found.inertia_kgm2, truth.motor.inertia_kgm2, 10.0);
    VERIFY_HOLDS(found.inertia_kgm2, truth.motor.inertia_kgm2);
    // In the middle of its speeds, whichever of them the model takes it for.
    const auto &plan = std::get<lab::SpinPlan>(bench.experiment.plan);
    const double speed = (plan.lowRpm + plan.highRpm) / 2.0 * 2.0 * 3.14159265 / 60.0;
    const auto friction = [speed](double dry, double viscous, double fan) {
        return dry + viscous * speed + fan * speed * speed;
    };
    const double held = friction(truth.motor.coulomb_nm + truth.load.constant_nm,
        truth.motor.viscous_nms, truth.load.fan_nms2);
    const double told = friction(found.dry_nm.value, found.viscous_nms.value, found.fan_nms2.value);
    QVERIFY2(std::abs(told / held - 1.0) < 0.1, qPrintable(QString::number(told / held)));
    VERIFY_HOLDS(found.dry_nm, truth.motor.coulomb_nm + truth.load.constant_nm);
    VERIFY_HOLDS(found.viscous_nms, truth.motor.viscous_nms);
    QVERIFY(std::ranges::any_of(found.notes, [](const std::string &note) {
        return note.find("records nothing by itself") != std::string::npos;
    }));
    QVERIFY(std::ranges::none_of(found.notes, [](const std::string &note) {
        return note.find("swings") != std::string::npos
            || note.find("nearly stood still") != std::string::npos;
    }));
}

/// Its slow ramps have not shown that the bus takes a fast one. What comes behind the last of them counts for nothing.
void TestPolledMechanics::aRunningMotorComesBackGently()
{
    MechanicsBench bench(olderServo());
    QVERIFY(bench.pair.ready);
    QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(drive::SpeedRamp{1, 300, 0ms})));
    QVERIFY(bench.pair.runAt(300));
    bench.pair.runFor(1s);
    VERIFY_END(bench.run(), End::Complete);
    const auto ramps = bench.asked<drive::SpeedRamp>();
    QCOMPARE(ramps.size(), std::size_t(13)); // there, ten, back, and that of before once more
    QCOMPARE(ramps[11].rpm, 300);
    QVERIFY(ramps[11].duration == 3s);
    const auto finding = bench.finding();
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    for (const std::string &note : std::get<lab::Mechanics>(*finding).notes)
        QVERIFY2(note.find("stood still") == std::string::npos, note.c_str());
}

void TestPolledMechanics::aFaultOnARampEndsItAndIsNamed()
{
    MechanicsBench bench(olderServo());
    QVERIFY(bench.pair.ready);
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<drive::SpeedRamp>().size() >= 4; }, 20s));
    bench.runUntil([] { return false; }, 700ms);
    bench.pair.board->setFaults(0x0040);
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }, 5s));
    VERIFY_END(bench.runner->outcome(), End::Aborted);
    QVERIFY(bench.runner->outcome().reason.starts_with("the board reports a fault: "));
    const std::size_t wishes = bench.asked<drive::SpeedRamp>().size();
    bench.pair.runFor(5s);
    QCOMPARE(bench.asked<drive::SpeedRamp>().size(), wishes);
    QVERIFY(!bench.pair.board->truth(1).driven);
}

void TestPolledMechanics::bothDirectionsAreOneRun()
{
    MechanicsBench bench(olderServo());
    QVERIFY(bench.pair.ready);
    const auto plan = std::get<lab::SpinPlan>(bench.experiment.plan);
    for (const lab::SpinPlan &way : {plan, lab::otherWay(plan)}) {
        bench.experiment.plan = way;
        VERIFY_END(bench.run(), End::Complete);
    }
    QCOMPARE(lab::runsIn(bench.happenings).size(), std::size_t(1));
    const auto finding = bench.finding();
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::Mechanics>(*finding);
    QVERIFY(found.both);
    const double truth = simulation::findPreset("servo24")->motor.inertia_kgm2;
    VERIFY_WITHIN(found.inertia_kgm2, truth, 10.0);
    VERIFY_WITHIN(found.both->forwards_kgm2, truth, 10.0);
    VERIFY_WITHIN(found.both->backwards_kgm2, truth, 10.0);
    VERIFY_HOLDS(found.both->always_nm, 0.0);
}

/// As of a computer that stood still for a second.
void TestPolledMechanics::readsThatAreMissingTakeNothingButThemselves()
{
    MechanicsBench bench(olderServo());
    QVERIFY(bench.pair.ready);
    std::optional<double> begun_s;
    bench.loses = [&](const recorded::Entry &) {
        const double now_s = toSeconds(bench.pair.now.time_since_epoch());
        if (!begun_s && !bench.asked<drive::SpeedRamp>().empty())
            begun_s = now_s;
        return begun_s && now_s > *begun_s + 10.0 && now_s < *begun_s + 11.0;
    };
    VERIFY_END(bench.run(), End::Complete);
    const auto finding = bench.finding();
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::Mechanics>(*finding);
    VERIFY_WITHIN(found.inertia_kgm2, simulation::findPreset("servo24")->motor.inertia_kgm2, 10.0);
    QVERIFY(std::ranges::any_of(found.notes, [](const std::string &note) {
        return note.find("are missing in it") != std::string::npos;
    }));
}

void TestPolledMechanics::withoutATorqueNothingIsBegun()
{
    const simulation::BoardOptions options = olderServo();
    MechanicsBench bench(options);
    QVERIFY(bench.pair.ready);
    bench.experiment.subject.limits.torquePerAmp = 0.0;
    QVERIFY(lab::objectionTo(bench.experiment).starts_with("nothing tells which torque"));
    VERIFY_END(bench.run(), End::Refused);
    QVERIFY(bench.wishes.empty());
    OlderBench digits(options);
    QVERIFY(digits.pair.ready);
    digits.experiment.subject.limits.torquePerAmp = torqueConstantOf(options.plant->motor);
    digits.experiment.plan = lab::spinPlanFor(digits.experiment.subject, {3000.0, 0.0});
    QVERIFY(lab::objectionTo(digits.experiment).starts_with("nothing tells its current in A"));
}

/// Files are foreign.
void TestPolledMechanics::ofAFileThatSaysYearsNothingIsCounted()
{
    capture::Capture capture;
    constexpr double kYears_s = 3e8;
    for (const double at_s : {0.5, 0.502, 0.504, kYears_s, kYears_s + 0.002, 2.0 * kYears_s})
        for (const auto &[id, name, unit] :
            {std::tuple(7, "SPEED_MEAS", "rpm"), std::tuple(8, "I_Q_MEAS", "A")})
            capture.appendPolled(static_cast<drive::RegisterId>(id), name, unit, at_s, 1000.0);
    const lab::Happenings happenings{
        {0,
            {lab::SpinPlan::kEntry,
                {{"motor", "1"}, {"speed", "SPEED_MEAS"}, {"current", "I_Q_MEAS"},
                    {"torque Nm per A", "0.06"}, {"low rpm", "750"}, {"high rpm", "2100"}}}},
        {1, {"speed ramp", {{"motor", "1"}, {"rpm", "2100"}, {"ms", "1500"}}}},
    };
    const auto finding = lab::findingIn(capture, happenings);
    QVERIFY(!finding);
    QVERIFY2(finding.error().starts_with("the motor turned for only"), finding.error().c_str());
}

QTEST_APPLESS_MAIN(TestPolledMechanics)
#include "tst_polled_mechanics.moc"
