#include "drive/mcb/commands.h"

#include "drive/mcb/identification.h"
#include "drive/values.h"
#include "drive/write_check.h"
#include "motor/ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace drive {

namespace {

using namespace mcbreg;
using namespace std::chrono_literals;

constexpr std::uint16_t kSwitchOn = 0x07, kEnable = 0x0F, kDisable = 0x00, kFaultReset = 0x80;
constexpr std::uint16_t kModeCurrent = 2, kModeVelocity = 3, kModeProfileVelocity = 19,
                        kModeProfilePosition = 20;
constexpr Duration kStepWithin = 500ms; ///< of the state machine, without a motor that turns
constexpr double kTurn_rad = 2.0 * std::numbers::pi;
/// Added to the set-points of velocity, Iq and Id.
constexpr std::array<std::uint16_t, 3> kOffsets{0x07B, 0x07C, 0x07D};

// What has to be known before an act is judged.
using Addresses = std::vector<std::uint16_t>;
Addresses readsOf(const Command &command)
{
    if (command.action == MotorAction::Start)
        return {kStatus, kMode, kVelocity, kIq, kId, kProfileVelocity, kOffsets[0], kOffsets[1],
            kOffsets[2]};
    return command.action == MotorAction::StopRamp ? Addresses{kVelocityNow, kMode} : Addresses{};
}
Addresses readsOf(const SpeedRamp &) { return {kMode, kVelocityNow, kVelocity, kStatus}; }
Addresses readsOf(const CurrentReference &) { return {kMode}; }
Addresses readsOf(const PositionRamp &) { return {kMode, kPositionNow}; }

const mcb::Master::Request &plain(const McbRequest &request)
{
    return std::get<mcb::Master::Request>(request);
}

} // namespace

std::uint16_t mcbSetPointOf(std::uint16_t mode)
{
    struct Row {
        std::uint16_t mode, setPoint;
    };
    static constexpr Row kRows[] = {{2, kIq}, {34, kIq}, {3, kVelocity}, {19, kVelocity},
        {35, kVelocity}, {4, kPosition}, {20, kPosition}, {36, kPosition}};
    for (const Row &row : kRows)
        if (row.mode == mode)
            return row.setPoint;
    return 0;
}

catalog::ControlMode mcbControlOf(std::int64_t mode)
{
    using catalog::ControlMode;
    const std::uint16_t followed = mcbSetPointOf(static_cast<std::uint16_t>(mode));
    return followed == kVelocity ? ControlMode::Speed
        : followed == kIq        ? ControlMode::Torque
                                 : ControlMode::Other;
}

std::vector<RegisterId> McbActTask::needs() const
{
    std::vector<RegisterId> ids;
    for (const std::uint16_t address : std::visit([](auto &one) { return readsOf(one); }, m_act))
        if (m_board.readable(address))
            ids.push_back(mcbIdOf(address));
    return ids;
}

void McbActTask::write(std::uint16_t address, const Value &value)
{
    auto words = mcbWordsOf(m_board, address, value);
    if (words)
        request(mcbWrite(address, std::move(*words)));
    else
        m_problem = m_board.catalog->nameOf(mcbIdOf(address)) + ": " + words.error();
}

void McbActTask::setMode(std::uint16_t mode, std::uint16_t setPoint, const Value &value)
{
    const auto now = static_cast<std::uint16_t>(valueOf(kMode).value_or(0xFFFF));
    const bool shares = mcbSetPointOf(now) == setPoint;
    if (!shares)
        write(setPoint, value);
    if (now != mode)
        write(kMode, std::int64_t{mode});
    if (shares)
        write(setPoint, value);
}

bool McbActTask::passes(const McbRequest &asked, const McbAnswer &answer, TimePoint now)
{
    if (plain(asked).command == mcb::Command::Write) {
        m_written = now;
        return true;
    }
    const std::uint16_t status = answer.words.empty() ? std::uint16_t{0} : answer.words.front();
    const auto [mask, bits] = m_awaited.front();
    if ((status & mask) == bits) {
        m_awaited.pop_front();
        return true;
    }
    if (now - m_written >= kStepWithin)
        end(Outcome::Refused, "the drive stays in " + std::string(mcbStateOf(status).name));
    return false;
}

