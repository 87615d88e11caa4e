// How a speed loop takes a load that comes and goes: of made-up samples, whose numbers follow by hand, and of simulated
// motors, whose rotor and brake are known.
#include "core/lab/estimate_checks.h"
#include "core/lab/lost_samples.h"
#include "lab/caps.h"
#include "lab/evaluation/finding.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

#include <numbers>

using lab::End;
using lab::Nanos;
using support::LabBench;
using namespace std::chrono_literals;

namespace {

std::optional<lab::Estimate> loadFigure(const lab::LoadSteps &found, std::string_view key)
{
    for (const lab::Figure &figure : figuresOf(found))
        if (figure.key == key)
            return figure.value;
    return std::nullopt;
}

bool loadSays(const lab::LoadSteps &found, std::string_view words)
{
    return std::ranges::any_of(found.notes,
        [words](const std::string &note) { return note.find(words) != std::string::npos; });
}

constexpr double kHeldRpm = 1500.0;

/// Eight seconds of a speed that gives way by 100 rpm at 2 s and is back by exp(-t / tau_s) from flat_s on, the other
/// way at 4 s and the first way again at 6 s. Four pole pairs; the current goes with the load at once.
struct ChangingLoad {
    double dip_rpm = 100.0, flat_s = 0.03, tau_s = 0.02, load_a = 3.0;
    std::vector<double> changes_s{2.0, 4.0, 6.0};
    bool back = true; ///< else it stays where it went
    std::string sensor = "ENCODER_EL_ANGLE";
    /// Of a second of gap, the piece behind it, and another second of gap; 0: there is none.
    double missingFrom_s = 0.0, kept_s = 0.0;
    int planned_rpm = static_cast<int>(kHeldRpm); ///< as the file says it

    Result<lab::Finding, std::string> found() const
    {
        constexpr int kTicks = 64000;
        constexpr double kTick_hz = 8000.0;
        capture::Capture capture;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kTick_hz;
        layout.fast = {{1, sensor, "deg", 360.0 / 65536.0}, {2, "I_Q_REF", "A", 1e-3},
            {3, "I_Q_MEAS", "A", 1e-3}};
        capture.begin(layout);
        capture::SampleBlock block;
        block.stream = 1;
        block.count = kTicks;
        std::vector<std::int16_t> current;
        double turns = 0.0;
        for (int tick = 0; tick < kTicks; ++tick) {
            const double at_s = tick / kTick_hz;
            double rpm = kHeldRpm, amps = 1.0;
            int count = 0;
            for (const double change_s : changes_s) {
                if (at_s < change_s)
                    break;
                const double t_s = at_s - change_s, way = count++ % 2 == 0 ? -1.0 : 1.0;
                amps += -way * load_a;
                rpm = kHeldRpm
                    + way * dip_rpm
                        * (t_s < 0.01          ? t_s / 0.01
                                : !back        ? 1.0
                                : t_s < flat_s ? 1.0
                                               : std::exp(-(t_s - flat_s) / tau_s));
            }
            turns += rpm / 60.0 * 4.0 / kTick_hz;
            block.fast.push_back(static_cast<std::int16_t>(
                std::lround(65536.0 * (turns - std::floor(turns))) - 32768));
            current.push_back(static_cast<std::int16_t>(std::lround(amps * 1e3)));
        }
        for (int times = 0; times < 2; ++times)
            block.fast.insert(block.fast.end(), current.begin(), current.end());
        const auto appendFrom = [&](double from_s, double to_s) {
            const auto from = std::ptrdiff_t(from_s * kTick_hz),
                       to = std::ptrdiff_t(to_s * kTick_hz);
            capture::SampleBlock part;
            part.stream = 1;
            part.firstTick = static_cast<capture::Tick>(from);
            part.count = static_cast<std::uint32_t>(to - from);
            for (std::ptrdiff_t signal = 0; signal < 3; ++signal) {
                const auto begin = block.fast.begin() + signal * kTicks;
                part.fast.insert(part.fast.end(), begin + from, begin + to);
            }
            capture.append(part);
        };
        if (!(kept_s > 0.0)) {
            capture.append(block);
        } else {
            appendFrom(0.0, missingFrom_s);
            appendFrom(missingFrom_s + 1.0, missingFrom_s + 1.0 + kept_s);
            appendFrom(missingFrom_s + 2.0 + kept_s, kTicks / kTick_hz);
        }

        lab::LoadPlan plan;
        plan.fromRpm = plan.toRpm = planned_rpm;
        plan.hold = 3500ms;
        recorded::Happening entry{lab::LoadPlan::kEntry,
            {{"motor", "1"}, {"pole pairs", "4"}, {"torque Nm per A", "0.05"},
                {"reference", "I_Q_REF"}, {"current", "I_Q_MEAS"}, {"angle", sensor}}};
        lab::putFields(entry, plan);
        const auto ramp = [](const char *ms) {
            return recorded::Happening{"speed ramp", {{"motor", "1"}, {"rpm", "1500"}, {"ms", ms}}};
        };
        return lab::findingIn(capture,
            {{0, entry}, {capture::toNanos(0.5), ramp("0")}, {capture::toNanos(4.0), ramp("0")},
                {capture::toNanos(7.9), lab::entryOfEnd({})}});
    }
    lab::LoadSteps load() const
    {
        const auto it = found();
        return it ? std::get<lab::LoadSteps>(*it) : lab::LoadSteps{};
    }
};

} // namespace

