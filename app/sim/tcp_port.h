// A TCP port of this machine's loopback address, for clients that know no serial ports. One client at a time: while one
// is there, others are turned away, and so is a browser that a page has sent here: no board is spoken to in HTTP or
// TLS.
#pragma once

#include "base/result.h"
#include "port.h"

#include <cstdint>
#include <memory>

namespace sim {

class TcpPort final : public Port {
public:
    /// @param number  0: a free one is chosen
    /// @return the listening port, or a sentence
    static Result<std::unique_ptr<Port>, std::string> open(std::uint16_t number);
    ~TcpPort() override;

    std::string address() const override { return "127.0.0.1:" + std::to_string(m_number); }
    bool clientPresent() override;
    int descriptor() const override { return m_client; }
    Bytes read() override;
    void write(ByteView bytes) override;

private:
    TcpPort(int listener, std::uint16_t number)
        : m_listener(listener)
        , m_number(number)
    {
    }
    void leave();
    Bytes judged(Bytes bytes);

    int m_listener;
    std::uint16_t m_number;
    int m_client = -1;
    bool m_trusted = false; ///< its first bytes are no browser's
    Bytes m_first; ///< kept back until that is known
};

} // namespace sim
