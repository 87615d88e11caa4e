// ThreadSanitizer does not see the locks of Qt, because Debian's Qt is not instrumented: whatever a queued call or a
// job of a pool carries looks like a race, and so does what is ended after its thread. This tells it the order that
// there is: what comes before a call or a job is queued comes before what that does; what a thread or a job has done
// comes before the return of those who waited for it. Linked into every program of a build with it, and into no other.
#ifdef __SANITIZE_THREAD__

#include <QCoreApplication>
#include <QObject>
#include <QSemaphore>
#include <QThread>
#include <QThreadPool>
#include <QThreadStorage>
#include <sanitizer/tsan_interface.h>

#include <atomic>
#include <cstddef>
#include <dlfcn.h>
#include <utility>

extern "C" int __sanitizer_install_malloc_and_free_hooks(
    void (*allocated)(const volatile void *, std::size_t), void (*freed)(const volatile void *));

namespace {

char order; // its address stands for the lock
std::atomic<bool> probing{false};
std::atomic<std::size_t> ofCalls{0}; // bytes of the event that a queued call is

/// A call is put into its event right before that is queued, also a signal: then all that it carries has been made. The
/// event is known by its size, for other events carry nothing between threads.
void allocated(const volatile void *, std::size_t bytes)
{
    if (probing.load(std::memory_order_relaxed))
        ofCalls.store(bytes, std::memory_order_relaxed);
    else if (bytes == ofCalls.load(std::memory_order_relaxed))
        __tsan_release(&order);
}

void freed(const volatile void *) { }

/// Qt ends it in its thread behind all objects of that, and before what waits for the thread goes on.
struct LastOfThread {
    ~LastOfThread() { __tsan_release(&order); }
};

QThreadStorage<LastOfThread *> &lastOfThread()
{
    static QThreadStorage<LastOfThread *> last;
    return last;
}

bool delivered(void **)
{
    __tsan_acquire(&order);
    if (thread_local bool known = false; !std::exchange(known, true))
        lastOfThread().setLocalData(new LastOfThread);
    return false; // the event goes its way
}

/// What this program's own definition hides.
template <class Function>
Function hidden(const char *symbol)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, symbol));
}

} // namespace

// What begins or awaits something, with its order told. The linker takes these for the calls of this program and of
// other libraries; an object is the first argument.

/// The last of posting an event: a signal's arguments have been copied since its call was made. Where the other thread
/// is quicker than this, `allocated` has told of what came before, and tests/tsan.supp passes over the copies.
extern "C" void g_main_context_wakeup(void *context)
{
    static const auto wakeUp = hidden<void (*)(void *)>("g_main_context_wakeup");
    __tsan_release(&order);
    wakeUp(context);
}

void QThreadPool::start(std::function<void()> work, int priority)
{
    using Start = void (*)(QThreadPool *, std::function<void()>, int);
    static const auto start = hidden<Start>("_ZN11QThreadPool5startESt8functionIFvvEEi");
    std::function<void()> told = [work = std::move(work)] {
        __tsan_acquire(&order);
        work();
        __tsan_release(&order);
    };
    __tsan_release(&order); // what is made is made
    start(this, std::move(told), priority);
}

bool QThreadPool::waitForDone(int milliseconds)
{
    static const auto wait =
        hidden<bool (*)(QThreadPool *, int)>("_ZN11QThreadPool11waitForDoneEi");
    const bool done = wait(this, milliseconds);
    __tsan_acquire(&order);
    return done;
}

bool QThread::wait(QDeadlineTimer deadline)
{
    static const auto wait =
        hidden<bool (*)(QThread *, QDeadlineTimer)>("_ZN7QThread4waitE14QDeadlineTimer");
    const bool ended = wait(this, deadline);
    __tsan_acquire(&order);
    return ended;
}

void QSemaphore::acquire(int count)
{
    static const auto acquire = hidden<void (*)(QSemaphore *, int)>("_ZN10QSemaphore7acquireEi");
    acquire(this, count);
    __tsan_acquire(&order);
}

void QSemaphore::release(int count)
{
    static const auto release = hidden<void (*)(QSemaphore *, int)>("_ZN10QSemaphore7releaseEi");
    __tsan_release(&order);
    release(this, count);
}

namespace {

/// Before there is a second thread.
const bool told = [] {
    if (__sanitizer_install_malloc_and_free_hooks(allocated, freed) == 0)
        return false;
    QObject object;
    // Room in the queue.
    QMetaObject::invokeMethod(
        &object, [] {}, Qt::QueuedConnection);
    probing = true;
    QMetaObject::invokeMethod(
        &object, [] {}, Qt::QueuedConnection);
    probing = false;
    return QInternal::registerCallback(QInternal::EventNotifyCallback, delivered);
}();

} // namespace

#endif
