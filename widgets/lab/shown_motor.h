// ShownMotor: what a board says of the motor that is shown. It does not change: it is asked for until it is known.
#pragma once

#include "drive/motor_view.h"
#include "lab/evaluation/speed_loop.h"
#include "widgets/registers/model.h"

#include <vector>

namespace widgets {

class ShownMotor {
public:
    ShownMotor(const Device &device, const RegisterModel &registers)
        : m_device(device)
        , m_registers(registers)
    {
    }

    void begin(); ///< another board, or another motor
    /// @return  true: something came, and other registers are to be watched from now on
    bool refresh();
    const std::vector<catalog::RegisterId> &watched() const { return m_missing; }
    bool known() const { return m_missing.empty(); }
    const drive::MotorFacts &facts() const { return m_facts; }

    /// The speed loop by what its registers were read as last; empty: not all of it is known.
    std::optional<lab::SpeedLoop> speedLoop(const lab::Subject &subject) const;

private:
    const Device &m_device;
    const RegisterModel &m_registers;
    drive::MotorFacts m_facts;
    std::vector<catalog::RegisterId> m_missing; ///< not read yet
};

} // namespace widgets
