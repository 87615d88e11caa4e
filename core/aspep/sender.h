// What goes out to a Performer: one packet, and its reply is due then. It knows when each has left, at the earliest or
// as its owner tells, and so what began too soon to be an answer. It judges no reply; how long one may take is the
// owner's to say.
#pragma once

#include "aspep/packet.h"
#include "base/output.h"
#include "base/time.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace aspep {

class Sender {
public:
    /// Before what follows an unanswered packet: the Performer listens again only after its next 1 ms task.
    static constexpr Duration kBlindGap = std::chrono::milliseconds(2);

    /// `payloadPause`: between a header and its payload.
    Sender(std::uint32_t baud, Duration payloadPause)
        : m_baud(baud)
        , m_payloadPause(payloadPause)
    {
    }

    /// `dataCrc`: a CRC follows the payload. `replyTime`: for the reply, once all has left. @return  bytes on the wire
    std::size_t send(
        const Packet &packet, bool dataCrc, Duration gap, Duration replyTime, TimePoint now);
    /// All output taken so far has left: `replyTime` counts from here.
    void handleSent(Duration replyTime, TimePoint now);
    /// The reply has come, or is not waited for any longer.
    void settle() { m_replyDue.reset(); }
    void putOff(Duration more) { *m_replyDue += more; }

    /// Nothing is on the line from now on.
    void freeLine(TimePoint now) { m_lineFree = std::min(m_lineFree, now); }
    /// The last packet takes the place of all that has not left.
    void overtake() { m_output.back().dropsEarlier = true; }
    void clear() { m_output.clear(); }
    [[nodiscard]] std::vector<Output> takeOutput() { return std::exchange(m_output, {}); }

    /// For Controller::blindScript(), to a board with which `known` was agreed.
    std::vector<Output> blindScript(
        const std::vector<Bytes> &payloads, const std::optional<Beacon> &known) const;

    const std::optional<TimePoint> &replyDue() const { return m_replyDue; }
    TimePoint askedAt() const { return m_askedAt; } ///< when the last packet left
    bool pending() const { return m_sentPending; } ///< it has not, as far as is known
    /// A packet that began then can answer the last one.
    bool answerable(TimePoint began) const { return began >= m_answerableAt; }
    /// The last packet was taken, and its reply is due; since it left less than `time` has passed.
    bool justAsked(Duration time, TimePoint now) const;

private:
    void append(std::vector<Output> &to, const Packet &packet, bool dataCrc, Duration gap) const;

    std::uint32_t m_baud;
    Duration m_payloadPause;
    std::vector<Output> m_output;
    std::optional<TimePoint> m_replyDue; ///< of the last packet
    TimePoint m_askedAt;
    TimePoint m_answerableAt; ///< what began before answers something else than the last packet
    TimePoint m_lineFree; ///< when all that was handed over has left, at the earliest
    bool m_sentPending = false; ///< m_replyDue is an estimate until handleSent()
};

} // namespace aspep
