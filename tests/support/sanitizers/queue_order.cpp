#include "support/sanitizers/queue_order.h"

#ifdef __SANITIZE_THREAD__

#include <QCoreApplication>
#include <QObject>
#include <sanitizer/tsan_interface.h>

#include <atomic>
#include <cstddef>

extern "C" int __sanitizer_install_malloc_and_free_hooks(
    void (*allocated)(const volatile void *, std::size_t), void (*freed)(const volatile void *));

namespace {

char order; // its address stands for the lock
std::atomic<bool> probing{false};
std::atomic<std::size_t> ofCalls{0}; // bytes of the event that a queued call is

/// A call is put into its event right before that is queued, also a signal: then all that it carries has been made. The event
/// is known by its size, for other events carry nothing between threads.
void allocated(const volatile void *, std::size_t bytes)
{
    if (probing.load(std::memory_order_relaxed))
        ofCalls.store(bytes, std::memory_order_relaxed);
    else if (bytes == ofCalls.load(std::memory_order_relaxed))
        __tsan_release(&order);
}

void freed(const volatile void *) { }

bool delivered(void **)
{
    __tsan_acquire(&order);
    return false; // the event goes its way
}

} // namespace

void support::tellQueueOrder()
{
    if (__sanitizer_install_malloc_and_free_hooks(allocated, freed) == 0)
        return;
    QObject object;
    QMetaObject::invokeMethod(
        &object, [] {}, Qt::QueuedConnection); // room in the queue
    probing = true;
    QMetaObject::invokeMethod(
        &object, [] {}, Qt::QueuedConnection);
    probing = false;
    QInternal::registerCallback(QInternal::EventNotifyCallback, delivered);
}

#else

void support::tellQueueOrder() { }

#endif
