// Write wishes: a ledger of each register's value before, for undo, of what became of the write, and of the value after
// it, because an acknowledgement is not a proof. How the registers go out is up to the classes made from this one.
#pragma once

#include "drive/task.h"
#include "drive/values.h"

#include <algorithm>
#include <utility>

namespace drive {

template <class P>
class WriteTask : public WishTask<P> {
public:
    WriteTask(WishId id, const Write &write, const typename P::Facts &board)
        : WishTask<P>(id, Permission::Armed)
        , m_board(board)
        , m_reach(write.reach)
    {
        for (const RegisterWrite &one : write.writes) {
            m_items.push_back({one});
            m_items.back().result.id = one.id;
        }
    }

    void cut(const std::string &reason) override;
    void supersede(const Write &newer) override;
    std::vector<Reading> takeReadings() override { return std::exchange(m_readings, {}); }

protected:
    enum class State : std::uint8_t {
        Waiting,
        Open, ///< it has left
        Doubtful, ///< no answer says whether the board took it: what is read back decides
        Done
    };
    struct Item {
        RegisterWrite write;
        WriteResult result{};
        State state = State::Waiting;
        bool repeated = false;
    };

    /// Nothing of it has left, and a newer write may take its place.
    virtual bool replaceable(const Item &item) const = 0;
    /// What was read is what was to be written.
    virtual bool same(const RegisterWrite &write, const Value &read) const
    {
        return sameValue(write.value, read);
    }

    /// Of a reference: it is read as what is in force now, not as what was asked for last. What is asked for at rest is
    /// kept for the next start, and shown from then on.
    virtual bool showsInForce(const catalog::RegisterInfo &) const { return false; }

    /// The value before, if it was read a moment ago: then the write leaves without another read. Parameters
    /// alone: what a motor follows, firmware changes by itself.
    void recall(Item &item, TimePoint now)
    {
        const auto *info = m_board.catalog->find(item.write.id);
        const auto known = m_board.lately.find(item.write.id);
        if (info != nullptr && info->effect == catalog::Effect::Kept
            && known != m_board.lately.end() && now - known->second.asked <= LatelyRead::kHolds)
            item.result.before = known->second.value;
    }
    void endItem(Item &item, Outcome outcome, const std::string &reason = {})
    {
        item.state = State::Done;
        item.result.outcome = outcome;
        item.result.reason = reason;
    }
    void tell(Reading reading) { m_readings.push_back(std::move(reading)); }
    void finish();

    const typename P::Facts &m_board;
    const Reach m_reach;
    std::vector<Item> m_items;

private:
    void judge(Item &item);

    std::vector<Reading> m_readings;
};

/// All that can be known of it is known.
template <class P>
void WriteTask<P>::judge(Item &item)
{
    WriteResult &result = item.result;
    const bool asWanted = result.readBack && same(item.write, *result.readBack);
    const auto *info = m_board.catalog->find(item.write.id);
    const bool waits = !asWanted && result.before && result.readBack == result.before
        && info->effect == catalog::Effect::Reference && showsInForce(*info);
    if (item.state == State::Doubtful) {
        if (!result.readBack)
            endItem(item, Outcome::Unknown, kNoAnswer);
        else if (asWanted)
            endItem(item, Outcome::Ok);
        else if (waits)
            endItem(item, Outcome::Unknown, "no answer; if it was taken the next start goes to it");
        else
            endItem(item, Outcome::Refused, "no answer, and another value is read back");
    }
    if (!result.readBack || result.outcome != Outcome::Ok)
        return;
    if (waits)
        result.reason = "taken, and shown from the next start on, if the motor rests";
    else
        result.verified = asWanted;
}

template <class P>
void WriteTask<P>::finish()
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
    for (Item &item : m_items) {
        judge(item);
        if (weight(item.result.outcome) > weight(outcome)) {
            outcome = item.result.outcome;
            reason = m_board.catalog->nameOf(item.write.id) + ": " + item.result.reason;
        }
        this->writes().push_back(item.result);
    }
    this->end(outcome, reason);
}

template <class P>
void WriteTask<P>::cut(const std::string &reason)
{
    if (this->finished())
        return;
    for (Item &item : m_items) {
        if (item.state == State::Waiting)
            endItem(item, Outcome::NotSent, reason);
        else if (item.state == State::Open)
            endItem(item, Outcome::Unknown, reason);
    }
    finish();
}

template <class P>
void WriteTask<P>::supersede(const Write &newer)
{
    if (this->finished())
        return;
    bool left = false;
    for (Item &item : m_items) {
        const bool again = std::ranges::any_of(
            newer.writes, [&](const RegisterWrite &write) { return write.id == item.write.id; });
        if (again && replaceable(item))
            endItem(item, Outcome::NotSent, "replaced by a newer write");
        left = left || item.state != State::Done;
    }
    if (!left && !this->begun())
        finish();
}

} // namespace drive
