// Experiments on drives that send their samples with each exchange, some thousand times a second: steps and response of
// the speed, inertia and friction. The response is measured by set-points that leave with each exchange, too.
#include "core/lab/estimate_checks.h"
#include "lab/envelope.h"
#include "lab/evaluation/finding.h"
#include "lab/evaluation/response_evaluation.h"
#include "motor/constants.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"
#include "support/mcb/pair.h"

#include <bit>
#include <limits>
#include <numbers>

using lab::End;
using namespace std::chrono_literals;

namespace {

struct ServoSession : support::McbPair {
    explicit ServoSession(const simulation::McbBoardOptions &options)
        : McbPair(options)
        , ready(meet())
    {
        drive->arm();
        exchange();
    }
    bool ready;
};

struct ServoBench : support::LabBenchOn<ServoSession> {
    explicit ServoBench(const simulation::McbBoardOptions &options = {})
        : LabBenchOn(options)
    {
        experiment.subject.limits.torquePerAmp =
            motor::ktOfFlux_nmpa(truth.motor.flux_wb, truth.motor.polePairs);
        steps = {.fromRpm = 1000, .toRpm = 1500, .repeat = 2};
        pair.onEvent = [this, before = pair.onEvent](const drive::Event &event) {
            if (const auto *changed = std::get_if<drive::CyclicSetPointsChanged>(&event)) {
                travel = changed->on;
                began = began || travel;
            }
            before(event);
        };
    }
    /// As a window does it, whose numbers are to be read by eye.
    void readNowAndThen()
    {
        const lab::Registers &of = experiment.subject.registers;
        pair.submit(drive::Watch{
            .registers = {of.reference, of.current, of.speed, of.speedReference}, .period = 200ms});
        pair.runFor(1s);
    }
    bool travel = false, began = false; ///< set-points, with every exchange
    Result<lab::Finding, std::string> finding() const
    {
        return lab::findingIn(capture, happenings);
    }
    bool idles() { return pair.runUntilState(drive::MotorState::Idle); }
    const simulation::PlantParameters truth = *simulation::findPreset("servo24");
};

} // namespace

class TestExchangedSamples : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void stepsAreThoseOfTheRotor();
    void theMechanicsAreThoseOfTheMotor();
    void theResponseIsThatOfTheShaft();
    void theLoopIsThatOfItsGains();
    void setPointsThatTravelledBeforeGoOn();
    void aBrokenBoundIsAStop();
    void whatIsNoNumberBreaksIt();
    void anAnswerThatIsLostLeavesNothingTravelling();
    void aStartGoesItsWayAsBefore();
    void aStopLeavesNoSetPointThatTravels();
    void aLineThatFallsSilentBreaksIt();
    void whatNeedsMoreIsRefused();
};

void TestExchangedSamples::stepsAreThoseOfTheRotor()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    bench.readNowAndThen();
    std::vector<std::pair<lab::Nanos, double>> rotor;
    bench.eachTurn = [&] {
        rotor.emplace_back(
            bench.pair.now.time_since_epoch().count(), bench.pair.board->truth(1).rpm);
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(!outcome.leaves, outcome.reason.c_str());
    QCOMPARE(bench.stops, 0);
    QVERIFY(bench.idles());
    const auto series = bench.series();
    QVERIFY2(series, series ? "" : series.error().c_str());
    QCOMPARE(series->runs.size(), 4U);
    for (const lab::StepRun &run : series->runs) {
        QVERIFY(run.rise_s && run.overshoot_pct && run.settling_s && run.peakIq_a);
        QVERIFY(run.pollDistance_s < 2.5e-3);
        const double from = run.up ? 1000.0 : 1500.0, way = run.up ? 500.0 : -500.0;
        const auto when = [&](double share) {
            const auto at = std::find_if(rotor.begin(), rotor.end(), [&](const auto &one) {
                return one.first > run.at - 20'000'000 && (one.second - from) / way >= share;
            });
            return at == rotor.end() ? lab::Nanos{0} : at->first;
        };
        double most = 0.0;
        for (const auto &[at, rpm] : rotor)
            if (at > run.at && at < run.until)
                most = std::max(most, (rpm - from) / way);
        const double rise_s = capture::toSeconds(when(0.9) - when(0.1));
        QVERIFY2(std::abs(*run.rise_s - rise_s) < 4e-3,
            qPrintable(QStringLiteral("%1, not %2").arg(*run.rise_s).arg(rise_s)));
        QVERIFY2(std::abs(*run.overshoot_pct / 100.0 - (most - 1.0)) < 0.04,
            qPrintable(QStringLiteral("%1, not %2").arg(*run.overshoot_pct).arg(most)));
    }
}

