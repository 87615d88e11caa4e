#include "widgets/motion_allowed.h"

#include "widgets/device_text.h"

#include <QCoreApplication>

namespace widgets {
namespace {

struct Motion {
    Q_DECLARE_TR_FUNCTIONS(Motion)
};

} // namespace

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

} // namespace widgets
