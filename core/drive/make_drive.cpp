#include "drive/make_drive.h"

#include "drive/mcp_drive.h"

namespace drive {

std::unique_ptr<Drive> makeDrive(const LineOptions &options)
{
    McpDriveConfig config;
    config.baud = options.baud;
    config.patience = options.patience;
    return makeMcpDrive(config);
}

} // namespace drive
