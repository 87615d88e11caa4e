#include "widgets/runs/texts.h"

#include "widgets/base/device_text.h"
#include "widgets/base/si_text.h"
#include "widgets/base/value_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace widgets {
namespace {

struct RunText {
    Q_DECLARE_TR_FUNCTIONS(RunText)
};

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
const QString kDash(QChar(0x2013));

QString field(const session::Run &run, const char *name)
{
    for (const auto &[key, value] : run.plan)
        if (key == QLatin1String(name))
            return deviceText(value);
    return kDash;
}

/// A number, or the value of {"value","low","high"}.
double numberIn(const QJsonObject &object, const char *name)
{
    const QJsonValue value = object[QLatin1String(name)];
    return value.isObject() ? value.toObject()[QLatin1String("value")].toDouble(kNone)
                            : value.toDouble(kNone);
}

QString shown(double value, int decimals)
{
    return std::isfinite(value) ? numberText(value, decimals) : kDash;
}

QString endText(const session::Run &run)
{
    if (run.end == QLatin1String("complete"))
        return {};
    const QString why = deviceText(run.reason);
    if (run.end == QLatin1String("refused"))
        return RunText::tr("Not carried out: %1.").arg(why);
    if (run.end == QLatin1String("aborted"))
        return RunText::tr("Ended: %1.").arg(why);
    return RunText::tr("Interrupted: %1.").arg(why);
}

/// Empty where none is known: dashes alone tell nothing.
QString numbersText(const QJsonObject &result)
{
    const QString kind = result[QLatin1String("kind")].toString();
    const auto at = [&result](const char *name) { return numberIn(result, name); };
    const auto anyIn = [](const QJsonObject &object, std::initializer_list<const char *> names) {
        return std::any_of(names.begin(), names.end(),
            [&object](const char *name) { return std::isfinite(numberIn(object, name)); });
    };
    if (kind == QLatin1String("step")) {
        const QJsonObject mean = result[QLatin1String("mean")].toObject();
        if (!anyIn(mean, {"rise_s", "overshoot_pct", "settling_s"}))
            return {};
        return RunText::tr("rise %1 ms, overshoot %2 %, settling %3 ms")
            .arg(shown(numberIn(mean, "rise_s") * kMilli, 1),
                shown(numberIn(mean, "overshoot_pct"), 1),
                shown(numberIn(mean, "settling_s") * kMilli, 0));
    }
    if (kind == QLatin1String("mechanical"))
        return RunText::tr("J %1 kg m\u00b2, friction %2 and %3", "inertia, dry, viscous")
            .arg(QString::number(at("inertia_kgm2"), 'g', 4),
                siText(at("dry_nm"), QStringLiteral("N m")),
                siText(at("viscous_nms"), QStringLiteral("N m s")));
    if (kind == QLatin1String("electrical"))
        return RunText::tr("Rs %1, Ld %2, Lq %3, flux %4")
            .arg(siText(at("rs_ohm"), QStringLiteral("\u03a9")),
                siText(at("ld_h"), QStringLiteral("H")), siText(at("lq_h"), QStringLiteral("H")),
                siText(at("flux_wb"), QStringLiteral("Wb")));
    if (kind == QLatin1String("power"))
        return RunText::tr("electrical %1 W, shaft %2 W, efficiency %3")
            .arg(shown(at("electrical_w"), 1), shown(at("shaft_w"), 1), shown(at("efficiency"), 3));
    if (kind == QLatin1String("load"))
        return RunText::tr("load %1 A, gives way by %2 rpm, back in %3 ms")
            .arg(shown(at("load_a"), 2), shown(at("dip_rpm"), 0),
                shown(at("recovery_s") * kMilli, 0));
    if (kind == QLatin1String("response")
        && anyIn(result, {"crossover_hz", "phase_margin_deg", "ms"}))
        return RunText::tr("crossover %1 Hz, phase margin %2\u00b0, Ms %3")
            .arg(
                shown(at("crossover_hz"), 1), shown(at("phase_margin_deg"), 0), shown(at("ms"), 2));
    return {};
}

} // namespace

QString experimentText(const session::Run &run)
{
    const auto fromTo = [&run](const char *from, const char *to) {
        QString text = QStringLiteral("%1 \u2192 %2").arg(field(run, from), field(run, to));
        return text.replace(QLatin1Char('-'), QChar(0x2212));
    };
    if (run.experiment == QLatin1String("step plan"))
        return RunText::tr("Speed step %1 rpm", "from to").arg(fromTo("from rpm", "to rpm"));
    if (run.experiment == QLatin1String("current step plan"))
        return (field(run, "flux") == QLatin1String("1")
                ? RunText::tr("Flux step %1 A", "from to")
                : RunText::tr("Torque step %1 A", "from to"))
            .arg(fromTo("from A", "to A"));
    if (run.experiment == QLatin1String("spin plan"))
        return field(run, "flux A") == QLatin1String("0") ? RunText::tr("Mechanics")
                                                          : RunText::tr("Electrics, turning");
    if (run.experiment == QLatin1String("power plan"))
        return RunText::tr("Power at %1 rpm").arg(field(run, "rpm"));
    if (run.experiment == QLatin1String("load plan"))
        return RunText::tr("Load at %1 rpm").arg(field(run, "rpm"));
    if (run.experiment == QLatin1String("position plan"))
        return RunText::tr("Position step %1\u00b0").arg(field(run, "by deg"));
    if (run.experiment == QLatin1String("rest plan"))
        return RunText::tr("Electrics");
    if (run.experiment == QLatin1String("response plan"))
        return field(run, "current loop") == QLatin1String("0")
            ? RunText::tr("Response of the speed")
            : RunText::tr("Response of the current");
    if (run.experiment == QLatin1String(session::kStretch))
        return RunText::tr("%1, %2 to %3 s", "a recording, seconds")
            .arg(field(run, "recording"), field(run, "from s"), field(run, "to s"));
    return deviceText(run.experiment);
}

QString resultText(const session::Run &run)
{
    QStringList parts;
    if (const QString end = endText(run); !end.isEmpty())
        parts.append(end);
    if (const QString numbers = numbersText(run.result); !numbers.isEmpty())
        parts.append(numbers);
    else if (!run.notes.isEmpty() && parts.isEmpty())
        parts.append(deviceText(run.notes.first()));
    return parts.join(QLatin1Char(' '));
}

QString gainsText(const session::Run &run)
{
    if (field(run, "speed kp").toInt() > 0) // lent for as long as it was measured
        return QStringLiteral("%1 / %2").arg(numberText(field(run, "speed kp").toInt(), 0),
            numberText(field(run, "speed ki").toInt(), 0));
    const auto kp = run.gains.find(QStringLiteral("SPEED_KP")),
               ki = run.gains.find(QStringLiteral("SPEED_KI"));
    if (kp == run.gains.end() || ki == run.gains.end())
        return {};
    return QStringLiteral("%1 / %2").arg(numberText(*kp, 0), numberText(*ki, 0));
}

} // namespace widgets
