// ReplayBar: the pace of a replay, a pause, and how far it is. Shown while a recording is what is connected.
#pragma once

#include "session/recording/replay.h"
#include "widgets/base/device.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace widgets {

class ReplayBar : public QWidget {
    Q_OBJECT
public:
    /// Both outlive it.
    ReplayBar(Device &device, session::Replay &replay, QWidget *parent = nullptr);

private:
    void follow();
    void tell(const session::ReplayState &state);

    Device &m_device;
    session::Replay &m_replay;
    QToolButton *m_pause;
    QComboBox *m_speed;
    QLabel *m_text;
};

} // namespace widgets
