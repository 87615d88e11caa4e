// The frequency response of current loops on simulated boards, against the exact model of windings and regulator. A
// bridge without dead time is such a model; what a dead time makes of it is seen apart.
#include "core/lab/lost_samples.h"
#include "lab/evaluation/current_response_evaluation.h"
#include "simulation/plant/presets.h"
#include "support/current_loop_model.h"
#include "support/lab_bench.h"

#include <array>
#include <functional>
#include <numbers>

using namespace lab;
using support::LabBench;
using Complex = std::complex<double>;

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

struct Measured {
    Outcome outcome;
    ResponsePlan plan;
    double tickHz = 0.0;
    Result<FrequencyResponse, std::string> found = fail(std::string());
};

Measured measure(const simulation::PlantParameters &plant, std::uint64_t seed,
    const std::function<void(LabBench &)> &also = {})
{
    simulation::BoardOptions options;
    options.plant = plant;
    options.seed = seed;
    LabBench bench(options, seed);
    Measured measured;
    measured.tickHz = bench.experiment.subject.tickHz;
    measured.plan = currentResponsePlanFor(bench.experiment.subject, {});
    measured.plan.seed = static_cast<std::uint32_t>(seed);
    bench.experiment.plan = measured.plan;
    measured.outcome = bench.run();
    if (also)
        also(bench);
    measured.found = evaluateCurrentResponse(bench.capture, bench.happenings);
    return measured;
}

simulation::PlantParameters ideal(std::string_view motor)
{
    simulation::PlantParameters plant = *simulation::findPreset(motor);
    plant.inverter.deadTime_s = 0.0;
    return plant;
}

/// A current that follows its reference as a first order does; the reference is another one each millisecond.
struct DrawnCurrent {
    static constexpr double kTick_hz = 16000.0, kBandwidth_hz = 150.0;
    int every = 1; ///< ticks a sample

    static double gainAt(double hz) { return 1.0 / std::hypot(1.0, hz / kBandwidth_hz); }

