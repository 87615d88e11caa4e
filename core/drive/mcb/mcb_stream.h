// The stream of signals: the registers of a wish in the cyclic state's mapping, and every good frame a group of samples.
//
// A tick of the layout is a microsecond of the session's clock: samples carry the instant at which their frame left, so a
// frame that was late is late in the plot, too. A frame that was damaged is a gap.
#pragma once

#include "drive/mcb/mcb_board.h"
#include "drive/task.h"
#include "mcb/master.h"

#include <memory>

namespace drive {

class McbStreamControl {
public:
    explicit McbStreamControl(const McbBoard &board)
        : m_board(board)
    {
    }

    /// The cyclic state is over, wanted or not.
    void ended();
    void close(); ///< the link is given up: nothing is wanted any more

    void receive(const mcb::Master::Cycle &cycle, std::uint64_t lostFrames);
    void interrupted() { m_broken = true; } ///< frames were lost that nobody counted
    void flush(TimePoint now);
    std::optional<TimePoint> nextFlush() const;

    std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    bool wanted() const { return !m_wanted.fast.empty() || !m_wanted.slow.empty(); }
    const Stream &wish() const { return m_wanted; }
    bool running() const { return m_layout.has_value(); }
    Duration period() const { return m_period; }
    std::uint64_t packets() const { return m_packets; }
    std::uint64_t lost() const { return m_lost; }

private:
    friend class McbStreamTask;

    std::string refuse(const Stream &stream) const;
    void begin(const Stream &stream, const std::vector<RegisterId> &ids);
    void add(capture::SampleBlock block);

    const McbBoard &m_board;
    Stream m_wanted;
    Duration m_period{};
    std::optional<capture::StreamLayout> m_layout; ///< of what runs
    std::vector<mcb::Info> m_infos; ///< of its signals
    bool m_announced = false, m_broken = false;
    TimePoint m_origin{}; ///< tick 0
    capture::Tick m_lastTick = 0;
    capture::StreamId m_lastStream = 0;
    capture::SampleBlock m_block; ///< not handed out yet
    std::optional<TimePoint> m_blockSince;
    std::uint64_t m_packets = 0, m_lost = 0;
    std::vector<Event> m_events;
};

/// A stream wish: out of the cyclic state where there is one, types asked, mapping written, into it.
class McbStreamTask : public WishTask {
public:
    McbStreamTask(WishId id, const Stream &stream, McbStreamControl &control);

    std::optional<Bytes> nextRequest(TimePoint now) override;
    void takeResponse(ByteView response, TimePoint now) override;
    void takeNoResponse(std::optional<bool> executed, TimePoint now) override;
    bool takeTypeChanged() { return std::exchange(m_typeChanged, false); }

private:
    enum class Step : std::uint8_t { Begin, Unmap, Infos, Map };

    McbStreamControl &m_control;
    Stream m_stream;
    std::vector<RegisterId> m_ids; ///< fast, then slow, each once
    std::size_t m_asked = 0;
    Step m_step = Step::Begin;
    bool m_typeChanged = false;
};

} // namespace drive
