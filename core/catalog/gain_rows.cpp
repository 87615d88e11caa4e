#include "catalog/gain_rows.h"

#include <algorithm>

namespace catalog {

std::span<const GainRow> gainRows()
{
    using enum GainKind;
    static constexpr std::array kRows{
        GainRow{GainLoop::Torque, {{{"I_Q_KP", TorqueKp}, {"I_Q_KI", TorqueKi}, {}}}},
        GainRow{GainLoop::Flux, {{{"I_D_KP", FluxKp}, {"I_D_KI", FluxKi}, {}}}},
        GainRow{GainLoop::Speed, {{{"SPEED_KP", SpeedKp}, {"SPEED_KI", SpeedKi}, {}}}},
        GainRow{GainLoop::FluxWeakening,
            {{{"FLUXWK_KP", WeakeningKp}, {"FLUXWK_KI", WeakeningKi}, {}}}},
        GainRow{GainLoop::Position,
            {{{"POSITION_KP", PositionKp}, {"POSITION_KI", PositionKi},
                {"POSITION_KD", PositionKd}}}},
        GainRow{GainLoop::Pll, {{{"STOPLL_KP", PllKp}, {"STOPLL_KI", PllKi}, {}}}},
        GainRow{GainLoop::Observer,
            {{{"STOPLL_C1", Observer1, false}, {"STOPLL_C2", Observer2, false}, {}}}},
        GainRow{GainLoop::CordicObserver,
            {{{"STOCORDIC_C1", Observer1, false}, {"STOCORDIC_C2", Observer2, false}, {}}}},
        GainRow{GainLoop::Currents,
            {{{"FOC_KP_IDQ", PerUnit, false}, {"FOC_WI_IDQ", PerUnit, false}, {}}}},
        GainRow{GainLoop::Speed,
            {{{"FOC_KP_SPD", PerUnit, false}, {"FOC_KI_SPD", PerUnit, false}, {}}}},
        GainRow{GainLoop::Torque,
            {{{"CL_CUR_Q_KP", InUnits, false}, {"CL_CUR_Q_KI", InUnits, false}, {}}}},
        GainRow{GainLoop::Flux,
            {{{"CL_CUR_D_KP", InUnits, false}, {"CL_CUR_D_KI", InUnits, false}, {}}}},
        GainRow{GainLoop::Speed,
            {{{"CL_VEL_PID_KP", InUnits, false}, {"CL_VEL_PID_KI", InUnits, false},
                {"CL_VEL_PID_KD", InUnits, false}}}},
        GainRow{GainLoop::Position,
            {{{"CL_POS_PID_KP", InUnits, false}, {"CL_POS_PID_KI", InUnits, false},
                {"CL_POS_PID_KD", InUnits, false}}}},
    };
    return kRows;
}

bool hasGain(const Catalog &catalog, GainKind kind)
{
    for (const GainRow &row : gainRows())
        if (std::ranges::any_of(row.gains, [&](const GainRegister &gain) {
                return gain.name && gain.kind == kind && catalog.find(gain.name);
            }))
            return true;
    return false;
}

} // namespace catalog