    Result<FrequencyResponse, std::string> evaluated(const Subject &subject) const
    {
        const recorded::Happening entry =
            entryOf(currentResponsePlanFor(subject, {}), subject, {0.01, 1e-4, 1e-3});
        const auto names = recordedPlan<ResponsePlan>(entry);
        if (!names)
            return fail(std::string("it is no plan"));
        constexpr double kAmps = 1e-3, kTurn_hz = 100.0;
        constexpr int kLength = 6 * 16000, kTurn = 16;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = kTick_hz;
        layout.fastStep = static_cast<std::uint32_t>(every);
        layout.fast = {{1, names->reference, "A", kAmps}, {2, names->current, "A", kAmps},
            {3, names->angle, "deg", 360.0 / 65536.0}};
        capture::Capture capture;
        capture.begin(layout);
        std::array<std::vector<std::int16_t>, 3> columns;
        const auto put = [&columns](std::size_t column, double digits) {
            columns[column].push_back(static_cast<std::int16_t>(std::lround(digits)));
        };
        const double left = std::exp(-2.0 * std::numbers::pi * kBandwidth_hz / kTick_hz);
        support::Random random(3);
        double reference = 0.0, amps = 0.0;
        for (int tick = 0; tick < kLength; ++tick) {
            if (tick % kTurn == 0)
                reference = 3.0 + static_cast<double>(random.next() >> 11) * 0x1p-52 - 1.0;
            if (tick % every == 0) {
                put(0, reference / kAmps);
                put(1, amps / kAmps);
                put(2, std::remainder(std::floor(tick * kTurn_hz / kTick_hz * 65536.0), 65536.0));
            }
            amps = reference + (amps - reference) * left;
        }
        capture::SampleBlock block;
        block.stream = layout.id;
        block.count = static_cast<std::uint32_t>(columns[0].size());
        for (const auto &column : columns)
            block.fast.insert(block.fast.end(), column.begin(), column.end());
        capture.append(block);
        const recorded::Happening moved{
            "speed ramp", {{"motor", std::to_string(subject.motor)}, {"rpm", "1500"}, {"ms", "0"}}};
        return evaluateCurrentResponse(
            capture, {{-1, entry}, {0, moved}, {6'000'000'000, entryOfEnd({})}});
    }
};

/// Where it falls through a level for the first time.
double fallsThrough(const std::function<double(double)> &gain, double level)
{
    double hz = 20.0;
    while (hz < 5000.0 && gain(hz) >= level)
        hz += 0.5;
    return hz;
}

double fallsThrough(const FrequencyResponse &found, double level)
{
    const auto below = std::find_if(found.points.begin() + 1, found.points.end(),
        [level](const ResponsePoint &point) { return std::abs(point.plant) < level; });
    const ResponsePoint &a = *(below - 1), &b = *below;
    const double from = std::abs(a.plant), to = std::abs(b.plant);
    return a.hz + (from - level) / (from - to) * (b.hz - a.hz);
}

#define VERIFY_COMPLETE(measured)                                                                  \
    QVERIFY2((measured).outcome.end == End::Complete && (measured).outcome.reason.empty(),         \
        qPrintable(support::outcomeText((measured).outcome)));                                     \
    QVERIFY2((measured).found, (measured).found ? "" : (measured).found.error().c_str())

} // namespace

class TestCurrentResponse : public QObject {
    Q_OBJECT
private Q_SLOTS:
    /// Of 16 kHz a link of 230400 baud carries each eighth sample of four signals.
    void slowLinksTellItToo_data()
    {
        QTest::addColumn<int>("every");
        QTest::newRow("every sample") << 1;
        QTest::newRow("230400 baud") << 8;
    }
    void slowLinksTellItToo()
    {
        QFETCH(const int, every);
        const LabBench bench;
        const auto found = DrawnCurrent{every}.evaluated(bench.experiment.subject);
        QVERIFY2(found, found ? "" : found.error().c_str());
        int clear = 0;
        for (const ResponsePoint &point : found->points) {
            QVERIFY(point.hz > 20.0);
            if (point.hz > 300.0 || point.coherence < 0.9)
                continue;
            ++clear;
            const double ratio = std::abs(point.plant) / DrawnCurrent::gainAt(point.hz);
            QVERIFY2(std::abs(ratio - 1.0) < 0.05,
                qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(ratio)));
        }
        QVERIFY2(clear >= 5, qPrintable(QString::number(clear)));
    }

    void samplesTooFarApartTellNoResponse()
    {
        const LabBench bench;
        for (const int every : {15, 24, 8000}) {
            const auto found = DrawnCurrent{every}.evaluated(bench.experiment.subject);
            QVERIFY(!found);
            QVERIFY2(found.error().find("ms apart") != std::string::npos, found.error().c_str());
        }
    }

    void aGapIsSaid()
    {
        LabBench bench;
        bench.experiment.plan = currentResponsePlanFor(bench.experiment.subject, {});
        const auto found = foundWithAGap(bench, std::chrono::seconds(4), evaluateCurrentResponse);
        QVERIFY2(found, found ? "" : found.error().c_str());
    }

    void itIsThatOfTheExactLoop_data()
    {
        QTest::addColumn<QString>("motor");
        for (const char *motor : {"servo24", "pm24", "blower36", "prop12"})
            QTest::newRow(motor) << QString::fromLatin1(motor);
    }

    void itIsThatOfTheExactLoop()
    {
        QFETCH(const QString, motor);
        const simulation::PlantParameters plant = ideal(motor.toStdString());
        for (const std::uint64_t seed : {1U, 2U}) {
            const Measured measured = measure(plant, seed);
            VERIFY_COMPLETE(measured);
            const support::CurrentLoopModel model(plant, measured.tickHz, measured.plan.rpm);
            int clear = 0, within = 0;
            double worst = 0.0, turned = 0.0;
            for (const ResponsePoint &point : measured.found->points) {
                const Complex ratio = point.plant / model.at(point.hz);
                const double off = std::abs(std::abs(ratio) - 1.0);
                within += off <= 1.96 * point.relative ? 1 : 0;
                if (point.coherence < 0.95)
                    continue;
                ++clear;
                worst = std::max(worst, off);
                turned = std::max(turned, std::abs(std::arg(ratio)) * kDegrees);
            }
            const auto loop = [&](double hz) {
                const Complex closed = model.at(hz);
                return closed / (1.0 - closed);
            };
            const double crossover =
                fallsThrough([&](double hz) { return std::abs(loop(hz)); }, 1.0);
            const double margin =
                std::remainder(std::arg(loop(crossover)) * kDegrees + 180.0, 360.0);
            const double bandwidth =
                fallsThrough([&](double hz) { return std::abs(model.at(hz)); }, std::sqrt(0.5));
            const double measuredBandwidth = fallsThrough(*measured.found, std::sqrt(0.5));
            const FrequencyResponse &found = *measured.found;
            const QString numbers =
                QStringLiteral("%1 points: %2 %, %3 degrees, %4 of %5 inside; "
                               "crossover %6 of %7, margin %8 of %9, ")
                    .arg(clear)
                    .arg(worst * 100.0)
                    .arg(turned)
                    .arg(within)
                    .arg(found.points.size())
                    .arg(found.crossover_hz ? found.crossover_hz->value : 0.0)
                    .arg(crossover)
                    .arg(found.phaseMargin_deg ? found.phaseMargin_deg->value : 0.0)
                    .arg(margin)
                + QStringLiteral("-3 dB %1 of %2").arg(measuredBandwidth).arg(bandwidth);
            qInfo("%s", qPrintable(numbers));
            QVERIFY2(clear >= 8 && worst < 0.04 && turned < 3.0, qPrintable(numbers));
            QVERIFY2(within >= 0.9 * double(found.points.size()), qPrintable(numbers));
            QVERIFY(found.ms->value >= 1.0 && found.ms->value < 1.1);
            // Hall sensors see the rotor in steps, which are a current of their own just there.
            QCOMPARE(found.crossover_hz.has_value(), motor != QStringLiteral("blower36"));
            if (!found.crossover_hz)
                continue;
            QVERIFY2(std::abs(measuredBandwidth / bandwidth - 1.0) < 0.1, qPrintable(numbers));
            QVERIFY2(
                std::abs(found.crossover_hz->value / crossover - 1.0) < 0.08, qPrintable(numbers));
            QVERIFY2(std::abs(found.phaseMargin_deg->value - margin) < 4.0, qPrintable(numbers));
            QVERIFY(*found.crossover_hz->low < crossover && crossover < *found.crossover_hz->high);
            QVERIFY(*found.phaseMargin_deg->low < margin && margin < *found.phaseMargin_deg->high);
            QVERIFY(*found.phaseMargin_deg->high - *found.phaseMargin_deg->low < 20.0);
        }
    }

    /// It acts as a resistance, which is the larger the smaller the current: the loop really is slower.
    void aDeadTimeDampsItAndIsSaid()
    {
        const auto &plant = *simulation::findPreset("servo24");
        const Measured measured = measure(plant, 1);
        VERIFY_COMPLETE(measured);
        const support::CurrentLoopModel model(plant, measured.tickHz, measured.plan.rpm);
        for (const ResponsePoint &point : measured.found->points) {
            if (point.hz < 100.0 || point.hz > 500.0)
                continue;
            const double ratio = std::abs(point.plant / model.at(point.hz));
            QVERIFY2(ratio > 0.8 && ratio < 0.95, qPrintable(QString::number(ratio)));
            QVERIFY(point.coherence > 0.9);
        }
        QCOMPARE(measured.found->notes.size(), 1U);
        QVERIFY(measured.found->notes.front().find("dead time") != std::string::npos);
    }

    void whatTheMachineDoesOfItselfIsLeftOut()
    {
        const Measured measured = measure(*simulation::findPreset("pm24"), 1);
        VERIFY_COMPLETE(measured);
        const double electrical = measured.plan.rpm / 60.0 * 4.0;
        for (const ResponsePoint &point : measured.found->points)
            for (const double line :
                {electrical, 2.0 * electrical, 6.0 * electrical, 12.0 * electrical, 1000.0, 2000.0})
                QVERIFY2(std::abs(point.hz - line) > 10.0, qPrintable(QString::number(point.hz)));
    }

    void whatIsMissingIsSaid()
    {
        const Measured none = measure(ideal("servo24"), 1, [](LabBench &bench) {
            std::erase_if(
                bench.happenings, [](const auto &one) { return one.second.name == "speed ramp"; });
        });
        QVERIFY(!none.found && !none.found.error().empty());
        const Measured other =
            measure(ideal("servo24"), 1, [](LabBench &bench) { bench.happenings.clear(); });
        QVERIFY(!other.found);
        const Measured early = measure(ideal("servo24"), 1, [](LabBench &bench) {
            bench.happenings.back().second = entryOfEnd({End::Interrupted, "somebody stopped it"});
        });
        QVERIFY(early.found && early.found->notes.size() == 2);
    }

    /// As of a program that was killed.
    void aRecordingThatEndsBeforeItsExperimentIsToldSo()
    {
        const Measured cut =
            measure(ideal("servo24"), 1, [](LabBench &bench) { bench.happenings.pop_back(); });
        VERIFY_COMPLETE(cut);
        QCOMPARE(cut.found->notes.size(), 2U);
        QCOMPARE(cut.found->notes[1], std::string("the recording ends before the experiment does"));
    }

    /// As of the speed: what the plan itself lends and gives back are the gains that it is measured with.
    void changedGainsAreNoLoop_data()
    {
        QTest::addColumn<bool>("lent"); // three quarters of the gains
        QTest::addColumn<bool>("changes"); // while the set-point moves
        QTest::newRow("changed") << false << true;
        QTest::newRow("lent ones, given back") << true << false;
        QTest::newRow("lent ones, changed") << true << true;
    }
    void changedGainsAreNoLoop()
    {
        QFETCH(const bool, lent);
        QFETCH(const bool, changes);
        LabBench bench;
        const Registers &registers = bench.experiment.subject.registers;
        ResponsePlan plan = currentResponsePlanFor(bench.experiment.subject, {});
        const int kp = int(bench.number(registers.gain)),
                  ki = int(bench.number(registers.integral));
        if (lent) {
            plan.kp = 3 * kp / 4;
            plan.ki = 3 * ki / 4;
        }
        bench.experiment.plan = plan;
        constexpr std::size_t kInTheMiddle = 40; // ramps and set-points
        bool written = !changes;
        bench.eachTurn = [&] {
            if (!written && bench.asked<drive::SpeedRamp>().size() > kInTheMiddle) {
                written = true;
                bench.pair.submit(drive::Write{
                    {{registers.gain, std::int64_t{kp / 2}}}, drive::Reach::Parameters});
            }
        };
        const Outcome outcome = bench.run();
        QVERIFY2(outcome.end == End::Complete, qPrintable(support::outcomeText(outcome)));
        const auto found = evaluateCurrentResponse(bench.capture, bench.happenings);
        QCOMPARE(found ? std::string() : found.error(), changes ? kGainsChanged : std::string());
    }

    /// One plan, two questions: each recording answers its own.
    void aSpeedsResponseIsNoCurrents()
    {
        LabBench bench;
        ResponsePlan plan = responsePlanFor(bench.experiment.subject, {});
        plan.length = std::chrono::seconds(4);
        const recorded::Happening speed = entryOf(plan, bench.experiment.subject, {});
        plan.current = 1;
        const recorded::Happening current = entryOf(plan, bench.experiment.subject, {});
        QVERIFY(recordedPlan<ResponsePlan>(current)->plan == plan);
        QCOMPARE(recordedPlan<ResponsePlan>(current)->current, std::string("I_Q_MEAS"));
        const auto why = [&](const auto &found) { return QString::fromStdString(found.error()); };
        QVERIFY(why(evaluateCurrentResponse(bench.capture, {{0, speed}})).contains("no recording"));
        QVERIFY(why(evaluateResponse(bench.capture, {{0, current}})).contains("no recording"));
        QVERIFY(!why(evaluateCurrentResponse(bench.capture, {{0, current}})).contains("no rec"));
    }
};

QTEST_APPLESS_MAIN(TestCurrentResponse)
#include "tst_current_response.moc"
