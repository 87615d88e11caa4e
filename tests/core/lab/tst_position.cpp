// Moves of a shaft and back: of made-up samples, whose numbers follow by hand, and of a simulated motor whose board
// controls positions, whose rotor is known.
#include "core/lab/estimate_checks.h"
#include "core/lab/lost_samples.h"
#include "lab/caps.h"
#include "lab/evaluation/finding.h"
#include "lab/evaluation/position_evaluation.h"
#include "support/lab_bench.h"

#include <numbers>

using lab::End;
using lab::PositionPlan;
using support::LabBench;
using namespace std::chrono_literals;

namespace {

/// An encoder, and POSITION_* among the registers.
simulation::BoardOptions positioning()
{
    simulation::BoardOptions options = support::servo();
    for (const simulation::BuildOption &option : simulation::buildOptions())
        if (std::string_view(option.name) == "position")
            options.with.push_back(&option);
    return options;
}

bool positionSays(const lab::MeasuredSteps &found, std::string_view words)
{
    return std::ranges::any_of(found.notes,
        [words](const std::string &note) { return note.find(words) != std::string::npos; });
}

/// Of four pole pairs, there at 1 s and back at 2 s, by a loop of the second order that is told at once.
struct MadeUpMoves {
    double by_deg = 30.0, natural_hz = 10.0, damping = 0.5;
    double short_deg = 0.0; ///< that are left of the way back

    lab::MeasuredSteps found() const
    {
        constexpr int kTicks = 24000;
        constexpr double kTick_hz = 8000.0;
        capture::Capture capture;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kTick_hz;
        layout.fast = {{1, "ENCODER_EL_ANGLE", "deg", 360.0 / 65536.0}, {2, "I_Q_MEAS", "A", 1e-3}};
        capture.begin(layout);
        capture::SampleBlock block;
        block.stream = 1;
        block.count = kTicks;
        const auto response = [&](double t_s) {
            if (t_s < 0.0)
                return 0.0;
            const double w = 2.0 * std::numbers::pi * natural_hz;
            const double root = std::sqrt(1.0 - damping * damping), wd = w * root;
            return 1.0
                - std::exp(-damping * w * t_s)
                * (std::cos(wd * t_s) + damping / root * std::sin(wd * t_s));
        };
        for (int tick = 0; tick < kTicks; ++tick) {
            const double at_s = tick / kTick_hz;
            const double shaft_deg =
                by_deg * response(at_s - 1.0) - (by_deg - short_deg) * response(at_s - 2.0);
            const double turns = shaft_deg * 4.0 / 360.0 + 0.45; // it passes the end of a turn
            block.fast.push_back(static_cast<std::int16_t>(
                std::lround(65535.0 * (turns - std::floor(turns))) - 32768));
        }
        for (int tick = 0; tick < kTicks; ++tick)
            block.fast.push_back(tick == 9000 ? 2500 : 500);
        capture.append(block);

        recorded::Happening entry{PositionPlan::kEntry,
            {{"motor", "1"}, {"pole pairs", "4"}, {"current", "I_Q_MEAS"},
                {"angle", "ENCODER_EL_ANGLE"}}};
        lab::putFields(entry, PositionPlan{.byDegrees = by_deg, .ramp = 1ms, .hold = 900ms});
        const recorded::Happening move{
            "position ramp", {{"motor", "1"}, {"rad", "0.5"}, {"ms", "1"}}};
        const auto answer = [](const char *asked_s) {
            return recorded::Happening{
                "motion", {{"act", "POSITION_RAMP"}, {"asked s", asked_s}, {"took ms", "4"}}};
        };
        const auto found = lab::findingIn(capture,
            {{0, entry}, {capture::toNanos(0.998), move},
                {capture::toNanos(1.002), answer("0.998")}, {capture::toNanos(1.998), move},
                {capture::toNanos(2.002), answer("1.998")},
                {capture::toNanos(2.95), lab::entryOfEnd({})}});
        return found ? std::get<lab::MeasuredSteps>(*found) : lab::MeasuredSteps{};
    }
};

} // namespace

class TestPosition : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theNumbersOfSamplesFollowByHand();
    void whatIsLeftOfAWayIsSaid();
    void aShaftGoesThereAndBack();
    void aGapTakesTheMoveThatItIsIn();
    void disarmingStopsTheMotor();
    void aMoveThatIsTooFastIsRefused();
    void aBoardWithoutPositionsMovesNone();
};

void TestPosition::theNumbersOfSamplesFollowByHand()
{
    const lab::MeasuredSteps found = MadeUpMoves{}.found();
    QCOMPARE(found.runs.size(), std::size_t{2});
    QVERIFY(found.runs[0].up && !found.runs[1].up);
    for (const lab::StepRun &run : found.runs) {
        QVERIFY(run.rise_s && run.overshoot_pct && run.settling_s && run.instantError_s);
        QCOMPARE(*run.instantError_s, 2e-3);
        const double overshoot = 100.0 * std::exp(-std::numbers::pi * 0.5 / std::sqrt(0.75));
        QVERIFY2(std::abs(*run.overshoot_pct - overshoot) < 0.5,
            qPrintable(QString::number(*run.overshoot_pct)));
        // 10 to 90 % of a loop with a damping of 0.5 take 1.639 of 1 / w.
        const double rise_s = 1.639 / (2.0 * std::numbers::pi * 10.0);
        QVERIFY2(std::abs(*run.rise_s - rise_s) < 1e-3, qPrintable(QString::number(*run.rise_s)));
    }
    QCOMPARE(found.runs[0].peakIq_a.value_or(0.0), 2.5);
    QCOMPARE(found.runs[1].peakIq_a.value_or(0.0), 0.5);
    QVERIFY(found.notes.empty());
}

