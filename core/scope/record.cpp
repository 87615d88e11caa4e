#include "scope/record.h"

#include <algorithm>

namespace scope {

RecordHistory::RecordHistory(std::size_t capacity)
    : m_capacity(std::max<std::size_t>(capacity, 1))
{
}

std::vector<Record>::iterator RecordHistory::position(RecordId id)
{
    return std::ranges::find(m_records, id, &Record::id);
}

const Record *RecordHistory::find(RecordId id) const
{
    const auto at = std::ranges::find(m_records, id, &Record::id);
    return at != m_records.end() ? &*at : nullptr;
}

void RecordHistory::add(Record record)
{
    if (const auto same = position(record.id); same != m_records.end()) {
        *same = std::move(record);
        return;
    }
    if (m_records.size() >= m_capacity) {
        const auto oldest =
            std::ranges::find_if(m_records, [](const Record &one) { return !one.pinned; });
        if (oldest != m_records.end())
            m_records.erase(oldest);
    }
    m_records.push_back(std::move(record));
}

bool RecordHistory::setPinned(RecordId id, bool pinned)
{
    const auto at = position(id);
    if (at == m_records.end())
        return false;
    const auto others = static_cast<std::size_t>(std::ranges::count_if(
        m_records, [id](const Record &one) { return one.pinned && one.id != id; }));
    if (pinned && others + 1 >= m_capacity)
        return false;
    at->pinned = pinned;
    return true;
}

bool RecordHistory::setLabel(RecordId id, std::string_view label)
{
    const auto at = position(id);
    if (at == m_records.end())
        return false;
    std::size_t length = std::min(label.size(), kLabelBytes);
    // A byte 10xxxxxx continues a character.
    while (length > 0 && length < label.size()
        && (static_cast<unsigned char>(label[length]) & 0xC0U) == 0x80U)
        --length;
    at->label.assign(label.substr(0, length));
    return true;
}

void RecordHistory::clear() { m_records.clear(); }

bool RecordHistory::release(Nanos oldest)
{
    bool changed = std::erase_if(m_records, [oldest](const Record &one) {
        return !one.pinned && one.to <= oldest;
    }) > 0;
    for (Record &one : m_records) {
        if (one.to <= oldest && one.state != Record::State::Released) {
            one.state = Record::State::Released;
            changed = true;
        }
    }
    return changed;
}

} // namespace scope
