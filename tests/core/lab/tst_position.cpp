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
    std::chrono::milliseconds ramp{1}, hold{900}; ///< as the plan has them
    double ended_s = 2.95;
    double digit_deg = 360.0 / 65536.0;

    lab::MeasuredSteps found() const
    {
        constexpr int kTicks = 24000;
        constexpr double kTick_hz = 8000.0;
        capture::Capture capture;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kTick_hz;
        layout.fast = {{1, "ENCODER_EL_ANGLE", "deg", digit_deg}, {2, "I_Q_MEAS", "A", 1e-3}};
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
        lab::putFields(entry, PositionPlan{.byDegrees = by_deg, .ramp = ramp, .hold = hold});
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
                {capture::toNanos(ended_s), lab::entryOfEnd({})}});
        return found ? std::get<lab::MeasuredSteps>(*found) : lab::MeasuredSteps{};
    }
};

/// What the board tells is another value, from `from` moves on; none: it does not tell it.
void tellInstead(LabBench &bench, drive::RegisterId id, const std::optional<catalog::Value> &value,
    std::size_t from = 0)
{
    bench.pair.onEvent = [&bench, id, value, from, as = bench.pair.onEvent](
                             const drive::Event &event) {
        drive::Event told = event;
        if (auto *read = std::get_if<drive::RegistersRead>(&told);
            read != nullptr && bench.asked<drive::PositionRamp>().size() >= from)
            for (drive::Reading &reading : read->readings) {
                if (reading.id == id && value)
                    reading.value = *value;
                else if (reading.id == id)
                    reading.status = drive::ReadStatus::Refused;
            }
        as(told);
    };
}

} // namespace

class TestPosition : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theNumbersOfSamplesFollowByHand();
    void whatIsLeftOfAWayIsSaid();
    void aMoveThatIsCutInItsHoldTellsNothing();
    void whatSwingsIsNotCalledShort();
    void anAngleThatIsNoNumberTellsNothing();
    void aShaftGoesThereAndBack();
    void aShaftThatTurnsIsNotAsked();
    void whereAShaftCannotBeMovedFromIsSaid_data();
    void whereAShaftCannotBeMovedFromIsSaid();
    void whatStaysInPositionControlIsSaid();
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

/// Nine tenths of its whole time are not those of its hold.
void TestPosition::aMoveThatIsCutInItsHoldTellsNothing()
{
    MadeUpMoves made{.ramp = 800ms, .hold = 100ms};
    const lab::MeasuredSteps whole = made.found();
    QVERIFY(!whole.runs[1].cut);
    made.ended_s = 2.85;
    const lab::MeasuredSteps found = made.found();
    QVERIFY(!found.runs[0].cut && found.runs[1].cut);
    QVERIFY(!positionSays(found, "the shaft moved by"));
}

void TestPosition::whatSwingsIsNotCalledShort()
{
    const lab::MeasuredSteps found = MadeUpMoves{.damping = 0.01}.found();
    QVERIFY(positionSays(found, "does not settle while its position is held"));
    QVERIFY(!positionSays(found, "the shaft moved by"));
}

/// Nor is it taken for a shaft that stands.
void TestPosition::anAngleThatIsNoNumberTellsNothing()
{
    for (const lab::StepRun &run : MadeUpMoves{.digit_deg = std::nan("")}.found().runs) {
        QVERIFY(!run.rise_s && !run.overshoot_pct && !run.settling_s);
        QVERIFY(run.unusable == scope::WhyNot::GapInside);
    }
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
    // It counts from an instant that is not known better.
    for (const lab::StepRun &run : found.runs)
        QVERIFY(*found.settling_s->high - *found.settling_s->low >= 2.0 * *run.instantError_s);
}

/// Its place is asked for once it rests, and at last never.
void TestPosition::aShaftThatTurnsIsNotAsked()
{
    LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    const auto course = lab::courseOf({PositionPlan{}, bench.experiment.subject});
    const auto asks = [&](std::chrono::milliseconds at, std::optional<double> rpm) {
        return course->next({TimePoint(at), rpm, {}}).has_value();
    };
    QVERIFY(!asks(0ms, 300.0) && !asks(400ms, 0.0) && !asks(600ms, 300.0));
    QVERIFY(!asks(800ms, 0.0) && !asks(1099ms, 0.0));
    QVERIFY(asks(1100ms, 0.0));
    const auto other = lab::courseOf({PositionPlan{}, bench.experiment.subject});
    for (int at = 0; at < 2990; at += 20)
        QVERIFY(!other->next({TimePoint(std::chrono::milliseconds(at)), {}, {}}) && !other->over());
    QVERIFY(!other->next({TimePoint(3s), {}, {}}) && other->over());
    QVERIFY(QString::fromStdString(other->problem()).contains("does not come to rest"));
}

void TestPosition::whereAShaftCannotBeMovedFromIsSaid_data()
{
    QTest::addColumn<double>("radians");
    QTest::addColumn<QString>("why");
    QTest::newRow("not told") << std::nan("") << "the board does not tell where its shaft is";
    QTest::newRow("too far") << 9999.0 << "the shaft is too far from where the board was switched";
    QTest::newRow("too far back") << -10001.0 << "the shaft is too far from";
}
void TestPosition::whereAShaftCannotBeMovedFromIsSaid()
{
    QFETCH(const double, radians);
    QFETCH(const QString, why);
    LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = PositionPlan{.byDegrees = 90.0};
    tellInstead(bench, bench.experiment.subject.registers.position,
        std::isnan(radians) ? std::nullopt : std::optional<catalog::Value>(radians));
    const lab::Outcome outcome = bench.run();
    QVERIFY2(outcome.end == End::Refused && QString::fromStdString(outcome.reason).startsWith(why),
        qPrintable(support::outcomeText(outcome)));
    QVERIFY(!outcome.leaves);
    QVERIFY(bench.asked<drive::PositionRamp>().empty());
    QVERIFY(bench.pair.board->truth(1).state == simulation::MotorState::Idle);
}

/// A speed that is asked for and agreed to does not have to change the mode.
void TestPosition::whatStaysInPositionControlIsSaid()
{
    LabBench bench(positioning());
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = PositionPlan{.repeat = 1};
    const drive::RegisterId mode = bench.experiment.subject.setPoint.front(); // CONTROL_MODE
    tellInstead(bench, mode, catalog::Value(catalog::kPositionModeNumber), 2);
    const lab::Outcome outcome = bench.run();
    QVERIFY2(outcome.end == End::Complete && outcome.leaves
            && outcome.reason == "the motor is in position control now, it was in speed control",
        qPrintable(support::outcomeText(outcome)));
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