void TestExchangedSamples::theMechanicsAreThoseOfTheMotor()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = lab::spinPlanFor(bench.experiment.subject, {});
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(!outcome.leaves, outcome.reason.c_str());
    const auto finding = bench.finding();
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::Mechanics>(*finding);
    VERIFY_WITHIN(found.inertia_kgm2, bench.truth.motor.inertia_kgm2, 10.0);
    VERIFY_HOLDS(found.inertia_kgm2, bench.truth.motor.inertia_kgm2);
    VERIFY_HOLDS(found.dry_nm, bench.truth.motor.coulomb_nm);
    VERIFY_HOLDS(found.viscous_nms, bench.truth.motor.viscous_nms);
}

/// Kt / (J s + B), seen through the drive's mean of eight speeds a millisecond apart. Set-points leave with every
/// exchange meanwhile, and do not before and behind it.
void TestExchangedSamples::theResponseIsThatOfTheShaft()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = lab::responsePlanFor(bench.experiment.subject, {});
    bench.readNowAndThen();
    const bool &travel = bench.travel;
    bool whileDriven = true;
    bench.eachTurn = [&] {
        whileDriven = whileDriven && (travel || !bench.pair.board->truth(1).driven);
    };
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(!outcome.leaves, outcome.reason.c_str());
    QVERIFY(bench.began && whileDriven && !travel);
    const auto finding = bench.finding();
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::SpeedResponse>(*finding);
    QVERIFY(found.notes.empty());
    int clear = 0;
    for (const lab::ResponsePoint &point : found.points) {
        if (point.coherence < 0.95 || point.hz < 4.0)
            continue;
        ++clear;
        using Complex = std::complex<double>;
        const double w = 2.0 * std::numbers::pi * point.hz;
        constexpr int kMeanOf = 8;
        Complex mean = 0.0;
        for (int late = 0; late < kMeanOf; ++late)
            mean += std::polar(1.0 / kMeanOf, -w * 1e-3 * (late + 0.5));
        const Complex truth = mean * bench.experiment.subject.limits.torquePerAmp
            / Complex(bench.truth.motor.viscous_nms, w * bench.truth.motor.inertia_kgm2);
        const Complex off = point.plant / truth;
        QVERIFY2(std::abs(std::abs(off) - 1.0) < 0.06 && std::abs(std::arg(off)) < 0.1,
            qPrintable(QStringLiteral("%1 Hz: %2, %3 rad")
                           .arg(point.hz)
                           .arg(std::abs(off))
                           .arg(std::arg(off))));
    }
    QVERIFY2(clear >= 18, qPrintable(QString::number(clear)));
}

/// The same motor behind the same loops as that of a board whose regulator is known by its gains, and is used there.
void TestExchangedSamples::theLoopIsThatOfItsGains()
{
    support::LabBench recorded;
    ServoBench bench;
    QVERIFY(recorded.pair.ready && bench.pair.ready);
    recorded.experiment.plan = lab::responsePlanFor(recorded.experiment.subject, {});
    bench.experiment.plan = lab::responsePlanFor(bench.experiment.subject, {});
    VERIFY_END(recorded.run(), End::Complete);
    VERIFY_END(bench.run(), End::Complete);
    const auto one = lab::evaluateResponse(recorded.capture, recorded.happenings);
    const auto other = lab::evaluateResponse(bench.capture, bench.happenings);
    QVERIFY(one && one->crossover_hz && one->phaseMargin_deg && one->ms);
    QVERIFY(other && other->crossover_hz && other->phaseMargin_deg && other->ms);
    VERIFY_WITHIN(*other->crossover_hz, one->crossover_hz->value, 8.0);
    QVERIFY(std::abs(other->phaseMargin_deg->value - one->phaseMargin_deg->value) < 4.0);
    VERIFY_WITHIN(*other->ms, one->ms->value, 8.0);
}

