#include "mcp/structure_fields.h"

#include "mcp/datalog.h"
#include "mcp/structures.h"

#include <type_traits>

namespace mcp {
namespace {

/// Collects fields; integers of every width become one kind.
class Fields {
public:
    template <class T>
    Fields &add(std::string name, T value)
    {
        if constexpr (std::is_integral_v<T>)
            m_fields.push_back({std::move(name), static_cast<std::int64_t>(value)});
        else if constexpr (std::is_floating_point_v<T>)
            m_fields.push_back({std::move(name), static_cast<double>(value)});
        else
            m_fields.push_back({std::move(name), std::move(value)});
        return *this;
    }
    template <class Array>
    Fields &addEach(const std::string &name, const Array &values)
    {
        for (std::size_t i = 0; i < values.size(); ++i)
            add(name + " " + std::to_string(i + 1), values[i]);
        return *this;
    }
    std::vector<Field> take() { return std::move(m_fields); }

private:
    std::vector<Field> m_fields;
};

std::vector<Field> fields(const GlobalConfig &c)
{
    return Fields()
        .add("version", c.version)
        .add("motors", c.motors)
        .add("flags", c.flags)
        .add("streams UART A", c.streamsUartA)
        .add("streams UART B", c.streamsUartB)
        .add("streams ST-LINK", c.streamsStLink)
        .take();
}

std::vector<Field> fields(const MotorConfig &c)
{
    return Fields()
        .add("pole pairs", c.polePairs)
        .add("rated flux", c.ratedFlux)
        .add("Rs", c.rs)
        .add("skin factor", c.skinFactor)
        .add("Lq", c.lq)
        .add("Ld", c.ld)
        .add("max current", c.maxCurrent)
        .add("copper mass", c.copperMass)
        .add("cooling tau", c.coolingTau)
        .add("name", c.name)
        .take();
}

std::vector<Field> fields(const ApplicationConfig &c)
{
    Fields f;
    f.add("max speed", c.maxSpeedRpm).add("max readable current", c.maxReadableAmps);
    if (c.nominalDigits)
        f.add("nominal current", *c.nominalDigits);
    else
        f.add("nominal current", c.nominalAmps);
    return f.add("nominal voltage", c.nominalVolts).add("drive type", c.driveType).take();
}

std::vector<Field> fields(const FirmwareConfig &c)
{
    Fields f;
    f.add("primary sensor", c.primarySensor);
    if (!c.sixStep)
        f.add("auxiliary sensor", c.auxiliarySensor);
    f.add("topology", c.topology);
    if (!c.sixStep)
        f.add("FOC rate", c.focRate);
    f.add("PWM frequency", c.pwmHz).add("medium frequency", c.mediumHz).add("flags 1", c.flags1);
    if (c.flags2)
        f.add("flags 2", *c.flags2);
    if (c.driveMode)
        f.add("drive mode", *c.driveMode);
    return f.take();
}

std::vector<Field> fields(const ScaleConfig &c)
{
    return Fields()
        .add("voltage", c.voltage)
        .add("current", c.current)
        .add("frequency", c.frequency)
        .take();
}

std::vector<Field> fields(const SpeedRamp &r)
{
    return Fields().add("speed", r.rpm).add("duration", r.milliseconds).take();
}

std::vector<Field> fields(const TorqueRamp &r)
{
    return Fields().add("torque", r.digits).add("duration", r.milliseconds).take();
}

std::vector<Field> fields(const CurrentRef &r)
{
    return Fields().add("Iq", r.iq).add("Id", r.id).take();
}

std::vector<Field> fields(const PositionRamp &r)
{
    return Fields().add("target", r.targetRad).add("duration", r.seconds).take();
}

std::vector<Field> fields(const RevUpData &stages)
{
    Fields f;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const std::string stage = "stage " + std::to_string(i + 1) + " ";
        f.add(stage + "speed", stages[i].rpm).add(stage + "torque", stages[i].digits);
        f.add(stage + "duration", stages[i].milliseconds);
    }
    return f.take();
}

std::vector<Field> fields(const BemfAdcConf &c) { return Fields().addEach("word", c.words).take(); }

std::vector<Field> fields(const HallPins &p) { return Fields().addEach("pin", p.codes).take(); }

std::vector<Field> fields(const HallPhaseShift &s)
{
    return Fields().addEach("shift", s.shifts).take();
}

std::vector<Field> fields(const AdcOffset &o)
{
    return Fields().addEach("offset", o.offsets).take();
}

std::vector<Field> fields(const DatalogConfig &c)
{
    Fields f;
    f.add("buffer size", c.bufferSize).add("HF rate", c.fastRate).add("HF count", c.fast.size());
    f.add("MF rate", c.slowRate).add("MF count", c.slow.size());
    for (std::size_t i = 0; i < c.fast.size(); ++i)
        f.add("HF " + std::to_string(i + 1), c.fast[i].bits);
    for (std::size_t i = 0; i < c.slow.size(); ++i)
        f.add("MF " + std::to_string(i + 1), c.slow[i].bits);
    return f.add("mark", c.mark).take();
}

template <class Decoded>
std::vector<Field> fieldsIf(const Decoded &decoded)
{
    return decoded ? fields(*decoded) : std::vector<Field>{};
}

} // namespace

std::vector<Field> fieldsOf(RegisterId id, ByteView raw)
{
    if (id.type() != static_cast<std::uint8_t>(RegisterType::Raw))
        return {};
    switch (id.element()) {
    case reg::kGlobalConfig.element():
        return fieldsIf(decodeGlobalConfig(raw));
    case reg::kMotorConfig.element():
        return fieldsIf(decodeMotorConfig(raw));
    case reg::kApplicationConfig.element():
        return fieldsIf(decodeApplicationConfig(raw));
    case reg::kFocFwConfig.element():
        return fieldsIf(decodeFirmwareConfig(raw));
    case reg::kScaleConfig.element():
        return fieldsIf(decodeScaleConfig(raw));
    case reg::kAdcOffset.element():
        return fieldsIf(decodeAdcOffset(raw));
    case reg::kSpeedRamp.element():
        return fieldsIf(decodeSpeedRamp(raw));
    case reg::kTorqueRamp.element():
        return fieldsIf(decodeTorqueRamp(raw));
    case reg::kRevUpData.element():
        return fieldsIf(decodeRevUpData(raw));
    case reg::kCurrentRef.element():
        return fieldsIf(decodeCurrentRef(raw));
    case reg::kPositionRamp.element():
        return fieldsIf(decodePositionRamp(raw));
    case reg::kAsyncUartA.element():
    case reg::kAsyncUartB.element():
    case reg::kAsyncStLink.element():
        return fieldsIf(decodeDatalog(raw));
    case reg::kHallHewPins.element():
    case reg::kHallConnectedPins.element():
        return fieldsIf(decodeHallPins(raw));
    case reg::kHallPhaseShift.element():
        return fieldsIf(decodeHallPhaseShift(raw));
    case reg::kBemfAdcConf.element():
        return fieldsIf(decodeBemfAdcConf(raw));
    default:
        return {};
    }
}

} // namespace mcp
