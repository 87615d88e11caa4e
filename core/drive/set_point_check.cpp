#include "drive/set_point_check.h"

#include "base/text.h"
#include "drive/values.h"
#include "motor/ramp.h"
#include "motor/rev_up.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace drive {

namespace {

constexpr double kGreatestDigits = 32767.0;
constexpr double kShortest_s = 0.001, kLongest_s = 65.535;

double roundedDigits(const BoardFacts &board, int motor, double amps)
{
    return std::nearbyint(amps / board.ampsPerDigit(motor));
}

std::string_view nameOf(LimitGap gap)
{
    static constexpr Word<LimitGap> kNames[] = {{"greatest speed", LimitGap::MaxSpeed},
        {"greatest current", LimitGap::MaxCurrent}, {"nominal current", LimitGap::NominalCurrent}};
    return wordFor(kNames, gap);
}

std::string unknown(const std::string &what, int motor)
{
    return "the board does not tell the " + what + " of motor " + std::to_string(motor)
        + "; to move it all the same takes " + kExpertMode;
}

struct Bound {
    const char *quantity, *unit;
    double most, own; ///< own: the user's limit
};

std::string refuseBeyond(const Bound &bound, int motor, double value)
{
    if (!std::isfinite(value))
        return kNotFinite;
    if (!(bound.most > 0.0))
        return unknown(bound.quantity, motor);
    if (std::abs(value) > bound.most)
        return "beyond " + std::string(bound.most == bound.own ? "your own" : "the") + " limit of "
            + shortNumber(bound.most) + bound.unit;
    return {};
}

} // namespace

std::string refuseMotor(const BoardFacts &board, int motor)
{
    return board.hasMotor(motor) ? "" : "there is no motor " + std::to_string(motor);
}

std::string refuseRampTime(std::chrono::milliseconds time)
{
    return time.count() < 0 || time > kLongestRamp
        ? "a ramp lasts 0 to " + std::to_string(kLongestRamp.count()) + " ms"
        : "";
}

std::string refuseStart(const BoardFacts &board, int motor)
{
    if (board.expert.contains(motor))
        return {};
    std::string names;
    for (const LimitGap gap : gapsIn(board.limitsOf(motor)))
        names += (names.empty() ? "" : ", ") + std::string(nameOf(gap));
    return names.empty() ? names : unknown(names, motor);
}

std::string refuseCommand(const BoardFacts &board, const Command &command)
{
    auto why = refuseMotor(board, command.motor);
    return why.empty() && command.action == MotorAction::Start ? refuseStart(board, command.motor)
                                                               : why;
}

std::string refuseSpeed(const BoardFacts &board, int motor, double rpm)
{
    const double most = board.boundsOf(motor).rpm;
    return refuseBeyond({"speed limit", " rpm", most, board.user.maxSpeedRpm}, motor, rpm);
}

std::string refuseCurrent(const BoardFacts &board, int motor, double amps)
{
    const double most = board.boundsOf(motor).amps;
    return refuseBeyond({"current limit", " A", most, board.user.maxCurrentAmps}, motor, amps);
}

std::string refuseWireSpeed(const BoardFacts &board, int motor, double rpm)
{
    if (auto why = refuseSpeed(board, motor, rpm); !why.empty())
        return why;
    const double most = board.limitsOf(motor).wireRpm;
    return std::abs(rpm) > most
        ? "beyond the " + shortNumber(most) + " rpm that this protocol can hold"
        : "";
}

double leastAmps(double digits, double ampsPerDigit)
{
    return std::max(0.0, std::abs(digits) - 0.5) * ampsPerDigit;
}

std::string refuseStages(const BoardFacts &board, int motor, ByteView raw)
{
    const auto stages = motor::revUpOfBytes(raw);
    const double amps = board.ampsPerDigit(motor); // 0: six-step, whose stages hold no current
    if (!stages)
        return {};
    for (const motor::RevUpStage &stage : *stages) {
        if (auto why = refuseWireSpeed(board, motor, stage.speed_rpm); !why.empty())
            return why;
        if (!(amps > 0.0))
            continue;
        if (auto why = refuseCurrent(board, motor, leastAmps(stage.current_digits, amps));
            !why.empty())
            return why;
    }
    return {};
}

