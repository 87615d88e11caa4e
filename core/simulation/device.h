// A simulated device as its stream of bytes sees it, on virtual time: what a program that puts one behind a port needs.
#pragma once

#include "base/bytes.h"
#include "base/time.h"

namespace simulation {

class ByteDevice {
public:
    ByteDevice() = default;
    ByteDevice(const ByteDevice &) = delete;
    ByteDevice &operator=(const ByteDevice &) = delete;
    virtual ~ByteDevice() = default;

    virtual void receive(ByteView bytes, TimePoint now) = 0;
    virtual void advance(TimePoint now) = 0;
    [[nodiscard]] virtual Bytes takeOutput() = 0;
    /// When advance() will next have something to do that can be seen from outside.
    [[nodiscard]] virtual TimePoint nextWake() const = 0;
    /// Of a header, behind which a sender has to pause; 0: the protocol wants no pause.
    [[nodiscard]] virtual std::size_t headerBytes() const { return 0; }
};

} // namespace simulation
