// McpDrive through any script of acts, faults and time: drive_script.h has the rules.
#include "drive/protocol_table.h"
#include "fuzz/mcp_peer.h"
#include "support/wire/mcp.h"

using namespace std::chrono_literals;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const fuzz::Target target{
        .drive = [] { return drive::makeMcpDrive({}); },
        .peer = [](unsigned which, int motors) -> std::unique_ptr<fuzz::Peer> {
            if (which == 3)
                return std::make_unique<fuzz::NobodyThere>();
            return std::make_unique<fuzz::McpPeer>(motors);
        },
        .decoder = [] { return std::make_unique<judge::WireMcp>(1843200, 0.0); },
        .line = {.firstStop = 110ms, .repeat = 210ms, .gap = 500us, .answerWithin = 10s},
    };
    fuzz::playDrive(target, {data, size});
    return 0;
}
