#include "drive/mcb/mcb_watch.h"

#include "drive/mcb/mcb_catalog.h"

namespace drive {

void McbWatch::watch(const Watch &watch, TimePoint now)
{
    m_reader.clear();
    m_round.watch(watch, now);
}

void McbWatch::restart(TimePoint now)
{
    m_reader.clear();
    m_round.restart(now);
}

std::optional<McbRequest> McbWatch::nextRequest(TimePoint now)
{
    if (m_reader.finished())
        m_reader.start(m_round.begin(now));
    return m_reader.nextRequest();
}

void McbWatch::takeResponse(const McbAnswer &answer, TimePoint now)
{
    if (m_reader.finished())
        return; // the list was changed while this one was asked
    m_round.take(m_reader.takeResponse(answer, m_board, now));
    planNextRound(now);
}

void McbWatch::takeNoResponse(std::optional<bool>, TimePoint now)
{
    if (m_reader.finished())
        return;
    m_reader.takeNoResponse();
    planNextRound(now);
}

/// Half of the time is for others.
void McbWatch::planNextRound(TimePoint now) { m_round.planNext(2 * (now - m_round.begun()), now); }

std::optional<McbRequest> McbReadTask::nextRequest(TimePoint now)
{
    if (finished())
        return std::nullopt;
    if (!std::exchange(m_started, true)) {
        std::vector<RegisterId> ids;
        for (const RegisterId id : m_ids) {
            if (m_board.infoOf(mcbAddressOf(id)) == nullptr || m_board.readable(mcbAddressOf(id)))
                ids.push_back(id);
            else
                m_readings.push_back({id, ReadStatus::NotSupported, {}, now});
        }
        m_reader.start(ids);
        finish();
    }
    return m_reader.nextRequest();
}

void McbReadTask::takeResponse(const McbAnswer &answer, TimePoint now)
{
    m_readings.push_back(m_reader.takeResponse(answer, m_board, now));
    finish();
}

void McbReadTask::takeNoResponse(std::optional<bool>, TimePoint)
{
    m_reader.takeNoResponse();
    finish();
}

void McbReadTask::finish()
{
    if (m_reader.finished())
        end(m_reader.gaveUp() ? Outcome::Unknown : Outcome::Ok,
            m_reader.gaveUp() ? "no answer" : "");
}

} // namespace drive
