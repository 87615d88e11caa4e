// The wishes that wait for the link, in order: those that act before those that only read. Every wish put in comes out
// once, as an Ended event.
#pragma once

#include "drive/task.h"

#include <deque>
#include <memory>
#include <vector>

namespace drive {

class WishQueue {
public:
    static constexpr std::size_t kMaxWaiting =
        1000; ///< more are refused: somebody asks faster than any link answers

    /// @return false if too many wait already; the task is gone then
    bool add(std::unique_ptr<WishTask> task);
    void addFirst(
        std::unique_ptr<WishTask> task); ///< before all others; the drive's own, not counted
    /// A newer write: older ones of the same registers that have not left are not sent.
    void supersede(const Write &newer);

    /// The next task with something to ask, most urgent first; finished ones are ended on the way.
    /// @param armed  tasks that need arming are cut if this is false
    /// @param now    tasks that have expired are cut
    WishTask *next(bool armed, TimePoint now);

    /// Ends all wishes but the one in flight (may be null).
    void cutAll(const std::string &reason, const WishTask *except);
    void cutArmed(const std::string &reason, const WishTask *except);

    /// Ends and removes what has finished, reading its results out. @param now  when that was, for the motion log
    void collect(std::vector<Event> &events, TimePoint now);
    bool contains(const Task *task) const;

private:
    using Queue = std::deque<std::unique_ptr<WishTask>>;
    void collectFrom(Queue &queue, std::vector<Event> &events, TimePoint now);

    Queue m_acting, m_reading;
};

} // namespace drive
