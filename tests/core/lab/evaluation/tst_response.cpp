// The frequency response of simulated motors and their speed loops, against the model that they are.
#include "core/lab/lost_samples.h"
#include "lab/evaluation/response_evaluation.h"
#include "lab/maths/cross_spectra.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

#include <array>
#include <numbers>

using namespace lab;
using support::LabBench;
using Complex = std::complex<double>;

namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

struct MeasuredSpeed {
    Outcome outcome;
    ResponsePlan plan;
    Result<SpeedResponse, std::string> found = fail(std::string());
};

MeasuredSpeed measure(std::string_view motor, const std::function<void(LabBench &)> &also = {})
{
    simulation::BoardOptions options;
    options.motor = motor;
    LabBench bench(options);
    MeasuredSpeed measured;
    measured.plan = responsePlanFor(bench.experiment.subject, {});
    bench.experiment.plan = measured.plan;
    measured.outcome = bench.run();
    if (also)
        also(bench);
    measured.found = evaluateResponse(bench.capture, bench.happenings);
    return measured;
}

/// Of the shaft's speed by Iq, around the plan's speed.
Complex truthAt(const simulation::PlantParameters &plant, const ResponsePlan &plan, double hz)
{
    const double kt = 1.5 * plant.motor.polePairs * plant.motor.flux_wb;
    const double speed = plan.rpm * 2.0 * std::numbers::pi / 60.0;
    return kt
        / Complex(plant.motor.viscous_nms + 2.0 * plant.load.fan_nms2 * speed,
            plant.motor.inertia_kgm2 * 2.0 * std::numbers::pi * hz);
}

Complex laplaceOf(double hz) { return {0.0, 2.0 * std::numbers::pi * hz}; }

/// As an observer tells a motor, whose angle follows the current by so much: rad/A.
SpeedResponse observed(const std::function<Complex(Complex)> &motor, double angle)
{
    SpeedResponse found;
    for (double hz = 2.0; hz <= 40.0; hz += 1.0) {
        const Complex s = laplaceOf(hz);
        ResponsePoint &point = found.points.emplace_back();
        point.hz = hz;
        point.plant = motor(s) + angle * s;
        point.relative = 0.01;
        point.coherence = 0.95;
    }
    return found;
}

/// A speed loop as it is computed, without noise: an inertia with friction, and a current that is its reference.
struct DrawnLoop {
    static constexpr double kGain = 600.0, kPole = 5.0; ///< rad/s^2 for each ampere; 1/s
    static constexpr double kRpm = 60.0 / (2.0 * std::numbers::pi);
    static constexpr SpeedRegulator kRegulator{7.5e-3, 8e-5, 1e-3};
    double tick_hz = 16000.0;
    int every = 1; ///< ticks a sample

    static Complex plantAt(double hz) { return kGain / (laplaceOf(hz) + kPole); }
    static double crossover_hz()
    {
        double hz = 1.0;
        while (std::abs(plantAt(hz) * kRpm * regulatorAt(kRegulator, hz)) > 1.0)
            hz += 0.01;
        return hz;
    }

