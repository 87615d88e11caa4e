#include "recorded/coverage.h"

#include <algorithm>

namespace recorded {

void Coverage::accept(const Entry &entry)
{
    if (const auto *layout = std::get_if<capture::StreamLayout>(&entry)) {
        m_layout = *layout;
    } else if (const auto *block = std::get_if<capture::SampleBlock>(&entry)) {
        accept(*block);
    } else if (const auto *polled = std::get_if<PolledValues>(&entry)) {
        for (const PolledValue &value : polled->values)
            extend(value.id, capture::ChannelInfo::Kind::Polled, value.at, value.at);
    }
}

void Coverage::accept(const capture::SampleBlock &block)
{
    if (block.stream != m_layout.id)
        return;
    const auto base = capture::TickBase::of(m_layout.tickHz, m_layout.originSeconds);
    if (block.count > 0) {
        const Nanos first = base.timeOf(block.firstTick);
        const Nanos last = base.timeOf(
            block.firstTick + static_cast<capture::Tick>(block.count - 1) * m_layout.fastStep);
        for (const capture::StreamSignal &signal : m_layout.fast)
            extend(signal.id, capture::ChannelInfo::Kind::Fast, first, last);
    }
    if (block.slow.empty())
        return;
    const Nanos first = base.timeOf(block.slow.front().tick);
    const Nanos last = base.timeOf(block.slow.back().tick);
    for (const capture::StreamSignal &signal : m_layout.slow)
        extend(signal.id, capture::ChannelInfo::Kind::Slow, first, last);
}

void Coverage::extend(RegisterId id, capture::ChannelInfo::Kind kind, Nanos first, Nanos last)
{
    const auto [place, isNew] = m_spans.try_emplace({id, kind}, Span{first, last});
    if (isNew)
        return;
    place->second.first = std::min(place->second.first, first);
    place->second.last = std::max(place->second.last, last);
}

bool Coverage::holds(const capture::Capture &capture) const
{
    if (capture.clockMoved())
        return false;
    for (const capture::ChannelInfo &info : capture.channels()) {
        const capture::Channel &channel = *capture.channel(info.id);
        if (channel.empty() || !info.isBoards())
            continue;
        const auto span = m_spans.find({info.registerId, info.kind});
        if (span == m_spans.end() || channel.timeOf(channel.begin()) < span->second.first
            || channel.timeOf(channel.end() - 1) > span->second.last)
            return false;
    }
    return true;
}

} // namespace recorded
