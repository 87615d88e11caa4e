// The scalar registers of the HSO/ZeST family. The motor behind them is controlled by the same firmware as the others:
// its signals are shown per unit of the bases in SCALE_CONFIG, what only tunes the HSO is kept without effect.
// Source: registers.csv, rows of family hso (firmware 6.4.2).
#include "simulation/mcp/per_unit.h"
#include "simulation/mcp/register_table.h"

#include <array>
#include <cmath>
#include <numbers>

namespace simulation {

namespace {

using Row = RegisterRow;
using enum mcp::RegisterType;
using enum RegisterRow::Scope;
using mcp::Status;
using At = const RegisterContext;

constexpr bool zest(const Build &b) { return b.zest; }
constexpr bool withoutZest(const Build &b) { return !b.zest; }
constexpr bool profiler(const Build &b) { return b.profiler; }
constexpr bool cpuLoad(const Build &b) { return b.cpuLoad; }
constexpr bool dac(const Build &b) { return b.dac; }
constexpr bool potentiometer(const Build &b) { return b.potentiometer; }

constexpr double kRoot3 = std::numbers::sqrt3;

Status ignore(RegisterContext &, std::uint32_t) { return Status::Ok; }

// Phases from the two axes; the second lags the first by 120 degrees as the firmware counts them.
double second(double alpha, double beta) { return (-alpha - kRoot3 * beta) / 2.0; }
double third(double alpha, double beta) { return (-alpha + kRoot3 * beta) / 2.0; }

template <auto Member>
std::uint32_t current(At &at)
{
    return currentQ30(at.firmware, at.firmware.variables().*Member);
}

template <auto Member>
std::uint32_t voltage(At &at)
{
    return voltageQ30(at.firmware, at.firmware.variables().*Member);
}

std::uint32_t thirdCurrent(At &at)
{
    const Signals &s = at.firmware.variables();
    return currentQ30(at.firmware, -static_cast<double>(s.iA) - s.iB);
}

std::uint32_t secondVoltage(At &at)
{
    const Signals &s = at.firmware.variables();
    return voltageQ30(at.firmware, second(s.vAlpha, s.vBeta));
}

std::uint32_t thirdVoltage(At &at)
{
    const Signals &s = at.firmware.variables();
    return voltageQ30(at.firmware, third(s.vAlpha, s.vBeta));
}

/// Digits of a voltage as a share of the bus, full modulation being 1.
std::uint32_t dutyQ30(double digits) { return q30(digits / 32767.0); }

std::uint32_t frequency(At &at)
{
    return q30(electricalHz(at.firmware, at.firmware.variables().pllSpeed)
        / perUnitBases(at.firmware).frequency_hz);
}

double reference_hz(At &at)
{
    return electricalHz(at.firmware, at.firmware.speedReference_rpm() / 6.0);
}

Status setFrequency(RegisterContext &at, std::uint32_t value)
{
    const double hz =
        static_cast<std::int32_t>(value) / kQ30 * perUnitBases(at.firmware).frequency_hz;
    const double rpm = hz * 60.0 / polePairs(at.firmware);
    at.firmware.rampSpeed(
        {static_cast<std::int16_t>(std::lround(std::clamp(rpm, -32768.0, 32767.0))),
            speedRampTime_ms(at, std::abs(hz - reference_hz(at)))});
    return Status::Ok;
}

std::uint32_t amps(At &at, double digits)
{
    return q16(digits * at.firmware.stage().ampsPerDigit());
}

std::int16_t digitsOf(RegisterContext &at, double amps)
{
    const double digits = amps / at.firmware.stage().ampsPerDigit();
    return static_cast<std::int16_t>(std::clamp(digits, -32768.0, 32767.0));
}

Status setIq(RegisterContext &at, std::uint32_t value)
{
    at.firmware.setCurrentReferences(digitsOf(at, fromQ16(value)), at.firmware.variables().iDRef);
    return Status::Ok;
}

Status setId(RegisterContext &at, std::uint32_t value)
{
    at.firmware.setCurrentReferences(at.firmware.variables().iQRef, digitsOf(at, fromQ16(value)));
    return Status::Ok;
}

Status setTorque(RegisterContext &at, std::uint32_t value)
{
    const double perAmp = torquePerAmp_nm(at.firmware);
    at.firmware.rampTorque({digitsOf(at, perAmp > 0.0 ? fromQ16(value) / perAmp : 0.0), 0});
    return Status::Ok;
}

Status setControlMode(RegisterContext &at, std::uint32_t value)
{
    at.firmware.setControlMode(static_cast<std::uint8_t>(value));
    return Status::Ok;
}

/// FOC_MODULATIONMODE: what is out of range becomes 0.
Status setModulation(RegisterContext &at, std::uint32_t value)
{
    constexpr mcp::RegisterId kModulationMode = mcp::registerId(4, Bits8, 0);
    at.kept[kModulationMode.bits] = value <= 5 ? value : 0;
    return Status::Ok;
}

constexpr Row q(unsigned element, Row::Get get) { return computed(element, Bits32, get); }
constexpr Row f32(unsigned element, float initial = 0.0F)
{
    return kept(element, Bits32, std::bit_cast<std::uint32_t>(initial));
}
/// Kept, and until something is written what `get` works out.
constexpr Row from(Row row, Row::Get get)
{
    row.get = get;
    return row;
}
constexpr Row readOnly(Row row)
{
    row.keeps = false;
    if (row.get == nullptr)
        row.get = [](At &) { return 0U; };
    return row;
}

std::uint32_t resistance(At &at, double one)
{
    return static_cast<std::uint32_t>(std::lround(motorOf(at.firmware).rs_ohm * one));
}
std::uint32_t inductance(At &at, double one)
{
    return static_cast<std::uint32_t>(std::lround(motorOf(at.firmware).lq_h * one));
}
std::uint32_t flux(At &at)
{
    return static_cast<std::uint32_t>(std::lround(fluxVoltsPerHertz(at.firmware) * kQ24));
}

constexpr std::array kRows{
    computed(1, Bits8, [](At &at) { return asWire(at.firmware.state()); }), // STATUS
    computed(2, Bits8, [](At &at) { return asWire(at.firmware.controlMode()); })
        .settable(setControlMode),
    computed(3, Bits8, [](At &at) { return asWire(at.firmware.controlMode()); }).silent(),
    kept(4, Bits8).settable(setModulation), // FOC_MODULATIONMODE
    kept(7, Bits8), // FOC_SPEED_SOURCE_SELECT
    kept(8, Bits8), // FOC_RS_UPDATE_SELECT
    kept(9, Bits8), // OVS_SAMPLESELECT
    kept(10, Bits8), // FOC_CURRENTRECONSTRUCTION
    writeOnly(11, Bits8).in(profiler).unreadable(Status::WriteOnly), // PROFILER_COMMAND
    computed(12, Bits8, [](At &) { return 0U; }).in(profiler), // PROFILER_STATE

    kept(2, Bits16), // FOC_CURRENTRECONSTRUCTION_LIMIT
    kept(3, Bits16, 0x0004), // START_CONFIGURATION: offset measurement
    kept(4, Bits16).in(dac).at(Board), // DAC_OUT1
    kept(5, Bits16).in(dac).at(Board), // DAC_OUT2
    kept(6, Bits16, 16), // FOC_PULSE_DURATION
    kept(7, Bits16, 16), // FOC_PULSE_DECAY_DURATION
    measured<&Signals::temperature_c>(8),

    q(0, [](At &at) { return at.firmware.faultFlags(); }).settable(ignore),
    q(1, current<&Signals::iA>).forDatalog(), // ADC_I_U
    q(2, current<&Signals::iB>).forDatalog(), q(3, thirdCurrent).forDatalog(),
    q(4, voltage<&Signals::vAlpha>).forDatalog(), // ADC_U_U
    q(5, secondVoltage).forDatalog(), q(6, thirdVoltage).forDatalog(),
    q(7, current<&Signals::iAlpha>).onlyForDatalog(),
    q(8, current<&Signals::iBeta>).onlyForDatalog(),
    q(9, voltage<&Signals::vAlpha>).onlyForDatalog(),
    q(10, voltage<&Signals::vBeta>).onlyForDatalog(), q(11, current<&Signals::iD>).forDatalog(),
    q(12, current<&Signals::iQ>).forDatalog(), q(13, voltage<&Signals::vD>).onlyForDatalog(),
    q(14, voltage<&Signals::vQ>).onlyForDatalog(),
    q(15, current<&Signals::iA>).onlyForDatalog(), // ADC_I_RAW_U
    q(16, current<&Signals::iB>).onlyForDatalog(), q(17, thirdCurrent).onlyForDatalog(),
    q(18, frequency).onlyForDatalog(), // FE_HSO
    q(19, [](At &at) { return q30(std::cos(angle_rad(at.firmware))); }).forDatalog(), // HSO_FLUX_A
    q(20, [](At &at) { return q30(std::sin(angle_rad(at.firmware))); }).forDatalog(),
    q(30,
        [](At &at) {
            return q30(at.firmware.variables().busVoltage_v / perUnitBases(at.firmware).voltage_v);
        }), // ADC_U_DC
    readOnly(kept(31, Bits32)), // offsets of three currents and three voltages
    readOnly(kept(32, Bits32)), readOnly(kept(33, Bits32)), readOnly(kept(34, Bits32)),
    readOnly(kept(35, Bits32)), readOnly(kept(36, Bits32)), kept(37, Bits32), // FOC_OPENLOOP_ANGLE
    q(38, [](At &at) { return asWire(static_cast<float>(at.firmware.speed_rpm())); }).silent(),
    kept(39, Bits32), // FOC_VDREF
    q(42,
        [](At &at) {
            return q16(at.firmware.torqueReference() * at.firmware.stage().ampsPerDigit()
                * torquePerAmp_nm(at.firmware));
        })
        .settable(setTorque),
    readOnly(kept(43, Bits32)).in(potentiometer), // THROTTLE_ADC
    readOnly(kept(44, Bits32)).in(potentiometer), // THROTTLE_POS
    q(45, [](At &at) { return resistance(at, kQ24); }).settable(ignore), // RS
    q(46, [](At &at) { return inductance(at, kQ30); }).settable(ignore), // LS
    f32(47, 1.0F), // FOC_KP_IDQ
    f32(48, 1000.0F), // FOC_WI_IDQ
    f32(49, 0.01F), // FOC_KP_SPD
    f32(50, 0.1F), // FOC_KI_SPD
    q(51,
        [](At &at) {
            return q30(electricalHz(at.firmware, at.firmware.lastSpeedRamp().rpm / 6.0)
                / perUnitBases(at.firmware).frequency_hz);
        })
        .settable(setFrequency), // FOC_SPEEDREF_FREQ_PU; the next one follows its ramp
    q(52, [](At &at) { return q30(reference_hz(at) / perUnitBases(at.firmware).frequency_hz); })
        .settable(setFrequency),
    kept(53, Bits32, kSpeedRamp_hzps << 16), // FOC_SPEEDRAMP
    writeOnly(54, Bits32), // FOC_TORQUERAMP
    q(55,
        [](At &at) {
            return q16(at.firmware.variables().iQ * at.firmware.stage().ampsPerDigit()
                * torquePerAmp_nm(at.firmware));
        })
        .silent(), // FOC_TORQUE_NM
    q(56,
        [](At &at) {
            return q16(electricalHz(at.firmware, at.firmware.variables().pllSpeed));
        }), // FOC_FELEC_HZ
    kept(57, Bits32).in(zest), // FOC_ID_INJECT_A
    q(58, [](At &at) { return resistance(at, kQ16); }).settable(ignore), // FOC_RS_EST
    from(kept(59, Bits32), [](At &at) { return q16(at.firmware.stage().nominal_a); }),
    q(60, [](At &at) { return inductance(at, kQ30); }).settable(ignore), // FOC_LS_EST
    from(kept(61, Bits32), flux), // FOC_FLUX_RATED_VPHZ
    q(62, flux).silent(), // FOC_FLUX_VPHZ
    kept(63, Bits32, 1000U << 16).in(zest), // FOC_INJECTFREQ_HZ
    kept(64, Bits32).in(zest), // FOC_GAIN_D
    kept(65, Bits32).in(zest), // FOC_GAIN_Q
    q(66, [](At &at) { return dutyQ30(at.firmware.variables().vD); }).silent(), // FOC_DUTYCYCLE_D
    q(67, [](At &at) { return dutyQ30(at.firmware.variables().vQ); }).silent(),
    q(68, [](At &at) { return q30(angle_rad(at.firmware) / (2.0 * std::numbers::pi)); })
        .forDatalog(), // FOC_ANGLE_PU
    from(kept(69, Bits32), [](At &at) { return resistance(at, kQ20); }), // FOC_RS_RATED
    from(kept(70, Bits32), [](At &at) { return resistance(at, kQ20); }), // FOC_RS_ACTIVE
    from(kept(71, Bits32), [](At &at) { return inductance(at, kQ24); }), // FOC_LS_RATED
    from(kept(72, Bits32), [](At &at) { return inductance(at, kQ24); }), // FOC_LS_ACTIVE
    kept(73, Bits32, 1U << 30), // MAXMODULATION
    readOnly(kept(74, Bits32)).in(zest), // FOC_ZEST_OUTD
    readOnly(kept(75, Bits32)).in(zest), // FOC_ZEST_OUTQ
    kept(76, Bits32), // FOC_ANGLE_COMP_FACTOR
    q(78, [](At &at) { return amps(at, at.firmware.torqueReference()); }).silent(),
    q(79, [](At &at) { return amps(at, at.firmware.variables().iDRef); }).settable(setId),
    q(80, [](At &at) { return amps(at, at.firmware.variables().iQRef); }).settable(setIq),
    from(kept(81, Bits32),
        [](At &at) { return asWire(static_cast<float>(polePairs(at.firmware))); }),
    readOnly(f32(82)).in(profiler), // PROFILER_RS_DC
    readOnly(f32(83)).in(profiler), readOnly(f32(84)).in(profiler),
    readOnly(f32(85)).in(profiler), // PROFILER_FLUX_WB
    f32(86).in(profiler), // PROFILER_POWERGOAL_W
    f32(87).in(profiler), // PROFILER_FLUXESTFREQ_HZ
    measured<&Signals::cpuLoad>(88).in(cpuLoad).at(Board),
    measured<&Signals::cpuLoadMin>(89).in(cpuLoad).at(Board),
    measured<&Signals::cpuLoadMax>(90).in(cpuLoad).at(Board),
    q(106, [](At &at) { return dutyQ30(at.firmware.variables().vAlpha); }).onlyForDatalog(),
    q(107,
        [](At &at) {
            const Signals &s = at.firmware.variables();
            return dutyQ30(second(s.vAlpha, s.vBeta));
        })
        .onlyForDatalog(),
    q(108,
        [](At &at) {
            const Signals &s = at.firmware.variables();
            return dutyQ30(third(s.vAlpha, s.vBeta));
        })
        .onlyForDatalog(),
    f32(110, 1.0F), // FOC_PULSE_CURRENT_GOAL
    readOnly(kept(111, Bits32)), // FOC_PULSE_DUTY
    readOnly(kept(112, Bits32)), // FOC_PULSE_EST_ANGLE
    f32(113, 1.0F), // FOC_KSAMPLE_DELAY
    readOnly(f32(114)), // RSEST_RSOHM
    readOnly(f32(115)), // RSEST_RSPOWEROHM
    f32(117).in(zest), // FOC_SKINFACTOR
    q(117, [](At &) { return 0U; }).settable(ignore).in(withoutZest),
    readOnly(kept(118, Bits32)), // FOC_ZEST_CORRECTION
    readOnly(kept(119, Bits32)).in(zest).onlyForDatalog(), // ANG_SPEED
    readOnly(kept(120, Bits32)).in(zest).onlyForDatalog(),
    readOnly(kept(121, Bits32)).in(zest).onlyForDatalog(),
    readOnly(kept(122, Bits32)).in(zest).onlyForDatalog(),
    readOnly(kept(123, Bits32)).in(zest).onlyForDatalog(), // ZEST_FRACTION
    q(124, [](At &at) { return resistance(at, kQ20); }), // FOC_RS_TEMP_ALGO
    q(125, [](At &at) { return resistance(at, kQ20); }), // FOC_RS_EST_ALGO
    q(126, [](At &) { return 1U; }).in(zest).at(Board), // HSO_ZEST_REVISION
};

} // namespace

std::span<const RegisterRow> hsoRegisters() { return kRows; }

} // namespace simulation
