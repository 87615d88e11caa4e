#include "catalog/names.h"

#include "base/text.h"

#include <algorithm>

namespace catalog {

namespace {

constexpr NamedValue kStatus[] = {{0, "IDLE"}, {2, "ALIGNMENT"}, {4, "START"}, {6, "RUN"},
    {8, "STOP"}, {10, "FAULT_NOW"}, {11, "FAULT_OVER"}, {12, "ICLWAIT"}, {16, "CHARGE_BOOT_CAP"},
    {17, "OFFSET_CALIB"}, {19, "SWITCH_OVER"}, {20, "WAIT_STOP_MOTOR"}, {21, "OTF_DETECTION"},
    {22, "OTF_BRAKE"}, {30, "RS_ESTIMATION"}};
constexpr NamedValue kControlMode[] = {{0, "observing"}, {1, "open-loop voltage"},
    {2, "open-loop current"}, {3, "speed"}, {4, "torque"}, {5, "profiling"}, {6, "shorted"},
    {7, "position"}, {9, "duty"}};
constexpr NamedValue kPositionControl[] = {
    {0, "ready"}, {1, "moving"}, {2, "target reached"}, {3, "following"}};
constexpr NamedValue kPositionAlign[] = {{0, "awaiting"}, {1, "aligning"}, {2, "completed"},
    {3, "absolute not supported"}, {4, "absolute supported"}, {5, "error"}};
constexpr NamedValue kModulation[] = {{0, "sine"}, {1, "centred"}, {2, "shifted centre"},
    {3, "min-low"}, {4, "max-high"}, {5, "up-down"}};
constexpr NamedValue kSpeedSource[] = {{0, "protocol"}, {1, "potentiometer"}};
constexpr NamedValue kRsUpdate[] = {{0, "none"}, {1, "automatic"}};
constexpr NamedValue kProfilerCommand[] = {{0, "none"}, {1, "start"}, {2, "reset"}};

constexpr NamedValue kFaults[] = {{0x0001, "DURATION"}, {0x0002, "OVER_VOLT"},
    {0x0004, "UNDER_VOLT"}, {0x0008, "OVER_TEMP"}, {0x0010, "START_UP"}, {0x0020, "SPEED_FDBK"},
    {0x0040, "OVER_CURR"}, {0x0080, "SW_ERROR"}, {0x0100, "SAMPLE_FAULT"}, {0x0200, "OVER_CURR_SW"},
    {0x0400, "DRIVER_PROTECTION"}};
constexpr NamedValue kPfcFaults[] = {{0x01, "software"}, {0x02, "hardware"},
    {0x04, "software over-voltage"}, {0x08, "software over-current"}, {0x10, "mains frequency"},
    {0x20, "mains voltage"}};
constexpr NamedValue kStartConfiguration[] = {{0x01, "DC resistance estimate"},
    {0x02, "dynamic ZeST configuration"}, {0x04, "offset measurement"}, {0x08, "pole pulses"},
    {0x10, "fast DC resistance"}};
constexpr NamedValue kSteps[] = {{0x01, "step 1"}, {0x02, "step 2"}, {0x04, "step 3"},
    {0x08, "step 4"}, {0x10, "step 5"}, {0x20, "step 6"}};

constexpr NamedValue kDriveTypes[] = {{0, "FOC"}, {1, "six-step"}, {2, "ACIM"}};
constexpr NamedValue kSensors[] = {{0, "none"}, {1, "observer + PLL"}, {2, "observer + CORDIC"},
    {3, "encoder"}, {4, "Hall"}, {5, "HSO"}, {6, "ZeST"}};
constexpr NamedValue kTopologies[] = {{0, "three shunts"}, {1, "single shunt, active window"},
    {2, "single shunt, phase shift"}, {3, "isolated sensors"}, {4, "none"}};
constexpr NamedValue kDriveModes[] = {{0, "voltage"}, {1, "current"}};
constexpr NamedValue kTransports[] = {{0x01, "ST-LINK"}, {0x02, "UART A"}, {0x04, "UART B"}};
constexpr NamedValue kFlags1[] = {{0x0001, "flux weakening"}, {0x0002, "feed forward"},
    {0x0004, "MTPA"}, {0x0008, "PFC"}, {0x0010, "inrush limiter"}, {0x0020, "resistive brake"},
    {0x0040, "over-current protection disable"}, {0x0080, "STGAP drivers"},
    {0x0100, "position control"}, {0x0200, "bus voltage sensing"}, {0x0400, "temperature sensing"},
    {0x0800, "phase voltage sensing"}, {0x1000, "flash configuration"}, {0x2000, "DAC channel 1"},
    {0x4000, "DAC channel 2"}, {0x8000, "on-the-fly start-up"}};
constexpr NamedValue kFlags2[] = {{0x0001, "over-modulation"}, {0x0002, "discontinuous PWM"},
    {0x0400, "quasi-synchronous"}, {0x0800, "IPD start-up"}, {0x1000, "current monitor"},
    {0x2000, "profiler"}, {0x4000, "CPU load measurement"}, {0x8000, "open-loop debug"}};

struct Table {
    std::string_view registerName; ///< or the key of a field, as mcp/structure_fields.cpp has it
    std::span<const NamedValue> values;
};
const Table kEnumerations[] = {{"STATUS", kStatus}, {"CONTROL_MODE", kControlMode},
    {"FOC_CONTROLMODE", kControlMode}, {"FOC_CONTROLMODE_NEW", kControlMode},
    {"POSITION_CTRL_STATE", kPositionControl}, {"POSITION_ALIGN_STATE", kPositionAlign},
    {"FOC_MODULATIONMODE", kModulation}, {"FOC_SPEED_SOURCE_SELECT", kSpeedSource},
    {"FOC_RS_UPDATE_SELECT", kRsUpdate}, {"PROFILER_COMMAND", kProfilerCommand},
    {"drive type", kDriveTypes}, {"primary sensor", kSensors}, {"auxiliary sensor", kSensors},
    {"topology", kTopologies}, {"drive mode", kDriveModes}};
const Table kFlagRegisters[] = {{"FAULTS_FLAGS", kFaults}, {"PFC_FAULTS", kPfcFaults},
    {"START_CONFIGURATION", kStartConfiguration}, {"LOWSIDE_MODULATION", kSteps},
    {"OPENLOOP_SENSING", kSteps}, {"flags", kTransports}, {"flags 1", kFlags1},
    {"flags 2", kFlags2}};

template <std::size_t N>
std::span<const NamedValue> findTable(const Table (&tables)[N], std::string_view registerName)
{
    for (const Table &table : tables)
        if (table.registerName == registerName)
            return table.values;
    return {};
}

std::string nameIn(std::span<const NamedValue> names, std::int64_t value)
{
    for (const NamedValue &named : names)
        if (named.value == value)
            return std::string(named.name);
    return std::to_string(value);
}

std::vector<std::string> bitsIn(std::span<const NamedValue> names, std::uint32_t bits)
{
    std::vector<std::string> set;
    for (int bit = 0; bit < 32; ++bit) {
        const std::int64_t mask = std::int64_t{1} << bit;
        if ((bits & mask) == 0)
            continue;
        const auto named = std::ranges::find(names, mask, &NamedValue::value);
        set.push_back(
            named == names.end() ? "bit " + std::to_string(bit) : std::string(named->name));
    }
    return set;
}

} // namespace

std::span<const NamedValue> namedValues(std::string_view registerName)
{
    return findTable(kEnumerations, registerName);
}

std::string valueName(std::string_view registerName, std::int64_t value)
{
    return nameIn(namedValues(registerName), value);
}

std::vector<std::string> faultNames(std::uint16_t bits) { return bitsIn(kFaults, bits); }

std::vector<std::string> flagNames(std::string_view registerName, std::uint32_t bits)
{
    return bitsIn(namedFlags(registerName), bits);
}

std::span<const NamedValue> namedFlags(std::string_view registerName)
{
    return findTable(kFlagRegisters, registerName);
}

bool holdsPastFaults(std::string_view registerName) { return registerName == "FAULTS_FLAGS"; }

FaultKind faultKindOf(std::string_view name)
{
    using enum FaultKind;
    static constexpr Word<FaultKind> kKinds[] = {{"DURATION", Duration}, {"OVER_VOLT", OverVoltage},
        {"UNDER_VOLT", UnderVoltage}, {"OVER_TEMP", OverTemperature}, {"START_UP", StartUp},
        {"SPEED_FDBK", SpeedFeedback}, {"OVER_CURR", OverCurrent}, {"OVER_CURR_SW", OverCurrent},
        {"BREAK_IN", OverCurrent}, {"SW_ERROR", Software}, {"SAMPLE_FAULT", Sampling},
        {"DP_FAULT", DriverProtection}, {"DRIVER_PROTECTION", DriverProtection}};
    const FaultKind *kind = findWord(kKinds, name);
    return kind == nullptr ? Other : *kind;
}

} // namespace catalog
