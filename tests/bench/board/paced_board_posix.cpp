// A simulated board behind a pseudo-terminal, in a process of its own so that its time is not counted as ours: it
// writes all that its line carries in real time and waits for room where the reader is slow. Prints the path of the
// terminal and ends with standard input.
#include "simulation/simulated_board.h"
#include "support/pseudo_terminal.h"

#include <chrono>
#include <cstdio>

namespace {

TimePoint now()
{
    return TimePoint(
        std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

void serve(simulation::SimulatedBoard &board, support::PseudoTerminal &terminal)
{
    const auto origin = now() - TimePoint{};
    Bytes waiting;
    for (;;) {
        const short wanted = waiting.empty() ? POLLIN : POLLIN | POLLOUT;
        pollfd sources[] = {{terminal.master(), wanted, 0}, {STDIN_FILENO, POLLIN, 0}};
        ::poll(sources, 2, 1);
        if (sources[1].revents != 0)
            return; // nothing is to be read: it was closed
        const TimePoint at = now() - origin;
        if (const Bytes in = terminal.read(); !in.empty())
            board.receive(in, at);
        board.advance(at);
        const Bytes out = board.takeOutput();
        waiting.insert(waiting.end(), out.begin(), out.end());
        const auto sent = ::write(terminal.master(), waiting.data(), waiting.size());
        if (sent > 0)
            waiting.erase(waiting.begin(), waiting.begin() + sent);
    }
}

} // namespace

int main(int argc, char **argv)
{
    simulation::BoardOptions options;
    if (argc == 3) {
        options.baud = QByteArray(argv[1]).toUInt();
        options.hfHz = QByteArray(argv[2]).toUInt();
    }
    const auto board = simulation::makeBoard(options);
    if (!board || argc != 3)
        return 2;
    support::PseudoTerminal terminal;
    std::puts(qPrintable(terminal.path()));
    std::fflush(stdout);
    serve(*board, terminal);
    return 0;
}
