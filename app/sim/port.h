// Where clients of the simulated board come and go: one at a time, raw bytes both ways, nothing ever waits.
#pragma once

#include "base/bytes.h"

#include <string>

namespace sim {

class Port {
public:
    Port() = default;
    Port(const Port &) = delete;
    Port &operator=(const Port &) = delete;
    virtual ~Port() = default;

    virtual std::string address() const = 0; ///< what clients open
    /// Looks whether a client is there, and takes one in where that is to be done.
    virtual bool clientPresent() = 0;
    virtual int descriptor() const = 0; ///< for poll(); only while clientPresent()
    virtual Bytes read() = 0; ///< what the client wrote
    /// As much as fits; a client that does not read loses the rest, as on a UART.
    virtual void write(ByteView bytes) = 0;
};

} // namespace sim
