#include "session/link/batcher.h"

#include <algorithm>
#include <unordered_set>

namespace session {

namespace {

capture::Tick endOf(const capture::SampleBlock &block, capture::Tick step)
{
    return block.firstTick + std::max<capture::Tick>(1, capture::Tick{block.count} * step);
}

} // namespace

void Batcher::add(drive::Event event)
{
    if (auto *block = std::get_if<capture::SampleBlock>(&event))
        return addBlock(std::move(*block));
    if (const auto *started = std::get_if<drive::StreamStarted>(&event)) {
        m_streams.clear();
        if (!started->layout.empty())
            m_streams[started->layout.id].step = started->layout.fastStep;
    }
    if (auto *readings = std::get_if<drive::RegistersRead>(&event))
        return addReadings(std::move(*readings));
    if (!behind()) {
        m_waiting.push_back(std::move(event));
        return;
    }
    if (const auto *status = std::get_if<drive::MotorStatus>(&event)) {
        const int motor = status->motor;
        return replace(std::move(event), [motor](const drive::Event &old) {
            const auto *other = std::get_if<drive::MotorStatus>(&old);
            return other && other->motor == motor;
        });
    }
    if (std::holds_alternative<drive::LinkCounters>(event)) {
        return replace(std::move(event), [](const drive::Event &old) {
            return std::holds_alternative<drive::LinkCounters>(old);
        });
    }
    if (std::holds_alternative<drive::LinkChanged>(event)) {
        const auto isChange = [](const drive::Event &old) {
            return std::holds_alternative<drive::LinkChanged>(old);
        };
        const auto count = std::ranges::count_if(m_waiting, isChange);
        if (static_cast<std::size_t>(count) >= m_config.maxLinkChanges)
            m_waiting.erase(std::ranges::find_if(m_waiting, isChange));
    }
    m_waiting.push_back(std::move(event));
}

void Batcher::addBlock(capture::SampleBlock block)
{
    Stream &stream = m_streams[block.stream];
    const std::size_t values = samplesOf(block);
    if (behind() && m_waitingValues + values > m_config.maxWaitingValues) {
        m_dropped += values;
        stream.dropping = true;
        return;
    }
    if (stream.dropping) {
        block.lostTicks = std::max(block.lostTicks, block.firstTick - stream.end);
        stream.dropping = false;
    }
    stream.end = endOf(block, stream.step);
    m_waitingValues += values;
    m_waiting.push_back(std::move(block));
}

void Batcher::addReadings(drive::RegistersRead event)
{
    m_waitingReadings += event.readings.size();
    if (behind() && m_waitingReadings > m_config.maxWaitingReadings)
        dropOlderThan(event);
    auto *last = m_waiting.empty() ? nullptr : std::get_if<drive::RegistersRead>(&m_waiting.back());
    if (last) // what came together is told together
        last->readings.insert(last->readings.end(), event.readings.begin(), event.readings.end());
    else
        m_waiting.push_back(std::move(event));
}

void Batcher::dropOlderThan(const drive::RegistersRead &event)
{
    std::unordered_set<drive::RegisterId> fresh;
    for (const drive::Reading &reading : event.readings)
        fresh.insert(reading.id);
    for (drive::Event &old : m_waiting) {
        if (auto *readings = std::get_if<drive::RegistersRead>(&old))
            m_waitingReadings -= std::erase_if(
                readings->readings, [&](const drive::Reading &r) { return fresh.contains(r.id); });
    }
    std::erase_if(m_waiting, [](const drive::Event &old) {
        const auto *readings = std::get_if<drive::RegistersRead>(&old);
        return readings && readings->readings.empty();
    });
}

template <class Same>
void Batcher::replace(drive::Event event, Same same)
{
    std::erase_if(m_waiting, same);
    m_waiting.push_back(std::move(event));
}

std::optional<TimePoint> Batcher::due() const
{
    if (m_waiting.empty() || behind())
        return std::nullopt;
    return m_notBefore;
}

BatchPtr Batcher::take(TimePoint now)
{
    if (m_waiting.empty() || behind() || now < m_notBefore)
        return nullptr;
    // A timer fires late by up to a millisecond: were that added each time, the pace would fall behind that of a
    // screen.
    const Duration late = now - m_notBefore;
    const Duration period = m_calm ? m_config.calmPeriod : m_config.period;
    m_notBefore = now + period - (late <= period / 4 ? late : Duration::zero());
    return hand();
}

BatchPtr Batcher::hand()
{
    auto batch = std::make_shared<Batch>();
    batch->events = std::move(m_waiting);
    batch->droppedForDisplay = m_dropped;
    m_waiting.clear();
    m_waitingValues = 0;
    m_waitingReadings = 0;
    ++m_unacknowledged;
    return batch;
}

} // namespace session
