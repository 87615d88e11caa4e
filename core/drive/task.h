// A piece of work that asks the board something, one request after the other. A drive sends the request of the most
// urgent task whenever the link is free and hands the answer back to it. Tasks know no link and no clock.
#pragma once

#include "base/bytes.h"
#include "base/time.h"
#include "drive/event.h"
#include "drive/motion_record.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drive {

class Task {
public:
    Task() = default;
    Task(const Task &) = delete;
    Task &operator=(const Task &) = delete;
    virtual ~Task() = default;

    /// The next request's payload; nothing if it has nothing to ask now.
    virtual std::optional<Bytes> nextRequest(TimePoint now) = 0;
    virtual void takeResponse(ByteView response, TimePoint now) = 0;
    /// The answer was lost. `executed`: whether the board did what was asked, if the link can tell.
    virtual void takeNoResponse(std::optional<bool> executed, TimePoint now) = 0;
};

/// What has to be true for a wish to be carried out.
enum class Permission : std::uint8_t { Always, Armed };

/// The work for one wish. It ends once: finished() stays true and ended() says how.
class WishTask : public Task {
public:
    WishTask(WishId id, Permission permission)
        : m_permission(permission)
    {
        m_ended.id = id;
    }

    Permission permission() const { return m_permission; }
    bool finished() const { return m_finished; }
    const Ended &ended() const { return m_ended; }

    /// It was made then, or is getting on: the board has answered it then.
    void freshen(TimePoint now) { m_fresh = now; }
    void begin() { m_begun = true; } ///< its first request leaves
    /// It acts, nothing of it has left, and neither a person nor the board has been heard about it lately. A list of
    /// writes that move nothing goes on once it was begun in time, however slow the board is.
    bool expired(TimePoint now) const
    {
        const bool goesOn = m_sent || (m_begun && !m_motion);
        return m_permission == Permission::Armed && !goesOn && now > m_fresh + kWishExpiresAfter;
    }

    /// The act that the motion log is told of when this ends; empty: it is none.
    std::optional<MotionRecord> &motion() { return m_motion; }

    /// What it has read since the last call.
    virtual std::vector<Reading> takeReadings() { return {}; }
    /// A newer write of these registers was asked for: what has not left yet is not sent any more.
    virtual void supersede(const Write &) { }
    /// It acts on nothing, and waits behind those that do.
    virtual bool onlyReads() const { return false; }

    /// Nothing more will be sent for it (stop, link lost, disarmed): ends with what is known until now.
    virtual void cut(const std::string &reason)
    {
        if (!m_finished)
            end(m_sent ? Outcome::Unknown : Outcome::NotSent, reason);
    }

protected:
    void end(Outcome outcome, std::string reason = {})
    {
        m_finished = true;
        m_ended.outcome = outcome;
        m_ended.reason = std::move(reason);
    }
    void markSent() { m_sent = true; }
    bool sent() const { return m_sent; }
    std::vector<WriteResult> &writes() { return m_ended.writes; }

private:
    Ended m_ended;
    std::optional<MotionRecord> m_motion;
    Permission m_permission;
    TimePoint m_fresh{};
    bool m_begun = false;
    bool m_finished = false;
    bool m_sent = false; ///< something that can change the board has left
};

/// A wish that is refused whatever the board says.
class RefusedTask : public WishTask {
public:
    RefusedTask(WishId id, Permission permission, std::string reason)
        : WishTask(id, permission)
        , m_reason(std::move(reason))
    {
    }
    std::optional<Bytes> nextRequest(TimePoint) override
    {
        if (!finished())
            end(Outcome::Refused, m_reason);
        return std::nullopt;
    }
    void takeResponse(ByteView, TimePoint) override { }
    void takeNoResponse(std::optional<bool>, TimePoint) override { }

private:
    std::string m_reason;
};

} // namespace drive
