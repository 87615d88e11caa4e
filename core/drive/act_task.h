// An act on a motor: what the board holds of it is read, then the act is judged, then its requests leave, in their
// order and each once. One whose answer is lost ends it Unknown (NotSent, if the link can tell that the board did
// nothing), and the state is read instead: an act is never carried out twice.
#pragma once

#include "drive/reader.h"
#include "drive/task.h"

#include <cmath>
#include <deque>

namespace drive {

/// @tparam P  with endIn(answer): how it ends what was asked
template <class P>
class ActTask : public WishTask<P> {
public:
    using Request = typename P::Request;
    using Answer = typename P::Answer;

    template <class Act>
    ActTask(WishId id, const Act &act, const typename P::Facts &board)
        : WishTask<P>(id, permissionOf(act))
        , m_board(board)
        , m_motor(act.motor)
    {
    }

    std::optional<Request> nextRequest(TimePoint now) override;
    void onResponse(const Answer &answer, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

protected:
    /// Why it must not be, whatever the board holds; empty if it may. Looked at again before the act leaves.
    virtual std::string refuse() const = 0;
    /// The registers that it is judged by.
    virtual std::vector<RegisterId> needs() const { return {}; }
    /// Why it is not sent where one of them was never answered.
    virtual std::string unread() const { return kNoAnswer; }
    /// Gives the requests, with what was read; none: it is done. @return  why it must not be; empty if it may, or was
    /// ended here
    virtual std::string plan() = 0;
    void request(Request one) { m_requests.push_back(std::move(one)); }

    /// Whether the board has done what was asked; else it is asked again, unless the act was ended here.
    virtual bool passes(const Request &, const Answer &, TimePoint) { return true; }
    /// What it has certainly not carried out goes out once more.
    virtual bool repeats() const { return false; }
    /// The board did not take this; nothing of the act is left.
    virtual void conclude(const Request &, AnswerEnd said)
    {
        this->end(said.outcome, std::move(said.reason));
    }
    virtual void onRead() { } ///< all that was to be read

    bool more() const { return m_requests.size() > 1; } ///< than the one that is asked
    std::optional<Value> held(RegisterId id) const
    {
        for (const Reading &reading : m_found)
            if (reading.id == id && reading.status == ReadStatus::Ok)
                return reading.value;
        return std::nullopt;
    }
    std::optional<double> numberHeld(RegisterId id) const ///< a finite one
    {
        const auto value = held(id);
        const auto number = value ? catalog::asNumber(*value) : std::nullopt;
        return number && std::isfinite(*number) ? number : std::nullopt;
    }

    const typename P::Facts &m_board;
    const int m_motor;
    Reader<P> m_reader{m_board};
    std::vector<Reading> m_found; ///< also what was refused

private:
    std::deque<Request> m_requests; ///< the first is asked
    bool m_begun = false, m_planned = false, m_repeated = false;
};

template <class P>
std::optional<typename P::Request> ActTask<P>::nextRequest(TimePoint)
{
    if (this->finished())
        return std::nullopt;
    if (!this->sent())
        if (auto why = refuse(); !why.empty())
            return this->noRequest(Outcome::Refused, std::move(why));
    if (!std::exchange(m_begun, true))
        m_reader.start(needs());
    if (!m_reader.finished())
        return m_reader.nextRequest();
    if (!std::exchange(m_planned, true)) {
        if (m_reader.gaveUp())
            return this->noRequest(Outcome::NotSent, unread());
        if (auto why = plan(); !why.empty())
            return this->noRequest(Outcome::Refused, std::move(why));
    }
    if (this->finished())
        return std::nullopt;
    if (m_requests.empty())
        return this->noRequest(Outcome::Ok);
    this->markSent();
    return m_requests.front();
}

template <class P>
void ActTask<P>::onResponse(const Answer &answer, TimePoint now)
{
    if (this->finished())
        return;
    if (!m_reader.finished()) {
        for (Reading &reading : m_reader.onResponse(answer, now))
            m_found.push_back(std::move(reading));
        if (m_reader.finished())
            onRead();
        return;
    }
    if (AnswerEnd said = P::endIn(answer); said.outcome != Outcome::Ok) {
        const Request asked = std::move(m_requests.front());
        m_requests.clear();
        return conclude(asked, std::move(said));
    }
    if (!passes(m_requests.front(), answer, now))
        return;
    m_requests.pop_front();
    if (m_requests.empty())
        this->end(Outcome::Ok);
}

template <class P>
void ActTask<P>::onNoResponse(std::optional<bool> executed, TimePoint)
{
    if (this->finished())
        return;
    if (!m_reader.finished()) {
        m_reader.onNoResponse();
        if (m_reader.finished())
            onRead();
    } else if (executed != false || !repeats() || std::exchange(m_repeated, true)) {
        this->endLost(executed);
    }
}

} // namespace drive
