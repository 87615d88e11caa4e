// StatusStrip: the line at the bottom of the window: link, packet sizes, motor, faults, how full the link is, what was
// lost. It shows; it asks for nothing. Each part has its place, whatever it says; where there is not room for all of
// them the least important ones are in the tool tip of the first.
#pragma once

#include "widgets/base/device.h"

#include <QStatusBar>

namespace widgets {

class Lamp;
class SteadyLabel;

class StatusStrip : public QStatusBar {
    Q_OBJECT
public:
    explicit StatusStrip(Device &device, QWidget *parent = nullptr);

    void refresh(Milliseconds now); ///< rates, once a second
    void showHeld(const QString &text); ///< what the samples take, in the tool tip of the rate

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    SteadyLabel *addPart(const char *objectName, const QStringList &room);
    QString endpointText() const;
    void fit();
    void tellHidden();
    std::optional<drive::Identified> connected() const;
    void updateLink();
    void updateWatchdog();
    void updateMotor();
    void updateCounters();

    Device &m_device;
    Lamp *m_link;
    SteadyLabel *m_sizes;
    SteadyLabel *m_motor;
    SteadyLabel *m_faults;
    SteadyLabel *m_rate;
    SteadyLabel *m_lost;
    SteadyLabel *m_bad;
    SteadyLabel *m_watchdog;
    Milliseconds m_lastTime{};
    std::uint64_t m_lastBytes = 0;
};

} // namespace widgets
