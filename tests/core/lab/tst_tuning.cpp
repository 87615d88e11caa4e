// Gains from the measured response of simulated motors: that their loops keep the distance that was promised, and step as
// predicted, whatever gains the board began with.
#include "lab/evaluation/tuning.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

using namespace lab;
using namespace std::chrono_literals;
using support::LabBench;

namespace {

struct Gains {
    int proportional = 0, integral = 0; ///< digits
};

Gains gainsOf(LabBench &bench)
{
    const Registers &registers = bench.experiment.subject.registers;
    return {int(bench.number(registers.gain)), int(bench.number(registers.integral))};
}

bool write(LabBench &bench, const Gains &gains)
{
    const Registers &registers = bench.experiment.subject.registers;
    return bench.pair.runUntilEnded(
        bench.pair.submit(drive::Write{{{registers.gain, std::int64_t{gains.proportional}},
                                           {registers.integral, std::int64_t{gains.integral}}},
            drive::Reach::Parameters}));
}

GainDigits digitsOf(LabBench &bench)
{
    const Subject &subject = bench.experiment.subject;
    const Registers &registers = subject.registers;
    return {jumpPerRpm(subject, 1.0, bench.number(registers.gainExponent)),
        jumpPerRpm(subject, 1.0, bench.number(registers.integralExponent))};
}

Result<SpeedResponse, std::string> respond(LabBench &bench)
{
    bench.experiment.plan = responsePlanFor(bench.experiment.subject, {});
    const Outcome outcome = bench.run();
    if (outcome.end != End::Complete)
        return fail(outcome.reason);
    return evaluateResponse(bench.capture, bench.happenings);
}

simulation::BoardOptions boardOf(const QString &motor)
{
    simulation::BoardOptions options;
    options.motor = motor.toStdString();
    options.load = simulation::findPreset(options.motor)->load;
    return options;
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
        LabBench before(boardOf(motor));
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

        LabBench after(boardOf(motor));
        QVERIFY(write(after, {medium->proportional, medium->integral}));
        const auto proof = respond(after);
        QVERIFY2(proof, proof ? "" : proof.error().c_str());
        // From a quarter of the gains of an observed motor little is seen of the frequencies where a quicker loop is nearest.
        const double tolerated = factor < 1.0 ? 1.2 : 1.1;
        QVERIFY2(proof->ms->value <= tolerated * distanceOf(Goal::Medium).ms,
            qPrintable(QString::number(proof->ms->value)));
        QVERIFY2(std::abs(proof->phaseMargin_deg->value - medium->phaseMargin_deg) < 5.0,
            qPrintable(QString::number(proof->phaseMargin_deg->value)));
        QVERIFY2(std::abs(proof->crossover_hz->value / medium->crossover_hz - 1.0) < 0.1,
            qPrintable(QString::number(proof->crossover_hz->value)));
    }

    void aLoopKeepsItsPromiseOrIsTooLivelyOrTooSlow()
    {
        const Promise promise{1.7, 10.0};
        const auto measured = [](double ms, double crossover_hz, double half) {
            FrequencyResponse proof;
            proof.ms = Estimate{ms, ms, ms};
            proof.crossover_hz = Estimate{crossover_hz, crossover_hz - half, crossover_hz + half};
            return proof;
        };
        QCOMPARE(keptBy(measured(1.86, 9.0, 0.5), promise), Kept::Yes);
        QCOMPARE(keptBy(measured(1.88, 9.0, 0.5), promise), Kept::TooLively);
        QCOMPARE(keptBy(measured(1.5, 7.0, 0.5), promise), Kept::TooSlow);
        QCOMPARE(keptBy(measured(1.5, 7.0, 1.5), promise), Kept::Yes); // it may be 8 Hz
        QCOMPARE(
            keptBy(measured(2.0, 7.0, 0.5), promise), Kept::TooLively); // the nearer danger is told
        FrequencyResponse proof = measured(1.5, 9.0, 0.5);
        proof.crossover_hz.reset();
        QCOMPARE(keptBy(proof, promise), Kept::Unclear);
        proof.ms = Estimate{1.9, 1.9, 1.9};
        QCOMPARE(keptBy(proof, promise), Kept::TooLively);
        QCOMPARE(keptBy(FrequencyResponse(), promise), Kept::Unclear);
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
            point.relative *= 5.0;
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
