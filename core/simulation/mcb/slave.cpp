#include "simulation/mcb/slave.h"

#include <algorithm>

namespace simulation {

using mcb::Command;
using mcb::ErrorCode;
using mcb::Frame;

McbSlave::McbSlave(const McbRig &rig, McbLife *life)
    : m_registers(rig)
    , m_life(life)
    , m_replyDelay(rig.replyDelay)
{
}

Frame McbSlave::nextOutput()
{
    Frame frame;
    if (!m_answers.empty() && m_wait > 0) {
        --m_wait;
    } else if (!m_answers.empty()) {
        frame = std::move(m_answers.front());
        m_answers.pop_front();
    }
    if (m_cyclic)
        frame.cyclic = m_registers.cyclicOutput(*m_cyclic);
    return frame;
}

Bytes McbSlave::exchange(ByteView input)
{
    ++m_counts.frames;
    if (m_life != nullptr)
        m_life->show(m_registers);
    const bool answered = !m_answers.empty() && m_wait == 0;
    Bytes output = mcb::encodeFrame(nextOutput());
    if (input.size() != output.size()) {
        ++m_counts.wrongLength;
        if (answered)
            abandonSwitch(); // the ACK is lost
        output.resize(input.size());
        return output;
    }
    const auto request = mcb::decodeFrame(input);
    if (request && m_cyclic) {
        m_registers.acceptCyclicInput(*m_cyclic, request->cyclic);
        if (m_life != nullptr && !m_cyclic->rx.empty())
            m_life->look(m_registers);
    }
    // The master has seen the ACK, whatever came of its own frame.
    if (answered && m_switches && m_answers.empty())
        switchState();
    if (request)
        handle(*request);
    else
        ++m_counts.badFrames;
    return output;
}

void McbSlave::switchState()
{
    m_switches = false;
    m_cyclic.reset();
    const auto state = m_registers.read(McbRegisters::kState);
    const auto mapping = m_registers.mapping();
    if (state && state->front() == McbRegisters::kCyclicState && mapping)
        m_cyclic = *mapping;
}

void McbSlave::abandonSwitch()
{
    if (std::exchange(m_switches, false))
        m_registers.setState(m_cyclic ? McbRegisters::kCyclicState : McbRegisters::kConfigState);
}

void McbSlave::handle(const Frame &request)
{
    if (request.command == Command::Idle)
        return;
    abandonSwitch(); // what was not yet sent of the answer before never will be
    switch (request.command) {
    case Command::Read: {
        const auto words = m_registers.read(request.address);
        if (words)
            return answer(mcb::fragmentsOf(request.address, Command::Ack, *words));
        return refuse(request, Command::ErrorOfRead, words.error());
    }
    case Command::GetInfo:
        if (const McbRegister *content = m_registers.find(request.address))
            return answer(
                {Frame{request.address, Command::Ack, false, mcb::configOf(content->info), {}}});
        return refuse(request, Command::ErrorOfInfo, ErrorCode::NoSuchRegister);
    case Command::Write:
        return handleWrite(request);
    case Command::Ack:
    case Command::ErrorOfInfo:
    case Command::ErrorOfRead:
    case Command::ErrorOfWrite:
    case Command::Idle:
        break;
    }
    refuse(request, Command::ErrorOfInfo, ErrorCode::InvalidCommand);
}

void McbSlave::handleWrite(const Frame &request)
{
    using Added = mcb::Gatherer::Added;
    const Added added = m_written.add(request);
    if (added == Added::TooLong)
        return refuse(request, Command::ErrorOfWrite, ErrorCode::General);
    if (added == Added::Whole) {
        if (const auto code = m_life != nullptr
                ? m_life->refusal(request.address, m_written.words())
                : std::nullopt)
            return refuse(request, Command::ErrorOfWrite, *code);
        const auto written = m_registers.write(request.address, m_written.words());
        if (!written)
            return refuse(request, Command::ErrorOfWrite, written.error());
        if (m_life != nullptr)
            m_life->look(m_registers);
    }
    // Each fragment is acknowledged alone, with what came.
    answer({Frame{request.address, Command::Ack, false, request.config, {}}});
    m_switches = added == Added::Whole && request.address == McbRegisters::kState;
}

void McbSlave::answer(std::vector<Frame> frames)
{
    m_answers.assign(
        std::make_move_iterator(frames.begin()), std::make_move_iterator(frames.end()));
    m_wait = m_replyDelay;
}

void McbSlave::refuse(const Frame &request, Command command, ErrorCode code)
{
    m_written.clear();
    answer({Frame{request.address, command, false, mcb::configOf(code), {}}});
}

void McbStream::receive(ByteView bytes, TimePoint now)
{
    m_framing.receive(
        bytes, now, [this] { return m_slave.frameBytes(); },
        [this](ByteView input) { return m_slave.exchange(input); });
}

void McbStream::reset()
{
    m_slave = McbSlave(m_rig);
    m_framing.clear();
}

} // namespace simulation
