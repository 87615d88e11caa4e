#include "mcp/trace_decoder.h"

#include "base/crc.h"
#include "mcp/datalog_decoder.h"
#include "mcp/request.h"
#include "mcp/response.h"

#include <algorithm>
#include <utility>

namespace mcp {
namespace {

constexpr std::size_t kHeaderSize = 4;
constexpr std::size_t kCrcSize = 2;
constexpr std::size_t kMaxStreams = 16;
constexpr std::uint32_t kBeacon = 5, kPing = 6, kData = 9, kResponse = 10, kError = 15;

unsigned bits(std::uint32_t word, int at, int width) { return (word >> at) & ((1U << width) - 1); }

bool is(std::optional<std::uint16_t> command, CommandId wanted)
{
    return command == static_cast<std::uint16_t>(wanted);
}

} // namespace

TraceDecoder::TraceDecoder(TraceLookup lookup)
    : m_lookup(std::move(lookup))
{
}

TraceItem TraceDecoder::next(TraceDirection direction, ByteView bytes)
{
    if (direction == TraceDirection::Event) {
        m_active = false; // perhaps a reset
        return TraceEvent{};
    }
    if (bytes.size() < kHeaderSize)
        return TraceInvalid{"shorter than a header"};
    const std::uint32_t word = ByteReader(bytes).u32();
    if (crc4(word & 0x0FFFFFFFU) != word >> 28)
        return TraceInvalid{"header CRC"};
    const std::uint32_t type = word & 0xFU;
    switch (type) {
    case kBeacon:
        return beacon(direction, word);
    case kPing:
        return ping(direction, word);
    case kError:
        return TraceError{bits(word, 8, 8), bits(word, 16, 8)};
    case kData:
        return data(direction, false, word, bytes);
    case kResponse:
        if (direction == TraceDirection::FromPerformer)
            return data(direction, true, word, bytes);
        break;
    default:
        break;
    }
    return TraceInvalid{"packet type"};
}

TraceItem TraceDecoder::beacon(TraceDirection direction, std::uint32_t word)
{
    const TraceBeacon item{
        bits(word, 4, 3), bits(word, 7, 1), bits(word, 8, 6), bits(word, 14, 7), bits(word, 21, 7)};
    if (direction == TraceDirection::FromController)
        m_offer = word;
    else if (m_offer == word)
        m_payloadCrc = item.crc != 0;
    return item;
}

TraceItem TraceDecoder::ping(TraceDirection direction, std::uint32_t word)
{
    const TracePing item{bits(word, 4, 1), bits(word, 5, 1), bits(word, 6, 1), bits(word, 7, 1),
        bits(word, 8, 4), bits(word, 12, 16)};
    if (direction == TraceDirection::FromPerformer && item.c == 0)
        m_active = false; // it was reset, or never configured
    return item;
}

TraceItem TraceDecoder::data(
    TraceDirection direction, bool isResponse, std::uint32_t word, ByteView bytes)
{
    const std::size_t length = bits(word, 4, 13);
    const std::size_t follows = bytes.size() - kHeaderSize;
    if (follows < length)
        return TraceInvalid{"shorter than its header says"};
    if (m_payloadCrc && follows > length + kCrcSize)
        return TraceInvalid{"longer than its header says"};
    const ByteView payload = bytes.subspan(kHeaderSize, length);
    if (direction == TraceDirection::FromController)
        return request(payload);
    return isResponse ? response(payload) : async(payload);
}

TraceRegister TraceDecoder::named(RegisterId id) const
{
    const auto note = m_lookup ? m_lookup(id) : std::nullopt;
    return {id, note ? note->name : std::string()};
}

TraceValue TraceDecoder::meant(RegisterId id, const Value &value) const
{
    const auto note = m_lookup ? m_lookup(id) : std::nullopt;
    TraceValue item{{id, note ? note->name : std::string()},
        interpret(value, note ? note->type : plainType(id)), {}};
    if (const auto *raw = std::get_if<Bytes>(&value))
        item.fields = fieldsOf(id, *raw);
    return item;
}

bool TraceDecoder::isUnsigned(RegisterId id) const
{
    using catalog::ValueType;
    const auto note = m_lookup ? m_lookup(id) : std::nullopt;
    return note
        && (note->type == ValueType::U8 || note->type == ValueType::U16
            || note->type == ValueType::U32);
}

TraceItem TraceDecoder::request(ByteView payload)
{
    TraceRequest item;
    item.length = payload.size();
    m_command.reset();
    m_asked.clear();
    m_written = 0;
    m_pending.reset();
    const auto decoded = decodeRequest(payload);
    if (!decoded)
        return item;
    m_command = decoded->command;
    item.hasCommand = true;
    item.command = decoded->command;
    item.commandName = commandName(decoded->command);
    item.motor = decoded->motor;
    if (is(m_command, CommandId::GetRegister)) {
        m_asked = decodeGetList(decoded->content.first(decoded->content.size() / 2 * 2))
                      .value_or(std::vector<RegisterId>{});
        for (const RegisterId id : m_asked)
            item.registers.push_back(named(id));
    } else if (is(m_command, CommandId::SetRegister)) {
        readSet(item, decoded->content);
    }
    return item;
}

void TraceDecoder::readSet(TraceRequest &item, ByteView content)
{
    const SetList list = decodeSetList(content);
    m_written = list.writes.size() + (list.error ? 1 : 0);
    for (const RegisterValue &write : list.writes) {
        item.writes.push_back(meant(write.id, write.value));
        if (!isDatalogRegister(write.id))
            continue;
        const auto config = decodeDatalog(std::get<Bytes>(write.value));
        if (!config)
            continue;
        item.datalog = m_pending = *config;
        if (config->stops())
            m_active = false;
    }
}

void TraceDecoder::accept(const DatalogConfig &config)
{
    if (config.stops())
        return;
    // The mark that is active already changes nothing, whatever else is in the configuration.
    const bool same = m_active && !m_streams.empty() && m_streams.back().config.mark == config.mark;
    if (same)
        return;
    m_active = true;
    std::erase_if(
        m_streams, [&config](const Stream &stream) { return stream.config.mark == config.mark; });
    if (m_streams.size() == kMaxStreams)
        m_streams.erase(m_streams.begin());
    m_streams.push_back({config, DatalogLayout(config), std::nullopt});
}

TraceItem TraceDecoder::response(ByteView payload)
{
    TraceResponse item;
    item.length = payload.size();
    const auto decoded = decodeResponse(payload);
    if (!decoded)
        return TraceInvalid{"response without a status"};
    item.status = decoded->status;
    item.statusName = statusName(decoded->status);
    item.data = Bytes(decoded->data.begin(), decoded->data.end());
    if (is(m_command, CommandId::GetRegister)) {
        if (const auto answer = decodeGetAnswer(m_asked, *decoded)) {
            item.values.emplace();
            for (std::size_t i = 0; i < answer->values.size(); ++i)
                item.values->push_back(meant(m_asked[i], answer->values[i]));
        }
    } else if (is(m_command, CommandId::SetRegister)) {
        const auto answer = decodeSetAnswer(m_written, *decoded);
        if (answer && payload.size() > 1)
            item.registerStatus = answer->registers;
        if (m_pending && decoded->ok())
            accept(*m_pending);
    } else if (is(m_command, CommandId::GetMcpVersion) && versionOf(*decoded)) {
        item.version = ByteReader(decoded->data).u32();
    }
    m_pending.reset();
    return item;
}

TraceItem TraceDecoder::async(ByteView payload)
{
    TraceAsync item;
    item.length = payload.size();
    if (payload.size() < kDatalogOverhead)
        return item;
    item.timestamp = ByteReader(payload).u32();
    item.mark = payload[payload.size() - 2];
    item.asyncId = payload.back();
    if (item.asyncId != 0)
        return item;
    if (m_pending && m_pending->mark == item.mark && !m_pending->stops())
        accept(*m_pending); // the packet overtook the response
    const auto stream = std::ranges::find_if(
        m_streams, [&item](const Stream &s) { return s.config.mark == item.mark; });
    if (stream != m_streams.end())
        decodeSamples(item, *stream, payload);
    return item;
}

void TraceDecoder::decodeSamples(TraceAsync &item, Stream &stream, ByteView payload)
{
    Signedness signedness; // fast samples are stored signed; what is unsigned is put right below
    for (const RegisterId id : stream.config.slow)
        signedness.slowUnsigned.push_back(isUnsigned(id));
    capture::SampleBlock block;
    if (!decodeBlocks(stream.config, stream.layout, signedness, payload, block))
        return;
    item.decoded = true;
    item.fastBlocks = block.count;
    item.partial = stream.layout.fullLength() != payload.size();
    for (std::size_t s = 0; s < stream.config.fast.size(); ++s) {
        const RegisterId id = stream.config.fast[s];
        const std::int32_t mask = isUnsigned(id) ? 0xFFFF : -1;
        item.fast.push_back(named(id));
        auto &samples = item.fastSamples.emplace_back();
        for (std::size_t i = 0; i < block.count; ++i)
            samples.push_back(block.fast[s * block.count + i] & mask);
    }
    for (const RegisterId id : stream.config.slow)
        item.slow.push_back(named(id));
    for (const capture::SlowGroup &group : block.slow) {
        TraceSlowGroup out;
        out.block = static_cast<std::size_t>(group.tick - block.firstTick) / stream.layout.step();
        for (std::size_t s = 0; s < group.values.size(); ++s) {
            const bool wide = scalarWidth(stream.config.slow[s].type()) == 4;
            const std::int64_t value = group.values[s];
            out.values.push_back(wide && signedness.slowUnsigned[s] ? value & 0xFFFFFFFF : value);
        }
        item.slowGroups.push_back(std::move(out));
    }
    const std::size_t blocks =
        block.count > 0 ? block.count : stream.layout.blocksIn(payload.size()).value_or(0);
    if (stream.expected)
        item.lostTicks = item.timestamp - *stream.expected;
    stream.expected = item.timestamp + static_cast<std::uint32_t>(blocks * stream.layout.step());
}

} // namespace mcp