    Result<SpeedResponse, std::string> evaluated(const Subject &subject) const
    {
        const ResponsePlan plan = responsePlanFor(subject, {});
        Happenings happenings{{-1, entryOf(plan, subject, kRegulator)}};
        const auto names = recordedPlan<ResponsePlan>(happenings[0].second);
        if (!names)
            return fail(std::string("it is no plan"));
        constexpr double kAmps = 2e-4, kSpeed_rpm = 0.1, kDegrees = 180.0 / 32768.0;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = tick_hz;
        layout.fastStep = static_cast<std::uint32_t>(every);
        layout.fast = {{1, names->reference, "A", kAmps}, {2, names->current, "A", kAmps},
            {3, names->speed, "rpm", kSpeed_rpm}, {4, names->angle, "deg", kDegrees}};
        capture::Capture capture;
        capture.begin(layout);
        std::array<std::vector<std::int16_t>, 4> columns;
        const auto put = [&columns](std::size_t column, double digits) {
            columns[column].push_back(static_cast<std::int16_t>(std::lround(digits)));
        };
        const int perRegulation = static_cast<int>(std::lround(tick_hz * kRegulator.period_s));
        constexpr int kLength_ms = 16000, kHold_ms = 30;
        support::Random random(7);
        double speed = plan.rpm / kRpm, sum = speed * kPole / kGain, amps = sum, turned = 0.0;
        int wanted_rpm = plan.rpm, next_ms = 0;
        for (int tick = 0; tick < kLength_ms * perRegulation; ++tick) {
            const int ms = tick / perRegulation;
            if (ms == next_ms) {
                wanted_rpm =
                    plan.rpm + (wanted_rpm > plan.rpm ? -plan.amplitudeRpm : plan.amplitudeRpm);
                // As a line delivers them: at no fixed phase to the samples.
                next_ms += (random.next() >> 63 == 0 ? kHold_ms : 2 * kHold_ms)
                    + static_cast<int>(random.below(15));
                happenings.emplace_back(Nanos(ms) * 1'000'000,
                    recorded::Happening{"speed ramp",
                        {{"motor", std::to_string(subject.motor)},
                            {"rpm", std::to_string(wanted_rpm)}, {"ms", "0"}}});
            }
            if (tick % perRegulation == 0) {
                const double error = wanted_rpm - speed * kRpm;
                sum += kRegulator.integral * error;
                amps = kRegulator.proportional * error + sum;
            }
            if (tick % every == 0) {
                put(0, amps / kAmps);
                put(1, amps / kAmps);
                put(2, speed * kRpm / kSpeed_rpm);
                const double electrical = turned * names->polePairs / std::numbers::pi;
                put(3, std::remainder(std::floor(electrical * 32768.0), 65536.0));
            }
            const double before = speed;
            speed += (kGain * amps - kPole * speed) / tick_hz;
            turned += (before + speed) / 2.0 / tick_hz;
        }
        capture::SampleBlock block;
        block.stream = layout.id;
        block.count = static_cast<std::uint32_t>(columns[0].size());
        for (const auto &column : columns)
            block.fast.insert(block.fast.end(), column.begin(), column.end());
        capture.append(block);
        happenings.emplace_back(Nanos(kLength_ms) * 1'000'000, entryOfEnd({}));
        return evaluateResponse(capture, happenings);
    }
};

#define VERIFY_COMPLETE(measured)                                                                  \
    QVERIFY2((measured).outcome.end == End::Complete && (measured).outcome.reason.empty(),         \
        qPrintable(support::outcomeText((measured).outcome)));                                     \
    QVERIFY2((measured).found, (measured).found ? "" : (measured).found.error().c_str())

} // namespace

