// The engine of every drive: tasks and their answers, the order in which they get the link, stop, a lost link, leaving.
// A protocol brings what it asks and how it is sent (P below), and the hooks that have no answer here.
#pragma once

#include "drive/motion_entry.h"
#include "drive/read_task.h"
#include "drive/wish_drive.h"
#include "drive/wish_queue.h"

#include <algorithm>

namespace drive {

/// @tparam P  Request, Answer, Facts; Link, a sans-IO machine; Identification, Vitals and Watch, tasks; Writes, the
///            task of a write wish; stateSteps(), as in Identified
template <class P>
class TaskDrive : public WishDrive {
public:
    void connect(TimePoint now) override;
    void disconnect(TimePoint now) override;
    void receive(ByteView bytes, TimePoint now) override
    {
        m_link.receive(bytes, now);
        work(now);
    }
    void handleTimeout(TimePoint now) override
    {
        m_link.handleTimeout(now);
        m_stop.handleTimeout(now);
        work(now);
    }
    void handleSent(TimePoint now) override
    {
        if constexpr (requires { m_link.handleSent(now); }) {
            m_link.handleSent(now);
            work(now);
        }
    }
    std::vector<Output> takeOutput() override { return m_link.takeOutput(); }
    std::optional<TimePoint> nextTimeout() const override;
    void submit(Wish wish, TimePoint now) override;
    void stop(TimePoint now) override;
    void disarm() override;

protected:
    using Link = typename P::Link;
    using Request = typename P::Request;
    using Answer = typename P::Answer;
    using Made = std::unique_ptr<WishTask<P>>;

    template <class... Args>
    explicit TaskDrive(const typename Link::Config &config, Args... identification)
        : WishDrive(m_board)
        , m_link(config)
        , m_identification(m_board, identification...)
    {
    }

    /// After a lost link, until disconnect().
    static constexpr Duration kReconnectEvery = std::chrono::milliseconds(500);

    // What a protocol brings.
    /// For what commands and moves; nullptr: it is not there.
    virtual Made taskFor(const Wish &wish) = 0;
    virtual void onLinkEvents(TimePoint now) = 0;
    virtual bool connected() const = 0;
    /// Hands the request to the link. @param wish  that it is for; may be null
    /// @return  false: it is none that may leave
    virtual bool send(const Request &request, WishTask<P> *wish, TimePoint now) = 0;
    /// A link that holds requests back gives this one up if it has not left. @return  whether it had not
    virtual bool recall(TimePoint) { return false; }
    virtual void sendStop(int motor, TimePoint now) = 0; ///< one that is due and may leave
    virtual void closeLink() = 0;

    // What it may bring.
    virtual void onIdentified(TimePoint) { } ///< it has been told
    virtual bool recovering() const { return false; } ///< what was connected is out of step
    virtual LinkCounters counters() const { return {}; }
    virtual TimePoint stopMayLeave() const
    {
        return m_stopUnderWay ? m_stopSince + StopSequence::kRepeat : TimePoint{};
    }
    virtual std::optional<TimePoint> nextStop() const
    {
        const auto next = m_stop.nextStop(connected(), m_workedAt);
        return next ? std::optional(std::max(*next, stopMayLeave())) : std::nullopt;
    }
    /// True: the link is not there for anything else now.
    virtual bool sendFirst(TimePoint now)
    {
        if (m_board.identified)
            return false;
        give(m_identification, now);
        return true;
    }
    virtual void prepare(TimePoint) { } ///< before anything is sent
    virtual void leave() { } ///< adds the wishes that end what the board does by itself
    virtual Duration closingTime() const { return {}; } ///< that those wishes have
    virtual void onStatuses(const std::vector<MotorStatus> &) { }
    virtual void identifyAnew() { } ///< a wish has found another board
    virtual void collect(TimePoint now)
    {
        if (auto readings = m_watch.takeReadings(); !readings.empty())
            m_events.emplace_back(RegistersRead{std::move(readings)});
        m_wishes.collect(m_events, now);
        collectStop();
    }
    virtual std::optional<TimePoint> nextOwn() const { return std::nullopt; }
    virtual std::optional<TimePoint> nextWork() const { return std::nullopt; } ///< on a free link
    /// STOPs without a link do not hinder it.
    virtual bool reconnectsBlind() const { return false; }

