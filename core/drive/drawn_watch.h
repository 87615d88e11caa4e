// Reads the watched registers one by one, on a line where nothing comes by itself: those that are drawn (Watch::drawn)
// as often as the link gives, each in its turn, the others once a period. What the build does not have is reported once
// and left out from then on. Decides only what is asked next; the owner of the link decides when.
#pragma once

#include "drive/reader.h"
#include "drive/task.h"

#include <algorithm>
#include <set>
#include <utility>

namespace drive {

template <class P>
class DrawnWatch : public Task<P> {
public:
    explicit DrawnWatch(const typename P::Facts &board)
        : m_board(board)
    {
    }

    void watch(const Watch &watch, TimePoint now)
    {
        m_watch = watch;
        m_watch.period = std::max<Duration>(m_watch.period, std::chrono::milliseconds(1));
        restart(now);
    }
    void restart(TimePoint now); ///< a new connection
    std::optional<TimePoint> due() const
    {
        const auto first = std::ranges::min_element(m_entries, {}, &Entry::due);
        return first == m_entries.end() ? std::nullopt : std::optional(first->due);
    }

    std::optional<typename P::Request> nextRequest(TimePoint now) override;
    void onResponse(const typename P::Answer &response, TimePoint now) override;
    void onNoResponse(std::optional<bool>, TimePoint) override { m_reader.onNoResponse(); }

    const std::vector<Reading> &readings() const { return m_readings; } ///< not taken yet
    std::vector<Reading> takeReadings() { return std::exchange(m_readings, {}); }

private:
    struct Entry {
        RegisterId id = 0;
        bool drawn = false;
        TimePoint due;
    };
    Entry *next(TimePoint now);

    const typename P::Facts &m_board;
    Reader<P> m_reader{m_board};
    Watch m_watch;
    std::vector<Entry> m_entries;
    std::vector<Reading> m_readings;
    TimePoint m_asked;
    unsigned m_drawnInRow = 0;
};

template <class P>
void DrawnWatch<P>::restart(TimePoint now)
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

/// The one that waits longest; where both kinds are due they take turns, three drawn ones to one of the others.
template <class P>
typename DrawnWatch<P>::Entry *DrawnWatch<P>::next(TimePoint now)
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

template <class P>
std::optional<typename P::Request> DrawnWatch<P>::nextRequest(TimePoint now)
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

template <class P>
void DrawnWatch<P>::onResponse(const typename P::Answer &response, TimePoint now)
{
    for (Reading &reading : m_reader.onResponse(response, now)) {
        // The board looked at the value somewhere between the question and the answer.
        reading.spread = now - m_asked;
        if (reading.status != ReadStatus::Ok)
            std::erase_if(m_entries, [&](const Entry &entry) { return entry.id == reading.id; });
        m_readings.push_back(std::move(reading));
    }
}

} // namespace drive
