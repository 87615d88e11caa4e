#include "widgets/window/own_limits.h"

#include "session/files/limits_file.h"
#include "widgets/base/device_text.h"

namespace widgets {

OwnLimits::OwnLimits(Device &device, const QString &path, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_path(path)
{
}

void OwnLimits::load()
{
    const drive::UserLimits copy = m_device.userLimits();
    const bool copied = copy != drive::UserLimits{};
    const auto read = session::loadLimits(m_path);
    connect(&m_device, &Device::boundsChanged, this, &OwnLimits::save);
    if (read && *read) {
        m_stored = **read;
        m_device.setUserLimits(m_stored);
    } else if (read) {
        save();
    } else {
        m_stored = copy; // what cannot be read stays there until limits are set anew
        const QString file = deviceText(m_path), why = deviceText(read.error());
        Q_EMIT told(
            copied ? tr(
                "The file with your own limits, %1, cannot be read (%2). Those of the last time "
                "that Rotorscope ended are in force: look at them in the control panel.")
                         .arg(file, why)
                   : tr("The file with your own limits, %1, cannot be read (%2). NO limit of your "
                        "own is "
                        "in force: set them again in the control panel.")
                         .arg(file, why));
    }
}

void OwnLimits::save()
{
    const drive::UserLimits now = m_device.userLimits();
    if (now == m_stored)
        return; // expert mode changes bounds, too
    const QString wrong = session::saveLimits(now, m_path);
    if (wrong.isEmpty())
        m_stored = now;
    else
        Q_EMIT told(tr("Your own limits hold now, but could not be stored in %1 (%2).")
                        .arg(deviceText(m_path), deviceText(wrong)));
}

} // namespace widgets
