#include "session/transports/spi_transport.h"

namespace session {

std::unique_ptr<Transport> makeSpiTransport(const QString &, std::uint32_t) { return nullptr; }

} // namespace session
