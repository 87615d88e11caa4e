// Any bytes as requests, responses and structures of MCP: values or one error, and what was read can be written again.
#include "fuzz/script.h"
#include "mcp/request.h"
#include "mcp/response.h"
#include "mcp/structure_fields.h"

namespace {

constexpr std::size_t kRoom = 8191;

void readRequest(ByteView bytes)
{
    const auto request = mcp::decodeRequest(bytes);
    if (!request)
        return;
    if (const auto ids = mcp::decodeGetList(request->content); ids && !ids->empty())
        fuzz::require(mcp::encodeGet(*ids, kRoom).has_value());
    const mcp::SetList list = mcp::decodeSetList(request->content);
    if (!list.error && !list.writes.empty()) {
        const auto again = mcp::encodeSet(list.writes, kRoom);
        fuzz::require(again && again->size() == bytes.size());
    }
}

void readResponse(ByteView bytes)
{
    // The first half names the registers, the second answers.
    const auto ids = mcp::decodeGetList(bytes.first(bytes.size() / 4 * 2));
    const ByteView answer = bytes.subspan(bytes.size() / 4 * 2);
    const auto response = mcp::decodeResponse(answer);
    if (!response)
        return;
    if (const auto values = mcp::decodeGetAnswer(*ids, *response))
        fuzz::require(values->values.size() <= ids->size());
    if (const auto statuses = mcp::decodeSetAnswer(ids->size(), *response))
        fuzz::require(statuses->registers.size() <= ids->size());
    (void)mcp::versionOf(*response);
    (void)mcp::statusOf(*response);
}

void readStructure(ByteView bytes)
{
    if (bytes.empty())
        return;
    for (unsigned element = 0; element < 40; ++element)
        (void)mcp::fieldsOf(mcp::registerId(element, mcp::RegisterType::Raw, 1), bytes.subspan(1));
    for (int type = 0; type <= int(catalog::ValueType::Raw); ++type) {
        ByteReader reader(bytes.subspan(1));
        const auto value = mcp::decodeValue({bytes[0]}, reader);
        if (value)
            (void)mcp::interpret(*value, static_cast<catalog::ValueType>(type));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const ByteView bytes(data, std::min<std::size_t>(size, 2048));
    readRequest(bytes);
    readResponse(bytes);
    readStructure(bytes);
    return 0;
}
