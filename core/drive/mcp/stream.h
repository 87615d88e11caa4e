// The stream of signals: turns a wish into a datalog configuration, and async packets into sample blocks with the
// layout they belong to.
//
// Each configuration gets a new mark, because boards ignore one with the active mark. It takes effect when the first
// packet with its mark arrives; until then packets belong to the configuration before. After every connection and
// recovery a stop goes out before the first configuration, because boards go on by themselves with what they had.
#pragma once

#include "drive/mcp/requests.h"
#include "drive/task.h"
#include "mcp/datalog_decoder.h"

#include <deque>
#include <optional>

namespace drive {

/// The SET that configures the datalog of our link.
McpSet datalogRequest(std::uint8_t linkId, const mcp::DatalogConfig &config);

class McpStreamControl {
public:
    explicit McpStreamControl(const McpFacts &board)
        : m_board(board)
    {
    }

    void restart(); ///< identified; nothing about its counter is known any more
    /// The stop was sent, and answered in whichever way.
    void stopSent() { m_stopNeeded = false; }
    void close(); ///< the link is given up: nothing is wanted any more
    /// Again, or after a recovery: the board may be streaming by itself.
    void connected() { m_stopNeeded = true; }

    void receive(ByteView packet, TimePoint now);
    void handleTimeout(TimePoint now);
    std::optional<TimePoint> nextTimeout() const { return m_stoppedAt; }

    std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    bool wanted() const { return !m_wanted.fast.empty() || !m_wanted.slow.empty(); }
    /// What was last agreed, to be asked for again after a reset.
    const Stream &wish() const { return m_wanted; }
    double load() const { return m_load; } ///< bytes a second on the line
    std::uint64_t packets() const { return m_packets; }
    std::uint64_t lostTicks() const { return m_lost; }
    std::uint64_t skipped() const { return m_skipped; }

private:
    friend class McpStreamTask;

    struct Active {
        mcp::DatalogConfig config;
        capture::StreamLayout layout;
    };
    std::string refuse(const Stream &stream) const;
    Result<mcp::DatalogConfig, std::string> configure(const Stream &stream);
    void sending(const Stream &stream, const mcp::DatalogConfig &config);
    void agreed(const Stream &stream, const mcp::DatalogConfig &config, TimePoint now);
    bool announce(const capture::SampleBlock &block, TimePoint now);
    void addStats();

    const McpFacts &m_board;
    std::optional<mcp::DatalogDecoder> m_decoder;
    /// Configurations whose packets may come, oldest first; the first is the active one.
    std::deque<Active> m_sent;
    capture::StreamId m_lastStream = 0;
    capture::StreamId m_announced = 0; ///< 0: none
    std::optional<double> m_origin; ///< seconds of tick 0
    unsigned m_epoch = 0;
    std::uint8_t m_lastMark = 0;
    Stream m_wanted;
    bool m_stopNeeded = true;
    /// When what was on its way at a stop has certainly arrived.
    std::optional<TimePoint> m_stoppedAt;
    double m_load = 0.0;
    mcp::DatalogDecoder::Stats m_seen; ///< of the decoder, as far as they are added up below
    std::uint64_t m_packets = 0, m_lost = 0, m_skipped = 0;
    std::vector<Event> m_events;
};

/// A stream wish. Sent again, with another mark, if its answer is lost, and once if it is refused, for payloads are not
/// protected: a configuration moves nothing.
class McpStreamTask : public WishTask<McpProtocol> {
public:
    McpStreamTask(WishId id, const Stream &stream, McpStreamControl &control);

    std::optional<McpRequest> nextRequest(TimePoint now) override;
    void onResponse(const McpAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    McpStreamControl &m_control;
    Stream m_stream;
    bool m_stopping = false; ///< the stop that comes before a configuration is on its way
    mcp::DatalogConfig m_config;
    int m_losses = 0;
    bool m_refusedOnce = false;
};

} // namespace drive
