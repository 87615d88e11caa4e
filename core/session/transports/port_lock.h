// PortLock: one writer a port. QSerialPort's own lock goes by name, so a symbolic link would open
// the same port twice; this one holds the device itself. On systems whose ports are exclusive
// anyway it is always granted.
#pragma once

#include "session/transports/endpoint.h"

namespace session {

class PortLock {
public:
    PortLock() = default;
    PortLock(const PortLock &) = delete;
    PortLock &operator=(const PortLock &) = delete;
    ~PortLock();

    /// @param path  canonical path of the device
    PortError acquire(const QString &path);
    void release(); ///< also for duplicates of the descriptor
    /// Of the device, with the lock; -1: not held, or not on this system.
    int descriptor() const { return m_fd; }

private:
    int m_fd = -1;
};

/// The process that has the device open, as "name (pid 123)"; empty if that cannot be seen. For error texts.
QString portHolder(const QString &path);

/// What can be seen of an open port without reading from it.
PortProblem problemOf(int error); ///< of the errno of an open(): POSIX only

struct PortHealth {
    bool hungUp = false; ///< the device is gone
    bool inputWaiting = false; ///< bytes not read yet
    bool outputWaiting = false; ///< bytes that have not left yet
};
/// @param handle  QSerialPort::handle()
PortHealth checkPort(qintptr handle);

/// Asks the driver to hand on what it receives at once, instead of up to 16 ms later. Not all know
/// how; no harm done.
void askForLowLatency(qintptr handle);

} // namespace session
