// McbDrive through any script of acts, faults and time: drive_script.h has the rules.
#include "drive/protocol_table.h"
#include "fuzz/mcb_peer.h"
#include "support/wire/mcb.h"

using namespace std::chrono_literals;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const fuzz::Target target{
        .drive = [] { return drive::makeMcbDrive({}); },
        .peer = [](unsigned which, int) -> std::unique_ptr<fuzz::Peer> {
            if (which == 3)
                return std::make_unique<fuzz::NobodyThere>();
            return std::make_unique<fuzz::McbPeer>();
        },
        .decoder = [] { return std::make_unique<judge::WireMcb>(); },
        .line = {.firstStop = 150ms,
            .repeat = 250ms,
            .suspect = {},
            .lost = {},
            .startParts = 2,
            .referenceParts = 2},
        .baud = 10'000'000,
        .exchanges = true,
    };
    fuzz::playDrive(target, {data, size});
    return 0;
}
