#include "experiments/reports.h"

#include "json_text.h"
#include "lab/evaluation/current_response_evaluation.h"
#include "lab/evaluation/current_step_evaluation.h"
#include "lab/evaluation/electrical_evaluation.h"
#include "lab/evaluation/mechanical_evaluation.h"
#include "lab/evaluation/response_evaluation.h"
#include "lab/evaluation/step_series.h"

#include <array>
#include <cmath>
#include <numbers>

namespace cli {

namespace {

QString sentence(const std::string &words)
{
    QString text = QString::fromStdString(words);
    if (!text.isEmpty())
        text[0] = text[0].toUpper();
    return text + QLatin1Char('.');
}

void put(JsonText &json, std::string_view name, const std::optional<double> &value)
{
    json.member(name, value.value_or(std::nan("")));
}

void put(JsonText &json, std::string_view name, const std::optional<lab::Estimate> &estimate)
{
    json.beginObject(name);
    put(json, "value", estimate ? std::optional(estimate->value) : std::nullopt);
    put(json, "low", estimate ? estimate->low : std::nullopt);
    put(json, "high", estimate ? estimate->high : std::nullopt);
    json.endObject();
}

QByteArray jsonOf(const lab::MeasuredSteps &series)
{
    JsonText json;
    json.beginObject();
    json.member("kind", "step");
    json.beginArray("runs");
    for (const lab::StepRun &run : series.runs) {
        json.beginObject();
        json.member("direction", run.up ? "up" : "down");
        put(json, "rise_s", run.rise_s);
        put(json, "overshoot_pct", run.overshoot_pct);
        put(json, "settling_s", run.settling_s);
        put(json, "peak_iq_a", run.peakIq_a);
        put(json, "instant_error_s", std::optional(run.instantError_s));
        json.endObject();
    }
    json.endArray();
    json.beginObject("mean");
    put(json, "rise_s", series.rise_s);
    put(json, "overshoot_pct", series.overshoot_pct);
    put(json, "settling_s", series.settling_s);
    put(json, "peak_iq_a", series.peakIq_a);
    json.endObject();
    json.endObject();
    return json.text();
}

QString number(const std::optional<double> &value, double factor, int digits)
{
    return value ? QString::number(*value * factor, 'f', digits) : QStringLiteral("-");
}

QString row(const QString &name, const QStringList &cells)
{
    QString line = name.leftJustified(12);
    for (const QString &cell : cells)
        line += cell.rightJustified(20);
    return line;
}

QString meanText(const std::optional<lab::Estimate> &mean, double factor, int digits)
{
    if (!mean)
        return QStringLiteral("-");
    const QString value = number(mean->value, factor, digits);
    return mean->low
        ? value + QStringLiteral(" +- ") + number(mean->value - *mean->low, factor, digits)
        : value;
}

constexpr double kMilli = 1e3;

void print(const lab::MeasuredSteps &series, Output &out)
{
    out.line(row({},
        {QStringLiteral("rise ms"), QStringLiteral("overshoot %"), QStringLiteral("settling ms"),
            QStringLiteral("peak Iq A"), QStringLiteral("instant +- ms")}));
    int count = 0;
    for (const lab::StepRun &run : series.runs)
        out.line(row(
            QString::number(++count) + (run.up ? QStringLiteral(" up") : QStringLiteral(" down")),
            {number(run.rise_s, kMilli, 2), number(run.overshoot_pct, 1.0, 1),
                number(run.settling_s, kMilli, 1), number(run.peakIq_a, 1.0, 2),
                number(run.instantError_s, kMilli, 2)}));
    out.line(row(QStringLiteral("mean (95 %)"),
        {meanText(series.rise_s, kMilli, 2), meanText(series.overshoot_pct, 1.0, 1),
            meanText(series.settling_s, kMilli, 1), meanText(series.peakIq_a, 1.0, 2), {}}));
}

Outcome<int> report(const lab::MeasuredSteps &series, Output &out)
{
    if (out.json())
        out.json(jsonOf(series));
    else
        print(series, out);
    for (const std::string &note : series.notes)
        Output::error(sentence(note));
    if (series.rise_s)
        return kDone;
    return failure(
        kRefused, QStringLiteral("Not conclusive: no step of this series could be measured."));
}

const char *modelOf(const lab::Mechanics &found)
{
    return found.fan ? "viscous+dry+fan" : "viscous+dry";
}

QString line(const char *name, const lab::Estimate &estimate, const char *unit)
{
    constexpr int kDigits = 4;
    const auto text = [](double value) { return QString::number(value, 'g', kDigits); };
    return QStringLiteral("%1 %2 %3 (%4 to %5)")
        .arg(QString::fromLatin1(name).leftJustified(17), text(estimate.value),
            QString::fromUtf8(unit), text(estimate.low.value_or(0.0)),
            text(estimate.high.value_or(0.0)));
}

Outcome<int> report(const lab::Mechanics &found, Output &out)
{
    if (out.json()) {
        JsonText json;
        json.beginObject();
        json.member("kind", "mechanical");
        put(json, "inertia_kgm2", std::optional(found.inertia_kgm2));
        put(json, "viscous_nms", std::optional(found.viscous_nms));
        put(json, "dry_nm", std::optional(found.dry_nm));
        put(json, "fan_nms2", std::optional(found.fan_nms2));
        json.member("model", modelOf(found));
        json.endObject();
        out.json(json.text());
    } else {
        out.line(line("Inertia", found.inertia_kgm2, "kg m\u00b2"));
        out.line(line("Viscous friction", found.viscous_nms, "N m s"));
        out.line(line("Dry friction", found.dry_nm, "N m"));
        if (found.fan)
            out.line(line("Fan", found.fan_nms2, "N m s\u00b2"));
        constexpr double kPercent = 100.0;
        out.line(QStringLiteral("Model: %1; it leaves %2 % of the torque")
                     .arg(QLatin1String(modelOf(found)),
                         QString::number(found.share * kPercent, 'g', 2)));
    }
    for (const std::string &note : found.notes)
        Output::error(sentence(note));
    return kDone;
}

Outcome<int> report(const lab::Electrics &found, Output &out)
{
    struct Line {
        const char *key, *name, *unit;
        const std::optional<lab::Estimate> &estimate;
    };
    const std::array lines{Line{"rs_ohm", "Resistance", "\u03a9", found.rs_ohm},
        Line{"ld_h", "Inductance Ld", "H", found.ld_h},
        Line{"lq_h", "Inductance Lq", "H", found.lq_h},
        Line{"flux_wb", "Flux", "Wb", found.flux_wb},
        Line{"dead_time_v", "Dead time", "V", found.deadTime_v}};
    if (out.json()) {
        JsonText json;
        json.beginObject();
        json.member("kind", "electrical");
        for (const Line &one : lines)
            put(json, one.key, one.estimate);
        json.endObject();
        out.json(json.text());
    } else {
        for (const Line &one : lines)
            if (one.estimate)
                out.line(line(one.name, *one.estimate, one.unit));
    }
    for (const std::string &note : found.notes)
        Output::error(sentence(note));
    if (found.rs_ohm && found.ld_h)
        return kDone;
    return failure(kRefused, QStringLiteral("Not conclusive: not all of it could be measured."));
}

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// 95 % to either side.
double half(const lab::ResponsePoint &point)
{
    constexpr double kNormal = 1.96;
    return std::abs(point.plant) * std::min(1.0, kNormal * point.relative);
}

QByteArray jsonOf(const lab::FrequencyResponse &found)
{
    JsonText json;
    json.beginObject();
    json.member("kind", "response");
    json.beginArray("points");
    for (const lab::ResponsePoint &point : found.points) {
        if (!point.plantKnown)
            continue;
        const double gain = std::abs(point.plant);
        json.beginObject();
        json.member("hz", point.hz);
        json.member("gain", gain);
        json.member("gain_low", gain - half(point));
        json.member("gain_high", gain + half(point));
        json.member("phase_deg", std::arg(point.plant) * kDegrees);
        json.member("coherence", point.coherence);
        json.endObject();
    }
    json.endArray();
    put(json, "crossover_hz", found.crossover_hz);
    put(json, "phase_margin_deg", found.phaseMargin_deg);
    put(json, "ms", found.ms);
    json.endObject();
    return json.text();
}

void print(const lab::FrequencyResponse &found, const QString &unit, Output &out)
{
    out.line(row(QStringLiteral("Hz"),
        {unit, QStringLiteral("+- %"), QStringLiteral("degrees"), QStringLiteral("loop dB"),
            QStringLiteral("loop degrees"), QStringLiteral("coherence")}));
    constexpr double kPercent = 100.0, kDecibel = 20.0;
    for (const lab::ResponsePoint &point : found.points) {
        const auto known = [&](double value) {
            return point.plantKnown ? std::optional(value) : std::nullopt;
        };
        const auto loop = [&](double value) {
            return found.ms ? std::optional(value) : std::nullopt;
        };
        out.line(row(QString::number(point.hz, 'f', 1),
            {number(known(std::abs(point.plant)), 1.0, 3),
                number(known(half(point) / std::abs(point.plant)), kPercent, 1),
                number(known(std::arg(point.plant)), kDegrees, 1),
                number(loop(std::log10(std::abs(point.loop))), kDecibel, 1),
                number(loop(std::arg(point.loop)), kDegrees, 1),
                QString::number(point.coherence, 'f', 3)}));
    }
    out.line(QStringLiteral("Loop: crossover %1 Hz, phase margin %2 degrees, Ms %3")
                 .arg(meanText(found.crossover_hz, 1.0, 2), meanText(found.phaseMargin_deg, 1.0, 1),
                     meanText(found.ms, 1.0, 2)));
}

Outcome<int> report(const lab::FrequencyResponse &found, const QString &unit, Output &out)
{
    if (out.json())
        out.json(jsonOf(found));
    else
        print(found, unit, out);
    for (const std::string &note : found.notes)
        Output::error(sentence(note));
    return kDone;
}

} // namespace

lab::Happenings happeningsOf(const OpenedRecording &recording)
{
    lab::Happenings happenings;
    for (const auto &[at, what] : recording.report.happenings)
        happenings.emplace_back(at, what);
    return happenings;
}

Outcome<int> evaluate(const QString &path, Output &out)
{
    const auto recording = openRecording(path);
    if (!recording)
        return tl::make_unexpected(recording.error());
    if (const QString lack = lackText(**recording); !lack.isEmpty())
        Output::error(path + QStringLiteral(": ") + lack + QLatin1Char('.'));
    const lab::Happenings happenings = happeningsOf(**recording);
    const capture::Capture &capture = (*recording)->capture;
    const auto refused = [&](const std::string &why) {
        return failure(kRefused, QStringLiteral("%1: %2").arg(path, sentence(why)));
    };
    for (const auto &[at, what] : happenings) {
        if (lab::recordedSteps(what)) {
            const auto series = lab::stepSeries(capture, happenings);
            return series ? report(*series, out) : refused(series.error());
        }
        if (lab::recordedCurrentSteps(what)) {
            const auto series = lab::currentSteps(capture, happenings);
            return series ? report(*series, out) : refused(series.error());
        }
        const auto spin = lab::recordedSpin(what);
        if (lab::recordedRest(what) || (spin && spin->plan.fluxAmps > 0.0)) {
            const auto found = lab::evaluateElectrics(capture, happenings);
            return found ? report(*found, out) : refused(found.error());
        }
        if (spin) {
            const auto found = lab::evaluateMechanics(capture, happenings);
            return found ? report(*found, out) : refused(found.error());
        }
        if (const auto response = lab::recordedResponse(what)) {
            if (response->plan.current != 0) {
                const auto found = lab::evaluateCurrentResponse(capture, happenings);
                return found ? report(*found, QStringLiteral("A/A"), out) : refused(found.error());
            }
            const auto found = lab::evaluateResponse(capture, happenings);
            return found ? report(*found, QStringLiteral("(rad/s)/A"), out)
                         : refused(found.error());
        }
    }
    return refused("it is no recording of an experiment");
}

} // namespace cli
