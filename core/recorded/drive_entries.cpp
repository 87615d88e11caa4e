#include "recorded/drive_entries.h"

#include "base/text.h"

#include <algorithm>
#include <array>

namespace recorded {

namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

std::string text(double value) { return decimalText(value); }

std::string text(const catalog::Value &value)
{
    if (const auto *number = std::get_if<std::int64_t>(&value))
        return std::to_string(*number);
    if (const auto *number = std::get_if<double>(&value))
        return text(*number);
    if (const auto *words = std::get_if<std::string>(&value))
        return *words;
    return hexOf(std::get<Bytes>(value), "", kLowerHex);
}

std::string text(const std::vector<std::string> &words)
{
    std::string all;
    for (const std::string &word : words)
        all += (all.empty() ? "" : " ") + word;
    return all;
}

template <std::size_t N, class Enum>
std::string word(const std::array<const char *, N> &words, Enum value)
{
    const auto index = static_cast<std::size_t>(value);
    return index < N ? words[index] : "?";
}

constexpr std::array kLinkReasons{"", "no answer", "only garbage", "no agreement", "silence",
    "recovery failed", "board reset", "old protocol", "asking newer", "asking older",
    "other protocol", "not ready", "dead line"};

Happening linkHappening(const drive::LinkChanged &link)
{
    return {"link",
        {{"state", word(kLinkStateWords, link.state)},
            {"reason", word(kLinkReasons, link.reason)}}};
}

/// A line of the motion log, with what it says and no more.
Happening motionHappening(const drive::MotionEntry &motion)
{
    const auto milliseconds = [](Duration time) {
        return text(std::chrono::duration<double, std::milli>(time).count());
    };
    Happening happening{"motion",
        {{"act", std::string(wordOf(motion.act))}, {"source", std::string(wordOf(motion.source))},
            {"asked s", text(toSeconds(motion.asked.time_since_epoch()))},
            {"took ms", milliseconds(motion.ended - motion.asked)},
            {"outcome", std::string(motion.stop ? wordOf(*motion.stop) : wordOf(motion.outcome))},
            {"requests", std::to_string(motion.requests)}}};
    if (motion.motor > 0)
        happening.fields.emplace_back("motor", std::to_string(motion.motor));
    if (!motion.detail.empty())
        happening.fields.emplace_back("detail", motion.detail);
    if (!motion.reason.empty())
        happening.fields.emplace_back("reason", motion.reason);
    for (const Bytes &request : motion.sent)
        happening.fields.emplace_back("bytes", hexOf(request, "", kLowerHex));
    return happening;
}

Happening statusHappening(const drive::MotorStatus &status)
{
    Happening happening{"motor state",
        {{"motor", std::to_string(status.motor)}, {"state", word(kMotorStateWords, status.state)},
            {"name", status.stateName}, {"raw", std::to_string(status.rawState)},
            {"faults now", text(status.faultsNow)}, {"faults past", text(status.faultsPast)}}};
    if (status.speedRpm)
        happening.fields.emplace_back("speed rpm", text(*status.speedRpm));
    return happening;
}

} // namespace

std::string DriveEntries::nameOf(RegisterId id) const
{
    return m_identified && m_identified->catalog ? m_identified->catalog->nameOf(id)
                                                 : std::to_string(id);
}

