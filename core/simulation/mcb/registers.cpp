#include "simulation/mcb/registers.h"

#include <algorithm>

namespace simulation {

using mcb::ErrorCode;

namespace {

constexpr bool isEntryOf(std::uint16_t count, std::uint16_t address)
{
    return address > count && address <= count + McbRegisters::kMostEntries;
}

constexpr bool isCount(std::uint16_t address)
{
    return address == McbRegisters::kRxCount || address == McbRegisters::kTxCount;
}

constexpr bool isEntry(std::uint16_t address)
{
    return isEntryOf(McbRegisters::kRxCount, address) || isEntryOf(McbRegisters::kTxCount, address);
}

McbRegister setting(mcb::Type type, std::uint8_t size, std::uint32_t value)
{
    return {{size, type, mcb::Cyclic::ConfigOnly, catalog::Access::ReadWrite},
        mcb::wordsOfNumber(value, size)};
}

constexpr std::uint16_t addressIn(std::uint32_t entry) { return static_cast<std::uint16_t>(entry); }

} // namespace

McbRegisters::McbRegisters(const McbRig &rig)
    : m_registers(rig.registers)
{
    for (auto &[address, content] : m_registers)
        content.words.resize(mcb::wordsOf(content.info.size));
    m_registers[kState] = setting(mcb::Type::UInt16, 2, kConfigState);
    for (const std::uint16_t count : {kRxCount, kTxCount}) {
        m_registers[count] = setting(mcb::Type::UInt16, 2, 0);
        for (std::uint16_t i = 1; i <= kMostEntries; ++i)
            m_registers[static_cast<std::uint16_t>(count + i)] = setting(mcb::Type::UInt32, 4, 0);
    }
}

const McbRegister *McbRegisters::find(std::uint16_t address) const
{
    const auto found = m_registers.find(address);
    return found != m_registers.end() ? &found->second : nullptr;
}

std::uint32_t McbRegisters::numberAt(std::uint16_t address) const
{
    const McbRegister *content = find(address);
    const auto number =
        content != nullptr ? mcb::numberOf(content->words, content->info.size) : std::nullopt;
    return static_cast<std::uint32_t>(number.value_or(0));
}

Result<mcb::Words, ErrorCode> McbRegisters::read(std::uint16_t address) const
{
    const McbRegister *content = find(address);
    if (content == nullptr)
        return fail(ErrorCode::NoSuchRegister);
    const auto access = content->info.access;
    if (access != catalog::Access::Read && access != catalog::Access::ReadWrite)
        return fail(ErrorCode::AccessNotSupported);
    return content->words;
}

Result<void, ErrorCode> McbRegisters::write(std::uint16_t address, mcb::WordView words)
{
    const auto found = m_registers.find(address);
    if (found == m_registers.end())
        return fail(ErrorCode::NoSuchRegister);
    McbRegister &content = found->second;
    const auto access = content.info.access;
    if (access != catalog::Access::Write && access != catalog::Access::ReadWrite)
        return fail(ErrorCode::AccessNotSupported);
    const std::size_t room = content.words.size();
    if (words.size() >= room + mcb::kConfigWords) // a fragment too many
        return fail(ErrorCode::General);
    mcb::Words value(words.begin(), words.begin() + std::min(words.size(), room));
    value.resize(room);
    if (const auto checked = check(address, value); !checked)
        return checked;
    content.words = std::move(value);
    return {};
}

void McbRegisters::put(std::uint16_t address, mcb::WordView words)
{
    const auto found = m_registers.find(address);
    if (found == m_registers.end())
        return;
    mcb::Words &value = found->second.words;
    std::copy_n(words.begin(), std::min(value.size(), words.size()), value.begin());
}

Result<void, ErrorCode> McbRegisters::check(std::uint16_t address, mcb::WordView words) const
{
    if (isEntry(address))
        return checkEntry(address, static_cast<std::uint32_t>(*mcb::numberOf(words, 4)));
    if (isCount(address) && words[0] > kMostEntries)
        return fail(ErrorCode::BadCyclicIndex);
    if (address == kState && words[0] == kCyclicState) {
        if (const auto wanted = mapping(); !wanted)
            return fail(wanted.error());
    } else if (address == kState && words[0] != kConfigState) {
        return fail(ErrorCode::CyclicNotReachable);
    }
    return {};
}

Result<void, ErrorCode> McbRegisters::checkEntry(std::uint16_t address, std::uint32_t entry) const
{
    if (entry == 0)
        return {};
    const std::uint16_t list = isEntryOf(kRxCount, address) ? kRxCount : kTxCount;
    const McbRegister *content = find(addressIn(entry));
    if (content == nullptr)
        return fail(ErrorCode::NoSuchRegister);
    const auto direction = list == kRxCount ? mcb::Cyclic::Rx : mcb::Cyclic::Tx;
    if (content->info.cyclic != direction || content->info.size != entry >> 16)
        return fail(ErrorCode::CannotBeMapped);
    if (address > list + 1 && numberAt(static_cast<std::uint16_t>(address - 1)) == 0)
        return fail(ErrorCode::BadCyclicIndex);
    return {};
}

Result<std::vector<std::uint16_t>, ErrorCode> McbRegisters::mapped(std::uint16_t count) const
{
    std::vector<std::uint16_t> addresses;
    for (std::uint32_t i = 1; i <= numberAt(count); ++i) {
        const std::uint32_t entry = numberAt(static_cast<std::uint16_t>(count + i));
        if (entry == 0)
            return fail(ErrorCode::MappingRefused);
        addresses.push_back(addressIn(entry));
    }
    return addresses;
}

std::size_t McbRegisters::sumOf(const std::vector<std::uint16_t> &addresses) const
{
    std::size_t sum = 0;
    for (const std::uint16_t address : addresses)
        sum += find(address)->words.size();
    return sum;
}

Result<McbRegisters::Mapping, ErrorCode> McbRegisters::mapping() const
{
    auto rx = mapped(kRxCount);
    auto tx = mapped(kTxCount);
    if (!rx || !tx)
        return fail(ErrorCode::MappingRefused);
    const std::size_t words = std::max(sumOf(*rx), sumOf(*tx));
    if (words > mcb::kMostCyclicWords)
        return fail(ErrorCode::TooMuchMapped);
    if (words == 0)
        return fail(ErrorCode::MappingRefused);
    return Mapping{std::move(*rx), std::move(*tx), words};
}

mcb::Words McbRegisters::cyclicOutput(const Mapping &mapping) const
{
    mcb::Words output;
    for (const std::uint16_t address : mapping.tx) {
        const mcb::Words &words = find(address)->words;
        output.insert(output.end(), words.begin(), words.end());
    }
    output.resize(mapping.words);
    return output;
}

void McbRegisters::acceptCyclicInput(const Mapping &mapping, mcb::WordView words)
{
    for (const std::uint16_t address : mapping.rx) {
        mcb::Words &value = m_registers.at(address).words;
        const std::size_t count = std::min(value.size(), words.size());
        std::copy_n(words.begin(), count, value.begin());
        words = words.subspan(count);
    }
}

} // namespace simulation
