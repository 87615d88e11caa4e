// Out of step: finding the length of the slave's frames again, or that there is no slave.
#include "mcb/master.h"

#include <algorithm>
#include <utility>

namespace mcb {
namespace {

constexpr int kMostProbes = 4; ///< the same length has to come twice

/// Bytes of the shortest whole frame of a slave at the beginning; nothing if there is none.
std::optional<std::size_t> lengthIn(ByteView received)
{
    for (std::size_t length = kConfigFrameBytes; length <= received.size(); length += 2) {
        if (decodeAnswer(received.first(length)))
            return length;
    }
    return std::nullopt;
}

} // namespace

void Master::seek(TimePoint now)
{
    ++m_stats.searches;
    m_wasCyclic = m_state == State::Cyclic;
    const bool switching = m_operation && m_operation->request.command == Command::Write
        && m_operation->request.address == kStateRegister && m_operation->sent > 0;
    if (switching && !m_doubtful)
        m_doubtful = m_operation->request;
    if (m_doubtful)
        m_operation.reset();
    else if (m_operation) // which may be a step of the mapping
        end(m_operation->sent > 0 ? End::Unknown : End::NotSent, now, {}, 0, m_lastBad);
    if (m_met)
        m_events.emplace_back(Searching{});
    m_state = State::Seeking;
    m_probes = 0;
    m_probed.reset();
    m_bad = m_torn = m_drain = 0;
    m_notBefore = now + m_config.quiet;
}

void Master::onProbe(ByteView received, TimePoint now)
{
    m_notBefore = now + m_config.quiet;
    const auto length = lengthIn(received);
    if (length && m_probed == length)
        return found((*length - kConfigFrameBytes) / 2, now);
    m_probed = length;
    if (++m_probes < kMostProbes)
        return;
    const auto all = [&](std::uint8_t value) {
        return !received.empty()
            && std::ranges::all_of(received, [=](auto b) { return b == value; });
    };
    lose(received.empty() ? Cause::NoAnswer
            : all(0x00)   ? Cause::DeadLow
            : all(0xFF)   ? Cause::DeadHigh
                          : Cause::Garbage,
        now);
}

void Master::found(std::size_t words, TimePoint now)
{
    m_words = words;
    m_state = words > 0 ? State::Cyclic : State::Config;
    const bool ours = words > 0 && m_met && words == m_mapping.words();
    const auto doubtful = std::exchange(m_doubtful, std::nullopt);
    if (doubtful) {
        const bool on = doubtful->words.front() == kCyclicState;
        m_operation = Operation{};
        m_operation->request = *doubtful;
        m_events.emplace_back(Back{});
        if (on == (words > 0) && (!on || ours))
            return end(End::Ok, now); // it had been carried out
        if (on || ours)
            return end(End::NotSent, now, {}, 0, Cause::Damaged);
        end(End::Unknown, now, {}, 0, Cause::Damaged);
    }
    if (ours && m_wasCyclic) {
        m_events.emplace_back(Back{});
        return;
    }
    if (words > 0) { // of another program, or ours from before: zeros are the safe choice
        m_way = Way::Leave;
        m_steps = {{kStateRegister, {mcb::kConfigState}}};
        m_step = 0;
        m_period = std::chrono::milliseconds(1);
        m_cycleStart = now;
        m_nextTick = 0;
        m_cyclicOutput.clear();
        return begin({Command::Write, kStateRegister, m_steps[0].words, true});
    }
    if (m_met && !(m_wasCyclic && m_leaving))
        m_events.emplace_back(Back{m_wasCyclic});
    else
        meet();
}

/// Also a slave that is not in the state in which it was left: nothing that was known of it holds.
void Master::meet()
{
    if (std::exchange(m_met, true))
        m_events.emplace_back(Lost{m_lastBad});
    m_events.emplace_back(Met{});
}

void Master::lose(Cause cause, TimePoint now)
{
    m_exchange.reset();
    if (m_doubtful) {
        m_operation = Operation{};
        m_operation->request = *std::exchange(m_doubtful, std::nullopt);
        m_operation->sent = 1;
    }
    const Way way = m_way;
    if (m_operation && way != Way::Leave)
        end(m_operation->sent > 0 ? End::Unknown : End::NotSent, now, {}, 0, cause);
    m_operation.reset();
    m_way = Way::None;
    m_state = State::Lost;
    m_events.emplace_back(Lost{cause});
}

} // namespace mcb
