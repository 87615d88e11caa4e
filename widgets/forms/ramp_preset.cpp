#include "widgets/forms/ramp_preset.h"

#include <QJsonObject>

#include <array>
#include <cmath>

namespace widgets {
namespace {

constexpr double kMostPreset = 1e6;
constexpr std::array kKinds{"speed", "torque", "current", "position"};

} // namespace

QJsonArray rampPresetsJson(const QList<RampPreset> &presets)
{
    QJsonArray array;
    for (const RampPreset &preset : presets)
        array.append(QJsonObject{{QStringLiteral("name"), preset.name},
            {QStringLiteral("kind"), QLatin1String(kKinds[static_cast<std::size_t>(preset.kind)])},
            {QStringLiteral("target"), preset.target}, {QStringLiteral("second"), preset.second}});
    return array;
}

QList<RampPreset> rampPresetsOf(const QJsonArray &json)
{
    QList<RampPreset> presets;
    for (const auto &value : json) {
        if (presets.size() >= kMostRampPresets)
            break;
        const QJsonObject object = value.toObject();
        const QByteArray kind = object[QStringLiteral("kind")].toString().toLatin1();
        const auto known =
            std::find(kKinds.begin(), kKinds.end(), std::string_view(kind.constData()));
        RampPreset preset;
        preset.name = object[QStringLiteral("name")].toString().left(kLongestPresetName);
        preset.target = object[QStringLiteral("target")].toDouble(std::nan(""));
        preset.second = object[QStringLiteral("second")].toDouble(std::nan(""));
        if (preset.name.isEmpty() || known == kKinds.end()
            || !(std::abs(preset.target) <= kMostPreset)
            || !(std::abs(preset.second) <= kMostPreset))
            continue;
        preset.kind = static_cast<RampKind>(known - kKinds.begin());
        presets.append(preset);
    }
    return presets;
}

} // namespace widgets