std::vector<Entry> DriveEntries::accept(const drive::Event &event)
{
    if (const auto *block = std::get_if<capture::SampleBlock>(&event))
        return {*block};
    if (const auto *started = std::get_if<drive::StreamStarted>(&event)) {
        m_layout = started->layout;
        return {started->layout};
    }
    if (const auto *read = std::get_if<drive::RegistersRead>(&event))
        return readings(*read);
    if (const auto *motor = std::get_if<drive::MotorStatus>(&event))
        return status(*motor);
    if (const auto *link = std::get_if<drive::LinkCounters>(&event))
        return counters(*link);
    if (const auto *end = std::get_if<drive::Ended>(&event))
        return ended(*end);
    if (const auto *motion = std::get_if<drive::MotionEntry>(&event))
        return {motionHappening(*motion)};
    if (const auto *link = std::get_if<drive::LinkChanged>(&event)) {
        m_link = *link;
        return {linkHappening(*link)};
    }
    if (const auto *identified = std::get_if<drive::Identified>(&event)) {
        m_identified = *identified;
        m_described.clear(); // another board may call them otherwise
        return {identity()};
    }
    if (const auto *cyclic = std::get_if<drive::CyclicSetPointsChanged>(&event))
        return {Happening{"cyclic set-points", {{"on", cyclic->on ? "yes" : "no"}}}};
    if (const auto *stop = std::get_if<drive::StopProgress>(&event))
        return {Happening{"stop",
            {{"motor", std::to_string(stop->motor)}, {"word", word(kStopWords, stop->word)}}}};
    return {};
}

Happening DriveEntries::identity() const
{
    const drive::Identity &board = m_identified->identity;
    return {"board",
        {{"protocol", board.protocol}, {"firmware", board.firmware}, {"version", board.version},
            {"control board", board.controlBoard}, {"power boards", text(board.powerBoards)},
            {"motors", text(board.motorNames)}, {"tick Hz", text(m_identified->streaming.tickHz)}}};
}

/// Not if it is read for a wish only. Values that come unasked, as from a replay, are signals.
bool DriveEntries::isSignal(RegisterId id) const
{
    return m_watched.contains(id) || std::ranges::none_of(m_readOnce, [id](const auto &wish) {
        return wish.second.contains(id);
    });
}

std::vector<Entry> DriveEntries::readings(const drive::RegistersRead &read)
{
    std::vector<Entry> entries;
    PolledValues polled;
    for (const drive::Reading &reading : read.readings) {
        const auto number = catalog::asNumber(reading.value);
        if (reading.status != drive::ReadStatus::Ok || !number || !m_identified
            || !m_identified->catalog || !isSignal(reading.id))
            continue;
        const catalog::Scale scale = m_identified->catalog->readScale(reading.id);
        if (m_described.insert(reading.id).second)
            entries.emplace_back(PolledRegister{reading.id, nameOf(reading.id), scale.unit});
        polled.values.push_back(
            {reading.id, reading.at.time_since_epoch().count(), *number * scale.factor});
    }
    if (!polled.values.empty())
        entries.emplace_back(std::move(polled));
    return entries;
}

std::vector<Entry> DriveEntries::status(const drive::MotorStatus &status)
{
    const auto before = m_status.find(status.motor);
    const bool same = before != m_status.end() && before->second.state == status.state
        && before->second.rawState == status.rawState
        && before->second.faultsNow == status.faultsNow
        && before->second.faultsPast == status.faultsPast;
    m_status[status.motor] = status;
    if (same)
        return {};
    return {statusHappening(status)};
}

std::vector<Entry> DriveEntries::counters(const drive::LinkCounters &counters)
{
    const drive::LinkCounters before = std::exchange(m_counters, counters);
    if (before.badPackets == counters.badPackets && before.nacks == counters.nacks
        && before.timeouts == counters.timeouts && before.recoveries == counters.recoveries
        && before.streamLostTicks == counters.streamLostTicks
        && before.streamSkipped == counters.streamSkipped)
        return {};
    return {Happening{"link trouble",
        {{"bad packets", std::to_string(counters.badPackets)},
            {"refused packets", std::to_string(counters.nacks)},
            {"timeouts", std::to_string(counters.timeouts)},
            {"recoveries", std::to_string(counters.recoveries)},
            {"lost ticks", std::to_string(counters.streamLostTicks)},
            {"skipped stream packets", std::to_string(counters.streamSkipped)}}}};
}

