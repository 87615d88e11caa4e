#include "session/files/rev_up_json.h"

#include "session/files/json_text.h"

#include <QJsonDocument>

#include <cmath>

namespace session {

namespace {

const QLatin1String kStages("stages"), kStageSpeed("speed_rpm"), kAmps("current_a"),
    kDigits("current_digits"), kDuration("duration_ms");

std::optional<motor::RevUpStage> stageOf(const QJsonObject &object, double ampsPerDigit)
{
    const double nan = std::nan("");
    const double amps = object[kAmps].toDouble(nan);
    const double digits =
        object[kDigits].toDouble(ampsPerDigit > 0.0 ? std::round(amps / ampsPerDigit) : nan);
    const auto speed = wholeIn<std::int32_t>(object[kStageSpeed].toDouble(nan), -32767, 32767);
    const auto current = wholeIn<std::int16_t>(digits, -32768, 32767);
    const auto duration = wholeIn<std::uint16_t>(object[kDuration].toDouble(nan), 0, 65535);
    if (!speed || !current || !duration)
        return {};
    return motor::RevUpStage{*speed, *current, *duration};
}

} // namespace

QJsonArray revUpStagesJson(const motor::RevUp &stages, double ampsPerDigit)
{
    QJsonArray list;
    for (const motor::RevUpStage &stage : stages) {
        QJsonObject object{{kStageSpeed, stage.speed_rpm}, {kDigits, stage.current_digits},
            {kDuration, stage.duration_ms}};
        if (ampsPerDigit > 0.0)
            object[kAmps] = stage.current_digits * ampsPerDigit;
        list.append(object);
    }
    return list;
}

QByteArray revUpJson(const motor::RevUp &stages, double ampsPerDigit)
{
    return QJsonDocument(QJsonObject{{kStages, revUpStagesJson(stages, ampsPerDigit)},
                             {QLatin1String("duration_s"), motor::revUpDuration_s(stages)}})
        .toJson();
}

Result<motor::RevUp, RevUpFileError> readRevUpJson(const QByteArray &text, double ampsPerDigit)
{
    using Kind = RevUpFileError::Kind;
    QJsonParseError error;
    const QJsonObject root = QJsonDocument::fromJson(text, &error).object();
    if (error.error != QJsonParseError::NoError)
        return fail(RevUpFileError{Kind::NotJson});
    const QJsonArray list = root[kStages].toArray();
    if (list.isEmpty() || list.size() > static_cast<qsizetype>(motor::kRevUpStages))
        return fail(RevUpFileError{Kind::NoStages});
    motor::RevUp stages;
    for (const auto &one : list) {
        const auto stage = stageOf(one.toObject(), ampsPerDigit);
        if (!stage)
            return fail(RevUpFileError{Kind::BadStage, static_cast<int>(stages.size()) + 1});
        stages.push_back(*stage);
    }
    return stages;
}

} // namespace session