void TestPosition::whatIsLeftOfAWayIsSaid()
{
    MadeUpMoves made;
    made.short_deg = 2.0;
    QVERIFY(positionSays(made.found(), "the shaft moved by 28"));
    made.short_deg = 0.4; // less than half a degree
    QVERIFY(made.found().notes.empty());
}

/// By 90 degrees: the rotor does what the recording says, and everything is as before.
void TestPosition::aShaftGoesThereAndBack()
{
    LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    const PositionPlan plan{.byDegrees = 90.0, .ramp = 300ms, .repeat = 2, .hold = 600ms};
    bench.experiment.plan = plan;
    double turned_deg = 0.0, most_deg = 0.0, least_deg = 0.0;
    TimePoint before = bench.pair.now;
    bench.eachTurn = [&] {
        const double moved_s = toSeconds(bench.pair.now - std::exchange(before, bench.pair.now));
        if (bench.asked<drive::PositionRamp>().empty())
            return; // its alignment is not counted
        turned_deg += bench.pair.board->truth(1).rpm * 6.0 * moved_s;
        most_deg = std::max(most_deg, turned_deg);
        least_deg = std::min(least_deg, turned_deg);
    };
    const lab::Outcome outcome = bench.run();
    QVERIFY2(outcome.end == End::Complete && outcome.reason.empty(),
        qPrintable(support::outcomeText(outcome)));
    QVERIFY(!outcome.leaves);
    QVERIFY(bench.pair.board->truth(1).state == simulation::MotorState::Idle);
    QCOMPARE(bench.asked<drive::PositionRamp>().size(), std::size_t{4});
    QCOMPARE(bench.stops, 0);
    const auto finding = lab::findingIn(bench.capture, bench.happenings);
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    QCOMPARE(lab::nameOfRun(lab::runsIn(bench.happenings).front()), std::string("step position"));
    const auto &found = std::get<lab::MeasuredSteps>(*finding);
    QCOMPARE(found.runs.size(), std::size_t{4});
    // The way itself: 0.505 of its time from 10 to 90 %; the loop follows it.
    QVERIFY(found.rise_s && found.overshoot_pct && found.settling_s && found.peakIq_a);
    VERIFY_WITHIN(*found.rise_s, 0.505 * 0.3, 25.0);
    QVERIFY2(std::abs(most_deg - 90.0 * (1.0 + found.overshoot_pct->value / 100.0)) < 4.0,
        qPrintable(
            QStringLiteral("%1 degrees, %2 %").arg(most_deg).arg(found.overshoot_pct->value)));
    QVERIFY(found.settling_s->value > 0.15 && found.settling_s->value < 0.9);
}

void TestPosition::aGapTakesTheMoveThatItIsIn()
{
    LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = PositionPlan{.repeat = 2};
    std::optional<lab::LostSamples> lost;
    bench.eachTurn = [&] {
        if (!lost && bench.asked<drive::PositionRamp>().size() == 2)
            lost.emplace(bench, 200ms, 50ms);
    };
    VERIFY_END(bench.run(), End::Complete);
    const auto finding = lab::findingIn(bench.capture, bench.happenings);
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::MeasuredSteps>(*finding);
    QVERIFY(positionSays(found, "samples are missing in step 2 (down)"));
    QVERIFY(found.runs[0].rise_s && !found.runs[1].rise_s && found.runs[2].rise_s);
}

/// A position is held by nothing but the board: the motor does not stay behind in it.
void TestPosition::disarmingStopsTheMotor()
{
    LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = PositionPlan{};
    bench.eachTurn = [&] {
        if (bench.asked<drive::PositionRamp>().size() == 3)
            bench.runner->disarm();
    };
    const lab::Outcome outcome = bench.run();
    QCOMPARE(outcome.end, End::Interrupted);
    QVERIFY2(outcome.reason.find("every motor was told to stop") != std::string::npos
            && outcome.reason.find("position control now") != std::string::npos,
        outcome.reason.c_str());
    bench.turn();
    QCOMPARE(bench.stops, 1);
}

void TestPosition::aMoveThatIsTooFastIsRefused()
{
    const LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    const lab::Subject &subject = bench.experiment.subject;
    const auto objection = [&](const PositionPlan &plan) {
        return lab::objectionTo({plan, subject});
    };
    QCOMPARE(objection({}), std::string());
    QVERIFY(objection({.byDegrees = -3600.0, .ramp = 100ms}).ends_with("rpm that are allowed"));
    QVERIFY(objection({.byDegrees = std::nan("")}).starts_with("a shaft is moved by"));
    QVERIFY(objection({.byDegrees = 0.5}).starts_with("a shaft is moved by"));
    QVERIFY(objection({.ramp = 0ms}).starts_with("a move takes"));
    QVERIFY(objection({.repeat = 0}).starts_with("a series has"));
    QVERIFY(objection({.hold = 20ms}).starts_with("a position is held"));
    QVERIFY(!lab::objectionWhileTurning({PositionPlan{}, subject}, 500.0).empty());
    // A quarter of a turn in 300 ms has 94 rpm at the most.
    const lab::Caps caps = lab::capsOf({PositionPlan{}, subject}, 0.0);
    QVERIFY(std::abs(caps.mostRpm - 94.0 - 120.0) < 1.0 && caps.leastRpm == -caps.mostRpm);
}

void TestPosition::aBoardWithoutPositionsMovesNone()
{
    LabBench bench;
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = PositionPlan{};
    const lab::Outcome outcome = bench.run();
    QCOMPARE(outcome.end, End::Refused);
    QCOMPARE(outcome.reason, std::string("this board does not control the position of its shaft"));
    QVERIFY(bench.wishes.empty());
}

QTEST_APPLESS_MAIN(TestPosition)
#include "tst_position.moc"
