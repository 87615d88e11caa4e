#include "widgets/control/current_scales.h"

#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"

#include <algorithm>

namespace widgets {

CurrentScales::CurrentScales(Device &device, QMap<QString, double> &remembered, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_remembered(remembered)
{
    connect(&device, &Device::identityChanged, this, &CurrentScales::meet);
    connect(&device, &Device::wishEnded, this, &CurrentScales::accept);
}

/// The same board at the same port. A name for a file of ours, not for people.
QString CurrentScales::keyOf(int motor) const
{
    const drive::Identity &identity = m_device.identified()->identity;
    QStringList parts{QString::fromStdString(identity.firmware),
        QString::fromStdString(identity.version), QString::fromStdString(identity.controlBoard)};
    for (const std::string &board : identity.powerBoards)
        parts.append(QString::fromStdString(board));
    parts.append(m_device.endpoint().path);
    return parts.join(QLatin1Char('|')) + QLatin1Char('#') + QString::number(motor);
}

void CurrentScales::meet()
{
    if (!m_device.identified() || !m_device.capability(drive::Feature::CurrentScale).available)
        return;
    for (int motor = 1; motor <= m_device.identified()->identity.motors; ++motor) {
        const double amps = m_remembered.value(keyOf(motor), 0.0);
        const bool underWay = std::any_of(m_wished.begin(), m_wished.end(),
            [motor](const auto &wish) { return wish.second.motor == motor; });
        if (amps > 0.0 && !(m_device.fullScaleAmps(motor) > 0.0) && !underWay)
            m_wished[m_device.setCurrentScale(motor, amps)] = {motor, amps, keyOf(motor), false};
    }
}

void CurrentScales::set(int motor, double fullScaleAmps)
{
    if (m_device.identified())
        m_wished[m_device.setCurrentScale(motor, fullScaleAmps)] = {
            motor, fullScaleAmps, keyOf(motor), true};
}

void CurrentScales::accept(const drive::Ended &ended)
{
    const auto found = m_wished.extract(ended.id);
    if (found.empty())
        return;
    const Wished &wish = found.mapped();
    if (ended.outcome != drive::Outcome::Ok) {
        if (wish.byPerson)
            Q_EMIT told(failureText(tr("Setting the current scale"), ended));
        return;
    }
    if (!wish.byPerson)
        Q_EMIT told(tr("Motor %1: currents in A by the scale that was entered for this board "
                       "before, %2 A at full scale. See Current scale in the control panel.")
                        .arg(QString::number(wish.motor), numberText(wish.amps, 2)));
    else if (wish.amps > 0.0)
        m_remembered[wish.key] = wish.amps;
    else
        m_remembered.remove(wish.key);
}

} // namespace widgets