    void work(TimePoint now) final;
    bool atRest() const
    {
        return m_mode == Mode::Open && connected() && m_board.identified && m_vitals.complete()
            && !m_vitals.motorDriven() && !m_stop.open() && !m_suspect && !armed();
    }
    bool linkIsFree() const { return m_link.canSend() && m_task == nullptr && !m_stopUnderWay; }
    /// Sends the next request of the task; false: it has nothing to ask now.
    bool give(Task<P> &task, TimePoint now, WishTask<P> *wish = nullptr);
    /// The answer to m_task has come, or never will: the link is free. What acts is looked at at once. Without one it
    /// is that to the STOP that is under way.
    void passAnswer(const Answer &answer, TimePoint now)
    {
        if (m_task == nullptr)
            return onStopAnswer(P::endIn(answer).outcome == Outcome::Ok, now);
        m_task->onResponse(answer, now);
        if (m_task == &m_watch && !m_doubtedAt) // else it may be older than what raised the doubt
            for (const Reading &reading : m_watch.readings())
                if (reading.status == ReadStatus::Ok)
                    m_board.lately[reading.id] = {reading.value, m_askedAt};
        if (m_wish != nullptr)
            m_wish->freshen(now);
        afterTask(now);
    }
    void passLoss(std::optional<bool> executed, TimePoint now)
    {
        m_task->onNoResponse(executed, now);
        afterTask(now);
    }
    /// The answer to the STOP that is under way, if one is.
    void onStopAnswer(bool ok, TimePoint now)
    {
        if (!std::exchange(m_stopUnderWay, false))
            return;
        if (ok)
            m_stop.stopAnswered(m_stopMotor, now);
        m_vitals.hurry(now);
    }
    void cutAllWishes(const std::string &reason);
    /// What is known of the board, also where it was told before.
    void tellIdentified()
    {
        m_board.identity.motors = m_board.motors;
        m_board.identity.knownFirmware = m_board.knownFirmware;
        m_board.states = P::stateSteps();
        m_events.emplace_back(static_cast<const Identified &>(m_board));
    }

    void linkFound()
    {
        m_lost.reset();
        m_reconnectAt.reset();
        m_suspect = false;
        m_board.lately.clear();
    }
    /// Behind linkFound(): all is found out anew. @param about  what the link was told of the board
    template <class... About>
    void meet(LinkReason reason, TimePoint now, const About &...about)
    {
        m_identification.restart(about...);
        m_vitals.restart(now);
        m_watch.restart(now);
        tell(LinkState::Connected, reason);
    }
    void linkLost(LinkReason reason, TimePoint now);
    /// What was under way is never answered, and what waits not asked.
    void forgetLink(const std::string &reason)
    {
        cutAllWishes(reason);
        m_task = nullptr;
        m_stopUnderWay = m_suspect = false;
        m_reconnectAt.reset();
    }

    typename P::Facts m_board;
    Link m_link;
    typename P::Identification m_identification;
    typename P::Vitals m_vitals{m_board};
    typename P::Watch m_watch{m_board};
    WishQueue<P> m_wishes;
    Task<P> *m_task = nullptr; ///< whose answer the link is waiting for
    /// Handed to the link, not answered; may wait behind m_task's answer.
    bool m_stopUnderWay = false;
    int m_stopMotor = 1; ///< whose
    TimePoint m_stopSince;
    bool m_suspect = false;
    std::optional<TimePoint> m_reconnectAt;

private:
    /// The last request of a wish only read. The watched take turns with such ones: a snapshot reads for seconds.
    bool m_readLast = false;

