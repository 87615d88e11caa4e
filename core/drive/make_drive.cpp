#include "drive/make_drive.h"

#include "drive/mcp_drive.h"

namespace drive {

std::unique_ptr<Drive> makeDrive(std::uint32_t baud, Duration patience)
{
    McpDriveConfig config;
    config.baud = baud;
    config.patience = patience;
    return makeMcpDrive(config);
}

} // namespace drive
