// Gains from the measured response of simulated motors: that their loops keep the distance that was promised, and step as
// predicted, whatever gains the board began with.
#include "lab/tuning.h"
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
    return bench.pair.runUntilEnded(bench.pair.submit(
        drive::Write{{{registers.gain, std::int64_t{gains.proportional}},
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
        const auto proposed = proposeGains(
            *measured, digits, before.experiment.subject.limits.nominalCurrentAmps);
        QVERIFY2(proposed, proposed ? "" : proposed.error().c_str());
        for (const GainCandidate &one : *proposed)
            qDebug("%s: Kp %d (%d) Ki %d (%d), %.1f Hz, PM %.1f, Ms %.2f, rise %.1f ms, over %.1f %%, noise %.3f", nameOf(one.goal), one.proportional, told.proportional, one.integral, told.integral, one.crossover_hz, one.phaseMargin_deg, one.ms, one.rise_s*1e3, one.overshoot_pct, measured->referenceNoise_a);
        for (const GainCandidate &one : *proposed) {
        LabBench after(boardOf(motor));
        QVERIFY(write(after, {one.proportional, one.integral}));
        const auto proof = respond(after);
        QVERIFY2(proof, proof ? "" : proof.error().c_str());
        LabBench stepped(boardOf(motor));
        QVERIFY(write(stepped, {one.proportional, one.integral}));
        const int from = responsePlanFor(stepped.experiment.subject, {}).rpm;
        stepped.steps = {.fromRpm = from, .toRpm = from + 500, .repeat = 3, .hold = 1000ms};
        stepped.experiment.plan = stepped.steps;
        const Outcome o = stepped.run();
        const auto series = stepped.series();
        qDebug("   %s got: %.1f Hz PM %.1f Ms %.2f; step %s over %.1f rise %.1f", nameOf(one.goal), proof->crossover_hz.value_or(0), proof->phaseMargin_deg.value_or(0), proof->ms.value_or(0), o.reason.c_str(), series && series->overshoot_pct ? series->overshoot_pct->value : -1, series && series->rise_s ? series->rise_s->value*1e3 : -1);
        }
    }
};

QTEST_APPLESS_MAIN(TestTuning)
#include "tst_tuning.moc"
