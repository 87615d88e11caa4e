#include "recorder.h"

#include "drive/values.h"

#include <algorithm>
#include <cmath>

namespace cli {

using capture::SampleBlock;
using capture::Tick;

namespace {

/// Cuts off what is at or after `end`.
void trim(SampleBlock &block, Tick step, Tick end)
{
    std::erase_if(block.slow, [end](const capture::SlowGroup &group) { return group.tick >= end; });
    const Tick fits = std::clamp<Tick>((end - block.firstTick + step - 1) / step, 0, block.count);
    if (fits == block.count || block.count == 0)
        return;
    const std::size_t signalCount = block.fast.size() / block.count;
    std::vector<std::int16_t> fast;
    for (std::size_t s = 0; s < signalCount; ++s) {
        const auto begin = block.fast.begin() + static_cast<std::ptrdiff_t>(s * block.count);
        fast.insert(fast.end(), begin, begin + fits);
    }
    block.fast = std::move(fast);
    block.count = static_cast<std::uint32_t>(fits);
}

/// The tick after the last one that the block tells about.
Tick endOf(const SampleBlock &block, Tick step)
{
    Tick end = block.firstTick + Tick{block.count} * step;
    if (!block.slow.empty())
        end = std::max(end, block.slow.back().tick + 1);
    return end;
}

} // namespace

void Recorder::accept(const drive::Event &event)
{
    if (const auto *started = std::get_if<drive::StreamStarted>(&event)) {
        if (m_origin || started->layout.empty())
            return;
        m_layout = started->layout;
        m_layout.originSeconds = 0.0; // its ticks will be counted from the first sample
        m_length = std::max<Tick>(1, std::llround(m_seconds * m_layout.tickHz));
    } else if (const auto *block = std::get_if<SampleBlock>(&event)) {
        if (!m_complete && block->stream == m_layout.id && m_layout.tickHz > 0)
            onBlock(*block);
    } else if (const auto *read = std::get_if<drive::RegistersRead>(&event)) {
        for (const drive::Reading &reading : read->readings)
            onReading(reading);
    }
}

void Recorder::poll(
    std::vector<catalog::RegisterId> registers, std::shared_ptr<const catalog::Catalog> catalog)
{
    m_polled = std::move(registers);
    m_catalog = std::move(catalog);
}

void Recorder::onReading(const drive::Reading &reading)
{
    const auto value = drive::asNumber(reading.value);
    if (!m_catalog || m_complete || reading.status != drive::ReadStatus::Ok || !value
        || std::find(m_polled.begin(), m_polled.end(), reading.id) == m_polled.end())
        return;
    const double at = toSeconds(reading.at.time_since_epoch());
    if (!m_firstSeconds)
        m_firstSeconds = at;
    m_complete = at - *m_firstSeconds >= m_seconds;
    if (m_complete)
        return;
    m_recorded_s = at - *m_firstSeconds;
    m_spread = std::max(m_spread, toSeconds(reading.spread));
    const catalog::Scale scale = m_catalog->readScale(reading.id);
    m_capture.appendPolled(reading.id, m_catalog->nameOf(reading.id), scale.unit,
        at - *m_firstSeconds, *value * scale.factor);
    if (reading.id == m_polled.front())
        ++m_polledValues;
}

double Recorder::valuesPerSecond() const
{
    const double time_s = recordedSeconds();
    return time_s > 0.0 ? static_cast<double>(m_polledValues) / time_s : 0.0;
}

QString Recorder::lostText() const
{
    if (m_layout.ticksAreControlPeriods || !(m_layout.tickHz > 0.0))
        return QStringLiteral("%1 control periods").arg(m_lost);
    constexpr double kMilli = 1e3;
    return QStringLiteral("%1 ms").arg(
        QString::number(static_cast<double>(m_lost) / m_layout.tickHz * kMilli, 'f', 1));
}

std::vector<capture::ChannelId> Recorder::channels() const
{
    std::vector<capture::ChannelId> found = m_capture.streaming();
    for (const catalog::RegisterId id : m_polled)
        if (const auto channel = m_capture.find(id))
            found.push_back(*channel);
    return found;
}

void Recorder::onBlock(SampleBlock block)
{
    if (!m_origin) {
        m_origin = block.firstTick;
        block.lostTicks = 0; // before the beginning
        m_capture.begin(m_layout);
    }
    block.firstTick -= *m_origin;
    for (capture::SlowGroup &group : block.slow)
        group.tick -= *m_origin;
    if (block.lostTicks > 0)
        m_lost += std::max<Tick>(
            0, std::min(block.firstTick, m_length) - (block.firstTick - block.lostTicks));
    const Tick step = m_layout.fastStep;
    m_complete = endOf(block, step) >= m_length;
    m_recorded_s = static_cast<double>(endOf(block, step)) / m_layout.tickHz;
    trim(block, step, m_length);
    if (block.count > 0 || !block.slow.empty())
        m_capture.append(block);
}

} // namespace cli
