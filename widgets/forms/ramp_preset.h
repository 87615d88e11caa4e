// A ramp that the user has named, to be filled in again: values as they are shown, in the unit of their kind.
#pragma once

#include <QJsonArray>
#include <QList>
#include <QString>

namespace widgets {

enum class RampKind : std::uint8_t { Speed, Torque, Current, Position };

struct RampPreset {
    QString name;
    RampKind kind = RampKind::Speed;
    double target = 0.0; ///< rpm, A of Iq, or degrees of the shaft
    double second = 0.0; ///< ms, or A of Id
    bool operator==(const RampPreset &) const = default;
};

constexpr qsizetype kMostRampPresets = 100;
constexpr qsizetype kLongestPresetName = 40;

QJsonArray rampPresetsJson(const QList<RampPreset> &presets);
/// What does not make sense is left out.
QList<RampPreset> rampPresetsOf(const QJsonArray &json);

} // namespace widgets
