#include "session/transports/spi_transport.h"

#include "session/transports/endpoint.h"

namespace session {

std::optional<SpiPort> spiPortOf(const QString &path)
{
    constexpr QLatin1Char kReadyLine('@'), kLine(':');
    SpiPort port;
    port.device = path.section(kReadyLine, 0, 0);
    if (!isSpiPath(port.device))
        return std::nullopt;
    if (!path.contains(kReadyLine))
        return port;
    const QString ready = path.section(kReadyLine, 1);
    bool number = false;
    port.chip = ready.section(kLine, 0, 0);
    port.line = ready.section(kLine, 1).toUInt(&number);
    if (port.chip.isEmpty() || !number)
        return std::nullopt;
    return port;
}

} // namespace session
