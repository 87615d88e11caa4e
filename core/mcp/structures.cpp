#include "mcp/structures.h"

#include <algorithm>

namespace mcp {
namespace {

constexpr std::size_t kNameSize = 24;
constexpr float kFullScale = 32768.0F;

/// Text of a field of fixed size: up to its first zero, or all of it if there is none.
std::string boundedText(ByteView field)
{
    const auto end = std::find(field.begin(), field.end(), std::uint8_t{0});
    return {field.begin(), end};
}

} // namespace

Result<GlobalConfig, CodecError> decodeGlobalConfig(ByteView raw)
{
    if (raw.size() != 10)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    GlobalConfig c;
    c.version = r.u32();
    c.motors = r.u8();
    c.flags = r.u8();
    c.streamsUartA = r.u8();
    c.streamsUartB = r.u8();
    c.streamsStLink = r.u8();
    return c;
}

Result<MotorConfig, CodecError> decodeMotorConfig(ByteView raw)
{
    if (raw.size() != 60)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    MotorConfig c;
    for (float *field : {&c.polePairs, &c.ratedFlux, &c.rs, &c.skinFactor, &c.lq, &c.ld,
             &c.maxCurrent, &c.copperMass, &c.coolingTau})
        *field = r.f32();
    c.name = boundedText(r.take(kNameSize));
    return c;
}

Result<ApplicationConfig, CodecError> decodeApplicationConfig(ByteView raw)
{
    if (raw.size() != 16 && raw.size() != 14)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    ApplicationConfig c;
    c.maxSpeedRpm = r.u32();
    c.maxReadableAmps = r.f32();
    if (raw.size() == 16) {
        c.nominalAmps = r.f32();
    } else {
        c.nominalDigits = r.u16();
        c.nominalAmps = static_cast<float>(*c.nominalDigits) * c.maxReadableAmps / kFullScale;
    }
    c.nominalVolts = r.u16();
    c.driveType = r.u8();
    return c;
}

Result<FirmwareConfig, CodecError> decodeFirmwareConfig(ByteView raw)
{
    const std::size_t size = raw.size();
    if (size != 14 && size != 10 && size != 11 && size != 13)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    FirmwareConfig c;
    c.sixStep = size != 14;
    c.primarySensor = r.u8();
    if (!c.sixStep)
        c.auxiliarySensor = r.u8();
    c.topology = r.u8();
    if (!c.sixStep)
        c.focRate = r.u8();
    c.pwmHz = r.u32();
    c.mediumHz = r.u16();
    c.flags1 = r.u16();
    if (size >= 13)
        c.flags2 = r.u16();
    if (size == 11 || size == 13)
        c.driveMode = r.u8();
    return c;
}

Result<ScaleConfig, CodecError> decodeScaleConfig(ByteView raw)
{
    if (raw.size() != 12)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    ScaleConfig c;
    c.voltage = r.f32();
    c.current = r.f32();
    c.frequency = r.f32();
    return c;
}

Result<SpeedRamp, CodecError> decodeSpeedRamp(ByteView raw)
{
    if (raw.size() != 6)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    SpeedRamp ramp;
    ramp.rpm = r.s32();
    ramp.milliseconds = r.u16();
    return ramp;
}

Result<TorqueRamp, CodecError> decodeTorqueRamp(ByteView raw)
{
    if (raw.size() != 6 && raw.size() != 4)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    TorqueRamp ramp;
    ramp.digits = raw.size() == 6 ? r.s32() : r.s16();
    ramp.milliseconds = r.u16();
    return ramp;
}

Result<CurrentRef, CodecError> decodeCurrentRef(ByteView raw)
{
    if (raw.size() != 4)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    CurrentRef reference;
    reference.iq = r.s16();
    reference.id = r.s16();
    return reference;
}

Result<PositionRamp, CodecError> decodePositionRamp(ByteView raw)
{
    if (raw.size() != 8)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    PositionRamp ramp;
    ramp.targetRad = r.f32();
    ramp.seconds = r.f32();
    return ramp;
}

Result<RevUpData, CodecError> decodeRevUpData(ByteView raw)
{
    if (raw.size() % 8 != 0 || raw.size() > 8 * kMaxRevUpStages)
        return fail(CodecError::WrongSize);
    RevUpData stages;
    for (ByteReader r(raw); r.left() > 0;) {
        RevUpStage stage;
        stage.rpm = r.s32();
        stage.digits = r.s16();
        stage.milliseconds = r.u16();
        stages.push_back(stage);
    }
    return stages;
}

Result<BemfAdcConf, CodecError> decodeBemfAdcConf(ByteView raw)
{
    BemfAdcConf c;
    if (raw.size() != 2 * c.words.size())
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    for (std::uint16_t &word : c.words)
        word = r.u16();
    return c;
}

Result<HallPins, CodecError> decodeHallPins(ByteView raw)
{
    if (raw.size() != 4)
        return fail(CodecError::WrongSize);
    return HallPins{{raw[0], raw[1], raw[2]}};
}

Result<HallPhaseShift, CodecError> decodeHallPhaseShift(ByteView raw)
{
    HallPhaseShift shift;
    if (raw.size() != 2 * shift.shifts.size())
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    for (std::int16_t &value : shift.shifts)
        value = r.s16();
    return shift;
}

Result<AdcOffset, CodecError> decodeAdcOffset(ByteView raw)
{
    AdcOffset offset;
    if (raw.size() != 4 * offset.offsets.size())
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    for (std::int32_t &value : offset.offsets)
        value = r.s32();
    return offset;
}

Bytes encode(const GlobalConfig &c)
{
    ByteWriter w;
    w.u32(c.version)
        .u8(c.motors)
        .u8(c.flags)
        .u8(c.streamsUartA)
        .u8(c.streamsUartB)
        .u8(c.streamsStLink)
        .u8(0);
    return w.take();
}

Bytes encode(const MotorConfig &c)
{
    ByteWriter w;
    for (const float field : {c.polePairs, c.ratedFlux, c.rs, c.skinFactor, c.lq, c.ld,
             c.maxCurrent, c.copperMass, c.coolingTau})
        w.f32(field);
    Bytes name(kNameSize, 0);
    std::copy_n(c.name.begin(), std::min(c.name.size(), kNameSize - 1), name.begin());
    return w.bytes(name).take();
}

Bytes encode(const ApplicationConfig &c)
{
    ByteWriter w;
    w.u32(c.maxSpeedRpm).f32(c.maxReadableAmps);
    if (c.nominalDigits)
        w.u16(*c.nominalDigits);
    else
        w.f32(c.nominalAmps);
    return w.u16(c.nominalVolts).u8(c.driveType).u8(0).take();
}

Bytes encode(const FirmwareConfig &c)
{
    ByteWriter w;
    w.u8(c.primarySensor);
    if (!c.sixStep)
        w.u8(c.auxiliarySensor);
    w.u8(c.topology);
    if (!c.sixStep)
        w.u8(c.focRate);
    w.u32(c.pwmHz).u16(c.mediumHz).u16(c.flags1);
    if (!c.sixStep || c.flags2)
        w.u16(c.flags2.value_or(0));
    if (c.sixStep && c.driveMode)
        w.u8(*c.driveMode);
    return w.take();
}

Bytes encode(const ScaleConfig &c)
{
    return ByteWriter().f32(c.voltage).f32(c.current).f32(c.frequency).take();
}

Bytes encode(const SpeedRamp &ramp)
{
    return ByteWriter().s32(ramp.rpm).u16(ramp.milliseconds).take();
}

Bytes encode(const TorqueRamp &ramp)
{
    return ByteWriter().s32(ramp.digits).u16(ramp.milliseconds).take();
}

Bytes encode(const CurrentRef &reference)
{
    return ByteWriter().s16(reference.iq).s16(reference.id).take();
}

Bytes encode(const PositionRamp &ramp)
{
    return ByteWriter().f32(ramp.targetRad).f32(ramp.seconds).take();
}

Bytes encode(const RevUpData &stages)
{
    ByteWriter w;
    for (std::size_t i = 0; i < std::min(stages.size(), kMaxRevUpStages); ++i)
        w.s32(stages[i].rpm).s16(stages[i].digits).u16(stages[i].milliseconds);
    return w.take();
}

Bytes encode(const BemfAdcConf &config)
{
    ByteWriter w;
    for (const std::uint16_t word : config.words)
        w.u16(word);
    return w.take();
}

Bytes encode(const HallPins &pins) { return ByteWriter().bytes(pins.codes).u8(0).take(); }

Bytes encode(const HallPhaseShift &shift)
{
    ByteWriter w;
    for (const std::int16_t value : shift.shifts)
        w.s16(value);
    return w.take();
}

Bytes encode(const AdcOffset &offset)
{
    ByteWriter w;
    for (const std::int32_t value : offset.offsets)
        w.s32(value);
    return w.take();
}

} // namespace mcp
