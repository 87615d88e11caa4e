// Any bytes at any time into a simulated board, and well-formed packets with any payload into a connected one: it never
// gives more than its line can carry.
#include "aspep/packet.h"
#include "fuzz/script.h"
#include "simulation/simulated_board.h"

namespace {

/// The board in the shape of the other machines. It has something to do every few microseconds, so time passes in steps
/// of a millisecond.
struct Board {
    std::unique_ptr<simulation::SimulatedBoard> board;
    TimePoint now{};

    /// A piece that begins with an even byte goes to the board as it is, any other as a packet with the rest as
    /// payload.
    void receive(ByteView piece, TimePoint at)
    {
        if (piece.empty() || piece[0] % 2 == 0) {
            board->receive(piece, at);
            return;
        }
        const ByteView payload = piece.subspan(1);
        send(aspep::Data{false, static_cast<std::uint16_t>(payload.size())}, at);
        board->receive(payload, now);
        handleTimeout(now + std::chrono::milliseconds(3));
    }
    /// The header, and time to act upon it.
    void send(const aspep::Header &header, TimePoint at)
    {
        board->receive(aspep::encodeHeader(header), std::max(at, now));
        handleTimeout(std::max(at, now) + std::chrono::milliseconds(3));
    }
    void handleTimeout(TimePoint at)
    {
        now = std::max(now, at);
        board->advance(now);
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
    options.profile = profiles[(data[0] & 0x07U) % profiles.size()];
    options.motors = data[0] & 0x08 ? 2 : 1;
    if (data[0] & 0x10) {
        for (const simulation::BuildOption &option : simulation::buildOptions())
            options.with.push_back(&option);
    }
    options.nullCheck = data[0] & 0x40;
    options.userCallbacks = data[0] & 0x80 ? 2 : 0;
    Board machine{simulation::makeBoard(options)};
    const aspep::Beacon sizes{.dataCrc = false, .rxUnits = 7, .txSyncUnits = 7, .txAsyncUnits = 32};
    machine.send(sizes, {});
    machine.send(aspep::Ping{}, {});
    std::size_t given = 0;
    const auto drain = [&](TimePoint) {
        given += machine.board->takeOutput().size();
        fuzz::require(static_cast<double>(given)
            <= toSeconds(machine.now - TimePoint{}) * options.baud / 10.0 + 1.0);
    };
    fuzz::play({data + 1, size - 1}, machine, drain, std::chrono::milliseconds(1));
    return 0;
}
