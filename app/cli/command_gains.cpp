// gains: what the regulators need for a bandwidth and a damping, and how well their digits can say it.
#include "analysis/fixed_point.h"
#include "analysis/speed_loop.h"
#include "motor_facts.h"
#include "write_report.h"

#include <QJsonArray>

namespace cli {

namespace {

using analysis::PiGains;
using analysis::Quantised;

struct Row {
    std::string name; ///< of the numerator
    double physical = 0.0;
    const char *unit = "";
    Quantised quantised;
    Digits16 numerator, exponent; ///< as they are on the board
};

struct Plan {
    std::vector<Row> rows;
    double realBandwidth_radps = 0.0;
    analysis::StepPrediction step;
    std::optional<double> margin_deg, overshoot; ///< of the speed loop
    QString missing; ///< what the speed loop was left alone for
};

using Present = std::map<std::string, Digits16>;

/// With the divisor that is there, if the gain fits it: fewer registers change, and ST's numbers come out.
std::optional<Row> rowOf(const Present &present, const std::string &name, double digits,
    double physical, const char *unit)
{
    const auto numerator = present.find(name), exponent = present.find(name + "_DIV");
    if (numerator == present.end() || exponent == present.end())
        return std::nullopt;
    Row row{name, physical, unit,
        analysis::quantise(digits, static_cast<int>(exponent->second.value)), numerator->second,
        exponent->second};
    if (row.quantised.problem != analysis::FixedPointProblem::None)
        row.quantised = analysis::quantiseFinely(digits);
    return row;
}

Outcome<bool> addLoop(Plan &plan, const Present &present, const std::string &loop,
    const PiGains &digits, const PiGains &physical, const char *const (&units)[2])
{
    const auto kp = rowOf(present, loop + "_KP", digits.kp, physical.kp, units[0]);
    const auto ki = rowOf(present, loop + "_KI", digits.ki, physical.ki, units[1]);
    for (const auto &row : {kp, ki}) {
        if (!row)
            return failure(kRefused,
                QStringLiteral(
                    "This board does not give the gains and divisors of %1; its firmware "
                    "is a small one.")
                    .arg(QString::fromStdString(loop)));
        if (row->quantised.problem != analysis::FixedPointProblem::None)
            return failure(kRefused,
                QStringLiteral("%1 would be %2 and has no place in 16 bits; choose another "
                               "bandwidth or damping.")
                    .arg(QString::fromStdString(row->name), QString::number(row->physical)));
        plan.rows.push_back(*row);
    }
    return true;
}

Outcome<bool> addSpeedLoop(Plan &plan, const Present &present, const TuningArguments &wanted,
    const drive::MotorFacts &facts)
{
    const double flux_wb = wanted.ke_vrmsPerKrpm > 0.0
        ? analysis::fluxOfKe_wb(wanted.ke_vrmsPerKrpm, facts.motor.polePairs)
        : facts.motor.flux_wb;
    const double kt = analysis::ktOfFlux_nmpa(flux_wb, facts.motor.polePairs);
    const double inertia = wanted.inertia_kgm2 > 0.0 ? wanted.inertia_kgm2 : facts.inertia_kgm2;
    if (!(inertia > 0.0) || !(kt > 0.0)) {
        plan.missing = inertia > 0.0 ? QStringLiteral("ke") : QStringLiteral("inertia");
        return true;
    }
    const double lag = analysis::speedLoopLag_s(
        plan.realBandwidth_radps, 0.0, facts.controlPeriod_s, facts.speedPeriod_s);
    const PiGains gains = analysis::speedGains({kt, inertia}, lag, wanted.damping);
    const PiGains digits =
        analysis::speedDigits(gains, 1.0 / facts.ampsPerDigit, facts.speedPeriod_s);
    plan.margin_deg = analysis::phaseMargin_deg(wanted.damping);
    plan.overshoot = analysis::stepOvershoot(wanted.damping);
    return addLoop(plan, present, "SPEED", digits, gains, {"A/(rad/s)", "A/rad"});
}

Outcome<Plan> planOf(
    const TuningArguments &wanted, const drive::MotorFacts &facts, const Present &present)
{
    const analysis::MotorParameters &motor = facts.motor;
    if (!(motor.rs_ohm > 0.0) || !(motor.lq_h > 0.0) || !(motor.ld_h > 0.0) || !(facts.bus_v > 0.0)
        || !(facts.ampsPerDigit > 0.0) || !(facts.controlPeriod_s > 0.0))
        return failure(kRefused,
            QStringLiteral(
                "The board does not tell its motor's resistance and inductance or its own "
                "scales; see rotorscope-cli get MOTOR_CONFIG."));
    const analysis::PowerStage stage{facts.bus_v, 1.0 / facts.ampsPerDigit, facts.controlPeriod_s};
    if (wanted.bandwidth_radps > analysis::bandwidthLimit_radps(1.0 / facts.controlPeriod_s))
        return failure(kRefused,
            QStringLiteral("--bandwidth is beyond %1 rad/s, what the control rate allows.")
                .arg(analysis::bandwidthLimit_radps(1.0 / facts.controlPeriod_s)));
    const analysis::CurrentPlant q{motor.rs_ohm, motor.lq_h}, d{motor.rs_ohm, motor.ld_h};
    Plan plan;
    const auto loop = [&](const char *name, const analysis::CurrentPlant &plant) {
        const PiGains gains = analysis::currentGains(plant, wanted.bandwidth_radps);
        return addLoop(
            plan, present, name, analysis::currentDigits(gains, stage), gains, {"V/A", "V/(A s)"});
    };
    if (const auto done = loop("I_Q", q); !done)
        return tl::make_unexpected(done.error());
    if (const auto done = loop("I_D", d); !done)
        return tl::make_unexpected(done.error());
    const PiGains kept{plan.rows[0].quantised.gain.value(), plan.rows[1].quantised.gain.value()};
    plan.realBandwidth_radps = analysis::realBandwidth_radps(kept.kp, q, stage);
    constexpr double kTimeConstants = 10.0;
    const double samples = kTimeConstants / (plan.realBandwidth_radps * facts.controlPeriod_s);
    plan.step = analysis::predictCurrentStep(kept, q, stage, static_cast<int>(samples) + 20);
    if (wanted.damping > 0.0)
        if (const auto done = addSpeedLoop(plan, present, wanted, facts); !done)
            return tl::make_unexpected(done.error());
    return plan;
}

QJsonValue orNull(const std::optional<double> &value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

void printJson(Output &out, const Plan &plan, const TuningArguments &wanted, bool swapped)
{
    QJsonArray list;
    for (const Row &row : plan.rows)
        list.append(QJsonObject{{QStringLiteral("name"), QString::fromStdString(row.name)},
            {QStringLiteral("gain"), row.physical},
            {QStringLiteral("unit"), QLatin1String(row.unit)},
            {QStringLiteral("numerator"), row.quantised.gain.numerator},
            {QStringLiteral("exponent"), row.quantised.gain.exponent},
            {QStringLiteral("error"), row.quantised.error},
            {QStringLiteral("numerator_margin"), row.quantised.numeratorMargin},
            {QStringLiteral("product_margin"), row.quantised.productMargin},
            {QStringLiteral("old_numerator"), static_cast<qint64>(row.numerator.value)},
            {QStringLiteral("old_exponent"), static_cast<qint64>(row.exponent.value)}});
    out.line(QJsonObject{{QStringLiteral("bandwidth_radps"), wanted.bandwidth_radps},
        {QStringLiteral("real_bandwidth_radps"), plan.realBandwidth_radps},
        {QStringLiteral("rise_s"), plan.step.rise_s},
        {QStringLiteral("overshoot"), plan.step.overshoot},
        {QStringLiteral("speed_phase_margin_deg"), orNull(plan.margin_deg)},
        {QStringLiteral("speed_overshoot"), orNull(plan.overshoot)},
        {QStringLiteral("speed_missing"),
            plan.missing.isEmpty() ? QJsonValue() : QJsonValue(plan.missing)},
        {QStringLiteral("ld_above_lq"), swapped}, {QStringLiteral("gains"), list}});
}

void printText(Output &out, const Plan &plan, bool swapped)
{
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    for (const Row &row : plan.rows)
        out.line(QStringLiteral("%1 %2 %3 = %4 / 2^%5 (was %6 / 2^%7), rounding %8 %")
                     .arg(QString::fromStdString(row.name).leftJustified(8), number(row.physical),
                         QLatin1String(row.unit), QString::number(row.quantised.gain.numerator),
                         QString::number(row.quantised.gain.exponent),
                         QString::number(row.numerator.value), QString::number(row.exponent.value),
                         number(100.0 * row.quantised.error)));
    out.line(QStringLiteral("Current loop: %1 rad/s at the motor, rise %2 ms, overshoot %3 %")
                 .arg(number(plan.realBandwidth_radps), number(1e3 * plan.step.rise_s),
                     number(100.0 * plan.step.overshoot)));
    if (plan.margin_deg)
        out.line(QStringLiteral("Speed loop: phase margin %1 degrees, overshoot of a step %2 %")
                     .arg(number(*plan.margin_deg), number(100.0 * *plan.overshoot)));
    if (!plan.missing.isEmpty())
        out.line(
            QStringLiteral("Note: the speed loop stays as it is; say its --%1.").arg(plan.missing));
    if (swapped)
        out.line(QStringLiteral("Note: the board says that Ld is above Lq; they may be swapped."));
}

drive::Write writeOf(const Plan &plan)
{
    drive::Write write;
    const auto put = [&write](const Digits16 &old, std::int64_t value) {
        if (old.value != value)
            write.writes.push_back({old.id, value});
    };
    for (const Row &row : plan.rows) {
        put(row.numerator, row.quantised.gain.numerator);
        put(row.exponent, row.quantised.gain.exponent);
    }
    return write;
}

} // namespace

Outcome<int> runGains(Desk &desk)
{
    const auto motor = desk.checkMotor();
    if (!motor)
        return motor;
    const auto facts = readMotorFacts(desk, *motor);
    if (!facts)
        return tl::make_unexpected(facts.error());
    std::vector<std::string> names;
    for (const char *loop : {"I_Q", "I_D", "SPEED"})
        for (const char *gain : {"_KP", "_KI", "_KP_DIV", "_KI_DIV"})
            names.push_back(std::string(loop) + gain);
    const auto present = readDigits(desk, names, *motor);
    if (!present)
        return tl::make_unexpected(present.error());
    const TuningArguments &wanted = desk.arguments.tuning;
    const auto plan = planOf(wanted, *facts, *present);
    if (!plan)
        return tl::make_unexpected(plan.error());
    const bool swapped = facts->motor.ld_h > 1.001 * facts->motor.lq_h;
    if (!wanted.apply || !desk.out.json()) {
        if (desk.out.json())
            printJson(desk.out, *plan, wanted, swapped);
        else
            printText(desk.out, *plan, swapped);
    }
    if (!wanted.apply)
        return kDone;
    const drive::Write write = writeOf(*plan);
    if (!write.writes.empty())
        return writeAndReport(desk, write, Digits::Shown, QStringLiteral("The writing"));
    if (desk.out.json())
        desk.out.line(QJsonArray());
    return kDone;
}

} // namespace cli
