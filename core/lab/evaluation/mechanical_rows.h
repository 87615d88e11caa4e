// The equations that inertia and friction are solved from, out of samples of current and angle (lab/evaluation/
// mechanical_evaluation.h). Pure.
#pragma once

#include "lab/evaluation/segments.h"
#include "lab/maths/least_squares.h"

namespace lab {

/// Places of the unknowns in a row; the tilt is that of a torque which is not quite proportional to its current. Only
/// both directions tell dry friction from what is always there.
inline constexpr std::size_t kInertia = 0, kViscous = 1, kDry = 2, kFan = 3, kTilt = 4, kAlways = 5;

struct MechanicalFacts {
    double polePairs = 1.0;
    double torquePerAmp = 0.0; ///< Nm
    double edge_s = 5e-3; ///< to either side of an instant, for its speed
    double stretch_s = 1.0; ///< in which all is integrated from its beginning
};

/// Means over one window.
struct MechanicalInstant {
    double speed = 0.0; ///< rad/s
    double torque_nm = 0.0;
};

class MechanicalRows {
public:
    explicit MechanicalRows(const MechanicalFacts &facts)
        : m_facts(facts)
    {
    }

    /// @param segment  with Iq as its first value
    void accept(const Segment &segment);

    Rows rows;
    std::vector<MechanicalInstant> instants; ///< of the rows
    double time_s = 0.0;
    double fastest = 0.0; ///< rad/s

private:
    class Integrals;
    void add(const Integrals &integrals, double step_s, std::size_t from, std::size_t to);

    MechanicalFacts m_facts;
    std::size_t m_count = 0;
};

} // namespace lab
