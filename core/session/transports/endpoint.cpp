#include "session/transports/endpoint.h"

#include "drive/protocol_table.h"
#include "session/transports/port_list.h"
#include "simulation/legacy/legacy_motor_board.h"

namespace session {

namespace {

constexpr QLatin1Char kOf(':'); ///< between the simulated board and what it speaks
constexpr char kSpiDevice[] = "/dev/spidev";

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
        if (simulation::isLegacyProfile(name)) {
            endpoint.kind = Endpoint::Kind::Simulator;
            endpoint.board.profile = name; // what it speaks may be found out
            endpoint.baud = drive::rowOf(drive::Protocol::Legacy).baud;
        } else if (spoken && *spoken != drive::Protocol::Auto) {
            endpoint.kind = Endpoint::Kind::Simulator;
            endpoint.protocol = *spoken;
        }
    } else if (isSpiPath(path) && protocol == drive::Protocol::Auto) {
        for (const drive::ProtocolRow &row : drive::protocolTable())
            if (!row.choice.serial)
                endpoint.protocol = row.choice.protocol; // nothing else is spoken there
    }
    if (const auto &row = drive::rowOf(endpoint.protocol); !row.choice.serial)
        endpoint.board.profile = row.board; // no other has its line
    endpoint.board.baud = endpoint.baud;
    return endpoint;
}

bool isSpiPath(const QString &path) { return path.startsWith(QLatin1String(kSpiDevice)); }

} // namespace session
