// What the drives of all protocols have in common: wishes and how they end, arming, the user's limits, the stop and its
// words, the motion log, what is told of the link. What goes over the wire, and when: drive/task_drive.h.
#pragma once

#include "drive/board_facts.h"
#include "drive/drive.h"
#include "drive/motion_entry.h"
#include "drive/stop_sequence.h"

#include <algorithm>
#include <map>

namespace drive {

/// What a board has to have for the wish; empty: every board can be asked for it.
std::optional<Feature> featureOf(const Wish &wish);

class WishDrive : public Drive {
public:
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }
    bool stopOpen() const override { return m_stop.open(); }
    void arm() override;
    bool armed() const override { return m_armed; }
    void doubt(TimePoint now) override;
    void remember(const LineMemory &memory) override { m_memory = memory; }
    LineMemory memory() const override { return m_memory; }

protected:
    /// Takes the scale of a motor that there is. @return  why not; empty if it is taken
    virtual std::string acceptScale(const CurrentScale &)
    {
        return m_facts.reasonAgainst(Feature::CurrentScale);
    }

    /// What the owner wants of the link.
    enum class Mode : std::uint8_t { Closed, Open, Closing };

    /// @param facts  of the class made from this one; outlives it
    explicit WishDrive(BoardFacts &facts)
        : m_facts(facts)
    {
    }

    virtual void work(TimePoint now) = 0; ///< sends what is due, tells what has happened
    virtual void watch(const Watch &watch, TimePoint now) = 0;
    virtual void limitsChanged() { } ///< the user's own
    /// At the states of the motors, and often for a while.
    virtual void lookAtOnce(TimePoint now) = 0;

    /// Carries out, or refuses, what takes no task; false: it takes one.
    bool handleAtOnce(const Wish &wish, TimePoint now);
    void beginStop(TimePoint now);
    void setArmed(bool armed);
    void endNow(const Wish &wish, Outcome outcome, std::string reason, TimePoint now);
    /// The newest states of motors: evidence for the stop, and told. @param askedAt  they are no older than this
    void followStatuses(std::vector<MotorStatus> statuses, TimePoint askedAt);

    /// Takes motors that have become known into the stop. @return  whether STOPs may be due
    bool followStop(TimePoint now);
    /// A STOP leaves: notes it for the log.
    void noteStop(int motor, ByteView request, TimePoint now);
    /// Nothing may leave but STOP and the reading of states.
    bool stopHoldsBack(TimePoint now) const
    {
        return m_stop.exclusive() && (!m_stop.alarmed() || m_stop.blind(now));
    }
    /// Also those that the board had when it was met last, until it tells how many it has.
    int motorsToStop() const
    {
        return m_facts.motorsCounted ? m_facts.motors : std::max(m_facts.motors, m_memory.motors);
    }
    void collectStop(); ///< its words become events

    /// Tells the state of the link if it is another than was told last.
    void tellLink(LinkState state, LinkReason reason);
    void tell(LinkState state, LinkReason reason);
    void tellCounters(const LinkCounters &counters, TimePoint now);

    BoardFacts &m_facts;
    LineMemory m_memory;
    StopSequence m_stop;
    Mode m_mode = Mode::Closed;
    std::optional<TimePoint> m_doubtedAt; ///< until the states have been read anew
    std::optional<LinkReason> m_lost; ///< since the link was lost, until it is there again
    LinkState m_toldState = LinkState::Closed;
    LinkReason m_toldReason = LinkReason::None;
    TimePoint m_workedAt;
    std::vector<Event> m_events;

private:
    std::string refuseAcknowledge(const Wish &wish) const; ///< while the fault is there
    // Each takes what it is given, or says why not.
    std::string accept(const UserLimits &limits);
    std::string accept(const ExpertMode &expert);
    std::string accept(const CurrentScale &scale);

    TimePoint m_stopAsked; ///< by the user
    std::map<int, MotionEntry> m_stopsSent; ///< by motor: the STOPs since the log was last told
    std::map<int, bool> m_faultNow; ///< by motor, as the newest state says
    bool m_armed = false;
    TimePoint m_countersAt;
    LinkCounters m_counters;
};

} // namespace drive
