// The register table: rows of text to RegisterInfo. Columns are found by their names in the first
// row, so their order is free and unknown ones are passed over. Meaning of the columns:
// resources/registers/README.md.
#include "base/text.h"
#include "catalog/catalog.h"
#include "catalog/csv.h"

#include <algorithm>
#include <array>

namespace catalog {

namespace {

constexpr Word<ValueType> kTypes[] = {{"u8", ValueType::U8}, {"s8", ValueType::S8},
    {"u16", ValueType::U16}, {"s16", ValueType::S16}, {"u32", ValueType::U32},
    {"s32", ValueType::S32}, {"f32", ValueType::F32}, {"string", ValueType::Text},
    {"raw", ValueType::Raw}};
constexpr Word<Meaning> kMeanings[] = {{"number", Meaning::Number},
    {"enumeration", Meaning::Enumeration}, {"flags", Meaning::Flags},
    {"boolean", Meaning::Boolean}};
constexpr Word<Quantity> kQuantities[] = {{"plain", Quantity::Plain},
    {"current", Quantity::Current}, {"voltage", Quantity::Voltage}, {"angle", Quantity::Angle},
    {"speed", Quantity::SpeedTenthHz}, {"frequency", Quantity::Frequency}};
constexpr Word<Gain> kGains[] = {
    {"", Gain::None}, {"numerator", Gain::Numerator}, {"exponent", Gain::Exponent}};
constexpr Word<bool> kScopes[] = {{"motor", true}, {"global", false}};

struct AccessWord {
    Access access;
    bool stub = false;
    bool streamOnly = false;
};
constexpr Word<AccessWord> kAccesses[] = {{"R", {Access::Read}}, {"W", {Access::Write}},
    {"RW", {Access::ReadWrite}}, {"R-setnoop", {Access::Read}},
    {"datalog-only", {Access::None, false, true}}, {"stub", {Access::ReadWrite, true}},
    {"stub-RO", {Access::Read, true}}, {"setnoop", {Access::None}}, {"none", {Access::None}}};

std::vector<std::string_view> split(std::string_view text, char separator)
{
    std::vector<std::string_view> parts;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(separator), text.size());
        parts.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return parts;
}

/// "6.2" or "6.1.2" as an inclusive range of 0xMMmmpp.
struct VersionRange {
    std::uint32_t first = 0, last = 0;
};
std::optional<VersionRange> versions(std::string_view text)
{
    const auto parts = split(text, '.');
    if (parts.empty() || parts.size() > 3)
        return std::nullopt;
    VersionRange range;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto part =
            i < parts.size() ? numberIn<std::uint8_t>(parts[i]) : std::optional<std::uint8_t>(0);
        if (!part)
            return std::nullopt;
        range.first = range.first << 8 | *part;
        range.last = range.last << 8 | (i < parts.size() ? *part : 0xFFU);
    }
    return range;
}

enum Column : std::size_t {
    Family,
    Name,
    Aliases,
    IdHex,
    Format,
    Scope,
    AccessColumn,
    Unit,
    QuantityColumn,
    MeaningColumn,
    Group,
    Dangerous,
    Datalog,
    Since,
    Until,
    Description,
    GainColumn, // this and what follows may be missing: empty then
    LimitsColumn,
    EffectColumn,
    ColumnCount
};
constexpr std::size_t kMissing = std::string_view::npos;
constexpr std::array<std::string_view, ColumnCount> kColumns{"family", "name", "aliases", "id_hex",
    "format", "scope", "access", "unit", "quantity", "meaning", "group", "dangerous", "datalog",
    "since", "until", "description", "gain", "limits", "effect"};

class TableReader {
public:
    Result<void, TableError> readHeader(const CsvRow &header)
    {
        for (std::size_t column = 0; column < ColumnCount; ++column) {
            const auto at = std::find(header.fields.begin(), header.fields.end(), kColumns[column]);
            if (at == header.fields.end() && column >= GainColumn) {
                m_places[column] = kMissing;
                continue;
            }
            if (at == header.fields.end())
                return fail(TableError{header.line,
                    "The column \"" + std::string(kColumns[column]) + "\" is missing."});
            m_places[column] = static_cast<std::size_t>(at - header.fields.begin());
        }
        m_width = header.fields.size();
        return {};
    }

    /// Whether the row is of this family and version.
    Result<bool, TableError> isFor(
        const CsvRow &row, std::string_view family, std::uint32_t version) const
    {
        if (row.fields.size() != m_width)
            return error(row,
                "has " + std::to_string(row.fields.size()) + " fields instead of "
                    + std::to_string(m_width));
        const auto since = versions(field(row, Since));
        if (!since)
            return error(row, "has no valid version in \"since\"");
        const auto until =
            field(row, Until).empty() ? VersionRange{0, 0xFFFFFF} : versions(field(row, Until));
        if (!until)
            return error(row, "has no valid version in \"until\"");
        return field(row, Family) == family && version >= since->first && version <= until->last;
    }