class TestResponse : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anEncoderTellsTheMotorUpTo40Hz()
    {
        const MeasuredSpeed measured = measure("servo24");
        VERIFY_COMPLETE(measured);
        const auto &plant = *simulation::findPreset("servo24");
        int clear = 0, within = 0;
        for (const ResponsePoint &point : measured.found->points) {
            const Complex ratio = point.plant / truthAt(plant, measured.plan, point.hz);
            const double sigmas = std::abs(std::abs(ratio) - 1.0) / point.relative;
            within += sigmas <= 1.96 ? 1 : 0;
            QVERIFY2(sigmas < 4.0, qPrintable(QString::number(point.hz)));
            if (point.hz < 4.0 || point.hz > 40.0 || point.coherence < 0.95)
                continue;
            ++clear;
            // The set-point is held for 30 ms: little of it is left up there.
            QVERIFY2(std::abs(std::abs(ratio) - 1.0) < (point.hz < 35.0 ? 0.03 : 0.04),
                qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(std::abs(ratio))));
            QVERIFY2(std::abs(std::arg(ratio)) * kDegreesPerRadian < 3.0,
                qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(std::arg(ratio))));
        }
        QVERIFY2(clear >= 15, qPrintable(QString::number(clear)));
        QVERIFY(within >= 0.9 * double(measured.found->points.size()));
        QVERIFY(std::abs(measured.found->crossover_hz->value - 6.7) < 0.5);
        QVERIFY(std::abs(measured.found->phaseMargin_deg->value - 63.0) < 4.0);
        QVERIFY(measured.found->ms->value > 1.1 && measured.found->ms->value < 1.4);
        QVERIFY(measured.found->notes.empty());
    }

    /// Of loops of 16, 20 and 25 kHz links carry each, second, third or fifteenth sample: of few of these distances
    /// a millisecond is a multiple.
    void itsFrequenciesAreTrueAtEachDistanceOfSamples_data()
    {
        QTest::addColumn<double>("tick_hz");
        QTest::addColumn<int>("every");
        QTest::newRow("every sample") << 16000.0 << 1;
        QTest::newRow("16 kHz by 115200 baud") << 16000.0 << 15;
        QTest::newRow("20 kHz by 921600 baud") << 20000.0 << 3;
        QTest::newRow("25 kHz by 1.8 Mbaud") << 25000.0 << 2;
    }
    void itsFrequenciesAreTrueAtEachDistanceOfSamples()
    {
        QFETCH(const double, tick_hz);
        QFETCH(const int, every);
        const LabBench bench;
        const auto found =
            DrawnLoop{.tick_hz = tick_hz, .every = every}.evaluated(bench.experiment.subject);
        QVERIFY2(found, found ? "" : found.error().c_str());
        int clear = 0;
        double gains = 0.0;
        for (const ResponsePoint &point : found->points) {
            if (point.hz < 4.0 || point.hz > 40.0 || point.coherence < 0.95)
                continue;
            ++clear;
            const Complex ratio = point.plant / DrawnLoop::plantAt(point.hz);
            gains += std::abs(ratio);
            QVERIFY2(std::abs(std::abs(ratio) - 1.0) < 0.06,
                qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(std::abs(ratio))));
            QVERIFY2(std::abs(std::arg(ratio)) * kDegreesPerRadian < 3.0,
                qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(std::arg(ratio))));
        }
        QVERIFY2(clear >= 10, qPrintable(QString::number(clear)));
        QVERIFY2(std::abs(gains / clear - 1.0) < 0.02, qPrintable(QString::number(gains / clear)));
        QVERIFY(found->crossover_hz);
        QVERIFY2(std::abs(found->crossover_hz->value / DrawnLoop::crossover_hz() - 1.0) < 0.04,
            qPrintable(QString::number(found->crossover_hz->value)));
    }

    /// What is polled comes within half of the time that an envelope takes for silence.
    void aSlowLinkHasRoomForThePolls()
    {
        simulation::BoardOptions options = support::servo();
        options.baud = 115200;
        LabBench bench(options);
        const Subject &subject = bench.experiment.subject;
        ResponsePlan plan = responsePlanFor(subject, {});
        plan.length = std::chrono::seconds(4);
        QCOMPARE(objectionTo(plan, subject), std::string());
        bench.experiment.plan = plan;
        std::optional<TimePoint> last;
        Duration longest{};
        bench.pair.onEvent = [&, before = bench.pair.onEvent](const drive::Event &event) {
            before(event);
            const auto *read = std::get_if<drive::RegistersRead>(&event);
            if (read == nullptr || !bench.ranAt)
                return;
            for (const drive::Reading &one : read->readings)
                if (one.id == subject.registers.bus) {
                    longest = std::max(longest, bench.pair.now - last.value_or(bench.pair.now));
                    last = bench.pair.now;
                }
        };
        VERIFY_END(bench.run(), End::Complete);
        const Duration silence = Caps().silence + std::chrono::milliseconds(100);
        QVERIFY2(longest > Duration::zero() && longest <= silence / 2,
            qPrintable(QString::number(toSeconds(longest))));
    }

    /// What worked before the polls were counted still does: by any usual control loop a current's response at 230400
    /// baud, a speed's at 115200.
    void slowLinksCarryWhatResponsesNeed()
    {
        const LabBench bench;
        for (const double tick_hz : {8e3, 10e3, 12e3, 16e3, 20e3, 25e3, 30e3}) {
            Subject slow = bench.experiment.subject;
            slow.tickHz = tick_hz;
            slow.linkBytesPerSecond = 23040.0;
            QCOMPARE(objectionTo(currentResponsePlanFor(slow, {}), slow), std::string());
            slow.linkBytesPerSecond = 11520.0;
            QCOMPARE(objectionTo(responsePlanFor(slow, {}), slow), std::string());
        }
    }

    void samplesTooFarApartTellNoResponse()
    {
        const LabBench bench;
        const auto found = DrawnLoop{.every = 30}.evaluated(bench.experiment.subject);
        QVERIFY(!found);
        QVERIFY2(found.error().find("1.88 ms apart") != std::string::npos, found.error().c_str());
    }

    void aGapIsSaid()
    {
        LabBench bench;
        bench.experiment.plan = responsePlanFor(bench.experiment.subject, {});
        const auto found = foundWithAGap(bench, std::chrono::seconds(9), evaluateResponse);
        QVERIFY2(found, found ? "" : found.error().c_str());
        QVERIFY(found->crossover_hz && std::abs(found->crossover_hz->value - 6.7) < 0.7);
    }

    /// As of a program that was killed.
    void aRecordingThatEndsBeforeItsExperimentIsToldSo()
    {
        const MeasuredSpeed cut =
            measure("servo24", [](LabBench &bench) { bench.happenings.pop_back(); });
        VERIFY_COMPLETE(cut);
        QCOMPARE(cut.found->notes,
            (std::vector<std::string>{"the recording ends before the experiment does"}));
    }

    /// Their spread over seeds is what they say.
    void marginsHaveIntervals()
    {
        std::vector<FrequencyResponse> all;
        for (const std::uint32_t seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
            LabBench bench(support::servo(seed), seed);
            ResponsePlan plan = responsePlanFor(bench.experiment.subject, {});
            plan.seed = seed;
            bench.experiment.plan = plan;
            QVERIFY(bench.run().end == End::Complete);
            const auto found = evaluateResponse(bench.capture, bench.happenings);
            QVERIFY(found && found->crossover_hz && found->phaseMargin_deg && found->ms);
            all.push_back(*found);
        }
        for (const auto member : {&FrequencyResponse::crossover_hz,
                 &FrequencyResponse::phaseMargin_deg, &FrequencyResponse::ms}) {
            double mean = 0.0, width = 0.0;
            for (const FrequencyResponse &one : all) {
                mean += (one.*member)->value / double(all.size());
                width += (*(one.*member)->high - *(one.*member)->low) / double(all.size());
            }
            int held = 0;
            for (const FrequencyResponse &one : all) {
                const Estimate &estimate = *(one.*member);
                held += *estimate.low <= mean && mean <= *estimate.high ? 1 : 0;
            }
            QVERIFY2(held >= 5, qPrintable(QString::number(held)));
            QVERIFY(width < 0.5 * mean);
        }
    }

    void anObservedSpeedTellsItUpTo25Hz_data()
    {
        QTest::addColumn<QString>("motor");
        for (const char *motor : {"pm24", "prop12", "ipm48", "blower36"})
            QTest::newRow(motor) << QString::fromLatin1(motor);
    }
    void anObservedSpeedTellsItUpTo25Hz()
    {
        QFETCH(const QString, motor);
        const MeasuredSpeed measured = measure(motor.toStdString());
        VERIFY_COMPLETE(measured);
        const auto &plant = *simulation::findPreset(motor.toStdString());
        int known = 0, within = 0;
        for (const ResponsePoint &point : measured.found->points) {
            QCOMPARE(point.plantKnown, point.hz <= 25.0);
            if (!point.plantKnown || point.coherence < 0.8 || point.hz < 3.0)
                continue;
            ++known;
            const Complex ratio = point.plant / truthAt(plant, measured.plan, point.hz);
            within += std::abs(std::abs(ratio) - 1.0) <= 1.96 * point.relative ? 1 : 0;
            // Without what the current does to the angle it would be 30 % at 25 Hz.
            QVERIFY2(std::abs(std::abs(ratio) - 1.0) < std::max(0.06, 3.0 * point.relative),
                qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(std::abs(ratio))));
        }
        QVERIFY(within >= 0.9 * known);
        QVERIFY(known >= 10);
        QVERIFY(measured.found->crossover_hz.has_value());
        QCOMPARE(measured.found->notes.size(), 1U);
    }

    void frictionIsNotTakenForTheAngle_data()
    {
        QTest::addColumn<double>("pole"); // of the motor: friction by inertia, rad/s
        QTest::addColumn<double>("angle"); // rad/A
        QTest::newRow("none") << 0.0 << 0.01;
        QTest::newRow("a propeller") << 5.5 << 0.01;
        QTest::newRow("a heavy fan") << 20.0 << 0.01;
        QTest::newRow("a heavy fan, the other way") << 20.0 << -0.01;
        QTest::newRow("only a heavy fan") << 20.0 << 0.0;
    }
    void frictionIsNotTakenForTheAngle()
    {
        QFETCH(const double, pole);
        QFETCH(const double, angle);
        const auto truth = [pole](Complex s) { return 600.0 / (s + pole); };
        SpeedResponse found = observed(truth, angle);
        correctObserved(found, 4.0);
        for (const ResponsePoint &point : found.points) {
            QCOMPARE(point.plantKnown, point.hz <= 25.0);
            const double gain = std::abs(point.plant / truth(laplaceOf(point.hz)));
            if (point.plantKnown)
                QVERIFY2(std::abs(gain - 1.0) < 0.02,
                    qPrintable(QStringLiteral("%1 Hz: %2").arg(point.hz).arg(gain)));
        }
    }

    void aResonanceIsNotTakenForTheAngle()
    {
        const auto truth = [](Complex s) {
            const auto bend = [s](double hz) { return 1.0 - std::norm(s / laplaceOf(hz)); };
            return 600.0 / s * bend(25.5) / bend(35.5);
        };
        SpeedResponse found = observed(truth, 0.0);
        const SpeedResponse before = found;
        correctObserved(found, 4.0);
        for (std::size_t i = 0; i < found.points.size(); ++i) {
            QCOMPARE(found.points[i].plantKnown, found.points[i].hz <= 10.0);
            QCOMPARE(found.points[i].plant, before.points[i].plant);
        }
    }

    void withoutGainsTheLoopIsNotTold()
    {
        const MeasuredSpeed measured = measure("servo24", [](LabBench &bench) {
            for (auto &[at, what] : bench.happenings)
                for (auto &[key, value] : what.fields)
                    if (key == "proportional A per rpm" || key == "integral A per rpm")
                        value = "0";
        });
        QVERIFY(measured.found);
        QVERIFY(!measured.found->crossover_hz && !measured.found->ms);
    }

    void changedGainsAreNoLoop_data()
    {
        QTest::addColumn<int>("after_s"); // of the plan
        QTest::addColumn<bool>("lent"); // three quarters of the gains
        QTest::addColumn<bool>("changes");
        QTest::newRow("before the first edge") << 0 << false << true;
        QTest::newRow("in the middle") << 8 << false << true;
        QTest::newRow("behind it") << -1 << false << false;
        QTest::newRow("lent ones, given back") << -1 << true << false;
        QTest::newRow("lent ones in the middle") << 8 << true << true;
    }
    void changedGainsAreNoLoop()
    {
        QFETCH(const int, after_s);
        QFETCH(const bool, lent);
        LabBench bench(support::servo());
        const Registers &registers = bench.experiment.subject.registers;
        ResponsePlan plan = responsePlanFor(bench.experiment.subject, {});
        const int kp = int(bench.number(registers.gain)),
                  ki = int(bench.number(registers.integral));
        if (lent) {
            plan.kp = 3 * kp / 4;
            plan.ki = 3 * ki / 4;
        }
        bench.experiment.plan = plan;
        const std::int64_t other = kp / 2;
        const TimePoint due = bench.pair.now + std::chrono::seconds(after_s);
        bool written = after_s < 0;
        bench.eachTurn = [&] {
            if (!written && bench.pair.now >= due) {
                written = true;
                bench.pair.submit(
                    drive::Write{{{registers.gain, other}}, drive::Reach::Parameters});
            }
        };
        QVERIFY(bench.run().end == End::Complete);
        if (after_s < 0)
            QVERIFY(bench.pair.runUntilEnded(bench.pair.submit(
                drive::Write{{{registers.gain, other}}, drive::Reach::Parameters})));
        const auto found = evaluateResponse(bench.capture, bench.happenings);
        QTEST(found.has_value() ? false : found.error() == kGainsChanged, "changes");
        QCOMPARE(found.has_value(), after_s < 0);
    }

    /// Also those of the current loop, and what the digits weigh; of this motor alone.
    void whatChangesGainsIsReadFromItsEnd_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("told");
        QTest::addColumn<bool>("changes");
        QTest::newRow("another") << "SPEED_KP"
                                 << "ok, was 700, is 350" << true;
        QTest::newRow("the same") << "SPEED_KP"
                                  << "ok, was 700, is 700" << false;
        QTest::newRow("not known before") << "SPEED_KI"
                                          << "ok, is 350" << true;
        QTest::newRow("its weight") << "SPEED_KP_DIV"
                                    << "ok, was 4, is 5" << true;
        QTest::newRow("of the current") << "I_Q_KP"
                                        << "ok, was 700, is 350" << true;
        QTest::newRow("of motor 1") << "SPEED_KP@1"
                                    << "ok, was 700, is 350" << true;
        QTest::newRow("of motor 2") << "SPEED_KP@2"
                                    << "ok, was 700, is 350" << false;
        QTest::newRow("no gain") << "SPEED_REF"
                                 << "ok, was 700, is 350" << false;
        QTest::newRow("refused") << "SPEED_KP"
                                 << "refused, was 700" << false;
        QTest::newRow("not sent") << "SPEED_KP"
                                  << "not sent" << false;
        QTest::newRow("nobody knows") << "SPEED_KP"
                                      << "unknown, was 700" << true;
    }
    void whatChangesGainsIsReadFromItsEnd()
    {
        QFETCH(const QString, name);
        QFETCH(const QString, told);
        const recorded::Happening end{
            "ended", {{"wish", "7"}, {name.toStdString(), told.toStdString()}}};
        QTEST(changesGains(1, end), "changes");
        QVERIFY(!changesGains(1, {"write", end.fields}));
    }

    void whatIsMissingIsSaid()
    {
        const MeasuredSpeed none = measure("servo24", [](LabBench &bench) {
            std::erase_if(
                bench.happenings, [](const auto &one) { return one.second.name == "speed ramp"; });
        });
        QVERIFY(!none.found && !none.found.error().empty());
        const MeasuredSpeed other =
            measure("servo24", [](LabBench &bench) { bench.happenings.clear(); });
        QVERIFY(!other.found);
    }

    void aPlanIsHeldAgainstTheMotor()
    {
        const LabBench bench;
        const Subject &subject = bench.experiment.subject;
        const ResponsePlan plan = responsePlanFor(subject, {});
        QVERIFY(objectionTo(plan, subject).empty());
        Subject slow = subject; // 1.9 ms between two samples of four signals
        slow.linkBytesPerSecond = 5760.0;
        QVERIFY(objectionTo(plan, slow).find("too far") != std::string::npos);
        ResponsePlan other = plan;
        other.amplitudeRpm = plan.rpm / 2;
        QVERIFY(!objectionTo(other, subject).empty());
        other = plan;
        other.length = std::chrono::minutes(1);
        QVERIFY(!objectionTo(other, subject).empty());
        const auto read = recordedPlan<ResponsePlan>(entryOf(plan, subject, {0.1, 0.02, 1e-3}));
        QVERIFY(read && read->plan == plan && (read->regulator == SpeedRegulator{0.1, 0.02, 1e-3}));
    }

    /// A known filter: twice the instrument, two samples late, with noise that has nothing to do with it.
    void crossSpectraTellGainDelayAndCoherence()
    {
        support::Random random(5);
        const auto uniform = [&] {
            return static_cast<double>(random.next() >> 11) * 0x1p-52 - 1.0;
        };
        std::vector<double> r, y;
        for (int i = 0; i < 64 * 1024; ++i) {
            r.push_back(uniform());
            y.push_back((i >= 2 ? 2.0 * r[static_cast<std::size_t>(i - 2)] : 0.0) + uniform());
        }
        CrossSpectrum sum(256, 1000.0, 1);
        sum.add(std::vector{r, y});
        const CrossSpectra all = sum.result();
        QCOMPARE(all.binHz, 1000.0 / 256.0);
        QCOMPARE(sum.count(), 511);
        for (const std::size_t bin : {10U, 40U, 100U}) {
            const Complex gain = all.cross[0][bin] / all.instrument[bin];
            QVERIFY(std::abs(std::abs(gain) - 2.0) < 0.1);
            const double late = 2.0 * std::numbers::pi * double(bin) / 256.0 * 2.0;
            QVERIFY(std::abs(std::remainder(std::arg(gain) + late, 2.0 * std::numbers::pi)) < 0.05);
            QVERIFY(std::abs(all.coherence(0, bin) - 0.8) < 0.05); // 4 of 5 parts
        }
        const CrossSpectra band = all.band(10, 4);
        QCOMPARE(band.averages, 4 * all.averages);
        QVERIFY(std::abs(band.instrument[0]
                    - (all.instrument[10] + all.instrument[11] + all.instrument[12]
                        + all.instrument[13]))
            < 1e-6 * band.instrument[0]);
    }
};

QTEST_APPLESS_MAIN(TestResponse)
#include "tst_response.moc"
