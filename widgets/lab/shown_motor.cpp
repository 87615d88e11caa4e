#include "widgets/lab/shown_motor.h"

#include "drive/values.h"

#include <algorithm>

namespace widgets {

void ShownMotor::begin()
{
    m_facts = {};
    m_missing.clear();
    const auto catalog = m_registers.catalog();
    if (!catalog)
        return;
    m_facts = drive::motorFacts(*catalog, m_device.motor(),
        [this](catalog::RegisterId id) { return m_registers.known(id); });
    for (const catalog::RegisterId id : drive::motorRegisters(*catalog, m_device.motor()))
        if (!m_registers.known(id) && m_registers.pollable(id))
            m_missing.push_back(id);
}

bool ShownMotor::refresh()
{
    const bool news = std::any_of(m_missing.begin(), m_missing.end(),
        [this](auto id) { return m_registers.known(id) || !m_registers.pollable(id); });
    if (news)
        begin();
    return news;
}

std::optional<lab::SpeedLoop> ShownMotor::speedLoop(const lab::Subject &subject) const
{
    return lab::speedLoopOf(
        subject,
        [this](drive::RegisterId id) {
            const auto value = m_registers.known(id);
            return value ? drive::asNumber(*value) : std::nullopt;
        },
        m_facts.speedPeriod_s);
}

} // namespace widgets
