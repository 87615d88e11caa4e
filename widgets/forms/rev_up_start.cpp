#include "widgets/forms/rev_up_start.h"

#include "widgets/base/device_text.h"
#include "widgets/base/value_text.h"

#include <cmath>

namespace widgets {
namespace {

constexpr double kLongest_s = 400.0; ///< s; five stages of 65 s and some
constexpr qsizetype kMostPoints = 20000;
constexpr std::size_t kColumns = 300; ///< of a streamed current

double seconds(TimePoint at) { return toSeconds(at.time_since_epoch()); }

} // namespace

RevUpStart::RevUpStart(Device &device, const capture::Capture &capture, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_capture(capture)
{
    connect(&device, &Device::statusChanged, this, &RevUpStart::acceptStatus);
    connect(&device, &Device::readingsArrived, this, &RevUpStart::onReadings);
    connect(&device, &Device::linkStateChanged, this, [this] {
        if (m_result == Result::UnderWay && !m_device.answering())
            end(Result::Stopped);
    });
    connect(&device, &Device::motorChanged, this, [this] {
        if (m_result == Result::UnderWay)
            end(Result::Stopped);
        m_lastStatus = -1.0;
        m_wasStarting = false;
    });
}

std::optional<catalog::RegisterId> RevUpStart::currentId() const
{
    const auto catalog = m_device.catalog();
    const auto *info = catalog ? catalog->find("I_Q_MEAS") : nullptr;
    return info != nullptr ? std::optional(catalog->withMotor(*info, m_motor)) : std::nullopt;
}

/// The rev-up is the state START; charging the bootstrap capacitors and calibrating offsets come before it, a
/// switch-over may follow. It began somewhere between the last status without it and the first one with it.
void RevUpStart::acceptStatus(int motor)
{
    if (motor != m_device.motor())
        return;
    const drive::MotorStatus status = m_device.status(motor);
    const double at = seconds(status.at);
    const bool starting = status.state == drive::MotorState::Starting;
    const bool revUp = starting && status.stateName == "START";
    if (revUp && m_result != Result::UnderWay && !m_wasStarting) {
        m_motor = motor;
        begin(m_lastStatus >= 0.0 ? 0.5 * (m_lastStatus + at) : at);
    }
    m_wasStarting = starting && (m_wasStarting || revUp);
    m_lastStatus = at;
    if (m_result != Result::UnderWay)
        return;
    m_duration = at - m_begin;
    if (m_duration > kLongest_s)
        return end(Result::Stopped);
    if (revUp) {
        m_until = m_duration;
        if (status.speedRpm && m_measured.speed_rpm.size() < kMostPoints)
            m_measured.speed_rpm.append(QPointF(m_duration, *status.speedRpm));
    }
    if (starting)
        return;
    using State = drive::MotorState;
    if (drive::hasFault(status.state)) {
        m_fault = deviceNames(status.faultsNow.empty() ? status.faultsPast : status.faultsNow);
        return end(Result::Failed);
    }
    end(status.state == State::Running ? Result::Running : Result::Stopped);
}

void RevUpStart::begin(double begin_s)
{
    m_result = Result::UnderWay;
    m_begin = begin_s;
    m_duration = m_until = 0.0;
    m_fault.clear();
    m_measured = {};
    m_polled.clear();
    Q_EMIT changed();
}

void RevUpStart::end(Result result)
{
    m_result = result;
    refresh();
    Q_EMIT changed();
}

void RevUpStart::onReadings(const std::vector<drive::Reading> &readings)
{
    const auto id = currentId();
    if (m_result != Result::UnderWay || !id)
        return;
    const catalog::Scale scale = m_device.catalog()->readScale(*id);
    for (const drive::Reading &reading : readings) {
        const double value = rawNumber(reading.value) * scale.factor;
        const double at = seconds(reading.at) - m_begin;
        if (reading.id == *id && reading.status == drive::ReadStatus::Ok && std::isfinite(value)
            && at >= 0.0 && scale.unit == "A" && m_polled.size() < kMostPoints)
            m_polled.append(QPointF(at, value));
    }
}

/// Least and greatest of each column of time, in turn: what a scope draws at this width.
QList<QPointF> RevUpStart::streamedCurrent() const
{
    using Kind = capture::ChannelInfo::Kind;
    const auto id = currentId();
    if (!id)
        return {};
    for (const Kind kind : {Kind::Fast, Kind::Slow}) {
        const auto channel = m_capture.find(*id, kind);
        const auto info = channel ? m_capture.info(*channel) : std::nullopt;
        if (!info || info->unit != "A" || !(m_until > 0.0))
            continue;
        QList<QPointF> points;
        const double step = m_until / static_cast<double>(kColumns);
        double at = 0.5 * step;
        for (const capture::MinMax &column :
            m_capture.columns(*channel, m_begin, m_begin + m_until, kColumns)) {
            if (!column.empty()) {
                points.append(QPointF(at, column.min));
                if (column.max != column.min)
                    points.append(QPointF(at, column.max));
            }
            at += step;
        }
        if (points.size() > 1)
            return points;
    }
    return {};
}

void RevUpStart::refresh()
{
    m_measured.current_a = streamedCurrent();
    if (m_measured.current_a.isEmpty())
        for (const QPointF &point : std::as_const(m_polled))
            if (point.x() <= m_until)
                m_measured.current_a.append(point);
    if (m_result == Result::UnderWay)
        Q_EMIT changed();
}

} // namespace widgets
