#include "session/link/driven_motors.h"

#include "base/overloaded.h"
#include "drive/stop_sequence.h"

#include <algorithm>

namespace session {

namespace {

/// Also a register that is written: some of them start a motor.
bool canMove(const drive::Wish &wish)
{
    return std::visit(Overloaded{
                          [](const drive::Write &) { return true; },
                          [](const drive::Command &command) {
                              return command.action == drive::MotorAction::Start;
                          },
                          [](const drive::SpeedRamp &) { return true; },
                          [](const drive::TorqueRamp &) { return true; },
                          [](const drive::CurrentReference &) { return true; },
                          [](const drive::PositionRamp &) { return true; },
                          [](const drive::CyclicSetPoints &travel) { return travel.on; },
                          [](const auto &) { return false; },
                      },
        wish.what);
}

} // namespace

void DrivenMotors::submitted(const drive::Wish &wish, bool armed, TimePoint now)
{
    if (!armed || !canMove(wish))
        return;
    m_driven = true;
    m_lastAct = now;
    m_idle.clear();
    if (wish.id != 0)
        m_open.insert(wish.id);
}

void DrivenMotors::told(const drive::Event &event, TimePoint now)
{
    if (const auto *board = std::get_if<drive::Identified>(&event)) {
        m_motors = board->identity.motors;
    } else if (const auto *end = std::get_if<drive::Ended>(&event)) {
        if (m_open.erase(end->id) > 0)
            m_lastAct = now;
    } else if (const auto *status = std::get_if<drive::MotorStatus>(&event); status && m_driven) {
        accept(*status);
    }
}

void DrivenMotors::accept(const drive::MotorStatus &status)
{
    if (!m_open.empty() || status.at < m_lastAct + kSettle)
        return;
    int &idle = m_idle[status.motor];
    idle = drive::isDriveIdle(status) && !status.waitsForBus ? idle + 1 : 0;
    const auto enough =
        std::ranges::count_if(m_idle, [](const auto &one) { return one.second >= kIdleReadings; });
    m_driven = enough < m_motors;
}

} // namespace session
