// Any bytes on the line of the older serial protocol, for both its ends: frames or one error, and what was read can be
// written again. A static board takes the same bytes as a script of pieces and time.
#include "fcp/framer.h"
#include "fcp/register_table.h"
#include "fcp/reply.h"
#include "fcp/request.h"
#include "fuzz/script.h"
#include "simulation/fcp/board.h"

namespace {

void readRequest(const fcp::Frame &frame)
{
    const auto request = fcp::decodeRequest(frame);
    if (!request)
        return;
    const auto bytes = fcp::encodeRequest(*request);
    fuzz::require(bytes && *bytes == fcp::encodeFrame(frame.header, frame.payload));
}

void readData(ByteView data)
{
    (void)fcp::decodeBoardInfo(data);
    (void)fcp::decodeFirmwareVersion(data);
    if (const auto stage = fcp::decodeRevUp(data))
        fuzz::require(fcp::encodeRevUp(*stage) == Bytes(data.begin(), data.end()));
    if (data.empty())
        return;
    (void)fcp::decodeExecuteAck(data.front(), data.subspan(1));
    for (const auto dialect : {fcp::Dialect::Stm32, fcp::Dialect::PowerPc}) {
        const auto *which = fcp::findRegister(dialect, data.front());
        if (which != nullptr && fcp::decodeValue(*which, data.subspan(1)))
            fuzz::require(data.size() <= 5);
    }
}

void readReply(const fcp::Frame &frame)
{
    const auto reply = fcp::decodeReply(frame);
    if (!reply)
        return;
    if (const auto *ack = std::get_if<fcp::Ack>(&*reply)) {
        fuzz::require(fcp::encodeAck(ack->data) == fcp::encodeFrame(frame.header, frame.payload));
        readData(ack->data);
    }
}

void readStream(fcp::Framer::Side side, ByteView bytes)
{
    fcp::Framer framer(side);
    fcp::Frame frame;
    while (!bytes.empty()) {
        const std::size_t before = bytes.size();
        const auto step = framer.next(bytes, frame);
        fuzz::require(bytes.size() < before && frame.payload.size() <= fcp::kMaxPayload);
        if (step != fcp::Framer::Step::Frame)
            continue;
        if (side == fcp::Framer::Side::Board)
            readRequest(frame);
        else
            readReply(frame);
    }
}

/// A board as a machine of the script: its output is what it answers.
struct Machine {
    explicit Machine(fcp::Dialect dialect)
        : board(rigOf(dialect))
    {
    }
    static simulation::FcpRig rigOf(fcp::Dialect dialect)
    {
        simulation::FcpRig rig;
        rig.dialect = dialect;
        rig.motors.resize(2);
        rig.motors.front().revUp.resize(fcp::kRevUpStages);
        rig.fluxWeakening = rig.feedForward = rig.pfc = rig.profiler = rig.dac = true;
        rig.frameTimer = std::chrono::milliseconds(25);
        return rig;
    }
    void receive(ByteView bytes, TimePoint now) { board.receive(bytes, now); }
    void handleTimeout(TimePoint now) { board.advance(now); }
    std::optional<TimePoint> nextTimeout() const { return board.nextWake(); }

    simulation::FcpBoard board;
};

/// Whatever a board says, a client can read.
void playBoard(fcp::Dialect dialect, ByteView script)
{
    Machine machine(dialect);
    fcp::Framer framer(fcp::Framer::Side::Client);
    fcp::Frame frame;
    fuzz::play(
        script, machine,
        [&](TimePoint) {
            const Bytes output = machine.board.takeOutput();
            ByteView bytes(output);
            while (!bytes.empty()) {
                const auto step = framer.next(bytes, frame);
                fuzz::require(
                    step == fcp::Framer::Step::Frame || step == fcp::Framer::Step::NeedBytes);
                if (step == fcp::Framer::Step::Frame)
                    fuzz::require(fcp::decodeReply(frame).has_value());
            }
        },
        std::chrono::milliseconds(2));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const ByteView bytes(data, std::min<std::size_t>(size, 1024));
    readStream(fcp::Framer::Side::Board, bytes);
    readStream(fcp::Framer::Side::Client, bytes);
    playBoard(fcp::Dialect::Stm32, bytes);
    playBoard(fcp::Dialect::PowerPc, bytes);
    return 0;
}
