#include "drive/wish_queue.h"

#include <algorithm>

namespace drive {

bool WishQueue::add(std::unique_ptr<WishTask> task)
{
    Queue &queue = task->onlyReads() ? m_reading : m_acting;
    if (queue.size() >= kMaxWaiting)
        return false;
    queue.push_back(std::move(task));
    return true;
}

void WishQueue::addFirst(std::unique_ptr<WishTask> task) { m_acting.push_front(std::move(task)); }

void WishQueue::supersede(const Write &newer)
{
    for (const auto &task : m_acting)
        task->supersede(newer);
}

WishTask *WishQueue::next(bool armed, TimePoint now)
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

void WishQueue::cutAll(const std::string &reason, const WishTask *except)
{
    for (Queue *queue : {&m_acting, &m_reading})
        for (const auto &task : *queue)
            if (task.get() != except)
                task->cut(reason);
}

void WishQueue::cutArmed(const std::string &reason, const WishTask *except)
{
    for (const auto &task : m_acting)
        if (task->permission() == Permission::Armed && task.get() != except)
            task->cut(reason);
}

void WishQueue::collect(std::vector<Event> &events, TimePoint now)
{
    collectFrom(m_acting, events, now);
    collectFrom(m_reading, events, now);
}

void WishQueue::collectFrom(Queue &queue, std::vector<Event> &events, TimePoint now)
{
    for (const auto &task : queue) {
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
    std::erase_if(queue, [](const auto &task) { return task->finished(); });
}

bool WishQueue::contains(const Task *task) const
{
    const auto holds = [&](const Queue &queue) {
        return std::any_of(
            queue.begin(), queue.end(), [&](const auto &one) { return one.get() == task; });
    };
    return holds(m_acting) || holds(m_reading);
}

} // namespace drive