    Result<RegisterInfo, TableError> read(const CsvRow &row) const
    {
        RegisterInfo info;
        info.name = field(row, Name);
        if (info.name.empty())
            return error(row, "has no name");
        for (const std::string_view alias : split(field(row, Aliases), '|'))
            info.aliases.emplace_back(alias);
        info.group = field(row, Group);
        info.help = field(row, Description);
        info.unit = field(row, Unit);

        std::string_view hex = field(row, IdHex);
        if (hex.starts_with("0x"))
            hex.remove_prefix(2);
        const auto id = numberIn<RegisterId>(hex, 16);
        if (!id)
            return error(row, "has no valid identifier");
        info.id = *id;

        if (!readFormat(field(row, Format), info))
            return error(row, "has an unknown format");
        const auto *access = findWord(kAccesses, field(row, AccessColumn));
        const auto *meaning = findWord(kMeanings, field(row, MeaningColumn));
        const auto *quantity = findWord(kQuantities, field(row, QuantityColumn));
        const auto *gain = findWord(kGains, field(row, GainColumn));
        const auto *perMotor = findWord(kScopes, field(row, Scope));
        if (access == nullptr || meaning == nullptr || quantity == nullptr || perMotor == nullptr
            || gain == nullptr)
            return error(row, "has an unknown word in access, meaning, quantity, gain or scope");
        if (!readLimits(field(row, LimitsColumn), info))
            return error(row, "has no valid range in \"limits\"");
        info.effect = effectOf(field(row, EffectColumn)).value_or(Effect::Unknown);
        if (m_places[EffectColumn] != kMissing && info.effect == Effect::Unknown
            && (access->access == Access::ReadWrite || access->access == Access::Write))
            return error(row, "can be written and does not say its effect");
        info.gain = *gain;
        info.access = access->access;
        info.stub = access->stub;
        info.meaning = *meaning;
        info.quantity = *quantity;
        info.perMotor = *perMotor;
        info.dangerous = field(row, Dangerous) == "yes";
        const std::string_view datalog = field(row, Datalog);
        if (datalog.starts_with("HF"))
            info.streaming = access->streamOnly ? Streaming::StreamOnly : Streaming::Fast;
        info.streamsUpperHalf = datalog.find("upper 16 bits") != std::string_view::npos;
        return info;
    }

private:
    /// "s16", "u8 enum", "Q30 s32", "s32 fixed point": the type is the word that is one, Qn the
    /// fraction bits.
    static bool readFormat(std::string_view format, RegisterInfo &info)
    {
        bool typed = false;
        for (const std::string_view word : split(format, ' ')) {
            if (const auto *type = findWord(kTypes, word)) {
                info.type = *type;
                typed = true;
            } else if (word.starts_with('Q')) {
                info.fractionBits = numberIn<int>(word.substr(1)).value_or(0);
            }
        }
        return typed && info.fractionBits >= 0 && info.fractionBits < 32;
    }

    /// "0..15", "0..", "max speed", "max current", "max torque".
    static bool readLimits(std::string_view text, RegisterInfo &info)
    {
        if (text == "max speed")
            info.setPoint = SetPoint::Speed;
        else if (text == "max current")
            info.setPoint = SetPoint::Current;
        else if (text == "max torque")
            info.setPoint = SetPoint::Torque;
        if (text.empty() || info.setPoint != SetPoint::None)
            return true;
        const std::size_t dots = text.find("..");
        if (dots == std::string_view::npos)
            return false;
        const std::string_view above = text.substr(dots + 2);
        const auto least = numberIn<std::int32_t>(text.substr(0, dots));
        if (!least)
            return false;
        info.least = *least;
        if (above.empty())
            return true;
        const auto greatest = numberIn<std::int32_t>(above);
        if (!greatest)
            return false;
        info.greatest = *greatest;
        return *greatest >= *least;
    }

    std::string_view field(const CsvRow &row, Column column) const
    {
        return m_places[column] == kMissing ? std::string_view()
                                            : std::string_view(row.fields[m_places[column]]);
    }

    tl::unexpected<TableError> error(const CsvRow &row, const std::string &what) const
    {
        return fail(
            TableError{row.line, "The row of line " + std::to_string(row.line) + " " + what + "."});
    }

    std::array<std::size_t, ColumnCount> m_places{};
    std::size_t m_width = 0;
};

} // namespace

Result<std::vector<RegisterInfo>, TableError> readTable(
    std::string_view csv, std::string_view family, std::uint32_t version)
{
    const auto rows = readCsv(csv);
    if (!rows)
        return fail(rows.error());
    if (rows->empty())
        return fail(TableError{1, "The table is empty."});
    TableReader reader;
    if (const auto header = reader.readHeader(rows->front()); !header)
        return fail(header.error());

    std::vector<RegisterInfo> registers;
    for (std::size_t i = 1; i < rows->size(); ++i) {
        const auto wanted = reader.isFor((*rows)[i], family, version);
        if (!wanted)
            return fail(wanted.error());
        // Also where not wanted: a bad row is an error for every board.
        const auto info = reader.read((*rows)[i]);
        if (!info)
            return fail(info.error());
        if (*wanted)
            registers.push_back(*info);
    }
    return registers;
}

} // namespace catalog
