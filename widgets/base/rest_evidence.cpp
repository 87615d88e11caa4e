#include "widgets/base/rest_evidence.h"

namespace widgets {

namespace {

bool acts(const drive::Wish &wish)
{
    using namespace drive;
    return std::holds_alternative<Command>(wish.what) || std::holds_alternative<Write>(wish.what)
        || std::holds_alternative<SpeedRamp>(wish.what)
        || std::holds_alternative<TorqueRamp>(wish.what)
        || std::holds_alternative<CurrentReference>(wish.what)
        || std::holds_alternative<PositionRamp>(wish.what);
}

} // namespace

void RestEvidence::armed()
{
    m_moved = true;
    m_left = false;
}

void RestEvidence::asked(const drive::Wish &wish)
{
    if (acts(wish))
        m_underWay.insert(wish.id);
}

void RestEvidence::ended(const drive::Ended &ended)
{
    if (m_underWay.erase(ended.id) > 0 && ended.outcome != drive::Outcome::NotSent)
        m_atRest.clear();
}

void RestEvidence::accept(const drive::MotorStatus &status)
{
    m_heard.insert(status.motor);
    if (drive::rests(status.state)) {
        m_atRest.try_emplace(status.motor, Rest{status.at, status.at}).first->second.last =
            status.at;
    } else {
        m_moved = true;
        m_atRest.erase(status.motor);
    }
}

bool RestEvidence::heardOfAll(int motors) const
{
    return m_left || static_cast<int>(m_heard.size()) >= motors;
}

bool RestEvidence::wereAtRest(int motors) const
{
    for (int motor = 1; motor <= motors; ++motor) {
        const auto seen = m_atRest.find(motor);
        if (seen == m_atRest.end() || seen->second.last - seen->second.first < kFresh)
            return false;
    }
    return m_underWay.empty();
}

bool RestEvidence::mayTurn(int motors, TimePoint now) const
{
    if (!m_moved || m_left)
        return false;
    if (!m_underWay.empty())
        return true;
    for (int motor = 1; motor <= motors; ++motor) {
        const auto seen = m_atRest.find(motor);
        if (seen == m_atRest.end() || now - seen->second.last >= kFresh)
            return true;
    }
    return false;
}

} // namespace widgets
