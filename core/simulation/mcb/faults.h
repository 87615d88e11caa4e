// What a wire or a drive does wrong on purpose: each fault strikes a frame with a chance of its own, from a seed, so
// that the same seed gives the same run. Source: the fault switches of "MCB protocol description", section 9.
#pragma once

#include "base/random.h"
#include "mcb/frame.h"

#include <array>
#include <deque>
#include <optional>
#include <span>
#include <string_view>

namespace simulation {

enum class McbFault : std::uint8_t {
    Flip, ///< a bit of what the drive sends
    FlipInput, ///< a bit of what it hears
    SwapBytes, ///< the bytes of every word it sends
    WrongAddress, ///< an answer that names the next register
    StaleAck, ///< the last answer once more where IDLE is due
    ErrorInside, ///< an error instead of an answer or of a fragment
    IdleBetween, ///< IDLE, and the answer a frame later
    LostAnswer, ///< IDLE, and no answer at all
    Garbage, ///< anything in words that are not needed
    CrcError, ///< it says that the frame before was damaged
    NotReady, ///< the ready line stays low: nothing comes back
    Glitch, ///< a frame while it was not ready: nonsense
    DeadLow, ///< all bits 0, for several frames
    DeadHigh,
    Reset, ///< a power cycle
};
constexpr std::size_t kMcbFaults = 15;

struct McbFaultRow {
    McbFault fault;
    std::string_view name; ///< what a command line calls it
    std::string_view help;
};
std::span<const McbFaultRow> mcbFaultList();

/// A fault, and about how many frames lie between two of its kind.
struct McbFaultChoice {
    McbFault fault = McbFault::Flip;
    std::uint32_t every = 100;
};

/// Stands between the wire and a slave. Knows no registers.
class McbSpoiler {
public:
    McbSpoiler() = default;
    McbSpoiler(std::span<const McbFaultChoice> faults, std::uint64_t seed);

    bool honest() const { return m_none; }
    /// The drive starts anew before this frame.
    bool resets();
    /// Nothing is heard and nothing comes back.
    bool silent() { return strikes(McbFault::NotReady); }
    void spoilInput(Bytes &input);
    /// @param whole  it is a frame, and not one that was cut or filled up
    Bytes spoilOutput(Bytes output, bool whole = true);

private:
    bool strikes(McbFault fault);
    std::uint64_t random() { return splitmix64(m_state); }
    void spoilAnswer(mcb::Frame &frame);

    std::array<std::uint32_t, kMcbFaults> m_every{};
    bool m_none = true;
    std::uint64_t m_state = 0;
    int m_dead = 0;
    std::uint8_t m_deadLevel = 0;
    bool m_crcErrorDue = false;
    std::deque<mcb::Frame> m_late;
    std::optional<mcb::Frame> m_lastAnswer;
};

} // namespace simulation
