#include "simulation/mcb/faults.h"

#include "mcb/error_code.h"
#include "mcb/mapping.h"

#include <algorithm>
#include <utility>

namespace simulation {

using mcb::Command;
using mcb::Frame;

namespace {

constexpr int kDeadFrames = 6;

constexpr std::array<McbFaultRow, kMcbFaults> kRows{{
    {McbFault::Flip, "flip", "a bit of what it sends is wrong"},
    {McbFault::FlipInput, "flip-in", "a bit of what it hears is wrong"},
    {McbFault::SwapBytes, "swap", "the bytes of every word are swapped"},
    {McbFault::WrongAddress, "wrong-address", "an answer names the next register"},
    {McbFault::StaleAck, "stale-ack", "the last answer comes again where IDLE is due"},
    {McbFault::ErrorInside, "error-inside", "an error instead of an answer or a fragment"},
    {McbFault::IdleBetween, "idle-between", "an answer or a fragment is one frame late"},
    {McbFault::LostAnswer, "no-answer", "an answer never comes"},
    {McbFault::Garbage, "garbage", "anything in the words that are not used"},
    {McbFault::CrcError, "crc-error", "it says that a good frame was damaged"},
    {McbFault::NotReady, "not-ready", "the ready line stays low for a frame"},
    {McbFault::Glitch, "glitch", "the ready line rises too early: nonsense comes"},
    {McbFault::DeadLow, "dead-low", "the line is low for six frames"},
    {McbFault::DeadHigh, "dead-high", "the line is high for six frames"},
    {McbFault::Reset, "reset", "a power cycle, in the cyclic state too"},
}};

} // namespace

std::span<const McbFaultRow> mcbFaultList() { return kRows; }

McbSpoiler::McbSpoiler(std::span<const McbFaultChoice> faults, std::uint64_t seed)
    : m_none(faults.empty())
    , m_state(seed)
{
    for (const McbFaultChoice &one : faults)
        m_every[static_cast<std::size_t>(one.fault)] = one.every;
}

bool McbSpoiler::strikes(McbFault fault)
{
    const std::uint32_t every = m_every[static_cast<std::size_t>(fault)];
    return every != 0 && random() % every == 0;
}

bool McbSpoiler::resets()
{
    if (!strikes(McbFault::Reset))
        return false;
    m_late.clear();
    m_crcErrorDue = false;
    m_lastAnswer.reset();
    return true;
}

void McbSpoiler::spoilInput(Bytes &input)
{
    if (strikes(McbFault::FlipInput))
        input[random() % input.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    const auto frame = mcb::decodeFrame(input);
    if (!frame || frame->command == Command::Idle)
        return;
    m_late.clear(); // a new request: what was to come does not
    if (strikes(McbFault::CrcError)) {
        input.back() ^= 1U;
        m_crcErrorDue = true;
    }
}

void McbSpoiler::spoilAnswer(Frame &frame)
{
    const bool answer = frame.command != Command::Idle;
    // The ACK that changes the length of frames has been sent for the slave when it left it.
    const bool ofState = frame.address == mcb::kStateRegister;
    if (!m_late.empty() || (answer && !ofState && strikes(McbFault::IdleBetween))) {
        if (answer)
            m_late.push_back(frame);
        Frame now{0, Command::Idle, false, {}, {}};
        if (!answer) {
            now = std::move(m_late.front());
            m_late.pop_front();
        }
        now.cyclic = std::move(frame.cyclic);
        frame = std::move(now);
    } else if (std::exchange(m_crcErrorDue, false)) {
        frame = {frame.address, Command::ErrorOfInfo, false, mcb::configOf(mcb::ErrorCode::BadCrc),
            std::move(frame.cyclic)};
    } else if (!answer && m_lastAnswer && strikes(McbFault::StaleAck)) {
        mcb::Words cyclic = std::move(frame.cyclic);
        frame = *m_lastAnswer;
        frame.cyclic = std::move(cyclic);
    } else if (answer && strikes(McbFault::WrongAddress)) {
        frame.address = static_cast<std::uint16_t>((frame.address + 1) & mcb::kMostAddress);
    } else if (answer && strikes(McbFault::ErrorInside)) {
        frame.command = Command::ErrorOfInfo;
        frame.pending = false;
        frame.config = mcb::configOf(mcb::ErrorCode::General);
    } else if (answer && strikes(McbFault::LostAnswer)) {
        frame.command = Command::Idle;
        frame.address = 0;
        frame.config = {};
    } else if (answer) {
        m_lastAnswer = frame;
    }
    if (frame.command == Command::Idle && strikes(McbFault::Garbage))
        for (std::uint16_t &word : frame.config)
            word = static_cast<std::uint16_t>(random());
}

Bytes McbSpoiler::spoilOutput(Bytes output, bool whole)
{
    if (auto frame = mcb::decodeAnswer(output); frame && whole) {
        spoilAnswer(*frame);
        output = mcb::encodeFrame(*frame);
    }
    if (strikes(McbFault::Flip))
        output[random() % output.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    if (strikes(McbFault::SwapBytes))
        for (std::size_t i = 0; i + 1 < output.size(); i += 2)
            std::swap(output[i], output[i + 1]);
    if (strikes(McbFault::Glitch)) {
        do { // one in 65,536 would pass the check, and be an answer like any other
            for (std::uint8_t &byte : output)
                byte = static_cast<std::uint8_t>(random());
        } while (mcb::decodeAnswer(output));
    }
    for (const auto &[fault, level] :
        {std::pair(McbFault::DeadLow, 0x00), std::pair(McbFault::DeadHigh, 0xFF)}) {
        if (m_dead == 0 && strikes(fault)) {
            m_dead = kDeadFrames;
            m_deadLevel = static_cast<std::uint8_t>(level);
        }
    }
    if (m_dead > 0) {
        --m_dead;
        std::ranges::fill(output, m_deadLevel);
    }
    return output;
}

} // namespace simulation
