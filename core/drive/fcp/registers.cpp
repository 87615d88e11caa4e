#include "drive/fcp/registers.h"

#include "catalog/control_mode.h"
#include "drive/values.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace drive {

namespace {

using namespace fcp::number;
constexpr std::uint32_t kStandardTable = 0x060400; ///< whose groups and gains the names stand for
constexpr std::int64_t kTorqueOnWire = 0, kSpeedOnWire = 1;
constexpr std::int64_t kGreatestExponent = 15;

struct StandardName {
    std::uint8_t number;
    std::string_view name;
};
constexpr StandardName kStandardNames[] = {{0x01, "FAULTS_FLAGS"}, {kTorqueRef, "I_Q_REF"},
    {0x09, "I_Q_KP"}, {0x0A, "I_Q_KI"}, {0x0B, "I_Q_KD"}, {kFluxRef, "I_D_REF"}, {0x0D, "I_D_KP"},
    {0x0E, "I_D_KI"}, {0x0F, "I_D_KD"}, {0x10, "STOPLL_C1"}, {0x11, "STOPLL_C2"},
    {0x12, "STOCORDIC_C1"}, {0x13, "STOCORDIC_C2"}, {0x14, "STOPLL_KI"}, {0x15, "STOPLL_KP"},
    {0x1F, "I_Q_MEAS"}, {0x20, "I_D_MEAS"}};

bool isDivisor(std::uint8_t number) { return number == kSpeedKpDiv || number == kSpeedKiDiv; }

/// What the wire has instead of the numbers that a name stands for.
std::vector<catalog::WireDigits> wireDigits(std::uint8_t number)
{
    std::vector<catalog::WireDigits> all;
    if (number == kControlMode)
        all = {
            {catalog::kSpeedModeNumber, kSpeedOnWire}, {catalog::kTorqueModeNumber, kTorqueOnWire}};
    for (std::int64_t exponent = 0; isDivisor(number) && exponent <= kGreatestExponent; ++exponent)
        all.push_back({exponent, std::int64_t{1} << exponent});
    return all;
}

/// What a name says in every protocol: where it is shown, whether it is part of a gain.
void takeOver(catalog::RegisterInfo &info, const std::vector<catalog::RegisterInfo> &standard)
{
    const auto same = std::ranges::find(standard, info.name, &catalog::RegisterInfo::name);
    if (same == standard.end())
        return;
    info.group = same->group;
    if (info.help.empty())
        info.help = same->help;
    info.gain = same->gain;
}

catalog::RegisterInfo neutral(
    const fcp::Register &entry, const std::vector<catalog::RegisterInfo> &standard)
{
    catalog::RegisterInfo info = entry.info;
    const auto number = static_cast<std::uint8_t>(entry.info.id);
    info.id = fcpId(number, 0);
    const auto name = std::ranges::find(kStandardNames, number, &StandardName::number);
    if (name != std::end(kStandardNames))
        info.aliases.push_back(std::exchange(info.name, std::string(name->name)));
    takeOver(info, standard);
    using catalog::Access;
    const bool read = entry.readBytes > 0, write = entry.writeBytes > 0;
    info.access = read && write ? Access::ReadWrite
        : read                  ? Access::Read
        : write                 ? Access::Write
                                : Access::None;
    if (number == kFinalSpeed)
        info.setPoint = catalog::SetPoint::Speed;
    else if (number == kTorqueRef || number == kFluxRef || number == kIqSpeedMode)
        info.setPoint = catalog::SetPoint::Current;
    info.wire = wireDigits(number);
    info.perMotor = number != kUid && number != kControlBoard && number != kPowerBoard;
    return info;
}

} // namespace

std::vector<catalog::RegisterInfo> fcpRegisters(fcp::Dialect dialect, bool revUp)
{
    const auto standard = catalog::readTable(catalog::builtInTable("mcp"), "std", kStandardTable)
                              .value_or(std::vector<catalog::RegisterInfo>());
    std::vector<catalog::RegisterInfo> registers;
    for (const fcp::Register &entry : fcp::registersOf(dialect)) {
        // The selected motor is never used; what only a DAC can show is no register to read.
        if (entry.info.id == kTargetMotor || (entry.readBytes == 0 && entry.writeBytes == 0))
            continue;
        registers.push_back(neutral(entry, standard));
    }
    if (revUp) {
        catalog::RegisterInfo stages;
        stages.id = kFcpRevUp;
        stages.name = "REVUP_DATA";
        stages.type = catalog::ValueType::Raw;
        stages.access = catalog::Access::ReadWrite;
        takeOver(stages, standard);
        stages.effect = catalog::Effect::Kept; // they act at the next start, which looks at them
        registers.push_back(std::move(stages));
    }
    return registers;
}

std::optional<Value> fcpValue(const fcp::Register &which, ByteView data)
{
    auto value = fcp::decodeValue(which, data);
    if (!value)
        return std::nullopt;
    const auto *whole = std::get_if<std::int64_t>(&*value);
    if (whole == nullptr)
        return std::move(*value);
    const auto number = static_cast<std::uint8_t>(which.info.id);
    const auto digits = wireDigits(number);
    const auto at = std::ranges::find(digits, *whole, &catalog::WireDigits::digits);
    if (at != digits.end())
        return at->number;
    return isDivisor(number) ? std::nullopt : std::optional(std::move(*value));
}

Result<Bytes, std::string> fcpBytes(const fcp::Register &which, const Value &value)
{
    if (which.info.type == catalog::ValueType::F32) {
        const auto number = asNumber(value);
        if (!number || !std::isfinite(static_cast<float>(*number)))
            return fail(std::string(kNotFinite));
        return fcp::encodeValue(which, Value(*number), which.writeBytes);
    }
    auto whole = wholeNumberFor(which.info.type, value);
    if (!whole)
        return fail(whole.error());
    if (static_cast<std::uint8_t>(which.info.id) == kControlMode) {
        if (*whole != catalog::kTorqueModeNumber && *whole != catalog::kSpeedModeNumber)
            return fail(std::string("this board controls speed or torque only"));
        *whole = *whole == catalog::kTorqueModeNumber ? kTorqueOnWire : kSpeedOnWire;
    }
    // Four bytes for a register of two: firmware reads them all, and a sign has to reach to the end.
    return fcp::encodeValue(which, Value(*whole), which.writeBytes);
}

} // namespace drive
