#include "simulation/mcb/board.h"

#include <cmath>

namespace simulation {
namespace {

McbRig delayed(McbRig rig, int frames)
{
    rig.replyDelay = frames;
    return rig;
}

} // namespace

McbBoard::McbBoard(const McbBoardOptions &options, const PlantParameters &plant)
    : m_options(options)
    , m_servo(m_options.board, plant, options.servo)
    , m_slave(delayed(m_servo.rig(), options.replyDelay), &m_servo)
    , m_spoiler(options.faults, options.board.seed)
{
}

void McbBoard::reset()
{
    m_servo.restart();
    m_slave = McbSlave(delayed(m_servo.rig(), m_options.replyDelay), &m_servo);
    m_framing.clear();
}

Bytes McbBoard::exchange(ByteView input, TimePoint now)
{
    advance(now);
    if (m_servo.resetWanted() || m_spoiler.resets()) {
        m_servo.restart();
        m_slave = McbSlave(delayed(m_servo.rig(), m_options.replyDelay), &m_servo);
    }
    if (m_spoiler.silent())
        return {};
    Bytes heard(input.begin(), input.end());
    m_spoiler.spoilInput(heard);
    const bool whole = input.size() == m_slave.frameBytes();
    Bytes output = m_slave.exchange(heard);
    if (!m_spoiler.honest())
        output = m_spoiler.spoilOutput(std::move(output), whole);
    damage(output);
    return output;
}

/// What a control word asked for.
void McbBoard::damage(Bytes &output)
{
    if (m_corruptAfter) {
        if (*m_corruptAfter < output.size()) {
            output[static_cast<std::size_t>(*m_corruptAfter)] ^= 1U;
            m_corruptAfter.reset();
        } else {
            *m_corruptAfter -= output.size();
        }
    }
    if (m_now < m_muteUntil)
        output.clear();
    if (!m_injected.empty())
        output.insert(output.begin(), m_injected.begin(), m_injected.end());
    m_injected.clear();
}

void McbBoard::receive(ByteView bytes, TimePoint now)
{
    advance(now);
    m_framing.receive(
        bytes, now, [this] { return m_slave.frameBytes(); },
        [this, now](ByteView input) { return exchange(input, now); });
}

void McbBoard::advance(TimePoint now)
{
    if (now < m_now)
        return;
    m_now = now;
    m_servo.advance(now);
    m_framing.advance(now);
}

TimePoint McbBoard::nextWake() const
{
    // So that the motor's time is never made up at once.
    constexpr Duration kLook = std::chrono::milliseconds(5);
    return m_framing.outputWaits() ? m_now : std::min(m_framing.nextWake(), m_now + kLook);
}

void McbBoard::setFaults(std::uint16_t present)
{
    m_servo.axis().firmware.setPresentFaults(present);
}

MotorTruth McbBoard::truth(int motor) const
{
    if (motor != 1)
        return {};
    MotorTruth truth = truthOf(m_servo.axis());
    truth.referenceRpm = m_servo.speedReference_rpm();
    const Servo::State state = m_servo.state(); // which is at rest as soon as the stage is off
    truth.idle = !truth.driven
        && (state == Servo::State::SwitchOnDisabled || state == Servo::State::Ready
            || state == Servo::State::Fault);
    switch (state) { // what the servo's master may say of it
    case Servo::State::SwitchOnDisabled:
    case Servo::State::Ready:
        truth.state = MotorState::Idle;
        break;
    case Servo::State::SwitchedOn:
        truth.state = MotorState::Start;
        break;
    case Servo::State::Enabled:
        truth.state = MotorState::Run;
        break;
    case Servo::State::QuickStop:
        truth.state = MotorState::Stop;
        break;
    case Servo::State::Fault:
        break; // present or over, as the firmware has it
    }
    return truth;
}

void McbBoard::setLoadTorque(int motor, double nm)
{
    if (motor == 1)
        m_servo.axis().plant.setLoadTorque(nm);
}

std::string McbBoard::describe() const
{
    const PlantParameters &plant = m_servo.axis().plant.parameters();
    return "Simulated MCB drive, " + std::to_string(std::lround(plant.inverter.supply_v))
        + " V PMSM with " + std::to_string(plant.motor.polePairs) + " pole pairs";
}

std::unique_ptr<McbBoard> makeMcbBoard(McbBoardOptions options)
{
    if (options.board.motor.empty() && !options.board.plant)
        options.board.motor = "servo24";
    const auto plant = plantOf(options.board);
    return plant ? std::make_unique<McbBoard>(options, *plant) : nullptr;
}

} // namespace simulation
