#include "catalog/catalog.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace catalog {

namespace {

// The motor is in the low bits of an identifier; protocols that have it elsewhere put it there.
constexpr RegisterId kMotorBits = 7;

std::string hexName(RegisterId id) { return "0x" + hexDigits(id, id > 0xFFFF ? 8 : 4); }

Scale digits(double perDigit, std::string_view unit, const RegisterInfo &info, double fixedPoint)
{
    if (!(perDigit > 0.0) || !std::isfinite(perDigit))
        return {1.0, info.fractionBits > 0 ? std::string() : info.unit};
    return {perDigit * fixedPoint, std::string(unit)};
}

} // namespace

std::string upper(std::string_view text)
{
    std::string result(text);
    for (char &c : result)
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    return result;
}

Catalog::Catalog(std::vector<RegisterInfo> registers, int motors, std::vector<Scales> scales,
    const StartRegisters &start)
    : m_registers(std::move(registers))
    , m_motors(std::clamp(motors, 1, static_cast<int>(kMotorBits)))
    , m_scales(std::move(scales))
    , m_start(start)
{
    m_scales.resize(static_cast<std::size_t>(m_motors));
    for (std::size_t i = 0; i < m_registers.size(); ++i) {
        m_byId.emplace(m_registers[i].id, i);
        m_byName.emplace(upper(m_registers[i].name), i);
    }
    // After all names: an alias never hides a register's own name.
    for (std::size_t i = 0; i < m_registers.size(); ++i)
        for (const std::string &alias : m_registers[i].aliases)
            m_byName.emplace(upper(alias), i);
}

const RegisterInfo *Catalog::find(RegisterId id) const
{
    const auto at = m_byId.find(id & ~kMotorBits);
    return at == m_byId.end() ? nullptr : &m_registers[at->second];
}

const RegisterInfo *Catalog::find(std::string_view name) const
{
    const auto at = m_byName.find(upper(name));
    return at == m_byName.end() ? nullptr : &m_registers[at->second];
}

std::optional<RegisterId> Catalog::resolve(std::string_view nameAtMotor) const
{
    const std::size_t at = nameAtMotor.find('@');
    const RegisterInfo *info = find(nameAtMotor.substr(0, at));
    if (info == nullptr)
        return std::nullopt;
    if (at == std::string_view::npos)
        return withMotor(*info, 1);

    const std::string_view digits = nameAtMotor.substr(at + 1);
    const auto motor = numberIn<int>(digits);
    if (!motor || !info->perMotor || *motor < 1 || *motor > m_motors)
        return std::nullopt;
    return withMotor(*info, *motor);
}

RegisterId Catalog::withMotor(const RegisterInfo &info, int motor)
{
    return info.perMotor ? info.id | (static_cast<RegisterId>(motor) & kMotorBits) : info.id;
}

int Catalog::motorOf(RegisterId id) const { return static_cast<int>(id & kMotorBits); }

std::string Catalog::nameOf(RegisterId id) const
{
    const RegisterInfo *info = find(id);
    if (info == nullptr)
        return hexName(id);
    if (m_motors < 2 || !info->perMotor)
        return info->name;
    return info->name + "@" + std::to_string(motorOf(id));
}

Scale Catalog::scaleOf(RegisterId id, double rpmPerDigit) const
{
    const RegisterInfo *info = find(id);
    if (info == nullptr)
        return {};
    const Scales &scales = this->scales(motorOf(id));
    const double fixedPoint = std::ldexp(1.0, -info->fractionBits);
    switch (info->quantity) {
    case Quantity::Current:
        return digits(scales.ampsPerDigit, "A", *info, fixedPoint);
    case Quantity::Voltage:
        return digits(scales.voltsPerDigit, "V", *info, fixedPoint);
    case Quantity::Frequency:
        return digits(scales.hertzPerDigit, "Hz", *info, fixedPoint);
    case Quantity::SpeedTenthHz:
        return digits(rpmPerDigit, "rpm", *info, fixedPoint);
    case Quantity::Angle:
        return {360.0 * (info->fractionBits > 0 ? fixedPoint : 1.0 / 65536.0), "°"};
    case Quantity::TurnsPerSecond:
        return {60.0 * fixedPoint, "rpm"};
    case Quantity::Plain:
        break;
    }
    return {fixedPoint, info->unit};
}

const Scales &Catalog::scales(int motor) const
{
    static const Scales kNone;
    const auto at = static_cast<std::size_t>(std::clamp(motor, 1, m_motors) - 1);
    return at < m_scales.size() ? m_scales[at] : kNone;
}

Scale Catalog::readScale(RegisterId id) const
{
    return scaleOf(id, scales(motorOf(id)).rpmPerReadDigit);
}

Scale Catalog::streamScale(RegisterId id) const
{
    Scale scale = scaleOf(id, scales(motorOf(id)).rpmPerSpeedDigit);
    const RegisterInfo *info = find(id);
    if (info != nullptr && info->streamsUpperHalf)
        scale.factor *= 65536.0;
    return scale;
}

} // namespace catalog
