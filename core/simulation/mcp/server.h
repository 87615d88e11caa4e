// The commands of MCP as ST's firmware executes them: one request in, one response payload out.
// Source: mcp-aspep facts 4; the recorded sessions.
#pragma once

#include "mcp/protocol.h"
#include "simulation/axis.h"
#include "simulation/mcp/datalog_recorder.h"
#include "simulation/mcp/profile.h"
#include "simulation/mcp/register_file.h"

#include <utility>

namespace simulation {

struct BoardOptions;

class Server {
public:
    Server(const Traits &traits, const BoardOptions &options, const Build &build, const Axes &axes,
        RegisterFile &registers, DatalogRecorder &datalog);

    /// @param buffer       the whole receive buffer, old bytes included
    /// @param length       of the request; 0 where an empty one is executed all the same
    /// @param responseMax  negotiated, status byte included
    /// @return the response's payload; empty if the board restarts instead (resetWanted())
    Bytes execute(ByteView buffer, std::uint16_t length, std::size_t responseMax);
    bool takeResetWanted() { return std::exchange(m_resetWanted, false); }

private:
    struct Request {
        std::uint16_t command = 0;
        unsigned motor = 0;
        StaleBytes data;
        std::uint16_t length = 0; ///< wraps to 65534 for an empty request
        int room = 0;
    };
    mcp::Status dispatch(const Request &request);
    mcp::Status get(const Request &request);
    mcp::Status set(const Request &request);
    mcp::Status motorCommand(const Request &request, Firmware &firmware);
    mcp::Status command(const Request &request);
    bool start(unsigned motor);
    mcp::Status clearCpuLoad();
    mcp::Status profilerCommand(const Request &request) const;
    mcp::Status switchSensor(const Request &request, const Firmware &firmware) const;
    mcp::Status userCommand(const Request &request);
    mcp::Status heartbeat(const Request &request);

    const Traits &m_traits;
    const BoardOptions &m_options;
    const Build &m_build;
    const Axes &m_axes;
    RegisterFile &m_registers;
    DatalogRecorder &m_datalog;
    Bytes m_answer; ///< of the command in hand, without the status
    Bytes m_buffer; ///< the response buffer; old bytes stay in it
    bool m_resetWanted = false;
};

} // namespace simulation