class TestLoad : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theNumbersOfSamplesFollowByHand();
    void whatIsNotBackIsNotTold();
    void aLoadThatGoesAgainAtOnceDoesNotCount();
    void withoutAChangeNothingFollows();
    void aBrakeIsToldAsTheRotorFeelsIt_data();
    void aBrakeIsToldAsTheRotorFeelsIt();
    void aGapTakesWhatItTakes();
    void aPieceWithinAChangeHasNoMiddleOfItsOwn();
    void itHasCapsAndIsAgreedTo();
};

void TestLoad::theNumbersOfSamplesFollowByHand()
{
    ChangingLoad made;
    const lab::LoadSteps found = made.load();
    QVERIFY(loadSays(found, "the load came 2 times and went 1 times"));
    VERIFY_WITHIN(*loadFigure(found, "load_a"), 3.0, 1.0);
    VERIFY_WITHIN(*loadFigure(found, "load_nm"), 0.15, 1.0);
    VERIFY_WITHIN(*loadFigure(found, "dip_rpm"), 100.0, 3.0);
    VERIFY_WITHIN(*loadFigure(found, "dip_rpm_per_a"), 100.0 / 3.0, 3.0);
    // 10 % are left ln 10 tau behind the 30 ms; known to a block of 4 ms at both ends.
    const double recovery_s = 0.03 + 0.02 * std::numbers::ln10;
    QVERIFY2(std::abs(loadFigure(found, "recovery_s")->value - recovery_s) < 8e-3,
        qPrintable(QString::number(loadFigure(found, "recovery_s")->value)));
    VERIFY_WITHIN(*loadFigure(found, "peak_iq_a"), 4.0, 1.0); // of all, with the load
    made.dip_rpm = -100.0; // backwards would be the same the other way round
    QVERIFY(loadSays(made.load(), "the load came 1 times and went 2 times"));
}

void TestLoad::whatIsNotBackIsNotTold()
{
    ChangingLoad made;
    made.changes_s = {7.0};
    made.back = false;
    QVERIFY(!made.found());
    QVERIFY(made.found().error().starts_with("the load changed, and the speed did not come back"));
    made.back = true;
    made.changes_s = {3.0, 7.38}; // 20 ms before the end
    made.tau_s = 0.5;
    const lab::LoadSteps found = made.load();
    QVERIFY(loadSays(found, "the load came 1 times and went 0 times"));
    QVERIFY(loadSays(found, "it does not count"));
    QVERIFY(!loadFigure(found, "dip_rpm")->low); // nothing is known of the spread
    QVERIFY(!loadFigure(found, "load_nm")->low);
}

/// A tap: what is left of the reference behind it is nothing, and would make its yield endless.
void TestLoad::aLoadThatGoesAgainAtOnceDoesNotCount()
{
    ChangingLoad made;
    made.changes_s = {2.0, 4.0, 6.0, 6.04};
    const lab::LoadSteps found = made.load();
    QVERIFY(loadSays(found, "a load came and went before the speed was back"));
    QVERIFY(loadSays(found, "the load came 1 times and went 1 times"));
    VERIFY_WITHIN(*loadFigure(found, "dip_rpm_per_a"), 100.0 / 3.0, 3.0);
}

void TestLoad::withoutAChangeNothingFollows()
{
    ChangingLoad made;
    made.changes_s.clear();
    QVERIFY(!made.found());
    QVERIFY(made.found().error().starts_with("no load came or went"));
    made.sensor = "HALL_EL_ANGLE"; // whose means are as long as a turn
    made.planned_rpm = 0;
    QVERIFY(!made.found());
    made.planned_rpm = 1;
    QVERIFY(!made.found());
}

void TestLoad::aBrakeIsToldAsTheRotorFeelsIt_data()
{
    QTest::addColumn<QString>("motor");
    for (const char *motor : {"servo24", "blower36", "pm24", "ipm48"})
        QTest::newRow(motor) << QString::fromLatin1(motor);
}

