#include "snapshots/snapshot.h"

#include <algorithm>
#include <cmath>

namespace snapshots {

namespace {

/// Looks for entries that come in about the order they stand in: begins where the last one was found.
class Finder {
public:
    explicit Finder(const std::vector<Entry> &entries)
        : m_entries(entries)
    {
    }

    const Entry *find(const Entry &wanted)
    {
        for (std::size_t i = 0; i < m_entries.size(); ++i) {
            const std::size_t at = (m_next + i) % m_entries.size();
            if (!m_entries[at].isSame(wanted))
                continue;
            m_next = at + 1;
            return &m_entries[at];
        }
        return nullptr;
    }

private:
    const std::vector<Entry> &m_entries;
    std::size_t m_next = 0;
};

std::optional<double> shownOf(const Value &value, double factor)
{
    const auto number = catalog::asNumber(value);
    return number ? std::optional(*number * factor) : std::nullopt;
}

} // namespace

const Entry *Snapshot::find(const std::string &name, int motor) const
{
    const auto at = std::ranges::find_if(
        entries, [&](const Entry &entry) { return entry.name == name && entry.motor == motor; });
    return at == entries.end() ? nullptr : &*at;
}

bool tunable(const catalog::RegisterInfo &info) { return info.restorable(); }

std::vector<RegisterId> snapshotRegisters(const catalog::Catalog &catalog, Scope scope)
{
    std::vector<RegisterId> ids;
    for (const catalog::RegisterInfo &info : catalog.registers()) {
        const bool wanted = scope == Scope::All ? info.readable() && !info.stub : tunable(info);
        for (int motor = 1; wanted && motor <= (info.perMotor ? catalog.motors() : 1); ++motor)
            ids.push_back(catalog.withMotor(info, motor));
    }
    return ids;
}

Snapshot snapshotOf(const drive::Identity &board, const catalog::Catalog &catalog,
    const std::vector<drive::Reading> &readings)
{
    Snapshot snapshot;
    snapshot.board = board;
    for (const drive::Reading &reading : readings) {
        const catalog::RegisterInfo *info = catalog.find(reading.id);
        if (info == nullptr || reading.status != drive::ReadStatus::Ok)
            continue;
        const catalog::Scale scale = catalog.readScale(reading.id);
        snapshot.entries.push_back({.name = info->name,
            .motor = catalog.motorOf(reading.id),
            .id = reading.id,
            .group = info->group,
            .type = info->type,
            .tunable = tunable(*info),
            .value = reading.value,
            .shown = shownOf(reading.value, scale.factor),
            .unit = scale.unit});
    }
    return snapshot;
}

bool sameValue(const Value &a, const Value &b)
{
    const auto *x = std::get_if<double>(&a), *y = std::get_if<double>(&b);
    if (x != nullptr && y != nullptr && std::isnan(*x))
        return std::isnan(*y);
    return a == b;
}

Selection::Selection(std::vector<std::string> names)
    : m_names(std::move(names))
{
}

namespace {

bool fits(const std::string &wanted, const Entry &entry)
{
    const std::string upperName = catalog::upper(wanted), name = catalog::upper(entry.name);
    return upperName == catalog::upper(entry.group) || upperName == name
        || upperName == name + "@" + std::to_string(entry.motor);
}

} // namespace

bool Selection::takes(const Entry &entry) const
{
    return m_names.empty()
        || std::ranges::any_of(m_names, [&](const std::string &name) { return fits(name, entry); });
}

std::vector<std::string> Selection::unmatched(const Snapshot &snapshot) const
{
    std::vector<std::string> names;
    for (const std::string &name : m_names)
        if (std::ranges::none_of(
                snapshot.entries, [&](const Entry &entry) { return fits(name, entry); }))
            names.push_back(name);
    return names;
}

std::vector<Difference> differences(
    const Snapshot &a, const Snapshot &b, Scope scope, const Selection &selection)
{
    const auto wanted = [&](const Entry &entry) {
        return (scope == Scope::All || entry.tunable) && selection.takes(entry);
    };
    std::vector<Difference> list;
    Finder inB(b.entries), inA(a.entries);
    for (const Entry &entry : a.entries) {
        const Entry *other = wanted(entry) ? inB.find(entry) : &entry;
        if (other == nullptr || !sameValue(entry.value, other->value))
            list.push_back({&entry, other});
    }
    for (const Entry &entry : b.entries)
        if (wanted(entry) && inA.find(entry) == nullptr)
            list.push_back({nullptr, &entry});
    return list;
}

} // namespace snapshots
