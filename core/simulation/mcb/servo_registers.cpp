// The registers of a servo: those of the dictionary with values after power-on, what lives among them, and what is
// taken from them.
#include "simulation/mcb/servo.h"

#include "mcb/dictionary.h"
#include "mcb/mapping.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace simulation {
namespace {

mcb::Words floatWords(double value)
{
    return mcb::wordsOfNumber(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}

mcb::Words wholeWords(std::int64_t value, std::size_t bytes)
{
    return mcb::wordsOfNumber(static_cast<std::uint64_t>(value), bytes);
}

float floatAt(const McbRegisters &registers, std::uint16_t address)
{
    const float value = std::bit_cast<float>(registers.numberAt(address));
    return std::isfinite(value) ? value : 0.0F;
}

/// The exponents of two and numerators behind a gain, in the order of Servo::gains().
struct GainPlace {
    std::uint16_t address;
    std::int16_t Tuning::*numerator;
    std::int16_t Tuning::*exponent;
    enum class Unit : std::uint8_t {
        VoltPerAmp,
        VoltPerAmpSecond,
        AmpPerTurn,
        AmpPerTurnSecond,
        Position
    } unit;
};
using Unit = GainPlace::Unit;
constexpr std::array<GainPlace, 9> kGains{
    GainPlace{0x500, &Tuning::qKp, &Tuning::qKpDiv, Unit::VoltPerAmp},
    GainPlace{0x501, &Tuning::qKi, &Tuning::qKiDiv, Unit::VoltPerAmpSecond},
    GainPlace{0x505, &Tuning::dKp, &Tuning::dKpDiv, Unit::VoltPerAmp},
    GainPlace{0x506, &Tuning::dKi, &Tuning::dKiDiv, Unit::VoltPerAmpSecond},
    GainPlace{0x50A, &Tuning::speedKp, &Tuning::speedKpDiv, Unit::AmpPerTurn},
    GainPlace{0x50B, &Tuning::speedKi, &Tuning::speedKiDiv, Unit::AmpPerTurnSecond},
    GainPlace{0x511, &Tuning::positionKp, &Tuning::positionKpDiv, Unit::Position},
    GainPlace{0x512, &Tuning::positionKi, &Tuning::positionKiDiv, Unit::Position},
    GainPlace{0x513, &Tuning::positionKd, &Tuning::positionKdDiv, Unit::Position},
};

/// What 1.0 digit a digit is worth. The position loop of the firmware makes torque of an angle, that of a real servo
/// speed: its gains are shown as the firmware has them.
double worthOf(Unit unit, const Firmware &firmware)
{
    constexpr double kDigitsPerTurn = 10.0; // 0.1 Hz
    const double amps = firmware.stage().ampsPerDigit();
    const double volts = firmware.stage().voltsPerDigit();
    switch (unit) {
    case Unit::VoltPerAmp:
        return volts / amps;
    case Unit::VoltPerAmpSecond:
        return volts / amps * firmware.hfHz();
    case Unit::AmpPerTurn:
        return kDigitsPerTurn * amps;
    case Unit::AmpPerTurnSecond:
        return kDigitsPerTurn * amps * Firmware::kMfHz;
    case Unit::Position:
        break;
    }
    return 1.0;
}

} // namespace

std::array<float, 9> Servo::gains() const
{
    std::array<float, 9> values{};
    const Firmware &firmware = m_axis.firmware;
    const Tuning &tuning = firmware.tuning();
    for (std::size_t i = 0; i < kGains.size(); ++i)
        values[i] =
            static_cast<float>(scaledGain(tuning.*kGains[i].numerator, tuning.*kGains[i].exponent)
                * worthOf(kGains[i].unit, firmware));
    return values;
}

/// Numerators change, exponents stay: a gain beyond what 16 bits hold with them is cut.
void Servo::adoptGains()
{
    Firmware &firmware = m_axis.firmware;
    Tuning &tuning = firmware.tuning();
    for (std::size_t i = 0; i < kGains.size(); ++i) {
        if (m_wanted.gains[i] == m_followed.gains[i])
            continue;
        const double digits =
            static_cast<double>(m_wanted.gains[i]) / worthOf(kGains[i].unit, firmware);
        const double numerator =
            std::ldexp(digits, std::clamp<int>(tuning.*kGains[i].exponent, 0, 31));
        tuning.*kGains[i].numerator =
            static_cast<std::int16_t>(std::clamp(std::nearbyint(numerator), -32767.0, 32767.0));
    }
    m_followed.gains = m_wanted.gains;
}

McbRig Servo::rig() const
{
    McbRig rig;
    constexpr std::uint8_t kTextBytes = 24;
    for (const mcb::Entry &entry : mcb::dictionary()) {
        McbRegister content{entry.info, {}};
        if (entry.info.size == 0)
            content.info.size = kTextBytes;
        content.words.resize(mcb::wordsOf(content.info.size));
        const bool voltage = entry.address >= 0x068 && entry.address <= 0x06A;
        const bool gain = entry.address >= 0x50A && entry.address <= 0x516;
        if (m_servo.newer && voltage)
            content.info = {4, mcb::Type::Float, mcb::Cyclic::Tx, catalog::Access::Read};
        else if (m_servo.newer && gain)
            content.info.cyclic = mcb::Cyclic::Rx;
        rig.registers[entry.address] = std::move(content);
    }
    const auto put = [&](std::uint16_t address, mcb::Words words) {
        words.resize(rig.registers[address].words.size());
        rig.registers[address].words = std::move(words);
    };
    const auto text = [&](std::uint16_t address, const std::string &content) {
        const McbRegister &at = rig.registers[address];
        put(address, mcb::encodeValue(at.info, content, m_servo.order).value_or(mcb::Words()));
    };
    const PlantParameters &plant = m_axis.plant.parameters();
    const Stage &stage = m_axis.firmware.stage();
    const double maxTurns = stage.maxSpeed_rpm / 60.0;
    put(0x014, {3});
    put(0x025, floatWords(maxTurns));
    put(0x026, floatWords(50.0));
    put(0x027, floatWords(50.0));
    put(0x100, floatWords(plant.motor.nominal_a));
    put(0x101, floatWords(plant.motor.nominal_a));
    put(0x106, wholeWords(plant.motor.polePairs, 2));
    put(0x1E0, floatWords(plant.motor.nominal_a));
    put(0x1E8, floatWords(maxTurns));
    put(0x388, wholeWords(4LL * plant.sensors.encoderPulses, 4));
    put(0x520, wholeWords(Firmware::kMfHz, 4));
    put(0x6E0, wholeWords(0x29C, 4)); // invented, as in the vectors
    put(0x6E1, wholeWords(0x0A11, 4));
    put(0x6E2, wholeWords(1, 4));
    put(0x6E6, wholeWords(1, 4));
    text(0x6E4, m_servo.newer ? "2.4.0" : "1.12.0");
    text(0x6E5, "http://www.example.com");
    put(0x700, wholeWords(static_cast<std::int64_t>(m_hfHz), 4));
    put(0x710, floatWords(100.0));
    put(0x712, floatWords(m_axis.firmware.tuning().overVoltage_v));
    put(0x713, floatWords(m_axis.firmware.tuning().underVoltage_v));
    put(0x71D, floatWords(plant.motor.nominal_a));
    put(0x71F, floatWords(stage.maxReadable_a));
    put(0x720, floatWords(stage.maxReadable_a));
    put(0x732, floatWords(stage.busFullScale_v));
    const auto values = gains();
    for (std::size_t i = 0; i < kGains.size(); ++i)
        put(kGains[i].address, floatWords(static_cast<double>(values[i])));
    return rig;
}

void Servo::show(McbRegisters &registers)
{
    const Firmware &firmware = m_axis.firmware;
    const Signals &s = firmware.variables();
    const double amps = firmware.stage().ampsPerDigit(), volts = firmware.stage().voltsPerDigit();
    const double counts = static_cast<double>(s.position_rad) / radPerCount();
    const auto put = [&registers](std::uint16_t address, mcb::Words words) {
        registers.put(address, words);
    };
    put(0x00F, wholeWords(m_lastError, 4));
    put(0x011, {statusWord()});
    put(0x015, {m_wanted.mode});
    put(0x030, wholeWords(std::llround(std::clamp(counts, -2e9, 2e9)), 4));
    put(0x031, floatWords(firmware.speed_rpm() / 60.0));
    const double iA = s.iA * amps, iB = s.iB * amps;
    put(0x038, floatWords(iA));
    put(0x039, floatWords(iB));
    put(0x03A, floatWords(-iA - iB));
    put(0x03B, floatWords(s.iQ * amps));
    put(0x03C, floatWords(s.iD * amps));
    put(0x03D, {m_axis.plant.currentA()});
    put(0x03E, {m_axis.plant.currentB()});
    put(0x040, floatWords(s.encoderAngle / 65536.0));
    put(0x060, floatWords(m_axis.plant.bus_v()));
    put(0x061, floatWords(s.temperature_c));
    put(0x063, floatWords(m_axis.plant.winding_c()));
    put(0x067, floatWords(s.temperature_c));
    put(0x070, floatWords(s.vQ * volts));
    put(0x071, floatWords(s.vD * volts));
    put(0x072, floatWords(s.iQRef * amps));
    put(0x073, floatWords(s.iDRef * amps));
    put(0x079, floatWords(speedReference_rpm() / 60.0));
    put(0x38B, wholeWords(m_axis.plant.encoderCount(), 4));
    put(0x64D, wholeWords(m_lastError != 0 ? 1 : 0, 2));
    put(0x64F, wholeWords(m_lastError, 4));
}

void Servo::look(const McbRegisters &registers)
{
    Wanted wanted;
    wanted.control = static_cast<std::uint16_t>(registers.numberAt(0x010));
    wanted.mode = static_cast<std::uint16_t>(registers.numberAt(0x014));
    wanted.iq_a = floatAt(registers, 0x01A);
    wanted.id_a = floatAt(registers, 0x01B);
    wanted.velocity_rps = floatAt(registers, 0x021);
    wanted.position_cnt = static_cast<std::int32_t>(registers.numberAt(0x020));
    wanted.maxVelocity = floatAt(registers, 0x025);
    wanted.maxAcceleration = floatAt(registers, 0x026);
    wanted.currentLimit_a = floatAt(registers, 0x1E0);
    wanted.velocityLimit_rps = floatAt(registers, 0x1E8);
    for (std::size_t i = 0; i < kGains.size(); ++i)
        wanted.gains[i] = floatAt(registers, kGains[i].address);
    m_wanted = wanted;
    if (wanted.control != m_lastControl)
        obey(wanted.control);
    m_resetWanted = registers.numberAt(0x6DF) != 0;
}

} // namespace simulation
