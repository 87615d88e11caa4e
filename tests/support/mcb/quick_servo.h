// A drive of MCB without a motor model: what its control word says is so at once. Behind the slave of the simulated
// drives it is cheap enough for thousands of runs.
#pragma once

#include "drive/mcb/requests.h"
#include "mcb/dictionary.h"
#include "simulation/mcb/board.h"

#include <algorithm>
#include <array>

namespace support {

class QuickServo : public simulation::McbLife {
public:
    bool obeys = true; ///< a control word that takes the power away
    bool faultIsPresent = false;
    bool fault = false; ///< present, or not acknowledged

    /// A fault switches the power stage off, whatever was asked for before.
    bool driven() const { return !fault && (m_state == State::On || m_state == State::Enabled); }
    void restart()
    {
        m_state = State::Off;
        fault = false;
    }

    /// Registers that the drive will not ask for make each reset dearer and nothing else.
    static const simulation::McbRig &rig()
    {
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
            fault ? std::uint16_t{0x0208} : kWords[static_cast<std::size_t>(m_state)];
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
        const bool takesAway = (control & 0x06U) != 0x06U || (control & 0x01U) == 0;
        if ((control & 0x80U) != 0 && !faultIsPresent)
            fault = false;
        if (takesAway && driven() && !obeys)
            return;
        if (fault || (control & 0x06U) != 0x06U)
            m_state = State::Off;
        else if ((control & 0x01U) == 0)
            m_state = State::Ready;
        else if ((control & 0x08U) == 0)
            m_state = State::On;
        else if (m_state != State::Off)
            m_state = State::Enabled;
    }

private:
    enum class State : std::uint8_t { Off, Ready, On, Enabled };
    State m_state = State::Off;
};

} // namespace support
