#include "drive/motion_caution.h"

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
    /// @param most  that both set-points were agreed to up to
    void towards(std::optional<double> from, double to, double limit, double most)
    {
        step(from ? std::optional(std::abs(to - *from)) : std::nullopt, limit,
            from && std::abs(*from) <= most && std::abs(to) <= most);
        reversal(to);
    }
    void noLimit(bool torque)
    {
        if (torque && scene.ownSpeedLimitRpm > 0.0)
            found.push_back(MotionCaution::NoSpeedLimit);
    }
    void mode(bool torque)
    {
        if (!rests(scene.state) && scene.torqueMode != torque)
            found.push_back(
                scene.torqueMode ? MotionCaution::OtherMode : MotionCaution::UnknownMode);
    }

    void takesOver()
    {
        if (scene.experiment)
            found.push_back(MotionCaution::EndsExperiment);
    }

    void operator()(const Command &command)
    {
        if (command.action != MotorAction::Start)
            return;
        if (!scene.startedBefore)
            found.push_back(MotionCaution::FirstStart);
        takesOver();
    }
    void operator()(const SpeedRamp &ramp)
    {
        towards(scene.speedReferenceRpm, ramp.rpm, scene.bounds.rpm, scene.agreedRpm);
        mode(false);
        takesOver();
    }
    void operator()(const TorqueRamp &ramp)
    {
        towards(scene.iqReferenceAmps, ramp.amps, scene.bounds.amps, scene.agreedAmps);
        noLimit(ramp.amps != 0.0);
        mode(true);
        takesOver();
    }
    void operator()(const CurrentReference &reference)
    {
        const std::optional<double> iq = scene.iqReferenceAmps, id = scene.idReferenceAmps;
        const bool known = iq && id;
        step(known ? std::optional(std::hypot(reference.iqAmps - *iq, reference.idAmps - *id))
                   : std::nullopt, // how far the vector moves
            scene.bounds.amps,
            known && std::hypot(*iq, *id) <= scene.agreedAmps
                && std::hypot(reference.iqAmps, reference.idAmps) <= scene.agreedAmps);
        reversal(reference.iqAmps);
        noLimit(reference.iqAmps != 0.0);
        mode(true);
        takesOver();
    }
    void operator()(const PositionRamp &)
    {
        found.push_back(MotionCaution::Position); // it goes there by itself, and stays
        takesOver();
    }
    template <class Other>
    void operator()(const Other &)
    {
    }
};

} // namespace

std::vector<MotionCaution> cautionsOf(const WishContent &act, const MotionScene &scene)
{
    Judge judge{scene, {}};
    std::visit(judge, act);
    return std::move(judge.found);
}

} // namespace drive
