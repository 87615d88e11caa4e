#include "session/link/wanted_stops.h"

#include <QFileInfo>

#include <algorithm>

namespace session {

WantedStops::Port WantedStops::portOf(const Endpoint &endpoint)
{
    const QString device = QFileInfo(endpoint.path).canonicalFilePath();
    return {endpoint.path, device.isEmpty() ? endpoint.path : device};
}

void WantedStops::want(const Endpoint &port)
{
    if (port.kind == Endpoint::Kind::Serial && !at(port))
        m_ports.push_back(portOf(port));
}

void WantedStops::settle(const Endpoint &port)
{
    const Port settled = portOf(port);
    std::erase_if(m_ports, [&](const Port &one) { return one == settled; });
}

bool WantedStops::at(const Endpoint &port) const
{
    return any() && std::ranges::find(m_ports, portOf(port)) != m_ports.end();
}

QStringList WantedStops::portsBut(const Endpoint *open) const
{
    QStringList ports;
    for (const Port &port : m_ports)
        if (open == nullptr || !(port == portOf(*open)))
            ports.append(port.chosen);
    return ports;
}

} // namespace session
