// WantedStops: the stops that the user asked for and that nothing has confirmed until now, by port. They outlive the
// port, the drive and the connection: whatever is met there next is stopped first. Sends nothing.
//
// Only ports of hardware count: a simulated motor ends with its port. A port has two names, the one that the user chose
// and the device behind it; either is the same port.
#pragma once

#include "session/transports/endpoint.h"

#include <QStringList>

#include <vector>

namespace session {

class WantedStops {
public:
    void want(const Endpoint &port);
    /// Nothing drives a motor there, or the user has said that it is no longer wanted.
    void settle(const Endpoint &port);
    void forget() { m_ports.clear(); }

    bool any() const { return !m_ports.empty(); }
    bool at(const Endpoint &port) const;
    /// As people chose them, without `open`, where the stop is under way (may be null).
    QStringList portsBut(const Endpoint *open) const;

private:
    struct Port {
        QString chosen, device;
        bool operator==(const Port &other) const
        {
            return chosen == other.chosen || device == other.device;
        }
    };
    static Port portOf(const Endpoint &endpoint);

    std::vector<Port> m_ports;
};

} // namespace session
