// Finds out what board of the older serial protocol is on the other end, with reads only, before anything is written:
// dialect, version, motors, which registers its build has.
//
// GET_FW_VERSION tells the dialects apart: firmware of STM32 boards knows it. Where it is refused, registers that only
// one of the dialects has are read. If they contradict each other, or the user's choice, the board stays read-only.
#pragma once

#include "drive/fcp/requests.h"
#include "drive/task.h"
#include "fcp/reply.h"

#include <map>
#include <optional>

namespace drive {

class FcpIdentification : public Task<FcpProtocol> {
public:
    /// @param chosen  the dialect the user named; empty: to be found out
    FcpIdentification(FcpFacts &board, std::optional<fcp::Dialect> chosen)
        : m_board(board)
        , m_chosen(chosen)
    {
    }

    void restart(const fcp::BoardInfo &info);
    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

    /// What the board can do by what is known of it; anew when more is known.
    void addCapabilities();

    std::optional<fcp::Request> nextRequest(TimePoint now) override;
    void onResponse(const fcp::Reply &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

private:
    enum class Phase : std::uint8_t { Version, OnlyPowerPc, OnlyStm32, Motors, Registers };

    void decideDialect();
    void probeRegisters();
    void finish();
    void addLimits();

    FcpFacts &m_board;
    std::optional<fcp::Dialect> m_chosen;
    fcp::BoardInfo m_info;
    std::optional<fcp::FirmwareVersion> m_version; ///< as GET_FW_VERSION was answered
    Phase m_phase = Phase::Version;
    bool m_powerPcRegister = false, m_stm32Register = false; ///< asked for, and there
    std::string m_doubt; ///< why nothing may be written
    Reader<FcpProtocol> m_reader{m_board};
    std::map<RegisterId, Value> m_values;
    std::vector<Reading> m_readings;
    int m_losses = 0;
};

} // namespace drive
