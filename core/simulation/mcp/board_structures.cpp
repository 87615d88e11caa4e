// The structures, field by field.
#include "simulation/mcp/board_structures.h"

#include "simulation/mcp/per_unit.h"
#include "simulation/simulated_board.h"

#include <array>
#include <cmath>

namespace simulation {

namespace {

std::uint32_t hertz(const RegisterContext &at)
{
    return static_cast<std::uint32_t>(std::lround(at.firmware.hfHz()));
}

constexpr std::uint32_t bit(bool set, unsigned position) { return (set ? 1U : 0U) << position; }

std::uint32_t configurationFlag1(const Build &b)
{
    constexpr std::uint32_t kBusAndTemperature = 0x0600;
    return kBusAndTemperature | bit(b.fluxWeakening, 0) | bit(b.feedForward, 1) | bit(b.mtpa, 2)
        | bit(b.pfc, 3) | bit(b.positionControl, 8) | bit(b.dac, 13) | bit(b.dac, 14);
}

std::uint32_t configurationFlag2(const Build &b)
{
    return bit(b.ipd, 11) | bit(b.currentMonitor, 12) | bit(b.profiler, 13) | bit(b.cpuLoad, 14)
        | bit(b.openLoopDebug, 15);
}

/// What a six-step firmware says under the same name: ticks of its timers, not units. A Controller leaves it alone.
Bytes sixStepScale(const RegisterContext &at)
{
    constexpr double kTimer_hz = 48e6, kVolts_v = 1000.0, kGain = 0.02 * 10.0;
    const double period = kTimer_hz / at.firmware.hfHz();
    const double nominal_v = at.firmware.stage().nominal_v;
    return ByteWriter()
        .f32(static_cast<float>(kVolts_v * period / (nominal_v * nominal_v)))
        .f32(static_cast<float>(period * 1000.0 * kGain))
        .f32(static_cast<float>(period / 4.0))
        .take();
}

} // namespace

std::string firmwareName(const RegisterContext &at)
{
    std::string name(at.traits.firmwareName);
    if (at.options.watchdogMs > 0)
        name += " RSWD" + std::to_string(at.options.watchdogMs);
    return name;
}

std::string powerStageName(const RegisterContext &at)
{
    return "Simulated" + std::to_string(std::lround(at.firmware.stage().nominal_v)) + 'V';
}

std::string motorName(const RegisterContext &at)
{
    constexpr std::size_t kNameMax = 23; // MOTOR_CONFIG ends in a zero
    return motorOf(at.firmware).name.substr(0, kNameMax);
}

Bytes globalConfig(const RegisterContext &at)
{
    const auto streams = static_cast<std::uint32_t>(at.build.sixStep() ? 0 : at.options.streams);
    const bool onB = at.options.linkId == 1;
    const std::uint32_t links = streams == 0 ? 0 : onB ? 4 : 2;
    return ByteWriter()
        .u32(at.traits.sdkVersion)
        .u8(static_cast<std::uint32_t>(at.build.motors))
        .u8(links) // which links can stream
        .u8(onB ? 0 : streams)
        .u8(onB ? streams : 0)
        .u8(0) // streams over ST-LINK
        .u8(0)
        .take();
}

Bytes motorConfig(const RegisterContext &at)
{
    const MotorParameters &motor = motorOf(at.firmware);
    const auto f32 = [](double value) { return static_cast<float>(value); };
    ByteWriter out;
    // "Rated flux" is V/Hz in HSO builds only: a captured standard board of 17 V and 1596 rpm says 8.2 here, which can
    // but be V/krpm.
    const double flux = at.build.hso() ? fluxVoltsPerHertz(at.firmware) : voltsPerKrpm(at.firmware);
    out.f32(f32(motor.polePairs)).f32(f32(flux));
    out.f32(f32(motor.rs_ohm)).f32(0.0F); // skin factor
    out.f32(f32(motor.lq_h))
        .f32(f32(motor.ld_h))
        .f32(f32(at.firmware.stage().nominal_a))
        .f32(at.build.hso() ? f32(motor.copperMass_kg) : 0.0F)
        .f32(at.build.hso() ? f32(motor.coolingTime_s) : 0.0F);
    constexpr std::size_t kSize = 60;
    out.text(motorName(at));
    Bytes bytes = out.take();
    bytes.resize(kSize);
    return bytes;
}

Bytes applicationConfig(const RegisterContext &at)
{
    const Stage &stage = at.firmware.stage();
    ByteWriter out;
    out.u32(static_cast<std::uint32_t>(stage.maxSpeed_rpm))
        .f32(static_cast<float>(stage.maxReadable_a));
    if (at.traits.nominalCurrentInDigits)
        out.u16(static_cast<std::uint32_t>(std::lround(stage.nominal_a / stage.ampsPerDigit())));
    else
        out.f32(static_cast<float>(stage.nominal_a));
    return out.u16(static_cast<std::uint32_t>(stage.nominal_v))
        .u8(at.build.sixStep() ? 1 : 0) // drive type
        .u8(0)
        .take();
}

Bytes firmwareConfig(const RegisterContext &at)
{
    const Build &build = at.build;
    constexpr std::uint32_t kThreeShunts = 0, kVoltageMode = 0;
    ByteWriter out;
    out.u8(static_cast<std::uint32_t>(build.mainSensor));
    if (!build.sixStep())
        out.u8(static_cast<std::uint32_t>(build.auxiliarySensor));
    out.u8(kThreeShunts);
    if (!build.sixStep())
        out.u8(1); // one control period a PWM period
    out.u32(hertz(at)).u16(Firmware::kMfHz);
    out.u16(configurationFlag1(build)).u16(configurationFlag2(build));
    if (build.sixStep())
        out.u8(kVoltageMode);
    return out.take();
}

double fullScaleSpeedDigit_rpm(const Firmware &firmware)
{
    return 1.15 * firmware.stage().maxSpeed_rpm / 32768.0;
}

Bytes scaleConfig(const RegisterContext &at)
{
    const auto three = [](double voltage, double current, double frequency) {
        return ByteWriter()
            .f32(static_cast<float>(voltage))
            .f32(static_cast<float>(current))
            .f32(static_cast<float>(frequency))
            .take();
    };
    if (at.build.sixStep())
        return sixStepScale(at);
    if (at.build.hso()) {
        const PerUnitBases bases = perUnitBases(at.firmware);
        return three(bases.voltage_v, bases.current_a, bases.frequency_hz);
    }
    const Stage &stage = at.firmware.stage();
    return three(stage.voltsPerDigit(), stage.ampsPerDigit(),
        at.traits.scalesReadSpeeds ? fullScaleSpeedDigit_rpm(at.firmware) : 6.0);
}

Bytes bemfSensingConfig(const RegisterContext &at)
{
    // Thresholds and sampling points in percent, delays, demagnetisation times, filters.
    constexpr std::array<std::uint16_t, kBemfSensingWords> kDefaults{
        5, 30, 5, 50, 50, 1, 1, 3, 1000, 60, 40, 2, 10};
    ByteWriter out;
    for (std::size_t i = 0; i < kBemfSensingWords; ++i) {
        const auto written = at.kept.find(bemfSensingKey(i));
        out.u16(written == at.kept.end() ? kDefaults[i] : written->second);
    }
    return out.take();
}

} // namespace simulation
