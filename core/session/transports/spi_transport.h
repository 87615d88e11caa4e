// SpiTransport: a drive on an SPI bus of this computer. What is written goes out as one transfer, chip select low for
// the whole of it, and the bytes clocked in meanwhile are received at once. The slave's ready line is a GPIO line,
// watched by its edges; without one, the line is told to be low after a transfer and high again a little later.
//
// Source: "MCB protocol description", sections 4, 5 and 8: mode 2, upper byte of a word first, which 8-bit words in the
// order of the line give.
#pragma once

#include "session/transports/port_lock.h"
#include "session/transports/transport.h"

#include <optional>

namespace session {

/// "/dev/spidev0.0", or "/dev/spidev0.0@gpiochip0:25" with line 25 as the ready line.
struct SpiPort {
    QString device;
    QString chip; ///< of the ready line; empty: there is none
    unsigned line = 0;
    bool operator==(const SpiPort &) const = default;
};
/// Nothing if the text is not such a port.
std::optional<SpiPort> spiPortOf(const QString &path);

/// nullptr where this build has no SPI.
/// @param clockHz  of the bus
std::unique_ptr<Transport> makeSpiTransport(const QString &path, std::uint32_t clockHz);

} // namespace session
