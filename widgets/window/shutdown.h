// Shutdown: what goes before a connection is left. It watches what may have set a motor in motion; where one may turn
// it stops the motors, waits up to two seconds for the evidence and then says whether the connection may be left or the
// user has to be asked.
#pragma once

#include "widgets/base/device.h"
#include "widgets/base/rest_evidence.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace widgets {

class Shutdown : public QObject {
    Q_OBJECT
public:
    /// @param clock  that of the session, which stamps what boards tell
    Shutdown(Device &device, std::function<TimePoint()> clock, QObject *parent = nullptr);

    /// A motor may turn: the connection must not be left without a stop, or the user's word.
    bool mayTurn() const;
    /// Every motor was at rest for a while when it was last heard, however long ago, and nothing was asked for since.
    bool wereAtRest() const { return m_rest.wereAtRest(motors()); }
    /// The board answers, and no motor of it may turn.
    bool restIsSeen() const { return m_device.answering() && !mayTurn(); }
    /// The user's choice: motors that may turn stay as they are. Until the next arming or connection.
    void leaveAsTheyAre() { m_rest.leftAsTheyAre(); }

    /// Stops the motors and waits; ends in one of the signals, at once where no port can carry the stop. Harmless while
    /// it is under way.
    void begin();
    bool underWay() const { return m_deadline.isActive(); }

Q_SIGNALS:
    void confirmed();
    void notConfirmed();

private:
    int motors() const;
    void check();

    Device &m_device;
    std::function<TimePoint()> m_clock;
    RestEvidence m_rest;
    QTimer m_deadline;
};

} // namespace widgets
