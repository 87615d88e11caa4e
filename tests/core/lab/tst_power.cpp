// Power and efficiency of a motor at a speed: of made-up samples, whose numbers follow by hand, and of simulated
// motors, whose ledger is known: at a speed that is held the air gap gives what friction, fan and brake take.
#include "core/lab/lost_samples.h"
#include "lab/caps.h"
#include "lab/evaluation/finding.h"
#include "simulation/plant/presets.h"
#include "support/lab_bench.h"

#include <array>
#include <numbers>

using namespace lab;
using support::LabBench;

namespace {

std::optional<Estimate> figureOf(const Power &found, std::string_view key)
{
    for (const Figure &figure : figuresOf(found))
        if (figure.key == key)
            return figure.value;
    return std::nullopt;
}

/// Empty: it is within so many percent, between its ends.
QString missOf(const Power &found, const char *key, double truth, double percent)
{
    const auto figure = figureOf(found, key);
    if (!figure)
        return QStringLiteral("%1 is not told").arg(QLatin1String(key));
    const double off = (figure->value / truth - 1.0) * 100.0;
    const bool between = *figure->low <= figure->value && figure->value <= *figure->high;
    return std::abs(off) <= percent && between
        ? QString()
        : QStringLiteral("%1 is %2, %3 % off").arg(QLatin1String(key)).arg(figure->value).arg(off);
}

#define VERIFY_FIGURE(found, key, truth, percent)                                                  \
    do {                                                                                           \
        const QString miss = missOf(found, key, truth, percent);                                   \
        QVERIFY2(miss.isEmpty(), qPrintable(miss));                                                \
    } while (false)

/// Four seconds at 100 electrical turns a second, from 1 s on at a speed that is held; four pole pairs.
struct MadeUp {
    double ampsQ = 2.0, ampsD = -0.5, voltsQ = 5.0, voltsD = -1.0;
    double wave_a = 0.0; ///< of Iq, above and below by turns of a quarter of a second
    PowerPlan plan = {};
    bool ends = true;
    std::string sensor = "ENCODER_EL_ANGLE";

    Result<Finding, std::string> found() const
    {
        constexpr int kTicks = 32000, kQuarter = 2000;
        capture::Capture capture;
        capture::StreamLayout layout;
        layout.id = 1;
        layout.tickHz = 8000.0;
        layout.fast = {{1, sensor, "deg", 360.0 / 65536.0}, {2, "I_Q_MEAS", "A", 1e-3},
            {3, "I_D_MEAS", "A", 1e-3}, {4, "V_Q", "V", 1e-3}, {5, "V_D", "V", 1e-3}};
        capture.begin(layout);
        capture::SampleBlock block;
        block.stream = 1;
        block.count = kTicks;
        const auto add = [&block](double digits) {
            block.fast.push_back(static_cast<std::int16_t>(std::int64_t(std::lround(digits))));
        };
        for (int tick = 0; tick < kTicks; ++tick)
            add(double((tick * 65536LL / 80 + 32768) % 65536 - 32768));
        for (int tick = 0; tick < kTicks; ++tick)
            add((ampsQ + (tick / kQuarter % 2 == 0 ? wave_a : -wave_a)) * 1e3);
        for (const double steady : {ampsD, voltsQ, voltsD})
            for (int tick = 0; tick < kTicks; ++tick)
                add(steady * 1e3);
        capture.append(block);

        recorded::Happening entry{PowerPlan::kEntry,
            {{"motor", "1"}, {"pole pairs", "4"}, {"torque Nm per A", "0.05"},
                {"Lq less Ld H", "0.001"}, {"current", "I_Q_MEAS"}, {"current d", "I_D_MEAS"},
                {"voltage", "V_Q"}, {"voltage d", "V_D"}, {"angle", sensor}}};
        putFields(entry, plan);
        constexpr Nanos kSecond = 1'000'000'000;
        const auto ramp = [](const char *ms) {
            return recorded::Happening{"speed ramp", {{"motor", "1"}, {"rpm", "1500"}, {"ms", ms}}};
        };
        Happenings all{{0, entry}, {kSecond / 2, ramp("500")}, {kSecond, ramp("0")},
            {2 * kSecond, ramp("0")}, {3 * kSecond, {"command", {{"motor", "1"}}}}};
        if (ends)
            all.emplace_back(kSecond * 7 / 2, entryOfEnd({}));
        return findingIn(capture, all);
    }
    Power power() const
    {
        const auto it = found();
        return it ? std::get<Power>(*it) : Power{};
    }
};

/// A recording whose plan has another number there.
Happenings withField(Happenings all, std::string_view name, double factor)
{
    for (auto &[at, what] : all)
        for (auto &[key, value] : what.fields)
            if (what.name == PowerPlan::kEntry && key == name)
                value = decimalText(*numberOf(what, name) * factor);
    return all;
}

/// At rest and 25 degrees, with the switches.
double ohmsOf(const simulation::PlantParameters &plant)
{
    constexpr double kCopper = 0.00393, kWarmer_k = 5.0;
    return plant.motor.rs_ohm * (1.0 + kCopper * kWarmer_k) + plant.inverter.switchResistance_ohm;
}

/// Along a current that turns: 4 / pi of what dead times take of a phase.
double deadVoltsOf(const simulation::InverterParameters &inverter)
{
    constexpr double kPwm_hz = 16000.0;
    return 4.0 / std::numbers::pi * inverter.deadTime_s * kPwm_hz
        * (inverter.supply_v + 2.0 * inverter.diodeDrop_v);
}

} // namespace

