// RevUpStart: what was measured during the last start of a motor, counted from the moment its rev-up began. It listens
// to what comes anyway: the state and speed that are always polled, the current as it is streamed to the scope or
// polled for the form. It asks for nothing and starts nothing.
#pragma once

#include "capture/capture.h"
#include "widgets/base/device.h"

#include <QList>
#include <QObject>
#include <QPointF>

namespace widgets {

/// Curves of a start that was measured, in seconds from the beginning of its rev-up.
struct MeasuredStart {
    QList<QPointF> speed_rpm;
    QList<QPointF> current_a;
};

class RevUpStart : public QObject {
    Q_OBJECT
public:
    enum class Result : std::uint8_t {
        None, ///< no start yet
        UnderWay,
        Running, ///< the drive runs in closed loop
        Failed, ///< ended in a fault
        Stopped, ///< ended in any other way, or the link was lost
    };

    /// Both outlive it.
    RevUpStart(Device &device, const capture::Capture &capture, QObject *parent = nullptr);

    Result result() const { return m_result; }
    /// From the beginning of the rev-up to its end.
    double duration_s() const { return m_duration; }
    const QString &fault() const { return m_fault; } ///< names, of Failed
    const MeasuredStart &measured() const { return m_measured; }
    bool hasSpeed() const { return m_measured.speed_rpm.size() > 1; }
    bool hasCurrent() const { return m_measured.current_a.size() > 1; }
    void refresh(); ///< looks for what was streamed meanwhile

Q_SIGNALS:
    void changed();

private:
    void acceptStatus(int motor);
    void begin(double begin_s);
    void end(Result result);
    void onReadings(const std::vector<drive::Reading> &readings);
    std::optional<catalog::RegisterId> currentId() const;
    QList<QPointF> streamedCurrent() const;

    Device &m_device;
    const capture::Capture &m_capture;
    Result m_result = Result::None;
    int m_motor = 1;
    double m_begin = 0.0, m_lastStatus = -1.0; ///< s, on the session's axis
    double m_duration = 0.0;
    double m_until = 0.0; ///< how long the rev-up was seen; what comes then is no part of the plan
    bool m_wasStarting = false; ///< the rev-up of a start that is under way has been seen
    QString m_fault;
    MeasuredStart m_measured;
    QList<QPointF> m_polled; ///< current; used where nothing is streamed
};

} // namespace widgets
