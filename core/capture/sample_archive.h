// Where samples go that there is no memory for: the face that a capture sees. It takes bytes that will not change any
// more, and tells later where they can be read from. No I/O here; core/session has the archive on a disk.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace capture {

/// Bytes that are not written any more; `data` keeps them alive, wherever they are.
struct Stretch {
    std::shared_ptr<const std::byte> data;
    std::size_t size = 0;
};

/// What became of some stretches that were handed over together. Settled once, by the archive, in any thread; read by
/// the thread that handed them over. The state is the only thing that two threads touch.
class Deposit {
public:
    enum class State : std::uint8_t {
        Waiting,
        Stored,
        Refused, ///< no room, or the disk failed: they stay where they were
    };

    /// A thread that reads the state sees what was done before the deposit was made.
    Deposit() { m_state.store(State::Waiting, std::memory_order_release); }
    Deposit(const Deposit &) = delete;
    Deposit &operator=(const Deposit &) = delete;
    /// Behind what was settled, whoever lets go of it last.
    ~Deposit() { (void)state(); }

    State state() const { return m_state.load(std::memory_order_acquire); }
    void wait() const { m_state.wait(State::Waiting, std::memory_order_acquire); }

    /// The same bytes in the archive, in the order in which they were handed over; only when Stored.
    const std::vector<Stretch> &stretches() const { return m_stretches; }

    void settle(State state, std::vector<Stretch> stretches = {})
    {
        m_stretches = std::move(stretches);
        m_state.store(state, std::memory_order_release);
        m_state.notify_all();
    }

private:
    std::atomic<State> m_state;
    std::vector<Stretch> m_stretches;
};

class SampleArchive {
public:
    SampleArchive() = default;
    SampleArchive(const SampleArchive &) = delete;
    SampleArchive &operator=(const SampleArchive &) = delete;
    virtual ~SampleArchive() = default;

    /// Bytes that a capture may keep here; may change at any time, 0 switches the archive off.
    virtual std::uint64_t budget() const = 0;
    /// Bytes that are handed over at once, at most; more than a stretch.
    virtual std::size_t pieceBytes() const = 0;
    /// Never waits. Deposits are settled in the order in which they were made. Room is used again when the last
    /// stretch of a deposit is let go, in any thread.
    virtual std::shared_ptr<const Deposit> store(std::vector<Stretch> stretches) = 0;
};

} // namespace capture