std::vector<Entry> DriveEntries::ended(const drive::Ended &ended)
{
    m_readOnce.erase(ended.id);
    if (m_waiting.erase(ended.id) == 0 && ended.writes.empty())
        return {};
    Happening happening{"ended",
        {{"wish", std::to_string(ended.id)}, {"outcome", word(kOutcomeWords, ended.outcome)},
            {"reason", ended.reason}}};
    for (const drive::WriteResult &write : ended.writes) {
        std::string words = word(kOutcomeWords, write.outcome);
        if (write.before)
            words += ", was " + text(*write.before);
        if (write.readBack)
            words += ", is " + text(*write.readBack);
        if (!write.reason.empty())
            words += ", " + write.reason;
        happening.fields.emplace_back(nameOf(write.id), words);
    }
    return {std::move(happening)};
}

std::vector<Entry> DriveEntries::accept(const drive::Wish &wish)
{
    using drive::RegisterWrite;
    Happening happening;
    if (const auto *command = std::get_if<drive::Command>(&wish.what)) {
        happening = {"command",
            {{"motor", std::to_string(command->motor)},
                {"action", word(kActionWords, command->action)}}};
    } else if (const auto *ramp = std::get_if<drive::SpeedRamp>(&wish.what)) {
        happening = {"speed ramp",
            {{"motor", std::to_string(ramp->motor)}, {"rpm", std::to_string(ramp->rpm)},
                {"ms", std::to_string(ramp->duration.count())}}};
    } else if (const auto *torque = std::get_if<drive::TorqueRamp>(&wish.what)) {
        happening = {"torque ramp",
            {{"motor", std::to_string(torque->motor)}, {"A", text(torque->amps)},
                {"ms", std::to_string(torque->duration.count())}}};
    } else if (const auto *reference = std::get_if<drive::CurrentReference>(&wish.what)) {
        happening = {"current reference",
            {{"motor", std::to_string(reference->motor)}, {"Iq A", text(reference->iqAmps)},
                {"Id A", text(reference->idAmps)}}};
    } else if (const auto *position = std::get_if<drive::PositionRamp>(&wish.what)) {
        happening = {"position ramp",
            {{"motor", std::to_string(position->motor)}, {"rad", text(position->radians)},
                {"ms", std::to_string(position->duration.count())}}};
    } else if (const auto *write = std::get_if<drive::Write>(&wish.what)) {
        happening.name = "write";
        for (const RegisterWrite &one : write->writes)
            happening.fields.emplace_back(nameOf(one.id), text(one.value));
    } else {
        if (const auto *watch = std::get_if<drive::Watch>(&wish.what)) {
            m_watched = {watch->registers.begin(), watch->registers.end()};
            m_watched.insert(watch->drawn.begin(), watch->drawn.end());
        } else if (const auto *read = std::get_if<drive::Read>(&wish.what)) {
            m_readOnce[wish.id] = {read->registers.begin(), read->registers.end()};
        }
        return {};
    }
    constexpr std::size_t kMostWaiting = 10'000;
    if (wish.id != 0 && m_waiting.size() < kMostWaiting)
        m_waiting.insert(wish.id);
    happening.fields.emplace_back("wish", std::to_string(wish.id));
    return {std::move(happening)};
}

Entry DriveEntries::stop() { return Happening{"stop", {{"word", "wanted"}}}; }

std::vector<Entry> DriveEntries::state()
{
    std::vector<Entry> entries;
    if (m_link)
        entries.emplace_back(linkHappening(*m_link));
    if (m_identified)
        entries.emplace_back(identity());
    for (const auto &[motor, status] : m_status)
        entries.emplace_back(statusHappening(status));
    if (m_layout && !m_layout->empty())
        entries.emplace_back(*m_layout);
    m_described.clear();
    return entries;
}

std::vector<Entry> DriveEntries::descriptions()
{
    m_described.clear();
    return m_layout ? std::vector<Entry>{*m_layout} : std::vector<Entry>{};
}

} // namespace recorded
