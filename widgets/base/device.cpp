#include "widgets/base/device.h"

#include "base/overloaded.h"
#include "drive/board_facts.h"

namespace widgets {
namespace {

/// Expert mode is for one connection to one board that was not reset meanwhile.
bool forgetsExperts(const drive::LinkChanged &link)
{
    using drive::LinkState;
    return link.state == LinkState::Lost || link.state == LinkState::Closed
        || link.state == LinkState::Connecting || link.reason == drive::LinkReason::BoardReset;
}

} // namespace

Device::Device(QObject *parent)
    : QObject(parent)
{
}

std::shared_ptr<const catalog::Catalog> Device::catalog() const
{
    return m_identified ? m_identified->catalog : nullptr;
}

drive::StreamLimits Device::streamLimits() const
{
    return m_identified ? m_identified->streaming : drive::StreamLimits{};
}

drive::Capability Device::capability(drive::Feature feature) const
{
    if (!m_identified)
        return {feature, false, {}};
    for (const drive::Capability &capability : m_identified->capabilities)
        if (capability.feature == feature)
            return capability;
    return {feature, true, {}};
}

drive::MotorStatus Device::status(int motor) const
{
    const auto found = m_status.find(motor);
    if (found != m_status.end())
        return found->second;
    drive::MotorStatus unknown;
    unknown.motor = motor;
    return unknown;
}

bool Device::allIdle() const
{
    if (replaying(*this))
        return true; // what turned then does not turn now
    for (const auto &[motor, status] : m_status)
        if (!drive::rests(status.state))
            return false;
    return true;
}

drive::WishId Device::submit(decltype(drive::Wish::what) what)
{
    drive::Wish wish;
    wish.id = ++m_lastWish;
    wish.what = std::move(what);
    wish.madeAt = madeAt();
    Q_EMIT wishMade(wish);
    return m_lastWish;
}

std::optional<TimePoint> Device::madeAt() const
{
    return m_actClock ? std::optional(m_actClock()) : std::nullopt;
}

void Device::open(const session::Endpoint &endpoint)
{
    m_endpoint = endpoint;
    m_portError = {};
    forgetBoard();
    Q_EMIT openWished(endpoint);
}

void Device::stop()
{
    if (!portOpen())
        Q_EMIT stopImpossible();
    Q_EMIT stopWished();
    armedChanged(false);
}

void Device::setArmed(bool armed)
{
    if (armed && !answering())
        return;
    Q_EMIT armWished(armed, madeAt());
}

void Device::setMotor(int motor)
{
    if (motor == m_motor || motor < 1)
        return;
    m_motor = motor;
    Q_EMIT motorChanged();
}

drive::MotorLimits Device::limits(int motor) const
{
    const auto at = static_cast<std::size_t>(motor - 1);
    return m_identified && motor >= 1 && at < m_identified->limits.size() ? m_identified->limits[at]
                                                                          : drive::MotorLimits{};
}

drive::MotionBounds Device::bounds(int motor) const
{
    return drive::boundsOf(limits(motor), m_userLimits, expert(motor));
}

void Device::setUserLimits(const drive::UserLimits &limits)
{
    if (!drive::isPlausible(limits) || limits == m_userLimits)
        return;
    m_userLimits = limits;
    submit(limits);
    Q_EMIT boundsChanged();
}

double Device::fullScaleAmps(int motor) const
{
    const auto known = catalog();
    return known ? known->scales(motor).ampsPerDigit * drive::kFullScaleDigits : 0.0;
}

drive::WishId Device::setCurrentScale(int motor, double fullScaleAmps)
{
    return submit(drive::CurrentScale{motor, fullScaleAmps});
}

void Device::becomeExpert(int motor) { m_expertWished[submit(drive::ExpertMode{motor})] = motor; }

void Device::onEnd(const drive::Ended &ended)
{
    const auto wished = m_expertWished.extract(ended.id);
    if (!wished.empty() && ended.outcome == drive::Outcome::Ok) {
        m_expert.insert(wished.mapped());
        Q_EMIT boundsChanged();
    }
    Q_EMIT wishEnded(ended);
}

void Device::apply(const session::BatchPtr &batch)
{
    if (!batch)
        return;
    for (const drive::Event &event : batch->events)
        accept(event);
    m_dropped = batch->droppedForDisplay;
    Q_EMIT batchApplied();
}

void Device::portChanged(session::PortState state, const session::PortError &why)
{
    m_port = state;
    m_portError = why;
    if (state == session::PortState::Closed) {
        armedChanged(false);
        if (m_link.state != drive::LinkState::Lost)
            m_link = {};
        Q_EMIT linkStateChanged();
    } else {
        m_counters = {};
    }
    Q_EMIT portStateChanged();
}

void Device::armedChanged(bool armed)
{
    if (m_armed == armed)
        return;
    m_armed = armed;
    Q_EMIT armedStateChanged(armed);
}

void Device::disarm()
{
    setArmed(false);
    armedChanged(false); // shown at once; the session's own word follows
}

void Device::accept(const drive::Event &event)
{
    std::visit(
        Overloaded{
            [this](const drive::LinkChanged &link) {
                m_link = link;
                if (!answering() || link.reason == drive::LinkReason::BoardReset)
                    m_told.clear();
                if (forgetsExperts(link))
                    m_expert.clear();
                if (link.state == drive::LinkState::Lost || link.state == drive::LinkState::Closed
                    || link.reason == drive::LinkReason::BoardReset)
                    disarm();
                Q_EMIT linkStateChanged();
            },
            [this](const drive::Identified &identified) {
                const bool again = m_identified && m_motor <= identified.identity.motors;
                m_identified = identified;
                m_motor = again ? m_motor : 1;
                Q_EMIT identityChanged();
            },
            [this](const drive::RegistersRead &read) { Q_EMIT readingsArrived(read.readings); },
            [this](const drive::Ended &ended) { onEnd(ended); },
            [this](const drive::MotorStatus &status) {
                m_status[status.motor] = status;
                m_told.insert(status.motor);
                Q_EMIT statusChanged(status.motor);
            },
            [this](const drive::StreamStarted &started) { Q_EMIT streamStarted(started.layout); },
            [this](const drive::CyclicSetPointsChanged &changed) {
                m_cyclicSetPoints = changed.on;
                Q_EMIT cyclicSetPointsChanged();
            },
            [this](const capture::SampleBlock &block) { Q_EMIT samplesArrived(block); },
            [this](const drive::StopProgress &progress) { Q_EMIT stopAdvanced(progress); },
            [this](const drive::MotionEntry &entry) { Q_EMIT motionLogged(entry); },
            [this](const drive::LinkCounters &counters) {
                m_counters = counters;
                Q_EMIT countersChanged();
            },
        },
        event);
}

void Device::forgetBoard()
{
    m_link = {};
    m_identified.reset();
    m_status.clear();
    m_told.clear();
    m_expert.clear();
    m_expertWished.clear();
    m_cyclicSetPoints = false;
    m_motor = 1;
    m_dropped = 0;
    Q_EMIT identityChanged();
}

} // namespace widgets
