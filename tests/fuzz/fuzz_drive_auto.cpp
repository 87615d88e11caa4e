// AutoDrive through any script of acts, faults and time, and boards of each serial protocol: drive_script.h has the
// rules.
#include "drive/protocol_table.h"
#include "fuzz/fcp_peer.h"
#include "fuzz/mcp_peer.h"
#include "support/wire/either.h"

using namespace std::chrono_literals;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const fuzz::Target target{
        .drive =
            [] { return drive::makeDrive({.protocol = drive::Protocol::Auto, .baud = 115200}); },
        .peer = [](unsigned which, int motors) -> std::unique_ptr<fuzz::Peer> {
            if (which == 0)
                return std::make_unique<fuzz::McpPeer>(motors);
            if (which == 3)
                return std::make_unique<fuzz::NobodyThere>();
            return std::make_unique<fuzz::FcpPeer>(
                which == 1 ? fcp::Dialect::PowerPc : fcp::Dialect::Stm32, motors);
        },
        .decoder = [] { return std::make_unique<judge::WireEither>(); },
        .line = {.baud = 115200, .firstStop = 400ms, .repeat = 500ms, .suspect = 1s, .lost = 6s},
        .baud = 115200,
    };
    fuzz::playDrive(target, {data, size});
    return 0;
}