void TestExchangedSamples::setPointsThatTravelledBeforeGoOn()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    QCOMPARE(bench.pair.ask(drive::CyclicSetPoints{true}).outcome, drive::Outcome::Ok);
    QVERIFY(bench.travel);
    auto plan = lab::responsePlanFor(bench.experiment.subject, {});
    plan.length = 4s;
    bench.experiment.plan = plan;
    VERIFY_END(bench.run(), End::Complete);
    bench.pair.runFor(500ms);
    QVERIFY(bench.travel);
}

void TestExchangedSamples::aBrokenBoundIsAStop()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    bench.steps.caps.maxCurrentAmps = 1.0;
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Aborted);
    QVERIFY2(outcome.reason.find("a current of") != std::string::npos, outcome.reason.c_str());
    QCOMPARE(bench.stops, 1);
    QVERIFY(bench.idles());
}

/// A drive's floats are whatever it sends: a speed that is no number is not within any bound.
void TestExchangedSamples::whatIsNoNumberBreaksIt()
{
    const catalog::Catalog none;
    for (const std::size_t wrong : {0U, 1U}) {
        lab::Envelope envelope({.speed = 1, .current = 2});
        envelope.set({.leastRpm = -100.0, .mostRpm = 2000.0, .mostAmps = 5.0}, TimePoint(1s));
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = 1e6;
        layout.slow = {{1, "speed", "rpm"}, {2, "current", "A"}};
        for (capture::StreamSignal &signal : layout.slow)
            signal.real = true;
        QVERIFY(!envelope.accept(drive::StreamStarted{layout}, none, TimePoint(1s)));
        capture::SampleBlock block;
        block.stream = 1;
        const auto bits = [](float value) { return std::bit_cast<std::int32_t>(value); };
        block.slow = {{0, {bits(1000.0F), bits(-3.0F)}}};
        QVERIFY(!envelope.accept(block, none, TimePoint(1s)));
        QCOMPARE(envelope.rpm(), std::optional(1000.0));
        QCOMPARE(envelope.amps(), std::optional(-3.0));
        block.slow.front().values[wrong] = bits(std::numeric_limits<float>::quiet_NaN());
        QVERIFY(envelope.accept(block, none, TimePoint(1s)));
        QCOMPARE(envelope.rpm(), std::optional(1000.0));
    }
    // A bus that is told so was not read, and silence bounds it.
    lab::Envelope envelope({.bus = 3});
    envelope.set({.mostBus_v = 26.0, .silence = 1s}, TimePoint(1s));
    const auto reads = [&](double volts, TimePoint at) {
        const drive::RegistersRead read{{{3, drive::ReadStatus::Ok, volts, at}}};
        QVERIFY(!envelope.accept(read, none, at));
    };
    reads(24.0, TimePoint(2s));
    reads(std::nan(""), TimePoint(9s));
    QVERIFY(!envelope.busSince(TimePoint(2s)));
    QVERIFY(envelope.silence(TimePoint(9s)));
}

/// It may have begun all the same: it is ended again, and nothing was started.
void TestExchangedSamples::anAnswerThatIsLostLeavesNothingTravelling()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = lab::responsePlanFor(bench.experiment.subject, {});
    bench.begin();
    QVERIFY(bench.runUntil([&] { return !bench.asked<drive::CyclicSetPoints>().empty(); }));
    bench.runner->accept(
        drive::Ended{bench.wishes.back().id, drive::Outcome::Unknown, "no answer", {}},
        bench.pair.now);
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }));
    VERIFY_END(bench.runner->outcome(), End::Refused);
    QVERIFY(!bench.asked<drive::CyclicSetPoints>().back().on);
    QVERIFY(bench.asked<drive::Command>().empty());
    QVERIFY2(bench.runner->outcome().reason.find("leave with every exchange") == std::string::npos,
        bench.runner->outcome().reason.c_str());
    bench.pair.runFor(500ms);
    QVERIFY(!bench.travel);

    ServoBench disarmed; // before the drive has answered
    disarmed.experiment.plan = lab::responsePlanFor(disarmed.experiment.subject, {});
    disarmed.begin();
    QVERIFY(disarmed.runUntil([&] { return !disarmed.asked<drive::CyclicSetPoints>().empty(); }));
    disarmed.runner->disarm();
    const lab::Outcome outcome = disarmed.runner->outcome();
    QVERIFY2(outcome.leaves
            && outcome.reason.find("set-points may leave with every exchange") != std::string::npos,
        outcome.reason.c_str());
}

