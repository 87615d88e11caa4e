#include "snapshots/restore.h"

#include <algorithm>

namespace snapshots {

namespace {

/// BEMF_ADC_CONF comes back in other units (protocol-notes.md).
bool readsDifferently(const Entry &entry) { return entry.name == "BEMF_ADC_CONF"; }

/// The smaller, the earlier.
int rankOf(const catalog::RegisterInfo &info)
{
    if (info.dangerous)
        return 4;
    switch (catalog::widthOf(info.type)) {
    case 2:
        return 0; // these share a request with each other and with one of 32 bits
    case 4:
        return 1;
    case 1:
        return 2;
    default:
        return 3;
    }
}

std::string nameOf(const Entry &entry, const catalog::Catalog &catalog)
{
    return entry.motor > 0 && catalog.motors() > 1 ? entry.name + "@" + std::to_string(entry.motor)
                                                   : entry.name;
}

} // namespace

RestorePlan planRestore(const Snapshot &wanted, const Snapshot &now,
    const catalog::Catalog &catalog, const Selection &selection, const std::vector<int> &moving)
{
    struct Ranked {
        int rank;
        drive::RegisterWrite write;
    };
    std::vector<Ranked> ranked;
    RestorePlan plan;
    for (const Difference &difference : differences(wanted, now, Scope::All, selection)) {
        if (difference.a == nullptr)
            continue; // the snapshot says nothing of it
        const Entry &entry = *difference.a;
        const auto leave = [&](NotRestored why) {
            plan.left.push_back({nameOf(entry, catalog), why});
        };
        const Entry *there = difference.b;
        const catalog::RegisterInfo *info =
            there != nullptr ? catalog.find(there->id) : catalog.find(entry.name);
        const bool moves =
            info != nullptr && info->writable() && !info->stub && !info->restorable();
        if (moves && there != nullptr) // and differs
            leave(NotRestored::Moves);
        if (moves || !entry.tunable)
            continue;
        if (there == nullptr || info == nullptr || !tunable(*info))
            leave(NotRestored::NotOnBoard);
        else if (info->type != entry.type)
            leave(NotRestored::OtherType);
        else if (info->dangerous && std::ranges::find(moving, entry.motor) != moving.end())
            leave(NotRestored::MotorMoves);
        else if (readsDifferently(entry))
            leave(NotRestored::ReadsDifferently);
        else
            ranked.push_back({rankOf(*info), {there->id, entry.value}});
    }
    std::ranges::stable_sort(ranked, {}, &Ranked::rank);
    for (Ranked &one : ranked)
        plan.writes.push_back(std::move(one.write));
    return plan;
}

std::vector<std::string> otherHardware(const drive::Identity &wanted, const drive::Identity &now)
{
    std::vector<std::string> names;
    if (wanted.controlBoard != now.controlBoard)
        names.push_back(wanted.controlBoard);
    for (const auto &[theirs, ours] : {std::pair{&wanted.powerBoards, &now.powerBoards},
             std::pair{&wanted.motorNames, &now.motorNames}})
        for (std::size_t i = 0; i < theirs->size(); ++i)
            if (i >= ours->size() || (*theirs)[i] != (*ours)[i])
                names.push_back((*theirs)[i]);
    return names;
}

} // namespace snapshots
