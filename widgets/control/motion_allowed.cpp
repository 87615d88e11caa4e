#include "widgets/control/motion_allowed.h"

#include "widgets/base/device_text.h"

#include <QCoreApplication>

namespace widgets {
namespace {

struct Motion {
    Q_DECLARE_TR_FUNCTIONS(Motion)
};

} // namespace

MotionAllowed armAllowed(const Device &device)
{
    if (!device.answering())
        return {false, Motion::tr("Connect to a board first.")};
    const drive::Capability start = device.capability(drive::Feature::Start);
    const drive::Capability write = device.capability(drive::Feature::WriteRegisters);
    if (device.identified() && !start.available && !write.available)
        return {false, deviceText(write.reason)};
    return {true, {}};
}

MotionAllowed motionAllowed(const Device &device, drive::Feature feature)
{
    if (!device.answering() || !device.identified())
        return {false, Motion::tr("Connect to a board first.")};
    const drive::Capability capability = device.capability(feature);
    if (!capability.available)
        return {false, deviceText(capability.reason)};
    if (!device.armed())
        return {false, Motion::tr("Arm first.")};
    return {true, {}};
}

MotionAllowed startAllowed(const Device &device)
{
    const MotionAllowed base = motionAllowed(device, drive::Feature::Start);
    if (!base.yes)
        return base;
    const auto state = device.status(device.motor()).state;
    if (drive::hasFault(state))
        return {false, Motion::tr("Acknowledge the faults first.")};
    if (state != drive::MotorState::Idle)
        return {false, Motion::tr("The motor has to be idle.")};
    return base;
}

MotionAllowed acknowledgeAllowed(const Device &device)
{
    const MotionAllowed base = motionAllowed(device, drive::Feature::AcknowledgeFaults);
    if (!base.yes)
        return base;
    const drive::MotorStatus status = device.status(device.motor());
    if (!status.faultsNow.empty() || status.state == drive::MotorState::FaultNow)
        return {false, Motion::tr("The fault is still present: remove its cause first.")};
    if (status.faultsPast.empty() && status.state != drive::MotorState::FaultOver)
        return {false, Motion::tr("There is no fault to acknowledge.")};
    return base;
}

} // namespace widgets
