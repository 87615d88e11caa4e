// Makes the tables that an identification reads small and ready-made: a drive reads them at each connection, which
// would be most of what a run of the drive targets costs. Linked to these targets alone, with --wrap. What is left out
// is only more of the same: everything that can move or harm something stays, and of the rest every sixth register.
#include "catalog/catalog.h"
#include "mcb/dictionary.h"

#include <map>
#include <tuple>

namespace {

using Table = Result<std::vector<catalog::RegisterInfo>, catalog::TableError>;

bool stays(const catalog::RegisterInfo &info, std::size_t at)
{
    constexpr std::size_t kOneIn = 6;
    return info.dangerous || info.setPoint != catalog::SetPoint::None || at % kOneIn == 0;
}

} // namespace

// The names that the linker gives the function and what stands in for it.
Table readWhole(std::string_view csv, std::string_view family, std::uint32_t version) __asm__(
    "__real__ZN7catalog9readTableESt17basic_string_viewIcSt11char_traitsIcEES3_j");
Table readFew(std::string_view csv, std::string_view family, std::uint32_t version) __asm__(
    "__wrap__ZN7catalog9readTableESt17basic_string_viewIcSt11char_traitsIcEES3_j");

Table readFew(std::string_view csv, std::string_view family, std::uint32_t version)
{
    static std::map<std::tuple<const char *, std::string, std::uint32_t>, Table> known;
    const auto key = std::tuple(csv.data(), std::string(family), version);
    const auto at = known.find(key);
    if (at != known.end())
        return at->second;
    Table whole = readWhole(csv, family, version);
    std::vector<catalog::RegisterInfo> few;
    for (std::size_t i = 0; whole && i < whole->size(); ++i)
        if (stays((*whole)[i], i))
            few.push_back((*whole)[i]);
    return known.emplace(key, std::move(few)).first->second;
}

const std::vector<mcb::Entry> &wholeDictionary() __asm__("__real__ZN3mcb10dictionaryEv");
const std::vector<mcb::Entry> &fewEntries() __asm__("__wrap__ZN3mcb10dictionaryEv");

/// State, set-points, measurements and identity, and a few of what lies between them.
const std::vector<mcb::Entry> &fewEntries()
{
    static const std::vector<mcb::Entry> few = [] {
        constexpr std::size_t kOneIn = 12;
        std::vector<mcb::Entry> kept;
        for (std::size_t i = 0; i < wholeDictionary().size(); ++i) {
            const mcb::Entry &entry = wholeDictionary()[i];
            const bool needed = entry.address < 0x034 || entry.address == 0x100
                || entry.address == 0x106 || entry.address == 0x1E0 || entry.address == 0x1E8
                || entry.address == 0x388 || entry.address == 0x71F
                || (entry.address >= 0x640 && entry.address < 0x6F0);
            if (needed || i % kOneIn == 0)
                kept.push_back(entry);
        }
        return kept;
    }();
    return few;
}
