#include "drive/mcb/mcb_stream.h"

#include "drive/mcb/mcb_catalog.h"
#include "drive/mcb/mcb_messages.h"

#include <algorithm>

namespace drive {

namespace {

using namespace std::chrono_literals;

constexpr double kTickHz = 1e6;
constexpr Duration kTick = 1us;
constexpr Duration kExchange = 1ms; ///< the fastest period, and what rates are counted in
constexpr Duration kBlockTime = 16ms; ///< samples are handed out at most so often
constexpr double kHalf32 = 2147483648.0;

/// As a block has it: whole numbers shifted into the signed range, the bits of a float.
std::int32_t storedOf(const mcb::Info &info, mcb::WordView words)
{
    const auto bits = static_cast<std::uint32_t>(mcb::numberOf(words, info.size).value_or(0));
    if (info.type == mcb::Type::Int16)
        return static_cast<std::int16_t>(bits);
    if (info.type == mcb::Type::UInt32)
        return static_cast<std::int32_t>(bits ^ 0x80000000U);
    return static_cast<std::int32_t>(bits);
}

} // namespace

std::string McbStreamControl::refuse(const Stream &stream) const
{
    if (auto why = m_board.reasonAgainst(Feature::Stream); !why.empty())
        return why;
    if (stream.fastEvery < 1 || stream.fastEvery > 256)
        return "the fast rate is every 1st to 256th exchange";
    for (const auto *list : {&stream.fast, &stream.slow}) {
        for (const RegisterId id : *list) {
            const auto *info = m_board.catalog->find(id);
            if (info == nullptr)
                return m_board.catalog->nameOf(id) + ": no such register";
            if (info->streaming == catalog::Streaming::Polled)
                return info->name + ": cannot be streamed, only read";
        }
    }
    return {};
}

void McbStreamControl::begin(const Stream &stream, const std::vector<RegisterId> &ids)
{
    m_wanted = stream;
    m_infos.clear();
    capture::StreamLayout layout;
    layout.id = ++m_lastStream;
    layout.tickHz = kTickHz;
    layout.fastStep = static_cast<std::uint32_t>(m_period / kTick);
    for (const RegisterId id : ids) {
        const mcb::Info info = *m_board.infoOf(mcbAddressOf(id));
        const catalog::Scale scale = m_board.catalog->streamScale(id);
        capture::StreamSignal signal{id, m_board.catalog->nameOf(id), scale.unit, scale.factor,
            info.type == mcb::Type::UInt32 ? kHalf32 : 0.0};
        signal.real = info.type == mcb::Type::Float;
        layout.slow.push_back(std::move(signal));
        m_infos.push_back(info);
    }
    m_layout = std::move(layout);
    m_announced = m_broken = false;
    m_block = {};
    m_blockSince.reset();
}

void McbStreamControl::ended()
{
    if (m_block.slow.empty())
        m_blockSince.reset();
    else
        add(std::exchange(m_block, {}));
    m_blockSince.reset();
    m_layout.reset();
    if (std::exchange(m_announced, false))
        m_events.emplace_back(StreamStarted{});
}

void McbStreamControl::close()
{
    ended();
    m_wanted = {};
}

void McbStreamControl::receive(const mcb::Master::Cycle &cycle, std::uint64_t lostFrames)
{
    m_lost += lostFrames;
    if (!m_layout)
        return;
    if (!m_announced) {
        m_announced = true;
        m_origin = cycle.at;
        m_lastTick = 0;
        m_layout->originSeconds = toSeconds(m_origin.time_since_epoch());
        m_events.emplace_back(StreamStarted{*m_layout});
        m_broken = false;
        lostFrames = 0;
    }
    ++m_packets;
    capture::SlowGroup group;
    group.tick = (cycle.at - m_origin) / kTick;
    mcb::WordView words(cycle.input);
    for (const mcb::Info &info : m_infos) {
        const std::size_t count = std::min(mcb::wordsOf(info.size), words.size());
        group.values.push_back(storedOf(info, words.first(count)));
        words = words.subspan(count);
    }
    const bool gap = std::exchange(m_broken, false) || lostFrames > 0;
    if (gap && !m_block.slow.empty())
        add(std::exchange(m_block, {}));
    if (m_block.slow.empty()) {
        m_block.stream = m_layout->id;
        m_block.firstTick = group.tick;
        m_block.lostTicks =
            gap ? std::max<capture::Tick>(1, group.tick - m_lastTick - m_layout->fastStep) : 0;
        m_blockSince = cycle.at;
    }
    m_lastTick = group.tick;
    m_block.slow.push_back(std::move(group));
}

void McbStreamControl::add(capture::SampleBlock block) { m_events.emplace_back(std::move(block)); }

std::optional<TimePoint> McbStreamControl::nextFlush() const
{
    return m_blockSince ? std::optional(*m_blockSince + kBlockTime) : std::nullopt;
}

void McbStreamControl::flush(TimePoint now)
{
    if (!m_blockSince || now < *m_blockSince + kBlockTime)
        return;
    add(std::exchange(m_block, {}));
    m_blockSince.reset();
}

McbStreamTask::McbStreamTask(WishId id, const Stream &stream, McbStreamControl &control)
    : WishTask(id, Permission::Always)
    , m_control(control)
    , m_stream(stream)
{
    for (const auto *list : {&stream.fast, &stream.slow})
        for (const RegisterId one : *list)
            if (std::find(m_ids.begin(), m_ids.end(), one) == m_ids.end())
                m_ids.push_back(one);
}

std::optional<Bytes> McbStreamTask::nextRequest(TimePoint)
{
    if (finished())
        return std::nullopt;
    const bool stops = m_ids.empty();
    mcb::Mapping mapping;
    for (const RegisterId id : m_ids)
        if (const mcb::Info *info = m_control.m_board.infoOf(mcbAddressOf(id)))
            mapping.tx.push_back({mcbAddressOf(id), info->size});
    if (m_step == Step::Begin && !stops) {
        std::string why = m_control.refuse(m_stream);
        if (why.empty() && mapping.tx.size() > mcb::kMostMapped)
            why = "at most " + std::to_string(mcb::kMostMapped) + " signals at a time";
        if (why.empty() && !mapping.possible())
            why = "these signals do not fit into one frame";
        if (!why.empty()) {
            end(Outcome::Refused, why);
            return std::nullopt;
        }
    }
    if (m_step == Step::Begin || m_step == Step::Unmap) {
        m_step = m_control.running() ? Step::Unmap : Step::Infos;
        if (m_step == Step::Unmap) {
            markSent();
            return mcbUnmap();
        }
        if (stops) {
            m_control.m_wanted = {};
            end(Outcome::Ok);
            return std::nullopt;
        }
    }
    if (m_step == Step::Infos && m_asked < m_ids.size())
        return mcbInfo(mcbAddressOf(m_ids[m_asked]));
    m_step = Step::Map;
    markSent();
    m_control.m_period = m_stream.fastEvery * kExchange;
    return mcbMap(mapping);
}

void McbStreamTask::takeResponse(ByteView response, TimePoint)
{
    const McbAnswer answer = mcbAnswerOf(response);
    if (finished())
        return;
    switch (m_step) {
    case Step::Begin:
        break;
    case Step::Unmap:
        if (!answer.ok)
            return end(Outcome::Refused, mcbWordOf(answer.code));
        m_control.ended();
        break;
    case Step::Infos: {
        const RegisterId id = m_ids[m_asked++];
        const std::string name = m_control.m_board.catalog->nameOf(id);
        if (!answer.ok || answer.words.size() < 2)
            return end(Outcome::Refused, name + ": " + mcbWordOf(answer.code));
        if (mcb::infoOf({answer.words[0], answer.words[1], 0, 0})
            != *m_control.m_board.infoOf(mcbAddressOf(id))) {
            m_typeChanged = true;
            return end(Outcome::Refused, name + ": has another type than it had");
        }
        break;
    }
    case Step::Map:
        if (!answer.ok)
            return end(Outcome::Refused, mcbWordOf(answer.code));
        m_control.begin(m_stream, m_ids);
        end(Outcome::Ok);
        break;
    }
}

void McbStreamTask::takeNoResponse(std::optional<bool> executed, TimePoint)
{
    const bool notExecuted = executed.has_value() && !*executed;
    end(notExecuted ? Outcome::NotSent : Outcome::Unknown, "no answer");
}

} // namespace drive
