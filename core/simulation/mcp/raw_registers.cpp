// The tables of structures and texts.
// Source: registers.csv, types raw and string; mcp-aspep fact 8 for what GET and SET do differently.
#include "simulation/mcp/raw_registers.h"

#include "simulation/mcp/board_structures.h"

#include <algorithm>
#include <array>
#include <limits>

namespace simulation {

namespace {

using enum RegisterRow::Scope;
using mcp::RegisterId;
using mcp::Status;
using At = const RegisterContext;

constexpr std::size_t kRevUpStageBytes = 8;

constexpr bool standard(const Build &b) { return !b.hso(); }
constexpr bool hso(const Build &b) { return b.hso(); }
constexpr bool foc(const Build &b) { return b.family == Family::Foc; }
constexpr bool position(const Build &b) { return foc(b) && b.positionControl; }
constexpr bool revUp(const Build &b)
{
    return standard(b) && (b.observerPll || b.observerCordic || (b.sixStep() && b.bemfSensing));
}
constexpr bool hallTuning(const Build &b)
{
    return foc(b) && b.profiler && b.auxiliarySensor == SpeedSensor::Hall;
}
constexpr bool bemfSensing(const Build &b) { return b.sixStep() && b.bemfSensing; }

// Reading -------------------------------------------------------------------------------------------------------------

Bytes speedRamp(At &at)
{
    const auto ramp = at.firmware.lastSpeedRamp();
    return ByteWriter().s32(ramp.rpm).u16(ramp.ms).take();
}

/// Written as 6 bytes, read as 4; the text prints the same 6 for both.
Bytes torqueRamp(At &at)
{
    const auto ramp = at.firmware.lastTorqueRamp();
    if (at.traits.asPrinted)
        return ByteWriter().s32(ramp.digits).u16(ramp.ms).take();
    return ByteWriter().s16(ramp.digits).u16(ramp.ms).take();
}

Bytes currentReferences(At &at)
{
    const Signals &now = at.firmware.variables();
    return ByteWriter().s16(now.iQRef).s16(now.iDRef).take();
}

Bytes positionRamp(At &at)
{
    const auto ramp = at.firmware.lastPositionRamp();
    if (at.traits.swapsPositionRamp)
        return ByteWriter().f32(ramp.duration_s).f32(ramp.target_rad).take();
    return ByteWriter().f32(ramp.target_rad).f32(ramp.duration_s).take();
}

Bytes revUpStages(At &at)
{
    ByteWriter out;
    for (const StageDigits &stage : at.firmware.revUp())
        out.s32(stage.rpm).s16(stage.torque).u16(stage.ms);
    return out.take();
}

template <std::size_t Size>
Bytes nothing(At &)
{
    return Bytes(Size);
}

// Writing -------------------------------------------------------------------------------------------------------------

/// Firmware keeps 16 bits of 0.1 Hz, made in 32 bits: what is cut off or overflows is read back so.
std::int32_t keptSpeed_rpm(std::int32_t rpm)
{
    constexpr std::int32_t kStepsPerHz = 10, kRpmPerHz = 60;
    const auto product = static_cast<std::int32_t>(static_cast<std::uint32_t>(rpm) * kStepsPerHz);
    return static_cast<std::int16_t>(product / kRpmPerHz) * (kRpmPerHz / kStepsPerHz);
}

Status setSpeedRamp(RegisterContext &at, const StaleBytes &value, int)
{
    constexpr std::int32_t kMost = std::numeric_limits<std::int16_t>::max();
    const std::int32_t rpm = std::clamp(keptSpeed_rpm(value.s32(0)), -kMost, kMost);
    at.firmware.rampSpeed({static_cast<std::int16_t>(rpm), value.u16(4)});
    return Status::Ok;
}

Status setTorqueRamp(RegisterContext &at, const StaleBytes &value, int)
{
    at.firmware.rampTorque({static_cast<std::int16_t>(value.s32(0)), value.u16(4)});
    return Status::Ok;
}

Status setCurrentReferences(RegisterContext &at, const StaleBytes &value, int)
{
    at.firmware.setCurrentReferences(value.s16(0), value.s16(2));
    return Status::Ok;
}

Status setPositionRamp(RegisterContext &at, const StaleBytes &value, int)
{
    at.firmware.rampPosition({fromWire<float>(value.u32(0)), fromWire<float>(value.u32(4))});
    return Status::Ok;
}

Status setRevUpStages(RegisterContext &at, const StaleBytes &value, int size)
{
    const auto bytes = static_cast<std::size_t>(size);
    const std::size_t stages = bytes / kRevUpStageBytes;
    if (bytes % kRevUpStageBytes != 0 || stages > Firmware::kRevUpStages)
        return Status::BadRawFormat;
    for (std::size_t i = 0; i < stages; ++i) {
        const StaleBytes stage = value.from(i * kRevUpStageBytes);
        at.firmware.setRevUpStage(i, {keptSpeed_rpm(stage.s32(0)), stage.s16(4), stage.u16(6)});
    }
    return Status::Ok;
}

Status setBemfSensing(RegisterContext &at, const StaleBytes &value, int)
{
    for (std::size_t i = 0; i < kBemfSensingWords; ++i)
        at.kept[bemfSensingKey(i)] = value.u16(2 * i);
    return Status::Ok;
}

// The tables ----------------------------------------------------------------------------------------------------------

constexpr std::array kRaws{
    RawRow{.id = mcp::reg::kGlobalConfig,
        .get = globalConfig,
        .exists = standard,
        .scope = Board,
        .refusedAnywhere = true},
    RawRow{.id = mcp::reg::kGlobalConfig, .get = globalConfig, .exists = hso, .scope = Both},
    RawRow{.id = mcp::reg::kMotorConfig, .get = motorConfig, .refusedAnywhere = true},
    RawRow{.id = mcp::reg::kApplicationConfig, .get = applicationConfig, .refusedAnywhere = true},
    RawRow{.id = mcp::reg::kFocFwConfig, .get = firmwareConfig, .refusedAnywhere = true},
    RawRow{.id = mcp::reg::kScaleConfig, .get = scaleConfig, .refusal = Status::UnknownRegister},
    RawRow{.id = mcp::reg::kSpeedRamp,
        .get = speedRamp,
        .set = setSpeedRamp,
        .exists = standard,
        .looksAtRoom = false},
    RawRow{.id = mcp::reg::kTorqueRamp,
        .get = torqueRamp,
        .set = setTorqueRamp,
        .exists = foc,
        .looksAtRoom = false},
    RawRow{.id = mcp::reg::kRevUpData, .get = revUpStages, .set = setRevUpStages, .exists = revUp},
    RawRow{.id = mcp::reg::kCurrentRef,
        .get = currentReferences,
        .set = setCurrentReferences,
        .exists = foc,
        .looksAtRoom = false},
    RawRow{.id = mcp::reg::kPositionRamp,
        .get = positionRamp,
        .set = setPositionRamp,
        .exists = position,
        .looksAtRoom = false},
    RawRow{.id = mcp::reg::kHallHewPins,
        .get = nothing<4>,
        .refusal = Status::UnknownRegister,
        .exists = hallTuning},
    RawRow{.id = mcp::reg::kHallConnectedPins,
        .get = nothing<4>,
        .refusal = Status::UnknownRegister,
        .exists = hallTuning},
    RawRow{.id = mcp::reg::kHallPhaseShift,
        .get = nothing<28>,
        .refusal = Status::UnknownRegister,
        .exists = hallTuning},
    RawRow{.id = mcp::reg::kBemfAdcConf,
        .get = bemfSensingConfig,
        .set = setBemfSensing,
        .exists = bemfSensing},
    RawRow{.id = mcp::reg::kAdcOffset, .get = nothing<24>, .exists = hso, .ofCalibration = true},
};

constexpr std::array kTexts{
    TextRow{mcp::reg::kFwName, firmwareName, Board},
    TextRow{mcp::reg::kCtrlStageName, [](At &) { return std::string(kControlStageName); }, Board},
    TextRow{mcp::reg::kPwrStageName, powerStageName},
    TextRow{mcp::reg::kMotorName, motorName},
};

} // namespace

const RawRow *findRaw(RegisterId id, const Traits &traits, const Build &build)
{
    if (id.withMotor(0) == mcp::reg::kScaleConfig && !traits.hasScaleConfig)
        return nullptr;
    const auto row = std::ranges::find_if(kRaws, [&](const RawRow &candidate) {
        return candidate.id == id.withMotor(0)
            && (candidate.exists == nullptr || candidate.exists(build));
    });
    return row == kRaws.end() ? nullptr : &*row;
}

const TextRow *findText(RegisterId id)
{
    const auto row = std::ranges::find(kTexts, id.withMotor(0), &TextRow::id);
    return row == kTexts.end() ? nullptr : &*row;
}

} // namespace simulation
