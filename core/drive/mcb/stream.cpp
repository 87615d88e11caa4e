#include "drive/mcb/stream.h"

#include "drive/mcb/identification.h"
#include "drive/stop_sequence.h"
#include "drive/values.h"

#include <algorithm>
#include <cmath>

namespace drive {

namespace {

using namespace std::chrono_literals;

constexpr double kTickHz = 1e6;
constexpr Duration kTick = 1us;
constexpr Duration kExchange = 1ms; ///< the fastest period, and what rates are counted in
constexpr Duration kUnbroken = 100ms; ///< without an exchange: what was between is not known
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

void McbStreamControl::begin(const Stream &stream, const std::vector<RegisterId> &ids,
    const std::map<std::uint16_t, mcb::Info> &told)
{
    m_wanted = stream;
    m_running = true;
    m_leftOff = false;
    m_infos.clear();
    capture::StreamLayout layout;
    layout.id = ++m_lastStream;
    layout.tickHz = kTickHz;
    layout.ticksAreControlPeriods = false;
    layout.fastStep = static_cast<std::uint32_t>(m_period / kTick);
    for (const RegisterId id : ids) {
        const mcb::Info info = told.at(mcbAddressOf(id));
        const catalog::Scale scale = m_board.catalog->streamScale(id);
        capture::StreamSignal signal{id, m_board.catalog->nameOf(id), scale.unit, scale.factor,
            info.type == mcb::Type::UInt32 ? kHalf32 : 0.0};
        signal.real = info.type == mcb::Type::Float;
        layout.slow.push_back(std::move(signal));
        m_infos.push_back(info);
    }
    m_layout.reset();
    if (!ids.empty())
        m_layout = std::move(layout);
    m_announced = m_broken = false;
    m_block = {};
}

void McbStreamControl::ended()
{
    if (!m_block.slow.empty())
        m_events.emplace_back(std::exchange(m_block, {}));
    m_layout.reset();
    m_running = false;
    if (std::exchange(m_announced, false))
        m_events.emplace_back(StreamStarted{});
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
    const capture::Tick apart = group.tick - m_lastTick - m_layout->fastStep;
    const bool gap = std::exchange(m_broken, false) || lostFrames > 0 || apart > kUnbroken / kTick;
    if (gap) { // with what was never exchanged, as while the program stood still
        const capture::Tick each = std::max<capture::Tick>(1, m_layout->fastStep);
        const auto missing =
            static_cast<std::uint64_t>(std::max<capture::Tick>(0, apart + each / 2))
            / static_cast<std::uint64_t>(each);
        m_lost += missing - std::min(missing, lostFrames);
    }
    if (gap && !m_block.slow.empty())
        m_events.emplace_back(std::exchange(m_block, {}));
    if (m_block.slow.empty()) {
        m_block.stream = m_layout->id;
        m_block.firstTick = group.tick;
        m_block.lostTicks = gap ? std::max<capture::Tick>(1, apart) : 0;
    }
    m_lastTick = group.tick;
    m_block.slow.push_back(std::move(group));
}

std::optional<TimePoint> McbStreamControl::nextFlush() const
{
    return m_block.slow.empty() ? std::nullopt
                                : std::optional(m_origin + m_block.firstTick * kTick + kBlockTime);
}

void McbStreamControl::flush(TimePoint now)
{
    if (now >= nextFlush().value_or(TimePoint::max()))
        m_events.emplace_back(std::exchange(m_block, {}));
}

McbStreamTask::McbStreamTask(
    WishId id, const Stream &stream, McbStreamControl &control, McbSetPoints &setPoints)
    : WishTask(id, Permission::Always)
    , m_control(control)
    , m_setPoints(setPoints)
    , m_stream(stream)
{
}

McbStreamTask::McbStreamTask(
    WishId id, const CyclicSetPoints &wanted, McbStreamControl &control, McbSetPoints &setPoints)
    : WishTask(id, wanted.on ? Permission::Armed : Permission::Always)
    , m_control(control)
    , m_setPoints(setPoints)
    , m_turn(wanted.on)
{
}

mcb::Mapping McbStreamTask::mapping() const
{
    mcb::Mapping mapping;
    if (travels())
        mapping.rx = m_setPoints.entries();
    for (const RegisterId id : m_ids)
        if (const mcb::Info *info = m_control.m_board.infoOf(mcbAddressOf(id)))
            mapping.tx.push_back({mcbAddressOf(id), info->size});
    return mapping;
}

std::string McbStreamTask::refuse() const
{
    if (m_turn.value_or(false))
        if (auto why = m_control.m_board.reasonAgainst(Feature::CyclicSetPoints); !why.empty())
            return why;
    if (m_ids.empty())
        return {};
    if (auto why = m_control.m_board.reasonAgainst(m_stream, "exchange"); !why.empty())
        return why;
    if (m_ids.size() > mcb::kMostMapped)
        return "at most " + std::to_string(mcb::kMostMapped) + " signals at a time";
    return mapping().possible() ? std::string() : "these signals do not fit into one frame";
}

bool McbStreamTask::plan()
{
    if (m_turn && *m_turn == m_setPoints.wanted()) {
        end(Outcome::Ok);
        return false;
    }
    if (m_turn)
        m_stream = m_control.wish();
    for (const auto *list : {&m_stream.fast, &m_stream.slow})
        for (const RegisterId one : *list)
            if (std::ranges::find(m_ids, one) == m_ids.end())
                m_ids.push_back(one);
    if (auto why = refuse(); !why.empty()) {
        end(Outcome::Refused, std::move(why));
        return false;
    }
    if (m_turn.value_or(false))
        m_steps = {{Step::Standing, mcbreg::kStatus}, {Step::Standing, mcbreg::kVelocityNow}};
    const mcb::Mapping wanted = mapping();
    for (const auto *list : {&wanted.tx, &wanted.rx})
        for (const mcb::MappedRegister &one : *list)
            m_steps.push_back({Step::Info, one.address});
    for (const mcb::MappedRegister &one : wanted.rx)
        m_steps.push_back({Step::Hold, one.address});
    if (m_control.running())
        m_steps.push_back({Step::Unmap});
    if (wanted.possible())
        m_steps.push_back({Step::Map});
    if (m_steps.empty())
        finish();
    return !finished();
}

std::optional<McbRequest> McbStreamTask::nextRequest(TimePoint)
{
    if (finished() || (!std::exchange(m_planned, true) && !plan()))
        return std::nullopt;
    const Planned &next = m_steps.front();
    switch (next.step) {
    case Step::Standing:
    case Step::Hold:
        return mcbRead(next.address);
    case Step::Info:
        return mcbInfo(next.address);
    case Step::Unmap:
        markSent();
        return McbUnmap{};
    case Step::Map:
        break;
    }
    const mcb::Mapping wanted = mapping();
    // The set-points went with a reset, and there is nothing else; or a signal is not known any more.
    if (!wanted.possible() || wanted.tx.size() != m_ids.size()) {
        fail(Outcome::NotSent, "the drive was reset");
        return std::nullopt;
    }
    markSent();
    m_control.m_period = m_stream.fastEvery * kExchange;
    return McbMap{wanted};
}

/// Why the motor does not count as standing; empty if it may.
std::string McbStreamTask::reasonInStanding(std::uint16_t address, const McbAnswer &answer) const
{
    const auto value =
        answer.ok ? mcbValueOf(m_control.m_board, address, answer.words) : std::optional<Value>();
    const auto number = value ? asNumber(*value) : std::nullopt;
    if (!number)
        return "the drive does not tell whether the motor stands";
    const bool stands = address == mcbreg::kStatus
        ? mcbStateOf(static_cast<std::uint16_t>(*number)).state == MotorState::Idle
        : std::abs(*number) * kSecondsPerMinute <= StopSequence::kStandstillRpm;
    return stands ? "" : "only while the motor stands";
}

void McbStreamTask::onInfo(std::uint16_t address, const McbAnswer &answer)
{
    const std::string name = m_control.m_board.catalog->nameOf(mcbIdOf(address));
    if (!answer.ok || answer.words.size() < 2)
        return fail(Outcome::Refused, name + ": " + mcbWordOf(answer.code));
    // What is known may have changed meanwhile: after a reset all is asked anew, and answers are lost there, too.
    const mcb::Info *had = m_control.m_board.infoOf(address);
    m_told[address] = mcb::infoOf({answer.words[0], answer.words[1], 0, 0});
    if (had == nullptr || m_told[address] != *had) {
        markBoardChanged();
        fail(Outcome::Refused, name + ": has another type than it had");
    }
}

void McbStreamTask::onResponse(const McbAnswer &answer, TimePoint)
{
    if (finished() || m_steps.empty())
        return;
    const Planned done = m_steps.front();
    m_steps.pop_front();
    // What is asked of the motor and of types has its own words for a refusal.
    if (!answer.ok && done.step != Step::Standing && done.step != Step::Info)
        return fail(Outcome::Refused, mcbWordOf(answer.code));
    switch (done.step) {
    case Step::Standing:
        if (auto why = reasonInStanding(done.address, answer); !why.empty())
            fail(Outcome::Refused, std::move(why));
        break;
    case Step::Info:
        onInfo(done.address, answer);
        break;
    case Step::Hold:
        if (!m_setPoints.wanted()) // else the words that travel are what the drive has
            m_setPoints.set(done.address, answer.words);
        break;
    case Step::Unmap:
        m_unmapped = true;
        m_control.ended();
        break;
    case Step::Map:
        m_control.begin(m_stream, m_ids, m_told);
        break;
    }
    if (!finished() && m_steps.empty())
        finish();
}

void McbStreamTask::finish()
{
    travels() && m_control.running() ? m_setPoints.begin() : m_setPoints.end();
    if (m_ids.empty())
        m_control.m_wanted = {};
    end(Outcome::Ok);
}

/// Once the cyclic state was left, nothing travels any more.
void McbStreamTask::fail(Outcome outcome, std::string reason)
{
    if (m_unmapped || m_turn.value_or(false))
        m_setPoints.end();
    if (m_unmapped)
        m_control.m_leftOff = true;
    end(outcome, std::move(reason));
}

void McbStreamTask::onNoResponse(std::optional<bool> executed, TimePoint)
{
    const bool asks = !m_steps.empty() && m_steps.front().step != Step::Unmap
        && m_steps.front().step != Step::Map;
    fail(executed == false || asks ? Outcome::NotSent : Outcome::Unknown, kNoAnswer);
}

void McbStreamTask::cut(const std::string &reason)
{
    if (!finished() && m_unmapped)
        m_setPoints.end();
    // The drive's own wish goes back to what was streamed.
    if (!finished() && (m_unmapped || ended().id == 0))
        m_control.m_leftOff = true;
    WishTask::cut(reason);
}

} // namespace drive
