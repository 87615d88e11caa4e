#include "drive/mcb/mcb_writes.h"

#include "drive/mcb/mcb_catalog.h"
#include "drive/mcb/mcb_commands.h"
#include "drive/mcb/mcb_messages.h"
#include "drive/set_point_check.h"
#include "drive/values.h"
#include "drive/write_check.h"

#include <algorithm>

namespace drive {

namespace {

bool sameValue(const Value &wanted, const Value &read)
{
    const auto a = asNumber(wanted), b = asNumber(read);
    if (a && b)
        return *a == *b || static_cast<float>(*a) == static_cast<float>(*b);
    return wanted == read;
}

} // namespace

McbWriteTask::McbWriteTask(WishId id, const Write &write, const McbBoard &board)
    : WishTask(id, Permission::Armed)
    , m_board(board)
    , m_reach(write.reach)
{
    for (const RegisterWrite &one : write.writes) {
        m_items.push_back({one, {}, false, false});
        m_items.back().result.id = one.id;
    }
}

/// Why it must not be written; empty if it may.
std::string McbWriteTask::check()
{
    const RegisterWrite &write = item().write;
    const auto *info = m_board.catalog->find(write.id);
    const std::uint16_t address = mcbAddressOf(write.id);
    if (isMcbMappingRegister(address))
        return "is set by streaming";
    if (address == mcbreg::kControl)
        return "the state machine is walked by start, stop and the acknowledging of faults";
    if (auto why = refuseWrite(m_board, write, m_reach); !why.empty())
        return why;
    if (info->effect == catalog::Effect::Mode) {
        const auto mode = static_cast<std::uint16_t>(asNumber(write.value).value_or(0.0));
        if (auto why = refuseControl(
                m_board, m_board.catalog->motorOf(write.id), mcbControlOf(mode), m_reach);
            !why.empty())
            return why;
        m_followed = mcbSetPointOf(mode);
    }
    auto words = mcbWordsOf(m_board, address, write.value);
    if (!words)
        return words.error();
    m_words = std::move(*words);
    return {};
}

std::optional<McbRequest> McbWriteTask::nextRequest(TimePoint)
{
    while (!finished()) {
        if (m_at >= m_items.size()) {
            finish();
            break;
        }
        if (item().done) {
            ++m_at;
            m_step = Step::Check;
            m_followed = 0;
            continue;
        }
        const std::uint16_t address = mcbAddressOf(item().write.id);
        switch (m_step) {
        case Step::Check:
            if (auto why = check(); !why.empty()) {
                close(Outcome::Refused, why);
                continue;
            }
            m_step = Step::Info;
            [[fallthrough]];
        case Step::Info:
            return mcbInfo(address);
        case Step::Before:
            if (m_board.readable(address))
                return mcbRead(address);
            m_step = Step::Followed;
            [[fallthrough]];
        case Step::Followed:
            if (m_followed != 0 && m_board.readable(m_followed))
                return mcbRead(m_followed);
            m_step = Step::Set;
            [[fallthrough]];
        case Step::Set:
            markSent();
            item().sent = true;
            return mcbWrite(address, m_words);
        case Step::After:
            if (m_board.readable(address))
                return mcbRead(address);
            close(item().result.outcome, item().result.reason);
            continue;
        }
    }
    return std::nullopt;
}

void McbWriteTask::takeResponse(const McbAnswer &answer, TimePoint now)
{
    if (finished() || m_at >= m_items.size() || item().done)
        return;
    const std::uint16_t address = mcbAddressOf(item().write.id);
    std::optional<Value> value;
    if (answer.ok && (m_step == Step::Before || m_step == Step::After)) {
        value = mcbValueOf(m_board, address, answer.words);
        if (value)
            m_readings.push_back({item().write.id, ReadStatus::Ok, *value, now});
    }
    switch (m_step) {
    case Step::Check:
        break;
    case Step::Info: {
        const bool told = answer.ok && answer.words.size() >= 2;
        if (!told)
            return close(Outcome::Refused, mcbWordOf(answer.code));
        if (mcb::infoOf({answer.words[0], answer.words[1], 0, 0}) != *m_board.infoOf(address)) {
            markBoardChanged();
            return close(Outcome::Refused, "has another type than it had");
        }
        m_step = Step::Before;
        break;
    }
    case Step::Before:
        item().result.before = value;
        m_step = Step::Followed;
        break;
    case Step::Followed: {
        const auto there = answer.ok ? mcbValueOf(m_board, m_followed, answer.words) : std::nullopt;
        const std::string why =
            there ? refuseNumber(m_board, {mcbIdOf(m_followed), *there}) : "is not known";
        if (!why.empty())
            return close(Outcome::Refused,
                m_board.catalog->nameOf(mcbIdOf(m_followed)) + ", which it would follow, is "
                    + why);
        m_step = Step::Set;
        break;
    }
    case Step::Set:
        if (!answer.ok)
            return close(Outcome::Refused, mcbWordOf(answer.code));
        item().result.outcome = Outcome::Ok;
        m_step = Step::After;
        break;
    case Step::After: {
        WriteResult &result = item().result;
        result.readBack = value;
        const bool same = value && sameValue(item().write.value, *value);
        if (result.outcome == Outcome::Unknown && value)
            return close(same ? Outcome::Ok : Outcome::Refused,
                same ? "" : "no answer, and another value is read back");
        close(result.outcome, result.reason);
        break;
    }
    }
}

void McbWriteTask::takeNoResponse(std::optional<bool> executed, TimePoint)
{
    if (finished() || m_at >= m_items.size() || item().done)
        return;
    if (m_step == Step::Info)
        return close(Outcome::NotSent, "no answer");
    if (m_step == Step::Before) {
        m_step = Step::Followed;
        return;
    }
    if (m_step == Step::Followed)
        return close(Outcome::NotSent, "no answer about what it would follow");
    if (m_step == Step::Set && executed.has_value() && !*executed)
        return close(Outcome::NotSent, "no answer");
    if (m_step == Step::After)
        return close(item().result.outcome, item().result.reason);
    item().result.outcome = Outcome::Unknown;
    item().result.reason = "no answer";
    m_step = Step::After;
}

void McbWriteTask::close(Outcome outcome, const std::string &reason)
{
    WriteResult &result = item().result;
    result.outcome = outcome;
    result.reason = reason;
    if (outcome == Outcome::Ok && result.readBack)
        result.verified = sameValue(item().write.value, *result.readBack);
    item().done = true;
}

void McbWriteTask::finish()
{
    // Unknown tells the most, then Refused, then NotSent.
    const auto weight = [](Outcome outcome) {
        return outcome == Outcome::Unknown ? 3
            : outcome == Outcome::Refused  ? 2
            : outcome == Outcome::NotSent  ? 1
                                           : 0;
    };
    Outcome outcome = Outcome::Ok;
    std::string reason;
    for (const Item &one : m_items) {
        if (weight(one.result.outcome) > weight(outcome)) {
            outcome = one.result.outcome;
            reason = m_board.catalog->nameOf(one.write.id) + ": " + one.result.reason;
        }
        writes().push_back(one.result);
    }
    end(outcome, reason);
}

void McbWriteTask::cut(const std::string &reason)
{
    if (finished())
        return;
    for (Item &one : m_items) {
        if (one.done)
            continue;
        const bool certain = one.sent && m_step == Step::After && one.result.outcome == Outcome::Ok;
        if (!certain) {
            one.result.outcome = one.sent ? Outcome::Unknown : Outcome::NotSent;
            one.result.reason = reason;
        }
        one.done = true;
    }
    finish();
}

void McbWriteTask::supersede(const Write &newer)
{
    for (Item &one : m_items) {
        const bool again = std::any_of(newer.writes.begin(), newer.writes.end(),
            [&](const RegisterWrite &write) { return write.id == one.write.id; });
        const bool begun =
            &one == &m_items[std::min(m_at, m_items.size() - 1)] && m_step != Step::Check;
        if (again && !one.done && !one.sent && !begun) {
            one.result.outcome = Outcome::NotSent;
            one.result.reason = "replaced by a newer write";
            one.done = true;
        }
    }
    if (!finished()
        && std::all_of(m_items.begin(), m_items.end(), [](const Item &i) { return i.done; }))
        finish();
}

} // namespace drive