void McbActTask::conclude(const McbRequest &asked, AnswerEnd said)
{
    end(said.outcome, m_board.catalog->nameOf(mcbIdOf(plain(asked).address)) + ": " + said.reason);
}

std::string McbActTask::plan()
{
    const std::string why = std::visit([this](const auto &act) { return plan(act); }, m_act);
    return why.empty() ? m_problem : why;
}

std::string McbActTask::plan(const Command &command)
{
    switch (command.action) {
    case MotorAction::Start:
        return planStart();
    case MotorAction::StopMotor:
        control(mcbStopWord(m_board));
        break;
    case MotorAction::StopRamp:
        if (const auto velocity = valueOf(kVelocityNow); velocity
            && mcbSetPointOf(static_cast<std::uint16_t>(valueOf(kMode).value_or(0))) == kVelocity)
            write(kVelocity, *velocity);
        else
            return "no ramp of the speed is under way";
        break;
    case MotorAction::AcknowledgeFaults:
        control(kDisable); // the bit has to rise
        control(kFaultReset);
        break;
    }
    return {};
}

std::string McbActTask::planStart()
{
    if (auto why = m_board.reasonAgainst(Feature::Start); !why.empty())
        return why;
    if (auto why = refuseStart(m_board, m_motor); !why.empty())
        return why;
    const auto status = valueOf(kStatus);
    const auto mode = valueOf(kMode);
    if (!status || !mode)
        return "the drive does not tell its state and mode";
    const McbState state = mcbStateOf(static_cast<std::uint16_t>(*status));
    if (state.state != MotorState::Idle)
        return "in " + std::string(state.name);
    // What it would go to at once.
    const std::uint16_t followed = mcbSetPointOf(static_cast<std::uint16_t>(*mode));
    if (followed == 0)
        return "mode " + std::to_string(static_cast<int>(*mode))
            + " is not one that is started here";
    std::string why;
    if (followed == kVelocity)
        why = refuseSpeed(m_board, m_motor, valueOf(kVelocity).value_or(NAN) * kSecondsPerMinute);
    else if (followed == kIq)
        why = refuseCurrent(
            m_board, m_motor, std::hypot(valueOf(kIq).value_or(NAN), valueOf(kId).value_or(0.0)));
    if (!why.empty())
        return "its set-point is " + why;
    constexpr int kJumps = 4; // to a position, by no profile
    if (followed == kPosition && m_board.user.maxSpeedRpm > 0.0)
        why = *mode == kJumps ? "nothing keeps the way to a position within your own limit of speed"
                              : refuseSpeed(m_board, m_motor,
                                  valueOf(kProfileVelocity).value_or(NAN) * kSecondsPerMinute);
    if (!why.empty())
        return "its profile is refused: " + why;
    if (followed == kIq)
        if (auto torque = refuseTorqueControl(m_board); !torque.empty())
            return torque;
    for (const std::uint16_t offset : kOffsets)
        if (m_board.user != UserLimits{} && valueOf(offset).value_or(0.0) != 0.0)
            return m_board.catalog->nameOf(mcbIdOf(offset))
                + " is not 0, and no limit of your own holds for it";
    control(kShutdown);
    await(0x6F, 0x21);
    control(kSwitchOn);
    await(0x6F, 0x23);
    control(kEnable);
    return {};
}

