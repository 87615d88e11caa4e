#include "widgets/window/shutdown.h"

#include "widgets/files/replaying.h"

namespace widgets {
namespace {

constexpr int kConfirmMs = 2000;

} // namespace

Shutdown::Shutdown(Device &device, QObject *parent)
    : QObject(parent)
    , m_device(device)
{
    m_deadline.setSingleShot(true);
    m_deadline.setInterval(kConfirmMs);
    m_deadline.setTimerType(Qt::PreciseTimer);
    connect(&m_deadline, &QTimer::timeout, this, &Shutdown::notConfirmed);
    connect(&device, &Device::statusChanged, this, &Shutdown::check);
}

bool Shutdown::mayEnd() const
{
    // A board that answers but has not said yet what its motor does may have one that turns.
    const auto &identified = m_device.identified();
    const bool ours = !identified || identified->identity.knownFirmware;
    const bool unheard = m_device.answering() && ours && !replaying(m_device)
        && m_device.status(m_device.motor()).state == drive::MotorState::Unknown;
    return m_leave || (m_device.allIdle() && !unheard);
}

void Shutdown::begin()
{
    if (underWay())
        return;
    m_device.stop();
    m_deadline.start();
}

void Shutdown::check()
{
    if (!underWay() || !m_device.answering() || !mayEnd())
        return;
    m_deadline.stop();
    Q_EMIT confirmed();
}

} // namespace widgets
