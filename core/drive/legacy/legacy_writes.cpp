#include "drive/legacy/legacy_writes.h"

#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"

namespace drive {

namespace {

/// Why the register cannot be asked for; empty if it can.
std::string refuseAddress(const LegacyFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    if (info == nullptr)
        return "no such register";
    if (info->perMotor && !board.hasMotor(board.catalog->motorOf(id)))
        return "no such motor";
    if (board.missing.contains(id))
        return "this motor does not have it";
    return {};
}

constexpr std::uint8_t kFinalSpeed = 0x5B;

/// Beyond what a stage may ask for: its speed, and where the scale is known its current.
std::string refuseStages(
    const LegacyFacts &board, int motor, const std::vector<legacy::RevUpStage> &stages)
{
    const double amps = board.ampsPerDigit(motor);
    for (const legacy::RevUpStage &stage : stages) {
        if (auto why = refuseWireSpeed(board, motor, stage.speed_rpm); !why.empty())
            return why;
        if (amps > 0.0)
            if (auto why = refuseCurrent(board, motor, stage.torque * amps); !why.empty())
                return why;
    }
    return {};
}

} // namespace

std::optional<ReadStatus> LegacyProtocol::refuseRead(const LegacyFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    const bool readable = info != nullptr && info->readable();
    return readable && refuseAddress(board, id).empty() ? std::nullopt
                                                        : std::optional(ReadStatus::NotSupported);
}

std::string LegacyWriteTask::plan(const RegisterWrite &write)
{
    const RegisterId id = write.id;
    const int motor = m_board.catalog->motorOf(id);
    const double number = asNumber(write.value).value_or(0.0);
    if (auto why = refuseAddress(m_board, id); !why.empty())
        return why;
    if (auto why = refuseWrite(m_board, write, m_reach); !why.empty())
        return why;
    if (m_board.catalog->find(id)->effect == catalog::Effect::Mode)
        if (auto why = refuseControl(
                m_board, motor, controlModeOf(static_cast<std::int64_t>(number)), m_reach);
            !why.empty())
            return why;
    readBefore();
    if (isLegacyRevUp(id)) {
        const auto *raw = std::get_if<Bytes>(&write.value);
        const auto stages = raw != nullptr ? revUpStages(*raw) : std::nullopt;
        if (!stages)
            return "takes 40 bytes";
        std::uint8_t stage = 0;
        for (const legacy::RevUpStage &one : *stages)
            this->write({legacyMotor(id), legacy::SetRevUp{stage++, one}});
        return refuseStages(m_board, motor, *stages);
    }
    const legacy::Register *which = legacy::findRegister(m_board.dialect, legacyNumber(id));
    if (which == nullptr || which->writeBytes == 0)
        return "cannot be written";
    const auto bytes = legacyBytes(*which, write.value);
    if (!bytes)
        return bytes.error();
    this->write({legacyMotor(id), legacy::SetRegister{legacyNumber(id), *bytes}});
    return which->info.id == kFinalSpeed ? refuseWireSpeed(m_board, motor, number) : std::string();
}

} // namespace drive
