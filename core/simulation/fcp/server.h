// The frames of the older serial protocol as firmware executes them, on a rig: one good frame in, one answer out. It
// knows no line and no time.
// Source: firmware 5.4.3 for STM32, which reads old bytes where a request is too short; the text for PowerPC.
#pragma once

#include "base/time.h"
#include "fcp/framer.h"
#include "fcp/register_table.h"
#include "fcp/reply.h"
#include "fcp/request.h"
#include "simulation/stale_bytes.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace simulation {

struct FcpMotor {
    enum class Sensing : std::uint8_t { Pll, Cordic, Encoder, Hall };

    std::uint8_t state = 0; ///< STATUS
    std::uint8_t controlMode = 1; ///< 0 torque, 1 speed
    std::uint32_t faults = 0; ///< FLAGS: present now << 16 | not acknowledged
    Sensing sensing = Sensing::Pll;
    std::map<std::uint8_t, std::int64_t> registers; ///< raw digits; those not named are 0
    std::vector<fcp::StageFields> revUp; ///< empty: a build without
};

/// What a static board is and holds: no motor turns behind it, its values change only by what the protocol says, so
/// that every answer can be foretold.
struct FcpRig {
    fcp::Dialect dialect = fcp::Dialect::Stm32;
    std::string name; ///< for messages
    std::vector<FcpMotor> motors{FcpMotor{}}; ///< 1 to 7
    bool fluxWeakening = false, feedForward = false, pfc = false, profiler = false, dac = false;
    std::string firmware = "ST MC SDK\tVer.5.4.3"; ///< answer of GET_FW_VERSION
    bool integersInBoardInfo = false; ///< its version as the text has it, not as digits
    std::int32_t speedStep_rpm = 6; ///< speeds are kept in whole steps, 1 or more rpm each
    /// From the header; none: a broken frame stays half received, as in 5.4.3.
    std::optional<Duration> frameTimer;
};

/// The motors behind a board, as its server sees them: values to be looked up before each answer, and what a request
/// makes them do. Motors are counted from 0 here.
class FcpMachine {
public:
    FcpMachine() = default;
    FcpMachine(const FcpMachine &) = delete;
    FcpMachine &operator=(const FcpMachine &) = delete;
    virtual ~FcpMachine() = default;

    /// Fills in what the motor's registers hold now.
    virtual void refresh(std::size_t motor, FcpMotor &registers) = 0;

    virtual void written(std::size_t motor, std::uint8_t id, std::int64_t value) = 0;
    virtual void execute(std::size_t motor, fcp::CommandId command) = 0;
    virtual void setControlMode(std::size_t motor, bool torque) = 0;
    virtual void rampSpeed(std::size_t motor, std::int32_t rpm, std::uint16_t duration_ms) = 0;
    virtual void rampTorque(std::size_t motor, std::int16_t digits, std::uint16_t duration_ms) = 0;
    virtual void setCurrents(std::size_t motor, std::int16_t iq, std::int16_t id) = 0;
    virtual void setRevUp(std::size_t motor, std::size_t stage, const fcp::StageFields &values) = 0;
};

class FcpServer {
public:
    /// @param machine  the motors behind it; none: a static board, whose values are the rig's
    explicit FcpServer(FcpRig rig, FcpMachine *machine = nullptr);

    /// The whole answer to a frame whose checksum was good; empty once the firmware hangs.
    Bytes answer(const fcp::Frame &frame);
    /// Payload bytes that came but were not executed: later requests that are too short find them.
    void remember(ByteView payload);

    // What happens to the board besides the protocol.
    void setState(std::uint8_t state); ///< of the first motor
    void setFaults(std::uint32_t flags); ///< of the first motor
    std::uint32_t faults() const { return m_rig.motors.front().faults; }
    /// The medium-frequency task: commands that wait take effect in motors that run.
    void executeBuffered();

    /// The firmware followed a null pointer and answers nothing any more.
    bool hangs() const { return m_hangs; }
    const FcpRig &rig() const { return m_rig; } ///< as it is now

private:
    /// A command that waits for the motor to run.
    struct Ramp {
        std::int32_t speed_rpm = 0;
    };
    struct Currents {
        std::int16_t iq = 0, id = 0;
    };
    using Waiting = std::variant<std::monostate, Ramp, Currents>;

    Bytes execute(std::uint8_t code, std::size_t length);
    Bytes getRegister(std::uint8_t id);
    Bytes setRegister(std::uint8_t id, StaleBytes value);
    bool setSpecial(std::uint8_t id, std::int64_t value);
    Bytes selectMotor(std::uint8_t motor);
    Bytes setControlMode(std::uint8_t mode);
    Bytes command(std::uint8_t id);
    void act(fcp::CommandId id);
    Bytes getRevUp(std::uint8_t stage) const;
    Bytes setRevUp(const StaleBytes &content);
    void ramp(std::int32_t speed_rpm, std::uint16_t duration_ms);
    void torqueRamp(std::int16_t torque, std::uint16_t duration_ms);
    void wait(Currents currents);
    bool isBuilt(const fcp::Register &which) const;
    std::int64_t valueOf(std::uint8_t id) const;
    std::int32_t inSteps(std::int32_t speed_rpm) const;
    FcpMotor &motor() { return m_rig.motors[m_selected]; }
    const FcpMotor &motor() const { return m_rig.motors[m_selected]; }
    bool powerPc() const { return m_rig.dialect == fcp::Dialect::PowerPc; }

    FcpRig m_rig;
    FcpMachine *m_machine;
    std::size_t m_selected = 0; ///< kept from frame to frame
    std::vector<Waiting> m_waiting; ///< one a motor
    std::array<std::uint8_t, fcp::kMaxPayload> m_buffer{}; ///< never cleared, as in the firmware
    bool m_hangs = false;
};

} // namespace simulation
