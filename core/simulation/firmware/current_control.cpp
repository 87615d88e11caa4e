// The bridge holds a voltage for one period, during which the rotor turns: it is given for the angle of its middle.
#include "simulation/firmware/current_control.h"

#include "simulation/maths/transforms.h"

namespace simulation {

CurrentControl::CurrentControl(std::uint16_t pwmPeriod)
    : m_pwmPeriod(pwmPeriod)
{
}

void CurrentControl::clear()
{
    m_q.clear();
    m_d.clear();
}

void CurrentControl::measure(Ab currents, std::int16_t angle, Signals &out)
{
    const AlphaBeta still = clarke(currents);
    const Qd turning = park(still, trig(angle));
    out.iA = currents.a;
    out.iB = currents.b;
    out.iAlpha = still.alpha;
    out.iBeta = still.beta;
    out.iQ = turning.q;
    out.iD = turning.d;
}

Duties CurrentControl::apply(Qd voltage, Frame frame, Signals &out) const
{
    const Qd inside = circleLimit(voltage, m_circle);
    const AlphaBeta still = reversePark(inside, trig(wrapAngle(frame.angle + frame.perPeriod / 2)));
    out.vQ = inside.q;
    out.vD = inside.d;
    out.vAlpha = still.alpha;
    out.vBeta = still.beta;
    return dutiesOf(modulate(still, m_pwmPeriod), m_pwmPeriod);
}

Duties CurrentControl::step(
    Ab currents, Frame frame, Qd reference, Qd feedForward, const Tuning &tuning, Signals &out)
{
    measure(currents, frame.angle, out);
    m_q.follow({tuning.qKp, tuning.qKi, tuning.qKpDiv, tuning.qKiDiv});
    m_d.follow({tuning.dKp, tuning.dKi, tuning.dKpDiv, tuning.dKiDiv});
    const Qd loops{m_q.step(reference.q - out.iQ), m_d.step(reference.d - out.iD)};
    out.iQRef = reference.q;
    out.iDRef = reference.d;
    return apply(
        {saturateSymmetric(loops.q + feedForward.q), saturateSymmetric(loops.d + feedForward.d)},
        frame, out);
}

Duties CurrentControl::drive(Ab currents, Frame frame, Qd voltage, Signals &out)
{
    measure(currents, frame.angle, out);
    clear();
    out.iQRef = out.iDRef = 0;
    return apply(voltage, frame, out);
}

} // namespace simulation