class TestPower : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theNumbersOfSamplesFollowByHand()
    {
        MadeUp made;
        made.plan.rsOhm = 0.3;
        made.plan.deadVolts = 0.4;
        const Power found = made.power();
        QVERIFY(found.notes.empty());
        const double amps = std::sqrt(2.0 * 2.0 + 0.5 * 0.5), w = 2.0 * std::numbers::pi * 25.0;
        // 3/2 (5 V 2 A + 1 V 0.5 A) less dead times; 3/2 R i^2; 0.05 N m/A and 3/2 4 1 mH of 0.5 A against d.
        const double electrical = 1.5 * (10.0 + 0.5 - 0.4 * amps);
        const double shaft = (0.05 * 2.0 + 1.5 * 4.0 * 1e-3 * 0.5 * 2.0) * w;
        VERIFY_FIGURE(found, "speed_rpm", 1500.0, 0.01);
        VERIFY_FIGURE(found, "electrical_w", electrical, 0.01);
        VERIFY_FIGURE(found, "copper_w", 1.5 * 0.3 * amps * amps, 0.01);
        VERIFY_FIGURE(found, "shaft_w", shaft, 0.01);
        VERIFY_FIGURE(found, "efficiency", shaft / electrical, 0.01);
        std::vector<std::string> keys;
        for (const Figure &figure : figuresOf(found))
            keys.emplace_back(figure.key);
        QCOMPARE(keys,
            (std::vector<std::string>{
                "speed_rpm", "electrical_w", "copper_w", "shaft_w", "efficiency"}));
        QCOMPARE(std::string(Power::kKind), std::string("power"));
    }

    /// Eight blocks of a quarter of a second, the current 0.2 A above and below its mean by turns.
    void theIntervalIsOfItsBlocksAndItsScale()
    {
        MadeUp made;
        made.ampsD = 0.0;
        const Estimate steady = *figureOf(made.power(), "shaft_w");
        QVERIFY(std::abs((*steady.high - steady.value) / steady.value - 0.01) < 1e-4);
        made.wave_a = 0.2;
        const Estimate waves = *figureOf(made.power(), "shaft_w");
        // Sample deviation 0.1 sqrt(n / (n - 1)) of the mean; 2.365 and 2.447 standard errors of eight and of seven.
        const double half = (*waves.high - waves.value) / waves.value;
        QVERIFY2(half > 0.08 && half < 0.11, qPrintable(QString::number(half)));
        QVERIFY(std::abs((*waves.low + *waves.high) / 2.0 - waves.value) < 1e-9);
        made.wave_a = 0.0;
        made.sensor = "STOPLL_EL_ANGLE"; // which stands aside under a current
        const Estimate observed = *figureOf(made.power(), "shaft_w");
        QVERIFY(*observed.high - observed.value > 2.0 * (*steady.high - steady.value));
    }

    void whatIsNotKnownIsSaid()
    {
        MadeUp made;
        const std::vector<std::string> wanted{
            "resistance or dead time is not known: what it takes is not told"};
        QCOMPARE(made.power().notes, wanted);
        QVERIFY(!figureOf(made.power(), "copper_w"));
        QVERIFY(figureOf(made.power(), "efficiency"));
        made.plan.rsOhm = 0.3;
        QCOMPARE(made.power().notes, wanted);
        QVERIFY(figureOf(made.power(), "copper_w"));
        made.plan.deadVolts = 0.4;
        QVERIFY(made.power().notes.empty());
        made.ampsQ = -2.0; // the load drives it
        QVERIFY(!figureOf(made.power(), "efficiency"));
        QVERIFY(figureOf(made.power(), "shaft_w")->value < 0.0);
        made.ends = false;
        QCOMPARE(made.power().notes,
            std::vector<std::string>{"the recording ends before the experiment does"});
    }

    void aLoadedMotorGivesWhatItsLedgerSays_data()
    {
        QTest::addColumn<QString>("motor");
        for (const char *motor : {"servo24", "blower36", "pm24"})
            QTest::newRow(motor) << QString::fromLatin1(motor);
    }

    /// A brake of 0.3 of the nominal torque comes when it is nearly at its speed.
    void aLoadedMotorGivesWhatItsLedgerSays()
    {
        QFETCH(const QString, motor);
        simulation::PlantParameters truth = *simulation::findPreset(motor.toStdString());
        const double ampTorque = 1.5 * truth.motor.polePairs * truth.motor.flux_wb;
        const double nominal_nm = ampTorque * truth.motor.nominal_a, brake_nm = 0.3 * nominal_nm;
        simulation::BoardOptions options;
        options.motor = motor.toStdString();
        options.load = truth.load;
        LabBench bench(options);
        PowerPlan plan = powerPlanFor(bench.experiment.subject, {});
        plan.rsOhm = ohmsOf(truth);
        plan.deadVolts = deadVoltsOf(truth.inverter);
        bench.experiment.plan = plan;
        bool braked = false;
        double speeds = 0.0;
        int count = 0;
        bench.eachTurn = [&] {
            const double rpm = bench.pair.board->truth(1).rpm;
            if (!braked && rpm > 0.9 * plan.fromRpm) {
                braked = true;
                bench.pair.board->setLoadTorque(1, brake_nm);
            }
            const auto held = bench.asked<drive::SpeedRamp>();
            const bool measures = !held.empty() && held.back().duration == milliseconds(0);
            if (measures && bench.asked<drive::Command>().size() < 2) {
                speeds += rpm;
                ++count;
            }
        };
        const Outcome outcome = bench.run();
        QVERIFY2(outcome.end == End::Complete && outcome.reason.empty(),
            qPrintable(support::outcomeText(outcome)));
        std::vector<drive::SpeedRamp> ramps = bench.asked<drive::SpeedRamp>();
        QVERIFY(ramps.size() > 3);
        ramps.pop_back(); // what stood before
        for (const drive::SpeedRamp &ramp : ramps)
            QCOMPARE(ramp.rpm, plan.fromRpm);
        const auto found = findingIn(bench.capture, bench.happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        const Power &power = std::get<Power>(*found);
        QVERIFY(power.notes.empty());

        const double rpm = speeds / count, w = rpm * std::numbers::pi / 30.0;
        const double torque = (truth.motor.viscous_nms + truth.load.fan_nms2 * w) * w
            + truth.motor.coulomb_nm + brake_nm;
        QVERIFY(torque > 0.2 * nominal_nm);
        const double amps = torque / ampTorque, copper = 1.5 * plan.rsOhm * amps * amps;
        VERIFY_FIGURE(power, "speed_rpm", rpm, 0.5);
        VERIFY_FIGURE(power, "shaft_w", torque * w, 3.0);
        VERIFY_FIGURE(power, "copper_w", copper, 5.0);
        VERIFY_FIGURE(power, "electrical_w", torque * w + copper, 4.0);
        VERIFY_FIGURE(power, "efficiency", torque * w / (torque * w + copper), 4.0);
        // The bars tell a constant that is wrong.
        for (const auto &[field, key, is] : {std::tuple("torque Nm per A", "shaft_w", torque * w),
                 std::tuple("rs ohm", "copper_w", copper)}) {
            const auto other = findingIn(bench.capture, withField(bench.happenings, field, 1.1));
            QVERIFY(!missOf(std::get<Power>(*other), key, is, 5.0).isEmpty());
        }
    }

    void aGapIsSaidAndCostsNothingElse()
    {
        LabBench bench;
        PowerPlan plan = powerPlanFor(bench.experiment.subject, {});
        plan.rsOhm = 0.18;
        plan.deadVolts = 0.4;
        bench.experiment.plan = plan;
        const LostSamples lost(bench, milliseconds(5500), milliseconds(200));
        VERIFY_END(bench.run(), End::Complete);
        const auto found = findingIn(bench.capture, bench.happenings);
        QVERIFY2(found, found ? "" : found.error().c_str());
        QVERIFY(lost.saidIn(std::get<Power>(*found).notes));
        VERIFY_FIGURE(std::get<Power>(*found), "speed_rpm", plan.fromRpm, 0.5);
    }

    /// As with all that moves a motor by itself: within caps, and only what was agreed to.
    void itHasCapsAndIsAgreedTo()
    {
        const LabBench bench;
        const Subject &subject = bench.experiment.subject;
        PowerPlan plan = powerPlanFor(subject, {});
        const Experiment experiment{plan, subject};
        QCOMPARE(objectionTo(experiment), std::string());
        QCOMPARE(conditionsOf(experiment).length, milliseconds(5000));
        const Agreement agreed = agreementTo(experiment, 0.0);
        QCOMPARE(agreed.caps.mostRpm, 1.25 * plan.fromRpm);
        QVERIFY(agreed.caps.mostAmps > 0.0);
        QVERIFY(covers(agreed, agreed));
        const Experiment steps{static_cast<const StepPlan &>(plan), subject};
        QVERIFY(!covers(agreed, agreementTo(steps, 0.0)));
        PowerPlan other = plan;
        other.fromRpm = other.toRpm = plan.fromRpm + 60;
        QVERIFY(!covers(agreed, agreementTo({other, subject}, 0.0)));
        other = plan;
        other.hold = 2 * plan.hold;
        QVERIFY(!covers(agreed, agreementTo({other, subject}, 0.0)));
        other.fromRpm = other.toRpm = 0;
        QCOMPARE(objectionTo(Experiment{other, subject}), std::string("the motor has to turn"));
        other = plan;
        other.fromRpm = other.toRpm = 100'000;
        QVERIFY(!objectionTo(Experiment{other, subject}).empty());
        other = plan;
        other.hold = milliseconds(16'000);
        QCOMPARE(objectionTo(Experiment{other, subject}), std::string("it takes 1 to 30 s"));
        Subject without = subject;
        without.registers.voltageD = 0;
        QVERIFY(objectionTo(Experiment{plan, without}).starts_with("this board does not record"));
        without = subject;
        without.limits.torquePerAmp = 0.0;
        QVERIFY(objectionTo(Experiment{plan, without}).starts_with("the board does not tell"));
    }
};

QTEST_APPLESS_MAIN(TestPower)
#include "tst_power.moc"
