// A drive of MCB without a motor model, behind the slave of the simulated drives.
#pragma once

#include "fuzz/drive_script.h"
#include "support/mcb/quick_servo.h"

namespace fuzz {

class McbPeer final : public Peer {
public:
    void receive(ByteView bytes, TimePoint) override { m_answer = m_slave.exchange(bytes); }
    void advance(TimePoint) override { }
    Bytes takeOutput() override { return std::exchange(m_answer, {}); }
    TimePoint nextWake() const override { return TimePoint::max(); }
    void reset() override
    {
        m_servo.restart();
        m_slave = simulation::McbSlave(support::QuickServo::rig(), &m_servo);
    }
    void setFaults(std::uint16_t present) override
    {
        m_servo.faultIsPresent = present != 0;
        m_servo.fault = m_servo.fault || m_servo.faultIsPresent;
    }
    std::vector<judge::Motor> truth() const override
    {
        return {{m_servo.driven(), !m_servo.driven(), 0.0}};
    }

private:
    support::QuickServo m_servo;
    simulation::McbSlave m_slave{support::QuickServo::rig(), &m_servo};
    Bytes m_answer;
};

} // namespace fuzz
