// Inertia and friction of simulated motors, whose truth is known: within the bars of the lab, and inside their
// intervals.
#include "core/lab/estimate_checks.h"
#include "core/lab/fast_motor.h"
#include "core/lab/lost_samples.h"
#include "lab/evaluation/finding.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

using namespace lab;
using simulation::MotorParameters;
using simulation::PlantParameters;
using support::LabBench;
using namespace std::chrono_literals;

namespace {

struct MeasuredMechanics {
    Outcome outcome;
    Result<Mechanics, std::string> found = fail(std::string());
    std::vector<drive::TorqueRamp> torques;
    double slowest_rpm = 1e9; ///< of the rotor while torques drove it
};

MeasuredMechanics measure(simulation::BoardOptions options, std::uint64_t seed,
    const std::function<void(LabBench &)> &also = {})
{
    options.seed = seed;
    LabBench bench(options, seed);
    SpinPlan plan = spinPlanFor(bench.experiment.subject, {});
    plan.seed = static_cast<std::uint32_t>(seed);
    bench.experiment.plan = plan;
    MeasuredMechanics measured;
    bool turning = false;
    bench.eachTurn = [&] {
        turning = turning || bench.pair.board->truth(1).rpm > plan.highRpm * 0.9;
        if (turning && bench.asked<drive::Command>().size() < 2)
            measured.slowest_rpm = std::min(measured.slowest_rpm, bench.pair.board->truth(1).rpm);
    };
    measured.outcome = bench.run();
    if (also)
        also(bench);
    measured.found = evaluateMechanics(bench.capture, bench.happenings);
    measured.torques = bench.asked<drive::TorqueRamp>();
    return measured;
}

MeasuredMechanics measure(const PlantParameters &plant, std::string_view motor, std::uint64_t seed,
    const std::function<void(LabBench &)> &also = {})
{
    simulation::BoardOptions options;
    options.motor = motor;
    options.load = plant.load;
    return measure(options, seed, also);
}

/// An observer behind a rotor too heavy for its gains, on a supply that takes back.
simulation::BoardOptions swingingBoard(double heavier)
{
    simulation::BoardOptions options;
    options.plant = *simulation::findPreset("ipm48");
    options.plant->motor.inertia_kgm2 *= heavier;
    options.plant->inverter.supplyAbsorbs = true;
    return options;
}

/// A hub motor with Hall sensors, as tests/data/invented/hub48.json at 300 rpm with ten pole pairs and 4e-3 kg m^2;
/// another speed with magnets for it.
PlantParameters hubMotor(double rpm, int polePairs, double inertia_kgm2, double brake)
{
    PlantParameters plant = *simulation::findPreset("blower36");
    plant.motor.polePairs = polePairs;
    plant.motor.rs_ohm = 0.3;
    plant.motor.ld_h = plant.motor.lq_h = 1e-3;
    plant.motor.flux_wb = 0.075 * 10.0 / polePairs * 300.0 / rpm;
    plant.motor.inertia_kgm2 = inertia_kgm2;
    plant.motor.viscous_nms = 5e-3;
    plant.motor.coulomb_nm = 0.3 * 300.0 / rpm;
    plant.motor.nominal_a = 8.0;
    plant.motor.maxSpeed_rpm = rpm;
    plant.inverter.supply_v = 48.0;
    plant.inverter.shunt_ohm = 0.005;
    plant.inverter.amplifierGain = 14.0;
    plant.inverter.busRange_v = 82.5;
    plant.load.fan_nms2 = 0.0;
    plant.load.constant_nm = brake * 1.5 * polePairs * plant.motor.flux_wb * plant.motor.nominal_a;
    return plant;
}

} // namespace