/// A brake of 0.15 of the nominal torque comes and goes twice while the speed is held.
void TestLoad::aBrakeIsToldAsTheRotorFeelsIt()
{
    QFETCH(const QString, motor);
    const simulation::PlantParameters truth = *simulation::findPreset(motor.toStdString());
    const double ampTorque = 1.5 * truth.motor.polePairs * truth.motor.flux_wb;
    const double brake_nm = 0.15 * ampTorque * truth.motor.nominal_a;
    simulation::BoardOptions options;
    options.motor = motor.toStdString();
    LabBench bench(options);
    QVERIFY(bench.pair.ready);
    const lab::LoadPlan plan = lab::loadPlanFor(bench.experiment.subject, {});
    bench.experiment.plan = plan;
    std::optional<TimePoint> held;
    std::vector<double> farthest; ///< of each change, by the rotor
    double before_rpm = 0.0;
    bench.eachTurn = [&] {
        const auto asked = bench.asked<drive::SpeedRamp>();
        if (!held && !asked.empty() && asked.back().duration == 0ms)
            held = bench.pair.now;
        if (!held)
            return;
        const auto second = static_cast<std::size_t>((bench.pair.now - *held) / 2s);
        if (second >= 5)
            return;
        if (second >= farthest.size()) {
            before_rpm = bench.pair.board->truth(1).rpm;
            farthest.push_back(0.0);
            bench.pair.board->setLoadTorque(1, second % 2 == 1 ? brake_nm : 0.0);
        }
        farthest.back() =
            std::max(farthest.back(), std::abs(bench.pair.board->truth(1).rpm - before_rpm));
    };
    const lab::Outcome outcome = bench.run();
    QVERIFY2(outcome.end == End::Complete && outcome.reason.empty(),
        qPrintable(support::outcomeText(outcome)));
    const auto finding = lab::findingIn(bench.capture, bench.happenings);
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::LoadSteps>(*finding);
    QVERIFY2(
        loadSays(found, "the load came 2 times and went 2 times"), found.notes.front().c_str());
    VERIFY_WITHIN(*loadFigure(found, "load_nm"), brake_nm, 6.0);
    const lab::Estimate load_nm = *loadFigure(found, "load_nm");
    QVERIFY(*load_nm.high - load_nm.value >= 0.03 * load_nm.value);
    double dip_rpm = 0.0;
    for (std::size_t change = 1; change < farthest.size(); ++change)
        dip_rpm += farthest[change] / 4.0;
    VERIFY_WITHIN(*loadFigure(found, "dip_rpm"), dip_rpm, 12.0);
    QVERIFY(loadFigure(found, "recovery_s")->value > 0.0);
    QVERIFY(loadFigure(found, "dip_rpm")->low && loadFigure(found, "recovery_s")->low);
}

void TestLoad::aGapTakesWhatItTakes()
{
    LabBench bench;
    QVERIFY(bench.pair.ready);
    bench.experiment.plan = lab::loadPlanFor(bench.experiment.subject, {});
    bool braked = false;
    bench.eachTurn = [&] {
        if (std::exchange(braked, bench.pair.now > TimePoint(9s)) != braked)
            bench.pair.board->setLoadTorque(1, 0.05);
    };
    const lab::LostSamples lost(bench, 5500ms, 200ms);
    VERIFY_END(bench.run(), End::Complete);
    const auto finding = lab::findingIn(bench.capture, bench.happenings);
    QVERIFY2(finding, finding ? "" : finding.error().c_str());
    const auto &found = std::get<lab::LoadSteps>(*finding);
    QVERIFY(lost.saidIn(found.notes));
    VERIFY_WITHIN(*loadFigure(found, "load_nm"), 0.05, 10.0);
}

/// What is kept between two gaps has given way for the most of it, and is back at its end.
void TestLoad::aPieceWithinAChangeHasNoMiddleOfItsOwn()
{
    const lab::LoadSteps found =
        ChangingLoad{.flat_s = 0.3, .changes_s = {2.0, 4.0}, .missingFrom_s = 3.05, .kept_s = 0.4}
            .load();
    QVERIFY(loadSays(found, "the load came 1 times and went 0 times"));
    QVERIFY(!loadSays(found, "was not over at the end"));
    VERIFY_WITHIN(*loadFigure(found, "dip_rpm"), 100.0, 3.0);
}

void TestLoad::itHasCapsAndIsAgreedTo()
{
    const LabBench bench;
    const lab::Subject &subject = bench.experiment.subject;
    lab::LoadPlan plan = lab::loadPlanFor(subject, {});
    QCOMPARE(lab::objectionTo({plan, subject}), std::string());
    QCOMPARE(lab::conditionsOf(lab::Experiment{plan, subject}).length, lab::milliseconds(10'000));
    const lab::Agreement agreed = lab::agreementTo({plan, subject}, 0.0);
    QCOMPARE(agreed.caps.mostRpm, 1.4 * plan.fromRpm);
    QVERIFY(lab::covers(agreed, agreed));
    lab::LoadPlan other = plan;
    other.hold = 2 * plan.hold;
    QVERIFY(!lab::covers(agreed, lab::agreementTo({other, subject}, 0.0)));
    other = plan;
    other.fromRpm = other.toRpm = 0;
    QCOMPARE(lab::objectionTo({other, subject}), std::string("the motor has to turn"));
    other = plan;
    other.hold = 500ms;
    QCOMPARE(lab::objectionTo({other, subject}), std::string("it takes 2 to 30 s"));
}

QTEST_APPLESS_MAIN(TestLoad)
#include "tst_load.moc"
