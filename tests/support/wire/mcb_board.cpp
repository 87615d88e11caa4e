#include "support/wire/mcb_board.h"

#include "support/wire/mcb.h"

#include <array>
#include <bit>
#include <utility>

namespace judge {

namespace {

constexpr auto kWord = McbRegister::Type::Word, kWhole = McbRegister::Type::Whole;
constexpr std::array kRegisters = std::to_array<McbRegister>({{"DRV_DIAG_ERROR_LAST", 0x00F, 1.0,
                                                                  kWhole},
    {"DRV_STATE_CONTROL", 0x010, 1.0, kWord}, {"DRV_STATE_STATUS", 0x011, 1.0, kWord},
    {"DRV_OP_CMD", 0x014, 1.0, kWord}, {"DRV_OP_VALUE", 0x015, 1.0, kWord},
    {"CL_VOL_Q_SET_POINT", 0x018}, {"CL_VOL_D_SET_POINT", 0x019}, {"CL_CUR_Q_SET_POINT", 0x01A},
    {"CL_CUR_D_SET_POINT", 0x01B}, {"CL_CUR_A_SET_POINT", 0x01C}, {"CL_CUR_B_SET_POINT", 0x01D},
    {"CL_POS_SET_POINT_VALUE", 0x020, 1.0, kWhole}, {"CL_VEL_SET_POINT_VALUE", 0x021, 60.0},
    {"PROF_MAX_VEL", 0x025, 60.0}, {"CL_POS_FBK_VALUE", 0x030, 1.0, kWhole},
    {"CL_VEL_FBK_VALUE", 0x031, 60.0}, {"FBK_CUR_A_VALUE", 0x038}, {"FBK_CUR_B_VALUE", 0x039},
    {"FBK_CUR_C_VALUE", 0x03A}, {"CL_CUR_Q_VALUE", 0x03B}, {"CL_CUR_D_VALUE", 0x03C},
    {"DRV_PROT_VBUS_VALUE", 0x060}, {"DRV_PROT_PRIM_TEMP_VALUE", 0x061},
    {"MOT_PROT_TEMP_VALUE", 0x063}, {"CL_VOL_Q_REF_VALUE", 0x070}, {"CL_VOL_D_REF_VALUE", 0x071},
    {"CL_CUR_Q_REF_VALUE", 0x072}, {"CL_CUR_D_REF_VALUE", 0x073},
    {"CL_POS_REF_VALUE", 0x078, 1.0, kWhole}, {"CL_VEL_REF_VALUE", 0x079, 60.0},
    {"CL_VEL_CMD_OFFSET", 0x07B, 60.0}, {"CL_CUR_Q_OFFSET", 0x07C}, {"CL_CUR_D_OFFSET", 0x07D},
    {"CL_VEL_CMD_VALUE", 0x097, 60.0}, {"CL_CUR_Q_CMD_VALUE", 0x098}, {"CL_CUR_D_CMD_VALUE", 0x099},
    {"MOT_RATED_CURRENT", 0x100}, {"DRV_PROT_I2T_PEAK_VALUE", 0x101}, {"CL_CUR_REF_MAX", 0x1E0},
    {"CL_VEL_REF_MAX", 0x1E8, 60.0}, {"CL_CUR_Q_KP", 0x500}, {"CL_CUR_Q_KI", 0x501},
    {"CL_CUR_D_KP", 0x505}, {"CL_CUR_D_KI", 0x506}, {"CL_VEL_PID_KP", 0x50A},
    {"CL_VEL_PID_KI", 0x50B}, {"CL_POS_PID_KP", 0x511}, {"CL_POS_PID_KI", 0x512}});

constexpr unsigned kRead = 1, kWrite = 2, kAnswer = 3;
constexpr unsigned kMappingFirst = 0x660, kMappingLast = 0x66F; ///< of what the drive sends
constexpr std::size_t kConfig = 5; ///< words of a frame before those that travel

unsigned wordOf(ByteView bytes, std::size_t number)
{
    return unsigned{bytes[2 * number]} << 8 | bytes[2 * number + 1];
}
unsigned addressOf(ByteView bytes) { return wordOf(bytes, 0) >> 4 & 0x7FFU; }
unsigned commandOf(ByteView bytes) { return wordOf(bytes, 0) >> 1 & 7U; }
bool isPart(ByteView bytes) { return (wordOf(bytes, 0) & 1U) != 0; }
bool isFrame(ByteView bytes)
{
    return bytes.size() >= 2 * (kConfig + 1) && bytes.size() % 2 == 0
        && WireMcb::checkOf(bytes) == 0;
}

} // namespace

const McbRegister *findMcbRegister(std::string_view name)
{
    for (const McbRegister &known : kRegisters)
        if (known.name == name)
            return &known;
    return nullptr;
}

void McbBoard::reset()
{
    m_list.clear();
    m_due.clear();
    m_said.clear();
    m_length = 0;
}

void McbBoard::asks(ByteView bytes, bool arrives)
{
    m_said.clear();
    m_length = bytes.size();
    m_arrives = arrives;
    if (!arrives || !isFrame(bytes))
        return;
    const unsigned address = addressOf(bytes), command = commandOf(bytes);
    if (command == kRead || command == kWrite)
        m_due[address] = command == kRead;
    if (command == kWrite && address >= kMappingFirst && address <= kMappingLast)
        m_list[address] = wordOf(bytes, 1) | wordOf(bytes, 2) << 16;
}

void McbBoard::says(ByteView bytes, TimePoint at, bool arrives)
{
    m_arrives = m_arrives && arrives;
    m_said.insert(m_said.end(), bytes.begin(), bytes.end());
    if (m_length == 0 || m_said.size() < m_length)
        return;
    const Bytes frame(m_said.begin(), m_said.begin() + static_cast<std::ptrdiff_t>(m_length));
    m_length = 0;
    if (m_arrives && isFrame(frame))
        accept(frame, at);
    m_given.forgetOld(at);
}

std::vector<McbBoard::Entry> McbBoard::mapped() const
{
    const auto written = [&](unsigned address) {
        const auto at = m_list.find(address);
        return at == m_list.end() ? 0U : at->second;
    };
    std::vector<Entry> entries;
    for (unsigned i = 1; i <= written(kMappingFirst) && kMappingFirst + i <= kMappingLast; ++i) {
        const unsigned entry = written(kMappingFirst + i);
        entries.push_back({entry & 0xFFFFU, ((entry >> 16) + 1) / 2});
    }
    return entries;
}

void McbBoard::accept(ByteView bytes, TimePoint at)
{
    const unsigned address = addressOf(bytes);
    if (const auto due = m_due.find(address);
        commandOf(bytes) == kAnswer && !isPart(bytes) && due != m_due.end() && due->second) {
        due->second = false; // one that comes again may be the answer to something else
        keep(address, wordOf(bytes, 1), wordOf(bytes, 2), at);
    }
    const std::size_t end = bytes.size() / 2 - 1;
    std::size_t from = kConfig;
    for (const Entry &entry : mapped()) {
        if (from + entry.words > end)
            return;
        if (entry.words == 1 || entry.words == 2)
            keep(entry.address, wordOf(bytes, from), entry.words == 2 ? wordOf(bytes, from + 1) : 0,
                at);
        from += entry.words;
    }
}

void McbBoard::keep(unsigned address, unsigned low, unsigned high, TimePoint at)
{
    const std::uint32_t bits = low | high << 16;
    for (const McbRegister &known : kRegisters) {
        if (known.address != address)
            continue;
        double number = low;
        if (known.type == McbRegister::Type::Whole)
            number = static_cast<std::int32_t>(bits);
        else if (known.type == McbRegister::Type::Real)
            number = static_cast<double>(std::bit_cast<float>(bits));
        m_given.add(static_cast<std::uint16_t>(address << 3 | 1U), number, at);
    }
}

} // namespace judge
