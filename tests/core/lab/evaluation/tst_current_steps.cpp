// Steps of torque and of the current along the magnets: what they measure, and what keeps a motor safe whose speed
// nothing holds meanwhile.
#include "lab/caps.h"
#include "lab/evaluation/current_step_evaluation.h"
#include "lab/happenings.h"
#include "simulation/plant/presets.h"
#include "support/current_loop_model.h"
#include "support/lab_bench.h"

#include <numeric>

using namespace lab;
using support::LabBench;
using namespace std::chrono_literals;

namespace {

simulation::BoardOptions board(std::string_view motor)
{
    simulation::BoardOptions options;
    options.motor = motor;
    return options;
}

/// By shares of the nominal current.
CurrentStepPlan planFor(const LabBench &bench, bool flux, double from, double to)
{
    const double nominal = bench.experiment.subject.limits.nominalCurrentAmps;
    return currentStepPlanFor(bench.experiment.subject, flux, from * nominal, to * nominal, {});
}

/// From 10 to 90 % of the mean of their last fifth.
double riseOf(const std::vector<double> &samples)
{
    const auto tail = static_cast<std::ptrdiff_t>(samples.size() / 5);
    const double final =
        std::accumulate(samples.end() - tail, samples.end(), 0.0) / static_cast<double>(tail);
    const auto when = [&](double share) {
        const double level = share * final;
        const auto above = std::find_if(
            samples.begin(), samples.end(), [level](double value) { return value >= level; });
        return double(above - samples.begin()) - (*above - level) / (*above - *(above - 1));
    };
    return when(0.9) - when(0.1);
}

} // namespace

