// The registers of the simulated board: which motor an identifier means, what a read gives and a write does. The
// registers themselves are rows of register_table.h and raw_registers.h.
// Source: mcp-aspep facts 4.4, 4.5 and 5; the recorded sessions.
#pragma once

#include "mcp/protocol.h"
#include "simulation/axis.h"
#include "simulation/mcp/datalog_recorder.h"
#include "simulation/mcp/profile.h"
#include "simulation/mcp/register_table.h"
#include "simulation/stale_bytes.h"

#include <deque>

namespace simulation {

struct BoardOptions;

class RegisterFile {
public:
    struct Written {
        mcp::Status status;
        int consumed; ///< bytes of the value; 0 where nothing says how long it is
    };

    RegisterFile(
        const Traits &traits, const BoardOptions &options, const Build &build, const Axes &axes);
    RegisterFile(const RegisterFile &) = delete;
    RegisterFile &operator=(const RegisterFile &) = delete;

    /// Whether the board has the motor of an identifier; 0, the board itself, always.
    bool hasMotor(mcp::RegisterId id) const;

    /// A motor starts, which measures the offsets of its currents.
    void started(unsigned motor) { m_motors[motor - 1].calibrated = true; }

    /// Appends the value to `out`. `room` is what the response still has; some structures do not look at it.
    mcp::Status read(mcp::RegisterId id, int room, Bytes &out) const;
    /// `available`: bytes of the request behind the identifier.
    Written write(
        mcp::RegisterId id, const StaleBytes &value, int available, DatalogRecorder &datalog);

    /// The variable behind a register in the datalog.
    Source source(mcp::RegisterId id) const;

private:
    /// The motor that answers for an identifier; nullptr where its scope and its motor bits do not fit.
    RegisterContext *addressed(mcp::RegisterId id, RegisterRow::Scope scope);
    const RegisterContext *addressed(mcp::RegisterId id, RegisterRow::Scope scope) const;
    bool ignoresMotor() const { return m_traits.ignoresMotorBits && m_motors.size() == 1; }

    mcp::Status readScalar(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status readText(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status readRaw(mcp::RegisterId id, int room, Bytes &out) const;
    template <class Row>
    mcp::Status refusalElsewhere(const Row *row, mcp::RegisterId id) const;
    mcp::Status writeScalar(mcp::RegisterId id, std::uint32_t value);
    mcp::Status writeRaw(
        mcp::RegisterId id, const StaleBytes &value, int size, DatalogRecorder &datalog);
    bool isDatalog(mcp::RegisterId id) const;
    bool isPrintedDatalog(mcp::RegisterId id) const; ///< global, read and written

    const Traits &m_traits;
    const BoardOptions &m_options;
    const Build &m_build;
    Bytes m_printedDatalog{0, 0, 255, 0, 0}; ///< the datalog's structure as the text has it
    std::deque<RegisterContext> m_motors; ///< the datalog points at them
};

} // namespace simulation
