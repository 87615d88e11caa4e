// Shutdown: ending the program while a motor turns. It stops the motors, waits up to two seconds for the evidence and
// then says whether the program may end or a person has to be asked.
#pragma once

#include "widgets/base/device.h"

#include <QObject>
#include <QTimer>

namespace widgets {

class Shutdown : public QObject {
    Q_OBJECT
public:
    explicit Shutdown(Device &device, QObject *parent = nullptr);

    /// True if nothing keeps the program from ending now.
    bool mayEnd() const;
    /// Stops the motors and waits; ends in one of the signals. Harmless while it is under way.
    void begin();
    bool underWay() const { return m_deadline.isActive(); }
    void leaveRunning() { m_leave = true; } ///< the person's second, explicit choice

Q_SIGNALS:
    void confirmed();
    void notConfirmed();

private:
    void check();

    Device &m_device;
    QTimer m_deadline;
    bool m_leave = false;
};

} // namespace widgets
