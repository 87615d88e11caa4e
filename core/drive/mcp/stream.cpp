#include "drive/mcp/stream.h"

#include "drive/mcp/scales.h"
#include "mcp/datalog.h"
#include "mcp/protocol.h"

#include <algorithm>

namespace drive {

namespace {

constexpr std::size_t kMaxInFlight = 8; ///< configurations sent whose first packet has not come
constexpr double kUnsignedOffset = 32768.0;
constexpr Duration kStopGrace = std::chrono::milliseconds(20);

bool isUnsigned(const McpFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    return info != nullptr && !info->streamsUpperHalf
        && (info->type == catalog::ValueType::U16 || info->type == catalog::ValueType::U8);
}

capture::StreamSignal signalOf(const McpFacts &board, RegisterId id, bool fast)
{
    const catalog::Scale scale = board.catalog->streamScale(id);
    return {id, board.catalog->nameOf(id), scale.unit, scale.factor,
        fast && isUnsigned(board, id) ? kUnsignedOffset : 0.0};
}

/// Whether a signal is of a sensor that the build lacks: boards take it, and log zeros.
bool lacksSensor(const McpFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    const auto motor = static_cast<std::size_t>(board.catalog->motorOf(id)) - 1;
    if (info == nullptr || motor >= board.sensors.size() || board.sensors[motor].empty())
        return false;
    return std::ranges::any_of(kSensors, [&](const McpSensor &one) {
        return info->name.starts_with(one.prefix) && !board.sensors[motor].contains(one.number);
    });
}

/// Bytes a second that a configuration puts on the line.
double loadOf(const mcp::DatalogConfig &config, double tickHz)
{
    const mcp::DatalogLayout layout(config);
    if (config.stops() || !layout.fullLength() || layout.fullBlocks() == 0)
        return 0.0;
    const double packetsPerSecond =
        tickHz / (static_cast<double>(layout.fullBlocks()) * layout.step());
    constexpr double kHeader = 4.0;
    return packetsPerSecond * (static_cast<double>(*layout.fullLength()) + kHeader);
}

} // namespace

McpSet datalogRequest(std::uint8_t linkId, const mcp::DatalogConfig &config)
{
    return {{{mcp::datalogRegister(linkId), mcp::encodeDatalog(config).value_or(Bytes())}}};
}

void McpStreamControl::restart()
{
    if (m_announced != 0)
        m_events.emplace_back(StreamStarted{});
    m_announced = 0;
    m_sent.clear();
    m_load = 0.0;
    m_stoppedAt.reset();
    m_origin.reset();
    m_seen = {};
    m_epoch = 0;
    m_decoder.emplace(std::max(m_board.streaming.tickHz, 1.0));
}

void McpStreamControl::close()
{
    restart();
    m_decoder.reset();
    m_wanted = {};
    m_stopNeeded = true;
}

std::string McpStreamControl::refuse(const Stream &stream) const
{
    if (auto why = m_board.reasonAgainst(stream, "control period"); !why.empty())
        return why;
    for (const auto *list : {&stream.fast, &stream.slow})
        for (const RegisterId id : *list)
            if (lacksSensor(m_board, id))
                return m_board.catalog->nameOf(id) + ": this motor does not have it";
    if (stream.fast.size() + stream.slow.size() > m_board.streaming.maxSignals)
        return "at most " + std::to_string(m_board.streaming.maxSignals) + " signals at a time";
    if (stream.slowEvery < 1 || stream.slowEvery > Stream::kSlowOncePerPacket)
        return "the slow rate is every 1st to 254th fast sample, or once a packet";
    if (stream.slowEvery == Stream::kSlowOncePerPacket && stream.fast.empty())
        return "without fast signals no packet ever fills";
    return {};
}

Result<mcp::DatalogConfig, std::string> McpStreamControl::configure(const Stream &stream)
{
    mcp::DatalogConfig config;
    config.fastRate = static_cast<std::uint8_t>(stream.fastEvery - 1);
    config.slowRate =
        stream.slow.empty() ? mcp::kSlowNever : static_cast<std::uint8_t>(stream.slowEvery - 1);
    for (const RegisterId id : stream.fast)
        config.fast.push_back({static_cast<std::uint16_t>(id)});
    for (const RegisterId id : stream.slow)
        config.slow.push_back({static_cast<std::uint16_t>(id)});
    const auto size = mcp::chooseBufferSize(
        config, {m_board.streamBytes, m_board.streaming.tickHz, m_board.baud});
    if (!size)
        return fail(std::string("these signals do not fit into one packet"));
    config.bufferSize = *size;
    m_lastMark = m_lastMark == 255 ? 1 : static_cast<std::uint8_t>(m_lastMark + 1);
    config.mark = m_lastMark;
    return config;
}

void McpStreamControl::sending(const Stream &stream, const mcp::DatalogConfig &config)
{
    Active next{config, {}};
    next.layout.id = ++m_lastStream;
    next.layout.tickHz = m_board.streaming.tickHz;
    next.layout.fastStep = stream.fastEvery;
    mcp::Signedness signs;
    for (const RegisterId id : stream.fast) {
        next.layout.fast.push_back(signalOf(m_board, id, true));
        signs.fastUnsigned.push_back(isUnsigned(m_board, id));
    }
    for (const RegisterId id : stream.slow) {
        next.layout.slow.push_back(signalOf(m_board, id, false));
        signs.slowUnsigned.push_back(isUnsigned(m_board, id));
    }
    m_decoder->expect(next.layout.id, config, std::move(signs));
    if (m_sent.size() >= kMaxInFlight)
        m_sent.erase(m_sent.begin() + 1);
    m_sent.push_back(std::move(next));
    m_stoppedAt.reset();
}

void McpStreamControl::agreed(const Stream &stream, const mcp::DatalogConfig &config, TimePoint now)
{
    m_wanted = stream;
    m_load = loadOf(config, m_board.streaming.tickHz);
    if (config.stops())
        m_stoppedAt = now + wireTime(2 * m_board.streamBytes, m_board.baud) + kStopGrace;
}

void McpStreamControl::handleTimeout(TimePoint now)
{
    if (!m_stoppedAt || now < *m_stoppedAt)
        return;
    m_stoppedAt.reset();
    m_sent.clear();
    if (std::exchange(m_announced, 0) != 0)
        m_events.emplace_back(StreamStarted{});
}

void McpStreamControl::receive(ByteView packet, TimePoint now)
{
    if (!m_decoder || m_sent.empty()) {
        ++m_skipped; // left over from before the stop that opens every connection
        return;
    }
    auto block = m_decoder->decode(packet);
    addStats();
    if (!block)
        return;
    if (m_decoder->epoch() != m_epoch) {
        // The board's count began anew: another axis, so another stream.
        m_epoch = m_decoder->epoch();
        m_origin.reset();
        m_announced = 0;
    }
    if (block->stream != m_announced && !announce(*block, now)) {
        ++m_skipped; // of a configuration from before the last identification
        return;
    }
    m_events.emplace_back(std::move(*block));
}

bool McpStreamControl::announce(const capture::SampleBlock &block, TimePoint now)
{
    const auto at = std::ranges::find_if(
        m_sent, [&](const Active &sent) { return sent.layout.id == block.stream; });
    if (at == m_sent.end())
        return false;
    m_sent.erase(m_sent.begin(), at);
    capture::StreamLayout &layout = m_sent.front().layout;
    if (!m_origin) {
        // The packet was sent when its last sample was taken, and has just crossed the line.
        const double last = static_cast<double>(block.firstTick)
            + static_cast<double>(block.count) * static_cast<double>(layout.fastStep);
        const mcp::DatalogLayout shape(m_sent.front().config);
        const Duration crossing = wireTime(shape.fullLength().value_or(0), m_board.baud);
        m_origin = toSeconds(now.time_since_epoch() - crossing) - last / layout.tickHz;
    }
    layout.originSeconds = *m_origin;
    m_announced = block.stream;
    m_events.emplace_back(StreamStarted{layout});
    return true;
}

void McpStreamControl::addStats()
{
    const mcp::DatalogDecoder::Stats &now = m_decoder->stats();
    m_packets += now.packets - m_seen.packets;
    m_lost += now.lostTicks - m_seen.lostTicks;
    m_skipped += now.skipped() - m_seen.skipped();
    m_seen = now;
}

McpStreamTask::McpStreamTask(WishId id, const Stream &stream, McpStreamControl &control)
    : WishTask(id, Permission::Always)
    , m_control(control)
    , m_stream(stream)
{
}

std::optional<McpRequest> McpStreamTask::nextRequest(TimePoint)
{
    if (finished())
        return std::nullopt;
    const bool stops = m_stream.fast.empty() && m_stream.slow.empty();
    if (auto why = stops ? std::string() : m_control.refuse(m_stream); !why.empty())
        return noRequest(Outcome::Refused, std::move(why));
    markSent();
    if (stops || m_control.m_stopNeeded) {
        m_stopping = !stops;
        m_config = mcp::datalogStop(m_control.m_board.streamBytes);
        return datalogRequest(m_control.m_board.linkId, m_config);
    }
    m_stopping = false;
    auto config = m_control.configure(m_stream);
    if (!config)
        return noRequest(Outcome::Refused, config.error());
    m_config = std::move(*config);
    m_control.sending(m_stream, m_config);
    return datalogRequest(m_control.m_board.linkId, m_config);
}

void McpStreamTask::onResponse(const McpAnswer &answer, TimePoint now)
{
    const auto status = answer ? mcp::statusOf(*answer) : std::nullopt;
    if (!status)
        return onNoResponse(std::nullopt, now);
    const bool ok = *status == static_cast<std::uint8_t>(mcp::Status::Ok);
    if (m_config.stops())
        m_control.stopSent();
    if (m_stopping)
        return; // the configuration is next, whatever the board said to the stop
    if (!ok && std::exchange(m_refusedOnce, true))
        return end(Outcome::Refused, statusWord(*status));
    if (!ok)
        return; // it may have been damaged on its way
    m_control.agreed(m_stream, m_config, now);
    end(Outcome::Ok);
}

void McpStreamTask::onNoResponse(std::optional<bool>, TimePoint)
{
    if (++m_losses >= McpProtocol::kAttempts)
        end(Outcome::Unknown, kNoAnswer);
}

} // namespace drive
