// The wishes that wait for the link, in order: those that act before those that only read. Every wish put in comes out
// once, as an Ended event.
#pragma once

#include "drive/task.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <vector>

namespace drive {

template <class P>
class WishQueue {
public:
    /// More are refused: no link answers that fast.
    static constexpr std::size_t kMaxWaiting = 1000;

    /// @return false if too many wait already; the task is gone then
    bool add(std::unique_ptr<WishTask<P>> task)
    {
        Queue &queue = task->onlyReads() ? m_reading : m_acting;
        if (queue.size() >= kMaxWaiting)
            return false;
        queue.push_back(std::move(task));
        return true;
    }
    /// Before all others; the drive's own, not counted.
    void addFirst(std::unique_ptr<WishTask<P>> task) { m_acting.push_front(std::move(task)); }
    /// A newer write: older ones of the same registers that have not left are not sent.
    void supersede(const Write &newer)
    {
        for (const auto &task : m_acting)
            task->supersede(newer);
    }

    /// The next task with something to ask, most urgent first; finished ones are ended on the way.
    /// @param armed  tasks that need arming are cut if this is false
    /// @param now    tasks that have expired are cut
    WishTask<P> *next(bool armed, TimePoint now);

    /// Ends the wishes that it holds for, all by default, but not the one in flight (may be null).
    void cut(
        const std::string &reason, const WishTask<P> *except,
        bool (*which)(OpenWish &) = [](OpenWish &) { return true; })
    {
        for (Queue *queue : {&m_acting, &m_reading})
            for (const auto &task : *queue)
                if (task.get() != except && which(*task))
                    task->cut(reason);
    }

    /// Ends and removes what has finished, reading its results out. @param now  when that was, for the motion log
    void collect(std::vector<Event> &events, TimePoint now);

private:
    using Queue = std::deque<std::unique_ptr<WishTask<P>>>;

    Queue m_acting, m_reading;
};

template <class P>
WishTask<P> *WishQueue<P>::next(bool armed, TimePoint now)
{
    for (Queue *queue : {&m_acting, &m_reading}) {
        for (const auto &task : *queue) {
            if (!armed && task->permission() == Permission::Armed)
                task->cut("not armed");
            if (task->expired(now))
                task->cut(kTooLate);
            if (!task->finished())
                return task.get();
        }
    }
    return nullptr;
}

template <class P>
void WishQueue<P>::collect(std::vector<Event> &events, TimePoint now)
{
    for (Queue *queue : {&m_acting, &m_reading}) {
        for (const auto &task : *queue) {
            if (auto readings = task->takeReadings(); !readings.empty())
                events.emplace_back(RegistersRead{std::move(readings)});
            if (auto &motion = task->motion(); task->finished() && motion) {
                motion->ended = std::max(motion->asked, now);
                motion->outcome = task->ended().outcome;
                motion->reason = task->ended().reason;
                events.emplace_back(std::move(*motion));
            }
            if (task->finished() && task->ended().id != 0)
                events.emplace_back(task->ended());
        }
        std::erase_if(*queue, [](const auto &task) { return task->finished(); });
    }
}

} // namespace drive
