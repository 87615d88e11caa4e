#include "experiments/step_report.h"

#include "json_text.h"

#include <cmath>

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

QByteArray jsonOf(const lab::StepSeries &series)
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
    return mean->low ? value + QStringLiteral(" +- ")
            + number(mean->value - *mean->low, factor, digits)
                     : value;
}

constexpr double kMilli = 1e3;

void print(const lab::StepSeries &series, Output &out)
{
    out.line(row({}, {QStringLiteral("rise ms"), QStringLiteral("overshoot %"),
                         QStringLiteral("settling ms"), QStringLiteral("peak Iq A"),
                         QStringLiteral("instant +- ms")}));
    int count = 0;
    for (const lab::StepRun &run : series.runs)
        out.line(row(QString::number(++count)
                + (run.up ? QStringLiteral(" up") : QStringLiteral(" down")),
            {number(run.rise_s, kMilli, 2), number(run.overshoot_pct, 1.0, 1),
                number(run.settling_s, kMilli, 1), number(run.peakIq_a, 1.0, 2),
                number(run.instantError_s, kMilli, 2)}));
    out.line(row(QStringLiteral("mean (95 %)"),
        {meanText(series.rise_s, kMilli, 2), meanText(series.overshoot_pct, 1.0, 1),
            meanText(series.settling_s, kMilli, 1), meanText(series.peakIq_a, 1.0, 2), {}}));
}

} // namespace

Outcome<lab::StepSeries> seriesIn(const OpenedRecording &recording, const QString &path)
{
    lab::Happenings happenings;
    for (const auto &[at, what] : recording.report.happenings)
        happenings.emplace_back(at, what);
    auto series = lab::stepSeries(recording.capture, happenings);
    if (!series)
        return failure(kRefused,
            QStringLiteral("%1: %2").arg(path, sentence(series.error())));
    return *series;
}

Outcome<int> report(const lab::StepSeries &series, Output &out)
{
    if (out.json())
        out.json(jsonOf(series));
    else
        print(series, out);
    for (const std::string &note : series.notes)
        Output::error(sentence(note));
    if (series.rise_s)
        return kDone;
    return failure(kRefused,
        QStringLiteral("Not conclusive: no step of this series could be measured."));
}

} // namespace cli
