// gains: what the regulators need for a bandwidth and a damping, and how well their digits can say it.
#include "drive/motor_view.h"
#include "motor/gain_plan.h"
#include "motor_facts.h"
#include "write_report.h"

#include <QJsonArray>

#include <algorithm>

namespace cli {

namespace {

using motor::GainId;
using motor::GainPlan;
using motor::GainWarning;
using motor::PlannedGain;

/// A gain as this board names it.
struct Name {
    const char *name; ///< of the numerator; the exponent's ends in _DIV
    const char *unit;
};
constexpr motor::PerGain<Name> kNames{{{"I_Q_KP", "V/A"}, {"I_Q_KI", "V/(A s)"}, {"I_D_KP", "V/A"},
    {"I_D_KI", "V/(A s)"}, {"SPEED_KP", "A/(rad/s)"}, {"SPEED_KI", "A/rad"}}};

const Name &nameOf(GainId id) { return kNames[motor::indexOf(id)]; }
QString textOf(GainId id) { return QLatin1String(nameOf(id).name); }

using Present = std::map<std::string, Digits16>;

const Digits16 &numeratorOf(const Present &present, GainId id)
{
    return present.at(nameOf(id).name);
}
const Digits16 &exponentOf(const Present &present, GainId id)
{
    return present.at(std::string(nameOf(id).name) + "_DIV");
}

Outcome<bool> checkPresent(const Present &present, const GainPlan &plan)
{
    for (const PlannedGain &gain : plan.gains) {
        const std::string name = nameOf(gain.id).name;
        if (!present.contains(name) || !present.contains(name + "_DIV"))
            return failure(kRefused,
                QStringLiteral("This board does not give %1 and its divisor; its firmware is a "
                               "small one.")
                    .arg(textOf(gain.id)));
    }
    return true;
}

/// Why these gains must not be written.
QString sentenceOf(const GainPlan &plan, const motor::GainFinding &finding)
{
    switch (finding.warning) {
    case GainWarning::BandwidthBeyondLimit:
        return QStringLiteral("--bandwidth is beyond %1 rad/s, what the control rate allows.")
            .arg(finding.limit);
    case GainWarning::DoesNotFit:
    case GainWarning::RoundsToZero:
    case GainWarning::ProductTooLarge:
        return QStringLiteral("%1 would be %2 and has no place in 16 bits; choose another "
                              "bandwidth or damping.")
            .arg(textOf(*finding.gain), QString::number(plan.find(*finding.gain)->asked));
    default:
        return QStringLiteral("The board does not tell its motor's resistance and inductance or "
                              "its own scales; gains are computed from them.");
    }
}

const QString kPeriod = QStringLiteral("speed period"); ///< for which there is no option

/// What the speed loop was left alone for; empty if it was not.
QString missingOf(const GainPlan &plan)
{
    for (const motor::GainFinding &finding : plan.findings) {
        if (finding.warning == GainWarning::SpeedNeedsInertia)
            return QStringLiteral("inertia");
        if (finding.warning == GainWarning::SpeedNeedsFlux)
            return QStringLiteral("ke");
        if (finding.warning == GainWarning::SpeedNeedsPeriod)
            return kPeriod;
    }
    return {};
}

bool swapped(const GainPlan &plan)
{
    return std::any_of(plan.findings.begin(), plan.findings.end(),
        [](const auto &finding) { return finding.warning == GainWarning::LdAboveLq; });
}

/// What is worth knowing about gains that can be written; empty for what is said elsewhere.
QString noteOf(const motor::GainFinding &finding)
{
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    switch (finding.warning) {
    case GainWarning::BandwidthBeyondGuide:
        return QStringLiteral("%1 rad/s is beyond %2 rad/s, what this way of measuring currents "
                              "is advised for")
            .arg(number(finding.is), number(finding.limit));
    case GainWarning::CurrentMarginSmall:
        return QStringLiteral("the current loop's phase margin of %1 degrees is below %2")
            .arg(number(finding.is), number(finding.limit));
    case GainWarning::SpeedMarginSmall:
        return QStringLiteral("the speed loop's phase margin of %1 degrees is below %2")
            .arg(number(finding.is), number(finding.limit));
    case GainWarning::CoarseRounding:
        return QStringLiteral("%1 is rounded by %2 %")
            .arg(finding.gain ? textOf(*finding.gain) : QString(), number(100.0 * finding.is));
    case GainWarning::LdAboveLq:
        return QStringLiteral("the board says that Ld is above Lq; they may be swapped");
    default:
        return {};
    }
}

QStringList notesOf(const GainPlan &plan)
{
    QStringList notes;
    for (const motor::GainFinding &finding : plan.findings)
        if (const QString note = noteOf(finding); !note.isEmpty())
            notes.append(note);
    return notes;
}

motor::GainPlant plantOf(const drive::MotorFacts &facts, const TuningArguments &wanted)
{
    motor::GainPlant plant = drive::gainPlant(facts);
    if (wanted.ke_vrmsPerKrpm > 0.0)
        plant.motor.flux_wb = motor::fluxOfKe_wb(wanted.ke_vrmsPerKrpm, facts.motor.polePairs);
    if (wanted.inertia_kgm2 > 0.0)
        plant.inertia_kgm2 = wanted.inertia_kgm2;
    if (wanted.speedDelay_s)
        plant.speedDelay_s = *wanted.speedDelay_s;
    return plant;
}

Outcome<GainPlan> planOf(
    const TuningArguments &wanted, const drive::MotorFacts &facts, const Present &present)
{
    motor::PerGain<std::optional<int>> divisors;
    for (std::size_t i = 0; i < divisors.size(); ++i)
        if (const auto found = present.find(std::string(kNames[i].name) + "_DIV");
            found != present.end())
            divisors[i] = static_cast<int>(found->second.value);
    GainPlan plan = motor::planGains(
        plantOf(facts, wanted), {wanted.bandwidth_radps, wanted.damping}, divisors);
    if (const auto complete = checkPresent(present, plan); !complete)
        return tl::make_unexpected(complete.error());
    if (plan.blocked())
        return failure(kRefused, sentenceOf(plan, plan.findings.front()));
    return plan;
}

void printJson(
    Output &out, const GainPlan &plan, const Present &present, const TuningArguments &wanted)
{
    QJsonArray list;
    for (const PlannedGain &gain : plan.gains)
        list.append(QJsonObject{{QStringLiteral("name"), textOf(gain.id)},
            {QStringLiteral("gain"), gain.asked}, {QStringLiteral("real_gain"), gain.real},
            {QStringLiteral("unit"), QLatin1String(nameOf(gain.id).unit)},
            {QStringLiteral("numerator"), gain.quantised.gain.numerator},
            {QStringLiteral("exponent"), gain.quantised.gain.exponent},
            {QStringLiteral("error"), gain.quantised.error},
            {QStringLiteral("numerator_margin"), gain.quantised.numeratorMargin},
            {QStringLiteral("product_margin"), gain.quantised.productMargin},
            {QStringLiteral("old_numerator"),
                static_cast<qint64>(numeratorOf(present, gain.id).value)},
            {QStringLiteral("old_exponent"),
                static_cast<qint64>(exponentOf(present, gain.id).value)}});
    const auto speed = [&plan](auto member) {
        return orNull(plan.speed ? std::optional(member(*plan.speed)) : std::nullopt);
    };
    const QString missing = missingOf(plan);
    out.line(QJsonObject{{QStringLiteral("bandwidth_radps"), wanted.bandwidth_radps},
        {QStringLiteral("real_bandwidth_radps"), plan.current->realBandwidth_radps},
        {QStringLiteral("phase_margin_deg"), plan.current->phaseMargin_deg},
        {QStringLiteral("rise_s"), plan.current->step.rise_s},
        {QStringLiteral("overshoot"), plan.current->step.overshoot},
        {QStringLiteral("late_overshoot"), plan.current->lateOvershoot},
        {QStringLiteral("speed_phase_margin_deg"),
            speed([](const auto &loop) { return loop.margin.phase_deg; })},
        {QStringLiteral("speed_rise_s"), speed([](const auto &loop) { return loop.step.rise_s; })},
        {QStringLiteral("speed_overshoot"),
            speed([](const auto &loop) { return loop.step.overshoot; })},
        {QStringLiteral("speed_lag_s"), speed([](const auto &loop) { return loop.lag_s; })},
        {QStringLiteral("speed_missing"), missing.isEmpty() ? QJsonValue() : QJsonValue(missing)},
        {QStringLiteral("ld_above_lq"), swapped(plan)},
        {QStringLiteral("warnings"), QJsonArray::fromStringList(notesOf(plan))},
        {QStringLiteral("gains"), list}});
}

void printText(Output &out, const GainPlan &plan, const Present &present)
{
    const auto number = [](double value) { return QString::number(value, 'g', 4); };
    for (const PlannedGain &gain : plan.gains)
        out.line(QStringLiteral("%1 %2 %3 = %4 / 2^%5 (was %6 / 2^%7), rounding %8 %")
                     .arg(textOf(gain.id).leftJustified(8), number(gain.asked),
                         QLatin1String(nameOf(gain.id).unit),
                         QString::number(gain.quantised.gain.numerator),
                         QString::number(gain.quantised.gain.exponent),
                         QString::number(numeratorOf(present, gain.id).value),
                         QString::number(exponentOf(present, gain.id).value),
                         number(100.0 * gain.quantised.error)));
    out.line(
        QStringLiteral("Current loop: %1 rad/s at the motor, rise %2 ms, overshoot %3 %, "
                       "phase margin %4 degrees")
            .arg(number(plan.current->realBandwidth_radps), number(1e3 * plan.current->step.rise_s),
                number(100.0 * plan.current->step.overshoot),
                number(plan.current->phaseMargin_deg)));
    if (plan.speed)
        out.line(
            QStringLiteral("Speed loop: phase margin %1 degrees, rise %2 ms, overshoot of a "
                           "step %3 %, with a lag of %4 ms")
                .arg(number(plan.speed->margin.phase_deg), number(1e3 * plan.speed->step.rise_s),
                    number(100.0 * plan.speed->step.overshoot), number(1e3 * plan.speed->lag_s)));
    if (const QString missing = missingOf(plan); !missing.isEmpty())
        out.line(missing == kPeriod
                ? QStringLiteral("Note: the speed loop stays as it is: the board does not tell the "
                                 "rate of its speed loop.")
                : QStringLiteral("Note: the speed loop stays as it is; say its --%1.")
                      .arg(missing));
    for (const QString &note : notesOf(plan))
        out.line(QStringLiteral("Note: %1.").arg(note));
}

drive::Write writeOf(const GainPlan &plan, const Present &present)
{
    drive::Write write;
    write.reach = drive::Reach::Parameters;
    const auto put = [&write](const Digits16 &old, std::int64_t value) {
        if (old.value != value)
            write.writes.push_back({old.id, value});
    };
    for (const PlannedGain &gain : plan.gains) {
        put(numeratorOf(present, gain.id), gain.quantised.gain.numerator);
        put(exponentOf(present, gain.id), gain.quantised.gain.exponent);
    }
    return write;
}

Outcome<int> runGains(Desk &desk)
{
    const auto facts = readMotorFacts(desk);
    if (!facts)
        return tl::make_unexpected(facts.error());
    std::vector<std::string> names;
    for (const Name &gain : kNames) {
        names.emplace_back(gain.name);
        names.push_back(std::string(gain.name) + "_DIV");
    }
    const auto present = readDigits(desk, names);
    if (!present)
        return tl::make_unexpected(present.error());
    const TuningArguments &wanted = desk.arguments.tuning;
    const auto plan = planOf(wanted, *facts, *present);
    if (!plan)
        return tl::make_unexpected(plan.error());
    if (!wanted.apply || !desk.out.json()) {
        if (desk.out.json())
            printJson(desk.out, *plan, *present, wanted);
        else
            printText(desk.out, *plan, *present);
    }
    if (!wanted.apply)
        return kDone;
    const drive::Write write = writeOf(*plan, *present);
    if (!write.writes.empty())
        return writeAndReport(desk, write, Digits::Shown, QStringLiteral("The writing"));
    if (desk.out.json())
        desk.out.line(QJsonArray());
    return kDone;
}

constexpr OptionText kGainsOptions[] = {
    {"bandwidth", "W", "Of the current loop, in rad/s."},
    {"damping", "D", "Of the speed loop: 2 is quick, 4 is calm. Left out: it stays."},
    {"inertia", "J", "Of rotor and load in kg m2; few boards know it."},
    {"ke", "K", "V rms per 1000 rpm, if the board's own is wrong."},
    {"delay", "MS",
        "Of the measured speed in ms. Left out: half the average that ST's generator takes for the "
        "board's sensor."},
    {"apply", "", "Writes them and reads them back."},
};

Outcome<double> positive(const Given &given, const char *option, double least)
{
    if (!given.has(option))
        return 0.0;
    const QString text = given.value(option);
    const auto number = plainNumber(text);
    if (number && *number > least && *number < 1e9)
        return *number;
    return usage(
        QStringLiteral("--%1 must be a number above %2 and below 1e9, with a point, not \"%3\".")
            .arg(QLatin1String(option), QString::number(least), text));
}

Outcome<bool> readGains(const Given &given, Arguments &all)
{
    TuningArguments &arguments = all.tuning;
    using Row = std::tuple<const char *, double TuningArguments::*, double>;
    for (const auto &[option, member, least] :
        {Row{"bandwidth", &TuningArguments::bandwidth_radps, 0.0},
            Row{"damping", &TuningArguments::damping, 1.0},
            Row{"inertia", &TuningArguments::inertia_kgm2, 0.0},
            Row{"ke", &TuningArguments::ke_vrmsPerKrpm, 0.0}}) {
        const auto number = positive(given, option, least);
        if (!number)
            return tl::make_unexpected(number.error());
        arguments.*member = *number;
    }
    if (given.has("delay")) {
        constexpr double kLongest_ms = 1000.0;
        const auto delay_ms = plainNumber(given.value("delay"));
        if (!delay_ms || *delay_ms < 0.0 || *delay_ms > kLongest_ms)
            return usage(QStringLiteral(
                "--delay must be a number of milliseconds from 0 to 1000, not \"%1\".")
                             .arg(given.value("delay")));
        arguments.speedDelay_s = *delay_ms / 1e3;
    }
    if (arguments.bandwidth_radps == 0.0)
        return usage(
            QStringLiteral("Say how fast the current loop is to be with --bandwidth W in rad/s, "
                           "such as 1500."));
    arguments.apply = given.has("apply");
    return true;
}

} // namespace

const Command kGains{.name = "gains",
    .words = "--bandwidth W",
    .help =
        "Computes gains of the current and speed loops from the motor's values, and applies them.",
    .options = kGainsOptions,
    .read = readGains,
    .ofOneMotor = true,
    .run = runGains};

} // namespace cli
