#include "mcp/datalog.h"

#include <algorithm>
#include <limits>

namespace mcp {
namespace {

constexpr std::size_t kFixedPart = 7; ///< of a configuration, without its ids
constexpr double kFreshSeconds = 0.012;
constexpr double kLineSeconds = 0.020;
constexpr std::size_t kPacketHeader = 4;
constexpr std::size_t kUsualBuffer = 2048;

bool hasMotor(const std::vector<RegisterId> &ids)
{
    return std::ranges::all_of(ids, [](RegisterId id) { return id.motor() != 0; });
}

} // namespace

DatalogConfig datalogStop(std::size_t asyncMax)
{
    DatalogConfig config;
    config.bufferSize = static_cast<std::uint16_t>(std::min(kUsualBuffer, asyncMax));
    return config;
}

RegisterId datalogRegister(std::uint8_t linkId)
{
    return (linkId == 1 ? reg::kAsyncUartB : reg::kAsyncUartA).withMotor(1);
}

bool isDatalogRegister(RegisterId id)
{
    const RegisterId plain = id.withMotor(0);
    return plain == reg::kAsyncUartA || plain == reg::kAsyncUartB || plain == reg::kAsyncStLink;
}

Result<Bytes, CodecError> encodeDatalog(const DatalogConfig &config)
{
    constexpr std::size_t kMost = std::numeric_limits<std::uint8_t>::max();
    if (config.fast.size() > kMost || config.slow.size() > kMost)
        return fail(CodecError::TooLong);
    if (!hasMotor(config.fast) || !hasMotor(config.slow))
        return fail(CodecError::NoMotor);
    ByteWriter w;
    w.u16(config.bufferSize).u8(config.fastRate).u8(static_cast<std::uint32_t>(config.fast.size()));
    w.u8(config.slowRate).u8(static_cast<std::uint32_t>(config.slow.size()));
    for (const auto *list : {&config.fast, &config.slow})
        for (const RegisterId id : *list)
            w.u16(id.bits);
    return w.u8(config.mark).take();
}

Result<DatalogConfig, CodecError> decodeDatalog(ByteView raw)
{
    ByteReader r(raw);
    DatalogConfig config;
    config.bufferSize = r.u16();
    if (!r.ok())
        return fail(CodecError::TooShort);
    if (raw.size() < kFixedPart)
        return config.bufferSize == 0 ? Result<DatalogConfig, CodecError>(config)
                                      : fail(CodecError::TooShort);
    config.fastRate = r.u8();
    const std::size_t fast = r.u8();
    config.slowRate = r.u8();
    const std::size_t slow = r.u8();
    if (raw.size() < kFixedPart + 2 * (fast + slow))
        return config.bufferSize == 0 ? Result<DatalogConfig, CodecError>(DatalogConfig{})
                                      : fail(CodecError::TooShort);
    for (std::size_t i = 0; i < fast; ++i)
        config.fast.push_back({r.u16()});
    for (std::size_t i = 0; i < slow; ++i)
        config.slow.push_back({r.u16()});
    config.mark = r.u8();
    return config;
}

DatalogLayout::DatalogLayout(const DatalogConfig &config)
    : m_fastBytes(2 * config.fast.size())
    , m_step(config.fastRate + 1U)
    , m_slowAtEnd(config.slowRate == kSlowAtEnd)
{
    for (const RegisterId id : config.slow)
        m_slowBytes += scalarWidth(id.type());
    if (config.slowRate < kSlowAtEnd && m_slowBytes > 0)
        m_blocksAGroup = config.slowRate + std::size_t{1};
    if (!config.stops())
        fill(config.bufferSize);
}

void DatalogLayout::fill(std::size_t bufferSize)
{
    if ((m_fastBytes == 0 && m_blocksAGroup == 0) || bufferSize < smallestBuffer())
        return;
    // Blocks are added as long as the next one and a whole MF group would still fit.
    const std::size_t last = bufferSize - m_fastBytes - m_slowBytes - 2;
    std::size_t at = 4;
    for (std::size_t counter = 0; at <= last; ++m_fullBlocks) {
        at += m_fastBytes;
        if (m_blocksAGroup > 0 && ++counter == m_blocksAGroup) {
            at += m_slowBytes;
            counter = 0;
        }
    }
    m_fullLength = at + (m_slowAtEnd ? m_slowBytes : 0) + 2;
}

std::optional<std::size_t> DatalogLayout::blocksIn(std::size_t length) const
{
    const std::size_t ends = kDatalogOverhead + (endsInGroup(length) ? m_slowBytes : 0);
    if (length < ends)
        return std::nullopt;
    if (m_fastBytes == 0 && m_blocksAGroup == 0) // what a stop sends off holds no block then
        return length == ends ? std::optional(std::size_t{0}) : std::nullopt;
    const std::size_t body = length - ends;
    const std::size_t group =
        m_blocksAGroup * m_fastBytes + (m_blocksAGroup > 0 ? m_slowBytes : m_fastBytes);
    const std::size_t rest = body % group;
    if (m_blocksAGroup == 0)
        return rest == 0 ? std::optional(body / group) : std::nullopt;
    if (m_fastBytes == 0)
        return rest == 0 ? std::optional(body / group * m_blocksAGroup) : std::nullopt;
    // The last group may be incomplete, but its MF values come at once with its last block.
    if (rest % m_fastBytes != 0 || rest / m_fastBytes >= m_blocksAGroup)
        return std::nullopt;
    return body / group * m_blocksAGroup + rest / m_fastBytes;
}

std::optional<std::uint16_t> chooseBufferSize(const DatalogConfig &config, const DatalogLink &link)
{
    DatalogConfig trial = config;
    trial.mark = 1;
    const auto layoutFor = [&trial](std::size_t size) {
        trial.bufferSize = static_cast<std::uint16_t>(size);
        return DatalogLayout(trial);
    };
    const double lineBytes = kLineSeconds * link.baud / 10.0 - static_cast<double>(kPacketHeader);
    const std::size_t room =
        std::min<std::size_t>({link.asyncMax, static_cast<std::size_t>(std::max(lineBytes, 0.0)),
            std::numeric_limits<std::uint16_t>::max()});
    const DatalogLayout widest = layoutFor(room);
    const std::size_t group = std::max<std::size_t>(widest.blocksAGroup(), 1);
    if (!widest.fullLength() || widest.fullBlocks() < group)
        return std::nullopt;
    const auto fresh = static_cast<std::size_t>(kFreshSeconds * link.tickHz / widest.step());
    std::size_t wanted = std::min(widest.fullBlocks(), std::max(fresh, group));
    wanted -= wanted % group;
    // Looked for is the largest size that gives no more than `wanted`.
    std::size_t low = widest.smallestBuffer(), high = room;
    while (low < high) {
        const std::size_t middle = low + (high - low + 1) / 2;
        if (layoutFor(middle).fullBlocks() <= wanted)
            low = middle;
        else
            high = middle - 1;
    }
    return static_cast<std::uint16_t>(low);
}

} // namespace mcp
