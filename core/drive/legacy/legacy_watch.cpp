#include "drive/legacy/legacy_watch.h"

#include <algorithm>
#include <set>

namespace drive {

void LegacyWatch::watch(const Watch &watch, TimePoint now)
{
    m_watch = watch;
    m_watch.period = std::max<Duration>(m_watch.period, std::chrono::milliseconds(1));
    restart(now);
}

void LegacyWatch::restart(TimePoint now)
{
    m_reader.clear();
    m_readings.clear();
    m_entries.clear();
    std::set<RegisterId> seen;
    for (const auto *list : {&m_watch.drawn, &m_watch.registers})
        for (const RegisterId id : *list)
            if (!m_board.missing.contains(id) && seen.insert(id).second)
                m_entries.push_back({id, list == &m_watch.drawn, now});
}

std::optional<TimePoint> LegacyWatch::due() const
{
    std::optional<TimePoint> first;
    for (const Entry &entry : m_entries)
        if (!first || entry.due < *first)
            first = entry.due;
    return first;
}

/// The one that waits longest; where both kinds are due they take turns, three drawn ones to one of the others.
LegacyWatch::Entry *LegacyWatch::next(TimePoint now)
{
    Entry *drawn = nullptr, *other = nullptr;
    for (Entry &entry : m_entries) {
        Entry *&best = entry.drawn ? drawn : other;
        if (entry.due <= now && (best == nullptr || entry.due < best->due))
            best = &entry;
    }
    constexpr unsigned kDrawnToOne = 3;
    if (drawn == nullptr || (other != nullptr && m_drawnInRow >= kDrawnToOne)) {
        m_drawnInRow = 0;
        return other;
    }
    ++m_drawnInRow;
    return drawn;
}

std::optional<legacy::Request> LegacyWatch::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        Entry *entry = next(now);
        if (entry == nullptr)
            return std::nullopt;
        entry->due = entry->drawn ? now : now + m_watch.period;
        m_reader.start({entry->id});
    }
    m_asked = now;
    return m_reader.nextRequest();
}

void LegacyWatch::takeResponse(const legacy::Reply &response, TimePoint now)
{
    for (Reading &reading : m_reader.takeResponse(response, now)) {
        // The board looked at the value somewhere between the question and the answer.
        reading.spread = now - m_asked;
        if (reading.status != ReadStatus::Ok)
            std::erase_if(m_entries, [&](const Entry &entry) { return entry.id == reading.id; });
        m_readings.push_back(std::move(reading));
    }
}

void LegacyWatch::takeNoResponse(std::optional<bool>, TimePoint) { m_reader.takeNoResponse(); }

} // namespace drive
