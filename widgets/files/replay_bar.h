// ReplayBar: that it is a replay, its pace, a pause, and how far it is, which can be chosen. Shown while a recording is
// what is connected.
#pragma once

#include "session/recording/replay.h"
#include "widgets/base/device.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace widgets {

class SteadyLabel;

class ReplayBar : public QWidget {
    Q_OBJECT
public:
    /// Both outlive it.
    ReplayBar(Device &device, session::Replay &replay, QWidget *parent = nullptr);

protected:
    void changeEvent(QEvent *event) override;

private:
    void follow();
    void tell(const session::ReplayState &state);
    void paintBadge();

    Device &m_device;
    session::Replay &m_replay;
    QToolButton *m_pause;
    QComboBox *m_speed;
    QSlider *m_place;
    QLabel *m_badge;
    SteadyLabel *m_text;
    bool m_telling = false; ///< the slider moves by itself
};

} // namespace widgets
