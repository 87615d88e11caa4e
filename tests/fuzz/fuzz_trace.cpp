// Any recorded packets into the trace decoder.
#include "fuzz/script.h"
#include "mcp/trace_decoder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    mcp::TraceDecoder decoder({});
    ByteReader reader(ByteView(data, size));
    while (reader.left() > 0) {
        const std::uint16_t head = reader.u16(); // direction in the two highest bits, length below
        const auto direction = static_cast<mcp::TraceDirection>((head >> 14) % 3);
        const ByteView bytes = reader.take(std::min<std::size_t>(head & 0x3FFFU, reader.left()));
        const mcp::TraceItem item = decoder.next(direction, bytes);
        if (const auto *async = std::get_if<mcp::TraceAsync>(&item))
            fuzz::require(async->fastBlocks * async->fastSamples.size() <= bytes.size());
    }
    return 0;
}
