#include "mcp/structure_fields.h"

#include "mcp/datalog.h"
#include "mcp/structures.h"
#include "motor/rev_up.h"

#include <array>
#include <string_view>
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

std::vector<Field> fields(const motor::RevUp &stages)
{
    Fields f;
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const std::string stage = "stage " + std::to_string(i + 1) + " ";
        f.add(stage + "speed", stages[i].speed_rpm).add(stage + "torque", stages[i].current_digits);
        f.add(stage + "duration", stages[i].duration_ms);
    }
    return f.take();
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

template <auto kRead>
void addNext(Fields &fields, std::string name, ByteReader &reader)
{
    fields.add(std::move(name), (reader.*kRead)());
}
using AddNext = void (*)(Fields &, std::string, ByteReader &);
constexpr AddNext kU8 = addNext<&ByteReader::u8>, kU16 = addNext<&ByteReader::u16>,
                  kS16 = addNext<&ByteReader::s16>, kS32 = addNext<&ByteReader::s32>,
                  kF32 = addNext<&ByteReader::f32>;

/// Some numbers of a structure that is only ever shown: it is the rows of its register and size, in wire order.
struct Part {
    RegisterId id;
    std::size_t bytes = 0; ///< of the whole structure
    std::string_view name;
    AddNext add = nullptr;
    std::size_t count = 1; ///< several in a row have their place behind the name
};
constexpr std::array kParts{
    Part{reg::kAdcOffset, 24, "offset", kS32, 6}, // HSO: currents R S T, voltages R S T
    Part{reg::kSpeedRamp, 6, "speed", kS32},
    Part{reg::kSpeedRamp, 6, "duration", kU16},
    Part{reg::kTorqueRamp, 6, "torque", kS32}, // s16A; written as 6 bytes, read as 4
    Part{reg::kTorqueRamp, 6, "duration", kU16},
    Part{reg::kTorqueRamp, 4, "torque", kS16},
    Part{reg::kTorqueRamp, 4, "duration", kU16},
    Part{reg::kCurrentRef, 4, "Iq", kS16}, // s16A
    Part{reg::kCurrentRef, 4, "Id", kS16},
    Part{reg::kPositionRamp, 8, "target", kF32}, // rad and s; up to 6.2.1 GET swaps them
    Part{reg::kPositionRamp, 8, "duration", kF32},
    Part{reg::kHallHewPins, 4, "pin", kU8, 3},
    Part{reg::kHallConnectedPins, 4, "pin", kU8, 3},
    Part{reg::kHallPhaseShift, 28, "shift", kS16, 14},
    // Reading and writing it back changes it, see mcp-aspep.md section 8.
    Part{reg::kBemfAdcConf, 26, "word", kU16, 13},
};

std::vector<Field> fieldsByTable(RegisterId id, ByteView raw)
{
    Fields fields;
    ByteReader reader(raw);
    for (const Part &part : kParts) {
        if (part.id.element() != id.element() || part.bytes != raw.size())
            continue;
        const std::string name(part.name);
        for (std::size_t i = 1; i <= part.count; ++i)
            part.add(fields, part.count == 1 ? name : name + " " + std::to_string(i), reader);
    }
    return fields.take();
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
    case reg::kRevUpData.element():
        return fieldsIf(motor::revUpOfBytes(raw));
    case reg::kAsyncUartA.element():
    case reg::kAsyncUartB.element():
    case reg::kAsyncStLink.element():
        return fieldsIf(decodeDatalog(raw));
    default:
        return fieldsByTable(id, raw);
    }
}

} // namespace mcp
