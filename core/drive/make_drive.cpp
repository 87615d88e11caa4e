#include "drive/make_drive.h"

#include "drive/mcb_drive.h"
#include "drive/mcp_drive.h"

namespace drive {

std::unique_ptr<Drive> makeDrive(const LineOptions &options)
{
    if (options.protocol == Protocol::Mcb) {
        McbDriveConfig config;
        config.patience = options.patience;
        return makeMcbDrive(config);
    }
    McpDriveConfig config;
    config.baud = options.baud;
    config.patience = options.patience;
    return makeMcpDrive(config);
}

} // namespace drive