std::string refuseDigits(double digits)
{
    return digits > kGreatestDigits ? "beyond what 16 bits hold" : "";
}

bool sameStages(const Value &written, const Value &read)
{
    const auto *bytes = std::get_if<Bytes>(&written);
    const auto stages = motor::revUpOfBytes(bytes != nullptr ? *bytes : Bytes());
    return bytes != nullptr && stages
        && read == Value(motor::bytesOf(motor::keptByFirmware(*stages)));
}

std::string refusePosition(const BoardFacts &board, int motor, const Move &wanted)
{
    constexpr double kRounding = 1e-6; // of a float
    if (auto why = board.reasonAgainst(Feature::PositionRamp); !why.empty())
        return why;
    if (!(std::abs(wanted.radians) <= kFarthest_rad))
        return "an angle is at most 10000 rad";
    // Without a time firmware follows at once, however far it is.
    if (!(wanted.seconds >= kShortest_s - kRounding && wanted.seconds <= kLongest_s + kRounding))
        return "a move lasts 1 to 65535 ms";
    return refuseSpeed(board, motor, 0.0); // a limit that is not known
}

std::string refuseWay(const BoardFacts &board, int motor, const Move &wanted, double position_rad)
{
    if (!std::isfinite(position_rad))
        return "the board does not tell where the shaft is";
    const double rpm = motor::positionPeakSpeed_rpm(wanted.radians - position_rad, wanted.seconds);
    const std::string why = refuseSpeed(board, motor, rpm);
    return why.empty() ? why : "the speed on the way is " + why;
}

std::optional<SetPoint> setPointOf(const WishContent &act)
{
    if (const auto *ramp = std::get_if<SpeedRamp>(&act))
        return SetPoint{Feature::SpeedRamp, ramp->motor, double(ramp->rpm), 0.0, ramp->duration};
    if (const auto *ramp = std::get_if<TorqueRamp>(&act))
        return SetPoint{Feature::TorqueRamp, ramp->motor, ramp->amps, 0.0, ramp->duration};
    if (const auto *one = std::get_if<CurrentReference>(&act))
        return SetPoint{Feature::CurrentReference, one->motor, one->iqAmps, one->idAmps, {}};
    return std::nullopt;
}

std::string refuseSetPoint(const BoardFacts &board, const SetPoint &wanted)
{
    if (auto why = refuseMotor(board, wanted.motor); !why.empty())
        return why;
    if (auto why = board.reasonAgainst(wanted.feature); !why.empty())
        return why;
    if (auto why = refuseRampTime(wanted.duration); !why.empty())
        return why;
    if (wanted.feature == Feature::SpeedRamp)
        return refuseWireSpeed(board, wanted.motor, wanted.first);
    if (auto why = board.reasonAgainstAmps(wanted.motor); !why.empty())
        return why;
    const double amps = std::hypot(wanted.first, wanted.second);
    if (auto why = refuseCurrent(board, wanted.motor, amps); !why.empty())
        return why;
    const double most = std::max(std::abs(wanted.first), std::abs(wanted.second));
    return refuseDigits(roundedDigits(board, wanted.motor, most));
}

std::int16_t digitsOf(const BoardFacts &board, int motor, double amps)
{
    return static_cast<std::int16_t>(
        std::clamp(roundedDigits(board, motor, amps), -kGreatestDigits, kGreatestDigits));
}

std::string refuseNumber(const BoardFacts &board, const RegisterWrite &write)
{
    const auto *info = board.catalog->find(write.id);
    const auto value = asNumber(write.value);
    if (info == nullptr || !value || info->setPoint == catalog::SetPoint::None)
        return {};
    const int motor = board.catalog->motorOf(write.id);
    const double perDigit =
        setPointPerDigit(*info, board.catalog->readScale(write.id), board.limitsOf(motor));
    if (!(perDigit > 0.0))
        return "the scale of motor " + std::to_string(motor) + " is not known";
    return info->setPoint == catalog::SetPoint::Speed
        ? refuseSpeed(board, motor, *value * perDigit)
        : refuseCurrent(board, motor, *value * perDigit);
}

} // namespace drive
