#include "mcb/dictionary.h"

#include "base/text.h"
#include "catalog/catalog.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mcb {
namespace {

using catalog::Access;
using catalog::CsvRow;
using catalog::TableError;

constexpr Word<Type> kTypes[] = {{"INT16", Type::Int16}, {"UINT16", Type::UInt16},
    {"INT32", Type::Int32}, {"UINT32", Type::UInt32}, {"FLOAT", Type::Float},
    {"STRING", Type::Text}};
constexpr Word<Cyclic> kCyclic[] = {
    {"config", Cyclic::ConfigOnly}, {"tx", Cyclic::Tx}, {"rx", Cyclic::Rx}};
constexpr Word<Access> kAccesses[] = {
    {"R", Access::Read}, {"W", Access::Write}, {"RW", Access::ReadWrite}};

/// "0x010"; kMostAddress + 1 for what is none.
unsigned addressIn(std::string_view text)
{
    constexpr unsigned kNone = kMostAddress + 1U;
    return text.starts_with("0x") ? numberIn<unsigned>(text.substr(2), 16).value_or(kNone) : kNone;
}

enum Column {
    Address,
    OlderName,
    NewerName,
    TypeName,
    Size,
    AccessName,
    CyclicName,
    EffectName,
    Unit,
    Description,
    kColumns
};
constexpr std::array<std::string_view, kColumns> kColumnNames{"address", "name_summit",
    "name_newer", "type", "size_bytes", "access", "cyclic", "effect", "unit", "description"};

class Reader {
public:
    std::optional<TableError> readHead(const CsvRow &row)
    {
        for (std::size_t i = 0; i < kColumns; ++i) {
            const auto found = std::ranges::find(row.fields, kColumnNames[i]);
            if (found == row.fields.end())
                return TableError{
                    row.line, "there is no column " + std::string(kColumnNames[i]) + '.'};
            m_place[i] = static_cast<std::size_t>(found - row.fields.begin());
        }
        return std::nullopt;
    }

    Result<Entry, TableError> readRow(const CsvRow &row) const
    {
        const std::string &address = field(row, Address);
        const unsigned number = addressIn(address);
        const auto *type = findWord(kTypes, field(row, TypeName));
        const auto *access = findWord(kAccesses, field(row, AccessName));
        const auto *cyclic = findWord(kCyclic, field(row, CyclicName));
        const std::string &size = field(row, Size);
        const unsigned bytes =
            size.empty() ? 0U : numberIn<unsigned>(size).value_or(UINT8_MAX + 1U);
        if (number > kMostAddress)
            return fail(TableError{row.line, "\"" + address + "\" is no address."});
        if (type == nullptr || access == nullptr || cyclic == nullptr || bytes > UINT8_MAX)
            return fail(TableError{row.line, "type, size, access or cyclic is not known."});
        const auto effect = catalog::effectOf(field(row, EffectName));
        if (!effect && *access != Access::Read)
            return fail(TableError{row.line, "it can be written and does not say its effect."});
        Entry entry{static_cast<std::uint16_t>(number), field(row, NewerName),
            field(row, OlderName), Info{static_cast<std::uint8_t>(bytes), *type, *cyclic, *access},
            effect.value_or(catalog::Effect::Unknown), field(row, Unit), field(row, Description)};
        if (entry.name.empty() || entry.name == entry.olderName)
            entry.name = std::exchange(entry.olderName, {});
        if (entry.name.empty())
            return fail(TableError{row.line, "a register without a name."});
        return entry;
    }

private:
    const std::string &field(const CsvRow &row, Column column) const
    {
        static const std::string kNone;
        const std::size_t place = m_place[column];
        return place < row.fields.size() ? row.fields[place] : kNone;
    }

    std::array<std::size_t, kColumns> m_place{};
};

} // namespace

Result<std::vector<Entry>, TableError> readDictionary(std::string_view csv)
{
    const auto rows = catalog::readCsv(csv);
    if (!rows)
        return fail(rows.error());
    if (rows->empty())
        return fail(TableError{1, "the table is empty."});
    Reader reader;
    if (const auto problem = reader.readHead(rows->front()))
        return fail(*problem);
    std::vector<Entry> entries;
    for (const CsvRow &row : std::span(*rows).subspan(1)) {
        auto entry = reader.readRow(row);
        if (!entry)
            return fail(entry.error());
        const auto place = std::ranges::lower_bound(entries, entry->address, {}, &Entry::address);
        if (place != entries.end() && place->address == entry->address)
            return fail(TableError{row.line, "the address of an earlier row."});
        entries.insert(place, std::move(*entry));
    }
    return entries;
}

const std::vector<Entry> &dictionary()
{
    static const std::vector<Entry> entries = [] {
        auto read = readDictionary(catalog::builtInTable("mcb"));
        return read ? std::move(*read) : std::vector<Entry>();
    }();
    return entries;
}

const Entry *findEntry(std::uint16_t address)
{
    const auto &entries = dictionary();
    const auto place = std::ranges::lower_bound(entries, address, {}, &Entry::address);
    return place != entries.end() && place->address == address ? &*place : nullptr;
}

} // namespace mcb
