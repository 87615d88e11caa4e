// OwnLimits: keeps the user's own limits in their file. They are in force as soon as the file was read, and stored at
// once when they change, not when the program ends. If they were lost or cannot be read, it says so.
//
// Call order: construct, connect told(), then load().
#pragma once

#include "widgets/base/device.h"

#include <QObject>
#include <QString>

namespace widgets {

class OwnLimits : public QObject {
    Q_OBJECT
public:
    OwnLimits(Device &device, const QString &path, QObject *parent = nullptr);

    /// What the device has until then is a copy that other settings kept: it counts where the file is missing or
    /// damaged.
    void load();

Q_SIGNALS:
    void told(const QString &sentence); ///< a warning

private:
    void save();

    Device &m_device;
    QString m_path;
    drive::UserLimits m_stored;
};

} // namespace widgets
