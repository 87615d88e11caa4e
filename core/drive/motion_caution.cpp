#include "drive/motion_caution.h"

#include "drive/set_point_check.h"

#include <cmath>

namespace drive {

namespace {

std::vector<MotionCaution> cautionsOf(const SetPoint &to, const MotionScene &scene)
{
    std::vector<MotionCaution> found;
    const bool torque = to.feature != Feature::SpeedRamp;
    const bool vector = to.feature == Feature::CurrentReference;
    const auto first = torque ? scene.iqReferenceAmps : scene.speedReferenceRpm;
    const auto second = vector ? scene.idReferenceAmps : std::optional(0.0);
    std::optional<double> length; // of the step; empty: where it begins is unknown
    bool agreed = false; // both set-points lie within it, and then no step between them surprises
    if (first && second) {
        const double most = torque ? scene.agreedAmps : scene.agreedRpm;
        length = std::hypot(to.first - *first, to.second - *second); // how far the vector moves
        agreed = std::hypot(*first, *second) <= most && std::hypot(to.first, to.second) <= most;
    }
    const double limit = torque ? scene.bounds.amps : scene.bounds.rpm;
    const double greatest = kGreatestQuietStep * limit * (1.0 + 1e-9);
    if (!length)
        found.push_back(MotionCaution::StepFromUnknown);
    else if (!(agreed || *length <= greatest))
        found.push_back(MotionCaution::Step);
    const bool against = scene.speedRpm && std::abs(*scene.speedRpm) > kTurningRpm
        && std::signbit(*scene.speedRpm) != std::signbit(to.first);
    // The measured speed of a motor that is not driven may be an observer's noise; of one that is, it counts.
    const bool unknown = !scene.speedRpm && !rests(scene.state);
    if (to.first != 0.0 && (against || unknown))
        found.push_back(MotionCaution::Reversal);
    if (torque && to.first != 0.0 && scene.ownSpeedLimitRpm > 0.0)
        found.push_back(MotionCaution::NoSpeedLimit);
    if (!rests(scene.state) && scene.torqueMode != torque)
        found.push_back(scene.torqueMode ? MotionCaution::OtherMode : MotionCaution::UnknownMode);
    return found;
}

} // namespace

std::vector<MotionCaution> cautionsOf(const WishContent &act, const MotionScene &scene)
{
    std::vector<MotionCaution> found;
    const auto *command = std::get_if<Command>(&act);
    if (const auto wanted = setPointOf(act))
        found = cautionsOf(*wanted, scene);
    else if (std::holds_alternative<PositionRamp>(act))
        found = {MotionCaution::Position}; // it goes there by itself, and stays
    else if (command == nullptr || command->action != MotorAction::Start)
        return {};
    else if (!scene.startedBefore)
        found = {MotionCaution::FirstStart};
    if (scene.experiment)
        found.push_back(MotionCaution::EndsExperiment);
    return found;
}

} // namespace drive
