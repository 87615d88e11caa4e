#include "session/recording/tap.h"

#include <QDateTime>

#include <algorithm>
#include <chrono>

namespace session {

namespace {

/// About what an entry holds in memory.
std::size_t sizeOf(const recorded::Entry &entry)
{
    constexpr std::size_t kSmall = 256;
    if (const auto *block = std::get_if<capture::SampleBlock>(&entry))
        return kSmall + block->fast.size() * 2 + block->slow.size() * 64;
    if (const auto *link = std::get_if<recorded::LinkBytes>(&entry))
        return kSmall + link->bytes.size();
    if (const auto *polled = std::get_if<recorded::PolledValues>(&entry))
        return kSmall + polled->values.size() * sizeof(recorded::PolledValue);
    if (const auto *happening = std::get_if<recorded::Happening>(&entry))
        return kSmall + happening->fields.size() * 128;
    return kSmall;
}

} // namespace

void RecordingTap::switchOn(unsigned recording, Content content)
{
    m_content = content;
    m_recording = recording;
}

std::int64_t RecordingTap::startSeconds() const
{
    if (!m_clock)
        return 0;
    const auto since = std::chrono::floor<std::chrono::seconds>(m_clock().time_since_epoch());
    return QDateTime::currentSecsSinceEpoch() - since.count();
}

void RecordingTap::onEvent(const drive::Event &event, TimePoint now)
{
    // A new recording hears the state from before this event first.
    if (isOn() && m_toldState != m_recording)
        tell({}, now);
    if (const auto *started = std::get_if<drive::StreamStarted>(&event)) {
        m_step = started->layout.fastStep;
        m_dropping = false;
    }
    // Samples are copied only if they are wanted.
    if (!isOn() && std::holds_alternative<capture::SampleBlock>(event))
        return;
    tell(m_entries.accept(event), now);
}

void RecordingTap::onWish(const drive::Wish &wish, TimePoint now)
{
    tell(m_entries.accept(wish), now);
}

void RecordingTap::onLink(recorded::LinkBytes::Direction direction, ByteView bytes, TimePoint now)
{
    if (isOn() && m_content == Content::SamplesAndLink)
        tell({recorded::LinkBytes{direction, Bytes(bytes.begin(), bytes.end())}}, now);
}

void RecordingTap::tell(std::vector<recorded::Entry> entries, TimePoint now)
{
    const unsigned recording = m_recording;
    if (recording == 0)
        return;
    if (m_toldState != recording) {
        m_toldState = recording;
        m_lost = {};
        m_untold.clear();
        std::vector<recorded::Entry> state = m_entries.state();
        std::move(entries.begin(), entries.end(), std::back_inserter(state));
        entries = std::move(state);
    }
    if (entries.empty())
        return;
    addUntold(entries);
    std::size_t bytes = 0;
    for (const recorded::Entry &entry : entries)
        bytes += sizeOf(entry);
    if (m_waiting + bytes > m_mostWaiting)
        return drop(entries);
    send(std::move(entries), bytes, now);
}

void RecordingTap::send(std::vector<recorded::Entry> entries, std::size_t bytes, TimePoint now)
{
    for (recorded::Entry &entry : entries) {
        auto *block = std::get_if<capture::SampleBlock>(&entry);
        if (!block)
            continue;
        if (m_dropping)
            block->lostTicks = std::max(block->lostTicks, block->firstTick - m_streamEnd);
        m_dropping = false;
        m_streamEnd =
            block->firstTick + std::max<capture::Tick>(1, capture::Tick{block->count} * m_step);
    }
    if (m_lost != recorded::Lost{})
        entries.insert(entries.begin(), std::exchange(m_lost, {}));
    const std::size_t before = m_waiting.fetch_add(bytes), many = m_mostWaiting / 4;
    Q_EMIT told(std::make_shared<const Told>(
        Told{m_recording, now.time_since_epoch().count(), std::move(entries), bytes}));
    // The recorder switches off first and then takes what was told: one of the two sees the other.
    if (!isOn() || (before < many && before + bytes >= many))
        Q_EMIT dueNow();
}

void RecordingTap::drop(const std::vector<recorded::Entry> &entries)
{
    for (const recorded::Entry &entry : entries) {
        if (const auto *block = std::get_if<capture::SampleBlock>(&entry)) {
            m_lost.samples += capture::samplesOf(*block);
            m_dropping = true;
        } else if (const auto *link = std::get_if<recorded::LinkBytes>(&entry)) {
            m_lost.linkBytes += link->bytes.size();
        } else {
            ++m_lost.others;
            if (std::holds_alternative<capture::StreamLayout>(entry)
                || std::holds_alternative<recorded::PolledRegister>(entry))
                m_untold = m_entries.descriptions();
        }
    }
}

void RecordingTap::addUntold(std::vector<recorded::Entry> &entries)
{
    const bool newer = std::ranges::any_of(entries, [](const recorded::Entry &entry) {
        return std::holds_alternative<capture::StreamLayout>(entry);
    });
    if (!newer)
        entries.insert(entries.begin(), m_untold.begin(), m_untold.end());
    m_untold.clear();
}

Parts listened(Parts parts, std::shared_ptr<SessionTap> tap)
{
    parts.taps.push_back(std::move(tap));
    return parts;
}

Parts tapped(const Parts &parts, const std::shared_ptr<RecordingTap> &tap)
{
    tap->setClock(parts.clock);
    return listened(parts, tap);
}

} // namespace session
