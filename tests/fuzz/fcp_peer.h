// A board of the older serial protocol without a motor model: the rig and the server of the simulated boards, and
// motors that do at once what they are told.
#pragma once

#include "fcp/request.h"
#include "fuzz/drive_script.h"
#include "simulation/fcp/board.h"

namespace fuzz {

class FcpPeer final : public Peer, private simulation::FcpMachine {
public:
    FcpPeer(fcp::Dialect dialect, int motors)
        : m_motors(static_cast<std::size_t>(motors))
        , m_board(rig(dialect, motors), 115200, 200us, this)
    {
    }

    void receive(ByteView bytes, TimePoint now) override { m_board.receive(bytes, now); }
    void advance(TimePoint now) override { m_board.advance(now); }
    Bytes takeOutput() override { return m_board.takeOutput(); }
    TimePoint nextWake() const override { return m_board.nextWake(); }
    void reset() override
    {
        m_motors.assign(m_motors.size(), {});
        m_board.reset();
    }
    void setFaults(std::uint16_t present) override
    {
        for (Motor &motor : m_motors) {
            motor.faults = std::uint32_t{present} << 16 | (motor.faults & 0xFFFFU) | present;
            if (present != 0)
                motor.state = kFaultNow;
            else if (motor.state == kFaultNow)
                motor.state = kFaultOver;
        }
    }
    std::vector<judge::Motor> truth() const override
    {
        std::vector<judge::Motor> all;
        for (const Motor &motor : m_motors)
            all.push_back({motor.state == kRun, motor.state != kRun,
                motor.state == kRun ? static_cast<double>(motor.rpm) : 0.0});
        return all;
    }

private:
    // STATUS
    static constexpr std::uint8_t kIdle = 0, kRun = 6, kFaultNow = 10, kFaultOver = 11;
    static constexpr std::uint8_t kSpeedMeas = 0x1E;

    struct Motor {
        std::uint8_t state = kIdle;
        std::uint32_t faults = 0;
        std::int32_t rpm = 0;
    };

    static simulation::FcpRig rig(fcp::Dialect dialect, int motors)
    {
        simulation::FcpRig rig;
        rig.dialect = dialect;
        rig.motors.resize(static_cast<std::size_t>(motors));
        for (simulation::FcpMotor &motor : rig.motors)
            motor.revUp.resize(fcp::kRevUpStages);
        rig.frameTimer = 25ms;
        return rig;
    }

    void refresh(std::size_t motor, simulation::FcpMotor &registers) override
    {
        registers.state = m_motors[motor].state;
        registers.faults = m_motors[motor].faults;
        registers.registers[kSpeedMeas] = m_motors[motor].state == kRun ? m_motors[motor].rpm : 0;
    }
    void execute(std::size_t which, fcp::CommandId command) override
    {
        Motor &motor = m_motors[which];
        if (command == fcp::CommandId::StartMotor && motor.state == kIdle)
            motor.state = kRun;
        else if (command == fcp::CommandId::StopMotor && motor.state == kRun)
            motor.state = kIdle;
        else if (command == fcp::CommandId::FaultAck && motor.state == kFaultOver)
            motor = {};
    }
    void rampSpeed(std::size_t motor, std::int32_t rpm, std::uint16_t) override
    {
        m_motors[motor].rpm = rpm;
    }
    void written(std::size_t, std::uint8_t, std::int64_t) override { }
    void setControlMode(std::size_t, bool) override { }
    void rampTorque(std::size_t, std::int16_t, std::uint16_t) override { }
    void setCurrents(std::size_t, std::int16_t, std::int16_t) override { }
    void setRevUp(std::size_t, std::size_t, const fcp::StageFields &) override { }

    std::vector<Motor> m_motors;
    simulation::FcpBoard m_board;
};

} // namespace fuzz
