#include "session/files/finding_json.h"

#include "session/files/json_text.h"

#include <cmath>
#include <numbers>

namespace session {
namespace {

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

void fill(JsonText &json, const lab::MeasuredSteps &series)
{
    json.member("kind", "step");
    json.beginArray("runs");
    for (const lab::StepRun &run : series.runs) {
        json.beginObject();
        json.member("direction", run.up ? "up" : "down");
        put(json, "rise_s", run.rise_s);
        put(json, "overshoot_pct", run.overshoot_pct);
        put(json, "settling_s", run.settling_s);
        put(json, "peak_iq_a", run.peakIq_a);
        put(json, "instant_error_s", run.instantError_s);
        json.endObject();
    }
    json.endArray();
    json.beginObject("mean");
    put(json, "rise_s", series.rise_s);
    put(json, "overshoot_pct", series.overshoot_pct);
    put(json, "settling_s", series.settling_s);
    put(json, "peak_iq_a", series.peakIq_a);
    json.endObject();
}

void fill(JsonText &json, const lab::Mechanics &found)
{
    json.member("kind", "mechanical");
    put(json, "inertia_kgm2", std::optional(found.inertia_kgm2));
    put(json, "viscous_nms", std::optional(found.viscous_nms));
    put(json, "dry_nm", std::optional(found.dry_nm));
    put(json, "fan_nms2", std::optional(found.fan_nms2));
    json.member("model", modelOf(found));
    if (!found.both)
        return;
    put(json, "inertia_forwards_kgm2", std::optional(found.both->forwards_kgm2));
    put(json, "inertia_backwards_kgm2", std::optional(found.both->backwards_kgm2));
    put(json, "always_nm", std::optional(found.both->always_nm));
}

template <lab::HasFigures Found>
void fill(JsonText &json, const Found &found)
{
    json.member("kind", Found::kKind);
    for (const lab::Figure &figure : figuresOf(found))
        put(json, figure.key, figure.value);
}

void fill(JsonText &json, const lab::FrequencyResponse &found)
{
    json.member("kind", "response");
    json.beginArray("points");
    for (const lab::ResponsePoint &point : found.points) {
        if (!point.plantKnown)
            continue;
        constexpr double kDegrees = 180.0 / std::numbers::pi;
        const double gain = std::abs(point.plant), half = halfInterval(point);
        json.beginObject();
        json.member("hz", point.hz);
        json.member("gain", gain);
        json.member("gain_low", gain - half);
        json.member("gain_high", gain + half);
        json.member("phase_deg", std::arg(point.plant) * kDegrees);
        json.member("coherence", point.coherence);
        json.endObject();
    }
    json.endArray();
    put(json, "crossover_hz", found.crossover_hz);
    put(json, "phase_margin_deg", found.phaseMargin_deg);
    put(json, "ms", found.ms);
}

} // namespace

QByteArray findingJson(const lab::Finding &finding)
{
    JsonText json;
    json.beginObject();
    std::visit([&json](const auto &found) { fill(json, found); }, finding);
    json.endObject();
    return json.text();
}

double halfInterval(const lab::ResponsePoint &point)
{
    constexpr double kNormal = 1.96;
    return std::abs(point.plant) * std::min(1.0, kNormal * point.relative);
}

const char *modelOf(const lab::Mechanics &found)
{
    return found.fan ? "viscous+dry+fan" : "viscous+dry";
}

} // namespace session
