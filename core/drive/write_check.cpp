#include "drive/write_check.h"

#include "catalog/limits.h"
#include "drive/set_point_check.h"
#include "drive/values.h"

#include <cmath>

namespace drive {

namespace {

using catalog::ControlMode;
using catalog::Effect;
using catalog::RegisterInfo;

constexpr const char *kTakesWord =
    "nothing here bounds what follows from it; that takes your explicit word (expert)";

/// Of what nothing here bounds.
std::string refuseUnbounded(const BoardFacts &board, int motor, Reach reach)
{
    if (reach != Reach::Everything)
        return kTakesWord;
    if (auto why = refuseStart(board, motor); !why.empty())
        return why;
    return board.user == UserLimits{} ? ""
                                      : "no limit of your own holds for it; take yours away first";
}

std::string refuseEffect(
    const BoardFacts &board, const RegisterInfo &info, const RegisterWrite &write, Reach reach)
{
    if (info.effect == Effect::Kept)
        return {};
    if (reach == Reach::Parameters)
        return "moves a motor or acts at once; only parameters are written from a file";
    const int motor = info.perMotor ? board.catalog->motorOf(write.id) : 1;
    const double number = asNumber(write.value).value_or(0.0);
    switch (info.effect) {
    case Effect::Board:
        return reach == Reach::Everything ? "" : kTakesWord;
    case Effect::Unknown:
    case Effect::Unbounded:
    case Effect::Command:
        return refuseUnbounded(board, motor, reach);
    case Effect::Reference:
        return number != 0.0
                && (info.setPoint == catalog::SetPoint::Current
                    || info.setPoint == catalog::SetPoint::Torque)
            ? refuseTorqueControl(board)
            : "";
    case Effect::Mode:
        if (const auto mode = board.catalog->start().controlOf(static_cast<std::int64_t>(number));
            mode != ControlMode::Speed)
            return mode == ControlMode::Torque ? refuseTorqueControl(board)
                                               : refuseUnbounded(board, motor, reach);
        break;
    case Effect::Kept:
        break;
    }
    return {};
}

} // namespace

std::string refuseTorqueControl(const BoardFacts &board)
{
    if (!(board.user.maxSpeedRpm > 0.0))
        return {};
    return "in torque control nothing keeps the speed within your own limit of "
        + std::to_string(std::lround(board.user.maxSpeedRpm)) + " rpm: take that limit away first";
}

std::string refuseWrite(const BoardFacts &board, const RegisterWrite &write, Reach reach)
{
    if (auto why = board.reasonWithout(write.id); !why.empty())
        return why;
    const RegisterInfo *info = board.catalog->find(write.id);
    if (!info->writable())
        return "cannot be written";
    if (auto why = catalog::refuseValue(*info, write.value); !why.empty())
        return why;
    if (auto why = refuseEffect(board, *info, write, reach); !why.empty())
        return why;
    return refuseNumber(board, write);
}

} // namespace drive
