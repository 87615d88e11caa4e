#include "drive/motion_caution.h"

#include "drive/set_point_check.h"

#include <cmath>

namespace drive {

namespace {

struct Judge {
    const MotionScene &scene;
    std::vector<MotionCaution> found;

    /// @param length  of the step; empty: it comes from nobody knows where
    /// @param agreed  both set-points lie within it, and then no step between them surprises
    void step(std::optional<double> length, double limit, bool agreed)
    {
        const double greatest = kGreatestQuietStep * limit * (1.0 + 1e-9);
        if (!length)
            found.push_back(MotionCaution::StepFromUnknown);
        else if (!(agreed || *length <= greatest))
            found.push_back(MotionCaution::Step);
    }
    /// `to` has the sign of the speed or the torque that is asked for.
    void reversal(double to)
    {
        if (to == 0.0)
            return;
        const bool against = scene.speedRpm && std::abs(*scene.speedRpm) > kTurningRpm
            && std::signbit(*scene.speedRpm) != std::signbit(to);
        // The measured speed of a motor that is not driven may be an observer's noise; of one that is, it counts.
        const bool unknown = !scene.speedRpm && !rests(scene.state);
        if (against || unknown)
            found.push_back(MotionCaution::Reversal);
    }
    void mode(bool torque)
    {
        if (!rests(scene.state) && scene.torqueMode != torque)
            found.push_back(
                scene.torqueMode ? MotionCaution::OtherMode : MotionCaution::UnknownMode);
    }

    void setPoint(const SetPoint &to)
    {
        const bool torque = to.feature != Feature::SpeedRamp;
        const bool vector = to.feature == Feature::CurrentReference;
        const auto first = torque ? scene.iqReferenceAmps : scene.speedReferenceRpm;
        const auto second = vector ? scene.idReferenceAmps : std::optional(0.0);
        const bool known = first && second;
        const double agreed = torque ? scene.agreedAmps : scene.agreedRpm;
        step(known ? std::optional(std::hypot(to.first - *first, to.second - *second))
                   : std::nullopt, // how far the vector moves
            torque ? scene.bounds.amps : scene.bounds.rpm,
            known && std::hypot(*first, *second) <= agreed
                && std::hypot(to.first, to.second) <= agreed);
        reversal(to.first);
        if (torque && to.first != 0.0 && scene.ownSpeedLimitRpm > 0.0)
            found.push_back(MotionCaution::NoSpeedLimit);
        mode(torque);
    }
};

} // namespace

std::vector<MotionCaution> cautionsOf(const WishContent &act, const MotionScene &scene)
{
    Judge judge{scene, {}};
    const auto *command = std::get_if<Command>(&act);
    if (const auto wanted = setPointOf(act)) {
        judge.setPoint(*wanted);
    } else if (std::holds_alternative<PositionRamp>(act)) {
        judge.found.push_back(MotionCaution::Position); // it goes there by itself, and stays
    } else if (command == nullptr || command->action != MotorAction::Start) {
        return {};
    } else if (!scene.startedBefore) {
        judge.found.push_back(MotionCaution::FirstStart);
    }
    if (scene.experiment)
        judge.found.push_back(MotionCaution::EndsExperiment);
    return std::move(judge.found);
}

} // namespace drive
