// The system tells by SIGBUS that a page of a mapped file cannot be read. The handler looks the place up and puts a
// page of zeros there. It takes no lock: pieces come and go in the archive's thread alone, readers fail in any.
#include "session/archive/mapped_pieces.h"

#include <array>
#include <csignal>
#include <cstdint>
#include <sys/mman.h>
#include <unistd.h>

namespace session {

namespace {

struct Entry {
    std::atomic<std::uintptr_t> begin{0}; ///< 0: free
    std::atomic<std::size_t> size{0};
    std::atomic<std::atomic<bool> *> failed{nullptr};
};
/// As many as fill the largest archive: 16 GB in pieces of 16 MB, and as many again for copies that outlive theirs.
std::array<Entry, 2048> entries;
struct sigaction actionBefore;
std::uintptr_t pageSize = 0;

void onBusError(int number, siginfo_t *info, void *context)
{
    const auto place = reinterpret_cast<std::uintptr_t>(info->si_addr);
    for (Entry &entry : entries) {
        const std::uintptr_t begin = entry.begin.load();
        if (begin == 0 || place < begin || place >= begin + entry.size.load())
            continue;
        void *page =
            reinterpret_cast<void *>(place & ~(pageSize - 1)); // NOLINT(performance-no-int-to-ptr)
        if (::mmap(page, pageSize, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0)
            == MAP_FAILED)
            break;
        entry.failed.load()->store(true);
        return;
    }
    // Not ours: as if there were no handler here.
    if ((actionBefore.sa_flags & SA_SIGINFO) != 0)
        return actionBefore.sa_sigaction(number, info, context);
    if (actionBefore.sa_handler != SIG_DFL && actionBefore.sa_handler != SIG_IGN)
        return actionBefore.sa_handler(number);
    ::sigaction(number, &actionBefore, nullptr);
    ::raise(number);
}

/// Behind the handler of crashes: it is asked if the place is not ours.
bool install()
{
    pageSize = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    struct sigaction action { };
    action.sa_sigaction = onBusError;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    return ::sigaction(SIGBUS, &action, &actionBefore) == 0;
}

} // namespace

bool guardPiece(const std::byte *bytes, std::size_t size, std::atomic<bool> &failed)
{
    static const bool installed = install();
    for (Entry &entry : entries) {
        if (!installed || entry.begin.load() != 0)
            continue;
        entry.size.store(size);
        entry.failed.store(&failed);
        entry.begin.store(reinterpret_cast<std::uintptr_t>(bytes));
        return true;
    }
    return false;
}

void unguardPiece(const std::byte *bytes)
{
    for (Entry &entry : entries)
        if (entry.begin.load() == reinterpret_cast<std::uintptr_t>(bytes))
            entry.begin.store(0);
}

} // namespace session
