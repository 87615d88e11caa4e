// Drive for a serial line whose protocol is not told. It tries the protocols one after the other and stays
// with the first whose board answers; from then on it is that protocol's drive, until disconnect().
//
// Order and why: first ASPEP, because the four bytes of its BEACON mean nothing to a board of the older protocol (a
// length that is too long, or a motor and a code that no board has) and a board of the newer one is left as it was.
// Then the older protocol, which begins with reads alone. In the first round the BEACONs end after a second: a board
// that is there and free answers the first. One that was left within a request needs many, and one that boots when the
// port opens may be silent for seconds: therefore ASPEP is tried once more behind the others before no answer is
// reported. Nothing that could move a motor is sent until the board is known.
//
// A board that refuses in the frames of another protocol has proved which one it speaks: that is tried next, and
// nothing else as long as its answers go on to prove it.
//
// A stop that is asked for before a board has answered goes out in every protocol: while it is sent blind, the
// candidates take turns, each with its own way of a stop without a link; then each stops what it finds.
#include "drive/protocol_table.h"
#include "drive/stop_sequence.h"

#include <algorithm>
#include <deque>
#include <utility>

namespace drive {

namespace {

constexpr Duration kTryAgainAfter = std::chrono::milliseconds(500);
/// How long a candidate may talk while a stop is sent blind: time for a STOP, and for the answer of a board.
constexpr Duration kTurn = StopSequence::kRepeat;

/// The word of a stop that the event tells to the user or to the motion log.
std::optional<StopWord> wordIn(const Event &event)
{
    if (const auto *progress = std::get_if<StopProgress>(&event))
        return progress->word;
    const auto *entry = std::get_if<MotionEntry>(&event);
    return entry != nullptr ? entry->stop : std::nullopt;
}

/// Whether this failure proves that a board of the row is there.
bool isProof(const ProtocolRow &row, LinkReason reason)
{
    return reason != LinkReason::None && std::ranges::find(row.proofs, reason) != row.proofs.end();
}

class AutoDrive final : public Drive {
public:
    AutoDrive(std::vector<const ProtocolRow *> candidates, const LineOptions &options)
        : m_candidates(std::move(candidates))
        , m_options(options)
        , m_drive(m_candidates.front()->make(options, Search::Hasty))
    {
    }

    void connect(TimePoint now) override
    {
        m_open = true;
        m_reason = LinkReason::None;
        m_toldLost.reset();
        m_toldConnecting.reset();
        m_stop.end();
        m_turnEnds.reset();
        m_proven.reset();
        m_stopBefore = false;
        planRound(true);
        tryNext(now);
    }
    void disconnect(TimePoint now) override
    {
        m_open = false;
        m_stop.end();
        m_turnEnds.reset();
        const bool between = std::exchange(m_tryAgainAt, std::nullopt).has_value();
        m_drive->disconnect(now);
        sift(now);
        if (between) // the last candidate was closed when it had failed
            m_events.emplace_back(LinkChanged{LinkState::Closed, LinkReason::None});
    }
    void receive(ByteView bytes, TimePoint now) override
    {
        m_drive->receive(bytes, now);
        sift(now);
    }
    void handleTimeout(TimePoint now) override
    {
        m_stop.handleTimeout(now);
        if (m_turnEnds && now >= *m_turnEnds)
            return takeTurn(now);
        if (m_tryAgainAt && now >= *m_tryAgainAt) {
            planRound(false);
            return tryNext(now);
        }
        m_drive->handleTimeout(now);
        sift(now);
    }
    void handleSent(TimePoint now) override
    {
        m_stopBefore = false;
        m_drive->handleSent(now);
        sift(now);
    }
    std::vector<Output> takeOutput() override;
    std::vector<Event> takeEvents() override { return std::exchange(m_events, {}); }
    std::optional<TimePoint> nextTimeout() const override
    {
        auto due = m_drive->nextTimeout();
        for (const auto &other : {m_tryAgainAt, m_turnEnds, m_stop.nextAlarm()})
            earliest(due, other);
        return due;
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
        if (!m_open || m_settled) {
            m_drive->stop(now);
            return sift(now);
        }
        m_repeating = m_stop.active();
        if (!m_repeating)
            m_stopAsked = now;
        m_stop.begin(1, now);
        m_turnEnds = now + kTurn;
        if (m_tryAgainAt) { // between two rounds
            planRound(false);
            startCandidate(takeNext(), now);
        } else {
            m_drive->stop(now);
        }
        sift(now);
        m_repeating = false;
    }
    /// Before any board has answered: in every protocol.
    std::vector<Output> stopScript() const override
    {
        std::vector<Output> script = m_drive->stopScript();
        for (std::size_t i = 0; i < m_candidates.size() && !m_settled; ++i) {
            if (i == m_which)
                continue;
            const auto other = make(i, true)->stopScript();
            script.insert(script.end(), other.begin(), other.end());
        }
        return script;
    }
    bool stopOpen() const override { return m_stop.active() || m_drive->stopOpen(); }
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
    Duration gathersFor() const override { return m_drive->gathersFor(); }
    void doubt(TimePoint now) override
    {
        m_drive->doubt(now);
        sift(now);
    }
    void remember(const LineMemory &memory) override { m_drive->remember(memory); }
    LineMemory memory() const override { return m_drive->memory(); }

private:
    std::unique_ptr<Drive> make(std::size_t which, bool hasty) const;
    void planRound(bool first);
    std::size_t takeNext();
    void tryNext(TimePoint now) { tryCandidate(takeNext(), now); }
    void tryCandidate(std::size_t which, TimePoint now);
    void startCandidate(std::size_t which, TimePoint now);
    void settle();
    void letGo(TimePoint now);
    void takeTurn(TimePoint now);
    void sift(TimePoint now);
    std::optional<LinkReason> siftLink(const LinkChanged &change); ///< why the candidate has failed
    void acceptProof(LinkReason reason);
    void afterFailure(LinkReason reason, TimePoint now);

