#include "mcp/structures.h"

#include <algorithm>

namespace mcp {
namespace {

constexpr std::size_t kNameSize = 24;
constexpr float kFullScale = 32768.0F;

/// Text of a field of fixed size: up to its first zero, or all of it if there is none.
std::string boundedText(ByteView field)
{
    const auto end = std::ranges::find(field, std::uint8_t{0});
    return {field.begin(), end};
}

} // namespace

Result<GlobalConfig, CodecError> decodeGlobalConfig(ByteView raw)
{
    if (raw.size() != 10)
        return fail(CodecError::WrongSize);
    ByteReader r(raw);
    return GlobalConfig{r.u32(), r.u8(), r.u8(), r.u8(), r.u8(), r.u8()};
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
    return ScaleConfig{r.f32(), r.f32(), r.f32()};
}

} // namespace mcp