std::string McbActTask::plan(const SpeedRamp &ramp)
{
    if (auto why = refuseSetPoint(m_board, *setPointOf(ramp)); !why.empty())
        return why;
    const double target = ramp.rpm / kSecondsPerMinute;
    const double seconds = std::chrono::duration<double>(ramp.duration).count();
    const double way = std::abs(target - valueOf(kVelocityNow).value_or(0.0));
    const bool profiled = ramp.duration.count() > 0 && way > 0.0;
    if (profiled && !m_board.writable(kProfileAcceleration))
        return "this drive has no ramp for speeds; give it 0 ms";
    if (profiled) {
        write(kProfileAcceleration, way / seconds);
        if (m_board.writable(kProfileDeceleration))
            write(kProfileDeceleration, way / seconds);
    }
    setMode(profiled ? kModeProfileVelocity : kModeVelocity, kVelocity, target);
    return {};
}

std::string McbActTask::plan(const CurrentReference &reference)
{
    if (auto why = m_board.reasonAgainst(Feature::CurrentReference); !why.empty())
        return why;
    if (auto why = refuseCurrent(m_board, m_motor, std::hypot(reference.iqAmps, reference.idAmps));
        !why.empty())
        return why;
    write(kId, reference.idAmps);
    setMode(kModeCurrent, kIq, reference.iqAmps);
    return {};
}

std::string McbActTask::plan(const PositionRamp &ramp)
{
    const Move wanted{ramp.radians, toSeconds(ramp.duration)};
    if (auto why = refusePosition(m_board, m_motor, wanted); !why.empty())
        return why;
    const double counts = ramp.radians / kTurn_rad * m_board.countsPerTurn;
    const double now_rad = valueOf(kPositionNow).value_or(NAN) / m_board.countsPerTurn * kTurn_rad;
    if (auto why = refuseWay(m_board, m_motor, wanted, now_rad); !why.empty())
        return why;
    const double way_rad = ramp.radians - now_rad;
    const double rpm = std::abs(motor::positionPeakSpeed_rpm(way_rad, wanted.seconds));
    constexpr double kLeast = 1e-3; // turns a second: no drive takes 0 for a profile
    write(kProfileVelocity, std::max(rpm / kSecondsPerMinute, kLeast));
    setMode(kModeProfilePosition, kPosition, static_cast<std::int64_t>(std::llround(counts)));
    return {};
}

std::string McbWriteTask::plan(const RegisterWrite &write)
{
    const std::uint16_t address = mcbAddressOf(write.id);
    if (isMcbMappingRegister(address))
        return kSetByStreaming;
    if (address == mcbreg::kControl)
        return "the state machine is walked by start, stop and the acknowledging of faults";
    if (auto why = refuseWrite(m_board, write, m_reach); !why.empty())
        return why;
    // The set-point that comes into force with a mode.
    const std::uint16_t followed = m_board.catalog->find(write.id)->effect == catalog::Effect::Mode
        ? mcbSetPointOf(static_cast<std::uint16_t>(asNumber(write.value).value_or(0.0)))
        : 0;
    auto words = mcbWordsOf(m_board, address, write.value);
    if (!words)
        return words.error();
    ask(mcbInfo(address));
    readBefore();
    if (followed != 0 && m_board.readable(followed))
        ask(mcbRead(followed));
    this->write(mcbWrite(address, std::move(*words)));
    return {};
}

std::string McbWriteTask::judgeAnswer(const McbRequest &question, const McbAnswer &answer)
{
    const std::uint16_t address = plain(question).address;
    if (plain(question).command == mcb::Command::GetInfo) {
        if (!answer.ok || answer.words.size() < 2)
            return mcbWordOf(answer.code);
        if (mcb::infoOf({answer.words[0], answer.words[1], 0, 0}) == *m_board.infoOf(address))
            return {};
        markBoardChanged();
        return "has another type than it had";
    }
    const auto there = answer.ok ? mcbValueOf(m_board, address, answer.words) : std::nullopt;
    const std::string why =
        there ? refuseNumber(m_board, {mcbIdOf(address), *there}) : "is not known";
    return why.empty()
        ? why
        : m_board.catalog->nameOf(mcbIdOf(address)) + ", which it would follow, is " + why;
}

std::string McbWriteTask::reasonWithout(const McbRequest &question) const
{
    return plain(question).command == mcb::Command::GetInfo ? "" : " about what it would follow";
}

} // namespace drive
