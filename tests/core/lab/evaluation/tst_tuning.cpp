// Gains from the measured response of simulated motors: that their loops keep the distance that was promised, and step
// as predicted, whatever gains the board began with.
#include "core/lab/gain_acts.h"
#include "simulation/plant/presets.h"

#include <complex>
#include <numbers>

using namespace lab;
using namespace std::chrono_literals;
using support::digitsOf;
using support::Gains;
using support::gainsOf;
using support::LabBench;
using support::respond;
using support::write;

namespace {

simulation::BoardOptions boardWith(const QString &motor)
{
    simulation::BoardOptions options;
    options.motor = motor.toStdString();
    options.load = simulation::findPreset(options.motor)->load;
    return options;
}

constexpr GainDigits kDigits{1e-4, 1e-5};
/// With it 67 digits of the proportional gain cross over at 6.7 Hz.
constexpr double kQuick_rpmPerAs = 6283.2;

/// The response of a motor gain / (s + pole) without a delay, each point as clear as can be.
SpeedResponse respondingAs(double gain_rpmPerAs, double pole_radps)
{
    SpeedResponse response;
    response.regulator = {67 * kDigits.proportional, 10 * kDigits.integral, 1e-3};
    for (double hz = 2.0; hz < 60.0; hz *= 1.3) {
        const std::complex<double> s(0.0, 2.0 * std::numbers::pi * hz);
        ResponsePoint point;
        point.hz = hz;
        point.coherence = 1.0;
        point.loop = gain_rpmPerAs / (s + pole_radps) * regulatorAt(response.regulator, hz);
        point.loopRelative = 0.01;
        response.points.push_back(point);
    }
    return response;
}

} // namespace

