// StatusStrip: the line at the bottom of the window: link, packet sizes, motor, faults, how full the link is, what was
// lost. It shows; it asks for nothing.
#pragma once

#include "widgets/base/device.h"

#include <QStatusBar>

class QLabel;

namespace widgets {

class Lamp;

class StatusStrip : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusStrip(Device &device, QWidget *parent = nullptr);

    void refresh(Milliseconds now); ///< rates, once a second
    void showHeld(const QString &text); ///< what the samples take, in the tool tip of the rate

private:
    QLabel *addPart(const char *objectName);
    std::optional<drive::Identified> connected() const;
    void updateLink();
    void updateWatchdog();
    void updateMotor();
    void updateCounters();

    Device &m_device;
    Lamp *m_link;
    QLabel *m_sizes;
    QLabel *m_motor;
    QLabel *m_faults;
    QLabel *m_rate;
    QLabel *m_lost;
    QLabel *m_bad;
    QLabel *m_watchdog;
    Milliseconds m_lastTime{};
    std::uint64_t m_lastBytes = 0;
};

} // namespace widgets
