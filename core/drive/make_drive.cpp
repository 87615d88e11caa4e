#include "drive/make_drive.h"

#include "drive/mcp_drive.h"

namespace drive {

std::unique_ptr<Drive> makeDrive(std::uint32_t baud)
{
    McpDriveConfig config;
    config.baud = baud;
    return makeMcpDrive(config);
}

} // namespace drive
