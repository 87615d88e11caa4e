#include "session/files/fcp_rig_file.h"

#include "base/text.h"
#include "session/files/json_text.h"
#include "session/files/whole_file.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cmath>
#include <limits>

namespace session {
namespace {

using simulation::FcpMotor;
using simulation::FcpRig;

constexpr double kMostFrameTimer_ms = 60'000;

constexpr Word<FcpMotor::Sensing> kSensings[] = {{"pll", FcpMotor::Sensing::Pll},
    {"cordic", FcpMotor::Sensing::Cordic}, {"encoder", FcpMotor::Sensing::Encoder},
    {"hall", FcpMotor::Sensing::Hall}};
constexpr std::pair<const char *, bool FcpRig::*> kFeatures[] = {
    {"flux_weakening", &FcpRig::fluxWeakening}, {"feed_forward", &FcpRig::feedForward},
    {"pfc", &FcpRig::pfc}, {"profiler", &FcpRig::profiler}, {"dac", &FcpRig::dac}};

/// Reads members of objects; what an object does not have stays as it is. The first thing that is wrong stays in
/// `problem`.
class Reader {
public:
    std::string problem;

    FcpRig rig(const QJsonObject &from);

private:
    /// A whole number within the range.
    template <class Number>
    void assign(const QJsonValue &value, const std::string &place, Number &into,
        double least = std::numeric_limits<Number>::min(),
        double most = std::numeric_limits<Number>::max())
    {
        if (const auto whole = wholeIn<Number>(value.toDouble(NAN), least, most))
            into = *whole;
        else if (!value.isUndefined())
            wrong(place,
                "must be a whole number from " + std::to_string(static_cast<std::int64_t>(least))
                    + " to " + std::to_string(static_cast<std::int64_t>(most)));
    }

    void assign(const QJsonValue &value, const std::string &place, bool &into)
    {
        if (!value.isUndefined() && !value.isBool())
            wrong(place, "must be true or false");
        into = value.toBool(into);
    }

    void assign(const QJsonValue &value, const std::string &place, std::string &into)
    {
        if (value.isString())
            into = value.toString().toStdString();
        else if (!value.isUndefined())
            wrong(place, "must be a text");
    }

    void wrong(const std::string &place, const std::string &what)
    {
        if (problem.empty())
            problem = place + ": " + what;
    }

    FcpMotor motor(const QJsonObject &from);
    void readRegisters(const QJsonObject &from, FcpMotor &motor);
    void readRevUp(const QJsonArray &from, FcpMotor &motor);
};

void Reader::readRegisters(const QJsonObject &from, FcpMotor &motor)
{
    for (auto at = from.begin(); at != from.end(); ++at) {
        bool isNumber = false;
        const uint id = at.key().toUInt(&isNumber, 0);
        if (!isNumber || id > 0xFF)
            return wrong(at.key().toStdString(), "is no number of a register such as \"0x04\"");
        assign(at.value(), at.key().toStdString(), motor.registers[static_cast<std::uint8_t>(id)],
            INT32_MIN, UINT32_MAX);
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
        fcp::StageFields &read = motor.revUp.emplace_back();
        assign(stage[0], "revup rpm", read.speed_rpm);
        assign(stage[1], "revup torque", read.torque);
        assign(stage[2], "revup ms", read.duration_ms);
    }
}

FcpMotor Reader::motor(const QJsonObject &from)
{
    FcpMotor motor;
    assign(from[keyOf("state")], "state", motor.state);
    assign(from[keyOf("control_mode")], "control_mode", motor.controlMode);
    assign(from[keyOf("faults")], "faults", motor.faults);
    std::string sensing = "pll";
    assign(from[keyOf("sensing")], "sensing", sensing);
    if (const auto *known = findWord(kSensings, sensing))
        motor.sensing = *known;
    else
        wrong("sensing", "must be pll, cordic, encoder or hall");
    readRegisters(from[keyOf("registers")].toObject(), motor);
    readRevUp(from[keyOf("revup")].toArray(), motor);
    return motor;
}

FcpRig Reader::rig(const QJsonObject &from)
{
    FcpRig rig;
    std::string dialect;
    assign(from[keyOf("dialect")], "dialect", dialect);
    if (dialect == "powerpc")
        rig.dialect = fcp::Dialect::PowerPc;
    else if (dialect != "stm32")
        wrong("dialect", "must be stm32 or powerpc");
    assign(from[keyOf("rig")], "rig", rig.name);
    assign(from[keyOf("firmware_string")], "firmware_string", rig.firmware);
    assign(from[keyOf("speed_step")], "speed_step", rig.speedStep_rpm, 1, INT16_MAX);
    const QJsonObject features = from[keyOf("features")].toObject();
    for (const auto &[name, feature] : kFeatures)
        assign(features[keyOf(name)], name, rig.*feature);
    const QJsonValue timer = from[keyOf("frame_timer")];
    if (!timer.isUndefined() && timer.toString() != keyOf("dead")) {
        std::int64_t time_ms = 0;
        assign(timer, "frame_timer", time_ms, 1, kMostFrameTimer_ms);
        rig.frameTimer = std::chrono::milliseconds(time_ms);
    }
    const QJsonArray motors = from[keyOf("motors")].toArray();
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
    if (object[keyOf("protocol")].toString() != keyOf("legacy"))
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
