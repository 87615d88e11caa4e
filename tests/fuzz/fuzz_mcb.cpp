// Any bytes as frames and values of MCB, and as the stream into a slave: values or one error, what was read can be
// written again, and as many bytes come back as went in.
#include "fuzz/script.h"
#include "mcb/error_code.h"
#include "mcb/fragments.h"
#include "simulation/mcb/slave.h"

namespace {

void readFrame(ByteView bytes)
{
    const auto frame = mcb::decodeFrame(bytes);
    fuzz::require(frame || !mcb::decodeAnswer(bytes));
    if (!frame)
        return;
    const Bytes again = mcb::encodeFrame(*frame);
    fuzz::require(std::equal(again.begin(), again.end(), bytes.begin(), bytes.end()));
    (void)mcb::errorCodeOf(frame->config);
}

void readValue(ByteView bytes)
{
    mcb::Words words;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        words.push_back(static_cast<std::uint16_t>(bytes[i] << 8 | bytes[i + 1]));
    words.resize(std::max(words.size(), mcb::kConfigWords));
    const mcb::Info info = mcb::infoOf({words[0], words[1], 0, 0});
    if (info.type && info.access != catalog::Access::None)
        fuzz::require(mcb::infoOf(mcb::configOf(info)) == info);
    const auto value = mcb::decodeValue(info, mcb::WordView(words).subspan(2));
    if (!value)
        return;
    const auto again = mcb::encodeValue(info, *value);
    const bool notFinite = info.type == mcb::Type::Float;
    fuzz::require(again ? again->size() == mcb::wordsOf(info.size) : notFinite);
}

simulation::McbRig rig()
{
    using catalog::Access;
    using mcb::Cyclic;
    using mcb::Type;
    simulation::McbRig made;
    made.registers = {{0x010, {{2, Type::UInt16, Cyclic::Rx, Access::ReadWrite}, {0}}},
        {0x011, {{2, Type::UInt16, Cyclic::Tx, Access::Read}, {0x1637}}},
        {0x01A, {{4, Type::Float, Cyclic::Rx, Access::ReadWrite}, {0, 0}}},
        {0x060, {{4, Type::Float, Cyclic::Tx, Access::Read}, {0, 0x41C0}}},
        {0x6DB, {{4, Type::UInt32, Cyclic::ConfigOnly, Access::Write}, {0, 0}}},
        {0x6E4, {{16, Type::Text, Cyclic::ConfigOnly, Access::Read}, {0x302E, 0x312E}}},
        {0x6F0, {{15, Type::Text, Cyclic::ConfigOnly, Access::ReadWrite}, {}}}};
    return made;
}

/// A stream as the script plays it.
struct Played {
    simulation::McbStream stream{rig()};
    std::size_t in = 0, out = 0;

    void receive(ByteView bytes, TimePoint now)
    {
        in += bytes.size();
        stream.receive(bytes, now);
    }
    void handleTimeout(TimePoint now) { stream.advance(now); }
    std::optional<TimePoint> nextTimeout() const
    {
        const TimePoint wake = stream.nextWake();
        return wake == TimePoint::max() ? std::nullopt : std::optional(wake);
    }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const ByteView bytes(data, std::min<std::size_t>(size, 4096));
    readFrame(bytes);
    readValue(bytes);
    Played played;
    fuzz::play(bytes, played, [&played](TimePoint) {
        played.out += played.stream.takeOutput().size();
        fuzz::require(played.out <= played.in);
        fuzz::require(played.stream.slave().frameBytes() <= mcb::kMostFrameBytes);
    });
    return 0;
}
