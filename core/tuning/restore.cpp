#include "tuning/restore.h"

#include <algorithm>

namespace tuning {

namespace {

/// POSITION_RAMP comes back swapped in 6.1 and 6.2, BEMF_ADC_CONF in other units (protocol-notes.md).
bool readsDifferently(const Entry &entry)
{
    return entry.name == "POSITION_RAMP" || entry.name == "BEMF_ADC_CONF";
}

/// A value as the board takes it: TORQUE_RAMP is read as s16, u16 and written as s32, u16.
Value writableForm(const Entry &entry)
{
    const auto *bytes = std::get_if<Bytes>(&entry.value);
    if (entry.name != "TORQUE_RAMP" || bytes == nullptr || bytes->size() != 4)
        return entry.value;
    ByteReader reader(*bytes);
    const std::int16_t digits = reader.s16();
    return ByteWriter().s32(digits).u16(reader.u16()).take();
}

/// The smaller, the earlier.
int rankOf(const catalog::RegisterInfo &info)
{
    if (info.name == "CONTROL_MODE")
        return 5;
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
    for (const Difference &difference : differences(wanted, now, Scope::Tunable, selection)) {
        if (difference.a == nullptr)
            continue; // the snapshot says nothing of it
        const Entry &entry = *difference.a;
        const auto leave = [&](NotRestored why) {
            plan.left.push_back({nameOf(entry, catalog), why});
        };
        const Entry *there = difference.b;
        const catalog::RegisterInfo *info = there != nullptr ? catalog.find(there->id) : nullptr;
        if (info == nullptr || !tunable(*info))
            leave(NotRestored::NotOnBoard);
        else if (info->type != entry.type)
            leave(NotRestored::OtherType);
        else if (info->dangerous
            && std::find(moving.begin(), moving.end(), entry.motor) != moving.end())
            leave(NotRestored::MotorMoves);
        else if (readsDifferently(entry))
            leave(NotRestored::ReadsDifferently);
        else
            ranked.push_back({rankOf(*info), {there->id, writableForm(entry)}});
    }
    std::stable_sort(ranked.begin(), ranked.end(),
        [](const Ranked &x, const Ranked &y) { return x.rank < y.rank; });
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

} // namespace tuning
