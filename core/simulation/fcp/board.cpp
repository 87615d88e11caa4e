#include "simulation/fcp/board.h"

#include <algorithm>

namespace simulation {
namespace {

constexpr Duration kNothingToDo = std::chrono::hours(1);

} // namespace

FcpBoard::FcpBoard(FcpRig rig, std::uint32_t baud, Duration answerDelay, FcpMachine *machine)
    : m_rig(std::move(rig))
    , m_machine(machine)
    , m_server(m_rig, machine)
    , m_baud(std::max<std::uint32_t>(baud, 1))
    , m_answerDelay(answerDelay)
{
}

void FcpBoard::receive(ByteView bytes, TimePoint now)
{
    TimePoint at = std::max(now, m_lineBusyUntil);
    for (const std::uint8_t byte : bytes) {
        if (m_incoming.size() >= kMaxQueued)
            break;
        at += wireTime(1, m_baud);
        m_incoming.push_back({at, byte});
    }
    m_lineBusyUntil = at;
}

std::optional<TimePoint> FcpBoard::nextEvent() const
{
    std::optional<TimePoint> next = m_frameEnd;
    if (!m_incoming.empty())
        next = std::min(next.value_or(m_incoming.front().end), m_incoming.front().end);
    return next;
}

void FcpBoard::advance(TimePoint now)
{
    for (auto next = nextEvent(); next && *next <= now; next = nextEvent()) {
        if (m_frameEnd == next) {
            m_now = *next;
            expireFrame();
            continue;
        }
        const TimedByte byte = m_incoming.front();
        m_incoming.pop_front();
        advanceMachine(byte.end);
        accept(byte);
    }
    m_now = std::max(m_now, now);
    advanceMachine(m_now);
}

void FcpBoard::accept(const TimedByte &byte)
{
    if (byte.end <= m_sendingUntil)
        return;
    const bool first = !m_framer.midFrame();
    ByteView one(&byte.value, 1);
    const auto step = m_framer.next(one, m_frame);
    if (!m_framer.midFrame())
        m_frameEnd.reset();
    else if (first && m_rig.frameTimer)
        m_frameEnd = byte.end + *m_rig.frameTimer;
    if (step == fcp::Framer::Step::Frame) {
        send(m_server.answer(m_frame), byte.end);
    } else if (step == fcp::Framer::Step::BadChecksum) {
        m_server.remember(m_frame.payload);
        refuse(fcp::ErrorCode::BadChecksum, byte.end);
    }
}

void FcpBoard::expireFrame()
{
    if (m_framer.midFrame())
        breakOff(fcp::ErrorCode::Timeout);
    m_frameEnd.reset();
}

void FcpBoard::breakOff(fcp::ErrorCode error)
{
    m_frameEnd.reset();
    m_server.remember(m_framer.partialPayload());
    m_framer.reset();
    refuse(error, m_now);
}

void FcpBoard::refuse(fcp::ErrorCode error, TimePoint at)
{
    if (!m_server.hangs())
        send(fcp::encodeNack(error), at);
}

void FcpBoard::send(const Bytes &frame, TimePoint at)
{
    if (frame.empty())
        return;
    TimePoint end = std::max(at + m_answerDelay, m_sendingUntil);
    for (const std::uint8_t byte : frame) {
        end += wireTime(1, m_baud);
        m_outgoing.push_back({end, byte});
    }
    m_sendingUntil = end;
}

Bytes FcpBoard::takeOutput()
{
    Bytes out = std::exchange(m_injected, {});
    while (!m_outgoing.empty() && m_outgoing.front().end <= m_now) {
        TimedByte byte = m_outgoing.front();
        m_outgoing.pop_front();
        if (m_corruptAfter && (*m_corruptAfter)-- == 0) {
            byte.value ^= 1U;
            m_corruptAfter.reset();
        }
        if (byte.end > m_muteUntil)
            out.push_back(byte.value);
    }
    return out;
}

TimePoint FcpBoard::nextWake() const
{
    TimePoint wake = nextEvent().value_or(m_now + kNothingToDo);
    if (!m_outgoing.empty())
        wake = std::min(wake, m_outgoing.front().end);
    return wake;
}

void FcpBoard::reset()
{
    m_server = FcpServer(m_rig, m_machine);
    m_framer.reset();
    m_frameEnd.reset();
    m_incoming.clear();
    m_outgoing.clear();
    m_sendingUntil = m_lineBusyUntil = m_now;
}

void FcpBoard::setFaults(std::uint16_t present)
{
    const std::uint32_t past = (m_server.faults() & 0xFFFFU) | present;
    m_server.setFaults(std::uint32_t{present} << 16U | past);
}

void FcpBoard::corruptAfter(std::uint64_t bytes) { m_corruptAfter = bytes; }

void FcpBoard::inject(ByteView bytes)
{
    m_injected.insert(m_injected.end(), bytes.begin(), bytes.end());
}

/// By its state alone: nothing turns.
MotorTruth FcpBoard::truth(int motor) const
{
    const auto &motors = m_server.rig().motors;
    if (motor < 1 || static_cast<std::size_t>(motor) > motors.size())
        return {};
    const std::uint8_t state = motors[static_cast<std::size_t>(motor) - 1U].state;
    constexpr std::uint8_t kIdle = 0, kFaultNow = 10, kFaultOver = 11;
    const bool idle = state == kIdle || state == kFaultNow || state == kFaultOver;
    return {.driven = !idle,
        .idle = idle,
        .state = static_cast<MotorState>(state),
        .faults = m_server.faults()};
}

std::string FcpBoard::describe() const
{
    return std::string(m_rig.dialect == fcp::Dialect::PowerPc ? "PowerPC" : "STM32")
        + " board of the older protocol, rig " + m_rig.name;
}

} // namespace simulation
