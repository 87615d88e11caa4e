#include "drive/auto_drive.h"

#include <utility>

namespace drive {

namespace {

constexpr Duration kTryAgainAfter = std::chrono::milliseconds(500);

class AutoDrive final : public Drive {
public:
    explicit AutoDrive(std::vector<Candidate> candidates)
        : m_candidates(std::move(candidates))
        , m_drive(m_candidates.front().make(true))
    {
    }

    void connect(TimePoint now) override
    {
        m_open = true;
        m_reason = LinkReason::None;
        m_toldLost.reset();
        m_toldConnecting.reset();
        m_silent = false;
        m_stopAsked = false;
        m_hasty = true;
        tryCandidate(0, now);
    }
    void disconnect(TimePoint now) override
    {
        m_open = m_stopAsked = false;
        m_tryAgainAt.reset();
        m_drive->disconnect(now);
        sift(now);
    }
    void receive(ByteView bytes, TimePoint now) override
    {
        m_drive->receive(bytes, now);
        sift(now);
    }
    void handleTimeout(TimePoint now) override
    {
        if (m_tryAgainAt && now >= *m_tryAgainAt) {
            m_tryAgainAt.reset();
            m_hasty = false;
            return tryCandidate(0, now);
        }
        m_drive->handleTimeout(now);
        sift(now);
    }
    void handleSent(TimePoint now) override
    {
        m_drive->handleSent(now);
        sift(now);
    }
    std::vector<Output> takeOutput() override { return m_drive->takeOutput(); }
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const override
    {
        const auto due = m_drive->nextTimeout();
        return m_tryAgainAt && (!due || *m_tryAgainAt < *due) ? m_tryAgainAt : due;
    }
    void submit(Wish wish, TimePoint now) override
    {
        if (const auto *limits = std::get_if<UserLimits>(&wish.what))
            m_limits = *limits; // for the candidates that are still to come
        m_drive->submit(std::move(wish), now);
        sift(now);
    }
    void stop(TimePoint now) override
    {
        m_stopAsked = m_open && !m_settled; // in the language of whoever answers, then
        m_drive->stop(now);
        sift(now);
    }
    /// Before anybody has answered: in every language.
    std::vector<Output> stopScript() const override
    {
        std::vector<Output> script = m_drive->stopScript();
        for (std::size_t i = 0; i < m_candidates.size() && !m_settled; ++i) {
            if (i == m_which)
                continue;
            const auto other = m_candidates[i].make(true)->stopScript();
            script.insert(script.end(), other.begin(), other.end());
        }
        return script;
    }
    void arm() override
    {
        m_drive->arm();
        sift(m_now);
    }
    void disarm() override
    {
        m_drive->disarm();
        sift(m_now);
    }
    bool armed() const override { return m_drive->armed(); }
    void doubt(TimePoint now) override
    {
        m_drive->doubt(now);
        sift(now);
    }

private:
    void tryCandidate(std::size_t which, TimePoint now);
    void sift(TimePoint now);
    bool siftLink(const LinkChanged &change); ///< whether the candidate has failed
    void afterFailure(TimePoint now);

    std::vector<Candidate> m_candidates;
    std::unique_ptr<Drive> m_drive;
    std::size_t m_which = 0;
    bool m_open = false;
    bool m_settled = false; ///< the candidate's board has answered
    bool m_hasty = true; ///< the first round
    bool m_silent = false; ///< a round has failed: what is tried again is no news
    std::optional<LinkReason> m_toldConnecting; ///< with what was tried
    bool m_stopAsked =
        false; ///< before anybody had answered: each candidate has to stop what it finds
    bool m_repeating = false; ///< that a stop is wanted has been told
    std::optional<LinkReason> m_toldLost; ///< of the round before
    LinkReason m_reason = LinkReason::None; ///< the most telling one of this round's failures
    UserLimits m_limits;
    std::optional<TimePoint> m_tryAgainAt;
    TimePoint m_now;
    std::vector<Event> m_events;
};

void AutoDrive::tryCandidate(std::size_t which, TimePoint now)
{
    m_which = which;
    m_settled = false;
    m_drive = m_candidates[which].make(m_hasty);
    if (m_limits != UserLimits{})
        m_drive->submit({0, m_limits, Source::Person}, now);
    (void)m_drive->takeEvents(); // the log has these limits already
    m_drive->connect(now);
    if (m_stopAsked)
        m_drive->stop(now);
    m_repeating = m_stopAsked;
    sift(now);
    m_repeating = false;
}

bool AutoDrive::siftLink(const LinkChanged &change)
{
    switch (change.state) {
    case LinkState::Lost:
        if (m_reason == LinkReason::None || m_reason == LinkReason::NoAnswer)
            m_reason = change.reason;
        return true;
    case LinkState::Connecting:
        if (const LinkReason asking = m_candidates[m_which].asking;
            !m_silent && std::exchange(m_toldConnecting, asking) != asking)
            m_events.emplace_back(LinkChanged{change.state, asking});
        return false;
    case LinkState::Connected:
        m_settled = true;
        m_stopAsked = false;
        m_toldLost.reset();
        break;
    default:
        break;
    }
    m_toldConnecting.reset();
    m_silent = false;
    m_events.emplace_back(change);
    return false;
}

/// Hands the events on; a candidate that has found nobody makes room for the next one.
void AutoDrive::sift(TimePoint now)
{
    m_now = now;
    bool failed = false;
    for (Event &event : m_drive->takeEvents()) {
        const auto *change = std::get_if<LinkChanged>(&event);
        if (change != nullptr && m_open && !m_settled) {
            failed = siftLink(*change) || failed;
            continue;
        }
        if (auto *found = std::get_if<Identified>(&event)) {
            Identity &identity = found->identity;
            if (identity.evidence.empty())
                identity.evidence = m_candidates[m_which].evidence;
        }
        const auto *stop = std::get_if<StopProgress>(&event);
        if (!m_repeating || stop == nullptr || stop->word != StopWord::Requested)
            m_events.push_back(std::move(event));
    }
    if (failed)
        afterFailure(now);
}

void AutoDrive::afterFailure(TimePoint now)
{
    if (m_which + 1 < m_candidates.size())
        return tryCandidate(m_which + 1, now);
    // Nobody answered in any language: told once a round, and tried again.
    m_silent = true;
    const LinkReason reason = std::exchange(m_reason, LinkReason::None);
    if (m_toldLost != reason)
        m_events.emplace_back(LinkChanged{LinkState::Lost, reason});
    m_toldLost = reason;
    m_drive->disconnect(now);
    for (Event &event : m_drive->takeEvents())
        if (!std::holds_alternative<LinkChanged>(event))
            m_events.push_back(std::move(event));
    m_tryAgainAt = now + kTryAgainAfter;
}

} // namespace

std::unique_ptr<Drive> makeAutoDrive(std::vector<Candidate> candidates)
{
    return std::make_unique<AutoDrive>(std::move(candidates));
}

} // namespace drive
