#include "widgets/window/shutdown.h"

namespace widgets {
namespace {

constexpr int kConfirmMs = 2000;

} // namespace

Shutdown::Shutdown(Device &device, std::function<TimePoint()> clock, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_clock(std::move(clock))
{
    m_deadline.setSingleShot(true);
    connect(&m_deadline, &QTimer::timeout, this, &Shutdown::notConfirmed);
    connect(&device, &Device::openWished, this, [this] { m_rest.opened(); });
    connect(&device, &Device::closeWished, this, [this] { m_rest.leftAsTheyAre(); }); // was asked
    const auto armed = [this](bool on) {
        if (on)
            m_rest.armed();
    };
    connect(&device, &Device::armWished, this, armed);
    connect(&device, &Device::armedStateChanged, this, armed);
    connect(
        &device, &Device::wishMade, this, [this](const drive::Wish &wish) { m_rest.asked(wish); });
    connect(&device, &Device::wishEnded, this,
        [this](const drive::Ended &ended) { m_rest.ended(ended); });
    connect(&device, &Device::statusChanged, this, [this](int motor) {
        m_rest.accept(m_device.status(motor));
        check();
    });
}

int Shutdown::motors() const
{
    const auto &board = m_device.identified();
    return board ? board->identity.motors : 1;
}

bool Shutdown::mayTurn() const
{
    if (replaying(m_device))
        return false; // what turned then does not turn now
    if (m_rest.mayTurn(motors(), m_clock()))
        return true;
    // A board that answers but has not said yet what its motors do may have one that turns.
    const auto &board = m_device.identified();
    const bool tells = m_device.answering() && (!board || board->identity.knownFirmware);
    return tells && !m_rest.heardOfAll(motors());
}

void Shutdown::begin()
{
    if (underWay())
        return;
    m_deadline.start(m_device.portOpen() ? kConfirmMs : 0);
    m_device.stop();
}

void Shutdown::check()
{
    if (!underWay() || !restIsSeen())
        return;
    m_deadline.stop();
    Q_EMIT confirmed();
}

} // namespace widgets
