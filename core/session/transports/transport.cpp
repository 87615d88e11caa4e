// Which transport an endpoint needs.
#include "session/transports/recording_transport.h"
#include "session/transports/serial_transport.h"
#include "session/transports/simulator_transport.h"
#include "session/transports/spi_transport.h"
#include "session/transports/trace_transport.h"
#include "simulation/simulated_board.h"

namespace session {

std::unique_ptr<Transport> makeTransport(const Endpoint &endpoint)
{
    switch (endpoint.kind) {
    case Endpoint::Kind::Simulator: {
        simulation::BoardOptions options;
        if (!endpoint.board.empty())
            options.profile = endpoint.board;
        options.motors = endpoint.boardMotors;
        options.baud = endpoint.baud;
        return std::make_unique<SimulatorTransport>(
            [options] { return simulation::makeBoard(options); });
    }
    case Endpoint::Kind::Serial:
        if (isSpiPath(endpoint.path))
            return makeSpiTransport(endpoint.path, endpoint.baud);
        return std::make_unique<SerialTransport>(endpoint.path, endpoint.baud);
    case Endpoint::Kind::Trace:
        if (isRecordingFile(endpoint.path))
            return std::make_unique<RecordingTransport>(endpoint.path);
        return std::make_unique<TraceTransport>(endpoint.path);
    }
    return nullptr;
}

} // namespace session
