// The structures, field by field.
#include "simulation/board_structures.h"

#include "simulation/simulated_board.h"

#include <cmath>

namespace simulation {

std::string firmwareName(const Traits &traits, const BoardOptions &options)
{
    std::string name(traits.firmwareName);
    if (options.watchdogMs > 0)
        name += " RSWD" + std::to_string(options.watchdogMs);
    return name;
}

Bytes globalConfig(const Traits &traits, const BoardOptions &options)
{
    const auto streams = static_cast<std::uint32_t>(options.streams);
    const bool onB = options.linkId == 1;
    return ByteWriter()
        .u32(traits.sdkVersion)
        .u8(1) // motors
        .u8(onB ? 4 : 2) // which links can stream
        .u8(onB ? 0 : streams)
        .u8(onB ? streams : 0)
        .u8(0) // streams over ST-LINK
        .u8(0)
        .take();
}

Bytes motorConfig(const Firmware &firmware)
{
    const PmsmParameters &motor = firmware.motor().parameters();
    const auto f32 = [](double value) { return static_cast<float>(value); };
    ByteWriter out;
    out.f32(f32(motor.polePairs)).f32(1.0F).f32(f32(motor.rs_ohm)).f32(0.0F);
    out.f32(f32(motor.lq_h))
        .f32(f32(motor.ld_h))
        .f32(f32(firmware.stage().nominal_a))
        .f32(0.0F)
        .f32(0.0F);
    out.text(kMotorName);
    Bytes bytes = out.take();
    bytes.resize(60);
    return bytes;
}

Bytes applicationConfig(const Traits &traits, const Firmware &firmware)
{
    const Stage &stage = firmware.stage();
    ByteWriter out;
    out.u32(static_cast<std::uint32_t>(stage.maxSpeed_rpm))
        .f32(static_cast<float>(stage.maxReadable_a));
    if (traits.asPrinted)
        out.u16(static_cast<std::uint32_t>(std::lround(stage.nominal_a / stage.ampsPerDigit())));
    else
        out.f32(static_cast<float>(stage.nominal_a));
    return out.u16(static_cast<std::uint32_t>(stage.nominal_v)).u8(0).u8(0).take();
}

Bytes focFirmwareConfig(const Traits &traits, const Firmware &firmware)
{
    constexpr std::uint32_t kObserverPll = 1, kHall = 4, kBusAndTemperature = 0x0600;
    return ByteWriter()
        .u8(kObserverPll)
        .u8(traits.hasHall ? kHall : 0)
        .u8(0) // three shunts
        .u8(1) // one control period a PWM period
        .u32(static_cast<std::uint32_t>(std::lround(firmware.hfHz())))
        .u16(Firmware::kMfHz)
        .u16(kBusAndTemperature)
        .u16(0)
        .take();
}

double fullScaleSpeedDigit_rpm(const Firmware &firmware)
{
    return 1.15 * firmware.stage().maxSpeed_rpm / 32768.0;
}

Bytes scaleConfig(const Traits &traits, const Firmware &firmware)
{
    const Stage &stage = firmware.stage();
    const double speed_rpm = traits.scalesReadSpeeds ? fullScaleSpeedDigit_rpm(firmware) : 6.0;
    return ByteWriter()
        .f32(static_cast<float>(stage.voltsPerDigit()))
        .f32(static_cast<float>(stage.ampsPerDigit()))
        .f32(static_cast<float>(speed_rpm))
        .take();
}

} // namespace simulation
