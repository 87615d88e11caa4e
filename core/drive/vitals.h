// The states of the motors, read over and over: what the user must always be able to trust. Slow while nothing happens,
// fast while a start or a stop is under way, or after something was commanded. Decides what is asked next; the owner of
// the link decides when.
#pragma once

#include "catalog/names.h"
#include "drive/reader.h"
#include "drive/stop_sequence.h"
#include "drive/task.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace drive {

inline constexpr Duration kVitalsEvery = std::chrono::milliseconds(100);
inline constexpr Duration kVitalsFast = std::chrono::milliseconds(20);
inline constexpr Duration kVitalsHurry = std::chrono::milliseconds(500); ///< how long it stays fast
inline constexpr Duration kVitalsPause = std::chrono::milliseconds(250); ///< at most, for others
/// A round that took longer is of two times.
inline constexpr Duration kVitalsRound = std::chrono::milliseconds(500);

inline constexpr std::int64_t kInrushWait = 12; ///< the state ICLWAIT, in all of ST's firmware

/// A step of a run, by the numbers that firmware has for the states that it covers.
struct NumberedStep {
    MotorState state = MotorState::Unknown;
    std::initializer_list<std::int64_t> numbers;
};
/// As ST's firmware tells it. @param state  nothing: it is refused
/// @param faults  those that are present in its upper half, those that have been in the lower one
inline MotorStatus numberedStatus(std::span<const NumberedStep> steps,
    std::string (*nameOf)(std::int64_t), std::optional<double> state, std::optional<double> faults)
{
    MotorStatus status;
    if (state) {
        status.rawState = static_cast<std::int64_t>(*state);
        for (const NumberedStep &step : steps)
            if (std::ranges::find(step.numbers, status.rawState) != step.numbers.end())
                status.state = step.state;
        status.stateName = nameOf(status.rawState);
        status.waitsForBus = status.rawState == kInrushWait;
    }
    const auto bits = static_cast<std::uint32_t>(faults.value_or(0.0));
    status.faultsNow = catalog::faultNames(static_cast<std::uint16_t>(bits >> 16));
    status.faultsPast = catalog::faultNames(static_cast<std::uint16_t>(bits));
    return status;
}
inline std::vector<StateStep> namedSteps(
    std::span<const NumberedStep> steps, std::string (*nameOf)(std::int64_t))
{
    std::vector<StateStep> named;
    for (const NumberedStep &step : steps) {
        named.push_back({step.state, {}});
        for (const std::int64_t number : step.numbers)
            named.back().names.push_back(nameOf(number));
    }
    return named;
}

template <class P>
class Vitals : public Task<P> {
public:
    explicit Vitals(const typename P::Facts &board)
        : m_board(board)
    {
    }

    void restart(TimePoint now); ///< a new connection: nothing known counts any more
    /// Something was commanded: read at once and fast for a while.
    void hurry(TimePoint now)
    {
        m_fastUntil = now + kVitalsHurry;
        if (m_due)
            m_due = now;
    }
    std::optional<TimePoint> due() const { return m_due; }
    /// Every motor has been read at least once since restart().
    bool complete() const { return m_complete; }
    /// One was last seen not idle.
    bool motorDriven() const
    {
        return std::ranges::any_of(
            m_latest, [](const auto &one) { return !isDriveIdle(one.second); });
    }

    std::optional<typename P::Request> nextRequest(TimePoint now) override;
    void onResponse(const typename P::Answer &response, TimePoint now) override;
    void onNoResponse(std::optional<bool> executed, TimePoint now) override;

    /// What was read since the last call.
    std::vector<MotorStatus> takeStatuses() { return std::exchange(m_news, {}); }
    /// When the round behind the newest statuses began: evidence is never older than this.
    TimePoint askedAt() const { return m_askedAt; }

protected:
    // What a protocol brings.
    virtual std::vector<RegisterId> idsToRead() = 0; ///< of a round that begins
    /// What the answers call for; empty: the round is over.
    virtual std::vector<RegisterId> idsBehind() { return {}; }
    /// All but the motor's number and the time; nothing if it was not told this time.
    virtual std::optional<MotorStatus> statusOf(int motor) const = 0;