    void watch(const Watch &watch, TimePoint now) override { m_watch.watch(watch, now); }
    void lookAtOnce(TimePoint now) override { m_vitals.hurry(now); }
    /// What waits was asked for, and checked, under limits that hold no more.
    void limitsChanged() override
    {
        cutActing("the limits have changed", [](OpenWish &wish) {
            return wish.permission() == Permission::Armed && wish.motion().has_value();
        });
    }
    void cutActing(const std::string &reason, bool (*which)(OpenWish &));
    Made make(const Wish &wish);
    void endMissing(const Wish &wish, TimePoint now);
    void afterTask(TimePoint now);
    bool recallArmed(TimePoint now)
    {
        return m_wish != nullptr && m_wish->permission() == Permission::Armed && recall(now);
    }
    static bool acts(const WishTask<P> *wish) { return wish != nullptr && !wish->onlyReads(); }
    void sendNext(TimePoint now);
    bool giveToWish(TimePoint now);
    void close(TimePoint now);
    void tellLinkState();

    bool m_known = false; ///< the board, when it was looked at last
    TimePoint m_closeBy;
    TimePoint m_askedAt; ///< when m_task did last
    WishTask<P> *m_wish = nullptr; ///< m_task, if it is a wish's
    /// Takes the answer that belongs to a wish which has ended meanwhile.
    ReadTask<P> m_ended{0, Read{}, m_board};
    std::string m_cutAfterAnswer; ///< why m_wish ends when its answer has come; empty: it goes on
};

template <class P>
void TaskDrive<P>::connect(TimePoint now)
{
    forgetLink("connecting anew");
    m_mode = Mode::Open;
    m_lost.reset();
    m_link.connect(now);
    tellLinkState();
    work(now);
}

template <class P>
void TaskDrive<P>::disconnect(TimePoint now)
{
    if (m_mode != Mode::Open)
        return;
    m_workedAt = now;
    m_stop.end();
    setArmed(false);
    m_mode = Mode::Closing;
    m_closeBy = now + closingTime();
    recallArmed(now);
    cutAllWishes("disconnected");
    m_watch.watch({}, now);
    leave();
    work(now);
}

template <class P>
void TaskDrive<P>::close(TimePoint now)
{
    const bool busy = m_task != nullptr || m_wishes.next(false, now) != nullptr;
    if (busy && connected() && now < m_closeBy)
        return;
    forgetLink("disconnected");
    closeLink();
    m_stop.end();
    m_lost.reset();
    m_mode = Mode::Closed;
    collect(now);
}

template <class P>
void TaskDrive<P>::linkLost(LinkReason reason, TimePoint now)
{
    if (!m_lost || reason != LinkReason::NoAnswer)
        m_lost = reason; // "no answer" while trying again is no news
    setArmed(false);
    forgetLink("link lost");
    m_reconnectAt = now + kReconnectEvery;
}

template <class P>
std::optional<TimePoint> TaskDrive<P>::nextTimeout() const
{
    std::optional<TimePoint> due = m_link.nextTimeout();
    earliest(due, nextOwn());
    if (m_reconnectAt)
        earliest(due,
            m_stop.active() && !reconnectsBlind() ? std::max(*m_reconnectAt, m_stop.blindUntil())
                                                  : *m_reconnectAt);
    if (m_mode == Mode::Closing)
        earliest(due, m_closeBy);
    if (m_stop.active()) {
        earliest(due, m_stop.nextAlarm());
        earliest(due, nextStop());
    }
    // What is due already and was not sent waits for something else, which has its own timer.
    const auto considerLater = [&](std::optional<TimePoint> at) {
        if (at && *at > m_workedAt)
            earliest(due, at);
    };
    if (linkIsFree() && m_mode == Mode::Open) {
        considerLater(m_vitals.due());
        considerLater(nextWork());
        considerLater(m_watch.due());
        if (stopHoldsBack(m_workedAt))
            considerLater(m_stop.blindUntil());
    }
    return due;
}

template <class P>
void TaskDrive<P>::stop(TimePoint now)
{
    if (m_mode == Mode::Closed)
        return;
    m_cutAfterAnswer = m_task != nullptr ? "stopped" : "";
    m_wishes.cut("stopped", m_wish);
    beginStop(now);
    work(now);
}

template <class P>
void TaskDrive<P>::disarm()
{
    setArmed(false);
    const bool recalled = recallArmed(m_workedAt);
    cutActing("disarmed", [](OpenWish &wish) { return wish.permission() == Permission::Armed; });
    if (recalled)
        work(m_workedAt); // the link is free
}

/// The one whose answer is due ends with it, also after arming again.
template <class P>
void TaskDrive<P>::cutActing(const std::string &reason, bool (*which)(OpenWish &))
{
    m_wishes.cut(reason, m_wish, which);
    if (m_wish != nullptr && which(*m_wish) && m_cutAfterAnswer.empty())
        m_cutAfterAnswer = reason;
    m_wishes.collect(m_events, m_workedAt);
}

template <class P>
void TaskDrive<P>::cutAllWishes(const std::string &reason)
{
    m_wishes.cut(reason, nullptr);
    if (std::exchange(m_wish, nullptr) != nullptr)
        m_task = &m_ended;
    m_cutAfterAnswer.clear();
    m_wishes.collect(m_events, m_workedAt);
}

template <class P>
typename TaskDrive<P>::Made TaskDrive<P>::make(const Wish &wish)
{
    if (const auto *read = std::get_if<Read>(&wish.what))
        return std::make_unique<ReadTask<P>>(wish.id, *read, m_board);
    if (const auto *write = std::get_if<Write>(&wish.what))
        return std::make_unique<typename P::Writes>(wish.id, *write, m_board);
    return taskFor(wish);
}

/// What is not there is refused with the reason; to end a stream that is not there is no failure.
template <class P>
void TaskDrive<P>::endMissing(const Wish &wish, TimePoint now)
{
    const auto *stream = std::get_if<Stream>(&wish.what);
    if (stream != nullptr && stream->fast.empty() && stream->slow.empty())
        return endNow(wish, Outcome::Ok, {}, now);
    const auto feature = featureOf(wish);
    endNow(wish, Outcome::Refused, feature ? m_board.reasonAgainst(*feature) : "is not there", now);
}

template <class P>
void TaskDrive<P>::submit(Wish wish, TimePoint now)
{
    if (handleAtOnce(wish, now))
        return;
    Made task = make(wish);
    const auto feature = featureOf(wish);
    const bool records = feature == Feature::Stream || feature == Feature::CyclicSetPoints;
    if ((task ? task->permission() == Permission::Armed : !records) && !armed())
        return endNow(wish, Outcome::NotSent,
            m_stop.active() ? "stopped; arm again first" : "not armed", now);
    if (!task)
        return endMissing(wish, now);
    task->freshen(std::min(wish.madeAt.value_or(now), now));
    if (task->expired(now))
        return endNow(wish, Outcome::NotSent, kTooLate, now);
    task->motion() = motionOf(wish, *m_facts.catalog, now);
    if (const auto *write = std::get_if<Write>(&wish.what))
        m_wishes.supersede(*write);
    if (!m_wishes.add(std::move(task)))
        return endNow(wish, Outcome::NotSent, "too many wishes wait already", now);
    work(now);
}

template <class P>
void TaskDrive<P>::afterTask(TimePoint now)
{
    m_task = nullptr;
    WishTask<P> *wish = std::exchange(m_wish, nullptr);
    const std::string cut = std::exchange(m_cutAfterAnswer, {});
    if (wish == nullptr)
        return;
    const bool changed = wish->takeBoardChanged();
    if (!cut.empty())
        wish->cut(cut);
    if (wish->finished() && wish->permission() == Permission::Armed)
        lookAtOnce(now); // whatever became of it
    if (changed)
        identifyAnew();
}

template <class P>
void TaskDrive<P>::work(TimePoint now)
{
    m_workedAt = now;
    onLinkEvents(now);
    if (m_link.canSend())
        m_stopUnderWay = false; // its answer has come, or never will
    auto statuses = m_vitals.takeStatuses();
    onStatuses(statuses);
    followStatuses(std::move(statuses), m_vitals.askedAt());
    const bool known = m_board.identified;
    if (!std::exchange(m_known, known) && known) {
        tellIdentified();
        m_vitals.hurry(now); // there may be more to be read of them
        onIdentified(now);
    }
    if (m_reconnectAt && now >= *m_reconnectAt && m_mode == Mode::Open
        && (reconnectsBlind() || !m_stop.blind(now))) {
        m_reconnectAt.reset();
        m_link.connect(now);
    }
    prepare(now);
    if constexpr (requires { m_watch.setAtRest(true); })
        m_watch.setAtRest(atRest());
    if (followStop(now) && now >= stopMayLeave())
        if (const auto motor = m_stop.stopDue(now, connected()))
            sendStop(*motor, now);
    if (linkIsFree())
        sendNext(now);
    collect(now);
    if (m_mode == Mode::Closing)
        close(now);
    tellLinkState();
    tellCounters(counters(), now);
}

/// Gives a free link to the most urgent task.
template <class P>
void TaskDrive<P>::sendNext(TimePoint now)
{
    const bool open = m_mode == Mode::Open;
    if (open) {
        if (m_stop.open() && !m_facts.motorsCounted && sendFirst(now))
            return; // an unknown motor cannot be stopped
        if (m_stop.active() && give(m_vitals, now))
            return;
        if (stopHoldsBack(now) || sendFirst(now) || give(m_vitals, now))
            return;
    }
    if (open && std::exchange(m_readLast, false) && !acts(m_wishes.next(armed(), now))
        && give(m_watch, now))
        return;
    if (!giveToWish(now) && open)
        give(m_watch, now);
}

template <class P>
bool TaskDrive<P>::giveToWish(TimePoint now)
{
    while (WishTask<P> *wish = m_wishes.next(armed(), now)) {
        if (give(*wish, now, wish)) {
            m_readLast = wish->onlyReads();
            wish->begin();
            return true;
        }
        if (!wish->finished())
            return false; // waits for something else; no other wish overtakes it
        m_wishes.collect(m_events, m_workedAt);
    }
    return false;
}

template <class P>
bool TaskDrive<P>::give(Task<P> &task, TimePoint now, WishTask<P> *wish)
{
    while (const auto request = task.nextRequest(now)) {
        if (send(*request, wish, now)) {
            m_task = &task;
            m_wish = wish;
            m_askedAt = now;
            if (acts(wish))
                m_board.lately.clear();
            return true;
        }
        task.onNoResponse(false, now); // it never left
    }
    return false;
}

template <class P>
void TaskDrive<P>::tellLinkState()
{
    // A link may go on with what was agreed before; where nothing has answered since, there is nothing to recover.
    const bool comesBack = recovering() && m_toldState != LinkState::Connecting;
    const LinkState state = m_mode == Mode::Closed ? LinkState::Closed
        : m_lost                                   ? LinkState::Lost
        : !connected() && !comesBack               ? LinkState::Connecting
        : m_suspect                                ? LinkState::Suspect
        : comesBack                                ? LinkState::Recovering
                                                   : LinkState::Connected;
    const LinkReason reason = state == LinkState::Lost ? *m_lost
        : state == m_toldState                         ? m_toldReason
                                                       : LinkReason::None;
    tellLink(state, reason);
}

} // namespace drive
