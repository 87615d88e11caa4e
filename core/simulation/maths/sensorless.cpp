// Two ways to an angle from one back-EMF (E cos, -E sin); in reverse E is negative, so both sides change their sign.
#include "simulation/maths/sensorless.h"

#include "simulation/maths/transforms.h"

namespace simulation {

namespace {

int directionOr(int forced, std::int16_t speed_dpp)
{
    return (forced != 0 ? forced : speed_dpp) < 0 ? -1 : 1;
}

/// The observer keeps its back-EMF within -32767..32767, so nothing is cut.
AlphaBeta inDirection(AlphaBeta bemf, int direction)
{
    const int alpha = bemf.alpha * direction, beta = bemf.beta * direction;
    return {saturate16(alpha), saturate16(beta)};
}

} // namespace

void ObservedAngle::clear()
{
    m_observer.clear();
    m_speed.clear();
    m_angle = 0;
    m_instant_dpp = 0;
}

ObserverPll::ObserverPll(const Parameters &parameters)
    : ObservedAngle(parameters.observer, parameters.speed)
    , m_pll(parameters.pll)
{
}

std::int16_t ObserverPll::step(const ObserverInput &input)
{
    m_observer.step(input, m_speed.speed_dpp());
    const AlphaBeta bemf =
        inDirection(m_observer.bemf(), directionOr(m_direction, m_speed.speed_dpp()));
    const Trig t = trig(m_angle);
    const std::int32_t across = (-bemf.beta * t.cosine) >> 15, along = (bemf.alpha * t.sine) >> 15;
    m_instant_dpp = m_pll.step(across - along);
    m_speed.store(m_instant_dpp);
    m_angle = wrapAngle(m_angle + m_instant_dpp);
    return m_angle;
}

void ObserverPll::clear()
{
    ObservedAngle::clear();
    m_pll.clear();
}

ObserverCordic::ObserverCordic(const Parameters &parameters)
    : ObservedAngle(parameters.observer, parameters.speed)
    , m_maxAcceleration_dpp(parameters.maxAcceleration_dpp)
{
}

std::int16_t ObserverCordic::step(const ObserverInput &input)
{
    m_observer.step(input, m_speed.speed_dpp());
    const int direction = directionOr(m_direction, m_speed.speed_dpp());
    const AlphaBeta bemf = inDirection(m_observer.bemf(), direction);
    const std::int16_t seen = angleOf(bemf.alpha, saturate16(-bemf.beta));
    int speed = wrapAngle(seen - m_angle);
    if (speed * direction < 0)
        speed = 0;
    const int least = m_instant_dpp - m_maxAcceleration_dpp;
    const int most = m_instant_dpp + m_maxAcceleration_dpp;
    m_instant_dpp = saturate16(std::clamp(speed, least, most));
    m_speed.store(m_instant_dpp);
    m_angle = wrapAngle(m_angle + m_instant_dpp);
    return m_angle;
}

} // namespace simulation
