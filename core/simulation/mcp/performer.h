// The Performer half of ASPEP as ST's firmware has it: negotiation that only ever shrinks, a connection that exists
// after a PING, errors after which the receiver is deaf for one burst. It never looks into a request.
//
//   Receiving:   header -> (payload) -> ready -task()-> header
//   Connection:  Idle -matching BEACON-> Configured -PING-> Connected; any BEACON leaves Connected
//
// Source: mcp-aspep facts 3.1 to 3.6; the recorded sessions.
#pragma once

#include "aspep/packet.h"
#include "simulation/mcp/profile.h"
#include "simulation/mcp/uart.h"

#include <array>
#include <functional>

namespace simulation {

struct BoardOptions;

class Performer {
public:
    /// Executes a request and gives the response's payload. `buffer` is the whole receive buffer, old bytes included;
    /// `length` is what the firmware believes. Empty: there is no response (the board restarted).
    using Execute =
        std::function<Bytes(ByteView buffer, std::uint16_t length, std::size_t responseMax)>;

    Performer(const Traits &traits, const BoardOptions &options, UartReceiver &receiver,
        Transmitter &transmitter);

    /// Looks whether the armed piece is complete, as SysTick or the DMA interrupt does.
    void poll();
    void handleLineIdle(); ///< the receiver's LineIdle: everything starts with a header again
    void task(TimePoint now, const Execute &execute); ///< acts on a complete packet

    bool connected() const { return m_state == State::Connected; }
    std::size_t asyncMax() const { return m_asyncMax; }
    /// As printed, a BEACON begins everything anew, the services above too; says so once.
    bool takeServicesReset() { return std::exchange(m_servicesReset, false); }

    /// A packet of the board's own accord: header, payload and the trailer where one is agreed.
    Bytes framed(bool response, ByteView payload) const;

private:
    enum class State : std::uint8_t { Idle, Configured, Connected };
    enum class Receiving : std::uint8_t { Header, Payload, Ready };

    void armHeader();
    void decode();
    void ready(std::uint8_t nack);
    void act(TimePoint now, const Execute &execute);
    void beacon(TimePoint now);
    void beaconAsPrinted(const aspep::Beacon &theirs, TimePoint now);
    void agree(const aspep::Beacon &theirs); ///< the field-wise minimum
    void adoptLimits();
    void ping(TimePoint now);
    void request(TimePoint now, const Execute &execute);

    const Traits &m_traits;
    bool m_nullCheck;
    std::uint8_t m_linkId;
    UartReceiver &m_receiver;
    Transmitter &m_transmitter;

    aspep::Beacon m_reset; ///< what it can
    aspep::Beacon m_own; ///< shrinks with every BEACON
    bool m_servicesReset = false;
    State m_state = State::Idle;
    /// In use; computed on Idle -> Configured.
    std::size_t m_requestMax = 0, m_responseMax = 0, m_asyncMax = 0;
    std::uint32_t m_requests = 0; ///< accepted since power-on

    Receiving m_receiving = Receiving::Header;
    std::array<std::uint8_t, 4> m_header{};
    std::uint32_t m_word = 0; ///< the header that is ready
    std::uint8_t m_nack = 0; ///< what is wrong with it; 0: nothing
    std::uint16_t m_length = 0;
    Bytes m_buffer; ///< the receive buffer; never cleared, as in the firmware
    Bytes m_lastResponse;
};

} // namespace simulation
