// The datalog of the firmware: samples variables every few HF tasks into packets and hands them to the line. It reads
// its configuration like the firmware does, stale bytes and half-accepted refusals included.
// Source: mcp-aspep facts 6.1 to 6.3; the recorded datalog sessions.
#pragma once

#include "mcp/protocol.h"
#include "simulation/stale_bytes.h"

#include <array>
#include <cstdint>
#include <functional>

namespace simulation {

struct RegisterContext;

/// A variable that can be logged: how to read it. Without `get` there is none, it reads 0.
struct Source {
    std::uint32_t (*get)(const RegisterContext &) = nullptr;
    const RegisterContext *of = nullptr;
    bool upperHalf = false; ///< 32 bits of which packets carry the upper 16
};

/// What a build does with an identifier that it does not know.
enum class UnknownSignal : std::uint8_t { ReadsZero, KeepsPrevious };

/// The buffers of the line, as the recorder uses them.
class AsyncLine {
public:
    virtual ~AsyncLine() = default;
    virtual bool acquire() = 0; ///< one of two buffers; false while both wait
    virtual void send(ByteView payload) = 0; ///< and gives the buffer back when it has left
    virtual void release() = 0; ///< gives it back with nothing in it
    virtual std::size_t payloadMax() const = 0; ///< negotiated; 0: there are no async packets
};

class DatalogRecorder {
public:
    using FindSource = std::function<Source(mcp::RegisterId)>;

    DatalogRecorder(int streams, UnknownSignal unknown, FindSource find, AsyncLine &line);

    /// A SET of ASYNC_*: `value` starts behind the raw size.
    mcp::Status configure(const StaleBytes &value);
    /// The structure as the text prints it, without a packet size: 32-bit MF values, counted in HF tasks, and the id in
    /// front of the mark. A signal that cannot be logged is refused.
    mcp::Status configureAsPrinted(const StaleBytes &value, int size);
    void tick(std::uint32_t timestamp); ///< once an HF task
    void flush(); ///< sends the unfinished packet, without MF values
    void reset(); ///< stops, and what was recorded is thrown away
    bool running() const { return m_mark != 0; }

    static constexpr std::size_t kMaxSignals = 64;

private:
    struct Signal {
        Source source;
        std::uint8_t width = 2; ///< bytes in the packet
    };
    struct Configuration {
        bool asPrinted = false;
        std::uint8_t hfRate = 0, hfCount = 0, mfRate = 0, mfCount = 0;
        std::size_t trigger = 0; ///< the packet is full when its write index is beyond this
        std::array<Signal, kMaxSignals> logged{};
    };
    void stop();
    void tickAsPrinted(std::uint32_t timestamp);
    void begin(std::uint32_t timestamp);
    void appendBlock();
    void appendHf();
    void appendMf();
    void append(const Signal &signal);
    void appendNumber(std::uint32_t value, std::size_t width); ///< low byte first

    std::size_t m_streams;
    UnknownSignal m_unknown;
    FindSource m_find;
    AsyncLine &m_line;
    Configuration m_pending, m_active;
    std::uint8_t m_mark = 0, m_activeMark = 0;
    bool m_changed = false; ///< as printed: a configuration waits for the next packet
    std::uint8_t m_hfIndex = 0, m_mfIndex = 0;
    Bytes m_packet; ///< empty: no buffer taken
};

} // namespace simulation
