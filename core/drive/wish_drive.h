// What the drives of all protocols have in common: wishes and how they end, arming, a person's limits, the stop and its
// words, the motion log, what is told of the link. What goes over the wire, and when, is the business of the class made
// from this one.
#pragma once

#include "drive/board_facts.h"
#include "drive/drive.h"
#include "drive/motion_record.h"
#include "drive/stop_sequence.h"
#include "drive/wish_queue.h"

#include <map>

namespace drive {

/// Takes the answer that belongs to a wish which has ended meanwhile.
class NobodysTask : public Task {
public:
    std::optional<Bytes> nextRequest(TimePoint) override { return std::nullopt; }
    void takeResponse(ByteView, TimePoint) override { }
    void takeNoResponse(std::optional<bool>, TimePoint) override { }
};

class WishDrive : public Drive {
public:
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }
    void submit(Wish wish, TimePoint now) override;
    void stop(TimePoint now) override;
    bool stopOpen() const override { return m_stop.open(); }
    void arm() override;
    void disarm() override;
    bool armed() const override { return m_armed; }
    void doubt(TimePoint now) override;

protected:
    /// Takes the scale of a motor that there is. @return  why not; empty if it is taken
    virtual std::string takeScale(const CurrentScale &scale, TimePoint now);

    /// What the owner wants of the link.
    enum class Mode : std::uint8_t { Closed, Open, Closing };

    /// @param facts  of the class made from this one; outlives it
    explicit WishDrive(BoardFacts &facts)
        : m_facts(facts)
    {
    }

    // What a protocol brings.
    virtual void work(TimePoint now) = 0; ///< sends what is due, tells what has happened
    virtual std::unique_ptr<WishTask> taskFor(
        const Wish &wish) = 0; ///< for all but those done at once
    virtual void watch(const Watch &watch, TimePoint now) = 0;
    /// Sends the next request of the task; false: it has nothing to ask now.
    virtual bool give(Task &task, TimePoint now) = 0;
    /// What goes before states and wishes: the identification. True: the link is not there for anything else now.
    virtual bool sendFirst(TimePoint now) = 0;
    virtual void lookAtOnce(
        TimePoint now) = 0; ///< at the states of the motors, and often for a while

    void setArmed(bool armed);
    void endNow(const Wish &wish, Outcome outcome, std::string reason, TimePoint now);
    void cutAllWishes(const std::string &reason);
    /// Hands the answer to m_task, which is getting on by it.
    void takeAnswer(ByteView answer, TimePoint now);
    /// The answer to m_task has come, or never will: the link is free. What acts is looked at at once.
    void afterTask(TimePoint now);

    /// Gives a free link to whoever is most urgent. @param vitals, watch  of the class made from this one
    void sendNext(Task &vitals, Task &watch, TimePoint now);
    /// The newest states of motors: evidence for the stop, and told. @param askedAt  they are no older than this
    void takeStatuses(std::vector<MotorStatus> statuses, TimePoint askedAt);

    /// Takes motors that have become known into the stop. @return  whether STOPs may be due
    bool followStop(TimePoint now);
    /// A STOP leaves: notes it for the log.
    void noteStop(int motor, ByteView request, TimePoint now);
    /// Nothing may leave but STOP and the reading of states.
    bool stopHoldsBack(TimePoint now) const
    {
        return m_stop.exclusive() && (!m_stop.alarmed() || m_stop.blind(now));
    }
    /// Wishes that have ended, and the words of the stop, become events.
    void collectWishes();

    /// Tells the state of the link if it is another than was told last.
    void tellLink(LinkState state, LinkReason reason);
    void tell(LinkState state, LinkReason reason);
    void tellCounters(const LinkCounters &counters, TimePoint now);

    BoardFacts &m_facts;
    StopSequence m_stop;
    WishQueue m_wishes;
    Mode m_mode = Mode::Closed;
    NobodysTask m_nobody;
    Task *m_task = nullptr; ///< whose answer the link is waiting for
    std::optional<TimePoint> m_doubtedAt; ///< until the states have been read anew
    std::optional<LinkReason> m_lost; ///< since the link was lost, until it is there again
    LinkState m_toldState = LinkState::Closed;
    LinkReason m_toldReason = LinkReason::None;
    TimePoint m_workedAt;
    std::vector<Event> m_events;

private:
    bool giveToWish(TimePoint now);
    std::string refuseAcknowledge(const Wish &wish) const; ///< while the fault is there
    bool takeAtOnce(const Wish &wish, TimePoint now); ///< false: it takes a task
    void takeLimits(const Wish &wish, const UserLimits &limits, TimePoint now);
    void takeExpert(const Wish &wish, const ExpertMode &expert, TimePoint now);
    void takeScale(const Wish &wish, const CurrentScale &scale, TimePoint now);

    TimePoint m_stopAsked; ///< by a person
    std::map<int, MotionRecord> m_stopsSent; ///< by motor: the STOPs since the log was last told
    std::map<int, bool> m_faultNow; ///< by motor, as the newest state says
    bool m_cutAfterAnswer = false;
    bool m_armed = false;
    TimePoint m_countersAt;
    LinkCounters m_counters;
};

} // namespace drive
