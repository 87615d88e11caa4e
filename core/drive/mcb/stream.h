// The stream of signals: the registers of a wish in the cyclic state's mapping, and every good frame a group of
// samples.
//
// A tick of the layout is a microsecond of the session's clock: samples carry the instant at which their frame left, so
// a frame that was late is late in the plot, too. A frame that was damaged is a gap.
#pragma once

#include "drive/mcb/requests.h"
#include "drive/mcb/set_points.h"
#include "drive/task.h"

#include <deque>

namespace drive {

class McbStreamControl {
public:
    explicit McbStreamControl(const McbFacts &board)
        : m_board(board)
    {
    }

    /// The cyclic state is over, wanted or not.
    void ended();
    /// The link is given up: nothing is wanted any more.
    void close()
    {
        ended();
        m_wanted = {};
    }

    void receive(const mcb::Master::Cycle &cycle, std::uint64_t lostFrames);
    void interrupted() { m_broken = true; } ///< frames were lost uncounted
    /// Whether the cyclic state was left to write another mapping, and that was broken off; once.
    bool takeLeftOff() { return std::exchange(m_leftOff, false); }
    void flush(TimePoint now);
    std::optional<TimePoint> nextFlush() const;

    std::vector<Event> takeEvents() { return std::exchange(m_events, {}); }
    bool wanted() const { return !m_wanted.fast.empty() || !m_wanted.slow.empty(); }
    const Stream &wish() const { return m_wanted; }
    bool running() const { return m_running; } ///< the cyclic state, with signals or without
    Duration period() const { return m_period; }
    std::uint64_t packets() const { return m_packets; }
    std::uint64_t lost() const { return m_lost; }

private:
    friend class McbStreamTask;

    /// @param told  the type of each signal
    void begin(const Stream &stream, const std::vector<RegisterId> &ids,
        const std::map<std::uint16_t, mcb::Info> &told);

    const McbFacts &m_board;
    Stream m_wanted;
    Duration m_period{};
    bool m_running = false, m_leftOff = false;
    std::optional<capture::StreamLayout> m_layout; ///< of what runs, if it has signals
    std::vector<mcb::Info> m_infos; ///< of its signals
    bool m_announced = false, m_broken = false;
    TimePoint m_origin{}; ///< tick 0
    capture::Tick m_lastTick = 0;
    capture::StreamId m_lastStream = 0;
    capture::SampleBlock m_block; ///< not handed out yet
    std::uint64_t m_packets = 0, m_lost = 0;
    std::vector<Event> m_events;
};

/// Into the cyclic state with other signals than before, with set-points or without: types are asked and set-points
/// read, then it is left where it is, the mapping written, and entered. So what is refused leaves everything as it was.
class McbStreamTask : public WishTask<McbProtocol> {
public:
    /// Set-points travel on if they did.
    McbStreamTask(
        WishId id, const Stream &stream, McbStreamControl &control, McbSetPoints &setPoints);
    /// The signals stay as they are.
    McbStreamTask(WishId id, const CyclicSetPoints &wanted, McbStreamControl &control,
        McbSetPoints &setPoints);

    std::optional<McbRequest> nextRequest(TimePoint now) override;
    void onResponse(const McbAnswer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;
    void cut(const std::string &reason) override;

private:
    enum class Step : std::uint8_t { Standing, Info, Hold, Unmap, Map };
    struct Planned {
        Step step = Step::Map;
        std::uint16_t address = 0; ///< not of Unmap and Map
    };

    bool plan(); ///< false: it has ended already
    std::string refuse() const;
    bool travels() const { return m_turn.value_or(m_setPoints.wanted()); }
    mcb::Mapping mapping() const;
    void finish();
    void fail(Outcome outcome, std::string reason);
    std::string reasonInStanding(std::uint16_t address, const McbAnswer &answer) const;
    void onInfo(std::uint16_t address, const McbAnswer &answer);

    McbStreamControl &m_control;
    McbSetPoints &m_setPoints;
    std::optional<bool> m_turn; ///< of a wish for set-points
    Stream m_stream;
    std::vector<RegisterId> m_ids; ///< fast, then slow, each once
    std::deque<Planned> m_steps; ///< the first one is asked
    std::map<std::uint16_t, mcb::Info> m_told; ///< by address, what the drive said to Info
    bool m_planned = false, m_unmapped = false;
};

} // namespace drive
