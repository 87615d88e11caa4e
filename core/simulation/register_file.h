// The registers of the simulated board: which exist in the profile's build, what a read gives and a write does.
// Source: registers of firmware 6.2.0 and 6.4.0 (FOC, observer + PLL; 6.2 with Hall sensors); the recorded sessions.
#pragma once

#include "mcp/protocol.h"
#include "simulation/datalog_recorder.h"
#include "simulation/firmware/firmware.h"
#include "simulation/profile.h"
#include "simulation/stale_bytes.h"

namespace simulation {

struct BoardOptions;

class RegisterFile {
public:
    struct Written {
        mcp::Status status;
        int consumed; ///< bytes of the value; 0 where nothing says how long it is
    };

    RegisterFile(const Traits &traits, const BoardOptions &options, Firmware &firmware);

    /// Appends the value to `out`. `room` is what the response still has; some structures do not look at it.
    mcp::Status read(mcp::RegisterId id, int room, Bytes &out) const;
    /// `available`: bytes of the request behind the identifier.
    Written write(
        mcp::RegisterId id, const StaleBytes &value, int available, DatalogRecorder &datalog);

    /// The variable behind a register in the datalog.
    Source source(mcp::RegisterId id) const;
    /// Copies what is not kept as a variable of its own, for wide applications; before each sample.
    void refreshWide();

private:
    mcp::Status readByte(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status readWord(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status readLong(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status readText(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status readRaw(mcp::RegisterId id, int room, Bytes &out) const;
    mcp::Status writeByte(mcp::RegisterId id, std::uint8_t value);
    mcp::Status writeWord(mcp::RegisterId id, std::int16_t value);
    mcp::Status writeLong(mcp::RegisterId id, std::int32_t value);
    mcp::Status writeRaw(
        mcp::RegisterId id, const StaleBytes &value, int size, DatalogRecorder &datalog);
    mcp::Status writeRevUp(const StaleBytes &value, int size);
    bool isDatalog(mcp::RegisterId id) const;

    const Traits &m_traits;
    const BoardOptions &m_options;
    Firmware &m_firmware;
    std::uint8_t m_wideState = 0;
    std::int32_t m_wideSpeed = 0, m_wideReference = 0, m_wideFaults = 0;
};

} // namespace simulation
