#include "drive/mcp/mcp_protocol.h"

#include "base/overloaded.h"

namespace drive {

Result<Bytes, mcp::CodecError> encode(const McpRequest &request, std::size_t room)
{
    return std::visit(Overloaded{
                          [&](const McpGet &get) { return mcp::encodeGet(get.registers, room); },
                          [&](const McpSet &set) { return mcp::encodeSet(set.writes, room); },
                          [](const McpAct &act) {
                              return mcp::encodeCommand(
                                  act.command, static_cast<unsigned>(act.motor), act.content);
                          },
                      },
        request);
}

} // namespace drive