/// A speed is asked for by a mode and a profile of its own: a start that went there by a ramp does not jump afterwards.
void TestExchangedSamples::aStartGoesItsWayAsBefore()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    const drive::WishId ramp = bench.pair.submit(drive::SpeedRamp{1, 800, 2000ms});
    QVERIFY(bench.pair.runUntilEnded(ramp));
    std::vector<double> before;
    const std::vector<drive::RegisterId> way = bench.experiment.subject.way;
    QCOMPARE(way.size(), std::size_t{3});
    for (const drive::RegisterId id : way)
        before.push_back(bench.number(id));
    QCOMPARE(before.back(), 19.0); // by its profile
    const lab::Outcome outcome = bench.run();
    VERIFY_END(outcome, End::Complete);
    QVERIFY2(!outcome.leaves, outcome.reason.c_str());
    for (std::size_t i = 0; i < way.size(); ++i)
        QCOMPARE(bench.number(way[i]), before[i]);

    ServoBench cut; // what cannot be given back is said
    QVERIFY(cut.pair.runUntilEnded(cut.pair.submit(drive::SpeedRamp{1, 800, 2000ms})));
    cut.begin();
    QVERIFY(cut.runUntil([&] { return cut.pair.board->truth(1).rpm > 900.0; }));
    cut.runner->stopped();
    QVERIFY2(cut.runner->outcome().reason.find("DRV_OP_CMD=19") != std::string::npos,
        cut.runner->outcome().reason.c_str());
}

void TestExchangedSamples::aStopLeavesNoSetPointThatTravels()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(drive::SpeedRamp{1, 500, 0ms})));
    bench.experiment.plan = lab::responsePlanFor(bench.experiment.subject, {});
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.asked<drive::SpeedRamp>().size() > 6; }));
    bench.runner->stopped();
    bench.pair.drive->stop(bench.pair.now);
    const std::string &reason = bench.runner->outcome().reason;
    QVERIFY2(reason.find("the set-point is 0 rpm now, it was 500 rpm") != std::string::npos,
        reason.c_str());
    QVERIFY(bench.idles());
    QCOMPARE(bench.number(bench.experiment.subject.setPoint.back()), 0.0);
}

void TestExchangedSamples::aLineThatFallsSilentBreaksIt()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    bench.begin();
    QVERIFY(bench.runUntil([&] { return bench.pair.board->truth(1).rpm > 900.0; }));
    bench.pair.toDrive = [](Bytes &in) { std::ranges::fill(in, std::uint8_t{0}); };
    QVERIFY(bench.runUntil([&] { return bench.runner->over(); }));
    const lab::Outcome outcome = bench.runner->outcome();
    QVERIFY2(outcome.end == End::Lost || outcome.end == End::Aborted, outcome.reason.c_str());
    bench.turn();
    QCOMPARE(bench.stops, 1);
    bench.pair.toDrive = nullptr;
    QVERIFY(bench.idles());
}

void TestExchangedSamples::whatNeedsMoreIsRefused()
{
    ServoBench bench;
    QVERIFY(bench.pair.ready);
    const lab::Subject &subject = bench.experiment.subject;
    QVERIFY(subject.exchanged && subject.seesRotor());
    QVERIFY(!lab::subjectOf(*bench.pair.identified, 1));
    const std::string why =
        "this board sends its samples once an exchange: only steps and response "
        "of the speed, inertia and friction are told from them";
    for (const lab::Plan &plan : {lab::Plan(lab::restPlanFor(subject, {})),
             lab::Plan(lab::currentResponsePlanFor(subject, {})),
             lab::Plan(lab::powerPlanFor(subject, {}))})
        QCOMPARE(lab::objectionTo({plan, subject}), why);
    QVERIFY(!lab::objectionTo({lab::fluxPlanFor(subject, {}), subject}).empty());
    const lab::Experiment response{lab::responsePlanFor(subject, {}), subject};
    QCOMPARE(lab::objectionTo(response), std::string());
    QVERIFY(lab::objectionWhileTurning(response, 500.0).find("stop it first") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestExchangedSamples)
#include "tst_exchanged_samples.moc"
