// A drive of MCB without a motor model: the slave of the simulated drives, and behind it a state machine that does at once
// what its control word says.
#pragma once

#include "drive/mcb/mcb_messages.h"
#include "fuzz/drive_script.h"
#include "mcb/dictionary.h"
#include "mcb/mapping.h"
#include "simulation/mcb/mcb_board.h"

namespace fuzz {

class McbPeer final : public Peer, private simulation::McbLife {
public:
    McbPeer()
        : m_slave(rig(), this)
    {
    }

    void receive(ByteView bytes, TimePoint) override { m_answer = m_slave.exchange(bytes); }
    void advance(TimePoint) override { }
    Bytes takeOutput() override { return std::exchange(m_answer, {}); }
    TimePoint nextWake() const override { return TimePoint::max(); }
    void reset() override
    {
        m_state = State::Off;
        m_fault = false;
        m_slave = simulation::McbSlave(rig(), this);
    }
    void setFaults(std::uint16_t present) override
    {
        m_present = present != 0;
        m_fault = m_fault || m_present;
    }
    std::vector<judge::Motor> truth() const override
    {
        // A fault switches the power stage off, whatever was asked for before.
        const bool driven = !m_fault && (m_state == State::On || m_state == State::Enabled);
        return {{driven, !driven, 0.0}};
    }

private:
    enum class State : std::uint8_t { Off, Ready, On, Enabled };

    static const simulation::McbRig &rig()
    {
        // Registers that the drive will not ask for make each reset dearer and nothing else.
        static const simulation::McbRig rig = [] {
            simulation::McbRig whole = simulation::makeMcbBoard({})->servo().rig();
            const auto &entries = mcb::dictionary();
            std::erase_if(whole.registers, [&](const auto &one) {
                return std::none_of(entries.begin(), entries.end(),
                    [&](const mcb::Entry &entry) { return entry.address == one.first; });
            });
            return whole;
        }();
        return rig;
    }

    void show(simulation::McbRegisters &registers) override
    {
        static constexpr std::array<std::uint16_t, 4> kWords{0x0240, 0x0221, 0x0233, 0x1237};
        const std::uint16_t word =
            m_fault ? std::uint16_t{0x0208} : kWords[static_cast<std::size_t>(m_state)];
        registers.put(drive::mcbreg::kStatus, std::array{word});
    }
    std::optional<mcb::ErrorCode> refusal(std::uint16_t, mcb::WordView) const override
    {
        return {};
    }
    void look(const simulation::McbRegisters &registers) override
    {
        const auto words = registers.read(drive::mcbreg::kControl);
        const unsigned control = words && !words->empty() ? words->front() : 0U;
        if ((control & 0x80U) != 0 && !m_present)
            m_fault = false;
        if (m_fault || (control & 0x06U) != 0x06U)
            m_state = State::Off;
        else if ((control & 0x01U) == 0)
            m_state = State::Ready;
        else if ((control & 0x08U) == 0)
            m_state = State::On;
        else if (m_state != State::Off)
            m_state = State::Enabled;
    }

    State m_state = State::Off;
    bool m_present = false, m_fault = false;
    simulation::McbSlave m_slave;
    Bytes m_answer;
};

} // namespace fuzz
