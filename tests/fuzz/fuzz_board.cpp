// Any bytes at any time into a simulated board: it never gives more than its line can carry.
#include "fuzz/script.h"
#include "simulation/simulated_board.h"

namespace {

/// The board in the shape of the other machines. It has something to do every few microseconds, so time passes in
/// steps of a millisecond.
struct Board {
    std::unique_ptr<simulation::SimulatedBoard> board;
    TimePoint now{};

    void receive(ByteView bytes, TimePoint at) { board->receive(bytes, at); }
    void handleTimeout(TimePoint at)
    {
        now = at;
        board->advance(at);
    }
    std::optional<TimePoint> nextTimeout() const { return now + std::chrono::milliseconds(1); }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    simulation::BoardOptions options;
    const auto profiles = simulation::profileNames();
    options.profile = profiles[data[0] % profiles.size()];
    Board machine{simulation::makeBoard(options), {}};
    std::size_t given = 0;
    // A second of line time for a few bytes is slow: longer scripts say nothing new.
    const ByteView script(data + 1, std::min<std::size_t>(size - 1, 256));
    fuzz::play(script, machine, [&](TimePoint now) {
        given += machine.board->takeOutput().size();
        const auto seconds = std::chrono::duration<double>(now.time_since_epoch()).count();
        fuzz::require(static_cast<double>(given) <= seconds * options.baud / 10.0 + 1.0);
    });
    return 0;
}