class TestCurrentSteps : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void everyMotorIsSteppedAndIsAsItWas_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<bool>("flux");
        for (const char *motor : {"servo24", "pm24", "blower36", "prop12", "ipm48"}) {
            QTest::addRow("%s torque", motor) << QString::fromLatin1(motor) << false;
            QTest::addRow("%s flux", motor) << QString::fromLatin1(motor) << true;
        }
    }

    void everyMotorIsSteppedAndIsAsItWas()
    {
        QFETCH(const QString, motor);
        QFETCH(const bool, flux);
        LabBench bench(board(motor.toStdString()));
        const CurrentStepPlan plan =
            flux ? planFor(bench, true, 0.0, -0.3) : planFor(bench, false, 0.1, 0.3);
        bench.experiment.plan = plan;
        double fastest = 0.0;
        bench.eachTurn = [&] { fastest = std::max(fastest, bench.pair.board->truth(1).rpm); };
        const Outcome outcome = bench.run();
        VERIFY_END(outcome, End::Complete);
        QCOMPARE(outcome.reason, std::string());
        QCOMPARE(bench.stops, 0);
        QVERIFY(fastest < capsOf(bench.experiment, 0.0).mostRpm);
        QVERIFY(bench.pair.runUntilState(drive::MotorState::Idle));
        const auto found = currentSteps(bench.capture, bench.happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        QCOMPARE(found->runs.size(), 10U);
        for (std::size_t i = 0; i < found->runs.size(); ++i) {
            const StepRun &run = found->runs[i];
            QCOMPARE(run.up, (i % 2 == 0) != flux); // to -0.3 first, there
            QVERIFY(run.found && run.rise_s && run.overshoot_pct && run.peakIq_a);
            QVERIFY(run.instantError_s && *run.instantError_s < 63e-6); // a sample
        }
        QVERIFY(found->rise_s && *found->rise_s->low < *found->rise_s->high);
    }

    /// By currents that do not hold its speed: a host that is late must not let it go below what its observer needs.
    void aSensorlessMotorKeepsAwayFromWhereItIsLost_data()
    {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<int>("late_ms");
        QTest::addColumn<double>("cap_rpm");
        QTest::newRow("slower in the end") << 0.5 << 2.0 << 40 << 0.0;
        QTest::newRow("the same backwards") << -0.5 << -2.0 << 40 << 0.0;
        QTest::newRow("faster in the end") << 1.5 << 3.0 << 60 << 0.0;
        QTest::newRow("nothing before") << 0.0 << 2.0 << 20 << 0.0;
        QTest::newRow("at a lower speed") << 1.0 << 2.0 << 0 << 3600.0;
    }
    void aSensorlessMotorKeepsAwayFromWhereItIsLost()
    {
        QFETCH(const double, from);
        QFETCH(const double, to);
        QFETCH(const int, late_ms);
        QFETCH(const double, cap_rpm);
        LabBench bench(board("pm24"));
        bench.experiment.plan =
            currentStepPlanFor(bench.experiment.subject, false, from, to, {.maxSpeedRpm = cap_rpm});
        bench.held = std::chrono::milliseconds(late_ms);
        const Outcome outcome = bench.run();
        VERIFY_END(outcome, End::Complete);
        const auto found = currentSteps(bench.capture, bench.happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        for (const StepRun &run : found->runs)
            QVERIFY(run.found && run.rise_s && run.peakIq_a);
    }

    /// Of a bridge without dead time: its rise is that of windings and regulator.
    void theRiseIsThatOfTheLoop_data()
    {
        QTest::addColumn<double>("inductance");
        QTest::addColumn<bool>("flux");
        for (const double inductance : {1.0, 3.0}) {
            QTest::addRow("torque, %g of its inductance", inductance) << inductance << false;
            QTest::addRow("flux, %g of its inductance", inductance) << inductance << true;
        }
    }
    void theRiseIsThatOfTheLoop()
    {
        QFETCH(const double, inductance);
        QFETCH(const bool, flux);
        simulation::BoardOptions options;
        options.plant = *simulation::findPreset("servo24");
        options.plant->inverter.deadTime_s = 0.0;
        options.plant->motor.cogging_nm = 0.0;
        options.plant->inverter.supplyAbsorbs = true;
        options.plant->motor.inertia_kgm2 *= 10.0; // its speed stays near where it is
        options.plant->motor.ld_h *= inductance;
        options.plant->motor.lq_h *= inductance;
        LabBench bench(options);
        CurrentStepPlan plan =
            flux ? planFor(bench, true, 0.0, -0.3) : planFor(bench, false, 0.1, 0.2);
        plan.hold = 30ms;
        bench.experiment.plan = plan;
        VERIFY_END(bench.run(), End::Complete);
        const auto found = currentSteps(bench.capture, bench.happenings);
        QVERIFY(found && found->rise_s);
        const double hz = bench.experiment.subject.tickHz;
        if (flux) // no torque, so no back-EMF follows it
            options.plant->motor.inertia_kgm2 *= 1e6;
        const support::CurrentLoopModel model(*options.plant, hz, plan.rpm);
        const double truth = riseOf(model.step(480)) / hz;
        // A step back begins while the back-EMF of the one before has not settled.
        double mean = 0.0, count = 0.0;
        for (const StepRun &run : found->runs)
            if (flux || run.up) {
                mean += *run.rise_s;
                ++count;
            }
        mean /= count;
        QVERIFY2(std::abs(mean / truth - 1.0) < (flux ? 0.03 : 0.05),
            qPrintable(QStringLiteral("%1 of %2 ms").arg(mean * 1e3).arg(truth * 1e3)));
    }

    /// Of second order, through a board's digits: what was put in comes out.
    void anAnalyticStepIsMeasuredRight_data()
    {
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("damping");
        for (const double w : {800.0, 2000.0, 4000.0})
            for (const double damping : {0.4, 0.6, 0.8})
                QTest::addRow("%g rad/s, %g", w, damping) << w << damping;
    }
    void anAnalyticStepIsMeasuredRight()
    {
        QFETCH(const double, w);
        QFETCH(const double, damping);
        constexpr double kHz = 16000.0, kDigit = 1.8e-3;
        const double ring = w * std::sqrt(1.0 - damping * damping);
        const auto unit = [&](double t) {
            return t <= 0.0 ? 0.0
                            : 1.0
                    - std::exp(-damping * w * t)
                        * (std::cos(ring * t) + damping * w / ring * std::sin(ring * t));
        };
        const LabBench motor; // for its names
        CurrentStepPlan plan = planFor(motor, false, 0.1, 0.5);
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kHz;
        layout.fast = {{1, "I_Q_REF", "A", kDigit}, {2, "I_Q_MEAS", "A", kDigit}};
        capture::SampleBlock block;
        block.stream = 1;
        block.count = 1600;
        constexpr double kAt_s = 0.05;
        for (const bool measured : {false, true})
            for (std::uint32_t i = 0; i < block.count; ++i) {
                const double t = double(i) / kHz - kAt_s;
                const double share = measured ? unit(t) : t >= 0.0 ? 1.0 : 0.0;
                block.fast.push_back(static_cast<std::int16_t>(
                    std::lround((plan.fromAmps + share * (plan.toAmps - plan.fromAmps)) / kDigit)));
            }
        capture::Capture capture;
        capture.begin(layout);
        capture.append(block);
        const auto torque = [](double amps) {
            return recorded::Happening{"torque ramp",
                {{"motor", "1"}, {"A", decimalText(amps)}, {"ms", "0"}, {"wish", "0"}}};
        };
        constexpr Nanos kMilli = 1'000'000;
        const Happenings happenings{{0, entryOf(plan, motor.experiment.subject, {})},
            {20 * kMilli, torque(plan.fromAmps)}, {48 * kMilli, torque(plan.toAmps)},
            {70 * kMilli, torque(plan.fromAmps)}, {70 * kMilli, torque(0.0)},
            {90 * kMilli, entryOfEnd({})}};
        const auto found = currentSteps(capture, happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        QCOMPARE(found->runs.size(), 2U);
        const StepRun &run = found->runs.front();
        QVERIFY(run.found && run.rise_s && run.overshoot_pct);
        const auto when = [&](double level) {
            double low = 0.0, high = std::numbers::pi / ring;
            for (int i = 0; i < 60; ++i)
                (unit((low + high) / 2) < level ? low : high) = (low + high) / 2;
            return low;
        };
        const double rise = when(0.9) - when(0.1);
        const double overshoot = 100.0 * std::exp(-std::numbers::pi * damping * w / ring);
        QVERIFY2(std::abs(*run.rise_s - rise) < 0.01 * rise,
            qPrintable(QStringLiteral("%1 of %2").arg(*run.rise_s).arg(rise)));
        QVERIFY2(std::abs(*run.overshoot_pct - overshoot) < 0.5,
            qPrintable(QStringLiteral("%1 of %2").arg(*run.overshoot_pct).arg(overshoot)));
    }

    void aRunningMotorGetsItsModeAndItsSpeedBack()
    {
        for (const bool flux : {false, true}) {
            LabBench bench;
            QVERIFY(bench.pair.runAt(1800));
            bench.pair.runFor(1s);
            const lab::Registers &registers = bench.experiment.subject.registers;
            const auto before = bench.number(*bench.experiment.subject.setPoint.begin());
            bench.experiment.plan =
                flux ? planFor(bench, true, 0.0, 0.3) : planFor(bench, false, 0.0, 0.2);
            const Outcome outcome = bench.run();
            VERIFY_END(outcome, End::Complete);
            QCOMPARE(outcome.reason, std::string());
            QVERIFY(bench.pair.board->truth(1).driven);
            QVERIFY(std::abs(bench.pair.board->truth(1).rpm - 1800.0) < 60.0);
            QCOMPARE(bench.number(*bench.experiment.subject.setPoint.begin()), before);
            QVERIFY(std::abs(bench.number(registers.referenceD)) <= 1.0);
        }
    }

    /// They come late, and the motor goes faster and slower meanwhile.
    void stepsArePlacedHoweverTheHostStalls()
    {
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            LabBench bench(support::servo(seed), seed);
            support::Random random(seed);
            bench.experiment.plan = planFor(bench, false, 0.04, 0.08); // around what holds it
            bench.eachTurn = [&] { bench.held = std::chrono::milliseconds(random.below(300)); };
            VERIFY_END(bench.run(), End::Complete);
            const auto found = currentSteps(bench.capture, bench.happenings);
            QVERIFY(found && found->runs.size() == 10);
            for (const StepRun &run : found->runs)
                QVERIFY(run.found && run.instantError_s && *run.instantError_s < 63e-6);
        }
    }

    /// A light motor is soon too fast: its current is taken away before the time is over, and where the host is late
    /// the envelope stops it.
    void whatRunsAwayIsEnded()
    {
        for (const bool late : {false, true}) {
            LabBench bench;
            CurrentStepPlan plan = planFor(bench, false, 0.0, 0.4);
            plan.hold = 400ms;
            bench.experiment.plan = plan;
            double fastest = 0.0;
            bench.eachTurn = [&] {
                const bool pushes = !bench.asked<drive::TorqueRamp>().empty();
                bench.held = late && pushes ? 100ms : 0ms;
                fastest = std::max(fastest, bench.pair.board->truth(1).rpm);
            };
            const Outcome outcome = bench.run();
            VERIFY_END(outcome, late ? End::Aborted : End::Complete);
            bench.turn();
            QCOMPARE(bench.stops, late ? 1 : 0);
            const double most = capsOf(bench.experiment, 0.0).mostRpm;
            QVERIFY2((fastest > most) == late && fastest < most + 1500.0,
                qPrintable(QStringLiteral("%1 of %2").arg(fastest).arg(most)));
        }
    }

    void whatIsNotAPlanMovesNothing()
    {
        const auto refused = [](std::string_view motor, bool flux, double from, double to,
                                 const std::function<void(CurrentStepPlan &)> &change = {}) {
            LabBench bench(board(motor));
            CurrentStepPlan plan = planFor(bench, flux, from, to);
            if (change)
                change(plan);
            bench.experiment.plan = plan;
            const Outcome outcome = bench.run();
            return outcome.end == End::Refused && !outcome.reason.empty() && bench.wishes.empty();
        };
        QVERIFY(refused("servo24", false, 0.2, 0.2)); // no step
        QVERIFY(refused("servo24", false, -0.1, 0.2)); // one of them brakes
        QVERIFY(refused("servo24", false, 0.0, 1.5)); // too much
        QVERIFY(refused("servo24", true, 0.0, 0.8));
        QVERIFY(refused("pm24", true, 0.0, -0.5)); // an observer loses its rotor
        QVERIFY(refused("servo24", false, 0.0, 0.2, [](auto &plan) { plan.rpm = -plan.rpm; }));
        QVERIFY(refused("servo24", false, 0.0, 0.2, [](auto &plan) { plan.rpm = 3000; }));
        QVERIFY(refused("servo24", false, 0.0, 0.2, [](auto &plan) { plan.rpm = 0; }));
        QVERIFY(refused("servo24", false, 0.0, 0.2, [](auto &plan) { plan.hold = 2s; }));
        QVERIFY(refused("servo24", false, 0.0, 0.2, [](auto &plan) { plan.repeat = 0; }));
        QVERIFY(refused("servo24", false, 0.0, 0.2, [](auto &plan) { plan.repeat = 50; }));
        QVERIFY(refused(
            "servo24", false, 0.0, 0.2, [](auto &plan) { plan.caps.maxCurrentAmps = 1.0; }));
        LabBench backwards;
        QVERIFY(planFor(backwards, false, 0.0, -0.2).rpm < 0);
        QVERIFY(objectionTo({planFor(backwards, false, 0.0, -0.2), backwards.experiment.subject})
                    .empty());
    }

    /// What the user asked for along the magnets would be 0 afterwards.
    void aCurrentAlongTheMagnetsOfBeforeIsLeftAlone()
    {
        LabBench bench;
        QVERIFY(bench.pair.runAt(1800));
        QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(drive::CurrentReference{1, 0.4, -1.0})));
        QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(drive::SpeedRamp{1, 1800, 0ms})));
        bench.pair.runFor(1s);
        bench.experiment.plan = planFor(bench, true, 0.0, 0.3);
        VERIFY_END(bench.run(), End::Refused);
        QVERIFY(bench.runner->outcome().reason.find("I_D_REF is not 0") != std::string::npos);
        QVERIFY(bench.asked<drive::SpeedRamp>().empty());
        bench.experiment.plan = planFor(bench, false, 0.0, 0.2); // torque leaves it as it is
        VERIFY_END(bench.run(), End::Complete);
    }

    void aPlanIsReadBackAndForeignOnesAreNone()
    {
        const LabBench bench;
        const CurrentStepPlan plan = planFor(bench, true, 0.05, -0.2);
        const recorded::Happening entry = entryOf(plan, bench.experiment.subject, {});
        const auto read = recordedPlan<CurrentStepPlan>(entry);
        QVERIFY(read && read->plan == plan && read->referenceD == "I_D_REF");
        QVERIFY(!recordedPlan<CurrentStepPlan>({"step plan", entry.fields}));
        const auto none = currentSteps(bench.capture, {{0, entry}});
        QVERIFY(!none && none.error().find("no samples") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestCurrentSteps)
#include "tst_current_steps.moc"
