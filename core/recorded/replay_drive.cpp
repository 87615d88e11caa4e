#include "recorded/replay_drive.h"

#include "drive/board_facts.h"
#include "recorded/drive_entries.h"

#include <algorithm>

namespace recorded {

namespace {

using namespace std::chrono_literals;

/// Of what it cannot do, and of a wish that comes all the same.
constexpr const char *kSentence =
    "This is a replay of a recording: nothing is written, no motor moves.";
constexpr const char *kReason =
    "this is a replay of a recording: nothing is written, no motor moves";
constexpr RegisterId kMotorBits = 7;
constexpr std::uint64_t kMostATurn = 50'000; ///< values, so that a turn stays short at any speed
/// Recorded time that a wait may cost without being a pause.
constexpr Nanos kCatchUp = 500'000'000;
constexpr Duration kLookAgain = 50ms; ///< at the pace, which may have changed
constexpr Duration kWhileFull = 4ms;
constexpr Duration kReportEvery = 100ms;
constexpr double kSliceSeconds = 0.02;
/// Samples are gathered for 250 ms and written behind what was told meanwhile.
constexpr Nanos kLookAhead = 600'000'000;
constexpr std::size_t kMostPending = 5000;
constexpr Nanos kNever = std::numeric_limits<Nanos>::min();

bool isPlausible(Nanos at) { return at > -kFarthest && at < kFarthest; }

std::vector<std::string> wordsOf(const std::string &text)
{
    std::vector<std::string> words;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        if (end > at)
            words.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

drive::MotorState stateOf(const std::string &word)
{
    const auto *known = std::ranges::find(kMotorStateWords, word);
    return known != kMotorStateWords.end()
        ? static_cast<drive::MotorState>(known - kMotorStateWords.begin())
        : drive::MotorState::Unknown;
}

/// A block cut to what a board tells at a time, with the time from the block's to each part's.
std::vector<std::pair<Nanos, capture::SampleBlock>> slices(
    const capture::SampleBlock &block, const capture::StreamLayout &layout)
{
    const double hz = layout.tickHz / std::max<std::uint32_t>(1, layout.fastStep);
    const std::size_t signals = layout.fast.size();
    const auto most = static_cast<std::uint32_t>(std::clamp(hz * kSliceSeconds, 1.0, 1e6));
    if (block.stream != layout.id || !(hz > 1.0) || block.count <= most
        || block.fast.size() != signals * block.count)
        return {{0, block}};
    std::vector<std::pair<Nanos, capture::SampleBlock>> parts;
    auto group = block.slow.begin();
    for (std::uint32_t at = 0; at < block.count; at += most) {
        const std::uint32_t count = std::min(most, block.count - at);
        const bool last = at + count == block.count;
        const auto tickAt = [&](std::uint32_t sample) {
            return block.firstTick + static_cast<capture::Tick>(sample) * layout.fastStep;
        };
        capture::SampleBlock part{
            block.stream, tickAt(at), count, {}, {}, at == 0 ? block.lostTicks : 0};
        for (std::size_t s = 0; s < signals; ++s) {
            const auto from =
                block.fast.begin() + static_cast<std::ptrdiff_t>(s * block.count + at);
            part.fast.insert(part.fast.end(), from, from + count);
        }
        for (; group != block.slow.end() && (last || group->tick < tickAt(at + count)); ++group)
            part.slow.push_back(*group);
        parts.emplace_back(static_cast<Nanos>(at / hz * 1e9), std::move(part));
    }
    return parts;
}

} // namespace

void ReplayDrive::connect(TimePoint now)
{
    m_now = now;
    m_open = true;
    m_events.emplace_back(drive::LinkChanged{drive::LinkState::Connecting, {}});
    advance(now);
}

void ReplayDrive::disconnect(TimePoint now)
{
    m_now = now;
    if (!m_open)
        return;
    m_open = false;
    m_pending.clear();
    m_output.clear();
    if (!m_ended)
        m_events.emplace_back(drive::StreamStarted{});
    m_events.emplace_back(drive::LinkChanged{drive::LinkState::Closed, {}});
}

void ReplayDrive::receive(ByteView bytes, TimePoint now)
{
    m_asked = false;
    if (std::exchange(m_dropPiece, false))
        return advance(now);
    if (bytes.empty())
        m_decoder.finish();
    else
        m_decoder.feed(bytes);
    m_fed = m_fed || bytes.empty();
    advance(now);
}

std::optional<TimePoint> ReplayDrive::nextTimeout() const
{
    if (!m_open || m_asked)
        return std::nullopt;
    if (m_ended) // the user may want to see it again
        return m_control ? std::optional(m_now + kLookAgain) : std::nullopt;
    if (m_pending.empty())
        return std::nullopt;
    const ReplayPace now = pace();
    if (m_limited)
        return m_now + kWhileFull;
    if (hurries())
        return m_now;
    if (now.paused)
        return m_now + kLookAgain;
    if (now.speed <= 0.0)
        return m_now;
    const double wait = static_cast<double>(m_pending.begin()->first - m_position) / now.speed;
    return m_now
        + std::clamp(
            Duration(static_cast<Duration::rep>(std::min(wait, 1e9))), Duration(0), kLookAgain);
}

/// Tells what is due at `now`.
void ReplayDrive::advance(TimePoint now)
{
    const Duration passed = std::max(Duration(0), now - m_now);
    m_now = std::max(m_now, now);
    if (const auto place = m_control ? m_control->takeSeek() : std::nullopt; place && m_open)
        seek(*place, m_now);
    const ReplayPace at = pace();
    if (m_first && !at.paused)
        m_position +=
            static_cast<Nanos>(static_cast<double>(passed.count()) * std::max(0.0, at.speed));
    m_limited = m_control && m_control->full();
    m_told = 0;
    while (m_open && fetch(now)) {
        const bool hurried = hurries();
        if (!hurried && (at.paused || (at.speed > 0.0 && !isDue())))
            break;
        if (m_limited || m_told > kMostATurn)
            break;
        const Item item = std::move(m_pending.extract(m_pending.begin()).mapped());
        m_progress.bytes = std::max(m_progress.bytes, item.offset);
        m_progress.position = std::max(m_progress.position, item.at - *m_first);
        play(item);
        m_toldUntil = std::max(m_toldUntil.value_or(kNever), item.at + m_shift);
        if (hurried || at.speed <= 0.0)
            m_position = std::max(m_position, item.at);
    }
    if (!m_pending.empty()) { // short waits are caught up with
        const Nanos next = m_pending.begin()->first;
        m_position = std::min(m_position, at.speed > 0.0 ? next + kCatchUp : next);
    }
    if (m_control && m_told > 0)
        m_control->handed(m_told);
    report(now, false);
}

/// Entries into m_pending, as far ahead as they may be out of order; false while what is next is not known.
bool ReplayDrive::fetch(TimePoint now)
{
    const auto enough = [this] {
        return !m_pending.empty()
            && (m_pending.rbegin()->first - m_pending.begin()->first >= kLookAhead
                || m_pending.size() >= kMostPending);
    };
    while (!enough()) {
        std::optional<Decoder::Step> step = m_decoder.next();
        if (!step && m_fed)
            break;
        if (!step) {
            ask();
            return false;
        }
        if (std::holds_alternative<Damage>(*step)) {
            m_events.emplace_back(drive::LinkCounters{.badPackets = ++m_progress.damagedPlaces});
        } else {
            keep(std::move(std::get<Item>(*step)));
        }
    }
    if (m_pending.empty() && m_last) {
        const Nanos at = m_last->at;
        m_pending.emplace(at, *std::exchange(m_last, std::nullopt));
    }
    if (m_pending.empty()) {
        end(now);
        return false;
    }
    if (!m_first) {
        m_first = m_position = m_pending.begin()->first;
        // A block reaches further than the time at which it was told.
        m_shift = std::max(m_toldUntil ? *m_toldUntil + kLookAhead : kNever,
                      Nanos(now.time_since_epoch().count()))
            - *m_first;
        if (!std::exchange(m_met, true))
            m_events.emplace_back(drive::LinkChanged{drive::LinkState::Connected, {}});
    }
    return true;
}

void ReplayDrive::ask()
{
    if (std::exchange(m_asked, true))
        return;
    ByteWriter request;
    request.u32(kPiece);
    if (std::exchange(m_anew, false))
        request.u64(0);
    m_output.push_back({request.take(), {}});
}

/// Forward: no pace is kept up to there. Back: all begins anew, behind what was told.
void ReplayDrive::seek(std::uint64_t place, TimePoint now)
{
    m_hurryTo = place;
    if (place >= m_progress.bytes)
        return;
    m_dropPiece = m_asked;
    m_anew = true;
    m_decoder = {};
    m_pending.clear();
    m_last.reset();
    m_layout = {};
    m_samplesUntil = std::numeric_limits<Nanos>::min();
    m_fed = m_ended = false;
    m_first.reset();
    m_progress = {};
    m_reported = {};
    report(now, true);
}

/// Into m_pending at its time. Samples are gathered in a file: they are told a little at a time, as a board does, and
/// never behind the layout that follows them.
void ReplayDrive::keep(Item item)
{
    if (std::holds_alternative<Begin>(item.entry) || !isPlausible(item.at))
        return; // the time of the first is that of the file's making
    if (std::holds_alternative<End>(item.entry)) {
        // It may stand in front, and says nothing about how far ahead was read.
        m_last = std::move(item);
        return;
    }
    if (const auto *block = std::get_if<capture::SampleBlock>(&item.entry)) {
        for (auto &[after, part] : slices(*block, m_layout)) {
            m_samplesUntil = std::max(m_samplesUntil, item.at + after);
            m_pending.emplace(m_samplesUntil, Item{item.offset, m_samplesUntil, std::move(part)});
        }
        return;
    }
    if (const auto *layout = std::get_if<capture::StreamLayout>(&item.entry)) {
        m_layout = *layout;
        m_samplesUntil = item.at = std::max(item.at, m_samplesUntil);
    }
    const Nanos at = item.at;
    m_pending.emplace(at, std::move(item));
}

bool ReplayDrive::isDue()
{
    // While nothing was recorded there is nothing to see.
    const Nanos next = m_pending.begin()->first;
    m_position = std::max(m_position, next - kLongestPause);
    return next <= m_position;
}

void ReplayDrive::play(const Item &item)
{
    if (const auto *layout = std::get_if<capture::StreamLayout>(&item.entry))
        play(*layout);
    else if (const auto *block = std::get_if<capture::SampleBlock>(&item.entry))
        play(*block);
    else if (const auto *polled = std::get_if<PolledRegister>(&item.entry))
        play(*polled);
    else if (const auto *values = std::get_if<PolledValues>(&item.entry))
        play(*values);
    else if (const auto *happening = std::get_if<Happening>(&item.entry))
        play(item.at, *happening);
    else if (const auto *note = std::get_if<Note>(&item.entry); note && m_control)
        m_control->told((isPlausible(note->from) ? note->from : item.at) + m_shift, item.entry);
    else if (m_control && !std::holds_alternative<LinkBytes>(item.entry)
        && !std::holds_alternative<End>(item.entry)) // end() tells that one
        m_control->told(item.at + m_shift, item.entry);
}

void ReplayDrive::play(capture::StreamLayout layout)
{
    for (const auto *group : {&layout.fast, &layout.slow})
        for (const capture::StreamSignal &signal : *group)
            describe(signal.id, signal.name, signal.unit, true);
    layout.originSeconds += capture::toSeconds(m_shift);
    if (!layout.empty())
        m_tickHz = layout.tickHz;
    identify();
    m_events.emplace_back(drive::StreamStarted{std::move(layout)});
}

void ReplayDrive::play(capture::SampleBlock block)
{
    m_told += samplesOf(block);
    m_events.emplace_back(std::move(block));
}

void ReplayDrive::play(const PolledRegister &polled)
{
    describe(polled.id, polled.name, polled.unit, false);
    if (m_polled.size() < kMostRegisters)
        m_polled[polled.id] = true;
}

void ReplayDrive::play(const PolledValues &values)
{
    identify();
    drive::RegistersRead read;
    for (const PolledValue &value : values.values) {
        if (!m_polled.contains(value.id) || !isPlausible(value.at))
            continue; // its description is among what is damaged
        const drive::Reading reading{
            value.id, drive::ReadStatus::Ok, catalog::Value(value.value), axis(value.at)};
        m_values[value.id] = reading;
        read.readings.push_back(reading);
    }
    m_told += read.readings.size();
    if (!read.readings.empty())
        m_events.emplace_back(std::move(read));
}

void ReplayDrive::play(Nanos at, const Happening &happening)
{
    if (happening.name == "motor state")
        return playStatus(at, happening);
    if (happening.name == "board") {
        m_identity.protocol = happening.field("protocol");
        m_identity.firmware = happening.field("firmware");
        m_identity.version = happening.field("version");
        m_identity.controlBoard = happening.field("control board");
        m_identity.powerBoards = {happening.field("power boards")};
        m_identifiable = true;
        identify();
        return;
    }
    if (m_control)
        m_control->told(at + m_shift, happening);
}

void ReplayDrive::playStatus(Nanos at, const Happening &happening)
{
    drive::MotorStatus status;
    status.motor = static_cast<int>(
        std::clamp<std::int64_t>(happening.number<std::int64_t>("motor").value_or(1), 1, 7));
    status.state = stateOf(happening.field("state"));
    status.rawState = happening.number<std::int64_t>("raw").value_or(0);
    status.stateName = happening.field("name");
    status.faultsNow = wordsOf(happening.field("faults now"));
    status.faultsPast = wordsOf(happening.field("faults past"));
    status.at = axis(at);
    m_identifiable = m_identifiable || status.motor > m_identity.motors;
    m_identity.motors = std::max(m_identity.motors, status.motor);
    identify();
    m_events.emplace_back(std::move(status));
}

void ReplayDrive::describe(
    RegisterId id, const std::string &name, const std::string &unit, bool streamed)
{
    const RegisterId whole = id & ~kMotorBits;
    if (m_registers.size() >= kMostRegisters)
        return;
    catalog::RegisterInfo info;
    info.id = whole;
    info.name = name.substr(0, name.find('@'));
    info.group = "Recording";
    info.unit = unit;
    info.type = catalog::ValueType::F32;
    info.access = catalog::Access::Read;
    info.streaming = streamed ? catalog::Streaming::Fast : catalog::Streaming::Polled;
    info.perMotor = (id & kMotorBits) != 0;
    const bool isNew = m_registers.emplace(whole, std::move(info)).second;
    const int motor = static_cast<int>(id & kMotorBits);
    m_identifiable = m_identifiable || isNew || motor > m_identity.motors;
    m_identity.motors = std::max(m_identity.motors, motor);
}

/// Tells its identity again whenever more is known of it.
void ReplayDrive::identify()
{
    if (!std::exchange(m_identifiable, false))
        return;
    std::vector<catalog::RegisterInfo> all;
    for (const auto &[id, info] : m_registers)
        all.push_back(info);
    drive::Identified identified;
    identified.identity = m_identity;
    identified.catalog = std::make_shared<catalog::Catalog>(
        std::move(all), m_identity.motors, std::vector<catalog::Scales>());
    identified.limits.resize(static_cast<std::size_t>(m_identity.motors));
    identified.streaming.tickHz = m_tickHz;
    identified.capabilities = drive::noFeatures(kSentence);
    m_events.emplace_back(std::move(identified));
}

void ReplayDrive::submit(drive::Wish wish, TimePoint now)
{
    m_now = std::max(m_now, now);
    drive::Ended ended;
    ended.id = wish.id;
    if (const auto *wanted = std::get_if<drive::Read>(&wish.what)) {
        read(*wanted);
    } else if (!std::holds_alternative<drive::Watch>(wish.what)
        && !std::holds_alternative<drive::UserLimits>(wish.what)) {
        ended.outcome = drive::Outcome::NotSent;
        ended.reason = kReason;
    }
    if (wish.id != 0)
        m_events.emplace_back(std::move(ended));
}

/// The newest of what was recorded.
void ReplayDrive::read(const drive::Read &wish)
{
    drive::RegistersRead answer;
    for (const RegisterId id : wish.registers) {
        const auto known = m_values.find(id);
        answer.readings.push_back(known != m_values.end()
                ? known->second
                : drive::Reading{id, drive::ReadStatus::NotSupported, {}, m_now});
    }
    if (m_control)
        m_control->handed(answer.readings.size());
    m_events.emplace_back(std::move(answer));
}

void ReplayDrive::end(TimePoint now)
{
    if (std::exchange(m_ended, true))
        return;
    if (!m_decoder.isRecording()) {
        m_events.emplace_back(
            drive::LinkChanged{drive::LinkState::Lost, drive::LinkReason::OnlyGarbage});
        return;
    }
    m_events.emplace_back(drive::StreamStarted{});
    if (m_control && m_decoder.ending())
        m_control->told(m_position + m_shift, *m_decoder.ending());
    report(now, true);
}

void ReplayDrive::report(TimePoint now, bool always)
{
    if (!m_control || (!always && now - m_reported < kReportEvery && m_reported != TimePoint{}))
        return;
    m_reported = now;
    ReplayProgress progress = m_progress;
    progress.ended = m_ended;
    m_control->progressed(progress);
}

} // namespace recorded
