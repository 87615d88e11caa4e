#include "drive/legacy/legacy_writes.h"

#include "drive/legacy/legacy_commands.h"
#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"

#include <algorithm>
#include <cmath>

namespace drive {

namespace {

/// Why the register cannot be asked for; empty if it can.
std::string refuseAddress(const LegacyFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    if (info == nullptr)
        return "no such register";
    if (info->perMotor && !board.hasMotor(board.catalog->motorOf(id)))
        return "no such motor";
    if (board.missing.contains(id))
        return "this motor does not have it";
    return {};
}

constexpr std::uint8_t kFinalSpeed = 0x5B;

bool sameValue(const Value &wanted, const Value &read)
{
    const auto a = asNumber(wanted), b = asNumber(read);
    if (a && b)
        return *a == *b || static_cast<float>(*a) == static_cast<float>(*b);
    return wanted == read;
}

/// Beyond what a stage may ask for: its speed, and where the scale is known its current.
std::string refuseStages(
    const LegacyFacts &board, int motor, const std::vector<legacy::RevUpStage> &stages)
{
    const double amps = board.ampsPerDigit(motor);
    for (const legacy::RevUpStage &stage : stages) {
        if (auto why = refuseLegacySpeed(board, motor, stage.speed_rpm); !why.empty())
            return why;
        if (amps > 0.0)
            if (auto why = refuseCurrent(board, motor, stage.torque * amps); !why.empty())
                return why;
    }
    return {};
}

} // namespace

std::optional<ReadStatus> LegacyProtocol::refuseRead(const LegacyFacts &board, RegisterId id)
{
    const auto *info = board.catalog->find(id);
    const bool readable = info != nullptr && info->readable();
    return readable && refuseAddress(board, id).empty() ? std::nullopt
                                                        : std::optional(ReadStatus::NotSupported);
}

LegacyWriteTask::LegacyWriteTask(WishId id, const Write &write, const LegacyFacts &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_reach(write.reach)
{
    for (const RegisterWrite &one : write.writes) {
        m_items.push_back({one, {}, false, {}});
        m_items.back().result.id = one.id;
    }
}

void LegacyWriteTask::addRequests(Item &item) const
{
    const RegisterId id = item.write.id;
    const auto add = [&](legacy::Command command) {
        item.requests.push_back({legacyMotor(id), std::move(command)});
    };
    if (isLegacyRevUp(id)) {
        const auto *raw = std::get_if<Bytes>(&item.write.value);
        const auto stages = raw != nullptr ? revUpStages(*raw) : std::nullopt;
        if (!stages) {
            item.result.reason = "takes 40 bytes";
            return;
        }
        item.result.reason = refuseStages(m_board, m_board.catalog->motorOf(id), *stages);
        std::uint8_t number = 0;
        for (const legacy::RevUpStage &stage : *stages)
            add(legacy::SetRevUp{number++, stage});
        return;
    }
    const legacy::Register *which = legacy::findRegister(m_board.dialect, legacyNumber(id));
    if (which == nullptr || which->writeBytes == 0) {
        item.result.reason = "cannot be written";
        return;
    }
    const auto bytes = legacyBytes(*which, item.write.value);
    if (!bytes) {
        item.result.reason = bytes.error();
        return;
    }
    item.result.reason = which->info.id == kFinalSpeed ? refuseLegacySpeed(m_board,
                             m_board.catalog->motorOf(id), asNumber(item.write.value).value_or(0.0))
                                                       : std::string();
    add(legacy::SetRegister{legacyNumber(id), *bytes});
}

void LegacyWriteTask::check(Item &item) const
{
    const auto *info = m_board.catalog->find(item.write.id);
    if (auto address = refuseAddress(m_board, item.write.id); !address.empty())
        item.result.reason = address;
    else if (auto why = refuseWrite(m_board, item.write, m_reach); !why.empty())
        item.result.reason = why;
    else if (info->effect == catalog::Effect::Mode)
        item.result.reason = refuseControl(m_board, m_board.catalog->motorOf(item.write.id),
            controlModeOf(static_cast<std::int64_t>(asNumber(item.write.value).value_or(0.0))),
            m_reach);
    if (item.result.reason.empty())
        addRequests(item);
    if (!item.result.reason.empty()) {
        item.done = true;
        item.result.outcome = Outcome::Refused;
    }
}

void LegacyWriteTask::beginReading(Phase phase)
{
    m_phase = phase;
    const auto *info = m_board.catalog->find(current().write.id);
    const bool readable = info != nullptr && info->readable();
    m_reader.start(readable ? std::vector{current().write.id} : std::vector<RegisterId>());
}

std::optional<legacy::Request> LegacyWriteTask::nextRequest(TimePoint)
{
    while (!finished()) {
        if (m_at >= m_items.size()) {
            finish();
            break;
        }
        Item &item = current();
        if (m_phase == Phase::Check) {
            if (!item.done)
                check(item);
            if (item.done) {
                ++m_at;
                continue;
            }
            m_request = 0;
            m_setSent = m_repeated = false;
            m_doubt.clear();
            beginReading(Phase::Before);
        }
        if (m_phase == Phase::Setting) {
            markSent();
            m_setSent = true;
            return item.requests[m_request];
        }
        if (!m_reader.finished())
            return m_reader.nextRequest();
        afterReading();
    }
    return std::nullopt;
}

void LegacyWriteTask::afterReading()
{
    if (m_phase == Phase::Before)
        m_phase = Phase::Setting;
    else
        judge(m_doubt);
}

void LegacyWriteTask::takeResponse(const legacy::Reply &response, TimePoint now)
{
    if (m_phase == Phase::Setting)
        return takeAnswer(response);
    for (Reading &reading : m_reader.takeResponse(response, now)) {
        auto &where =
            m_phase == Phase::Before ? current().result.before : current().result.readBack;
        if (reading.status == ReadStatus::Ok)
            where = reading.value;
        m_readings.push_back(std::move(reading));
    }
    if (m_reader.finished())
        afterReading();
}

void LegacyWriteTask::takeAnswer(const legacy::Reply &response)
{
    if (!std::holds_alternative<legacy::Ack>(response))
        return finishItem(Outcome::Refused, nackWord(response));
    m_repeated = false;
    if (++m_request >= current().requests.size())
        beginReading(Phase::After);
}

void LegacyWriteTask::takeNoResponse(std::optional<bool> executed, TimePoint)
{
    if (m_phase == Phase::Setting) {
        const bool notExecuted = executed.has_value() && !*executed;
        if (notExecuted && !std::exchange(m_repeated, true))
            return; // the board said that it did not understand: once more
        m_doubt = "no answer";
        return beginReading(Phase::After);
    }
    m_reader.takeNoResponse();
    if (m_reader.finished())
        afterReading();
}

void LegacyWriteTask::finishItem(Outcome outcome, const std::string &reason)
{
    current().done = true;
    current().result.outcome = outcome;
    current().result.reason = reason;
    m_phase = Phase::Check;
    ++m_at;
}

/// All that can be known of the register is known.
void LegacyWriteTask::judge(const std::string &doubt)
{
    WriteResult &result = current().result;
    const bool same = result.readBack && sameValue(current().write.value, *result.readBack);
    if (doubt.empty()) {
        if (result.readBack)
            result.verified = same;
        finishItem(Outcome::Ok, {});
    } else if (!result.readBack) {
        finishItem(Outcome::Unknown, doubt);
    } else if (same) {
        result.verified = true;
        finishItem(Outcome::Ok, {});
    } else {
        finishItem(Outcome::Refused, doubt + ", and another value is read back");
    }
}

void LegacyWriteTask::finish()
{
    Outcome outcome = Outcome::Ok;
    std::string reason;
    for (const Item &item : m_items) {
        // Unknown tells the most, then Refused, then NotSent.
        const auto weight = [](Outcome o) {
            return o == Outcome::Unknown ? 3
                : o == Outcome::Refused  ? 2
                : o == Outcome::NotSent  ? 1
                                         : 0;
        };
        if (weight(item.result.outcome) > weight(outcome)) {
            outcome = item.result.outcome;
            reason = m_board.catalog->nameOf(item.write.id) + ": " + item.result.reason;
        }
        writes().push_back(item.result);
    }
    end(outcome, reason);
}

void LegacyWriteTask::cut(const std::string &reason)
{
    if (finished())
        return;
    bool first = true;
    while (m_at < m_items.size()) {
        const bool sentNow = std::exchange(first, false) && m_phase != Phase::Check && m_setSent;
        finishItem(current().done ? current().result.outcome
                : sentNow         ? Outcome::Unknown
                                  : Outcome::NotSent,
            current().done ? current().result.reason : reason);
    }
    finish();
}

void LegacyWriteTask::supersede(const Write &newer)
{
    if (finished())
        return;
    bool left = false;
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        Item &item = m_items[i];
        const bool begun = i < m_at || (i == m_at && m_phase != Phase::Check);
        const bool again = std::any_of(newer.writes.begin(), newer.writes.end(),
            [&](const RegisterWrite &write) { return write.id == item.write.id; });
        if (again && !begun && !item.done) {
            item.done = true;
            item.result.outcome = Outcome::NotSent;
            item.result.reason = "replaced by a newer write";
        }
        left = left || !item.done;
    }
    if (!left && m_at == 0 && m_phase == Phase::Check)
        finish();
}

} // namespace drive
