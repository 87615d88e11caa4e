// Any bytes on the line of the older serial protocol, for both its ends: frames or one error, and what was read can be
// written again. A static board takes the same bytes as a script of pieces and time.
#include "fuzz/script.h"
#include "legacy/framer.h"
#include "legacy/register_table.h"
#include "legacy/reply.h"
#include "legacy/request.h"
#include "simulation/legacy/legacy_board.h"

namespace {

void readRequest(const legacy::Frame &frame)
{
    const auto request = legacy::decodeRequest(frame);
    if (!request)
        return;
    const auto bytes = legacy::encodeRequest(*request);
    fuzz::require(bytes && *bytes == legacy::encodeFrame(frame.header, frame.payload));
}

void readData(ByteView data)
{
    (void)legacy::decodeBoardInfo(data);
    (void)legacy::decodeFirmwareVersion(data);
    if (const auto stage = legacy::decodeRevUp(data))
        fuzz::require(legacy::encodeRevUp(*stage) == Bytes(data.begin(), data.end()));
    if (data.empty())
        return;
    (void)legacy::decodeExecuteAck(data.front(), data.subspan(1));
    for (const auto dialect : {legacy::Dialect::Stm32, legacy::Dialect::PowerPc}) {
        const auto *which = legacy::findRegister(dialect, data.front());
        if (which != nullptr && legacy::decodeValue(*which, data.subspan(1)))
            fuzz::require(data.size() <= 5);
    }
}

void readReply(const legacy::Frame &frame)
{
    const auto reply = legacy::decodeReply(frame);
    if (!reply)
        return;
    if (const auto *ack = std::get_if<legacy::Ack>(&*reply)) {
        fuzz::require(
            legacy::encodeAck(ack->data) == legacy::encodeFrame(frame.header, frame.payload));
        readData(ack->data);
    }
}

void readStream(legacy::Framer::Side side, ByteView bytes)
{
    legacy::Framer framer(side);
    legacy::Frame frame;
    while (!bytes.empty()) {
        const std::size_t before = bytes.size();
        const auto step = framer.next(bytes, frame);
        fuzz::require(bytes.size() < before && frame.payload.size() <= legacy::kMaxPayload);
        if (step != legacy::Framer::Step::Frame)
            continue;
        if (side == legacy::Framer::Side::Board)
            readRequest(frame);
        else
            readReply(frame);
    }
}

/// A board as a machine of the script: its output is what it answers.
struct Machine {
    explicit Machine(legacy::Dialect dialect)
        : board(rigOf(dialect))
    {
    }
    static simulation::LegacyRig rigOf(legacy::Dialect dialect)
    {
        simulation::LegacyRig rig;
        rig.dialect = dialect;
        rig.motors.resize(2);
        rig.motors.front().revUp.resize(legacy::kRevUpStages);
        rig.fluxWeakening = rig.feedForward = rig.pfc = rig.profiler = rig.dac = true;
        rig.frameTimer = std::chrono::milliseconds(25);
        return rig;
    }
    void receive(ByteView bytes, TimePoint now) { board.receive(bytes, now); }
    void handleTimeout(TimePoint now) { board.advance(now); }
    std::optional<TimePoint> nextTimeout() const { return board.nextWake(); }

    simulation::LegacyBoard board;
};

/// Whatever a board says, a client can read.
void playBoard(legacy::Dialect dialect, ByteView script)
{
    Machine machine(dialect);
    legacy::Framer framer(legacy::Framer::Side::Client);
    legacy::Frame frame;
    fuzz::play(
        script, machine,
        [&](TimePoint) {
            const Bytes output = machine.board.takeOutput();
            ByteView bytes(output);
            while (!bytes.empty()) {
                const auto step = framer.next(bytes, frame);
                fuzz::require(
                    step == legacy::Framer::Step::Frame || step == legacy::Framer::Step::NeedBytes);
                if (step == legacy::Framer::Step::Frame)
                    fuzz::require(legacy::decodeReply(frame).has_value());
            }
        },
        std::chrono::milliseconds(2));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const ByteView bytes(data, std::min<std::size_t>(size, 1024));
    readStream(legacy::Framer::Side::Board, bytes);
    readStream(legacy::Framer::Side::Client, bytes);
    playBoard(legacy::Dialect::Stm32, bytes);
    playBoard(legacy::Dialect::PowerPc, bytes);
    return 0;
}
