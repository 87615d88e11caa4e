#include "drive/make_drive.h"

#include "drive/auto_drive.h"
#include "drive/legacy/legacy_drive.h"
#include "drive/mcb/mcb_drive.h"
#include "drive/mcp/mcp_drive.h"

#include <utility>

namespace drive {

namespace {

std::unique_ptr<Drive> newer(const LineOptions &options, bool hasty = false)
{
    if (options.protocol == Protocol::Mcb) {
        McbDriveConfig config;
        config.patience = options.patience;
        return makeMcbDrive(config);
    }
    McpDriveConfig config;
    config.baud = options.baud;
    config.patience = options.patience;
    config.hasty = hasty;
    return makeMcpDrive(config);
}

std::unique_ptr<Drive> older(const LineOptions &options, std::optional<legacy::Dialect> dialect)
{
    LegacyDriveConfig config;
    config.baud = options.baud;
    config.patience = options.patience;
    config.dialect = dialect;
    return makeLegacyDrive(config);
}

} // namespace

std::unique_ptr<Drive> makeDrive(const LineOptions &options)
{
    switch (options.protocol) {
    case Protocol::Legacy:
        return older(options, legacy::Dialect::Stm32);
    case Protocol::PowerPc:
        return older(options, legacy::Dialect::PowerPc);
    case Protocol::Auto: {
        std::vector<Candidate> candidates{
            {[options](bool hasty) { return newer(options, hasty); }, LinkReason::AskingNewer,
                "it answered a BEACON", Protocol::Mcp},
            {[options](bool) { return older(options, std::nullopt); }, LinkReason::AskingOlder, {},
                Protocol::Legacy}};
        if (options.spoken == Protocol::Legacy)
            std::swap(candidates.front(), candidates.back());
        return makeAutoDrive(std::move(candidates));
    }
    case Protocol::Mcp:
    case Protocol::Mcb:
        break;
    }
    return newer(options);
}

} // namespace drive
