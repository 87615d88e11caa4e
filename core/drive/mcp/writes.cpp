#include "drive/mcp/writes.h"

#include "drive/mcp/limits.h"
#include "mcp/datalog.h"
#include "motor/ramp.h"

#include <algorithm>
#include <cmath>

namespace drive {

namespace {

bool isPositionRamp(RegisterId id) { return (id & ~RegisterId{7}) == mcp::reg::kPositionRamp.bits; }

/// Why bytes of this length are not written over those that were read; empty if they may. The two that are written in
/// lengths of their own are looked at elsewhere: TORQUE_RAMP with the limits, REVUP_DATA by the board.
std::string refuseLength(const RegisterWrite &write, const Value &before)
{
    const auto *content = std::get_if<Bytes>(&write.value);
    const auto *old = std::get_if<Bytes>(&before);
    const RegisterId bare = write.id & ~RegisterId{7};
    if (content == nullptr || old == nullptr || content->size() == old->size()
        || bare == mcp::reg::kTorqueRamp.bits || bare == mcp::reg::kRevUpData.bits)
        return {};
    return "takes " + std::to_string(old->size()) + " bytes";
}

/// A SPEED_RAMP as the board keeps it.
Bytes keptSpeedRamp(ByteView written)
{
    ByteReader reader(written);
    const double rpm = motor::quantisedSpeed_rpm(reader.s32());
    return ByteWriter().s32(static_cast<std::int32_t>(rpm)).u16(reader.u16()).take();
}

/// Of what follows the id in a SET.
std::size_t sizeOf(const mcp::Value &value, RegisterId id)
{
    const auto *raw = std::get_if<Bytes>(&value);
    return raw != nullptr ? raw->size() + sizeof(std::uint16_t) : wireWidth(id);
}

} // namespace

/// What reads back otherwise than it was written: TORQUE_RAMP is shorter, speeds are kept in 0.1 Hz.
bool McpWriteTask::same(const RegisterWrite &write, const Value &read) const
{
    if (sameValue(write.value, read))
        return true;
    const auto *bytes = std::get_if<Bytes>(&write.value);
    const RegisterId bare = write.id & ~RegisterId{7};
    constexpr std::size_t kRampSize = 6;
    if (bytes == nullptr)
        return false;
    if (bare == mcp::reg::kTorqueRamp.bits && bytes->size() == kRampSize)
        return read == Value(Bytes{(*bytes)[0], (*bytes)[1], (*bytes)[4], (*bytes)[5]});
    if (bare == mcp::reg::kSpeedRamp.bits && bytes->size() == kRampSize)
        return read == Value(keptSpeedRamp(*bytes));
    return bare == mcp::reg::kRevUpData.bits && sameStages(write.value, read);
}

/// Why it must not be written; empty if it may, like that.
std::string McpWriteTask::check(const Item &item, mcp::Value &encoded) const
{
    if (mcp::isDatalogRegister({static_cast<std::uint16_t>(item.write.id)}))
        return kSetByStreaming;
    if (auto why = refuseWriteOf(m_board, item.write, m_reach); !why.empty())
        return why;
    auto value = wireValue(*m_board.catalog->find(item.write.id), item.write.value);
    if (!value)
        return value.error();
    if (const auto *raw = std::get_if<Bytes>(&*value); raw != nullptr && raw->empty())
        return "takes a byte or more";
    if (sizeOf(*value, item.write.id) + 4 > m_board.requestBytes)
        return "is longer than a request";
    encoded = std::move(*value);
    return {};
}

/// Whether it may follow in a SET of this size that has so many registers already.
bool McpWriteTask::joins(const Item &item, std::size_t size, std::size_t count) const
{
    const std::size_t width = wireWidth(item.write.id), at = size + sizeof(std::uint16_t);
    return !alone(item) && at + width <= m_board.requestBytes && at % width == 0
        && count + 2 <= m_board.responseBytes; // a status each and one for all
}

/// The next SET; its items are open then. Empty when nothing waits.
McpSet McpWriteTask::nextSet()
{
    McpSet set;
    std::size_t size = sizeof(std::uint16_t); // the command word
    for (std::size_t i = 0; i < m_items.size(); ++i) {
        Item &item = m_items[i];
        if (item.state != State::Waiting)
            continue;
        if (!set.writes.empty() && !joins(item, size, set.writes.size()))
            break;
        set.writes.push_back({{static_cast<std::uint16_t>(item.write.id)}, m_encoded[i]});
        size += sizeof(std::uint16_t) + wireWidth(item.write.id);
        item.state = State::Open;
        // Behind a byte the next id would be unaligned.
        if (alone(item) || wireWidth(item.write.id) == 1)
            break;
    }
    return set;
}

std::vector<McpWriteTask::Item *> McpWriteTask::open()
{
    std::vector<Item *> items;
    for (Item &item : m_items)
        if (item.state == State::Open)
            items.push_back(&item);
    return items;
}

std::vector<RegisterId> McpWriteTask::idsToRead(bool after) const
{
    std::vector<RegisterId> ids;
    for (const Item &item : m_items) {
        const auto *info = m_board.catalog->find(item.write.id);
        const bool wanted = after ? item.state == State::Doubtful
                || (item.state == State::Done && item.result.outcome == Outcome::Ok)
                                  : item.state == State::Waiting && !item.result.before;
        if (wanted && info != nullptr && info->readable() && !info->stub
            && std::ranges::find(ids, item.write.id) == ids.end())
            ids.push_back(item.write.id);
        const auto *position = m_board.catalog->find(kPosition);
        if (!after && wanted && position != nullptr && isPositionRamp(item.write.id))
            ids.push_back(
                m_board.catalog->withMotor(*position, m_board.catalog->motorOf(item.write.id)));
    }
    return ids;
}

/// The speed on the way to a position depends on where the shaft is, which has been read.
void McpWriteTask::judgeWays()
{
    for (Item &item : m_items) {
        const auto *bytes = std::get_if<Bytes>(&item.write.value);
        const auto *position = m_board.catalog->find(kPosition);
        if (item.state != State::Waiting || !isPositionRamp(item.write.id) || bytes == nullptr)
            continue;
        const int motor = m_board.catalog->motorOf(item.write.id);
        const auto at = position == nullptr
            ? m_numbers.end()
            : m_numbers.find(m_board.catalog->withMotor(*position, motor));
        const double now = at == m_numbers.end() ? NAN : at->second;
        if (auto why = refuseWay(m_board, motor, *positionIn(*bytes), now); !why.empty())
            endItem(item, Outcome::Refused, why);
    }
}

std::optional<McpRequest> McpWriteTask::nextRequest(TimePoint now)
{
    if (finished())
        return std::nullopt;
    if (m_phase == Phase::Begin) {
        m_encoded.resize(m_items.size());
        for (std::size_t i = 0; i < m_items.size(); ++i) {
            if (m_items[i].state != State::Waiting)
                continue;
            if (auto why = check(m_items[i], m_encoded[i]); !why.empty())
                endItem(m_items[i], Outcome::Refused, why);
            else
                recall(m_items[i], now);
        }
        enter(Phase::Before);
    }
    if (m_phase == Phase::Before) {
        if (!m_reader.finished())
            return m_reader.nextRequest();
        for (Item &item : m_items) {
            if (item.state != State::Waiting || !item.result.before)
                continue;
            if (const auto why = refuseLength(item.write, *item.result.before); !why.empty())
                endItem(item, Outcome::Refused, why);
        }
        judgeWays();
        enter(Phase::Setting);
    }
    if (m_phase == Phase::Setting) {
        if (McpSet set = nextSet(); !set.writes.empty()) {
            markSent();
            return set;
        }
        enter(Phase::After);
    }
    if (m_reader.finished()) {
        finish();
        return std::nullopt;
    }
    return m_reader.nextRequest();
}

void McpWriteTask::onAnswers(
    std::optional<Value> WriteResult::*where, const McpAnswer &answer, TimePoint now)
{
    for (Reading &reading : m_reader.onResponse(answer, now)) {
        for (Item &item : m_items)
            if (item.write.id == reading.id && reading.status == ReadStatus::Ok)
                item.result.*where = reading.value;
        if (const auto number = asNumber(reading.value); number && reading.status == ReadStatus::Ok)
            m_numbers[reading.id] = *number; // one of them may be where a shaft is
        tell(std::move(reading));
    }
}

void McpWriteTask::onResponse(const McpAnswer &answer, TimePoint now)
{
    if (m_phase == Phase::Before) {
        onAnswers(&WriteResult::before, answer, now);
    } else if (m_phase == Phase::After) {
        onAnswers(&WriteResult::readBack, answer, now);
        if (m_reader.finished())
            finish();
    } else {
        onStatuses(answer);
    }
}

void McpWriteTask::settle(Item &item, std::uint8_t status)
{
    if (status == static_cast<std::uint8_t>(mcp::Status::Ok))
        endItem(item, Outcome::Ok);
    else
        endItem(item, Outcome::Refused, statusWord(status));
}

/// Behind a value that cannot be parsed nothing is looked at. A NOK inside a list is a good one as the protocol is
/// printed.
void McpWriteTask::onStatuses(const McpAnswer &answer)
{
    constexpr auto kNok = static_cast<std::uint8_t>(mcp::Status::Nok);
    const std::vector<Item *> items = open();
    const auto told = answer.and_then([&](const mcp::Response &response) {
        return mcp::decodeSetAnswer(items.size(), response);
    });
    for (std::size_t i = 0; i < items.size(); ++i) {
        const bool known = told && !told->registers.empty();
        if (known && i >= told->registers.size())
            items[i]->state = State::Waiting;
        else if (!known || (items.size() > 1 && told->registers[i] == kNok))
            items[i]->state = State::Doubtful;
        else
            settle(*items[i], told->registers[i]);
    }
}

void McpWriteTask::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (m_phase != Phase::Setting) {
        m_reader.onNoResponse();
        if (m_phase == Phase::After && m_reader.finished())
            finish();
        return;
    }
    for (Item *item : open()) {
        // Raw registers may be ramps, which are never repeated.
        const bool raw = wireWidth(item->write.id) == 0;
        if (executed != false)
            item->state = State::Doubtful;
        else if (!raw && !std::exchange(item->repeated, true))
            item->state = State::Waiting;
        else
            endItem(*item, Outcome::NotSent, kNoAnswer);
    }
}

} // namespace drive
