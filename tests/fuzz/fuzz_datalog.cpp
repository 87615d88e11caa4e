// Any configuration and any packets into the datalog decoder: samples only where the length fits, and never too many.
#include "fuzz/script.h"
#include "mcp/datalog_decoder.h"

namespace {

/// A piece of the input with its length in two bytes before it.
ByteView piece(ByteReader &reader)
{
    const std::size_t length = reader.u16();
    return reader.take(std::min(length, reader.left()));
}

void check(const mcp::DatalogConfig &config, const capture::SampleBlock &block, std::size_t length)
{
    fuzz::require(block.fast.size() == config.fast.size() * block.count);
    fuzz::require(2 * block.fast.size() <= length);
    fuzz::require(block.lostTicks >= 0);
    for (const capture::SlowGroup &group : block.slow)
        fuzz::require(group.values.size() == config.slow.size() && group.tick >= block.firstTick);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    ByteReader reader(ByteView(data, size));
    const auto config = mcp::decodeDatalog(piece(reader));
    if (!config)
        return 0;
    for (const std::size_t room : {64U, 2048U, 8128U}) {
        const auto buffer = mcp::chooseBufferSize(*config, {room, 16000.0, 1843200});
        fuzz::require(!buffer || *buffer <= room);
    }
    mcp::DatalogDecoder decoder(16000.0);
    decoder.expect(1, *config);
    while (reader.left() > 0) {
        const ByteView payload = piece(reader);
        if (const auto block = decoder.decode(payload))
            check(*config, *block, payload.size());
    }
    return 0;
}
