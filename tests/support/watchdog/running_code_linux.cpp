#include "support/watchdog/beats.h"
#include "support/watchdog/running_code.h"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace support {

namespace {

constexpr int kMost = 64;
constexpr int kTold = 24; ///< the rest is how events come
void *addresses[kMost];
volatile std::sig_atomic_t count = 0;

void note(int) { count = backtrace(addresses, kMost); }

/// A timer of what this thread computes.
timer_t makeTimer()
{
    void *first[1];
    backtrace(first, 1); // loads what a handler must not load
    struct sigaction action = {};
    action.sa_handler = &note;
    action.sa_flags = SA_RESTART;
    const int signal = SIGRTMIN + 5;
    sigaction(signal, &action, nullptr);
    sigevent event = {};
    event.sigev_notify = SIGEV_THREAD_ID;
    event.sigev_signo = signal;
    event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
    timer_t timer = {};
    timer_create(CLOCK_THREAD_CPUTIME_ID, &event, &timer);
    return timer;
}

std::string nameOf(void *address)
{
    Dl_info info = {};
    if (!dladdr(address, &info) || !info.dli_sname)
        return {};
    int status = -1;
    char *plain = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status);
    std::string name = status == 0 ? plain : info.dli_sname;
    std::free(plain);
    return name;
}

} // namespace

double threadSeconds()
{
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

void noteCodeAfter(double seconds)
{
    static const timer_t timer = makeTimer();
    if (seconds > 0.0)
        count = 0;
    itimerspec when = {};
    when.it_value.tv_nsec = static_cast<long>(seconds * 1e9);
    timer_settime(timer, 0, &when, nullptr);
}

std::vector<std::string> codeThatRan()
{
    std::vector<std::string> names;
    constexpr int kOwn = 2; // the handler and what called it
    for (int i = kOwn; i < count && names.size() < kTold; ++i)
        if (std::string name = nameOf(addresses[i]); !name.empty())
            names.push_back(std::move(name));
    return names;
}

} // namespace support
