// Reading the table: columns found by name, words looked up in tables, every field checked.
#include "fcp/register_table.h"

#include "base/text.h"
#include "catalog/catalog.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

namespace fcp {
namespace {

using catalog::Access;
using catalog::Meaning;
using catalog::RegisterInfo;
using catalog::TableError;
using catalog::ValueType;

enum Column : std::uint8_t {
    Id,
    Name,
    Type,
    PowerPcType,
    Unit,
    Group,
    AccessColumn,
    PowerPcAccess,
    ReadBytes,
    WriteBytes,
    Needs,
    Dangerous,
    EffectColumn,
    Description,
    ColumnCount
};
constexpr std::array<std::string_view, ColumnCount> kColumns{"id", "name", "type", "powerpc_type",
    "unit", "group", "access", "powerpc_access", "read_bytes", "write_bytes", "needs", "dangerous",
    "effect", "description"};

constexpr Word<ValueType> kTypes[] = {{"u8", ValueType::U8}, {"s8", ValueType::S8},
    {"u16", ValueType::U16}, {"s16", ValueType::S16}, {"u32", ValueType::U32},
    {"s32", ValueType::S32}, {"f32", ValueType::F32}};
constexpr Word<Meaning> kMeanings[] = {{"", Meaning::Number}, {"enum", Meaning::Enumeration},
    {"flags", Meaning::Flags}, {"bool", Meaning::Boolean}};
constexpr Word<Access> kAccesses[] = {{"none", Access::None}, {"DAC", Access::None},
    {"", Access::None}, {"R", Access::Read}, {"W", Access::Write}, {"RW", Access::ReadWrite}};
constexpr Word<Need> kNeeds[] = {{"", Need::Nothing}, {"pll", Need::Pll}, {"cordic", Need::Cordic},
    {"sensor", Need::Sensor}, {"flux weakening", Need::FluxWeakening},
    {"feed forward", Need::FeedForward}, {"pfc", Need::Pfc}, {"dac", Need::Dac},
    {"injection", Need::Injection}, {"profiler", Need::Profiler}, {"position", Need::Position}};

std::optional<unsigned> number(std::string_view text, int base)
{
    if (base == 16 && text.starts_with("0x"))
        text.remove_prefix(2);
    const auto value = numberIn<unsigned>(text, base);
    return value && *value <= 0xFF ? value : std::nullopt;
}

/// Empty is 0: refused.
std::optional<std::size_t> width(std::string_view text)
{
    if (text.empty())
        return 0;
    const auto bytes = number(text, 10);
    if (!bytes || (*bytes != 1 && *bytes != 2 && *bytes != 4))
        return std::nullopt;
    return *bytes;
}

tl::unexpected<TableError> wrong(const catalog::CsvRow &row, std::string_view what)
{
    return fail(TableError{row.line, "There is no valid " + std::string(what) + " in this row."});
}

/// "u8 enum"
bool readType(std::string_view text, RegisterInfo &info)
{
    const std::size_t space = std::min(text.find(' '), text.size());
    const auto *type = findWord(kTypes, text.substr(0, space));
    const auto *meaning = findWord(kMeanings, text.substr(std::min(space + 1, text.size())));
    if (type == nullptr || meaning == nullptr)
        return false;
    info.type = *type;
    info.meaning = *meaning;
    return true;
}

/// What a unit says of the number.
void setQuantity(RegisterInfo &info)
{
    if (info.unit == "s16A")
        info.quantity = catalog::Quantity::Current;
    else if (info.unit == "s16V")
        info.quantity = catalog::Quantity::Voltage;
    else if (info.unit == "s16degree")
        info.quantity = catalog::Quantity::Angle;
    if (info.unit == "0.1 %") { // a share: no more than all
        info.least = 0.0;
        info.greatest = 1000.0;
    }
}

/// What the text alone says: the type's width where it can be read, and where it can be written.
void setWidthsByText(Register &entry)
{
    const std::size_t bytes = catalog::widthOf(entry.info.type);
    entry.readBytes = entry.info.readable() ? bytes : 0;
    entry.writeBytes = entry.info.writable() ? bytes : 0;
}

Result<Register, TableError> readRow(const catalog::CsvRow &row, Dialect dialect)
{
    const auto &fields = row.fields;
    const bool powerPc = dialect == Dialect::PowerPc;
    Register entry;
    const auto id = number(fields[Id], 16);
    if (!id)
        return wrong(row, "id");
    entry.info.id = *id;
    entry.info.name = fields[Name];
    if (entry.info.name.empty())
        return wrong(row, "name");
    if (!readType(fields[powerPc ? PowerPcType : Type], entry.info))
        return wrong(row, "type");
    const std::string &word = fields[powerPc ? PowerPcAccess : AccessColumn];
    const auto *access = findWord(kAccesses, word);
    const auto *need = findWord(kNeeds, fields[Needs]);
    const auto read = width(fields[ReadBytes]);
    const auto write = width(fields[WriteBytes]);
    if (access == nullptr || need == nullptr || !read || !write)
        return wrong(row, "access, need or width");
    entry.info.access = *access;
    entry.info.unit = fields[Unit];
    entry.info.group = fields[Group];
    entry.info.help = fields[Description];
    entry.info.dangerous = fields[Dangerous] == "yes";
    const auto effect = catalog::effectOf(fields[EffectColumn]);
    if (!effect && entry.info.writable())
        return wrong(row, "effect");
    entry.info.effect = effect.value_or(catalog::Effect::Unknown);
    setQuantity(entry.info);
    entry.need = *need;
    entry.dacSource = word == "DAC";
    entry.readBytes = *read;
    entry.writeBytes = *write;
    if (powerPc)
        setWidthsByText(entry);
    return entry;
}

std::vector<Register> builtIn(Dialect dialect)
{
    return readRegisterTable(catalog::builtInTable("legacy"), dialect)
        .value_or(std::vector<Register>{});
}

std::int64_t integerOf(ValueType type, ByteView bytes)
{
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bits |= std::uint32_t{bytes[i]} << (8 * i);
    const bool negative = !bytes.empty() && bytes.back() >= 0x80;
    const bool isSigned = type == ValueType::S8 || type == ValueType::S16 || type == ValueType::S32;
    std::int64_t value = bits;
    if (isSigned && negative)
        value -= std::int64_t{1} << (8 * bytes.size());
    return value;
}

} // namespace

Result<std::vector<Register>, TableError> readRegisterTable(std::string_view csv, Dialect dialect)
{
    const auto rows = catalog::readCsv(csv);
    if (!rows)
        return fail(rows.error());
    if (rows->empty()
        || !std::equal(kColumns.begin(), kColumns.end(), rows->front().fields.begin(),
            rows->front().fields.end()))
        return fail(TableError{1, "The columns are not those of the table."});
    std::vector<Register> registers;
    for (std::size_t i = 1; i < rows->size(); ++i) {
        const catalog::CsvRow &row = (*rows)[i];
        if (row.fields.size() != ColumnCount)
            return wrong(row, "number of fields");
        if (dialect == Dialect::PowerPc && row.fields[PowerPcAccess].empty())
            continue;
        const auto entry = readRow(row, dialect);
        if (!entry)
            return fail(entry.error());
        if (!registers.empty() && registers.back().info.id >= entry->info.id)
            return wrong(row, "order of ids");
        registers.push_back(*entry);
    }
    return registers;
}

const std::vector<Register> &registersOf(Dialect dialect)
{
    static const std::array tables{builtIn(Dialect::Stm32), builtIn(Dialect::PowerPc)};
    return tables[dialect == Dialect::Stm32 ? 0 : 1];
}

const Register *findRegister(Dialect dialect, std::uint8_t id)
{
    const auto &all = registersOf(dialect);
    const auto at = std::lower_bound(all.begin(), all.end(), id,
        [](const Register &entry, std::uint8_t wanted) { return entry.info.id < wanted; });
    return at != all.end() && at->info.id == id ? &*at : nullptr;
}

Result<catalog::Value, ReplyError> decodeValue(const Register &which, ByteView bytes)
{
    const std::size_t full = catalog::widthOf(which.info.type);
    if (bytes.empty() || (bytes.size() != full && bytes.size() != which.readBytes))
        return fail(ReplyError::BadLength);
    if (which.info.type == ValueType::F32)
        return catalog::Value(static_cast<double>(ByteReader(bytes).f32()));
    return catalog::Value(integerOf(which.info.type, bytes));
}

Bytes encodeValue(const Register &which, const catalog::Value &value, std::size_t width)
{
    std::uint64_t bits = 0;
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        bits = which.info.type == ValueType::F32
            ? std::bit_cast<std::uint32_t>(static_cast<float>(*whole))
            : static_cast<std::uint64_t>(*whole);
    else if (const auto *real = std::get_if<double>(&value);
             real != nullptr && which.info.type == ValueType::F32)
        bits = std::bit_cast<std::uint32_t>(static_cast<float>(*real));
    Bytes bytes;
    for (std::size_t i = 0; i < width; ++i)
        bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i)));
    return bytes;
}

} // namespace fcp