    const Value *valueOf(RegisterId id) const ///< that this round has read
    {
        const auto at = m_round.find(id);
        return at == m_round.end() ? nullptr : &at->second;
    }
    std::optional<double> numberOf(RegisterId id) const ///< the same, if it is one
    {
        const Value *value = valueOf(id);
        return value != nullptr ? catalog::asNumber(*value) : std::nullopt;
    }
    std::set<RegisterId> m_refused; ///< by the board, since restart()
    const typename P::Facts &m_board;

private:
    void begin(TimePoint now)
    {
        m_round.clear();
        m_reader.start(idsToRead());
        m_roundAsked = now;
    }
    void afterAnswer(TimePoint now);
    void publish(TimePoint now);

    Reader<P> m_reader{m_board};
    std::map<RegisterId, Value> m_round;
    std::map<int, MotorStatus> m_latest;
    std::vector<MotorStatus> m_news;
    std::optional<TimePoint> m_due;
    TimePoint m_fastUntil, m_askedAt, m_roundAsked;
    bool m_complete = false;
    bool m_again = false; ///< the round before took too long
};

template <class P>
void Vitals<P>::restart(TimePoint now)
{
    m_reader.clear();
    m_round.clear();
    m_refused.clear();
    m_latest.clear();
    m_news.clear();
    m_due = m_fastUntil = now;
    m_complete = m_again = false;
}

template <class P>
std::optional<typename P::Request> Vitals<P>::nextRequest(TimePoint now)
{
    if (m_reader.finished()) {
        if (!m_due || now < *m_due)
            return std::nullopt;
        begin(now);
    }
    return m_reader.nextRequest();
}

template <class P>
void Vitals<P>::onResponse(const typename P::Answer &response, TimePoint now)
{
    if (m_reader.finished())
        return; // begun anew while it was asked
    for (Reading &reading : m_reader.onResponse(response, now)) {
        if (reading.status == ReadStatus::Ok)
            m_round[reading.id] = std::move(reading.value);
        else
            m_refused.insert(reading.id);
    }
    afterAnswer(now);
}

template <class P>
void Vitals<P>::onNoResponse(std::optional<bool>, TimePoint now)
{
    if (m_reader.finished())
        return;
    m_reader.onNoResponse();
    afterAnswer(now);
}

template <class P>
void Vitals<P>::afterAnswer(TimePoint now)
{
    if (!m_reader.finished())
        return;
    if (const auto ids = idsBehind(); !ids.empty())
        return m_reader.start(ids);
    // The board may have been reset in the middle. Once: a line on which every round is that long has no better.
    if (now - m_roundAsked > kVitalsRound && !std::exchange(m_again, true))
        return begin(now);
    m_again = false;
    publish(now);
}

template <class P>
void Vitals<P>::publish(TimePoint now)
{
    m_askedAt = m_roundAsked;
    m_complete = true;
    for (int motor = 1; motor <= m_board.motors; ++motor) {
        auto status = statusOf(motor);
        m_complete = m_complete && status.has_value();
        if (!status)
            continue;
        status->motor = motor;
        status->at = now;
        status->asked = m_roundAsked;
        m_latest[motor] = *status;
        m_news.push_back(std::move(*status));
    }
    const bool underWay = std::ranges::any_of(m_latest, [](const auto &one) {
        const MotorState state = one.second.state;
        return state == MotorState::Starting || state == MotorState::Stopping;
    });
    const Duration period = underWay || now < m_fastUntil ? kVitalsFast : kVitalsEvery;
    // On a slow line a round takes long: half of the time is for others. One that an outage made long says nothing.
    m_due = std::max(m_roundAsked + period, now + std::min(now - m_roundAsked, kVitalsPause));
}

} // namespace drive
