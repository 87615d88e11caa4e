// The slave half of MCB: one call a frame, because both sides send at once. Alone it answers as a static device, so
// that every answer can be foretold; a motor behind its registers is another's business (McbLife).
//
//   Config state: frames of 12 bytes.  Cyclic state: frames of 12 + 2 n bytes, n words of the mapping.
//   A write of 0x640 changes the state when its ACK has been sent: the frame after it has the new length.
//
// Behind it: McbStream, the same as a stream of bytes, for programs that know no SPI.
// Source: "MCB protocol description"; the sessions that mcblib's master ran (tests/data/vectors/mcb.jsonl).
#pragma once

#include "mcb/fragments.h"
#include "simulation/device.h"
#include "simulation/mcb/registers.h"

#include <deque>
#include <functional>
#include <optional>
#include <utility>

namespace simulation {

/// A slave behind a byte stream: whenever a whole frame has come in, as many bytes go out. The end of the answer means
/// that the ready line is high again; a frame that stays unfinished for kUnfinished is dropped, as when chip select
/// goes high.
class McbFraming {
public:
    static constexpr Duration kUnfinished = std::chrono::milliseconds(50);

    /// @param length    of a frame now
    /// @param exchange  what goes out while a frame comes in; shorter or empty: it is torn
    void receive(ByteView bytes, TimePoint now, const std::function<std::size_t()> &length,
        const std::function<Bytes(ByteView)> &exchange)
    {
        advance(now);
        if (!bytes.empty())
            m_lastInput = now;
        m_input.insert(m_input.end(), bytes.begin(), bytes.end());
        std::size_t taken = 0;
        for (std::size_t size = length(); m_input.size() - taken >= size; size = length()) {
            const Bytes output = exchange(ByteView(m_input).subspan(taken, size));
            m_output.insert(m_output.end(), output.begin(), output.end());
            taken += size;
        }
        m_input.erase(m_input.begin(), m_input.begin() + static_cast<std::ptrdiff_t>(taken));
    }
    void advance(TimePoint now)
    {
        if (!m_input.empty() && now - m_lastInput >= kUnfinished)
            m_input.clear();
    }
    Bytes takeOutput() { return std::exchange(m_output, {}); }
    bool outputWaits() const { return !m_output.empty(); }
    TimePoint nextWake() const
    {
        return m_input.empty() ? TimePoint::max() : m_lastInput + kUnfinished;
    }
    void clear()
    {
        m_input.clear();
        m_output.clear();
    }

private:
    Bytes m_input, m_output;
    TimePoint m_lastInput{};
};

class McbSlave {
public:
    struct Counts {
        std::uint64_t frames = 0, wrongLength = 0, badFrames = 0;
    };

    /// @param life  what changes the registers and is moved by them; outlives the slave
    explicit McbSlave(const McbRig &rig, McbLife *life = nullptr);

    /// How long a frame is now.
    std::size_t frameBytes() const { return mcb::frameBytes(m_cyclic ? m_cyclic->words : 0); }

    /// What it sends while `input` comes, in as many bytes: cut or filled up with zeros if the length is not that of
    /// the state. An input of another length, or one that is damaged, changes nothing.
    Bytes exchange(ByteView input);

    bool cyclic() const { return m_cyclic.has_value(); }
    const McbRegisters &registers() const { return m_registers; }
    const Counts &counts() const { return m_counts; }

private:
    mcb::Frame nextOutput();
    void handle(const mcb::Frame &request);
    void handleWrite(const mcb::Frame &request);
    void answer(std::vector<mcb::Frame> frames);
    void refuse(const mcb::Frame &request, mcb::Command command, mcb::ErrorCode code);
    void switchState();
    void abandonSwitch();

    McbRegisters m_registers;
    McbLife *m_life;
    int m_replyDelay;
    int m_wait = 0; ///< IDLE frames before the answer
    std::deque<mcb::Frame> m_answers;
    mcb::Gatherer m_written;
    std::optional<McbRegisters::Mapping> m_cyclic; ///< in force; empty: config state
    bool m_switches = false; ///< the answer that waits is the ACK of a 0x640 write
    Counts m_counts;
};

/// A static slave behind a byte stream.
class McbStream final : public ByteDevice {
public:
    static constexpr Duration kUnfinished = McbFraming::kUnfinished;

    explicit McbStream(McbRig rig)
        : m_rig(std::move(rig))
        , m_slave(m_rig)
    {
    }

    void receive(ByteView bytes, TimePoint now) override;
    void advance(TimePoint now) override { m_framing.advance(now); }
    [[nodiscard]] Bytes takeOutput() override { return m_framing.takeOutput(); }
    [[nodiscard]] TimePoint nextWake() const override { return m_framing.nextWake(); }

    void reset(); ///< as by a power cycle: config state, values of the rig
    const McbSlave &slave() const { return m_slave; }

private:
    McbRig m_rig;
    McbSlave m_slave;
    McbFraming m_framing;
};

} // namespace simulation
