// AutoDrive through any script of acts, faults and time, and boards of each serial protocol: drive_script.h has the rules.
#include "drive/make_drive.h"
#include "fuzz/legacy_peer.h"
#include "fuzz/mcp_peer.h"

namespace {

/// It changes the language: a header of ASPEP is told from a frame of the older protocol by its CRC and length alone, as a
/// board would tell them.
class EitherEffect {
public:
    fuzz::Effect operator()(ByteView output)
    {
        const bool header = output.size() == aspep::kHeaderSize
            && aspep::decodeHeader({output[0], output[1], output[2], output[3]}).has_value();
        if (m_payloadNext || header) {
            m_payloadNext = header && !m_payloadNext && (output[0] & 0x0FU) == 9;
            return m_newer(output);
        }
        return fuzz::legacyEffect(output);
    }

private:
    fuzz::McpEffects m_newer;
    bool m_payloadNext = false;
};

} // namespace

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
            return std::make_unique<fuzz::LegacyPeer>(
                which == 1 ? legacy::Dialect::PowerPc : legacy::Dialect::Stm32, motors);
        },
        .effects = [] { return EitherEffect(); },
        .baud = 115200,
    };
    fuzz::playDrive(target, {data, size});
    return 0;
}