class TestMechanical : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// What its current does while it turns by 24 degrees looks like a fan.
    void aRotorThatTurnsFarInAControlPeriodIsToldHonestly()
    {
        simulation::BoardOptions options;
        options.plant = support::fastMotor();
        const simulation::MotorParameters &truth = options.plant->motor;
        const MeasuredMechanics measured = measure(options, 1);
        QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
        const Mechanics &found = *measured.found;
        VERIFY_WITHIN(found.inertia_kgm2, truth.inertia_kgm2, 2.0);
        VERIFY_HOLDS(found.inertia_kgm2, truth.inertia_kgm2);
        VERIFY_HOLDS(found.viscous_nms, truth.viscous_nms);
        VERIFY_HOLDS(found.dry_nm, truth.coulomb_nm);
        VERIFY_HOLDS(found.fan_nms2, 0.0);
        QVERIFY(!found.fan);
        QVERIFY(std::any_of(found.notes.begin(), found.notes.end(), [](const std::string &note) {
            return note.find("within a control period") != std::string::npos;
        }));
    }

    void allPresetsAreMeasured_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<quint64>("seed");
        for (const simulation::Preset &preset : simulation::presets())
            for (const quint64 seed : {1, 2})
                QTest::addRow("%s, seed %llu", std::string(preset.name).c_str(), seed)
                    << QString::fromStdString(std::string(preset.name)) << seed;
    }
    void allPresetsAreMeasured()
    {
        QFETCH(const QString, motor);
        QFETCH(const quint64, seed);
        const PlantParameters &truth = *simulation::findPreset(motor.toStdString());
        const MeasuredMechanics measured = measure(truth, motor.toStdString(), seed);
        QVERIFY2(measured.outcome.end == End::Complete && measured.outcome.reason.empty(),
            qPrintable(support::outcomeText(measured.outcome)));
        QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
        const Mechanics &found = *measured.found;
        VERIFY_WITHIN(found.inertia_kgm2, truth.motor.inertia_kgm2, 1.5);
        // Of what a propeller takes it is a twentieth: the bar of the others is missed there.
        VERIFY_WITHIN(found.viscous_nms, truth.motor.viscous_nms,
            motor == QLatin1String("prop12") ? 12.0 : 6.0);
        VERIFY_WITHIN(found.dry_nm, truth.motor.coulomb_nm, 5.0);
        VERIFY_HOLDS(found.inertia_kgm2, truth.motor.inertia_kgm2);
        QCOMPARE(found.fan, truth.load.fan_nms2 > 0.0);
        if (found.fan)
            VERIFY_WITHIN(found.fan_nms2, truth.load.fan_nms2, 5.0);
        QVERIFY(found.notes.empty());
        // Never braked, and not the same torque twice.
        for (const drive::TorqueRamp &torque : measured.torques)
            QVERIFY(torque.amps >= 0.0);
        QVERIFY(measured.torques.size() >= 8);
        QVERIFY2(measured.slowest_rpm > 0.15 * truth.motor.maxSpeed_rpm,
            qPrintable(QString::number(measured.slowest_rpm)));
    }

    /// Its observer stands aside under a current, part of which makes a torque by Lq less Ld.
    void whatASalientRotorAddsIsInItsInterval()
    {
        simulation::BoardOptions options;
        options.plant = *simulation::findPreset("ipm48");
        const simulation::MotorParameters &motor = options.plant->motor;
        constexpr double kBrake = 0.25;
        options.plant->load.constant_nm =
            kBrake * 1.5 * motor.polePairs * motor.flux_wb * motor.nominal_a;
        const MeasuredMechanics measured = measure(options, 1);
        QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
        VERIFY_WITHIN(measured.found->inertia_kgm2, motor.inertia_kgm2, 2.0);
        VERIFY_HOLDS(measured.found->inertia_kgm2, motor.inertia_kgm2);
        VERIFY_HOLDS(measured.found->viscous_nms, motor.viscous_nms);
        VERIFY_HOLDS(measured.found->dry_nm, motor.coulomb_nm + options.plant->load.constant_nm);
    }

    void whatHoldsASpeedIsAMean_data()
    {
        // A third of the looks tells 2 A more, the others 1 A less.
        QTest::addColumn<double>("holds_a");
        QTest::addColumn<int>("sign");
        QTest::newRow("a current") << 0.3 << 1;
        QTest::newRow("backwards") << 0.3 << -1;
        QTest::newRow("none") << 0.0 << 1;
        QTest::newRow("a load that drives") << -0.5 << 1;
    }

    /// A noise that counts on one side only is left while it coasts, and may be enough to go on accelerating.
    void whatHoldsASpeedIsAMean()
    {
        QFETCH(const double, holds_a);
        QFETCH(const int, sign);
        const LabBench bench;
        const Subject &subject = bench.experiment.subject;
        SpinPlan plan = spinPlanFor(subject, {});
        plan.lowRpm *= sign;
        plan.highRpm *= sign;
        const auto course = courseOf(plan, subject);
        TimePoint now{std::chrono::seconds(1)};
        std::optional<Ask> ask;
        for (int look = 0; look < 100 && !ask; ++look) {
            now = std::max(now, course->due());
            const double amps = holds_a + (look % 3 == 0 ? 2.0 : -1.0);
            ask = course->next({now, double(plan.lowRpm), amps * sign, true});
        }
        const auto *first = ask ? std::get_if<drive::TorqueRamp>(&*ask) : nullptr;
        QVERIFY(first);
        // The first push is 3.5 to 5 % of the nominal current above it.
        const double above =
            (first->amps * sign - std::max(0.0, holds_a)) / subject.limits.nominalCurrentAmps;
        QVERIFY2(above > 0.034 && above < 0.051, qPrintable(QString::number(above)));
    }

    void slowHallMotorsAreTrueOrNotTold_data()
    {
        QTest::addColumn<double>("rpm");
        QTest::addColumn<int>("polePairs");
        QTest::addColumn<double>("inertia");
        QTest::addColumn<double>("brake");
        QTest::addColumn<bool>("told");
        QTest::newRow("hub48") << 300.0 << 10 << 4e-3 << 0.0 << true;
        QTest::newRow("hub48 with a brake") << 300.0 << 10 << 4e-3 << 0.1 << false;
        QTest::newRow("light") << 300.0 << 10 << 1e-3 << 0.0 << false;
        QTest::newRow("heavy") << 300.0 << 10 << 2e-2 << 0.0 << true;
        QTest::newRow("heavy, few poles") << 300.0 << 4 << 2e-2 << 0.0 << true;
        QTest::newRow("faster, few poles, a brake") << 600.0 << 4 << 4e-3 << 0.1 << true;
        QTest::newRow("faster, light") << 600.0 << 10 << 1e-3 << 0.0 << true;
        QTest::newRow("faster, light, a brake") << 600.0 << 10 << 1e-3 << 0.1 << true;
        QTest::newRow("fast, light, a brake") << 1200.0 << 4 << 1e-3 << 0.1 << true;
        QTest::newRow("fast") << 1200.0 << 10 << 4e-3 << 0.0 << true;
    }

    /// Their angle moves in steps, and lags: an interval that does not hold the truth is worse than none.
    void slowHallMotorsAreTrueOrNotTold()
    {
        QFETCH(const double, rpm);
        QFETCH(const int, polePairs);
        QFETCH(const double, inertia);
        QFETCH(const double, brake);
        QFETCH(const bool, told);
        simulation::BoardOptions options;
        options.plant = hubMotor(rpm, polePairs, inertia, brake);
        for (const std::uint64_t seed : {1U, 2U}) {
            const MeasuredMechanics measured = measure(options, seed);
            QVERIFY2(measured.outcome.end == End::Complete,
                qPrintable(support::outcomeText(measured.outcome)));
            QVERIFY2(measured.found.has_value() == told,
                measured.found ? "" : measured.found.error().c_str());
            if (!told) {
                QVERIFY2(measured.found.error().find("Hall sensors") != std::string::npos,
                    measured.found.error().c_str());
                continue;
            }
            const Mechanics &found = *measured.found;
            VERIFY_WITHIN(found.inertia_kgm2, inertia, 6.0);
            VERIFY_HOLDS(found.inertia_kgm2, inertia);
            VERIFY_HOLDS(found.viscous_nms, options.plant->motor.viscous_nms);
            VERIFY_HOLDS(
                found.dry_nm, options.plant->motor.coulomb_nm + options.plant->load.constant_nm);
            QVERIFY(!found.fan);
        }
    }

    void anAngleThatIsOffIsSeenAndSaid_data()
    {
        QTest::addColumn<double>("brake"); // of the nominal torque
        QTest::addColumn<bool>("said");
        QTest::newRow("a little") << 0.1 << true;
        QTest::newRow("much") << 0.25 << true;
        QTest::newRow("not") << 0.0 << false;
    }

    /// A rotor that is aligned against a brake stands aside, and its torque is that of weaker magnets. The voltage
    /// along them tells by how much, and what flows along them while the speed changes counts, too.
    void anAngleThatIsOffIsSeenAndSaid()
    {
        QFETCH(const double, brake);
        QFETCH(const bool, said);
        PlantParameters plant = *simulation::findPreset("servo24");
        plant.load.constant_nm = brake * 1.5 * 5 * plant.motor.flux_wb * plant.motor.nominal_a;
        for (const std::uint64_t seed : {1U, 2U}) {
            const MeasuredMechanics measured = measure(plant, "servo24", seed);
            QVERIFY2(measured.outcome.end == End::Complete,
                qPrintable(support::outcomeText(measured.outcome)));
            QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
            const Mechanics &found = *measured.found;
            VERIFY_WITHIN(found.inertia_kgm2, plant.motor.inertia_kgm2, 1.0);
            VERIFY_HOLDS(found.inertia_kgm2, plant.motor.inertia_kgm2);
            VERIFY_HOLDS(found.viscous_nms, plant.motor.viscous_nms);
            VERIFY_HOLDS(found.dry_nm, plant.motor.coulomb_nm + plant.load.constant_nm);
            QCOMPARE(found.notes.size(), said ? 1U : 0U);
            if (said)
                QVERIFY2(found.notes[0].find("electrical degrees beside") != std::string::npos,
                    found.notes[0].c_str());
        }
    }

    /// A recording without that voltage, as before 2026-11-28: only the other one tells, which dead times spoil.
    void withoutTheVoltageAlongThemTheMagnetsTellLess()
    {
        PlantParameters plant = *simulation::findPreset("servo24");
        plant.load.constant_nm = 0.05;
        const MeasuredMechanics measured = measure(plant, "servo24", 1, [](LabBench &bench) {
            for (auto &[at, what] : bench.happenings)
                for (auto &[name, value] : what.fields)
                    if (name == "voltage d")
                        value.clear();
        });
        QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
        VERIFY_WITHIN(measured.found->inertia_kgm2, plant.motor.inertia_kgm2, 3.0);
        VERIFY_HOLDS(measured.found->inertia_kgm2, plant.motor.inertia_kgm2);
        QCOMPARE(measured.found->notes.size(), 1U);
        QVERIFY(
            measured.found->notes[0].find("the angle of its rotor is off") != std::string::npos);
    }

    void aBrakeIsDryFriction()
    {
        PlantParameters plant = *simulation::findPreset("blower36");
        plant.load.constant_nm = 0.05;
        const MeasuredMechanics measured = measure(plant, "blower36", 1);
        QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
        VERIFY_WITHIN(measured.found->dry_nm, plant.motor.coulomb_nm + 0.05, 5.0);
        VERIFY_WITHIN(measured.found->inertia_kgm2, plant.motor.inertia_kgm2, 1.5);
    }

    /// The next torque came so late that it had coasted to a stop: there, friction is whatever holds it.
    void aRotorThatStoodForAWhileSaysTheSame()
    {
        const PlantParameters &truth = *simulation::findPreset("servo24");
        LabBench bench;
        bench.experiment.plan = spinPlanFor(bench.experiment.subject, {});
        double slowest_rpm = 1e9;
        bench.eachTurn = [&] {
            const std::vector<drive::TorqueRamp> torques = bench.asked<drive::TorqueRamp>();
            const std::size_t asked = torques.size();
            const bool coasts = asked > 4 && torques[asked - 1].amps < torques[asked - 2].amps;
            bench.held = std::chrono::milliseconds(coasts && asked < 9 ? 1400 : 0);
            if (coasts)
                slowest_rpm = std::min(slowest_rpm, bench.pair.board->truth(1).rpm);
        };
        const Outcome outcome = bench.run();
        QVERIFY2(outcome.end == End::Complete, qPrintable(support::outcomeText(outcome)));
        QVERIFY2(slowest_rpm < 10.0, qPrintable(QString::number(slowest_rpm)));
        const auto found = evaluateMechanics(bench.capture, bench.happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        VERIFY_WITHIN(found->inertia_kgm2, truth.motor.inertia_kgm2, 1.5);
        VERIFY_WITHIN(found->viscous_nms, truth.motor.viscous_nms, 6.0);
        VERIFY_WITHIN(found->dry_nm, truth.motor.coulomb_nm, 5.0);
        VERIFY_HOLDS(found->inertia_kgm2, truth.motor.inertia_kgm2);
        QCOMPARE(found->notes.size(), 1U);
        QVERIFY(found->notes[0].find("nearly stood still") != std::string::npos);
    }

    void aLoopThatSwingsIsNotWaitedFor_data()
    {
        QTest::addColumn<double>("heavier");
        QTest::newRow("4") << 4.0;
        QTest::newRow("6") << 6.0;
        QTest::newRow("8") << 8.0;
    }

    /// Its speed does not come to rest with the gains of a lighter rotor, and it is measured by torques all the same.
    /// What waits for a speed at rest is not measured there (tst_tuning, aLoopThatSwingsIsCalmedToBeMeasured).
    void aLoopThatSwingsIsNotWaitedFor()
    {
        QFETCH(const double, heavier);
        const simulation::BoardOptions options = swingingBoard(heavier);
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const MeasuredMechanics measured = measure(options, seed);
            QVERIFY2(measured.outcome.end == End::Complete && measured.outcome.reason.empty(),
                qPrintable(support::outcomeText(measured.outcome)));
            QVERIFY2(measured.found, measured.found ? "" : measured.found.error().c_str());
            VERIFY_WITHIN(measured.found->inertia_kgm2, options.plant->motor.inertia_kgm2, 1.5);
            const auto &notes = measured.found->notes;
            QVERIFY(std::any_of(notes.begin(), notes.end(), [](const std::string &note) {
                return note.find("did not come to rest before the first torque")
                    != std::string::npos;
            }));
            // What flows in the midst of a swing is not taken for what holds the speed: it would be in all that
            // follows.
            QVERIFY(measured.torques.front().amps < 0.25 * options.plant->motor.nominal_a);
        }
    }

    /// It swung before, so the runner does not wait for rest afterwards: all that was measured would end with a Stop.
    void aMotorThatRanAndSwungGoesOnToDoSo()
    {
        const simulation::BoardOptions options = swingingBoard(6.0);
        LabBench bench(options);
        bench.experiment.plan = spinPlanFor(bench.experiment.subject, {});
        constexpr int kSetPoint_rpm = 2200;
        const auto speed = [&bench] { return bench.pair.board->truth(1).rpm; };
        bench.pair.submit(drive::SpeedRamp{1, kSetPoint_rpm, std::chrono::milliseconds(500)});
        bench.pair.submit(drive::Command{drive::MotorAction::Start, 1});
        constexpr Duration kUntil = std::chrono::seconds(20);
        QVERIFY(bench.pair.runUntil([&] { return speed() > kSetPoint_rpm; }, kUntil));
        // It is begun as it passes its set-point, and refused away from that.
        Outcome outcome{End::Refused, {}, {}};
        for (int tries = 0; tries < 100 && outcome.end == End::Refused; ++tries) {
            const TimePoint next = bench.pair.now + std::chrono::milliseconds(37);
            QVERIFY(bench.pair.runUntil([&] { return bench.pair.now >= next; }, kUntil));
            bench.wishes.clear();
            bench.happenings.clear();
            outcome = bench.run();
        }
        QVERIFY2(outcome.end == End::Complete && outcome.reason.empty(),
            qPrintable(support::outcomeText(outcome)));
        QVERIFY(bench.asked<drive::Command>().empty());
        QVERIFY(speed() > 1000.0);
        QVERIFY(evaluateMechanics(bench.capture, bench.happenings));
    }

    void whatIsMissingIsSaid()
    {
        const PlantParameters &truth = *simulation::findPreset("pm24");
        const MeasuredMechanics none = measure(truth, "pm24", 1, [](LabBench &bench) {
            std::erase_if(
                bench.happenings, [](const auto &one) { return one.second.name == "torque ramp"; });
        });
        QVERIFY(!none.found);
        const MeasuredMechanics cut = measure(truth, "pm24", 1, [](LabBench &bench) {
            std::size_t seen = 0;
            std::erase_if(bench.happenings,
                [&](const auto &one) { return one.second.name == "torque ramp" && ++seen > 3; });
            for (auto &[at, what] : bench.happenings)
                if (what.name == "torque ramp")
                    bench.happenings.emplace_back(
                        at + 1'000'000'000, entryOfEnd({End::Interrupted, "it was interrupted"}));
            std::stable_sort(bench.happenings.begin(), bench.happenings.end(),
                [](const auto &a, const auto &b) { return a.first < b.first; });
        });
        QVERIFY(!cut.found);
        QVERIFY2(
            cut.found.error().find("are needed") != std::string::npos, cut.found.error().c_str());
    }

    void aGapIsSaidAndTakesNoMoreThanItself()
    {
        LabBench bench;
        bench.experiment.plan = spinPlanFor(bench.experiment.subject, {});
        const auto found = foundWithAGap(bench, std::chrono::seconds(8), evaluateMechanics);
        QVERIFY2(found, found ? "" : found.error().c_str());
        QCOMPARE(found->notes.size(), 1U);
        const simulation::MotorParameters &truth = simulation::findPreset("servo24")->motor;
        VERIFY_WITHIN(found->inertia_kgm2, truth.inertia_kgm2, 1.5);
        VERIFY_HOLDS(found->inertia_kgm2, truth.inertia_kgm2);
    }

    /// As of a program that was killed.
    void aRecordingThatEndsBeforeItsExperimentIsToldSo()
    {
        const MeasuredMechanics cut = measure(*simulation::findPreset("servo24"), "servo24", 1,
            [](LabBench &bench) { bench.happenings.pop_back(); });
        QVERIFY2(cut.found, cut.found ? "" : cut.found.error().c_str());
        QCOMPARE(cut.found->notes,
            (std::vector<std::string>{"the recording ends before the experiment does"}));
    }

    /// Files are foreign: one sample a second is no recording of a control loop, and ends no program.
    void samplesThatAreFarApartTellNothing()
    {
        const LabBench bench;
        const SpinPlan plan = spinPlanFor(bench.experiment.subject, {});
        const recorded::Happening entry = entryOf(plan, bench.experiment.subject, {});
        const Recorded<SpinPlan> names = *recordedPlan<SpinPlan>(entry);
        capture::Capture capture;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = 1.0;
        layout.fast = {{1, names.current, "A", 1e-3}, {2, names.angle, "deg", 360.0 / 65536.0},
            {3, names.voltage, "V", 1e-3}};
        capture.begin(layout);
        capture::SampleBlock block;
        block.stream = 1;
        block.count = 100;
        block.fast.assign(300, 7);
        capture.append(block);
        const Happenings happenings{
            {0, entry}, {1, {"torque ramp", {{"motor", "1"}, {"A", "1"}, {"ms", "0"}}}}};
        const auto found = evaluateMechanics(capture, happenings);
        QVERIFY(!found && !found.error().empty());
    }

    void aPlanIsHeldAgainstTheMotor()
    {
        LabBench bench;
        Subject subject = bench.experiment.subject;
        const SpinPlan plan = spinPlanFor(subject, {});
        QVERIFY(objectionTo(plan, subject).empty());
        SpinPlan other = plan;
        other.highRpm = -other.highRpm;
        QVERIFY(!objectionTo(other, subject).empty());
        other = plan;
        other.lowRpm = other.highRpm;
        QVERIFY(!objectionTo(other, subject).empty());
        other = plan;
        other.length = std::chrono::minutes(2);
        QVERIFY(!objectionTo(other, subject).empty());
        subject.limits.torquePerAmp = 0.0;
        QVERIFY(!objectionTo(plan, subject).empty());
        const SpinPlan slow = spinPlanFor(bench.experiment.subject, {.maxSpeedRpm = 1000.0});
        QVERIFY(slow.highRpm < 1000);
        QVERIFY(recordedPlan<SpinPlan>(entryOf(plan, bench.experiment.subject, {}))->plan == plan);
    }

    void bothDirectionsTellATorqueThatIsAlwaysThere_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<double>("always"); // of the dry friction
        QTest::newRow("servo24") << "servo24" << 0.6;
        QTest::newRow("servo24, the other way") << "servo24" << -0.6;
        QTest::newRow("servo24, none") << "servo24" << 0.0;
        QTest::newRow("pm24") << "pm24" << 0.6;
        QTest::newRow("prop12") << "prop12" << 0.0;
        QTest::newRow("blower36") << "blower36" << -0.5;
    }
    /// One direction takes it for friction.
    void bothDirectionsTellATorqueThatIsAlwaysThere()
    {
        QFETCH(const QString, motor);
        QFETCH(const double, always);
        const MotorParameters truth = simulation::findPreset(motor.toStdString())->motor;
        const double always_nm = always * truth.coulomb_nm;
        simulation::BoardOptions options;
        options.motor = motor.toStdString();
        options.load = simulation::findPreset(options.motor)->load;
        options.load->drive_nm = -always_nm;
        LabBench bench(options, 1);
        const SpinPlan plan = spinPlanFor(bench.experiment.subject, {});
        std::size_t ofOne = 0;
        for (const SpinPlan &way : {plan, otherWay(plan)}) {
            bench.experiment.plan = way;
            VERIFY_END(bench.run(), End::Complete);
            ofOne = ofOne == 0 ? bench.happenings.size() : ofOne;
        }
        QCOMPARE(runsIn(bench.happenings).size(), std::size_t(1));
        const auto found = evaluateMechanics(bench.capture, bench.happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        VERIFY_WITHIN(found->inertia_kgm2, truth.inertia_kgm2, 1.5);
        VERIFY_HOLDS(found->inertia_kgm2, truth.inertia_kgm2);
        VERIFY_HOLDS(found->dry_nm, truth.coulomb_nm);
        VERIFY_HOLDS(found->viscous_nms, truth.viscous_nms);
        QVERIFY(found->both);
        VERIFY_HOLDS(found->both->always_nm, always_nm);
        VERIFY_WITHIN(found->both->forwards_kgm2, truth.inertia_kgm2, 3.0);
        VERIFY_WITHIN(found->both->backwards_kgm2, truth.inertia_kgm2, 3.0);
        const auto says = [&](const char *word) {
            return std::ranges::any_of(found->notes,
                [&](const std::string &note) { return note.find(word) != std::string::npos; });
        };
        QCOMPARE(says("drives it backwards"), always > 0.0);
        QCOMPARE(says("drives it forwards"), always < 0.0);
        QVERIFY(!says("apart"));

        const auto one = evaluateMechanics(bench.capture,
            {bench.happenings.begin(),
                bench.happenings.begin() + static_cast<std::ptrdiff_t>(ofOne)});
        QVERIFY(one && !one->both);
        if (always != 0.0) // as much as it is, this time to one side
            QVERIFY(*one->dry_nm.high < truth.coulomb_nm || truth.coulomb_nm < *one->dry_nm.low);
    }

    void aDirectionThatIsMissingIsNamed()
    {
        LabBench bench;
        const SpinPlan plan = spinPlanFor(bench.experiment.subject, {});
        bench.experiment.plan = plan;
        VERIFY_END(bench.run(), End::Complete);
        bench.experiment.plan = otherWay(plan);
        bench.begin();
        bench.happenings.emplace_back(
            bench.happenings.back().first, entryOfEnd({End::Refused, "it was refused", {}}));
        const auto found = evaluateMechanics(bench.capture, bench.happenings);
        QVERIFY(found && !found->both);
        QVERIFY(std::ranges::count(
                    found->notes, std::string("it was driven in one of its two directions only"))
            == 1);
    }

    /// One stretch would know a torque that is always there exactly, and be wrong.
    void aDirectionThatIsShortCountsForNothing()
    {
        LabBench bench;
        const SpinPlan plan = spinPlanFor(bench.experiment.subject, {});
        bench.experiment.plan = plan;
        VERIFY_END(bench.run(), End::Complete);
        const auto one = evaluateMechanics(bench.capture, bench.happenings);
        const std::size_t torques = bench.asked<drive::TorqueRamp>().size();
        bench.experiment.plan = otherWay(plan);
        bench.begin();
        QVERIFY(bench.runUntil([&] { return bench.asked<drive::TorqueRamp>().size() > torques; }));
        const TimePoint driven = bench.pair.now;
        QVERIFY(bench.runUntil([&] { return bench.pair.now - driven > 1500ms; }));
        bench.happenings.emplace_back(
            bench.pair.now.time_since_epoch().count(), entryOfEnd({End::Aborted, "a bound", {}}));
        const auto found = evaluateMechanics(bench.capture, bench.happenings);
        QVERIFY(one && found && !found->both);
        QCOMPARE(found->inertia_kgm2, one->inertia_kgm2);
        for (const char *note :
            {"it was driven in one of its two directions only", "the run ended early: a bound"})
            QVERIFY2(std::ranges::count(found->notes, std::string(note)) == 1, note);
    }

    /// Behind the other direction another one begins, and so it does behind one that ended early.
    void twoDirectionsAreOneRunAndNoMore()
    {
        const LabBench bench;
        const Subject &subject = bench.experiment.subject;
        const SpinPlan plan = spinPlanFor(subject, {});
        SpinPlan other = plan;
        other.seed = 2;
        const auto begins = [&](RunStarts &starts, const SpinPlan &what) {
            return starts.accept(entryOf(what, subject, {}));
        };
        RunStarts starts;
        QVERIFY(begins(starts, plan));
        QVERIFY(!starts.accept(entryOfEnd({})));
        QVERIFY(!begins(starts, otherWay(plan)));
        QVERIFY(begins(starts, plan));
        QVERIFY(begins(starts, plan));
        QVERIFY(begins(starts, otherWay(other)));
        QVERIFY(!begins(starts, other));
        QVERIFY(begins(starts, plan));
        QVERIFY(!starts.accept(entryOfEnd({End::Aborted, "a bound", {}})));
        QVERIFY(begins(starts, otherWay(plan)));
    }

    /// A ramp through 0 would lose the rotor of one, and brake the other.
    void aMotorThatTurnsTheOtherWayIsLeftAlone()
    {
        for (const char *motor : {"servo24", "pm24"}) {
            simulation::BoardOptions options;
            options.motor = motor;
            LabBench bench(options, 1);
            QVERIFY(bench.pair.runAt(2000));
            bench.experiment.plan = otherWay(spinPlanFor(bench.experiment.subject, {}));
            const Outcome outcome = bench.run();
            QVERIFY2(outcome.end == End::Refused
                    && outcome.reason == "the motor turns the other way: stop it first",
                qPrintable(support::outcomeText(outcome)));
            QVERIFY(
                bench.asked<drive::SpeedRamp>().empty() && bench.asked<drive::Command>().empty());
        }
    }

    void onlyStepsGoThroughZeroAndOnlyOfARotorThatIsSeen()
    {
        for (const bool seen : {true, false}) {
            simulation::BoardOptions options;
            options.motor = seen ? "servo24" : "pm24";
            const LabBench bench(options, 1);
            const Subject &subject = bench.experiment.subject;
            const auto may = [&](const Plan &plan, double before_rpm) {
                return objectionWhileTurning({plan, subject}, before_rpm).empty();
            };
            const StepPlan back{.fromRpm = -2000, .toRpm = -2500};
            QCOMPARE(may(back, 2000.0), seen);
            QVERIFY(may(back, -2000.0));
            SpinPlan spin = otherWay(spinPlanFor(subject, {}));
            ResponsePlan response = responsePlanFor(subject, {});
            response.rpm = -response.rpm;
            for (const Plan &plan : {Plan(spin), Plan(response)}) {
                QVERIFY(!may(plan, 2000.0));
                QVERIFY(may(plan, -2000.0));
            }
            QVERIFY(inBothDirections({{spin, subject}, {otherWay(spin), subject}}));
            QVERIFY(!inBothDirections({{spin, subject}, {response, subject}}));
        }
    }

    /// A load drives it, as a heavy rotor would go on by itself for longer than is waited for.
    void aRotorThatStillTurnsTheOtherWayIsNotStarted()
    {
        simulation::BoardOptions options = support::servo();
        options.load = simulation::findPreset("servo24")->load;
        options.load->drive_nm = 1.5 * simulation::findPreset("servo24")->motor.coulomb_nm;
        LabBench bench(options, 1);
        bench.pair.runFor(2s);
        bench.experiment.plan = otherWay(spinPlanFor(bench.experiment.subject, {}));
        const Outcome outcome = bench.run();
        QVERIFY2(
            outcome.end == End::Refused && outcome.reason == "the motor still turns the other way",
            qPrintable(support::outcomeText(outcome)));
        QVERIFY(bench.asked<drive::Command>().empty());
    }

    /// Out of torque control, on a line whose answers come late: by way of the speed of before it would be braked.
    void aRunningMotorComesBackToItsSpeed_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<int>("rpm");
        QTest::newRow("servo24") << "servo24" << 2000;
        QTest::newRow("pm24") << "pm24" << 2000;
        QTest::newRow("prop12") << "prop12" << 3000;
    }
    void aRunningMotorComesBackToItsSpeed()
    {
        QFETCH(const QString, motor);
        QFETCH(const int, rpm);
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            simulation::BoardOptions options;
            options.motor = motor.toStdString();
            LabBench bench(options, seed);
            QVERIFY(bench.pair.runAt(rpm));
            bench.pair.runFor(1s);
            bench.eachTurn = [&] { bench.held = 25ms; };
            bench.experiment.plan = spinPlanFor(bench.experiment.subject, {});
            const Outcome outcome = bench.run();
            QVERIFY2(outcome.end == End::Complete && outcome.reason.empty(),
                qPrintable(support::outcomeText(outcome)));
            QVERIFY2(std::abs(bench.pair.board->truth(1).rpm - rpm) < 0.05 * rpm,
                qPrintable(QString::number(bench.pair.board->truth(1).rpm)));
        }
    }
};

QTEST_APPLESS_MAIN(TestMechanical)
#include "tst_mechanical.moc"
