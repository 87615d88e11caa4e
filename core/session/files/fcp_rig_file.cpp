#include "session/files/fcp_rig_file.h"

#include "session/files/whole_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <optional>

namespace session {
namespace {

using simulation::FcpMotor;
using simulation::FcpRig;

constexpr double kMostFrameTimer_ms = 60'000;

/// Reads members of objects; the first thing that is wrong stays in `problem`.
class Reader {
public:
    std::string problem;

    /// A whole number between the bounds; `usual` if there is none.
    std::int64_t whole(
        const QJsonObject &from, const char *key, double least, double most, std::int64_t usual = 0)
    {
        const QJsonValue value = from[QLatin1String(key)];
        return value.isUndefined() ? usual : whole(value, key, least, most);
    }

    std::int64_t whole(const QJsonValue &value, const std::string &place, double least, double most)
    {
        const double number = value.toDouble(NAN);
        if (number >= least && number <= most && number == std::trunc(number))
            return static_cast<std::int64_t>(number);
        wrong(place,
            "must be a whole number from " + std::to_string(static_cast<std::int64_t>(least))
                + " to " + std::to_string(static_cast<std::int64_t>(most)));
        return 0;
    }

    bool flag(const QJsonObject &from, const char *key)
    {
        const QJsonValue value = from[QLatin1String(key)];
        if (!value.isUndefined() && !value.isBool())
            wrong(key, "must be true or false");
        return value.toBool();
    }

    std::string text(const QJsonObject &from, const char *key, const std::string &usual)
    {
        const QJsonValue value = from[QLatin1String(key)];
        if (!value.isUndefined() && !value.isString())
            wrong(key, "must be a text");
        return value.isString() ? value.toString().toStdString() : usual;
    }

    void wrong(const std::string &place, const std::string &what)
    {
        if (problem.empty())
            problem = place + ": " + what;
    }

    FcpMotor motor(const QJsonObject &from);
    FcpRig rig(const QJsonObject &from);

private:
    void readRegisters(const QJsonObject &from, FcpMotor &motor);
    void readRevUp(const QJsonArray &from, FcpMotor &motor);
    void readTimer(const QJsonValue &from, FcpRig &rig);
};

void Reader::readRegisters(const QJsonObject &from, FcpMotor &motor)
{
    for (auto at = from.begin(); at != from.end(); ++at) {
        bool isNumber = false;
        const uint id = at.key().toUInt(&isNumber, 0);
        if (!isNumber || id > 0xFF)
            return wrong(at.key().toStdString(), "is no number of a register such as \"0x04\"");
        motor.registers[static_cast<std::uint8_t>(id)] =
            whole(at.value(), at.key().toStdString(), INT32_MIN, UINT32_MAX);
    }
}

void Reader::readRevUp(const QJsonArray &from, FcpMotor &motor)
{
    if (from.size() > static_cast<qsizetype>(fcp::kRevUpStages))
        return wrong("revup", "has more than 5 stages");
    for (const auto &value : from) {
        const QJsonArray stage = value.toArray();
        if (stage.size() != 3)
            return wrong("revup", "each stage is [rpm, torque, ms]");
        motor.revUp.push_back(
            {static_cast<std::int32_t>(whole(stage[0], "revup rpm", INT32_MIN, INT32_MAX)),
                static_cast<std::int16_t>(whole(stage[1], "revup torque", INT16_MIN, INT16_MAX)),
                static_cast<std::uint16_t>(whole(stage[2], "revup ms", 0, UINT16_MAX))});
    }
}

FcpMotor Reader::motor(const QJsonObject &from)
{
    using Sensing = FcpMotor::Sensing;
    constexpr std::array kSensings{std::pair{"pll", Sensing::Pll},
        std::pair{"cordic", Sensing::Cordic}, std::pair{"encoder", Sensing::Encoder},
        std::pair{"hall", Sensing::Hall}};
    FcpMotor motor;
    motor.state = static_cast<std::uint8_t>(whole(from, "state", 0, 0xFF));
    motor.controlMode = static_cast<std::uint8_t>(whole(from, "control_mode", 0, 0xFF, 1));
    motor.faults = static_cast<std::uint32_t>(whole(from, "faults", 0, UINT32_MAX));
    const std::string sensing = text(from, "sensing", "pll");
    bool known = false;
    for (const auto &[word, meaning] : kSensings) {
        if (sensing == word) {
            motor.sensing = meaning;
            known = true;
        }
    }
    if (!known)
        wrong("sensing", "must be pll, cordic, encoder or hall");
    readRegisters(from[QLatin1String("registers")].toObject(), motor);
    readRevUp(from[QLatin1String("revup")].toArray(), motor);
    return motor;
}

void Reader::readTimer(const QJsonValue &from, FcpRig &rig)
{
    if (from.isUndefined() || from.toString() == QLatin1String("dead"))
        return;
    rig.frameTimer = std::chrono::milliseconds(whole(from, "frame_timer", 1, kMostFrameTimer_ms));
}

FcpRig Reader::rig(const QJsonObject &from)
{
    FcpRig rig;
    const std::string dialect = text(from, "dialect", "");
    if (dialect == "powerpc")
        rig.dialect = fcp::Dialect::PowerPc;
    else if (dialect != "stm32")
        wrong("dialect", "must be stm32 or powerpc");
    rig.name = text(from, "rig", "");
    rig.firmware = text(from, "firmware_string", rig.firmware);
    rig.speedStep_rpm = static_cast<std::int32_t>(whole(from, "speed_step", 1, INT16_MAX, 6));
    const QJsonObject features = from[QLatin1String("features")].toObject();
    rig.fluxWeakening = flag(features, "flux_weakening");
    rig.feedForward = flag(features, "feed_forward");
    rig.pfc = flag(features, "pfc");
    rig.profiler = flag(features, "profiler");
    rig.dac = flag(features, "dac");
    readTimer(from[QLatin1String("frame_timer")], rig);
    const QJsonArray motors = from[QLatin1String("motors")].toArray();
    if (motors.isEmpty() || motors.size() > static_cast<qsizetype>(fcp::kMostMotors))
        wrong("motors", "must be a list of 1 to 7 motors");
    rig.motors.clear();
    for (const auto &value : motors)
        rig.motors.push_back(motor(value.toObject()));
    return rig;
}

} // namespace

Result<FcpRig, std::string> readFcpRig(const QByteArray &json)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (error.error != QJsonParseError::NoError)
        return fail("is no JSON: " + error.errorString().toStdString());
    const QJsonObject object = document.object();
    if (object[QLatin1String("protocol")].toString() != QLatin1String("legacy"))
        return fail(std::string("protocol: must be legacy"));
    Reader reader;
    FcpRig rig = reader.rig(object);
    if (!reader.problem.empty())
        return fail(reader.problem);
    return rig;
}

Result<FcpRig, std::string> readFcpRigFile(const QString &path)
{
    const auto content = readWholeFile(path, kMostText);
    if (!content)
        return fail(path.toStdString() + ": " + content.error().toStdString());
    auto rig = readFcpRig(*content);
    if (!rig)
        return fail(path.toStdString() + ": " + rig.error());
    return rig;
}

} // namespace session
