// A piece of work that asks the board something, one request after the other. A drive sends the request of the most
// urgent task whenever the link is free and hands the answer back to it. Tasks know no link and no clock.
#pragma once

#include "base/time.h"
#include "drive/event.h"
#include "drive/motion_entry.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace drive {

/// @tparam P  a protocol: its Request and Answer are the words of the task, and what the link takes and gives
template <class P>
class Task {
public:
    using Request = typename P::Request;
    using Answer = typename P::Answer;

    Task() = default;
    Task(const Task &) = delete;
    Task &operator=(const Task &) = delete;
    virtual ~Task() = default;

    /// Nothing if it has nothing to ask now.
    virtual std::optional<Request> nextRequest(TimePoint now) = 0;
    virtual void onResponse(const Answer &response, TimePoint now) = 0;
    /// The answer was lost. `executed`: whether the board did what was asked, if the link can tell.
    virtual void onNoResponse(std::optional<bool> executed, TimePoint now) = 0;
};

/// What has to be true for a wish to be carried out.
enum class Permission : std::uint8_t { Always, Armed };
template <class Act>
constexpr Permission permissionOf(const Act &)
{
    return Permission::Armed;
}
constexpr Permission permissionOf(const Command &command)
{
    return command.action == MotorAction::StopMotor ? Permission::Always : Permission::Armed;
}

/// How an answer ends what was asked.
struct AnswerEnd {
    Outcome outcome = Outcome::Ok;
    std::string reason{}; ///< the board's word, if it is not Ok
};

/// The command that it is where ST has named it so. @tparam Id  the commands of the protocol
template <class Id>
constexpr Id commandOf(MotorAction action)
{
    switch (action) {
    case MotorAction::Start:
        return Id::StartMotor;
    case MotorAction::StopMotor:
        return Id::StopMotor;
    case MotorAction::StopRamp:
        return Id::StopRamp;
    case MotorAction::AcknowledgeFaults:
        break;
    }
    return Id::FaultAck;
}

/// What becomes of one wish, whatever is asked for it. It ends once: finished() stays true and ended() says how.
class OpenWish {
public:
    OpenWish(WishId id, Permission permission)
        : m_permission(permission)
    {
        m_ended.id = id;
    }
    OpenWish(const OpenWish &) = delete;
    OpenWish &operator=(const OpenWish &) = delete;
    virtual ~OpenWish() = default;

    Permission permission() const { return m_permission; }
    bool finished() const { return m_finished; }
    const Ended &ended() const { return m_ended; }

    /// It was made then, or is getting on: the board has answered it then.
    void freshen(TimePoint now) { m_fresh = now; }
    void begin() { m_begun = true; } ///< its first request leaves
    /// It acts, nothing of it has left, and neither the user nor the board has been heard about it lately. A list of
    /// writes that move nothing goes on once it was begun in time, however slow the board is.
    bool expired(TimePoint now) const
    {
        const bool goesOn = m_sent || (m_begun && !m_motion);
        return m_permission == Permission::Armed && !goesOn && now > freshUntil();
    }
    TimePoint freshUntil() const { return m_fresh + kWishExpiresAfter; }
    /// Each part of what moves something leaves by then, or never does.
    std::optional<TimePoint> leaveBy() const
    {
        return m_permission == Permission::Armed && (m_motion || !m_begun)
            ? std::optional(freshUntil())
            : std::nullopt;
    }

    /// The board is not the one that was identified; said once.
    bool takeBoardChanged() { return std::exchange(m_boardChanged, false); }

    /// The act that the motion log is told of when this ends; empty: it is none.
    std::optional<MotionEntry> &motion() { return m_motion; }

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
        m_ended.byProgram = outcome == Outcome::Refused && !m_sent;
    }
    /// The same for a caller that has to return a request: there is none.
    std::nullopt_t noRequest(Outcome outcome, std::string reason = {})
    {
        end(outcome, std::move(reason));
        return std::nullopt;
    }
    /// As what leaves once ends whose answer was lost.
    void endLost(std::optional<bool> executed)
    {
        end(executed == false ? Outcome::NotSent : Outcome::Unknown, kNoAnswer);
    }
    void markSent() { m_sent = true; }
    void markBoardChanged() { m_boardChanged = true; }
    bool begun() const { return m_begun; }
    bool sent() const { return m_sent; }
    std::vector<WriteResult> &writes() { return m_ended.writes; }

private:
    Ended m_ended;
    std::optional<MotionEntry> m_motion;
    Permission m_permission;
    TimePoint m_fresh{};
    bool m_begun = false;
    bool m_finished = false;
    bool m_sent = false; ///< something that can change the board has left
    bool m_boardChanged = false;
};

/// The work for one wish.
template <class P>
class WishTask : public Task<P>, public OpenWish {
public:
    using OpenWish::OpenWish;
};

} // namespace drive