    std::vector<const ProtocolRow *> m_candidates;
    LineOptions m_options;
    std::unique_ptr<Drive> m_drive;
    std::size_t m_which = 0;
    bool m_open = false;
    bool m_settled = false; ///< the candidate's board has answered
    std::deque<std::size_t> m_plan; ///< candidates still to come in this round
    std::optional<std::size_t> m_proven; ///< whose board it is
    bool m_followed = false; ///< in this round a proof has led to another one
    bool m_hasty = true; ///< the candidate comes once more in this round
    std::optional<LinkReason> m_toldConnecting; ///< with what was tried
    StopSequence m_stop; ///< asked for before any board had answered: its times and its alarm
    TimePoint m_stopAsked;
    std::optional<TimePoint> m_turnEnds; ///< of a candidate that stops blind
    bool m_stopBefore = false; ///< of the candidate before: it may not have left yet
    bool m_repeating = false; ///< that a stop is wanted has been told
    std::optional<LinkReason> m_toldLost; ///< of the round before: what is tried again is no news
    LinkReason m_reason = LinkReason::None; ///< the most telling one of this round's failures
    UserLimits m_limits;
    std::optional<TimePoint> m_tryAgainAt;
    TimePoint m_now;
    std::vector<Event> m_events;
};

/// A candidate's own STOP is more urgent than all before it, but for that of another language.
std::vector<Output> AutoDrive::takeOutput()
{
    std::vector<Output> outputs = m_drive->takeOutput();
    for (Output &output : outputs)
        output.dropsEarlier = output.dropsEarlier && !m_stopBefore;
    return outputs;
}

void AutoDrive::planRound(bool first)
{
    m_tryAgainAt.reset();
    m_plan.clear();
    m_followed = false;
    if (m_proven)
        return m_plan.push_back(*m_proven);
    for (std::size_t i = 0; i < m_candidates.size(); ++i)
        m_plan.push_back(i);
    for (std::size_t i = 0; first && i + 1 < m_candidates.size(); ++i)
        if (m_candidates[i]->hurries)
            m_plan.push_back(i);
}

std::size_t AutoDrive::takeNext()
{
    const std::size_t which = m_plan.front();
    m_plan.pop_front();
    m_hasty = std::ranges::find(m_plan, which) != m_plan.end();
    return which;
}

void AutoDrive::tryCandidate(std::size_t which, TimePoint now)
{
    m_repeating = m_stop.active();
    startCandidate(which, now);
    sift(now);
    m_repeating = false;
}

/// It starts with what the one before had found out of the line.
std::unique_ptr<Drive> AutoDrive::make(std::size_t which, bool hasty) const
{
    auto drive = m_candidates[which]->make(m_options, hasty ? Search::Hasty : Search::Patient);
    drive->remember(m_drive->memory());
    return drive;
}

/// It also stops what it finds, if that is wanted.
void AutoDrive::startCandidate(std::size_t which, TimePoint now)
{
    m_which = which;
    m_settled = false;
    m_stopBefore = m_repeating;
    m_drive = make(which, m_hasty);
    if (m_limits != UserLimits{})
        m_drive->submit({0, m_limits, Source::Person}, now);
    (void)m_drive->takeEvents(); // the log has these limits already
    m_drive->connect(now);
    if (m_stop.active())
        m_drive->stop(now);
}

void AutoDrive::settle()
{
    m_settled = true;
    LineMemory memory = m_drive->memory();
    memory.spoken = m_candidates[m_which]->choice.protocol;
    m_drive->remember(memory);
}

/// What was asked of a candidate ends with it.
void AutoDrive::letGo(TimePoint now)
{
    m_drive->disconnect(now);
    for (Event &event : m_drive->takeEvents())
        if (!std::holds_alternative<LinkChanged>(event))
            m_events.push_back(std::move(event));
}

/// The next candidate's turn to stop whatever is there; after the blind time the search goes on as without a stop.
void AutoDrive::takeTurn(TimePoint now)
{
    m_turnEnds.reset();
    if (m_proven == m_which)
        return;
    if (m_stop.blind(now))
        m_turnEnds = now + kTurn;
    letGo(now);
    tryCandidate((m_which + 1) % m_candidates.size(), now);
}

std::optional<LinkReason> AutoDrive::siftLink(const LinkChanged &change)
{
    switch (change.state) {
    case LinkState::Lost:
        if (m_reason == LinkReason::None || m_reason == LinkReason::NoAnswer)
            m_reason = change.reason;
        return change.reason;
    case LinkState::Connecting:
        if (const LinkReason asking = m_candidates[m_which]->asking;
            !m_toldLost && !m_turnEnds && std::exchange(m_toldConnecting, asking) != asking)
            m_events.emplace_back(LinkChanged{change.state, asking});
        return std::nullopt;
    case LinkState::Connected:
        settle();
        m_stop.end(); // the candidate has its own
        m_turnEnds.reset();
        m_toldLost.reset();
        break;
    default:
        break;
    }
    m_toldConnecting.reset();
    m_events.emplace_back(change);
    return std::nullopt;
}

/// Hands the events on; a candidate that has found no board makes room for the next one.
void AutoDrive::sift(TimePoint now)
{
    m_now = now;
    for (const StopProgress &progress : m_stop.takeProgress()) {
        if (progress.word != StopWord::NotConfirmed)
            continue; // the candidates tell the others
        m_events.emplace_back(entryOf(progress, m_stopAsked));
        m_events.emplace_back(progress);
    }
    std::optional<LinkReason> failed;
    for (Event &event : m_drive->takeEvents()) {
        const auto *change = std::get_if<LinkChanged>(&event);
        if (change != nullptr && m_open && !m_settled) {
            if (const auto why = siftLink(*change))
                failed = why;
            continue;
        }
        if (auto *found = std::get_if<Identified>(&event)) {
            Identity &identity = found->identity;
            if (identity.evidence.empty())
                identity.evidence = m_candidates[m_which]->evidence;
        }
        const auto word = wordIn(event);
        const bool toldAlready = (m_repeating && word == StopWord::Requested)
            || (m_stop.active() && word == StopWord::NotConfirmed);
        if (!toldAlready)
            m_events.push_back(std::move(event));
    }
    const bool proof = failed && std::ranges::any_of(m_candidates, [&](const ProtocolRow *row) {
        return isProof(*row, *failed);
    });
    if (failed && (!m_turnEnds || proof))
        afterFailure(*failed, now);
}

/// One that is led elsewhere twice in a round, by noise or by two boards, is proved nothing.
void AutoDrive::acceptProof(LinkReason reason)
{
    const auto proven = std::ranges::find_if(
        m_candidates, [&](const ProtocolRow *row) { return isProof(*row, reason); });
    if (proven == m_candidates.end()) {
        if (m_proven == m_which)
            m_proven.reset(); // nothing proves it any more: the next round asks for all
        return;
    }
    const auto which = static_cast<std::size_t>(proven - m_candidates.begin());
    if (which == m_which) {
        m_plan.clear();
        m_proven = which;
    } else if (!std::exchange(m_followed, true)) {
        m_plan.assign(1, which);
        m_proven = which;
    } else {
        m_proven.reset();
    }
}

void AutoDrive::afterFailure(LinkReason reason, TimePoint now)
{
    acceptProof(reason);
    if (!m_plan.empty())
        return tryNext(now);
    // No answer in any protocol: told once a round, and tried again.
    const LinkReason told = std::exchange(m_reason, LinkReason::None);
    if (m_toldLost != told)
        m_events.emplace_back(LinkChanged{LinkState::Lost, told});
    m_toldLost = told;
    letGo(now);
    m_tryAgainAt = now + kTryAgainAfter;
}

} // namespace

std::unique_ptr<Drive> makeAutoDrive(
    std::vector<const ProtocolRow *> candidates, const LineOptions &options)
{
    return std::make_unique<AutoDrive>(std::move(candidates), options);
}

} // namespace drive
