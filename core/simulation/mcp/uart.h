// The serial port of a simulated board: a receiver whose DMA has to be armed for every piece, and a transmitter with
// ST's queue. Neither decodes the bytes; time is an argument.
// Source: mcp-aspep facts 3.1 and 3.5, seen with ST's handlers on an emulated UART.
#pragma once

#include "aspep/packet.h"
#include "base/bytes.h"
#include "base/time.h"
#include "simulation/mcp/liars.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <utility>

namespace simulation {

/// Bytes come in at the baud rate. Armed, they go where arm() said; unarmed, the UART holds one and the next sets
/// overrun: from then on everything is lost up to the next idle line.
class UartReceiver {
public:
    enum class Happened : std::uint8_t { Nothing, TransferComplete, LineIdle };

    explicit UartReceiver(std::uint32_t baud);

    /// Bytes on the line from `now` on, or behind those that are still coming. Bounded: what exceeds kMaxQueued is
    /// lost.
    void put(ByteView bytes, TimePoint now);

    std::optional<TimePoint> nextEvent() const;
    /// Lets the event at nextEvent() happen.
    Happened step();

    /// The next target.size() bytes go to `target`, a held one first. Ends an earlier transfer.
    void arm(std::span<std::uint8_t> target);
    /// Nothing is received until the line was busy once more and fell idle: then LineIdle happens.
    void awaitIdle();
    /// Whether the armed transfer is complete; says so once.
    bool takeComplete() { return std::exchange(m_complete, false); }

    void reset(); ///< forgets everything, also what is still on the line

    static constexpr std::size_t kMaxQueued = 65536;

private:
    struct Byte {
        TimePoint end;
        std::uint8_t value = 0;
    };
    void accept(std::uint8_t value);
    bool idleComesFirst() const;

    Duration m_byteTime;
    std::deque<Byte> m_line;
    TimePoint m_lastEnd{};
    std::span<std::uint8_t> m_target;
    std::size_t m_filled = 0;
    std::optional<std::uint8_t> m_held;
    bool m_complete = false;
    bool m_errorEnabled = true; ///< the overrun interrupt; off until the line is idle again
    bool m_idleEnabled = false;
    bool m_sawByte = false; ///< since the last idle event
};

/// What goes wrong on the line behind the transmitter.
struct LineFaults {
    TimePoint muteUntil{};
    std::optional<std::uint64_t> corruptAfter;
};

/// One packet at a time leaves at the baud rate. Waiting: one response, one control packet (a newer one replaces it),
/// async packets in two buffers; they leave in this order.
class Transmitter {
public:
    Transmitter(std::uint32_t baud, Liar &liar); ///< every packet passes the liar

    bool responseFree() const { return !m_response && m_kind != Kind::Response; }
    void sendResponse(Bytes packet, TimePoint now);
    void sendControl(const aspep::HeaderBytes &packet, TimePoint now);
    void sendAsIs(Bytes bytes, TimePoint now); ///< in the place of a response

    /// Takes one of the two async buffers; false if both wait for the line.
    bool acquireAsync();
    void releaseAsync(); ///< the buffer is thrown away
    void sendAsync(Bytes packet, TimePoint now);

    std::optional<TimePoint> nextEvent() const; ///< when the packet on the line has left
    void step(); ///< lets that happen

    void discardWaiting(); ///< what is not on the line yet never leaves

    /// Appends what has left by `now`, as it looks behind the line.
    void collect(TimePoint now, LineFaults &faults, Bytes &out);
    void reset();

private:
    enum class Kind : std::uint8_t { None, Response, Control, Async };
    void start(TimePoint now);
    void begin(Kind kind, Bytes packet, TimePoint now);
    TimePoint endOf(std::size_t bytes) const { return m_start + wireTime(bytes, m_baud); }

    std::uint32_t m_baud;
    Liar *m_liar;
    std::optional<Bytes> m_response;
    std::optional<Bytes> m_control;
    std::deque<Bytes> m_async;
    int m_asyncBusy = 0;
    Kind m_kind = Kind::None;
    Bytes m_packet; ///< on the line
    TimePoint m_start{};
    std::size_t m_collected = 0; ///< bytes of it that collect() gave out
    Bytes m_left; ///< ends of packets that left before they were collected
    std::vector<TimePoint> m_leftTimes;
};

} // namespace simulation