class TestTuning : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsProposedIsWhatComes_data()
    {
        QTest::addColumn<QString>("motor");
        QTest::addColumn<double>("factor");
        for (const simulation::Preset &preset : simulation::presets())
            for (const double factor : {1.0, 4.0, 0.25})
                QTest::addRow("%s, gains x %g", std::string(preset.name).c_str(), factor)
                    << QString::fromStdString(std::string(preset.name)) << factor;
    }
    void whatIsProposedIsWhatComes()
    {
        QFETCH(const QString, motor);
        QFETCH(const double, factor);
        LabBench before(boardWith(motor));
        const Gains told = gainsOf(before);
        const auto scaled = [&](int gain) { return std::max(1, int(std::lround(gain * factor))); };
        QVERIFY(write(before, {scaled(told.proportional), scaled(told.integral)}));
        const GainDigits digits = digitsOf(before);
        const auto measured = respond(before);
        QVERIFY2(measured, measured ? "" : measured.error().c_str());
        const auto proposed =
            proposeGains(*measured, digits, before.experiment.subject.limits.nominalCurrentAmps);
        QVERIFY2(proposed, proposed ? "" : proposed.error().c_str());
        const auto medium = std::find_if(proposed->begin(), proposed->end(),
            [](const GainCandidate &one) { return one.goal == Goal::Medium; });
        QVERIFY(medium != proposed->end());
        QVERIFY(medium->phaseMargin_deg >= distanceOf(Goal::Medium).phaseMargin_deg);
        QVERIFY(medium->ms <= distanceOf(Goal::Medium).ms);

        LabBench after(boardWith(motor));
        QVERIFY(write(after, {medium->proportional, medium->integral}));
        const auto proof = respond(after);
        QVERIFY2(proof, proof ? "" : proof.error().c_str());
        // From a quarter of the gains of an observed motor little is seen of the frequencies where a quicker loop is
        // nearest.
        const double tolerated = factor < 1.0 ? 1.2 : 1.1;
        QVERIFY2(proof->ms->value <= tolerated * distanceOf(Goal::Medium).ms,
            qPrintable(QString::number(proof->ms->value)));
        QVERIFY2(std::abs(proof->phaseMargin_deg->value - medium->phaseMargin_deg) < 5.0,
            qPrintable(QString::number(proof->phaseMargin_deg->value)));
        QVERIFY2(std::abs(proof->crossover_hz->value / medium->crossover_hz - 1.0) < 0.1,
            qPrintable(QString::number(proof->crossover_hz->value)));
    }

    void theOvershootOfASmallStepIsTheRotors_data()
    {
        QTest::addColumn<QString>("motor");
        for (const char *motor : {"servo24", "blower36", "pm24"}) // an encoder, Hall sensors, none
            QTest::newRow(motor) << QString::fromLatin1(motor);
    }
    /// Twenty digits of the speed, in which noise is as large as the overshoot.
    void theOvershootOfASmallStepIsTheRotors()
    {
        QFETCH(const QString, motor);
        LabBench bench(boardWith(motor));
        const ResponsePlan around = responsePlanFor(bench.experiment.subject, {});
        bench.steps = {.fromRpm = around.rpm - around.amplitudeRpm,
            .toRpm = around.rpm + around.amplitudeRpm,
            .repeat = 5};
        bench.experiment.plan = bench.steps;
        const Gains told = gainsOf(bench);
        QVERIFY(write(bench, {told.proportional / 2, told.integral})); // livelier than the board's
        std::vector<double> peaks; // of the rotor itself, above each step up
        bool wasUp = false;
        bench.eachTurn = [&] {
            const simulation::MotorTruth truth = bench.pair.board->truth(1);
            const bool up = std::abs(truth.referenceRpm - bench.steps.toRpm) < 10.0;
            if (up && !wasUp)
                peaks.push_back(0.0);
            if (up)
                peaks.back() = std::max(peaks.back(), truth.rpm - bench.steps.toRpm);
            wasUp = up;
        };
        const lab::Outcome outcome = bench.run();
        QVERIFY2(outcome.end == End::Complete, outcome.reason.c_str());
        const auto series = bench.series();
        QVERIFY(series && series->runs.size() == 10 && peaks.size() == 5);
        double told_pct = 0.0, rotor_pct = 0.0;
        for (const StepRun &run : series->runs)
            if (run.up) {
                QVERIFY(run.overshoot_pct);
                told_pct += *run.overshoot_pct / 5.0;
            }
        for (const double peak : peaks)
            rotor_pct += peak / (2.0 * around.amplitudeRpm) * 100.0 / 5.0;
        QVERIFY2(rotor_pct > 10.0 && std::abs(told_pct - rotor_pct) < 5.0,
            qPrintable(QStringLiteral("%1 %, the rotor %2 %").arg(told_pct).arg(rotor_pct)));
    }

    /// A heavy rotor behind an observer: with the gains of the light one its speed swings, and nothing is measured.
    /// With a quarter of them it is, and the board has its own again.
    void aLoopThatSwingsIsCalmedToBeMeasured()
    {
        simulation::BoardOptions options;
        options.plant = *simulation::findPreset("ipm48");
        options.plant->motor.inertia_kgm2 *= 4.0;
        options.plant->inverter.supplyAbsorbs = true;
        LabBench bench(options);
        const Gains told = gainsOf(bench);
        const auto swinging = respond(bench);
        QVERIFY(!swinging);
        QVERIFY2(bench.runner->outcome().swings, swinging.error().c_str());
        // Its rotor turns on: without a sensor that is not seen, and a start would end in too much current.
        QVERIFY(bench.pair.board->truth(1).rpm > 1000.0);
        SpeedLoop loop;
        loop.proportional = told.proportional;
        loop.integral = told.integral;
        bench.experiment.plan = *calmer(responsePlanFor(bench.experiment.subject, {}), loop);
        bench.happenings.clear();
        const lab::Outcome calmed = bench.run();
        QVERIFY2(calmed.end == End::Complete, qPrintable(support::outcomeText(calmed)));
        const auto measured = evaluateResponse(bench.capture, bench.happenings);
        QVERIFY2(measured, measured ? "" : measured.error().c_str());
        QVERIFY2(bench.runner->outcome().reason.empty(), bench.runner->outcome().reason.c_str());
        const double digit = digitsOf(bench).proportional;
        const int calm = told.proportional / 4; // in whole digits
        QVERIFY(std::abs(measured->regulator.proportional / digit - calm) < 1e-6);
        const Gains after = gainsOf(bench);
        QCOMPARE(after.proportional, told.proportional);
        QCOMPARE(after.integral, told.integral);
        // The gains of a motor that turns are not written.
        QVERIFY(bench.runUntil([&] { return std::abs(bench.pair.board->truth(1).rpm) < 1.0; }));
        QVERIFY(bench.pair.submit(drive::Command{drive::MotorAction::Start, 1}) != 0);
        QVERIFY(bench.pair.runUntil(
            [&] { return bench.pair.board->truth(1).state == simulation::MotorState::Run; }, 20s));
        ResponsePlan plan = responsePlanFor(bench.experiment.subject, {});
        plan.kp = 100;
        plan.ki = 10;
        bench.experiment.plan = plan;
        const lab::Outcome outcome = bench.run();
        QVERIFY(outcome.end == End::Refused);
        QVERIFY2(outcome.reason.find("stop it first") != std::string::npos, outcome.reason.c_str());
    }

    /// An integral gain alone turns the phase by two quarters: no number of such a loop means anything.
    void aLoopThatWouldSwingEverMoreIsCalledSo()
    {
        LabBench bench(boardWith(QStringLiteral("servo24")));
        const Gains told = gainsOf(bench);
        const GainDigits digits = digitsOf(bench);
        const auto measured = respond(bench);
        QVERIFY2(measured, measured ? "" : measured.error().c_str());
        const auto forecaster = forecasterOf(*measured, digits);
        QVERIFY(forecaster);
        QVERIFY((*forecaster)(told.proportional, told.integral).stable);
        QVERIFY(!(*forecaster)(0, 7000).stable);
    }

    /// Its crossover is beyond the band, where nothing is known of its phase.
    void aLoopWhoseGainNeverFallsBelow1IsCalledUnstable()
    {
        const auto forecaster = forecasterOf(respondingAs(kQuick_rpmPerAs, 1.0), kDigits);
        QVERIFY(forecaster);
        const LoopForecast usual = (*forecaster)(67, 0);
        QVERIFY(usual.stable && std::abs(usual.crossover_hz - 6.7) < 0.3);
        const LoopForecast beyond = (*forecaster)(kDigits.most, 0);
        QCOMPARE(beyond.crossover_hz, 0.0);
        QVERIFY(!beyond.stable);
        QVERIFY((*forecaster)(0, 0).stable); // it does nothing
    }

    /// 3 digits of the proportional gain alone hold a motor with friction at two thirds of what is asked for.
    void aStepThatDoesNotComeNearHasNoRise()
    {
        const auto forecaster = forecasterOf(respondingAs(kQuick_rpmPerAs, 1.0), kDigits);
        QVERIFY(forecaster);
        const LoopForecast slow = (*forecaster)(3, 0);
        QVERIFY2(slow.stable && std::abs(slow.crossover_hz - 0.25) < 0.05,
            qPrintable(QString::number(slow.crossover_hz)));
        QVERIFY(!slow.rise_s);
        const LoopForecast usual = (*forecaster)(67, 0);
        QVERIFY(usual.rise_s && *usual.rise_s > 0.03 && *usual.rise_s < 0.08);
    }

    void gainsGetOnlySoSmall()
    {
        SpeedLoop loop;
        loop.proportional = 400;
        loop.integral = 50;
        const auto first = calmer({}, loop);
        QVERIFY(first);
        QCOMPARE(first->kp, 100);
        QCOMPARE(first->ki, 12);
        const auto second = calmer(*first, loop);
        QVERIFY(second);
        QCOMPARE(second->kp, 25);
        QVERIFY(!calmer(*second, loop));
    }

    void aLoopKeepsItsPromiseOrIsTooLivelyOrTooSlow()
    {
        const Promise promise{1.7, 10.0, 20.0};
        const Estimate overshoot{20.0, 18.0, 22.0};
        const auto keeps = [&](const FrequencyResponse &proof) {
            return keptBy(proof, overshoot, promise);
        };
        const auto measured = [](double ms, double crossover_hz, double half) {
            FrequencyResponse proof;
            proof.ms = Estimate{ms, ms, ms};
            proof.crossover_hz = Estimate{crossover_hz, crossover_hz - half, crossover_hz + half};
            return proof;
        };
        QCOMPARE(keeps(measured(1.86, 9.0, 0.5)), Kept::Yes);
        QCOMPARE(keeps(measured(1.88, 9.0, 0.5)), Kept::TooLively);
        QCOMPARE(keeps(measured(1.5, 7.0, 0.5)), Kept::TooSlow);
        QCOMPARE(keeps(measured(1.5, 7.0, 1.5)), Kept::Yes); // it may be 8 Hz
        // The nearer danger is told.
        QCOMPARE(keeps(measured(2.0, 7.0, 0.5)), Kept::TooLively);
        FrequencyResponse proof = measured(1.5, 9.0, 0.5);
        proof.crossover_hz.reset();
        QCOMPARE(keeps(proof), Kept::Unclear);
        proof.ms = Estimate{1.9, 1.9, 1.9};
        QCOMPARE(keeps(proof), Kept::TooLively);
        QCOMPARE(keeps(FrequencyResponse()), Kept::Unclear);
    }

    void aLoopWhoseStepsOvershootByMoreThanPredictedMissesItsPromise()
    {
        const Promise promise{1.7, 10.0, 20.0};
        FrequencyResponse proof;
        proof.ms = Estimate{1.6, 1.6, 1.6};
        proof.crossover_hz = Estimate{10.0, 9.5, 10.5};
        const auto with = [&](const std::optional<Estimate> &overshoot_pct) {
            return keptBy(proof, overshoot_pct, promise);
        };
        QCOMPARE(with(Estimate{29.0, 27.0, 31.0}), Kept::Yes); // it may be 27 %
        QCOMPARE(with(Estimate{31.0, 29.0, 33.0}), Kept::Overshoots);
        QVERIFY(missed(Kept::Overshoots) && !missed(Kept::Unclear));
        QCOMPARE(with(Estimate{29.0, {}, {}}), Kept::Overshoots); // a single step
        QCOMPARE(with(Estimate{10.0, 8.0, 12.0}), Kept::Yes); // less is no harm
        QCOMPARE(with(std::nullopt), Kept::Unclear);
        proof.crossover_hz = Estimate{7.0, 6.5, 7.5};
        QCOMPARE(with(std::nullopt), Kept::TooSlow);
    }

    /// The nearer to instability, the greater the integral gain.
    void quickerGoalsAreNearer()
    {
        LabBench bench;
        const GainDigits digits = digitsOf(bench);
        const auto measured = respond(bench);
        QVERIFY(measured);
        const auto proposed = proposeGains(*measured, digits, 7.0);
        QVERIFY(proposed);
        QCOMPARE(proposed->size(), kGoals.size());
        for (std::size_t i = 1; i < proposed->size(); ++i) {
            QVERIFY((*proposed)[i].integral > (*proposed)[i - 1].integral);
            QVERIFY((*proposed)[i].ms > (*proposed)[i - 1].ms);
            QVERIFY((*proposed)[i].rise_s < (*proposed)[i - 1].rise_s);
        }
        // Worse points keep a wider distance.
        SpeedResponse unsure = *measured;
        for (ResponsePoint &point : unsure.points)
            point.loopRelative *= 5.0;
        const auto careful = proposeGains(unsure, digits, 7.0);
        QVERIFY(careful);
        QVERIFY(careful->back().integral < proposed->back().integral);
        // Noise bounds the proportional gain.
        SpeedResponse noisy = *measured;
        noisy.referenceNoise_a = 0.7;
        const auto quiet = proposeGains(noisy, digits, 7.0);
        QVERIFY(quiet);
        QVERIFY(quiet->front().proportional < proposed->front().proportional);
    }

    void whatIsNotKnownIsSaid()
    {
        LabBench bench;
        const GainDigits digits = digitsOf(bench);
        SpeedResponse measured;
        QVERIFY(!proposeGains(measured, digits, 7.0));
        measured.regulator = {0.01, 1e-4, 1e-3};
        const auto few = proposeGains(measured, digits, 7.0);
        QVERIFY(!few && few.error().find("too few") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestTuning)
#include "tst_tuning.moc"
