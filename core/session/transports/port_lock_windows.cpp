// Windows opens serial ports exclusively by itself; what the other functions could tell it tells
// through QSerialPort.
#include "session/transports/port_lock.h"

namespace session {

PortLock::~PortLock() = default;

PortError PortLock::acquire(const QString &) { return {}; }

void PortLock::release() { }

QString portHolder(const QString &) { return {}; }

PortHealth checkPort(qintptr) { return {}; }

void askForLowLatency(qintptr) { }

} // namespace session
