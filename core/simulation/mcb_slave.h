// The slave half of MCB: one call a frame, because both sides send at once. It answers as a static device, so that every
// answer can be foretold; motors are another's business.
//
//   Config state: frames of 12 bytes.  Cyclic state: frames of 12 + 2 n bytes, n words of the mapping.
//   A write of 0x640 changes the state when its ACK has been sent: the frame after it has the new length.
//
// Behind it: McbStream, the same as a stream of bytes, for programs that know no SPI.
// Source: "MCB protocol description"; the sessions that mcblib's master ran (tests/data/vectors/mcb.jsonl).
#pragma once

#include "mcb/fragments.h"
#include "simulation/device.h"
#include "simulation/mcb_registers.h"

#include <deque>
#include <optional>

namespace simulation {

class McbSlave {
public:
    struct Counts {
        std::uint64_t frames = 0, wrongLength = 0, badFrames = 0;
    };

    explicit McbSlave(const McbRig &rig);

    /// How long a frame is now.
    std::size_t frameBytes() const;

    /// What it sends while `input` comes, in as many bytes: cut or filled up with zeros if the length is not that of the
    /// state. An input of another length, or one that is damaged, changes nothing.
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
    int m_replyDelay;
    int m_wait = 0; ///< IDLE frames before the answer
    std::deque<mcb::Frame> m_answers;
    mcb::Gatherer m_written;
    std::optional<McbRegisters::Mapping> m_cyclic; ///< in force; empty: config state
    bool m_switches = false; ///< the answer that waits is the ACK of a 0x640 write
    Counts m_counts;
};

/// A slave behind a byte stream: whenever a whole frame has come in, as many bytes go out. The end of the answer means
/// that the ready line is high again; a frame that stays unfinished for kUnfinished is dropped, as when chip select
/// goes high.
class McbStream final : public Device {
public:
    static constexpr Duration kUnfinished = std::chrono::milliseconds(50);

    explicit McbStream(McbRig rig)
        : m_rig(std::move(rig))
        , m_slave(m_rig)
    {
    }

    void receive(ByteView bytes, TimePoint now) override;
    void advance(TimePoint now) override;
    [[nodiscard]] Bytes takeOutput() override { return std::exchange(m_output, {}); }
    [[nodiscard]] TimePoint nextWake() const override;

    void reset(); ///< as by a power cycle: config state, values of the rig
    const McbSlave &slave() const { return m_slave; }

private:
    McbRig m_rig;
    McbSlave m_slave;
    Bytes m_input, m_output;
    TimePoint m_lastInput{};
};

} // namespace simulation
