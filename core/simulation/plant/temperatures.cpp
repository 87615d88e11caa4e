// One step of a first-order thermal model, backward, so that no step is too long.
#include "simulation/plant/temperatures.h"

namespace simulation {

HeatStore::HeatStore(double ambient_c, double capacity_jpk, double cooling_s)
    : m_ambient_c(ambient_c)
    , m_capacity_jpk(capacity_jpk)
    , m_cooling_s(cooling_s)
{
}

void HeatStore::warm(double energy_j, double over_s)
{
    if (m_capacity_jpk <= 0.0)
        return;
    m_rise_k += energy_j / m_capacity_jpk;
    if (m_cooling_s > 0.0)
        m_rise_k /= 1.0 + over_s / m_cooling_s;
}

} // namespace simulation
