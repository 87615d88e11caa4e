#include "session/transports/endpoint.h"

#include "drive/protocol_table.h"
#include "session/transports/port_list.h"

#include <algorithm>
#include <string_view>

namespace session {

namespace {

constexpr QLatin1Char kOf(':'); ///< between the simulated board and what it speaks
constexpr char kSpiDevice[] = "/dev/spidev";

/// Whose simulated board has this name; nullptr: none of them.
const drive::ProtocolRow *rowOfBoard(std::string_view name)
{
    for (const drive::ProtocolRow &row : drive::protocolTable())
        if (std::ranges::find(row.boards, name) != row.boards.end())
            return &row;
    return nullptr;
}

} // namespace

Endpoint endpointFor(const QString &path, std::uint32_t baud, drive::Protocol protocol)
{
    Endpoint endpoint;
    endpoint.path = path;
    endpoint.baud = baud;
    endpoint.protocol = protocol;
    endpoint.kind = Endpoint::Kind::Serial;
    const QString simulator = QString::fromLatin1(kSimulatorPath);
    if (path == simulator) {
        endpoint.kind = Endpoint::Kind::Simulator;
    } else if (path.startsWith(simulator + kOf)) {
        const std::string name = path.section(kOf, 1).toStdString();
        const auto spoken = drive::protocolOf(name);
        if (const drive::ProtocolRow *row = rowOfBoard(name); row && row->choice.serial) {
            endpoint.kind = Endpoint::Kind::Simulator;
            endpoint.board = name; // what it speaks may be found out
            endpoint.baud = row->baud;
        } else if (spoken && *spoken != drive::Protocol::Auto) {
            endpoint.kind = Endpoint::Kind::Simulator;
            endpoint.protocol = *spoken;
        }
    } else if (isSpiPath(path)) { // whatever was chosen for serial ports
        for (const drive::ProtocolRow &row : drive::protocolTable())
            if (!row.choice.serial)
                endpoint.protocol = row.choice.protocol; // nothing else is spoken there
    }
    if (const auto &row = drive::rowOf(endpoint.protocol); !row.choice.serial)
        endpoint.board = row.boards.front(); // no other has its line
    return endpoint;
}

bool isSpiPath(const QString &path) { return path.startsWith(QLatin1String(kSpiDevice)); }

} // namespace session
